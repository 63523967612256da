/* quantile.h -- how many standard errors an interval of 95 % reaches to either side (分位数). */
#ifndef CAGD_FIT_QUANTILE_H
#define CAGD_FIT_QUANTILE_H

/* z with P(|Z| <= z) = 0.95 for the normal distribution. */
double fit_normal_quantile(void);

/* t with P(|T| <= t) = 0.95 for Student's distribution with nu >= 1 degrees of freedom, within one
 * unit of the last place where long double is longer than double; NaN for nu < 1. */
double fit_student_quantile(int nu);
/* P(F > x) of Fisher's F with m and d degrees of freedom: the regularised incomplete beta function I_{d/(d+mx)}(d/2, m/2). */
double fit_f_probability(double x, double m, double d);
#endif
