/* read.h -- formulas as they are printed, read into trees.
 *
 * Juxtaposition is a product.  What stands at the top right of a name is an index where the name was defined or declared with
 * one, and otherwise a power; a name before a bracket is a function where it was defined with arguments, and otherwise a factor.
 * A name that nobody defined, declared or bound is refused, and so is what could be read in two ways: a/b c, x^12, f^{-1}(t). */
#ifndef CAGD_READ_H
#define CAGD_READ_H

#include "exact/expression/scope.h"

/* text[from..to) as a value; as relations, or several of them with commas between.  NULL and the error where it is none. */
const cagd_tree *cagd_read_value(const cagd_scope *scope, const char *text, int from, int to,
                                 cagd_reading_error *error);
const cagd_tree *cagd_read_statement(const cagd_scope *scope, const char *text, int from, int to,
                                     cagd_reading_error *error);

/* What is supposed behind a formula, with or without a word before it: ranges of letters that stand in it alone are its own, and those of whole numbers that are
 * known are left out.  NULL where nothing is left; an error only where one is noted. */
const cagd_tree *cagd_read_supposed(const cagd_scope *scope, const char *text, int from, int to,
                                    cagd_reading_error *error);
/* What is asked of a relation behind a formula and its ranges. */
#define CAGD_SAID_OR_SUPPOSED \
    "is this said as well, or supposed? write \\text{where} before what is supposed, and what is said as a statement of its own"

/* A line that says what a name means is added to the scope; 0 and the error where it does not:
 *
 *     B_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}       a definition
 *     N_i^k(t) = ..., \quad k \ge 2                 one with a condition
 *     \omega_i \in \mathbb{R},  -1 \le \lambda < 1  variables, and what they are
 *     0/0 = 0                                       the rule of Cox and de Boor */
int cagd_read_definition(cagd_scope *scope, const char *text, int from, int to, cagd_reading_error *error);
/* Whether two lines define a name together, \mathbf f_i and \mathbf{f}_j: of several definitions the first that fits is taken, so that they keep their order. */
int cagd_define_same(const cagd_scope *scope, const char *text, int from, int to, int other, int other_to);

/* The same of a line that declares variables that are no whole numbers, with bounds that are numbers or none: whether it is such a one. */
int cagd_read_declaration(cagd_scope *scope, const char *text, int from, int to);

/* For what a statement is said, its parts with commas between; added to the scope:
 *
 *     n = 1..12        i = 0, \dots, n        n = 1, 2, \dots       whole numbers
 *     0 \le t \le 1    x, y \in \mathbb{R}    t \in [0, 1)          other numbers
 *     x \ne y                                                       a condition of known names */
int cagd_read_ranges(cagd_scope *scope, const char *text, int from, int to, cagd_reading_error *error);
#endif
