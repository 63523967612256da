/* verdict.c -- the verdict of a statement follows from what its claims did; it is never typed in. */
#include "chapters/judge/memory_text.h"
#include "chapters/judge/scope.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const claim_result *result_of(const char *claim_name, const claim_result *results, int count)
{
    for (int k = 0; k < count; k++)
        if (strcmp(results[k].claim->name, claim_name) == 0)
            return &results[k];
    return NULL;
}

static int is_given(const char *text) { return text != NULL && text[0] != '\0'; }

/* ---- what several claims decide together ------------------------------------------------------------ */

/* A finding in the making. */
struct gathering {
    int claims;
    evidence weakest;
    scope scope;
    char *argued_for;
    int bounded; /* whether some claim is limited to degrees, and no words lead further */
};

/* Whether the part is one of those that semicolons keep apart. */
static int has_part(const char *all, const char *part)
{
    size_t length = strlen(part);
    for (const char *at = all; at != NULL && (at = strstr(at, part)) != NULL; at++)
        if ((at == all || (at >= all + 2 && strncmp(at - 2, "; ", 2) == 0)) &&
            (at[length] == '\0' || at[length] == ';'))
            return 1;
    return 0;
}

static void add_cases(struct gathering *g, const char *cases)
{
    size_t old = g->argued_for != NULL ? strlen(g->argued_for) : 0;
    if (!is_given(cases) || has_part(g->argued_for, cases))
        return;
    char *longer = realloc(g->argued_for, old + strlen(cases) + 3);
    if (longer == NULL)
        abort();
    sprintf(longer + old, "%s%s", old > 0 ? "; " : "", cases);
    g->argued_for = longer;
}

static void weaken(struct gathering *g, evidence e) { g->weakest = e < g->weakest ? e : g->weakest; }

/* An argument that adds cases lets the evidence of the others stand; one that the cases themselves need does not. */
static void add_argument(struct gathering *g, const char *cases)
{
    if (is_given(cases))
        add_cases(g, cases);
    else
        weaken(g, BY_ARGUMENT);
}

static void add_claim(struct gathering *g, const claim_result *c)
{
    scope s = scope_of(c);
    int limited = 0;
    for (int k = 0; k < s.ranges; k++)
        limited |= s.range[k].high < WITHOUT_END;
    g->claims++;
    weaken(g, c->evidence);
    meet_scope(&g->scope, &s);
    free_scope(&s);
    if (is_given(c->claim->argued))
        add_argument(g, c->claim->argued_for);
    g->bounded |= limited && !is_given(c->claim->argued_for);
}

/* Ends the gathering.  Words of one claim that lead to more cases lead nowhere while another one stays behind. */
static finding found(struct gathering *g, const char *letter, int said_of_all)
{
    finding f = {.evidence = g->claims > 0 ? g->weakest : NO_EVIDENCE};
    f.scope = g->claims > 0 ? scope_words(&g->scope, is_given(letter) ? letter : "n") : strdup("");
    int whole = g->argued_for != NULL && (said_of_all || !g->bounded);
    f.argued_for = whole ? g->argued_for : strdup("");
    if (f.scope == NULL || f.argued_for == NULL)
        abort();
    if (!whole)
        free(g->argued_for);
    free_scope(&g->scope);
    return f;
}

void free_finding(finding *f)
{
    free(f->scope), free(f->argued_for);
    *f = (finding){0};
}

finding finding_of(const claim_result *c, const char *letter)
{
    struct gathering g = {.weakest = PROVED};
    add_claim(&g, c);
    return found(&g, letter, 0);
}

/* What a reading and those that stand with it decide. */
static struct gathering gather_reading(const statement_link *reading, const claim_result *results, int count)
{
    struct gathering g = {.weakest = PROVED};
    for (const statement_link *l = reading; l == reading || (l->role == READING_WITH && l->claim != NULL); l++) {
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c != NULL)
            add_claim(&g, c);
    }
    return g;
}

finding finding_of_reading(const statement *s, const statement_link *reading, const claim_result *results, int count)
{
    struct gathering g = gather_reading(reading, results, count);
    if (reading->digest != NULL)
        leave_letters(&g.scope, reading->digest);
    if (s->degree > 0)
        keep_degree(&g.scope, s->degree);
    return found(&g, s->letter, 0);
}

/* Whether the claims of a reading have no case in common that is one of the statement. */
static int is_empty_reading(const statement *s, const statement_link *reading, const claim_result *results, int count)
{
    struct gathering g = gather_reading(reading, results, count);
    if (s->degree > 0)
        keep_degree(&g.scope, s->degree);
    int is = is_empty_scope(&g.scope);
    free(g.argued_for);
    free_scope(&g.scope);
    return is;
}

/* "proved for n = 1 to 6"; "proved, each step for its own cases". */
static void put_known(FILE *out, const char *how, const char *cases)
{
    static const char apart[] = "each step ";
    int is_apart = strncmp(cases, apart, sizeof apart - 1) == 0;
    fprintf(out, "%s%s%s", how, cases[0] == '\0' ? "" : is_apart ? ", " : " for ", cases);
}

char *finding_words(const finding *f)
{
    char *text = NULL;
    size_t room = 0;
    FILE *out = text_open(&text, &room);
    const char *how = evidence_name[f->evidence], *argued = evidence_name[BY_ARGUMENT];
    if (f->evidence == BY_ARGUMENT && is_given(f->argued_for)) {
        put_known(out, how, f->argued_for);
        if (is_given(f->scope)) {
            fputs("; ", out);
            put_known(out, "computed", f->scope);
        }
    } else if (f->evidence != NO_EVIDENCE) {
        put_known(out, how, f->scope);
        if (is_given(f->argued_for)) {
            fputs("; ", out);
            put_known(out, argued, f->argued_for);
        }
    }
    text_close(out, &text);
    return text;
}

/* ---- verdicts --------------------------------------------------------------------------------------- */

/* How many links of each role there are, and how many readings fail. */
struct links {
    int of[ROLES], failing_readings;
};

/* A statement
 *   with a claim that refutes it                               fails, a definition too,
 *   that is a definition                                       is one, with what is checked about it,
 *   with a reading that fails, unless it is said what is meant is undecided, and so is one with readings alone,
 *   with hypotheses to be added, each shown to be needed       is conditional,
 *   decided by claims that all hold                            holds,
 *   about which nothing was decided                            is open. */
static verdict verdict_of(const statement *s, const struct links *n)
{
    int held = n->of[HOLDS_BY] + n->of[CHECKED_BY];
    if (n->of[REFUTED_BY] > 0)
        return VERDICT_FAILS;
    if (s->is_definition)
        return VERDICT_DEFINITION;
    if (n->of[HYPOTHESIS] == 0 && n->of[READING] > 0 && (held == 0 || (n->failing_readings > 0 && n->of[MEANT] == 0)))
        return VERDICT_UNDECIDED;
    if (held == 0)
        return VERDICT_OPEN;
    return n->of[HYPOTHESIS] > 0 ? VERDICT_CONDITIONAL : VERDICT_HOLDS;
}

/* A claim that did not do what its role asks leaves the statement open, and not as expected; so do claims that have no case in
 * common, of one reading, too. */
statement_result derive(const statement *s, const claim_result *results, int count)
{
    statement_result r = {.statement = s, .as_expected = 1};
    struct links n = {0};
    int said_of_all = 0;
    struct gathering printed = {.weakest = PROVED}, corrected = {.weakest = PROVED}, against = {.weakest = PROVED};
    for (const statement_link *link = s->links; link->claim != NULL || link->text != NULL; link++) {
        const claim_result *c = link->claim != NULL ? result_of(link->claim, results, count) : NULL;
        if (link->claim != NULL && (c == NULL || !c->as_expected)) {
            r.as_expected = 0;
            continue;
        }
        n.of[link->role]++;
        switch (link->role) {
        case HOLDS_BY:
        case CHECKED_BY:
            add_claim(&printed, c);
            break;
        case REFUTED_BY:
            if (r.refuted_by == NULL)
                r.refuted_by = c;
            weaken(&against, c->evidence);
            break;
        case CORRECTED_BY:
            add_claim(&corrected, c);
            break;
        case READING:
            n.failing_readings += c != NULL && c->outcome == FAILS;
            r.as_expected &= !is_empty_reading(s, link, results, count);
            break;
        default:
            break;
        }
    }
    /* Words are about what is true: the statement, or what is true instead. */
    int is_corrected = n.of[REFUTED_BY] > 0 || (n.of[CORRECTED_BY] > 0 && n.of[HOLDS_BY] + n.of[CHECKED_BY] == 0);
    struct gathering *truth = is_corrected ? &corrected : &printed;
    for (const statement_link *link = s->links; link->claim != NULL || link->text != NULL; link++)
        if (link->role == ARGUED) {
            add_argument(truth, link->place);
            said_of_all |= is_given(link->place);
        } else if (link->role == CITES) {
            weaken(truth, BY_ARGUMENT);
        } else if (link->role == HYPOTHESIS || link->role == NEEDS) {
            add_condition(&truth->scope, link->digest);
        }
    if (s->letters != NULL) {
        leave_letters(&printed.scope, s->letters);
        leave_letters(&corrected.scope, s->letters);
    }
    if (s->degree > 0) {
        keep_degree(&printed.scope, s->degree);
        keep_degree(&corrected.scope, s->degree);
    }
    r.as_expected &= !is_empty_scope(&printed.scope) && !is_empty_scope(&corrected.scope);
    r.as_printed = found(&printed, s->letter, said_of_all);
    r.as_corrected = found(&corrected, s->letter, said_of_all);
    r.verdict = r.as_expected ? verdict_of(s, &n) : VERDICT_OPEN;
    if (r.verdict == VERDICT_FAILS) {
        free(r.as_printed.scope);
        r.as_printed.evidence = against.weakest;
        r.as_printed.scope = strdup(r.refuted_by->scope);
        if (r.as_printed.scope == NULL)
            abort();
    } else {
        r.refuted_by = NULL;
    }
    if (r.verdict == VERDICT_OPEN || r.verdict == VERDICT_UNDECIDED)
        r.as_printed.evidence = NO_EVIDENCE;
    return r;
}

void free_statement_result(statement_result *r)
{
    free_finding(&r->as_printed);
    free_finding(&r->as_corrected);
    *r = (statement_result){0};
}
