/* words.h -- the words in which the bodies of claims are written, besides + - * / : data, comparison,
 * and what is shown.  Each word has one meaning in every number type.
 *
 *   unknown(T, "x", i)    any number: a variable x_i of the field; elsewhere a random dyadic in [-1, 1]
 *   positive(T, "w", i)   a positive number: a variable; elsewhere a random dyadic in [1/8, 4]
 *   parameter(T, "t")     any parameter: a variable; elsewhere a random dyadic in (-1, 2)
 *   whole(T, "n", a, b)   a whole number: a variable, so that what is proved holds for every n;
 *                         elsewhere a random integer in [a, b]
 *   inside(T, "s")        a number of (0, 1): s/(1+s) in the field with s > 0; elsewhere a random dyadic in (0, 1)
 *   same(T, a, b)         compare: must be equal
 *   vanishes(T, a)        compare: must be 0
 *   nonnegative(T, a)     compare: must be >= 0.  In the field: numerator and denominator have only
 *                         coefficients of one sign, every variable being positive; otherwise UNABLE
 *   agree(T, condition)   compare: a condition that was decided exactly must hold
 *   refute(T, condition)  in a counterexample: a condition, decided exactly, that contradicts what is printed
 *   show(T, "x", a)       exhibit a value;  show_points(T, "R", count, dim, R) exhibits points
 *
 * The data of a claim stand in its block, :data: R = (0,0) (1,2) (2,0); w = 1 0 1; n = 2, and what comes out of them in
 * :result: R''(0) = (4,0).  In the control a datum of the same name in :instead: takes the place of that in :data:.
 *
 *   given(T, "t")                       the number of that name; shown, as everything given
 *   given_points(T, "R", count, dim, R) fills R with the points of that name, which are just so many
 *   given_whole(T, "n")                 the whole number of that name, as an int
 *   given_text(T, "F")                  the text of that name
 *   found(T, "x", a)                    a is the result of that name: shown and compared with it
 *   found_points(T, "S", count, dim, S), found_whole(T, "n", k), found_text(T, "F", text)   the same
 *
 * What is given, and what comes out as it is stated, is shown as it is written in the block: 0.15 and not 3/20.
 *
 * In the control nothing is compared with the results.  An entry that nobody asks for in the run is a mistake, and so is a
 * result that differs: the claim is then not as expected, whatever it compared.
 *
 *   fault(T, right, wrong) the wrong value where the named fault is in: in the control of an identity or decision, and in
 *                         the run of a counterexample, which computes what is printed; otherwise the right one
 *
 * The data are the same dyadic numbers in every arithmetic, so binary64 starts from exact values. */
#ifndef CAGD_WORDS_H
#define CAGD_WORDS_H

#include "chapters/judge/claim.h"
#include "core/number/num_measured.h"
#include "exact/number/interval.h"
#include "exact/record/number.h"
#include "exact/words.h"

int pick(trial *T, int low, int high);  /* a seeded random integer in [low, high]                     */
void about(trial *T, const char *what); /* names what the next comparisons are about                  */
/* The formula of a condition, as it stands in the body, is written into the certificate beside the facts that it combines. */
void agree_as(trial *T, int condition, const char *formula);
#define agree(T, ...)          agree_as(T, (__VA_ARGS__) != 0, #__VA_ARGS__)
#define refute(T, ...)         agree_as(T, !(__VA_ARGS__), "!(" #__VA_ARGS__ ")")
#define fault(T, right, wrong) ((T)->faulty ? (wrong) : (right))
void show_text(trial *T, const char *name, const char *format, ...) __attribute__((format(printf, 3, 4)));

int given_whole(trial *T, const char *name);
const char *given_text(trial *T, const char *name); /* lives as long as the claim                          */
void found_whole(trial *T, const char *name, int value);
void found_text(trial *T, const char *name, const char *text);

enum { ALONE = -1 }; /* the index of a number whose letter has none */

#define JUDGE_WORDS(S)                                                                                                 \
    num_##S unknown_##S(trial *T, const char *name, int index);                                                        \
    num_##S positive_##S(trial *T, const char *name, int index);                                                       \
    num_##S parameter_##S(trial *T, const char *name);                                                                 \
    num_##S whole_##S(trial *T, const char *name, int low, int high);                                                  \
    num_##S inside_##S(trial *T, const char *name);                                                                    \
    void same_##S(trial *T, num_##S a, num_##S b);                                                                     \
    void vanishes_##S(trial *T, num_##S a);                                                                            \
    void nonnegative_##S(trial *T, num_##S a);                                                                         \
    void show_##S(trial *T, const char *name, num_##S a);                                                              \
    void show_points_##S(trial *T, const char *name, int count, int dim, const num_##S R[]);                           \
    num_##S given_##S(trial *T, const char *name);                                                                     \
    void given_points_##S(trial *T, const char *name, int count, int dim, num_##S R[]);                                \
    void found_##S(trial *T, const char *name, num_##S a);                                                             \
    void found_points_##S(trial *T, const char *name, int count, int dim, const num_##S R[]);
JUDGE_WORDS(f)
JUDGE_WORDS(q)
JUDGE_WORDS(i)
JUDGE_WORDS(m)
#undef JUDGE_WORDS
#endif
