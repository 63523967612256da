#include "exact/record/sturm.h"

#include "exact/record/trace.h"
#include "exact/words.h"

/* In the form of roots.c, of different roots alone; an end that is NULL is infinite, the right one counts. */
static int noted(poly p, const num_q *a, const num_q *b, int is)
{
    if (cagd_trace_noting()) {
        int node = cagd_node_of_poly(p), low = a != NULL ? cagd_node_of_q(*a) : -1,
            high = b != NULL ? cagd_node_of_q(*b) : -1;
        cagd_trace_fact("roots");
        cagd_trace_put("p", node);
        cagd_trace_put_list("from", 2, (int[]){low, high});
        cagd_trace_put_list("with_ends", 2, (int[]){0, 1});
        cagd_trace_put("distinct", is);
        cagd_trace_fact_end();
    }
    return is;
}

int cagd_testify_sturm_count(poly p, num_q a, num_q b)
{
    cagd_trace_pause();
    int answer = cagd_sturm_count(p, a, b);
    cagd_trace_resume();
    return noted(p, &a, &b, answer);
}
int cagd_testify_sturm_count_above(poly p, num_q a)
{
    cagd_trace_pause();
    int answer = cagd_sturm_count_above(p, a);
    cagd_trace_resume();
    return noted(p, &a, NULL, answer);
}
int cagd_testify_sturm_count_below(poly p, num_q b)
{
    cagd_trace_pause();
    int answer = cagd_sturm_count_below(p, b);
    cagd_trace_resume();
    return noted(p, NULL, &b, answer);
}
int cagd_testify_sturm_count_line(poly p)
{
    cagd_trace_pause();
    int answer = cagd_sturm_count_line(p);
    cagd_trace_resume();
    return noted(p, NULL, NULL, answer);
}
