/* test_record.c -- what a trace notes, to the letter: the nodes of a computation, and the facts of every decision that testifies.
 *
 * The texts are what proofs-tests/recheck.py computes again; each was read against the list of nodes in exact/record/trace.h. */
#include "unit_exact.h"

#include "exact/number/field.h"
#include "exact/number/polynomial.h"
#include "exact/record/crossings.h"
#include "exact/record/hull.h"
#include "exact/record/number.h"
#include "exact/record/polynomial.h"
#include "exact/record/resultant.h"
#include "exact/record/roots.h"
#include "exact/record/sign.h"
#include "exact/record/sturm.h"
#include "exact/record/total_positivity.h"
#include "exact/record/trace.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PLENTY = 100000 };

enum { LEAST = -4, MOST = 9 };
static num_q whole[MOST - LEAST + 1];

/* Opens a trace whose first nodes are the integers -4, ..., 9 in this order, so that 0 is node 4. */
static void open_with_integers(void)
{
    cagd_trace_open(PLENTY);
    for (int k = 0; k <= MOST - LEAST; k++)
        whole[k] = from_int_q(k + LEAST);
}
static num_q q(int m) { return whole[m - LEAST]; }

/* The text without the bracket at its end and the line break. */
static void assert_list(const char *found, const char *expected)
{
    assert_non_null(found);
    size_t n = strlen(found);
    assert_true(n >= 3 && strcmp(found + n - 2, "]\n") == 0 && found[0] == '[');
    char *inside = malloc(n);
    snprintf(inside, n - 2, "%s", found + 1);
    assert_string_equal(inside, expected);
    free(inside);
}
/* What was noted since the trace was opened; the trace is closed. */
static void noted(const char *inputs, const char *nodes, const char *steps)
{
    assert_list(cagd_trace_inputs(), inputs);
    assert_list(cagd_trace_nodes(), nodes);
    assert_list(cagd_trace_steps(), steps);
    cagd_trace_close();
}

static int occurrences(const char *text, const char *word)
{
    int count = 0;
    for (; (text = strstr(text, word)) != NULL; text++)
        count++;
    return count;
}

static void arithmetic(void **state)
{
    (void)state;
    num_q before = from_ratio_q(5, 7);
    open_with_integers();
    num_q a = from_ratio_q(2, 3), b = q(-4), w = cagd_from_mpq_q(before.at);
    cagd_trace_input(w, "w", 3);
    num_q s = add_q(a, b), d = sub_q(s, a), p = mul_q(d, d), r = div_q(p, w), n = neg_q(r), x = root_q(2, q(9));
    /* while a trace is open, a sum with 0, a product with 1 and so on are nodes of their own */
    add_q(q(0), n), add_q(n, q(0)), sub_q(n, q(0)), mul_q(q(1), x), mul_q(x, q(1)), mul_q(q(0), x), mul_q(x, q(0));
    div_q(q(0), x), div_q(x, q(1));
    add_q(before, before);
    from_double_q(0.25), from_string_q("1e2");
    noted("[\"w3\",\"5/7\"]",
          "[\"c\",\"-4\"],[\"c\",\"-3\"],[\"c\",\"-2\"],[\"c\",\"-1\"],[\"c\",\"0\"],[\"c\",\"1\"],"
          "[\"c\",\"2\"],[\"c\",\"3\"],[\"c\",\"4\"],[\"c\",\"5\"],[\"c\",\"6\"],[\"c\",\"7\"],[\"c\",\"8\"],"
          "[\"c\",\"9\"],[\"c\",\"2/3\"],[\"x\",0],[\"+\",14,0],[\"-\",16,14],[\"*\",17,17],[\"/\",18,15],"
          "[\"neg\",19],[\"root\",13,2],[\"+\",4,20],[\"+\",20,4],[\"-\",20,4],[\"*\",5,21],[\"*\",21,5],"
          "[\"*\",4,21],[\"*\",21,4],[\"/\",4,21],[\"/\",21,5],[\"o\",\"5/7\"],[\"+\",31,31],[\"c\",\"1/4\"],"
          "[\"c\",\"100\"]",
          "");
}

static void functions_and_polynomials(void **state)
{
    (void)state;
    cagd_field_open(3);
    num_f old = div_f(variable_f("t"), add_f(variable_f("a"), from_int_f(1)));
    open_with_integers();
    num_f t = variable_f("t"), a = variable_f("a"), again = variable_f("t");
    num_f s = add_f(t, a), d = sub_f(s, again), m = mul_f(d, s), v = div_f(m, old), n = neg_f(v);
    num_f half = from_rational_f(from_ratio_q(1, 2)), zero = from_rational_f(q(0)), one = from_rational_f(q(1));
    add_f(n, half), add_f(n, zero), add_f(zero, n), sub_f(n, zero), mul_f(n, one), mul_f(one, n), mul_f(n, zero),
        mul_f(zero, n);
    div_f(zero, n), div_f(n, one);
    num_q c[2] = {q(1), q(2)};
    poly p = poly_from_q(2, c), b = poly_from_bernstein(1, c), x = poly_variable(), k = poly_constant(q(3));
    poly sum = poly_add(p, b), difference = poly_sub(sum, x), product = poly_mul(difference, p);
    poly_gcd(product, p), poly_quotient(product, p), poly_remainder(product, p), poly_compose(p, x);
    poly_neg(p), poly_derivative(p), poly_scale(p, c[1]);
    num_q value = poly_value(p, c[0]), coefficient = poly_coefficient(p, 1), out[2];
    poly_to_bernstein(p, 1, c[0], c[1], out);
    (void)k, (void)value, (void)coefficient;
    noted("[\"t\",\"307/51\"],[\"a\",\"680/13\"]",
          "[\"c\",\"-4\"],[\"c\",\"-3\"],[\"c\",\"-2\"],[\"c\",\"-1\"],[\"c\",\"0\"],[\"c\",\"1\"],"
          "[\"c\",\"2\"],[\"c\",\"3\"],[\"c\",\"4\"],[\"c\",\"5\"],[\"c\",\"6\"],[\"c\",\"7\"],[\"c\",\"8\"],"
          "[\"c\",\"9\"],[\"x\",0],[\"x\",1],[\"+\",14,15],[\"-\",16,14],[\"*\",17,16],[\"f\",\"t/(a+1)\"],"
          "[\"/\",18,19],[\"neg\",20],[\"c\",\"1/2\"],[\"+\",21,22],[\"+\",21,4],[\"+\",4,21],[\"-\",21,4],"
          "[\"*\",21,5],[\"*\",5,21],[\"*\",21,4],[\"*\",4,21],[\"/\",4,21],[\"/\",21,5],[\"poly\",5,6],"
          "[\"bernstein\",5,6],[\"c\",\"0\"],[\"c\",\"1\"],[\"poly\",35,36],[\"poly\",7],[\"p+\",33,34],"
          "[\"p-\",39,37],[\"p*\",40,33],[\"pgcd\",41,33],[\"pquo\",41,33],[\"prem\",41,33],"
          "[\"pcompose\",33,37],[\"pneg\",33],[\"pder\",33],[\"poly\",6],[\"p*\",33,48],[\"value\",33,5],"
          "[\"coefficient\",33,1],[\"tobernstein\",33,5,6,1,0],[\"tobernstein\",33,5,6,1,1]",
          "");
}

/* One after the other, every decision on small data. */
static void decisions(void **state)
{
    (void)state;
    num_q half = from_ratio_q(1, 2);
    open_with_integers();
    num_q c[3] = {q(-1), q(0), q(1)}; /* t^2 - 1 */
    poly p = poly_from_q(3, c);
    struct cagd_root out[2];
    struct cagd_root_count n = cagd_testify_count_roots(p, q(-1), q(1), CLOSED);
    assert_true(n.distinct == 2 && n.counted == 2 && n.crossings == 0 && n.touches == 0);
    assert_int_equal(cagd_testify_count_roots(p, q(-1), q(1), OPEN).distinct, 0);
    assert_int_equal(cagd_testify_count_roots(p, q(-1), q(1), OPEN_LEFT).distinct, 1);
    assert_int_equal(cagd_testify_count_roots(p, q(-1), q(2), OPEN_RIGHT).crossings, 1);
    assert_int_equal(cagd_testify_count_roots_line(p).distinct, 2);
    assert_int_equal(cagd_testify_count_roots_above(p, q(0)).distinct, 1);
    assert_int_equal(cagd_testify_count_roots_below(p, q(0)).distinct, 1);
    assert_int_equal(cagd_testify_isolate_roots(p, q(0), q(3), out, 2), 1);
    assert_int_equal(cagd_testify_sturm_count(p, q(0), q(1)), 1);
    assert_int_equal(cagd_testify_sturm_count_above(p, q(0)), 1);
    assert_int_equal(cagd_testify_sturm_count_below(p, q(5)), 2);
    assert_int_equal(cagd_testify_sturm_count_line(p), 2);
    assert_int_equal(cagd_testify_sign_on(p, q(2), q(3), CLOSED), SIGN_POSITIVE);
    assert_int_equal(cagd_testify_sign_on(p, q(1), q(3), OPEN_LEFT), SIGN_POSITIVE);
    assert_int_equal(cagd_testify_sign_on(p, q(1), q(3), OPEN_RIGHT), SIGN_NONNEGATIVE);
    assert_int_equal(cagd_testify_sign_on(p, q(-1), q(1), OPEN), SIGN_NEGATIVE);
    assert_int_equal(cagd_testify_is_nonnegative_on(p, q(1), q(3)), 1);
    assert_int_equal(cagd_testify_is_nonnegative_on(p, q(-1), q(3)), 0);
    assert_int_equal(cagd_testify_poly_degree(p), 2);
    assert_int_equal(cagd_testify_poly_is_zero(p), 0);
    assert_int_equal(cagd_testify_poly_equal(p, p), 1);
    poly square = poly_mul(p, p), nothing = poly_from_q(0, NULL);
    assert_int_equal(cagd_testify_poly_divides(p, square), 1);
    assert_int_equal(cagd_testify_poly_divides(square, p), 0);
    assert_int_equal(cagd_testify_poly_divides(nothing, p), 0);
    assert_int_equal(cagd_testify_poly_is_zero(nothing), 1);
    assert_int_equal(cagd_testify_poly_degree(nothing), -1);
    assert_int_equal(cagd_testify_poly_equal(p, square), 0);
    assert_int_equal(cagd_testify_sign_q(half), 1);
    assert_int_equal(cagd_testify_compare_q(half, q(1)), -1);
    assert_int_equal(cagd_testify_compare_q(q(7), half), 1);
    assert_int_equal(cagd_testify_equal_q(half, half), 1);
    assert_int_equal(cagd_testify_equal_q(half, c[0]), 0);
    assert_int_equal(cagd_testify_is_zero_q(c[1]), 1);
    assert_int_equal(cagd_testify_is_whole_q(half), 0);
    assert_int_equal(cagd_testify_is_whole_q(c[0]), 1);
    noted("",
          "[\"c\",\"-4\"],[\"c\",\"-3\"],[\"c\",\"-2\"],[\"c\",\"-1\"],[\"c\",\"0\"],[\"c\",\"1\"],"
          "[\"c\",\"2\"],[\"c\",\"3\"],[\"c\",\"4\"],[\"c\",\"5\"],[\"c\",\"6\"],[\"c\",\"7\"],[\"c\",\"8\"],"
          "[\"c\",\"9\"],[\"poly\",3,4,5],[\"p*\",14,14],[\"poly\"],[\"prem\",15,14],[\"prem\",14,15],"
          "[\"o\",\"1/2\"]",
          "{\"fact\":\"roots\",\"p\":14,\"from\":[3,5],\"with_ends\":[1,1],\"distinct\":2,\"counted\":2,\"crossings\":"
          "0,\"touches\":0},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[3,5],\"with_ends\":[0,0],\"distinct\":0,\"counted\":0,\"crossings\":"
          "0,\"touches\":0},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[3,5],\"with_ends\":[0,1],\"distinct\":1,\"counted\":1,\"crossings\":"
          "0,\"touches\":0},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[3,6],\"with_ends\":[1,0],\"distinct\":2,\"counted\":2,\"crossings\":"
          "1,\"touches\":0},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[-1,-1],\"with_ends\":[0,0],\"distinct\":2,\"counted\":2,"
          "\"crossings\":2,\"touches\":0},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[4,-1],\"with_ends\":[0,0],\"distinct\":1,\"counted\":1,\"crossings\":"
          "1,\"touches\":0},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[-1,4],\"with_ends\":[0,0],\"distinct\":1,\"counted\":1,\"crossings\":"
          "1,\"touches\":0},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[4,7],\"with_ends\":[1,1],\"distinct\":1},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[4,5],\"with_ends\":[0,1],\"distinct\":1},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[4,-1],\"with_ends\":[0,1],\"distinct\":1},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[-1,9],\"with_ends\":[0,1],\"distinct\":2},"
          "{\"fact\":\"roots\",\"p\":14,\"from\":[-1,-1],\"with_ends\":[0,1],\"distinct\":2},"
          "{\"fact\":\"sign\",\"p\":14,\"from\":[6,7],\"with_ends\":[1,1],\"is\":1},"
          "{\"fact\":\"sign\",\"p\":14,\"from\":[5,7],\"with_ends\":[0,1],\"is\":1},"
          "{\"fact\":\"sign\",\"p\":14,\"from\":[5,7],\"with_ends\":[1,0],\"is\":2},"
          "{\"fact\":\"sign\",\"p\":14,\"from\":[3,5],\"with_ends\":[0,0],\"is\":4},"
          "{\"fact\":\"sign\",\"p\":14,\"from\":[5,7],\"with_ends\":[1,1],\"is\":2},"
          "{\"fact\":\"sign\",\"p\":14,\"from\":[3,7],\"with_ends\":[1,1],\"is\":5},"
          "{\"fact\":\"degree\",\"of\":[14,-1],\"is\":2},{\"fact\":\"pequal\",\"of\":[14,-1],\"is\":0},"
          "{\"fact\":\"pequal\",\"of\":[14,14],\"is\":1},{\"fact\":\"pequal\",\"of\":[17,-1],\"is\":1},"
          "{\"fact\":\"pequal\",\"of\":[18,-1],\"is\":0},{\"fact\":\"pequal\",\"of\":[14,-1],\"is\":0},"
          "{\"fact\":\"pequal\",\"of\":[16,-1],\"is\":1},{\"fact\":\"degree\",\"of\":[16,-1],\"is\":-1},"
          "{\"fact\":\"pequal\",\"of\":[14,15],\"is\":0},{\"fact\":\"order\",\"of\":[19,-1],\"is\":1},"
          "{\"fact\":\"order\",\"of\":[19,5],\"is\":-1},{\"fact\":\"order\",\"of\":[11,19],\"is\":1},"
          "{\"fact\":\"equal\",\"of\":[19,19],\"is\":1},{\"fact\":\"equal\",\"of\":[19,3],\"is\":0},"
          "{\"fact\":\"equal\",\"of\":[4,-1],\"is\":1},{\"fact\":\"whole\",\"of\":[19,-1],\"is\":0},"
          "{\"fact\":\"whole\",\"of\":[3,-1],\"is\":1}");
}

static void planar(void **state)
{
    (void)state;
    open_with_integers();
    num_q P[8] = {q(0), q(0), q(4), q(0), q(4), q(4), q(0), q(4)}, x[2] = {q(1), q(2)}, far[2] = {q(5), q(9)};
    struct cagd_hull_certificate in = cagd_testify_hull_membership(2, 4, P, x),
                                 out = cagd_testify_hull_membership(2, 4, P, far);
    assert_true(in.inside && !out.inside);
    int orientation, vertex[5];
    assert_int_equal(cagd_testify_polygon_is_convex(3, P, 1, &orientation), 1);
    assert_int_equal(cagd_testify_polygon_is_convex(3, P, 0, &orientation), 1);
    assert_int_equal(cagd_testify_convex_hull_2d(4, P, vertex), 4);
    struct cagd_line line = {q(1), q(0), q(-1)};
    num_q w[3] = {q(1), q(1), q(1)};
    assert_int_equal(cagd_testify_curve_meets_line(2, P, w, line).crossings, 1);
    assert_int_equal(cagd_testify_polygon_meets_line(3, P, line).crossings, 2);
    assert_int_equal(cagd_testify_polygon_crossings(1, P, line), 1);
    num_q A[6] = {q(1), q(2), q(1), q(1), q(3), q(5)};
    assert_int_equal(cagd_testify_is_totally_nonnegative(2, 3, A), 1);
    assert_int_equal(cagd_testify_is_totally_positive(2, 3, A), 1);
    struct cagd_minor worst;
    assert_int_equal(cagd_testify_all_minors_nonnegative(3, 2, A, 0, &worst), 0);
    assert_int_equal(cagd_testify_all_minors_nonnegative(2, 2, A, 1, &worst), 0);
    assert_true(cagd_equal_q(cagd_testify_pivoted_determinant_q(2, A), q(-1)));
    num_q two[2] = {add_q(A[0], A[1])};
    two[1] = mul_q(A[1], A[2]);
    cagd_testify_operations(2, two, 1, 1, 0);
    noted("",
          "[\"c\",\"-4\"],[\"c\",\"-3\"],[\"c\",\"-2\"],[\"c\",\"-1\"],[\"c\",\"0\"],[\"c\",\"1\"],"
          "[\"c\",\"2\"],[\"c\",\"3\"],[\"c\",\"4\"],[\"c\",\"5\"],[\"c\",\"6\"],[\"c\",\"7\"],[\"c\",\"8\"],"
          "[\"c\",\"9\"],[\"o\",\"1/2\"],[\"o\",\"0\"],[\"o\",\"1/4\"],[\"o\",\"1/4\"],[\"o\",\"1\"],"
          "[\"o\",\"1\"],[\"o\",\"8\"],[\"o\",\"-1\"],[\"+\",5,6],[\"*\",6,5]",
          "{\"fact\":\"hull\",\"dim\":2,\"points\":[4,4,8,4,8,8,4,8],\"x\":[5,6],\"is\":1,\"coefficients\":[14,15,16,"
          "17]},"
          "{\"fact\":\"hull\",\"dim\":2,\"points\":[4,4,8,4,8,8,4,8],\"x\":[9,13],\"is\":0,\"normal\":[18,19],"
          "\"offset\":[20]},"
          "{\"fact\":\"convex_polygon\",\"points\":[4,4,8,4,8,8,4,8],\"closed\":1,\"orientation\":1,\"is\":1},"
          "{\"fact\":\"convex_polygon\",\"points\":[4,4,8,4,8,8,4,8],\"closed\":0,\"orientation\":1,\"is\":1},"
          "{\"fact\":\"hull_vertices\",\"points\":[4,4,8,4,8,8,4,8],\"vertices\":[0,1,2,3]},"
          "{\"fact\":\"curve_and_line\",\"R\":[4,4,8,4,8,8],\"w\":[5,5,5],\"line\":[5,4,3],\"is\":[0,1,1,1,0,0,0]},"
          "{\"fact\":\"polygon_and_line\",\"R\":[4,4,8,4,8,8,4,8],\"line\":[5,4,3],\"is\":[2,2,2,0]},"
          "{\"fact\":\"polygon_and_line\",\"R\":[4,4,8,4],\"line\":[5,4,3],\"is\":[1,1,1,0]},"
          "{\"fact\":\"minors\",\"rows\":2,\"columns\":3,\"A\":[5,6,5,5,7,9],\"strict\":0,\"is\":1},"
          "{\"fact\":\"minors\",\"rows\":2,\"columns\":3,\"A\":[5,6,5,5,7,9],\"strict\":1,\"is\":1},"
          "{\"fact\":\"minors\",\"rows\":3,\"columns\":2,\"A\":[5,6,5,5,7,9],\"strict\":0,\"is\":0},"
          "{\"fact\":\"minors\",\"rows\":2,\"columns\":2,\"A\":[5,6,5,5],\"strict\":1,\"is\":0},"
          "{\"fact\":\"determinant\",\"rows\":2,\"A\":[5,6,5,5],\"is\":[21]},"
          "{\"fact\":\"operations\",\"out\":[22,23],\"additions\":1,\"multiplications\":1,\"shifts\":0}");
}

/* An array of no elements may be NULL: the hull of no points, which is empty, and a matrix without rows. */
static void arrays_of_no_elements(void **state)
{
    (void)state;
    open_with_integers();
    num_q x[2] = {q(1), q(2)};
    assert_false(cagd_testify_hull_membership(2, 0, NULL, x).inside);
    assert_true(cagd_equal_q(cagd_testify_pivoted_determinant_q(0, NULL), q(1)));
    assert_int_equal(region_faults, 0);
    assert_true(cagd_trace_noting());
    const char *steps = cagd_trace_steps();
    assert_non_null(steps);
    assert_int_equal(occurrences(steps, "{\"fact\":\"hull\",\"dim\":2,\"points\":[],\"x\":[5,6],\"is\":0,"), 1);
    assert_int_equal(occurrences(steps, "{\"fact\":\"determinant\",\"rows\":0,\"A\":[],\"is\":["), 1);
    cagd_trace_close();
}

static void in_the_field(void **state)
{
    (void)state;
    cagd_field_open(2);
    cagd_trace_open(PLENTY);
    num_f t = variable_f("t"), a = variable_f("a"), r = mul_f(t, t);
    r = add_f(r, a);
    r = div_f(r, t);
    assert_int_equal(cagd_testify_has_degrees_f(r, t, 2, 1), 1);
    assert_int_equal(cagd_testify_has_degrees_f(r, t, 2, 0), 0);
    assert_int_equal(cagd_testify_has_degrees_f(r, t, 1, 1), 0);
    assert_int_equal(cagd_testify_is_zero_f(r), 0);
    assert_int_equal(cagd_testify_is_zero_f(sub_f(r, r)), 1);
    cagd_trace_same(0, 1, 0);
    cagd_trace_agree(1, "no fact since");
    cagd_testify_is_zero_f(a);
    cagd_trace_agree(0, "!is_zero_f(a)  &&\n    \"\\\"");
    cagd_testify_is_zero_f(a);
    cagd_trace_agree(1, NULL);
    cagd_trace_nonnegative(1, 1, "a", 1);
    cagd_trace_nonnegative(0, 0, NULL, 0);
    noted("[\"t\",\"307/51\"],[\"a\",\"680/13\"]",
          "[\"x\",0],[\"x\",1],[\"*\",0,0],[\"+\",2,1],[\"/\",3,0],[\"-\",4,4]",
          "{\"fact\":\"degrees\",\"of\":[4,0],\"is\":[2,1]},{\"fact\":\"degrees\",\"of\":[4,0],\"is\":[2,1]},"
          "{\"fact\":\"degrees\",\"of\":[4,0],\"is\":[2,1]},{\"fact\":\"equal\",\"of\":[4,-1],\"is\":0},"
          "{\"fact\":\"equal\",\"of\":[5,-1],\"is\":1},{\"same\":[0,1],\"equal\":false},{\"agree\":true},"
          "{\"fact\":\"equal\",\"of\":[1,-1],\"is\":0},{\"agree\":false,\"formula\":\"!is_zero_f(a) && \\\"\\\\\\\"\"},"
          "{\"fact\":\"equal\",\"of\":[1,-1],\"is\":0},{\"agree\":true},"
          "{\"nonnegative\":1,\"good\":true,\"text\":\"a\",\"sign\":1},{\"nonnegative\":0,\"good\":false}");
}

/* Decisions that are made of smaller ones note those; in which order the compiler evaluates operands is its own affair, and so is the
 * order of their nodes. */
static void made_of_smaller_decisions(void **state)
{
    (void)state;
    open_with_integers();
    num_q P[8] = {q(0), q(0), q(4), q(0), q(4), q(4), q(0), q(4)}, far[2] = {q(5), q(9)}, normal[2] = {q(1), q(0)};
    struct cagd_hull_certificate out = {.normal = normal, .offset = q(4)};
    assert_true(cagd_testify_hull_certificate_holds(2, 4, P, far, out));
    assert_int_equal(occurrences(cagd_trace_steps(), "\"order\""), 5); /* of every point, and of x */
    assert_int_equal(cagd_testify_turn_2d(P, P + 2, P + 4), 1);
    assert_int_equal(occurrences(cagd_trace_steps(), "\"order\""), 6);
    assert_int_equal(occurrences(cagd_trace_steps(), "\"is\":-1"), 3);
    assert_int_equal(occurrences(cagd_trace_steps(), "\"is\":0"), 2);
    assert_int_equal(occurrences(cagd_trace_steps(), "\"is\":1"), 1);
    cagd_trace_close();
    cagd_field_open(2);
    cagd_trace_open(PLENTY);
    num_f t = variable_f("t"), a = variable_f("a"), zero = from_int_f(0), p = sub_f(t, a);
    num_f M[4] = {zero, t, a, t}, det = cagd_testify_pivoted_determinant_f(2, M);
    assert_int_equal(occurrences(cagd_trace_steps(), "\"equal\""), 3); /* pivots: 0, a, and the last */
    num_f resultant = cagd_testify_resultant_by_f(p, t, t);
    assert_int_equal(occurrences(cagd_trace_steps(), "\"equal\""), 5);
    cagd_trace_close();
    assert_true(equal_f(det, neg_f(mul_f(a, t))));
    assert_true(equal_f(resultant, a));
}

/* A node is known by its value however many there are, and a slot that is used again has lost its old node. */
static void many_values(void **state)
{
    (void)state;
    enum { MANY = 6000 };
    static num_q x[MANY];
    cagd_trace_open(PLENTY);
    for (int k = 0; k < MANY; k++)
        x[k] = from_int_q(k);
    for (int k = 0; k < MANY; k++)
        neg_q(x[(k * 7919L) % MANY]);
    const char *at = cagd_trace_nodes();
    for (int k = 0; k < 2 * MANY; k++) {
        char node[40];
        if (k < MANY)
            snprintf(node, sizeof node, "[\"c\",\"%d\"]", k);
        else
            snprintf(node, sizeof node, "[\"neg\",%d]", (int)(((k - MANY) * 7919L) % MANY));
        at++; /* the bracket or the comma */
        assert_int_equal(strncmp(at, node, strlen(node)), 0);
        at += strlen(node);
    }
    assert_string_equal(at, "]\n");
    cagd_trace_close();
}

static void slots_that_are_used_again(void **state)
{
    (void)state;
    cagd_trace_open(PLENTY);
    num_q kept = from_int_q(1);
    region_mark m = region_open();
    from_int_q(2), from_int_q(3);
    region_drop(m);
    cagd_trace_pause();
    num_q five = from_int_q(5), six = from_int_q(6); /* where 2 and 3 were, and noted nowhere */
    cagd_trace_pause(), cagd_trace_resume();
    assert_false(cagd_trace_noting());
    cagd_trace_resume();
    assert_true(cagd_trace_noting());
    add_q(five, six), add_q(kept, six);
    assert_list(cagd_trace_nodes(),
                "[\"c\",\"1\"],[\"c\",\"2\"],[\"c\",\"3\"],[\"o\",\"5\"],[\"o\",\"6\"],[\"+\",3,4],[\"+\",0,4]");
    cagd_trace_again();
    kept = from_int_q(1);
    assert_list(cagd_trace_nodes(), "[\"c\",\"1\"]");
    cagd_trace_close();
    assert_null(cagd_trace_nodes());
    cagd_trace_close(), cagd_trace_again(), cagd_trace_pause(), cagd_trace_resume(); /* do nothing without a trace */
    assert_false(cagd_trace_noting());
    assert_null(cagd_trace_inputs());
    assert_null(cagd_trace_steps());
    assert_int_equal(cagd_trace_fact("order"), 0);
    cagd_testify_operations(0, NULL, 0, 0, 0);
}

/* Numbers and polynomials that were made while nothing was noted are literals where a fact first names them: in the order in which it
 * does. */
static void values_made_before(void **state)
{
    (void)state;
    num_q a[4], c[3] = {from_int_q(1), from_int_q(0), from_ratio_q(2, 3)};
    for (int m = 0; m < 4; m++)
        a[m] = from_int_q(m + 2);
    poly p = poly_from_q(3, c);
    cagd_trace_open(PLENTY);
    assert_int_equal(cagd_testify_poly_degree(p), 2);
    assert_int_equal(cagd_testify_is_totally_nonnegative(2, 2, a), 0);
    struct cagd_line line = {a[0], a[1], neg_q(a[3])};
    assert_int_equal(cagd_testify_polygon_crossings(1, a, line), 0);
    noted("", "[\"opoly\",\"1\",\"0\",\"2/3\"],[\"o\",\"2\"],[\"o\",\"3\"],[\"o\",\"4\"],[\"o\",\"5\"],[\"neg\",4]",
          "{\"fact\":\"degree\",\"of\":[0,-1],\"is\":2},"
          "{\"fact\":\"minors\",\"rows\":2,\"columns\":2,\"A\":[1,2,3,4],\"strict\":0,\"is\":0},"
          "{\"fact\":\"polygon_and_line\",\"R\":[1,2,3,4],\"line\":[1,2,5],\"is\":[0,0,0,0]}");
}

/* The last node that there is room for, and one more. */
/* What is computed with a polynomial that was made before the trace is noted, and so is what is computed after it. */
static void after_a_polynomial_made_before(void **state)
{
    (void)state;
    num_q c[] = {from_int_q(2), from_int_q(3)};
    poly before = cagd_poly_from_q(2, c);
    cagd_trace_open(PLENTY);
    poly twice = cagd_poly_add(before, before);
    cagd_poly_neg(twice);
    num_q five = from_int_q(5);
    add_q(five, five);
    assert_list(cagd_trace_nodes(), "[\"opoly\",\"2\",\"3\"],[\"p+\",0,0],[\"pneg\",1],[\"c\",\"5\"],[\"+\",3,3]");
    cagd_trace_close();
}

/* A variable whose name begins another one's is another variable. */
static void names_that_begin_others(void **state)
{
    (void)state;
    cagd_field_open(3);
    cagd_trace_open(PLENTY);
    num_f long_name = variable_f("ab"), short_name = variable_f("a");
    add_f(long_name, variable_f("ab")), add_f(short_name, long_name);
    assert_list(cagd_trace_nodes(), "[\"x\",0],[\"x\",1],[\"+\",0,0],[\"+\",1,0]");
    cagd_trace_close();
    cagd_field_open(1);
}

static void too_many_nodes(void **state)
{
    (void)state;
    cagd_trace_open(3);
    for (int k = 0; k < 3; k++)
        from_int_q(k);
    assert_int_equal(region_faults, 0);
    assert_true(cagd_trace_noting());
    region_faults = FAULT_UNDEFINED; /* another one stays */
    from_int_q(3);
    expect_fault(FAULT_UNABLE | FAULT_UNDEFINED);
    assert_false(cagd_trace_noting());
    assert_null(cagd_trace_nodes());
    assert_null(cagd_trace_inputs());
    assert_null(cagd_trace_steps());
    cagd_trace_pause(), cagd_trace_resume();
    assert_false(cagd_trace_noting()); /* it has given up for good */
    cagd_trace_close();
}

/* 128 names, of up to 15 bytes; each has its own value, positive and below 1000, the same in every trace. */
static void names_of_variables(void **state)
{
    (void)state;
    char name[24];
    cagd_field_open(FIELD_MAX_VARIABLES);
    cagd_trace_open(PLENTY);
    num_f last = {NULL};
    for (int v = 0; v < FIELD_MAX_VARIABLES; v++) {
        snprintf(name, sizeof name, "v%d", v);
        last = variable_f(name);
    }
    variable_f(name), neg_f(last);
    snprintf(name, sizeof name, ",[\"neg\",%d]]\n", FIELD_MAX_VARIABLES - 1);
    const char *nodes = cagd_trace_nodes(), *inputs = cagd_trace_inputs();
    assert_string_equal(nodes + strlen(nodes) - strlen(name), name);
    long values[FIELD_MAX_VARIABLES], top, bottom;
    int v = 0, read = 0;
    for (const char *at = inputs + 1; sscanf(at, "[\"%20[^\"]\",\"%ld/%ld\"]%n", name, &top, &bottom, &read) == 3;
         at += read + 1, v++) {
        assert_in_range(top, 1, 997);
        assert_in_range(bottom, 11, 99);
        values[v] = 1000 * top + bottom;
        for (int u = 0; u < v; u++)
            assert_int_not_equal(values[u], values[v]);
    }
    assert_int_equal(v, FIELD_MAX_VARIABLES);
    cagd_trace_close();
    cagd_field_open(1);
}

/* What was noted last, from its name on; the trace is closed. */
static void ends_with(const char *expected)
{
    const char *steps = cagd_trace_steps();
    assert_non_null(steps);
    size_t n = strlen(steps), m = strlen(expected);
    assert_true(n > m + 2);
    char *end = malloc(m + 1);
    snprintf(end, m + 1, "%s", steps + n - 2 - m);
    assert_string_equal(end, expected);
    free(end);
    cagd_trace_close();
}

/* How many numbers the list of that name has where it stands first. */
static int length_of(const char *steps, const char *name)
{
    const char *at = strstr(steps, name);
    assert_non_null(at);
    at = strchr(at, '[');
    int count = at[1] != ']';
    for (; *at != ']'; at++)
        count += *at == ',';
    return count;
}

/* A curve whose seven counts of a line are different: y = t (t - 1/4)(t - 1/2)(t - 3/4)^2 / W, and W has five simple roots and a double one. */
static void counts_that_differ(void **state)
{
    (void)state;
    enum { N = 8 };
    poly one = poly_constant(from_int_q(1)), Y = poly_variable(), W = one;
    static const int root_of_y[] = {2, 4, 6, 6}, root_of_w[] = {1, 3, 5, 7, 7};
    for (int k = 0; k < 4; k++)
        Y = poly_mul(Y, poly_sub(poly_variable(), poly_constant(from_ratio_q(root_of_y[k], 8))));
    for (int k = 0; k < 5; k++)
        W = poly_mul(W, poly_sub(poly_variable(), poly_constant(from_ratio_q(root_of_w[k], 8))));
    W = poly_mul(W, poly_sub(poly_variable(), poly_constant(from_ratio_q(1, 7))));
    W = poly_mul(W, poly_sub(poly_variable(), poly_constant(from_ratio_q(1, 9))));
    num_q x[N + 1], y[N + 1], w[N + 1], R[2 * N + 2], zero = from_int_q(0), unit = from_int_q(1);
    poly_to_bernstein(one, N, zero, unit, x);
    poly_to_bernstein(Y, N, zero, unit, y);
    poly_to_bernstein(W, N, zero, unit, w);
    for (int i = 0; i <= N; i++) {
        assert_false(cagd_is_zero_q(w[i]));
        R[2 * i] = div_q(x[i], w[i]), R[2 * i + 1] = div_q(y[i], w[i]);
    }
    struct cagd_line axis = {zero, unit, zero};
    cagd_trace_open(PLENTY);
    cagd_testify_curve_meets_line(N, R, w, axis);
    assert_int_equal(length_of(cagd_trace_steps(), "\"R\""), 2 * N + 2);
    ends_with("\"is\":[0,4,3,2,1,6,5]}");
    for (int i = 0; i <= N; i++)
        R[2 * i + 1] = zero;
    cagd_trace_open(PLENTY);
    cagd_testify_curve_meets_line(N, R, w, axis);
    ends_with("\"is\":[1,0,0,0,0,6,0]}");

    /* Along the axis from 0 to 2, up, to 5 and up again, through 7 to below, to 1, and below. */
    static const int corner[][2] = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {5, 0}, {6, 1}, {8, -1}, {1, 0}, {0, -1}};
    enum { CORNERS = sizeof corner / sizeof *corner };
    num_q P[2 * CORNERS];
    for (int i = 0; i < CORNERS; i++)
        P[2 * i] = from_int_q(corner[i][0]), P[2 * i + 1] = from_int_q(corner[i][1]);
    cagd_trace_open(PLENTY);
    assert_int_equal(cagd_testify_polygon_crossings(CORNERS - 1, P, axis), 1);
    ends_with("\"is\":[1,4,3,2]}");
    cagd_trace_open(PLENTY);
    struct cagd_polygon_meets_line meets = cagd_testify_polygon_meets_line(CORNERS - 1, P, axis);
    assert_true(meets.crossings == 1 && meets.common_runs == 4 && meets.components == 3 && meets.contained_edges == 2);
    ends_with("\"is\":[1,4,3,2]}");

    /* t^2 (t - 1/2)(t - 1)^3 (t - 2) from -1 to 2. */
    poly p = poly_mul(poly_variable(), poly_variable()), minus_one = poly_sub(poly_variable(), one);
    p = poly_mul(p, poly_mul(minus_one, poly_mul(minus_one, minus_one)));
    p = poly_mul(p, poly_sub(poly_variable(), poly_constant(from_ratio_q(1, 2))));
    p = poly_mul(p, poly_sub(poly_variable(), poly_constant(from_int_q(2))));
    cagd_trace_open(PLENTY);
    cagd_testify_count_roots(p, from_int_q(-1), from_int_q(2), CLOSED);
    ends_with("\"with_ends\":[1,1],\"distinct\":4,\"counted\":7,\"crossings\":2,\"touches\":1}");

    cagd_trace_open(PLENTY);
    num_q sum = add_q(unit, unit);
    cagd_testify_operations(1, &sum, 5, 3, 2);
    ends_with("\"additions\":5,\"multiplications\":3,\"shifts\":2}");
}

/* Every answer that a predicate of numbers has, of two numbers and of one and 0. */
static void every_answer(void **state)
{
    (void)state;
    num_q half = from_ratio_q(1, 2), minus = from_ratio_q(-1, 2), one = from_int_q(1), zero = from_int_q(0);
    const num_q of[] = {minus, zero, half, one};
    for (int i = 0; i < 4; i++) {
        static const char *const order[] = {"\"is\":-1}", "\"is\":0}", "\"is\":1}"};
        const int sign = (i > 1) - (i < 1);
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_sign_q(of[i]), sign);
        ends_with(order[1 + sign]);
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_is_zero_q(of[i]), i == 1);
        ends_with(order[1 + (i == 1)]);
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_is_whole_q(of[i]), i % 2);
        ends_with(order[1 + i % 2]);
        for (int j = 0; j < 4; j++) {
            cagd_trace_open(PLENTY);
            assert_int_equal(cagd_testify_compare_q(of[i], of[j]), (i > j) - (i < j));
            ends_with(order[1 + (i > j) - (i < j)]);
            cagd_trace_open(PLENTY);
            assert_int_equal(cagd_testify_equal_q(of[i], of[j]), i == j);
            ends_with(order[1 + (i == j)]);
        }
    }
    /* 0, p > 0, p >= 0, p <= 0, p < 0 and both, on [0,1]: of 0, 1, t, -t, -1, 2t - 1. */
    static const int c[][2] = {{0, 0}, {1, 0}, {0, 1}, {0, -1}, {-1, 0}, {-1, 2}};
    for (int is = 0; is < 6; is++) {
        char text[20];
        num_q a[2] = {from_int_q(c[is][0]), from_int_q(c[is][1])};
        poly p = poly_from_q(2, a);
        snprintf(text, sizeof text, "\"is\":%d}", is);
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_sign_on(p, zero, one, CLOSED), is);
        ends_with(text);
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_is_nonnegative_on(p, zero, one), is < 3);
        ends_with(text);
        /* a number that is not 0 divides every polynomial, and 0 divides 0 alone */
        poly two = poly_constant(from_int_q(2)), nothing = poly_from_q(0, NULL);
        assert_int_equal(cagd_testify_poly_divides(two, p), 1);
        assert_int_equal(cagd_testify_poly_divides(nothing, p), is == 0);
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_poly_divides(two, p), 1);
        ends_with("\"is\":1}");
    }
}

/* Points of one, two and three coordinates, inside and outside: the lists have as many numbers. */
static void hulls_of_every_dimension(void **state)
{
    (void)state;
    for (int d = 1; d <= 3; d++)
        for (int inside = 0; inside < 2; inside++) {
            enum { COUNT = 5 };
            num_q points[3 * COUNT], x[3];
            for (int m = 0; m < d * COUNT; m++)
                points[m] = from_int_q(m / d == m % d + 1 ? 8 : m / d == 4 ? -1 : 0);
            for (int i = 0; i < d; i++)
                x[i] = from_int_q(inside ? 1 : 9);
            char text[20];
            snprintf(text, sizeof text, "\"dim\":%d,", d);
            cagd_trace_open(PLENTY);
            struct cagd_hull_certificate c = cagd_testify_hull_membership(d, COUNT, points, x);
            assert_int_equal(c.inside, inside);
            const char *steps = cagd_trace_steps();
            assert_non_null(strstr(steps, text));
            assert_int_equal(length_of(steps, "\"points\""), d * COUNT);
            assert_int_equal(length_of(steps, "\"x\""), d);
            if (inside)
                assert_int_equal(length_of(steps, "\"coefficients\""), COUNT);
            else
                assert_int_equal(length_of(steps, "\"normal\""), d);
            cagd_trace_close();
        }
}

/* Polygons that turn to either side, lie on a line, or are not convex; whoever asks need not want to know the side. */
static void polygons_of_every_kind(void **state)
{
    (void)state;
    static const struct {
        int at[8];
        const char *closed, *open;
    } list[] = {
        {{0, 0, 2, 0, 2, 2, 0, 2},
         "\"closed\":1,\"orientation\":1,\"is\":1}",
         "\"closed\":0,\"orientation\":1,\"is\":1}"},
        {{0, 2, 2, 2, 2, 0, 0, 0},
         "\"closed\":1,\"orientation\":-1,\"is\":1}",
         "\"closed\":0,\"orientation\":-1,\"is\":1}"},
        {{0, 0, 1, 0, 2, 0, 3, 0},
         "\"closed\":1,\"orientation\":0,\"is\":0}",
         "\"closed\":0,\"orientation\":0,\"is\":1}"},
        {{0, 0, 2, 2, 2, 0, 0, 2},
         "\"closed\":1,\"orientation\":0,\"is\":0}",
         "\"closed\":0,\"orientation\":0,\"is\":0}"},
    };
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        num_q P[8];
        for (int m = 0; m < 8; m++)
            P[m] = from_int_q(list[k].at[m]);
        for (int closed = 0; closed <= 2; closed++) {
            cagd_trace_open(PLENTY);
            cagd_testify_polygon_is_convex(3, P, closed, NULL);
            ends_with(closed ? list[k].closed : list[k].open);
        }
    }
    /* the vertices of a triangle with a point inside and one on an edge, from the leftmost on */
    num_q T[10];
    static const int at[] = {4, 0, 1, 1, 0, 4, 2, 0, 0, 0};
    for (int m = 0; m < 10; m++)
        T[m] = from_int_q(at[m]);
    int vertex[6];
    cagd_trace_open(PLENTY);
    assert_int_equal(cagd_testify_convex_hull_2d(5, T, vertex), 3);
    assert_int_equal(length_of(cagd_trace_steps(), "\"points\""), 10);
    ends_with("\"vertices\":[4,0,2]}");
}

/* A determinant is of as many rows as are said, and all of its numbers are told; the worst minor is the one that is found without a
 * trace. */
static void matrices_of_every_size(void **state)
{
    (void)state;
    for (int n = 1; n <= 4; n++) {
        num_q A[16];
        char text[24];
        for (int m = 0; m < n * n; m++)
            A[m] = from_int_q(m % (n + 1) == 0 ? 2 : m % n == 0);
        snprintf(text, sizeof text, "\"rows\":%d,", n);
        cagd_trace_open(PLENTY);
        assert_true(cagd_equal_q(cagd_testify_pivoted_determinant_q(n, A), from_int_q(1L << n)));
        assert_non_null(strstr(cagd_trace_steps(), text));
        assert_int_equal(length_of(cagd_trace_steps(), "\"A\""), n * n);
        cagd_trace_close();
    }
    for (int strict = 0; strict < 2; strict++) {
        num_q A[2] = {from_int_q(1), from_int_q(strict ? 0 : -1)};
        struct cagd_minor worst = {0};
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_all_minors_nonnegative(1, 2, A, strict, &worst), 0);
        assert_true(worst.order == 1 && worst.row[0] == 0 && worst.column[0] == 1);
        assert_true(cagd_equal_q(worst.value, A[1]));
        ends_with(strict ? "\"strict\":1,\"is\":0}" : "\"strict\":0,\"is\":0}");
        num_q B[2] = {from_int_q(1), from_int_q(3)};
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_all_minors_nonnegative(1, 2, B, strict, NULL), 1);
        ends_with(strict ? "\"strict\":1,\"is\":1}" : "\"strict\":0,\"is\":1}");
        cagd_trace_open(PLENTY);
        assert_int_equal(cagd_testify_is_totally_positive(1, 2, A), 0);
        ends_with("\"strict\":1,\"is\":0}");
    }
}

/* Inputs are numbered from 0 on, or not at all. */
static void inputs_by_number(void **state)
{
    (void)state;
    num_q w = from_ratio_q(5, 7), huge = from_int_q(1);
    for (int k = 0; k < 2000; k++) /* more digits than there is room for at first */
        huge = mul_q(huge, from_int_q(10));
    cagd_trace_open(PLENTY);
    cagd_trace_input(w, "w", 0), cagd_trace_input(w, "w", 1), cagd_trace_input(w, "w", 12),
        cagd_trace_input(w, "w", -1);
    cagd_trace_input(neg_q(huge), "huge", 2), cagd_trace_input(div_q(w, huge), "small", 0);
    const char *inputs = cagd_trace_inputs(),
               *begin = "[[\"w0\",\"5/7\"],[\"w1\",\"5/7\"],[\"w12\",\"5/7\"],[\"w\",\"5/7\"],[\"huge2\",\"-1000";
    assert_int_equal(strncmp(inputs, begin, strlen(begin)), 0);
    const char *small = strstr(inputs, "000\"],[\"small0\",\"1/14000"); /* 5/(7 10^2000) */
    assert_non_null(small);
    assert_int_equal((long)(small - strstr(inputs, "-1000")), 2 + 2000 - 3);
    assert_int_equal(strlen(small), strlen("000\"],[\"small0\",\"1/14") + 1999 + strlen("\"]]\n"));
    cagd_trace_close();
}

/* The limit of nodes and the values of variables are those of before when everything begins anew. */
static num_q value_of(const char *name)
{
    return strcmp(name, "a") == 0                 ? from_ratio_q(-3, 5)
           : strcmp(name, "abcdefghijklmno") == 0 ? from_int_q(7)
                                                  : (num_q){NULL};
}
static void values_that_are_said(void **state)
{
    (void)state;
    cagd_trace_values(value_of); /* nothing without a trace */
    cagd_field_open(3);
    cagd_trace_open(9);
    cagd_trace_values(value_of);
    for (int round = 0; round < 3; round++) {
        num_f t = variable_f("t"), a = variable_f("a"), longest = variable_f("abcdefghijklmno");
        add_f(a, add_f(t, longest)), variable_f("a"), variable_f("abcdefghijklmno");
        assert_list(cagd_trace_inputs(), "[\"t\",\"307/51\"],[\"a\",\"-3/5\"],[\"abcdefghijklmno\",\"7\"]");
        assert_int_equal(region_faults, 0);
        cagd_trace_again();
    }
    for (int k = 0; k < 9; k++)
        from_int_q(k);
    assert_true(cagd_trace_noting());
    from_int_q(9);
    expect_fault(FAULT_UNABLE);
    assert_false(cagd_trace_noting());
    cagd_trace_again();
    assert_true(cagd_trace_noting());
    cagd_trace_close();
    cagd_trace_open(PLENTY); /* a new one knows no values */
    variable_f("a");
    assert_null(strstr(cagd_trace_inputs(), "-3/5"));
    cagd_trace_close();
    cagd_field_open(1);
}

/* A formula stands beside the first condition after facts alone; its blanks, letters beyond ASCII and line breaks. */
static void formulas_of_conditions(void **state)
{
    (void)state;
    num_q one = from_int_q(1);
    static const char *const written[][2] = {{"a", "a"},
                                             {"  a  ", " a"},
                                             {"a\t \n b", "a b"},
                                             {"\xcf\x89_0 > 0", "\xcf\x89_0 > 0"},
                                             {"s == \"\\\\\"", "s == \\\"\\\\\\\\\\\""},
                                             {"", ""}};
    for (size_t k = 0; k < sizeof written / sizeof *written; k++) {
        char text[80];
        cagd_trace_open(PLENTY);
        cagd_testify_is_zero_q(one), cagd_testify_is_zero_q(one);
        cagd_trace_agree(1, written[k][0]);
        cagd_trace_agree(1, "b");
        snprintf(text, sizeof text, "{\"agree\":true,\"formula\":\"%s\"},{\"agree\":true}", written[k][1]);
        ends_with(text);
    }
    cagd_trace_open(PLENTY);
    cagd_testify_is_zero_q(one);
    cagd_trace_same(0, 0, 1);
    cagd_trace_agree(1, "b");
    ends_with("{\"same\":[0,0],\"equal\":true},{\"agree\":true}");
    cagd_trace_open(PLENTY);
    cagd_testify_is_zero_q(one);
    cagd_trace_nonnegative(0, 0, "-a", -1);
    cagd_trace_agree(0, "b");
    ends_with("{\"nonnegative\":0,\"good\":false,\"text\":\"-a\",\"sign\":-1},{\"agree\":false}");
    /* a formula that is longer than there is room for at first */
    char formula[3000], *long_text = malloc(sizeof formula + 100);
    memset(formula, 'x', sizeof formula - 1), formula[sizeof formula - 1] = '\0';
    cagd_trace_open(PLENTY);
    cagd_testify_is_zero_q(one);
    cagd_trace_agree(1, formula);
    snprintf(long_text, sizeof formula + 100, ",\"formula\":\"%s\"}", formula);
    ends_with(long_text);
    free(long_text);
}

/* The first of many numbers, and a fact of many numbers, while tables and texts grow. */
static void the_first_of_many(void **state)
{
    (void)state;
    enum { MANY = 3000 };
    static num_q x[MANY];
    cagd_trace_open(PLENTY);
    for (int k = 0; k < MANY; k++) {
        cagd_trace_input(x[k] = from_ratio_q(k, 7), "x", k);
        if (k > 0 && (k & (k - 1)) == 0)
            cagd_testify_equal_q(x[0], x[k - 1]);
    }
    cagd_testify_operations(MANY, x, 0, 0, 0);
    assert_int_equal(length_of(cagd_trace_steps(), "\"out\""), MANY);
    const char *at = strstr(cagd_trace_steps(), "\"out\":[") + strlen("\"out\":[");
    for (int k = 0; k < MANY; k++) {
        char *end;
        assert_int_equal(strtol(at, &end, 10), 2 * k + 1);
        at = end + 1;
    }
    assert_null(strstr(cagd_trace_nodes(), "\"o\""));
    const char *steps = cagd_trace_steps();
    for (int k = 1; k < MANY; k *= 2) {
        char text[60];
        snprintf(text, sizeof text, "{\"fact\":\"equal\",\"of\":[1,%d],\"is\":%d}", 2 * k - 1, k == 1);
        assert_non_null(strstr(steps, text));
    }
    cagd_trace_close();
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(arithmetic),
                                       unit(functions_and_polynomials),
                                       unit(decisions),
                                       unit(planar),
                                       unit(arrays_of_no_elements),
                                       unit(in_the_field),
                                       unit(made_of_smaller_decisions),
                                       unit(many_values),
                                       unit(slots_that_are_used_again),
                                       unit(too_many_nodes),
                                       unit(names_of_variables),
                                       unit(values_made_before),
                                       unit(after_a_polynomial_made_before),
                                       unit(names_that_begin_others),
                                       unit(counts_that_differ),
                                       unit(every_answer),
                                       unit(hulls_of_every_dimension),
                                       unit(polygons_of_every_kind),
                                       unit(matrices_of_every_size),
                                       unit(inputs_by_number),
                                       unit(values_that_are_said),
                                       unit(formulas_of_conditions),
                                       unit(the_first_of_many)};
    return run_unit_tests(tests);
}
