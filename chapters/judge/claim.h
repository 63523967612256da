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

#include "chapters/judge/lists.h"

#include <stdint.h>

#define ONE(...) +1 /* counts the entries of a list */

typedef enum number_type {
#define TYPE_TAG(tag, name, suffix, kernels) tag##_TYPE,
    NUMBER_TYPE_LIST(TYPE_TAG)
#undef TYPE_TAG
        NUMBER_TYPES
} number_type;
extern const char *const number_type_name[NUMBER_TYPES];

typedef enum outcome { HOLDS, FAILS, UNDECIDED } outcome;
extern const char *const outcome_name[];

/* By increasing strength. */
typedef enum evidence {
    NO_EVIDENCE,
    MEASURED,
    ENCLOSED,
    SAMPLED,
    BY_ARGUMENT, /* what was computed is decided or proved, and words lead from there to the statement */
    DECIDED,
    PROVED
} evidence;
extern const char *const evidence_name[];

typedef enum claim_kind {
#define KIND_TAG(tag, name) tag,
    KIND_LIST(KIND_TAG)
#undef KIND_TAG
} claim_kind;
enum { KINDS = 0 KIND_LIST(ONE) };
extern const char *const kind_name[KINDS];

/* One entry `name = value` of a claim's data: rows of columns numbers each, written as they stand in the block, row after
 * row.  Of a text, columns is 0 and value[0] is the text. */
typedef struct datum {
    const char *name, *text; /* text: the value as it is written                                      */
    enum data_place {
#define PLACE_TAG(tag, key) IN_##tag,
        DATA_LIST(PLACE_TAG)
#undef PLACE_TAG
    } place;
    int rows, columns;
    const char *const *value;
} datum;
enum { DATA_PLACES = 0 DATA_LIST(ONE) };

/* One named value that a claim shows: the data of a counterexample, the two sides of an equality. */
typedef struct exhibit {
    char *name, *value;
} exhibit;

/* One case of one claim in one number type. */
typedef struct trial {
    const struct claim *claim;
    uint64_t seed, state; /* the seed of this case, printed when it fails; the generator's state     */
    int degree;           /* n of this case; 0 for a claim without degrees                           */
    int planted;          /* 1 in the control                                                        */
    int faulty;           /* 1 where the named fault is in: in the control, and of a counterexample in
                              the run, whose control is right                                        */
    int deep;             /* 1 when asked for more than the default depth                            */
    int compared;         /* values compared so far; a claim that compared nothing fails             */
    const char *positive; /* field: the variables taken to be positive where a sign was read off the
                              coefficients, separated by blanks; NULL for none                        */
    outcome outcome;      /* FAILS as soon as one comparison does                                    */
    double worst;         /* double: largest error/bound; interval: widest enclosure of a difference */
    const char *about;    /* what is being compared, for the first difference                        */
    exhibit *shown;       /* what the case shows, `exhibits` in number                                */
    int exhibits;
    struct small_data *small; /* where the data are simple, or kept; otherwise NULL: see witness.h */
    uint64_t used;            /* bit k: entry k of the claim's data was asked for                         */
    int mistaken;             /* 1 when an entry is missing, of another shape, or another result came out */
} trial;

typedef struct claim {
    const char *name, *title, *title_zh, *given, *let, *then, *method, *control, *scope;
    const char *letter, *over; /* of the degrees; what the variables of the field stand for: see scope.c         */
    const char *where;         /* conditions on what is given, "one; another"; NULL for none: see scope.h         */
    const char *within;        /* which phrases of scopes are narrower than which: see scope.h; NULL for none     */
    const char *argued_for, *argued; /* the cases that an argument in words adds, and the argument; see ARGUED    */
    const char *defines; /* the kernels whose definitional claim this is: its other side shares no code with them */
    const char *chapter, *file;
    int line;
    claim_kind kind;
    int degree_low, degree_high;          /* the degrees that the field visits; both 0 without degrees           */
    int degree_sampled;                   /* the largest degree sampled; at least degree_high                     */
    int all_degrees;                      /* 1 when n itself is a variable of the field                           */
    void (*body[NUMBER_TYPES])(trial *T); /* NULL where the claim is not run                             */
    const datum *data;                    /* ends with an entry of NULL name; NULL without data          */
    const void *context;                  /* for the body alone, which finds it as T->claim->context      */
} claim;

typedef enum role {
#define ROLE_TAG(tag, key, has_text) tag,
    ROLE_LIST(ROLE_TAG)
#undef ROLE_TAG
} role;
enum { ROLES = 0 ROLE_LIST(ONE) };
extern const char *const role_key[ROLES];

typedef enum role_form {
#define FORM_TAG(tag) tag,
    FORM_LIST(FORM_TAG)
#undef FORM_TAG
} role_form;
extern const role_form form_of_role[ROLES];

/* What its role asks for; NULL where there is none. */
typedef struct statement_link {
    role role;
    const char *claim, *place, *text;
    const char *
        digest; /* of a hypothesis: what it asks, the first clause of the text; of a reading: its letters and those of its
                         * statement, "t beta x"; else NULL */
} statement_link;

typedef struct statement {
    const char *id, *title, *title_zh, *printed, *class, *corrected, *figure, *note;
    const char *example; /* why one instance decides what is printed in general words, or empty */
    const char *letter;  /* what it calls the degree: "n", "k" for orders, "degree", "order"; NULL: n             */
    const char *letters; /* of what is printed and corrected, with blanks between: "t beta x"; NULL: not known    */
    const char *chapter, *file;
    int line, is_definition, striking; /* striking: rank among the counterexamples worth telling first, or 0 */
    int degree;                        /* the only one that it is about, or 0                                */
    const statement_link *links;       /* ends with a link whose claim and text are NULL                       */
} statement;

/* One body for every number type it is compiled in; T is the trial. */
/* clang-format off */
#define CLAIM(name)                                                                                                    \
    void G(claim_##name)(trial *T);                                                                                    \
    void G(claim_##name)(trial *T)
/* clang-format on */
#endif
