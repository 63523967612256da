/* report.c -- results as JSON and as texts of one line. */
#include "cli/report.h"
#include "chapters/judge/memory_text.h"
#include "cli/screen.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The type whose evidence is the claim's, hence whose exhibits speak for it. */
const type_result *speaking_type(const claim_result *r)
{
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        if (r->by[t].ran && r->by[t].outcome == FAILS)
            return &r->by[t];
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        if (r->by[t].ran)
            return &r->by[t];
    return NULL;
}

char *line_of_exhibits(const exhibit *shown, int count)
{
    char *text = NULL;
    size_t room = 0;
    FILE *out = text_open(&text, &room);
    for (int k = 0; k < count; k++)
        fprintf(out, "%s%s = %s", k > 0 ? "; " : "", shown[k].name, shown[k].value);
    text_close(out, &text);
    return text;
}

char *exhibits_line(const claim_result *r)
{
    const type_result *b = speaking_type(r);
    return line_of_exhibits(b != NULL ? b->shown : NULL, b != NULL ? b->exhibits : 0);
}

static json_t *list_of_exhibits(const exhibit *shown, int count)
{
    json_t *list = json_array();
    for (int k = 0; k < count; k++)
        json_array_append_new(list, json_pack("{s:s, s:s}", "name", shown[k].name, "value", shown[k].value));
    return list;
}

static json_t *exhibits_json(const type_result *b) { return list_of_exhibits(b->shown, b->exhibits); }

char *not_expected(const claim_result *r)
{
    char *text = NULL;
    size_t room;
    FILE *out = text_open(&text, &room);
    fprintf(out, "%s, expected otherwise", outcome_name[r->outcome]);
    for (number_type t = 0; t < NUMBER_TYPES; t++)
        if (r->by[t].ran && !r->by[t].control_caught)
            fprintf(out, "; %s: its control was not caught", number_type_name[t]);
    text_close(out, &text);
    return text;
}

/* A number, or null for what is none or infinite, which JSON has not. */
static json_t *number_json(double x) { return isfinite(x) ? json_real(x) : json_null(); }

json_t *claim_json(const claim_result *r)
{
    static const char *const kind[] = {"identity", "decision", "counterexample"};
    const claim *c = r->claim;
    json_t *types = json_object();
    for (number_type t = 0; t < NUMBER_TYPES; t++) {
        const type_result *b = &r->by[t];
        if (!b->ran)
            continue;
        char seed[24];
        snprintf(seed, sizeof seed, "%016llx", (unsigned long long)b->seed);
        json_t *j = json_pack("{s:s, s:i, s:i, s:b, s:s}", "outcome", outcome_name[b->outcome], "cases", b->cases,
                              "compared", b->compared, "control_caught", b->control_caught, "seed", seed);
        if (t == DOUBLE_TYPE)
            json_object_set_new(j, "largest_error_over_bound", number_json(b->worst));
        if (t == INTERVAL_TYPE)
            json_object_set_new(j, "widest_enclosure", number_json(b->worst));
        json_object_set_new(j, "shown", exhibits_json(b));
        json_object_set_new(types, number_type_name[t], j);
    }
    json_t *small = r->witnesses > 0 ? list_of_exhibits(r->witness, r->witnesses) : NULL;
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:s, s:b, s:s, s:s, s:o, s:o*}", "name",
                     c->name, "chapter", c->chapter, "title", c->title, "title_zh", c->title_zh, "kind", kind[c->kind],
                     "given", c->given, "let", c->let, "then", c->then, "method", c->method, "control", c->control,
                     "outcome", outcome_name[r->outcome], "as_expected", r->as_expected, "evidence",
                     evidence_name[r->evidence], "scope", r->scope, "types", types, "small_instance", small);
}

/* Whether it is a counterexample, and does refute. */
static int is_shown_false(const claim_result *c) { return c->claim->kind == COUNTEREXAMPLE && c->as_expected; }

static json_t *counterexample_json(const claim_result *r)
{
    char *line = exhibits_line(r);
    json_t *j =
        json_pack("{s:s, s:s, s:o}", "claim", r->claim->name, "text", line, "values", exhibits_json(speaking_type(r)));
    free(line);
    return j;
}

/* A step, or a reading, with how it is known: what the fields `more` say, and the finding, which an argument in words, NULL where
 * there is none, weakens. */
static json_t *with_finding(json_t *more, finding f, const char *argument)
{
    f.evidence = argument != NULL && f.evidence > BY_ARGUMENT ? BY_ARGUMENT : f.evidence;
    if (argument != NULL)
        json_object_set_new(more, "argument", json_string(argument));
    json_object_set_new(more, "evidence", json_string(evidence_name[f.evidence]));
    json_object_set_new(more, "scope", json_string(f.scope != NULL ? f.scope : ""));
    json_object_set_new(more, "argued_for", json_string(f.argued_for != NULL ? f.argued_for : ""));
    free_finding(&f);
    return more;
}

/* The claims of a role, each with its own finding. */
static json_t *steps_json(const statement *s, role wanted, const claim_result *results, int count)
{
    json_t *steps = json_array();
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        const claim_result *c = l->role == wanted && l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c != NULL)
            json_array_append_new(
                steps, with_finding(json_pack("{s:s, s:s}", "claim", l->claim, "kind", kind_name[c->claim->kind]),
                                    finding_of(c, s->letter), NULL));
    }
    return steps;
}

json_t *statement_json(const statement_result *r, const claim_result *results, int count)
{
    const statement *s = r->statement;
    json_t *hypotheses = json_array(), *needed = json_array(), *readings = json_array(), *claims = json_array();
    json_t *words = json_array();
    const claim_result *against = NULL;
    for (const statement_link *l = s->links; l->claim != NULL || l->text != NULL; l++) {
        const claim_result *c = l->claim != NULL ? result_of(l->claim, results, count) : NULL;
        if (c != NULL) {
            int known = 0;
            for (size_t k = 0; k < json_array_size(claims); k++)
                known |= strcmp(json_string_value(json_array_get(claims, k)), l->claim) == 0;
            if (!known)
                json_array_append_new(claims, json_string(l->claim));
            if (against == NULL && (l->role == REFUTED_BY || l->role == HYPOTHESIS) && is_shown_false(c))
                against = c;
        }
        if (l->role == HYPOTHESIS || l->role == NEEDS)
            json_array_append_new(l->role == NEEDS ? needed : hypotheses,
                                  json_pack("{s:s, s:s*, s:o}", "hypothesis", l->text, "stated_in", l->place,
                                            "without_it",
                                            c != NULL && c->as_expected ? counterexample_json(c) : json_null()));
        if (l->role == ARGUED || l->role == CITES || l->role == MEANT)
            json_array_append_new(
                words, json_pack("{s:s, s:s, s:s}", "is", role_key[l->role], "place", l->place, "text", l->text));
        if (l->role == READING)
            json_array_append_new(
                readings, with_finding(json_pack("{s:s, s:s*, s:s}", "reading", l->text, "claim", l->claim, "outcome",
                                                 c != NULL ? outcome_name[c->outcome] : "not decided"),
                                       c != NULL ? finding_of_reading(s, l, results, count) : (finding){0}, l->place));
        if (l->role == READING_WITH) {
            json_t *reading = json_array_get(readings, json_array_size(readings) - 1);
            if (json_object_get(reading, "with") == NULL)
                json_object_set_new(reading, "with", json_array());
            json_array_append_new(json_object_get(reading, "with"), json_string(l->claim));
        }
    }
    json_t *printed = json_pack(
        "{s:s, s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o}", "verdict", verdict_name[r->verdict], "evidence",
        evidence_name[r->as_printed.evidence], "scope", r->as_printed.scope, "argued_for", r->as_printed.argued_for,
        "class", r->verdict == VERDICT_FAILS ? s->class : "", "hypotheses", hypotheses, "counterexample",
        against != NULL ? counterexample_json(against) : json_null(), "readings", readings, "stated_hypotheses_needed",
        needed, "words", words, "steps", steps_json(s, s->is_definition ? CHECKED_BY : HOLDS_BY, results, count));
    json_t *corrected = json_null();
    if (s->corrected[0] != '\0')
        corrected = json_pack("{s:s, s:s, s:s, s:s, s:s, s:o}", "tex", s->corrected, "verdict",
                              r->as_corrected.evidence != NO_EVIDENCE ? "holds" : "open", "evidence",
                              evidence_name[r->as_corrected.evidence], "scope", r->as_corrected.scope, "argued_for",
                              r->as_corrected.argued_for, "steps", steps_json(s, CORRECTED_BY, results, count));
    return json_pack("{s:s, s:s, s:s, s:s, s:s, s:o, s:o, s:o, s:s, s:s, s:s, s:b}", "id", s->id, "title", s->title,
                     "title_zh", s->title_zh, "printed_tex", s->printed, "chapter", s->chapter, "as_printed", printed,
                     "corrected", corrected, "claims", claims, "figure", s->figure, "example", s->example, "note",
                     s->note, "as_expected", r->as_expected);
}

static void print_with(json_t *document, int digits)
{
    screen_leaves_lines();
    json_dumpf(document, stdout, JSON_INDENT(2) | (size_t)JSON_REAL_PRECISION(digits));
    fputc('\n', stdout);
    json_decref(document);
}
void print_json(json_t *document) { print_with(document, 6); }
void print_json_exactly(json_t *document) { print_with(document, 17); }
