/* orders.c -- see orders.h. */
#include "exact/code/orders.h"

#include <math.h>
#include <stdlib.h>

enum { MOST_MADE = 1 << 20, MOST_TERMS = 256 };

/* Operands that were not made have their binary64 alone: index -1. */
static struct made {
    char by;
    int a, b;
    double x, y;
} * made;
static double *value[CAGD_CODE_ORDERS]; /* of the first `done` of them, in each order */
static int count, room, done;

static int make_room(void)
{
    int more = room > 0 ? 2 * room : 1024;
    struct made *larger = realloc(made, (size_t)more * sizeof *made);
    if (larger == NULL)
        return 0;
    made = larger;
    for (int order = 0; order < CAGD_CODE_ORDERS; order++) {
        double *longer = realloc(value[order], (size_t)more * sizeof *longer);
        if (longer == NULL)
            return 0;
        value[order] = longer;
    }
    room = more;
    return 1;
}

void cagd_code_note_made(cagd_code_value *v, char by, cagd_code_value a, cagd_code_value b)
{
    v->made = 0;
    if (count == MOST_MADE || (count == room && !make_room()))
        return;
    made[count++] = (struct made){by, a.made - 1, b.made - 1, a.d, b.d};
    v->made = count;
}

static double operand(int index, double alone, int order) { return index < 0 ? alone : value[order][index]; }

struct term {
    double amount;
    int index, sign; /* index: of a sum that is not taken apart yet, or -1 */
};

static int is_sum(int index)
{
    return index >= 0 && (made[index].by == '+' || made[index].by == '-' || made[index].by == 'n');
}

/* The terms of a sum; what there is no room for is one term, done as a sum of its own. */
static int take_apart(int sum, int order, struct term term[MOST_TERMS])
{
    int terms = 1;
    term[0] = (struct term){0, sum, 1};
    for (int k = 0; k < terms;) {
        const struct made *m = term[k].index >= 0 ? &made[term[k].index] : NULL;
        int sign = term[k].sign, two = m != NULL && m->by != 'n';
        if (m == NULL || (two && terms == MOST_TERMS)) {
            if (m != NULL)
                term[k].amount = sign * value[order][term[k].index];
            k++;
            continue;
        }
        int first = m->by == 'n' ? -sign : sign, second = m->by == '-' ? -sign : sign;
        term[k] = (struct term){first * operand(m->a, m->x, order), is_sum(m->a) ? m->a : -1, first};
        if (two)
            term[terms++] = (struct term){second * operand(m->b, m->y, order), is_sum(m->b) ? m->b : -1, second};
    }
    return terms;
}

static int by_size(const void *a, const void *b)
{
    double x = fabs(((const struct term *)a)->amount), y = fabs(((const struct term *)b)->amount);
    return (x > y) - (x < y);
}

static double halves(const struct term term[], int terms)
{
    return terms == 1 ? term[0].amount : halves(term, terms / 2) + halves(term + terms / 2, terms - terms / 2);
}

static double sum_of(int sum, int order)
{
    struct term term[MOST_TERMS];
    int terms = take_apart(sum, order, term);
    double s = 0;
    if (order == CAGD_CODE_IN_HALVES)
        return halves(term, terms);
    qsort(term, (size_t)terms, sizeof *term, by_size);
    for (int k = 0; k < terms; k++)
        s += term[order == CAGD_CODE_SMALLEST_FIRST ? k : terms - 1 - k].amount;
    return s;
}

static double result(int index, int order)
{
    const struct made *m = &made[index];
    double x = operand(m->a, m->x, order), y = operand(m->b, m->y, order);
    switch (m->by) {
    case '*':
        return x * y;
    case '/':
        return x / y;
    case 'r':
        return sqrt(x);
    default:
        return sum_of(index, order);
    }
}

double cagd_code_in_order(cagd_code_value v, enum cagd_code_order order)
{
    for (; done < count; done++)
        for (int k = 0; k < CAGD_CODE_ORDERS; k++)
            value[k][done] = result(done, k);
    return v.made > 0 ? value[order][v.made - 1] : v.d;
}
