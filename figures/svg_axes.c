/* svg_axes.c -- frames, grids, axes with their ticks, and matrices as tinted cells. */
#include "figures/svg_parts.h"

#include <string.h>

enum { MAX_TICKS = 200 };

void svg_frame(svg *s)
{
    struct panel *p = svg_current(s);
    if (p != NULL)
        put(&p->layer[GROUND], "<rect class=\"l %s\" width=\"%h\" height=\"%h\"/>\n", role_class(s, SVG_AXIS),
            hundredths(s, kept(p->width)), hundredths(s, kept(p->height)));
}

/* The integers k with lo <= k step <= hi; none for step = 0. */
struct ticks {
    long first, last;
};
static struct ticks ticks_of(svg *s, num_q lo, num_q hi, num_q step)
{
    struct ticks none = {0, -1}, ticks = none;
    if (cagd_is_zero_q(step))
        return none;
    region_mark mark = region_open();
    num_q low = div_q(lo, step), high = div_q(hi, step);
    mpz_t first, last;
    mpz_inits(first, last, (mpz_ptr)0);
    mpz_cdiv_q(first, mpq_numref(low.at), mpq_denref(low.at));
    mpz_fdiv_q(last, mpq_numref(high.at), mpq_denref(high.at));
    if (cagd_sign_q(step) > 0 && mpz_fits_slong_p(first) && mpz_fits_slong_p(last))
        ticks = (struct ticks){mpz_get_si(first), mpz_get_si(last)};
    mpz_sub(last, last, first);
    if (cagd_sign_q(step) < 0 || mpz_cmp_ui(last, MAX_TICKS) > 0) {
        svg_fail(s, "an axis has at most 200 ticks, a positive step apart");
        ticks = none;
    }
    mpz_clears(first, last, (mpz_ptr)0);
    region_drop(mark);
    return ticks;
}

/* Where the multiple k of the step lies, in hundredths, on the axis whose point `origin` is drawn at 0. */
static long tick_at(svg *s, long k, num_q step, num_q origin, num_q scale)
{
    region_mark mark = region_open();
    long at = hundredths(s, mul_q(sub_q(mul_q(from_int_q(k), step), origin), scale));
    region_drop(mark);
    return at;
}

void svg_grid(svg *s, num_q dx, num_q dy)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    struct string *out = &p->layer[GROUND];
    struct ticks x = ticks_of(s, kept(p->x0), kept(p->x1), dx), y = ticks_of(s, kept(p->y0), kept(p->y1), dy);
    region_mark mark = region_open();
    num_q down = neg_q(kept(p->scale_y));
    put(out, "<path class=\"grid\" d=\"");
    for (long k = x.first; k <= x.last; k++)
        put(out, "M%h 0V%h", tick_at(s, k, dx, kept(p->x0), kept(p->scale_x)), hundredths(s, kept(p->height)));
    for (long k = y.first; k <= y.last; k++)
        put(out, "M0 %hH%h", tick_at(s, k, dy, kept(p->y1), down), hundredths(s, kept(p->width)));
    put(out, "\"/>\n");
    region_drop(mark);
}

/* ---- Numbers ---------------------------------------------------------------------------------- */

static bool is_integer(num_q x) { return mpz_cmp_ui(mpq_denref(x.at), 1) == 0; }

/* x as a decimal where it has one of at most 12 places, else as a fraction. */
static void put_number(struct string *out, num_q x)
{
    region_mark mark = region_open();
    num_q scaled = cagd_sign_q(x) < 0 ? neg_q(x) : x, ten = from_int_q(10);
    int places = 0;
    put(out, cagd_sign_q(x) < 0 ? "−" : "");
    for (; places < 12 && !is_integer(scaled); places++)
        scaled = mul_q(scaled, ten);
    if (is_integer(scaled)) {
        const char *digits = to_string_q(scaled);
        int count = (int)strlen(digits), whole = count - places;
        for (int k = whole < 1 ? whole - 1 : 0; k < count; k++)
            put(out, "%s%d", k == whole ? "." : "", k < 0 ? 0 : digits[k] - '0');
    } else {
        put(out, "%s", to_string_q(x) + (cagd_sign_q(x) < 0));
    }
    region_drop(mark);
}

/* ---- Axes ------------------------------------------------------------------------------------- */

static void tick_label(svg *s, struct panel *p, long x, long y, enum svg_anchor anchor, num_q value)
{
    struct string number = {0};
    put_number(&number, value);
    put_words(s, p, x, y, anchor, KIND_TICK, SVG_AXIS, false, content(&number));
    drop_string(s, &number);
}

/* Where the axis across lo ... hi meets this direction: at 0 if that is between, else at lo. */
static num_q foot(num_q lo, num_q hi) { return cagd_sign_q(lo) <= 0 && cagd_sign_q(hi) >= 0 ? from_int_q(0) : lo; }

/* The arrow of an axis reaches over the window by OVERHANG. */
enum { OVERHANG = 1000, HEAD = 650, WING = 230, TICK = 350 };

static void x_ticks(svg *s, struct panel *p, num_q step)
{
    long bottom = hundredths(s, kept(p->height));
    struct ticks ticks = ticks_of(s, kept(p->x0), kept(p->x1), step);
    for (long k = ticks.first; k <= ticks.last; k++) {
        long x = tick_at(s, k, step, kept(p->x0), kept(p->scale_x));
        put(&p->layer[GROUND], "<path class=\"l %s\" d=\"M%h %hV%h\"/>\n", role_class(s, SVG_AXIS), x, bottom,
            bottom + TICK);
        tick_label(s, p, x, bottom + 1620, SVG_MIDDLE, mul_q(from_int_q(k), step));
    }
}

static void y_ticks(svg *s, struct panel *p, num_q step)
{
    struct ticks ticks = ticks_of(s, kept(p->y0), kept(p->y1), step);
    num_q down = neg_q(kept(p->scale_y));
    for (long k = ticks.first; k <= ticks.last; k++) {
        long y = tick_at(s, k, step, kept(p->y1), down);
        put(&p->layer[GROUND], "<path class=\"l %s\" d=\"M0 %hH%h\"/>\n", role_class(s, SVG_AXIS), y, -(long)TICK);
        tick_label(s, p, -TICK - 350, y + 400, SVG_END, mul_q(from_int_q(k), step));
    }
}

static void x_axis(svg *s, struct panel *p, num_q y_foot, num_q step, const char *name)
{
    struct string *out = &p->layer[GROUND];
    const char *class = role_class(s, SVG_AXIS);
    long y = hundredths(s, to_output(p, (svg_point){kept(p->x0), y_foot}).y);
    long end = hundredths(s, kept(p->width)) + OVERHANG;
    put(out, "<path class=\"l %s\" d=\"M0 %hH%h\"/>\n", class, y, end - HEAD);
    put(out, "<path class=\"c %s\" d=\"M%h %hL%h %hL%h %hZ\"/>\n", class, end - HEAD, y - WING, end, y, end - HEAD,
        y + WING);
    x_ticks(s, p, step);
    if (name != NULL)
        put_words(s, p, end + 350, y + 420, SVG_START, KIND_LABEL, SVG_AXIS, true, name);
}

static void y_axis(svg *s, struct panel *p, num_q x_foot, num_q step, const char *name)
{
    struct string *out = &p->layer[GROUND];
    const char *class = role_class(s, SVG_AXIS);
    long x = hundredths(s, to_output(p, (svg_point){x_foot, kept(p->y0)}).x), end = -OVERHANG;
    put(out, "<path class=\"l %s\" d=\"M%h %hV%h\"/>\n", class, x, hundredths(s, kept(p->height)), end + HEAD);
    put(out, "<path class=\"c %s\" d=\"M%h %hL%h %hL%h %hZ\"/>\n", class, x - WING, end + HEAD, x, end, x + WING,
        end + HEAD);
    y_ticks(s, p, step);
    if (name != NULL)
        put_words(s, p, x, end - 550, SVG_MIDDLE, KIND_LABEL, SVG_AXIS, true, name);
}

void svg_axes(svg *s, num_q dx, num_q dy, const char *x_name, const char *y_name)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    region_mark mark = region_open();
    x_axis(s, p, foot(kept(p->y0), kept(p->y1)), dx, x_name);
    y_axis(s, p, foot(kept(p->x0), kept(p->x1)), dy, y_name);
    region_drop(mark);
}

void svg_scales(svg *s, num_q dx, num_q dy, const char *x_name, const char *y_name)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    region_mark mark = region_open();
    svg_frame(s);
    x_ticks(s, p, dx);
    y_ticks(s, p, dy);
    long right = hundredths(s, kept(p->width)), bottom = hundredths(s, kept(p->height));
    if (x_name != NULL)
        put_words(s, p, right + 700, bottom + 420, SVG_START, KIND_LABEL, SVG_AXIS, true, x_name);
    if (y_name != NULL)
        put_words(s, p, 0, -850, SVG_MIDDLE, KIND_LABEL, SVG_AXIS, true, y_name);
    region_drop(mark);
}

/* ---- Matrices --------------------------------------------------------------------------------- */

static num_q size_of(num_q a) { return cagd_sign_q(a) < 0 ? neg_q(a) : a; }

/* The tint of |a| <= largest, in eight steps of 0.07, rounded upwards: only 0 has none. */
static long tint(num_q a, num_q largest)
{
    num_q x = div_q(mul_q(from_int_q(8), size_of(a)), largest);
    mpz_t step;
    mpz_init(step);
    mpz_cdiv_q(step, mpq_numref(x.at), mpq_denref(x.at));
    long steps = mpz_get_si(step);
    mpz_clear(step);
    return 7 * steps;
}

static void put_cell(svg *s, struct panel *p, svg_point upper_left, num_q a, num_q largest, bool printed)
{
    svg_point P = to_output(p, upper_left);
    svg_point Q = {add_q(P.x, kept(p->scale_x)), add_q(P.y, kept(p->scale_y))};
    long x = hundredths(s, P.x), y = hundredths(s, P.y), width = hundredths(s, Q.x) - x;
    long height = hundredths(s, Q.y) - y, middle = x + width / 2;
    if (!cagd_is_zero_q(a))
        put(&p->layer[LINES],
            "<rect class=\"c %s\" fill-opacity=\"%h\" x=\"%h\" y=\"%h\" width=\"%h\" height=\"%h\"/>\n",
            role_class(s, cagd_sign_q(a) < 0 ? SVG_CURVE_2 : SVG_CURVE), tint(a, largest), x + 50, y + 50, width - 100,
            height - 100);
    if (printed) {
        struct string number = {0};
        put_number(&number, a);
        put_text(s, &p->layer[WORDS], middle, y + height / 2 + 420, SVG_MIDDLE, KIND_PLAIN,
                 cagd_is_zero_q(a) ? SVG_MUTED : SVG_POINT, false, content(&number));
        drop_string(s, &number);
    } else if (cagd_sign_q(a) < 0) {
        put(&p->layer[MARKS], "<path class=\"x %s\" d=\"M%h %hH%h\"/>\n", role_class(s, SVG_CURVE_2), x + width / 3,
            y + height / 2, x + width - width / 3);
    }
}

/* Every entry fits into its cell. */
static bool entries_fit(svg *s, const struct panel *p, int count, const num_q m[])
{
    struct string number = {0}, scratch = {0};
    long widest = 0;
    for (int k = 0; k < count; k++) {
        empty_string(&number);
        put_number(&number, m[k]);
        long width = put_markup(&scratch, content(&number), false, NOTE_SIZE);
        widest = width > widest ? width : widest;
    }
    drop_string(s, &number);
    drop_string(s, &scratch);
    return widest + 400 <= hundredths(s, kept(p->scale_x)) && NOTE_SIZE <= hundredths(s, kept(p->scale_y));
}

void svg_heat(svg *s, int rows, int columns, const num_q m[])
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    region_mark mark = region_open();
    num_q largest = from_int_q(0);
    for (int k = 0; k < rows * columns; k++)
        largest = cagd_compare_q(size_of(m[k]), largest) > 0 ? size_of(m[k]) : largest;
    bool printed = entries_fit(s, p, rows * columns, m);
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            put_cell(s, p, svg_at(j, rows - i), m[i * columns + j], largest, printed);
    region_drop(mark);
}
