/* functions.c -- the mathematical functions of the C library: exact where they are, else enclosed or refused. */
#include "exact/code/names.h"
#include "exact/code/value.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct complex_pair {
    double re, im;
};
struct single_pair {
    float re, im;
};

/* The prototypes of what the rewritten code calls by these names. */
#define ONE(name)                                                                                                      \
    double cagd_code_lib_##name(double x);                                                                             \
    float cagd_code_lib_##name##f(float x);                                                                            \
    double cagd_code_lib_##name##l(double x);
#define TWO(name)                                                                                                      \
    double cagd_code_lib_##name(double x, double y);                                                                   \
    float cagd_code_lib_##name##f(float x, float y);                                                                   \
    double cagd_code_lib_##name##l(double x, double y);
CAGD_CODE_ONE(ONE)
CAGD_CODE_TWO(TWO)
#undef ONE
#undef TWO
double cagd_code_lib_fma(double x, double y, double z);
float cagd_code_lib_fmaf(float x, float y, float z);
double cagd_code_lib_ldexp(double x, int n);
float cagd_code_lib_ldexpf(float x, int n);
double cagd_code_lib_scalbn(double x, int n);
double cagd_code_lib_scalbln(double x, long n);
double cagd_code_lib_frexp(double x, int *n);
double cagd_code_lib_modf(double x, double *whole);
void cagd_code_lib_sincos(double x, double *s, double *c);
long cagd_code_lib_lround(double x);
long long cagd_code_lib_llround(double x);
long cagd_code_lib_lrint(double x);
long long cagd_code_lib_llrint(double x);
int cagd_code_lib_isnan(double x);
int cagd_code_lib___isnan(double x);
int cagd_code_lib_isinf(double x);
int cagd_code_lib___isinf(double x);
int cagd_code_lib_finite(double x);
int cagd_code_lib___finite(double x);
int cagd_code_lib___signbit(double x);
double cagd_code_lib_creal(struct complex_pair z);
double cagd_code_lib_cimag(struct complex_pair z);
struct complex_pair cagd_code_lib_conj(struct complex_pair z);
double cagd_code_lib_cabs(struct complex_pair z);
struct complex_pair cagd_code_lib___muldc3(double a, double b, double c, double d);
struct complex_pair cagd_code_lib___divdc3(double a, double b, double c, double d);
struct complex_pair cagd_code_lib_csqrt(struct complex_pair z);
float cagd_code_lib_crealf(struct single_pair z);
float cagd_code_lib_cimagf(struct single_pair z);
struct single_pair cagd_code_lib_conjf(struct single_pair z);
float cagd_code_lib_cabsf(struct single_pair z);
struct single_pair cagd_code_lib___mulsc3(float a, float b, float c, float d);
struct single_pair cagd_code_lib___divsc3(float a, float b, float c, float d);
int cagd_code_lib_ilogb(double x);
int cagd_code_lib_fesetround(int mode);

typedef cagd_code_value value;
static value of(double x) { return cagd_code_value_of(x); }
static double number(value v) { return cagd_code_number(v); }
static value zero(void) { return cagd_code_integer(0); }
static int rounding(void) { return cagd_code_machine.job->numbers == CAGD_CODE_ROUNDING; }

/* Whether v is that integer, whatever the variables are. */
static int is_just(value v, long n)
{
    cagd_num_q q = v.q;
    if (v.special || (v.f.at != NULL && !cagd_is_constant_f(v.f, &q)))
        return 0;
    return q.at != NULL && cagd_equal_q(q, cagd_from_int_q(n));
}

static int is_nan(value v) { return v.special && isnan(v.d); }
static int is_infinite(value v) { return v.special && isinf(v.d); }

/* ---- enclosures ---------------------------------------------------------------------------------------- */

enum { BITS = 320 };

typedef int function(mpfr_t, const mpfr_t, mpfr_rnd_t);

enum shape { MONOTONE, STEEP, SLOW }; /* between the values at the ends; neither; |f'| <= 1 */

static cagd_num_q end_of(mpfr_srcptr x)
{
    mpq_t q;
    mpq_init(q);
    mpfr_get_q(q, x);
    cagd_num_q end = cagd_from_mpq_q(q);
    mpq_clear(q);
    return end;
}

/* f(x): between its values, rounded outwards, at the two numbers of 320 bits beside x, where f is monotone from one to the other; where it
 * need not be, their distance further, |f'| being at most 1.  A pole of the tangent between them makes the values larger than 2^100. */
static cagd_num_i enclosed_at(cagd_num_q q, function *f, const char *name, enum shape shape)
{
    static const mpfr_rnd_t beside[] = {MPFR_RNDD, MPFR_RNDU};
    mpfr_t x[2], low, high;
    mpfr_inits2(BITS, x[0], x[1], low, high, (mpfr_ptr)0);
    cagd_num_i at[2];
    for (int k = 0; k < 2; k++) {
        mpfr_set_q(x[k], q.at, beside[k]);
        f(low, x[k], MPFR_RNDD);
        f(high, x[k], MPFR_RNDU);
        if (mpfr_cmpabs_ui(x[k], 1) > 0 && mpfr_get_exp(x[k]) > 64)
            cagd_code_stop(CAGD_CODE_REFUSED, "%s of a number beyond 2^64", name);
        if (!mpfr_number_p(low) || mpfr_zero_p(low) || mpfr_get_exp(low) < -100 || mpfr_get_exp(low) > 100)
            cagd_code_stop(CAGD_CODE_REFUSED, "%s where its value is too large, too small or not there", name);
        at[k] = cagd_hull_i(cagd_from_rational_i(end_of(low)), cagd_from_rational_i(end_of(high)));
    }
    cagd_num_i both = cagd_hull_i(at[0], at[1]);
    if (shape == SLOW) {
        cagd_num_q apart = cagd_sub_q(end_of(x[1]), end_of(x[0]));
        both = cagd_add_i(both, cagd_hull_i(cagd_from_rational_i(cagd_neg_q(apart)), cagd_from_rational_i(apart)));
    }
    mpfr_clears(x[0], x[1], low, high, (mpfr_ptr)0);
    return both;
}

/* v, what a function makes of a; in a run with rounding with the binary64 of its plain form, and the error of a times its slope. */
static value with_error_of(value a, value v, double (*plain)(double), const char *name)
{
    if (!rounding())
        return v;
    double h = a.d != 0 ? fabs(a.d) * 0x1p-26 : 0x1p-26, slope = (plain(a.d + h) - plain(a.d - h)) / (2 * h);
    if (a.shares > 0 && !isfinite(slope))
        cagd_code_stop(CAGD_CODE_REFUSED, "the error of %s where it has no slope", name);
    v.d = plain(a.d);
    cagd_code_shared(&v, a, slope, (value){.d = 0}, 0, 0);
    return v;
}

static value enclosed(value a, function *f, double (*plain)(double), const char *name, enum shape shape)
{
    const struct cagd_code_job *job = cagd_code_machine.job;
    if (a.special) { /* 0, 1, -1, or no number; π/2 is no binary64 */
        double at_infinity = plain(a.d);
        if (isfinite(at_infinity) && at_infinity != rint(at_infinity))
            cagd_code_stop(CAGD_CODE_REFUSED, "%s of an infinity", name);
        return cagd_code_special(at_infinity);
    }
    if (job->numbers == CAGD_CODE_FIELD || (job->numbers == CAGD_CODE_RATIONAL && !job->enclose))
        cagd_code_stop(CAGD_CODE_REFUSED, "%s of a number for which it is not rational", name);
    value v = {.d = plain(a.d)};
    if (a.q.at != NULL) {
        v.i = enclosed_at(a.q, f, name, shape);
    } else {
        cagd_num_q low = end_of(a.i.at->lo), high = end_of(a.i.at->hi), width = cagd_sub_q(high, low);
        if (shape == STEEP)
            cagd_code_stop(CAGD_CODE_REFUSED, "%s of an interval", name);
        v.i = enclosed_at(low, f, name, shape);
        if (shape == MONOTONE)
            v.i = cagd_hull_i(v.i, enclosed_at(high, f, name, shape));
        else
            v.i =
                cagd_hull_i(cagd_sub_i(v.i, cagd_from_rational_i(width)), cagd_add_i(v.i, cagd_from_rational_i(width)));
    }
    return with_error_of(a, v, plain, name);
}

#define ENCLOSED(name, exact_at, exactly, shape)                                                                       \
    double cagd_code_lib_##name(double x)                                                                              \
    {                                                                                                                  \
        value a = of(x);                                                                                               \
        return number(is_just(a, exact_at) ? with_error_of(a, cagd_code_integer(exactly), name, #name)                 \
                                           : enclosed(a, mpfr_##name, name, #name, shape));                            \
    }
ENCLOSED(exp, 0, 1, MONOTONE)
ENCLOSED(expm1, 0, 0, MONOTONE)
ENCLOSED(log, 1, 0, MONOTONE)
ENCLOSED(log1p, 0, 0, MONOTONE)
ENCLOSED(tan, 0, 0, STEEP)
ENCLOSED(asin, 0, 0, MONOTONE)
ENCLOSED(acos, 1, 0, MONOTONE)
ENCLOSED(atan, 0, 0, MONOTONE)
ENCLOSED(sinh, 0, 0, MONOTONE)
ENCLOSED(cosh, 0, 1, STEEP)
ENCLOSED(tanh, 0, 0, MONOTONE)

/* 2^n for whole n; of others an enclosure. */
double cagd_code_lib_exp2(double x)
{
    value a = of(x);
    if (!a.special && a.f.at == NULL && a.q.at != NULL && cagd_is_whole_q(a.q) && fabs(cagd_to_double_q(a.q)) < 1e6)
        return number(with_error_of(a, of(cagd_code_power(2, (int32_t)cagd_to_double_q(a.q))), exp2, "exp2"));
    return number(enclosed(a, mpfr_exp2, exp2, "exp2", MONOTONE));
}

/* n where a = base^n. */
static double whole_logarithm(double x, long base, function *f, double (*plain)(double), const char *name)
{
    value a = of(x);
    if (!a.special && a.f.at == NULL && a.q.at != NULL && cagd_sign_q(a.q) > 0) {
        long n = lround(plain(cagd_to_double_q(a.q)));
        if (labs(n) < 100000) {
            value power = of(cagd_code_power((double)base, (int32_t)n));
            if (power.q.at != NULL && cagd_equal_q(power.q, a.q))
                return number(with_error_of(a, cagd_code_integer(n), plain, name));
        }
    }
    return number(enclosed(a, f, plain, name, MONOTONE));
}
double cagd_code_lib_log2(double x) { return whole_logarithm(x, 2, mpfr_log2, log2, "log2"); }
double cagd_code_lib_log10(double x) { return whole_logarithm(x, 10, mpfr_log10, log10, "log10"); }

/* ---- sine and cosine --------------------------------------------------------------------------------------- */

/* In the field: two variables, the square of the first being 1 less that of the second, for every angle but 0. */
enum { MOST_ANGLES = 16 };
static struct {
    cagd_num_f angle;
    value sine, cosine;
} angles[MOST_ANGLES];
static int angle_count, angle_names; /* cos1, cos2, ..., without those that are inputs */

static value enclosed_at_point(cagd_num_q q, function *f, double (*plain)(double), const char *name)
{
    struct cagd_code_job here = *cagd_code_machine.job;
    const struct cagd_code_job *job = cagd_code_machine.job;
    here.numbers = CAGD_CODE_INTERVAL;
    cagd_code_machine.job = &here;
    value v = enclosed(cagd_code_constant(q), f, plain, name, SLOW);
    cagd_code_machine.job = job;
    return v;
}

static int known_angle(value a)
{
    if (a.q.at == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "an angle that is not rational");
    for (int k = 0; k < angle_count; k++)
        if (cagd_equal_f(angles[k].angle, a.f))
            return k;
    if (angle_count == MOST_ANGLES)
        cagd_code_stop(CAGD_CODE_BOUND, "more than %d angles", MOST_ANGLES);
    char name[CAGD_FIELD_MAX_NAME + 1];
    do
        snprintf(name, sizeof name, "cos%d", ++angle_names);
    while (cagd_code_is_input(name));
    value cosine = enclosed_at_point(a.q, mpfr_cos, cos, "cos"), sine = enclosed_at_point(a.q, mpfr_sin, sin, "sin");
    cosine.f = cagd_variable_f(name);
    cagd_code_check_faults();
    cagd_code_enclose_variable(cosine.f, cosine.i);
    angles[angle_count].angle = a.f;
    angles[angle_count].cosine = cosine;
    angles[angle_count].sine =
        cagd_code_new_root(cagd_sub_f(cagd_from_int_f(1), cagd_mul_f(cosine.f, cosine.f)), sine, 0);
    return angle_count++;
}

double cagd_code_lib_sin(double x)
{
    value a = of(x);
    if (is_just(a, 0))
        return 0;
    return number(a.f.at != NULL ? angles[known_angle(a)].sine : enclosed(a, mpfr_sin, sin, "sin", SLOW));
}

double cagd_code_lib_cos(double x)
{
    value a = of(x);
    if (is_just(a, 0))
        return 1;
    return number(a.f.at != NULL ? angles[known_angle(a)].cosine : enclosed(a, mpfr_cos, cos, "cos", SLOW));
}

void cagd_code_lib_sincos(double x, double *s, double *c)
{
    *s = cagd_code_lib_sin(x);
    *c = cagd_code_lib_cos(x);
}

/* ---- roots and powers --------------------------------------------------------------------------------------- */

double cagd_code_lib_sqrt(double x) { return number(cagd_code_square_root(of(x))); }

double cagd_code_lib_cbrt(double x)
{
    value a = of(x);
    if (a.special || a.q.at == NULL || a.f.at != NULL)
        return number(enclosed(a, mpfr_cbrt, cbrt, "cbrt", MONOTONE));
    int negative = cagd_sign_q(a.q) < 0;
    cagd_num_q root = cagd_root_q(3, negative ? cagd_neg_q(a.q) : a.q);
    if (cagd_region_faults & CAGD_FAULT_UNABLE) {
        cagd_region_faults &= ~(unsigned)CAGD_FAULT_UNABLE;
        return number(enclosed(a, mpfr_cbrt, cbrt, "cbrt", MONOTONE));
    }
    return number(with_error_of(a, cagd_code_constant(negative ? cagd_neg_q(root) : root), cbrt, "cbrt"));
}

/* A number that is to minus infinity as an exponent what n is: of the same sign, and odd where n is; 0 where it is 0. */
static double exponent_like(value n)
{
    int sign = cagd_code_sign(n);
    if (sign == 0)
        return 0;
    if (n.f.at != NULL || n.q.at == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "pow of minus infinity with an exponent that varies");
    int is_odd = cagd_is_whole_q(n.q) && mpz_odd_p(mpq_numref(n.q.at));
    return is_odd ? sign : 2 * sign;
}

/* x^y where one of the two, or both, is an infinity or a NaN, as C has it.  What it is depends on whether the base is 1 (beside a NaN), on which side of 1
 * its size is (beside an infinity), or on the sign of the exponent: a condition of the way.  Any other number of which the same is true has the same
 * power. */
static double power_beside_infinity(double x, double y)
{
    value a = of(x), n = of(y), one = cagd_code_integer(1);
    double base = a.d, exponent = n.d;
    if (!a.special && isnan(n.d)) {
        base = cagd_code_relation(a, one, 1) == 1 ? 1 : 2;
    } else if (!a.special) {
        value size = of(cagd_code_lib_fabs(x));
        base = cagd_code_relation(size, one, 4) == 4 ? 0.5 : cagd_code_relation(size, one, 2) == 2 ? 2 : 1;
    } else if (!n.special && isnan(a.d)) {
        exponent = cagd_code_relation(n, zero(), 1) == 1 ? 0 : 1;
    } else if (!n.special) {
        exponent = a.d < 0 ? exponent_like(n) : cagd_code_sign(n);
    }
    return pow(base, exponent);
}

double cagd_code_lib_pow(double x, double y)
{
    value a = of(x), n = of(y);
    if (n.shares > 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "pow with an exponent that was rounded");
    if (is_just(n, 0) || (is_just(a, 1) && a.shares == 0))
        return 1;
    if (a.special || n.special)
        return power_beside_infinity(x, y);
    if (n.f.at != NULL || n.q.at == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "pow with an exponent that varies");
    if (cagd_is_whole_q(n.q) && fabs(cagd_to_double_q(n.q)) < 0x1p30)
        return cagd_code_power(x, (int32_t)cagd_to_double_q(n.q));
    if (cagd_equal_q(n.q, cagd_from_ratio_q(1, 2)))
        return cagd_code_lib_sqrt(x);
    cagd_code_stop(CAGD_CODE_REFUSED, "pow with an exponent that is neither whole nor 1/2");
}

double cagd_code_lib_hypot(double x, double y)
{
    value a = of(x), b = of(y);
    if (a.special || b.special)
        return hypot(a.special ? a.d : 0, b.special ? b.d : 0);
    return number(cagd_code_square_root(cagd_code_sum(cagd_code_product(a, a), cagd_code_product(b, b))));
}

double cagd_code_lib_cabs(struct complex_pair z) { return cagd_code_lib_hypot(z.re, z.im); }

/* 0 on the positive axis; elsewhere not rational. */
double cagd_code_lib_atan2(double y, double x)
{
    value a = of(y), b = of(x);
    if (is_nan(a) || is_nan(b))
        return NAN;
    if (is_just(a, 0) && cagd_code_sign(b) >= 0)
        return 0;
    if (a.special || b.special || cagd_code_sign(b) <= 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "atan2 outside the right half-plane");
    return number(enclosed(cagd_code_quotient(a, b), mpfr_atan, atan, "atan2", MONOTONE));
}

/* ---- parts of a number -------------------------------------------------------------------------------------- */

double cagd_code_lib_fabs(double x)
{
    value a = of(x);
    if (a.special)
        return fabs(a.d);
    return cagd_code_relation(a, zero(), 4) == 4 ? number(cagd_code_negative(a)) : x;
}

#define ROUNDED(name, how)                                                                                             \
    double cagd_code_lib_##name(double x) { return number(cagd_code_whole(of(x), how)); }
ROUNDED(floor, CAGD_CODE_FLOOR)
ROUNDED(ceil, CAGD_CODE_CEIL)
ROUNDED(trunc, CAGD_CODE_TRUNC)
ROUNDED(round, CAGD_CODE_ROUND)
ROUNDED(rint, CAGD_CODE_EVEN)
ROUNDED(nearbyint, CAGD_CODE_EVEN)
ROUNDED(roundeven, CAGD_CODE_EVEN)

long cagd_code_lib_lround(double x) { return cagd_code_to_integer(cagd_code_lib_round(x), 64, 1); }
long long cagd_code_lib_llround(double x) { return cagd_code_lib_lround(x); }
long cagd_code_lib_lrint(double x) { return cagd_code_to_integer(cagd_code_lib_rint(x), 64, 1); }
long long cagd_code_lib_llrint(double x) { return cagd_code_lib_lrint(x); }

double cagd_code_lib_fmin(double x, double y)
{
    if (is_nan(of(x)) || is_nan(of(y)))
        return is_nan(of(x)) ? y : x;
    return cagd_code_compare(x, y, 4) ? x : y;
}

double cagd_code_lib_fmax(double x, double y)
{
    if (is_nan(of(x)) || is_nan(of(y)))
        return is_nan(of(x)) ? y : x;
    return cagd_code_compare(x, y, 2) ? x : y;
}

/* There is no negative zero but the one that is written. */
static int is_negative_zero(double x) { return x == 0 && signbit(x); }

double cagd_code_minimum(double x, double y)
{
    if (is_nan(of(x)) || is_nan(of(y)))
        return NAN;
    return cagd_code_compare(x, y, is_negative_zero(x) ? 4 | 1 : 4) ? x : y;
}

double cagd_code_maximum(double x, double y)
{
    if (is_nan(of(x)) || is_nan(of(y)))
        return NAN;
    return cagd_code_compare(x, y, is_negative_zero(y) ? 2 | 1 : 2) ? x : y;
}

double cagd_code_lib_fdim(double x, double y)
{
    if (is_nan(of(x)) || is_nan(of(y)))
        return is_nan(of(x)) ? x : y;
    return cagd_code_compare(x, y, 2) ? cagd_code_sub(x, y) : 0;
}

double cagd_code_lib_copysign(double x, double y)
{
    double size = cagd_code_lib_fabs(x);
    return cagd_code_sign_bits(y) != 0 ? cagd_code_neg(size) : size;
}

/* x - y trunc(x/y), and with the nearest integer for trunc. */
static double rest(double x, double y, enum cagd_code_rounding how)
{
    value a = of(x), b = of(y);
    if (!a.special && is_infinite(b))
        return x;
    if (a.special || b.special)
        return fmod(a.special ? a.d : cagd_code_real(a), b.special ? b.d : cagd_code_real(b));
    value n = cagd_code_whole(cagd_code_quotient(a, b), how);
    value v = cagd_code_difference(a, cagd_code_product(n, b));
    if (rounding()) { /* x^ - n^ y^, which is no rounded number; (x^ - n y^) - (x - n y) = (x^ - x) - n (y^ - y) */
        v.d = how == CAGD_CODE_TRUNC ? fmod(a.d, b.d) : remainder(a.d, b.d);
        v.shares = 0;
        double other = 0;
        if (isfinite(v.d) && isfinite(b.d))
            other = cagd_to_double_q(cagd_sub_q(cagd_sub_q(cagd_from_double_q(v.d), cagd_from_double_q(a.d)),
                                                cagd_neg_q(cagd_mul_q(n.q, cagd_from_double_q(b.d)))));
        cagd_code_shared(&v, a, 1, b, -cagd_to_double_q(n.q), other);
    }
    return number(v);
}
double cagd_code_lib_fmod(double x, double y) { return rest(x, y, CAGD_CODE_TRUNC); }
double cagd_code_lib_remainder(double x, double y) { return rest(x, y, CAGD_CODE_EVEN); }

double cagd_code_lib_fma(double x, double y, double z)
{
    value a = of(x), b = of(y), c = of(z);
    value p = cagd_code_product(a, b), v = cagd_code_sum(p, c);
    if (rounding() && !v.special) {
        v.d = fma(a.d, b.d, c.d);
        cagd_num_q sum =
            cagd_add_q(cagd_mul_q(cagd_from_double_q(a.d), cagd_from_double_q(b.d)), cagd_from_double_q(c.d));
        value alone = {.d = 0};
        cagd_code_shared(&alone, a, cagd_code_real(b), b, a.d, 0);
        v.shares = 0;
        cagd_code_shared(&v, alone, 1, c, 1, cagd_to_double_q(cagd_sub_q(cagd_from_double_q(v.d), sum)));
    }
    return number(v);
}
float cagd_code_lib_fmaf(float x, float y, float z)
{
    return cagd_code_narrow(cagd_code_lib_fma(cagd_code_widen(x), cagd_code_widen(y), cagd_code_widen(z)));
}

double cagd_code_lib_scalbln(double x, long n)
{
    if (n < -100000 || n > 100000)
        cagd_code_stop(CAGD_CODE_BOUND, "a power of two beyond 2^100000");
    return cagd_code_mul(x, cagd_code_power(2, (int32_t)n));
}
double cagd_code_lib_ldexp(double x, int n) { return cagd_code_lib_scalbln(x, n); }
double cagd_code_lib_scalbn(double x, int n) { return cagd_code_lib_scalbln(x, n); }
float cagd_code_lib_ldexpf(float x, int n) { return cagd_code_narrow(cagd_code_lib_scalbln(cagd_code_widen(x), n)); }

/* x = m 2^n with 1/2 <= |m| < 1; 0 = 0 2^0. */
double cagd_code_lib_frexp(double x, int *n)
{
    value a = of(x);
    *n = 0;
    if (a.special)
        cagd_code_stop(CAGD_CODE_REFUSED, "frexp of an infinity or a NaN, whose exponent C does not specify");
    if (a.q.at == NULL)
        cagd_code_stop(CAGD_CODE_REFUSED, "frexp of an interval");
    if (cagd_code_relation(a, zero(), 1) == 1)
        return x;
    double size = cagd_code_lib_fabs(x);
    long guess = (long)mpz_sizeinbase(mpq_numref(a.q.at), 2) - (long)mpz_sizeinbase(mpq_denref(a.q.at), 2);
    if (cagd_code_compare(size, cagd_code_power(2, (int32_t)guess), 3))
        guess++;
    cagd_code_compare(size, cagd_code_power(2, (int32_t)guess - 1), 3); /* both are true, and conditions */
    cagd_code_compare(size, cagd_code_power(2, (int32_t)guess), 4);
    cagd_code_follow(guess);
    *n = (int)guess;
    return cagd_code_lib_scalbln(x, -guess);
}

double cagd_code_lib_modf(double x, double *whole)
{
    value a = of(x);
    *whole = cagd_code_lib_trunc(x);
    return is_infinite(a) ? 0 : cagd_code_sub(x, *whole);
}

int cagd_code_lib_isnan(double x) { return is_nan(of(x)); }
int cagd_code_lib___isnan(double x) { return is_nan(of(x)); }
int cagd_code_lib_isinf(double x)
{
    value a = of(x);
    return is_infinite(a) ? (a.d > 0 ? 1 : -1) : 0;
}
int cagd_code_lib___isinf(double x) { return cagd_code_lib_isinf(x); }
int cagd_code_lib_finite(double x) { return !of(x).special; }
int cagd_code_lib___finite(double x) { return !of(x).special; }
int cagd_code_lib___signbit(double x) { return cagd_code_sign_bits(x) != 0; }

/* ---- complex numbers -------------------------------------------------------------------------------------- */

double cagd_code_lib_creal(struct complex_pair z) { return z.re; }
double cagd_code_lib_cimag(struct complex_pair z) { return z.im; }
struct complex_pair cagd_code_lib_conj(struct complex_pair z)
{
    return (struct complex_pair){z.re, cagd_code_neg(z.im)};
}

/* (a + bi)(c + di) as the formula has it. */
static struct complex_pair complex_product(double a, double b, double c, double d)
{
    return (struct complex_pair){cagd_code_sub(cagd_code_mul(a, c), cagd_code_mul(b, d)),
                                 cagd_code_add(cagd_code_mul(a, d), cagd_code_mul(b, c))};
}

/* Where the formula has two NaNs and an infinity takes part, C goes another way, to an infinity or to 0 (annex G of its standard). */
static struct complex_pair unless_infinite(struct complex_pair z, double a, double b, double c, double d)
{
    int any = is_infinite(of(a)) || is_infinite(of(b)) || is_infinite(of(c)) || is_infinite(of(d));
    if (any && is_nan(of(z.re)) && is_nan(of(z.im)))
        cagd_code_stop(CAGD_CODE_REFUSED, "a product or quotient of complex numbers with an infinity");
    return z;
}

struct complex_pair cagd_code_lib___muldc3(double a, double b, double c, double d)
{
    return unless_infinite(complex_product(a, b, c, d), a, b, c, d);
}

struct complex_pair cagd_code_lib___divdc3(double a, double b, double c, double d)
{
    double size = cagd_code_add(cagd_code_mul(c, c), cagd_code_mul(d, d));
    struct complex_pair p = complex_product(a, b, c, cagd_code_neg(d));
    return unless_infinite((struct complex_pair){cagd_code_div(p.re, size), cagd_code_div(p.im, size)}, a, b, c, d);
}

/* ---- the same for float and long double ------------------------------------------------------------------------ */

#define ONE(name)                                                                                                      \
    float cagd_code_lib_##name##f(float x) { return cagd_code_narrow(cagd_code_lib_##name(cagd_code_widen(x))); }      \
    double cagd_code_lib_##name##l(double x) { return cagd_code_lib_##name(x); }
#define TWO(name)                                                                                                      \
    float cagd_code_lib_##name##f(float x, float y)                                                                    \
    {                                                                                                                  \
        return cagd_code_narrow(cagd_code_lib_##name(cagd_code_widen(x), cagd_code_widen(y)));                         \
    }                                                                                                                  \
    double cagd_code_lib_##name##l(double x, double y) { return cagd_code_lib_##name(x, y); }
CAGD_CODE_ONE(ONE)
CAGD_CODE_TWO(TWO)

/* ---- complex numbers of floats, and a root ------------------------------------------------------------------------ */

static struct single_pair narrow(struct complex_pair z)
{
    return (struct single_pair){cagd_code_narrow(z.re), cagd_code_narrow(z.im)};
}
float cagd_code_lib_crealf(struct single_pair z) { return z.re; }
float cagd_code_lib_cimagf(struct single_pair z) { return z.im; }
struct single_pair cagd_code_lib_conjf(struct single_pair z)
{
    return (struct single_pair){z.re, cagd_code_narrow(cagd_code_neg(cagd_code_widen(z.im)))};
}
float cagd_code_lib_cabsf(struct single_pair z) { return cagd_code_lib_hypotf(z.re, z.im); }
struct single_pair cagd_code_lib___mulsc3(float a, float b, float c, float d)
{
    return narrow(
        cagd_code_lib___muldc3(cagd_code_widen(a), cagd_code_widen(b), cagd_code_widen(c), cagd_code_widen(d)));
}
struct single_pair cagd_code_lib___divsc3(float a, float b, float c, float d)
{
    return narrow(
        cagd_code_lib___divdc3(cagd_code_widen(a), cagd_code_widen(b), cagd_code_widen(c), cagd_code_widen(d)));
}

/* The root in the right half-plane: with r = |z|, √((r + a)/2) ± i √((r - a)/2), the sign that of the imaginary part. */
struct complex_pair cagd_code_lib_csqrt(struct complex_pair z)
{
    if (of(z.re).special || of(z.im).special)
        cagd_code_stop(CAGD_CODE_REFUSED, "the square root of a complex number with an infinity or a NaN");
    double r = cagd_code_lib_cabs(z);
    struct complex_pair root = {cagd_code_lib_sqrt(cagd_code_div(cagd_code_add(r, z.re), 2)),
                                cagd_code_lib_sqrt(cagd_code_div(cagd_code_sub(r, z.re), 2))};
    if (cagd_code_sign(of(z.im)) < 0)
        root.im = cagd_code_neg(root.im);
    return root;
}

/* ---- exponents, and the direction of rounding ------------------------------------------------------------------- */

static int exponent_of(double x)
{
    int n;
    if (of(x).special || cagd_code_sign(of(x)) == 0)
        cagd_code_stop(CAGD_CODE_REFUSED, "the exponent of 0 or of what is no number");
    cagd_code_lib_frexp(x, &n);
    return n - 1;
}
int cagd_code_lib_ilogb(double x) { return exponent_of(x); }
double cagd_code_lib_logb(double x) { return exponent_of(x); }

/* Nothing is rounded, or with rounding to the nearest. */
int cagd_code_lib_fesetround(int mode)
{
    if (mode != FE_TONEAREST)
        cagd_code_stop(CAGD_CODE_REFUSED, "another direction of rounding than to the nearest");
    return 0;
}
