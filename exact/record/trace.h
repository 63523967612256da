/* trace.h -- a record of a computation with rationals and polynomials, from which others can do it again.
 *
 * While a trace is open in a thread, it listens to the arithmetic (exact/number/recorder.h), and every operation becomes a node:
 * what was done, and to which earlier nodes.  So a value is known together with the straight-line program that made it, and the
 * program can be run on other inputs.  The predicates that testify (the other headers of this folder) note facts: what was
 * asked, about which nodes, and what was answered; what is computed to answer is not noted.
 *
 * Texts are JSON.  Nodes, i and j being earlier ones:
 * Rational functions are nodes as numbers are; their variables are inputs with arbitrary values, and
 *     ["f","(a + b)/c"]  a rational function whose making was not noted, in the names of the inputs.
 *
 *     ["x",k]  input k          ["c","3/7"]  a constant          ["o","3/7"]  a number whose making was not noted
 *     ["+",i,j] ["-",i,j] ["*",i,j] ["/",i,j]    ["neg",i]    ["root",i,n] the n-th root
 *     ["cagd_poly",i,...] sum of coefficients i t^k   ["bernstein",i,...] in the Bernstein basis   ["opoly","3/7",...] not noted
 *     ["p+",i,j] ["p-",i,j] ["p*",i,j] ["pgcd",i,j] ["pquo",i,j] ["prem",i,j] ["pcompose",i,j] ["pneg",i] ["pder",i]
 *     ["value",i,j] polynomial i at number j     ["coefficient",i,k] of t^k
 *     ["tobernstein",i,a,b,n,k] the k-th of n+1 Bernstein coefficients of polynomial i over [a,b] */
#ifndef CAGD_TRACE_H
#define CAGD_TRACE_H

#include "exact/number/recorder.h"

/* Open a trace that gives up, with the fault UNABLE, beyond `most` nodes.  One at a time in a thread.  Without memory the fault
 * is MEMORY, and nothing is opened, or the trace gives up. */
void cagd_trace_open(size_t most);
void cagd_trace_close(void); /* forgets everything; nothing without a trace                                     */
void cagd_trace_again(void); /* the same as close and open, where a computation begins anew; nothing without a trace */

/* What was noted; the texts live until cagd_trace_close.  NULL without a trace, and when it gave up. */
const char *cagd_trace_inputs(void); /* [["w0","5/8"], ...]                                                 */
const char *cagd_trace_nodes(void);  /* the array of nodes                                                  */
const char *cagd_trace_steps(void);  /* the array of comparisons and facts in their order                   */

/* Between as many pauses and resumes nothing is noted: inside a decision.  Both do nothing without a trace. */
void cagd_trace_pause(void);
void cagd_trace_resume(void);

/* Whether what happens now is to be noted; the functions below are called only then. */
int cagd_trace_noting(void);

/* Variables of the field become inputs with the values that this function has for their names; any value where it has none. */
void cagd_trace_values(cagd_num_q (*value_of)(const char *name));

/* The number becomes an input of that name; index < 0: none. */
void cagd_trace_input(cagd_num_q a, const char *name, int index);

/* ---- steps ------------------------------------------------------------------------------------------ */

/* {"same":[i,j],"equal":true}, {"agree":true}, {"nonnegative":i,"good":true}; the last of a rational function with a text of it
 * whose coefficients were looked at: {"nonnegative":i,"good":true,"text":"(a + b)/c","sign":1}.  Where facts were noted since the
 * step before, a condition has its formula in C beside it: {"agree":true,"formula":"sign_q(x) > 0 && !is_zero_q(y)"}. */
void cagd_trace_same(int i, int j, int equal);
void cagd_trace_agree(int condition, const char *formula);                /* formula may be NULL */
void cagd_trace_nonnegative(int i, int good, const char *text, int sign); /* text may be NULL */
/* {"fact":kind,"of":[i,j],"is":1}; j = -1: of i alone, or against 0.
 * "order": the sign of i - j.  "equal", "pequal": i = j, numbers, polynomials.  "degree": of the polynomial i.  "whole": whether i
 * is an integer. */
void cagd_trace_relation(const char *kind, int i, int j, int is);

/* A fact of another kind: opened, its fields put one by one, closed.  cagd_trace_fact returns 0, and then the rest is left
 * out, when nothing is to be noted. */
int cagd_trace_fact(const char *kind);
void cagd_trace_put(const char *field, int x);
void cagd_trace_put_list(const char *field, int count, const int x[]);
void cagd_trace_fact_end(void);

/* The nodes of the numbers, which get some where they have none, are a field of the fact that is open.  x may be NULL where there
 * are no numbers; where there are some, NULL is an array for which there was no memory, and the trace gives up. */
void cagd_trace_put_numbers(const char *field, int count, const cagd_num_q x[]);
#endif
