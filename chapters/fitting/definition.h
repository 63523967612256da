/* definition.h -- NURBS curves and what belongs to a fit, straight from the definitions.  Nothing here uses a kernel. */
#include "chapters/judge/claims_on.h"

enum { MOST_ROWS = 4, MOST_DEGREE = 9, MOST_POINTS = MOST_DEGREE + 1 };

/* One segment of degree p: the knots x_0 < x_1 < ... of its 2p+2, clamped or simple; place says which are one.  The segment is
 * that of u_p < u_{p+1}.  In the field the knots are variables for p = 1, and 0, 1, 3, 7, ... for p > 1. */
static inline void G(segment_knots)(trial *T, int p, int clamped, num u[], int place[])
{
    num x = FIELD && p > 1 ? from_int(0) : unknown(T, "x", 0);
    for (int i = 0; i < 2 * p + 2; i++) {
        place[i] = clamped ? i > p : i;
        if (i > 0 && place[i] > place[i - 1])
#if FIELD
            x = p > 1 ? from_int((1L << place[i]) - 1) : unknown(T, "x", place[i]);
#else
            x = add(x, positive(T, "h", place[i]));
#endif
        u[i] = x;
    }
}

/* A number of that segment; in the field any number. */
static inline num G(in_segment)(trial *T, int p, const num u[])
{
#if FIELD
    (void)p, (void)u;
    return parameter(T, "t");
#else
    return add(u[p], mul(parameter(T, "t"), sub(u[p + 1], u[p])));
#endif
}

/* N[m*rows + r]: the coefficient of s^r in N_{m,p}(t+s), m = 0, ..., p, on the segment, r < rows <= MOST_ROWS: the recursion of
 * de Boor and Cox by its letter, 0/0 being 0, with power series in the place of values. */
static inline void G(basis_series)(int p, const num u[], const int place[], num t, int rows, num N[])
{
    num value[(2 * MOST_DEGREE + 2) * MOST_ROWS];
    for (int i = 0; i <= 2 * p; i++)
        for (int r = 0; r < rows; r++)
            value[i * rows + r] = from_int(i == p && r == 0);
    for (int q = 1; q <= p; q++)
        for (int i = 0; i + q <= 2 * p; i++) {
            num *left = value + i * rows, *right = left + rows, sum[MOST_ROWS];
            for (int r = 0; r < rows; r++) {
                sum[r] = from_int(0);
                if (place[i] < place[i + q]) {
                    num above = mul(sub(t, u[i]), left[r]);
                    above = r > 0 ? add(above, left[r - 1]) : above;
                    sum[r] = div(above, sub(u[i + q], u[i]));
                }
                if (place[i + 1] < place[i + q + 1]) {
                    num above = mul(sub(u[i + q + 1], t), right[r]);
                    above = r > 0 ? sub(above, right[r - 1]) : above;
                    sum[r] = add(sum[r], div(above, sub(u[i + q + 1], u[i + 1])));
                }
            }
            for (int r = 0; r < rows; r++)
                left[r] = sum[r];
        }
    for (int m = 0; m <= p; m++)
        for (int r = 0; r < rows; r++)
            N[m * rows + r] = value[m * rows + r];
}

/* q = a/b and c = a b as power series. */
static inline void G(series_quotient)(int rows, const num a[], const num b[], num q[])
{
    for (int r = 0; r < rows; r++) {
        num rest = a[r];
        for (int j = 0; j < r; j++)
            rest = sub(rest, mul(q[j], b[r - j]));
        q[r] = div(rest, b[0]);
    }
}
static inline void G(series_product)(int rows, const num a[], const num b[], num c[])
{
    for (int r = 0; r < rows; r++) {
        c[r] = from_int(0);
        for (int j = 0; j <= r; j++)
            c[r] = add(c[r], mul(a[j], b[r - j]));
    }
}

/* The rank of the rows x columns matrix A, which is destroyed, over the rationals: Gaussian elimination. */
#if RATIONAL
static inline int rank_over_q(int rows, int columns, num A[])
{
    int rank = 0;
    for (int c = 0; c < columns; c++) {
        int pivot = rank;
        while (pivot < rows && is_zero_q(A[pivot * columns + c]))
            pivot++;
        if (pivot == rows)
            continue;
        for (int k = 0; k < columns; k++) {
            num kept = A[pivot * columns + k];
            A[pivot * columns + k] = A[rank * columns + k];
            A[rank * columns + k] = kept;
        }
        for (int i = rank + 1; i < rows; i++) {
            num factor = div(A[i * columns + c], A[rank * columns + c]);
            for (int k = c; k < columns; k++)
                A[i * columns + k] = sub(A[i * columns + k], mul(factor, A[rank * columns + k]));
        }
        rank++;
    }
    return rank;
}
#endif
#include "chapters/judge/claims_off.h"
