/* equidistant-knots.figure.c -- drawings for equidistant-knots.claims.h. */
#include "chapters/nurbs/matrix-figures.h"

FIGURE(uniform_matrices)
{
    svg *s = svg_new("uniform_matrices", "The matrices of equidistant knots",
                     "The coefficient matrices of equidistant knots of the orders 2, 3, 4 and 5, each multiplied by "
                     "(k-1)! so that its "
                     "entries are integers.");
    static const char *const caption[] = {"$k=2$", "$k=3$, times 2!", "$k=4$, times 3!", "$k=5$, times 4!"};
    for (int k = 2, factorial = 1; k <= 5; factorial *= k, k++) {
        num_q A[25];
        bspline_matrix_uniform_q(k - 1, A);
        for (int m = 0; m < k * k; m++)
            A[m] = mul_q(q(factorial), A[m]);
        put_matrix(s, k, A, 46, caption[k - 2]);
    }
    return s;
}

/* The fourth sum of the chain with the letter l and with the digit 1 in the exponent, k = 3. */
FIGURE(uniform_letter)
{
    enum { k = 3 };
    num_q A[k * k], B[k * k];
    svg *s = svg_new(
        "uniform_letter", "A letter for a digit",
        "The matrix of equidistant knots of order 3, and what the last sum of the chain gives with the exponent "
        "k-l-j as it is printed.");
    bspline_matrix_uniform_q(k - 1, A);
    static const long factorial[] = {1, 1, 2, 6};
    for (int j = 0; j < k; j++)
        for (int i = 0; i < k; i++) {
            num_q sum = q(0);
            for (int l = 0; l <= i; l++) {
                num_q power = q(1);
                for (int m = 0; m < (k - l - j < 0 ? l + j - k : k - l - j); m++)
                    power = k - l - j < 0 ? div_q(power, q(i - l + 1)) : mul_q(power, q(i - l + 1));
                power = mul_q(power, r(l % 2 == 0 ? 1 : -1, factorial[k - l] * factorial[l]));
                sum = add_q(sum, power);
            }
            B[j * k + i] = mul_q(q((j % 2 == 0 ? 1 : -1) * k * binomial(k - 1, j)), sum);
        }
    put_matrix(s, k, B, 76, "the exponent as printed, $k=3$");
    svg_heading(s, SVG_WRONG, "$k-l-j$");
    put_matrix(s, k, A, 76, "the exponent put right");
    svg_heading(s, SVG_RIGHT, "$k-1-j$");
    return s;
}
