/* process.h -- the process in which code runs, from inside; only for run.c and resident.c. */
#ifndef CAGD_CODE_PROCESS_H
#define CAGD_CODE_PROCESS_H

#include "exact/code/run.h"

/* The job with its bounds written out; the memory that parent and child share, an outcome that says that the process ended, and how much
 * of it there is. */
struct cagd_code_job cagd_code_bounded(const struct cagd_code_job *job);
struct cagd_code_outcome *cagd_code_shared_room(size_t *bytes);
void cagd_code_outcome_begin(struct cagd_code_outcome *o);

/* In the child: what is told goes into the outcome and the room behind it, up to `bytes` bytes of both. */
void cagd_code_tell_into(struct cagd_code_outcome *o, size_t bytes, const struct cagd_code_job *job);
/* The process has its bounds, the code is there, and its constructors have run.  Returns what the job names; does not return where that
 * fails. */
void (*cagd_code_begin(const struct cagd_code_program *p, const struct cagd_code_job *job))(void);
/* From now on the process is ended when it waits for long. */
void cagd_code_bound_waiting(const struct cagd_code_job *job);
/* The code has returned: what it left behind is looked at, and the outcome is finished. */
void cagd_code_finish(const struct cagd_code_job *job);
#endif
