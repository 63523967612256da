/* test_expression.c -- formulas as they are read, their values, and the signs of polynomials in boxes. */
#include "proofs-tests/unit/unit_exact.h"

#include "exact/expression/check.h"
#include "exact/expression/read.h"
#include "exact/words.h"

#include <stdio.h>
#include <string.h>

static cagd_scope scope;

static int define(const char *line)
{
    cagd_reading_error error;
    return cagd_read_definition(&scope, line, 0, (int)strlen(line), &error);
}
static void begin(void)
{
    scope = (cagd_scope){0};
    field_open(16);
    assert_true(define("B_i^n(t) = \\binom{n}{i} t^i (1-t)^{n-i}"));
    assert_true(define("x, y, P_i, Q_{ij} \\in \\mathbb{R}"));
    assert_true(define("\\mathbf{a} = (1, 2, 2)"));
    assert_true(define("\\mathbf{b}(t) = (t, 0, t^2)"));
    assert_true(define("s, \\mathrm{I} \\in \\text{labels}"));
    assert_true(define("Z_s(t) = t^2"));
    assert_true(define("w_i = 2i"));
    assert_true(define("\\kappa(t) = 2t"));
    assert_true(define("w_i^* = 3i"));
    assert_true(define("w_i^r(t) = 1 + r t^i"));
    assert_true(define("\\dot{Z}_{\\mathrm I}(t) = 5t"));
    assert_true(define("\\Delta Z_s(t) = Z_s(t+1) - Z_s(t)"));
    assert_true(define("\\Delta^2 Z_s(t) = \\Delta Z_s(t+1) - \\Delta Z_s(t)"));
}

static const cagd_tree *read_value(const char *text)
{
    cagd_reading_error error;
    const cagd_tree *t = cagd_read_value(&scope, text, 0, (int)strlen(text), &error);
    if (t == NULL)
        print_message("%s: %s\n", text, error.message);
    return t;
}

/* The value where x = 2/3 and y = -5. */
static cagd_value value_of(const char *text)
{
    static cagd_context c;
    const cagd_tree *t = read_value(text);
    assert_non_null(t);
    c = (cagd_context){.scope = &scope, .steps = CAGD_USUAL_STEPS, .in_field = 1};
    cagd_bind(&c, "x", cagd_value_q(from_ratio_q(2, 3)));
    cagd_bind(&c, "y", cagd_value_int(-5));
    return cagd_evaluate(&c, t);
}
static void has_value(const char *text, long p, long q)
{
    cagd_value v = value_of(text);
    if (region_faults != 0 || !v.rational || !cagd_equal_q(v.q, from_ratio_q(p, q)))
        fail_msg("%s = %s and not %ld/%ld", text, v.rational ? to_string_q(v.q) : "a function", p, q);
}

static void test_values(void **state)
{
    (void)state;
    begin();
    has_value("2+3\\cdot 4", 14, 1);
    has_value("-x^2", -4, 9);
    has_value("(-x)^2", 4, 9);
    has_value("1-2-3", -4, 1);
    has_value("3xy", -10, 1);
    has_value("1/2/2", 1, 4);
    has_value("\\frac{x}{y}", -2, 15);
    has_value("\\frac12 x", 1, 3);
    has_value("2^{3^2}", 512, 1);
    has_value("x^{-1}", 3, 2);
    has_value("0^0 + y^0", 2, 1);
    has_value("4! + 0!", 25, 1);
    has_value("\\binom{5}{2} + \\binom{5}{7} + \\binom{5}{-1} + \\binom{-2}{3}", 6, 1);
    has_value("\\sqrt{49} + \\sqrt[3]{8}", 9, 1);
    has_value("|y| + \\max(x, y) - \\min\\{x, y\\}", 32, 3);
    has_value("\\lfloor -7/2 \\rfloor + \\lceil x \\rceil", -3, 1);
    has_value("\\sum_{k=1}^4 k^2", 30, 1);
    has_value("\\sum_{1 \\le k < 4} k", 6, 1);
    has_value("\\sum_{k=0, k \\ne 2}^3 k", 4, 1);
    has_value("\\sum_{k=1}^0 k + \\prod_{k=1}^0 k", 1, 1);
    has_value("\\prod_{k=1}^3 (x+k) \\prod_{k=1}^2 k", 880 * 2, 27 * 2);
    has_value("\\sum_{k=0}^2 k + 1", 4, 1);
    has_value("\\begin{cases} 1 & x < 0 \\\\ 2 & 0 \\le x < 1, y < 0 \\\\ 3 & \\text{otherwise} \\end{cases}", 2, 1);
    has_value("B_1^3(x)", 2 * 3, 27);
    has_value("\\|\\mathbf a\\| + |2\\mathbf a| + \\|\\mathbf b(1)\\|^2", 11, 1);
    has_value("\\mathbf a \\cdot \\mathbf{b}(x) \\|\\mathbf a\\|^2", 14, 1);
    has_value("(\\mathbf a \\times \\mathbf b(y)) \\cdot \\mathbf b'(1) + (\\mathbf a, \\mathbf b(y), \\mathbf{b}'(1))",
              140, 1);
    has_value("[\\mathbf b(y)\\,\\mathbf b'(1)\\;\\mathbf a]", 70, 1);
    has_value("\\|\\sum_{k=1}^2 k (\\mathbf a - [1,\\frac12,k])\\|^2", 85, 4);
    has_value("w_1^2 + w_3^2(x) + w_1^{*2}", 394, 27);
    has_value("\\sum_{k=1}^2 k/\\sum_{k=1}^3 k + \\mathbf{0}", 1, 2);
    has_value("\\sin(2P_1) - 2\\sin P_1 \\cos P_1 + \\cos^2\\frac{P_2}2 + \\sin^2(-\\frac12 P_2)", 1, 1);
    has_value("\\begin{vmatrix} 0 & 2 \\\\ 3 & x \\end{vmatrix} + \\begin{vmatrix} 1 & 2 & 3 \\\\ 0 & y & 1 \\\\ 2 & 0 "
              "& 4 \\end{vmatrix}",
              8, 1);
    has_value("|-x^2 (1-x)|", 4, 27);
    has_value("Z_s(3) + \\dot Z_{\\mathrm{I}}(x) + \\Delta Z_s(y) + \\Delta^2Z_s(7)", 9 * 3 + 10 - 21, 3);
    has_value("B_1^3{}'(1/2) + (B_1^3)'(1) + B_1^{3\\prime\\prime}(0)", -3 - 48, 4);
    has_value("\\frac{d^2}{dx^2} x^3", 4, 1);
    has_value("\\int_0^1 B_2^4(x) dx", 1, 5);
    has_value("\\int_{-1}^3 (x^3 - x + 2) dx", 24, 1);
    has_value("\\begin{cases} 1 & 0 < x < 1/2 \\\\ 2 & 0 < x < 1 < 2 \\\\ 3 & \\text{otherwise} \\end{cases}", 2, 1);
    has_value("\\begin{cases} 1 & 0 < x < 1 < x \\\\ 2 & \\text{otherwise} \\end{cases}", 2, 1);
    has_value("2 − 3·x", 0, 1);
    field_close();
}

/* Every one of several counts, wherever it stands; numbers and lists at their ends; and every component. */
static void each_of_several_counts(void **state)
{
    (void)state;
    begin();
    has_value("\\max(9, 1, 2, 3) + \\max(1, 9, 2, 3) + \\max(1, 2, 9, 3) + \\max(1, 2, 3, 9) + \\max(9)", 45, 1);
    has_value("\\min(-9, 1, 2, 3) + \\min(1, -9, 2, 3) + \\min(1, 2, -9, 3) + \\min(1, 2, 3, -9) + \\min(9)", -27, 1);
    has_value("\\lceil 3 \\rceil + \\lceil -7/2 \\rceil + \\lfloor 3 \\rfloor + \\lfloor 7/2 \\rfloor", 6, 1);
    has_value(
        "\\lceil -3 \\rceil + \\lfloor -3 \\rfloor + \\lceil 0 \\rceil + \\lceil 1/9 \\rceil + \\lfloor 8/9 \\rfloor",
        -5, 1);
    has_value("\\sqrt[1]{x} + \\sqrt[3]{8} + \\sqrt{4/9} + \\sqrt[4]{16} + \\sqrt{0}", 16, 3);
    has_value("0! + 1! + 2! + 3!", 10, 1);
    has_value("\\binom{0}{0} + \\binom{5}{5} + \\binom{5}{0} + \\binom{5}{6} + \\binom{1/2}{2} + \\binom{-1}{3}", 15,
              8);
    has_value("\\begin{bmatrix} 4 \\\\ 2 \\end{bmatrix}_2 + {4 \\brack 0}_2 + {4 \\brack 4}_2 + {4 \\brack 5}_2 + {4 "
              "\\brack -1}_2 + {5 \\brack 4}_2",
              35 + 2 + 31, 1);
    has_value("[0]_2 + [1]_2 + [3]_2 + [3]_2! + [0]_2! + [5]_1 + [3]_{-1}", 0 + 1 + 7 + 21 + 1 + 5 + 1, 1);
    has_value("(-2)^{-3} + y^1 + 0^5 + 1^{-1} + (-1)^{1000} + (-1)^{999}", -33, 8);
    has_value("\\|\\mathbf a\\|^{-2} + \\|\\mathbf a\\|^4 + \\|\\mathbf a\\|^3 + \\|\\mathbf a\\|^0", 982, 9);
    /* conditions, the first, the last and all others; letters with one amount */
    has_value("\\sum_{k=0, k \\ne 1, k \\ne 2, k \\ne 4}^5 k", 8, 1);
    has_value("\\prod_{k=1, k \\ne 2, k \\ne 3, k \\ne 5}^6 k", 24, 1);
    has_value("\\max_{k=0, k \\ne 3, k < 3}^3 k + \\min_{k=0, k > 0, k \\ne 1}^3 k + \\max_{k=2}^2 k", 6, 1);
    has_value("\\sum_{i=0}^2 \\sum_{j=0}^i \\sum_{k=0}^j 1 + \\sum_{i,j,k=0}^1 1", 18, 1);
    has_value("\\sum_{i+j=3} i + \\sum_{i+j<2} 1 + \\sum_{i+j \\le 2} j + \\sum_{i+j+k=2} k + \\sum_{i+j+k \\le 1} 1",
              6 + 3 + 4 + 4 + 4, 1);
    has_value(
        "\\sum_{0 \\le i < j < k \\le 3} 1 + \\sum_{0 \\le i \\le j \\le k \\le 1} 1 + \\sum_{0 < i < j \\le k < 3} 1",
        4 + 4 + 1, 1);
    /* components, entries, and the rows and columns of determinants and inverses */
    has_value("|(3, 4)| + \\|(1, 1, 1, 1)\\| + (1, 2, 3, 4) \\cdot (1, 10, 100, 1000) + (1, 2) \\cdot (3, 4)",
              5 + 2 + 4321 + 11, 1);
    has_value("((1, 2, 4) \\times (3, 5, 7)) \\cdot (1, 0, 0)", -6, 1);
    has_value("((1, 2, 4) \\times (3, 5, 7)) \\cdot (0, 1, 0)", 5, 1);
    has_value("((1, 2, 4) \\times (3, 5, 7)) \\cdot (0, 0, 1)", -1, 1);
    has_value("\\begin{vmatrix} 0 & 0 & 0 & 2 \\\\ 3 & 0 & 0 & 0 \\\\ 0 & 5 & 0 & 0 \\\\ 0 & 0 & 7 & 0 \\end{vmatrix}",
              -210, 1);
    has_value("\\begin{vmatrix} 0 & 0 & 0 & 0 & 2 \\\\ 3 & 0 & 0 & 0 & 0 \\\\ 0 & 5 & 0 & 0 & 0 \\\\ 0 & 0 & 7 & 0 & 0 "
              "\\\\ 1 & 1 & 1 & 11 & 1 \\end{vmatrix}",
              2310, 1);
    has_value("\\begin{vmatrix} 1 & 0 & 0 & 0 & 0 & 9 \\\\ 0 & 2 & 0 & 0 & 0 & 0 \\\\ 0 & 0 & 3 & 0 & 0 & 0 \\\\ 0 & 0 "
              "& 0 & 5 & 0 & 0 \\\\ 0 & 0 & 0 & 0 & 7 & 0 \\\\ 1 & 0 & 0 & 0 & 0 & 10 \\end{vmatrix}",
              210, 1);
    assert_true(define(
        "M = \\begin{pmatrix} 1 & 2 & 0 \\\\ 0 & 1 & 3 \\\\ 1 & 0 & 1 \\end{pmatrix}")); /* its determinant is 7 */
    static const long given[3][3] = {{1, 2, 0}, {0, 1, 3}, {1, 0, 1}},
                      inverse[3][3] = {{1, -2, 6}, {3, 1, -3}, {-1, 2, 1}};
    static const char *const unit_vector[] = {"(1, 0, 0)", "(0, 1, 0)", "(0, 0, 1)"};
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 3; column++) {
            long square = 0, of_inverse = 0;
            for (int k = 0; k < 3; k++)
                square += given[row][k] * given[k][column], of_inverse += inverse[row][k] * inverse[k][column];
            const struct {
                const char *matrix;
                long p, q;
            } list[] = {{"M", given[row][column], 1}, {"M^T", given[column][row], 1},      {"M^0", row == column, 1},
                        {"M^2", square, 1},           {"M^{-1}", inverse[row][column], 7}, {"M^{-2}", of_inverse, 49}};
            for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
                char text[100];
                snprintf(text, sizeof text, "%s \\cdot (%s %s)", unit_vector[row], list[k].matrix, unit_vector[column]);
                has_value(text, list[k].p, list[k].q);
            }
        }
    /* orders of derivatives, places, ends of integrals */
    has_value("\\frac{d^0}{dx^0} x^4 + \\frac{d}{dx} x^4 + \\frac{d^3}{dx^3} x^4 + \\frac{d^4}{dx^4} x^4 + "
              "\\frac{d^5}{dx^5} x^4",
              16 + 96 + 16 * 81 + 24 * 81, 81);
    has_value("Z_s'(3) + Z_s''(3) + Z_s'''(3) + Z_s^{(0)}(3) + Z_s^{(2)}(3)", 6 + 2 + 0 + 9 + 2, 1);
    has_value("[x^2 y]_{x=3} + [x^2 y]_{x=1, y=2} + [x^2 y]_{(x,y)=(2,3)}", -45 + 2 + 12, 1);
    has_value("\\int_1^0 z \\, dz + \\int_2^2 z \\, dz + \\int_{-1}^1 z^3 \\, dz + \\int_{-2}^{-1} 1 \\, dz", 1, 2);
    /* every case, and every connective of a condition; x = 2/3, y = -5 */
    has_value(
        "\\begin{cases} 1 & x < 0 \\\\ 2 & x > 1 \\\\ 3 & y > 0 \\\\ 4 & y < 0 \\\\ 5 & \\text{otherwise} \\end{cases}",
        4, 1);
    has_value("\\begin{cases} 1 & x < 0 \\lor x > 1 \\lor y < 0 \\\\ 2 & \\text{otherwise} \\end{cases}", 1, 1);
    has_value("\\begin{cases} 1 & x > 0, x < 1, y > 0 \\\\ 2 & \\text{otherwise} \\end{cases}", 2, 1);
    has_value("\\begin{cases} 1 & \\neg(x < 0) \\\\ 2 & \\text{otherwise} \\end{cases}", 1, 1);
    has_value("\\begin{cases} 1 & x \\le 2/3 \\\\ 2 & \\text{otherwise} \\end{cases} + \\begin{cases} 10 & x < 2/3 "
              "\\\\ 20 & \\text{otherwise} \\end{cases}",
              21, 1);
    has_value("\\begin{cases} 1 & x \\ge 2/3 \\\\ 2 & \\text{otherwise} \\end{cases} + \\begin{cases} 10 & x > 2/3 "
              "\\\\ 20 & \\text{otherwise} \\end{cases}",
              21, 1);
    has_value("\\begin{cases} 1 & x = 2/3 \\\\ 2 & \\text{otherwise} \\end{cases} + \\begin{cases} 10 & x \\ne 2/3 "
              "\\\\ 20 & \\text{otherwise} \\end{cases}",
              21, 1);
    field_close();
}

/* Roots of numbers are multiples of one root each: whatever squares are in them are taken out, as often as they are. */
static void roots_of_numbers(void **state)
{
    (void)state;
    static const char *const zero[] = {"\\sqrt{50} - 5 \\sqrt{2}",
                                       "\\sqrt{32} - 4 \\sqrt{2}",
                                       "\\sqrt{\\frac{1}{2}} - \\frac{\\sqrt{2}}{2}",
                                       "\\sqrt{98} + \\sqrt{8} - 9 \\sqrt{2}",
                                       "\\sqrt{12} - 2 \\sqrt{3}",
                                       "\\sqrt{1458} - 27 \\sqrt{2}",
                                       "\\sqrt{2 \\cdot 997^2} - 997 \\sqrt{2}",
                                       "\\sqrt{\\frac{75}{49}} - \\frac{5 \\sqrt{3}}{7}",
                                       "\\sqrt{\\frac{2}{27}} - \\frac{\\sqrt{6}}{9}"},
                             *const other[] = {"\\sqrt{50} - 2 \\sqrt{5}", "\\sqrt{32} - 2 \\sqrt{2}",
                                               "\\sqrt{12} - \\sqrt{3}", "\\sqrt{2} - \\sqrt{3}"};
    begin();
    for (size_t k = 0; k < sizeof zero / sizeof *zero + sizeof other / sizeof *other; k++) {
        static cagd_context c;
        const int is_zero = k < sizeof zero / sizeof *zero;
        const cagd_tree *t = read_value(is_zero ? zero[k] : other[k - sizeof zero / sizeof *zero]);
        assert_non_null(t);
        c = (cagd_context){.scope = &scope, .steps = CAGD_USUAL_STEPS, .in_field = 1, .has_roots = 1};
        cagd_value v = cagd_evaluate(&c, t);
        assert_int_equal(region_faults, 0);
        assert_int_equal(cagd_value_is_zero(v), is_zero);
    }
    field_close();
}

/* Values that are none. */
static void test_no_values(void **state)
{
    (void)state;
    begin();
    static const struct {
        const char *text;
        unsigned fault;
    } none[] = {{"1/(x-2/3)", FAULT_UNDEFINED},
                {"0^{-1}", FAULT_UNDEFINED},
                {"(-1)!", FAULT_UNDEFINED},
                {"(1/2)!", FAULT_UNABLE},
                {"\\sin(\\kappa'(P_1))", FAULT_UNABLE},
                {"(-2)!", FAULT_UNDEFINED},
                {"\\max_{k=1}^0 k", FAULT_UNDEFINED},
                {"\\min_{k=0, k > 5}^2 k", FAULT_UNDEFINED},
                {"\\max_{k=0, k > 5}^2 k", FAULT_UNDEFINED},
                {"\\sqrt{-1}", FAULT_UNABLE},
                {"\\sqrt[0]{2}", FAULT_UNABLE},
                {"\\sqrt[-2]{4}", FAULT_UNABLE},
                {"\\sqrt[1/2]{4}", FAULT_UNABLE},
                {"Z_s^{(-1)}(3)", FAULT_UNABLE},
                {"\\frac{d^{-1}}{dx^{-1}} x^2", FAULT_UNABLE},
                {"[-1]_2", FAULT_UNABLE},
                {"[1/2]_2", FAULT_UNABLE},
                {"{-1 \\brack 0}_2", FAULT_UNABLE},
                {"\\begin{vmatrix} 1/(x-2/3) & 0 \\\\ 0 & 0 \\end{vmatrix}", FAULT_UNDEFINED},
                {"(1, 0) \\cdot (\\begin{pmatrix} 1 & 2 \\\\ 2 & 4 \\end{pmatrix}^{-1} (1, 0))", FAULT_UNDEFINED},
                {"x^{1/2}", FAULT_UNABLE},
                {"\\binom{3}{1/2}", FAULT_UNABLE},
                {"\\sqrt{2}", FAULT_UNABLE},
                {"\\cos\\frac{P_1}{3}", FAULT_UNABLE},
                {"\\sin P_1 + \\sin(\\pi P_1)", FAULT_UNABLE},
                {"\\sin 2", FAULT_UNABLE},
                {"2^{1001}", FAULT_UNABLE},
                {"\\sum_{k=0}^{1/2} k", FAULT_UNABLE},
                {"((((9^{999})^{999})^{999})^{999})^{999}", FAULT_UNABLE},
                {"\\begin{cases} 1 & x < 0 \\end{cases}", FAULT_UNDEFINED},
                {"P_{1/2}", FAULT_UNABLE},
                {"P_{P_1}", FAULT_UNABLE},
                {"\\frac{d^{x}}{dy^{x}} 2", FAULT_UNABLE},
                {"\\int_0^1 \\frac{1}{1+z} dz", FAULT_UNABLE},
                {"\\int_0^1 \\sqrt{2} dz", FAULT_UNABLE},
                {"\\frac{d}{dy} y^{1/2}", FAULT_UNABLE},
                {"\\sin(P_1/0)", FAULT_UNABLE},
                {"\\sin(P_1 P_2)", FAULT_UNABLE},
                {"\\sin P_{1/2}", FAULT_UNABLE},
                {"\\cos(P_1 + P_{1/2} + P_2)", FAULT_UNABLE},
                {"(\\sqrt{2})^2", FAULT_UNABLE},
                {"(\\sqrt{2})!", FAULT_UNABLE},
                {"\\binom{\\sqrt{2}}{2}", FAULT_UNABLE},
                {"\\sqrt{\\sqrt{2}}", FAULT_UNABLE},
                {"\\sqrt[x]{2}", FAULT_UNABLE},
                {"\\lfloor \\sqrt{2} \\rfloor", FAULT_UNABLE},
                {"\\lfloor P_1 \\rfloor", FAULT_UNABLE},
                {"\\sum_{k=0}^{\\sqrt{2}} k", FAULT_UNABLE},
                {"\\sum_{k=0}^{100001} k", FAULT_UNABLE},
                {"\\sum_{k=0, P_1 > k}^{2} k", FAULT_UNABLE},
                {"\\begin{cases} 1 & \\sqrt{2} < 1 \\\\ 2 & \\text{otherwise} \\end{cases}", FAULT_UNABLE},
                {"\\begin{cases} 1 & P_1 < 0 \\\\ 2 & \\text{otherwise} \\end{cases}", FAULT_UNABLE},
                {"\\begin{vmatrix} 1 & \\sqrt{2} \\\\ 1 & 1 \\end{vmatrix}", FAULT_UNABLE},
                {"\\max(1, \\sqrt{2})", FAULT_UNABLE},
                {"\\sqrt{P_1^2}", FAULT_UNABLE},
                {"\\max(P_1, 0)", FAULT_UNABLE},
                {"\\max_{0 \\le k \\le 2} P_k", FAULT_UNABLE}};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        value_of(none[k].text);
        if ((region_faults & none[k].fault) == 0)
            fail_msg("%s has a value", none[k].text);
        region_faults = 0;
    }
    assert_true(define("L_n = L_n + 1"));
    value_of("L_3");
    expect_fault(FAULT_UNABLE);
    field_close();
}

/* In the field: names without a value are variables, t and t_i are different ones, and indices are told apart. */
static void test_names(void **state)
{
    (void)state;
    begin();
    assert_true(define("t_i, t, \\hat{t}, t^* \\in \\mathbb{R}"));
    static const char *const different[] = {"t",   "t_0",    "t_1",    "t_{10}",  "\\hat t",
                                            "t^*", "Q_{12}", "Q_{21}", "Q_{1,1}", "P_{-1}"};
    int count = (int)(sizeof different / sizeof *different);
    for (int i = 0; i < count; i++)
        for (int j = 0; j < count; j++) {
            char text[80];
            snprintf(text, sizeof text, "%s - %s", different[i], different[j]);
            assert_int_equal(cagd_value_is_zero(value_of(text)), i == j);
        }
    assert_true(cagd_value_is_zero(value_of("P_{1+1} - P_2")));
    assert_true(cagd_value_is_zero(value_of("\\hat{t} - \\hat t")));
    assert_true(cagd_value_is_zero(value_of("\\sum_{i=0}^5 B_i^5(t) - 1")));
    assert_false(cagd_value_is_zero(value_of("\\sum_{i=0}^4 B_i^5(t) - 1")));
    field_close();
}

static void test_definitions(void **state)
{
    (void)state;
    begin();
    assert_true(define("F_0 = 0"));
    assert_true(define("F_1 = 1"));
    assert_true(define("F_n = F_{n-1} + F_{n-2}, \\quad n \\ge 2"));
    has_value("F_{12}", 144, 1);
    value_of("F_{-1}");
    expect_fault(FAULT_UNDEFINED);
    assert_true(define("F_n = 0"));
    has_value("F_{-1}", 0, 1);
    assert_false(define("F_n = 1")); /* there is nothing left */
    assert_false(define("F_n^k = 1"));
    assert_true(define("g(s;y) = s + y"));
    has_value("g(1)", -4, 1); /* the argument that is left out is the letter */
    has_value("g(1;2)", 3, 1);
    cagd_scope before = scope;
    assert_true(define("h = 7"));
    assert_null(cagd_defined(&before, "h"));
    assert_non_null(cagd_defined(&scope, "h"));
    assert_null(cagd_nearest(&scope, "v"));
    assert_string_equal(cagd_nearest(&scope, "\\hat{w}^*_"), "w^*_"); /* of equal letters the nearest */
    assert_string_equal(cagd_nearest(&scope, "P"), "P_");
    /* Cox and de Boor: 0/0 = 0, and 1/0 beside a factor 0 */
    value_of("0/0");
    expect_fault(FAULT_UNDEFINED);
    assert_true(define("0/0 = 0"));
    has_value("\\frac{0}{0} + \\frac{1}{0} \\cdot 0", 0, 1);
    value_of("\\frac{1}{0}");
    expect_fault(FAULT_UNDEFINED);
    field_close();
}

/* ---- words ----------------------------------------------------------------------------------------------- */

/* A scope in which the letters of the formulas below mean something. */
static void begin_words(void)
{
    cagd_reading_error error;
    static const char numbers[] = "n = 4, i = 2, j = 3, k = 1, m = 2, p = 2, r = 3";
    scope = (cagd_scope){0};
    field_open(16);
    assert_true(define("x, y, z_i, w_{ij} \\in \\mathbb{R}"));
    assert_true(define("\\mathbf{a}, \\mathbf{b} \\in \\mathbb{R}^3"));
    assert_true(define("A \\in \\mathbb{R}^{2 \\times 2}"));
    assert_true(define("F(t) = t^2"));
    assert_true(define("\\mathbf{u}, \\mathrm{u}, \\mathit{u}, \\mathcal{u}, \\mathsf{u} \\in \\mathbb{R}"));
    assert_true(cagd_read_ranges(&scope, numbers, 0, (int)strlen(numbers), &error));
}

/* The formula with the word in the place of each @. */
static const char *with_word(const char *formula, const char *word)
{
    char *text = region_bytes(strlen(formula) + 40 * (strlen(word) + 1) + 1);
    assert_non_null(text);
    *text = '\0';
    for (; *formula != '\0'; formula++)
        if (*formula == '@')
            strcat(text, word);
        else
            strncat(text, formula, 1);
    return text;
}

static const cagd_tree *statement_with(const char *formula, const char *word)
{
    cagd_reading_error error;
    const char *text = with_word(formula, word);
    const cagd_tree *t = cagd_read_statement(&scope, text, 0, (int)strlen(text), &error);
    if (t == NULL)
        fail_msg("%s: %s", text, error.message);
    return t;
}

/* What is written in several ways is one formula: every word that stands for another one, in a formula with both. */
static void every_word_is_what_it_stands_for(void **state)
{
    (void)state;
    static const struct {
        const char *formula, *plain, *word[36];
    } list[] = {
        {"x @ y", "\\le", {"\\leq", "\\leqslant", "\\leqq", "≤", "⩽", "≦", "\\ngtr", "\\not>", "{\\le}", "{}\\le{}"}},
        {"x @ y", "\\ge", {"\\geq", "\\geqslant", "\\geqq", "≥", "⩾", "≧", "\\nless", "\\not<", "{\\ge}"}},
        {"x @ y", "<", {"\\lt", "\\ngeq", "\\not\\ge", "{<}", "<{}"}},
        {"x @ y", ">", {"\\gt", "\\nleq", "\\not\\le", "{>}", ">{}"}},
        {"x @ y", "\\ne", {"\\neq", "≠", "\\not=", "{\\ne}"}},
        {"x @ y", "=", {"\\equiv", "≡", "\\not\\ne", "{=}", "={}", "\\stackrel{(1)}{=}", "\\overset{!}{=}"}},
        {"x @ [0,1] \\Rightarrow y = 1", "\\in", {"∈"}},
        {"x @ [0,1] \\Rightarrow y = 1", "\\notin", {"∉", "\\not\\in"}},
        {"1 + 2 + @ + n = x",
         "\\dots",
         {"\\ldots", "\\cdots", "\\dotsc", "\\dotsb", "\\dotsm", "\\dotso", "…", "⋯", "...", ".."}},
        {"@{x}{y} = 1", "\\frac", {"\\dfrac", "\\tfrac", "\\cfrac", "\\nicefrac", "\\sfrac"}},
        {"@{n}{k} = 1", "\\binom", {"\\dbinom", "\\tbinom"}},
        {"x @ y = 1", "*", {"\\cdot", "\\cdotp", "\\ast", "⋅", "∗", "·"}},
        {"\\mathbf a @ \\mathbf b = \\mathbf 0", "\\times", {"×"}},
        {"@ \\mathbf a @ = 1", "\\|", {"\\Vert", "‖"}},
        {"\\lVert \\mathbf a @ = 1", "\\|", {"\\rVert"}},
        {"@ x @ = 1", "|", {"\\vert"}},
        {"\\lvert x @ = 1", "|", {"\\rvert"}},
        {"\\forall l \\in \\{0, 1\\} @ l < 2", ":", {"\\colon"}},
        {"@ x + y \\} = 1", "\\{", {"\\lbrace"}},
        {"\\{ x + y @ = 1", "\\}", {"\\rbrace"}},
        {"@ x + y ] = 1", "[", {"\\lbrack"}},
        {"[ x + y @ = 1", "]", {"\\rbrack"}},
        {"x = 1 @ y = 1", "\\land", {"\\wedge", "∧"}},
        {"x = 1 @ y = 1", "\\lor", {"\\vee", "∨", "\\text{ or }", "\\mathrm{or}"}},
        {"@ (x = 1)", "\\neg", {"\\lnot", "¬"}},
        {"x = 1 @ y = 1",
         "\\Rightarrow",
         {"\\implies", "\\Longrightarrow", "⇒", "⟹", "\\text{ implies }", "\\text{ implies that }"}},
        {"x = 1 @ y = 1",
         "\\Leftarrow",
         {"\\impliedby",
          "\\Longleftarrow",
          "⇐",
          "⟸",
          "\\text{ if }",
          "\\text{ when }",
          "\\text{ whenever }",
          "\\text{ provided that }",
          "\\text{ provided }",
          "\\text{ where }",
          "\\text{ with }",
          "\\text{ as long as }",
          "\\text{ for }",
          "\\text{ for all }",
          "\\text{ for every }",
          "\\text{ for any }",
          "\\text{ for each }",
          "{\\rm if}",
          "\\mathrm{if}",
          "\\mathrm{when}",
          "\\mathrm{where}",
          "\\mathrm{for}",
          ", \\mbox{if}"}},
        {"x = 1 @ y = 1",
         "\\iff",
         {"\\Leftrightarrow", "\\Longleftrightarrow", "⇔", "⟺", "\\text{ if and only if }", "\\text{ iff }",
          "\\text{ exactly when }", "\\text{ is equivalent to }"}},
        {"@ x = 1 \\text{ then } y = 1",
         "\\text{if }",
         {"\\text{If }", "\\text{when }", "\\text{whenever }", "\\text{suppose }", "\\text{Suppose that }",
          "\\mathrm{if}"}},
        {"\\text{if } x = 1 @ y = 1",
         "\\text{ then }",
         {"\\text{ implies }", "\\text{, then }", "\\mathrm{then}", "\\Rightarrow"}},
        {"@ l \\in \\{0, 1\\}: l < 2", "\\forall", {"∀"}},
        {"@ l \\in \\{0, 1\\}: l < 2", "\\exists", {"∃"}},
        {"@_{l=0}^n z_l = 1", "\\sum", {"∑"}},
        {"@_{l=0}^n z_l = 1", "\\prod", {"∏"}},
        {"@_0^1 x \\, dx = 1", "\\int", {"∫"}},
        {"\\int_0^1 x \\, @ x = 1",
         "d",
         {"\\mathrm d", "\\mathrm{d}", "\\operatorname{d}", "\\text{d}", "\\textrm{d}", "{\\rm d}"}},
        {"\\frac{@}{@ x} x^2 = 1", "\\partial", {"∂"}},
        {"@{4} = x", "\\sqrt", {"√"}},
        {"@ x \\rfloor = 1", "\\lfloor", {"⌊"}},
        {"\\lfloor x @ = 1", "\\rfloor", {"⌋"}},
        {"@ x \\rceil = 1", "\\lceil", {"⌈"}},
        {"\\lceil x @ = 1", "\\rceil", {"⌉"}},
        {"@ \\mathbf a, \\mathbf b \\rangle = 1", "\\langle", {"⟨"}},
        {"\\langle \\mathbf a, \\mathbf b @ = 1", "\\rangle", {"⟩"}},
        {"x @ y = 1", "-", {"−"}},
        {"F@(x) = 1", "'", {"′", "^\\prime", "^{\\prime}", "{}'"}},
        {"x \\in [1, @) \\Rightarrow y = 1", "\\infty", {"∞", "+\\infty"}},
        {"x \\in (@, 1] \\Rightarrow y = 1", "-\\infty", {"-∞", "−\\infty"}},
        {"@ ( x + y ) = 1",
         "",
         {"\\left", "\\big", "\\Big", "\\bigg", "\\Bigg", "\\bigl", "\\Bigl", "\\biggl", "\\Biggl", "\\mleft",
          "\\displaystyle", "\\textstyle", "\\scriptstyle", "\\boxed", "\\ensuremath"}},
        {"( x + y @ ) = 1", "", {"\\right",     "\\bigr",
                                 "\\Bigr",      "\\biggr",
                                 "\\Biggr",     "\\mright",
                                 "\\relax",     "\\strut",
                                 "\\mathstrut", "\\bigm",
                                 "\\Bigm",      "\\biggm",
                                 "\\Biggm",     "\\middle",
                                 "\\smallskip", "\\medskip",
                                 "\\bigskip",   "\\nonumber",
                                 "\\notag",     "\\hline",
                                 "\\thinspace", "\\negthinspace",
                                 "\\medspace",  "\\thickspace",
                                 "\\enspace",   "\\enskip",
                                 "\\hfill",     "\\,",
                                 "\\;",         "\\:",
                                 "\\!",         "\\ ",
                                 "\\>"}},
        {"( x + y @ ) = 1",
         "",
         {"~",
          "\u00a0",
          "\u2002",
          "\u2003",
          "\u2009",
          "\u200a",
          "\u202f",
          "\u3000",
          "\\hspace{2em}",
          "\\hspace*{2em}",
          "\\vspace{2em}",
          "\\mspace{2mu}",
          "\\phantom{y}",
          "\\vphantom{y}",
          "\\hphantom{y}",
          "\\label{a}",
          "\\tag{2}",
          "\\tag*{2}",
          "\\noalign{2}",
          "\\color{red}",
          "\\underset{2}",
          "% y\n"}},
        {"\\sum@_{l=0}^n z_l = 1", "", {"\\limits", "\\nolimits", "\\displaylimits"}},
        {"\\begin{pmatrix} x @ y \\end{pmatrix} = (1, 2)", "\\\\", {"\\cr", "\\tabularnewline", "\\\\*", "\\\\[2mm]"}},
        {"\\begin{@} x & y \\\\ 1 & 2 \\end{@} = A", "pmatrix", {"bmatrix", "Bmatrix", "matrix", "smallmatrix"}},
        {"\\left(\\begin{array}@ x & y \\\\ 1 & 2 \\end{array}\\right) = A",
         "{cc}",
         {"{ll}", "{rr}", "{c|c}", "{@{}cc@{}}", "[t]{lr}", "{p{2cm}c}", "{*{2}c}"}},
        {"A^@ = A",
         "T",
         {"{T}", "t", "\\top", "{\\top}", "\\intercal", "{\\mathsf T}", "\\mathsf{T}", "{\\mathsf{T}}", "\\mathrm T",
          "\\mathit T", "\\mathtt T", "\\mathbf{T}", "{\\rm T}"}},
        {"\\begin{cases} x & x > 0 \\\\ y & @ \\end{cases} = 1",
         "\\text{otherwise}",
         {"\\text{else}", "\\text{elsewhere}", "\\text{in all other cases}", "\\text{in other cases}",
          "\\text{in the other cases}", "\\mbox{otherwise}", "\\hbox{otherwise}", "\\textrm{otherwise}",
          "\\textnormal{otherwise}", "\\textup{otherwise}", "\\textit{otherwise}", "\\mathrm{otherwise}",
          "\\mathit{otherwise}", "\\operatorname{otherwise}", "\\mathrm{else}", "\\mathrm{elsewhere}",
          "\\mathrm{otherwise.}", "{\\rm otherwise}"}},
        {"\\begin{cases} x & @ x > 0 \\\\ y & \\text{otherwise} \\end{cases} = 1",
         "",
         {"\\text{if }", "\\text{for }", "\\text{when }", "\\text{where }", "\\text{whenever }", "\\text{as }",
          "\\text{with }", "\\text{provided }", "\\text{provided that }", "\\text{for all }", "\\text{for every }",
          "\\text{for each }", "\\text{for any }", "\\mathrm{if}"}},
        {"\\begin{cases} x & x > 0 @ y > 0 \\\\ y & \\text{otherwise} \\end{cases} = 1",
         ",",
         {"\\text{ and }", "\\mathrm{and}", "\\land"}},
        {"\\begin{@} x & x > 0 \\\\ y & \\text{otherwise} \\end{@} = 1", "cases", {"dcases"}},
        {"\\left\\{ \\begin{@ x, & x > 0 \\\\ y, & \\text{otherwise} \\end{array} \\right. = 1",
         "array}{ll}",
         {"array}{lr}"}},
        {"@ x = 1", "\\sin", {"\\mathrm{sin}", "\\operatorname{sin}"}},
        {"@ x = 1", "\\cos", {"\\mathrm{cos}", "\\operatorname{cos}"}},
        {"@ x = 1", "\\tan", {"\\mathrm{tan}", "\\operatorname{tan}"}},
        {"@ x = 1", "\\cot", {"\\mathrm{cot}", "\\operatorname{cot}"}},
        {"@ A = 1", "\\det", {"\\mathrm{det}", "\\operatorname{det}"}},
        {"@(x, y) = 1", "\\max", {"\\mathrm{max}", "\\operatorname{max}"}},
        {"@(x, y) = 1", "\\min", {"\\mathrm{min}", "\\operatorname{min}"}},
        {"@ = 1", "\\mathbf{u}", {"{\\bf u}", "{\\bfseries u}", "\\mathbf u"}},
        {"@ = 1", "\\mathrm{u}", {"{\\rm u}", "\\mathrm u"}},
        {"@ = 1", "\\mathit{u}", {"{\\it u}", "\\mathit u"}},
        {"@ = 1", "\\mathcal{u}", {"{\\cal u}", "\\mathcal u"}},
        {"@ = 1", "\\mathsf{u}", {"{\\sf u}", "\\mathsf u"}},
        {"x^2 = x^2 @ x > 0, y > 0", "\\text{if }", {"\\text{whenever }", "\\text{provided that }"}},
        {"x = x \\text{ for } x > 0 @ y > 0",
         "\\text{ and }",
         {",", ";", "\\land", "\\text{ and all }", "\\text{ and for all }"}},
        {"n @ \\Rightarrow x = 1",
         "\\text{ even}",
         {"\\text{ is even}", "\\text{ be even}", "\\text{ are even}", "\\mathrm{even}"}},
        {"n @ \\Rightarrow x = 1",
         "\\text{ odd}",
         {"\\text{ is odd}", "\\text{ be odd}", "\\text{ are odd}", "\\mathrm{odd}"}},
        {"\\begin{@} x &= 1 \\\\ y &= 2 \\end{@}",
         "aligned",
         {"split", "equation", "align", "align*", "eqnarray", "gather", "gathered", "flalign", "multline", "cases",
          "dcases"}},
        {"\\begin{@ x &= 1 \\\\ y &= 2 \\end{alignedat}", "alignedat}{2}", {"alignedat}{1}"}},
        {"\\begin{@ x &= 1 \\\\ y &= 2 \\end{alignat}", "alignat}{2}", {"alignat}{1}"}},
    };
    begin_words();
    for (size_t k = 0; k < sizeof list / sizeof *list; k++) {
        const cagd_tree *plain = statement_with(list[k].formula, list[k].plain);
        for (int m = 0; m < 36 && list[k].word[m] != NULL; m++)
            if (!cagd_tree_equal(plain, statement_with(list[k].formula, list[k].word[m])))
                fail_msg("%s with %s is another formula than with %s", list[k].formula, list[k].word[m], list[k].plain);
    }
    field_close();
}

/* The space behind a row, in every unit, and as a multiple of a length, is no factor. */
static void spaces_behind_rows(void **state)
{
    (void)state;
    static const char *const written[] = {"2pt",
                                          "2mm",
                                          "-2cm",
                                          "1in",
                                          ".5ex",
                                          "0,5em",
                                          "2bp",
                                          "2pc",
                                          "2dd",
                                          "2cc",
                                          "2sp",
                                          "2mu",
                                          "2px",
                                          "2 mm",
                                          "\\jot",
                                          "2\\jot",
                                          "\\baselineskip",
                                          "\\normalbaselineskip",
                                          "\\smallskipamount",
                                          "\\medskipamount",
                                          "\\bigskipamount",
                                          "\\lineskip",
                                          "\\parskip"};
    static const char rows[] = "\\begin{aligned} x &= 1, @ y &= 2 \\end{aligned}";
    char text[60];
    begin_words();
    const cagd_tree *plain = statement_with(rows, "\\\\");
    for (size_t k = 0; k < sizeof written / sizeof *written; k++) {
        snprintf(text, sizeof text, "\\\\[%s]", written[k]);
        if (!cagd_tree_equal(plain, statement_with(rows, text)))
            fail_msg("%s is more than a space", text);
    }
    field_close();
}

/* Letters and digits that stand above or below the line in the source itself. */
static void scripts_of_the_source(void **state)
{
    (void)state;
    static const char *const above[][2] = {{"⁰", "0"}, {"¹", "1"}, {"²", "2"},   {"³", "3"},     {"⁴", "4"},
                                           {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"},   {"⁸", "8"},     {"⁹", "9"},
                                           {"ⁱ", "i"}, {"ʲ", "j"}, {"ᵏ", "k"},   {"ᵐ", "m"},     {"ⁿ", "n"},
                                           {"ᵖ", "p"}, {"ʳ", "r"}, {"⁻¹", "-1"}, {"ⁿ⁺¹", "n+1"}, {"²⁴", "24"}},
                             *const below[][2] = {{"₀", "0"}, {"₁", "1"},     {"₂", "2"},     {"₃", "3"},  {"₄", "4"},
                                                  {"₅", "5"}, {"₆", "6"},     {"₇", "7"},     {"₈", "8"},  {"₉", "9"},
                                                  {"ᵢ", "i"}, {"ⱼ", "j"},     {"ₖ", "k"},     {"ₘ", "m"},  {"ₙ", "n"},
                                                  {"ₚ", "p"}, {"ₙ₋₁", "n-1"}, {"ᵢ₊₁", "i+1"}, {"₁₂", "12"}};
    char text[40];
    begin_words();
    for (size_t k = 0; k < sizeof above / sizeof *above; k++) {
        snprintf(text, sizeof text, "x^{%s} = 1", above[k][1]);
        if (!cagd_tree_equal(statement_with(text, ""), statement_with("x@ = 1", above[k][0])))
            fail_msg("x%s is not x^{%s}", above[k][0], above[k][1]);
    }
    for (size_t k = 0; k < sizeof below / sizeof *below; k++) {
        snprintf(text, sizeof text, "z_{%s} = 1", below[k][1]);
        if (!cagd_tree_equal(statement_with(text, ""), statement_with("z@ = 1", below[k][0])))
            fail_msg("z%s is not z_{%s}", below[k][0], below[k][1]);
    }
    field_close();
}

/* Every letter of the Greek alphabet is the command for it, and is another one than its neighbour; so is a letter with another face. */
static void letters_and_faces(void **state)
{
    (void)state;
    static const char *const greek[][2] = {{"\\alpha", "α"},
                                           {"\\beta", "β"},
                                           {"\\gamma", "γ"},
                                           {"\\delta", "δ"},
                                           {"\\epsilon", "ε"},
                                           {"\\zeta", "ζ"},
                                           {"\\eta", "η"},
                                           {"\\theta", "θ"},
                                           {"\\iota", "ι"},
                                           {"\\kappa", "κ"},
                                           {"\\lambda", "λ"},
                                           {"\\mu", "μ"},
                                           {"\\nu", "ν"},
                                           {"\\xi", "ξ"},
                                           {"\\pi", "π"},
                                           {"\\rho", "ρ"},
                                           {"\\sigma", "σ"},
                                           {"\\tau", "τ"},
                                           {"\\upsilon", "υ"},
                                           {"\\phi", "φ"},
                                           {"\\chi", "χ"},
                                           {"\\psi", "ψ"},
                                           {"\\omega", "ω"},
                                           {"\\Gamma", "Γ"},
                                           {"\\Theta", "Θ"},
                                           {"\\Lambda", "Λ"},
                                           {"\\Xi", "Ξ"},
                                           {"\\Pi", "Π"},
                                           {"\\Sigma", "Σ"},
                                           {"\\Phi", "Φ"},
                                           {"\\Psi", "Ψ"},
                                           {"\\Omega", "Ω"},
                                           {"\\varphi", "ϕ"},
                                           {"\\vartheta", "ϑ"},
                                           {"\\ell", "ℓ"},
                                           {"\\epsilon", "\\varepsilon"},
                                           {"\\Delta", "Δ"},
                                           {"\\hat x", "\\widehat{x}"},
                                           {"\\tilde x", "\\widetilde{x}"},
                                           {"\\bar x", "\\overline{x}"}};
    static const char *const faces[] = {
        "\\hat",        "\\bar",      "\\tilde",   "\\dot",      "\\ddot",      "\\dddot",        "\\vec",
        "\\check",      "\\breve",    "\\mathbf",  "\\mathrm",   "\\mathit",    "\\mathcal",      "\\bm",
        "\\boldsymbol", "\\mathsf",   "\\mathbb",  "\\mathfrak", "\\underline", "\\operatorname", "\\acute",
        "\\grave",      "\\mathring", "\\mathscr", "\\mathtt",   "\\pmb",       "\\textbf"};
    enum { LETTERS = sizeof greek / sizeof *greek, FACES = sizeof faces / sizeof *faces };
    scope = (cagd_scope){0};
    field_open(16);
    for (int k = 0; k < LETTERS; k++)
        if (!define(with_word("@ \\in \\mathbb{R}", greek[k][0])))
            fail_msg("%s cannot be declared", greek[k][0]);
    for (int k = 0; k < LETTERS; k++) {
        const cagd_tree *t = statement_with("@ = 1", greek[k][0]);
        if (!cagd_tree_equal(t, statement_with("@ = 1", greek[k][1])))
            fail_msg("%s is not %s", greek[k][1], greek[k][0]);
        for (int m = 0; m < k; m++)
            if (strcmp(greek[k][0], greek[m][0]) != 0)
                assert_false(cagd_tree_equal(t, statement_with("@ = 1", greek[m][0])));
    }
    scope = (cagd_scope){0};
    for (int k = 0; k < FACES; k++)
        if (!define(with_word("@{v} \\in \\mathbb{R}", faces[k])))
            fail_msg("%s{v} cannot be declared", faces[k]);
    for (int k = 0; k < FACES; k++)
        for (int m = 0; m < k; m++)
            assert_false(cagd_tree_equal(statement_with("@{v} = 1", faces[k]), statement_with("@ v = 1", faces[m])));
    field_close();
}

/* What is told of words of the language, of functions without a backslash, and of those that are not computed: each of them. */
static void words_that_are_no_names(void **state)
{
    (void)state;
    static const struct {
        const char *formula, *told, *word[16];
    } list[] = {{"z_1 = 1 @ z_2",
                 "words stand in \\text{@}",
                 {"for", "if", "and", "or", "where", "with", "then", "when", "otherwise"}},
                {"z_1 = @ z_2",
                 "or is it \\@?",
                 {"sin", "cos", "tan", "max", "min", "det", "sum", "prod", "frac", "binom", "sqrt", "int"}},
                {"z_1 = \\@ z_2",
                 "is no rational function",
                 {"sec", "csc", "exp", "log", "ln", "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan"}},
                {"z_1 = \\@{z_2}", "of plain TeX: write \\begin{@}", {"cases", "matrix", "pmatrix"}},
                {"z_1 = \\eqalign{@}", "of plain TeX: write \\begin{aligned}", {"z_2"}}};
    scope = (cagd_scope){0};
    field_open(16);
    assert_true(define("z_i \\in \\mathbb{R}"));
    for (size_t k = 0; k < sizeof list / sizeof *list; k++)
        for (int m = 0; m < 16 && list[k].word[m] != NULL; m++) {
            cagd_reading_error error;
            const char *text = with_word(list[k].formula, list[k].word[m]),
                       *told = with_word(list[k].told, list[k].word[m]);
            assert_null(cagd_read_statement(&scope, text, 0, (int)strlen(text), &error));
            if (strstr(error.message, told) == NULL)
                fail_msg("%s: %s", text, error.message);
        }
    field_close();
}

/* The simplest number between two: none with a smaller denominator is between them. */
static void test_simplest(void **state)
{
    (void)state;
    for (int k = 0; k < 300; k++) {
        num_q a = coarse_q(60, 40), b = coarse_q(60, 40);
        int order = cagd_compare_q(a, b);
        if (order == 0)
            continue;
        num_q low = order < 0 ? a : b, high = order < 0 ? b : a, x = cagd_simplest_between(low, high);
        assert_true(cagd_compare_q(low, x) < 0 && cagd_compare_q(x, high) < 0);
        long least = mpz_get_si(mpq_denref(x.at));
        for (long q = 1; q < least; q++)
            for (long p = -61 * q; p <= 61 * q; p++) {
                num_q y = from_ratio_q(p, q);
                assert_false(cagd_compare_q(low, y) < 0 && cagd_compare_q(y, high) < 0);
            }
    }
}

static cagd_side_of_box side(const char *name, long low, long high, int open)
{
    return (cagd_side_of_box){variable_f(name), 1, 1, open, open, from_int_q(low), from_int_q(high)};
}

/* Random products of linear forms in two and three variables, against their values on a grid. */
static void test_signs_in_boxes(void **state)
{
    (void)state;
    int seen[3] = {0};
    for (int k = 0; k < 200; k++) {
        region_mark mark = region_open();
        field_open(4);
        int count = 1 + k % 3, rational;
        cagd_side_of_box s[] = {side("a", 0, 2, 0), side("b", -1, 1, 0), side("c", 0, 1, 0)};
        num_q point[3];
        num_f p = from_int_f(1);
        for (int m = 0; m < 2; m++) {
            num_f form = from_int_f(random_int(-2, 5));
            for (int v = 0; v < count; v++)
                form = add_f(form, mul_f(from_int_f(random_int(-2, 2)), s[v].variable));
            p = mul_f(p, k % 5 == 0 && m == 1 ? p : form);
        }
        cagd_answer answer = cagd_positive_in_box(p, 0, count, s, point, &rational);
        assert_int_equal(region_faults, 0);
        seen[answer]++;
        if (answer == CAGD_FAILS) {
            num_q value;
            num_f at = p;
            for (int v = 0; v < count; v++) {
                assert_true(cagd_is_inside(&s[v], point[v]));
                at = substitute_f(at, s[v].variable, from_rational_f(point[v]));
            }
            assert_true(is_constant_f(at, &value) && cagd_sign_q(value) < 0);
        }
        for (int g = 0; answer == CAGD_HOLDS && g < 125; g++) {
            num_q value;
            num_f at = p;
            for (int v = 0, i = g; v < count; v++, i /= 5) {
                num_q length = sub_q(s[v].high, s[v].low), x = add_q(s[v].low, mul_q(length, from_ratio_q(i % 5, 4)));
                at = substitute_f(at, s[v].variable, from_rational_f(x));
            }
            assert_true(is_constant_f(at, &value) && cagd_sign_q(value) >= 0);
        }
        field_close();
        region_drop(mark);
    }
    assert_true(seen[CAGD_HOLDS] > 20 && seen[CAGD_FAILS] > 20 && seen[CAGD_UNDECIDED] < 30);
}

/* For which parameters (c - 1) (c^2 - 2) + t >= 0 on [0,1]: those of [-sqrt 2, 1] and from sqrt 2 on. */
static void test_cells(void **state)
{
    (void)state;
    field_open(4);
    num_f t = variable_f("t"), c = variable_f("c"), one = from_int_f(1);
    num_f p = add_f(mul_f(sub_f(c, one), sub_f(mul_f(c, c), from_int_f(2))), t);
    cagd_side_of_box of_t = {t, 1, 1, 0, 0, from_int_q(0), from_int_q(1)}, all = {.variable = c};
    cagd_cells *cells = region_bytes(sizeof *cells);
    cagd_constraint constraint[] = {{.p = p, .demand = CAGD_AT_LEAST_ZERO, .t = of_t}};
    assert_true(cagd_cells_of(1, constraint, &all, cells));
    int changes = 0;
    for (int k = 0; k < cells->count; k++) {
        assert_false(cells->empty[k]);
        if (cells->cell[k] != cells->cell[k + 1]) {
            static const double expected[] = {-1.41421356, 1, 1.41421356};
            struct cagd_root r = cagd_equal_q(cells->root[k].lo, cells->root[k].hi)
                                     ? cells->root[k]
                                     : refine_root(cells->root[k], from_ratio_q(1, 1000000));
            double x = to_double_q(r.lo);
            assert_true(x - expected[changes] < 1e-5 && expected[changes] - x < 1e-5);
            assert_int_equal(cells->at[k], CAGD_HOLDS); /* closed */
            changes++;
        }
    }
    assert_int_equal(changes, 3);
    assert_int_equal(cells->cell[0], CAGD_FAILS);
    field_close();
}

int main(void)
{
    const struct CMUnitTest tests[] = {unit(test_values),
                                       unit(each_of_several_counts),
                                       unit(roots_of_numbers),
                                       unit(test_no_values),
                                       unit(test_names),
                                       unit(test_definitions),
                                       unit(test_simplest),
                                       unit(test_signs_in_boxes),
                                       unit(every_word_is_what_it_stands_for),
                                       unit(spaces_behind_rows),
                                       unit(scripts_of_the_source),
                                       unit(letters_and_faces),
                                       unit(words_that_are_no_names),
                                       unit(test_cells)};
    return run_unit_tests(tests);
}
