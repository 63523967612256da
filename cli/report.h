/* report.h -- results as JSON, JUnit, and files of the ledger. */
#ifndef CAGD_REPORT_H
#define CAGD_REPORT_H

#include "chapters/judge/register.h"
#include "chapters/judge/run.h"

#include <jansson.h>

/* One claim, one statement, as the documents of the schemas cagd-claim-1, cagd-statement-1 and those of lists have them; `results`
 * are those of all claims that the statement names.  The caller owns the document. */
json_t *claim_json(const claim_result *r);
json_t *statement_json(const statement_result *r, const claim_result *results, int count);

/* Print the document and release it; reals are times, of 6 digits, or results, of 17. */
void print_json(json_t *document);
void print_json_exactly(json_t *document);

/* All forms of the ledger as files in the folder, from a run over all claims: ledger.txt the rows, summary.txt the counts,
 * striking.txt the three most striking counterexamples, ledger.json.  How many statements are not as expected, or -1 and
 * a line on stderr when a file cannot be written. */
int write_report(const cagd_register *r, const char *folder, const claim_result *results, int claims);
int promise_report(const char *folder); /* that these files can be written there, as output_promise does */
/* 0, or -1 and a line on stderr. */
int write_junit(const char *path, const claim_result *results, int count);

/* The type whose exhibits speak for the claim: the first that failed, or else the first that ran; NULL when none did. */
const type_result *speaking_type(const claim_result *r);
/* Named values in one line: "n = 2; w = 1, 2, 1".  The caller frees it. */
char *line_of_exhibits(const exhibit *shown, int count);
/* The counterexample, or whatever the claim shows, in one line: "n = 2; w = 1, 2, 1; ...".  The caller frees it. */
char *exhibits_line(const claim_result *r);
/* What a claim is whose result is not as expected, with the number types whose control was not caught.  The caller frees. */
char *not_expected(const claim_result *r);
#endif
