#include "exact/record/number.h"

#include "exact/record/trace.h"
#include "exact/words.h"

/* Of a and b, or of a and 0. */
static int noted(const char *kind, num_q a, const num_q *b, int is)
{
    if (cagd_trace_noting()) {
        int i = cagd_node_of_q(a), j = b != NULL ? cagd_node_of_q(*b) : -1;
        cagd_trace_relation(kind, i, j, is);
    }
    return is;
}
static int sign(int x) { return (x > 0) - (x < 0); }

int cagd_testify_sign_q(num_q a) { return noted("order", a, NULL, sign(cagd_sign_q(a))); }
int cagd_testify_compare_q(num_q a, num_q b) { return noted("order", a, &b, sign(cagd_compare_q(a, b))); }
int cagd_testify_equal_q(num_q a, num_q b) { return noted("equal", a, &b, cagd_equal_q(a, b)); }
int cagd_testify_is_zero_q(num_q a) { return noted("equal", a, NULL, cagd_is_zero_q(a)); }
int cagd_testify_is_whole_q(num_q a) { return noted("whole", a, NULL, cagd_is_whole_q(a)); }

int cagd_testify_is_zero_f(num_f a)
{
    int zero = cagd_is_zero_f(a);
    if (cagd_trace_noting())
        cagd_trace_relation("equal", cagd_node_of_f(a), -1, zero);
    return zero;
}

/* The degrees themselves are the fact. */
int cagd_testify_has_degrees_f(num_f a, num_f variable, int numerator, int denominator)
{
    if (cagd_trace_noting()) {
        int is[] = {degree_f(a, variable), denominator_degree_f(a, variable)};
        int of[] = {cagd_node_of_f(a), cagd_node_of_f(variable)};
        if (cagd_trace_fact("degrees")) {
            cagd_trace_put_list("of", 2, of);
            cagd_trace_put_list("is", 2, is);
            cagd_trace_fact_end();
        }
    }
    return cagd_has_degrees_f(a, variable, numerator, denominator);
}

void cagd_testify_operations(int count, const num_q out[], int additions, int multiplications, int shifts)
{
    if (!cagd_trace_noting())
        return;
    cagd_trace_fact("operations");
    cagd_trace_put_numbers("out", count, out);
    cagd_trace_put("additions", additions);
    cagd_trace_put("multiplications", multiplications);
    cagd_trace_put("shifts", shifts);
    cagd_trace_fact_end();
}
