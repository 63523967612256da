/* data.c -- what bodies compute with: variables in the field, elsewhere the same dyadic numbers in every type. */
#include "chapters/judge/witness.h"
#include "chapters/judge/words.h"
#include "exact/record/trace.h"

#include <stdio.h>

/* splitmix64 (steele-lea-flood-2014); the remainder's bias is below 2^-32 for the ranges used. */
int pick(trial *T, int low, int high)
{
    uint64_t z = (T->state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (int)((z ^ (z >> 31)) % (uint64_t)(high - low + 1));
}

enum { ONE = 1 << 20 }; /* 20-bit data: exact in binary64, products of them mostly are not */

/* A random number of the kind, low and high for whole ones. */
static num_q random_number(trial *T, enum input_kind kind, int low, int high)
{
    switch (kind) {
    case ANY_NUMBER:
        return from_ratio_q(pick(T, -ONE, ONE), ONE);
    case POSITIVE_NUMBER:
        return from_ratio_q(pick(T, ONE / 8, 4 * ONE), ONE);
    case PARAMETER:
        return from_ratio_q(pick(T, 1 - ONE, 2 * ONE - 1), ONE);
    case FRACTION:
        return from_ratio_q(pick(T, 1, ONE - 1), ONE);
    default:
        return from_int_q(pick(T, low, high));
    }
}

/* A random number, or a simple one where a small instance is looked for. */
static num_q input(trial *T, const char *name, int index, enum input_kind kind, int low, int high)
{
    if (T->small != NULL && !T->small->random)
        return small_number(T, name, index, kind, low, high);
    num_q a = random_number(T, kind, low, high);
    if (T->small != NULL)
        keep_input(T, name, index, a);
    return a;
}

static num_f indexed_variable(const char *name, int index)
{
    char full[16];
    if (index == ALONE)
        return variable_f(name);
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

/* For a trace it is an input from here on. */
static num_q noted_input(trial *T, const char *name, int index, enum input_kind kind, int low, int high)
{
    num_q a = input(T, name, index, kind, low, high);
    if (cagd_trace_noting())
        cagd_trace_input(a, name, index);
    return a;
}

/* The other types start from the same rationals. */
static num_q from_rational_q(num_q a) { return a; }
static num_m from_rational_m(num_q a) { return exact_m(to_double_q(a)); }
#define SAMPLED_DATA(S)                                                                                                \
    num_##S unknown_##S(trial *T, const char *name, int index)                                                         \
    {                                                                                                                  \
        return from_rational_##S(noted_input(T, name, index, ANY_NUMBER, 0, 0));                                       \
    }                                                                                                                  \
    num_##S positive_##S(trial *T, const char *name, int index)                                                        \
    {                                                                                                                  \
        return from_rational_##S(noted_input(T, name, index, POSITIVE_NUMBER, 0, 0));                                  \
    }                                                                                                                  \
    num_##S parameter_##S(trial *T, const char *name)                                                                  \
    {                                                                                                                  \
        return from_rational_##S(noted_input(T, name, ALONE, PARAMETER, 0, 0));                                           \
    }                                                                                                                  \
    num_##S whole_##S(trial *T, const char *name, int low, int high)                                                   \
    {                                                                                                                  \
        return from_rational_##S(noted_input(T, name, ALONE, WHOLE_NUMBER, low, high));                                   \
    }                                                                                                                  \
    num_##S inside_##S(trial *T, const char *name)                                                                     \
    {                                                                                                                  \
        return from_rational_##S(noted_input(T, name, ALONE, FRACTION, 0, 0));                                            \
    }
SAMPLED_DATA(q)
SAMPLED_DATA(i)
SAMPLED_DATA(m)
