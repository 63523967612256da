/* test_hull.c -- convex hulls against Caratheodory's theorem and against the definitions. */
#include "unit_exact.h"

#include "exact/decide/hull.h"
#include "exact/words.h"

static num_q q(long m) { return from_int_q(m); }
static int same(const num_q P[], const num_q Q[]) { return cagd_equal_q(P[0], Q[0]) && cagd_equal_q(P[1], Q[1]); }

/* x on the segment P Q, also for P = Q. */
static int on_segment(const num_q P[], const num_q Q[], const num_q x[])
{
    num_q d = add_q(mul_q(sub_q(x[0], P[0]), sub_q(x[0], Q[0])), mul_q(sub_q(x[1], P[1]), sub_q(x[1], Q[1])));
    return cagd_turn_2d(P, Q, x) == 0 && cagd_sign_q(d) <= 0;
}
static int in_triangle(const num_q P[], const num_q Q[], const num_q R[], const num_q x[])
{
    int a = cagd_turn_2d(P, Q, x), b = cagd_turn_2d(Q, R, x), c = cagd_turn_2d(R, P, x);
    if (cagd_turn_2d(P, Q, R) == 0)
        return on_segment(P, Q, x) || on_segment(Q, R, x) || on_segment(R, P, x);
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}
/* Caratheodory: the hull is the union of the triangles. */
static int in_some_triangle(int count, const num_q P[], const num_q x[])
{
    int in = 0;
    for (int i = 0; i < count; i++)
        for (int j = 0; j <= i; j++)
            for (int k = 0; k <= j; k++)
                in |= in_triangle(P + 2 * i, P + 2 * j, P + 2 * k, x);
    return in;
}

static void plane_membership_is_caratheodory(void **state)
{
    (void)state;
    int inside = 0, outside = 0;
    for (int k = 0; k < 600; k++) {
        region_mark m = region_open();
        int count = random_int(1, 7), size = random_int(1, 4);
        num_q P[14], x[2];
        for (int i = 0; i < 2 * count; i++)
            P[i] = k % 2 ? coarse_q(size, 1) : coarse_q(9, 4);
        x[0] = coarse_q(3, k % 2 ? 1 : 5), x[1] = coarse_q(3, k % 2 ? 1 : 5);
        struct cagd_hull_certificate c = cagd_hull_membership(2, count, P, x);
        assert_int_equal(c.inside, in_some_triangle(count, P, x));
        assert_true(cagd_hull_certificate_holds(2, count, P, x, c));
        *(c.inside ? &inside : &outside) += 1;
        region_drop(m);
    }
    assert_true(inside > 50 && outside > 50);
}

/* A certificate is refused when one point, or one coefficient, does not do what it says, whichever it is. */
static void one_point_spoils_a_certificate(void **state)
{
    (void)state;
    num_q P[8] = {q(0), q(0), q(2), q(0), q(2), q(2), q(0), q(2)}, x[2] = {q(1), q(1)}, far[2] = {q(5), q(1)};
    num_q quarter[4], normal[2] = {q(1), q(0)};
    for (int j = 0; j < 4; j++)
        quarter[j] = from_ratio_q(1, 4);
    struct cagd_hull_certificate in = {.inside = 1, .coefficient = quarter, .offset = q(0)};
    struct cagd_hull_certificate out = {.inside = 0, .normal = normal, .offset = q(2)};
    assert_true(cagd_hull_certificate_holds(2, 4, P, x, in));
    assert_true(cagd_hull_certificate_holds(2, 4, P, far, out));
    assert_false(cagd_hull_certificate_holds(2, 4, P, x, out));
    for (int j = 0; j < 4; j++) {
        num_q moved[8], uneven[4];
        for (int m = 0; m < 8; m++)
            moved[m] = m == 2 * j ? q(3) : P[m];
        assert_false(cagd_hull_certificate_holds(2, 4, moved, far, out)); /* this point alone is beyond the line */
        assert_false(cagd_hull_certificate_holds(2, 4, moved, x, in));
        for (int m = 0; m < 4; m++)
            uneven[m] = m == j ? q(-1) : m == (j + 1) % 4 ? q(2) : q(0);
        num_q at[2];
        for (int c = 0; c < 2; c++)
            at[c] = sub_q(mul_q(q(2), P[2 * ((j + 1) % 4) + c]), P[2 * j + c]);
        in.coefficient = uneven; /* the point and the sum are right, one coefficient is negative */
        assert_false(cagd_hull_certificate_holds(2, 4, P, at, in));
        for (int m = 0; m < 4; m++)
            uneven[m] = m == j ? q(1) : q(0);
        assert_true(cagd_hull_certificate_holds(2, 4, P, P + 2 * j, in));
        uneven[(j + 1) % 4] = from_ratio_q(1, 9); /* the sum is not 1 */
        assert_false(cagd_hull_certificate_holds(2, 4, P, P + 2 * j, in));
        in.coefficient = quarter;
    }
    num_q on_it[2] = {q(2), q(7)};
    assert_false(cagd_hull_certificate_holds(2, 4, P, on_it, out)); /* a point on the line is not separated */
}

/* Is 0 in the hull of these ten points?  Every pivot but the last is degenerate; with the last instead of the first variable leaving
 * among equal ratios, a basis comes twice.  Found by random search in small integers, dimension 5. */
static void blands_rule_does_not_cycle(void **state)
{
    (void)state;
    static const int points[10][5] = {{-4, -9, 3, 3, 3}, {-1, 4, 8, -5, -8}, {-3, -3, 6, 9, 6}, {-5, 8, 0, -4, -3},
                                      {2, -8, 7, 9, -3}, {7, 9, -9, -1, 6},  {9, -2, -3, 8, 8}, {-9, -4, 5, 2, -3},
                                      {-6, 6, -4, 8, 5}, {4, 4, -2, -5, -3}};
    num_q P[50], x[5];
    for (int m = 0; m < 50; m++)
        P[m] = q(points[m / 5][m % 5]);
    for (int c = 0; c < 5; c++)
        x[c] = q(0);
    struct cagd_hull_certificate c = cagd_hull_membership(5, 10, P, x);
    assert_true(cagd_hull_certificate_holds(5, 10, P, x, c));
}

static void combinations_are_inside_in_every_dimension(void **state)
{
    (void)state;
    for (int d = 1; d <= 4; d++)
        for (int k = 0; k < 40; k++) {
            region_mark m = region_open();
            int count = random_int(1, 12);
            num_q P[48], x[4], sum = q(0), lambda[12], beyond[4];
            for (int i = 0; i < d * count; i++)
                P[i] = random_q();
            for (int j = 0; j < count; j++)
                sum = add_q(sum, lambda[j] = q(random_int(j == 0, 3)));
            num_q least = P[0];
            for (int i = 0; i < d; i++) {
                x[i] = q(0);
                for (int j = 0; j < count; j++) {
                    x[i] = add_q(x[i], div_q(mul_q(lambda[j], P[d * j + i]), sum));
                    if (i == 0 && cagd_compare_q(P[d * j], least) < 0)
                        least = P[d * j];
                }
                beyond[i] = i == 0 ? sub_q(least, from_ratio_q(1, 1000003)) : x[i];
            }
            struct cagd_hull_certificate in = cagd_hull_membership(d, count, P, x),
                                         out = cagd_hull_membership(d, count, P, beyond);
            assert_true(in.inside && cagd_hull_certificate_holds(d, count, P, x, in));
            assert_true(!out.inside && cagd_hull_certificate_holds(d, count, P, beyond, out));
            for (int i = 0; i < d; i++) { /* each coordinate counts */
                num_q moved[4], normal[4];
                for (int c = 0; c < d; c++) {
                    moved[c] = c == i ? add_q(x[c], from_ratio_q(1, 100)) : x[c];
                    normal[c] = q(c == i);
                }
                assert_false(cagd_hull_certificate_holds(d, count, P, moved, in));
                num_q most = P[i], above[4];
                for (int j = 1; j < count; j++)
                    most = cagd_compare_q(most, P[d * j + i]) < 0 ? P[d * j + i] : most;
                for (int c = 0; c < d; c++)
                    above[c] = c == i ? add_q(most, from_ratio_q(1, 100)) : x[c];
                struct cagd_hull_certificate axis = {.inside = 0, .normal = normal, .offset = most};
                assert_true(cagd_hull_certificate_holds(d, count, P, above, axis));
                assert_false(cagd_hull_certificate_holds(d, count, P, x, axis));
                axis.offset = sub_q(most, from_ratio_q(1, 100));
                assert_false(cagd_hull_certificate_holds(d, count, P, above, axis));
            }
            /* a certificate of the one proves nothing about the other */
            assert_false(cagd_hull_certificate_holds(d, count, P, beyond, in));
            assert_false(cagd_hull_certificate_holds(d, count, P, x, out));
            region_drop(m);
        }
    num_q x = q(0);
    assert_false(cagd_hull_membership(1, 0, NULL, &x).inside);
}

static void extreme_points_are_the_vertices(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        region_mark m = region_open();
        int count = random_int(1, 9), vertex[10], size = random_int(0, 3);
        num_q P[18], corner[20];
        for (int i = 0; i < 2 * count; i++)
            P[i] = k % 2 ? coarse_q(size, 1) : coarse_q(9, 4);
        int n = cagd_convex_hull_2d(count, P, vertex), extreme = 0;
        for (int j = 0; j < count; j++) { /* outside the hull of the points different from it */
            num_q others[18];
            int rest = 0, first = 1;
            for (int i = 0; i < count; i++)
                if (!same(P + 2 * i, P + 2 * j)) {
                    others[2 * rest] = P[2 * i], others[2 * rest + 1] = P[2 * i + 1];
                    rest++;
                } else if (i < j) {
                    first = 0;
                }
            extreme += first && !in_some_triangle(rest, others, P + 2 * j);
        }
        assert_int_equal(n, extreme);
        for (int i = 0; i < n; i++) {
            corner[2 * i] = P[2 * vertex[i]], corner[2 * i + 1] = P[2 * vertex[i] + 1];
            if (n > 2)
                assert_int_equal(
                    cagd_turn_2d(P + 2 * vertex[i], P + 2 * vertex[(i + 1) % n], P + 2 * vertex[(i + 2) % n]), 1);
        }
        for (int j = 0; j < count; j++) { /* the first one is the leftmost, and the lowest of these */
            int right = cagd_compare_q(P[2 * j], corner[0]), up = cagd_compare_q(P[2 * j + 1], corner[1]);
            assert_true(right > 0 || (right == 0 && up >= 0));
            assert_true(in_some_triangle(n, corner, P + 2 * j));
        }
        int orientation;
        assert_true(n == 2 || cagd_polygon_is_convex(n - 1, corner, 1, &orientation));
        assert_true(n <= 2 || orientation == 1);
        region_drop(m);
    }
}

static void false_certificates_are_refused(void **state)
{
    (void)state;
    num_q P[6] = {q(0), q(0), q(4), q(0), q(0), q(4)}, in[2] = {q(1), q(1)}, out[2] = {q(3), q(3)};
    num_q right[3] = {from_ratio_q(1, 2), from_ratio_q(1, 4), from_ratio_q(1, 4)};
    num_q affine[3] = {from_ratio_q(-1, 2), from_ratio_q(3, 4), from_ratio_q(3, 4)}; /* sum 1, one < 0 */
    num_q half[3] = {q(0), from_ratio_q(1, 4), from_ratio_q(1, 4)};                  /* sum 1/2        */
    num_q normal[2] = {q(1), q(1)};
    assert_true(cagd_hull_certificate_holds(2, 3, P, in, (struct cagd_hull_certificate){1, right, NULL, q(0)}));
    assert_false(cagd_hull_certificate_holds(2, 3, P, out, (struct cagd_hull_certificate){1, affine, NULL, q(0)}));
    assert_false(cagd_hull_certificate_holds(2, 3, P, in, (struct cagd_hull_certificate){1, half, NULL, q(0)}));
    assert_true(cagd_hull_certificate_holds(2, 3, P, out, (struct cagd_hull_certificate){0, NULL, normal, q(4)}));
    assert_false(cagd_hull_certificate_holds(2, 3, P, out, (struct cagd_hull_certificate){0, NULL, normal, q(6)}));
    assert_false(cagd_hull_certificate_holds(2, 3, P, in, (struct cagd_hull_certificate){0, NULL, normal, q(1)}));
}

/* The definition.  Without its repeated points the polygon Q_0 ... Q_m (closed: and back) must have
 * every edge on a supporting line, and no two of its edges may meet but in the vertex they share. */
static int segments_meet(const num_q A[], const num_q B[], const num_q C[], const num_q D[])
{
    int proper = cagd_turn_2d(A, B, C) * cagd_turn_2d(A, B, D) < 0 && cagd_turn_2d(C, D, A) * cagd_turn_2d(C, D, B) < 0;
    return proper || on_segment(A, B, C) || on_segment(A, B, D) || on_segment(C, D, A) || on_segment(C, D, B);
}
static int convex_by_definition(int n, const num_q R[], int closed)
{
    num_q Q[40];
    int m = 0;
    for (int i = 0; i <= n; i++)
        if (m == 0 || !same(Q + 2 * (m - 1), R + 2 * i)) {
            Q[2 * m] = R[2 * i], Q[2 * m + 1] = R[2 * i + 1];
            m++;
        }
    if (m > 1 && same(Q, Q + 2 * (m - 1))) { /* ends where it starts: closed in any case */
        closed = 1;
        m--;
    }
    if (m == 1)
        return 1;
    int edges = closed ? m : m - 1;
    for (int e = 0; e < edges; e++) {
        const num_q *A = Q + 2 * e, *B = Q + 2 * ((e + 1) % m);
        int left = 0, right = 0;
        for (int j = 0; j < m; j++) {
            left |= cagd_turn_2d(A, B, Q + 2 * j) > 0;
            right |= cagd_turn_2d(A, B, Q + 2 * j) < 0;
        }
        if (left && right)
            return 0;
        for (int f = e + 1; f < edges; f++) {
            const num_q *C = Q + 2 * f, *D = Q + 2 * ((f + 1) % m);
            int after = f == e + 1, before = closed && (f + 1) % m == e;
            if (after && before) /* a digon goes back */
                return 0;
            if (after    ? on_segment(A, B, D) || on_segment(C, D, A)
                : before ? on_segment(A, B, C) || on_segment(C, D, B)
                         : segments_meet(A, B, C, D))
                return 0;
        }
    }
    return 1;
}

static void convexity_is_its_definition(void **state)
{
    (void)state;
    int met[2][2] = {{0}};
    for (int k = 0; k < 6000; k++) {
        region_mark m = region_open();
        int n = random_int(0, 6), closed = random_int(0, 1), width = random_int(1, 3), height = random_int(0, 3);
        num_q R[14];
        for (int i = 0; i <= n; i++) {
            R[2 * i] = q(random_int(0, width));
            R[2 * i + 1] = q(random_int(0, height));
        }
        int orientation, convex = cagd_polygon_is_convex(n, R, closed, &orientation);
        assert_int_equal(convex, convex_by_definition(n, R, closed));
        met[closed][convex && orientation != 0]++;
        /* walked backwards it turns to the other side */
        num_q back[14];
        for (int i = 0; i <= n; i++)
            back[2 * i] = R[2 * (n - i)], back[2 * i + 1] = R[2 * (n - i) + 1];
        int reverse;
        assert_int_equal(cagd_polygon_is_convex(n, back, closed, &reverse), convex);
        assert_int_equal(reverse, -orientation);
        region_drop(m);
    }
    assert_true(met[0][1] > 100 && met[1][1] > 100 && met[0][0] > 100 && met[1][0] > 100);
    /* a pentagram turns always to the left, twice round */
    num_q star[10] = {q(0), q(3), q(2), q(-3), q(-3), q(1), q(3), q(1), q(-2), q(-3)};
    assert_false(cagd_polygon_is_convex(4, star, 1, NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(plane_membership_is_caratheodory), unit(one_point_spoils_a_certificate),
        unit(blands_rule_does_not_cycle),       unit(combinations_are_inside_in_every_dimension),
        unit(false_certificates_are_refused),   unit(extreme_points_are_the_vertices),
        unit(convexity_is_its_definition),
    };
    return run_unit_tests(tests);
}
