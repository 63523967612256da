#include "exact/expression/radical.h"

#include "exact/words.h"

enum { DEEPEST = 6 };

/* p with x^2 = square: even and odd powers of x, A + B x. */
static num_f with_square(num_f p, const cagd_square_root *r)
{
    num_f part[2] = {from_int_f(0), from_int_f(0)}, power = from_int_f(1);
    for (int e = 0; e <= degree_f(p, r->x); e++) {
        part[e % 2] = add_f(part[e % 2], mul_f(coefficient_f(p, r->x, e), power));
        power = e % 2 == 1 ? mul_f(power, r->square) : power;
    }
    return add_f(part[0], mul_f(part[1], r->x));
}

num_f cagd_without_powers(num_f p, int roots, const cagd_square_root root[])
{
    for (int again = 1; again && region_faults == 0;) { /* the square of one root may have another */
        again = 0;
        for (int i = 0; i < roots; i++)
            if (degree_f(p, root[i].x) > 1)
                p = with_square(p, &root[i]), again = 1;
    }
    return p;
}

static int is_shown(num_f p, int roots, const cagd_square_root root[], int count, const cagd_side_of_box side[],
                    int depth)
{
    num_q unused[CAGD_MOST_UNKNOWNS];
    int rational, k = 0;
    p = cagd_numerator_f(cagd_without_powers(p, roots, root));
    while (k < roots && degree_f(p, root[k].x) < 1)
        k++;
    if (region_faults != 0 || depth == 0)
        return 0;
    if (cagd_positive_in_box(p, 0, count, side, unused, &rational) == CAGD_HOLDS)
        return 1;
    if (k == roots)
        return 0;
    num_f A = coefficient_f(p, root[k].x, 0), B = coefficient_f(p, root[k].x, 1),
          gap = sub_f(mul_f(mul_f(B, B), root[k].square), mul_f(A, A));
    int B_is = is_shown(B, roots, root, count, side, depth - 1);
    if (B_is && is_shown(gap, roots, root, count, side, depth - 1))
        return 1;
    return is_shown(A, roots, root, count, side, depth - 1) &&
           (B_is || is_shown(neg_f(gap), roots, root, count, side, depth - 1));
}

int cagd_is_nonnegative_with_roots(num_f p, int roots, const cagd_square_root root[], int count,
                                   const cagd_side_of_box side[])
{
    int is = roots > 0 && is_shown(p, roots, root, count, side, DEEPEST) && region_faults == 0;
    region_faults &= FAULT_MEMORY | FAULT_CROWDED;
    return is;
}
