#include "exact/expression/basis.h"

#include "core/clock.h"
#include "exact/decide/resultant.h"
#include "exact/expression/angle.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

enum { FIELD_ROOM = 32, MOST_DEGREE = 64, MOST_STEPS = 60 };

/* ---- reading ------------------------------------------------------------------------------------------- */

static cagd_side_of_box side_of(const cagd_binding *b)
{
    return (cagd_side_of_box){b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
}

/* x = (t - a)/(b - t) maps (a,b) to the positive numbers: t = (a + b x)/(1 + x). */
static num_f over_positive_numbers(num_f f, const cagd_side_of_box *t)
{
    num_f x = t->variable, a = from_rational_f(t->low), b = from_rational_f(t->high);
    return substitute_f(f, x, div_f(add_f(a, mul_f(b, x)), add_f(from_int_f(1), x)));
}

static num_f power(num_f a, int e)
{
    num_f r = from_int_f(1);
    while (e-- > 0)
        r = mul_f(r, a);
    return r;
}

static num_f choose(int n, int k)
{
    num_f r = from_int_f(1);
    for (int i = 0; i < k; i++)
        r = div_f(mul_f(r, from_int_f(n - i)), from_int_f(i + 1));
    return r;
}

/* b_i(t) (1 + x)^d = sum_j C(d,j) c_j x^j. */
static void bernstein_coefficients(cagd_basis *b)
{
    num_f t = b->t.variable;
    b->degree = b->angle ? -1 : 0;
    if (b->angle)
        return;
    for (int i = 0; i < b->count; i++) {
        int degree = degree_f(b->function[i], t);
        if (cagd_denominator_degree_f(b->function[i], t) > 0 || degree > MOST_DEGREE) {
            b->degree = -1;
            return;
        }
        b->degree = degree > b->degree ? degree : b->degree;
    }
    int columns = b->degree + 1;
    num_f *c = cagd_region_array(b->count, columns, sizeof *c);
    for (int i = 0; i < b->count && c != NULL; i++) {
        num_f p = mul_f(over_positive_numbers(b->function[i], &b->t), power(add_f(from_int_f(1), t), b->degree));
        for (int j = 0; j < columns; j++)
            c[i * columns + j] = div_f(coefficient_f(p, t, j), choose(b->degree, j));
    }
    b->coefficient = c;
}

static void values_at_ends(const cagd_context *c, cagd_basis *b)
{
    num_f t = b->t.variable, end[2] = {from_rational_f(b->t.low), from_rational_f(b->t.high)};
    for (int i = 0; i < b->count; i++) {
        num_f f = b->function[i];
        for (int order = 0; order < CAGD_END_ORDERS;
             order++, f = b->angle ? cagd_by_angle_f(c, f, t) : derivative_f(f, t))
            for (int k = 0; k < 2; k++)
                b->at_end[k][order][i] = substitute_f(f, t, end[k]);
    }
}

static const char *reason_of(const cagd_context *c)
{
    if (c->split != NULL || c->has_cut)
        return "a definition changes within the interval, or at an end that belongs to it";
    return c->trouble != NULL ? c->trouble : "a value that is not computed";
}

/* "0", "2", "\\frac{3\\pi}{4}": the number, or so many times pi. */
static const char *in_tex(num_q x, int times_pi)
{
    char text[80];
    const char *number = cagd_to_string_q(x), *bar = strchr(number, '/');
    int whole = bar != NULL ? (int)(bar - number) : (int)strlen(number),
        unit = (whole == 1 && number[0] == '1') || strncmp(number, "-1", (size_t)whole) == 0;
    if (!times_pi || cagd_is_zero_q(x))
        return number;
    int n = bar != NULL ? snprintf(text, sizeof text, "\\frac{%.*s\\pi}{%s}", unit ? whole - 1 : whole, number, bar + 1)
                        : snprintf(text, sizeof text, "%.*s\\pi", unit ? whole - 1 : whole, number);
    return cagd_text_of(text, n < (int)sizeof text ? n : (int)sizeof text - 1);
}

/* The ends as they are printed. */
static int name_ends(const cagd_scope *scope, const char *argument, cagd_basis *b)
{
    num_q end[2] = {b->t.low, b->t.high};
    const cagd_variable *v = cagd_declared(scope, argument);
    if (b->angle && (v == NULL || v->low == NULL || v->high == NULL || !cagd_multiple_of_pi(scope, v->low, &end[0]) ||
                     !cagd_multiple_of_pi(scope, v->high, &end[1])))
        return 0;
    for (int k = 0; k < 2; k++)
        b->end[k] = in_tex(end[k], b->angle);
    b->sum = in_tex(add_q(end[0], end[1]), b->angle);
    return 1;
}

int cagd_basis_argument(const cagd_tree *function, const char *parameter)
{
    for (int k = function->lower + function->upper; k < function->count; k++)
        if (parameter == NULL || function->at[k]->kind != CAGD_NAME || strcmp(function->at[k]->head, parameter) != 0)
            return k;
    return function->lower + function->upper;
}

/* The variable of the argument is the tangent of a half, or of a quarter where that reaches an end. */
static int is_angle(cagd_context *c, const cagd_tree *function, int k)
{
    const cagd_definition *d = cagd_defined(c->scope, function->head);
    num_q end[2];
    if (d == NULL || !cagd_is_angle_argument(c, d, k))
        return 0;
    const cagd_variable *v = cagd_declared(c->scope, function->at[k]->head);
    c->whole_angles = !cagd_has_half_angles(c->scope, function);
    for (int m = 0; v != NULL && m < 2; m++) {
        const cagd_tree *t = m == 0 ? v->low : v->high;
        if (t != NULL && cagd_multiple_of_pi(c->scope, t, &end[m]))
            c->whole_angles &= cagd_compare_q(end[m], from_int_q(1)) < 0 && cagd_compare_q(end[m], from_int_q(-1)) > 0;
    }
    return c->whole_angles ? 2 : 4;
}

static const char *read_basis(const cagd_scope *scope, const cagd_tree *function, const char *index, long first,
                              long last, const char *parameter, cagd_basis *out)
{
    cagd_context *c = region_bytes(sizeof *c);
    if (c == NULL)
        return "there is no memory for it";
    *c = (cagd_context){.scope = scope, .in_field = 1, .steps = CAGD_USUAL_STEPS};
    *out = (cagd_basis){.count = (int)(last - first + 1), .has_parameter = parameter != NULL};
    field_open(FIELD_ROOM);
    const int place = cagd_basis_argument(function, parameter);
    const char *argument = function->at[place]->head;
    char tangent[120], of_pi[120];
    out->angle = is_angle(c, function, place);
    for (int k = out->angle != 0; k < 2; k++) {
        cagd_tree name = {.kind = CAGD_NAME, .head = k == 0 ? argument : parameter};
        if (name.head != NULL)
            cagd_evaluate(c, &name);
    }
    for (int i = 0; i < out->count && region_faults == 0; i++) {
        cagd_bind(c, index, cagd_value_int(first + i));
        out->function[i] = cagd_in_field(cagd_evaluate(c, function));
    }
    const char *variable = argument;
    if (out->angle && cagd_key_of_tangent(c, argument, tangent, sizeof tangent))
        variable = tangent;
    const cagd_binding *t = cagd_binding_of(c, variable), *p = parameter != NULL ? cagd_binding_of(c, parameter) : NULL;
    snprintf(of_pi, sizeof of_pi, "\\pi %s", argument);
    if (region_faults == 0 && out->angle && cagd_key_of_tangent(c, of_pi, tangent, sizeof tangent) &&
        cagd_binding_of(c, tangent) != NULL)
        return "derivatives would have \\pi as a factor: take the angle as the argument, such as \\sin t for 0 \\le t "
               "\\le \\pi/2";
    if (region_faults != 0 || t == NULL)
        return reason_of(c);
    if (c->mixes_angles)
        return "an angle that is a number, too";
    if (t->is_root_end[0] || t->is_root_end[1])
        return "the ends of the interval of an angle are multiples of \\pi/2, or of \\pi";
    out->t = side_of(t);
    if (p != NULL)
        out->range = side_of(p);
    if (!out->t.has_low || !out->t.has_high || cagd_compare_q(out->t.low, out->t.high) >= 0 ||
        !name_ends(scope, argument, out))
        return "the interval of the argument is not known: say, for instance, 0 \\le t \\le 1";
    for (int k = 0; k < c->count; k++) {
        if (!c->binding[k].unknown || c->binding[k].key[0] == '\0')
            continue;
        out->others += &c->binding[k] != t && &c->binding[k] != p;
        out->letter[out->names] = c->binding[k].key;
        out->name[out->names++] = cagd_to_string_f(c->binding[k].value.f);
    }
    values_at_ends(c, out);
    if (region_faults != 0)
        return "a function that has no value, or no derivative, at an end";
    bernstein_coefficients(out);
    return region_faults != 0 ? "a function that is too large" : NULL;
}

const char *cagd_basis_read(const cagd_scope *scope, const cagd_tree *function, const char *index, long first,
                            long last, const char *parameter, cagd_basis *out)
{
    const char *why = read_basis(scope, function, index, first, last, parameter, out);
    region_faults &= FAULT_MEMORY;
    return why;
}

/* ---- Wronskians ---------------------------------------------------------------------------------------- */

/* The functions over x > 0, and their common denominator. */
static num_f over_common_denominator(const cagd_basis *b, num_f p[])
{
    num_f common = from_int_f(1);
    for (int i = 0; i < b->count; i++)
        p[i] = over_positive_numbers(b->function[i], &b->t);
    for (int i = 0; i < b->count; i++)
        common = mul_f(common, cagd_denominator_f(mul_f(p[i], common)));
    return common;
}

/* The functions as polynomials in x > 0, all of them times one function, which is positive where the values of the parameter are not
 * *poles, zeros of a polynomial; 0 where their denominators have a sign that is not known. */
static int as_polynomials(const cagd_basis *b, num_f p[], num_f *poles)
{
    num_f common = over_common_denominator(b, p);
    *poles = b->has_parameter ? cagd_factor_of_parameter(common, b->range.variable) : from_int_f(1);
    cagd_side_of_box side[2] = {{.variable = b->t.variable, .has_low = 1, .low_open = 1, .low = from_int_q(0)},
                                b->range};
    num_q point[2];
    int rational;
    num_f rest = div_f(common, *poles);
    if (cagd_positive_in_box(rest, 1, b->has_parameter ? 2 : 1, side, point, &rational) != CAGD_HOLDS)
        return 0;
    for (int i = 0; i < b->count; i++)
        p[i] = mul_f(p[i], mul_f(common, *poles));
    return region_faults == 0;
}

/* W(p_first, ..., p_{first+order-1}) by x, without its power of x. */
static num_f wronskian(const cagd_basis *b, const num_f p[], int first, int order)
{
    num_f x = b->t.variable, *A = cagd_region_array(order, order, sizeof *A);
    for (int k = 0; k < order && A != NULL; k++) {
        num_f f = p[first + k];
        for (int row = 0; row < order; row++, f = derivative_f(f, x))
            A[row * order + k] = f;
    }
    if (A == NULL)
        return from_int_f(0);
    num_f w = cagd_pivoted_determinant_f(order, A);
    while (!cagd_is_zero_f(w) && cagd_is_zero_f(coefficient_f(w, x, 0)))
        w = div_f(w, x);
    return w;
}

static void not_known(cagd_found *out, const char *why)
{
    out->known = 0, out->why = why;
    region_faults &= FAULT_MEMORY;
}

/* Without a parameter the one cell is all. */
static cagd_side_of_box parameter_of(const cagd_basis *b)
{
    cagd_side_of_box none = {.has_low = 1, .has_high = 1, .low = from_int_q(0), .high = from_int_q(0)};
    none.variable = cagd_variable_f("none");
    return b->has_parameter ? b->range : none;
}

/* A value of the parameter is no pole. */
static cagd_constraint no_pole(const cagd_basis *b, num_f poles)
{
    return (cagd_constraint){
        .p = mul_f(poles, poles), .demand = CAGD_MORE_THAN_ZERO, .t = {.variable = parameter_of(b).variable}};
}

/* Where a function is not defined, nothing is true of it. */
static void without_poles(const cagd_constraint *defined, const cagd_side_of_box *parameter, cagd_cells *c)
{
    cagd_cells *again = region_bytes(sizeof *again);
    if (again == NULL)
        return;
    *again = *c;
    cagd_answer_cells(1, defined, parameter, again);
    for (int k = 0; k < c->count; k++)
        if (again->at[k] == CAGD_FAILS)
            c->at[k] = CAGD_FAILS;
}

/* The functions as polynomials, or why that is not possible. */
static int begin(const cagd_basis *b, num_f p[], num_f *poles, cagd_found *out)
{
    if (b->others > 0)
        not_known(out, "there are other variables than the parameter");
    else if (!as_polynomials(b, p, poles))
        not_known(out, "a denominator is 0 somewhere");
    else
        return 1;
    return 0;
}

/* The common denominator is not 0 for any t inside. */
static cagd_constraint has_no_zero(const cagd_basis *b)
{
    num_f p[CAGD_MOST_FUNCTIONS], common = over_common_denominator(b, p);
    cagd_side_of_box x = {.variable = b->t.variable, .has_low = 1, .low_open = 1, .low = from_int_q(0)};
    return (cagd_constraint){.p = mul_f(common, common), .demand = CAGD_MORE_THAN_ZERO, .t = x};
}

/* At an end of the interval no denominator is 0, but for one that is so whatever the parameter is: then the limit is meant. */
static int defined_at_ends(const cagd_basis *b, cagd_constraint to[])
{
    const num_q end[] = {b->t.low, b->t.high};
    int count = 0;
    for (int i = 0; i < b->count && b->has_parameter; i++)
        for (int k = 0; k < 2; k++) {
            num_f m = substitute_f(cagd_denominator_f(b->function[i]), b->t.variable, from_rational_f(end[k]));
            if (!cagd_is_zero_f(m) && !is_constant_f(m, NULL))
                to[count++] = (cagd_constraint){
                    .p = mul_f(m, m), .demand = CAGD_MORE_THAN_ZERO, .t = {.variable = b->range.variable}};
        }
    return count;
}

void cagd_basis_defined(const cagd_basis *b, cagd_found *out)
{
    num_f p[CAGD_MOST_FUNCTIONS], poles;
    *out = (cagd_found){.cases = 1, .domain = parameter_of(b)};
    int has_sign = begin(b, p, &poles, out);
    if (!has_sign && b->others > 0)
        return;
    cagd_constraint defined[2 * CAGD_MOST_FUNCTIONS + 1] = {has_sign ? no_pole(b, poles) : has_no_zero(b)};
    const int count = 1 + defined_at_ends(b, defined + 1);
    out->known = cagd_cells_of(count, defined, &out->domain, &out->cells);
    if (!out->known)
        not_known(out, "too many poles");
}

void cagd_basis_independent(const cagd_basis *b, cagd_found *out)
{
    num_f p[CAGD_MOST_FUNCTIONS], poles;
    *out = (cagd_found){.cases = 1, .domain = parameter_of(b)};
    if (!begin(b, p, &poles, out))
        return;
    cagd_constraint one_of[] = {{.p = wronskian(b, p, 0, b->count), .demand = CAGD_ZERO, .t = b->t}, no_pole(b, poles)};
    cagd_cells *c = &out->cells;
    out->known = cagd_cells_of(2, one_of, &out->domain, c);
    if (!out->known) {
        not_known(out, "a Wronskian that is too large");
        return;
    }
    cagd_answer_cells(1, one_of, &out->domain, c);
    for (int k = 0; k <= c->count; k++)
        c->cell[k] = c->cell[k] == CAGD_HOLDS ? CAGD_FAILS : CAGD_HOLDS;
    for (int k = 0; k < c->count; k++)
        c->at[k] = c->at[k] == CAGD_HOLDS ? CAGD_FAILS : CAGD_HOLDS;
    without_poles(&one_of[1], &out->domain, c);
}

/* ---- total positivity ---------------------------------------------------------------------------------- */

/* f for a value of the parameter, at t. */
static num_q value_at(const cagd_basis *b, int i, num_q parameter, num_q t)
{
    num_q value = from_int_q(0);
    num_f f = b->function[i];
    if (b->has_parameter)
        f = substitute_f(f, b->range.variable, from_rational_f(parameter));
    f = substitute_f(f, b->t.variable, from_rational_f(t));
    is_constant_f(f, &value);
    return value;
}

/* Where W < 0 at x, minors at t, t + h, t + 2 h, ... are negative for small h. */
static void find_negative_minor(const cagd_basis *b, int first, int order, num_q parameter, num_q x,
                                cagd_negative_minor *out)
{
    num_q t = div_q(add_q(b->t.low, mul_q(b->t.high, x)), add_q(from_int_q(1), x));
    num_q h = div_q(sub_q(b->t.high, t), from_int_q(order));
    num_q *A = cagd_region_array(order, order, sizeof *A);
    for (int step = 0; step < MOST_STEPS && A != NULL; step++, h = div_q(h, from_int_q(2))) {
        *out = (cagd_negative_minor){.first = first, .order = order, .parameter = parameter};
        for (int row = 0; row < order; row++) {
            out->t[row] = add_q(t, mul_q(from_int_q(row), h));
            for (int k = 0; k < order; k++)
                A[row * order + k] = value_at(b, first + k, parameter, out->t[row]);
        }
        out->value = cagd_pivoted_determinant_q(order, A);
        if (cagd_sign_q(out->value) < 0)
            return;
    }
    *out = (cagd_negative_minor){0};
}

/* From the answers to W > 0 and W >= 0 the answer; in both the cuts are the same. */
static void combine(cagd_cells *c, const cagd_cells *weak)
{
    for (int k = 0; k <= c->count; k++) {
        if (c->cell[k] == CAGD_HOLDS)
            continue;
        c->cell[k] = weak->cell[k] == CAGD_FAILS ? CAGD_FAILS : CAGD_UNDECIDED;
        c->broken[k] = weak->broken[k], c->witness[k] = weak->witness[k], c->has_witness[k] = weak->has_witness[k];
    }
    for (int k = 0; k < c->count; k++) { /* a limit of good values is good */
        int limit = (!c->empty[k] && c->cell[k] == CAGD_HOLDS) || (!c->empty[k + 1] && c->cell[k + 1] == CAGD_HOLDS);
        if (c->at[k] != CAGD_HOLDS)
            c->at[k] = limit ? CAGD_HOLDS : weak->at[k] == CAGD_FAILS ? CAGD_FAILS : CAGD_UNDECIDED;
    }
}

void cagd_basis_totally_positive(const cagd_basis *b, double seconds, cagd_found *out, cagd_negative_minor *minor)
{
    double until = cagd_seconds() + seconds;
    num_f p[CAGD_MOST_FUNCTIONS], poles;
    int n = b->count, blocks = n * (n + 1) / 2, count = 0;
    cagd_constraint *one_of = cagd_region_array((2 * blocks + 1), 1, sizeof *one_of);
    int *first = cagd_region_array(blocks, 1, sizeof *first);
    cagd_cells *c = &out->cells, *weak = region_bytes(sizeof *weak);
    *out = (cagd_found){.cases = blocks, .domain = parameter_of(b), .why = "there is no memory for it"};
    *minor = (cagd_negative_minor){0};
    if (one_of == NULL || first == NULL || weak == NULL || !begin(b, p, &poles, out))
        return;
    cagd_side_of_box x = {.variable = b->t.variable, .has_low = 1, .low_open = 1, .low = from_int_q(0)};
    for (int order = 1; order <= n; order++)
        for (int i = 0; i + order <= n; i++, count++) {
            if (cagd_seconds() > until) {
                not_known(out, "the time was over");
                return;
            }
            num_f w = wronskian(b, p, i, order);
            one_of[count] = (cagd_constraint){.p = w, .demand = CAGD_AT_LEAST_ZERO, .t = x};
            one_of[blocks + count] = (cagd_constraint){.p = w, .demand = CAGD_MORE_THAN_ZERO, .t = x};
            first[count] = i * (CAGD_MOST_FUNCTIONS + 1) + order;
        }
    one_of[2 * blocks] = no_pole(b, poles);
    out->known = cagd_cells_of(2 * blocks + 1, one_of, &out->domain, c);
    if (!out->known) {
        not_known(out, "Wronskians that are too large");
        return;
    }
    *weak = *c;
    cagd_answer_cells(blocks, one_of, &out->domain, weak);
    combine(c, weak);
    without_poles(&one_of[2 * blocks], &out->domain, c);
    out->why = "the functions are not independent, and then the signs of their Wronskians do not tell";
    int telling = cagd_telling_failure(c);
    if (telling >= 0 && c->has_witness[telling]) {
        int which = first[c->broken[telling]];
        find_negative_minor(b, which / (CAGD_MOST_FUNCTIONS + 1), which % (CAGD_MOST_FUNCTIONS + 1), c->sample[telling],
                            c->witness[telling], minor);
    }
}

/* ---- monotony ------------------------------------------------------------------------------------------ */

cagd_monotony cagd_basis_monotony(const cagd_basis *b, int i)
{
    num_f d = derivative_f(b->function[i], b->range.variable), m = cagd_denominator_f(d), n = cagd_numerator_f(d);
    cagd_side_of_box side[2] = {b->t, b->range};
    num_q point[2];
    int rational;
    if (cagd_is_zero_f(d))
        return CAGD_CONSTANT;
    if (b->others > 0)
        return CAGD_UNKNOWN;
    cagd_answer up = cagd_positive_in_box(mul_f(n, m), 0, 2, side, point, &rational),
                down = cagd_positive_in_box(neg_f(mul_f(n, m)), 0, 2, side, point, &rational);
    if (up == CAGD_UNDECIDED || down == CAGD_UNDECIDED)
        return CAGD_UNKNOWN;
    return up == CAGD_HOLDS ? CAGD_INCREASING : down == CAGD_HOLDS ? CAGD_DECREASING : CAGD_NOT_MONOTONE;
}
