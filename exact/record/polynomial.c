#include "exact/record/polynomial.h"

#include "exact/record/trace.h"
#include "exact/words.h"

/* Of p and q, or of p alone. */
static int noted(const char *kind, poly p, const poly *q, int is)
{
    if (cagd_trace_noting()) {
        int i = cagd_node_of_poly(p), j = q != NULL ? cagd_node_of_poly(*q) : -1;
        cagd_trace_relation(kind, i, j, is);
    }
    return is;
}

int cagd_testify_poly_degree(poly p) { return noted("degree", p, NULL, cagd_poly_degree(p)); }
int cagd_testify_poly_is_zero(poly p) { return noted("pequal", p, NULL, cagd_poly_is_zero(p)); }
int cagd_testify_poly_equal(poly p, poly q) { return noted("pequal", p, &q, cagd_poly_equal(p, q)); }
int cagd_testify_poly_divides(poly d, poly p)
{
    return cagd_testify_poly_is_zero(cagd_poly_degree(d) < 0 ? p : poly_remainder(p, d));
}
