/* command.h -- what the subcommands share: exit codes, selection, terminal, files, JSON. */
#ifndef CAGD_COMMAND_H
#define CAGD_COMMAND_H

#include "chapters/chapters.h"
#include "chapters/judge/run.h"
#include "exact/number/rational.h"
#include "exact/words.h"

#include <argp.h>
#include <jansson.h>
#include <stdio.h>

enum exit_code { EXIT_AS_EXPECTED = 0, EXIT_NOT_AS_EXPECTED = 1, EXIT_USAGE = 2, EXIT_INTERNAL = 3 };

struct command {
    const char *name, *summary;
    int (*run)(int argc, char **argv); /* argv[0] is "cagd NAME"; returns an exit code            */
};
int run_verify(int argc, char **argv);
int run_list(int argc, char **argv);
int run_show(int argc, char **argv);
int run_ledger(int argc, char **argv);
int run_figures(int argc, char **argv);
int run_curve(int argc, char **argv);
int run_fit(int argc, char **argv);

/* Parses with argp; a usage error prints one line and ends the program with EXIT_USAGE. */
void parse_arguments(const struct argp *argp, int argc, char **argv, void *input);
/* A whole number in [low, high], or one line that says what was expected, and EXIT_USAGE. */
int whole_number(struct argp_state *state, const char *option, const char *text, int low, int high);

/* ---- selection (select.c) --------------------------------------------------------------------- */

/* Patterns are shell globs.  One matches a claim by its name, by chapter.name, or by the id of a
 * statement that the claim decides; no pattern matches all. */
struct patterns {
    char **at;
    int count;
};
int claim_matches(const claim *c, const struct patterns *p);
int statement_matches(const statement *s, const struct patterns *p);
/* The claims that match; with a statement, all claims it names.  The caller frees. */
const claim **matching_claims(const struct patterns *p, int *count);
const statement **matching_statements(const struct patterns *p, int *count);
const claim **claims_of(const statement *const list[], int statements, int *count);
/* What a pattern or an id may name. */
enum kind_of_name { STATEMENTS_AND_CLAIMS, FIGURES };
/* One line on stderr: nothing of this kind is called so, and the names nearest to it. */
void complain_about(const char *id, enum kind_of_name kind);
/* Whether every pattern matches something; a line on stderr about the first that does not. */
int all_match_claims(const struct patterns *p);
int all_match_statements(const struct patterns *p);

/* ---- terminal (terminal.c) -------------------------------------------------------------------- */

enum style { PLAIN, BOLD, DIM, GOOD, BAD, WARN };
/* The escape sequence for the style, or "" unless the stream is a terminal without NO_COLOR. */
const char *style(FILE *stream, enum style s);
int is_terminal(FILE *stream);
int columns_of(const char *utf8);                                         /* printed width of a text              */
void put_padded(FILE *out, const char *utf8, int width);                  /* text and blanks up to the width      */
void put_clipped(FILE *out, const char *utf8, int width);                 /* as much as fits, and " ..." if cut   */
void put_paragraph(FILE *out, const char *utf8, int indent, int width);   /* filled lines            */
void show_progress(void *context, int done, int total, const char *name); /* run_options.progress  */
void end_progress(void);
int processors(void);

/* Judges claims with progress on a terminal. */
claim_result *judge_with_progress(const claim *const list[], int count, int jobs, int deep);

/* ---- files (output.c) ------------------------------------------------------------------------- */

/* Output goes to a temporary file beside `path`, renamed when it is whole.  NULL and a line on
 * stderr when it cannot be written. */
struct output;
struct output *output_open(const char *path);
FILE *output_stream(struct output *o);
int output_close(struct output *o); /* 0 when the file is in place                                 */
int write_text_file(const char *path, const char *text);
int make_folder(const char *path); /* with its parents; 0 on success                              */

/* ---- curves (curve_json.c) --------------------------------------------------------------------- */

/* A Bézier, rational Bézier, B-spline or NURBS curve, exactly as a file says it.  A Bézier curve is a spline of one
 * span over 0, ..., 0, 1, ..., 1.  Shapes as in core/kernels/bspline.tmpl.h; weights NULL: none.  Lives in the region. */
struct curve {
    int degree, count, dim;
    num_q *knots, *points, *weights;
};

/* Reads {"kind": ..., "degree" or "order": ..., "points": ..., "weights": ..., "knots": ...} from the file, "-" for
 * standard input, and checks it.  0 on success; otherwise -1 and one line on stderr that says what, where, and what was
 * expected. */
int read_curve(const char *path, struct curve *c);
json_t *
curve_json(const struct curve *c); /* the same format; whole numbers as such, other rationals as strings       */
json_t *number_json(num_q a);
/* The exact value of an option; one line and EXIT_USAGE when it is not a number. */
num_q exact_number(struct argp_state *state, const char *option, const char *text);

/* ---- reports (report.c, ledger.c) ------------------------------------------------------------- */

json_t *claim_json(const claim_result *r);
json_t *statement_json(const statement_result *r, const claim_result *results, int count);
/* All forms of the ledger as files in the folder, from a run over all claims: ledger.txt the rows, summary.txt the counts,
 * striking.txt the three most striking counterexamples, ledger.json.  How many statements are not as expected, or -1 and
 * a line on stderr when a file cannot be written. */
int write_report(const char *folder, const claim_result *results, int claims);
int write_junit(const char *path, const claim_result *results, int count);
void print_json(json_t *document);         /* prints and releases; reals are times, of 6 digits           */
void print_json_exactly(json_t *document); /* the same; reals are results, of 17 digits                  */

/* The counterexample, or whatever the claim shows, in one line: "n = 2; w = 1, 2, 1; ...". */
char *exhibits_line(const claim_result *r);
const type_result *speaking_type(const claim_result *r); /* whose exhibits speak for the claim      */

/* Counts of verdicts by source key. */
struct tally {
    char source[32];
    int verdict[6];
    int total;
};
int tally_statements(const statement_result *list, int count, struct tally tally[], int room);
#endif
