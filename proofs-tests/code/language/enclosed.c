/* Numbers that are not rational, in intervals. */
#include <math.h>

/* = math.sqrt(2) */
double e_root(void) { return sqrt(2); }
/* = math.sqrt(2) + math.sqrt(3) */
double e_sum_of_roots(void) { return sqrt(2) + sqrt(3); }
/* = math.sin(1) */
double e_sine(void) { return sin(1); }
/* = math.exp(1/3) */
double e_exponential(void) { return exp(1.0 / 3); }
/* = math.atan(1/3) */
double e_arc(void) { return atan(1.0 / 3); }
/* = 3 * math.log(7) */
double e_logarithm(void) { double x = log(7); return x > 1 ? 3 * x : 0; }
/* = math.acos(0.5) * math.sqrt(5) */
double e_acos(void) { return acos(0.5) * sqrt(5); }
/* = 2 ** (1/3) */
double e_cube_root(void) { return cbrt(2); }
