/* witness.h -- at what a claim fails: the data of the case, and a small instance. */
#ifndef CAGD_WITNESS_H
#define CAGD_WITNESS_H

#include "chapters/judge/claim.h"
#include "exact/number/rational.h"
#include "exact/words.h"

/* What a body asks for: any number, a positive one, any parameter, one of (0, 1), a whole one of a range. */
enum input_kind { ANY_NUMBER, POSITIVE_NUMBER, PARAMETER, FRACTION, WHOLE_NUMBER };

/* One number that a body asked for, in the order in which it asks. */
struct small_input {
    char name[16];
    int index; /* -1: none                                                                */
    enum input_kind kind;
    int low, high; /* of a whole number                                                       */
    int rank;      /* its place among the numbers of its kind, simplest first                 */
    char *value;
};

/* The data of a case: simple numbers in the place of random ones, or these themselves, which are then only kept. */
struct small_data {
    int random;
    struct small_input *at;
    int count, next; /* known so far; to be asked for next                                      */
    int largest;     /* the largest rank that is drawn for one that is not known                */
    trial draws;     /* their generator                                                         */
};

/* The number that the body asks for next; T->small is where it stands. */
num_q small_number(trial *T, const char *name, int index, enum input_kind kind, int low, int high);
/* Keeps the random number that the body was given. */
void keep_input(trial *T, const char *name, int index, num_q a);

/* Case k, which fails, runs again: what *T shows is then the degree, the data that the case asked for, and what it showed. */
struct plan;
void show_case(const struct plan *p, int k, trial *T);
/* Looks, in rationals, for simple data with which the identity or the decision fails by comparison, at the lowest degree where
 * some are found: within 400 runs and two seconds.  *shown: the degree, the data, what is compared; the caller frees it.  None:
 * *count is 0. */
void find_witness(const claim *c, exhibit **shown, int *count);
#endif
