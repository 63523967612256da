/* formula.c -- requirements whose results are printed formulas; see lab.h.
 *
 *     :printed: left_k = \sum_{i=0}^k \binom{k}{i} t^i (1-t)^{k-i} p_i
 *     :index: k = 0..$n
 *
 * With :let: and :use: as in `cagd exactly`.  The formula of each result becomes a rational function of the inputs, and that becomes C, which
 * stands in for the call of the reference: so the reference, and every right solution, is judged by the formula. */
#include "cli/lab/lab.h"

#include "exact/code/formula.h"
#include "exact/expression/depends.h"
#include "exact/expression/evaluate.h"
#include "exact/expression/read.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_DIGITS = 15, MOST_POWER = 100 };

/* ---- rational functions in C ----------------------------------------------------------------------------- */

/* "3*t^2" is 3.0*(1*t*t). */
const char *lab_put_function(const char *text, FILE *out)
{
    while (*text != 0) {
        size_t digits = strspn(text, "0123456789"), name = 0;
        while (digits == 0 && (isalnum((unsigned char)text[name]) || text[name] == '_'))
            name++;
        if (digits > MOST_DIGITS)
            return "the formula has coefficients of more than 15 digits";
        if (digits > 0) {
            fprintf(out, "%.*s.0", (int)digits, text);
            text += digits;
        } else if (name > 0) {
            const char *base = text;
            long power = 1;
            text += name;
            if (*text == '^') {
                char *end;
                power = strtol(text + 1, &end, 10);
                text = end;
            }
            if (power < 1 || power > MOST_POWER)
                return "a power of at most 100 was expected";
            fputs("(1", out);
            for (long k = 0; k < power; k++)
                fprintf(out, "*%.*s", (int)name, base);
            fputs(")", out);
        } else if (strchr("+-*/() ", *text) != NULL) {
            fputc(*text++, out);
        } else {
            return "a rational function was expected";
        }
    }
    return NULL;
}

/* ---- the formulas of a case ------------------------------------------------------------------------------ */

struct formulas {
    const struct lab_case *c;
    struct cagd_code_formulas read;
    int outputs;
    struct output {
        char name[CAGD_CODE_MOST_NAME + 1];
        int count; /* 0: a number alone */
        char *has; /* which of its numbers have a formula */
    } output[CAGD_CODE_MOST_IN_HARNESS];
    FILE *out;
    char *cause;
};

static int refuse(const struct formulas *f, const char *what)
{
    if (f->cause[0] == 0)
        snprintf(f->cause, LAB_CAUSE, "%s: %s", json_string_value(json_object_get(f->c->requirement, "name")), what);
    return -1;
}

/* The binding's name in C: "p_{10}" is p[10].  0 where it is no input. */
static int put_name(const struct formulas *f, const char *key, FILE *out)
{
    for (int k = 0; k < f->c->h->inputs; k++) {
        const struct cagd_code_asked_input *in = &f->c->h->input[k];
        const char *head = cagd_code_formula_head(in->name, in->count);
        size_t length = head != NULL ? strlen(head) : 0;
        if (head == NULL || strncmp(key, head, length) != 0 || (in->count == 0 && key[length] != 0))
            continue;
        fputs(in->name, out);
        const char *index = key + length + (key[length] == '{');
        if (in->count > 0 && (!isdigit((unsigned char)*index) || strtol(index, NULL, 10) >= in->count))
            return 0;
        if (in->count > 0)
            fprintf(out, "[%ld]", strtol(index, NULL, 10));
        return 1;
    }
    return 0;
}

/* NAME[j] = the value, in a block of its own. */
static int put_value(const struct formulas *f, const struct output *o, long j, cagd_context *c, cagd_value value)
{
    fputs("{ ", f->out);
    for (int k = 0; k < c->count; k++) {
        if (!c->binding[k].unknown)
            continue;
        fprintf(f->out, "const double %s = ", cagd_to_string_f(c->binding[k].value.f));
        if (!put_name(f, c->binding[k].key, f->out))
            return refuse(f, "a formula has a name that is no input, or an index that it has not");
        fputs("; ", f->out);
    }
    if (o->count > 0)
        fprintf(f->out, "%s[%ld] = ", o->name, j);
    else
        fprintf(f->out, "%s = ", o->name);
    const char *why = lab_put_function(cagd_to_string_f(cagd_in_field(value)), f->out);
    fputs("; } ", f->out);
    return why != NULL ? refuse(f, why) : 0;
}

static struct output *output_of(struct formulas *f, const cagd_tree *left)
{
    for (int k = 0; k < f->outputs && left->kind == CAGD_NAME; k++) {
        const char *head = cagd_code_formula_head(f->output[k].name, f->output[k].count);
        if (head != NULL && strcmp(head, left->head) == 0)
            return &f->output[k];
    }
    return NULL;
}

/* The equation for one value of the index, whose letter may be NULL. */
static int put_equation(struct formulas *f, const cagd_tree *t, const char *letter, long index)
{
    struct output *o = t->count == 2 ? output_of(f, t->at[0]) : NULL;
    long j = 0;
    if (o == NULL)
        return refuse(f, "on the left of an equation stands a result of :output:");
    cagd_region_mark mark = cagd_region_open();
    cagd_context *c = cagd_region_bytes(sizeof *c);
    if (c == NULL)
        abort();
    cagd_field_open(CAGD_FIELD_MAX_VARIABLES);
    *c = (cagd_context){.scope = &f->read.scope, .in_field = 1, .steps = CAGD_USUAL_STEPS};
    if (letter != NULL)
        cagd_bind(c, letter, cagd_value_int(index));
    int status = -1;
    if (o->count > 0 && (!cagd_value_is_whole(cagd_evaluate(c, t->at[0]->at[0]), &j) || j < 0 || j >= o->count)) {
        refuse(f, "an index of a result that it has not");
    } else if (o->has[j]) {
        refuse(f, "two equations for one result");
    } else {
        cagd_value value = cagd_evaluate(c, t->at[1]);
        o->has[j] = 1;
        status = cagd_region_faults != 0 ? refuse(f, c->trouble != NULL ? c->trouble : "a formula has no value")
                                         : put_value(f, o, j, c, value);
    }
    cagd_region_faults = 0;
    cagd_region_drop(mark);
    return status;
}

/* For every value of its index. */
static int put_equations(struct formulas *f, const cagd_tree *t)
{
    const cagd_variable *index = NULL;
    for (const cagd_variable *v = f->read.scope.variables; v != NULL; v = v->next)
        if (v->whole && cagd_depends_on(&f->read.scope, t, v->head)) {
            if (index != NULL)
                return refuse(f, "an equation has one index at most");
            index = v;
        }
    if (index == NULL)
        return put_equation(f, t, NULL, 0);
    cagd_context *c = cagd_region_bytes(sizeof *c);
    long low, high;
    if (c == NULL)
        abort();
    *c = (cagd_context){.scope = &f->read.scope, .steps = CAGD_USUAL_STEPS};
    if (index->low == NULL || index->high == NULL || !cagd_value_is_whole(cagd_evaluate(c, index->low), &low) ||
        !cagd_value_is_whole(cagd_evaluate(c, index->high), &high) || cagd_region_faults != 0) {
        cagd_region_faults = 0;
        return refuse(f, "an index runs between whole numbers");
    }
    for (long k = low; k <= high; k++)
        if (put_equation(f, t, index->head, k) != 0)
            return -1;
    return 0;
}

/* Visits every text of a key, with its numbers put in. */
static int each(struct formulas *f, const char *key, const struct lab_letters *l,
                int (*visit)(struct formulas *f, const char *text))
{
    size_t k;
    const json_t *value;
    int status = 0;
    json_array_foreach(json_object_get(f->c->requirement, key), k, value)
    {
        char *text = lab_put_numbers(json_string_value(value), l);
        if (text == NULL)
            status = refuse(f, "a number behind $ was expected");
        else if (status == 0)
            status = visit(f, text);
        free(text);
    }
    return status;
}

static int visit_let(struct formulas *f, const char *text)
{
    return cagd_code_formula_let(&f->read, text) != 0 ? refuse(f, f->read.message) : 0;
}

static int visit_use(struct formulas *f, const char *text)
{
    char line[LAB_CAUSE];
    snprintf(line, sizeof line, ":use: %s", text);
    return visit_let(f, line);
}

static int visit_index(struct formulas *f, const char *text)
{
    cagd_reading_error error;
    return cagd_read_ranges(&f->read.scope, text, 0, (int)strlen(text), &error) ? 0 : refuse(f, error.message);
}

static int visit_printed(struct formulas *f, const char *text)
{
    const cagd_tree *t = cagd_code_formula_read(&f->read, text, "");
    if (t == NULL)
        return refuse(f, f->read.message);
    for (int k = 0; t->kind == CAGD_ALL && k < t->count; k++)
        if (put_equations(f, t->at[k]) != 0)
            return -1;
    return t->kind == CAGD_ALL ? 0 : put_equations(f, t);
}

/* The results are declared, and afterwards have all their formulas. */
static void declare(struct formulas *f)
{
    const struct cagd_code_harness *h = f->c->h;
    for (int k = 0; k < h->inputs; k++)
        cagd_code_formula_name(&f->read, h->input[k].name, h->input[k].count);
    for (int k = 0; k < h->output.count; k++) {
        struct output *o = &f->output[f->outputs];
        if (!cagd_code_output_name(h->output.text[k], o->name, &o->count))
            continue;
        o->has = calloc(o->count > 0 ? (size_t)o->count : 1, 1);
        if (o->has == NULL)
            abort();
        cagd_code_formula_name(&f->read, o->name, o->count);
        fprintf(f->out, o->count > 0 ? "double %s[%d]; " : "double %s; ", o->name, o->count);
        f->outputs++;
    }
}

static int is_whole(const struct formulas *f)
{
    for (int k = 0; k < f->outputs; k++)
        for (int j = 0; j < (f->output[k].count > 0 ? f->output[k].count : 1); j++)
            if (!f->output[k].has[j])
                return 0;
    return f->outputs == f->c->h->output.count;
}

int lab_read_formula(struct lab_case *c, const struct lab_letters *l, char cause[LAB_CAUSE])
{
    size_t size;
    if (json_object_get(c->requirement, "printed") == NULL)
        return 0;
    struct formulas *f = calloc(1, sizeof *f);
    if (f == NULL || (f->out = open_memstream(&c->formula, &size)) == NULL)
        abort();
    f->c = c, f->cause = cause;
    cause[0] = 0;
    cagd_region_mark mark = cagd_region_open();
    cagd_region_faults = 0;
    declare(f);
    int status = each(f, "let", l, visit_let) != 0 || each(f, "use", l, visit_use) != 0 ||
                         each(f, "index", l, visit_index) != 0 || each(f, "printed", l, visit_printed) != 0
                     ? -1
                     : 0;
    if (status == 0 && !is_whole(f))
        status = refuse(f, "every result of :output: needs its formula");
    cagd_region_faults = 0;
    cagd_region_drop(mark);
    for (int k = 0; k < f->outputs; k++)
        free(f->output[k].has);
    fclose(f->out);
    free(f);
    return status;
}

void lab_write_formulas(const struct lab *lab, FILE *out)
{
    for (int k = 0; k < lab->cases; k++) {
        const struct lab_case *c = &lab->at[k];
        struct cagd_code_harness h = *c->h; /* in the place of the calls */
        char name[40];
        if (c->formula == NULL)
            continue;
        h.call.count = 1;
        h.call.text[0] = c->formula;
        snprintf(name, sizeof name, "lab_formula_%d", k);
        fprintf(out, "\nvoid %s(void);\n", name);
        lab_write_case(c, &h, name, out);
    }
}
