/* formula.h -- what results should be, as it is printed: formulas in the language of `cagd check` (exact/expression).
 *
 * The inputs and outputs of a harness are names in them: p[4] is p_0, ..., p_3, and t is t; lambda is \lambda, and any other name of
 * several letters stands upright, \mathrm{knot}_2. */
#ifndef CAGD_CODE_FORMULA_H
#define CAGD_CODE_FORMULA_H

#include "exact/expression/scope.h"

enum { CAGD_CODE_MESSAGE = 400 };

/* What formulas are read with.  All is in the region. */
struct cagd_code_formulas {
    cagd_scope scope;
    char message[CAGD_CODE_MESSAGE]; /* of what is refused */
};

/* What stands for a name of the harness, "p_" or "t", in the region; NULL where it has not letters alone. */
const char *cagd_code_formula_head(const char *name, long count);
/* A name of the harness becomes known, count = 0: a number alone.  One that has no letters alone stays unknown. */
void cagd_code_formula_name(struct cagd_code_formulas *f, const char *name, long count);
/* A line that says what other names mean: "B_i^n(t) = ...", or ":use: bernstein B_i^n(t)".  0, or -1 and the message. */
int cagd_code_formula_let(struct cagd_code_formulas *f, const char *line);
/* Equations, with the ranges of their whole numbers, which are added: CAGD_RELATION, or CAGD_ALL of them.  NULL and the message, also
 * where both sides are the same formula. */
const cagd_tree *cagd_code_formula_read(struct cagd_code_formulas *f, const char *formula, const char *ranges);
/* Whether that name of the harness is in the formula, or in what names in it mean. */
int cagd_code_formula_has(const struct cagd_code_formulas *f, const cagd_tree *t, const char *name, long count);
#endif
