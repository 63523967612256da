#include "exact/number/field.h"

#include "exact/number/fraction.h"
#include "exact/number/recorder.h"
#include "exact/words.h"

#include <flint/fmpq.h>
#include <flint/fmpz_mpoly_factor.h>
#include <stdio.h>
#include <string.h>

/* Lexicographic order keeps the exponent vectors free of a degree field. */
static _Thread_local struct {
    fmpz_mpoly_ctx_t ctx;
    int open, capacity, known;
    char name[FIELD_MAX_VARIABLES][FIELD_MAX_NAME + 1];
} field;

/* Slots are made and cleared with a context of one variable when none is open: FLINT's init and
 * clear use none of it but its size. */
const fmpz_mpoly_ctx_struct *cagd_field_context(void)
{
    if (!field.open)
        field_open(1);
    return field.ctx;
}
void cagd_field_slot_init(void *p)
{
    struct cagd_field_element *element = p;
    fmpz_mpoly_init(element->numerator, cagd_field_context());
    fmpz_mpoly_init(element->rest, cagd_field_context());
    fmpz_init_set_ui(element->content, 1);
    element->factors.known = 1;
    element->factors.count = 0;
}
void cagd_field_slot_clear(void *p)
{
    struct cagd_field_element *element = p;
    fmpz_mpoly_clear(element->numerator, cagd_field_context());
    fmpz_mpoly_clear(element->rest, cagd_field_context());
    fmpz_clear(element->content);
}

void cagd_field_open(int variables)
{
    field_close();
    if (variables > FIELD_MAX_VARIABLES)
        region_faults |= FAULT_UNABLE;
    field.capacity = variables < 1 ? 1 : variables < FIELD_MAX_VARIABLES ? variables : FIELD_MAX_VARIABLES;
    fmpz_mpoly_ctx_init(field.ctx, field.capacity, ORD_LEX);
    field.open = 1;
    field.known = 0;
    cagd_fraction_open();
}
void cagd_field_close(void)
{
    if (field.open) {
        cagd_fraction_close();
        fmpz_mpoly_ctx_clear(field.ctx);
    }
    field.open = 0;
}

const char *cagd_field_variables(void)
{
    char *text = region_bytes((size_t)field.known * sizeof field.name[0] + 1), *at = text;
    if (text == NULL)
        return "";
    *at = '\0';
    for (int v = 0; v < field.known; v++)
        at += sprintf(at, v > 0 ? " %s" : "%s", field.name[v]);
    return text;
}

static struct cagd_field_element *fresh(void) { return cagd_fresh_slot(SLOT_FIELD); }

/* r was made of a, or of a and b. */
static num_f made_of(const char *op, const struct cagd_field_element *r, num_f a, const num_f *b)
{
    if (cagd_noting()) {
        int argument[2] = {cagd_node_of_f(a), b != NULL ? cagd_node_of_f(*b) : 0};
        cagd_recorder->node(r, op, b != NULL ? 2 : 1, argument);
    }
    return (num_f){r};
}

static num_f zero_f(void) { return (num_f){fresh()}; }

/* After a fault there are only placeholders: a second one, such as a division by the 0 that stands
 * for a variable without room, would say nothing, and is not recorded. */
static num_f fault_f(unsigned fault)
{
    if (region_faults == 0)
        region_faults = fault;
    return zero_f();
}

num_f cagd_variable_f(const char *name)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    if (strlen(name) > FIELD_MAX_NAME)
        return fault_f(FAULT_UNABLE);
    int v = 0;
    while (v < field.known && strcmp(field.name[v], name) != 0)
        v++;
    if (v == field.known) {
        if (field.known == field.capacity)
            return fault_f(FAULT_CROWDED);
        snprintf(field.name[field.known++], sizeof field.name[0], "%s", name);
    }
    struct cagd_field_element *r = fresh();
    fmpz_mpoly_gen(r->numerator, v, ctx);
    if (cagd_noting())
        cagd_recorder->variable(r, name);
    return (num_f){r};
}

int cagd_field_variable_f(num_f a)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    slong power[CAGD_FIELD_MAX_VARIABLES];
    if (!cagd_fraction_is_polynomial(a.at) || !fmpz_mpoly_is_gen(a.at->numerator, -1, ctx))
        return -1;
    fmpz_mpoly_get_term_exp_si(power, a.at->numerator, 0, ctx);
    for (int v = 0; v < field.known; v++)
        if (power[v] == 1)
            return v;
    return -1;
}

/* After a fault the values mean nothing, so no more work is spent on them. */
typedef void field_operation(struct cagd_field_element *, const struct cagd_field_element *,
                             const struct cagd_field_element *);
static num_f combine(const char *name, field_operation *op, num_f a, num_f b)
{
    struct cagd_field_element *r = fresh();
    if (region_faults == 0)
        op(r, a.at, b.at);
    return made_of(name, r, a, &b);
}
static int is_zero(num_f a) { return fmpz_mpoly_is_zero(a.at->numerator, cagd_field_context()); }
static int is_one(num_f a)
{
    return fmpz_mpoly_is_one(a.at->numerator, cagd_field_context()) && cagd_fraction_is_polynomial(a.at);
}

/* Values do not change, so a + 0 is a itself; but each node of a record is a value of its own. */
num_f cagd_add_f(num_f a, num_f b)
{
    if (cagd_recorder == NULL && (is_zero(a) || is_zero(b)))
        return is_zero(a) ? b : a;
    return combine("+", cagd_fraction_add, a, b);
}
num_f cagd_sub_f(num_f a, num_f b)
{
    if (cagd_recorder == NULL && is_zero(b))
        return a;
    return combine("-", cagd_fraction_sub, a, b);
}
num_f cagd_mul_f(num_f a, num_f b)
{
    if (cagd_recorder == NULL && (is_zero(a) || is_one(a) || is_zero(b) || is_one(b)))
        return is_zero(a) || is_one(b) ? a : b;
    return combine("*", cagd_fraction_mul, a, b);
}
num_f cagd_div_f(num_f a, num_f b)
{
    if (is_zero(b))
        return fault_f(FAULT_UNDEFINED);
    if (cagd_recorder == NULL && (is_zero(a) || is_one(b)))
        return a;
    return combine("/", cagd_fraction_div, a, b);
}
num_f cagd_neg_f(num_f a)
{
    struct cagd_field_element *r = fresh();
    fmpz_mpoly_neg(r->numerator, a.at->numerator, field.ctx);
    fmpz_mpoly_set(r->rest, a.at->rest, field.ctx);
    fmpz_set(r->content, a.at->content);
    r->factors = a.at->factors;
    return made_of("neg", r, a, NULL);
}

num_f cagd_from_rational_f(num_q a)
{
    struct cagd_field_element *r = fresh();
    fmpz_set_mpz(r->content, mpq_numref(a.at));
    fmpz_mpoly_set_fmpz(r->numerator, r->content, cagd_field_context());
    fmpz_set_mpz(r->content, mpq_denref(a.at));
    if (cagd_noting())
        cagd_recorder->alias(r, cagd_node_of_q(a));
    return (num_f){r};
}
num_f cagd_from_int_f(long m) { return from_rational_f(from_int_q(m)); }
num_f cagd_from_ratio_f(long m, long n)
{
    return n == 0 ? fault_f(FAULT_UNDEFINED) : from_rational_f(from_ratio_q(m, n));
}

/* root = an n-th root of p; 0 when p has none.  With p = c f_1^e_1 f_2^e_2 ..., the f_i squarefree and
 * coprime in pairs, it has one exactly when c has one and n divides every e_i. */
static int polynomial_root(fmpz_mpoly_t root, int n, const fmpz_mpoly_t p)
{
    if (fmpz_mpoly_is_zero(p, field.ctx)) {
        fmpz_mpoly_zero(root, field.ctx);
        return 1;
    }
    fmpz_mpoly_factor_t f;
    fmpz_mpoly_t power;
    fmpz_t c, back;
    fmpz_mpoly_factor_init(f, field.ctx), fmpz_mpoly_init(power, field.ctx), fmpz_init(c), fmpz_init(back);
    int found = fmpz_mpoly_factor_squarefree(f, p, field.ctx) && (n % 2 == 1 || fmpz_sgn(f->constant) > 0);
    if (found) {
        fmpz_root(c, f->constant, n);
        fmpz_pow_ui(back, c, (ulong)n);
        found = fmpz_equal(back, f->constant);
        fmpz_mpoly_set_fmpz(root, c, field.ctx);
    }
    for (slong i = 0; found && i < f->num; i++) {
        found = fmpz_divisible_si(f->exp + i, n);
        found = found && fmpz_mpoly_pow_ui(power, f->poly + i, fmpz_get_ui(f->exp + i) / (ulong)n, field.ctx);
        if (found)
            fmpz_mpoly_mul(root, root, power, field.ctx);
    }
    fmpz_mpoly_factor_clear(f, field.ctx), fmpz_mpoly_clear(power, field.ctx), fmpz_clear(c), fmpz_clear(back);
    return found;
}

num_f cagd_root_f(int n, num_f a)
{
    if (n == 1)
        return a;
    struct cagd_field_element *p = fresh(), *q = fresh();
    fmpz_mpoly_t denominator;
    fmpz_mpoly_init(denominator, field.ctx);
    cagd_fraction_denominator(denominator, a.at);
    int found =
        n >= 1 && polynomial_root(p->numerator, n, a.at->numerator) && polynomial_root(q->numerator, n, denominator);
    fmpz_mpoly_clear(denominator, field.ctx);
    return found ? div_f((num_f){p}, (num_f){q}) : fault_f(FAULT_UNABLE);
}

int cagd_is_zero_f(num_f a) { return is_zero(a); }
int cagd_equal_f(num_f a, num_f b) { return cagd_fraction_equal(a.at, b.at); }

int cagd_is_constant_f(num_f a, num_q *value)
{
    if (!fmpz_mpoly_is_fmpz(a.at->numerator, cagd_field_context()) || !a.at->factors.known || a.at->factors.count > 0)
        return 0;
    if (value != NULL) {
        fmpz_t n;
        mpq_t x;
        fmpz_init(n), mpq_init(x);
        fmpz_mpoly_get_fmpz(n, a.at->numerator, field.ctx);
        fmpz_get_mpz(mpq_numref(x), n), fmpz_get_mpz(mpq_denref(x), a.at->content);
        *value = from_mpq_q(x);
        fmpz_clear(n), mpq_clear(x);
    }
    return 1;
}

num_f cagd_derivative_f(num_f a, num_f variable)
{
    int v = field_variable_f(variable);
    if (v < 0)
        return fault_f(FAULT_UNDEFINED);
    struct cagd_field_element *r = fresh();
    cagd_fraction_derivative(r, a.at, v);
    return (num_f){r};
}

/* p(value) for a polynomial p: its coefficients in powers of the variable, by Horner's rule. */
static num_f horner(const fmpz_mpoly_t p, int v, num_f value)
{
    fmpz_mpoly_univar_t u;
    fmpz_mpoly_univar_init(u, field.ctx);
    fmpz_mpoly_to_univar(u, p, v, field.ctx);
    num_f sum = zero_f();
    slong k = fmpz_mpoly_univar_length(u, field.ctx), high = 0;
    for (slong j = 0; j < k; j++) { /* terms come by decreasing exponent */
        slong e = fmpz_mpoly_univar_get_term_exp_si(u, j, field.ctx);
        for (slong step = j == 0 ? e : high; step > e; step--)
            sum = mul_f(sum, value);
        struct cagd_field_element *c = fresh();
        fmpz_mpoly_univar_get_term_coeff(c->numerator, u, j, field.ctx);
        sum = add_f(sum, (num_f){c});
        high = e;
    }
    for (; high > 0; high--)
        sum = mul_f(sum, value);
    fmpz_mpoly_univar_clear(u, field.ctx);
    return sum;
}

num_f cagd_substitute_f(num_f a, num_f variable, num_f value)
{
    int v = field_variable_f(variable);
    if (v < 0)
        return fault_f(FAULT_UNDEFINED);
    fmpz_mpoly_t denominator;
    fmpz_mpoly_init(denominator, field.ctx);
    cagd_fraction_denominator(denominator, a.at);
    num_f r = div_f(horner(a.at->numerator, v, value), horner(denominator, v, value));
    fmpz_mpoly_clear(denominator, field.ctx);
    return r;
}

/* The index of the variable; UNDEFINED, and -1, when it is none. */
static int index_of(num_f variable)
{
    int v = field_variable_f(variable);
    if (v < 0)
        fault_f(FAULT_UNDEFINED);
    return v;
}
int cagd_degree_f(num_f a, num_f variable)
{
    int v = index_of(variable);
    return v < 0 ? -1 : (int)fmpz_mpoly_degree_si(a.at->numerator, v, field.ctx);
}
int cagd_denominator_degree_f(num_f a, num_f variable)
{
    int v = index_of(variable);
    return v < 0 ? -1 : cagd_fraction_denominator_degree(a.at, v);
}

int cagd_has_degrees_f(num_f a, num_f variable, int numerator, int denominator)
{
    return degree_f(a, variable) == numerator && denominator_degree_f(a, variable) == denominator;
}

static num_q ratio_of(const fmpz_t n, const fmpz_t d)
{
    mpq_t x;
    mpq_init(x);
    fmpz_get_mpz(mpq_numref(x), n), fmpz_get_mpz(mpq_denref(x), d);
    mpq_canonicalize(x);
    num_q q = from_mpq_q(x);
    mpq_clear(x);
    return q;
}

int cagd_linear_f(num_f a, struct cagd_linear *out)
{
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    slong power[CAGD_FIELD_MAX_VARIABLES], terms = fmpz_mpoly_length(a.at->numerator, ctx);
    *out = (struct cagd_linear){.constant = from_int_q(0)};
    if (!a.at->factors.known || a.at->factors.count > 0 || terms > field.known + 1)
        return 0;
    int *variable = cagd_region_array(field.known + 1, 1, sizeof *variable);
    num_q *coefficient = cagd_region_array(field.known + 1, 1, sizeof *coefficient);
    if (variable == NULL || coefficient == NULL)
        return 0;
    fmpz_t n;
    fmpz_init(n);
    int is_linear = 1;
    for (slong k = 0; k < terms && is_linear; k++) {
        int v = -1;
        fmpz_mpoly_get_term_exp_si(power, a.at->numerator, k, ctx);
        for (int m = 0; m < field.known; m++) {
            is_linear &= power[m] == 0 || (power[m] == 1 && v < 0);
            v = power[m] != 0 ? m : v;
        }
        fmpz_mpoly_get_term_coeff_fmpz(n, a.at->numerator, k, ctx);
        if (v < 0)
            out->constant = ratio_of(n, a.at->content);
        else
            variable[out->count] = v, coefficient[out->count++] = ratio_of(n, a.at->content);
    }
    fmpz_clear(n);
    out->variable = variable, out->coefficient = coefficient;
    return is_linear;
}

/* Does the printed polynomial need no parentheses above (below) the bar of a fraction? */
static int stands_alone(const char *text, int below)
{
    return strpbrk(text[0] == '-' ? text + 1 : text, below ? "+-*" : "+-") == NULL;
}

num_f cagd_coefficient_f(num_f a, num_f variable, int k)
{
    if (denominator_degree_f(a, variable) != 0)
        return fault_f(FAULT_UNDEFINED);
    struct cagd_field_element *r = fresh();
    fmpz_mpoly_t p;
    fmpz_mpoly_univar_t u;
    fmpz_mpoly_init(p, field.ctx), fmpz_mpoly_univar_init(u, field.ctx);
    fmpz_mpoly_to_univar(u, a.at->numerator, field_variable_f(variable), field.ctx);
    for (slong j = 0; j < fmpz_mpoly_univar_length(u, field.ctx); j++)
        if (fmpz_mpoly_univar_get_term_exp_si(u, j, field.ctx) == k)
            fmpz_mpoly_univar_get_term_coeff(p, u, j, field.ctx);
    cagd_fraction_over_denominator_of(r, p, a.at);
    fmpz_mpoly_clear(p, field.ctx), fmpz_mpoly_univar_clear(u, field.ctx);
    return (num_f){r};
}

const char *cagd_to_string_f(num_f a)
{
    const char *names[FIELD_MAX_VARIABLES];
    for (int v = 0; v < FIELD_MAX_VARIABLES; v++)
        names[v] = v < field.known ? field.name[v] : "?";
    const fmpz_mpoly_ctx_struct *ctx = cagd_field_context();
    fmpz_mpoly_t denominator;
    fmpz_mpoly_init(denominator, ctx);
    cagd_fraction_denominator(denominator, a.at);
    char *p = fmpz_mpoly_get_str_pretty(a.at->numerator, names, ctx);
    char *q = fmpz_mpoly_get_str_pretty(denominator, names, ctx);
    fmpz_mpoly_clear(denominator, ctx);
    size_t room = strlen(p) + strlen(q) + 6;
    char *text = region_bytes(room);
    if (text == NULL)
        ;
    else if (strcmp(q, "1") == 0)
        snprintf(text, room, "%s", p);
    else
        snprintf(text, room,
                 stands_alone(p, 0)   ? stands_alone(q, 1) ? "%s/%s" : "%s/(%s)"
                 : stands_alone(q, 1) ? "(%s)/%s"
                                      : "(%s)/(%s)",
                 p, q);
    flint_free(p);
    flint_free(q);
    return text != NULL ? text : "";
}

static int coefficients_sign(const fmpz_mpoly_t p)
{
    int seen = 0;
    fmpz_t c;
    fmpz_init(c);
    for (slong k = 0; k < fmpz_mpoly_length(p, field.ctx) && seen != 2; k++) {
        fmpz_mpoly_get_term_coeff_fmpz(c, p, k, field.ctx);
        seen = seen == 0 || seen == fmpz_sgn(c) ? fmpz_sgn(c) : 2;
    }
    fmpz_clear(c);
    return seen;
}
int cagd_coefficients_sign_f(num_f a)
{
    fmpz_mpoly_t denominator;
    fmpz_mpoly_init(denominator, cagd_field_context());
    cagd_fraction_denominator(denominator, a.at);
    int p = coefficients_sign(a.at->numerator), q = coefficients_sign(denominator);
    fmpz_mpoly_clear(denominator, field.ctx);
    return p == 2 || q == 2 ? -2 : p * q;
}

/* ---- factors ---------------------------------------------------------------------------------------- */

num_f cagd_numerator_f(num_f a)
{
    struct cagd_field_element *r = fresh();
    fmpz_mpoly_set(r->numerator, a.at->numerator, field.ctx);
    return (num_f){r};
}

num_f cagd_denominator_f(num_f a)
{
    struct cagd_field_element *r = fresh();
    cagd_fraction_denominator(r->numerator, a.at);
    return (num_f){r};
}

static long words_of(const fmpz_mpoly_t p)
{
    slong bits = fmpz_mpoly_max_bits(p);
    return (long)fmpz_mpoly_length(p, field.ctx) * (1 + (long)(bits < 0 ? -bits : bits) / 64);
}

long cagd_words_f(num_f a)
{
    fmpz_mpoly_t denominator;
    fmpz_mpoly_init(denominator, cagd_field_context());
    cagd_fraction_denominator(denominator, a.at);
    long words = words_of(a.at->numerator) + words_of(denominator);
    fmpz_mpoly_clear(denominator, field.ctx);
    return words;
}

int cagd_factors_f(num_f a, num_f variable, int room, num_f factor[], int power[])
{
    int v = field_variable_f(variable), count = 0;
    fmpz_mpoly_factor_t f;
    fmpz_mpoly_factor_init(f, field.ctx);
    if (v < 0 || !fmpz_mpoly_factor(f, a.at->numerator, field.ctx)) {
        fault_f(FAULT_UNABLE);
        count = -1;
    }
    for (slong i = 0; count >= 0 && i < f->num; i++) {
        if (fmpz_mpoly_degree_si(f->poly + i, v, field.ctx) < 1)
            continue;
        if (count == room || !fmpz_fits_si(f->exp + i)) {
            count = -1;
            break;
        }
        struct cagd_field_element *r = fresh();
        fmpz_mpoly_set(r->numerator, f->poly + i, field.ctx);
        factor[count] = (num_f){r};
        power[count++] = (int)fmpz_get_si(f->exp + i);
    }
    fmpz_mpoly_factor_clear(f, field.ctx);
    return count;
}
