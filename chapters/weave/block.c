/* block.c -- what the options of a block say. */
#include "chapters/weave/book.h"

#include <stdio.h>
#include <string.h>

const char *value_of(const struct block *b, const char *key)
{
    for (int k = 0; k < b->options; k++)
        if (strcmp(b->option[k].key, key) == 0)
            return b->option[k].value;
    return NULL;
}

const struct block *block_named(const struct book *book, const char *name, enum block_kind kind)
{
    for (int k = 0; k < book->blocks; k++)
        if (book->block[k].kind == kind && strcmp(book->block[k].name, name) == 0)
            return &book->block[k];
    return NULL;
}

int role_of(const char *key)
{
#define KEY(tag, key, form) key,
    static const char *const keys[ROLES] = {ROLE_LIST(KEY)};
#undef KEY
    int r = 0;
    while (r < ROLES && strcmp(keys[r], key) != 0)
        r++;
    return r;
}

role_form form_of(int r)
{
#define FORM(tag, key, form) form,
    static const role_form forms[ROLES] = {ROLE_LIST(FORM)};
#undef FORM
    return forms[r];
}

int kind_of(const struct block *b)
{
#define NAME(tag, name) name,
    static const char *const names[KINDS] = {KIND_LIST(NAME)};
#undef NAME
    const char *kind = value_of(b, "kind");
    int k = 0;
    while (kind != NULL && k < KINDS && strcmp(names[k], kind) != 0)
        k++;
    return k;
}

int has_word(const char *list, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = list; (at = strstr(at, word)) != NULL; at += n)
        if ((at == list || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0'))
            return 1;
    return 0;
}

int has_type(const struct book *book, const struct block *b, number_type t)
{
#define NAME(tag, name, suffix, kernels) #name,
    static const char *const names[NUMBER_TYPES] = {NUMBER_TYPE_LIST(NAME)};
#undef NAME
    const char *types = value_of(b, "types");
    if (!has_word(book->types, names[t]))
        return 0;
    if (types == NULL)
        return kind_of(b) == IDENTITY || t == RATIONAL_TYPE;
    return has_word(types, names[t]);
}

int is_compiled(const struct book *book, const struct block *b)
{
    int compiled = 0;
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        compiled |= has_type(book, b, t);
    return compiled;
}

int read_degrees(const struct block *b, struct degrees *d)
{
    const char *text = value_of(b, "degrees");
    *d = (struct degrees){0};
    if (text == NULL)
        return 1;
    const char *equals = strchr(text, '=');
    if (equals != NULL) {
        char *letter = trimmed(copy_of(text, (size_t)(equals - text)));
        snprintf(d->letter, sizeof d->letter, "%s", letter);
        text = equals + 1 + strspn(equals + 1, " ");
    }
    if (strcmp(text, "all") == 0 || sscanf(text, "all from %d", &d->low) == 1) {
        d->all = 1;
        d->high = d->sampled = d->low; /* one case, in which n is a variable */
        return 1;
    }
    int read = sscanf(text, "%d..%d sampled %d", &d->low, &d->high, &d->sampled);
    d->sampled = d->sampled > d->high ? d->sampled : d->high;
    return read >= 2 && d->low >= 0 && d->high >= d->low;
}

/* What stands before the next bar, or NULL; *value is what follows it. */
static char *before_bar(const char **value)
{
    const char *bar = strchr(*value, '|');
    if (bar == NULL)
        return NULL;
    char *part = trimmed(copy_of(*value, (size_t)(bar - *value)));
    *value = bar + 1;
    return part;
}

struct link read_link(const char *value, role_form form)
{
    struct link link = {0};
    if (form != PLACE_TEXT)
        link.claim = before_bar(&value);
    if (form == PLACE_TEXT || form == CLAIM_PLACE_TEXT)
        link.place = before_bar(&value);
    if (form == CLAIM_TEXT_WORDS) {
        const char *bar = strstr(value, " | ");
        if (bar != NULL) {
            link.text = trimmed(copy_of(value, (size_t)(bar - value)));
            link.place = trimmed(whole_copy(bar + 3));
            return link;
        }
    }
    link.text = trimmed(whole_copy(value));
    return link;
}
