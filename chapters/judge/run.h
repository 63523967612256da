/* run.h -- judging claims, and deriving the verdicts of statements from the claims that decide them. */
#ifndef CAGD_RUN_H
#define CAGD_RUN_H

#include "chapters/judge/claim.h"

/* One claim in one number type. */
typedef struct type_result {
    int ran;                     /* 0 where the claim has no body in this type                              */
    outcome outcome;             /* of the statement                                                        */
    unsigned faults;             /* of the region, over all cases                                           */
    int cases, compared;         /* how much was really tested                                              */
    int degree_low, degree_high; /* degrees visited; 0 without degrees                                */
    double worst;                /* see trial.worst                                                         */
    uint64_t seed;               /* of the first failing case                                               */
    int control_caught;          /* the control had the opposite outcome                                    */
    char *variables;             /* field: the named variables of the largest case, separated by blanks     */
    char *positive;              /* field: those of them that were taken to be positive; see trial.positive */
    exhibit *shown;              /* of the first failing case, or of the first case                         */
    int exhibits;
    double seconds;
} type_result;

typedef struct claim_result {
    const claim *claim;
    type_result by[NUMBER_TYPES];
    int as_expected;   /* the outcome is the expected one in every type, and every control caught */
    outcome outcome;   /* what the claim establishes                                              */
    evidence evidence; /* the strongest that its types support                                    */
    char *scope;       /* for which degrees and variables, in words; made from what was run       */
} claim_result;

typedef struct run_options {
    int jobs; /* threads, at least 1                                                             */
    int deep; /* many more random cases                                                          */
    void (*progress)(void *context, int done, int total, const char *name); /* may be NULL; called
                                                                                under a lock       */
    void *context;
} run_options;

/* Judge `count` claims.  The caller owns the results: free_results(results, count). */
claim_result *judge_claims(const claim *const list[], int count, const run_options *options);
void free_results(claim_result *results, int count);
/* What the claim's being as expected in a number type is evidence of. */
evidence evidence_of(const claim *c, number_type t);

/* The verdict of a statement, derived from the results of its claims; never typed in by hand. */
typedef enum verdict {
    VERDICT_HOLDS,
    VERDICT_CONDITIONAL,
    VERDICT_FAILS,
    VERDICT_UNDECIDED,
    VERDICT_OPEN,
    VERDICT_DEFINITION
} verdict;
extern const char *const verdict_name[];

typedef struct statement_result {
    const statement *statement;
    verdict verdict;
    evidence evidence;              /* the weakest among the claims that decide it               */
    const claim_result *decided_by; /* the claim whose scope and exhibit speak for the verdict   */
    int corrected;                  /* 1 when a corrected statement was decided                  */
    evidence corrected_evidence;
    const claim_result *corrected_by;
    int as_expected; /* every claim it names did what its role asks               */
} statement_result;

statement_result derive(const statement *s, const claim_result *results, int count);
const claim_result *result_of(const char *claim_name, const claim_result *results, int count);
#endif
