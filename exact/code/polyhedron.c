/* polyhedron.c -- see polyhedron.h.  Claims become linear conditions on monomials; "not 0" is "above" or "below". */
#include "exact/code/polyhedron.h"

#include "exact/decide/linear.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_MONOMIALS = 240, MOST_CONDITIONS = 400, MOST_SYSTEMS = 64 };

struct polyhedron {
    int monomials, conditions, splits, systems;
    const char *monomial[MOST_MONOMIALS];
    struct cagd_linear_condition condition[MOST_CONDITIONS];
    const cagd_num_q *split[MOST_CONDITIONS]; /* what is not 0 */
};

static void *room(size_t count, size_t size)
{
    void *at = cagd_region_array(1, (int)(count > 0 ? count : 1), size);
    if (at == NULL)
        abort();
    return at;
}

/* The factors of a monomial in one order, whatever the order in the text: as the field has one order of variables, they are. */
static int number_of(struct polyhedron *p, const char *start, size_t length)
{
    for (int k = 0; k < p->monomials; k++)
        if (strlen(p->monomial[k]) == length && memcmp(p->monomial[k], start, length) == 0)
            return k;
    if (p->monomials == MOST_MONOMIALS)
        return -1;
    char *text = room(length + 1, 1);
    memcpy(text, start, length);
    text[length] = 0;
    p->monomial[p->monomials] = text;
    return p->monomials++;
}

/* "-3*k[1]*t": its sign and coefficient, and the monomial without them; the end. */
static const char *read_term(const char *at, cagd_num_q *coefficient, const char **monomial, size_t *length)
{
    int negative = *at == '-';
    if (*at == '-' || *at == '+')
        at++;
    *coefficient = cagd_from_int_q(1);
    if (isdigit((unsigned char)*at)) {
        size_t digits = strspn(at, "0123456789");
        char *text = room(digits + 1, 1);
        memcpy(text, at, digits);
        text[digits] = 0;
        *coefficient = cagd_from_string_q(text);
        at += digits;
        if (*at == '*')
            at++;
    }
    if (negative)
        *coefficient = cagd_neg_q(*coefficient);
    *monomial = at;
    *length = strcspn(at, "+-");
    return at + *length;
}

/* The coefficients of a polynomial, that of 1 first; NULL when it is no polynomial in that form, or there are too many. */
static const cagd_num_q *coefficients(struct polyhedron *p, const char *text)
{
    cagd_num_q *a = room(MOST_MONOMIALS + 1, sizeof *a);
    cagd_num_q zero = cagd_from_int_q(0);
    for (int k = 0; k <= MOST_MONOMIALS; k++)
        a[k] = zero;
    if (*text == 0 || strpbrk(text, "()/ ") != NULL)
        return NULL;
    while (*text != 0) {
        cagd_num_q c;
        const char *monomial;
        size_t length;
        text = read_term(text, &c, &monomial, &length);
        int k = length == 0 ? 0 : number_of(p, monomial, length) + 1;
        if (length > 0 && k == 0)
            return NULL;
        a[k] = cagd_add_q(a[k], c);
    }
    return a;
}

static int add(struct polyhedron *p, const cagd_num_q *a, enum cagd_linear_relation relation)
{
    if (p->conditions == MOST_CONDITIONS)
        return -1;
    p->condition[p->conditions++] = (struct cagd_linear_condition){a, relation};
    return 0;
}

static const cagd_num_q *negated(const cagd_num_q *a)
{
    cagd_num_q *b = room(MOST_MONOMIALS + 1, sizeof *b);
    for (int k = 0; k <= MOST_MONOMIALS; k++)
        b[k] = cagd_neg_q(a[k]);
    return b;
}

/* A polynomial that cannot be read claims nothing here, which is right where nothing is to be found anywhere. */
static int add_claim(struct polyhedron *p, const struct cagd_code_claim *claim)
{
    const cagd_num_q *a = coefficients(p, claim->polynomial);
    if (a == NULL)
        return 0;
    switch (claim->signs) {
    case CAGD_CODE_ZERO:
        return add(p, a, CAGD_LINEAR_ZERO);
    case CAGD_CODE_ABOVE:
        return add(p, a, CAGD_LINEAR_POSITIVE);
    case CAGD_CODE_ABOVE | CAGD_CODE_ZERO:
        return add(p, a, CAGD_LINEAR_NONNEGATIVE);
    case CAGD_CODE_BELOW:
        return add(p, negated(a), CAGD_LINEAR_POSITIVE);
    case CAGD_CODE_BELOW | CAGD_CODE_ZERO:
        return add(p, negated(a), CAGD_LINEAR_NONNEGATIVE);
    case CAGD_CODE_ABOVE | CAGD_CODE_BELOW:
        if (p->splits == MOST_CONDITIONS)
            return -1;
        p->split[p->splits++] = a;
        return 0;
    default: /* no sign at all: nowhere */
        return claim->signs != 0 ? 0 : add(p, negated(coefficients(p, "1")), CAGD_LINEAR_NONNEGATIVE);
    }
}

/* What conditions on that variable alone say: 2 it is > 0, 1 it is >= 0, 0 neither. */
static int known_sign(struct polyhedron *p, const char *name, size_t length)
{
    int k = number_of(p, name, length), known = 0;
    for (int c = 0; k >= 0 && c < p->conditions; c++) {
        const struct cagd_linear_condition *l = &p->condition[c];
        int alone = l->relation != CAGD_LINEAR_ZERO && cagd_sign_q(l->a[k + 1]) > 0 && cagd_sign_q(l->a[0]) <= 0;
        for (int j = 0; alone && j < p->monomials; j++)
            alone = j == k || cagd_is_zero_q(l->a[j + 1]);
        if (alone && (l->relation == CAGD_LINEAR_POSITIVE || cagd_sign_q(l->a[0]) < 0))
            return 2;
        known = known || alone;
    }
    return known;
}

/* A product of even powers and of variables that are not negative is not negative; of positive ones it is positive. */
static int add_sign_of_monomial(struct polyhedron *p, int k)
{
    int positive = 1, not_negative = 1, degree = 0;
    for (const char *at = p->monomial[k]; *at != 0;) {
        size_t length = strcspn(at, "*"), name = strcspn(at, "*^");
        long power = at[name] == '^' ? strtol(at + name + 1, NULL, 10) : 1;
        int sign = known_sign(p, at, name);
        positive = positive && sign == 2;
        not_negative = not_negative && (sign > 0 || power % 2 == 0);
        degree += power > 1 ? 2 : 1;
        at += length + (at[length] == '*');
    }
    if (degree < 2 || !not_negative)
        return 0;
    cagd_num_q *a = room(MOST_MONOMIALS + 1, sizeof *a), zero = cagd_from_int_q(0), one = cagd_from_int_q(1);
    for (int j = 0; j <= MOST_MONOMIALS; j++)
        a[j] = j == k + 1 ? one : zero;
    return add(p, a, positive ? CAGD_LINEAR_POSITIVE : CAGD_LINEAR_NONNEGATIVE);
}

static int vanishes_at(const struct polyhedron *p, const cagd_num_q a[], const cagd_num_q x[])
{
    cagd_num_q sum = a[0];
    for (int k = 0; k < p->monomials; k++)
        if (!cagd_is_zero_q(a[k + 1]))
            sum = cagd_add_q(sum, cagd_mul_q(a[k + 1], x[k]));
    return cagd_is_zero_q(sum);
}

/* What is not 0 is tried with both signs, unless the solution without it does already. */
static int search(struct polyhedron *p, struct cagd_linear_answer *answer)
{
    if (++p->systems > MOST_SYSTEMS)
        return -1;
    *answer = cagd_linear_solve(p->monomials, p->conditions, p->condition);
    if (answer->x == NULL && answer->multiplier == NULL)
        return -1;
    if (!answer->solvable)
        return 0;
    int k = 0;
    while (k < p->splits && !vanishes_at(p, p->split[k], answer->x))
        k++;
    if (k == p->splits)
        return 1;
    int answers[2];
    for (int side = 0; side < 2; side++) {
        if (add(p, side == 0 ? p->split[k] : negated(p->split[k]), CAGD_LINEAR_POSITIVE) != 0)
            return -1;
        answers[side] = search(p, answer);
        p->conditions--;
        if (answers[side] == 1)
            return 1;
    }
    return answers[0] < 0 || answers[1] < 0 ? -1 : 0;
}

int cagd_code_is_anywhere(int count, const struct cagd_code_claim claim[], struct cagd_code_witness *witness)
{
    struct polyhedron *p = room(1, sizeof *p);
    struct cagd_linear_answer answer;
    p->monomials = p->conditions = p->systems = p->splits = 0;
    for (int k = 0; k < count; k++)
        if (add_claim(p, &claim[k]) != 0)
            return -1;
    for (int k = p->monomials - 1; k >= 0; k--)
        if (add_sign_of_monomial(p, k) != 0)
            return -1;
    int found = search(p, &answer);
    if (found == 1)
        *witness = (struct cagd_code_witness){p->monomials, p->monomial, answer.x};
    return found;
}

/* "k[1]^2*t" */
static cagd_num_q monomial_at(const char *at, size_t length,
                              cagd_num_q (*value)(const void *context, const char *name, size_t length),
                              const void *context)
{
    cagd_num_q product = cagd_from_int_q(1);
    const char *end = at + length;
    while (at < end) {
        size_t name = strcspn(at, "*^+-");
        cagd_num_q x = value(context, at, name);
        long power = 1;
        at += name;
        if (at < end && *at == '^') {
            char *after;
            power = strtol(at + 1, &after, 10);
            at = after;
        }
        for (; power > 0; power--)
            product = cagd_mul_q(product, x);
        at += at < end && *at == '*';
    }
    return product;
}

int cagd_code_hold_at(int count, const struct cagd_code_claim claim[],
                      cagd_num_q (*value)(const void *context, const char *name, size_t length), const void *context)
{
    for (int k = 0; k < count; k++) {
        const char *at = claim[k].polynomial;
        cagd_num_q sum = cagd_from_int_q(0);
        if (*at == 0 || strpbrk(at, "()/ ") != NULL)
            return 0;
        while (*at != 0) {
            cagd_num_q c;
            const char *monomial;
            size_t length;
            at = read_term(at, &c, &monomial, &length);
            sum = cagd_add_q(sum, cagd_mul_q(c, monomial_at(monomial, length, value, context)));
        }
        int sign = cagd_sign_q(sum);
        if ((claim[k].signs & (sign == 0 ? CAGD_CODE_ZERO : sign > 0 ? CAGD_CODE_ABOVE : CAGD_CODE_BELOW)) == 0)
            return 0;
    }
    return 1;
}
