/* witness.c -- at what a claim fails: the data of the case, and the smallest instance, which a reader copies to make a
 * counterexample of it. */
#include "chapters/judge/witness.h"

#include "chapters/judge/case.h"
#include "chapters/judge/memory_text.h"
#include "chapters/judge/words.h"
#include "core/clock.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_INPUTS = 4096, MOST_RUNS = 400, LARGEST_RANK = 6, DRAWS = 24 };
static const double MOST_SECONDS = 2;

/* The number of that rank among those of its kind, simplest first:
 *
 *     any        0, 1, -1, 2, -2, ...           positive   1, 2, 1/2, 3, 1/3, ...
 *     in (0, 1)  1/2, 1/3, 2/3, 1/4, 2/4, ...   whole      low, low + 1, ..., high */
static num_q simple_number(const struct small_input *in)
{
    int r = in->rank, half = (r + 1) / 2, below = 2;
    switch (in->kind) {
    case ANY_NUMBER:
        return from_int_q(r % 2 == 1 ? half : -half);
    case POSITIVE_NUMBER:
        return r % 2 == 1 ? from_int_q(half + 1) : from_ratio_q(1, half + 1);
    case PARAMETER:
    case FRACTION:
        for (; r >= below - 1; below++)
            r -= below - 1;
        return from_ratio_q(r + 1, below);
    default:
        return from_int_q(in->low + r > in->high ? in->high : in->low + r);
    }
}

static void write_down(struct small_input *in, const char *name, int index, num_q a)
{
    snprintf(in->name, sizeof in->name, "%s", name);
    in->index = index;
    free(in->value);
    in->value = strdup(to_string_q(a));
    if (in->value == NULL)
        abort();
}

static struct small_data no_data(void)
{
    struct small_data d = {.at = calloc(MOST_INPUTS, sizeof *d.at)};
    if (d.at == NULL)
        abort();
    return d;
}

static void free_data(struct small_data *d)
{
    for (int k = 0; k < MOST_INPUTS; k++)
        free(d->at[k].value);
    free(d->at);
}

num_q small_number(trial *T, const char *name, int index, enum input_kind kind, int low, int high)
{
    struct small_data *s = T->small;
    if (s->next == MOST_INPUTS)
        return from_int_q(1);
    struct small_input *in = &s->at[s->next++];
    if (s->next > s->count) {
        s->count = s->next;
        in->rank = s->largest > 0 ? pick(&s->draws, 0, s->largest) : 0;
    }
    in->kind = kind, in->low = low, in->high = high;
    num_q a = simple_number(in);
    write_down(in, name, index, a);
    return a;
}

void keep_input(trial *T, const char *name, int index, num_q a)
{
    struct small_data *s = T->small;
    if (s->next == MOST_INPUTS)
        return;
    write_down(&s->at[s->next++], name, index, a);
    s->count = s->next;
}

/* ---- the search ------------------------------------------------------------------------------------ */

struct search {
    struct plan plan;
    struct small_data data;
    int which; /* the case: it has the degree */
    int runs;
    double end;
};

static int is_over(const struct search *s) { return s->runs >= MOST_RUNS || cagd_seconds() > s->end; }

/* Whether the claim fails with these data, by comparison; then *T is the case, whose exhibits the caller frees. */
static int fails(struct search *s, trial *T)
{
    s->runs++;
    s->data.next = 0;
    *T = run_case(&s->plan, s->which, 0, NULL, NULL);
    outcome o = judged_case(T);
    if (o == FAILS && region_faults == 0 && T->compared > 0 && !T->mistaken)
        return 1;
    forget_exhibits(T->shown, T->exhibits);
    return 0;
}

/* Draws larger and larger numbers until the claim fails; once where it asks for none. */
static int draw(struct search *s, trial *T)
{
    for (int largest = 0; largest <= LARGEST_RANK; largest++)
        for (int k = 0; k < (largest == 0 ? 1 : DRAWS) && !is_over(s); k++) {
            s->data.count = 0;
            s->data.largest = largest;
            if (fails(s, T))
                return 1;
            if (s->data.count == 0)
                return 0;
        }
    return 0;
}

/* Puts the simplest number in the place of each for which it still fails. */
static void simplify(struct search *s, trial *T)
{
    for (int changed = 1; changed && !is_over(s);) {
        changed = 0;
        for (int k = 0; k < s->data.count; k++) {
            struct small_input *in = &s->data.at[k];
            for (int had = in->rank, rank = 0; rank < had && !is_over(s); rank++) {
                trial other;
                in->rank = rank;
                if (fails(s, &other)) {
                    forget_exhibits(T->shown, T->exhibits);
                    *T = other;
                    changed = 1;
                    break;
                }
                in->rank = had;
            }
        }
    }
    forget_exhibits(T->shown, T->exhibits);
    (void)fails(s, T); /* the values of the last change that was kept, and no more of them */
    s->data.count = s->data.next;
}

/* ---- what is told ---------------------------------------------------------------------------------- */

/* The numbers that one name has, for the indices i, i + 1, ...: "P = 1, 0", "w2, w3 = 1, 2". */
static int show_inputs(trial *out, const struct small_data *d, int k)
{
    int end = k + 1, first = d->at[k].index;
    while (end < d->count && strcmp(d->at[end].name, d->at[k].name) == 0 && first >= 0 &&
           d->at[end].index == first + (end - k))
        end++;
    char name[64];
    if (first < 0)
        snprintf(name, sizeof name, "%s", d->at[k].name);
    else if (end == k + 1)
        snprintf(name, sizeof name, "%s%d", d->at[k].name, first);
    else
        snprintf(name, sizeof name, "%s%d to %s%d", d->at[k].name, first, d->at[k].name, first + end - k - 1);
    char *text = NULL;
    size_t room;
    FILE *list = text_open(&text, &room);
    for (int j = k; j < end; j++)
        fprintf(list, "%s%s", j > k ? ", " : "", d->at[j].value);
    text_close(list, &text);
    show_text(out, name, "%s", text);
    free(text);
    return end;
}

/* Whether the name is among the first so many. */
static int is_shown(const trial *T, int first, const char *name)
{
    int k = 0;
    while (k < first && strcmp(T->shown[k].name, name) != 0)
        k++;
    return k < first;
}

/* The data of the case, its degree, then what it shows. */
static void tell(const struct small_data *d, const trial *T, exhibit **shown, int *count)
{
    trial out = {.claim = T->claim, .degree = T->degree};
    show_degree(T->claim, &out);
    for (int k = 0; k < d->count;)
        k = show_inputs(&out, d, k);
    for (int k = 0, data = out.exhibits; k < T->exhibits; k++)
        if (!is_shown(&out, data, T->shown[k].name))
            show_text(&out, T->shown[k].name, "%s", T->shown[k].value);
    *shown = out.shown;
    *count = out.exhibits;
}

void show_case(const struct plan *p, int k, trial *T)
{
    struct small_data data = no_data();
    struct plan again = *p;
    again.small = &data;
    data.random = 1;
    trial same = run_case(&again, k, 0, NULL, NULL);
    (void)judged_case(&same);
    forget_exhibits(T->shown, T->exhibits);
    tell(&data, &same, &T->shown, &T->exhibits);
    forget_exhibits(same.shown, same.exhibits);
    free_data(&data);
}

void find_witness(const claim *c, exhibit **shown, int *count)
{
    *shown = NULL;
    *count = 0;
    if (c->kind == COUNTEREXAMPLE || c->body[RATIONAL_TYPE] == NULL)
        return;
    struct search s = {.plan = {c, RATIONAL_TYPE, 0, &s.data}, .data = no_data(), .end = cagd_seconds() + MOST_SECONDS};
    const unsigned faults = region_faults; /* of those who ran before: the search has its own */
    trial T;
    int degrees = c->degree_high - c->degree_low + 1, found = 0;
    for (; s.which < degrees && !found && !is_over(&s); s.which += !found)
        found = draw(&s, &T);
    if (found && s.data.count == 0) /* there is but one instance */
        forget_exhibits(T.shown, T.exhibits);
    if (found && s.data.count > 0) {
        simplify(&s, &T);
        tell(&s.data, &T, shown, count);
        forget_exhibits(T.shown, T.exhibits);
    }
    free_data(&s.data);
    region_faults = faults;
}
