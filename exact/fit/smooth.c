#include "exact/fit/smooth.h"

#include "core/number/limits.h"
#include "exact/fit/words.h"

enum { POINTS = MAX_DEGREE + 1 };

/* A linear form in the points of a span: its coefficients. */
typedef struct form {
    num_i of[POINTS];
} form;

static form combine(int points, num_i s, const form *a, const form *b)
{
    form sum;
    for (int k = 0; k < points; k++)
        sum.of[k] = add_i(a->of[k], mul_i(s, sub_i(b->of[k], a->of[k])));
    return sum;
}

/* Differences of the forms, over the lengths of their supports, times the degree: the points of the derivative. */
static void derive(const num_i *u, int mu, int degree, int points, form d[])
{
    for (int k = 0; k < degree; k++) {
        num_i factor = div_i(from_double_i(degree), sub_i(u[mu + k + 1], u[mu - degree + k + 1]));
        for (int l = 0; l < points; l++)
            d[k].of[l] = mul_i(factor, sub_i(d[k + 1].of[l], d[k].of[l]));
    }
}

/* Point i of Bernstein's form over [u_mu, u_mu+1]: the polar form at u_mu, m - i times, and u_mu+1, i times. */
static form bernstein_point(const num_i *u, int mu, int m, int i, int points, const form d[])
{
    form b[POINTS];
    for (int k = 0; k <= m; k++)
        b[k] = d[k];
    for (int r = 1; r <= m; r++)
        for (int k = 0; k <= m - r; k++) {
            num_i from = u[mu - m + r + k], to = u[mu + 1 + k], at = r <= m - i ? u[mu] : u[mu + 1];
            b[k] = combine(points, div_i(sub_i(at, from), sub_i(to, from)), &b[k], &b[k + 1]);
        }
    return b[0];
}

static double choose(int n, int k)
{
    double c = 1;
    for (int i = 0; i < k; i++)
        c = c * (n - i) / (i + 1);
    return c;
}

/* The span u_mu < u_mu+1: lambda L^3 (u_mu+1 - u_mu) times the integrals of the products. */
static void add_span(struct box *b, int mu, num_i factor)
{
    const cagd_stationary_problem *problem = b->problem;
    const int p = problem->curve->degree, dim = problem->curve->dim, m = p - 2, first = mu - p;
    form d[POINTS], c[POINTS];
    for (int k = 0; k <= p; k++)
        for (int l = 0; l <= p; l++)
            d[k].of[l] = from_double_i(k == l);
    derive(b->knot, mu, p, p + 1, d);
    derive(b->knot, mu, p - 1, p + 1, d);
    for (int i = 0; i <= m; i++)
        c[i] = bernstein_point(b->knot, mu, m, i, p + 1, d);
    for (int k = 0; k <= p; k++)
        for (int l = 0; l <= p; l++) {
            num_i sum = from_double_i(0);
            for (int i = 0; i <= m; i++)
                for (int j = 0; j <= m; j++) {
                    num_i integral = div_i(from_double_i(choose(m, i) * choose(m, j)),
                                           from_double_i((2 * m + 1) * choose(2 * m, i + j)));
                    sum = add_i(sum, mul_i(integral, mul_i(c[i].of[k], c[j].of[l])));
                }
            sum = mul_i(factor, sum);
            for (int x = 0; x < dim; x++) {
                const int a = b->of_coordinate[(first + k) * dim + x], e = b->of_coordinate[(first + l) * dim + x];
                if (a < 0)
                    continue;
                cagd_accumulate(&b->gradient[a], mul_i(sum, b->point[(first + l) * dim + x]));
                if (e >= a)
                    cagd_accumulate(&b->hessian[a * b->n + e], sum);
            }
        }
}

void cagd_stationary_smooth(struct box *b, int stride)
{
    const cagd_stationary_problem *problem = b->problem;
    const cagd_spline *curve = problem->curve;
    const int p = curve->degree, low = p + problem->shift, high = curve->count - problem->shift;
    num_i length = sub_i(b->knot[high], b->knot[low]);
    num_i whole = mul_i(from_double_i(problem->smooth), mul_i(length, square_i(length)));
    whole = div_i(whole, from_double_i(stride));
    for (int mu = low; mu < high; mu++) {
        region_mark mark = region_open();
        if (curve->knots[mu] < curve->knots[mu + 1])
            add_span(b, mu, mul_i(whole, sub_i(b->knot[mu + 1], b->knot[mu])));
        region_drop(mark);
    }
}
