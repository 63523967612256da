#include "exact/record/crossings.h"

#include "exact/record/trace.h"
#include "exact/words.h"

struct cagd_curve_meets_line cagd_testify_curve_meets_line(int n, const num_q R[], const num_q w[],
                                                           struct cagd_line line)
{
    cagd_trace_pause();
    struct cagd_curve_meets_line answer = cagd_curve_meets_line(n, R, w, line);
    cagd_trace_resume();
    if (cagd_trace_noting()) {
        num_q l[3] = {line.a, line.b, line.c};
        cagd_trace_fact("curve_and_line");
        cagd_trace_put_numbers("R", 2 * n + 2, R);
        cagd_trace_put_numbers("w", n + 1, w);
        cagd_trace_put_numbers("line", 3, l);
        cagd_trace_put_list("is", 7,
                            (int[]){answer.contained, answer.common_closed, answer.common_open, answer.crossings,
                                    answer.touches, answer.poles, answer.jumps});
        cagd_trace_fact_end();
    }
    return answer;
}

struct cagd_polygon_meets_line cagd_testify_polygon_meets_line(int n, const num_q R[], struct cagd_line line)
{
    cagd_trace_pause();
    struct cagd_polygon_meets_line answer = cagd_polygon_meets_line(n, R, line);
    cagd_trace_resume();
    if (cagd_trace_noting()) {
        num_q l[3] = {line.a, line.b, line.c};
        cagd_trace_fact("polygon_and_line");
        cagd_trace_put_numbers("R", 2 * n + 2, R);
        cagd_trace_put_numbers("line", 3, l);
        cagd_trace_put_list("is", 4,
                            (int[]){answer.crossings, answer.common_runs, answer.components, answer.contained_edges});
        cagd_trace_fact_end();
    }
    return answer;
}

int cagd_testify_polygon_crossings(int n, const num_q R[], struct cagd_line line)
{
    return cagd_testify_polygon_meets_line(n, R, line).crossings;
}
