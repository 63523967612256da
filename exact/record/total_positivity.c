#include "exact/record/total_positivity.h"

#include "exact/record/trace.h"
#include "exact/words.h"

/* All minors are >= 0, or > 0 if strict, or not all. */
static int noted(int rows, int columns, const num_q A[], int strict, int is)
{
    if (cagd_trace_noting()) {
        cagd_trace_fact("minors");
        cagd_trace_put("rows", rows);
        cagd_trace_put("columns", columns);
        cagd_trace_put_numbers("A", rows * columns, A);
        cagd_trace_put("strict", strict != 0);
        cagd_trace_put("is", is != 0);
        cagd_trace_fact_end();
    }
    return is;
}

int cagd_testify_is_totally_nonnegative(int rows, int columns, const num_q A[])
{
    cagd_trace_pause();
    int answer = cagd_is_totally_nonnegative(rows, columns, A);
    cagd_trace_resume();
    return noted(rows, columns, A, 0, answer);
}
int cagd_testify_is_totally_positive(int rows, int columns, const num_q A[])
{
    cagd_trace_pause();
    int answer = cagd_is_totally_positive(rows, columns, A);
    cagd_trace_resume();
    return noted(rows, columns, A, 1, answer);
}
int cagd_testify_all_minors_nonnegative(int rows, int columns, const num_q A[], int strict, struct cagd_minor *worst)
{
    cagd_trace_pause();
    int answer = cagd_all_minors_nonnegative(rows, columns, A, strict, worst);
    cagd_trace_resume();
    return noted(rows, columns, A, strict, answer);
}
