/* certify.h -- what `cagd exactly` proves, as certificates that recheck.py takes. */
#ifndef CLI_CERTIFY_H
#define CLI_CERTIFY_H

#include "exact/code/decide.h"

#include <jansson.h>

/* The statements and claims of a folder, while they are written. */
struct certifying {
    const char *folder;
    json_t *claims, *statements;
};

/* The folder is made.  0, or -1 and a line on stderr; so everywhere here. */
int certify_begin(struct certifying *c, const char *folder);

/* A proved block: claims/NAME.json has a case for each way through the code, the straight-line program that the way is, with what it
 * compared, at its point; exactly/NAME.json says that the claim decides it.  Others are left out. */
int certify_block(struct certifying *c, const struct cagd_code_program *p, const struct cagd_code_harness *h,
                  const struct cagd_code_verdict *v);

/* manifest.json, and the end. */
int certify_end(struct certifying *c);
#endif
