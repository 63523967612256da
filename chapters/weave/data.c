/* data.c -- the entries of the options data, instead and result.
 *
 *     :data: R = (0,0) (1,2) (2,0); w = 1 -1/2 1; n = 2; F = "y^2 - x^3"
 *
 * Entries are separated by semicolons.  A value is a text in quotation marks, numbers separated by blanks, or points in
 * parentheses, which all have as many coordinates.  A number is a whole number, a fraction 3/7, a decimal 0.35, a binary64
 * 0x1.8p-3, or the name of a variable of the field, a letter and what follows it. */
#include "chapters/weave/book.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static int digits(const char **s, int hexadecimal)
{
    int count = 0;
    for (; hexadecimal ? isxdigit((unsigned char)**s) : isdigit((unsigned char)**s); (*s)++)
        count++;
    return count;
}

static int is_number(const char *s)
{
    s += *s == '-';
    int hexadecimal = s[0] == '0' && s[1] == 'x', count;
    s += 2 * hexadecimal;
    count = digits(&s, hexadecimal);
    if (*s == '/' && count > 0 && !hexadecimal) {
        s++;
        count = digits(&s, 0);
    } else if (*s == '.') {
        s++;
        count += digits(&s, hexadecimal);
    }
    if (count > 0 && *s == (hexadecimal ? 'p' : 'e')) {
        s++;
        s += *s == '-';
        count = digits(&s, 0);
    }
    return count > 0 && *s == '\0';
}

static int is_name(const char *s)
{
    if (!isalpha((unsigned char)*s))
        return 0;
    while (isalnum((unsigned char)*s))
        s++;
    return *s == '\0';
}

/* Numbers up to one of the ends, separated by blanks or commas; how many. */
static int read_numbers(struct block *b, struct entry *e, char *text)
{
    int count = 0;
    for (char *word = strtok(text, ", "); word != NULL; word = strtok(NULL, ", "), count++) {
        if (!is_number(word) && !is_name(word))
            complain(b->file, e->line, "'%s': '%s' in %s is no number", b->name, word, e->name);
        append(&e->values, whole_copy(word));
    }
    return count;
}

static void read_points(struct block *b, struct entry *e, const char *s)
{
    while (*s == '(') {
        const char *end = strchr(s, ')');
        if (end == NULL)
            break;
        int columns = read_numbers(b, e, copy_of(s + 1, (size_t)(end - s) - 1));
        if (e->rows++ > 0 && columns != e->columns)
            complain(b->file, e->line, "'%s': the points of %s have %d and %d coordinates", b->name, e->name,
                     e->columns, columns);
        e->columns = columns;
        s = end + 1 + strspn(end + 1, " ");
    }
    if (*s != '\0')
        complain(b->file, e->line, "'%s': what is '%s' in %s?  Points are written (0,1) (2,3)", b->name, s, e->name);
}

static void read_value(struct block *b, struct entry *e)
{
    size_t n = strlen(e->text);
    if (e->text[0] == '"' && n > 1 && e->text[n - 1] == '"') {
        e->rows = 1;
        append(&e->values, copy_of(e->text + 1, n - 2));
    } else if (e->text[0] == '(') {
        read_points(b, e, e->text);
    } else {
        e->rows = read_numbers(b, e, whole_copy(e->text));
        e->columns = 1;
    }
    if (e->values.count == 0)
        complain(b->file, e->line, "'%s': %s has no value", b->name, e->name);
}

static void read_entry(struct block *b, enum data_place place, int line, char *text)
{
    char *equals = strstr(text, " =");
    if (equals == NULL || (equals[2] != ' ' && equals[2] != '\0')) {
        complain(b->file, line, "'%s': '%s' is not written name = value", b->name, text);
        return;
    }
    struct entry e = {.place = place,
                      .line = line,
                      .name = trimmed(copy_of(text, (size_t)(equals - text))),
                      .text = trimmed(whole_copy(equals + 2))};
    read_value(b, &e);
    for (int k = 0; k < b->entries; k++)
        if (b->entry[k].place == place && strcmp(b->entry[k].name, e.name) == 0)
            complain(b->file, line, "'%s': %s occurs twice", b->name, e.name);
    b->entry = must(realloc(b->entry, (size_t)(b->entries + 1) * sizeof *b->entry));
    b->entry[b->entries++] = e;
}

void read_data(struct block *b)
{
#define KEY(tag, key) key,
    static const char *const keys[DATA_PLACES] = {DATA_LIST(KEY)};
#undef KEY
    enum { MOST = 64 }; /* the judge keeps a bit for each */
    for (int k = 0; k < b->options; k++)
        for (int place = 0; place < DATA_PLACES; place++) {
            if (strcmp(b->option[k].key, keys[place]) != 0)
                continue;
            /* A semicolon within quotation marks separates nothing. */
            const char *from = b->option[k].value;
            int quoted = 0;
            for (const char *at = from;; at++) {
                quoted ^= *at == '"';
                if (*at != '\0' && (*at != ';' || quoted))
                    continue;
                char *text = trimmed(copy_of(from, (size_t)(at - from)));
                if (*text != '\0')
                    read_entry(b, (enum data_place)place, b->option[k].line, text);
                if (*at == '\0')
                    break;
                from = at + 1;
            }
        }
    if (b->entries > MOST)
        complain(b->file, b->line, "'%s' has more than %d data and results", b->name, MOST);
}
