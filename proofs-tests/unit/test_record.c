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
                                       unit(names_that_begin_others)};
    return run_unit_tests(tests);
}
