#include "core/fit/knots.h"

#include "core/number/limits.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int fit_knots_count(const fit_knots *k, int degree, int closed)
{
    return closed ? k->inner + 1 : k->inner + degree + 1;
}

/* Knot i of a closed curve's period 0, inner knots; i may be any. */
static double periodic_knot(const fit_knots *k, int i)
{
    const int n = k->inner + 1, turns = i >= 0 ? i / n : -((n - 1 - i) / n), at = i - turns * n;
    return turns + (at == 0 ? 0 : k->u[at - 1]);
}

void fit_knots_spell(const fit_knots *k, int degree, int closed, double U[])
{
    const int count = fit_knots_count(k, degree, closed), all = count + degree + (closed ? degree : 0) + 1;
    for (int i = 0; i < all; i++)
        U[i] = closed ? periodic_knot(k, i - degree) : i <= degree ? 0 : i >= count ? 1 : k->u[i - degree - 1];
}

void fit_knots_even(int inner, fit_knots *k)
{
    k->inner = inner;
    for (int i = 0; i < inner; i++)
        k->u[i] = (double)(i + 1) / (inner + 1);
}

void fit_knots_insert(fit_knots *k, double u)
{
    int at = k->inner++;
    for (; at > 0 && k->u[at - 1] > u; at--)
        k->u[at] = k->u[at - 1];
    k->u[at] = u;
}

static void take_out(fit_knots *k, int at)
{
    for (int i = at; i < k->inner - 1; i++)
        k->u[i] = k->u[i + 1];
    k->inner--;
}

fit_knots fit_knots_without(const fit_knots *from, int i, int shift)
{
    fit_knots k = *from;
    take_out(&k, i);
    if (shift & 1)
        k.u[i - 1] = (from->u[i - 1] + from->u[i]) / 2;
    if (shift & 2)
        k.u[i] = (from->u[i + 1] + from->u[i]) / 2;
    return k;
}

/* The polar form of the segment over [u_mu, u_mu+1] at the arguments a_1, ..., a_p, less `shift`. */
static void polar_form(const cagd_spline *c, int mu, const double a[], double shift, double P[])
{
    const int p = c->degree, dim = c->dim;
    double d[(MAX_DEGREE + 1) * 3];
    memcpy(d, c->points + (mu - p) * dim, (size_t)((p + 1) * dim) * sizeof *d);
    for (int r = 1; r <= p; r++)
        for (int i = 0; i <= p - r; i++) {
            const double *u = c->knots + mu - p + r + i;
            const double s = (a[r - 1] - shift - u[0]) / (u[p + 1 - r] - u[0]);
            for (int x = 0; x < dim; x++)
                d[i * dim + x] += s * (d[(i + 1) * dim + x] - d[i * dim + x]);
        }
    memcpy(P, d, (size_t)dim * sizeof *P);
}

void fit_respace(const cagd_spline *from, int period, const double v[], int count, double to[])
{
    const int p = from->degree;
    const double start = from->knots[p], end = from->knots[from->count];
    for (int j = 0; j < count; j++) {
        int span = -1; /* the one nearest to the middle of what the point moves */
        for (int i = j; i <= j + p; i++)
            if (v[i] < v[i + 1] && i >= (period ? 0 : p) && (period || i < count) &&
                (span < 0 || abs(2 * i - 2 * j - p) < abs(2 * span - 2 * j - p)))
                span = i;
        double middle = (v[span] + v[span + 1]) / 2,
               shift = period ? floor((middle - start) / (end - start)) * (end - start) : 0;
        int mu = p;
        while (mu < from->count - 1 && from->knots[mu + 1] <= middle - shift)
            mu++;
        polar_form(from, mu, v + j + 1, shift, to + j * from->dim);
    }
}
