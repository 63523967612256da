/* names.c -- names as people type them. */
#include "cli/names.h"
#include "cli/nearest.h"
#include "cli/refuse.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static void *must(void *p)
{
    if (p == NULL)
        abort();
    return p;
}

/* The name of the table of which the id is an entry, as long as the program runs: it stands nowhere by itself.  NULL for no
 * entry. */
static const char *table_of(const char *id)
{
    static struct kept {
        struct kept *next;
        char *name;
    } * first;
    size_t length = table_length(id);
    if (length == 0)
        return NULL;
    for (const struct kept *k = first; k != NULL; k = k->next)
        if (strlen(k->name) == length && strncmp(k->name, id, length) == 0)
            return k->name;
    struct kept *more = must(malloc(sizeof *more));
    *more = (struct kept){first, must(strndup(id, length))};
    first = more;
    return more->name;
}

/* Calls visit(context, name, title, title_zh) for everything of the kind: statements, tables of them and claims, or figures. */
typedef void visitor(void *context, const char *name, const char *title, const char *title_zh);
static void visit_names(const cagd_register *r, enum kind_of_name kind, visitor *visit, void *context)
{
    for (const statement *s = r->statements; kind != FIGURES && s->id != NULL; s++) {
        const char *table = table_of(s->id);
        if (table != NULL && (s == r->statements || table_of(s[-1].id) != table))
            visit(context, table, NULL, NULL);
        visit(context, s->id, s->title, s->title_zh);
    }
    for (const claim *c = r->claims; kind != FIGURES && c->name != NULL; c++)
        visit(context, c->name, c->title, c->title_zh);
    for (const figure *f = r->figures; kind == FIGURES && f->name != NULL; f++)
        visit(context, f->name, NULL, NULL);
}

/* The names that a text may stand for: how many, and the first of them. */
enum { LISTED = 6 };
struct meant {
    const char *text, *at[LISTED];
    int count, formula; /* whether only formulas are meant */
};

static void note(struct meant *m, const char *name)
{
    for (int k = 0; k < m->count && k < LISTED; k++)
        if (m->at[k] == name) /* a table whose entries do not stand together */
            return;
    if (m->count < LISTED)
        m->at[m->count] = name;
    m->count++;
}

/* The names in a line, behind what was written of it. */
static void put_names(FILE *out, const struct meant *m)
{
    for (int k = 0; k < m->count && k < LISTED; k++)
        fprintf(out, "%s %s", k > 0 ? "," : "", m->at[k]);
    fputs(m->count > LISTED ? ", ..." : "", out);
}

/* ---- places in a book ----------------------------------------------------------------------------- */

/* What a text calls a place, and how ids begin: "" for a formula, whose id may be its number alone. */
static const struct {
    const char *word, *key;
} places[] = {{"定理", "thm"},      {"theorem", "thm"},
              {"thm", "thm"},       {"引理", "lemma"},
              {"lemma", "lemma"},   {"推论", "cor"},
              {"corollary", "cor"}, {"cor", "cor"},
              {"定义", "def"},      {"definition", "def"},
              {"def", "def"},       {"命题", "prop"},
              {"性质", "prop"},     {"proposition", "prop"},
              {"prop", "prop"},     {"property", "property"},
              {"算法", "alg"},      {"algorithm", "alg"},
              {"图", "fig"},        {"figure", "fig"},
              {"公式", ""},         {"式", ""},
              {"formula", ""},      {"equation", ""},
              {"eq.", ""},          {"eq", ""},
              {"§", "sec"},         {"节", "sec"},
              {"section", "sec"}};

/* The text as the end of an id: "wang-ch3:定理 3.3.2" is "wang-ch3:thm-3.3.2", "(3.3.2)" is "3.3.2".  Whether it means a
 * formula. */
static int as_end_of_id(const char *text, char *end, size_t room)
{
    int formula = 0;
    const char *colon = strchr(text, ':'), *place = colon != NULL ? colon + 1 : text, *key = "";
    for (size_t k = 0; k < sizeof places / sizeof *places; k++) {
        size_t length = strlen(places[k].word);
        if (strncasecmp(place, places[k].word, length) == 0 && strpbrk(place + length, "0123456789") != NULL) {
            place += length;
            key = places[k].key;
            formula = key[0] == '\0';
            break;
        }
    }
    int length = snprintf(end, room, "%.*s%s", (int)(place == text || colon == NULL ? 0 : colon + 1 - text), text, key);
    if (length >= (int)room) /* no id is as long */
        length = (int)room - 1;
    int separated = key[0] == '\0';
    for (; *place != '\0' && length + 2 < (int)room; place++) {
        static const char *const wide[] = {"（", "）"};
        const char *skipped = strncmp(place, wide[0], 3) == 0 || strncmp(place, wide[1], 3) == 0 ? place + 2 : NULL;
        if (skipped != NULL)
            place = skipped;
        formula |= *place == '(' || skipped != NULL;
        if (skipped != NULL || strchr("() ", *place) != NULL)
            continue;
        if (!separated && *place != '-')
            end[length++] = '-';
        separated = 1;
        end[length++] = *place;
    }
    end[length] = '\0';
    return formula;
}

/* Whether what stands before the number of an id lets it be one of a formula: nothing, "formula-" or "eq-". */
static int is_before_formula(const char *id, size_t length)
{
    static const char *const words[] = {":", "formula-", "eq-"};
    for (int k = 0; k < 3; k++)
        if (length >= strlen(words[k]) && strncmp(id + length - strlen(words[k]), words[k], strlen(words[k])) == 0)
            return 1;
    return length == 0;
}

/* Ids that end with the text, in front of which a part of the id ends. */
static void consider_end(void *context, const char *name, const char *title, const char *title_zh)
{
    struct meant *m = context;
    size_t all = strlen(name), end = strlen(m->text);
    (void)title, (void)title_zh;
    if (end > 0 && all >= end && strcmp(name + all - end, m->text) == 0 &&
        (all == end || strchr(":-_", name[all - end - 1]) != NULL) &&
        (!m->formula || is_before_formula(name, all - end)))
        note(m, name);
}

/* Ids in which it is a part, whatever follows. */
static void consider_part(void *context, const char *name, const char *title, const char *title_zh)
{
    struct meant *m = context;
    size_t length = strlen(m->text);
    (void)title, (void)title_zh;
    for (const char *at = length > 0 ? strstr(name, m->text) : NULL; at != NULL; at = strstr(at + 1, m->text))
        if ((at == name || strchr(":-_", at[-1]) != NULL) && at[length] != '\0' && strchr(":-_", at[length]) != NULL &&
            (!m->formula || is_before_formula(name, (size_t)(at - name)))) {
            note(m, name);
            return;
        }
}

static void consider_title(void *context, const char *name, const char *title, const char *title_zh)
{
    struct meant *m = context;
    if (is_in_title(m->text, title, title_zh))
        note(m, name);
}

/* ---- all names --------------------------------------------------------------------------------------- */

void print_names(const cagd_register *r, const struct patterns *p)
{
    int statements, claims;
    const statement **s = matching_statements(r, p, &statements);
    const claim **c = matching_claims(r, p, &claims);
    const char *table = NULL;
    for (int k = 0; k < statements; k++) {
        const char *its = table_of(s[k]->id);
        if (its != NULL && its != table)
            puts(its);
        table = its;
        puts(s[k]->id);
    }
    for (int k = 0; k < claims; k++)
        printf("%s\n%s.%s\n", c[k]->name, c[k]->chapter, c[k]->name);
    free(s), free(c);
}

/* ---- what is meant --------------------------------------------------------------------------------- */

static void consider_near(void *context, const char *name, const char *title, const char *title_zh)
{
    (void)title, (void)title_zh;
    consider_name(context, name);
}

/* Why no name is meant. */
static void put_why(FILE *out, const cagd_register *r, const char *text, enum kind_of_name kind)
{
    struct nearest n = {.text = text};
    if (!is_glob(text))
        visit_names(r, kind, consider_near, &n);
    fprintf(out, "no %s %s '%s'; ", kind == FIGURES ? "figure" : "statement or claim",
            is_glob(text) ? "matches" : "is called", text);
    put_nearest(out, &n, "");
    int is_figure = 0;
    for (const figure *f = r->figures; kind != FIGURES && f->name != NULL; f++)
        is_figure |= n.name[0] == NULL && strcmp(f->name, text) == 0;
    if (n.name[0] == NULL)
        fputs(is_figure         ? "it is a figure: cagd figures draws it"
              : kind == FIGURES ? "cagd figures --list prints the names"
                                : "cagd list and cagd ledger print the names",
              out);
}

const char *name_meant_by(const cagd_register *r, const char *text, enum kind_of_name kind)
{
    enum { LONGEST = 255 };
    char end[LONGEST + 1];
    struct meant m = {.text = text}, titled = {.text = text};
    int formula = as_end_of_id(text, end, sizeof end);
    if (kind != FIGURES && !is_glob(text)) {
        visit_names(r, kind, consider_end, &m);
        if (m.count == 0) {
            m = (struct meant){.text = end, .formula = formula};
            visit_names(r, kind, consider_end, &m);
        }
        if (m.count == 0 || isdigit((unsigned char)end[0])) /* a number alone may stand for any part of a place */
            visit_names(r, kind, consider_part, &m);
        if (m.count == 0)
            visit_names(r, kind, consider_title, &titled);
    }
    if (m.count == 1)
        return m.at[0];
    if (titled.count == 1)
        return titled.at[0];
    struct refusal why;
    refusal_begin(&why);
    if (m.count > 1) {
        fprintf(why.to, "'%s' may be one of %d:", text, m.count);
        put_names(why.to, &m);
        fputs("; which is meant?", why.to);
    } else if (titled.count > 1) {
        fprintf(why.to, "'%s' is in %d titles, of", text, titled.count);
        put_names(why.to, &titled);
        fprintf(why.to, "; cagd list '%s' and cagd ledger '%s' print all", text, text);
    } else {
        put_why(why.to, r, text, kind);
    }
    refusal_put(&why);
    return NULL;
}
