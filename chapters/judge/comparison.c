/* comparison.c -- comparing: equal, zero, nonnegative, a decided condition. */
#include "chapters/judge/exhibits.h"
#include "chapters/judge/words.h"
#include "exact/record/trace.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void about(trial *T, const char *what) { T->about = what; }

/* Counts one comparison; says whether it is the first that fails, whose sides are to be shown.  After
 * UNABLE or CROWDED values may be placeholders: what is compared then decides nothing. */
static int first_failure(trial *T, int good)
{
    T->compared++;
    if (good || T->outcome == FAILS || (region_faults & (FAULT_UNABLE | FAULT_CROWDED)))
        return 0;
    T->outcome = FAILS;
    if (T->about != NULL)
        show_text(T, "compared", "%s", T->about);
    return 1;
}

void agree_as(trial *T, int condition, const char *formula)
{
    if (cagd_trace_noting())
        cagd_trace_agree(condition, formula);
    if (first_failure(T, condition) && T->claim->kind != COUNTEREXAMPLE)
        show_text(T, "condition", "%s", formula);
}

void same_f(trial *T, num_f a, num_f b)
{
    int equal = equal_f(a, b);
    if (cagd_trace_noting()) {
        int left = cagd_node_of_f(a), right = cagd_node_of_f(b);
        cagd_trace_same(left, right, equal);
    }
    if (first_failure(T, equal)) {
        show_text(T, "left", "%s", text_f(a));
        show_text(T, "right", "%s", text_f(b));
    }
}
void same_q(trial *T, num_q a, num_q b)
{
    int equal = mpq_equal(a.at, b.at) != 0;
    if (cagd_trace_noting()) {
        int left = cagd_node_of_q(a), right = cagd_node_of_q(b);
        cagd_trace_same(left, right, equal);
    }
    if (first_failure(T, equal)) {
        show_text(T, "left", "%s", text_q(a));
        show_text(T, "right", "%s", text_q(b));
    }
}
/* Intervals that meet confirm nothing: the outcome is UNDECIDED at best. */
void same_i(trial *T, num_i a, num_i b)
{
    num_i gap = sub_i(a, b);
    if (width_i(gap) > T->worst)
        T->worst = width_i(gap);
    if (first_failure(T, contains_zero_i(gap))) {
        show_text(T, "left", "%s", text_i(a));
        show_text(T, "right", "%s", text_i(b));
    }
    if (T->outcome == HOLDS)
        T->outcome = UNDECIDED;
}
void same_m(trial *T, num_m a, num_m b)
{
    double allowed = error_bound_m(a) + error_bound_m(b), error = fabs(a.v - b.v);
    double part = error == 0 ? 0 : error / allowed;
    if (!isnan(T->worst) && !(part <= T->worst))
        T->worst = part;
    if (first_failure(T, part <= 1)) {
        show_text(T, "left", "%s", text_m(a));
        show_text(T, "right", "%s", text_m(b));
    }
}

void vanishes_f(trial *T, num_f a) { same_f(T, a, from_int_f(0)); }
void vanishes_q(trial *T, num_q a) { same_q(T, a, from_int_q(0)); }
void vanishes_i(trial *T, num_i a) { same_i(T, a, from_int_i(0)); }
void vanishes_m(trial *T, num_m a) { same_m(T, a, exact_m(0)); }

static int is_word(const char *word, const char *words)
{
    size_t n = strlen(word);
    for (const char *at = words; at != NULL && (at = strstr(at, word)) != NULL; at += n)
        if ((at == words || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0'))
            return 1;
    return 0;
}

/* Notes the variables of a: its coefficients say something for their positive values only. */
static void take_as_positive(trial *T, num_f a)
{
    char name[FIELD_MAX_NAME + 1];
    for (const char *known = field_variables(); *known != '\0'; known += strspn(known, " ")) {
        size_t n = strcspn(known, " ");
        snprintf(name, sizeof name, "%.*s", (int)n, known);
        known += n;
        num_f v = variable_f(name);
        if (is_word(name, T->positive) || (degree_f(a, v) <= 0 && denominator_degree_f(a, v) <= 0))
            continue;
        size_t had = T->positive != NULL ? strlen(T->positive) : 0, room = had + n + 2;
        char *longer = region_bytes(room);
        snprintf(longer, room, "%s%s%s", had > 0 ? T->positive : "", had > 0 ? " " : "", name);
        T->positive = longer;
    }
}

void nonnegative_f(trial *T, num_f a)
{
    int sign = coefficients_sign_f(a);
    if (sign < -1)
        region_faults |= FAULT_UNABLE;
    take_as_positive(T, a);
    if (cagd_trace_noting())
        cagd_trace_nonnegative(cagd_node_of_f(a), sign != -1, to_string_f(a), sign);
    if (first_failure(T, sign != -1))
        show_text(T, "negative", "%s", text_f(a));
}
void nonnegative_q(trial *T, num_q a)
{
    int good = mpq_sgn(a.at) >= 0;
    if (cagd_trace_noting())
        cagd_trace_nonnegative(cagd_node_of_q(a), good, NULL, 0);
    if (first_failure(T, good))
        show_text(T, "negative", "%s", text_q(a));
}
void nonnegative_i(trial *T, num_i a)
{
    if (first_failure(T, upper_i(a) >= 0))
        show_text(T, "negative", "%s", text_i(a));
    if (T->outcome == HOLDS && lower_i(a) < 0)
        T->outcome = UNDECIDED;
}
void nonnegative_m(trial *T, num_m a)
{
    if (first_failure(T, a.v >= -error_bound_m(a)))
        show_text(T, "negative", "%s", text_m(a));
}
