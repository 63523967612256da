#include "cli/check/sheet.h"

#include "cli/check/graphs.h"
#include "cli/check/verdict.h"
#include "cli/input.h"
#include "cli/layout.h"
#include "cli/terminal.h"
#include "cli/tex.h"
#include "core/clock.h"
#include "exact/expression/check.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 92, INDENT = 4, LONGEST = 4096, LABEL = 26 };

/* A property that is a formula is read like any other and checked or, with a parameter, asked for its values. */
struct property {
    const char *key, *title;
    void (*write)(char *text, const struct sheet *s, const cagd_basis *b); /* a formula; or */
    void (*find)(const cagd_basis *b, cagd_found *out);                    /* another question */
    int is_identity;
};

struct answer {
    const struct property *property;
    struct formula formula;
    struct document text; /* in which the formula stands */
    cagd_found found;
    cagd_finding finding;
    int was_checked; /* without a parameter: the finding is the answer */
    int is_left_out; /* it is not asked of functions of an angle */
    int of_limits;   /* decided of the limits at the ends, as the formulas have no values there */
    cagd_negative_minor minor;
};

/* ---- the formulas -------------------------------------------------------------------------------------- */

/* The function with another index and another argument: "\hat B_{7-i}(1-t)". */
static const char *function_with(const struct sheet *s, const char *index, const char *argument)
{
    char text[LONGEST];
    int n =
        snprintf(text, sizeof text, "%.*s{%s}%.*s%s%s", s->index_from, s->functions, index,
                 s->argument_from - s->index_to, s->functions + s->index_to, argument, s->functions + s->argument_to);
    const char *kept = n < LONGEST ? cagd_text_of(text, n) : NULL;
    return kept != NULL ? kept : "";
}

/* The index of the sum is a letter that means nothing else. */
static void sum_is_one(char *text, const struct sheet *s, const cagd_basis *b)
{
    static const char *const letter[] = {"j", "k", "l", "m", "\\nu", "\\mu", "\\kappa"};
    enum { LETTERS = sizeof letter / sizeof *letter };
    int which = 0;
    (void)b;
    while (which + 1 < LETTERS &&
           (cagd_declared(&s->scope, letter[which]) != NULL || cagd_defined(&s->scope, letter[which]) != NULL ||
            strcmp(letter[which], s->argument) == 0))
        which++;
    snprintf(text, LONGEST, "\\sum_{%s=%ld}^{%ld} %s = 1", letter[which], s->first, s->last,
             function_with(s, letter[which], s->argument));
}

static void is_nonnegative(char *text, const struct sheet *s, const cagd_basis *b)
{
    (void)b;
    snprintf(text, LONGEST, "%s \\ge 0", s->functions);
}

static void is_symmetric(char *text, const struct sheet *s, const cagd_basis *b)
{
    char index[128], argument[128];
    snprintf(index, sizeof index, "%ld-%s", s->first + s->last, s->index);
    snprintf(argument, sizeof argument, "%s-%s", b->sum, s->argument);
    snprintf(text, LONGEST, "%s = %s", function_with(s, s->index, argument), function_with(s, index, s->argument));
}

/* Values 1 and 0 at the ends. */
static void interpolates_ends(char *text, const struct sheet *s, const cagd_basis *b)
{
    static const char cases[] = "\\begin{cases} 1, & %s = %ld \\\\ 0, & \\text{otherwise} \\end{cases}";
    char left[128], right[128];
    snprintf(left, sizeof left, cases, s->index, s->first);
    snprintf(right, sizeof right, cases, s->index, s->last);
    snprintf(text, LONGEST, "%s = %s, \\quad %s = %s", function_with(s, s->index, b->end[0]), left,
             function_with(s, s->index, b->end[1]), right);
}

/* An element of the field in TeX, with the letters of the file: v1 is \beta. */
static const char *element_text(const cagd_basis *b, num_f f)
{
    char text[LONGEST];
    int n = 0;
    for (const char *s = cagd_to_string_f(f); *s != '\0' && n < LONGEST - 128;) {
        int known = 0;
        size_t length = strcspn(s, " +-*/^()");
        while (known < b->names && (strlen(b->name[known]) != length || strncmp(s, b->name[known], length) != 0))
            known++;
        if (length == 0 && *s == '^') { /* and its exponent */
            length = strspn(s + 1, "0123456789");
            n += snprintf(text + n, 64, "^{%.*s}", (int)length, s + 1);
            s += length + 1;
        } else if (length == 0) {
            if (*s != '*')
                text[n++] = *s;
            s++;
        } else {
            n += known < b->names ? snprintf(text + n, 120, "{%s}", b->letter[known])
                                  : snprintf(text + n, 120, "%.*s", (int)length, s);
            s += length;
        }
    }
    const char *kept = cagd_text_of(text, n);
    return kept != NULL ? kept : "";
}

/* Likewise of the limits, where x^{i-1} has no value at 0. */
static void limits_at_ends(char *text, const struct sheet *s, const cagd_basis *b)
{
    int n = 0;
    (void)s;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < b->count && n < LONGEST; i++)
            n += snprintf(text + n, (size_t)(LONGEST - n), "%s%s = %d", n > 0 ? ", \\quad " : "",
                          element_text(b, b->at_end[k][0][i]), i == (k == 0 ? 0 : b->count - 1));
}

/* ((t-a)/(b-a))^i ((b-t)/(b-a))^{n-i} times C(n,i). */
static void is_bernstein(char *text, const struct sheet *s, const cagd_basis *b)
{
    const char *low = b->end[0], *high = b->end[1], *length = to_string_q(sub_q(b->t.high, b->t.low));
    snprintf(text, LONGEST,
             "%s = \\binom{%ld}{%s-(%ld)} \\left(\\frac{%s-(%s)}{%s}\\right)^{%s-(%ld)} "
             "\\left(\\frac{%s-%s}{%s}\\right)^{%ld-%s}",
             s->functions, s->last - s->first, s->index, s->first, s->argument, low, length, s->index, s->first, high,
             s->argument, length, s->last, s->index);
}

static const struct property properties[] = {
    {"defined", "defined", NULL, cagd_basis_defined, 0},
    {"linearly_independent", "linearly independent", NULL, cagd_basis_independent, 0},
    {"partition_of_unity", "sum is 1", sum_is_one, NULL, 1},
    {"nonnegative", "nonnegative", is_nonnegative, NULL, 0},
    {"symmetric", "symmetric", is_symmetric, NULL, 1},
    {"interpolates_ends", "1 and 0 at the ends", interpolates_ends, NULL, 1},
    {"bernstein", "the Bernstein basis", is_bernstein, NULL, 1},
    {"totally_positive", "totally positive", NULL, NULL, 0},
};
enum { DEFINED = 0, NONNEGATIVE = 3, ENDS = 5, BERNSTEIN = 6, PROPERTIES = sizeof properties / sizeof *properties };

/* ---- deciding ------------------------------------------------------------------------------------------ */

/* Without a parameter there is one cell, and what holds in it. */
static void decide_formula(struct answer *a, const struct sheet *s, const cagd_basis *b,
                           void (*write)(char *text, const struct sheet *s, const cagd_basis *b), double seconds)
{
    char *text = region_bytes(LONGEST);
    cagd_reading_error error;
    a->found.why = "it cannot be read";
    if (text == NULL)
        return;
    write(text, s, b);
    a->text = (struct document){.path = "", .text = text, .size = (int)strlen(text), .scope = s->scope};
    a->formula = (struct formula){.name = a->property->key, .printed = text, .find = s->find, .scope = s->scope};
    a->formula.tree = cagd_read_statement(&s->scope, text, 0, a->text.size, &error);
    if (a->formula.tree == NULL) {
        a->found.why = cagd_text_of(error.message, (int)strlen(error.message));
        return;
    }
    a->was_checked = s->find == NULL;
    if (a->was_checked)
        cagd_check(&a->formula.scope, a->formula.tree, seconds, &a->finding);
    else
        cagd_find(&a->formula.scope, a->formula.tree, s->find, 0, seconds, &a->found);
}

/* Holds for all values, for none, for some; or it is not known. */
enum extent { FOR_ALL, FOR_NONE, FOR_SOME, NOT_KNOWN };
static enum extent extent_of(const struct answer *a)
{
    const cagd_found *f = &a->found;
    int good = 0, bad = 0;
    if (a->was_checked)
        return a->finding.answer == CAGD_HOLDS ? FOR_ALL : a->finding.answer == CAGD_FAILS ? FOR_NONE : NOT_KNOWN;
    if (!f->known)
        return NOT_KNOWN;
    if (a->formula.find == NULL && f->cells.cell[0] == CAGD_UNDECIDED)
        return NOT_KNOWN;
    for (int k = 0; k <= f->cells.count; k++)
        if (!f->cells.empty[k])
            good |= f->cells.cell[k] == CAGD_HOLDS, bad |= f->cells.cell[k] != CAGD_HOLDS;
    for (int k = 0; k < f->cells.count; k++) {
        const struct cagd_root *r = &f->cells.root[k];
        if (a->formula.find != NULL && (!cagd_equal_q(r->lo, r->hi) || cagd_is_inside(&f->domain, r->lo)))
            good |= f->cells.at[k] == CAGD_HOLDS, bad |= f->cells.at[k] != CAGD_HOLDS;
    }
    return good && bad ? FOR_SOME : good ? FOR_ALL : FOR_NONE;
}

/* Some values are neither good nor bad. */
static int is_open(const struct answer *a)
{
    int open = 0;
    for (int k = 0; a->found.known && k <= a->found.cells.count; k++)
        open |= !a->found.cells.empty[k] && a->found.cells.cell[k] == CAGD_UNDECIDED;
    return open;
}

/* ---- the page ------------------------------------------------------------------------------------------ */

static void heading(const char *text) { printf("\n%s%s%s\n", style(stdout, BOLD), text, style(stdout, PLAIN)); }

static void row(const char *label, const char *tex)
{
    char *plain = tex_to_text(tex, 1);
    printf("%*s", INDENT, "");
    const int own = columns_of(label), columns = own < LABEL ? LABEL : own + 1; /* a long label has a blank behind it */
    put_padded(stdout, label, columns);
    put_behind(stdout, plain, INDENT + columns, INDENT + LABEL, WIDTH);
    free(plain);
}

static const char *joined(const char *format, const char *a, const char *b)
{
    char text[LONGEST];
    int n = snprintf(text, sizeof text, format, a, b);
    const char *kept = cagd_text_of(text, n < LONGEST ? n : LONGEST - 1);
    return kept != NULL ? kept : "";
}

/* Single values of the parameter that are not decided, $k = 0$, $k = 1$; "" where there are none. */
static const char *open_values(const struct answer *a)
{
    const char *text = "";
    for (int k = 0; a->found.known && a->formula.find != NULL && k < a->found.cells.count; k++) {
        const struct cagd_root *r = &a->found.cells.root[k];
        if (a->found.cells.at[k] == CAGD_UNDECIDED &&
            (!cagd_equal_q(r->lo, r->hi) || cagd_is_inside(&a->found.domain, r->lo)))
            text = joined("%s%s", text,
                          joined(text[0] != '\0' ? ", $%s = %s$" : "$%s = %s$", a->formula.find, end_text(r)));
    }
    return text;
}

static const char *values_text(const struct answer *a)
{
    switch (extent_of(a)) {
    case FOR_ALL:
        return a->formula.find == NULL ? "yes" : values_of(&a->formula, &a->found);
    case FOR_NONE:
        return a->formula.find == NULL ? "no" : values_of(&a->formula, &a->found);
    case FOR_SOME:
        return values_of(&a->formula, &a->found);
    default:
        return joined("not decided: %s%s", a->was_checked ? reason_of(&a->text, &a->finding) : a->found.why, "");
    }
}

/* The word is the one of the weakest part. */
static const char *evidence_text(const struct answer *a)
{
    enum extent extent = extent_of(a);
    return extent == NOT_KNOWN ? "" : extent == FOR_ALL && a->property->is_identity ? "proved" : "decided";
}

static void print_properties(const struct answer answer[])
{
    heading("Properties");
    for (int k = 0; k < PROPERTIES; k++) {
        const struct answer *a = &answer[k];
        const char *evidence = evidence_text(a);
        if (a->is_left_out || (k == DEFINED && extent_of(a) == FOR_ALL))
            continue;
        const char *open = open_values(a);
        row(a->property->title, evidence[0] != '\0' && open[0] != '\0' && !is_open(a)
                                    ? joined("%s (%s)", values_text(a), joined("%s; undecided for %s", evidence, open))
                                : evidence[0] != '\0'
                                    ? joined(is_open(a)     ? "%s (%s; for other values it may be undecided)"
                                             : a->of_limits ? "%s, as limits (%s)"
                                                            : "%s (%s)",
                                             values_text(a), evidence)
                                    : values_text(a));
    }
}

static const char *name_of_function(const struct sheet *s, int i, int order)
{
    char index[32];
    snprintf(index, sizeof index, "%ld", s->first + i);
    const char *argument = function_with(s, index, ""), *bracket = strrchr(argument, '(');
    char text[LONGEST];
    snprintf(text, sizeof text, "%s%.*s%s", order > 0 ? "{" : "", bracket != NULL ? (int)(bracket - argument) : 0,
             argument,
             order == 0   ? ""
             : order == 1 ? "}'"
                          : "}''");
    return cagd_text_of(text, (int)strlen(text));
}

static const char *minor_text(const struct answer *a, const struct sheet *s, const cagd_basis *b)
{
    const cagd_negative_minor *m = &a->minor;
    const char *text = "";
    if (s->find != NULL)
        text = joined("$%s = %s$: ", s->find, to_string_q(m->parameter));
    for (int k = 0; k < m->order; k++)
        text = joined(k > 0          ? "%s, $%s$"
                      : m->order > 1 ? "%sthe determinant of $%s$"
                                     : "%s$%s$",
                      text, name_of_function(s, m->first + k, 0));
    for (int k = 0; k < m->order; k++)
        text = joined(k > 0      ? "%s, %s"
                      : b->angle ? joined("%%s at $\\tan(%s/%s) = %%s", s->argument, b->angle == 2 ? "2" : "4")
                                 : "%s at $%s",
                      text, to_string_q(m->t[k]));
    return joined("%s$ is $%s$", text, to_string_q(m->value));
}

/* Numbers for which it is not so; "" where there are none. */
static const char *example_text(const struct answer *a, const struct sheet *s, const cagd_basis *b)
{
    const char *text = "";
    int cell = a->found.known ? cagd_telling_failure(&a->found.cells) : -1;
    if (a->minor.order > 0)
        return minor_text(a, s, b);
    for (int k = 0; a->was_checked && a->finding.has_example && k < a->finding.given; k++)
        text = joined(k > 0 ? "%s, $%s" : "%s$%s", text,
                      joined("%s = %s$", a->finding.example[k].name, value_text(&a->finding.example[k])));
    if (text[0] != '\0' && !a->finding.has_root)
        return joined("%s: %s", text,
                      joined("left $%s$, right $%s$", to_string_q(a->finding.left), to_string_q(a->finding.right)));
    return a->was_checked || s->find == NULL || cell < 0 ? text : breaking_text(&a->formula, &a->found, cell);
}

static void print_examples(const struct sheet *s, const cagd_basis *b, const struct answer answer[])
{
    int first = 1;
    for (int k = 0; k < PROPERTIES; k++) {
        const char *text = example_text(&answer[k], s, b);
        if (text[0] == '\0')
            continue;
        if (first)
            heading("Where it is not so");
        first = 0;
        row(answer[k].property->title, text);
    }
}

static void print_ends(const struct sheet *s, const cagd_basis *b)
{
    static const char *const title[] = {"values", "first derivatives", "second derivatives"};
    heading("At the ends, what is not 0");
    for (int k = 0; k < 2; k++)
        for (int order = 0; order < CAGD_END_ORDERS; order++) {
            const char *text = "";
            for (int i = 0; i < b->count; i++)
                if (!cagd_is_zero_f(b->at_end[k][order][i]))
                    text = joined(
                        text[0] != '\0' ? "%s, $%s$" : "%s$%s$", text,
                        joined("%s = %s", name_of_function(s, i, order), element_text(b, b->at_end[k][order][i])));
            char label[96], *end = tex_to_text(b->end[k], 0);
            snprintf(label, sizeof label, "%s at %s", title[order], end);
            free(end);
            row(label, text[0] != '\0' ? text : "none");
        }
}

static void print_coefficients(const struct sheet *s, const cagd_basis *b)
{
    char title[64];
    if (b->degree < 0 || b->coefficient == NULL)
        return;
    snprintf(title, sizeof title, "Bernstein coefficients of degree %d", b->degree);
    heading(title);
    for (int i = 0; i < b->count; i++) {
        const char *text = "";
        for (int j = 0; j <= b->degree; j++)
            text =
                joined(j > 0 ? "%s, $%s$" : "%s$%s$", text, element_text(b, b->coefficient[i * (b->degree + 1) + j]));
        char *label = tex_to_text(name_of_function(s, i, 0), 0);
        row(label, text);
        free(label);
    }
}

static void print_monotony(const struct sheet *s, const cagd_basis *b)
{
    static const char *const title[] = {"does not change", "increases", "decreases", "neither", "not decided"};
    if (!b->has_parameter)
        return;
    heading("When the parameter grows");
    const char *list[5] = {"", "", "", "", ""};
    for (int i = 0; i < b->count; i++) {
        cagd_monotony m = cagd_basis_monotony(b, i);
        list[m] = joined(list[m][0] != '\0' ? "%s, $%s$" : "%s$%s$", list[m], name_of_function(s, i, 0));
    }
    for (int k = 0; k < 5; k++)
        if (list[k][0] != '\0')
            row(title[k], list[k]);
}

static void print_page(const struct document *d, const struct sheet *s, const cagd_basis *b,
                       const struct answer answer[], const char *why)
{
    char range[256];
    if (why != NULL) {
        printf("%s%s%s  (%s:%d)\n", style(stdout, BOLD), s->name, style(stdout, PLAIN), name_of_input(d->path),
               s->line);
        heading("Not decided");
        put_paragraph(stdout, why, INDENT, WIDTH);
        return;
    }
    printf("%s%s%s  (%s:%d)\n", style(stdout, BOLD), s->name, style(stdout, PLAIN), name_of_input(d->path), s->line);
    heading("Functions");
    snprintf(range, sizeof range, ", $%s = %ld$ to $%ld$, $%s %s %s %s %s$%s%s%s", s->index, s->first, s->last,
             b->end[0], b->t.low_open ? "<" : "\\le", s->argument, b->t.high_open ? "<" : "\\le", b->end[1],
             s->find != NULL ? "; the parameter is $" : "", s->find != NULL ? s->find : "", s->find != NULL ? "$" : "");
    char *plain = tex_to_text(joined("$%s$%s", s->functions, range), 1);
    put_paragraph(stdout, plain, INDENT, WIDTH);
    free(plain);
    print_properties(answer);
    print_examples(s, b, answer);
    print_monotony(s, b);
    print_ends(s, b);
    print_coefficients(s, b);
}

/* ---- JSON ---------------------------------------------------------------------------------------------- */

static json_t *plain_json(const char *tex, int mixed)
{
    char *plain = tex_to_text(tex, mixed);
    json_t *j = json_string(plain);
    free(plain);
    return j;
}

static json_t *property_json(const struct answer *a, const struct sheet *s, const cagd_basis *b)
{
    static const char *const words[] = {"holds", "fails", "holds for some values", "undecided"};
    enum extent extent = extent_of(a);
    json_t *j = json_pack("{s:s, s:s, s:s}", "property", a->property->key, "verdict", words[extent], "evidence",
                          extent == NOT_KNOWN ? "none" : evidence_text(a));
    if (a->formula.printed != NULL)
        json_object_set_new(j, "formula_tex", json_string(a->formula.printed));
    if (extent == NOT_KNOWN)
        json_object_set_new(j, "reason", plain_json(values_text(a), 1));
    else if (s->find != NULL)
        json_object_set_new(j, "values", plain_json(values_text(a), 1));
    const char *example = example_text(a, s, b);
    if (example[0] != '\0')
        json_object_set_new(j, "fails_for", plain_json(example, 1));
    json_object_set_new(j, "complete", json_boolean(!is_open(a)));
    if (a->of_limits)
        json_object_set_new(j, "of_limits", json_true());
    return j;
}

/* Functions that are not understood, and why. */
static json_t *refused_json(const struct sheet *s, const char *why)
{
    return json_pack("{s:s, s:i, s:s, s:I, s:I, s:s}", "name", s->name, "line", s->line, "functions_tex", s->functions,
                     "first", (json_int_t)s->first, "last", (json_int_t)s->last, "reason", why);
}

static json_t *sheet_json(const struct sheet *s, const cagd_basis *b, const struct answer answer[])
{
    static const char *const monotony[] = {"constant", "increasing", "decreasing", "neither", "undecided"};
    json_t *properties_list = json_array(), *ends = json_array();
    for (int k = 0; k < PROPERTIES; k++)
        if (!answer[k].is_left_out)
            json_array_append_new(properties_list, property_json(&answer[k], s, b));
    for (int k = 0; k < 2; k++)
        for (int order = 0; order < CAGD_END_ORDERS; order++) {
            json_t *values = json_array();
            for (int i = 0; i < b->count; i++)
                json_array_append_new(values, plain_json(element_text(b, b->at_end[k][order][i]), 0));
            json_array_append_new(
                ends, json_pack("{s:o, s:i, s:o}", "at", plain_json(b->end[k], 0), "order", order, "values", values));
        }
    json_t *j =
        json_pack("{s:s, s:i, s:s, s:I, s:I, s:[o,o], s:o, s:o}", "name", s->name, "line", s->line, "functions_tex",
                  s->functions, "first", (json_int_t)s->first, "last", (json_int_t)s->last, "interval",
                  plain_json(b->end[0], 0), plain_json(b->end[1], 0), "properties", properties_list, "ends", ends);
    if (s->find != NULL) {
        json_t *list = json_array();
        for (int i = 0; i < b->count; i++)
            json_array_append_new(list, json_string(monotony[cagd_basis_monotony(b, i)]));
        json_object_set_new(j, "parameter", json_string(s->find));
        json_object_set_new(j, "with_parameter", list);
    }
    if (b->degree >= 0 && b->coefficient != NULL) {
        json_t *rows = json_array();
        for (int i = 0; i < b->count; i++) {
            json_t *row_of_i = json_array();
            for (int k = 0; k <= b->degree; k++)
                json_array_append_new(row_of_i,
                                      plain_json(element_text(b, b->coefficient[i * (b->degree + 1) + k]), 0));
            json_array_append_new(rows, row_of_i);
        }
        json_object_set_new(j, "bernstein_coefficients", rows);
    }
    return j;
}

/* ---- the whole ----------------------------------------------------------------------------------------- */

/* The values of the picture: those of the file, or the ends of the first range in which the functions are nonnegative and a
 * number between them; their number. */
static int values_shown(const struct sheet *s, const cagd_basis *b, const struct answer *nonnegative, num_q value[])
{
    int count = 0;
    for (int k = 0; k < s->shown_count; k++)
        value[count++] = s->shown[k];
    if (count > 0 || s->find == NULL)
        return count;
    const cagd_cells *c = &nonnegative->found.cells;
    for (int k = 0; nonnegative->found.known && k <= c->count && count == 0; k++) {
        if (c->empty[k] || c->cell[k] != CAGD_HOLDS)
            continue;
        const cagd_side_of_box *range = &b->range;
        if (k > 0 ? cagd_equal_q(c->root[k - 1].lo, c->root[k - 1].hi) : range->has_low && !range->low_open)
            value[count++] = k > 0 ? c->root[k - 1].lo : range->low;
        value[count++] = c->sample[k];
        if (k < c->count ? cagd_equal_q(c->root[k].lo, c->root[k].hi) : range->has_high && !range->high_open)
            value[count++] = k < c->count ? c->root[k].lo : range->high;
    }
    if (count == 0)
        value[count++] = cagd_inside(&b->range);
    return count;
}

/* The formulas have no values at an end, but the functions, of which b is read anew, have limits. */
static void decide_limits(struct answer *a, const struct sheet *s, const cagd_basis *b, double seconds)
{
    struct answer limits = {.property = a->property};
    decide_formula(&limits, s, b, limits_at_ends, seconds);
    if (extent_of(&limits) == NOT_KNOWN)
        return;
    *a = limits;
    a->of_limits = 1;
}

int check_sheet(const struct document *d, const struct sheet *s, json_t *list, svg *picture)
{
    struct answer *answer = cagd_region_array(PROPERTIES, 1, sizeof *answer);
    cagd_basis *b = region_bytes(sizeof *b);
    double until = cagd_seconds() + s->seconds;
    int all = 1;
    const char *why = NULL;
    if (answer == NULL || b == NULL)
        return 0;
    for (int k = 0; k < PROPERTIES; k++) {
        struct answer *a = &answer[k];
        *a = (struct answer){.property = &properties[k], .formula = {.find = s->find}};
        why = cagd_basis_read(&s->scope, s->tree, s->index, s->first, s->last, s->find, b);
        double left = until - cagd_seconds();
        a->is_left_out = why == NULL && b->angle && k == BERNSTEIN;
        if (a->is_left_out)
            continue;
        if (why != NULL)
            a->found.why = why;
        else if (a->property->write != NULL)
            decide_formula(a, s, b, a->property->write, left > 0.1 ? left : 0.1);
        else if (a->property->find != NULL)
            a->property->find(b, &a->found);
        else
            cagd_basis_totally_positive(b, left > 0.1 ? left : 0.1, &a->found, &a->minor);
        if (k == ENDS && extent_of(a) == NOT_KNOWN &&
            (why = cagd_basis_read(&s->scope, s->tree, s->index, s->first, s->last, s->find, b)) == NULL)
            decide_limits(a, s, b, left > 0.1 ? left : 0.1);
        all &= extent_of(a) != NOT_KNOWN && !is_open(a);
    }
    if (why == NULL) /* the field of the last property is open still, or that of a formula */
        why = cagd_basis_read(&s->scope, s->tree, s->index, s->first, s->last, s->find, b);
    if (list == NULL)
        print_page(d, s, b, answer, why);
    else
        json_array_append_new(list, why != NULL ? refused_json(s, why) : sheet_json(s, b, answer));
    int left = picture != NULL ? svg_panels_left(picture) : 0;
    if (why == NULL && left > 0) {
        num_q value[MOST_SHOWN];
        int shown = values_shown(s, b, &answer[NONNEGATIVE], value);
        draw_basis(picture, s, b, shown < left ? shown : left, value);
    }
    return all;
}
