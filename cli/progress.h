/* progress.h -- how far a long computation is, on a terminal. */
#ifndef CAGD_PROGRESS_H
#define CAGD_PROGRESS_H

#include "chapters/judge/run.h"

/* Judges claims, with a bar on standard error if that is a terminal.  The caller owns the results. */
claim_result *judge_with_progress(const claim *const list[], int count, int jobs, int deep);

/* Clears the line of a terminal on which progress was shown. */
void end_progress(void);
#endif
