/* picture.c -- what was got over what was expected, drawn; see lab.h. */
#include "cli/lab/lab.h"
#include "figures/svg.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_PLACES = 64, WIDTH = 330, HEIGHT = 220, TICKS = 4 };

/* One panel: values at increasing places; {NULL} where there is none. */
struct graph {
    int count;
    num_q at[MOST_PLACES], got[MOST_PLACES], wanted[MOST_PLACES];
};

static const char *member(const json_t *row, const char *key)
{
    const char *text = json_string_value(json_object_get(row, key));
    return text != NULL ? text : "";
}

static const char *member_at(const json_t *row, const char *key, int k)
{
    const char *text = json_string_value(json_array_get(json_object_get(row, key), (size_t)k));
    return text != NULL ? text : "";
}

static num_q number_of(const json_t *list, int k)
{
    const char *text = json_string_value(json_array_get(list, (size_t)k));
    return text != NULL && cagd_code_is_number(text) ? from_string_q(text) : (num_q){NULL};
}

static void read_graph(const json_t *row, struct graph *g)
{
    const json_t *at = json_object_get(row, "at");
    g->count = json_array_size(at) < MOST_PLACES ? (int)json_array_size(at) : MOST_PLACES;
    for (int k = 0; k < g->count; k++) {
        g->at[k] = number_of(at, k);
        g->got[k] = number_of(json_object_get(row, "got"), k);
        g->wanted[k] = number_of(json_object_get(row, "expected"), k);
    }
}

/* The least and the greatest of the values, with room around them. */
static void extent_of(const struct graph *g, num_q *low, num_q *high)
{
    *low = *high = (num_q){NULL};
    for (int k = 0; k < 2 * g->count; k++) {
        num_q y = k < g->count ? g->wanted[k] : g->got[k - g->count];
        if (y.at == NULL)
            continue;
        if (low->at == NULL || cagd_compare_q(y, *low) < 0)
            *low = y;
        if (high->at == NULL || cagd_compare_q(y, *high) > 0)
            *high = y;
    }
    if (low->at == NULL)
        *low = *high = from_int_q(0);
    num_q room = div_q(sub_q(*high, *low), from_int_q(10));
    if (cagd_is_zero_q(room))
        room = from_int_q(1);
    *low = sub_q(*low, room), *high = add_q(*high, room);
}

/* 1, 2 or 5 times a power of 10, so that a length has about TICKS of it. */
static num_q tick_of(num_q length)
{
    num_q step = from_int_q(1), ten = from_int_q(10), wanted = div_q(length, from_int_q(TICKS));
    for (int k = 0; k < 60 && cagd_compare_q(step, wanted) > 0; k++)
        step = div_q(step, ten);
    for (int k = 0; k < 60 && cagd_compare_q(mul_q(step, ten), wanted) <= 0; k++)
        step = mul_q(step, ten);
    return cagd_compare_q(mul_q(step, from_int_q(5)), wanted) <= 0   ? mul_q(step, from_int_q(5))
           : cagd_compare_q(mul_q(step, from_int_q(2)), wanted) <= 0 ? mul_q(step, from_int_q(2))
                                                                     : step;
}

/* Through neighbours that have a value; with marks, where the places are numbers of results. */
static void draw_values(svg *s, const struct graph *g, const num_q y[], enum svg_role role, int marked)
{
    num_q P[2 * MOST_PLACES];
    int count = 0;
    for (int k = 0; k <= g->count; k++) {
        if (k < g->count && y[k].at != NULL) {
            P[2 * count] = g->at[k], P[2 * count + 1] = y[k], count++;
            if (marked)
                svg_mark(s, svg_pair(P + 2 * count - 2), role, SVG_USUAL);
            continue;
        }
        if (count > 1)
            svg_polyline(s, count, P, role);
        count = 0;
    }
}

static void draw_panel(svg *s, const json_t *requirement)
{
    const json_t *row = json_object_get(requirement, "graph");
    const char *over = member(row, "over"), *where = member(requirement, "case");
    struct graph g;
    num_q low, high;
    char caption[400], axis[40];
    read_graph(row, &g);
    if (g.count < 1 || g.at[0].at == NULL)
        return;
    extent_of(&g, &low, &high);
    num_q first = g.at[0], last = g.at[g.count - 1], room = *over == 0 ? from_ratio_q(1, 4) : from_int_q(0);
    if (cagd_equal_q(first, last))
        room = from_int_q(1);
    svg_window window = {sub_q(first, room), low, add_q(last, room), high};
    snprintf(caption, sizeof caption, "%.200s%s%.60s%s%.30s", member(requirement, "name"), *where != 0 ? ", " : "",
             where, *over != 0 ? ": " : "", *over != 0 ? member(row, "of") : "");
    for (char *at = caption; *at != 0; at++) /* no markup */
        *at = *at == '$' || *at == '\\' ? ' ' : *at;
    snprintf(axis, sizeof axis, "%.30s", over);
    svg_panel(s, window, WIDTH, HEIGHT, caption);
    svg_frame(s);
    svg_scales(s, *over != 0 ? tick_of(sub_q(last, first)) : from_int_q(1), tick_of(sub_q(high, low)),
               *over != 0 ? axis : NULL, NULL);
    draw_values(s, &g, g.wanted, SVG_RIGHT, *over == 0);
    draw_values(s, &g, g.got, SVG_WRONG, *over == 0);
    for (int k = 0; k < g.count; k++)
        if (strcmp(member(row, "here"), member_at(row, "at", k)) == 0) { /* the counterexample */
            if (g.wanted[k].at != NULL)
                svg_mark(s, (svg_point){g.at[k], g.wanted[k]}, SVG_RIGHT, SVG_USUAL);
            if (g.got[k].at != NULL)
                svg_mark(s, (svg_point){g.at[k], g.got[k]}, SVG_WRONG, SVG_USUAL);
        }
}

char *lab_picture(const char *name, const json_t *result)
{
    char title[300], *text = NULL;
    size_t k;
    const json_t *row;
    int panels = 0;
    cagd_region_mark mark = cagd_region_open();
    snprintf(title, sizeof title, "%.250s", member(result, "title"));
    svg *s = svg_new(name, title,
                     "What the answer computes, dashed, over what is expected, for the numbers that were found.");
    json_array_foreach(json_object_get(result, "requirements"), k, row) if (json_object_get(row, "graph") != NULL)
    {
        if (panels % 2 == 0 && panels > 0)
            svg_row(s);
        draw_panel(s, row);
        panels++;
    }
    svg_legend_line(s, SVG_RIGHT, "expected");
    svg_legend_line(s, SVG_WRONG, "this answer");
    const char *made = panels > 0 ? svg_text(s) : NULL;
    if (made != NULL && svg_failed(s) == NULL)
        text = strdup(made);
    svg_free(s);
    cagd_region_drop(mark);
    return text;
}
