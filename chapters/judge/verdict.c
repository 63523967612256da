/* verdict.c -- the verdict of a statement follows from what its claims did; it is never typed in. */
#include "chapters/judge/run.h"

#include <string.h>

const claim_result *result_of(const char *claim_name, const claim_result *results, int count)
{
    for (int k = 0; k < count; k++)
        if (strcmp(results[k].claim->name, claim_name) == 0)
            return &results[k];
    return NULL;
}

static evidence weaker(evidence a, evidence b) { return a < b ? a : b; }

static int is_limited(const claim *c) { return c->degree_high > 0 && !c->all_degrees; }

/* Of two claims that together decide a statement, the one whose scope speaks for both: that of the weaker evidence,
 * then that of the fewer degrees. */
static const claim_result *narrower(const claim_result *a, const claim_result *b)
{
    if (a == NULL || a->evidence != b->evidence)
        return a == NULL || b->evidence < a->evidence ? b : a;
    int fewer = is_limited(b->claim) && (!is_limited(a->claim) || b->claim->degree_high < a->claim->degree_high);
    return fewer ? b : a;
}

/* A statement
 *   with a claim that refutes it                               fails, a definition too,
 *   that is a definition                                       is one, with what is checked about it,
 *   with hypotheses to be added, each shown to be needed       is conditional,
 *   decided by claims that all hold                            holds,
 *   with several readings and none of these                    is undecided,
 *   about which nothing was decided                            is open.
 * A claim that did not do what its role asks leaves the statement open, and not as expected. */
statement_result derive(const statement *s, const claim_result *results, int count)
{
    statement_result r = {.statement = s, .as_expected = 1};
    int refuted = 0, held = 0, conditions = 0, readings = 0;
    evidence for_it = PROVED, against_it = PROVED, correction = PROVED;
    const claim_result *holds_by = NULL, *refuted_by = NULL;
    for (const statement_link *link = s->links; link->claim != NULL || link->text != NULL; link++) {
        const claim_result *c = link->claim != NULL ? result_of(link->claim, results, count) : NULL;
        if (link->claim != NULL && (c == NULL || !c->as_expected)) {
            r.as_expected = 0;
            continue;
        }
        switch (link->role) {
        case HOLDS_BY:
        case CHECKED_BY:
            held++;
            holds_by = narrower(holds_by, c);
            for_it = weaker(for_it, c->evidence);
            break;
        case REFUTED_BY:
            refuted++;
            if (refuted_by == NULL)
                refuted_by = c;
            against_it = weaker(against_it, c->evidence);
            break;
        case CORRECTED_BY:
            r.corrected_by = narrower(r.corrected_by, c);
            r.corrected = 1;
            correction = weaker(correction, c->evidence);
            break;
        case HYPOTHESIS:
            conditions++;
            break;
        case NEEDS:
            break;
        case READING:
            readings++;
            break;
        }
    }
    r.corrected_evidence = r.corrected ? correction : NO_EVIDENCE;
    if (!r.as_expected) {
        r.verdict = VERDICT_OPEN;
    } else if (refuted > 0) {
        r.verdict = VERDICT_FAILS;
        r.evidence = against_it;
        r.decided_by = refuted_by;
    } else if (s->is_definition) {
        r.verdict = VERDICT_DEFINITION;
        r.evidence = held > 0 ? for_it : NO_EVIDENCE;
        r.decided_by = holds_by;
    } else if (readings > 0 && conditions == 0 && held == 0) {
        r.verdict = VERDICT_UNDECIDED;
    } else if (held > 0) {
        r.verdict = conditions > 0 ? VERDICT_CONDITIONAL : VERDICT_HOLDS;
        r.evidence = for_it;
        r.decided_by = holds_by;
    } else {
        r.verdict = VERDICT_OPEN;
    }
    return r;
}
