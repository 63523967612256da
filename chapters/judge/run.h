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
    char *variables;             /* field: the named variables of all cases, separated by blanks            */
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
    evidence computed; /* the strongest that its types support                                    */
    evidence evidence; /* the same, BY_ARGUMENT where words are needed to get from there to the claim */
    char *scope;       /* for which degrees and data, in words; made from what was run: see scope.h */
    exhibit *witness;  /* of an identity or decision that fails: a small instance; see witness.h */
    int witnesses;     /* how many values that are                                                */
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
    VERDICT_DEFINITION,
    VERDICTS
} verdict;
extern const char *const verdict_name[];

/* What claims together decided. */
typedef struct finding {
    evidence evidence; /* the weakest that is needed; BY_ARGUMENT where words or a cited theorem are needed     */
    char *scope;       /* what the scopes of all claims that are needed have in common, in words; see scope.h   */
    char *argued_for;  /* the cases that arguments in words add, or empty                                       */
} finding;

typedef struct statement_result {
    const statement *statement;
    verdict verdict;
    finding as_printed;
    finding as_corrected;           /* NO_EVIDENCE where nothing was corrected                   */
    const claim_result *refuted_by; /* whose exhibit speaks for a statement that fails, or NULL  */
    int as_expected;                /* every claim it names did what its role asks               */
} statement_result;

/* The caller owns what is in the result: free_statement_result. */
statement_result derive(const statement *s, const claim_result *results, int count);
void free_statement_result(statement_result *r);
/* What one claim decided, as one step of several or as a reading, in the letter of the source; NULL: n.  The caller owns what
 * is in it: free_finding. */
finding finding_of(const claim_result *c, const char *letter);
/* The same of a reading, by its claim and those behind it that decide it, too. */
finding finding_of_reading(const statement *s, const statement_link *reading, const claim_result *results, int count);
void free_finding(finding *f);
/* "proved for n = 1 to 6; argued for every n", "argued for every n; computed for n = 1 to 6": in words; "" without evidence.
 * The caller frees. */
char *finding_words(const finding *f);
const claim_result *result_of(const char *claim_name, const claim_result *results, int count);
#endif
