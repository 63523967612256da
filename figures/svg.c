/* svg.c -- the canvas: its life, its panels, their layout and the document. */
#include "figures/svg_parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { MARGIN = 1600, GAP = 2800, CAPTION_GAP = 1000, LINE_HEIGHT = 1750, HEADING_GAP = 1100 };
enum { BOLD = 112 }; /* how wide bold letters are, in hundredths of others */

/* ---- Life ------------------------------------------------------------------------------------- */

static char *copy(svg *s, const char *text)
{
    char *at = strdup(text);
    if (at == NULL)
        svg_fail(s, "memory is short");
    return at;
}

/* The name can prefix an XML id. */
static bool is_name(const char *name)
{
    const char *others = "0123456789-_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    return strspn(name, others) == strlen(name) && strspn(name, others + 12) > 0;
}

svg *svg_new(const char *name, const char *title, const char *description)
{
    svg *s = calloc(1, sizeof *s);
    if (s == NULL)
        return NULL;
    mpq_init(s->tolerance);
    mpq_set_ui(s->tolerance, 1, 20);
    s->name = copy(s, name);
    s->title = copy(s, title);
    s->description = copy(s, description);
    if (!is_name(name))
        svg_fail(s, "the name of a figure consists of letters, digits, '-' and '_', a letter first");
    return s;
}

static void free_panel(struct panel *p)
{
    mpq_clears(p->x0, p->y0, p->x1, p->y1, p->scale_x, p->scale_y, p->width, p->height, (mpq_ptr)0);
    for (int k = 0; k < LAYERS; k++)
        free_string(&p->layer[k]);
    free(p->word);
    free(p->heading);
    free(p->caption);
}

void svg_free(svg *s)
{
    if (s == NULL)
        return;
    for (int k = 0; k < s->panels; k++)
        free_panel(&s->panel[k]);
    for (int k = 0; k < s->keys; k++)
        free_string(&s->key[k].body);
    mpq_clear(s->tolerance);
    free_string(&s->text);
    free(s->name);
    free(s->title);
    free(s->description);
    free(s);
}

void svg_fail(svg *s, const char *why)
{
    if (s != NULL && s->failure == NULL)
        s->failure = why;
}

void drop_string(svg *s, struct string *out)
{
    if (out->broken)
        svg_fail(s, "memory is short");
    free_string(out);
}

const char *svg_failed(const svg *s) { return s == NULL ? "memory is short" : s->failure; }

void svg_tolerance(svg *s, num_q units)
{
    if (svg_failed(s) != NULL)
        return;
    if (cagd_sign_q(units) <= 0)
        svg_fail(s, "a tolerance is positive");
    else
        mpq_set(s->tolerance, units.at);
}

/* ---- Panels ----------------------------------------------------------------------------------- */

struct panel *svg_current(svg *s)
{
    if (svg_failed(s) != NULL)
        return NULL;
    if (s->panels == 0) {
        svg_fail(s, "nothing can be drawn before a panel is opened");
        return NULL;
    }
    return &s->panel[s->panels - 1];
}

void svg_panel(svg *s, svg_window window, int width, int height, const char *caption)
{
    if (svg_failed(s) != NULL)
        return;
    if (s->panels == MAX_PANELS)
        svg_fail(s, "a figure has at most 12 panels");
    else if (cagd_compare_q(window.x0, window.x1) >= 0 || cagd_compare_q(window.y0, window.y1) >= 0)
        svg_fail(s, "the window of a panel is empty");
    else if (width <= 0 || height < 0)
        svg_fail(s, "a panel is wider than 0 and not lower than 0");
    if (s->failure != NULL)
        return;
    struct panel *p = &s->panel[s->panels++];
    p->first = s->row || s->panels == 1;
    s->row = false;
    mpq_inits(p->x0, p->y0, p->x1, p->y1, p->scale_x, p->scale_y, p->width, p->height, (mpq_ptr)0);
    mpq_set(p->x0, window.x0.at);
    mpq_set(p->y0, window.y0.at);
    mpq_set(p->x1, window.x1.at);
    mpq_set(p->y1, window.y1.at);
    region_mark mark = region_open();
    num_q dx = sub_q(window.x1, window.x0), dy = sub_q(window.y1, window.y0), w = from_int_q(width);
    num_q scale = div_q(w, dx), h = height == 0 ? mul_q(dy, scale) : from_int_q(height);
    mpq_set(p->width, w.at);
    mpq_set(p->height, h.at);
    mpq_set(p->scale_x, scale.at);
    mpq_set(p->scale_y, div_q(h, dy).at);
    region_drop(mark);
    if (caption != NULL)
        p->caption = copy(s, caption);
}

int svg_panels_left(const svg *s) { return MAX_PANELS - s->panels; }

void svg_row(svg *s)
{
    if (svg_failed(s) == NULL)
        s->row = true;
}

void svg_heading(svg *s, enum svg_role role, const char *markup)
{
    struct panel *p = svg_current(s);
    if (p == NULL)
        return;
    free(p->heading);
    p->heading = copy(s, markup);
    p->heading_role = role;
}

svg_point to_output(const struct panel *p, svg_point at)
{
    return (svg_point){mul_q(sub_q(at.x, kept(p->x0)), kept(p->scale_x)),
                       mul_q(sub_q(kept(p->y1), at.y), kept(p->scale_y))};
}

long hundredths(svg *s, num_q x)
{
    enum { FARTHEST = 100000000 };
    /* |x| = a/b is rounded to floor((200 a + b) / (2 b)). */
    mpz_t a, b;
    mpz_inits(a, b, (mpz_ptr)0);
    mpz_abs(a, mpq_numref(x.at));
    mpz_mul_ui(a, a, 200);
    mpz_add(a, a, mpq_denref(x.at));
    mpz_mul_ui(b, mpq_denref(x.at), 2);
    mpz_fdiv_q(a, a, b);
    bool far = mpz_cmp_ui(a, FARTHEST) > 0;
    long size = far ? 0 : mpz_get_si(a);
    mpz_clears(a, b, (mpz_ptr)0);
    if (far)
        svg_fail(s, "a point is more than 10^6 units away");
    return cagd_sign_q(x) < 0 ? -size : size;
}

/* ---- The document -----------------------------------------------------------------------------
 *
 * The panels stand in rows, the windows of a row level at the top and the first windows of all rows level at the
 * left, with all the words around them. */

struct layout {
    long half[MAX_PANELS];                    /* half the width of each window                         */
    long left[MAX_PANELS], right[MAX_PANELS]; /* what each panel needs on either side of its middle    */
    long before;                              /* what the first panels need on the left of the window  */
    long width;                               /* of the widest row                                     */
    struct string around[MAX_PANELS];         /* headings and captions                                 */
    struct string title;                      /* its lines, around x = 0, below y = 0                  */
    long title_width, title_height;
};

/* A row: its panels, and what it needs above and below the windows' top. */
struct row {
    int first, end;
    long above, below;
};

static long larger(long a, long b) { return a > b ? a : b; }

static void need_width(struct layout *y, int k, long width)
{
    y->left[k] = larger(y->left[k], (width + 1) / 2);
    y->right[k] = larger(y->right[k], (width + 1) / 2);
}

static void set_heading(svg *s, struct layout *y, int k, long base)
{
    const struct panel *p = &s->panel[k];
    struct string *out = &y->around[k];
    bool sign = p->heading_role == SVG_WRONG || p->heading_role == SVG_RIGHT;
    struct string draft = {0};
    long width = put_markup(&draft, p->heading, false, HEADING_SIZE) * BOLD / 100, shift = sign ? 900 : 0;
    free(draft.at);
    if (sign) /* begins behind its mark, however wide the reader's letters are */
        put_text(s, out, y->half[k] + shift - width / 2, base, SVG_START, KIND_HEADING, p->heading_role, false,
                 p->heading);
    else
        put_text(s, out, y->half[k], base, SVG_MIDDLE, KIND_HEADING, p->heading_role, false, p->heading);
    long x = y->half[k] - width / 2 - 600, mid = base - 450;
    const char *class = role_class(s, p->heading_role);
    if (p->heading_role == SVG_RIGHT)
        put(out, "<path class=\"x %s\" d=\"M%h %hL%h %hL%h %h\"/>\n", class, x - 450, mid + 50, x - 120, mid + 400,
            x + 450, mid - 450);
    else if (p->heading_role == SVG_WRONG)
        put_mark(s, out, x, mid, SVG_WRONG, SVG_CROSS);
    need_width(y, k, width + 2 * shift);
}

static int set_caption(svg *s, struct layout *y, int k, long base)
{
    int lines = 0;
    for (const char *c = s->panel[k].caption; *c != '\0'; lines++) {
        size_t n = strcspn(c, "\n");
        char *line = strndup(c, n);
        if (line == NULL) {
            svg_fail(s, "memory is short");
            return lines;
        }
        need_width(y, k,
                   put_text(s, &y->around[k], y->half[k], base + lines * LINE_HEIGHT, SVG_MIDDLE, KIND_PLAIN, SVG_POINT,
                            false, line));
        free(line);
        c += n + (c[n] == '\n');
    }
    return lines;
}

static struct row lay_out_row(svg *s, struct layout *y, int first)
{
    struct row row = {.first = first, .end = first};
    long bottom = 0;
    bool headed = false;
    int lines = 0;
    do {
        int k = row.end++;
        const struct panel *p = &s->panel[k];
        y->half[k] = hundredths(s, kept(p->width)) / 2;
        y->left[k] = y->half[k] + p->pad[LEFT];
        y->right[k] = y->half[k] + p->pad[RIGHT];
        row.above = larger(row.above, p->pad[TOP]);
        bottom = larger(bottom, hundredths(s, kept(p->height)) + p->pad[BOTTOM]);
        headed = headed || p->heading != NULL;
    } while (row.end < s->panels && !s->panel[row.end].first);
    row.above += headed ? HEADING_GAP : 0;
    for (int k = row.first; k < row.end; k++) {
        if (s->panel[k].heading != NULL)
            set_heading(s, y, k, -row.above);
        if (s->panel[k].caption != NULL) {
            int n = set_caption(s, y, k, bottom + CAPTION_GAP + NOTE_SIZE);
            lines = n > lines ? n : lines;
        }
    }
    row.above += headed ? HEADING_SIZE : 0;
    row.below = bottom + (lines > 0 ? CAPTION_GAP + NOTE_SIZE + (lines - 1) * LINE_HEIGHT + 400 : 0);
    return row;
}

/* Where the middle of panel k stands, seen from where the rows begin. */
static long middle_of(const struct layout *y, const struct row *row, int k)
{
    long x = y->before + y->half[row->first];
    for (int i = row->first; i < k; i++)
        x += y->right[i] + GAP + y->left[i + 1];
    return x;
}

/* One line of the title; its width.  A title is text: what markup takes for a sign stands behind a backslash. */
static long set_title_line(svg *s, struct string *out, long base, const char *words, size_t n)
{
    char *line = calloc(2 * n + 1, 1), *end = line;
    if (line == NULL) {
        svg_fail(s, "memory is short");
        return 0;
    }
    for (size_t k = 0; k < n; *end++ = words[k++])
        if (words[k] == '$' || words[k] == '\\')
            *end++ = '\\';
    long width = put_text(s, out, 0, base, SVG_MIDDLE, KIND_TITLE, SVG_POINT, false, line);
    free(line);
    return width * BOLD / 100;
}

/* How much of the text the first line takes that is no wider than the room: broken at a blank, if there is one. */
static size_t end_of_title_line(svg *s, const char *at, long room)
{
    size_t n = strlen(at);
    struct string draft = {0};
    while (set_title_line(s, &draft, 0, at, n) > room) {
        size_t shorter = n;
        while (shorter > 0 && at[--shorter] != ' ')
            ;
        if (shorter == 0)
            break;
        n = shorter;
    }
    drop_string(s, &draft);
    return n;
}

static int title_lines(svg *s, long room)
{
    int lines = 0;
    for (const char *at = s->title; *at != '\0'; lines++) {
        at += end_of_title_line(s, at, room);
        at += *at == ' ';
    }
    return lines;
}

/* The title in as few lines as the width of the rows takes, but not narrower than NARROWEST; the lines are about as long as
 * one another: no narrower room takes as few. */
static void set_title(svg *s, struct layout *y)
{
    enum { NARROWEST = 26000, LINE = 2000, BELOW = 1400 };
    long room = larger(y->width, NARROWEST), too_narrow = 0;
    for (int lines = title_lines(s, room); room - too_narrow > 1;) {
        long between = (room + too_narrow) / 2;
        if (title_lines(s, between) > lines)
            too_narrow = between;
        else
            room = between;
    }
    for (const char *at = s->title; *at != '\0'; y->title_height += LINE) {
        size_t n = end_of_title_line(s, at, room);
        y->title_width = larger(y->title_width, set_title_line(s, &y->title, y->title_height + TITLE_SIZE, at, n));
        at += n + (at[n] == ' ');
    }
    y->title_height += y->title_height > 0 ? BELOW : 0;
}

static int lay_out(svg *s, struct layout *y, struct row rows[MAX_PANELS])
{
    int count = 0;
    for (int k = 0; k < s->panels; k = rows[count++].end) {
        rows[count] = lay_out_row(s, y, k);
        y->before = larger(y->before, y->left[k] - y->half[k]);
    }
    for (int i = 0; i < count; i++) {
        int last = rows[i].end - 1;
        y->width = larger(y->width, middle_of(y, &rows[i], last) + y->right[last]);
    }
    set_title(s, y);
    return count;
}

static void put_panel(svg *s, int k, long x, long y, const char *around)
{
    struct panel *p = &s->panel[k];
    struct string *out = &s->text;
    put(out, "<g transform=\"translate(%h %h)\">\n%s", x, y, content(&p->layer[GROUND]));
    if (p->clipped)
        put(out,
            "<clipPath id=\"%s-window-%d\"><rect x=\"-1\" y=\"-1\" width=\"%h\" height=\"%h\"/></clipPath>\n"
            "<g clip-path=\"url(#%s-window-%d)\">\n%s</g>\n",
            s->name, k + 1, hundredths(s, kept(p->width)) + 200, hundredths(s, kept(p->height)) + 200, s->name, k + 1,
            content(&p->layer[LINES]));
    else
        put(out, "%s", content(&p->layer[LINES]));
    put(out, "%s%s%s</g>\n", content(&p->layer[MARKS]), content(&p->layer[WORDS]), around);
}

/* Entries of the legend flow into rows no wider than `room`, each row centred at `middle`.  Returns the
 * number of rows; with out == NULL nothing is put. */
static int put_legend(const svg *s, struct string *out, long room, long middle, long y)
{
    int rows = 0;
    for (int first = 0, next; first < s->keys; first = next, rows++) {
        long width = s->key[first].width;
        for (next = first + 1; next < s->keys && width + GAP + s->key[next].width <= room; next++)
            width += GAP + s->key[next].width;
        long x = middle - width / 2;
        for (int k = first; out != NULL && k < next; x += s->key[k++].width + GAP)
            put(out, "<g transform=\"translate(%h %h)\">\n%s</g>\n", x, y + rows * LINE_HEIGHT,
                content(&s->key[k].body));
    }
    return rows;
}

/* The rows of the legend with about as many words each: no narrower room takes as few. */
static long legend_room(const svg *s, long room)
{
    long too_narrow = 0;
    for (int rows = put_legend(s, NULL, room, 0, 0); room - too_narrow > 1;) {
        long between = (room + too_narrow) / 2;
        if (put_legend(s, NULL, between, 0, 0) > rows)
            too_narrow = between;
        else
            room = between;
    }
    return room;
}

static void put_document(svg *s, const struct layout *y, int count, const struct row rows[])
{
    struct string *out = &s->text;
    long room = larger(y->width, y->title_width), row_end = MARGIN + y->title_height;
    for (int i = 0; i < count; i++)
        row_end += (i > 0 ? GAP : 0) + rows[i].above + rows[i].below;
    for (int k = 0; k < s->keys; k++)
        room = larger(room, s->key[k].width);
    int lines = put_legend(s, NULL, room, 0, 0);
    long width = room + 2 * MARGIN;
    long height = row_end + (lines > 0 ? 2000 + (lines - 1) * LINE_HEIGHT + 500 : 0) + MARGIN;
    put(out,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"cagd\" width=\"%h\" height=\"%h\" viewBox=\"0 0 %h %h\" "
        "xml:space=\"preserve\" role=\"img\" aria-labelledby=\"%s-title %s-desc\">\n"
        "<title id=\"%s-title\">%x</title>\n<desc id=\"%s-desc\">%x</desc>\n",
        width, height, width, height, s->name, s->name, s->name, s->title, s->name, s->description);
    put_style(s, out);
    put(out, "<rect class=\"paper\" width=\"100%%\" height=\"100%%\" rx=\"5\"/>\n");
    if (y->title_height > 0)
        put(out, "<g class=\"title\" transform=\"translate(%h %h)\">\n%s</g>\n", width / 2, MARGIN, content(&y->title));
    long x = (width - y->width) / 2, top = MARGIN + y->title_height;
    for (int i = 0; i < count; i++) {
        for (int k = rows[i].first; k < rows[i].end; k++)
            put_panel(s, k, x + middle_of(y, &rows[i], k) - y->half[k], top + rows[i].above, content(&y->around[k]));
        top += rows[i].above + rows[i].below + GAP;
    }
    put_legend(s, out, legend_room(s, room), width / 2, row_end + 2000);
    put(out, "</svg>\n");
}

static bool whole(const svg *s)
{
    bool broken = s->text.broken;
    for (int k = 0; k < s->panels; k++)
        for (int l = 0; l < LAYERS; l++)
            broken = broken || s->panel[k].layer[l].broken;
    for (int k = 0; k < s->keys; k++)
        broken = broken || s->key[k].body.broken;
    return !broken;
}

const char *svg_text(svg *s)
{
    if (svg_current(s) == NULL)
        return NULL;
    struct layout y = {0};
    struct row rows[MAX_PANELS];
    int count = lay_out(s, &y, rows);
    empty_string(&s->text);
    put_document(s, &y, count, rows);
    for (int k = 0; k < s->panels; k++) {
        if (y.around[k].broken)
            svg_fail(s, "memory is short");
        free_string(&y.around[k]);
    }
    if (y.title.broken)
        svg_fail(s, "memory is short");
    free_string(&y.title);
    if (!whole(s))
        svg_fail(s, "memory is short");
    return s->failure == NULL ? s->text.at : NULL;
}

void svg_write(svg *s, const char *path)
{
    const char *text = svg_text(s);
    if (text == NULL)
        return;
    struct string temporary = {0};
    put(&temporary, "%s.%d.part", path, (int)getpid());
    FILE *file = temporary.broken ? NULL : fopen(temporary.at, "wx");
    if (file == NULL) {
        svg_fail(s, "the file cannot be made");
    } else {
        bool written = fputs(text, file) >= 0;
        if (fclose(file) != 0 || !written || rename(temporary.at, path) != 0) {
            remove(temporary.at);
            svg_fail(s, "the file cannot be written");
        }
    }
    free_string(&temporary);
}

static bool overlap(const struct box *a, const struct box *b)
{
    return a->left < b->right && b->left < a->right && a->top < b->bottom && b->top < a->bottom;
}

int svg_overlaps(const svg *s)
{
    int pairs = 0;
    for (int k = 0; s != NULL && k < s->panels; k++) {
        const struct panel *p = &s->panel[k];
        for (int i = 0; i < p->words; i++)
            for (int j = 0; j < i; j++)
                pairs += overlap(&p->word[i], &p->word[j]);
    }
    return pairs;
}
