/* evaluate.h -- the value of a formula: in rationals, where all names have values, and in the field where some are variables.
 *
 * The power with exponent 0 is 1 whatever its base; a binomial coefficient is a(a-1)...(a-b+1)/b! for whole b >= 0, and 0 for
 * b < 0; a sum over nothing is 0 and a product 1.  Primes and derivatives are computed in the field. */
#ifndef CAGD_EVALUATE_H
#define CAGD_EVALUATE_H

#include "exact/decide/roots.h"
#include "exact/expression/scope.h"
#include "exact/expression/value.h"

#define CAGD_PI "\\pi"
enum { CAGD_MOST_UNKNOWNS = 64, CAGD_MOST_LIMITS = 128, CAGD_MOST_MEMOS = 256, CAGD_MOST_LETTERS = 4 };

/* A name with a value: "t", "\omega_3".  The value is a number, or a variable of the field; then the bounds are what is known of
 * it. */
typedef struct cagd_binding {
    const char *key;
    const cagd_variable *variable; /* its declaration, or NULL */
    cagd_value value;
    int unknown;    /* a variable of the field */
    int number;     /* its index there */
    int solved;     /* was one, and is a function of the others where an equality holds (cell.h) */
    int near, side; /* a fresh variable near the value `place`: above (side 1), below (-1), or there (0)      */
    cagd_value place;
    int has_low, has_high, low_open, high_open;
    cagd_num_q low, high;
    int is_tied;  /* and that by an equality of higher degree (tie.h)                     */
    int has_root; /* it is that root, and its bounds are rational numbers near it (tie.h) */
    struct cagd_root root;
    int is_number;     /* and no name of the page                                                    */
    int is_letter;     /* it has that value for a while, in place of its own                           */
    int hidden;        /* other names are functions of it that the page does not know (tie.h)            */
    const char *angle; /* the angle of whose part this is the tangent, or, where it has none, the cosine; or NULL */
    int of_pi;         /* the angle is \pi times that name                                            */
    int turned;        /* and that of what it is behind so many quarters of the way around (angle.h)   */
    /* Whether the lower, the upper end is this root, of which `low` and `high` are numbers outside: no other root of its polynomial is between
     * the bounds, and so the sign of its polynomial tells on which side of it the name is. */
    int is_root_end[2], root_end_open[2];
    struct cagd_root root_end[2];
} cagd_binding;

/* A variable is looked at below a number, or above it, only. */
typedef struct cagd_piece {
    const char *key;
    int below;
    cagd_num_q at;
} cagd_piece;
enum { CAGD_MOST_PIECES = 64 };

/* A linear form in names without values, and its sign: 1, 0, -1.  It lives in the region. */
typedef struct cagd_cut_term {
    const char *key;
    const cagd_variable *variable;
    cagd_num_q coefficient;
} cagd_cut_term;
typedef struct cagd_cut {
    int count; /* at least 2 */
    const cagd_cut_term *term;
    cagd_num_q constant;
    int sign;
} cagd_cut;
enum { CAGD_MOST_CUTS_OF_CELL = 60 };

/* form > 0, or form >= 0; a polynomial of degree 1 in variables of the field. */
typedef struct cagd_limit {
    cagd_num_f form;
    int strict;
    struct cagd_linear at; /* the form once more, by its coefficients */
} cagd_limit;

/* Numbers that names have together where no variable reaches: c = -1, s = 0. */
typedef struct cagd_apart {
    const char *key[2];
    const cagd_variable *variable[2];
    cagd_num_q value[2];
    int count;
} cagd_apart;
enum { CAGD_MOST_APART = 8, CAGD_MOST_ROOTS = 16 };

/* Sums, products, and "for all" of the formula, and whether they had a term. */
enum { CAGD_MOST_SUMS = 16 };
typedef struct cagd_sums_met {
    const cagd_tree *sum[CAGD_MOST_SUMS];
    int had_terms[CAGD_MOST_SUMS], count;
} cagd_sums_met;

/* The signs that a form can have in the cell, as bits. */
enum { CAGD_CAN_BE_NEGATIVE = 1, CAGD_CAN_BE_ZERO = 2, CAGD_CAN_BE_POSITIVE = 4, CAGD_ANY_SIGN = 7 };
typedef struct cagd_memo {
    cagd_num_f form;
    unsigned signs;
} cagd_memo;

/* A way through a program that is run at one point: what names are, and how comparisons come out there, is known to it, and it notes
 * them. */
typedef struct cagd_way {
    int (*name)(const char *key, cagd_value *value);    /* 0: there is none                            */
    int (*holds)(cagd_num_f d, cagd_relation relation); /* d relation 0                                */
    int (*equal)(cagd_num_f a, cagd_num_f b);           /* wherever the program takes this way         */
} cagd_way;

typedef struct cagd_context {
    const cagd_scope *scope;
    const cagd_way *way;      /* NULL: whatever values the names have                         */
    const cagd_tree *premise; /* what is supposed besides the conditions of the scope, or NULL */
    cagd_binding binding[CAGD_MOST_UNKNOWNS];
    int count;
    cagd_piece piece[CAGD_MOST_PIECES];
    int pieces;
    int used_bounds; /* whether what was found depends on the bounds of a variable */
    int in_field;    /* names without a value become variables of the field; otherwise they are UNABLE           */
    int has_roots;   /* the square root of a number that is no square is a variable, too (tie.h)     */
    long steps;      /* what may still be done; UNABLE when it is used up                                        */
    double until;    /* and until when on cagd_seconds, or 0: without end                                        */
    int depth, fresh;
    int met_root;        /* a root was asked for that is no rational function                                      */
    int angles;          /* how often an angle was asked for (angle.h)                                              */
    int whole_angles;    /* no halves of angles come up                                                             */
    int mixes_angles;    /* a name is an angle and a number, or \pi is one: not tied here (enclosed.h)              */
    int knows_angles;    /* whether definitions have angles: not known yet, no, yes                                 */
    int component;       /* of vectors this one is asked for, from 1; 0: none is                            */
    int asks_for_number; /* an angle that is moved was asked for as a number, which it was not known as            */
    const char *trouble; /* why there is no value, in words; NULL while nothing went wrong                 */
    const cagd_tree *where; /* and at which part of the formula                                              */
    const char *split;      /* a condition changes where this name has the value split_at                    */
    cagd_num_q split_at;
    int has_cut; /* or where this form changes its sign */
    cagd_cut cut;

    int missing; /* conditions, and a premise, that were supposed and are not used: what holds, holds without them */
    int untied;  /* equalities of higher degree are not used (tie.h) */
    int ties;    /* how many were                                    */
    int loose;   /* a bound of a name that became a function of others is not known of these */
    cagd_apart apart[CAGD_MOST_APART];
    int aparts;
    const cagd_binding *rooted; /* NULL, or a name that is one of these roots */
    struct cagd_root root[CAGD_MOST_ROOTS];
    int roots;

    /* The cell: what is known of names together. */
    cagd_limit limit[CAGD_MOST_LIMITS];
    int limits, is_empty; /* is_empty: what is known contradicts itself */
    int supposed;         /* of so many names the conditions for every index are among the limits */
    cagd_memo memo[CAGD_MOST_MEMOS];
    int memos;
    int met_joint;           /* a condition changed where a derivative was taken                                  */
    int divided_beside;      /* where a derivative was taken something was divided by that depends on the variable */
    int omits_poles;         /* a divisor can be 0, and nothing is said of that                               */
    int fits_none;           /* no definition of a name fitted                                                */
    int undefined_otherwise; /* the last value was undefined for another reason than a division by 0 */
    int passes_divisions;    /* a division by 0 is taken for 0: it is asked whether something else is undefined */
    cagd_num_f *divisor;     /* where it is not NULL, divisors that are no numbers are written there, at most so many */
    int divisors, most_divisors;
    int tells_poles; /* more than so many are poles that are left out; otherwise they are UNABLE        */
    cagd_num_f whole
        [CAGD_MOST_LETTERS]; /* variables of the field that stand for whole numbers, as n does in a proof for every n */
    int wholes;
    cagd_sums_met sums;
    int one_sided; /* a derivative was taken where the definitions end, from the side on which they fit */
} cagd_context;

/* What letters stand for inside a definition or a sum; all other names are the same everywhere. */
typedef struct cagd_frame {
    const char *head;
    cagd_value value;
    const struct cagd_frame *next;
} cagd_frame;

/* An argument that is an angle, of which sines and cosines have values: a tree and what its letters stand for, and, where it is moved by one
 * more, the x of that (angle.h), otherwise 0; and that one as a number, where it is asked for. */
struct cagd_angle {
    const cagd_tree *tree;
    const cagd_frame *frame;
    cagd_value tangent, moved;
};

enum { CAGD_USUAL_STEPS = 400000 };

/* The value; region_faults are set where there is none, and `trouble` says why.  The field is open. */
cagd_value cagd_evaluate(cagd_context *c, const cagd_tree *t);
cagd_value cagd_evaluate_in(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
/* The indices and arguments of the name t, which is defined by d and others; and the body that fits them, with the frame in which
 * it stands, whose nodes are room[]: NULL when none fits. */
void cagd_arguments_of(cagd_context *c, const cagd_tree *t, const cagd_definition *d, const cagd_frame *f,
                       cagd_value value[]);
const cagd_tree *cagd_body_of(cagd_context *c, const cagd_tree *t, const cagd_value value[], cagd_frame room[],
                              const cagd_frame **inner);
/* Whether relations hold: 1, 0; -1 and `split` or `trouble` where they depend on variables. */
int cagd_truth(cagd_context *c, const cagd_tree *t);
int cagd_truth_in(cagd_context *c, const cagd_tree *t, const cagd_frame *f);
/* Whether d is 0, on a way at its point, which is noted; whether a = b, on a way wherever the program takes it. */
int cagd_is_zero_here(cagd_context *c, cagd_value d);
int cagd_equal_here(cagd_context *c, cagd_value a, cagd_value b);
/* Whether a relation b, where the sign of a - b is this: -1, 0, 1. */
int cagd_relation_holds(int sign, cagd_relation relation);
/* a relation b for two values, likewise. */
int cagd_compare_values(cagd_context *c, cagd_value a, cagd_relation relation, cagd_value b);

/* Notes the first trouble, at that part of the formula; the value means nothing. */
cagd_value cagd_fail(cagd_context *c, const cagd_tree *t, unsigned fault, const char *why);
cagd_value cagd_divides_by_0(cagd_context *c, const cagd_tree *t);
/* "\omega_3^{2}": the name with the values of its indices; 0 where there is none. */
int cagd_key_of(cagd_context *c, const cagd_tree *t, const cagd_frame *f, char key[], int room);

/* The declaration of the name with its indices, and its key; NULL where there is none, or region_faults. */
const cagd_variable *cagd_declaration_of(cagd_context *c, const cagd_tree *t, const cagd_frame *f, char key[],
                                         int room);

/* Notes that the sum was met. */
void cagd_note_sum(cagd_sums_met *met, const cagd_tree *sum, int has_terms);

/* The binding of that name; a new one without a value if there is none yet.  NULL when there is no room. */
cagd_binding *cagd_bind(cagd_context *c, const char *key, cagd_value value);
cagd_binding *cagd_binding_of(cagd_context *c, const char *key);
/* The value of that name, which is declared by v or NULL: a variable of the field if it had none. */
cagd_value cagd_value_of_key(cagd_context *c, const char *key, const cagd_variable *v);
#endif
