/* lab.h -- labs: assignments as folders of data, and what judges them; only for cli/lab.
 *
 * A lab is a folder NAME with
 *     README.md     the assignment, in English and Chinese, which the student gets
 *     lab.md        blocks {lab}, {requirement}, {triangle} and {wrong}, and the page for the lecturer around them
 *     figure.svg    the picture in it, if there is one
 *     start.c       what the student begins with; start.py where the language is Python, start.txt where numbers are asked for
 *     reference.c   what is right, by the definition, in C whatever the language
 *     right/        other right solutions
 * A block is ":::{kind} name", lines ":key: text" that go on in lines which begin with a blank, and ":::". */
#ifndef CAGD_LAB_H
#define CAGD_LAB_H

#include "exact/code/harness.h"
#include "exact/code/points.h"

#include <jansson.h>
#include <stdio.h>
#include <sys/types.h>

enum { LAB_MOST_CASES = 128, LAB_MOST_PATH = 4096, LAB_MOST_BYTES = 1 << 20, LAB_CAUSE = 600 };

/* ---- read.c: a lab ------------------------------------------------------------------------------------- */

/* Whole numbers by their letters, "n = 3, r = 2". */
enum { LAB_MOST_LETTERS = 4 };
struct lab_letters {
    int count;
    char name[LAB_MOST_LETTERS];
    long value[LAB_MOST_LETTERS];
};

/* One requirement for one degree, say: what is called, with which inputs. */
struct lab_case {
    const json_t *requirement;
    char label[64]; /* "n = 3", or "" */
    int number;     /* of its function in the driver */
    int earlier;    /* another case of the requirement, which is run before it where state is looked for */
    char *python;   /* the call in Python, where that is the language; else NULL */
    struct cagd_code_harness *h;
    char *formula;  /* in C: what puts the results of the formulas, in the place of the call; NULL: the reference's count */
    json_t *points; /* of triangles, in their order: {"triangle", "level", "name", "value": [formulas in C]} */
};

struct lab {
    char name[64], folder[LAB_MOST_PATH];
    const char *language; /* "c", "python" or "numbers"                                               */
    char file[80];        /* that the student hands in                                                */
    const json_t *head;   /* the block {lab}                                                          */
    json_t *blocks;       /* all; each has "kind", "name", "line", and for every key a list of texts  */
    int cases;
    struct lab_case at[LAB_MOST_CASES];
};

/* The lab in the folder; seed: what the inputs are drawn from.  NULL and a cause. */
struct lab *lab_read(const char *folder, const char *seed, char cause[LAB_CAUSE]);
void lab_free(struct lab *lab);
/* "$n" and "$(n+1)" become numbers.  The caller frees; NULL when one is not understood. */
char *lab_put_numbers(const char *text, const struct lab_letters *l);
/* Each of the cases "r = 1..n, i = 0..n-r", whose letters follow on those that are there; 0, or what `visit` says where that is not 0; -1: not
 * understood. */
int lab_each(const char *ranges, struct lab_letters *l, int (*visit)(void *what, const struct lab_letters *l),
             void *what);
/* The first text of a key, or "". */
const char *lab_text(const json_t *block, const char *key);
int lab_points(const json_t *requirement);
/* Whether the name is in a list of names with blanks between. */
int lab_lists(const char *list, const char *name);
/* The text of a file of at most LAB_MOST_BYTES, no link followed; NULL and errno. */
char *lab_file(const char *path);
/* The folder of all labs: beside the program, installed or built. */
int lab_folder(char path[LAB_MOST_PATH]);
/* The names of the labs there, sorted. */
json_t *lab_names(void);

/* ---- driver.c ------------------------------------------------------------------------------------------ */

#define LAB_DRIVER "lab.md" /* what its lines are of */
/* The C that calls what is handed in: for case K the functions lab_entry_K and, with other calls before it, lab_again_K. */
int lab_write_driver(const struct lab *lab, const char *path);

/* The driver of a harness as a function of that name, whose last lines are these. */
void lab_write_body(const struct cagd_code_harness *h, const char *name, const char *tail, FILE *out);

/* The function of that name: the harness h of the case, behind whose calls the inputs are told once more: they stay what they were. */
void lab_write_case(const struct lab_case *c, const struct cagd_code_harness *h, const char *name, FILE *out);

/* ---- formula.c: results that are told by formulas --------------------------------------------------------------- */

/* The formulas of the requirement, for these numbers, become part of the case; there may be none. */
int lab_read_formula(struct lab_case *c, const struct lab_letters *l, char cause[LAB_CAUSE]);
/* In C, behind the reference: for case K with formulas the function lab_formula_K, whose results are theirs. */
void lab_write_formulas(const struct lab *lab, FILE *out);
/* A rational function as the field writes it, in C.  NULL, or why it is none. */
const char *lab_put_function(const char *text, FILE *out);

/* ---- levels.c: what a triangle's levels are, and which an answer computes ---------------------------------- */

/* The triangles of the requirement, for these numbers, become part of the case. */
int lab_read_levels(const struct lab *lab, struct lab_case *c, const struct lab_letters *l, char cause[LAB_CAUSE]);
/* In C, behind the reference: for case K the function lab_levels_K, whose results are the numbers of the points of its triangles. */
void lab_write_levels(const struct lab *lab, FILE *out);
/* How far an answer comes in a triangle. */
struct lab_reached {
    int triangle;       /* its number, or -1: nothing is said                                                     */
    int levels, points; /* so many whole levels, and so many points of the next, in their order, are computed     */
    int missing;        /* the index of the first point that is not; -1: there is none                            */
    int instead;        /* the first other result of an operation that gives two points: its index, or -1         */
    size_t results;     /* so many are computed                                                                   */
    int told;           /* so many points of these are no number that stands there anyway                         */
};
/* At the point p, for numbers that nothing makes equal by chance, in the triangle in which it comes farthest.  got: of a run whose results
 * were noted; levels: what lab_levels_K says; whole, unless NULL: gets the lines of all triangles that are computed wholly. */
struct lab_reached lab_reach(const struct lab_case *c, const struct cagd_code_point *p, const json_t *got,
                             const json_t *levels, json_t *whole);
/* The same in words, with its numbers at the point `here`, and those of the point itself if they are not told elsewhere.  0: it is not so there
 * by some chance, or here is NULL, and the numbers are left out. */
int lab_tell_reached(const struct lab_case *c, const struct lab_reached *r, const struct cagd_code_point *here,
                     int names_inputs, const json_t *got, const json_t *levels, char text[LAB_CAUSE]);

/* ---- place.c: processes ---------------------------------------------------------------------------------- */

/* Where other people's code is compiled and run: a folder of its own and, if `shut`, no more than the system's programs beside
 * it, no network, and no other process. */
struct lab_place {
    char folder[LAB_MOST_PATH];
    int shut;
    char store[LAB_MOST_PATH]; /* where what is compiled there is kept, see keep.c; "": nothing is */
};
int lab_place_open(struct lab_place *p, int shut); /* 0, or -1 and errno */
void lab_place_close(const struct lab_place *p);
/* NULL, or why code cannot be shut in here. */
const char *lab_cannot_shut(void);
/* Starts it; writes the ends of the pipes to its input and from its output, unless NULL.  `errors`: a descriptor, or -1. */
pid_t lab_start(const struct lab_place *p, char *const word[], int *to, int *from, int errors);
/* Runs it to its end, with at most so many seconds and 2 GB of addresses; its output and errors go to a text that the caller frees.  The
 * exit code; 128 and the signal; -1, also when more was said than is kept. */
int lab_run(const struct lab_place *p, char *const word[], int seconds, char **said);
/* The same without a bound for addresses, of which a sanitizer takes terabytes; what is said is kept as far as there is room. */
int lab_run_sanitized(const struct lab_place *p, char *const word[], int seconds, char **said);

/* ---- play.c: the process that runs other people's code ----------------------------------------------------- */

/* Reads jobs and writes outcomes, a line of JSON each, until its input ends: `cagd lab --play OBJECT`. */
int lab_play(const char *object);

struct lab_player {
    pid_t pid;
    FILE *to, *from;
};
int lab_player_open(struct lab_player *p, const struct lab_place *place, const struct lab *lab, const char *object);
void lab_player_close(struct lab_player *p);
void lab_ask(struct lab_player *p, const json_t *job);
json_t *lab_answer(struct lab_player *p); /* NULL when there is none */

/* ---- keep.c: objects of the lab itself, from one check to the next --------------------------------------------- */

/* From then on what is made in the place is kept for this user, where there is a folder for that. */
void lab_keep_for(struct lab_place *p, const struct lab *lab);
/* Whether the file of that name, made of the text, was kept; it is in the place then. */
int lab_take_kept(const struct lab_place *p, const char *name, const char *text);
/* The file of that name in the place, made of the text, is kept where that can be done. */
void lab_keep(const struct lab_place *p, const char *name, const char *text);

/* ---- build.c ------------------------------------------------------------------------------------------- */

/* Why nothing became of a source: it has no place in an assignment, or it is no C. */
enum lab_reason { LAB_NO_REASON, LAB_REFUSED, LAB_NOT_EXPANDED };
/* The driver in the place and a source of the lab itself, of which something is made; the caller frees. */
char *lab_with_driver(const struct lab_place *place, const char *source);
/* A program that is installed with this one. */
const char *lab_program(const char *name, char path[LAB_MOST_PATH]);
/* The driver of the lab in its place, compiled once: all answers are linked with it.  NULL, or the cause, which the caller frees. */
char *lab_build_driver(const struct lab *lab, const struct lab_place *place);
/* The source becomes an object in the place, of that name, with the driver of the place `ready`; NULL, or the cause, which the caller
 * frees.  reason: unless NULL, whether it was refused before it was compiled. */
char *lab_build(const struct lab *lab, const struct lab_place *place, const struct lab_place *ready, const char *source,
                const char *object, enum lab_reason *reason);
/* What is seen in the source before it runs: {"refused": text or absent, "unset": a variable without a value, {"line", "name"}, or absent,
 * "notes": [{"line", "text"}]}. */
json_t *lab_inspect(const struct lab *lab, const struct lab_place *place);
/* What the sanitizers say about the code in binary64; NULL: nothing.  A list of jobs, as for a player. */
json_t *lab_sanitize(const struct lab *lab, const struct lab_place *place, const struct lab_place *ready,
                     const json_t *jobs);
/* The same for values that were never computed, integers among them, by which something is decided. */
json_t *lab_look_for_values(const struct lab *lab, const struct lab_place *place, const struct lab_place *ready,
                            const json_t *jobs);
/* The text of a wrong solution: of the file that the block names, with what it replaces.  NULL and a cause. */
char *lab_wrong_source(const struct lab *lab, const json_t *wrong, char cause[LAB_CAUSE]);

/* ---- source.c -------------------------------------------------------------------------------------------- */

/* What has no place in an assignment, "line 3: ...", which the caller frees, or NULL: among the directives of a source in C, and in
 * what the preprocessor made of it, of which the lines are looked at that its markers give to the file of the lab. */
char *lab_wrong_directive(const char *source);
char *lab_wrong_expansion(const struct lab *lab, const char *expanded);

/* ---- python.c -------------------------------------------------------------------------------------------- */

/* Whether the object, which is not the reference, is an answer in Python. */
int lab_is_python(const struct lab *lab, const char *object);
/* As lab_build, for an answer in Python: the object is its source, beside cagd_lab.py and cases.json. */
char *lab_build_python(const struct lab *lab, const struct lab_place *place, const char *source, const char *object);
/* As lab_inspect. */
json_t *lab_inspect_python(const struct lab_place *place, const char *file);

/* ---- same.c: rational functions as texts ----------------------------------------------------------------- */

/* Polynomials as texts, and which signs they have on a way, sums of CAGD_CODE_ZERO, ABOVE, BELOW. */
enum { LAB_MOST_COMPARED = 48 };
struct lab_compared {
    int count;
    const char *polynomial[LAB_MOST_COMPARED];
    int holding[LAB_MOST_COMPARED];
};
/* Whether two texts, "(0-2*t)/(p[0]+1)", are the same function wherever both have a value and the polynomials these signs: 1 is a proof. */
int lab_same_where(const char *a, const char *b, const struct lab_compared *compared);
/* Whether it is a polynomial in one variable, and no fraction is a zero of it, so that no number in a computer is: it has no linear factor
 * over the rationals.  0 where that is not so, or not known. */
int lab_is_zero_at_no_fraction(const char *polynomial);

/* ---- numbers.c ------------------------------------------------------------------------------------------- */

/* Whether the object, which is not the reference, is made of a file of numbers. */
int lab_is_numbers(const struct lab *lab, const char *object);
/* The file of numbers as functions in C; NULL and a cause, which the caller frees.  digits: of all numbers together. */
char *lab_numbers_as_c(const char *source, char **cause, long *digits);
/* As lab_inspect. */
json_t *lab_inspect_numbers(const char *source);

/* ---- ways.c -------------------------------------------------------------------------------------------- */

/* The ways that two codes, an answer and the reference, take together through their comparisons, for inputs of one harness. */
struct lab_ways;
struct lab_ways *lab_ways_new(const struct cagd_code_harness *h);
void lab_ways_free(struct lab_ways *w);
/* Whether the outcomes, of any numbers, are those of a way that was not met before. */
int lab_ways_is_new(struct lab_ways *w, const json_t *got, const json_t *want, const struct cagd_code_point *p);
/* The outcomes in the field at the point: a way, with what was compared and divided by on it. */
void lab_ways_add(struct lab_ways *w, const json_t *got, const json_t *want, const struct cagd_code_point *p);
/* A point to be tried, which may take a way that is not known, or at which the answer may divide by 0; the caller's.  NULL: none is left. */
struct cagd_code_point *lab_ways_next(struct lab_ways *w);
/* What is known when no point is left.  Of the conditions on all ways: */
struct lab_open {
    int conditions; /* comparisons that depend on the inputs                                             */
    int branches;   /* those whose other branch was not met, and is not proved to be taken by no inputs  */
    int line;       /* of the first of these in the answer, or 0; and what is compared there:             */
    char compared[200];
    int undecided;    /* those of them whose border was not found either; or there were too many           */
    int denominators; /* what is divided by, and not proved to be never 0                                  */
};
struct lab_open lab_ways_open(const struct lab_ways *w);

/* ---- judge.c ------------------------------------------------------------------------------------------- */

/* What is kept from one submission to the next. */
struct lab_bench {
    const struct lab *lab;
    struct lab_place own;    /* the reference, and wrong solutions as they are needed */
    struct lab_player right; /* the reference */
    json_t *known;           /* what it said to each job */
    json_t *kept;            /* by their sources, objects of answers that were judged; NULL: none is kept */
    json_t *whole; /* of the triangles that right answers compute wholly, their lines in lab.md; NULL: not asked */
    struct lab_player wrong[64];
    int built[64];
    struct {
        int is_known;
        double ulps;
        long operations;
    } best;     /* what rounding and cost are at best, of right solutions in the last case */
    int points; /* how many at least are tried */
    int draws;  /* whether results have what a picture needs */
};
/* keeps: whether what is compiled of the lab is kept for the next time. */
int lab_bench_open(struct lab_bench *b, const struct lab *lab, int keeps, char cause[LAB_CAUSE]);
void lab_bench_close(struct lab_bench *b);
/* The result for the source text: see cli/schemas/cagd-lab-1.schema.json.  shut: as in lab_place. */
json_t *lab_judge(struct lab_bench *b, const char *source, int shut);

/* ---- picture.c ------------------------------------------------------------------------------------------- */

/* Of each requirement with another result a panel, what was got over what was expected; NULL where there is none, or it cannot be drawn.
 * name: of the picture, as svg_new has it.  The caller frees it. */
char *lab_picture(const char *name, const json_t *result);

/* ---- page.c, grade.c, make.c ------------------------------------------------------------------------------ */

void lab_print(const struct lab *lab, const json_t *result);
int lab_grade(const struct lab *lab, const char *submissions, const char *out, int jobs, const char *seed);
int lab_begin(const struct lab *lab, const char *folder); /* cagd lab start; an exit code, as the next */
int lab_new(const char *name);
int lab_test(const char *folder, int json);
#endif
