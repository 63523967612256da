/* fit.h -- a fit and what is said of it: text, JSON, table of residuals, picture. */
#ifndef CAGD_CLI_FIT_H
#define CAGD_CLI_FIT_H

#include "cli/command.h"
#include "cli/curve_json.h"
#include "cli/fit/points.h"
#include "cli/output.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "core/fit/cagd_fit.h"
#include "exact/fit/stationary.h"
#include "exact/words.h"

struct fit {
    const char *path;
    cagd_fit_choices choices;
    cagd_fit_quality quality;
    cagd_fit_circle circle;
    cagd_fit_cures cures; /* what was tried where it is not good */
    int sigma_given;      /* one standard deviation for all points, by an option */
    struct points points;
    cagd_fit_data data;
    cagd_fit_options options;
    cagd_fit_result *result;
    int checked; /* whether it was asked to verify the minimum, or the feet where nothing is free */
    cagd_stationary_verdict verdict;
    cagd_nearest_verdict nearest;
};

/* What cagd fit is asked. */
struct fit_arguments {
    struct asked asked;
    const char *initial, *residuals, *svg, *curve;
    struct columns columns;
    cagd_fit_options options;
    const char *ends; /* as given; NULL: not  */
    int exact_ends, free_given;
    int closed;    /* 1, 0; -1: as the points say             */
    int automatic; /* the number of control points is chosen  */
    double within; /* > 0: a tolerance                        */
    int smooth;    /* 1: its weight by cross-validation       */
    cagd_fit_choices choices;
    const char *knots; /* as given; NULL: none */
    double *inner;     /* the inner knots; the caller frees them */
    int inner_knots, degree_given, degree_automatic;
    double sigma; /* of every point; 0: not given */
    int verbose, verify;
};
/* A usage error ends the program. */
struct fit_arguments read_fit_arguments(const struct call *c); /* options.c */
int run_fit(const struct call *c);                             /* fit.c     */

/* Whether only the distances from a given curve were asked for. */
static inline int nothing_is_free(const struct fit *f) { return f->options.free == 0; }

/* Whether the curve is an ellipse or an arc of one. */
static inline int is_ellipse(const struct fit *f) { return f->result->found.ellipse.known; }
/* Whether weights are among the unknowns. */
int fits_weights(const struct fit *f); /* verdict.c */
/* How many control points are its own. */
static inline int own_points(const struct fit *f)
{
    return f->result->period > 0 ? f->result->period : f->result->curve.count;
}

/* ---- names and numbers as they are written (numbers.c) ------------------------------------------------------- */

/* "w1" or "P1 x". */
void unknown_name(const cagd_fit_result *r, int k, char name[32]);
/* origin + value, exactly, with as many decimals as show two digits of the error of the value. */
void put_rounded(FILE *out, double origin, double value, double error);
/* A coordinate that is given: ten digits, or as many as tell it from other numbers where ten do not. */
void put_given(FILE *out, double origin, double x);
/* A text of the file system or of a file as JSON: what is no UTF-8 becomes U+FFFD. */
json_t *text_json(const char *text);

/* ---- what is printed and written ------------------------------------------------------------------ */

void print_fit(const struct fit *f, int verbose); /* text.c    */
/* A line of the report, filled (text.c). */
void say(const char *name, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* A number with its standard error and interval (text.c). */
void print_number(const char *name, cagd_fit_number x);
void print_choice(const struct fit *f);  /* what was chosen, and why: verdict.c */
void print_ellipse(const struct fit *f); /* verdict.c */
void print_quality(const struct fit *f); /* verdict.c */
/* Whether a conic is told as an arc of a circle, and the line that does (circle.c). */
int tells_circle(const struct fit *f);
void print_circle(const struct fit *f);
/* Sentences without full stop about what is not good, each with what was tried and cures it; their number (verdict.c). */
enum { MOST_PROBLEMS = 9 };
int problems_of(const struct fit *f, char *sentence[MOST_PROBLEMS]);
/* What they are, shortly, from the lowest bit of the quality on (cures.c). */
extern const char *const problem_name[MOST_PROBLEMS];
/* " (not so with OPTIONS)", those of the best trial, else of the first that has neither this problem nor a new one; nothing where there is none (cures.c). */
void put_cure(FILE *out, const struct fit *f, int problem);
void print_cures(const struct fit *f);
json_t *cures_json(const struct fit *f);
json_t *fit_json(const struct fit *f);                      /* json.c    */
json_t *fitted_curve_json(const cagd_spline *c);            /* as read_curve reads it; binary64 in 17 digits */
int write_curve(const struct fit *f, const char *path);     /* each: 0, or a line on stderr        */
int write_residuals(const struct fit *f, const char *path); /* CSV                                 */
int write_picture(const struct fit *f, const char *path);   /* picture.c                       */
#endif
