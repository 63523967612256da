#include "cli/check/counterexample.h"

#include "cli/tex.h"
#include "cli/ticks.h"
#include "exact/expression/sides.h"
#include "exact/words.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES = 48, PANEL_WIDTH = 300, PANEL_HEIGHT = 220, PIECES = 48, IN_A_ROW = 3, LONGEST = 400, TICKS = 5 };

struct side {
    const cagd_scope *scope;
    const cagd_finding *f;
    int name, is_right;
};

static svg_point point_at(num_q x, const void *data)
{
    const struct side *side = data;
    num_q left, right;
    if (!cagd_sides_at(side->scope, side->f, side->name, x, &left, &right)) {
        region_faults |= FAULT_UNDEFINED;
        return (svg_point){x, from_int_q(0)};
    }
    return (svg_point){x, side->is_right ? right : left};
}

static int by_size(const void *a, const void *b) { return cagd_compare_q(*(const num_q *)a, *(const num_q *)b); }

/* The window: the range of the name, and the values of both sides, without those near poles, which are far beyond the others.  The two
 * at the counterexample are in it. */
static svg_window window_of(const cagd_scope *scope, const cagd_finding *f, int name, num_q low, num_q high)
{
    num_q value[2 * SAMPLES + 2], two = from_int_q(2);
    int count = 0;
    for (int k = 0; k <= SAMPLES; k++) {
        num_q x = add_q(low, mul_q(sub_q(high, low), from_ratio_q(k, SAMPLES)));
        if (cagd_sides_at(scope, f, name, x, &value[count], &value[count + 1]))
            count += 2;
    }
    num_q bottom = f->left, top = f->left;
    if (count > 0) {
        qsort(value, (size_t)count, sizeof *value, by_size);
        num_q middle = value[count / 2],
              far = mul_q(from_int_q(6), sub_q(value[count - 1 - count / 8], value[count / 8]));
        for (int k = 0; k < count; k++) {
            num_q away = sub_q(value[k], middle);
            int near = cagd_compare_q(away, far) <= 0 && cagd_compare_q(neg_q(away), far) <= 0;
            bottom = near && cagd_compare_q(value[k], bottom) < 0 ? value[k] : bottom;
            top = near && cagd_compare_q(value[k], top) > 0 ? value[k] : top;
        }
    }
    bottom = cagd_compare_q(f->right, bottom) < 0 ? f->right : bottom;
    top = cagd_compare_q(f->right, top) > 0 ? f->right : top;
    num_q margin = div_q(sub_q(top, bottom), from_int_q(12));
    margin = cagd_is_zero_q(margin) ? div_q(from_int_q(1), two) : margin;
    return (svg_window){low, sub_q(bottom, margin), high, add_q(top, margin)};
}

/* "nonnegative, i = 1, λ = −4: fails at t = 1/10": what has one value in the panel, and where the mark is. */
static void caption_of(const struct formula *one, const cagd_finding *f, int name, char text[LONGEST])
{
    size_t used = (size_t)snprintf(text, LONGEST, "%.100s", one->name);
    for (int k = 0; k <= f->given && used < LONGEST; k++) {
        int last = k == f->given, which = last ? name : k;
        if (k == name)
            continue;
        char *plain = tex_to_text(f->example[which].name, 0);
        used += (size_t)snprintf(text + used, LONGEST - used, "%s%s = %s", last ? ": fails at " : ", ", plain,
                                 to_string_q(f->example[which].value));
        free(plain);
    }
}

int draw_counterexample(svg *s, const struct formula *one, const cagd_finding *f, int panel)
{
    num_q low, high;
    int name = f->has_example && !f->has_root ? cagd_free_name(&one->scope, f, &low, &high) : -1;
    if (name < 0)
        return 0;
    struct side left = {&one->scope, f, name, 0}, right = {&one->scope, f, name, 1};
    svg_window w = window_of(&one->scope, f, name, low, high);
    num_q x = f->example[name].value;
    char caption[LONGEST];
    caption_of(one, f, name, caption);
    if (panel % IN_A_ROW == 0)
        svg_row(s);
    svg_panel(s, w, PANEL_WIDTH, PANEL_HEIGHT, caption);
    char *letter = tex_to_text(f->example[name].name, 0);
    svg_axes(s, nice_step(to_double_q(sub_q(w.x1, w.x0)), TICKS), nice_step(to_double_q(sub_q(w.y1, w.y0)), TICKS),
             letter, NULL);
    svg_plot(s, point_at, &right, low, high, PIECES, SVG_RIGHT);
    svg_plot(s, point_at, &left, low, high, PIECES, SVG_WRONG);
    svg_segment(s, (svg_point){x, f->left}, (svg_point){x, f->right}, SVG_MUTED);
    svg_mark(s, (svg_point){x, f->right}, SVG_RIGHT, SVG_USUAL);
    svg_mark(s, (svg_point){x, f->left}, SVG_WRONG, SVG_USUAL);
    free(letter);
    return 1;
}

void draw_legend_of_counterexamples(svg *s)
{
    svg_legend_line(s, SVG_WRONG, "left side");
    svg_legend_line(s, SVG_RIGHT, "right side");
    svg_legend_mark(s, SVG_WRONG, SVG_USUAL, "where they are not as printed");
}
