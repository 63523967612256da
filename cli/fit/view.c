/* view.c -- a view of points and curve: which numbers it shows, and where in it something stands. */
#include "cli/fit/picture.h"
#include "cli/ticks.h"

#include <math.h>
#include <stdlib.h>

enum {
    MARGIN = 36,   /* around what a view shows       */
    LOWEST = 220,  /* a view is from so high ...     */
    HIGHEST = 460, /* ... to so high                 */
    TICKS = 45     /* ticks are at least so far apart */
};

static void include(struct scale *s, double x)
{
    s->low = fmin(s->low, x);
    s->high = fmax(s->high, x);
}

int power_of(double size)
{
    int e = size > 0 ? (int)floor(log10(size)) : 0;
    return e >= 6 || e <= -4 ? e : 0;
}

static num_q times_power(num_q x, int e)
{
    num_q ten = from_int_q(10);
    for (int i = 0; i < abs(e); i++)
        x = e > 0 ? mul_q(x, ten) : div_q(x, ten);
    return x;
}

num_q scaled(double x, int e) { return times_power(from_double_q(x), -e); }

/* What is subtracted from coordinates of an interval that is so far from 0 that ticks would have more than some five digits: a number
 * with few digits that is no farther from it than ten times its length. */
static double base_of(const struct scale *s, double size)
{
    double far = fmin(fabs(s->low), fabs(s->high)), unit = pow(10, ceil(log10(size)));
    return s->low * s->high > 0 && far > 2e4 * size ? unit * 10 * trunc(s->low / (10 * unit)) : 0;
}

num_q shown(const struct view *v, double x) { return scaled(x, v->power); }

svg_point shown_from(const struct view *v, const double origin[], const double P[])
{
    num_q at[2];
    for (int k = 0; k < 2; k++) {
        int c = k == 0 ? v->a : v->b;
        num_q x = sub_q(from_double_q(P[c]), from_double_q(v->base[k]));
        x = origin != NULL ? add_q(x, from_double_q(origin[c])) : x;
        at[k] = times_power(x, -v->power);
    }
    return svg_pair(at);
}

svg_point control_point(const struct view *v, int j)
{
    const cagd_fit_result *r = v->f->result;
    return shown_from(v, r->origin, r->relative + j * r->curve.dim);
}

int inside(const struct view *v, int j)
{
    svg_point at = control_point(v, j);
    double x = to_double_q(at.x), y = to_double_q(at.y);
    return v->x.low <= x && x <= v->x.high && v->y.low <= y && y <= v->y.high;
}

struct beyond beyond_border(const struct view *v, int j)
{
    const double low[2] = {v->x.low, v->y.low}, high[2] = {v->x.high, v->y.high};
    double from[2] = {0, 0}, to[2], part = 1, longer = fmax(high[0] - low[0], high[1] - low[1]), length;
    int seen = 0;
    struct beyond b;
    for (int k = j - 1; k <= j + 1; k += 2)
        if (k >= 0 && k < v->f->result->curve.count && inside(v, k)) {
            svg_point at = control_point(v, k);
            from[0] += to_double_q(at.x), from[1] += to_double_q(at.y);
            seen++;
        }
    svg_point at = control_point(v, j);
    to[0] = to_double_q(at.x), to[1] = to_double_q(at.y);
    for (int c = 0; c < 2; c++)
        from[c] = seen > 0 ? from[c] / seen : (low[c] + high[c]) / 2;
    for (int c = 0; c < 2; c++) {
        if (to[c] > high[c])
            part = fmin(part, (high[c] - from[c]) / (to[c] - from[c]));
        if (to[c] < low[c])
            part = fmin(part, (low[c] - from[c]) / (to[c] - from[c]));
    }
    length = hypot(to[0] - from[0], to[1] - from[1]);
    for (int c = 0; c < 2; c++) {
        b.at[c] = from[c] + part * (to[c] - from[c]);
        b.direction[c] = (to[c] - from[c]) / length * longer;
    }
    return b;
}

/* Points and feet; and the control points unless the window would become more than twice as large. */
static struct view new_view(const struct fit *f, int a, int b, int width)
{
    const cagd_spline *c = &f->result->curve;
    struct view v = {f, a, b, {0, 0}, 0, {INFINITY, -INFINITY, {0}}, {INFINITY, -INFINITY, {0}}};
    int dim = c->dim;
    for (int i = 0; i < f->data.count; i++)
        for (int k = 0; k < 2; k++) {
            int at = i * dim + (k == 0 ? a : b);
            double q = f->data.points[at], foot = q - f->result->residuals[at];
            struct scale *s = k == 0 ? &v.x : &v.y;
            include(s, q);
            include(s, foot);
        }
    struct scale x = v.x, y = v.y;
    for (int j = 0; j < c->count; j++) {
        include(&x, c->points[j * dim + a]);
        include(&y, c->points[j * dim + b]);
    }
    if (fmax(x.high - x.low, y.high - y.low) <= 2 * fmax(v.x.high - v.x.low, v.y.high - v.y.low)) {
        v.x = x;
        v.y = y;
    }
    double extent = fmax(v.x.high - v.x.low, v.y.high - v.y.low);
    v.power = power_of(extent);
    v.base[0] = base_of(&v.x, extent);
    v.base[1] = base_of(&v.y, extent);
    double unit = pow(10, v.power), room = extent / unit * MARGIN / width;
    v.x = (struct scale){(v.x.low - v.base[0]) / unit - room, (v.x.high - v.base[0]) / unit + room, {0}};
    v.y = (struct scale){(v.y.low - v.base[1]) / unit - room, (v.y.high - v.base[1]) / unit + room, {0}};
    return v;
}

/* Widens the window to the shape of a panel of that width whose height is between the bounds. */
static void shape(struct view *v, int width)
{
    double dx = v->x.high - v->x.low, dy = v->y.high - v->y.low, middle;
    if (dy < dx * LOWEST / width) {
        middle = (v->y.low + v->y.high) / 2;
        dy = dx * LOWEST / width;
        v->y.low = middle - dy / 2;
        v->y.high = middle + dy / 2;
    } else if (dy > dx * HIGHEST / width) {
        middle = (v->x.low + v->x.high) / 2;
        dx = dy * width / HIGHEST;
        v->x.low = middle - dx / 2;
        v->x.high = middle + dx / 2;
    }
    v->x.step = v->y.step = nice_step(dx, width / TICKS);
}

struct view view_of(const struct fit *f, int a, int b, int width)
{
    struct view v = new_view(f, a, b, width);
    shape(&v, width);
    return v;
}

int any_beyond(const struct view *v)
{
    for (int j = 0; j < own_points(v->f); j++)
        if (!inside(v, j))
            return 1;
    return 0;
}
