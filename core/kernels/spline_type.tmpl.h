/* spline_type.tmpl.h -- a B-spline curve of degree p as the kernels take it, with weights a NURBS curve.
 *
 * count points of dim coordinates, count > degree: coordinate c of point i is points[i*dim + c]; count+degree+1 knots; as many
 * weights as points, or NULL.  For binary64 it is the cagd_spline of cagd.h, for rationals the cagd_spline_q of exact/curve. */
struct G(spline) {
    int degree, count, dim;
    const G(num) *knots, *points, *weights;
};
