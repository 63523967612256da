/* resident.h -- a process that runs the same code again and again, which is ten times as fast as a process for each run. */
#ifndef CAGD_CODE_RESIDENT_H
#define CAGD_CODE_RESIDENT_H

#include "exact/code/run.h"

struct cagd_code_resident;

/* As cagd_code_run, in rationals, with the present values of the job's inputs; program and job, but for these values, are the same in each
 * call with one resident, which is NULL at first.  A run knows nothing of those before it: the process is another one after a run that did not finish,
 * that put into a variable of static storage, or whose program asks for memory before it is called or calls a function of a library that is
 * not ours (these may remember), and after some thousand runs.  The outcome lives until the next call, and is not given back; NULL
 * without memory. */
struct cagd_code_outcome *cagd_code_run_again(struct cagd_code_resident **resident, const struct cagd_code_program *p,
                                              const struct cagd_code_job *job);
void cagd_code_dismiss(struct cagd_code_resident *resident); /* NULL: nothing */
#endif
