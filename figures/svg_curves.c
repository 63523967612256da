/* svg_curves.c -- Bézier curves and curves given by a function, flattened where SVG has no such curve. */
#include "figures/svg_parts.h"

#include "exact/kernels_q.h"

/* ---- Rational curves --------------------------------------------------------------------------
 *
 * A rational curve is a polynomial curve (w x, w y, w) above the plane, in output units.  De Casteljau's
 * algorithm cuts it at 1/2.  Where the weights of a piece have one sign, the piece lies in the convex
 * hull of its control points.  If these are near the chord, so is the piece, since the points near a
 * segment are a convex set; and the piece, which joins the ends, passes near every point of the chord. */

enum { DEEPEST = 16, COEFFICIENTS = 3 * (MAX_DEGREE + 1) };

/* The control points of a piece whose weights have one sign; 0 otherwise.  A control vector 0 has no
 * point: the curve is an average of the others, and at its end tends to the next one. */
static int control_points(int degree, const num_q H[], svg_point P[])
{
    int count = 0, sign = 0;
    for (int i = 0; i <= degree; i++) {
        num_q x = H[3 * i], y = H[3 * i + 1], w = H[3 * i + 2];
        if (cagd_is_zero_q(w) && cagd_is_zero_q(x) && cagd_is_zero_q(y))
            continue;
        if (cagd_is_zero_q(w) || sign * cagd_sign_q(w) < 0)
            return 0;
        sign = cagd_sign_q(w);
        P[count++] = (svg_point){div_q(x, w), div_q(y, w)};
    }
    return count;
}

static bool is_flat(const svg *s, int count, const svg_point P[])
{
    for (int i = 1; i < count - 1; i++)
        if (!near_segment(s, P[i], P[0], P[count - 1]))
            return false;
    return true;
}

static void flatten(struct pen *pen, int degree, const num_q H[], int depth)
{
    region_mark mark = region_open();
    svg_point P[MAX_DEGREE + 1];
    int count = control_points(degree, H, P);
    if (count > 0 && is_flat(pen->s, count, P)) {
        pen_segment(pen, P[0], P[count - 1]);
    } else if (depth < DEEPEST && (count == 0 || !outside(pen->p, count, P))) {
        num_q left[COEFFICIENTS], right[COEFFICIENTS];
        bezier_split_q(degree, 3, H, from_ratio_q(1, 2), left, right);
        flatten(pen, degree, left, depth + 1);
        flatten(pen, degree, right, depth + 1);
    }
    region_drop(mark);
}

static bool has_degree(svg *s, int degree)
{
    if (degree < 1 || degree > MAX_DEGREE)
        svg_fail(s, "the degree of a curve is between 1 and 64");
    return svg_failed(s) == NULL;
}

void svg_rational(svg *s, int degree, const num_q R[], const num_q w[], enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL || !has_degree(s, degree))
        return;
    struct pen pen = pen_new(s, p);
    num_q P[2 * (MAX_DEGREE + 1)], H[COEFFICIENTS];
    bool vanishes = true;
    region_mark mark = region_open();
    for (int i = 0; i <= degree; i++) {
        svg_point at = to_output(p, svg_pair(R + 2 * i));
        P[2 * i] = at.x;
        P[2 * i + 1] = at.y;
        vanishes = vanishes && cagd_is_zero_q(w[i]);
    }
    rational_homogenize_q(degree, 2, P, w, H);
    if (vanishes)
        svg_fail(s, "some weight of a rational curve is not 0");
    else
        flatten(&pen, degree, H, 0);
    region_drop(mark);
    pen_finish(&pen, LINES, role);
}

/* ---- Polynomial curves ------------------------------------------------------------------------ */

static void native(svg *s, struct panel *p, int degree, const num_q R[], enum svg_role role)
{
    static const char *const command[] = {"", "L", "Q", "C"};
    struct string *out = &p->layer[LINES];
    p->clipped = true;
    put(out, "<path class=\"l %s\" d=\"", role_class(s, role));
    for (int i = 0; i <= degree; i++) {
        svg_point P = to_output(p, svg_pair(R + 2 * i));
        put(out, "%s%h %h", i == 0 ? "M" : i == 1 ? command[degree] : " ", hundredths(s, P.x), hundredths(s, P.y));
    }
    put(out, "\"/>\n");
}

void svg_bezier(svg *s, int degree, const num_q R[], enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL || !has_degree(s, degree))
        return;
    region_mark mark = region_open();
    if (degree <= 3) {
        native(s, p, degree, R, role);
    } else {
        num_q one[MAX_DEGREE + 1];
        for (int i = 0; i <= degree; i++)
            one[i] = from_int_q(1);
        svg_rational(s, degree, R, one, role);
    }
    region_drop(mark);
}

/* ---- Curves given by a function --------------------------------------------------------------- */

enum { DEEPEST_CUT = 12 };

struct sample {
    num_q t;
    svg_point at; /* in output units */
    bool defined;
};

struct plot {
    struct pen pen;
    svg_curve *curve;
    const void *data;
};

static struct sample sample_at(const struct plot *f, num_q t)
{
    unsigned before = region_faults;
    region_faults = 0;
    svg_point at = f->curve(t, f->data);
    bool defined = (region_faults & FAULT_UNDEFINED) == 0;
    region_faults = before | (region_faults & ~(unsigned)FAULT_UNDEFINED);
    return (struct sample){t, defined ? to_output(f->pen.p, at) : at, defined};
}

/* The curve between two samples.  Where no three samples agree on a straight piece it is left open. */
static void plot_between(struct plot *f, struct sample a, struct sample b, int depth)
{
    region_mark mark = region_open();
    struct sample m = sample_at(f, mul_q(from_ratio_q(1, 2), add_q(a.t, b.t)));
    bool all = a.defined && m.defined && b.defined, none = !a.defined && !m.defined && !b.defined;
    bool unseen = none || (all && outside(f->pen.p, 3, (svg_point[]){a.at, m.at, b.at}));
    if (all && near_segment(f->pen.s, m.at, a.at, b.at)) {
        pen_segment(&f->pen, a.at, b.at);
    } else if (!unseen && depth < DEEPEST_CUT) {
        plot_between(f, a, m, depth + 1);
        plot_between(f, m, b, depth + 1);
    }
    region_drop(mark);
}

void svg_plot(svg *s, svg_curve *curve, const void *data, num_q t0, num_q t1, int pieces, enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    if (pieces < 1) {
        svg_fail(s, "a plot has one piece or more");
        return;
    }
    struct plot f = {pen_new(s, p), curve, data};
    for (int k = 0; k < pieces; k++) {
        region_mark mark = region_open();
        num_q width = div_q(sub_q(t1, t0), from_int_q(pieces));
        num_q a = add_q(t0, mul_q(from_int_q(k), width)), b = add_q(a, width);
        plot_between(&f, sample_at(&f, a), sample_at(&f, b), 0);
        region_drop(mark);
    }
    pen_finish(&f.pen, LINES, role);
}
