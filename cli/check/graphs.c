#include "cli/check/graphs.h"

#include "cli/tex.h"
#include "core/number/limits.h"
#include "exact/words.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SAMPLES = 64, PANEL_WIDTH = 300, PANEL_HEIGHT = 220, PIECES = 64, LONGEST = 160 };

struct graph {
    const cagd_basis *basis;
    num_f f; /* a function of t alone */
};

/* The variable of the functions where the argument is t: itself, or of an angle the tangent of its part. */
static num_q variable_at(const cagd_basis *b, num_q t)
{
    return b->angle ? from_double_q(tan(to_double_q(t) / b->angle)) : t;
}

/* The ends of the argument. */
static num_q end_of(const cagd_basis *b, int high)
{
    num_q x = high ? b->t.high : b->t.low;
    return b->angle ? from_double_q(b->angle * atan(to_double_q(x))) : x;
}

static num_q value_at(const struct graph *g, num_q t)
{
    num_q y = from_int_q(0);
    is_constant_f(substitute_f(g->f, g->basis->t.variable, from_rational_f(variable_at(g->basis, t))), &y);
    return y;
}

static svg_point point_at(num_q t, const void *data) { return (svg_point){t, value_at(data, t)}; }

static struct graph graph_of(const cagd_basis *b, int i, const num_q *parameter)
{
    struct graph g = {b, b->function[i]};
    if (parameter != NULL)
        g.f = substitute_f(g.f, b->range.variable, from_rational_f(*parameter));
    return g;
}

static num_q sample(const cagd_basis *b, int k)
{
    num_q low = end_of(b, 0);
    return add_q(low, mul_q(sub_q(end_of(b, 1), low), from_ratio_q(k, SAMPLES)));
}

/* A polynomial is the Bezier curve of the points (a + (b-a) j/d, c_j). */
static void draw_graph(svg *s, const cagd_basis *b, int i, const num_q *parameter, enum svg_role role)
{
    struct graph g = graph_of(b, i, parameter);
    if (b->degree < 1 || b->degree > MAX_DEGREE) {
        svg_plot(s, point_at, &g, end_of(b, 0), end_of(b, 1), PIECES, role);
        return;
    }
    num_q P[2 * (MAX_DEGREE + 1)];
    for (int j = 0; j <= b->degree; j++) {
        num_f c = b->coefficient[i * (b->degree + 1) + j];
        if (parameter != NULL)
            c = substitute_f(c, b->range.variable, from_rational_f(*parameter));
        P[2 * j] = add_q(b->t.low, mul_q(sub_q(b->t.high, b->t.low), from_ratio_q(j, b->degree)));
        P[2 * j + 1] = from_int_q(0);
        is_constant_f(c, &P[2 * j + 1]);
    }
    svg_bezier(s, b->degree, P, role);
}

/* The least and the greatest of all values at the samples, 0 and 1 among them, and for each function where it is greatest. */
static void extent_of(const cagd_basis *b, int count, const num_q value[], num_q *low, num_q *high)
{
    *low = from_int_q(0), *high = from_int_q(1);
    for (int v = 0; v < (count > 0 ? count : 1); v++)
        for (int i = 0; i < b->count; i++) {
            struct graph g = graph_of(b, i, count > 0 ? &value[v] : NULL);
            for (int k = 0; k <= SAMPLES; k++) {
                num_q y = value_at(&g, sample(b, k));
                if (cagd_compare_q(y, *low) < 0)
                    *low = y;
                if (cagd_compare_q(y, *high) > 0)
                    *high = y;
            }
        }
}

static svg_point top_of(const cagd_basis *b, int i, const num_q *parameter)
{
    struct graph g = graph_of(b, i, parameter);
    svg_point best = point_at(sample(b, 0), &g);
    for (int k = 1; k <= SAMPLES; k++) {
        svg_point p = point_at(sample(b, k), &g);
        if (cagd_compare_q(p.y, best.y) > 0)
            best = p;
    }
    return best;
}

static void label(svg *s, const struct sheet *sheet, const cagd_basis *b, int i, const num_q *parameter,
                  enum svg_role role)
{
    char tex[LONGEST];
    int head = sheet->argument_from - 1; /* without the bracket of the argument */
    snprintf(tex, sizeof tex, "%.*s{%ld}%.*s", sheet->index_from, sheet->functions, sheet->first + i,
             head - sheet->index_to, sheet->functions + sheet->index_to);
    char *text = tex_to_text(tex, 0);
    svg_point top = top_of(b, i, parameter);
    enum svg_direction towards = cagd_equal_q(top.x, end_of(b, 0))   ? SVG_NE
                                 : cagd_equal_q(top.x, end_of(b, 1)) ? SVG_NW
                                                                     : SVG_N;
    svg_mark(s, top, role, SVG_USUAL);
    svg_note(s, top, towards, role, text);
    free(text);
}

void draw_basis(svg *s, const struct sheet *sheet, const cagd_basis *b, int count, const num_q value[])
{
    num_q low, high, length = sub_q(end_of(b, 1), end_of(b, 0));
    extent_of(b, count, value, &low, &high);
    svg_window window = {end_of(b, 0), low, end_of(b, 1), high};
    svg_row(s);
    for (int v = 0; v < (count > 0 ? count : 1); v++) {
        const num_q *parameter = count > 0 ? &value[v] : NULL;
        char caption[LONGEST];
        char *name = tex_to_text(sheet->find != NULL ? sheet->find : "", 0);
        snprintf(caption, sizeof caption, parameter != NULL ? "%s, %s = %s" : "%s%s%s", sheet->name, name,
                 parameter != NULL ? to_string_q(*parameter) : "");
        free(name);
        svg_panel(s, window, PANEL_WIDTH, PANEL_HEIGHT, caption);
        svg_axes(s, b->angle ? from_ratio_q(1, 2) : div_q(length, from_int_q(2)), from_ratio_q(1, 2), NULL, NULL);
        for (int i = 0; i < b->count; i++) {
            enum svg_role role = i % 2 == 0 ? SVG_CURVE : SVG_CURVE_2;
            draw_graph(s, b, i, parameter, role);
            label(s, sheet, b, i, parameter, role);
        }
    }
}
