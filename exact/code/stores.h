/* stores.h -- the numbers that lines of the code put into variables, in their order; only for exact/code. */
#ifndef CAGD_CODE_STORES_H
#define CAGD_CODE_STORES_H

/* At the end of a run whose stores were noted: of the calls and of what is expected, the first number that a variable of the same
 * name does not get in both, to the outcome (run.h: apart). */
void cagd_code_tell_apart(void);
#endif
