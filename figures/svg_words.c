/* svg_words.c -- labels, remarks and the legend: the markup, and how wide its words usually are.
 *
 * The viewer sets the text; widths are only needed to put scripts under one another, to centre the
 * legend, and to keep room around the window.  They are those of Times and Helvetica, which most
 * fonts in their place share or nearly share; for the room that a whole text needs, those of
 * DejaVu, which stands in their place where they are not there, and is wider. */
#include "figures/svg_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum script { BASE, SUB, SUPER };
enum face { PROSE, UPRIGHT, ITALIC };

/* ---- Widths in thousandths of an em ------------------------------------------------------------ */

static const short prose_letter[] = {556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833,
                                     556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500};
static const short prose_capital[] = {667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833,
                                      722, 778, 667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611};
static const short italic_letter[] = {500, 500, 444, 500, 444, 278, 500, 500, 278, 278, 444, 278, 722,
                                      500, 500, 500, 500, 389, 389, 278, 500, 444, 667, 444, 444, 389};
static const short italic_capital[] = {611, 611, 667, 722, 611, 611, 722, 722, 333, 444, 667, 556, 833,
                                       667, 722, 611, 722, 611, 500, 556, 722, 611, 833, 611, 556, 556};

static long advance(uint32_t c, enum face face)
{
    bool prose = face == PROSE;
    if (c >= 'a' && c <= 'z')
        return (prose ? prose_letter : italic_letter)[c - 'a'];
    if (c >= 'A' && c <= 'Z')
        return (prose ? prose_capital : italic_capital)[c - 'A'];
    if (c >= '0' && c <= '9')
        return prose ? 556 : 500;
    if (c < 0x80 && strchr(" .,:;'/", (int)c) != NULL)
        return 270;
    if (c < 0x80 && strchr("()[]-", (int)c) != NULL)
        return 333;
    if (c >= 0x0300 && c < 0x0370) /* combining marks */
        return 0;
    return c >= 0x2E80 || c == 0x2014 || c == 0x2192 ? 1000 : 570; /* East Asia, dash, arrow; the others */
}

/* Latin and Greek letters, which stand for quantities. */
static bool is_letter(uint32_t c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= 0x3B1 && c <= 0x3C9) || c == 0x3D5 || c == 0x3F5;
}

/* How wide a character is in DejaVu, in hundredths of the width above: the means over the texts of the gallery, of letters and
 * figures, and of the signs that are as wide as those of a relation. */
static long wider(uint32_t c, enum face face)
{
    enum { OF_PROSE = 117, OF_MATHEMATICS = 124, OF_SIGNS = 147 };
    bool sign = c == '=' || c == '<' || c == '>' || c == '+' || c == 0x2212 || c == 0x2264 || c == 0x2265;
    return sign ? OF_SIGNS : face == PROSE ? OF_PROSE : OF_MATHEMATICS;
}

/* ---- Markup ----------------------------------------------------------------------------------- */

/* The setter puts one tspan for each run of characters of one face and one script. */
struct setter {
    struct string *out;
    long size;
    bool open;
    enum face face;
    enum script script;
    long x, furthest; /* where the pen stands by the usual widths, and stood at most, in units / 10^5 */
    long base_end;    /* where the word ends that carries the scripts                                  */
    long shift;       /* moves the next character sideways                                             */
    long usual, wide; /* the widths of all characters, scripts behind one another: usual, and in DejaVu */
};

/* How far below the baseline a script stands. */
static long drop(const struct setter *y, enum script script)
{
    return script == SUB ? y->size * 24 / 100 : script == SUPER ? -y->size * 42 / 100 : 0;
}

static void open_run(struct setter *y, enum face face, enum script script)
{
    static const char *const class[2][3] = {{"", "u", "i"}, {"s", "u s", "i s"}};
    if (y->open)
        put(y->out, "</tspan>");
    long fall = drop(y, script) - drop(y, y->script);
    y->open = face != PROSE || script != BASE || fall != 0 || y->shift != 0;
    if (y->open) {
        put(y->out, "<tspan");
        if (*class[script != BASE][face] != '\0')
            put(y->out, " class=\"%s\"", class[script != BASE][face]);
        if (y->shift != 0)
            put(y->out, " dx=\"%h\"", y->shift / 1000);
        if (fall != 0)
            put(y->out, " dy=\"%h\"", fall);
        put(y->out, ">");
    }
    y->x += y->shift;
    y->shift = 0;
    y->face = face;
    y->script = script;
}

static void set_character(struct setter *y, uint32_t c, enum face face, enum script script)
{
    if (face != y->face || script != y->script || y->shift != 0)
        open_run(y, face, script);
    put_character(y->out, c);
    long percent = script != BASE ? 80 : face != PROSE ? 112 : 100;
    long width = advance(c, face) * y->size * percent / 100;
    y->x += width;
    y->usual += width;
    y->wide += width * wider(c, face) / 100;
    y->furthest = y->x > y->furthest ? y->x : y->furthest;
}

static void set_mathematics(struct setter *y, uint32_t c, enum script script)
{
    uint32_t shown = c == '-' ? 0x2212 : c == '\'' ? 0x2032 : c;
    set_character(y, shown, is_letter(c) ? ITALIC : UPRIGHT, script);
}

/* One script, a character or a group.  A second one on the same word goes back to where the word ends. */
static const char *set_script(struct setter *y, const char *markup, enum script script)
{
    if (y->script == BASE)
        y->base_end = y->furthest = y->x;
    y->shift = y->base_end - y->x + (script == SUPER ? y->size * 30 : 0); /* clears a slanted letter */
    bool group = *markup == '{';
    markup += group;
    for (bool more = true; more && *markup != '\0' && !(group && *markup == '}'); more = group) {
        uint32_t c = next_character(&markup);
        if (c == '\\' && *markup != '\0')
            set_character(y, next_character(&markup), UPRIGHT, script);
        else
            set_mathematics(y, c, script);
    }
    return markup + (group && *markup == '}');
}

long put_markup(struct string *out, const char *markup, bool mathematics, long size)
{
    struct setter y = {.out = out, .size = size};
    for (uint32_t c; (c = next_character(&markup)) != 0;) {
        if (mathematics && (c == '_' || c == '^')) {
            markup = set_script(&y, markup, c == '_' ? SUB : SUPER);
        } else if (c == '$') {
            mathematics = !mathematics;
        } else {
            if (y.script != BASE) /* goes on behind the longer of two scripts */
                y.shift = y.furthest - y.x;
            if (c == '\\' && *markup != '\0')
                set_character(&y, next_character(&markup), mathematics ? UPRIGHT : PROSE, BASE);
            else if (mathematics)
                set_mathematics(&y, c, BASE);
            else
                set_character(&y, c, PROSE, BASE);
        }
    }
    if (y.open)
        put(out, "</tspan>");
    return y.usual == 0 ? 0 : y.furthest / 1000 * (y.wide / 1000) / (y.usual / 1000);
}

/* ---- Text elements ---------------------------------------------------------------------------- */

static const struct {
    const char *class;
    long size;
} kinds[] = {
    [KIND_LABEL] = {"halo", 1450},        [KIND_NOTE] = {"halo n", NOTE_SIZE}, [KIND_TICK] = {"halo k", 1150},
    [KIND_HEADING] = {"d", HEADING_SIZE}, [KIND_PLAIN] = {"n", NOTE_SIZE},     [KIND_TITLE] = {"t", TITLE_SIZE},
};

long put_text(svg *s, struct string *out, long x, long y, enum svg_anchor anchor, enum text_kind kind,
              enum svg_role role, bool mathematics, const char *markup)
{
    static const char *const attribute[] = {"", " text-anchor=\"middle\"", " text-anchor=\"end\""};
    put(out, "<text class=\"%s %s\" x=\"%h\" y=\"%h\"%s>", kinds[kind].class, role_class(s, role), x, y,
        attribute[anchor]);
    long width = put_markup(out, markup, mathematics, kinds[kind].size);
    put(out, "</text>\n");
    return width;
}

static void keep_room(svg *s, struct panel *p, struct box word)
{
    if (p->words == p->words_room) {
        int room = 2 * p->words_room + 16;
        struct box *more = realloc(p->word, (size_t)room * sizeof *more);
        if (more == NULL) {
            svg_fail(s, "memory is short");
            return;
        }
        p->word = more;
        p->words_room = room;
    }
    p->word[p->words++] = word;
    long over[] = {-word.left, -word.top, word.right - hundredths(s, kept(p->width)),
                   word.bottom - hundredths(s, kept(p->height))};
    for (int side = LEFT; side <= BOTTOM; side++)
        p->pad[side] = over[side] > p->pad[side] ? over[side] : p->pad[side];
}

void put_words(svg *s, struct panel *p, long x, long y, enum svg_anchor anchor, enum text_kind kind, enum svg_role role,
               bool mathematics, const char *markup)
{
    long width = put_text(s, &p->layer[WORDS], x, y, anchor, kind, role, mathematics, markup);
    long left = anchor == SVG_START ? x : anchor == SVG_MIDDLE ? x - width / 2 : x - width;
    long size = kinds[kind].size;
    keep_room(s, p, (struct box){left, y - size * 78 / 100, left + width, y + size * 24 / 100});
}

/* Where words stand beside a point: hundredths of an em to the right and up. */
static const struct {
    enum svg_anchor anchor;
    int right, up;
} places[] = {
    [SVG_N] = {SVG_MIDDLE, 0, 68},    [SVG_NE] = {SVG_START, 36, 44},  [SVG_E] = {SVG_START, 62, -33},
    [SVG_SE] = {SVG_START, 36, -110}, [SVG_S] = {SVG_MIDDLE, 0, -132}, [SVG_SW] = {SVG_END, -36, -110},
    [SVG_W] = {SVG_END, -62, -33},    [SVG_NW] = {SVG_END, -36, 44},   [SVG_HERE] = {SVG_MIDDLE, 0, -33},
};

static void words_at(svg *s, svg_point at, enum svg_anchor anchor, int right, int up, enum text_kind kind,
                     enum svg_role role, bool mathematics, const char *markup)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    region_mark mark = region_open();
    svg_point P = to_output(p, at);
    long em = kinds[kind].size;
    put_words(s, p, hundredths(s, P.x) + em * right / 100, hundredths(s, P.y) - em * up / 100, anchor, kind, role,
              mathematics, markup);
    region_drop(mark);
}

void svg_label_at(svg *s, svg_point at, enum svg_anchor anchor, int right, int up, enum svg_role role,
                  const char *markup)
{
    words_at(s, at, anchor, right, up, KIND_LABEL, role, true, markup);
}

void svg_label(svg *s, svg_point at, enum svg_direction towards, enum svg_role role, const char *markup)
{
    words_at(s, at, places[towards].anchor, places[towards].right, places[towards].up, KIND_LABEL, role, true, markup);
}

void svg_note(svg *s, svg_point at, enum svg_direction towards, enum svg_role role, const char *markup)
{
    words_at(s, at, places[towards].anchor, places[towards].right, places[towards].up, KIND_NOTE, role, false, markup);
}

/* ---- Where there is room ------------------------------------------------------------------------ */

/* The window in doubles, as these places need no more. */
struct sight {
    double x0, y1, scale_x, scale_y;
};

enum { MARK = 450, CELLS = 8, FARTHEST = 4 }; /* hundredths of a unit about the middle of a mark; directions; rings about the point */

/* How many of the points lie in the box, `margin` wider. */
static int in_box(const struct sight *v, int count, const double P[], struct box b, double margin)
{
    const double left = (double)b.left - margin, right = (double)b.right + margin, top = (double)b.top - margin,
                 bottom = (double)b.bottom + margin;
    int found = 0;
    for (int i = 0; i < count; i++) {
        const double x = 100 * (P[2 * i] - v->x0) * v->scale_x, y = 100 * (v->y1 - P[2 * i + 1]) * v->scale_y;
        found += x > left && x < right && y > top && y < bottom;
    }
    return found;
}

static bool overlap(struct box a, struct box b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/* Whether words there would be outside of the window, over other words or over a point. */
static bool is_taken(svg *s, const struct panel *p, const struct sight *v, const svg_crowd *crowd, struct box b)
{
    const long width = hundredths(s, kept(p->width)), height = hundredths(s, kept(p->height));
    bool taken = b.left < 0 || b.top < 0 || b.right > width || b.bottom > height;
    for (int k = 0; k < p->words && !taken; k++)
        taken = overlap(b, p->word[k]);
    return taken || in_box(v, crowd->points, crowd->point, b, MARK) > 0;
}

/* Where words stand: the baseline and its anchor. */
struct stand {
    long x, y;
    enum svg_anchor anchor;
};

/* In the k-th direction, `ring` steps farther away. */
static struct stand stand_at(long x, long y, int direction, int ring, long em)
{
    const long out = em * 60 * ring / 100, aside = places[direction].right, above = places[direction].up + 33;
    return (struct stand){x + em * aside / 100 + (aside > 0 ? out : aside < 0 ? -out : 0),
                          y - em * places[direction].up / 100 - (above > 0 ? out : above < 0 ? -out : 0),
                          places[direction].anchor};
}

static struct box box_at(struct stand at, long width, long size)
{
    const long left = at.anchor == SVG_START ? at.x : at.anchor == SVG_MIDDLE ? at.x - width / 2 : at.x - width;
    return (struct box){left, at.y - size * 78 / 100, left + width, at.y + size * 24 / 100};
}

/* The nearest place of an interval. */
static long nearest(long x, long low, long high) { return x < low ? low : x > high ? high : x; }

/* Whether some other point of the crowd is less than half as far again from the box as (x, y) is. */
static bool another_is_near(const struct sight *v, const svg_crowd *crowd, long x, long y, struct box b)
{
    enum { SAME = 100 }; /* nearer to (x, y) than this is the point itself */
    const double own = hypot((double)(x - nearest(x, b.left, b.right)), (double)(y - nearest(y, b.top, b.bottom)));
    bool near = false;
    for (int i = 0; i < crowd->points && !near; i++) {
        const long px = lround(100 * (crowd->point[2 * i] - v->x0) * v->scale_x),
                   py = lround(100 * (v->y1 - crowd->point[2 * i + 1]) * v->scale_y);
        near = hypot((double)(px - x), (double)(py - y)) > SAME &&
               hypot((double)(px - nearest(px, b.left, b.right)), (double)(py - nearest(py, b.top, b.bottom))) < 1.5 * own;
    }
    return near;
}

static int clear_words(svg *s, svg_point at, enum svg_direction towards, const svg_crowd *crowd, enum text_kind kind,
                       enum svg_role role, bool mathematics, const char *markup)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return 0;
    region_mark mark = region_open();
    const svg_point P = to_output(p, at);
    const long em = kinds[kind].size, x = hundredths(s, P.x), y = hundredths(s, P.y);
    const struct sight v = {to_double_q(kept(p->x0)), to_double_q(kept(p->y1)), to_double_q(kept(p->scale_x)),
                            to_double_q(kept(p->scale_y))};
    struct string ignored = {0};
    const long width = put_markup(&ignored, markup, mathematics, em);
    free_string(&ignored);
    struct stand best = {0};
    double lowest = -1;
    for (int ring = 0; ring < FARTHEST && lowest < 0; ring++)
        for (int turn = 0; turn < CELLS; turn++) {
            const int direction = ((int)towards + (turn % 2 ? turn / 2 + 1 : CELLS - turn / 2)) % CELLS;
            const struct stand there = stand_at(x, y, direction, ring, em);
            const struct box b = box_at(there, width, em);
            if (is_taken(s, p, &v, crowd, b))
                continue;
            const double cost = turn + 3 * in_box(&v, crowd->places, crowd->place, b, 0);
            if (lowest < 0 || cost < lowest)
                best = there, lowest = cost;
        }
    if (lowest >= 0)
        put_words(s, p, best.x, best.y, best.anchor, kind, role, mathematics, markup);
    const struct box b = box_at(best, width, em);
    if (lowest >= 0 && kind == KIND_NOTE && another_is_near(&v, crowd, x, y, b))
        put(&p->layer[LINES], "<path class=\"h %s\" d=\"M%h %hL%h %h\"/>\n", role_class(s, role), x, y, nearest(x, b.left, b.right),
            nearest(y, b.top, b.bottom));
    region_drop(mark);
    return lowest >= 0;
}

int svg_label_clear(svg *s, svg_point at, enum svg_direction towards, const svg_crowd *crowd, enum svg_role role,
                    const char *markup)
{
    return clear_words(s, at, towards, crowd, KIND_LABEL, role, true, markup);
}

int svg_note_clear(svg *s, svg_point at, enum svg_direction towards, const svg_crowd *crowd, enum svg_role role,
                   const char *markup)
{
    return clear_words(s, at, towards, crowd, KIND_NOTE, role, false, markup);
}

/* The eight sectors are parted by lines of slope tan 22.5° = sqrt 2 - 1 and its inverse: with a and b
 * the sizes of the coordinates, b < (sqrt 2 - 1) a exactly when (a + b)^2 < 2 a^2. */
enum svg_direction svg_direction_of(svg_point from, svg_point to)
{
    static const enum svg_direction compass[3][3] = {
        {SVG_SW, SVG_W, SVG_NW}, {SVG_S, SVG_N, SVG_N}, {SVG_SE, SVG_E, SVG_NE}};
    region_mark mark = region_open();
    num_q dx = sub_q(to.x, from.x), dy = sub_q(to.y, from.y);
    int i = cagd_sign_q(dx), j = cagd_sign_q(dy);
    num_q a = i < 0 ? neg_q(dx) : dx, b = j < 0 ? neg_q(dy) : dy, sum = add_q(a, b);
    num_q square = mul_q(sum, sum), two = from_int_q(2);
    if (cagd_compare_q(square, mul_q(two, mul_q(a, a))) < 0)
        j = 0;
    else if (cagd_compare_q(square, mul_q(two, mul_q(b, b))) < 0)
        i = 0;
    region_drop(mark);
    return compass[i + 1][j + 1];
}

/* ---- Legend ----------------------------------------------------------------------------------- */

enum { SAMPLE = 2600, SAMPLE_GAP = 800 };

/* Opens an entry: the words.  The caller adds the sample, centred at the height 0. */
static struct string *new_key(svg *s, long sample, const char *markup)
{
    if (svg_failed(s) != NULL)
        return NULL;
    if (s->keys == MAX_KEYS) {
        svg_fail(s, "a legend has at most 12 entries");
        return NULL;
    }
    struct key *key = &s->key[s->keys++];
    key->width = sample + SAMPLE_GAP +
                 put_text(s, &key->body, sample + SAMPLE_GAP, 420, SVG_START, KIND_PLAIN, SVG_POINT, false, markup);
    return &key->body;
}

void svg_legend_line(svg *s, enum svg_role role, const char *markup)
{
    struct string *out = new_key(s, SAMPLE, markup);
    if (out != NULL)
        put(out, "<path class=\"l %s\" d=\"M0 0H%h\"/>\n", role_class(s, role), (long)SAMPLE);
}

void svg_legend_mark(svg *s, enum svg_role role, enum svg_shape shape, const char *markup)
{
    struct string *out = new_key(s, SAMPLE / 3, markup);
    if (out != NULL)
        put_mark(s, out, SAMPLE / 6, 0, role, shape);
}

void svg_legend_dot(svg *s, enum svg_role role, int diameter, const char *markup)
{
    struct string *out = new_key(s, SAMPLE / 3, markup);
    if (out != NULL)
        put(out, "<path class=\"p %s\" stroke-width=\"%h\" d=\"M%h 0h0\"/>\n", role_class(s, role), (long)diameter, (long)(SAMPLE / 6));
    s->clouded = true;
}

void svg_legend_area(svg *s, enum svg_role role, const char *markup)
{
    struct string *out = new_key(s, SAMPLE, markup);
    if (out != NULL) {
        put(out, "<rect ");
        put_area_class(s, out, role);
        put(out, " y=\"-5\" width=\"%h\" height=\"10\"/>\n", (long)SAMPLE);
    }
}
