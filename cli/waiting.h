/* waiting.h -- that a long computation goes on, on a terminal. */
#ifndef CAGD_WAITING_H
#define CAGD_WAITING_H

/* From two seconds on standard error, if it is a terminal, says every second what is computed and for how long, until
 * waiting_end clears the line.  `what` lives that long. */
void waiting_begin(const char *what);
void waiting_end(void);
/* So many of `total` things are done. */
void waiting_at(int done, int total, const char *things);
#endif
