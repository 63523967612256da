/* The two points of Gauss on [0, 1], where t^2 - t + 1/6 vanishes: from below, to one thousandth. */
#include <cagd_exact.h>
#include <stdio.h>
int main(void)
{
    cagd_num_q zero = cagd_from_int_q(0), one = cagd_from_int_q(1), width = cagd_from_string_q("1e-3");
    cagd_num_q c[] = {cagd_from_ratio_q(1, 6), cagd_neg_q(one), one};
    struct cagd_root root[2];
    int count = cagd_isolate_roots(cagd_poly_from_q(3, c), zero, one, root, 2);
    for (int k = 0; k < count; k++)
        printf("%.3f ", cagd_to_double_q(cagd_refine_root(root[k], width).lo));
    return printf("%d\n", count), cagd_thread_end(), cagd_region_faults != 0;
}
