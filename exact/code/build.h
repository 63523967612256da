/* build.h -- the sources of a harness and its driver, compiled and rewritten. */
#ifndef CAGD_CODE_BUILD_H
#define CAGD_CODE_BUILD_H

#include "exact/code/harness.h"
#include "exact/code/run.h"

/* The program of the harness in the file `path`, made by the program `compiler` (cagd-compile-exactly); clang's messages go to
 * standard error.  NULL, and what is wrong. */
struct cagd_code_program *cagd_code_build(const struct cagd_code_harness *h, const char *path, const char *compiler,
                                          size_t room, char message[]);

/* Removes what a build has made, for a program that ends before the build does: allowed in a handler of a signal. */
void cagd_code_build_forget(void);
#endif
