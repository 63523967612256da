#include "chapters/frame/judge.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const number_type_name[NUMBER_TYPES] = {"field", "rational", "interval", "double"};
const char *const outcome_name[] = {"holds", "fails", "undecided"};
const char *const evidence_name[] = {"none", "measured", "enclosed", "sampled", "decided", "proved"};

/* splitmix64 (Steele, Lea, Flood 2014); the remainder's bias is below 2^-32 for the ranges used. */
int pick(trial *T, int low, int high)
{
    uint64_t z = (T->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (int)((z ^ (z >> 31)) % (uint64_t)(high - low + 1));
}

void about(trial *T, const char *what) { T->about = what; }

/* ---- what is shown ---------------------------------------------------------------------------- */

static void add_exhibit(trial *T, const char *name, char *value)
{
    exhibit *more = realloc(T->shown, (size_t)(T->exhibits + 1) * sizeof *more);
    char *copy = strdup(name);
    if (more == NULL || copy == NULL || value == NULL)
        abort();
    T->shown = more;
    T->shown[T->exhibits++] = (exhibit){copy, value};
}

void show_text(trial *T, const char *name, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    int length = vsnprintf(NULL, 0, format, list);
    va_end(list);
    char *value = malloc((size_t)length + 1);
    if (value == NULL)
        abort();
    va_start(list, format);
    vsnprintf(value, (size_t)length + 1, format, list);
    va_end(list);
    add_exhibit(T, name, value);
}

static const char *text_q(num_q a) { return to_string_q(a); }
static const char *text_i(num_i a)
{
    char *text = region_bytes(80);
    snprintf(text, 80, "[%.17g, %.17g]", lower_i(a), upper_i(a));
    return text;
}
static const char *text_m(num_m a)
{
    char *text = region_bytes(40);
    snprintf(text, 40, "%.17g", a.v);
    return text;
}
/* A long formula is cut: an exhibit is for reading. */
static const char *text_f(num_f a)
{
    enum { LONGEST = 400 };
    const char *whole = to_string_f(a);
    if (strlen(whole) <= LONGEST)
        return whole;
    char *text = region_bytes(LONGEST + 8);
    snprintf(text, LONGEST + 8, "%.*s ...", LONGEST, whole);
    return text;
}

/* ---- data ------------------------------------------------------------------------------------- */

enum { ONE = 1 << 20 }; /* 20-bit data: exact in binary64, products of them mostly are not */

static num_q datum(trial *T) { return from_ratio_q(pick(T, -ONE, ONE), ONE); }
static num_q weight(trial *T) { return from_ratio_q(pick(T, ONE / 8, 4 * ONE), ONE); }
static num_q fraction(trial *T) { return from_ratio_q(pick(T, 1, ONE - 1), ONE); }

static num_f indexed_variable(const char *name, int index)
{
    char full[16];
    snprintf(full, sizeof full, "%s%d", name, index);
    return variable_f(full);
}

num_f unknown_f(trial *T, const char *name, int index)
{
    (void)T;
    return indexed_variable(name, index);
}
num_f positive_f(trial *T, const char *name, int index)
{
    (void)T;
    return indexed_variable(name, index);
}
num_f parameter_f(trial *T, const char *name)
{
    (void)T;
    return variable_f(name);
}
num_f whole_f(trial *T, const char *name, int low, int high)
{
    (void)T, (void)low, (void)high;
    return variable_f(name);
}
num_f inside_f(trial *T, const char *name)
{
    (void)T;
    num_f s = variable_f(name);
    return div_f(s, add_f(from_int_f(1), s));
}

/* The same for a trace: from here on it is an input. */
static num_q as_input(num_q a, const char *name, int index)
{
    if (cagd_trace_noting())
        cagd_trace_input(a.at, name, index);
    return a;
}

/* The other types start from the same rationals. */
static num_q from_rational_q(num_q a) { return a; }
static num_m from_rational_m(num_q a) { return exact_m(to_double_q(a)); }
#define SAMPLED_DATA(S)                                                                                                \
    num_##S unknown_##S(trial *T, const char *name, int index)                                                         \
    {                                                                                                                  \
        return from_rational_##S(as_input(datum(T), name, index));                                                     \
    }                                                                                                                  \
    num_##S positive_##S(trial *T, const char *name, int index)                                                        \
    {                                                                                                                  \
        return from_rational_##S(as_input(weight(T), name, index));                                                    \
    }                                                                                                                  \
    num_##S parameter_##S(trial *T, const char *name) { return from_rational_##S(as_input(fraction(T), name, -1)); }   \
    num_##S whole_##S(trial *T, const char *name, int low, int high)                                                   \
    {                                                                                                                  \
        return from_rational_##S(as_input(from_int_q(pick(T, low, high)), name, -1));                                  \
    }                                                                                                                  \
    num_##S inside_##S(trial *T, const char *name) { return from_rational_##S(as_input(fraction(T), name, -1)); }
SAMPLED_DATA(q)
SAMPLED_DATA(i)
SAMPLED_DATA(m)

/* ---- comparison ------------------------------------------------------------------------------- */

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

void agree(trial *T, int condition)
{
    if (cagd_trace_noting())
        cagd_trace_agree(condition);
    (void)first_failure(T, condition);
}

void same_f(trial *T, num_f a, num_f b)
{
    int equal = equal_f(a, b);
    if (cagd_trace_noting()) {
        int left = cagd_trace_field_element(a), right = cagd_trace_field_element(b);
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
        int left = cagd_trace_number(a.at), right = cagd_trace_number(b.at);
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
    if (!(part <= T->worst))
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
        cagd_trace_nonnegative(cagd_trace_field_element(a), sign != -1, to_string_f(a), sign);
    if (first_failure(T, sign != -1))
        show_text(T, "negative", "%s", text_f(a));
}
void nonnegative_q(trial *T, num_q a)
{
    int good = mpq_sgn(a.at) >= 0;
    if (cagd_trace_noting())
        cagd_trace_nonnegative(cagd_trace_number(a.at), good, NULL, 0);
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

#define SHOWN(S)                                                                                                       \
    void show_##S(trial *T, const char *name, num_##S a) { show_text(T, name, "%s", text_##S(a)); }                    \
    void show_points_##S(trial *T, const char *name, int count, int dim, const num_##S R[])                            \
    {                                                                                                                  \
        size_t room = 1;                                                                                               \
        for (int k = 0; k < count * dim; k++)                                                                          \
            room += strlen(text_##S(R[k])) + 4;                                                                        \
        char *text = region_bytes(room + 4), *at = text;                                                               \
        *at = '\0';                                                                                                    \
        for (int k = 0; k < count * dim; k++)                                                                          \
            if (dim == 1)                                                                                              \
                at += sprintf(at, "%s%s", k > 0 ? ", " : "", text_##S(R[k]));                                          \
            else                                                                                                       \
                at += sprintf(at, "%s%s%s", k % dim == 0 ? (k > 0 ? " (" : "(") : ", ", text_##S(R[k]),                \
                              k % dim == dim - 1 ? ")" : "");                                                          \
        show_text(T, name, "%s", text);                                                                                \
    }
SHOWN(f)
SHOWN(q)
SHOWN(i)
SHOWN(m)
