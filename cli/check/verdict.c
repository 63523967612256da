#include "cli/check/verdict.h"

#include "cli/input.h"
#include "cli/layout.h"
#include "cli/terminal.h"
#include "cli/tex.h"
#include "exact/expression/bounds.h"
#include "exact/expression/depends.h"
#include "exact/words.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 92, INDENT = 4, READABLE = 60 };

const char *verdict_of(const cagd_finding *f) { return expected_name[f->answer]; }

const char *evidence_of_finding(const cagd_finding *f)
{
    static const char *const words[] = {"none", "decided", "proved"};
    return f->answer == CAGD_UNDECIDED ? "none" : f->answer == CAGD_FAILS ? "decided" : words[f->strength];
}

/* ---- scope --------------------------------------------------------------------------------------------- */

/* A text that grows, in the region. */
static const char *append(const char *text, const char *format, ...) __attribute__((format(printf, 2, 3)));
static const char *append(const char *text, const char *format, ...)
{
    va_list list, again;
    va_start(list, format);
    va_copy(again, list);
    const size_t n = strlen(text), m = (size_t)vsnprintf(NULL, 0, format, list);
    va_end(list);
    char *both = region_bytes(n + m + 1);
    if (both != NULL) {
        memcpy(both, text, n);
        vsnprintf(both + n, m + 1, format, again);
    }
    va_end(again);
    return both != NULL ? both : text;
}

static int is_number(const struct cagd_root *r) { return cagd_equal_q(r->lo, r->hi); }

/* The first digits of a root, none of them rounded. */
static const char *digits_of(const struct cagd_root *r)
{
    char digits[64];
    struct cagd_root fine = refine_root(*r, from_ratio_q(1, 1000000000));
    int length = snprintf(digits, sizeof digits, "%.9f", to_double_q(fine.lo));
    return append("", "%.*s\\dots", length > 3 && length < 60 ? length - 3 : length, digits);
}

/* In whole numbers without a common divisor, as it is written: "24 x^{10} - x^9 + 3". */
static const char *polynomial_text(poly of)
{
    poly p = cagd_poly_primitive(of);
    const char *text = "";
    for (int k = cagd_poly_degree(p); k >= 0; k--) {
        num_q c = cagd_poly_coefficient(p, k);
        int minus = cagd_sign_q(c) < 0, first = text[0] == '\0';
        const char *size = to_string_q(minus ? neg_q(c) : c);
        if (cagd_is_zero_q(c))
            continue;
        text = append(text, "%s", first ? (minus ? "-" : "") : minus ? " - " : " + ");
        if (k == 0 || strcmp(size, "1") != 0)
            text = append(text, "%s%s", size, k > 0 ? " " : "");
        text = k > 1 ? append(text, k < 10 ? "x^%d" : "x^{%d}", k) : append(text, "%s", k == 1 ? "x" : "");
    }
    return text;
}

/* "$1.41\dots$ is the root of $x^2 - 2$ between $1$ and $2$." */
static const char *root_text(const struct cagd_root *r)
{
    return append("", "$%s$ is the root of $%s$ between $%s$ and $%s$.", digits_of(r), polynomial_text(r->factor),
                  to_string_q(r->lo), to_string_q(r->hi));
}

const char *value_text(const cagd_given *g) { return g->root != NULL ? digits_of(g->root) : to_string_q(g->value); }

static const char *source(const struct document *d, const cagd_tree *t)
{
    if (t != NULL && t->kind == CAGD_NUMBER && (d->text[t->from] == 'N' || d->text[t->from] == 'Z')) /* of \mathbb{N} */
        return to_string_q(t->number);
    const char *text = t != NULL ? cagd_text_of(d->text + t->from, t->to - t->from) : NULL;
    return text != NULL ? text : "";
}

/* A list as it is printed, from its first number to its last one, and the other way round where it goes down. */
static const char *as_printed(const struct document *d, const cagd_tree *a, const cagd_tree *b)
{
    int from = a->from < b->from ? a->from : b->from, to = a->to > b->to ? a->to : b->to;
    const char *text = cagd_text_of(d->text + from, to - from);
    return text != NULL ? text : "";
}

/* The letters of a name without its numbers: "\omega" of "\omega_3", "\mathbf{P}" of the component "(\mathbf{P}_0)_x". */
static int is_of(const char *key, const char *head)
{
    size_t n = strlen(head);
    key += key[0] == '(' && head[0] != '(';
    return strncmp(key, head, n) == 0 && (key[n] == '\0' || key[n] == ')' || head[n - 1] == '_' || key[n] == '^');
}

/* Whether a condition for every index speaks of names that the statement has; any other condition is told. */
static int is_about_names(const cagd_finding *f, const cagd_tree *t)
{
    int is = t->kind != CAGD_EVERY_INDEX && t->kind != CAGD_NAME && t->kind != CAGD_RELATION && t->kind != CAGD_ALL;
    if (t->kind == CAGD_RELATION || t->kind == CAGD_ALL)
        return 1;
    for (int k = 0; t->kind == CAGD_EVERY_INDEX && k < f->names && !is; k++)
        for (int m = 0; m < t->at[0]->count && !is; m++)
            is = t->at[0]->at[m]->kind == CAGD_NAME && is_of(f->name[k], t->at[0]->at[m]->head);
    return is;
}

/* Whether it is a value that the ranges of the statement give: the other statements do not know it. */
static int is_given_here(const struct document *d, const cagd_definition *value)
{
    for (const cagd_definition *other = d->scope.definitions; other != NULL; other = other->next)
        if (other->left == value->left)
            return 0;
    return 1;
}

/* Whether the name, one of many, has bounds of its own. */
static int is_bounded_alone(const cagd_scope *scope, const char *key)
{
    const cagd_variable *v = cagd_declared(scope, key);
    return v != NULL && v->lower == 0;
}

/* Whether it is read from a piece of what the one before was: 0 \le u, v \le 1. */
static int is_part_of(const cagd_tree *t, const cagd_tree *before)
{
    return before != NULL && before->from <= t->from && t->to == before->to;
}

/* Whether the finding has names that are called as the variable, and of which its bounds are not. */
static int has_others(const cagd_finding *f, const cagd_variable *v)
{
    int has = 0;
    for (int k = 0; v->some && k < f->names && !has; k++)
        if (is_of(f->name[k], v->head)) {
            const char *index = f->name[k] + strlen(v->head);
            long value = strtol(index + (*index == '{'), NULL, 10);
            has = value < v->first || value > v->last;
        }
    return has;
}

static int has_root(const cagd_tree *t)
{
    int has = t->kind == CAGD_ROOT;
    for (int k = 0; k < t->count && !has; k++)
        has = has_root(t->at[k]);
    return has;
}

/* Whether it says that a value is within the bounds of its name: both are told. */
static int is_of_value(const struct formula *s, const cagd_tree *condition)
{
    for (const cagd_definition *d = s->scope.definitions; d != NULL; d = d->next)
        if (d->left->from == condition->from && d->left->to <= condition->to && d->left->count == 0)
            return 1;
    return 0;
}

const char *scope_of_finding(const struct document *d, const struct formula *s, const cagd_finding *f)
{
    const cagd_variable *whole[16];
    const char *text = "", *comma = "";
    int count = cagd_whole_numbers(&s->scope, s->tree, whole, 16);
    for (int k = 0; k < count; k++, comma = ", ") {
        const cagd_variable *v = whole[k];
        if (v->high == NULL)
            text = append(text, "%severy $%s %s %s$", comma, v->head, v->low_open ? ">" : "\\ge", source(d, v->low));
        else if (v->step > 1 || v->listed != NULL)
            text = append(text, "%s$%s = %s$", comma, v->head, as_printed(d, v->low, v->high));
        else if (v->low_open || v->high_open)
            text = append(text, "%swhole $%s %s %s %s %s$", comma, source(d, v->low), v->low_open ? "<" : "\\le",
                          v->head, v->high_open ? "<" : "\\le", source(d, v->high));
        else
            text = append(text, "%s$%s = %s$ to $%s$", comma, v->head, source(d, v->low), source(d, v->high));
    }
    int variables = 0;
    for (const cagd_variable *v = s->scope.variables; v != NULL; v = v->next)
        variables++;
    for (int which = variables - 1; which >= 0; which--) { /* the last declared stands first */
        const cagd_variable *v = s->scope.variables;
        for (int k = 0; k < which; k++)
            v = v->next;
        int named = 0;
        for (int k = 0; k < f->names; k++)
            named |= is_of(f->name[k], v->head) && (v->lower == 0 || !is_bounded_alone(&s->scope, f->name[k]));
        if (!named || cagd_declared(&s->scope, v->head) != v)
            continue;
        const char *letter = v->lower == 0 ? "" : "i";
        if (v->lower == 1 && v->left != NULL && v->left->at[0]->kind == CAGD_NAME &&
            ((v->low != NULL && cagd_tree_has(v->low, v->left->at[0]->head)) ||
             (v->high != NULL && cagd_tree_has(v->high, v->left->at[0]->head))))
            letter = v->left->at[0]->head;
        int bounded = f->bounded && (v->low != NULL || v->high != NULL);
        if (!bounded)
            text = append(text, "%sall $%s%s$", comma, v->head, letter);
        else
            text = append(text, "%s$%s%s%s%s%s%s$", comma, source(d, v->low),
                          v->low == NULL ? ""
                          : v->low_open  ? " < "
                                         : " \\le ",
                          v->head, letter,
                          v->high == NULL ? ""
                          : v->high_open  ? " < "
                                          : " \\le ",
                          source(d, v->high));
        if (bounded && has_others(f, v))
            text = append(text, " for $%s = %ld$ to $%ld$", letter, v->first, v->last);
        else if (bounded && v->when != NULL && !v->some)
            text = append(text, " for some indices");
        comma = ", ";
    }
    for (int k = 0; k < f->names; k++) {
        int declared = 0;
        for (const cagd_variable *v = s->scope.variables; v != NULL; v = v->next)
            declared |= is_of(f->name[k], v->head);
        if (!declared)
            text = append(text, "%sall $%s$", comma, f->name[k]), comma = ", ";
    }
    for (const cagd_definition *value = s->scope.definitions; value != NULL; value = value->next)
        if (is_given_here(d, value) && cagd_depends_on(&s->scope, s->tree, value->left->head))
            text = append(text, "%s$%s = %s$", comma, source(d, value->left), source(d, value->body)), comma = ", ";
    for (int k = 0; k < s->scope.condition_count; k++) {
        if (!is_about_names(f, s->scope.conditions[k]) || is_of_value(s, s->scope.conditions[k]) ||
            is_part_of(s->scope.conditions[k], k > 0 ? s->scope.conditions[k - 1] : NULL))
            continue;
        text = append(text, "%s$%s$", comma, source(d, s->scope.conditions[k]));
        comma = ", ";
    }
    const cagd_tree *one, *last = NULL;
    for (int k = 0; f->supposed != NULL && k < (f->supposed->kind == CAGD_ALL ? f->supposed->count : 1);
         k++, last = one) {
        one = f->supposed->kind == CAGD_ALL ? f->supposed->at[k] : f->supposed;
        if (is_part_of(one, last))
            continue;
        text = append(text, "%s$%s$", comma, source(d, one));
        comma = ", ";
    }
    const cagd_tree *premise = s->tree->kind == CAGD_IMPLIES ? s->tree->at[0] : NULL;
    for (int k = 0; premise != NULL && k < (premise->kind == CAGD_ALL ? premise->count : 1); k++) {
        one = premise->kind == CAGD_ALL ? premise->at[k] : premise;
        if ((s->tree->at[0]->from < s->tree->at[1]->from && !cagd_is_range_of_name(&s->scope, one, NULL)) ||
            has_root(one) || is_part_of(one, k > 0 ? premise->at[k - 1] : NULL))
            continue;
        text = append(text, "%s$%s$", comma, source(d, one));
        comma = ", ";
    }
    if (f->leaves_out_poles)
        text = append(text, "%swherever both sides are defined", text[0] != '\0' ? ", " : "");
    return text;
}

const char *reason_of(const struct document *d, const cagd_finding *f)
{
    const char *text = "";
    if (f->out_of_time)
        text = append(text, "the time was over after %ld case%s", f->cases, f->cases == 1 ? "" : "s");
    if (f->why != NULL)
        text = append(text, "%s%s", text[0] != '\0' ? "; " : "", f->why);
    if (f->where != NULL) {
        int line, column;
        const char *file = place_of(d, f->where->from, &line, &column);
        text = append(text, " (%s%sline %d, column %d: %s)", file != d->path ? file : "", file != d->path ? ", " : "",
                      line, column, source(d, f->where));
    }
    if (text[0] == '\0')
        text = append(text, "no way to decide it was found in the time that it has");
    return text;
}

/* ---- the page ------------------------------------------------------------------------------------------ */

static void heading(const char *text) { printf("\n%s%s%s\n", style(stdout, BOLD), text, style(stdout, PLAIN)); }

static void paragraph(const char *tex, int mixed)
{
    char *plain = tex_to_layout(tex, mixed);
    put_paragraph(stdout, plain, INDENT, WIDTH);
    free(plain);
}

static void labelled(const char *tex, int width, const char *value)
{
    char *plain = tex_to_text(tex, 0);
    printf("%*s", INDENT, "");
    put_padded(stdout, plain, width);
    printf(" = %s\n", value);
    free(plain);
}

static int width_of(const char *tex)
{
    char *plain = tex_to_text(tex, 0);
    int width = columns_of(plain);
    free(plain);
    return width;
}

static const char *const relation_word[] = {"=", "\\ne", "<", "\\le", ">", "\\ge"};

static const char *const order_word[] = {"less than", "equal to", "greater than"};

/* A side of what fails; of vectors and matrices the component that does. */
static const char *side_of(const struct document *d, const cagd_tree *t)
{
    int dimension = t->kind == CAGD_COMPONENT ? t->at[0]->dimension : 0, columns = cagd_columns(dimension);
    int is_bracket = dimension > 0 && t->at[0]->kind == CAGD_POINT && source(d, t)[0] == '(';
    const char *text = source(d, t), *open = is_bracket ? "" : "(", *close = is_bracket ? "" : ")";
    if (dimension == 0)
        return text;
    if (columns > 1)
        return append("", "%s%s%s_{%d%d}", open, text, close, t->order / columns + 1, t->order % columns + 1);
    return dimension <= 3 ? append("", "%s%s%s_%c", open, text, close, "xyz"[t->order])
                          : append("", "%s%s%s_%d", open, text, close, t->order + 1);
}

static void print_example(const struct document *d, const cagd_finding *f)
{
    int relates = f->of_left != NULL && !f->has_root;
    const char *sides[2] = {relates ? side_of(d, f->of_left) : "", relates ? side_of(d, f->of_right) : ""};
    int width = 0;
    for (int k = 0; k < 2; k++)
        if (width_of(sides[k]) > READABLE / 2)
            sides[k] = k == 0 ? "left" : "right";
    for (int k = 0; k < f->given + 2 * relates; k++) {
        int w = width_of(k < f->given ? f->example[k].name : sides[k - f->given]);
        width = w > width ? w : width;
    }
    heading("Counterexample");
    for (int k = 0; k < f->given; k++) {
        char *digits = f->example[k].root != NULL ? tex_to_text(value_text(&f->example[k]), 0) : NULL;
        labelled(f->example[k].name, width, digits != NULL ? digits : to_string_q(f->example[k].value));
        free(digits);
    }
    for (int k = 0; k < f->given; k++)
        if (f->example[k].root != NULL)
            paragraph(append("", "Here %s", root_text(f->example[k].root)), 1);
    if (f->has_root && f->of_left != NULL && f->of_left->dimension != 0)
        paragraph("There the two sides are different.", 1);
    else if (f->is_enclosed)
        paragraph(append("",
                         "The left side, about %.6g, is %s the right one, about %.6g: decided with rational bounds of "
                         "what is no rational number.",
                         f->near_left, order_word[f->order + 1], f->near_right),
                  1);
    else if (f->has_root)
        paragraph(append("The left side is ", "%s the right one.", order_word[f->order + 1]), 1);
    if (!relates)
        return;
    labelled(sides[0], width, to_string_q(f->left));
    if (f->of_right->kind != CAGD_NUMBER)
        labelled(sides[1], width, to_string_q(f->right));
}

/* What the variable of a difference stands for. */
static const char *meaning_of(const struct document *d, const struct cagd_variable_text *v, const char *n)
{
    const char *by = v->by > 1 ? append("", "%d%s", v->by, n) : n;
    return v->of != NULL         ? append("", "$%s$ taken up to $%s$", source(d, v->of), by)
           : v->power_of != NULL ? append("", "(%s)^%s", v->power_of, n)
                                 : append("", "(%s)!", by);
}

/* A difference that is 0 for the first number, and from one number to the next. */
static void print_induction(const struct document *d, const cagd_every *e)
{
    paragraph(append("", "By induction over $%s$. The difference of both sides is a fraction with the numerator", e->n),
              1);
    paragraph(append("E(", "%s) = %s", e->n, e->E), 0);
    for (int i = 0; i < e->variables; i++) {
        const struct cagd_variable_text *v = &e->variable[i];
        int same = strcmp(v->times, "1") == 0, alone = strcmp(v->plus, "0") == 0;
        const char *text = append("where ", "%s(%s) is %s, ", v->name, e->n, meaning_of(d, v, e->n));
        text = append(text, "%s(%s+1) = %s%s%s%s", v->name, e->n, same ? "" : "(", same ? "" : v->times,
                      same ? "" : ") ", v->name);
        paragraph(append(text, "%s%s.", alone ? "" : " + ", alone ? "" : v->plus), 1);
    }
    paragraph(append("So E(", "%s+1) = r E(%s), r = %s.", e->n, e->n, e->ratio), 1);
}

/* R, or how long it is where nobody would read it. */
static void print_quotient(const char *R)
{
    enum { LONGEST = 600 };
    int terms = 0;
    for (const char *c = R; *c != '\0'; c++)
        terms += c == R || *c == '/' || ((*c == '+' || *c == '-') && c[-1] != '(' && c[-1] != '^');
    if (strlen(R) <= LONGEST)
        paragraph(append("R = ", "%s", R), 0);
    else
        paragraph(append("", "R is a quotient of polynomials with %d terms in all, which --json has.", terms), 1);
}

/* Two sides of a chain, or one of several relations. */
static const char *link_of(const struct document *d, const cagd_tree *link)
{
    if (link->count > 2)
        return source(d, link);
    return append(source(d, link->at[0]), " = %s", source(d, link->at[1]));
}

/* Both sides by the same terms. */
static void print_similar(const cagd_every *e)
{
    if (e->by_factorials)
        paragraph("C(N, K) = N!/(K! (N - K)!), since 0 \xe2\x89\xa4 K \xe2\x89\xa4 N for all of them", 1);
    for (int i = 0; i < e->rewritten; i++)
        paragraph(append("", "%s = %s %s", e->rewriting[i].from, e->rewriting[i].factor, e->rewriting[i].to), 0);
    paragraph(e->rewritten > 0 || e->by_factorials
                  ? "So both sides are one rational function of the whole numbers, the names, and the terms and powers "
                    "that are left."
                  : "Both sides are one rational function of the whole numbers, the names, and the terms and powers in "
                    "them.",
              1);
}

/* What everybody can check: the identity of rational functions that telescopes. */
static void print_proof(const struct document *d, const cagd_every *e)
{
    if (e->of != NULL)
        paragraph(append("", "Of $%s$:", link_of(d, e->of)), 1);
    if (e->real) {
        paragraph(append("", "It was decided for every real number $%s \\ge %ld$, and before that one by one.", e->n,
                         e->from),
                  1);
        return;
    }
    if (e->similar) {
        print_similar(e);
        return;
    }
    if (e->E != NULL)
        print_induction(d, e);
    if (e->closed && (e->E == NULL || e->sums > 0)) {
        paragraph(append("",
                         "Both sides have closed forms, in which $%s$ and what has it as exponent or in a factorial "
                         "are variables.",
                         e->n),
                  1);
        for (int i = 0; i < e->sums; i++)
            paragraph(append("",
                             "The terms F of the sum over $%s$ are differences: %s F(%s) = G(%s+1) - G(%s), %s = %s",
                             e->sum[i].k, strcmp(e->sum[i].a, "1") == 0 ? "" : e->sum[i].a, e->sum[i].k, e->sum[i].k,
                             e->sum[i].k, e->sum[i].G != NULL ? "G" : "G = R F, R",
                             e->sum[i].G != NULL ? e->sum[i].G : e->sum[i].R),
                      1);
    }
    if (e->closed)
        return;
    paragraph(append("", "By creative telescoping, for $F(%s,%s)$ the terms of the sum%s and $G = R F$:", e->n, e->k,
                     e->counted ? append("", ", with $%s$ counted from the first one", e->k) : ""),
              1);
    const char *sum = "";
    for (int j = 0; j <= e->order; j++)
        sum = append(sum, "%s(%s) F(%s%s,%s)", j > 0 ? " + " : "", e->a[j], e->n,
                     j == 0   ? ""
                     : j == 1 ? "+1"
                              : "+2",
                     e->k);
    paragraph(append(sum, " = G(%s,%s+1) - G(%s,%s)", e->n, e->k, e->n, e->k), 0);
    print_quotient(e->R);
    paragraph(
        append("",
               "Nothing is left at the ends. The right side satisfies the same recurrence for $%s \\ge %ld$, and the "
               "first cases were computed.",
               e->n, e->from),
        1);
}

static void print_every(const struct document *d, const cagd_every *e)
{
    heading("Proof");
    for (; e != NULL; e = e->next)
        print_proof(d, e);
}

static void print_head(const struct document *d, const struct formula *s)
{
    printf("%s%s%s  (%s:%d)\n", style(stdout, BOLD), s->name, style(stdout, PLAIN), name_of_input(d->path), s->line);
    heading("Printed");
    paragraph(s->printed, 0);
    heading("Verdict");
}

/* The next range that was given for this statement and of which nothing depends, behind v; from the first one for NULL. */
static const cagd_variable *unused_range(const struct document *d, const struct formula *s, const cagd_variable *v)
{
    const cagd_variable *used[16];
    int count = cagd_whole_numbers(&s->scope, s->tree, used, 16);
    for (v = v == NULL ? s->scope.variables : v->next; v != d->scope.variables && v != NULL; v = v->next) {
        int is_used = !v->whole || cagd_declared(&s->scope, v->head) != v;
        for (int k = 0; k < count; k++)
            is_used |= used[k] == v;
        for (const cagd_variable *other = d->scope.variables; other != NULL; other = other->next)
            is_used |= other == v;
        for (int k = d->scope.condition_count; k < s->scope.condition_count; k++)
            is_used |=
                s->scope.conditions[k]->kind == CAGD_FOR_ALL && strcmp(s->scope.conditions[k]->head, v->head) == 0;
        for (const cagd_definition *a = s->scope.definitions; a != NULL; a = a->next)
            is_used |= a->when != NULL && cagd_tree_has(a->when, v->head) &&
                       cagd_depends_on(&s->scope, s->tree, a->left->head);
        for (const cagd_variable *w = s->scope.variables; w != NULL; w = w->next) /* x_i \ge 0, i = 2, 3, 4 */
            is_used |= w->when != NULL && cagd_tree_has(w->when, v->head) &&
                       cagd_depends_on(&s->scope, s->tree, w->head);
        if (!is_used)
            return v;
    }
    return NULL;
}

/* Sums over nothing, and ranges without use. */
static void print_oddities(const struct document *d, const struct formula *s, const cagd_finding *f)
{
    for (int k = 0; k < f->sums.count; k++)
        if (!f->sums.had_terms[k])
            paragraph(append("", "$%s$ goes over nothing.", source(d, f->sums.sum[k])), 1);
    for (const cagd_variable *v = unused_range(d, s, NULL); v != NULL; v = unused_range(d, s, v))
        paragraph(append("", "Nothing depends on $%s$, for which a range is given.", v->head), 1);
}

static void add_oddities(json_t *j, const struct document *d, const struct formula *s, const cagd_finding *f)
{
    json_t *sums = json_array(), *ranges = json_array();
    for (int k = 0; k < f->sums.count; k++)
        if (!f->sums.had_terms[k])
            json_array_append_new(sums, json_string(source(d, f->sums.sum[k])));
    for (const cagd_variable *v = unused_range(d, s, NULL); v != NULL; v = unused_range(d, s, v))
        json_array_append_new(ranges, json_string(v->head));
    if (json_array_size(sums) > 0)
        json_object_set(j, "over_nothing", sums);
    if (json_array_size(ranges) > 0)
        json_object_set(j, "unused_ranges", ranges);
    json_decref(sums);
    json_decref(ranges);
}

void print_finding_page(const struct document *d, const struct formula *s, const cagd_finding *f)
{
    print_head(d, s);
    const char *scope = scope_of_finding(d, s, f), *words = "";
    if (f->answer == CAGD_HOLDS) {
        words = append("", "It holds as printed: %s", evidence_of_finding(f));
        words = append(words, "%s%s.", scope[0] != '\0' ? " for " : "", scope);
    } else if (f->answer == CAGD_FAILS) {
        words = append("", "It fails as printed (decided)");
        if (f->cases > 1)
            words = append(words, ": in %ld of %ld cases", f->failing, f->cases);
        if (f->undecided > 0)
            words = append(words, ", %ld undecided", f->undecided);
        words = append(words, ".");
    } else {
        words = append("", "It is undecided: %s.", reason_of(d, f));
        if (f->cases > f->undecided + f->failing && !f->first_alone)
            words = append(words, " Of %ld cases %ld hold.", f->cases, f->cases - f->undecided - f->failing);
    }
    paragraph(words, 1);
    if (f->says_nothing)
        paragraph(
            "But it says nothing: it holds however it is changed, or both sides are one formula, or it is supposed.",
            1);
    else if (f->changes > 0)
        paragraph(append(append("", "Changed in one number, sign, index, range or relation it fails in %d of %d ways",
                                f->noticed, f->changes),
                         f->open == 0   ? "."
                         : f->open == 1 ? "; one is not decided."
                                        : "; %d are not decided.",
                         f->open),
                  1);
    if (f->one_sided)
        paragraph("At the end of where a function is defined its derivative is the one-sided one.", 1);
    print_oddities(d, s, f);
    if (f->has_example)
        print_example(d, f);
    if (f->for_every)
        print_every(d, &f->every);
    if (s->expected != EXPECT_NOTHING && (int)s->expected != (int)f->answer)
        printf("\n%*sThe file expects that it %s.\n", INDENT, "",
               s->expected == EXPECT_UNDECIDED ? "is undecided" : expected_name[s->expected]);
}

static json_t *given_json(const cagd_given *g)
{
    char *digits = g->root != NULL ? tex_to_text(value_text(g), 0) : NULL;
    json_t *j = json_pack("{s:s, s:s}", "name", g->name, "value", digits != NULL ? digits : to_string_q(g->value));
    if (g->root != NULL)
        json_object_set_new(j, "root",
                            json_pack("{s:s, s:[s, s]}", "of", polynomial_text(g->root->factor), "between",
                                      to_string_q(g->root->lo), to_string_q(g->root->hi)));
    free(digits);
    return j;
}

static json_t *induction_json(const struct document *d, const cagd_every *e)
{
    json_t *variables = json_array();
    for (int i = 0; i < e->variables; i++)
        json_array_append_new(variables, json_pack("{s:s, s:s, s:s, s:s}", "name", e->variable[i].name, "is",
                                                   meaning_of(d, &e->variable[i], e->n), "times", e->variable[i].times,
                                                   "plus", e->variable[i].plus));
    return json_pack("{s:s, s:s, s:o}", "difference", e->E, "ratio", e->ratio, "variables", variables);
}

/* What proves it for every n. */
static void add_proof(json_t *j, const struct document *d, const cagd_every *e)
{
    if (e->real) {
        json_object_set_new(j, "for_every_real", json_pack("{s:s, s:I}", "n", e->n, "from", (json_int_t)e->from));
    } else if (e->similar) {
        json_t *rewritten = json_array();
        for (int k = 0; k < e->rewritten; k++)
            json_array_append_new(rewritten, json_pack("{s:s, s:s, s:s}", "term", e->rewriting[k].from, "factor",
                                                       e->rewriting[k].factor, "of", e->rewriting[k].to));
        json_object_set_new(j, "similar_terms",
                            json_pack("{s:o, s:b}", "rewritten", rewritten, "by_factorials", e->by_factorials));
    } else if (e->closed) {
        json_t *sums = json_array();
        for (int k = 0; k < e->sums; k++)
            json_array_append_new(sums, json_pack("{s:s, s:s, s:s}", "k", e->sum[k].k, "a", e->sum[k].a,
                                                  e->sum[k].G != NULL ? "G" : "R",
                                                  e->sum[k].G != NULL ? e->sum[k].G : e->sum[k].R));
        json_object_set_new(j, "closed_form",
                            json_pack("{s:s, s:I, s:o}", "n", e->n, "from", (json_int_t)e->from, "sums", sums));
        if (e->E != NULL)
            json_object_set_new(j, "induction", induction_json(d, e));
    } else {
        json_t *a = json_array();
        for (int k = 0; k <= e->order; k++)
            json_array_append_new(a, json_string(e->a[k]));
        json_object_set_new(j, "telescoper",
                            json_pack("{s:s, s:s, s:I, s:o, s:s, s:b}", "n", e->n, "k", e->k, "from",
                                      (json_int_t)e->from, "a", a, "R", e->R, "counted_from_the_first", e->counted));
    }
}

json_t *finding_json(const struct document *d, const struct formula *s, const cagd_finding *f)
{
    json_t *example = json_null();
    if (f->has_example) {
        json_t *values = json_array();
        for (int k = 0; k < f->given; k++)
            json_array_append_new(values, given_json(&f->example[k]));
        example =
            f->is_enclosed ? json_pack("{s:o, s:s, s:f, s:f}", "values", values, "left_is", order_word[f->order + 1],
                                       "left_about", f->near_left, "right_about", f->near_right)
            : f->has_root  ? json_pack("{s:o, s:s}", "values", values, "left_is", order_word[f->order + 1])
            : f->of_left == NULL
                ? json_pack("{s:o}", "values", values)
                : json_pack("{s:o, s:s, s:s, s:s, s:s, s:s}", "values", values, "left_tex", side_of(d, f->of_left),
                            "relation", relation_word[f->relation], "right_tex", side_of(d, f->of_right), "left",
                            to_string_q(f->left), "right", to_string_q(f->right));
    }
    char *scope = tex_to_text(scope_of_finding(d, s, f), 1);
    json_t *j = json_pack("{s:s, s:i, s:s, s:s, s:s, s:s, s:I, s:I, s:I, s:o}", "name", s->name, "line", s->line,
                          "printed_tex", s->printed, "verdict", verdict_of(f), "evidence", evidence_of_finding(f),
                          "scope", f->answer == CAGD_HOLDS ? scope : "", "cases", (json_int_t)f->cases, "failing",
                          (json_int_t)f->failing, "undecided", (json_int_t)f->undecided, "counterexample", example);
    free(scope);
    if (f->answer == CAGD_UNDECIDED)
        json_object_set_new(j, "reason", json_string(reason_of(d, f)));
    if (f->one_sided)
        json_object_set_new(j, "one_sided_derivatives", json_true());
    add_oddities(j, d, s, f);
    if (f->changes > 0 || f->says_nothing) {
        json_object_set_new(j, "changes", json_integer(f->changes));
        json_object_set_new(j, "changes_noticed", json_integer(f->noticed));
        json_object_set_new(j, "changes_undecided", json_integer(f->open));
        json_object_set_new(j, "says_nothing", json_boolean(f->says_nothing));
    }
    if (f->for_every && f->every.next == NULL)
        add_proof(j, d, &f->every);
    json_t *links = f->for_every && f->every.next != NULL ? json_array() : NULL;
    for (const cagd_every *e = links != NULL ? &f->every : NULL; e != NULL; e = e->next) {
        json_t *link = json_pack("{s:s}", "link_tex", link_of(d, e->of));
        add_proof(link, d, e);
        json_array_append_new(links, link);
    }
    if (links != NULL)
        json_object_set_new(j, "links", links);
    if (s->expected != EXPECT_NOTHING)
        json_object_set_new(j, "expected", json_string(expected_name[s->expected]));
    return j;
}

/* ---- for which values it holds ------------------------------------------------------------------------- */

const char *end_text(const struct cagd_root *r) { return is_number(r) ? to_string_q(r->lo) : digits_of(r); }

/* The parts in which it holds: between the cuts first and last of the cells; -1 and `count` are the ends of the domain. */
struct span {
    int first, last, closed_first, closed_last;
};

static int spans_of(const cagd_found *f, struct span out[])
{
    const cagd_cells *c = &f->cells;
    int count = 0, inside = 0;
    struct span now = {0};
    for (int k = 0; k <= c->count; k++) {
        int cell = !c->empty[k] && c->cell[k] == CAGD_HOLDS;
        if (cell && !inside) /* it begins behind the cut k - 1 */
            now = (struct span){.first = k - 1, .closed_first = k == 0 && !f->domain.low_open}, inside = 1;
        if (!cell && inside && !c->empty[k]) /* the cut k - 1 belonged to it */
            now.last = k - 1, now.closed_last = 1, out[count++] = now, inside = 0;
        if (k == c->count)
            break;
        int cut = c->at[k] == CAGD_HOLDS && (!is_number(&c->root[k]) || cagd_is_inside(&f->domain, c->root[k].lo));
        if (cut && !inside)
            now = (struct span){.first = k, .closed_first = 1}, inside = 1;
        if (!cut && inside)
            now.last = k, now.closed_last = 0, out[count++] = now, inside = 0;
    }
    if (inside) {
        now.last = c->empty[c->count] ? c->count - 1 : c->count;
        now.closed_last = c->empty[c->count] || !f->domain.high_open;
        out[count++] = now;
    }
    return count;
}

static const char *span_text(const struct formula *s, const cagd_found *f, const struct span *p)
{
    const cagd_cells *c = &f->cells;
    const char *low = p->first >= 0       ? end_text(&c->root[p->first])
                      : f->domain.has_low ? to_string_q(f->domain.low)
                                          : NULL;
    const char *high = p->last < c->count   ? end_text(&c->root[p->last])
                       : f->domain.has_high ? to_string_q(f->domain.high)
                                            : NULL;
    if (p->first == p->last && p->first >= 0)
        return append("", "$%s = %s$", s->find, low);
    if (low == NULL && high == NULL)
        return append("", "all $%s$", s->find);
    if (low == NULL)
        return append("", "$%s %s %s$", s->find, p->closed_last ? "\\le" : "<", high);
    if (high == NULL)
        return append("", "$%s %s %s$", s->find, p->closed_first ? "\\ge" : ">", low);
    return append("", "$%s %s %s %s %s$", low, p->closed_first ? "\\le" : "<", s->find, p->closed_last ? "\\le" : "<",
                  high);
}

const char *values_of(const struct formula *s, const cagd_found *f)
{
    struct span span[2 * CAGD_MOST_CUTS + 2];
    int count = f->known ? spans_of(f, span) : 0;
    const char *text = "";
    for (int k = 0; k < count; k++)
        text = append(text, "%s%s", k == 0 ? "" : k + 1 < count ? ", " : " and ", span_text(s, f, &span[k]));
    return count > 0 ? text : append("", "no $%s$", s->find);
}

static int changes_at(const cagd_cells *c, int k) { return c->cell[k] != c->cell[k + 1] || c->at[k] != c->cell[k]; }

/* Where an end is a root, of what; and what is not decided. */
static void print_roots(const struct formula *s, const cagd_found *f)
{
    const cagd_cells *c = &f->cells;
    for (int k = 0; k < c->count; k++) {
        const struct cagd_root *r = &c->root[k];
        if (changes_at(c, k) && !is_number(r))
            paragraph(root_text(r), 1);
        if (c->at[k] == CAGD_UNDECIDED)
            paragraph(append("", "For $%s = %s$ itself it is not decided.", s->find, end_text(r)), 1);
    }
}

const char *breaking_text(const struct formula *s, const cagd_found *f, int k)
{
    const char *text = append("", "$%s = %s$", s->find, to_string_q(f->cells.sample[k]));
    for (int m = 0; m < f->wholes; m++)
        text = append(text, ", $%s = %s$", f->breaking[k][m].name, to_string_q(f->breaking[k][m].value));
    if (f->cells.has_witness[k] && f->name_of_witness[k] != NULL)
        text = append(text, ", $%s = %s$", f->name_of_witness[k], to_string_q(f->cells.witness[k]));
    return text;
}

void print_found_page(const struct document *d, const struct formula *s, const cagd_found *f)
{
    const cagd_cells *c = &f->cells;
    print_head(d, s);
    if (!f->known) {
        paragraph(append("", "It is undecided for which $%s$ it holds: %s.", s->find, f->why), 1);
        return;
    }
    struct span span[2 * CAGD_MOST_CUTS + 2];
    int spans = spans_of(f, span), whole = spans == 0 || (spans == 1 && span[0].first < 0 && span[0].last == c->count);
    paragraph(append("It holds for ", "%s%s (decided, %ld case%s)%s.", values_of(s, f),
                     whole ? "" : ", and for no other", f->cases, f->cases == 1 ? "" : "s",
                     f->leaves_out_poles ? ", wherever both sides are defined" : ""),
              1);
    print_roots(s, f);
    int first = 1;
    for (int k = 0; k <= c->count; k++) {
        int told = k > 0 && !c->empty[k - 1] && c->cell[k - 1] == CAGD_FAILS && c->at[k - 1] == CAGD_FAILS;
        if (c->empty[k] || c->cell[k] != CAGD_FAILS || told)
            continue;
        if (first)
            heading("It fails");
        first = 0;
        paragraph(append("for ", "%s", breaking_text(s, f, k)), 1);
    }
}

json_t *found_json(const struct formula *s, const cagd_found *f)
{
    json_t *fails = json_array();
    for (int k = 0; f->known && k <= f->cells.count; k++) {
        if (f->cells.empty[k] || f->cells.cell[k] != CAGD_FAILS)
            continue;
        json_t *one = json_pack("{s:s}", s->find, to_string_q(f->cells.sample[k]));
        for (int m = 0; m < f->wholes; m++)
            json_object_set_new(one, f->breaking[k][m].name, json_string(to_string_q(f->breaking[k][m].value)));
        if (f->cells.has_witness[k] && f->name_of_witness[k] != NULL)
            json_object_set_new(one, f->name_of_witness[k], json_string(to_string_q(f->cells.witness[k])));
        json_array_append_new(fails, one);
    }
    json_t *roots = json_array();
    for (int k = 0; f->known && k < f->cells.count; k++) {
        const struct cagd_root *r = &f->cells.root[k];
        if (is_number(r) || !changes_at(&f->cells, k))
            continue;
        char *digits = tex_to_text(digits_of(r), 0);
        json_array_append_new(roots,
                              json_pack("{s:s, s:s, s:[s,s]}", "value", digits, "polynomial_tex",
                                        polynomial_text(r->factor), "between", to_string_q(r->lo), to_string_q(r->hi)));
        free(digits);
    }
    char *values = tex_to_text(f->known ? values_of(s, f) : "", 1);
    json_t *j = json_pack("{s:s, s:i, s:s, s:s, s:s, s:s, s:o, s:I, s:o}", "name", s->name, "line", s->line,
                          "printed_tex", s->printed, "verdict", f->known ? "found" : "undecided", "find", s->find,
                          "values", values, "roots", roots, "cases", (json_int_t)f->cases, "fails_for", fails);
    free(values);
    if (!f->known)
        json_object_set_new(j, "reason", json_string(f->why));
    return j;
}
