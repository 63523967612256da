/* span_type.tmpl.h -- a span as the kernels take it: degree p, dim, knots u, the span mu, and the points and weights of
 * bspline.tmpl.h and nurbs.tmpl.h, of which c_{mu-p}, ..., c_mu are read.  What a kernel does not read may be NULL. */
struct G(curve_span) {
    int degree, dim;
    const G(num) * knots;
    int mu;
    const G(num) * points, *weights;
};

/* A span of a B-spline curve, of its n points c; of a NURBS curve, of its n points R and weights w. */
static inline struct G(curve_span) G(on_span)(int p, int dim, const G(num) u[], int mu, const G(num) c[])
{
    return (struct G(curve_span)){p, dim, u, mu, c, NULL};
}
static inline struct G(curve_span)
    G(nurbs_on_span)(int p, int dim, const G(num) u[], int mu, const G(num) R[], const G(num) w[])
{
    return (struct G(curve_span)){p, dim, u, mu, R, w};
}

/* The same of the p+1 points d = c_{mu-p}, ..., c_mu alone: with the knots from u_{mu-p} on it is the span p. */
static inline struct G(curve_span) G(span_alone)(int p, int dim, const G(num) u[], int mu, const G(num) d[])
{
    return G(on_span)(p, dim, u + (mu - p), p, d);
}

/* A span of a curve. */
static inline struct G(curve_span) G(span_of_curve)(const struct G(spline) * curve, int mu)
{
    return G(nurbs_on_span)(curve->degree, curve->dim, curve->knots, mu, curve->points, curve->weights);
}
