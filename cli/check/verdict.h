/* verdict.h -- what was found out about a formula, in words, on a page, and as JSON. */
#ifndef CAGD_CLI_CHECK_VERDICT_H
#define CAGD_CLI_CHECK_VERDICT_H

#include "cli/check/document.h"
#include "exact/expression/find.h"

#include <jansson.h>

/* "holds", "fails", "undecided"; "proved", "decided", "none". */
const char *verdict_of(const cagd_finding *f);
const char *evidence_of_finding(const cagd_finding *f);
/* For which numbers, in TeX: "n = 1..12, all t"; in the region. */
const char *scope_of_finding(const struct document *d, const struct formula *s, const cagd_finding *f);
/* Why it is not decided, in words; in the region. */
const char *reason_of(const struct document *d, const cagd_finding *f);

/* Of an example, in TeX: "1/2", or the first digits of a root; in the region. */
const char *value_text(const cagd_given *g);

/* For which values of the parameter it holds, in TeX: "$-7 \le \beta \le 1$"; in the region. */
/* A number that is an end: as it is, or the first digits of a root. */
const char *end_text(const struct cagd_root *r);
const char *values_of(const struct formula *s, const cagd_found *f);
/* For which numbers it breaks first in cell k: "$\beta = -8$, $i = 1$, $t = 1/65$"; in the region. */
const char *breaking_text(const struct formula *s, const cagd_found *f, int k);
void print_found_page(const struct document *d, const struct formula *s, const cagd_found *f);
json_t *found_json(const struct formula *s, const cagd_found *f);

void print_finding_page(const struct document *d, const struct formula *s, const cagd_finding *f);
json_t *finding_json(const struct document *d, const struct formula *s, const cagd_finding *f);
#endif
