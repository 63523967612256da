/* formula.c -- formulas are read, and computed beside a run: along its way, at its point; see formula.h. */
#include "exact/code/formula.h"

#include "exact/code/value.h"
#include "exact/expression/depends.h"
#include "exact/expression/evaluate.h"
#include "exact/expression/read.h"
#include "exact/expression/standard.h"
#include "exact/expression/token.h"
#include "exact/record/trace.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- reading --------------------------------------------------------------------------------------------- */

static int refuse(struct cagd_code_formulas *f, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(f->message, sizeof f->message, format, list);
    va_end(list);
    return -1;
}

/* The place as the text that stands there. */
static int refuse_reading(struct cagd_code_formulas *f, const char *text, const cagd_reading_error *e)
{
    int length = e->to > e->from ? e->to - e->from : (int)strlen(text + e->from);
    if (length == 0)
        return refuse(f, "\"%s\": %s", text, e->message);
    return refuse(f, "\"%s\", at \"%.*s\": %s", text, length < 40 ? length : 40, text + e->from, e->message);
}

/* Where it begins and ends without dollar signs around it. */
struct part {
    int from, to;
};

static struct part part_of(const char *text)
{
    struct part p = {0, (int)strlen(text)};
    if (p.to >= 2 && text[0] == '$' && text[p.to - 1] == '$')
        p.from++, p.to--;
    return p;
}

const char *cagd_code_formula_head(const char *name, long count)
{
    enum { MOST = 80 };
    char head[MOST];
    size_t letters = strlen(name);
    for (size_t k = 0; k < letters; k++)
        if (!isalpha((unsigned char)name[k]))
            return NULL;
    int length = snprintf(head, sizeof head, letters == 1 ? "%s" : "\\%s", name);
    if (letters > 1 && !cagd_is_greek(head))
        length = snprintf(head, sizeof head, "\\mathrm{%s}", name);
    if (letters == 0 || length >= MOST - 1)
        return NULL;
    strcpy(head + length, count > 0 ? "_" : "");
    return cagd_text_of(head, length + (count > 0));
}

void cagd_code_formula_name(struct cagd_code_formulas *f, const char *name, long count)
{
    const char *head = cagd_code_formula_head(name, count);
    if (head != NULL && cagd_declared(&f->scope, head) == NULL)
        cagd_declare(&f->scope, (cagd_variable){.head = head, .lower = count > 0});
}

static int define(struct cagd_code_formulas *f, const char *text)
{
    cagd_reading_error error;
    int conditions = f->scope.condition_count;
    struct part p = part_of(text);
    if (!cagd_read_definition(&f->scope, text, p.from, p.to, &error))
        return refuse_reading(f, text, &error);
    if (f->scope.condition_count > conditions)
        return refuse(f, "\"%s\" is a condition; the line says what a name means, and conditions stand in :where:", text);
    return 0;
}

int cagd_code_formula_let(struct cagd_code_formulas *f, const char *line)
{
    static const char use[] = ":use:";
    if (strncmp(line, use, sizeof use - 1) != 0)
        return define(f, line);
    line += sizeof use - 1;
    line += strspn(line, " \t");
    char message[CAGD_STANDARD_MESSAGE];
    const char *lines = cagd_standard(&f->scope, line, (int)strlen(line), message);
    if (lines == NULL)
        return refuse(f, "\"%s\": %s", line, message);
    for (size_t length; *lines != 0; lines += length + (lines[length] == '\n')) {
        length = strcspn(lines, "\n");
        if (define(f, cagd_text_of(lines, (int)length)) != 0)
            return -1;
    }
    return 0;
}

static int has_same_sides(const cagd_tree *t)
{
    int same = 0;
    for (int k = 0; t->kind == CAGD_RELATION && k + 1 < t->count; k++)
        same |= cagd_tree_equal(t->at[k], t->at[k + 1]);
    for (int k = 0; t->kind == CAGD_ALL && k < t->count; k++)
        same |= has_same_sides(t->at[k]);
    return same;
}

static int is_equation(const cagd_tree *t)
{
    for (int k = 0; t->kind == CAGD_RELATION && k + 1 < t->count; k++)
        if (t->relation[k] != CAGD_EQUAL)
            return 0;
    for (int k = 0; t->kind == CAGD_ALL && k < t->count; k++)
        if (!is_equation(t->at[k]))
            return 0;
    return t->kind == CAGD_RELATION || t->kind == CAGD_ALL;
}

const cagd_tree *cagd_code_formula_read(struct cagd_code_formulas *f, const char *formula, const char *ranges)
{
    cagd_reading_error error;
    const cagd_variable *before = f->scope.variables;
    int conditions = f->scope.condition_count;
    struct part range = part_of(ranges), equation = part_of(formula);
    if (*ranges != 0 && !cagd_read_ranges(&f->scope, ranges, range.from, range.to, &error)) {
        refuse_reading(f, ranges, &error);
        return NULL;
    }
    for (const cagd_variable *v = f->scope.variables; v != before; v = v->next)
        if (!v->whole || v->high == NULL || v->step > 1 || v->listed != NULL) {
            refuse(f, "\"%s\": a range such as j = 0..2 was expected; those of other numbers stand in :input:", ranges);
            return NULL;
        }
    if (f->scope.condition_count > conditions) {
        refuse(f, "\"%s\": a range such as j = 0..2 was expected; conditions stand in :where:", ranges);
        return NULL;
    }
    const cagd_tree *t = cagd_read_statement(&f->scope, formula, equation.from, equation.to, &error);
    int bad = t == NULL          ? refuse_reading(f, formula, &error)
              : !is_equation(t)  ? refuse(f, "\"%s\": an equation was expected", formula)
              : has_same_sides(t) ? refuse(f, "\"%s\": both sides are the same", formula)
                                 : 0;
    return bad == 0 ? t : NULL;
}

int cagd_code_formula_has(const struct cagd_code_formulas *f, const cagd_tree *t, const char *name, long count)
{
    const char *head = cagd_code_formula_head(name, count);
    return head != NULL && cagd_depends_on(&f->scope, t, head);
}

/* ---- what names are ---------------------------------------------------------------------------------------- */

enum { MOST_NAMES = 128, MOST_DIVISORS = 512 };

static struct {
    struct cagd_code_formulas formulas;
    struct {
        const char *head;
        long count;
        const double *x;
    } name[MOST_NAMES];
    int names;
} here;

static int in_field(void) { return cagd_code_machine.job->numbers == CAGD_CODE_FIELD; }

void cagd_code_formulas(void)
{
    memset(&here, 0, sizeof here);
    if (!in_field())
        cagd_field_open(CAGD_FIELD_MAX_VARIABLES);
}

/* The numbers that it has now: the code may change its arguments. */
void cagd_code_name(const char *name, long count, const double *x)
{
    const char *head = cagd_code_formula_head(name, count);
    long numbers = count > 0 ? count : 1;
    if (head == NULL)
        return;
    if (here.names == MOST_NAMES)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %d names for formulas", MOST_NAMES);
    double *kept = cagd_region_array((int)numbers, 1, sizeof *kept);
    cagd_code_check_faults();
    memcpy(kept, x, (size_t)numbers * sizeof *kept);
    cagd_code_formula_name(&here.formulas, name, count);
    here.name[here.names].head = head;
    here.name[here.names].count = count;
    here.name[here.names++].x = kept;
}

/* A number that is an interval at the point: a variable of the field, the same one for the same number. */
static cagd_num_f irrational(cagd_num_i place)
{
    char name[16];
    cagd_num_i other;
    for (int k = 0; k < cagd_code_enclosed_count(); k++) {
        cagd_num_f x = cagd_code_enclosed_at(k, &other);
        if (other.at == place.at)
            return x;
    }
    snprintf(name, sizeof name, "x%d", cagd_code_enclosed_count());
    cagd_num_f x = cagd_variable_f(name);
    cagd_code_enclose_variable(x, place);
    return x;
}

/* "p_3" or "p_{12}": the index behind the head, -1 where it is another name. */
static long index_in(const char *key, const char *head)
{
    size_t n = strlen(head);
    char *end;
    if (strncmp(key, head, n) != 0)
        return -1;
    key += n;
    int braces = *key == '{';
    long index = strtol(key + braces, &end, 10);
    return end != key + braces && strcmp(end, braces ? "}" : "") == 0 ? index : -1;
}

static int value_of_name(const char *key, cagd_value *value)
{
    for (int k = 0; k < here.names; k++) {
        long count = here.name[k].count,
             index = count > 0 ? index_in(key, here.name[k].head) : -(strcmp(key, here.name[k].head) != 0);
        if (index < 0 || index >= (count > 0 ? count : 1))
            continue;
        if (!cagd_code_was_computed(here.name[k].x[index]))
            cagd_code_stop(CAGD_CODE_REFUSED, "%s was never computed", key);
        cagd_code_value v = cagd_code_value_of(here.name[k].x[index]);
        if (v.special)
            cagd_code_stop(CAGD_CODE_REFUSED, "%s is an infinity or no number", key);
        *value = v.f.at != NULL   ? cagd_value_f(v.f)
                 : v.q.at != NULL ? cagd_value_q(v.q)
                                  : cagd_value_f(irrational(v.i));
        return 1;
    }
    return 0;
}

/* ---- values at the point ------------------------------------------------------------------------------------ */

/* Of a polynomial in inputs. */
static cagd_num_q known_at_point(cagd_num_f f)
{
    cagd_num_q q = cagd_code_at_point(f);
    if (q.at == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "a division by what depends on the variable of an integral");
    return q;
}

/* A polynomial at the point, by Horner's scheme in one variable after the other: in those from the k-th on that are known by intervals. */
static cagd_num_i enclosed(cagd_num_f f, int k)
{
    if (k == cagd_code_enclosed_count())
        return cagd_from_rational_i(known_at_point(f));
    cagd_num_i place, sum = cagd_from_int_i(0);
    cagd_num_f x = cagd_code_enclosed_at(k, &place);
    for (int power = cagd_degree_f(f, x); power >= 0; power--)
        sum = cagd_add_i(cagd_mul_i(sum, place), enclosed(cagd_coefficient_f(f, x, power), k + 1));
    return sum;
}

/* The value as one of the run: a function, and what it is at the point. */
static cagd_code_value at_the_point(cagd_value a)
{
    if (a.rational)
        return cagd_code_constant(a.q);
    cagd_trace_pause();
    cagd_code_value v = {.q = cagd_code_at_point(a.f)};
    if (v.q.at == NULL)
        v.i = cagd_div_i(enclosed(cagd_numerator_f(a.f), 0), enclosed(cagd_denominator_f(a.f), 0));
    cagd_trace_resume();
    cagd_code_check_faults();
    if (in_field())
        v.f = a.f;
    return v;
}

static int holds(cagd_num_f d, cagd_relation relation)
{
    static const int predicate[] = {[CAGD_EQUAL] = 1,   [CAGD_NOT_EQUAL] = 6,     [CAGD_LESS] = 4, [CAGD_LESS_OR_EQUAL] = 5,
                                    [CAGD_GREATER] = 2, [CAGD_GREATER_OR_EQUAL] = 3};
    return (cagd_code_relation(at_the_point(cagd_value_f(d)), cagd_code_integer(0), predicate[relation]) &
            predicate[relation]) != 0;
}

static int equal(cagd_num_f a, cagd_num_f b)
{
    cagd_trace_pause();
    int answer = cagd_code_equal_here(a, b);
    cagd_trace_resume();
    return answer;
}

static const cagd_way way = {.name = value_of_name, .holds = holds, .equal = equal};

/* ---- what holds ---------------------------------------------------------------------------------------------- */

void cagd_code_let(const char *line)
{
    if (cagd_code_formula_let(&here.formulas, line) != 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "%s", here.formulas.message);
}

/* Ends the run where there was no value. */
static void check_evaluation(const cagd_context *c)
{
    unsigned faults = cagd_region_faults;
    const char *why = c->trouble != NULL                 ? c->trouble
                      : faults & CAGD_FAULT_UNDEFINED ? "a division by 0"
                                                      : "functions that are too large";
    int length = (int)strcspn(why, ":"); /* behind it there is what to write in the blocks of cagd check */
    if (faults & (CAGD_FAULT_MEMORY | CAGD_FAULT_CROWDED))
        cagd_code_check_faults();
    cagd_region_faults = 0;
    if (faults & CAGD_FAULT_UNDEFINED)
        cagd_code_stop(CAGD_CODE_UNDEFINED, "%.*s", length, why);
    if (faults != 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "%.*s", length, why);
}

static double side(cagd_context *c, const cagd_tree *t)
{
    cagd_num_f divisor[MOST_DIVISORS];
    c->divisor = divisor, c->divisors = 0, c->most_divisors = MOST_DIVISORS, c->steps = CAGD_USUAL_STEPS;
    cagd_value value = cagd_evaluate(c, t);
    check_evaluation(c);
    for (int k = 0; k < c->divisors; k++) {
        cagd_num_q place = at_the_point(cagd_value_f(divisor[k])).q; /* an irrational one is divided by as an interval */
        if (place.at != NULL && cagd_is_zero_q(place))
            cagd_code_stop(CAGD_CODE_UNDEFINED, "a division by 0");
        cagd_code_note_divisor(divisor[k]);
    }
    return cagd_code_number(at_the_point(value));
}

/* "R_j, j = 1": the left side as it is printed, and the case. */
static void name_of_case(const cagd_context *c, const cagd_variable *const whole[], int wholes, const cagd_tree *left,
                         const char *formula, size_t room, char name[])
{
    int at = snprintf(name, room, "%.*s", left->to - left->from, formula + left->from);
    for (int k = 0; k < wholes && at < (int)room; k++)
        at += snprintf(name + at, room - (size_t)at, ", %s = %s", whole[k]->head,
                       cagd_to_string_q(cagd_binding_of((cagd_context *)c, whole[k]->head)->value.q));
}

/* How many comparisons there were. */
static long compare(cagd_context *c, const cagd_variable *const whole[], int wholes, const cagd_tree *t, const char *formula)
{
    char name[150];
    long count = t->kind == CAGD_RELATION ? t->count - 1 : 0;
    for (int k = 0; t->kind == CAGD_ALL && k < t->count; k++)
        count += compare(c, whole, wholes, t->at[k], formula);
    for (int k = 0; t->kind == CAGD_RELATION && k + 1 < t->count; k++) {
        name_of_case(c, whole, wholes, t->at[k], formula, sizeof name, name);
        double left = side(c, t->at[k]), right = side(c, t->at[k + 1]);
        cagd_code_expect_one(name, 1, 0, left, right);
    }
    return count;
}

/* The cases of the whole numbers from the k-th on. */
static long each_case(cagd_context *c, const cagd_variable *const whole[], int wholes, int k, const cagd_tree *t,
                      const char *formula)
{
    long low, high, count = 0;
    if (k == wholes)
        return compare(c, whole, wholes, t, formula);
    cagd_value first = cagd_evaluate(c, whole[k]->low), last = cagd_evaluate(c, whole[k]->high);
    check_evaluation(c);
    if (!cagd_value_is_whole(first, &low) || !cagd_value_is_whole(last, &high))
        cagd_code_stop(CAGD_CODE_REFUSED, "a range whose ends are no whole numbers");
    for (; low <= high; low++) {
        cagd_bind(c, whole[k]->head, cagd_value_constant(cagd_from_int_q(low)));
        count += each_case(c, whole, wholes, k + 1, t, formula);
    }
    return count;
}

void cagd_code_printed(const char *formula, const char *ranges, const char *file, int line)
{
    enum { MOST_WHOLE = 8 };
    struct cagd_code_formulas f = here.formulas;
    const cagd_variable *whole[MOST_WHOLE];
    const struct cagd_code_place place = {file, "the formula", line}, *before = cagd_code_at;
    if (cagd_code_machine.job->numbers == CAGD_CODE_ROUNDING) /* what is told of a run with rounding is told of outputs */
        return;
    cagd_code_at = &place;
    if (cagd_code_machine.job->numbers == CAGD_CODE_INTERVAL)
        cagd_code_stop(CAGD_CODE_REFUSED, "a formula in intervals");
    const cagd_tree *t = cagd_code_formula_read(&f, formula, ranges);
    if (t == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "%s", f.message);
    int wholes = cagd_whole_numbers(&f.scope, t, whole, MOST_WHOLE);
    if (wholes < 0)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %d ranges for a formula", MOST_WHOLE);
    cagd_context *c = cagd_region_array(1, 1, sizeof *c);
    cagd_code_check_faults();
    *c = (cagd_context){.scope = &f.scope, .way = &way, .steps = CAGD_USUAL_STEPS};
    if (each_case(c, whole, wholes, 0, t, formula) == 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "a range is empty, so that nothing is compared");
    cagd_code_at = before;
}
