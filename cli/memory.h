/* memory.h -- how the program ends where it cannot go on: with one line on standard error, no half of a file, and EXIT_INTERNAL. */
#ifndef CAGD_CLI_MEMORY_H
#define CAGD_CLI_MEMORY_H

/* Before anything else: what GMP, MPFR, FLINT, jansson and this program do where memory is refused, and what abort() does,
 * which the library of C++ and assertions call. */
void memory_begin(void);

/* There is not enough memory. */
_Noreturn void no_memory(void);

/* What else to clear away then; it does nothing that is not allowed in a handler of a signal. */
void also_forget(void (*what)(void));
#endif
