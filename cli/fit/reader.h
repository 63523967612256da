/* reader.h -- what the readers of points share: the text, the place in it, refusals, and what is kept. */
#ifndef CAGD_CLI_FIT_READER_H
#define CAGD_CLI_FIT_READER_H

#include "cli/fit/points.h"

struct reader {
    struct input_error *error;
    char *next, *end; /* what is still to be read, ended by a zero byte */
    char *start;      /* the line read last                             */
    int line;         /* its number; 0: none                            */
};

/* Notes the error: in the line read last, at the character that `at` points to unless it is NULL; -1. */
int refuse(const struct reader *r, const char *at, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Makes the line that `at` points into the line read last; `at` never goes back. */
void go_to(struct reader *r, const char *at);

/* A point of p->dim coordinates.  -1 when memory is short. */
int add_point(struct points *p, const double at[], double sigma, int line);

/* What was read otherwise than as a plain table of points, to be told. */
void note_of(struct points *p, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Lines of a drawing or a map, of which a file may have several and a fit takes one: the first one is kept, the points
 * of the others are counted. */
enum { MOST_STROKES = 8 };
struct strokes {
    int count, points[MOST_STROKES];
};
void begin_stroke(struct strokes *s);
int add_to_stroke(struct strokes *s, struct points *p, const double at[], double sigma, int line);
/* Whether points i and j have equal coordinates; 0 and -0 are. */
int is_same_point(const struct points *p, int i, int j);
/* The first point once more, unless it is the last one already. */
int close_stroke(struct strokes *s, struct points *p);
/* Whether there is exactly one; 0, or -1 and the error, which calls one of them `what`. */
int only_stroke(struct reader *r, const struct strokes *s, const char *what);

/* Each: 0, or -1 and the error.  The text is changed. */
int read_table(struct reader *r, const struct columns *asked, struct points *p);       /* table.c       */
int read_json_points(struct reader *r, const struct columns *asked, struct points *p); /* json_points.c */
int read_gpx(struct reader *r, const struct columns *asked, struct points *p);         /* drawings.c    */
int read_svg(struct reader *r, const struct columns *asked, struct points *p);
int read_dxf(struct reader *r, const struct columns *asked, struct points *p); /* dxf.c         */
#endif
