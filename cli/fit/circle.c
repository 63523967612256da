/* circle.c -- what is told of a conic in one segment that the points do not tell from an arc of a circle. */
#include "chapters/judge/memory_text.h"
#include "cli/fit/fit.h"

#include <math.h>
#include <stdlib.h>

/* Distances that are no noise say nothing by an F test. */
int tells_circle(const struct fit *f)
{
    return f->circle.known && cagd_fit_is_minimum(f->result) && !(f->quality.problems & CAGD_FIT_STRUCTURE);
}

/* The number +- half of its 95 % interval; both ends where that does not lie about it, as of a short arc; the number alone where there is none. */
static void put_with_interval(FILE *out, cagd_fit_number x)
{
    const double below = x.value - x.low, above = x.high - x.value;
    put_rounded(out, 0, x.value, x.error);
    if (!isfinite(below) || !isfinite(above))
        return;
    if (fabs(above - below) < (above + below) / 20) {
        fputs(" ± ", out);
        put_rounded(out, 0, (above + below) / 2, x.error);
        return;
    }
    fputs(", from ", out);
    put_rounded(out, 0, x.low, x.error);
    fputs(" to ", out);
    put_rounded(out, 0, x.high, x.error);
}

void print_circle(const struct fit *f)
{
    const cagd_fit_circle *c = &f->circle;
    char *text;
    size_t size;
    if (!tells_circle(f))
        return;
    FILE *out = text_open(&text, &size);
    fputs("radius ", out);
    put_with_interval(out, c->radius);
    fputs("; centre x ", out);
    put_with_interval(out, c->centre[0]);
    fputs("; centre y ", out);
    put_with_interval(out, c->centre[1]);
    text_close(out, &text);
    say("Circle",
        "%s%s; an arc of %.4g degrees, not contradicted by the points (F = %.3g with 2 and %d degrees of freedom "
        "against the conic, probability %.2g by "
        "chance; rms %.4g)",
        text,
        isfinite(c->radius.high) ? ", at 95 %"
                                 : ", without intervals, since the distances are more than a twentieth of the radius",
        c->sweep, c->ratio, c->freedom, c->probability, c->rms);
    free(text);
}
