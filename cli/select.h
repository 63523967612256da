/* select.h -- which claims, statements and figures are meant by patterns and ids. */
#ifndef CAGD_SELECT_H
#define CAGD_SELECT_H

#include "chapters/judge/run.h"

/* Patterns are shell globs.  One matches a claim by its name, by chapter.name, or by the id of a
 * statement that the claim decides; no pattern matches all. */
struct patterns {
    char **at;
    int count;
};
int claim_matches(const claim *c, const struct patterns *p);
int statement_matches(const statement *s, const struct patterns *p);
/* The claims that match; with a statement, all claims it names.  The caller frees. */
const claim **matching_claims(const struct patterns *p, int *count);
const statement **matching_statements(const struct patterns *p, int *count);
const claim **claims_of(const statement *const list[], int statements, int *count);
/* What a pattern or an id may name. */
enum kind_of_name { STATEMENTS_AND_CLAIMS, FIGURES };
/* One line on stderr: nothing of this kind is called so, and the names nearest to it. */
void complain_about(const char *id, enum kind_of_name kind);
/* Whether every pattern matches something; a line on stderr about the first that does not. */
int all_match_claims(const struct patterns *p);
int all_match_statements(const struct patterns *p);
#endif
