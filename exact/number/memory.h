/* memory.h -- where there is no memory. */
#ifndef CAGD_MEMORY_H
#define CAGD_MEMORY_H

/* Calls what cagd_without_memory named; returns where nothing is named. */
void cagd_memory_is_refused(void);
/* The same for a number, without which nothing goes on: abort() with a line on stderr where nothing is named. */
_Noreturn void cagd_no_memory(void);
#endif
