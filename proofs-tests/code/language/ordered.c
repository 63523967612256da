/* Addresses of different arrays are neither ordered nor subtracted, where the job asks for that. */
#include <stdlib.h>

/* = F(1, 3) + 3 */
double d_of_one_array(void) { double a[4] = {1.0 / 3, 1, 2, 3}, s = 0; for (double *p = a; p < a + 1; p++) s += *p; return s + ((a + 3) - a); }
/* = 1 + 2 + 4 + 8 */
double d_up_to_its_end(void) { double *a = malloc(32), *end = a + 4; return (a < end) + 2 * (end >= a) + 4 * (end - a == 4) + 8 * !(a > end); }
/* = 1 */
double d_equality(void) { double a[2], b[2], *p = a, *q = b; return p != q && !(p == q) && p != NULL; }
/* ! addresses of different arrays are compared, which C does not define */
double d_less(void)
{
    double a[2], b[2], *p = a, *q = b;
    return p < q; // here
}
/* ! addresses of different arrays are compared, which C does not define */
double d_not_less(void)
{
    double *p = malloc(8), *q = malloc(8);
    return p >= q; // here
}
/* ! addresses of different arrays are compared, which C does not define */
double d_distance(void)
{
    double a[2], b[2], *p = a, *q = b;
    return q - p; // here
}
