/* The forms for long double, where it is a double (-mlong-double-64). */
#include <math.h>

/* = F(1, 3) */
double h_number(void) { long double x = 1.0L / 3; return (double)x; }
/* = F(1, 3) + 10 * 6 + 100 * 7 */
double h_one(void) { return (double)(fabsl(-1.0L / 3) + 10 * floorl(20.0L / 3) + 100 * ceill(20.0L / 3)); }
/* = F(3, 7) + 10 * -4 + 100 * -3 */
double h_more(void) { return (double)(sqrtl(9.0L / 49) + 10 * roundl(-7.0L / 2) + 100 * truncl(-7.0L / 2)); }
/* = F(8, 27) + 10 * F(2, 3) - 100 * F(1, 3) */
double h_two(void) { return (double)(powl(2.0L / 3, 3) + 10 * fmodl(20.0L / 3, 2) + 100 * copysignl(1.0L / 3, -2)); }
/* = F(1, 6) + 10 * F(1, 3) + 100 * F(1, 2) */
double h_least_and_greatest(void) { return (double)(fdiml(1.0L / 2, 1.0L / 3) + 10 * fminl(1.0L / 3, 1.0L / 2) + 100 * fmaxl(1.0L / 3, 1.0L / 2)); }
/* = F(-1, 3) + 10 * F(5, 12) */
double h_rest(void) { return (double)(remainderl(17.0L / 3, 2) + 10 * hypotl(1.0L / 4, 1.0L / 3) + atan2l(0, 3)); }
