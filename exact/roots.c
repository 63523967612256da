#include "exact/roots.h"

/* A polynomial over an interval, up to a positive factor: the integers b_0 ... b_n of
 * sum b_i B_i^n(t), t running from 0 to 1 over the interval. */
struct ordinates {
    int n;
    mpz_t *b;
};

static struct ordinates new_ordinates(int n)
{
    struct ordinates f = {n, region_bytes((size_t)(n + 1) * sizeof(mpz_t))};
    for (int i = 0; i <= n; i++)
        mpz_init(f.b[i]);
    return f;
}
static void clear_ordinates(struct ordinates f)
{
    for (int i = 0; i <= f.n; i++)
        mpz_clear(f.b[i]);
}

static struct ordinates ordinates_over(poly p, num_q lo, num_q hi)
{
    int n = poly_degree(p);
    struct ordinates f = new_ordinates(n);
    num_q *b = region_bytes((size_t)(n + 1) * sizeof *b);
    poly_to_bernstein(p, n, lo, hi, b);
    mpz_t common;
    mpz_init_set_ui(common, 1);
    for (int i = 0; i <= n; i++)
        mpz_lcm(common, common, mpq_denref(b[i].at));
    for (int i = 0; i <= n; i++) {
        mpz_divexact(f.b[i], common, mpq_denref(b[i].at));
        mpz_mul(f.b[i], f.b[i], mpq_numref(b[i].at));
    }
    mpz_clear(common);
    return f;
}

/* Changes of sign in b_0 ... b_n, zeros skipped. */
static int variations(struct ordinates f)
{
    int count = 0, last = 0;
    for (int i = 0; i <= f.n; i++) {
        int s = mpz_sgn(f.b[i]);
        count += s * last < 0;
        last = s != 0 ? s : last;
    }
    return count;
}

static void remove_common_power_of_two(struct ordinates f)
{
    mp_bitcnt_t least = ~(mp_bitcnt_t)0;
    for (int i = 0; i <= f.n; i++)
        if (mpz_sgn(f.b[i]) != 0 && mpz_scan1(f.b[i], 0) < least)
            least = mpz_scan1(f.b[i], 0);
    for (int i = 0; i <= f.n; i++)
        mpz_tdiv_q_2exp(f.b[i], f.b[i], least);
}

/* De Casteljau at 1/2: f becomes the left half, the right half is returned.  Sums stand for means,
 * so that after r rounds everything is 2^r times too large; at the end, everything 2^n times. */
static struct ordinates halve(struct ordinates f)
{
    int n = f.n;
    struct ordinates right = new_ordinates(n);
    mpz_set(right.b[n], f.b[n]);
    for (int r = 1; r <= n; r++) {
        for (int i = n; i >= r; i--)
            mpz_add(f.b[i], f.b[i], f.b[i - 1]);
        mpz_set(right.b[n - r], f.b[n]);
    }
    for (int k = 0; k <= n; k++) {
        mpz_mul_2exp(f.b[k], f.b[k], (mp_bitcnt_t)(n - k));
        mpz_mul_2exp(right.b[k], right.b[k], (mp_bitcnt_t)k);
    }
    remove_common_power_of_two(f);
    remove_common_power_of_two(right);
    return right;
}

static num_q midpoint(num_q a, num_q b) { return mul_q(from_ratio_q(1, 2), add_q(a, b)); }

/* Roots found so far; only the first `room` are kept. */
struct findings {
    struct root *out;
    int room, found;
};
static void record(struct findings *all, num_q lo, num_q hi)
{
    if (all->found < all->room)
        all->out[all->found] = (struct root){.lo = lo, .hi = hi};
    all->found++;
}

/* The roots in the open interval (lo,hi) of a squarefree polynomial, from left to right.  The
 * ordinates are used up. */
static void search(struct findings *all, struct ordinates f, num_q lo, num_q hi)
{
    int bound = variations(f);
    if (bound < 2) {
        if (bound == 1)
            record(all, lo, hi);
        clear_ordinates(f);
        return;
    }
    struct ordinates right = halve(f);
    num_q middle = midpoint(lo, hi);
    int root_at_middle = mpz_sgn(right.b[0]) == 0;
    search(all, f, lo, middle);
    if (root_at_middle)
        record(all, middle, middle);
    search(all, right, middle, hi);
}

static int is_root(poly p, num_q t) { return is_zero_q(poly_value(p, t)); }

static int count_inside(poly squarefree, num_q lo, num_q hi)
{
    struct findings none = {0};
    region_mark m = region_open();
    search(&none, ordinates_over(squarefree, lo, hi), lo, hi);
    region_drop(m);
    return none.found;
}

/* No roots are asked for where there is no polynomial or no interval. */
static int undefined(poly p, num_q a, num_q b)
{
    int fault = poly_is_zero(p) || compare_q(a, b) > 0;
    region_faults |= fault ? FAULT_UNDEFINED : 0;
    return fault;
}

/* Yun's decomposition, in the region. */
struct squarefree {
    int count, *multiplicity;
    poly *factor;
};
static struct squarefree decompose(poly p)
{
    size_t n = (size_t)poly_degree(p);
    struct squarefree s = {0, region_bytes(n * sizeof(int)), region_bytes(n * sizeof(poly))};
    s.count = poly_squarefree(p, s.factor, s.multiplicity);
    return s;
}

struct root_count count_roots(poly p, num_q a, num_q b, enum ends ends)
{
    struct root_count total = {0};
    if (undefined(p, a, b))
        return total;
    int proper = compare_q(a, b) < 0;
    int with_left = ends == CLOSED || (ends == OPEN_RIGHT && proper);
    int with_right = proper && (ends == CLOSED || ends == OPEN_LEFT);
    region_mark m = region_open();
    struct squarefree s = decompose(p);
    for (int k = 0; k < s.count; k++) {
        poly f = s.factor[k];
        int inside = proper ? count_inside(f, a, b) : 0;
        int all = inside + (with_left && is_root(f, a)) + (with_right && is_root(f, b));
        total.distinct += all;
        total.counted += all * s.multiplicity[k];
        if (s.multiplicity[k] % 2 == 1)
            total.crossings += inside;
        else
            total.touches += inside;
    }
    region_drop(m);
    return total;
}

/* |c_{n-k}/c_n| < 2^e gives 2 |c_{n-k}/c_n|^(1/k) < 2^(1 + ceil(e/k)). */
num_q root_bound(poly p)
{
    int n = poly_degree(p);
    if (n < 1) {
        region_faults |= n < 0 ? FAULT_UNDEFINED : 0;
        return from_int_q(1);
    }
    long largest = 0;
    for (int k = 1; k <= n; k++) {
        num_q ratio = div_q(poly_coefficient(p, n - k), poly_coefficient(p, n));
        long e = (long)mpz_sizeinbase(mpq_numref(ratio.at), 2) - (long)mpz_sizeinbase(mpq_denref(ratio.at), 2) + 1;
        if (!is_zero_q(ratio) && e > 0 && (e + k - 1) / k > largest)
            largest = (e + k - 1) / k;
    }
    mpq_t bound;
    mpq_init(bound);
    mpq_set_ui(bound, 1, 1);
    mpq_mul_2exp(bound, bound, (mp_bitcnt_t)largest + 1);
    num_q B = from_mpq_q(bound);
    mpq_clear(bound);
    return B;
}

struct root_count count_roots_line(poly p)
{
    num_q B = root_bound(p);
    return count_roots(p, neg_q(B), B, OPEN);
}
struct root_count count_roots_above(poly p, num_q a)
{
    num_q B = root_bound(p);
    return count_roots(p, a, compare_q(a, B) < 0 ? B : a, OPEN);
}
struct root_count count_roots_below(poly p, num_q b)
{
    num_q B = neg_q(root_bound(p));
    return count_roots(p, compare_q(b, B) > 0 ? B : b, b, OPEN);
}

/* Which of the coprime factors has the root? */
static void attribute(struct root *r, struct squarefree s)
{
    int point = equal_q(r->lo, r->hi), k = 0;
    while (!(point ? is_root(s.factor[k], r->lo) : count_inside(s.factor[k], r->lo, r->hi) == 1))
        k++;
    r->factor = s.factor[k];
    r->multiplicity = s.multiplicity[k];
}

int isolate_roots(poly p, num_q a, num_q b, struct root out[], int room)
{
    if (undefined(p, a, b))
        return 0;
    struct squarefree s = decompose(p);
    poly radical = poly_constant(from_int_q(1));
    for (int k = 0; k < s.count; k++)
        radical = poly_mul(radical, s.factor[k]);

    struct findings all = {out, room, 0};
    if (is_root(radical, a))
        record(&all, a, a);
    if (compare_q(a, b) < 0) {
        search(&all, ordinates_over(radical, a, b), a, b);
        if (is_root(radical, b))
            record(&all, b, b);
    }
    for (int r = 0; r < all.found && r < room; r++)
        attribute(&out[r], s);
    return all.found;
}

/* The sign of f just above t, where f has at most a simple root at t. */
static int sign_above(poly f, num_q t)
{
    int s = sign_q(poly_value(f, t));
    return s != 0 ? s : sign_q(poly_value(poly_derivative(f), t));
}

struct root refine_root(struct root r, num_q width)
{
    if (sign_q(width) <= 0) {
        region_faults |= FAULT_UNDEFINED;
        return r;
    }
    int left = equal_q(r.lo, r.hi) ? 0 : sign_above(r.factor, r.lo);
    while (compare_q(sub_q(r.hi, r.lo), width) > 0) {
        num_q middle = midpoint(r.lo, r.hi);
        int s = sign_q(poly_value(r.factor, middle));
        if (s == left || s == 0)
            r.lo = middle;
        if (s != left)
            r.hi = middle;
    }
    return r;
}
