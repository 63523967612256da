/* test_svg.c -- the canvas, read back from its documents with libxml2 and judged with exact rationals. */
#include "unit_exact.h"

#include "exact/kernels_q.h"
#include "exact/words.h"
#include "figures/svg.h"

#include <libxml/parser.h>
#include <libxml/xpath.h>
#include <libxml/xpathInternals.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static num_q q(long m) { return from_int_q(m); }
static num_q r(long m, long n) { return from_ratio_q(m, n); }

/* ---- Reading a document ----------------------------------------------------------------------- */

/* A figure of one panel whose output units are those of the world: (x, y) is drawn at (x, side - y). */
static svg *square(int side)
{
    svg *s = svg_new("test", "Title", "Description");
    svg_panel(s, svg_integer_window(0, 0, side, side), side, 0, NULL);
    return s;
}

static xmlDocPtr parsed(svg *s)
{
    const char *text = svg_text(s);
    assert_null(svg_failed(s));
    assert_non_null(text);
    xmlDocPtr document = xmlReadMemory(text, (int)strlen(text), "test.svg", NULL, XML_PARSE_NONET);
    assert_non_null(document);
    return document;
}

/* All words but those of the title. */
#define WORDS "//s:g[not(@class='title')]/s:text"

static xmlXPathObjectPtr found(xmlDocPtr document, const char *path)
{
    xmlXPathContextPtr context = xmlXPathNewContext(document);
    xmlXPathRegisterNs(context, BAD_CAST "s", BAD_CAST "http://www.w3.org/2000/svg");
    xmlXPathObjectPtr result = xmlXPathEvalExpression(BAD_CAST path, context);
    assert_non_null(result);
    xmlXPathFreeContext(context);
    return result;
}

static int count(svg *s, const char *path)
{
    xmlDocPtr document = parsed(s);
    xmlXPathObjectPtr result = found(document, path);
    int nodes = xmlXPathNodeSetGetLength(result->nodesetval);
    xmlXPathFreeObject(result);
    xmlFreeDoc(document);
    return nodes;
}

/* The text of the first match, in a static buffer; "" when nothing matches. */
static const char *value(svg *s, const char *path)
{
    static char buffer[200000];
    xmlDocPtr document = parsed(s);
    xmlXPathObjectPtr result = found(document, path);
    xmlChar *text = xmlXPathCastToString(result);
    snprintf(buffer, sizeof buffer, "%s", (const char *)text);
    xmlFree(text);
    xmlXPathFreeObject(result);
    xmlFreeDoc(document);
    return buffer;
}

/* The numbers of a path: its points, one after the other, and where it is lifted (M). */
struct drawn {
    int points;
    num_q x[20000], y[20000];
    bool lifted[20000];
};
static struct drawn drawn;
static void read_path(const char *d)
{
    drawn.points = 0;
    while (*d != '\0' && *d != 'Z') {
        char number[2][40];
        bool lifted = *d == 'M';
        d += *d == 'M' || *d == 'L';
        for (int k = 0; k < 2; k++) {
            size_t n = strspn(d, "-.0123456789");
            assert_in_range(n, 1, 39);
            snprintf(number[k], sizeof number[k], "%.*s", (int)n, d);
            d += n + (k == 0);
        }
        assert_in_range(drawn.points, 0, 19999);
        drawn.lifted[drawn.points] = lifted;
        drawn.x[drawn.points] = from_string_q(number[0]);
        drawn.y[drawn.points++] = from_string_q(number[1]);
    }
}

/* ---- Strings ---------------------------------------------------------------------------------- */

static void strings_are_escaped_and_repaired(void **state)
{
    (void)state;
    svg *s = svg_new("nasty", "a < b && \"c\" > 'd' \x01\xff\xc1\x81 ω \xed\xa0\x80", "]]> <script/>");
    svg_panel(s, svg_integer_window(0, 0, 1, 1), 100, 0, "$x_{<}$ & \xf0\x9d\x92\xb3");
    assert_string_equal(value(s, "string(//s:title)"), "a < b && \"c\" > 'd' \uFFFD\uFFFD\uFFFD ω \uFFFD");
    assert_string_equal(value(s, "string(//s:desc)"), "]]> <script/>");
    assert_string_equal(value(s, "string(" WORDS ")"), "x< & \U0001D4B3");
    svg_free(s);
}

static void markup_becomes_spans(void **state)
{
    (void)state;
    static const struct {
        const char *markup, *text;
        int spans;
    } cases[] = {
        {"R_0", "R0", 2},
        {"R_i^{[2]}(t,c)", "Ri[2](t,c)", 8},
        {"-f'", "−f′", 3},
        {"\\d\\e\\t M", "det M", 2},
        {"$a - b$ c", "a - b c", 2},
        {"x_", "x", 1},
        {"x^{", "x", 1},
        {"x_{}y", "xy", 1},
        {"\\$_2", "$2", 2},
        {"", "", 0},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        svg *s = square(100);
        svg_label(s, svg_at(50, 50), SVG_E, SVG_POINT, cases[k].markup);
        assert_string_equal(value(s, "string(" WORDS ")"), cases[k].text);
        assert_int_equal(count(s, "//s:tspan"), cases[k].spans);
        svg_free(s);
    }
    svg *s = square(100);
    svg_label(s, svg_at(50, 50), SVG_HERE, SVG_POINT, "ω_1");
    assert_string_equal(value(s, "string(" WORDS "/@x)"), "50.00");
    assert_string_equal(value(s, "string(//s:tspan[1]/@class)"), "i");
    assert_string_equal(value(s, "string(//s:tspan[2]/@class)"), "u s");
    assert_string_equal(value(s, "string(//s:tspan[2]/@dy)"), "3.48");
    svg_label(s, svg_at(50, 50), SVG_HERE, SVG_POINT, "R_{12}^3x"); /* what follows stands behind the longer script */
    assert_string_equal(value(s, "string(" WORDS "[2]/s:tspan[3]/@dx)"), "-11.16");
    assert_string_equal(value(s, "string(" WORDS "[2]/s:tspan[3]/@dy)"), "-9.57");
    assert_string_equal(value(s, "string(" WORDS "[2]/s:tspan[4]/@dx)"), "5.36");
    assert_string_equal(value(s, "string(" WORDS "[2]/s:tspan[4]/@dy)"), "6.09");
    svg_free(s);
}

static void a_document_is_accessible(void **state)
{
    (void)state;
    svg *s = square(100);
    assert_string_equal(value(s, "string(/s:svg/@role)"), "img");
    assert_string_equal(value(s, "string(/s:svg/@aria-labelledby)"), "test-title test-desc");
    assert_string_equal(value(s, "string(//*[@id='test-title'])"), "Title");
    assert_string_equal(value(s, "string(//*[@id='test-desc'])"), "Description");
    assert_non_null(strstr(svg_text(s), "@media (prefers-color-scheme:dark)"));
    assert_non_null(strstr(svg_text(s), "@media print"));
    svg_free(s);
}

/* ---- Rounding --------------------------------------------------------------------------------- */

static const char *shown(num_q x)
{
    svg *s = square(100);
    svg_mark(s, (svg_point){x, q(0)}, SVG_POINT, SVG_DISC);
    const char *text = value(s, "string(//s:circle/@cx)");
    svg_free(s);
    return text;
}

static void coordinates_are_rounded_half_away_from_zero(void **state)
{
    (void)state;
    static const struct {
        const char *x, *shown;
    } cases[] = {
        {"0", "0.00"},        {"1/200", "0.01"},     {"-1/200", "-0.01"},
        {"3/200", "0.02"},    {"-3/200", "-0.02"},   {"5/200", "0.03"},
        {"-5/200", "-0.03"},  {"1/3", "0.33"},       {"-2/3", "-0.67"},
        {"-1/201", "0.00"},   {"1/199", "0.01"},     {"999.995", "1000.00"},
        {"-99.99", "-99.99"}, {"1e6", "1000000.00"}, {"4999999999/1000000000000", "0.00"},
        {"7", "7.00"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        assert_string_equal(shown(from_string_q(cases[k].x)), cases[k].shown);
    for (int k = 0; k < 300; k++) {
        num_q x = r(random_int(-99999999, 99999999), random_int(1000, 2000));
        num_q error = sub_q(from_string_q(shown(x)), x);
        assert_true(cagd_compare_q(cagd_sign_q(error) < 0 ? neg_q(error) : error, r(1, 200)) <= 0);
    }
}

static void a_point_too_far_away_is_a_failure(void **state)
{
    (void)state;
    svg *s = square(100);
    svg_mark(s, (svg_point){from_string_q("1000000.01"), q(0)}, SVG_POINT, SVG_DISC);
    assert_non_null(svg_failed(s));
    assert_null(svg_text(s));
    svg_free(s);
}

/* ---- Lines ------------------------------------------------------------------------------------ */

/* Whether (x, y) rounded is the point k that was drawn, in a square of the given side. */
static bool is_drawn(int k, num_q x, num_q y, int side)
{
    num_q dx = sub_q(drawn.x[k], x), dy = sub_q(drawn.y[k], sub_q(q(side), y)), half = r(1, 200);
    return cagd_compare_q(mul_q(dx, dx), mul_q(half, half)) <= 0 &&
           cagd_compare_q(mul_q(dy, dy), mul_q(half, half)) <= 0;
}

/* The line through (a, b) and (c, d) meets the square's four sides where it should, and is drawn between. */
static void lines_end_at_the_window(void **state)
{
    (void)state;
    enum { SIDE = 64 };
    int met = 0, missed = 0;
    for (int k = 0; k < 400; k++) {
        region_mark mark = region_open();
        num_q a = coarse_q(160, 3), b = coarse_q(160, 3), c = coarse_q(160, 3), d = coarse_q(160, 3);
        num_q dx = sub_q(c, a), dy = sub_q(d, b);
        if (!cagd_is_zero_q(dx) && !cagd_is_zero_q(dy)) {
            num_q x[4], y[4]; /* the points on the four sides' lines that are on the sides */
            int ends = 0;
            for (int side = 0; side < 4; side++) {
                num_q at = q(side % 2 * SIDE);
                num_q u = side < 2 ? at : add_q(a, mul_q(dx, div_q(sub_q(at, b), dy)));
                num_q v = side < 2 ? add_q(b, mul_q(dy, div_q(sub_q(at, a), dx))) : at;
                num_q other = side < 2 ? v : u;
                if (cagd_sign_q(other) >= 0 && cagd_compare_q(other, q(SIDE)) <= 0) {
                    x[ends] = u;
                    y[ends++] = v;
                }
            }
            svg *s = square(SIDE);
            svg_line(s, (svg_point){a, b}, (svg_point){c, d}, SVG_MUTED);
            read_path(value(s, "string(//s:path/@d)"));
            assert_int_equal(drawn.points, ends == 0 ? 0 : 2);
            for (int i = 0; i < drawn.points; i++) {
                bool somewhere = false;
                for (int j = 0; j < ends; j++)
                    somewhere = somewhere || is_drawn(i, x[j], y[j], SIDE);
                assert_true(somewhere);
            }
            if (ends == 2)
                assert_true((is_drawn(0, x[0], y[0], SIDE) && is_drawn(1, x[1], y[1], SIDE)) ||
                            (is_drawn(1, x[0], y[0], SIDE) && is_drawn(0, x[1], y[1], SIDE)));
            met += ends > 0;
            missed += ends == 0;
            svg_free(s);
        }
        region_drop(mark);
    }
    assert_true(met > 50 && missed > 50);
}

static void segments_and_axis_parallel_lines_are_clipped(void **state)
{
    (void)state;
    svg *s = square(10);
    num_q P[] = {q(-5), q(5), q(5), q(5), q(5), q(15), q(8), q(15), q(8), q(2)};
    svg_polyline(s, 5, P, SVG_CURVE);
    svg_line(s, svg_at(3, 20), svg_at(3, 21), SVG_MUTED);
    svg_line(s, svg_at(11, 0), svg_at(11, 1), SVG_MUTED);
    svg_segment(s, svg_at(-3, 3), svg_at(-1, 1), SVG_MUTED);
    assert_string_equal(value(s, "string(//s:path[1]/@d)"), "M0.00 5.00L5.00 5.00L5.00 0.00M8.00 0.00L8.00 8.00");
    assert_string_equal(value(s, "string(//s:path[2]/@d)"), "M3.00 10.00L3.00 0.00");
    assert_int_equal(count(s, "//s:path"), 2);
    svg_free(s);
}

/* ---- Curves ----------------------------------------------------------------------------------- */

/* The square of the distance of (x, y) from the drawn polyline. */
static num_q distance_squared(num_q x, num_q y)
{
    num_q least = q(1000000);
    for (int k = 1; k < drawn.points; k++) {
        if (drawn.lifted[k])
            continue;
        num_q dx = sub_q(drawn.x[k], drawn.x[k - 1]), dy = sub_q(drawn.y[k], drawn.y[k - 1]);
        num_q vx = sub_q(x, drawn.x[k - 1]), vy = sub_q(y, drawn.y[k - 1]);
        num_q length = add_q(mul_q(dx, dx), mul_q(dy, dy)), t = q(0);
        if (!cagd_is_zero_q(length))
            t = div_q(add_q(mul_q(vx, dx), mul_q(vy, dy)), length);
        t = cagd_sign_q(t) < 0 ? q(0) : cagd_compare_q(t, q(1)) > 0 ? q(1) : t;
        num_q ex = sub_q(vx, mul_q(t, dx)), ey = sub_q(vy, mul_q(t, dy));
        num_q e = add_q(mul_q(ex, ex), mul_q(ey, ey));
        least = cagd_compare_q(e, least) < 0 ? e : least;
    }
    return least;
}

static bool in_square(const num_q P[], int side)
{
    return cagd_sign_q(P[0]) >= 0 && cagd_sign_q(P[1]) >= 0 && cagd_compare_q(P[0], q(side)) <= 0 &&
           cagd_compare_q(P[1], q(side)) <= 0;
}

/* How many of the points at t = (2 k + 1)/(2 N) that lie in the window are farther than bound from what is
 * drawn, of how many. */
static void judge_curve(int n, const num_q R[], const num_q w[], int side, num_q bound, int *seen, int *far)
{
    enum { N = 60 };
    for (int k = 0; k < N; k++) {
        region_mark mark = region_open();
        num_q t = r(2 * k + 1, 2 * N), P[2];
        if (!cagd_is_zero_q(rational_weight_q(n, w, t))) {
            rational_point_q(n, 2, R, w, t, P);
            if (in_square(P, side)) {
                num_q e = distance_squared(P[0], sub_q(q(side), P[1]));
                *seen += 1;
                *far += cagd_compare_q(e, mul_q(bound, bound)) > 0;
            }
        }
        region_drop(mark);
    }
}

/* The vertices are rounded by at most 1/200 in each coordinate, hence the polyline by less than 1/100. */
static void flattened_curves_keep_the_tolerance(void **state)
{
    (void)state;
    enum { SIDE = 200 };
    static const long inverse[] = {1, 20, 300};
    int seen = 0, far = 0, coarse_far = 0, signs = 0;
    for (int k = 0; k < 36; k++) {
        region_mark mark = region_open();
        int n = random_int(1, 8);
        num_q R[18], w[9], tolerance = r(1, inverse[k % 3]);
        for (int i = 0; i <= n; i++) {
            R[2 * i] = r(random_int(0, 20000), 100);
            R[2 * i + 1] = r(random_int(0, 20000), 100);
            w[i] = r(random_int(k % 2 ? 1 : -20, 40), random_int(1, 7));
            signs += cagd_sign_q(w[i]) < 0;
        }
        svg *s = square(SIDE);
        svg_tolerance(s, tolerance);
        svg_rational(s, n, R, w, SVG_CURVE);
        read_path(value(s, "string(//s:path/@d)"));
        judge_curve(n, R, w, SIDE, add_q(tolerance, r(1, 100)), &seen, &far);
        int ignored = 0;
        if (k % 3 == 0)
            judge_curve(n, R, w, SIDE, r(1, 20), &ignored, &coarse_far);
        svg_free(s);
        region_drop(mark);
    }
    assert_int_equal(far, 0);
    assert_true(seen > 1000 && signs > 10);
    assert_true(coarse_far > 10); /* control: a coarse polyline is caught by the finer bound */
}

static void polynomial_curves_of_low_degree_are_native(void **state)
{
    (void)state;
    num_q R[] = {q(0), q(0), q(1), q(2), q(3), q(4), q(5), q(1), q(6), q(6)};
    static const char *const d[] = {"M0.00 10.00L1.00 8.00", "M0.00 10.00Q1.00 8.00 3.00 6.00",
                                    "M0.00 10.00C1.00 8.00 3.00 6.00 5.00 9.00"};
    for (int n = 1; n <= 3; n++) {
        svg *s = square(10);
        svg_bezier(s, n, R, SVG_CURVE);
        assert_string_equal(value(s, "string(//s:path/@d)"), d[n - 1]);
        svg_free(s);
    }
    svg *s = square(10);
    num_q one[] = {q(1), q(1), q(1), q(1), q(1)};
    int seen = 0, far = 0;
    svg_bezier(s, 4, R, SVG_CURVE);
    read_path(value(s, "string(//s:path/@d)"));
    judge_curve(4, R, one, 10, r(6, 100), &seen, &far);
    assert_int_equal(seen, 60);
    assert_int_equal(far, 0);
    svg_free(s);
}

/* 1/(t - 5): undefined at 5, beyond the window near it. */
static svg_point hyperbola(num_q t, const void *data)
{
    (void)data;
    return (svg_point){t, add_q(q(5), div_q(q(1), sub_q(t, q(5))))};
}

static void a_plot_is_open_at_a_pole(void **state)
{
    (void)state;
    svg *s = square(10);
    svg_plot(s, hyperbola, NULL, q(0), q(10), 7, SVG_CURVE);
    svg_plot(s, hyperbola, NULL, q(0), q(10), 8, SVG_CURVE_2);
    assert_int_equal(region_faults, 0);
    for (int which = 1; which <= 2; which++) {
        read_path(value(s, which == 1 ? "string(//s:path[1]/@d)" : "string(//s:path[2]/@d)"));
        int lifts = 0;
        for (int k = 0; k < drawn.points; k++) {
            lifts += drawn.lifted[k];
            if (k > 0 && !drawn.lifted[k])
                assert_int_equal(cagd_compare_q(drawn.x[k], q(5)), cagd_compare_q(drawn.x[k - 1], q(5)));
        }
        assert_int_equal(lifts, 2);
        for (int k = 0; k < 100; k++) {
            svg_point P = hyperbola(r(2 * k + 1, 20), NULL);
            if (in_square((num_q[]){P.x, P.y}, 10))
                assert_true(cagd_compare_q(distance_squared(P.x, sub_q(q(10), P.y)), r(36, 10000)) <= 0);
        }
    }
    svg_free(s);
}

/* ---- Contours --------------------------------------------------------------------------------- */

static num_q circle(svg_point at, const void *data)
{
    (void)data;
    num_q x = sub_q(at.x, q(50)), y = sub_q(at.y, q(50));
    return sub_q(q(900), add_q(mul_q(x, x), mul_q(y, y)));
}
static num_q constant(svg_point at, const void *data)
{
    (void)at;
    return q(*(const int *)data);
}
static num_q half_plane(svg_point at, const void *data)
{
    (void)data;
    return sub_q(at.x, q(25));
}
static num_q strip(svg_point at, const void *data)
{
    (void)data;
    num_q x = sub_q(at.x, q(25));
    return sub_q(r(1, 1000000), mul_q(x, x));
}
static num_q nowhere(svg_point at, const void *data)
{
    (void)data;
    return div_q(at.x, sub_q(at.y, at.y));
}

static void contours_are_found_to_a_hundredth(void **state)
{
    (void)state;
    svg *s = square(100);
    svg_implicit(s, circle, NULL, 37, SVG_CURVE);
    const char *d = value(s, "string(//s:path/@d)");
    assert_int_equal(d[strlen(d) - 1], 'Z');
    read_path(d);
    assert_in_range(drawn.points, 60, 100);
    for (int k = 0; k < drawn.points; k++) {
        num_q F = circle((svg_point){drawn.x[k], drawn.y[k]}, NULL);
        assert_true(cagd_compare_q(mul_q(F, F), r(9, 4)) <= 0); /* |r - 30| < 2/100 times r + 30 gives less than 3/2 */
    }
    svg_free(s);
}

/* A region thinner than the rounding goes up and comes back the same way. */
static void a_thin_region_keeps_its_length(void **state)
{
    (void)state;
    svg *s = square(100);
    svg_region(s, strip, NULL, 4, SVG_FILL);
    assert_string_equal(value(s, "string(//s:g//s:path/@d)"), "M25.00 100.00L25.00 0.00L25.00 75.00Z");
    svg_free(s);
}

static void regions_are_closed_along_the_border(void **state)
{
    (void)state;
    svg *s = square(100);
    svg_region(s, constant, &(int){1}, 10, SVG_FILL);
    svg_region(s, half_plane, NULL, 9, SVG_WRONG);
    svg_region(s, constant, &(int){-1}, 10, SVG_FILL);
    assert_int_equal(count(s, "//s:g//s:path"), 2);
    for (int which = 1; which <= 2; which++) {
        read_path(value(s, which == 1 ? "string((//s:g//s:path)[1]/@d)" : "string((//s:g//s:path)[2]/@d)"));
        num_q area = q(0); /* twice, by the shoelace formula */
        for (int k = 0; k < drawn.points; k++) {
            int l = (k + 1) % drawn.points;
            area = add_q(area, sub_q(mul_q(drawn.x[k], drawn.y[l]), mul_q(drawn.x[l], drawn.y[k])));
        }
        num_q error = sub_q(cagd_sign_q(area) < 0 ? neg_q(area) : area, q(which == 1 ? 20000 : 15000));
        assert_true(cagd_compare_q(mul_q(error, error), q(which == 1 ? 0 : 4)) <= 0); /* 1/100 along the side of 100 */
        assert_in_range(drawn.points, 4, 6);
    }
    assert_int_equal(count(s, "//s:pattern[@id='test-hatch']"), 1);
    svg_region(s, nowhere, NULL, 4, SVG_FILL);
    assert_non_null(svg_failed(s));
    svg_free(s);
    region_faults = 0;
}

/* ---- Words, axes, matrices -------------------------------------------------------------------- */

static void directions_are_the_nearest_of_eight(void **state)
{
    (void)state;
    static const struct {
        long x, y;
        enum svg_direction towards;
    } cases[] = {
        {0, 0, SVG_N},    {1, 0, SVG_E},    {1, 1, SVG_NE},    {0, 2, SVG_N},     {-3, 3, SVG_NW},   {-1, 0, SVG_W},
        {-1, -1, SVG_SW}, {0, -1, SVG_S},   {7, -7, SVG_SE},   {5, 2, SVG_E},     {12, 5, SVG_NE},   {5, 12, SVG_NE},
        {2, 5, SVG_N},    {-29, 12, SVG_W}, {-70, 29, SVG_NW}, {70, -29, SVG_SE}, {-12, -29, SVG_S}, {29, -12, SVG_E},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        assert_int_equal(svg_direction_of(svg_at(3, 4), svg_at(3 + cases[k].x, 4 + cases[k].y)), cases[k].towards);
}

static void ticks_are_exact_numbers(void **state)
{
    (void)state;
    svg *s = svg_new("ticks", "t", "d");
    svg_panel(s, (svg_window){r(-3, 50), r(-1, 3), r(11, 100), r(2, 3)}, 300, 200, NULL);
    svg_axes(s, r(1, 20), r(1, 3), "x", NULL);
    static const char *const expected[] = {"−0.05", "0", "0.05", "0.1", "x", "−1/3", "0", "1/3", "2/3"};
    assert_int_equal(count(s, WORDS ""), 9);
    for (int k = 0; k < 9; k++) {
        char path[80];
        snprintf(path, sizeof path, "string((" WORDS ")[%d])", k + 1);
        assert_string_equal(value(s, path), expected[k]);
    }
    assert_int_equal(svg_overlaps(s), 0);
    svg_axes(s, r(1, 100000), q(0), NULL, NULL);
    assert_non_null(svg_failed(s));
    svg_free(s);
}

static void scales_stand_around_a_frame(void **state)
{
    (void)state;
    svg *s = square(4);
    svg_scales(s, q(1), q(2), "x", "y");
    assert_int_equal(count(s, "//s:rect[contains(@class,'axis')]"), 1);
    assert_int_equal(count(s, "//s:path[contains(@class,'axis')]"), 5 + 3); /* ticks, and no axes */
    assert_int_equal(count(s, WORDS "[contains(@class,'k')]"), 5 + 3);
    assert_int_equal(count(s, WORDS "[not(contains(@class,'k'))]"), 2);
    svg_free(s);
}

static void a_cloud_is_one_path_of_dots(void **state)
{
    (void)state;
    const num_q P[] = {q(1), q(1), q(1), q(1), q(2), q(3), r(5, 2), q(0), q(2), q(3)};
    svg *s = square(4);
    svg_cloud(s, 5, P, 250, SVG_POINT);
    svg_cloud(s, 0, P, 250, SVG_POINT);
    assert_int_equal(count(s, "//s:path"), 1);
    assert_string_equal(value(s, "string(//s:path/@d)"),
                        "M1.00 3.00h0M2.00 1.00h0M2.50 4.00h0M2.00 1.00h0"); /* the second is the first */
    assert_string_equal(value(s, "string(//s:path/@stroke-width)"), "2.50");
    svg_free(s);
}

/* Above everything, in as many lines as it takes. */
static void the_title_stands_above(void **state)
{
    (void)state;
    static const char title[] = "A title that is much longer than $100$ units are and so is broken at a blank";
    svg *s = svg_new("title", title, "d");
    svg_panel(s, svg_integer_window(0, 0, 100, 100), 100, 0, NULL);
    svg_frame(s);
    enum { LINES = 3 };
    assert_int_equal(count(s, "//s:g[@class='title']/s:text"), LINES);
    char whole[200] = "";
    for (int k = 1; k <= LINES; k++) {
        char path[80];
        snprintf(path, sizeof path, "string(//s:g[@class='title']/s:text[%d])", k);
        snprintf(whole + strlen(whole), sizeof whole - strlen(whole), "%s%s", k > 1 ? " " : "", value(s, path));
    }
    assert_string_equal(whole, title);
    char place[80];
    snprintf(place, sizeof place, "%s", value(s, "string(/s:svg/s:g[not(@class)]/@transform)"));
    svg_free(s);
    s = svg_new("title", "", "d"); /* without one the panel stands three lines higher */
    svg_panel(s, svg_integer_window(0, 0, 100, 100), 100, 0, NULL);
    svg_frame(s);
    assert_int_equal(count(s, "//s:g[@class='title']"), 0);
    assert_string_not_equal(value(s, "string(/s:svg/s:g[not(@class)]/@transform)"), place);
    svg_free(s);
}

/* A point of a role is as large as that of any other; only its shape differs. */
static void points_are_of_one_scale(void **state)
{
    (void)state;
    svg *s = square(100);
    for (int role = 0; role < SVG_ROLES; role++) {
        svg_mark(s, svg_at(50, 50), (enum svg_role)role, SVG_DISC);
        svg_mark(s, svg_at(50, 50), (enum svg_role)role, SVG_RING);
    }
    assert_int_equal(count(s, "//s:circle"), 2 * SVG_ROLES);
    assert_int_equal(count(s, "//s:circle[@r='3.30']"), 2 * SVG_ROLES);
    svg_free(s);
}

/* Where the panel k, from 1, is put: the numbers of its translation. */
static svg_point place(svg *s, int k)
{
    char path[80], x[40] = "", y[40] = "";
    snprintf(path, sizeof path, "string(/s:svg/s:g[not(@class)][%d]/@transform)", k);
    assert_int_equal(sscanf(value(s, path), "translate(%39[0-9.-] %39[0-9.-])", x, y), 2);
    return (svg_point){from_string_q(x), from_string_q(y)};
}

/* Panels of one row are level at the top; first panels of rows at the left, however far their words reach; and a row stands
 * below what the row before needs. */
static void rows_stand_below_one_another(void **state)
{
    (void)state;
    svg *s = svg_new("rows", "Rows", "Three panels in two rows");
    for (int k = 0; k < 3; k++) {
        if (k == 2)
            svg_row(s);
        svg_panel(s, svg_integer_window(0, 0, 100, 100), 100, 50 + 30 * k, k == 1 ? "one\ntwo" : NULL);
        if (k == 2)
            svg_scales(s, q(0), q(100), NULL, "y");
        svg_frame(s);
    }
    svg_point a = place(s, 1), b = place(s, 2), c = place(s, 3);
    assert_true(cagd_equal_q(a.y, b.y));
    assert_true(cagd_compare_q(b.x, add_q(a.x, q(100))) > 0);
    assert_true(cagd_equal_q(a.x, c.x));
    assert_true(cagd_compare_q(c.y, add_q(a.y, q(80 + 25))) > 0);
    num_q bottom = add_q(c.y, q(110));
    assert_true(cagd_compare_q(from_string_q(value(s, "string(/s:svg/@height)")), bottom) > 0);
    svg_free(s);
}

static void a_matrix_shows_its_entries_or_their_signs(void **state)
{
    (void)state;
    num_q m[] = {q(1), r(-1, 3), q(0), q(-8), r(1, 1000), q(12)};
    svg *s = svg_new("matrix", "t", "d");
    svg_panel(s, svg_integer_window(0, 0, 3, 2), 150, 0, NULL);
    svg_heat(s, 2, 3, m);
    assert_int_equal(count(s, "//s:rect[@fill-opacity]"), 5);
    assert_int_equal(count(s, WORDS ""), 6);
    assert_string_equal(value(s, "string((" WORDS ")[2])"), "−1/3");
    assert_string_equal(value(s, "string((" WORDS ")[5])"), "0.001");
    svg_panel(s, svg_integer_window(0, 0, 3, 2), 60, 0, NULL);
    svg_heat(s, 2, 3, m);
    assert_int_equal(count(s, WORDS ""), 6);
    assert_int_equal(count(s, "//s:path[@class='x curve-2']"), 2);
    svg_free(s);
}

static void overlaps_are_counted_and_words_never_cut_off(void **state)
{
    (void)state;
    svg *s = square(100);
    svg_label(s, svg_at(0, 0), SVG_W, SVG_POINT, "R_0");
    svg_label(s, svg_at(100, 100), SVG_NE, SVG_POINT, "R_1");
    assert_int_equal(svg_overlaps(s), 0);
    num_q width = from_string_q(value(s, "string(/s:svg/@width)"));
    assert_true(cagd_compare_q(width, q(132 + 2 * 18)) > 0);
    svg_label(s, svg_at(99, 100), SVG_NE, SVG_POINT, "R_2");
    assert_int_equal(svg_overlaps(s), 1);
    svg_free(s);
}

/* Around a point that others surround closely there is room only farther away; where the window is full there is none, and then nothing is put. */
static void labels_that_stand_clear(void **state)
{
    (void)state;
    enum { SIDE = 21 };
    double near[16], all[2 * SIDE * SIDE];
    for (int k = 0; k < 8; k++) {
        near[2 * k] = 50 + 14 * cos(k * acos(-1) / 4);
        near[2 * k + 1] = 50 + 14 * sin(k * acos(-1) / 4);
    }
    for (int k = 0; k < SIDE * SIDE; k++) {
        all[2 * k] = 5 * (k % SIDE);
        all[2 * k + 1] = 5 * (k / SIDE);
    }
    svg *s = square(100);
    assert_true(svg_label_clear(s, svg_at(50, 50), SVG_E, &(svg_crowd){0}, SVG_POINT, "A"));
    const double first = strtod(value(s, "string((" WORDS ")[1]/@x)"), NULL);
    assert_true(svg_label_clear(s, svg_at(50, 50), SVG_E, &(svg_crowd){.points = 8, .point = near}, SVG_POINT, "B"));
    assert_int_equal(svg_overlaps(s), 0);
    const double second = strtod(value(s, "string((" WORDS ")[2]/@x)"), NULL), y = strtod(value(s, "string((" WORDS ")[2]/@y)"), NULL);
    assert_true(hypot(second - 50, y - 50) > fabs(first - 50));
    assert_false(svg_label_clear(s, svg_at(50, 50), SVG_E, &(svg_crowd){.points = SIDE * SIDE, .point = all}, SVG_POINT, "C"));
    assert_false(svg_note_clear(s, svg_at(50, 50), SVG_E, &(svg_crowd){.points = SIDE * SIDE, .point = all}, SVG_POINT, "C"));
    assert_int_equal(count(s, WORDS ""), 2);
    svg_free(s);
}

/* ---- The document ----------------------------------------------------------------------------- */

/* A bit of everything. */
static svg *busy(void)
{
    num_q R[] = {r(1, 3), q(1), q(2), r(7, 3), q(4), r(1, 7)}, w[] = {q(1), r(-2, 5), q(3)};
    svg *s = svg_new("busy", "Busy", "Everything at once");
    svg_panel(s, svg_integer_window(-1, -1, 5, 4), 300, 0, "One\ntwo $x_1$");
    svg_heading(s, SVG_WRONG, "As printed");
    svg_grid(s, q(1), q(1));
    svg_axes(s, q(1), q(1), "x", "y");
    svg_area(s, 3, R, SVG_WRONG);
    svg_rational(s, 2, R, w, SVG_CURVE);
    svg_bezier(s, 2, R, SVG_CURVE_2);
    svg_control_polygon(s, 2, R, "R");
    svg_panel(s, svg_integer_window(0, 0, 100, 100), 200, 120, NULL);
    svg_heading(s, SVG_RIGHT, "True");
    svg_frame(s);
    svg_region(s, circle, NULL, 20, SVG_FILL);
    svg_implicit(s, circle, NULL, 20, SVG_RIGHT);
    svg_circle(s, svg_at(50, 50), r(40, 3), SVG_MUTED);
    svg_arrow(s, svg_at(50, 50), (svg_point){r(200, 3), q(70)}, SVG_POINT);
    svg_mark(s, svg_at(10, 10), SVG_WRONG, SVG_USUAL);
    svg_legend_line(s, SVG_CURVE, "a");
    svg_legend_mark(s, SVG_POLYGON, SVG_USUAL, "b");
    svg_legend_area(s, SVG_FILL, "c");
    return s;
}

/* Where three of four equal entries have room, two stand in each row. */
static void the_rows_of_a_legend_are_alike(void **state)
{
    (void)state;
    svg *s = svg_new("legend", "Legend", "d");
    svg_panel(s, svg_integer_window(0, 0, 100, 100), 300, 0, NULL);
    svg_frame(s);
    for (int k = 0; k < 4; k++)
        svg_legend_line(s, SVG_CURVE, "entry");
    static const char row[] = "//s:g[contains(@transform,\"%s)\")][s:text='entry']";
    const char *first = value(s, "substring-before(substring-after((//s:g[s:text='entry'])[1]/@transform, ' '), ')')");
    char here[120], height[40];
    snprintf(height, sizeof height, " %s", first);
    snprintf(here, sizeof here, row, height);
    assert_int_equal(count(s, "//s:g[s:text='entry']"), 4);
    assert_int_equal(count(s, here), 2);
    svg_free(s);
}

static void the_bytes_are_always_the_same(void **state)
{
    (void)state;
    svg *s = busy();
    char *first = strdup(svg_text(s));
    assert_non_null(first);
    assert_string_equal(svg_text(s), first);
    svg_free(s);
    for (int k = 0; k < 1000; k++)
        random_q(); /* another state of the region */
    s = busy();
    assert_string_equal(svg_text(s), first);
    assert_null(strstr(first, "-0.00"));
    free(first);
    svg_free(s);
}

static void every_id_is_unique_and_every_reference_meets_one(void **state)
{
    (void)state;
    svg *s = busy();
    assert_int_equal(count(s, "//*[@id][@id = following::*/@id or @id = descendant::*/@id]"), 0);
    assert_int_equal(count(s, "//*[starts-with(@clip-path,'url(#')]"), 2);
    assert_int_equal(count(s, "//*[@clip-path][not(substring-before(substring-after(@clip-path,'#'),')') = //@id)]"),
                     0);
    assert_int_equal(count(s, "//*[starts-with(@fill,'url(#')][not(@fill = 'url(#busy-hatch)')]"), 0);
    svg_free(s);
}

static void trouble_sticks(void **state)
{
    (void)state;
    assert_non_null(svg_failed(NULL));
    assert_null(svg_text(NULL));
    svg_panel(NULL, svg_integer_window(0, 0, 1, 1), 10, 0, NULL);
    svg_label(NULL, svg_at(0, 0), SVG_N, SVG_POINT, "x");
    svg_control_polygon(NULL, 1, (num_q[]){q(0), q(0), q(1), q(1)}, "R");
    svg_legend_line(NULL, SVG_CURVE, "x");
    svg_write(NULL, "nowhere");
    svg_free(NULL);
    static const char *const bad[] = {"", "1a", "a b", "a\"", "ä"};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        svg *s = svg_new(bad[k], "", "");
        assert_non_null(svg_failed(s));
        svg_free(s);
    }
    for (int k = 0; k < 9; k++) {
        svg *s = svg_new("a_1-b", "", "");
        if (k > 0)
            svg_panel(s, svg_integer_window(0, 0, 10, 10), 10, 0, NULL);
        assert_null(svg_failed(s));
        switch (k) {
        case 0:
            svg_mark(s, svg_at(0, 0), SVG_POINT, SVG_USUAL);
            break;
        case 1:
            svg_panel(s, svg_integer_window(0, 1, 2, 1), 10, 0, NULL);
            break;
        case 2:
            svg_line(s, svg_at(1, 1), svg_at(1, 1), SVG_CURVE);
            break;
        case 3:
            svg_arrow(s, svg_at(1, 1), svg_at(1, 1), SVG_CURVE);
            break;
        case 4:
            svg_circle(s, svg_at(1, 1), q(0), SVG_CURVE);
            break;
        case 5:
            svg_rational(s, 1, (num_q[]){q(0), q(0), q(1), q(1)}, (num_q[]){q(0), q(0)}, SVG_CURVE);
            break;
        case 6:
            svg_tolerance(s, q(0));
            break;
        case 7:
            svg_bezier(s, 65, NULL, SVG_CURVE);
            break;
        default:
            svg_write(s, "/nowhere/at/all.svg");
        }
        const char *why = svg_failed(s);
        assert_non_null(why);
        svg_circle(s, svg_at(1, 1), q(-1), SVG_CURVE);
        assert_ptr_equal(svg_failed(s), why);
        assert_null(svg_text(s));
        svg_free(s);
    }
}

static void a_file_holds_the_document(void **state)
{
    (void)state;
    char folder[] = "/tmp/test_svg_XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/busy.svg", folder);
    svg *s = busy();
    svg_write(s, path);
    assert_null(svg_failed(s));
    svg_write(s, path); /* over the first */
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    static char text[100000];
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(text, svg_text(s));
    svg_free(s);
    assert_int_equal(remove(path), 0);
    assert_int_equal(rmdir(folder), 0); /* nothing else was left there */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        unit(strings_are_escaped_and_repaired),
        unit(markup_becomes_spans),
        unit(a_document_is_accessible),
        unit(coordinates_are_rounded_half_away_from_zero),
        unit(a_point_too_far_away_is_a_failure),
        unit(lines_end_at_the_window),
        unit(segments_and_axis_parallel_lines_are_clipped),
        unit(flattened_curves_keep_the_tolerance),
        unit(polynomial_curves_of_low_degree_are_native),
        unit(a_plot_is_open_at_a_pole),
        unit(contours_are_found_to_a_hundredth),
        unit(a_thin_region_keeps_its_length),
        unit(regions_are_closed_along_the_border),
        unit(directions_are_the_nearest_of_eight),
        unit(ticks_are_exact_numbers),
        unit(scales_stand_around_a_frame),
        unit(a_cloud_is_one_path_of_dots),
        unit(rows_stand_below_one_another),
        unit(the_title_stands_above),
        unit(the_rows_of_a_legend_are_alike),
        unit(points_are_of_one_scale),
        unit(a_matrix_shows_its_entries_or_their_signs),
        unit(overlaps_are_counted_and_words_never_cut_off),
        unit(labels_that_stand_clear),
        unit(the_bytes_are_always_the_same),
        unit(every_id_is_unique_and_every_reference_meets_one),
        unit(trouble_sticks),
        unit(a_file_holds_the_document),
    };
    int failed = run_unit_tests(tests);
    xmlCleanupParser();
    return failed;
}
