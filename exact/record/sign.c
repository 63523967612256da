#include "exact/record/sign.h"

#include "exact/record/trace.h"
#include "exact/words.h"

enum cagd_sign_pattern cagd_testify_sign_on(poly p, num_q a, num_q b, enum cagd_ends ends)
{
    cagd_trace_pause();
    enum cagd_sign_pattern answer = cagd_sign_on(p, a, b, ends);
    cagd_trace_resume();
    if (cagd_trace_noting()) {
        int node = cagd_node_of_poly(p), low = cagd_node_of_q(a), high = cagd_node_of_q(b);
        cagd_trace_fact("sign");
        cagd_trace_put("p", node);
        cagd_trace_put_list("from", 2, (int[]){low, high});
        cagd_trace_put_list("with_ends", 2,
                            (int[]){ends == CLOSED || ends == OPEN_RIGHT, ends == CLOSED || ends == OPEN_LEFT});
        cagd_trace_put("is", (int)answer);
        cagd_trace_fact_end();
    }
    return answer;
}

int cagd_testify_is_nonnegative_on(poly p, num_q a, num_q b)
{
    return cagd_is_nonnegative(cagd_testify_sign_on(p, a, b, CLOSED));
}
