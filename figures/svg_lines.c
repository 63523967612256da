/* svg_lines.c -- points, and what is drawn with straight lines. */
#include "figures/svg_parts.h"

/* ---- Clipping --------------------------------------------------------------------------------- */

/* A set of real numbers t: lo <= t <= hi, where an end without a value is infinite. */
struct range {
    num_q lo, hi;
};

/* Keeps the t with p t <= q.  False when none is left. */
static bool keep_half(struct range *r, num_q p, num_q q)
{
    if (cagd_is_zero_q(p))
        return cagd_sign_q(q) >= 0;
    num_q t = div_q(q, p);
    num_q *end = cagd_sign_q(p) > 0 ? &r->hi : &r->lo;
    if (end->at == NULL || cagd_sign_q(p) * cagd_compare_q(t, *end) < 0)
        *end = t;
    return r->lo.at == NULL || r->hi.at == NULL || cagd_compare_q(r->lo, r->hi) <= 0;
}

/* Keeps the t for which a + t d is in the window (Liang and Barsky).  False when there are none. */
static bool keep_window(const struct panel *p, svg_point a, svg_point d, struct range *r)
{
    return keep_half(r, neg_q(d.x), a.x) && keep_half(r, d.x, sub_q(kept(p->width), a.x)) &&
           keep_half(r, neg_q(d.y), a.y) && keep_half(r, d.y, sub_q(kept(p->height), a.y));
}

static svg_point along(svg_point a, svg_point d, num_q t)
{
    return (svg_point){add_q(a.x, mul_q(t, d.x)), add_q(a.y, mul_q(t, d.y))};
}

static svg_point difference(svg_point b, svg_point a) { return (svg_point){sub_q(b.x, a.x), sub_q(b.y, a.y)}; }

static num_q dot(svg_point a, svg_point b) { return add_q(mul_q(a.x, b.x), mul_q(a.y, b.y)); }

svg_point middle(svg_point a, svg_point b) { return along(a, difference(b, a), from_ratio_q(1, 2)); }

bool outside(const struct panel *p, int count, const svg_point *P)
{
    bool left = true, right = true, above = true, below = true;
    for (int i = 0; i < count; i++) {
        left = left && cagd_sign_q(P[i].x) < 0;
        above = above && cagd_sign_q(P[i].y) < 0;
        right = right && cagd_compare_q(P[i].x, kept(p->width)) > 0;
        below = below && cagd_compare_q(P[i].y, kept(p->height)) > 0;
    }
    return left || right || above || below;
}

/* With d = b - a and v = P - a: beside the segment, 0 <= v.d <= d.d, the distance is |v x d| / |d|;
 * elsewhere it is that from the nearer end. */
bool near_segment(const svg *s, svg_point P, svg_point a, svg_point b)
{
    svg_point d = difference(b, a), v = difference(P, a);
    num_q along_d = dot(v, d), length2 = dot(d, d), tolerance2 = mul_q(kept(s->tolerance), kept(s->tolerance));
    if (cagd_sign_q(along_d) <= 0)
        return cagd_compare_q(dot(v, v), tolerance2) <= 0;
    if (cagd_compare_q(along_d, length2) >= 0) {
        svg_point e = difference(P, b);
        return cagd_compare_q(dot(e, e), tolerance2) <= 0;
    }
    num_q cross = sub_q(mul_q(v.x, d.y), mul_q(v.y, d.x));
    return cagd_compare_q(mul_q(cross, cross), mul_q(tolerance2, length2)) <= 0;
}

/* ---- The pen ---------------------------------------------------------------------------------- */

struct pen pen_new(svg *s, struct panel *p) { return (struct pen){.s = s, .p = p}; }

/* Goes straight from a to b, both in the window.  Steps that vanish in rounding are left out. */
static void pen_draw(struct pen *pen, svg_point a, svg_point b)
{
    long ax = hundredths(pen->s, a.x), ay = hundredths(pen->s, a.y);
    long bx = hundredths(pen->s, b.x), by = hundredths(pen->s, b.y);
    bool onwards = pen->down && pen->x == ax && pen->y == ay;
    if (ax == bx && ay == by && onwards)
        return;
    if (!onwards)
        put(&pen->path, "M%h %h", ax, ay);
    put(&pen->path, "L%h %h", bx, by);
    pen->down = true;
    pen->x = bx;
    pen->y = by;
}

static void pen_clipped(struct pen *pen, svg_point a, svg_point b, struct range r)
{
    svg_point d = difference(b, a);
    if (keep_window(pen->p, a, d, &r))
        pen_draw(pen, along(a, d, r.lo), along(a, d, r.hi));
}

void pen_segment(struct pen *pen, svg_point a, svg_point b)
{
    region_mark mark = region_open();
    pen_clipped(pen, a, b, (struct range){from_int_q(0), from_int_q(1)});
    region_drop(mark);
}

void pen_finish(struct pen *pen, enum layer layer, enum svg_role role)
{
    struct string *out = &pen->p->layer[layer];
    if (pen->path.broken)
        svg_fail(pen->s, "memory is short");
    else if (pen->path.used > 0)
        put(out, "<path class=\"l %s\" d=\"%s\"/>\n", role_class(pen->s, role), content(&pen->path));
    free_string(&pen->path);
}

/* ---- Points and lines ------------------------------------------------------------------------- */

void svg_mark(svg *s, svg_point at, enum svg_role role, enum svg_shape shape)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    region_mark mark = region_open();
    svg_point P = to_output(p, at);
    put_mark(s, &p->layer[MARKS], hundredths(s, P.x), hundredths(s, P.y), role, shape);
    region_drop(mark);
}

/* Dots of paths without length, whose round ends the viewer draws; a dot that falls on the one before is left out. */
void svg_cloud(svg *s, int count, const num_q P[], int diameter, enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL || count < 1)
        return;
    struct string *out = &p->layer[GROUND];
    put(out, "<path class=\"p %s\" stroke-width=\"%h\" d=\"", role_class(s, role), (long)diameter);
    s->clouded = true;
    long x = 0, y = 0;
    for (int i = 0; i < count; i++) {
        region_mark mark = region_open();
        svg_point at = to_output(p, svg_pair(P + 2 * i));
        long new_x = hundredths(s, at.x), new_y = hundredths(s, at.y);
        if (i == 0 || new_x != x || new_y != y)
            put(out, "M%h %hh0", new_x, new_y);
        x = new_x;
        y = new_y;
        region_drop(mark);
    }
    put(out, "\"/>\n");
}

void svg_polyline(svg *s, int count, const num_q P[], enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    struct pen pen = pen_new(s, p);
    region_mark mark = region_open();
    for (int i = 1; i < count; i++)
        pen_segment(&pen, to_output(p, svg_pair(P + 2 * i - 2)), to_output(p, svg_pair(P + 2 * i)));
    region_drop(mark);
    pen_finish(&pen, LINES, role);
}

void svg_segment(svg *s, svg_point a, svg_point b, enum svg_role role)
{
    svg_polyline(s, 2, (num_q[]){a.x, a.y, b.x, b.y}, role);
}

void svg_line(svg *s, svg_point a, svg_point b, enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    if (cagd_equal_q(a.x, b.x) && cagd_equal_q(a.y, b.y)) {
        svg_fail(s, "a line needs two points");
        return;
    }
    struct pen pen = pen_new(s, p);
    region_mark mark = region_open();
    pen_clipped(&pen, to_output(p, a), to_output(p, b), (struct range){{NULL}, {NULL}});
    region_drop(mark);
    pen_finish(&pen, LINES, role);
}

/* The square root of a > 0, rounded down to a multiple of 1/1000 (and at least that). */
static num_q length_of(num_q a)
{
    mpz_t n;
    mpz_init(n);
    mpz_mul_ui(n, mpq_numref(a.at), 1000000);
    mpz_fdiv_q(n, n, mpq_denref(a.at));
    mpz_sqrt(n, n);
    if (mpz_sgn(n) == 0)
        mpz_set_ui(n, 1);
    mpq_t root;
    mpq_init(root);
    mpq_set_z(root, n);
    mpz_clear(n);
    num_q length = div_q(from_mpq_q(root), from_int_q(1000));
    mpq_clear(root);
    return length;
}

/* The head is 8 units long and 6 wide; the shaft ends inside it. */
static void put_arrow(svg *s, struct panel *p, svg_point a, svg_point b, enum svg_role role)
{
    svg_point d = difference(b, a);
    num_q length = length_of(dot(d, d));
    svg_point e = {div_q(d.x, length), div_q(d.y, length)}, n = {neg_q(e.y), e.x};
    svg_point neck = along(b, e, from_int_q(-6)), back = along(b, e, from_int_q(-8));
    svg_point wing[] = {along(back, n, from_int_q(3)), b, along(back, n, from_int_q(-3)), neck};
    const char *class = role_class(s, role);
    put(&p->layer[MARKS], "<path class=\"l %s\" d=\"M%h %hL%h %h\"/>\n", class, hundredths(s, a.x), hundredths(s, a.y),
        hundredths(s, neck.x), hundredths(s, neck.y));
    put(&p->layer[MARKS], "<path class=\"c %s\" d=\"", class);
    for (int i = 0; i < 4; i++)
        put(&p->layer[MARKS], "%s%h %h", i == 0 ? "M" : "L", hundredths(s, wing[i].x), hundredths(s, wing[i].y));
    put(&p->layer[MARKS], "Z\"/>\n");
}

void svg_arrow(svg *s, svg_point tail, svg_point head, enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    region_mark mark = region_open();
    if (cagd_equal_q(tail.x, head.x) && cagd_equal_q(tail.y, head.y))
        svg_fail(s, "an arrow needs two points");
    else
        put_arrow(s, p, to_output(p, tail), to_output(p, head), role);
    region_drop(mark);
}

void svg_area(svg *s, int count, const num_q P[], enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    struct string *out = &p->layer[LINES];
    p->clipped = true;
    put(out, "<path ");
    put_area_class(s, out, role);
    put(out, " fill-rule=\"evenodd\" d=\"");
    region_mark mark = region_open();
    for (int i = 0; i < count; i++) {
        svg_point Q = to_output(p, svg_pair(P + 2 * i));
        put(out, "%s%h %h", i == 0 ? "M" : "L", hundredths(s, Q.x), hundredths(s, Q.y));
    }
    region_drop(mark);
    put(out, "Z\"/>\n");
}

void svg_circle(svg *s, svg_point centre, num_q radius, enum svg_role role)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    if (cagd_sign_q(radius) <= 0) {
        svg_fail(s, "the radius of a circle is positive");
        return;
    }
    region_mark mark = region_open();
    svg_point C = to_output(p, centre);
    p->clipped = true;
    put(&p->layer[LINES], "<ellipse class=\"l %s\" cx=\"%h\" cy=\"%h\" rx=\"%h\" ry=\"%h\"/>\n", role_class(s, role),
        hundredths(s, C.x), hundredths(s, C.y), hundredths(s, mul_q(radius, kept(p->scale_x))),
        hundredths(s, mul_q(radius, kept(p->scale_y))));
    region_drop(mark);
}

/* A label stands away from the neighbours of its point. */
static enum svg_direction outwards(int degree, const num_q R[], int i)
{
    int before = i > 0 ? i - 1 : degree > 0, after = i < degree ? i + 1 : i > 0 ? i - 1 : 0;
    return svg_direction_of(middle(svg_pair(R + 2 * before), svg_pair(R + 2 * after)), svg_pair(R + 2 * i));
}

void svg_control_polygon(svg *s, int degree, const num_q R[], const char *letter)
{
    svg_control_polygon_towards(s, degree, R, letter, NULL);
}

void svg_control_polygon_towards(svg *s, int degree, const num_q R[], const char *letter,
                                 const enum svg_direction towards[])
{
    svg_polyline(s, degree + 1, R, SVG_POLYGON);
    for (int i = 0; i <= degree; i++) {
        region_mark mark = region_open();
        svg_point P = svg_pair(R + 2 * i);
        struct string name = {0};
        put(&name, "%s_{%d}", letter, i);
        svg_mark(s, P, SVG_POLYGON, SVG_USUAL);
        svg_label(s, P, towards != NULL ? towards[i] : outwards(degree, R, i), SVG_POINT, content(&name));
        drop_string(s, &name);
        region_drop(mark);
    }
}
