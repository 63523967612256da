#include "exact/expression/run.h"

/* The sides of the box of all variables that are known. */
int cagd_sides_of_known(const cagd_context *c, cagd_side_of_box side[], int of[])
{
    int count = 0;
    for (int k = 0; k < c->count; k++) {
        const cagd_binding *b = &c->binding[k];
        if (!b->unknown)
            continue;
        of[count] = k;
        side[count++] =
            (cagd_side_of_box){b->value.f, b->has_low, b->has_high, b->low_open, b->high_open, b->low, b->high};
    }
    return count;
}

cagd_answer cagd_worse(cagd_answer a, cagd_answer b)
{
    return a == CAGD_FAILS || b == CAGD_FAILS ? CAGD_FAILS : a == CAGD_UNDECIDED ? a : b;
}

void cagd_weaken(cagd_finding *f, cagd_strength s)
{
    f->strength = f->strength == CAGD_BY_NOTHING || s < f->strength ? s : f->strength;
}

cagd_answer cagd_note_undecided(cagd_run *r, const cagd_context *c, const char *why)
{
    if (r->out->why == NULL) {
        r->out->why = c->trouble != NULL ? c->trouble : why;
        r->out->where = c->trouble != NULL ? c->where : NULL;
    }
    return CAGD_UNDECIDED;
}
