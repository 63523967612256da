/* scope.h -- what names mean: definitions, variables, and the letters that are bound where a formula is read.
 *
 * A definition B_i^n(t) = ... has patterns on its left: a letter stands for whatever is given, a number for itself alone; of
 * several definitions of one name the first whose patterns and conditions fit is taken. */
#ifndef CAGD_SCOPE_H
#define CAGD_SCOPE_H

#include "exact/expression/tree.h"

typedef struct cagd_definition {
    const cagd_tree *left, *body, *when; /* when: a condition, or NULL                    */
    int dimension;                       /* of a vector or matrix; 0 of a number          */
    unsigned functions; /* bits: which children of the left side are functions; they have `arity` arguments   */
    int arity;
    struct cagd_definition *next; /* in the order in which they were written       */
} cagd_definition;

/* A variable, with so many lower and upper indices: "\omega_i", "t"; or one of them alone, "\omega_3", whose bounds are not those of the others.
 * Its values, where bounds are known: the bounds are trees, which may have the names of numbers, and the letters that the indices have in `left`; a
 * bound that is NULL is none. */
typedef struct cagd_variable {
    const char *head;
    const cagd_tree *left; /* the name as it was declared, or NULL */
    int lower, upper;
    int dimension; /* of a vector or matrix; 0 of a number */
    int whole;     /* runs over the whole numbers from low to high; every number from low on when high is NULL */
    int real;      /* it was said to be a real number, by a set or an interval: no index makes it a whole one  */
    const cagd_tree *low, *high;
    int low_open, high_open; /* < and not <= */
    long step; /* of whole numbers: low, low + step, ... up to high, which has to be one of them; 0 is 1 */
    const cagd_tree *const
        *listed; /* the whole numbers, one by one, or NULL; low and high are then the first and the last of the list */
    int listed_count;
    /* NULL, or for which indices the bounds are, a condition of the letters in `left`: the others have those of an earlier declaration. */
    const cagd_tree *when;
    int some; /* these are the whole numbers from `first` to `last` */
    long first, last;
    const struct cagd_variable *next;
} cagd_variable;

typedef struct cagd_scope {
    cagd_definition *definitions;
    const cagd_variable *variables; /* the last declared first          */
    const cagd_tree **conditions;   /* what else is supposed            */
    int condition_count;
    const cagd_variable *block; /* of a block of meanings that is being read (in_block): what was declared before it */
    int in_block;
    int zero_over_zero;       /* whether 0/0 = 0 was said                     */
    const cagd_tree **labels; /* letters that as an index are part of the name: R_s */
    int label_count;
} cagd_scope;

/* The first definition of that name, the variable of that name; NULL if there is none. */
const cagd_definition *cagd_defined(const cagd_scope *scope, const char *head);
const cagd_variable *cagd_declared(const cagd_scope *scope, const char *head);
/* The declaration of the name t with the indices of the key: that of it alone, or of those for which `is_for` says so, with its indices in the bounds;
 * NULL if there is none. */
const cagd_variable *cagd_declared_for(const cagd_scope *scope, const cagd_tree *t, const char *key, const long index[],
                                       int (*is_for)(void *data, const cagd_variable *v, const long index[]),
                                       void *data);
/* The key of a name with these indices, "\omega_{12}^3"; the length that it would have, as snprintf. */
int cagd_put_key(char key[], int room, const cagd_tree *t, const long index[]);
/* The dimension of the vectors of that name; 0 where they are numbers, or where it is not known. */
int cagd_dimension_of(const cagd_scope *scope, const char *head);
int cagd_is_label(const cagd_scope *scope, const char *head);
/* Whether it is the letter of an argument on the left of some definition: such a letter is a number wherever else it stands. */
int cagd_is_parameter(const cagd_scope *scope, const char *head);
/* The known name that is nearest to that one in spelling, or NULL where none is near. */
const char *cagd_nearest(const cagd_scope *scope, const char *head);

/* The scope with one more, while copies of it that were made before stay what they are.  0, or NULL, when there is no memory.  The
 * body of the new definition is to be filled in: it may use its own name. */
cagd_definition *cagd_define(cagd_scope *scope, const cagd_tree *left);
int cagd_declare(cagd_scope *scope, cagd_variable v);
/* Whether the letter is a whole number wherever it is an index with bounds: i, j, k, l, m, n, r. */
int cagd_is_usual_index(const char *head);
/* A number as it stands, 1/2 or -3. */
int cagd_is_plain_number(const cagd_tree *t, cagd_num_q *value);
/* Whether the letter is called as last indices are and running ones are not: n, m, N, M. */
int cagd_is_called_as_last(const char *letter);
/* Variables with a lower bound that are indices of names of the tree, ends of its sums, or stand below in binomial coefficients become whole
 * numbers, 0 <= i <= n being 0, 1, ..., n, where they were not said to be real and their bounds do not show it.  0 and an error where a name is an index
 * of a function, which may be a parameter, and neither its bounds nor its letter say what it is: 0 <= alpha <= 1. */
int cagd_make_indices_whole(cagd_scope *scope, const cagd_tree *t, cagd_reading_error *error);
int cagd_suppose(cagd_scope *scope, const cagd_tree *condition);
int cagd_label(cagd_scope *scope, const cagd_tree *letter);
#endif
