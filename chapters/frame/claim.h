/* claim.h -- what a claim is, what a statement of a source is, and what running them gives.
 *
 * A claim (断言) is a statement together with a computation that would expose it if it were false.
 * A statement (命题) is one entry of the ledger: something a source prints, and the claims that decide
 * it.  Both are written as blocks in the comments of the chapter files and collected by weave; the
 * bodies of the claims are generic text, so that one body is judged in several arithmetics:
 *
 *   field     rational functions in named variables   an equality is proved, for all values at once
 *   rational  GMP                                     exact at sampled instances; finite decisions
 *   interval  MPFR                                    can refute an equality, never confirm it
 *   double    binary64 with a running error bound     measured
 */
#ifndef CAGD_CLAIM_H
#define CAGD_CLAIM_H

#include <stdint.h>

typedef enum number_type { FIELD_TYPE, RATIONAL_TYPE, INTERVAL_TYPE, DOUBLE_TYPE, NUMBER_TYPES } number_type;
extern const char *const number_type_name[NUMBER_TYPES];

typedef enum outcome { HOLDS, FAILS, UNDECIDED } outcome;
extern const char *const outcome_name[];

/* By increasing strength. */
typedef enum evidence { NO_EVIDENCE, MEASURED, ENCLOSED, SAMPLED, DECIDED, PROVED } evidence;
extern const char *const evidence_name[];

typedef enum claim_kind {
    IDENTITY,      /* compared at every case; the evidence is the number type's                     */
    DECISION,      /* a finite exact decision that settles the stated case or range                  */
    COUNTEREXAMPLE /* the printed statement, computed at one exact instance, where it must fail      */
} claim_kind;

/* One named value that a claim shows: the data of a counterexample, the two sides of an equality. */
typedef struct exhibit {
    char *name, *value;
} exhibit;

/* One case of one claim in one number type. */
typedef struct trial {
    uint64_t seed, state; /* the seed of this case, printed when it fails; the generator's state     */
    int degree;           /* n of this case; 0 for a claim without degrees                           */
    int planted;          /* 1 in the control: the fault the block names is in                       */
    int deep;             /* 1 when asked for more than the default depth                            */
    int compared;         /* values compared so far; a claim that compared nothing fails             */
    const char *positive; /* field: the variables taken to be positive where a sign was read off the
                              coefficients, separated by blanks; NULL for none                        */
    outcome outcome;      /* FAILS as soon as one comparison does                                    */
    double worst;         /* double: largest error/bound; interval: widest enclosure of a difference */
    const char *about;    /* what is being compared, for the first difference                        */
    exhibit *shown;       /* what the case shows, `exhibits` in number                                */
    int exhibits;
} trial;

typedef struct claim {
    const char *name, *title, *title_zh, *given, *let, *then, *method, *control, *scope;
    const char *defines; /* the kernels whose definitional claim this is: its other side shares no code with them */
    const char *chapter, *file;
    int line;
    claim_kind kind;
    int degree_low, degree_high;          /* the degrees that the field visits; both 0 without degrees           */
    int degree_sampled;                   /* the largest degree sampled; at least degree_high                     */
    int all_degrees;                      /* 1 when n itself is a variable of the field                           */
    void (*body[NUMBER_TYPES])(trial *T); /* NULL where the claim is not run                             */
} claim;

typedef enum role {
    HOLDS_BY,     /* the claim decides that what is printed is true (under the hypotheses, if any)    */
    REFUTED_BY,   /* the claim exhibits a case where what is printed is false                          */
    CORRECTED_BY, /* the claim decides the corrected statement                                         */
    HYPOTHESIS,   /* text: a hypothesis to be added; claim: what goes wrong without it                 */
    NEEDS,        /* text: a hypothesis that the source states; claim: what goes wrong without it     */
    READING,      /* text: one way to read the print; claim: what decides that reading                 */
    CHECKED_BY    /* definitions: what is checked about them                                           */
} role;

typedef struct statement_link {
    role role;
    const char *claim, *text;
} statement_link;

typedef struct statement {
    const char *id, *title, *title_zh, *printed, *class, *corrected, *figure, *note;
    const char *chapter, *file;
    int line, is_definition, striking; /* striking: rank among the counterexamples worth telling first, or 0 */
    const statement_link *links;       /* ends with a link whose claim and text are NULL                       */
} statement;

typedef struct chapter {
    const char *name, *title;
} chapter;

/* The register, written by weave from the blocks; each array ends with an entry of NULL names. */
extern const claim all_claims[];
extern const statement all_statements[];
extern const chapter all_chapters[];

/* One body for every number type it is compiled in; T is the trial. */
/* clang-format off */
#define CLAIM(name)                                                                                                    \
    void G(claim_##name)(trial *T);                                                                                    \
    void G(claim_##name)(trial *T)
/* clang-format on */
#endif
