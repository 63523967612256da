/* svg_contour.c -- curves F = 0 and regions F > 0, by exact signs on a grid (marching squares).
 *
 * The grid has a vertex at every (i, j), 0 <= i < columns, 0 <= j < rows.  Its edges join neighbours;
 * where the signs of an edge's ends differ, the contour crosses it, at a point found by bisection.  Each
 * cell joins the crossings on its sides in pairs, so that the crossings form chains.
 *
 * For a region the grid has one more ring of vertices, which lie on the border of the window but
 * count as outside: every chain is then closed, and runs along the border where the region meets it. */
#include "figures/svg_parts.h"

#include <stdlib.h>

enum { MAX_CELLS = 512, NOWHERE = -1 };

struct edge {
    long x, y;   /* where the contour crosses it */
    int next[2]; /* the crossings joined to this, or NOWHERE */
    bool crossed, drawn;
};

struct grid {
    svg *s;
    struct panel *p;
    svg_field *F;
    const void *data;
    int cells_x, cells_y, ring; /* cells in the window; 1 if there is one more ring of vertices */
    int columns, rows;          /* vertices, those of the ring included */
    bool *inside;               /* F > 0, at vertex j columns + i */
    struct edge *edge;          /* first the edges towards i + 1, then those towards j + 1; by their first vertex */
};

static int smaller(int a, int b) { return a < b ? a : b; }

/* The vertex in the world; those of the ring have the place of their neighbour on the border. */
static svg_point vertex(const struct grid *g, int i, int j)
{
    int a = smaller(i > g->ring ? i - g->ring : 0, g->cells_x), b = smaller(j > g->ring ? j - g->ring : 0, g->cells_y);
    const struct panel *p = g->p;
    num_q u = from_ratio_q(a, g->cells_x), v = from_ratio_q(b, g->cells_y);
    return (svg_point){add_q(kept(p->x0), mul_q(u, sub_q(kept(p->x1), kept(p->x0)))),
                       add_q(kept(p->y0), mul_q(v, sub_q(kept(p->y1), kept(p->y0))))};
}

static bool is_inside(const struct grid *g, svg_point at)
{
    unsigned before = region_faults;
    region_faults = 0;
    bool positive = cagd_sign_q(g->F(at, g->data)) > 0;
    if (region_faults != 0)
        svg_fail(g->s, "the function of a contour is undefined somewhere in the window");
    region_faults |= before;
    return positive;
}

static bool in_ring(const struct grid *g, int i, int j)
{
    return g->ring > 0 && (i == 0 || j == 0 || i == g->columns - 1 || j == g->rows - 1);
}

static void find_signs(struct grid *g)
{
    for (int j = 0; j < g->rows; j++)
        for (int i = 0; i < g->columns; i++) {
            region_mark mark = region_open();
            g->inside[j * g->columns + i] = !in_ring(g, i, j) && is_inside(g, vertex(g, i, j));
            region_drop(mark);
        }
}

/* The crossing between an inside point a and an outside point b, which share x or y: halved until they
 * are half a hundredth apart. */
static void find_crossing(const struct grid *g, struct edge *e, svg_point a, svg_point b)
{
    svg_point A = to_output(g->p, a), B = to_output(g->p, b);
    long apart = 2 * hundredths(g->s, add_q(sub_q(A.x, B.x), sub_q(A.y, B.y)));
    for (; apart != 0; apart /= 2) {
        svg_point m = middle(a, b);
        *(is_inside(g, m) ? &a : &b) = m;
    }
    A = to_output(g->p, a);
    *e = (struct edge){hundredths(g->s, A.x), hundredths(g->s, A.y), {NOWHERE, NOWHERE}, true, false};
}

/* The edges of the vertex (i, j) towards i + 1 and towards j + 1. */
static int across(const struct grid *g, int i, int j) { return j * g->columns + i; }
static int upwards(const struct grid *g, int i, int j) { return (g->rows + j) * g->columns + i; }

static void find_crossings(struct grid *g)
{
    for (int j = 0; j < g->rows; j++)
        for (int i = 0; i < g->columns; i++)
            for (int up = 0; up <= 1; up++) {
                int k = up ? i : i + 1, l = up ? j + 1 : j;
                if (k == g->columns || l == g->rows)
                    continue;
                bool here = g->inside[j * g->columns + i];
                if (here == g->inside[l * g->columns + k])
                    continue;
                region_mark mark = region_open();
                svg_point P = vertex(g, i, j), Q = vertex(g, k, l);
                find_crossing(g, &g->edge[up ? upwards(g, i, j) : across(g, i, j)], here ? P : Q, here ? Q : P);
                region_drop(mark);
            }
}

static void join(struct grid *g, int e, int f)
{
    struct edge *E = &g->edge[e], *F = &g->edge[f];
    E->next[E->next[0] != NOWHERE] = f;
    F->next[F->next[0] != NOWHERE] = e;
}

/* Two crossed sides are joined; of four, the opposite ones. */
static void join_cells(struct grid *g)
{
    for (int j = 0; j + 1 < g->rows; j++)
        for (int i = 0; i + 1 < g->columns; i++) {
            int side[] = {across(g, i, j), across(g, i, j + 1), upwards(g, i, j), upwards(g, i + 1, j)};
            int crossed[4], count = 0;
            for (int k = 0; k < 4; k++)
                if (g->edge[side[k]].crossed)
                    crossed[count++] = side[k];
            for (int k = 0; k + 1 < count; k += 2)
                join(g, crossed[k], crossed[k + 1]);
        }
}

/* The turn from a over b to c is none: b may be left out. */
static bool straight(const struct edge *a, const struct edge *b, const struct edge *c)
{
    long ux = b->x - a->x, uy = b->y - a->y, vx = c->x - b->x, vy = c->y - b->y;
    return ux * vy == uy * vx && ux * vx + uy * vy >= 0;
}

static struct edge *successor(const struct grid *g, const struct edge *e)
{
    for (int k = 0; k < 2; k++)
        if (e->next[k] != NOWHERE && !g->edge[e->next[k]].drawn)
            return &g->edge[e->next[k]];
    return NULL;
}

static void put_chain(struct grid *g, struct string *out, struct edge *first)
{
    bool closed = first->next[1] != NOWHERE;
    const struct edge *corner = first; /* the last point that was put */
    put(out, "M%h %h", first->x, first->y);
    for (struct edge *e = first, *next; e != NULL; e = next) {
        e->drawn = true;
        next = successor(g, e);
        if (e != first && (next == NULL || !straight(corner, e, next))) {
            put(out, "L%h %h", e->x, e->y);
            corner = e;
        }
    }
    put(out, closed ? "Z" : "");
}

/* The open chains first, from an end; what is left then is closed. */
static void put_chains(struct grid *g, struct string *out)
{
    for (int closed = 0; closed <= 1; closed++)
        for (int k = 0; k < 2 * g->rows * g->columns; k++) {
            struct edge *e = &g->edge[k];
            if (e->crossed && !e->drawn && (closed || e->next[1] == NOWHERE))
                put_chain(g, out, e);
        }
}

/* The path of the contour; "" where F has one sign. */
static struct string contour(svg *s, struct panel *p, svg_field *F, const void *data, int cells, int ring)
{
    struct string path = {0};
    region_mark mark = region_open();
    bool wide = cagd_compare_q(kept(p->width), kept(p->height)) >= 0;
    mpq_srcptr longer = wide ? p->width : p->height, shorter = wide ? p->height : p->width;
    int fewer = 1 + (int)(hundredths(s, mul_q(from_int_q(cells), div_q(kept(shorter), kept(longer)))) - 1) / 100;
    region_drop(mark);
    struct grid g = {.s = s, .p = p, .F = F, .data = data, .ring = ring};
    g.cells_x = wide ? cells : fewer;
    g.cells_y = wide ? fewer : cells;
    g.columns = g.cells_x + 1 + 2 * ring;
    g.rows = g.cells_y + 1 + 2 * ring;
    size_t vertices = (size_t)g.columns * (size_t)g.rows;
    g.inside = calloc(vertices, sizeof *g.inside);
    g.edge = calloc(2 * vertices, sizeof *g.edge);
    if (g.inside == NULL || g.edge == NULL) {
        svg_fail(s, "memory is short");
    } else {
        find_signs(&g);
        find_crossings(&g);
        join_cells(&g);
        put_chains(&g, &path);
    }
    free(g.inside);
    free(g.edge);
    return path;
}

static struct panel *panel_for_contour(svg *s, int cells)
{
    struct panel *p = svg_current(s);
    if (p == NULL || (cells >= 1 && cells <= MAX_CELLS))
        return p;
    svg_fail(s, "the grid of a contour has 1 to 512 cells");
    return NULL;
}

void svg_implicit(svg *s, svg_field *F, const void *data, int cells, enum svg_role role)
{
    struct panel *p = panel_for_contour(s, cells);
    if (p == NULL)
        return;
    struct string path = contour(s, p, F, data, cells, 0);
    if (path.used > 0)
        put(&p->layer[LINES], "<path class=\"l %s\" d=\"%s\"/>\n", role_class(s, role), content(&path));
    drop_string(s, &path);
}

void svg_region(svg *s, svg_field *F, const void *data, int cells, enum svg_role role)
{
    struct panel *p = panel_for_contour(s, cells);
    if (p == NULL)
        return;
    struct string path = contour(s, p, F, data, cells, 1);
    if (path.used > 0) {
        put(&p->layer[LINES], "<path ");
        put_area_class(s, &p->layer[LINES], role);
        put(&p->layer[LINES], " fill-rule=\"evenodd\" d=\"%s\"/>\n", content(&path));
    }
    drop_string(s, &path);
}
