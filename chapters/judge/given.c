/* given.c -- the data that stand in the block of a claim, and the results that are stated beside them. */
#include "chapters/judge/case.h"
#include "chapters/judge/exhibits.h"
#include "chapters/judge/words.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- entries ------------------------------------------------------------------------------------ */

static void mistake(trial *T, const char *name, const char *what)
{
    T->mistaken = 1;
    show_text(T, "mistake", "'%s': %s", name, what);
}

/* The entry of that name and place, which counts as used; NULL where there is none. */
static const datum *entry(trial *T, const char *name, enum data_place place)
{
    const datum *list = T->claim->data;
    for (int k = 0; list != NULL && list[k].name != NULL; k++)
        if (list[k].place == place && strcmp(list[k].name, name) == 0) {
            T->used |= (uint64_t)1 << k;
            return &list[k];
        }
    return NULL;
}

/* What is given under the name: in the control, what stands instead.  A mistake unless it has the shape; rows < 0: any. */
static const datum *given_entry(trial *T, const char *name, int rows, int columns)
{
    const datum *d = T->planted ? entry(T, name, IN_INSTEAD) : NULL;
    if (d == NULL)
        d = entry(T, name, IN_DATA);
    if (d == NULL)
        mistake(T, name, "the block has no such datum");
    else if (rows >= 0 && (d->rows != rows || d->columns != columns))
        mistake(T, name, "the datum has another shape");
    else
        return d;
    return NULL;
}

/* The result of that name, to be compared; NULL in the control, and where there is none. */
static const datum *stated_result(trial *T, const char *name, int rows, int columns)
{
    if (T->planted)
        return NULL;
    const datum *d = entry(T, name, IN_RESULT);
    if (d == NULL)
        mistake(T, name, "the block states no such result");
    else if (d->rows != rows || d->columns != columns)
        mistake(T, name, "the stated result has another shape");
    else
        return d;
    return NULL;
}

/* Entries that the run did not ask for; those that stand instead are for the control. */
void look_for_unused(trial *T)
{
    const datum *list = T->claim->data;
    for (int k = 0; list != NULL && list[k].name != NULL; k++)
        if ((list[k].place == IN_INSTEAD) == (T->planted != 0) && !(T->used >> k & 1))
            mistake(T, list[k].name, "nothing in the body asks for it");
}

/* ---- numbers ------------------------------------------------------------------------------------ */

/* A letter begins the name of a variable of the field. */
static int is_variable(const char *text) { return *text >= 'A'; }

static num_q value_q(const char *text) { return from_string_q(text); }
static num_i value_i(const char *text) { return from_rational_i(from_string_q(text)); }
static num_f value_f(const char *text)
{
    return is_variable(text) ? variable_f(text) : from_rational_f(from_string_q(text));
}

/* The nearest number with its error, which is 0 where it is exact. */
static num_m value_m(const char *text)
{
    num_q exact = from_string_q(text), near = from_double_q(to_double_q(exact));
    num_m a = exact_m(to_double_q(exact));
    a.e = mpq_equal(exact.at, near.at) ? 0 : fabs(a.v);
    a.k = 1;
    return a;
}

static int agrees_q(num_q a, const char *text) { return mpq_equal(a.at, value_q(text).at); }
static int agrees_f(num_f a, const char *text) { return equal_f(a, value_f(text)); }
static int agrees_i(num_i a, const char *text) { return contains_zero_i(sub_i(a, value_i(text))); }
/* What is stated of binary64 is the very number. */
static int agrees_m(num_m a, const char *text) { return mpq_equal(from_double_q(a.v).at, from_string_q(text).at); }

#define GIVEN(S)                                                                                                       \
    num_##S given_##S(trial *T, const char *name)                                                                      \
    {                                                                                                                  \
        num_##S a;                                                                                                     \
        given_points_##S(T, name, 1, 1, &a);                                                                           \
        return a;                                                                                                      \
    }                                                                                                                  \
    void given_points_##S(trial *T, const char *name, int count, int dim, num_##S R[])                                 \
    {                                                                                                                  \
        const datum *d = given_entry(T, name, count, dim);                                                             \
        for (int k = 0; k < count * dim; k++)                                                                          \
            R[k] = d != NULL ? value_##S(d->value[k]) : from_int_##S(0);                                               \
        if (d != NULL)                                                                                                 \
            show_written(T, name, count, dim, d->value);                                                               \
    }                                                                                                                  \
    void found_##S(trial *T, const char *name, num_##S a) { found_points_##S(T, name, 1, 1, &a); }                     \
    void found_points_##S(trial *T, const char *name, int count, int dim, const num_##S R[])                           \
    {                                                                                                                  \
        const datum *d = stated_result(T, name, count, dim);                                                           \
        int agrees = 1;                                                                                                \
        for (int k = 0; d != NULL && k < count * dim; k++)                                                             \
            agrees = agrees && agrees_##S(R[k], d->value[k]);                                                          \
        if (d != NULL && agrees)                                                                                       \
            show_written(T, name, count, dim, d->value);                                                               \
        else                                                                                                           \
            show_points_##S(T, name, count, dim, R);                                                                   \
        if (!agrees)                                                                                                   \
            mistake(T, name, "another result is stated");                                                              \
    }
GIVEN(f)
GIVEN(q)
GIVEN(i)
GIVEN(m)

/* ---- whole numbers and texts -------------------------------------------------------------------- */

int given_whole(trial *T, const char *name)
{
    const datum *d = given_entry(T, name, 1, 1);
    if (d == NULL)
        return 0;
    char *end;
    long value = strtol(d->value[0], &end, 10);
    if (*end != '\0' || value < INT_MIN || value > INT_MAX)
        mistake(T, name, "the datum is no whole number");
    show_text(T, name, "%s", d->text);
    return (int)value;
}

const char *given_text(trial *T, const char *name)
{
    const datum *d = given_entry(T, name, 1, 0);
    if (d == NULL)
        return "";
    show_text(T, name, "%s", d->value[0]);
    return d->value[0];
}

void found_whole(trial *T, const char *name, int value)
{
    const datum *d = stated_result(T, name, 1, 1);
    char text[24];
    snprintf(text, sizeof text, "%d", value);
    show_text(T, name, "%s", text);
    if (d != NULL && strcmp(d->value[0], text) != 0)
        mistake(T, name, "another result is stated");
}

void found_text(trial *T, const char *name, const char *text)
{
    const datum *d = stated_result(T, name, 1, 0);
    show_text(T, name, "%s", text);
    if (d != NULL && strcmp(d->value[0], text) != 0)
        mistake(T, name, "another result is stated");
}
