#include "exact/record/resultant.h"

#include "exact/decide/with.h"
#include "exact/record/number.h"
#include "exact/record/trace.h"
#include "exact/words.h"

num_q cagd_testify_pivoted_determinant_q(int n, const num_q A[])
{
    cagd_trace_pause();
    num_q answer = cagd_pivoted_determinant_q(n, A);
    cagd_trace_resume();
    if (cagd_trace_noting()) {
        cagd_trace_fact("determinant");
        cagd_trace_put("rows", n);
        cagd_trace_put_numbers("A", n * n, A);
        cagd_trace_put_numbers("is", 1, &answer);
        cagd_trace_fact_end();
    }
    return answer;
}

num_f cagd_testify_pivoted_determinant_f(int n, const num_f A[])
{
    return cagd_pivoted_determinant_with_f(cagd_testify_is_zero_f, n, A);
}

num_f cagd_testify_resultant_by_f(num_f p, num_f q, num_f variable)
{
    return cagd_resultant_with_f(cagd_testify_pivoted_determinant_f, p, q, variable);
}
