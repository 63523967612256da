/* lists.h -- the lists that judge, weave, the build and the tests share: each stands here and nowhere else.
 *
 * A list is a macro that applies X to every entry.  chapters/CMakeLists.txt reads the number types from the lines below,
 * and weave writes all lists into register.json, where the tests find them. */
#ifndef CAGD_LISTS_H
#define CAGD_LISTS_H

/* X(TAG, name, suffix, kernels): FIELD_TYPE, "field", the suffix of what is generic in it, and its kernels. */
#define NUMBER_TYPE_LIST(X)                                                                                            \
    X(FIELD, field, f, "exact/kernels_f.h")                                                                            \
    X(RATIONAL, rational, q, "exact/kernels_q.h")                                                                      \
    X(INTERVAL, interval, i, "exact/kernels_i.h")                                                                      \
    X(DOUBLE, double, m, "core/kernels/kernels_m.h")

/* X(TAG, name): the kinds of claims. */
#define KIND_LIST(X)                                                                                                   \
    X(IDENTITY, "identity")             /* compared at every case; the evidence is the number type's               */  \
    X(DECISION, "decision")             /* a finite exact decision that settles the stated case or range           */  \
    X(COUNTEREXAMPLE, "counterexample") /* the printed statement, computed at one exact instance, where it must fail */

/* X(TAG): how the option of a role is written.
 *     CLAIM_LIST             claim claim ...
 *     CLAIM_TEXT         claim | text, or text alone
 *     CLAIM_TEXT_WORDS   claim | text | words, or claim | text, or text alone
 *     CLAIM_PLACE_TEXT   claim | place | text
 *     PLACE_TEXT         place | text */
#define FORM_LIST(X) X(CLAIM_LIST) X(CLAIM_TEXT) X(CLAIM_TEXT_WORDS) X(CLAIM_PLACE_TEXT) X(PLACE_TEXT)

/* X(TAG, key, form): what a claim, or a text, does for a statement. */
#define ROLE_LIST(X)                                                                                                   \
    X(HOLDS_BY, "holds-by", CLAIM_LIST)         /* the claim decides that what is printed is true                     */   \
    X(CONFIRMED_BY, "confirmed-by", CLAIM_LIST) /* the claim confirms it, in another way or for fewer cases            */  \
    X(REFUTED_BY, "refuted-by", CLAIM_LIST)     /* the claim exhibits a case where what is printed is false            */  \
    X(CORRECTED_BY, "corrected-by", CLAIM_LIST) /* the claim decides the corrected statement                           */  \
    X(HYPOTHESIS, "hypothesis", CLAIM_TEXT) /* text: a hypothesis to be added; claim: what goes wrong without it   */  \
    X(NEEDS, "needs", CLAIM_PLACE_TEXT)     /* text: a hypothesis that the source states, at that place; claim: what   \
                                               goes wrong without it                                               */  \
    X(READING, "reading", CLAIM_TEXT_WORDS) /* text: one way to read the print; claim: what decides that reading;     \
                                               place: the argument in words that it needs besides, or none         */  \
    X(READING_WITH, "reading-with", CLAIM_LIST) /* behind a reading: a claim that decides it together with its own */  \
    X(MEANT, "meant", PLACE_TEXT)           /* text: what the source itself means; place: by what one knows        */  \
    X(ARGUED, "argued", PLACE_TEXT) /* text: an argument in words that leads from the claims to the statement; place:  \
                                       the cases that it adds to those of the claims, empty where they need it     */  \
    X(CITES, "cites", PLACE_TEXT)   /* text: a theorem that the decision stands on; place: where it is proved      */  \
    X(CHECKED_BY, "checked-by", CLAIM_LIST) /* definitions: what is checked about them                                 */

/* X(name): what is wrong with a statement that fails. */
#define CLASS_LIST(X) X("misprint") X("false") X("missing-hypothesis") X("invalid-proof")

/* X(TAG, key): where an entry of a claim's data stands. */
#define DATA_LIST(X)                                                                                                   \
    X(DATA, "data")       /* what the claim is computed for                                                       */   \
    X(INSTEAD, "instead") /* what takes the place of a datum of that name in the control                          */   \
    X(RESULT, "result")   /* what comes out, compared with what the body computes                                 */
#endif
