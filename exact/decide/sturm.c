#include "exact/decide/sturm.h"
#include "exact/words.h"

/* A polynomial over Z: sum c[k] x^k, c[n] != 0, or n = -1 for zero; with room up to c[room]. */
struct integral {
    int n, room;
    mpz_t *c;
};

/* Where coefficients are taken from, one after the other: for p of degree n and both of its chains (n+1)(n+7) are enough.
 * Made at once, so that memory is missing before anything is begun. */
struct stock {
    mpz_t *next;
    struct integral *chain; /* 2 (n + 2) of them */
};

static struct integral new_integral(struct stock *stock, int n)
{
    struct integral f = {n, n, stock->next};
    stock->next += n + 1;
    for (int k = 0; k <= n; k++)
        mpz_init(f.c[k]);
    return f;
}
static void clear_integral(struct integral f)
{
    for (int k = 0; k <= f.room; k++)
        mpz_clear(f.c[k]);
}

/* Divide by the greatest common divisor of the coefficients: signs do not change. */
static void make_primitive(struct integral f)
{
    mpz_t content;
    mpz_init(content);
    for (int k = 0; k <= f.n && mpz_cmp_ui(content, 1) != 0; k++)
        mpz_gcd(content, content, f.c[k]);
    for (int k = 0; k <= f.n; k++)
        mpz_divexact(f.c[k], f.c[k], content);
    mpz_clear(content);
}

/* A positive multiple of p. */
static struct integral from_poly(struct stock *stock, poly p)
{
    struct integral f = new_integral(stock, cagd_poly_degree(p));
    mpz_t common;
    mpz_init_set_ui(common, 1);
    for (int k = 0; k <= f.n; k++)
        mpz_lcm(common, common, mpq_denref(poly_coefficient(p, k).at));
    for (int k = 0; k <= f.n; k++) {
        num_q c = poly_coefficient(p, k);
        mpz_divexact(f.c[k], common, mpq_denref(c.at));
        mpz_mul(f.c[k], f.c[k], mpq_numref(c.at));
    }
    mpz_clear(common);
    make_primitive(f);
    return f;
}
static struct integral slope(struct stock *stock, struct integral f)
{
    struct integral d = new_integral(stock, f.n - 1);
    for (int k = 1; k <= f.n; k++)
        mpz_mul_ui(d.c[k - 1], f.c[k], (unsigned long)k);
    make_primitive(d);
    return d;
}

/* f becomes a positive multiple of its remainder by g: as long as deg f >= deg g,
 * f := |lead g| f - sign(lead g) lead(f) x^(deg f - deg g) g. */
static void reduce(struct integral *f, struct integral g)
{
    mpz_t size, lead;
    mpz_init(size), mpz_init(lead);
    mpz_abs(size, g.c[g.n]);
    while (f->n >= g.n) {
        int shift = f->n - g.n;
        mpz_set(lead, f->c[f->n]);
        if (mpz_sgn(g.c[g.n]) < 0)
            mpz_neg(lead, lead);
        for (int k = 0; k <= f->n; k++)
            mpz_mul(f->c[k], f->c[k], size);
        for (int k = 0; k <= g.n; k++)
            mpz_submul(f->c[k + shift], lead, g.c[k]);
        while (f->n >= 0 && mpz_sgn(f->c[f->n]) == 0)
            f->n--;
    }
    mpz_clear(size), mpz_clear(lead);
}

/* f/g for a primitive g that divides f: by Gauss's lemma the quotient is over Z. */
static struct integral exact_quotient(struct stock *stock, struct integral f, struct integral g)
{
    struct integral q = new_integral(stock, f.n - g.n);
    for (int k = q.n; k >= 0; k--) {
        mpz_divexact(q.c[k], f.c[k + g.n], g.c[g.n]);
        for (int j = 0; j <= g.n; j++)
            mpz_submul(f.c[k + j], q.c[k], g.c[j]);
    }
    return q;
}

/* p_0, p_1, ..., p_last: primitive, p_last the greatest common divisor of p_0 and p_1. */
struct chain {
    int last;
    struct integral *p;
};

static struct integral minus_remainder(struct stock *stock, struct integral f, struct integral g)
{
    struct integral r = new_integral(stock, f.n);
    for (int k = 0; k <= f.n; k++)
        mpz_neg(r.c[k], f.c[k]);
    reduce(&r, g);
    make_primitive(r);
    return r;
}
static struct chain chain_of(struct stock *stock, struct integral f)
{
    struct chain s = {0, stock->chain};
    stock->chain += f.n + 2;
    s.p[0] = f;
    struct integral next = f.n > 0 ? slope(stock, f) : new_integral(stock, -1);
    while (next.n >= 0) {
        s.p[++s.last] = next;
        next = minus_remainder(stock, s.p[s.last - 1], s.p[s.last]);
    }
    clear_integral(next);
    return s;
}
static void clear_chain(struct chain s)
{
    for (int k = 0; k <= s.last; k++)
        clear_integral(s.p[k]);
}

/* The chain of the squarefree part of p. */
static struct chain sturm_chain(struct stock *stock, poly p)
{
    struct chain s = chain_of(stock, from_poly(stock, p));
    if (s.p[s.last].n > 0) {
        struct integral squarefree = exact_quotient(stock, s.p[0], s.p[s.last]);
        clear_chain(s);
        s = chain_of(stock, squarefree);
    }
    return s;
}

/* A place on the line, or one of its two ends. */
struct place {
    int infinite; /* -1, 0 or +1 */
    num_q x;
};

/* The sign of f at x = u/v: that of sum c[k] u^k v^(n-k), by Horner's rule. */
static int sign_at(struct integral f, struct place x)
{
    if (x.infinite != 0)
        return mpz_sgn(f.c[f.n]) * (x.infinite < 0 && f.n % 2 == 1 ? -1 : 1);
    mpz_t sum, power;
    mpz_init_set(sum, f.c[f.n]);
    mpz_init_set_ui(power, 1);
    for (int k = f.n - 1; k >= 0; k--) {
        mpz_mul(power, power, mpq_denref(x.x.at));
        mpz_mul(sum, sum, mpq_numref(x.x.at));
        mpz_addmul(sum, power, f.c[k]);
    }
    int s = mpz_sgn(sum);
    mpz_clear(sum), mpz_clear(power);
    return s;
}
static int variations(struct chain s, struct place x)
{
    int count = 0, last = 0;
    for (int k = 0; k <= s.last; k++) {
        int sign = sign_at(s.p[k], x);
        if (sign != 0) {
            count += sign == -last;
            last = sign;
        }
    }
    return count;
}

static int count(poly p, struct place a, struct place b)
{
    int empty = a.infinite == 0 && b.infinite == 0 && cagd_compare_q(a.x, b.x) > 0;
    if (cagd_poly_is_zero(p) || empty) {
        region_faults |= FAULT_UNDEFINED;
        return 0;
    }
    region_mark m = region_open();
    long n = cagd_poly_degree(p);
    struct stock stock = {cagd_region_array(n + 1, n + 7, sizeof(mpz_t)),
                          cagd_region_array(2, n + 2, sizeof(struct integral))};
    int difference = 0;
    if (stock.next != NULL && stock.chain != NULL) {
        struct chain s = sturm_chain(&stock, p);
        difference = variations(s, a) - variations(s, b);
        clear_chain(s);
    }
    region_drop(m);
    return difference;
}

static const struct place left_end = {.infinite = -1}, right_end = {.infinite = +1};

int cagd_sturm_count(poly p, num_q a, num_q b) { return count(p, (struct place){0, a}, (struct place){0, b}); }
int cagd_sturm_count_above(poly p, num_q a) { return count(p, (struct place){0, a}, right_end); }
int cagd_sturm_count_below(poly p, num_q b) { return count(p, left_end, (struct place){0, b}); }
int cagd_sturm_count_line(poly p) { return count(p, left_end, right_end); }
