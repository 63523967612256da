#include "exact/record/roots.h"

#include "exact/record/trace.h"
#include "exact/words.h"

/* The counts over an interval; an end that is NULL is infinite. */
static struct cagd_root_count noted(poly p, const num_q *a, const num_q *b, enum cagd_ends ends,
                                    struct cagd_root_count is)
{
    if (cagd_trace_noting()) {
        int node = cagd_node_of_poly(p), low = a != NULL ? cagd_node_of_q(*a) : -1,
            high = b != NULL ? cagd_node_of_q(*b) : -1;
        cagd_trace_fact("roots");
        cagd_trace_put("p", node);
        cagd_trace_put_list("from", 2, (int[]){low, high});
        cagd_trace_put_list("with_ends", 2,
                            (int[]){ends == CLOSED || ends == OPEN_RIGHT, ends == CLOSED || ends == OPEN_LEFT});
        cagd_trace_put("distinct", is.distinct);
        if (is.counted >= 0) { /* not where only the different roots were counted */
            cagd_trace_put("counted", is.counted);
            cagd_trace_put("crossings", is.crossings);
            cagd_trace_put("touches", is.touches);
        }
        cagd_trace_fact_end();
    }
    return is;
}

struct cagd_root_count cagd_testify_count_roots(poly p, num_q a, num_q b, enum cagd_ends ends)
{
    cagd_trace_pause();
    struct cagd_root_count answer = cagd_count_roots(p, a, b, ends);
    cagd_trace_resume();
    return noted(p, &a, &b, ends, answer);
}
struct cagd_root_count cagd_testify_count_roots_line(poly p)
{
    cagd_trace_pause();
    struct cagd_root_count answer = cagd_count_roots_line(p);
    cagd_trace_resume();
    return noted(p, NULL, NULL, OPEN, answer);
}
struct cagd_root_count cagd_testify_count_roots_above(poly p, num_q a)
{
    cagd_trace_pause();
    struct cagd_root_count answer = cagd_count_roots_above(p, a);
    cagd_trace_resume();
    return noted(p, &a, NULL, OPEN, answer);
}
struct cagd_root_count cagd_testify_count_roots_below(poly p, num_q b)
{
    cagd_trace_pause();
    struct cagd_root_count answer = cagd_count_roots_below(p, b);
    cagd_trace_resume();
    return noted(p, NULL, &b, OPEN, answer);
}

int cagd_testify_isolate_roots(poly p, num_q a, num_q b, struct cagd_root out[], int room)
{
    cagd_trace_pause();
    int answer = cagd_isolate_roots(p, a, b, out, room);
    cagd_trace_resume();
    return noted(p, &a, &b, CLOSED, (struct cagd_root_count){answer, -1, -1, -1}).distinct;
}
