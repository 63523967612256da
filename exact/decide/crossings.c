#include "exact/decide/crossings.h"

#include "exact/decide/roots.h"
#include "exact/words.h"

#include <stdlib.h>

static num_q line_at(struct cagd_line l, const num_q R[])
{
    return add_q(add_q(mul_q(l.a, R[0]), mul_q(l.b, R[1])), l.c);
}
static int no_line(struct cagd_line l)
{
    int fault = cagd_is_zero_q(l.a) && cagd_is_zero_q(l.b);
    region_faults |= fault ? FAULT_UNDEFINED : 0;
    return fault;
}

/* sum w_i c_i B_i^n(t), the c_i standing every second place. */
static poly weighted(int n, const num_q w[], const num_q c[])
{
    num_q *b = cagd_region_array(1, n + 1L, sizeof *b);
    if (b == NULL)
        return poly_constant(from_int_q(0));
    for (int i = 0; i <= n; i++)
        b[i] = mul_q(w[i], c[2 * i]);
    return poly_from_bernstein(n, b);
}

/* p without the factors that it shares with q. */
static poly without_common_roots(poly p, poly q)
{
    for (poly g = poly_gcd(p, q); cagd_poly_degree(g) > 0; g = poly_gcd(p, g))
        p = poly_quotient(p, g);
    return p;
}

/* With x = X/W, y = Y/W in lowest terms, a x + b y + c = g/W, g = a X + b Y + c W.  An affine point
 * is on the line where g = 0 and W != 0; near there W keeps its sign, so that it is g whose parity
 * counts.  The sign of g/W is that of g W: what changes there and not at such a point is a jump. */
struct cagd_curve_meets_line cagd_curve_meets_line(int n, const num_q R[], const num_q w[], struct cagd_line line)
{
    struct cagd_curve_meets_line m = {0};
    region_mark mark = region_open();
    poly W = poly_from_bernstein(n, w);
    if (no_line(line) || cagd_poly_is_zero(W)) {
        region_faults |= FAULT_UNDEFINED;
        region_drop(mark);
        return m;
    }
    poly X = weighted(n, w, R), Y = weighted(n, w, R + 1), common = poly_gcd(poly_gcd(X, Y), W);
    W = poly_quotient(W, common);
    poly g = poly_add(poly_scale(poly_quotient(X, common), line.a), poly_scale(poly_quotient(Y, common), line.b));
    g = poly_add(g, poly_scale(W, line.c));

    num_q zero = from_int_q(0), one = from_int_q(1);
    m.poles = cagd_count_roots(W, zero, one, CLOSED).distinct;
    m.contained = cagd_poly_is_zero(g);
    if (!m.contained) {
        poly affine = without_common_roots(g, W);
        struct cagd_root_count inside = cagd_count_roots(affine, zero, one, OPEN);
        m.common_closed = cagd_count_roots(affine, zero, one, CLOSED).distinct;
        m.common_open = inside.distinct;
        m.crossings = inside.crossings;
        m.touches = inside.touches;
        m.jumps = cagd_count_roots(poly_mul(g, W), zero, one, OPEN).crossings - m.crossings;
    }
    region_drop(mark);
    return m;
}

/* A part of the line: from one place to another, measured along the line. */
struct stretch {
    num_q from, to;
};
static int by_from(const void *p, const void *q)
{
    return cagd_compare_q(((const struct stretch *)p)->from, ((const struct stretch *)q)->from);
}

/* Connected components of the union. */
static int components(int count, struct stretch s[])
{
    int found = 0;
    qsort(s, (size_t)count, sizeof *s, by_from);
    for (int k = 0; k < count;) {
        num_q end = s[k].to;
        for (found++; k < count && cagd_compare_q(s[k].from, end) <= 0; k++)
            if (cagd_compare_q(s[k].to, end) > 0)
                end = s[k].to;
    }
    return found;
}

/* The place on the line of the foot of the point: (-b, a) is the line's direction. */
static num_q place(struct cagd_line l, const num_q R[]) { return sub_q(mul_q(l.a, R[1]), mul_q(l.b, R[0])); }

static struct stretch between(num_q p, num_q q)
{
    return cagd_compare_q(p, q) <= 0 ? (struct stretch){p, q} : (struct stretch){q, p};
}

struct cagd_polygon_meets_line cagd_polygon_meets_line(int n, const num_q R[], struct cagd_line line)
{
    struct cagd_polygon_meets_line m = {0};
    if (no_line(line))
        return m;
    region_mark mark = region_open();
    struct stretch *common = cagd_region_array(1, 2L * n + 1, sizeof *common);
    if (common == NULL)
        return m;
    int stretches = 0, last_sign = 0, s_before = 1;
    num_q value_before = {0}, place_before = {0};
    for (int i = 0; i <= n; i++) {
        num_q value = line_at(line, R + 2 * i), here = place(line, R + 2 * i);
        int s = cagd_sign_q(value), edge = i > 0;
        if (s == 0) {
            int from_line = edge && s_before == 0;
            common[stretches++] = between(from_line ? place_before : here, here);
            m.common_runs += !from_line;
            m.contained_edges += from_line && !cagd_equal_q(place_before, here);
        } else if (edge && s == -s_before) { /* the foot moves in proportion to the value */
            num_q ratio = div_q(value_before, sub_q(value_before, value));
            num_q hit = add_q(place_before, mul_q(ratio, sub_q(here, place_before)));
            common[stretches++] = between(hit, hit);
            m.common_runs++;
        }
        m.crossings += s != 0 && s == -last_sign;
        last_sign = s != 0 ? s : last_sign;
        s_before = s;
        value_before = value;
        place_before = here;
    }
    m.components = components(stretches, common);
    region_drop(mark);
    return m;
}

int cagd_polygon_crossings(int n, const num_q R[], struct cagd_line line)
{
    return cagd_polygon_meets_line(n, R, line).crossings;
}
