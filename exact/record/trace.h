/* trace.h -- a record of a computation with rationals and polynomials, from which others can do it again.
 *
 * While a trace is open in a thread, every operation is noted as a node: what was done, and to which earlier nodes.
 * So a value is known together with the straight-line program that made it, and the program can be run on other inputs.
 * The exact decisions (roots, signs, hulls, minors, ...) note themselves as facts: what was asked, about which nodes,
 * and what was answered; what they compute inside is not noted.
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

#include <gmp.h>
#include <stddef.h>

struct cagd_trace;
extern _Thread_local struct cagd_trace *cagd_tracing; /* NULL when no trace is open in this thread */

/* Open a trace that gives up, with the fault UNABLE, beyond `most` nodes.  One at a time in a thread. */
void cagd_trace_open(size_t most);
void cagd_trace_close(void); /* forgets everything */
void cagd_trace_again(void); /* the same as close and open, where a computation begins anew; nothing without a trace */

/* What was noted; the texts live until cagd_trace_close.  NULL when the trace gave up. */
const char *cagd_trace_inputs(void); /* [["w0","5/8"], ...]                                                 */
const char *cagd_trace_nodes(void);  /* the array of nodes                                                  */
const char *cagd_trace_steps(void);  /* the array of comparisons and facts in their order                   */

/* Between as many pauses and resumes nothing is noted: inside a decision.  Both do nothing without a trace. */
void cagd_trace_pause(void);
void cagd_trace_resume(void);

/* Whether what happens now is to be noted; the functions below are called only then, but for cagd_trace_fresh, which is called
 * whenever a trace is open. */
int cagd_trace_is_noting(void);
static inline int cagd_trace_noting(void) { return cagd_tracing != NULL && cagd_trace_is_noting(); }

/* ---- nodes: values are named by the slots that they live in --------------------------------------- */

void cagd_trace_fresh(const void *slot); /* the slot is about to get a value                 */
int cagd_trace_known(const void *slot);  /* its node, or -1                                  */
int cagd_trace_number(mpq_srcptr a);     /* its node; an "o" if there was none               */
void cagd_trace_node(const void *slot, const char *op, int count, const int argument[]);
void cagd_trace_literal(const void *slot, const char *op, int count, mpq_srcptr (*get)(const void *list, int k),
                        const void *list);
void cagd_trace_alias(const void *slot, int node); /* the slot holds the value of that node            */
void cagd_trace_text(const void *slot, const char *op, const char *text);
void cagd_trace_input(mpq_srcptr r, const char *name, int index); /* index < 0: none                           */
void cagd_trace_variable(const void *slot, const char *name);     /* an input, the same one for the same name      */

/* ---- steps ------------------------------------------------------------------------------------------ */

/* {"same":[i,j],"equal":true}, {"agree":true}, {"nonnegative":i,"good":true}; the last of a rational function with a text of it
 * whose coefficients were looked at: {"nonnegative":i,"good":true,"text":"(a + b)/c","sign":1}. */
void cagd_trace_same(int i, int j, int equal);
void cagd_trace_agree(int condition);
void cagd_trace_nonnegative(int i, int good, const char *text, int sign); /* text may be NULL */
/* {"fact":"order","of":[i,j],"is":-1}, {"fact":"equal","of":[i,j],"is":0}; b NULL, j = -1: against 0.
 * {"fact":"degrees","of":[i,j],"is":[3,1]}: of numerator and denominator of i, in lowest terms, in the input j.
 * {"fact":"whole","of":[i,-1],"is":1}: whether number i is an integer. */
void cagd_trace_order(mpq_srcptr a, mpq_srcptr b, int order);
void cagd_trace_equal(mpq_srcptr a, mpq_srcptr b, int equal);
void cagd_trace_relation(const char *kind, int i, int j, int is); /* the same by nodes; j = -1: 0 */

/* A fact of another kind: opened, its fields put one by one, closed.  cagd_trace_fact returns 0, and then the rest is left
 * out, when nothing is to be noted.  Nodes that fields name must exist before it is opened. */
int cagd_trace_fact(const char *kind);
void cagd_trace_put(const char *field, int x);
void cagd_trace_put_list(const char *field, int count, const int x[]);
void cagd_trace_fact_end(void);
#endif
