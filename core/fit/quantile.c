#include "core/fit/quantile.h"

#include <float.h>
#include <math.h>

static const long double normal_quantile = 1.959963984540054235524594430520551527956L;

double fit_normal_quantile(void) { return (double)normal_quantile; }

/* P(|T| <= t) with theta = atan(t/sqrt(nu)), in closed form:
 *     nu odd     2/pi (theta + sin theta cos theta (1 + 2/3 c (1 + 4/5 c (1 + ... (nu-3)/(nu-2) c)))),   c = cos^2 theta,
 *     nu even    sin theta (1 + 1/2 c (1 + 3/4 c (1 + ... (nu-3)/(nu-2) c))).
 * Source: abramowitz-stegun-1964, 26.7.3 and 26.7.4. */
static long double student_probability(int nu, long double theta, long double *density)
{
    const long double pi = 3.141592653589793238462643383279502884L;
    long double c = cosl(theta) * cosl(theta), sum = 1, factor = 1;
    for (int j = nu - 3; j > 0; j -= 2) {
        const long double part = c / (long double)(j + 1);
        sum = 1 + sum * part * (long double)j;
        factor *= part * (long double)(j + 2);
    }
    if (nu % 2 == 0) { /* dP/dtheta = cos theta (1 + 1/2) (1 + 1/4) ... c^{nu/2-1} */
        *density = factor * cosl(theta);
        return sinl(theta) * sum;
    }
    if (nu == 1) {
        *density = 2 / pi;
        return 2 / pi * theta;
    }
    *density = 2 / pi * factor * 2 * c; /* the first factor of the product, 2/1 c, has no j */
    return 2 / pi * (theta + sinl(theta) * cosl(theta) * sum);
}

/* For many degrees of freedom the expansion about the normal quantile is used, whose first term left out is of the
 * size of nu^{-5} < 2^{-61}.  For fewer, P is increasing and concave in theta, hence Newton's method from the left
 * increases to the solution; it ends when rounding stops it.  It begins with three terms of the expansion, which all
 * lie below.  Source: abramowitz-stegun-1964, 26.7.5. */
double fit_student_quantile(int nu)
{
    const long double wanted = 0.95L, z = normal_quantile, n = nu, y = z * z;
    if (nu < 1)
        return NAN;
    const long double g1 = z * (y + 1) / 4, g2 = z * ((5 * y + 16) * y + 3) / 96;
    if (nu > 5000) {
        long double g3 = z * (((3 * y + 19) * y + 17) * y - 15) / 384;
        long double g4 = z * ((((79 * y + 776) * y + 1482) * y - 1920) * y - 945) / 92160;
        return (double)(z + (g1 + (g2 + (g3 + g4 / n) / n) / n) / n);
    }
    long double theta = atanl((z + (g1 + g2 / n) / n) / sqrtl(n)), density;
    for (int step = 0; step < 64; step++) {
        long double missing = wanted - student_probability(nu, theta, &density), next = theta + missing / density;
        if (!(next > theta))
            break;
        theta = next;
    }
    return (double)(sqrtl(n) * tanl(theta));
}

/* The regularised incomplete beta function I_x(a, b) by its continued fraction (Lentz), for x < (a+1)/(a+b+2); otherwise
 * 1 - I_{1-x}(b, a).  Source: abramowitz-stegun-1964, 26.5.8. */
static double incomplete_beta(double a, double b, double x)
{
    if (!(x > 0) || x >= 1)
        return x > 0;
    if (x > (a + 1) / (a + b + 2))
        return 1 - incomplete_beta(b, a, 1 - x);
    const double tiny = 1e-300;
    double c = 1, d = 1 - (a + b) * x / (a + 1), value;
    d = 1 / (fabs(d) > tiny ? d : tiny);
    value = d;
    for (int m = 1; m < 1000; m++) {
        double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)),
               odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 + even * d, c = 1 + even / c;
        d = 1 / (fabs(d) > tiny ? d : tiny), c = fabs(c) > tiny ? c : tiny;
        value *= c * d;
        d = 1 + odd * d, c = 1 + odd / c;
        d = 1 / (fabs(d) > tiny ? d : tiny), c = fabs(c) > tiny ? c : tiny;
        value *= c * d;
        if (fabs(c * d - 1) <= DBL_EPSILON)
            break;
    }
    return exp(a * log(x) + b * log1p(-x) + lgamma(a + b) - lgamma(a) - lgamma(b)) / a * value;
}

double fit_f_probability(double x, double m, double d) { return incomplete_beta(d / 2, m / 2, d / (d + m * x)); }
