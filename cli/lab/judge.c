/* judge.c -- a submission against the reference: points, ways through the code, the field; see lab.h.
 *
 * Both are run in processes of their own and tell what they computed; only here the two are compared.  A requirement is wrong
 * when there are numbers for which its exact results are not those of the reference: never because something was not understood.
 * It is right for all inputs when on every way that was found, through both codes together, the results are the same elements of
 * the field; other ways, and inputs for which the code divides by 0, are looked for as ways.c says. */
#include "cli/lab/lab.h"
#include "cli/point_json.h"
#include "exact/code/border.h"

#include <dirent.h>
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { FIRST_POINTS = 3, MOST_SHRINKING = 200, HINT_POINTS = 4, ROUNDED = 12, MOST_SOLUTIONS = 16, MOST_KNOWN = 20000 };
enum { SECONDS = 1, FIELD_SECONDS = 10, SHOWN = 6, SHORT = 60 };

/* What is known while one submission is judged. */
struct trial {
    struct lab_bench *bench;
    const struct lab *lab;
    struct lab_place place;
    struct lab_player student;
    json_t *jobs;      /* what the sanitizers are shown                                  */
    char manners[300]; /* what the code does besides computing; empty: nothing was seen  */
    int manners_line;
    char unset[150]; /* what is seen of values that were never computed, before anything runs; or empty */
    int unset_line;
};

/* ---- one run of both -------------------------------------------------------------------------------------- */

static json_t *job_of(const struct lab_case *c, const struct cagd_code_point *p, const char *numbers, const char *entry)
{
    char name[40];
    json_t *inputs = json_array();
    snprintf(name, sizeof name, "%s_%d", entry, c->number);
    for (int i = 0; i < p->inputs; i++) {
        const struct cagd_code_input *in = &p->input[i];
        json_t *value = json_array(), *like = json_array();
        for (int j = 0; j < (in->count > 0 ? in->count : 1); j++) {
            json_array_append_new(value, json_string(in->value[j]));
            json_array_append_new(like, json_integer(in->like != NULL ? in->like[j] : j));
        }
        json_array_append_new(inputs, json_pack("{s:s, s:i, s:b, s:o, s:o}", "name", in->name, "count", in->count,
                                                "variable", in->variable, "value", value, "like", like));
    }
    return json_pack("{s:s, s:s, s:i, s:o}", "entry", name, "numbers", numbers, "seconds",
                     strcmp(numbers, "field") == 0 ? FIELD_SECONDS : SECONDS, "inputs", inputs);
}

/* What the two say to a job; the job is released. */
struct pair {
    json_t *got, *want;
};

static void forget(struct pair *p)
{
    json_decref(p->got);
    json_decref(p->want);
}

static json_t *lost(void)
{
    return json_pack("{s:s, s:s}", "end", "crashed", "message",
                     "the process of the code ended, or said what no run says");
}

/* What the reference says to a job; it is asked once only. */
static json_t *asked_reference(struct lab_bench *b, const json_t *job, int *is_asked)
{
    char *key = json_dumps(job, JSON_COMPACT);
    json_t *known = key != NULL ? json_object_get(b->known, key) : NULL;
    *is_asked = known == NULL;
    free(key);
    return json_incref(known);
}

static void keep_reference(struct lab_bench *b, const json_t *job, json_t *answer)
{
    char *key = json_dumps(job, JSON_COMPACT);
    if (json_object_size(b->known) >= MOST_KNOWN)
        json_object_clear(b->known);
    if (key != NULL)
        json_object_set(b->known, key, answer);
    free(key);
}

/* A job for each, which may be the same. */
static struct pair ask(struct trial *t, json_t *job, json_t *for_reference)
{
    struct pair p;
    int is_asked;
    lab_ask(&t->student, job);
    p.want = asked_reference(t->bench, for_reference, &is_asked);
    if (is_asked)
        lab_ask(&t->bench->right, for_reference);
    p.got = lab_answer(&t->student);
    if (is_asked)
        p.want = lab_answer(&t->bench->right);
    if (is_asked && p.want != NULL)
        keep_reference(t->bench, for_reference, p.want);
    json_decref(job);
    json_decref(for_reference);
    if (p.got == NULL) {
        p.got = lost();
        lab_player_close(&t->student);
        lab_player_open(&t->student, &t->place, t->lab, "student.so");
    }
    if (p.want == NULL)
        p.want = lost();
    return p;
}

/* What is right is told by formulas, where the requirement has them. */
static json_t *for_reference(const struct trial *t, json_t *job)
{
    static const char entry[] = "lab_entry_";
    char name[40];
    const char *asked = json_string_value(json_object_get(job, "entry"));
    int number = strncmp(asked, entry, sizeof entry - 1) == 0 ? atoi(asked + sizeof entry - 1) : -1;
    if (number < 0 || t->lab->at[number].formula == NULL)
        return json_incref(job);
    json_t *other = json_copy(job);
    snprintf(name, sizeof name, "lab_formula_%d", number);
    json_object_set_new(other, "entry", json_string(name));
    return other;
}

static struct pair ask_both(struct trial *t, json_t *job) { return ask(t, job, for_reference(t, job)); }

static int finished(const json_t *outcome)
{
    return strcmp(json_string_value(json_object_get(outcome, "end")), "finished") == 0;
}

static const char *member(const json_t *row, const char *key)
{
    const char *text = json_string_value(json_object_get(row, key));
    return text != NULL ? text : "";
}

/* Whether what was printed is the answer's: where this program is sanitized the sanitizer prints of a run that is stopped. */
static int is_its_own(const json_t *outcome)
{
#ifdef __SANITIZE_ADDRESS__
    return finished(outcome);
#else
    (void)outcome;
    return 1;
#endif
}

/* The index of the first result that is not the same; -1 when there is none. */
static int first_difference(const json_t *got, const json_t *want)
{
    const json_t *a = json_object_get(got, "results"), *b = json_object_get(want, "results");
    for (size_t k = 0; k < json_array_size(b); k++) {
        const json_t *x = json_array_get(a, k), *y = json_array_get(b, k);
        if (x == NULL || strcmp(member(x, "name"), member(y, "name")) != 0 ||
            strcmp(member(x, "got"), member(y, "got")) != 0)
            return (int)k;
    }
    return json_array_size(a) != json_array_size(b) ? 0 : -1;
}

/* Whether the result is an input as it is behind the call. */
static int is_input(const struct lab_case *c, const char *name)
{
    size_t length = strcspn(name, "[");
    for (int k = 0; k < c->h->inputs; k++)
        if (strlen(c->h->input[k].name) == length && strncmp(c->h->input[k].name, name, length) == 0)
            return 1;
    return 0;
}

/* The first difference among what was computed; a changed argument is a matter of manners. */
static int difference_of(struct trial *t, const struct lab_case *c, const struct pair *p)
{
    int k = first_difference(p->got, p->want);
    if (k < 0)
        return k;
    const char *name = member(json_array_get(json_object_get(p->want, "results"), (size_t)k), "name");
    if (!is_input(c, name))
        return k;
    if (t->manners[0] == 0)
        snprintf(t->manners, sizeof t->manners, "changes its argument %.*s", (int)strcspn(name, "["), name);
    return -1;
}

/* ---- one case --------------------------------------------------------------------------------------------- */

struct found {
    int wrong, stopped; /* a difference; the code ended                                */
    struct cagd_code_point *point;
    struct pair at;                  /* what was said there                                         */
    int points, ways, proved, empty; /* empty: no case may stay without a point */
    int unfollowed;                  /* the code itself could not be run in the field */
    int whole_line;                  /* where the code makes a whole number of what varies, or 0    */
    struct lab_open open;            /* what is not known of other ways                             */
    char why[300], hole[300];        /* why it is not proved; how the reference failed                 */
};

/* What is compared on a way, by the answer and by the reference. */
static struct lab_compared compared_on(const struct pair *at)
{
    const json_t *both[] = {at->got, at->want}, *row;
    struct lab_compared compared = {0};
    for (int side = 0; side < 2; side++) {
        size_t k;
        json_array_foreach(json_object_get(both[side], "conditions"), k,
                           row) if (*member(row, "polynomial") != 0 && compared.count < LAB_MOST_COMPARED)
        {
            compared.polynomial[compared.count] = member(row, "polynomial");
            compared.holding[compared.count++] = (int)json_integer_value(json_object_get(row, "holding"));
        }
    }
    return compared;
}

/* Whether the results in the field are the same for all inputs that take this way, on which equations may hold; a changed argument is a
 * matter of manners. */
static int same_on_way(const struct lab_case *c, const struct pair *at)
{
    const json_t *a = json_object_get(at->got, "results"), *b = json_object_get(at->want, "results"), *want;
    const struct lab_compared compared = compared_on(at);
    size_t k;
    json_array_foreach(b, k, want)
    {
        const json_t *got = json_array_get(a, k);
        if (is_input(c, member(want, "name")))
            continue;
        if (strcmp(member(got, "name"), member(want, "name")) != 0 ||
            (strcmp(member(got, "field"), member(want, "field")) != 0 &&
             !lab_same_where(member(got, "field"), member(want, "field"), &compared)))
            return 0;
    }
    return json_array_size(a) == json_array_size(b);
}

/* The way in the field. */
static void prove(struct trial *t, const struct lab_case *c, struct lab_ways *w, struct found *f,
                  const struct cagd_code_point *p)
{
    struct pair at = ask_both(t, job_of(c, p, "field", "lab_entry"));
    f->ways++;
    if (finished(at.got) && finished(at.want)) {
        f->proved += same_on_way(c, &at);
        if (f->whole_line == 0)
            f->whole_line = (int)json_integer_value(json_object_get(at.got, "whole"));
        lab_ways_add(w, at.got, at.want, p);
    } else if (f->why[0] == 0) {
        f->unfollowed = finished(at.want);
        snprintf(f->why, sizeof f->why, "%.250s", member(finished(at.got) ? at.want : at.got, "message"));
    }
    forget(&at);
}

/* A variable that outlives the call and is put into, however many calls it takes until that matters. */
static void note_state(struct trial *t, const json_t *outcome)
{
    const char *kept = member(outcome, "kept");
    if (*kept == 0 || t->manners[0] != 0)
        return;
    snprintf(t->manners, sizeof t->manners, "remembers earlier calls: %.100s outlives them, and changes", kept);
    t->manners_line = (int)json_integer_value(json_object_get(outcome, "kept_line"));
}

/* The reference may have no value, where it divides by 0 or the inputs are not those of the lab; otherwise it is at fault. */
static void note_hole(struct found *f, const json_t *want)
{
    const char *end = member(want, "end");
    if (f->hole[0] == 0 && strcmp(end, "outside") != 0 && strcmp(end, "undefined") != 0)
        snprintf(f->hole, sizeof f->hole, "%.250s", member(want, "message"));
}

/* In rationals; 1 when the search is over.  Where the reference has no value nothing is asked. */
static int try_point(struct trial *t, const struct lab_case *c, struct lab_ways *w, struct found *f,
                     struct cagd_code_point *p)
{
    struct pair at = ask_both(t, job_of(c, p, "rational", "lab_entry"));
    if (!finished(at.want)) {
        note_hole(f, at.want);
        forget(&at);
        return 0;
    }
    f->points++;
    f->stopped = !finished(at.got);
    f->wrong = f->stopped || difference_of(t, c, &at) >= 0;
    const char *why = f->stopped ? member(at.got, "message") : "";
    if (strstr(why, "outside an array") != NULL && t->manners[0] == 0) /* wrong, and no manners either */
        snprintf(t->manners, sizeof t->manners, "%s", why);
    if (json_integer_value(json_object_get(at.got, "printed")) > 0 && t->manners[0] == 0 && is_its_own(at.got))
        snprintf(t->manners, sizeof t->manners, "prints");
    note_state(t, at.got);
    if (f->wrong) {
        f->point = cagd_code_point_copy(p);
        f->at = at;
        return 1;
    }
    if (lab_ways_is_new(w, at.got, at.want, p))
        prove(t, c, w, f, p);
    forget(&at);
    return 0;
}

/* How many digits a value has: what is made small. */
static size_t length_of(const char *value)
{
    return strlen(value) + (*value == '-' ? 1u : 0u) + (strchr(value, '/') != NULL ? 2u : 0u);
}

/* One value becomes simpler, if the results still differ. */
static int shrink_one(struct trial *t, const struct lab_case *c, struct found *f, int i, int j, int *left)
{
    static const char *const tries[] = {"0", "1", "2", "3", "-1", "1/2", "1/3"};
    for (size_t k = 0; k<sizeof tries / sizeof *tries && * left> 0; k++) {
        const char *now = f->point->input[i].value[j];
        if (length_of(tries[k]) > length_of(now) ||
            (length_of(tries[k]) == length_of(now) && strcmp(tries[k], now) >= 0))
            continue;
        struct cagd_code_point *other = cagd_code_point_copy(f->point);
        cagd_code_point_set(other, i, j, tries[k]);
        struct pair at = ask_both(t, job_of(c, other, "rational", "lab_entry"));
        --*left;
        if (finished(at.want) && (f->stopped ? !finished(at.got) : finished(at.got) && difference_of(t, c, &at) >= 0)) {
            cagd_code_point_free(f->point);
            forget(&f->at);
            f->point = other;
            f->at = at;
            return 1;
        }
        cagd_code_point_free(other);
        forget(&at);
    }
    return 0;
}

static void shrink(struct trial *t, const struct lab_case *c, struct found *f)
{
    int left = MOST_SHRINKING;
    const char *end = member(f->at.got, "end");
    if (f->stopped && strcmp(end, "undefined") != 0) /* an endless loop is not waited for so often */
        return;
    for (int again = 1; again && left > 0;) {
        again = 0;
        for (int i = 0; i < f->point->inputs; i++)
            for (int j = 0;
                 f->point->input[i].variable && j < (f->point->input[i].count > 0 ? f->point->input[i].count : 1); j++)
                again |= shrink_one(t, c, f, i, j, &left);
    }
}

static void decide(struct trial *t, const struct lab_case *c, struct found *f)
{
    struct lab_ways *w = lab_ways_new(c->h);
    long patterns = cagd_code_patterns(c->h), wanted = FIRST_POINTS > 2 * patterns ? FIRST_POINTS : 2 * patterns;
    int over = 0, fixed = cagd_code_variables(c->h) == 0;
    for (long k = 0, found = 0; !over && k < 10 * wanted && found < (fixed ? 1 : wanted); k++) {
        struct cagd_code_point *p = cagd_code_point_new(c->h, k, 0);
        int before = f->points;
        over = try_point(t, c, w, f, p);
        found += f->points > before;
        cagd_code_point_free(p);
        if (!over && f->points > 0 && f->proved < f->ways && wanted < t->bench->points)
            wanted = t->bench->points; /* what is not proved is tried more often */
    }
    for (struct cagd_code_point *p; !over && (p = lab_ways_next(w)) != NULL; cagd_code_point_free(p))
        over = try_point(t, c, w, f, p);
    f->open = lab_ways_open(w);
    lab_ways_free(w);
    if (f->wrong)
        shrink(t, c, f);
}

/* ---- hints ------------------------------------------------------------------------------------------------ */

/* The wrong solution of that index, ready to be asked; whether it is. */
static int is_built(struct lab_bench *b, size_t index, const json_t *wrong)
{
    char cause[LAB_CAUSE], object[40];
    if (index >= sizeof b->built / sizeof *b->built)
        return 0;
    if (b->built[index] != 0)
        return b->built[index] > 0;
    b->built[index] = -1;
    char *source = lab_wrong_source(b->lab, wrong, cause);
    if (source == NULL)
        return 0;
    snprintf(object, sizeof object, "wrong-%zu.so", index);
    const char *kept = json_string_value(json_object_get(b->kept, source));
    if (kept != NULL)
        snprintf(object, sizeof object, "%s", kept);
    char *errors = kept != NULL ? NULL : lab_build(b->lab, &b->own, &b->own, source, object, NULL);
    if (errors == NULL && lab_player_open(&b->wrong[index], &b->own, b->lab, object) == 0)
        b->built[index] = 1;
    free(errors);
    free(source);
    return b->built[index] > 0;
}

/* Whether the wrong solution says to every job what the submission said. */
static int says_the_same(struct lab_player *wrong, json_t *const job[], json_t *const said[], int count)
{
    for (int k = 0; k < count; k++) {
        lab_ask(wrong, job[k]);
        json_t *answer = lab_answer(wrong);
        int same = answer != NULL && finished(answer) && first_difference(answer, said[k]) < 0;
        json_decref(answer);
        if (!same)
            return 0;
    }
    return 1;
}

/* The known misconception whose results are those of the submission, at the point that was found and at others. */
static json_t *hint_for(struct trial *t, const struct lab_case *c, const struct found *f)
{
    json_t *job[HINT_POINTS + 1], *said[HINT_POINTS + 1], *hint = NULL;
    const char *requirement = member(c->requirement, "name");
    size_t index;
    const json_t *block;
    int count = 0;
    job[count] = job_of(c, f->point, "rational", "lab_entry");
    said[count++] = json_incref(f->at.got);
    for (long k = 0; k < 4 * HINT_POINTS && count <= HINT_POINTS; k++) {
        struct cagd_code_point *p = cagd_code_point_new(c->h, k, 0);
        job[count] = job_of(c, p, "rational", "lab_entry");
        struct pair at = ask_both(t, json_incref(job[count]));
        if (finished(at.want) && finished(at.got))
            said[count++] = json_incref(at.got);
        else
            json_decref(job[count]);
        forget(&at);
        cagd_code_point_free(p);
    }
    json_array_foreach(t->lab->blocks, index, block)
    {
        if (hint != NULL || strcmp(member(block, "kind"), "wrong") != 0 || *lab_text(block, "hint") == 0 ||
            !lab_lists(lab_text(block, "fails"), requirement) || !is_built(t->bench, index, block))
            continue;
        if (says_the_same(&t->bench->wrong[index], job, said, count))
            hint = json_pack("{s:s, s:s, s:s}", "name", member(block, "name"), "text", lab_text(block, "hint"), "zh",
                             lab_text(block, "zh"));
    }
    for (int k = 0; k < count; k++) {
        json_decref(job[k]);
        json_decref(said[k]);
    }
    return hint;
}

/* ---- requirements ------------------------------------------------------------------------------------------ */

static json_t *differences_json(const struct lab_case *c, const struct pair *at)
{
    json_t *list = json_array();
    size_t k;
    const json_t *want;
    json_array_foreach(json_object_get(at->want, "results"), k, want)
    {
        const json_t *got = json_array_get(json_object_get(at->got, "results"), k);
        if (json_array_size(list) == SHOWN || is_input(c, member(want, "name")) ||
            strcmp(member(got, "got"), member(want, "got")) == 0)
            continue;
        json_array_append_new(list, json_pack("{s:s, s:s, s:s}", "name", member(want, "name"), "got",
                                              member(got, "got"), "expected", member(want, "got")));
    }
    return list;
}

/* What became of code that ended, in words. */
static const char *ended(const json_t *outcome, char text[LAB_CAUSE])
{
    const char *end = member(outcome, "end"), *message = member(outcome, "message");
    long line = (long)json_integer_value(json_object_get(outcome, "line"));
    const char *missing = strstr(message, ", which is not in the sources");
    if (missing != NULL) {
        snprintf(text, LAB_CAUSE, "there is no function %.*s", (int)(missing - message - (long)strlen("the function ")),
                 message + strlen("the function "));
        return text;
    }
    if (strcmp(end, "bound") == 0 && strstr(message, "time") != NULL)
        message = "does not come to an end";
    else if (strcmp(end, "undefined") == 0 && strstr(message, "division") != NULL)
        message = "divides by zero";
    if (line > 0)
        snprintf(text, LAB_CAUSE, "%.400s, in line %ld", message, line);
    else
        snprintf(text, LAB_CAUSE, "%.400s", message);
    return text;
}

/* Where a variable goes in a picture: over what is given for it, or over the interval from 0 to 1 and the value at the counterexample; 0
 * where that is one place. */
static int range_of(const struct lab_case *c, const struct cagd_code_point *p, int input, cagd_num_q *from,
                    cagd_num_q *to)
{
    const struct cagd_code_asked_input *in = &c->h->input[input];
    cagd_num_q at = cagd_from_string_q(p->input[input].value[0]), zero = cagd_from_int_q(0), one = cagd_from_int_q(1);
    *from = cagd_compare_q(at, zero) < 0 ? at : zero, *to = cagd_compare_q(at, one) > 0 ? at : one;
    if (in->shape == CAGD_CODE_BETWEEN)
        *from = cagd_code_evaluate(in->low, p, NULL, zero), *to = cagd_code_evaluate(in->high, p, NULL, zero);
    return from->at != NULL && to->at != NULL && cagd_compare_q(*from, *to) < 0;
}

/* The value of the result of that name; null where there is none. */
static json_t *value_named(const json_t *outcome, const char *name)
{
    size_t k;
    const json_t *row;
    if (finished(outcome))
        json_array_foreach(json_object_get(outcome, "results"), k,
                           row) if (strcmp(member(row, "name"), name) == 0) return json_string(member(row, "got"));
    return json_null();
}

/* The results of that name where the input is x. */
static void put_sample(struct trial *t, const struct lab_case *c, const struct cagd_code_point *point, int input,
                       cagd_num_q x, const char *name, json_t *at, json_t *got, json_t *wanted)
{
    struct cagd_code_point *p = cagd_code_point_copy(point);
    cagd_code_point_set(p, input, 0, cagd_to_string_q(x));
    struct pair both = ask_both(t, job_of(c, p, "rational", "lab_entry"));
    json_array_append_new(at, json_string(p->input[input].value[0]));
    json_array_append_new(got, value_named(both.got, name));
    json_array_append_new(wanted, value_named(both.want, name));
    forget(&both);
    cagd_code_point_free(p);
}

/* What a picture of the difference shows: the first result that differs over the last input that is a single variable; where there is no
 * such input, all results in their order. */
static json_t *graph_of(struct trial *t, const struct lab_case *c, const struct found *f)
{
    enum { SAMPLES = 32 };
    json_t *at = json_array(), *got = json_array(), *wanted = json_array();
    const json_t *results = json_object_get(f->at.want, "results"), *row;
    int first = first_difference(f->at.got, f->at.want), over = -1;
    const char *name = member(json_array_get(results, first >= 0 ? (size_t)first : 0), "name");
    cagd_region_mark mark = cagd_region_open();
    cagd_num_q from = {NULL}, to = {NULL};
    for (int i = 0; i < c->h->inputs; i++)
        over = f->point->input[i].variable && f->point->input[i].count == 0 ? i : over;
    if (over >= 0 && range_of(c, f->point, over, &from, &to)) {
        cagd_num_q x = from, here = cagd_from_string_q(f->point->input[over].value[0]);
        for (int k = 0; k <= SAMPLES; k++) {
            cagd_num_q end = cagd_add_q(from, cagd_mul_q(cagd_sub_q(to, from), cagd_from_ratio_q(k, SAMPLES)));
            if (k > 0 && cagd_compare_q(x, here) < 0 && cagd_compare_q(here, end) < 0)
                put_sample(t, c, f->point, over, here, name, at, got, wanted);
            put_sample(t, c, f->point, over, end, name, at, got, wanted);
            x = end;
        }
    } else {
        size_t k;
        over = -1;
        json_array_foreach(results, k, row) if (!is_input(c, member(row, "name")))
        {
            json_array_append_new(at, json_string(cagd_to_string_q(cagd_from_int_q((long)json_array_size(at)))));
            json_array_append_new(got, value_named(f->at.got, member(row, "name")));
            json_array_append_new(wanted, value_named(f->at.want, member(row, "name")));
        }
    }
    cagd_region_drop(mark);
    json_t *graph = json_pack("{s:s, s:s, s:o, s:o, s:o}", "of", name, "over",
                              over >= 0 ? f->point->input[over].name : "", "at", at, "got", got, "expected", wanted);
    if (graph != NULL && over >= 0)
        json_object_set_new(graph, "here", json_string(f->point->input[over].value[0]));
    return graph;
}

/* ---- levels of a triangle ------------------------------------------------------------------------------------ */

/* The answer with its results noted, and the points of the triangles, at the point. */
static struct pair with_levels(struct trial *t, const struct lab_case *c, const struct cagd_code_point *p)
{
    json_t *job = job_of(c, p, "rational", "lab_entry");
    json_object_set_new(job, "note", json_true());
    return ask(t, job, job_of(c, p, "rational", "lab_levels"));
}

/* How far the answer comes at a point, if it is wrong there: whether it is. */
static int reach_at(struct trial *t, const struct lab_case *c, const struct cagd_code_point *p, struct lab_reached *r)
{
    struct pair at = ask_both(t, job_of(c, p, "rational", "lab_entry"));
    int wrong = finished(at.got) && finished(at.want) && first_difference(at.got, at.want) >= 0;
    forget(&at);
    if (!wrong)
        return 0;
    at = with_levels(t, c, p);
    wrong = finished(at.got) && finished(at.want);
    if (wrong)
        *r = lab_reach(c, p, at.got, at.want, NULL);
    forget(&at);
    return wrong;
}

/* How far a wrong answer comes for numbers of many digits: where two draws tell something, and the same.  Numbers of a triangle
 * may be 0 for some draws; where none is computed it is not asked again. */
static struct lab_reached reach(struct trial *t, const struct lab_case *c)
{
    enum { DRAWS = 12 };
    const struct lab_reached nothing = {-1, 0, 0, -1, -1, 0, 0};
    struct lab_reached first = nothing, r = nothing;
    for (int k = 0, told = 1; k < DRAWS && told > 0 && json_array_size(c->points) > 0; k++) {
        struct cagd_code_point *p = cagd_code_point_new(c->h, k * cagd_code_patterns(c->h), 1);
        int wrong = reach_at(t, c, p, &r);
        cagd_code_point_free(p);
        if (!wrong)
            continue;
        told = r.told;
        if (r.triangle >= 0 && first.triangle >= 0)
            return r.triangle == first.triangle && r.missing == first.missing ? first : nothing;
        if (r.triangle >= 0)
            first = r;
    }
    return nothing;
}

/* The triangles that a right answer computes wholly are noted. */
static void note_whole(struct trial *t, const struct lab_case *c)
{
    struct cagd_code_point *p = cagd_code_point_new(c->h, 0, 1);
    struct pair levels = with_levels(t, c, p);
    if (finished(levels.got) && finished(levels.want))
        lab_reach(c, p, levels.got, levels.want, t->bench->whole);
    forget(&levels);
    cagd_code_point_free(p);
}

/* In words, with the numbers at that point; whether they are told. */
static int tell_reached(struct trial *t, const struct lab_case *c, const struct lab_reached *r,
                        const struct cagd_code_point *p, int names_inputs, char text[LAB_CAUSE])
{
    struct pair at = with_levels(t, c, p);
    int told =
        lab_tell_reached(c, r, finished(at.got) && finished(at.want) ? p : NULL, names_inputs, at.got, at.want, text);
    forget(&at);
    return told;
}

/* Which levels are computed: in the case of the counterexample or, where that is too small to tell, in the last of the requirement; with
 * the numbers of the counterexample or, where some of them are equal by chance, of a draw. */
static void tell_levels(struct trial *t, const struct lab_case *c, const struct found *f, json_t *row)
{
    enum { DRAWS = 4 };
    char text[LAB_CAUSE], whole[LAB_CAUSE + 80];
    const struct lab_case *of = c;
    struct lab_reached r = reach(t, c);
    if (r.triangle < 0) {
        while (of + 1 < t->lab->at + t->lab->cases && of[1].requirement == c->requirement)
            of++;
        if (of == c || (r = reach(t, of)).triangle < 0)
            return;
    }
    int told = of == c && tell_reached(t, c, &r, f->point, 0, text);
    for (long k = 0; !told && k < DRAWS; k++) {
        struct cagd_code_point *p = cagd_code_point_new(of->h, k, 0);
        told = tell_reached(t, of, &r, p, 1, text);
        cagd_code_point_free(p);
    }
    snprintf(whole, sizeof whole, "%s%s%s%s", of != c ? "for " : "", of != c ? of->label : "", of != c ? ": " : "",
             text);
    json_object_set_new(row, "levels", json_string(whole));
}

static void tell_wrong(struct trial *t, const struct lab_case *c, const struct found *f, json_t *row)
{
    char text[LAB_CAUSE];
    json_object_set_new(row, "verdict", json_string(f->stopped ? "stopped" : "wrong"));
    json_object_set_new(row, "case", json_string(c->label));
    json_object_set_new(row, "inputs", point_json(f->point));
    if (f->stopped) {
        json_object_set_new(row, "text", json_string(ended(f->at.got, text)));
        json_object_set(row, "line", json_object_get(f->at.got, "line"));
        return;
    }
    json_object_set_new(row, "text", json_string("another result"));
    json_object_set_new(row, "differences", differences_json(c, &f->at));
    if (t->bench->draws)
        json_object_set_new(row, "graph", graph_of(t, c, f));
    tell_levels(t, c, f, row);
    json_t *hint = hint_for(t, c, f);
    if (hint != NULL)
        json_object_set_new(row, "hint", hint);
}

/* Why it is not known for all inputs that the answer is right. */
static void tell_open(const struct found *sum, char text[LAB_CAUSE])
{
    const struct lab_open *open = &sum->open;
    if (sum->why[0] != 0)
        snprintf(text, LAB_CAUSE, "%s", sum->why);
    else if (open->line > 0)
        snprintf(text, LAB_CAUSE, "line %d: whether any numbers take the other way%s%s is not known", open->line,
                 strlen(open->compared) < SHORT ? " than " : "", strlen(open->compared) < SHORT ? open->compared : "");
    else if (open->branches > 0)
        snprintf(text, LAB_CAUSE, "not every way through the code and the reference was met, or is known to be none");
    else if (open->undecided > 0)
        snprintf(text, LAB_CAUSE, "there are more ways through the code than were followed");
    else
        snprintf(text, LAB_CAUSE,
                 "on %d of %d ways the results agree at the points that were tried, and not as functions",
                 sum->ways - sum->proved, sum->ways);
}

/* What is right in all cases that were tried, but not known for all inputs, has points only where the lab says that this is enough. */
static void tell_right(const struct lab_case *first, const struct lab_case *last, const struct found *sum, json_t *row)
{
    char text[LAB_CAUSE], because[LAB_CAUSE], range[140] = "";
    const struct lab_open *open = &sum->open;
    int proved = sum->ways > 0 && sum->proved == sum->ways && open->undecided == 0 && open->branches == 0,
        fixed = cagd_code_variables(first->h) == 0 && first == last && sum->points > 0,
        enough = strcmp(lab_text(first->requirement, "enough"), "cases") == 0;
    if (first != last)
        snprintf(range, sizeof range, ", %s to %s", first->label, last->label);
    const char *where = open->denominators > 0 ? ", where it has a value: no division by 0 was found" : "";
    if (fixed)
        snprintf(text, sizeof text, "right, decided exactly");
    else if (proved && open->conditions == 0)
        snprintf(text, sizeof text, "right for all inputs%s%s", range, where);
    else if (proved)
        snprintf(text, sizeof text, "right for all inputs%s, on each of the %d ways that there are%s", range, sum->ways,
                 where);
    else
        snprintf(text, sizeof text, "right in %d exact cases%s%s", sum->points, range,
                 enough ? "" : "; its points wait for a person");
    /* which whole number it is may be any of infinitely many: what each of them leads to is not seen by trying some */
    int untried = sum->whole_line > 0 && !proved;
    if (sum->empty > 0)
        snprintf(text, sizeof text, "no numbers were found for which the reference has a result");
    else if (untried)
        snprintf(text, sizeof text, "a whole number is made of a number, and not all that it can be were tried");
    else if (sum->unfollowed)
        snprintf(text, sizeof text, "right in %d exact cases%s, but not followed for all inputs", sum->points, range);
    int known = fixed || proved || enough;
    json_object_set_new(row, "verdict",
                        json_string(sum->empty > 0 || untried || sum->unfollowed || !known ? "undecided"
                                    : fixed || proved                                      ? "proved"
                                                                                           : "sampled"));
    json_object_set_new(row, "text", json_string(text));
    if (untried)
        json_object_set_new(row, "line", json_integer(sum->whole_line));
    if (!fixed && !proved && sum->empty == 0 && !untried) {
        tell_open(sum, because);
        json_object_set_new(row, "because", json_string(because));
    }
    if (sum->hole[0] != 0)
        json_object_set_new(row, "reference", json_string(sum->hole));
}

/* The same call again, and behind other calls: nothing may be kept. */
static void look_for_state(struct trial *t, const struct lab_case *c)
{
    struct cagd_code_point *before = cagd_code_point_new(t->lab->at[c->earlier].h, 0, 0),
                           *p = cagd_code_point_new(c->h, 1, 0);
    json_t *job = job_of(c, p, "rational", "lab_again"),
           *other = c->earlier != c->number ? job_of(&t->lab->at[c->earlier], before, "rational", "lab_again") : NULL;
    json_array_append_new(t->jobs, job_of(c, p, "rational", "lab_entry"));
    if (other != NULL)
        json_array_extend(json_object_get(job, "inputs"), json_object_get(other, "inputs"));
    struct pair at = ask_both(t, job);
    if (finished(at.want) && t->manners[0] == 0 && (!finished(at.got) || first_difference(at.got, at.want) >= 0))
        snprintf(t->manners, sizeof t->manners, "remembers earlier calls: the same call has another result");
    note_state(t, at.got);
    forget(&at);
    json_decref(other);
    cagd_code_point_free(before);
    cagd_code_point_free(p);
}

/* The cases from `k` on that belong to the requirement; the index behind them. */
static int judge_requirement(struct trial *t, int k, json_t *row)
{
    const struct lab *lab = t->lab;
    const struct lab_case *first = &lab->at[k], *last = first;
    struct found sum = {0};
    int wrong = 0, stopped = 0;
    for (; k < lab->cases && lab->at[k].requirement == first->requirement; k++) {
        struct found f = {0};
        if (wrong)
            continue;
        last = &lab->at[k];
        decide(t, last, &f);
        sum.points += f.points, sum.ways += f.ways, sum.proved += f.proved;
        sum.open.conditions += f.open.conditions, sum.open.undecided += f.open.undecided;
        sum.open.branches += f.open.branches, sum.open.denominators += f.open.denominators;
        if (sum.open.line == 0) {
            sum.open.line = f.open.line;
            memcpy(sum.open.compared, f.open.compared, sizeof sum.open.compared);
        }
        sum.empty += f.points == 0;
        sum.unfollowed |= f.unfollowed;
        if (sum.whole_line == 0)
            sum.whole_line = f.whole_line;
        if (sum.why[0] == 0)
            memcpy(sum.why, f.why, sizeof sum.why);
        if (sum.hole[0] == 0)
            memcpy(sum.hole, f.hole, sizeof sum.hole);
        if (f.wrong) {
            tell_wrong(t, last, &f, row);
            cagd_code_point_free(f.point);
            forget(&f.at);
            wrong = 1, stopped = f.stopped;
        }
    }
    if (!wrong) {
        tell_right(first, last, &sum, row);
        if (t->bench->whole != NULL && json_array_size(last->points) > 0)
            note_whole(t, last);
        look_for_state(t, last);
    } else if (!stopped || strstr(member(row, "text"), "end") == NULL) { /* what has no end is not run once more */
        struct cagd_code_point *p = cagd_code_point_new(last->h, 0, 0);
        json_array_append_new(t->jobs, job_of(last, p, "rational", "lab_entry"));
        cagd_code_point_free(p);
    }
    return k;
}

/* ---- rounding and cost ---------------------------------------------------------------------------------------- */

static double worst_of(const json_t *outcome)
{
    double worst = 0;
    size_t k;
    const json_t *row;
    json_array_foreach(json_object_get(outcome, "results"), k, row)
    {
        double ulps = json_real_value(json_object_get(row, "ulps"));
        worst = ulps > worst ? ulps : worst;
    }
    return worst;
}

/* Ulps at worst, and operations, in the last case of the lab. */
struct cost {
    double ulps;
    json_int_t operations;
    int runs;
};

/* Whether each of its results is a number in binary64. */
static int keeps_numbers(const json_t *outcome)
{
    size_t k;
    const json_t *row;
    json_array_foreach(json_object_get(outcome, "results"), k, row) if (json_object_get(row, "lost") != NULL) return 0;
    return 1;
}

static void add_run(struct cost *c, const json_t *outcome)
{
    if (outcome == NULL || !finished(outcome) || !keeps_numbers(outcome))
        return;
    c->ulps = worst_of(outcome) > c->ulps ? worst_of(outcome) : c->ulps;
    c->operations = json_integer_value(json_object_get(outcome, "operations"));
    c->runs++;
}

/* The same numbers for everybody, until a run has no number for its result. */
static void add_runs(const struct lab *lab, struct lab_player *player, struct cost *cost)
{
    const struct lab_case *c = &lab->at[lab->cases - 1];
    for (long k = 0; k < ROUNDED && cost->runs == k; k++) {
        struct cagd_code_point *p = cagd_code_point_new(c->h, k, 1);
        json_t *job = job_of(c, p, "rounding", "lab_entry");
        lab_ask(player, job);
        json_t *answer = lab_answer(player);
        add_run(cost, answer);
        json_decref(answer);
        json_decref(job);
        cagd_code_point_free(p);
    }
}

/* The least of each; what does not run to its end everywhere is not counted. */
static void take_best(struct lab_bench *b, const struct cost *cost)
{
    if (cost->runs < ROUNDED)
        return;
    int first = !b->best.is_known;
    b->best.ulps = first || cost->ulps < b->best.ulps ? cost->ulps : b->best.ulps;
    b->best.operations = first || cost->operations < b->best.operations ? (long)cost->operations : b->best.operations;
    b->best.is_known = 1;
}

static void add_solution(struct lab_bench *b, const char *name, int number)
{
    char path[LAB_MOST_PATH + 300], object[40];
    struct lab_player player;
    struct cost cost = {0};
    snprintf(path, sizeof path, "%s/right/%s", b->lab->folder, name);
    snprintf(object, sizeof object, "right-%d.so", number);
    char *source = lab_file(path),
         *errors = source != NULL ? lab_build(b->lab, &b->own, &b->own, source, object, NULL) : NULL;
    if (source != NULL && errors == NULL && lab_player_open(&player, &b->own, b->lab, object) == 0) {
        add_runs(b->lab, &player, &cost);
        lab_player_close(&player);
    }
    take_best(b, &cost);
    free(errors);
    free(source);
}

/* The names of the right solutions that the lab has, and their texts as one; the caller frees both. */
static char *solutions(const struct lab *lab, struct dirent ***entry, int *count)
{
    char path[LAB_MOST_PATH + 300], *all = NULL;
    size_t size;
    FILE *out = open_memstream(&all, &size);
    snprintf(path, sizeof path, "%s/right", lab->folder);
    *entry = NULL;
    *count = scandir(path, entry, NULL, alphasort);
    for (int k = 0; k < *count && k < MOST_SOLUTIONS; k++) {
        snprintf(path, sizeof path, "%s/right/%s", lab->folder, (*entry)[k]->d_name);
        char *source = lab_file(path);
        fprintf(out, "%s\n%s\n", (*entry)[k]->d_name, source != NULL ? source : "");
        free(source);
    }
    fclose(out);
    return all;
}

/* The file in the place of what is the best known, read, or written. */
static int read_best(struct lab_bench *b, const char *path)
{
    FILE *in = fopen(path, "r");
    int good = in != NULL && fscanf(in, "%lf %ld", &b->best.ulps, &b->best.operations) == 2;
    if (in != NULL)
        fclose(in);
    b->best.is_known = good;
    return good;
}

static void write_best(const struct lab_bench *b, const char *path)
{
    FILE *out = fopen(path, "w");
    if (out == NULL)
        return;
    fprintf(out, "%.17g %ld\n", b->best.ulps, b->best.operations);
    fclose(out);
}

/* What is the best known: of the reference and of the right solutions that the lab has. */
static void find_best(struct lab_bench *b)
{
    char path[LAB_MOST_PATH + 16];
    struct cost cost = {0};
    struct dirent **entry;
    int count;
    char *texts = solutions(b->lab, &entry, &count), *made_of = lab_with_driver(&b->own, texts);
    snprintf(path, sizeof path, "%s/best", b->own.folder);
    if (!lab_take_kept(&b->own, "best", made_of) || !read_best(b, path)) {
        add_runs(b->lab, &b->right, &cost);
        take_best(b, &cost);
        for (int k = 0; k < count && k < MOST_SOLUTIONS; k++)
            if (entry[k]->d_name[0] != '.')
                add_solution(b, entry[k]->d_name, k);
        if (b->best.is_known) {
            write_best(b, path);
            lab_keep(&b->own, "best", made_of);
        }
    }
    for (int k = 0; k < count; k++)
        free(entry[k]);
    free(entry);
    free(texts);
    free(made_of);
}

/* It is stable where it loses no decimal digit more than the best known does at these numbers: its error is less than ten times as large, or
 * than ten ulps.  NULL where at some of them no number comes out. */
static json_t *measure(struct trial *t)
{
    enum { DIGIT = 10 };
    struct cost ours = {0};
    add_runs(t->lab, &t->student, &ours);
    if (ours.runs < ROUNDED)
        return NULL;
    if (!t->bench->best.is_known)
        find_best(t->bench);
    int none = !t->bench->best.is_known;
    double best = none || ours.ulps < t->bench->best.ulps ? ours.ulps : t->bench->best.ulps,
           least = best > 1 ? best : 1;
    json_int_t operations = t->bench->best.operations;
    if (none || ours.operations < operations)
        operations = ours.operations;
    return json_pack("{s:s, s:i, s:f, s:f, s:b, s:I, s:I}", "case", t->lab->at[t->lab->cases - 1].label, "points",
                     ROUNDED, "ulps", ours.ulps, "best_ulps", best, "stable", ours.ulps < DIGIT * least, "operations",
                     ours.operations, "best_operations", operations);
}

static void tell_measured(struct trial *t, json_t *result)
{
    json_t *measured = measure(t);
    if (measured != NULL)
        json_object_set_new(result, "measured", measured);
    else
        json_array_append_new(
            json_object_get(result, "notes"),
            json_pack("{s:i, s:s}", "line", 0, "text",
                      "in binary64 no number comes out at some point that was drawn, where exactly one does"));
}

/* Where rounding turns a comparison, so that the result is another one exactly, in no way the fault of the last digits: told, as exact
 * arithmetic does not see it. */
static void look_for_turns(struct trial *t, json_t *notes)
{
    enum { POINTS = 3 };
    for (int k = 0; k < t->lab->cases; k++) {
        const struct lab_case *c = &t->lab->at[k];
        if (k + 1 < t->lab->cases && t->lab->at[k + 1].requirement == c->requirement)
            continue;
        for (long j = 0; j < POINTS; j++) {
            struct cagd_code_point *p = cagd_code_point_new(c->h, j, 1);
            struct pair at = ask_both(t, job_of(c, p, "rounding", "lab_entry"));
            int turned = finished(at.got) && finished(at.want) && json_is_integer(json_object_get(at.got, "turned")) &&
                         first_difference(at.got, at.want) >= 0;
            json_int_t line = json_integer_value(json_object_get(at.got, "turned"));
            forget(&at);
            cagd_code_point_free(p);
            if (turned) {
                json_array_append_new(notes, json_pack("{s:I, s:s}", "line", line, "text",
                                                       "in binary64 this comparison goes another way than exactly, and "
                                                       "the result is another one"));
                return;
            }
        }
    }
}

/* ---- a submission -------------------------------------------------------------------------------------------- */

static json_t *blank(const json_t *requirement)
{
    return json_pack("{s:s, s:s, s:s, s:i, s:i}", "name", member(requirement, "name"), "title",
                     lab_text(requirement, "title"), "zh", lab_text(requirement, "zh"), "points", 0, "of",
                     lab_points(requirement));
}

static void mark(json_t *result)
{
    json_int_t points = 0, of = 0;
    size_t k;
    json_t *row;
    json_array_foreach(json_object_get(result, "requirements"), k, row)
    {
        const char *verdict = member(row, "verdict");
        if (strcmp(verdict, "proved") == 0 || strcmp(verdict, "sampled") == 0 || strcmp(verdict, "clean") == 0)
            json_object_set(row, "points", json_object_get(row, "of"));
        points += json_integer_value(json_object_get(row, "points"));
        of += json_integer_value(json_object_get(row, "of"));
    }
    json_object_set_new(result, "points", json_integer(points));
    json_object_set_new(result, "of", json_integer(of));
}

/* Requirements one by one; then what is asked of the whole code. */
static void judge_all(struct trial *t, json_t *rows)
{
    size_t k;
    const json_t *block;
    int at = 0, wrong = 0;
    json_array_foreach(t->lab->blocks, k, block)
    {
        if (strcmp(member(block, "kind"), "requirement") != 0 || json_object_get(block, "call") == NULL)
            continue;
        json_t *row = blank(block);
        at = judge_requirement(t, at, row);
        wrong += json_object_get(row, "case") != NULL;
        json_array_append_new(rows, row);
    }
    json_t *report = lab_sanitize(t->lab, &t->place, &t->bench->own, t->jobs);
    if (report == NULL && wrong == 0 && t->manners[0] == 0) /* otherwise it was said where it mattered */
        report = t->unset[0] != 0 ? json_pack("{s:i, s:s}", "line", t->unset_line, "text", t->unset)
                                  : lab_look_for_values(t->lab, &t->place, &t->bench->own, t->jobs);
    if (report != NULL) {
        snprintf(t->manners, sizeof t->manners, "%s", member(report, "text"));
        t->manners_line = (int)json_integer_value(json_object_get(report, "line"));
    }
    json_decref(report);
    json_array_foreach(t->lab->blocks, k, block)
    {
        if (strcmp(member(block, "kind"), "requirement") != 0 || json_object_get(block, "call") != NULL)
            continue;
        /* who has computed nothing has not behaved well either */
        int nothing = wrong == (int)json_array_size(rows), bad = t->manners[0] != 0;
        json_t *row = blank(block);
        json_object_set_new(row, "verdict", json_string(bad || nothing ? "unclean" : "clean"));
        json_object_set_new(row, "text",
                            json_string(bad       ? t->manners
                                        : nothing ? "nothing is right yet"
                                                  : "nothing was seen"));
        if (t->manners_line > 0)
            json_object_set_new(row, "line", json_integer(t->manners_line));
        json_array_append_new(rows, row);
        break;
    }
}

/* Nothing was run: why. */
static void tell_refused(const struct lab *lab, json_t *rows, const char *verdict, const char *text)
{
    size_t k;
    const json_t *block;
    json_array_foreach(lab->blocks, k, block) if (strcmp(member(block, "kind"), "requirement") == 0)
    {
        json_t *row = blank(block);
        json_object_set_new(row, "verdict", json_string(verdict));
        json_object_set_new(row, "text", json_string(k == 0 ? text : ""));
        json_array_append_new(rows, row);
    }
    (void)text;
}

static char *prepare(struct trial *t, const char *source, json_t *result)
{
    enum lab_reason reason = LAB_NO_REASON;
    char *errors = lab_build(t->lab, &t->place, &t->bench->own, source, "student.so", &reason);
    if (reason != LAB_NO_REASON) {
        json_object_set_new(result, reason == LAB_REFUSED ? "refused" : "compiler", json_string(errors));
        json_object_set_new(result, "notes", json_array());
        return errors;
    }
    json_t *seen = lab_inspect(t->lab, &t->place);
    const char *compiler = member(seen, "compiler"), *refused = member(seen, "refused");
    const json_t *unset = json_object_get(seen, "unset");
    if (unset != NULL) {
        snprintf(t->unset, sizeof t->unset, "uses %.100s, which has no value yet", member(unset, "name"));
        t->unset_line = (int)json_integer_value(json_object_get(unset, "line"));
    }
    json_object_set(result, "notes", json_object_get(seen, "notes"));
    if (*compiler != 0 || (*refused == 0 && errors != NULL)) {
        free(errors == NULL || *compiler != 0 ? errors : NULL);
        errors = *compiler != 0 ? strdup(compiler) : errors;
        json_object_set_new(result, "compiler", json_string(errors));
    } else if (*refused != 0) {
        free(errors);
        errors = strdup(refused);
        json_object_set_new(result, "refused", json_string(errors));
    }
    json_decref(seen);
    return errors;
}

/* The object of an answer stays, for the case that it is one of the wrong solutions of the lab. */
static void keep_object(struct trial *t, const char *source)
{
    char from[LAB_MOST_PATH + 32], to[LAB_MOST_PATH + 64], name[40];
    snprintf(name, sizeof name, "kept-%zu.so", json_object_size(t->bench->kept));
    snprintf(from, sizeof from, "%s/student.so", t->place.folder);
    snprintf(to, sizeof to, "%s/%s", t->bench->own.folder, name);
    if (!lab_is_python(t->lab, "student.so") && link(from, to) == 0)
        json_object_set_new(t->bench->kept, source, json_string(name));
}

json_t *lab_judge(struct lab_bench *b, const char *source, int shut)
{
    struct trial t = {.bench = b, .lab = b->lab, .jobs = json_array()};
    json_t *rows = json_array(),
           *result = json_pack("{s:s, s:s, s:s, s:o}", "schema", "cagd-lab-1", "lab", b->lab->name, "title",
                               lab_text(b->lab->head, "title"), "requirements", rows);
    if (lab_place_open(&t.place, shut) != 0) {
        tell_refused(b->lab, rows, "refused", strerror(errno));
        json_object_set_new(result, "refused", json_string("there is no temporary folder"));
    } else {
        char *errors = prepare(&t, source, result);
        if (errors != NULL) {
            tell_refused(b->lab, rows, json_object_get(result, "refused") != NULL ? "refused" : "not compiled", errors);
        } else if (lab_player_open(&t.student, &t.place, b->lab, "student.so") == 0) {
            if (b->kept != NULL)
                keep_object(&t, source);
            judge_all(&t, rows);
            mark(result);
            if (json_equal(json_object_get(result, "points"), json_object_get(result, "of"))) {
                tell_measured(&t, result);
                look_for_turns(&t, json_object_get(result, "notes"));
            }
            lab_player_close(&t.student);
        }
        free(errors);
        lab_place_close(&t.place);
    }
    mark(result);
    json_decref(t.jobs);
    return result;
}

int lab_bench_open(struct lab_bench *b, const struct lab *lab, int keeps, char cause[LAB_CAUSE])
{
    char path[LAB_MOST_PATH + 32];
    *b = (struct lab_bench){.lab = lab, .points = 24, .known = json_object()};
    snprintf(path, sizeof path, "%s/reference.c", lab->folder);
    char *source = lab_file(path);
    if (source == NULL || lab_place_open(&b->own, 0) != 0) {
        snprintf(cause, LAB_CAUSE, "reference.c: %s", strerror(errno));
        free(source);
        return -1;
    }
    if (keeps)
        lab_keep_for(&b->own, lab);
    char *with_levels = NULL, *errors = lab_build_driver(lab, &b->own);
    size_t size;
    FILE *out = open_memstream(&with_levels, &size);
    fputs(source, out);
    lab_write_levels(lab, out);
    lab_write_formulas(lab, out);
    fclose(out);
    if (errors == NULL)
        errors = lab_build(lab, &b->own, &b->own, with_levels, "reference.so", NULL);
    free(with_levels);
    free(source);
    if (errors == NULL && lab_player_open(&b->right, &b->own, lab, "reference.so") == 0)
        return 0;
    snprintf(cause, LAB_CAUSE, "reference.c: %.500s", errors != NULL ? errors : "cannot be started");
    json_decref(b->known);
    free(errors);
    lab_place_close(&b->own);
    return -1;
}

void lab_bench_close(struct lab_bench *b)
{
    lab_player_close(&b->right);
    for (size_t k = 0; k < sizeof b->wrong / sizeof *b->wrong; k++)
        lab_player_close(&b->wrong[k]);
    json_decref(b->known);
    json_decref(b->kept);
    json_decref(b->whole);
    lab_place_close(&b->own);
}
