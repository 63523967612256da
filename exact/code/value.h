/* value.h -- the values behind the numbers of a run; only for exact/code. */
#ifndef CAGD_CODE_VALUE_H
#define CAGD_CODE_VALUE_H

#include "exact/code/run.h"
#include "exact/number/field.h"
#include "exact/number/interval.h"

/* How much of the error of a number arose at a line. */
struct cagd_code_share {
    const struct cagd_code_place *place;
    double amount;
};

/* What a number is.  q: its value, at the point where there are variables; q.at = NULL: it is known by the interval i only.
 * f: the rational function; f.at = NULL: a constant, or a run without variables.  d: the binary64 of a run with rounding, and
 * d - q the sum of the shares.  special: an infinity or a NaN, d. */
typedef struct cagd_code_value {
    cagd_num_q q;
    cagd_num_i i;
    cagd_num_f f;
    double d;
    const struct cagd_code_share *share;
    int shares, special;
    int made; /* in a run with rounding: which operation made it, from 1 (orders.h); 0: not noted */
} cagd_code_value;

/* The run of this process. */
struct cagd_code_machine {
    const struct cagd_code_job *job;
    struct cagd_code_outcome *outcome;
    char *free_room, *end_of_room; /* of the memory that the outcome shares with the parent */
    int given;
    int entered;  /* the code runs, and what is made before it is made      */
    void *object; /* of dlopen */
};
extern struct cagd_code_machine cagd_code_machine;

void cagd_code_values_open(void);
/* Which numbers there are; and from then on the later ones are none any more. */
struct cagd_code_mark {
    uint32_t used, used_singles;
    cagd_region_mark region;
};
struct cagd_code_mark cagd_code_values_mark(void);
void cagd_code_values_back(struct cagd_code_mark *mark);
cagd_code_value cagd_code_value_of(double x); /* ends the run for a number that was never computed           */
double cagd_code_number(cagd_code_value v);   /* the double that carries it                                   */
void cagd_code_bound_bits(cagd_num_q q);      /* ends the run where it has more bits than the job allows      */
int cagd_code_is_one(uint64_t bits);          /* whether the bits are those of a number in the table          */
int cagd_code_is_single(uint32_t bits);
int cagd_code_was_computed(double x); /* not what stands in variables and memory before */

cagd_code_value cagd_code_constant(cagd_num_q q);
cagd_code_value cagd_code_integer(long n);
cagd_code_value cagd_code_special(double d);
cagd_code_value cagd_code_enclosed(cagd_num_i i);

/* A root: a variable of its own in the field, with its square; where it has none elsewhere, an interval or a refusal. */
cagd_code_value cagd_code_square_root(cagd_code_value a);
/* A variable of the field whose square is `square`, with that value at the point; is_positive: its positive root, the same
 * variable for the same square. */
cagd_code_value cagd_code_new_root(cagd_num_f square, cagd_code_value at_point, int is_positive);
/* Whether f is 0 for all values of the variables, given what the squares of roots are. */
int cagd_code_vanishes(cagd_num_f f);
int cagd_code_vanishes_here(cagd_num_f f); /* wherever the conditions of the path hold */
int cagd_code_equal_here(cagd_num_f a, cagd_num_f b);
/* "The sign of f is one of these" is a condition of the way: a sum of 1 for 0, 2 for above, 4 for below. */
void cagd_code_know_sign(cagd_num_f f, int signs);
/* The signs that f can have where the conditions of the way hold; 7 where nothing is known. */
int cagd_code_signs_here(cagd_num_f f);
cagd_num_q cagd_code_value_at_point(const char *name); /* of a variable, from the job's inputs */
int cagd_code_has_roots(void);                         /* whether some root or angle is a variable of its own */
/* Whether an input has that name: then a variable that is none needs another one. */
int cagd_code_is_input(const char *name);
/* A variable that is no input is somewhere at the point; those of which that was said, in their order. */
void cagd_code_enclose_variable(cagd_num_f variable, cagd_num_i place);
int cagd_code_enclosed_count(void);
cagd_num_f cagd_code_enclosed_at(int k, cagd_num_i *place);
/* The variables that are inputs, and their values at the point; whether f has others in it, roots and the like. */
int cagd_code_variable_count(void);
cagd_num_f cagd_code_variable_at(int k, cagd_num_q *value);
int cagd_code_has_others(cagd_num_f f);
cagd_num_q cagd_code_at_point(cagd_num_f f); /* q.at = NULL where roots are in it                        */
/* A variable that f has linearly, times a constant, and what it is where f = 0; 0 when there is none. */
int cagd_code_solve(cagd_num_f f, cagd_num_f *variable, cagd_num_f *value);
cagd_num_f cagd_code_function(cagd_code_value v); /* v as an element of the field */
cagd_num_i cagd_code_interval(cagd_code_value v);

/* A variable of the field, with its value at the point. */
cagd_code_value cagd_code_variable(const char *name, cagd_num_q value);
double cagd_code_real(cagd_code_value v); /* near the exact value                            */
/* In a run with rounding: the error of v is that of a times c, that of b times e, and what was rounded here. */
void cagd_code_shared(cagd_code_value *v, cagd_code_value a, double c, cagd_code_value b, double e, double rounded);

cagd_code_value cagd_code_sum(cagd_code_value a, cagd_code_value b);
cagd_code_value cagd_code_difference(cagd_code_value a, cagd_code_value b);
cagd_code_value cagd_code_product(cagd_code_value a, cagd_code_value b);
cagd_code_value cagd_code_quotient(cagd_code_value a, cagd_code_value b);
cagd_code_value cagd_code_negative(cagd_code_value a);

/* The relation between a and b, one of 1, 2, 4, 8; noted as the condition "the predicate is true (or false)". */
int cagd_code_relation(cagd_code_value a, cagd_code_value b, int predicate);
/* What was decided, a truth or the whole number that was made of a number, is part of the path, whether or not it is told. */
void cagd_code_follow(long outcome);
/* What is divided by must not be 0: told, once for each function, unless the conditions of the way say so. */
void cagd_code_note_divisor(cagd_num_f f);
/* -1, 0, 1, and the condition that says so. */
int cagd_code_sign(cagd_code_value a);

enum cagd_code_rounding { CAGD_CODE_TRUNC, CAGD_CODE_FLOOR, CAGD_CODE_CEIL, CAGD_CODE_ROUND, CAGD_CODE_EVEN };
cagd_code_value cagd_code_whole(cagd_code_value a, enum cagd_code_rounding how);

const char *cagd_code_text(cagd_code_value v);       /* at the point: "-3/7", "in [1.4, 1.5]", "inf"; in the region  */
const char *cagd_code_field_text(cagd_code_value v); /* in the field                                               */

/* One of the results "name[index]", of `count`, and what it should be: told, and compared. */
struct cagd_code_result *cagd_code_expect_one(const char *name, long count, long index, double got, double wanted);

/* Ends the run. */
_Noreturn void cagd_code_stop(enum cagd_code_end end, const char *format, ...);
/* Room in the memory shared with the parent; a text in it. */
void *cagd_code_room(size_t bytes);
const char *cagd_code_keep(const char *text);
void cagd_code_check_faults(void); /* ends the run where the arithmetic reports a fault */
#endif
