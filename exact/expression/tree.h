/* tree.h -- a formula as a tree.  Trees live in the region, with numbers that are rationals. */
#ifndef CAGD_TREE_H
#define CAGD_TREE_H

#include "exact/expression/reading.h"

enum { CAGD_MOST_CHILDREN = 64, CAGD_MOST_ROWS = 8, CAGD_MATRIX = 16, CAGD_MOST_DEPTH = 200, CAGD_MOST_INDICES = 4 };

/* In brackets: what the children are. */
typedef enum cagd_tree_kind {
    CAGD_NUMBER, /* `number`                                                                                   */
    CAGD_NAME, /* head with [lower indices, upper indices, arguments], derived `order` times by its first argument, or as
                       often as `times` says */
    CAGD_SUM,  /* [a, b, ...] */
    CAGD_PRODUCT,     /* [a, b, ...] */
    CAGD_NEGATIVE,    /* [a] */
    CAGD_QUOTIENT,    /* [a, b] */
    CAGD_POWER,       /* [a, b] */
    CAGD_FACTORIAL,   /* [a] */
    CAGD_BINOMIAL,    /* [a, b] */
    CAGD_Q_NUMBER,    /* [n, q]: 1 + q + ... + q^(n-1)                                                              */
    CAGD_Q_FACTORIAL, /* [n, q]: the product of those of 1 to n                                                     */
    CAGD_Q_BINOMIAL,  /* [n, k, q]: the Gaussian binomial coefficient                                               */
    CAGD_ROOT,        /* [a, n] */
    CAGD_ABSOLUTE,    /* [a] */
    CAGD_FLOOR,       /* [a] */
    CAGD_CEILING,     /* [a] */
    CAGD_MAXIMUM,     /* [a, b, ...] */
    CAGD_MINIMUM,     /* [a, b, ...] */
    CAGD_SUM_OVER,    /* [low, high, body, conditions ...] over the index `head`                                    */
    CAGD_PRODUCT_OVER,
    CAGD_MAXIMUM_OVER,
    CAGD_MINIMUM_OVER,
    CAGD_DERIVATIVE, /* [a, k]: k times by the variable `head`; [a, k, name]: by that name, with an index; partial: order 1 */
    CAGD_INTEGRAL,       /* [low, high, a] by the variable `head`                                                     */
    CAGD_AT,             /* [a, b]: a with b in the place of the variable `head`                                      */
    CAGD_POINT,          /* [x, y, ...]: a vector by its components, a matrix by its rows, one behind the other       */
    CAGD_COMPONENT,      /* [a]: component number `order` of a vector, from 0                                         */
    CAGD_DOT,            /* [a, b] */
    CAGD_CROSS,          /* [a, b], of space */
    CAGD_MIXED,          /* [a, b, c]: (a, b, c) = (a x b) . c */
    CAGD_NORM,           /* [a]: the length of a vector                                                               */
    CAGD_MATRIX_PRODUCT, /* [a, b]: `order` terms for each entry                                              */
    CAGD_TRANSPOSED,     /* [a] */
    CAGD_INVERSE,        /* [a] */
    CAGD_DETERMINANT,    /* [a_11, a_12, ...]: of `order` rows, one behind the other                                  */
    CAGD_COSINE,         /* [a]: of an angle, a sum of names and of halves of names                                  */
    CAGD_SINE,
    CAGD_CASES,       /* [a, condition, b, condition, ...]; the last condition may be missing: otherwise            */
    CAGD_RELATION,    /* [a, b, ...]: a relation[0] b relation[1] c ...; a truth, no value                         */
    CAGD_ALL,         /* [conditions ...]: each of them                                                            */
    CAGD_EVERY_INDEX, /* [condition]: for every value of the letter `head` in indices                           */
    CAGD_ANY,         /* [conditions ...]: one of them at least                                                 */
    CAGD_NOT,         /* [a] */
    CAGD_IMPLIES,     /* [a, b] */
    CAGD_IFF,         /* [a, b] */
    CAGD_FOR_ALL,     /* [low, high, a]: for all whole numbers `head` from low to high                          */
    CAGD_EXISTS       /* likewise, for one at least                                                             */
} cagd_tree_kind;

typedef enum cagd_relation {
    CAGD_EQUAL,
    CAGD_NOT_EQUAL,
    CAGD_LESS,
    CAGD_LESS_OR_EQUAL,
    CAGD_GREATER,
    CAGD_GREATER_OR_EQUAL
} cagd_relation;

typedef struct cagd_tree {
    cagd_tree_kind kind;
    int from, to; /* the bytes of the text that it was read from */
    cagd_num_q number;
    const char *head; /* "t", "\\hat{B}_" of a name with lower indices: t and t_i are different names */
    int lower, upper, arguments, order;
    int before_semicolon; /* of a name: so many of its arguments; the others are parameters, which may be left out */
    int dimension;        /* of a vector; rows + CAGD_MATRIX columns of a matrix; 0 of a number or a truth */
    const struct cagd_tree *times;
    int juxtaposed; /* of a product: its factors stand side by side, as in P_{ij}; of matrices: their rows are points; of
                       CAGD_ALL: the conditions stand side by side with \land between, and all are said */
    unsigned long long
        asked; /* of CAGD_ALL: the conditions, by their places, that stand behind "and", a semicolon or the break of a row: whether they are
                                 said or supposed is asked for, where it matters */
    int count;
    const struct cagd_tree **at;
    const cagd_relation *relation;
} cagd_tree;

/* What a dimension says.  A matrix has at least two columns; a vector is a column, and counts as a matrix of one. */
static inline int cagd_is_matrix(int dimension) { return dimension > CAGD_MATRIX; }
static inline int cagd_rows(int dimension) { return dimension % CAGD_MATRIX; }
static inline int cagd_columns(int dimension) { return dimension > CAGD_MATRIX ? dimension / CAGD_MATRIX : 1; }
static inline int cagd_components(int dimension) { return cagd_rows(dimension) * cagd_columns(dimension); }

/* A tree with room for so many children, the others fields 0; NULL when there is no memory. */
cagd_tree *cagd_tree_new(cagd_tree_kind kind, int from, int to, int count);
cagd_tree *cagd_tree_number(long value, int from, int to);

/* Whether the name occurs in the tree as it stands; and whether the trees are the same, wherever they were read. */
int cagd_tree_has(const cagd_tree *t, const char *head);
int cagd_tree_equal(const cagd_tree *a, const cagd_tree *b);

/* The tree with another one in the place of that letter; NULL for NULL. */
const cagd_tree *cagd_tree_with(const cagd_tree *t, const char *letter, const cagd_tree *other);

/* On the left of a definition: the child before the k-th one that is the same letter, b_{n,n}; -1 where there is none. */
int cagd_same_index(const cagd_tree *left, int k);
#endif
