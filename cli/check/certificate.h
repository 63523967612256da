/* certificate.h -- what was found of a formula, as a certificate that recheck.py takes (cli/certify.h). */
#ifndef CAGD_CLI_CHECK_CERTIFICATE_H
#define CAGD_CLI_CHECK_CERTIFICATE_H

#include "cli/certify.h"
#include "cli/check/document.h"
#include "exact/expression/find.h"

/* The certificate of what was found, where there is one: its name in the region goes to *name, NULL otherwise.  0, or -1 and a line on
 * stderr where it cannot be written. */
int certify_formula(struct certifying *c, const struct document *d, const struct formula *s, const cagd_finding *f,
                    const char **name);
/* The same of the values of a parameter that were found. */
int certify_values(struct certifying *c, const struct formula *s, const cagd_found *f, const char **name);
#endif
