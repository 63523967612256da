/* manifest.h -- what the certificates of a run certify (清单): every statement with its printed text and its claims, and what
 * the certificate of every claim must have.  recheck.py takes no certificate that is not listed, or has less. */
#ifndef CAGD_MANIFEST_H
#define CAGD_MANIFEST_H

#include "chapters/judge/certificate.h"
#include "chapters/judge/register.h"
#include "cli/digest.h"

/* The cases in the certificate of one claim, and the digest of the file. */
struct recorded {
    char digest[DIGEST];
    int count;
    struct recorded_case cases[MOST_RECORDED];
};

/* DIR/manifest.json, of the claims that ran and the statements that they decide.  0, or -1 and a line on stderr. */
int write_manifest(const cagd_register *r, const char *folder, const claim_result *results, int count,
                   const struct recorded *recorded);
#endif
