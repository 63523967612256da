/* driver.h -- the driver of a harness: the C, or C++, that reads the inputs, makes the calls and hands over the results. */
#ifndef CAGD_CODE_DRIVER_H
#define CAGD_CODE_DRIVER_H

#include "exact/code/harness.h"

/* `path` names the file of the harness in clang's messages. */
void cagd_code_write_driver(const struct cagd_code_harness *h, const char *path, FILE *out);
int cagd_code_is_cpp(const struct cagd_code_harness *h);
#endif
