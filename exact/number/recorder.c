#include "exact/number/recorder.h"

_Thread_local struct cagd_recorder *cagd_recorder;

void *cagd_fresh_slot(enum cagd_slot_kind kind)
{
    void *slot = cagd_region_slot(kind);
    if (cagd_recorder != NULL)
        cagd_recorder->fresh(slot);
    return slot;
}

int cagd_node_of_q(cagd_num_q a)
{
    if (cagd_recorder->known(a.at) < 0)
        cagd_recorder->literal(a.at, "o", 1, &a);
    return cagd_recorder->known(a.at);
}

int cagd_node_of_f(cagd_num_f a)
{
    if (cagd_recorder->known(a.at) < 0)
        cagd_recorder->text(a.at, "f", cagd_to_string_f(a));
    return cagd_recorder->known(a.at);
}

int cagd_node_of_poly(cagd_poly p)
{
    if (cagd_recorder->known(p.at) < 0) {
        int length = cagd_poly_degree(p) + 1, noting = cagd_recorder->noting;
        cagd_num_q *c = cagd_region_array(1, length, sizeof *c);
        if (c == NULL)
            return -1;
        cagd_recorder->noting = 0;
        for (int k = 0; k < length; k++)
            c[k] = cagd_poly_coefficient(p, k);
        cagd_recorder->noting = noting;
        cagd_recorder->literal(p.at, "opoly", length, c);
    }
    return cagd_recorder->known(p.at);
}
