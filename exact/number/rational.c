#include "exact/number/rational.h"
#include "exact/number/recorder.h"
#include "exact/words.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static mpq_ptr fresh(void) { return cagd_fresh_slot(SLOT_RATIONAL); }

/* The value of r, now that it has one, for the record: made of a, or of a and b. */
static num_q noted(const char *op, mpq_ptr r, num_q a, const num_q *b)
{
    if (cagd_noting()) {
        int argument[2] = {cagd_node_of_q(a), b != NULL ? cagd_node_of_q(*b) : 0};
        cagd_recorder->node(r, op, b != NULL ? 2 : 1, argument);
    }
    return (num_q){r};
}
static num_q constant(mpq_ptr r)
{
    num_q c = {r};
    if (cagd_noting())
        cagd_recorder->literal(r, "c", 1, &c);
    return c;
}

static num_q fault_q(unsigned fault)
{
    region_faults |= fault;
    return from_int_q(0);
}

/* Values do not change, so a + 0 is a itself; but each node of a record is a value of its own. */
static int is_zero(num_q a) { return cagd_recorder == NULL && mpq_sgn(a.at) == 0; }
static int is_one(num_q a) { return cagd_recorder == NULL && mpq_cmp_ui(a.at, 1, 1) == 0; }

num_q cagd_add_q(num_q a, num_q b)
{
    if (is_zero(a) || is_zero(b))
        return is_zero(a) ? b : a;
    mpq_ptr r = fresh();
    mpq_add(r, a.at, b.at);
    return noted("+", r, a, &b);
}
num_q cagd_sub_q(num_q a, num_q b)
{
    if (is_zero(b))
        return a;
    mpq_ptr r = fresh();
    mpq_sub(r, a.at, b.at);
    return noted("-", r, a, &b);
}
num_q cagd_mul_q(num_q a, num_q b)
{
    if (is_zero(a) || is_zero(b) || is_one(a) || is_one(b))
        return is_zero(a) || is_one(b) ? a : b;
    mpq_ptr r = fresh();
    mpq_mul(r, a.at, b.at);
    return noted("*", r, a, &b);
}
num_q cagd_div_q(num_q a, num_q b)
{
    if (mpq_sgn(b.at) == 0)
        return fault_q(FAULT_UNDEFINED);
    if (is_zero(a) || is_one(b))
        return a;
    mpq_ptr r = fresh();
    mpq_div(r, a.at, b.at);
    return noted("/", r, a, &b);
}
num_q cagd_neg_q(num_q a)
{
    mpq_ptr r = fresh();
    mpq_neg(r, a.at);
    return noted("neg", r, a, NULL);
}
num_q cagd_from_int_q(long m)
{
    mpq_ptr r = fresh();
    mpq_set_si(r, m, 1);
    return constant(r);
}
num_q cagd_from_ratio_q(long m, long n)
{
    if (n == 0)
        return fault_q(FAULT_UNDEFINED);
    mpq_ptr r = fresh();
    mpz_set_si(mpq_numref(r), m);
    mpz_set_si(mpq_denref(r), n);
    mpq_canonicalize(r);
    return constant(r);
}

num_q cagd_root_q(int n, num_q a)
{
    mpq_ptr r = fresh();
    if (n < 1 || mpq_sgn(a.at) < 0 || !mpz_root(mpq_numref(r), mpq_numref(a.at), (unsigned long)n) ||
        !mpz_root(mpq_denref(r), mpq_denref(a.at), (unsigned long)n)) {
        mpq_set_ui(r, 0, 1);
        return fault_q(FAULT_UNABLE);
    }
    if (cagd_noting()) {
        int argument[2] = {cagd_node_of_q(a), n};
        cagd_recorder->node(r, "root", 2, argument);
    }
    return (num_q){r};
}

num_q cagd_floor_q(num_q a)
{
    mpq_ptr r = fresh();
    mpz_fdiv_q(mpq_numref(r), mpq_numref(a.at), mpq_denref(a.at));
    mpz_set_ui(mpq_denref(r), 1);
    return (num_q){r};
}

num_q cagd_from_mpq_q(mpq_srcptr x)
{
    mpq_ptr r = fresh();
    mpq_set(r, x);
    return (num_q){r};
}

num_q cagd_from_double_q(double x)
{
    if (!isfinite(x))
        return fault_q(FAULT_UNDEFINED);
    mpq_ptr r = fresh();
    mpq_set_d(r, x);
    return constant(r);
}

/* r *= base^e.  |e| <= 99999 was checked by the caller. */
static void scale(mpq_ptr r, unsigned base, long e)
{
    mpz_t power;
    mpz_init(power);
    mpz_ui_pow_ui(power, base, (unsigned long)labs(e));
    mpz_ptr side = e < 0 ? mpq_denref(r) : mpq_numref(r);
    mpz_mul(side, side, power);
    mpz_clear(power);
    mpq_canonicalize(r);
}

static int digit(char c, int base)
{
    int d = c >= '0' && c <= '9' ? c - '0' : isxdigit((unsigned char)c) ? tolower((unsigned char)c) - 'a' + 10 : 99;
    return d < base ? d : -1;
}

/* r = base^count r + behind, which has so many digits. */
static void put_behind(mpz_ptr r, mpz_srcptr behind, int count, int base)
{
    mpz_t power;
    mpz_init(power);
    mpz_ui_pow_ui(power, (unsigned long)base, (unsigned long)count);
    mpz_mul(r, r, power);
    mpz_add(r, r, behind);
    mpz_clear(power);
}

/* r is the value of so many digits, read by halves: as products of long numbers cost little, so do long texts. */
static void value_of_digits(mpz_ptr r, const char *s, int count, int base)
{
    enum { IN_A_WORD = 7 };
    if (count <= IN_A_WORD) {
        unsigned long word = 0;
        for (int k = 0; k < count; k++)
            word = word * (unsigned long)base + (unsigned long)digit(s[k], base);
        mpz_set_ui(r, word);
        return;
    }
    int half = count / 2;
    mpz_t behind;
    mpz_init(behind);
    value_of_digits(r, s, count - half, base);
    value_of_digits(behind, s + count - half, half, base);
    put_behind(r, behind, half, base);
    mpz_clear(behind);
}

/* Digits of the base, at most `limit` in number, behind those that r has.  Returns how many were read. */
static int read_digits(const char **s, int base, mpz_ptr r, int limit)
{
    int count = 0;
    while (count < limit && digit((*s)[count], base) >= 0)
        count++;
    mpz_t behind;
    mpz_init(behind);
    value_of_digits(behind, *s, count, base);
    put_behind(r, behind, count, base);
    mpz_clear(behind);
    *s += count;
    return count;
}

/* An exponent with sign, |e| <= 99999. */
static int read_exponent(const char **s, long *e)
{
    char *end;
    if (!isdigit((unsigned char)(*s)[(**s == '-' || **s == '+')]))
        return 0;
    *e = strtol(*s, &end, 10);
    *s = end;
    return -99999 <= *e && *e <= 99999;
}

/* [-+] digits [. digits] [exponent]  or  [-+] digits / digits, in base 10 or, after 0x, 16. */
num_q cagd_from_string_q(const char *s)
{
    enum { LONGEST = 100000 };
    mpq_ptr r = fresh();
    mpq_set_ui(r, 0, 1);
    int minus = *s == '-';
    s += *s == '-' || *s == '+';
    int base = s[0] == '0' && (s[1] == 'x' || s[1] == 'X') ? 16 : 10;
    s += base == 16 ? 2 : 0;

    int whole = read_digits(&s, base, mpq_numref(r), LONGEST), fraction = 0;
    int good = whole < LONGEST;
    if (*s == '/' && base == 10) {
        s++;
        mpz_set_ui(mpq_denref(r), 0);
        int under = read_digits(&s, base, mpq_denref(r), LONGEST);
        good &= whole > 0 && 0 < under && under < LONGEST && mpz_sgn(mpq_denref(r)) != 0;
        if (!good)
            mpz_set_ui(mpq_denref(r), 1);
        mpq_canonicalize(r);
    } else {
        long e = 0;
        if (*s == '.') {
            s++;
            fraction = read_digits(&s, base, mpq_numref(r), LONGEST);
        }
        good &= whole + fraction > 0 && fraction < LONGEST;
        if (good && (base == 16 ? *s == 'p' || *s == 'P' : *s == 'e' || *s == 'E')) {
            s++;
            good &= read_exponent(&s, &e);
        }
        if (good) {
            scale(r, (unsigned)base, -fraction);
            scale(r, base == 16 ? 2 : 10, e);
        }
    }
    if (!good || *s != '\0')
        return fault_q(FAULT_UNDEFINED);
    if (minus)
        mpq_neg(r, r);
    return constant(r);
}

/* The nearest binary64, by two divisions of integers: mpq_get_d truncates, hence not it. */
double cagd_to_double_q(num_q a)
{
    if (mpq_sgn(a.at) == 0)
        return 0;
    mpz_t n, d, quotient, rest;
    mpz_inits(n, d, quotient, rest, NULL);
    mpz_abs(n, mpq_numref(a.at));
    mpz_set(d, mpq_denref(a.at));
    /* n/d = q 2^e with 2^54 <= q < 2^56, and e no smaller than the subnormal grid needs */
    long e = (long)mpz_sizeinbase(n, 2) - (long)mpz_sizeinbase(d, 2) - 55;
    if (e < -1076)
        e = -1076;
    if (e < 0)
        mpz_mul_2exp(n, n, (mp_bitcnt_t)-e);
    else
        mpz_mul_2exp(d, d, (mp_bitcnt_t)e);
    mpz_tdiv_qr(quotient, rest, n, d);
    /* round q to 53 bits (fewer below the smallest normal number), the remainder being sticky */
    long bits = (long)mpz_sizeinbase(quotient, 2), keep = bits + e < -1021 ? bits + e + 1074 : 53;
    if (keep < 0)
        keep = 0;
    if (bits > keep) {
        mp_bitcnt_t cut = (mp_bitcnt_t)(bits - keep);
        int half = mpz_tstbit(quotient, cut - 1);
        int below = mpz_sgn(rest) != 0 || mpz_scan1(quotient, 0) < cut - 1;
        mpz_fdiv_q_2exp(quotient, quotient, cut);
        e += (long)cut;
        if (half && (below || mpz_odd_p(quotient)))
            mpz_add_ui(quotient, quotient, 1);
    }
    double v = ldexp(mpz_get_d(quotient), (int)(e > 5000 ? 5000 : e));
    int negative = mpq_sgn(a.at) < 0;
    mpz_clears(n, d, quotient, rest, NULL);
    return negative ? -v : v;
}

const char *cagd_to_string_q(num_q a)
{
    char *text = region_bytes(mpz_sizeinbase(mpq_numref(a.at), 10) + mpz_sizeinbase(mpq_denref(a.at), 10) + 3);
    return text != NULL ? mpq_get_str(text, 10, a.at) : "";
}
