#include "exact/record/hull.h"

#include "exact/decide/with.h"
#include "exact/record/trace.h"
#include "exact/words.h"

static const struct cagd_order testified = {cagd_testify_compare_q, cagd_testify_sign_q, cagd_testify_equal_q};

struct cagd_hull_certificate cagd_testify_hull_membership(int d, int count, const num_q points[], const num_q x[])
{
    cagd_trace_pause();
    struct cagd_hull_certificate answer = cagd_hull_membership(d, count, points, x);
    cagd_trace_resume();
    if (cagd_trace_noting()) {
        cagd_trace_fact("hull");
        cagd_trace_put("dim", d);
        cagd_trace_put_numbers("points", d * count, points);
        cagd_trace_put_numbers("x", d, x);
        cagd_trace_put("is", answer.inside);
        if (answer.inside)
            cagd_trace_put_numbers("coefficients", count, answer.coefficient);
        else {
            cagd_trace_put_numbers("normal", d, answer.normal);
            cagd_trace_put_numbers("offset", 1, &answer.offset);
        }
        cagd_trace_fact_end();
    }
    return answer;
}

int cagd_testify_hull_certificate_holds(int d, int count, const num_q points[], const num_q x[],
                                        struct cagd_hull_certificate c)
{
    return cagd_hull_certificate_holds_with(&testified, d, count, points, x, c);
}

int cagd_testify_turn_2d(const num_q P[2], const num_q Q[2], const num_q R[2])
{
    return cagd_turn_2d_with(&testified, P, Q, R);
}

int cagd_testify_polygon_is_convex(int n, const num_q points[], int closed, int *orientation)
{
    cagd_trace_pause();
    int side = 0, answer = cagd_polygon_is_convex(n, points, closed, &side);
    cagd_trace_resume();
    if (orientation != NULL)
        *orientation = side;
    if (cagd_trace_noting()) {
        cagd_trace_fact("convex_polygon");
        cagd_trace_put_numbers("points", 2 * n + 2, points);
        cagd_trace_put("closed", closed != 0);
        cagd_trace_put("orientation", side);
        cagd_trace_put("is", answer != 0);
        cagd_trace_fact_end();
    }
    return answer;
}

int cagd_testify_convex_hull_2d(int count, const num_q points[], int vertex[])
{
    cagd_trace_pause();
    int answer = cagd_convex_hull_2d(count, points, vertex);
    cagd_trace_resume();
    if (cagd_trace_noting()) {
        cagd_trace_fact("hull_vertices");
        cagd_trace_put_numbers("points", 2 * count, points);
        cagd_trace_put_list("vertices", answer, vertex);
        cagd_trace_fact_end();
    }
    return answer;
}
