#include "exact/decide/roots.h"
#include "exact/words.h"

/* A polynomial over an interval, up to a positive factor: integers b_0 ... b_n, each within `slack`
 * of the true ordinate, of sum b_i B_i^n(t), t running from 0 to 1 over the interval.  Large integers
 * are cut to `bits` bits.  That is safe because means never enlarge an error; and where a sign is lost
 * in the slack, the ordinates are made again with twice as many bits.  No slack: they are exact. */
struct ordinates {
    int n;
    mp_bitcnt_t bits;
    mpz_t *b, slack;
};

/* Zeros; none, and n = -1, when there is no memory. */
static struct ordinates new_ordinates(int n, mp_bitcnt_t bits)
{
    struct ordinates f = {.n = n, .bits = bits, .b = cagd_region_array(1, n + 1L, sizeof(mpz_t))};
    if (f.b == NULL)
        f.n = -1;
    for (int i = 0; i <= f.n; i++)
        mpz_init(f.b[i]);
    mpz_init(f.slack);
    return f;
}
static void clear_ordinates(struct ordinates *f)
{
    for (int i = 0; i <= f->n; i++)
        mpz_clear(f->b[i]);
    mpz_clear(f->slack);
}

/* Divide by a power of two: by the common one while that is exact, and by as much as leaves `bits`
 * bits, each division rounding by less than 1. */
static void trim(struct ordinates *f)
{
    mp_bitcnt_t common = ~(mp_bitcnt_t)0, longest = 0;
    for (int i = 0; i <= f->n; i++)
        if (mpz_sgn(f->b[i]) != 0) {
            mp_bitcnt_t zeros = mpz_scan1(f->b[i], 0), length = mpz_sizeinbase(f->b[i], 2);
            common = zeros < common ? zeros : common;
            longest = length > longest ? length : longest;
        }
    int exact = mpz_sgn(f->slack) == 0;
    mp_bitcnt_t shift = longest > f->bits ? longest - f->bits : 0;
    if (exact && longest > 0 && common >= shift) {
        shift = common;
    } else if (shift > 0) {
        mpz_cdiv_q_2exp(f->slack, f->slack, shift);
        mpz_add_ui(f->slack, f->slack, 1);
    }
    for (int i = 0; i <= f->n; i++)
        mpz_fdiv_q_2exp(f->b[i], f->b[i], shift);
}

static struct ordinates ordinates_over(poly p, num_q lo, num_q hi, mp_bitcnt_t bits)
{
    int n = cagd_poly_degree(p);
    struct ordinates f = new_ordinates(n, bits);
    num_q *b = cagd_region_array(1, n + 1L, sizeof *b);
    if (f.n < n || b == NULL) {
        clear_ordinates(&f);
        return new_ordinates(-1, bits);
    }
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
    trim(&f);
    return f;
}

/* The sign of b_i as far as it is known: 0 when there is none, or when the slack hides it. */
static int known_sign(const struct ordinates *f, int i)
{
    return mpz_cmpabs(f->b[i], f->slack) > 0 ? mpz_sgn(f->b[i]) : 0;
}

/* Changes of sign in b_0 ... b_n, zeros and hidden signs skipped: with slack, a lower bound. */
static int variations(const struct ordinates *f)
{
    int count = 0, last = 0;
    for (int i = 0; i <= f->n; i++) {
        int s = known_sign(f, i);
        count += s * last < 0;
        last = s != 0 ? s : last;
    }
    return count;
}

static int hides_a_sign(const struct ordinates *f)
{
    int hidden = 0;
    for (int i = 0; i <= f->n; i++)
        hidden |= known_sign(f, i) == 0;
    return hidden && mpz_sgn(f->slack) != 0;
}

/* De Casteljau at 1/2: f becomes the left half, the right half is returned.  Sums stand for means,
 * so that after r rounds everything is 2^r times too large; at the end, everything 2^n times. */
static struct ordinates halve(struct ordinates *f)
{
    int n = f->n;
    struct ordinates right = new_ordinates(n, f->bits);
    if (right.n < n)
        return right;
    mpz_set(right.b[n], f->b[n]);
    for (int r = 1; r <= n; r++) {
        for (int i = n; i >= r; i--)
            mpz_add(f->b[i], f->b[i], f->b[i - 1]);
        mpz_set(right.b[n - r], f->b[n]);
    }
    for (int k = 0; k <= n; k++) {
        mpz_mul_2exp(f->b[k], f->b[k], (mp_bitcnt_t)(n - k));
        mpz_mul_2exp(right.b[k], right.b[k], (mp_bitcnt_t)k);
    }
    mpz_mul_2exp(f->slack, f->slack, (mp_bitcnt_t)n);
    mpz_set(right.slack, f->slack);
    trim(f);
    trim(&right);
    return right;
}

static num_q midpoint(num_q a, num_q b) { return mul_q(from_ratio_q(1, 2), add_q(a, b)); }

/* Roots found so far; only the first `room` are kept. */
struct findings {
    struct cagd_root *out;
    int room, found;
};
static void record(struct findings *all, num_q lo, num_q hi)
{
    if (all->found < all->room)
        all->out[all->found] = (struct cagd_root){.lo = lo, .hi = hi};
    all->found++;
}

static int is_root(poly p, num_q t) { return cagd_is_zero_q(poly_value(p, t)); }

/* The roots in the open interval (lo,hi) of a squarefree polynomial, from left to right.  f are its
 * ordinates there; they are used up. */
static void search(struct findings *all, poly p, struct ordinates f, num_q lo, num_q hi)
{
    while (variations(&f) < 2 && hides_a_sign(&f)) {
        mp_bitcnt_t more = 2 * f.bits;
        clear_ordinates(&f);
        f = ordinates_over(p, lo, hi, more);
    }
    int bound = variations(&f);
    if (bound < 2) {
        if (bound == 1)
            record(all, lo, hi);
        clear_ordinates(&f);
        return;
    }
    struct ordinates right = halve(&f);
    if (right.n < f.n) {
        clear_ordinates(&f), clear_ordinates(&right);
        return;
    }
    num_q middle = midpoint(lo, hi);
    int root_at_middle = known_sign(&right, 0) == 0 && is_root(p, middle);
    search(all, p, f, lo, middle);
    if (root_at_middle)
        record(all, middle, middle);
    search(all, p, right, middle, hi);
}

/* Four bits a degree to begin with: that many are cheap to carry, and making ordinates again is not. */
static void search_interval(struct findings *all, poly p, num_q lo, num_q hi)
{
    mp_bitcnt_t bits = 64 + 4 * (mp_bitcnt_t)cagd_poly_degree(p);
    search(all, p, ordinates_over(p, lo, hi, bits), lo, hi);
}

static int count_inside(poly squarefree, num_q lo, num_q hi)
{
    struct findings none = {0};
    region_mark m = region_open();
    search_interval(&none, squarefree, lo, hi);
    region_drop(m);
    return none.found;
}

/* No roots are asked for where there is no polynomial or no interval. */
static int undefined(poly p, num_q a, num_q b)
{
    int fault = cagd_poly_is_zero(p) || cagd_compare_q(a, b) > 0;
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
    int n = cagd_poly_degree(p);
    struct squarefree s = {0, cagd_region_array(1, n, sizeof(int)), cagd_region_array(1, n, sizeof(poly))};
    if (s.multiplicity != NULL && s.factor != NULL)
        s.count = poly_squarefree(p, s.factor, s.multiplicity);
    return s;
}

struct cagd_root_count cagd_count_roots(poly p, num_q a, num_q b, enum cagd_ends ends)
{
    struct cagd_root_count total = {0};
    if (undefined(p, a, b))
        return total;
    int proper = cagd_compare_q(a, b) < 0;
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
num_q cagd_root_bound(poly p)
{
    int n = cagd_poly_degree(p);
    if (n < 1) {
        region_faults |= n < 0 ? FAULT_UNDEFINED : 0;
        return from_int_q(1);
    }
    long largest = 0;
    for (int k = 1; k <= n; k++) {
        num_q ratio = div_q(poly_coefficient(p, n - k), poly_coefficient(p, n));
        long e = (long)mpz_sizeinbase(mpq_numref(ratio.at), 2) - (long)mpz_sizeinbase(mpq_denref(ratio.at), 2) + 1;
        if (!cagd_is_zero_q(ratio) && e > 0 && (e + k - 1) / k > largest)
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

/* Over (a,b), where NULL means infinity. */
static struct cagd_root_count count_without_bound(poly p, const num_q *a, const num_q *b)
{
    num_q B = root_bound(p), low = a != NULL ? *a : neg_q(B), high = b != NULL ? *b : B;
    if (a != NULL && cagd_compare_q(low, high) > 0)
        high = low;
    if (b != NULL && cagd_compare_q(low, high) > 0)
        low = high;
    return cagd_count_roots(p, low, high, OPEN);
}
struct cagd_root_count cagd_count_roots_line(poly p) { return count_without_bound(p, NULL, NULL); }
struct cagd_root_count cagd_count_roots_above(poly p, num_q a) { return count_without_bound(p, &a, NULL); }
struct cagd_root_count cagd_count_roots_below(poly p, num_q b) { return count_without_bound(p, NULL, &b); }

/* Which of the coprime factors has the root? */
static void attribute(struct cagd_root *r, struct squarefree s)
{
    int point = cagd_equal_q(r->lo, r->hi), k = 0;
    while (k < s.count && !(point ? is_root(s.factor[k], r->lo) : count_inside(s.factor[k], r->lo, r->hi) == 1))
        k++;
    if (k == s.count) { /* there was no memory to find out */
        r->factor = poly_constant(from_int_q(0));
        return;
    }
    r->factor = s.factor[k];
    r->multiplicity = s.multiplicity[k];
}

int cagd_isolate_roots(poly p, num_q a, num_q b, struct cagd_root out[], int room)
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
    if (cagd_compare_q(a, b) < 0) {
        search_interval(&all, radical, a, b);
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
    int s = cagd_sign_q(poly_value(f, t));
    return s != 0 ? s : cagd_sign_q(poly_value(poly_derivative(f), t));
}

struct cagd_root cagd_refine_root(struct cagd_root r, num_q width)
{
    if (cagd_sign_q(width) <= 0) {
        region_faults |= FAULT_UNDEFINED;
        return r;
    }
    int left = cagd_equal_q(r.lo, r.hi) ? 0 : sign_above(r.factor, r.lo);
    while (cagd_compare_q(sub_q(r.hi, r.lo), width) > 0) {
        num_q middle = midpoint(r.lo, r.hi);
        int s = cagd_sign_q(poly_value(r.factor, middle));
        if (s == left || s == 0)
            r.lo = middle;
        if (s != left)
            r.hi = middle;
    }
    return r;
}

num_q cagd_simplest_between(num_q a, num_q b)
{
    if (cagd_sign_q(a) < 0 && cagd_sign_q(b) > 0)
        return from_int_q(0);
    if (cagd_sign_q(a) < 0)
        return neg_q(cagd_simplest_between(neg_q(b), neg_q(a)));
    num_q whole = cagd_floor_q(a), next = add_q(whole, from_int_q(1)), above = sub_q(b, whole);
    if (cagd_compare_q(next, b) < 0)
        return next;
    if (cagd_equal_q(a, whole)) /* whole + 1/n */
        return add_q(whole, div_q(from_int_q(1), add_q(cagd_floor_q(div_q(from_int_q(1), above)), from_int_q(1))));
    return add_q(whole, div_q(from_int_q(1), cagd_simplest_between(div_q(from_int_q(1), above),
                                                                   div_q(from_int_q(1), sub_q(a, whole)))));
}
