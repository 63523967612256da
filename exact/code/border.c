/* border.c -- see border.h. */
#include "exact/code/border.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* What is read, and what the names in it mean. */
struct reading {
    const char *at, *name;
    const struct cagd_code_point *point;
    cagd_num_q instead;
    int wrong;
};

static cagd_num_q sum(struct reading *r);

static void skip(struct reading *r)
{
    while (*r->at == ' ')
        r->at++;
}

/* "p[2]", where elements that are equal have one name, or "t". */
static cagd_num_q named(struct reading *r)
{
    size_t length = 0;
    while (isalnum((unsigned char)r->at[length]) || r->at[length] == '_')
        length++;
    size_t whole = length + (r->at[length] == '[' ? strcspn(r->at + length, "]") + 1 : 0);
    const char *start = r->at;
    r->at += whole;
    if (r->name != NULL && strlen(r->name) == whole && strncmp(r->name, start, whole) == 0)
        return r->instead;
    for (int k = 0; k < r->point->inputs; k++) {
        const struct cagd_code_input *in = &r->point->input[k];
        if (strlen(in->name) != length || strncmp(in->name, start, length) != 0)
            continue;
        long index = whole > length ? strtol(start + length + 1, NULL, 10) : 0;
        if (index < (in->count > 0 ? in->count : 1))
            return cagd_from_string_q(in->value[index]);
    }
    r->wrong = 1;
    return cagd_from_int_q(0);
}

static cagd_num_q atom(struct reading *r)
{
    skip(r);
    if (*r->at == '(') {
        r->at++;
        cagd_num_q value = sum(r);
        skip(r);
        r->wrong |= *r->at != ')';
        r->at += *r->at == ')';
        return value;
    }
    if (isalpha((unsigned char)*r->at))
        return named(r);
    size_t digits = strspn(r->at, "0123456789");
    char *text = strndup(r->at, digits);
    if (text == NULL)
        abort();
    cagd_num_q value = cagd_from_string_q(digits > 0 ? text : "0");
    r->wrong |= digits == 0;
    r->at += digits;
    free(text);
    return value;
}

static cagd_num_q power(struct reading *r)
{
    cagd_num_q base = atom(r), value = base;
    skip(r);
    if (*r->at != '^')
        return base;
    char *end;
    long n = strtol(r->at + 1, &end, 10);
    r->wrong |= end == r->at + 1 || n < 1 || n > 1000;
    r->at = end;
    for (long k = 1; k < n && !r->wrong; k++)
        value = cagd_mul_q(value, base);
    return value;
}

static cagd_num_q product(struct reading *r)
{
    cagd_num_q value = power(r);
    for (skip(r); *r->at == '*' || *r->at == '/'; skip(r)) {
        int times = *r->at++ == '*';
        cagd_num_q next = power(r);
        if (!times && cagd_is_zero_q(next))
            r->wrong = 1;
        else
            value = times ? cagd_mul_q(value, next) : cagd_div_q(value, next);
    }
    return value;
}

static cagd_num_q sum(struct reading *r)
{
    skip(r);
    int minus = *r->at == '-';
    r->at += minus || *r->at == '+';
    cagd_num_q value = product(r);
    if (minus)
        value = cagd_neg_q(value);
    for (skip(r); *r->at == '+' || *r->at == '-'; skip(r))
        value = *r->at++ == '+' ? cagd_add_q(value, product(r)) : cagd_sub_q(value, product(r));
    return value;
}

/* {NULL} where it has no value. */
cagd_num_q cagd_code_evaluate(const char *expression, const struct cagd_code_point *p, const char *name,
                              cagd_num_q instead)
{
    struct reading r = {.at = expression, .name = name, .point = p, .instead = instead};
    cagd_num_q value = sum(&r);
    skip(&r);
    return r.wrong || *r.at != 0 ? (cagd_num_q){NULL} : value;
}

/* A linear function is one whose values at 0, 1, 2 and 5 say so; what else passes there is no worse a point to try. */
cagd_num_q cagd_code_border(const char *difference, const struct cagd_code_point *p, int input, int element)
{
    char name[64];
    const cagd_num_q none = {NULL};
    if (p->input[input].count > 0)
        snprintf(name, sizeof name, "%s[%d]", p->input[input].name, element);
    else
        snprintf(name, sizeof name, "%s", p->input[input].name);
    if (strstr(difference, name) == NULL)
        return none;
    static const long places[4] = {0, 1, 2, 5};
    cagd_num_q value[4];
    for (int k = 0; k < 4; k++) {
        value[k] = cagd_code_evaluate(difference, p, name, cagd_from_int_q(places[k]));
        if (value[k].at == NULL)
            return none;
    }
    cagd_num_q slope = cagd_sub_q(value[1], value[0]);
    if (cagd_is_zero_q(slope))
        return none;
    for (int k = 2; k < 4; k++)
        if (!cagd_equal_q(value[k], cagd_add_q(value[0], cagd_mul_q(slope, cagd_from_int_q(places[k])))))
            return none;
    return cagd_neg_q(cagd_div_q(value[0], slope));
}
