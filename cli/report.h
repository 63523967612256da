/* report.h -- results as JSON, JUnit, and files of the ledger. */
#ifndef CAGD_REPORT_H
#define CAGD_REPORT_H

#include "chapters/judge/register.h"
#include "chapters/judge/run.h"

#include <jansson.h>

json_t *claim_json(const claim_result *r);
json_t *statement_json(const statement_result *r, const claim_result *results, int count);
/* All forms of the ledger as files in the folder, from a run over all claims: ledger.txt the rows, summary.txt the counts,
 * striking.txt the three most striking counterexamples, ledger.json.  How many statements are not as expected, or -1 and
 * a line on stderr when a file cannot be written. */
int write_report(const cagd_register *r, const char *folder, const claim_result *results, int claims);
int write_junit(const char *path, const claim_result *results, int count);
void print_json(json_t *document);         /* prints and releases; reals are times, of 6 digits           */
void print_json_exactly(json_t *document); /* the same; reals are results, of 17 digits                  */

/* The counterexample, or whatever the claim shows, in one line: "n = 2; w = 1, 2, 1; ...". */
char *exhibits_line(const claim_result *r);
const type_result *speaking_type(const claim_result *r); /* whose exhibits speak for the claim      */

/* Counts of verdicts by source key. */
struct tally {
    char source[32];
    int verdict[6];
    int total;
};
int tally_statements(const statement_result *list, int count, struct tally tally[], int room);
#endif
