/*
# The B-spline basis (B 样条基)

A B-spline is a piecewise polynomial that is as smooth as its knots allow and vanishes outside the shortest interval on
which it can: $N_{i,p}$ lives on $[u_i,u_{i+p+1}]$.  The recursion of de Boor and Cox defines it,

$$N_{i,0}=\begin{cases}1,&u_i\le t<u_{i+1}\\0,&\text{otherwise}\end{cases},\qquad
N_{i,p}(t)=\frac{t-u_i}{u_{i+p}-u_i}N_{i,p-1}(t)+\frac{u_{i+p+1}-t}{u_{i+p+1}-u_{i+1}}N_{i+1,p-1}(t),$$

where a fraction with the denominator $0$ counts as $0$.  On a span only $p+1$ of these functions do not vanish; the
kernel computes just these, and on the span no denominator is $0$.

:::{claim} bspline_basis_follows_definition
:title: The values of the kernel are the B-splines of the span, and the others vanish there
:zh: 核函数所算的值即该区间上的 B 样条基
:given: knots of every pattern of multiplicities in the list of the claim, their distinct values variables; every interval
  of the domain; any $t$
:then: `bspline_basis` gives $N_{\mu-p,p}(t),\dots,N_{\mu,p}(t)$, and $N_{i,p}=0$ on the span for every other $i$
:method: The kernel against the recursion of de Boor and Cox by its letter, for each index $i$ of the knot vector.
:degrees: 0..4 sampled 7
:defines: basis_level bspline_basis
:control: the span of the interval replaced by its neighbour on the left or, in the first interval, on the right
:::
*/
#include "chapters/nurbs/definition.h"

#include "chapters/frame/claims_on.h"

/* Patterns for degree p: simple knots, clamped ends, double and multiple inner knots up to the order, unclamped
 * ends that are multiple. */
static const char *const patterns[][6] = {
    {"111", "121", "2", "11", NULL},
    {"11111", "2112", "22", "1221", "1122", NULL},
    {"1111111", "3113", "33", "32123", "1121211", NULL},
    {"111111111", "41214", "44", "4314", "112122", NULL},
    {"11111111111", "51115", "55", "524135", NULL},
    {"1111111111111", "61126", "66", "624136", NULL},
    {"111111111111111", "71127", "77", "725137", NULL},
    {"11111111111111111", "811218", "88", "836148", NULL},
};

CLAIM(bspline_basis_follows_definition)
{
    int p = T->degree;
    num u[MOST_KNOTS], N[MAX_DEGREE + 1], t = parameter(T, "t");
    int place[MOST_KNOTS];
    for (int k = 0; patterns[p][k] != NULL; k++) {
        int count = G(knots_of_pattern)(T, patterns[p][k], u, place), n = count - p - 1;
        for (int interval = place[p]; interval < place[n]; interval++) {
            int mu = G(span_of_interval)(count, place, interval), used = mu;
            if (T->planted && interval + 1 < place[n])
                used = G(span_of_interval)(count, place, interval + 1);
            else if (T->planted && interval > place[p])
                used = G(span_of_interval)(count, place, interval - 1);
            G(bspline_basis)(p, u, used, t, N);
            about(T, "N_i on the span");
            for (int i = 0; i < n; i++) {
                num value = i < mu - p || i > mu ? from_int(0) : N[i - mu + p];
                same(T, value, G(cox_de_boor)(p, u, place, i, interval, t));
            }
        }
    }
}
#include "chapters/frame/claims_off.h"
