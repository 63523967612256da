/* svg_parts.h -- the inside of the canvas, shared by the files svg*.c and by nobody else.
 *
 * Inside, lengths are output units with the y axis downwards and the origin in the upper left corner
 * of the panel's window: exact as num_q, or rounded once as a long that counts hundredths. */
#ifndef CAGD_SVG_PARTS_H
#define CAGD_SVG_PARTS_H

#include "figures/svg.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* ---- Growing strings (svg_string.c) ----------------------------------------------------------- */

struct string {
    char *at; /* NULL, or ended by '\0'                */
    size_t used, room;
    bool broken; /* memory was short: what follows is lost */
};

/* Appends format with %s a string, %x a string escaped for XML, %d an int, %h hundredths as a
 * decimal with two digits, %% a percent sign. */
void put(struct string *out, const char *format, ...);
void put_character(struct string *out, uint32_t code); /* escaped for XML */
void empty_string(struct string *out);
void free_string(struct string *out);
const char *content(const struct string *s); /* "" when nothing was put */

/* The next code point of *utf8, which moves on, or 0 at the end; U+FFFD for what XML cannot hold. */
uint32_t next_character(const char **utf8);

/* ---- The canvas (svg.c) ----------------------------------------------------------------------- */

enum { MAX_PANELS = 12, MAX_KEYS = 12 };
enum layer { GROUND, LINES, MARKS, WORDS, LAYERS };
enum side { LEFT, TOP, RIGHT, BOTTOM };

struct box {
    long left, top, right, bottom;
};

struct panel {
    mpq_t x0, y0, x1, y1;   /* the window in the world                                       */
    mpq_t scale_x, scale_y; /* (x, y) is drawn at ((x - x0) scale_x, (y1 - y) scale_y)        */
    mpq_t width, height;    /* of the window in output units                                  */
    long pad[4];            /* how far words reach over the sides of the window               */
    struct string layer[LAYERS];
    bool clipped;     /* some line needs the viewer to clip it                          */
    bool first;       /* it begins a row                                                */
    struct box *word; /* where the words stand                                          */
    int words, words_room;
    enum svg_role heading_role;
    char *heading, *caption;
};

struct key { /* an entry of the legend */
    struct string body;
    long width;
};

struct svg {
    char *name, *title, *description;
    const char *failure;
    mpq_t tolerance;
    struct panel panel[MAX_PANELS];
    struct key key[MAX_KEYS];
    int panels, keys;
    bool row, hatched, clouded, used[SVG_ROLES]; /* row: the next panel begins one */
    struct string text;
};

void svg_fail(svg *s, const char *why);
void drop_string(svg *s, struct string *out); /* frees it; a string that found no memory is a failure of the picture */

/* The panel being drawn, or NULL, after saying so, when there is none or when s has failed. */
struct panel *svg_current(svg *s);

/* A value kept by the canvas, as a number. */
static inline num_q kept(mpq_srcptr x) { return (num_q){x}; }

svg_point to_output(const struct panel *p, svg_point at);

/* 100 x rounded to the nearest integer, half away from zero; a failure beyond 10^6 units. */
long hundredths(svg *s, num_q x);

/* ---- Roles (svg_roles.c) ---------------------------------------------------------------------- */

/* The CSS class of the role, which is now used. */
const char *role_class(svg *s, enum svg_role role);

/* The class of an area of that role; hatched, and the pattern defined, for SVG_WRONG. */
void put_area_class(svg *s, struct string *out, enum svg_role role);

/* A point in the usual shape of the role unless another is asked for. */
void put_mark(svg *s, struct string *out, long x, long y, enum svg_role role, enum svg_shape shape);

/* The style sheet for the roles that were used, and the definitions it needs. */
void put_style(svg *s, struct string *out);

/* ---- Words (svg_words.c) ---------------------------------------------------------------------- */

enum { NOTE_SIZE = 1250, HEADING_SIZE = 1350, TITLE_SIZE = 1600 };
enum text_kind {
    KIND_LABEL,
    KIND_NOTE,
    KIND_TICK,
    KIND_HEADING,
    KIND_PLAIN,
    KIND_TITLE
}; /* plain: a note without a halo */

/* Puts the tspans of the markup; returns the usual width of the words. */
long put_markup(struct string *out, const char *markup, bool mathematics, long size);

/* Puts a whole text element whose anchor and baseline are at (x, y); returns the words' width. */
long put_text(svg *s, struct string *out, long x, long y, enum svg_anchor anchor, enum text_kind kind,
              enum svg_role role, bool mathematics, const char *markup);

/* The same in the panel's layer of words, making room for it around the window. */
void put_words(svg *s, struct panel *p, long x, long y, enum svg_anchor anchor, enum text_kind kind, enum svg_role role,
               bool mathematics, const char *markup);

/* ---- Lines (svg_lines.c) ---------------------------------------------------------------------- */

/* A pen draws one path element of straight lines, clipped exactly to the window. */
struct pen {
    svg *s;
    struct panel *p;
    struct string path;
    bool down;
    long x, y; /* where it stands when down */
};
struct pen pen_new(svg *s, struct panel *p);
void pen_segment(struct pen *pen, svg_point a, svg_point b); /* in output units */
void pen_finish(struct pen *pen, enum layer layer, enum svg_role role);

svg_point middle(svg_point a, svg_point b);

/* All of the points are beyond one side of the window. */
bool outside(const struct panel *p, int count, const svg_point *P);

/* The distance of P from the segment ab is <= the tolerance of s. */
bool near_segment(const svg *s, svg_point P, svg_point a, svg_point b);

#endif
