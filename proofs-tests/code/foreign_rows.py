"""What is asked of libraries that others wrote (foreign.py), and what the routines should compute."""
from typing import NamedTuple

# N_{i,p}(t) and its derivative from their definitions, right of a knot (side 0) or left of it (side 1).
REFERENCE = """
static double N(int i, int p, const double *k, double t, int side)
{
    double a = 0, b = 0;
    if (p == 0)
        return side ? k[i] < t && t <= k[i + 1] : k[i] <= t && t < k[i + 1];
    if (k[i + p] != k[i])
        a = (t - k[i]) / (k[i + p] - k[i]) * N(i, p - 1, k, t, side);
    if (k[i + p + 1] != k[i + 1])
        b = (k[i + p + 1] - t) / (k[i + p + 1] - k[i + 1]) * N(i + 1, p - 1, k, t, side);
    return a + b;
}
static double D(int i, int p, const double *k, double t, int side)
{
    double a = 0, b = 0;
    if (k[i + p] != k[i])
        a = p / (k[i + p] - k[i]) * N(i, p - 1, k, t, side);
    if (k[i + p + 1] != k[i + 1])
        b = p / (k[i + p + 1] - k[i + 1]) * N(i + 1, p - 1, k, t, side);
    return a - b;
}
/* The derivative of order r. */
static double DN(int r, int i, int p, const double *k, double t, int side)
{
    double a = 0, b = 0;
    if (r == 0)
        return N(i, p, k, t, side);
    if (p == 0)
        return 0;
    if (k[i + p] != k[i])
        a = p / (k[i + p] - k[i]) * DN(r - 1, i, p - 1, k, t, side);
    if (k[i + p + 1] != k[i + 1])
        b = p / (k[i + p + 1] - k[i + 1]) * DN(r - 1, i + 1, p - 1, k, t, side);
    return a - b;
}
static double S(int n, int p, const double *k, const double *c, double t, int side)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += c[i] * N(i, p, k, t, side);
    return s;
}
static double SN(int r, int n, int p, const double *k, const double *c, double t, int side)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += c[i] * DN(r, i, p, k, t, side);
    return s;
}
static double DS(int n, int p, const double *k, const double *c, double t, int side)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += c[i] * D(i, p, k, t, side);
    return s;
}
"""


# Functions in C that call the templates of libraries of headers.
EIGEN = """#define EIGEN_DONT_VECTORIZE
#include <unsupported/Eigen/Splines>
template <int P> static void value_and_derivative(int n, const double *k, const double *c, double t, double *R)
{
    typedef Eigen::Spline<double, 1, P> Spline;
    typename Spline::KnotVectorType knots(n + P + 1);
    typename Spline::ControlPointVectorType points(1, n);
    for (int i = 0; i < n + P + 1; i++)
        knots(i) = k[i];
    for (int i = 0; i < n; i++)
        points(0, i) = c[i];
    Spline s(knots, points);
    R[0] = s(t)(0);
    R[1] = s.derivatives(t, 1)(0, 1);
}
""" + "".join(f"""extern "C" void eigen_{p}(int n, const double *k, const double *c, double t, double *R)
{{
    value_and_derivative<{p}>(n, k, c, t, R);
}}
""" for p in range(1, 5))

BOOST = """#include <boost/math/interpolators/barycentric_rational.hpp>
#include <boost/math/interpolators/cubic_hermite.hpp>
#include <boost/math/interpolators/quintic_hermite.hpp>
#include <boost/math/interpolators/makima.hpp>
#include <boost/math/special_functions/legendre.hpp>
typedef std::vector<double> V;
extern "C" double barycentric(int n, int d, const double *x, const double *y, double t)
{
    boost::math::barycentric_rational<double> b(x, y, n, d);
    return b(t);
}
extern "C" void cubic_hermite(int n, const double *x, const double *y, const double *d, double t, double *R)
{
    boost::math::interpolators::cubic_hermite<V> h(V(x, x + n), V(y, y + n), V(d, d + n));
    R[0] = h(t);
    R[1] = h.prime(t);
}
extern "C" void quintic_hermite(int n, const double *x, const double *y, const double *d, const double *e, double t, double *R)
{
    boost::math::interpolators::quintic_hermite<V> h(V(x, x + n), V(y, y + n), V(d, d + n), V(e, e + n));
    R[0] = h(t);
    R[1] = h.prime(t);
}
extern "C" double modified_akima(int n, const double *x, const double *y, double t)
{
    boost::math::interpolators::makima<V> s(V(x, x + n), V(y, y + n));
    return s(t);
}
extern "C" double legendre(int n, double t)
{
    return boost::math::legendre_p(n, t);
}
"""


# SISL copies by memcpy between pieces that overlap, which C leaves undefined: asked is what it computes where that is done as by memmove.
MOVES = ":memcpy: moves\n"


class Row(NamedTuple):
    """What is asked: of which library, for which inputs, by which statements; and what is expected."""
    name: str
    library: str
    inputs: str
    statements: str
    expected: list
    keys: str = ""  # further lines of the block


def curve(p, n):
    return f"SISLCurve *c = newCurve({n}, {p + 1}, k, P, 1, 1, 1);"


def apart(count, first, last):
    """SISL takes for one number what differs by 1e-12 of the larger: the knots, of size 100 at most, are farther apart, and u is
    one of them or farther from them."""
    return (f"\n:where: k[0] > -100 && k[{count - 1}] < 100"
            + "".join(f"\n:where: k[{i}] - k[{i - 1}] > 1.0 / 1000" for i in range(1, count))
            + "".join(f"\n:where: u == k[{i}] || u - k[{i}] > 1.0 / 1000 || k[{i}] - u > 1.0 / 1000" for i in range(first, last + 1)))


def sisl_rows():
    for p in range(1, 5):
        n = p + 2
        knots, inner = f"k[{n + p + 1}] increasing; P[{n}]", f"k[{p}], k[{n}]"
        yield Row(f"s1221_degree_{p}", "sisl", f"{knots}; t in [{inner})",
               f"double R[2]; int left = 0, status; {curve(p, n)} s1221(c, 1, t, &left, R, &status);",
               [f"(R[0]) = S({n}, {p}, k, P, t, 0)", f"(R[1]) = DS({n}, {p}, k, P, t, 0)"])
        yield Row(f"s1227_degree_{p}", "sisl", f"{knots}; t in ({inner}]",
               f"double R[2]; int left = 0, status; {curve(p, n)} s1227(c, 1, t, &left, R, &status);",
               [f"(R[0]) = S({n}, {p}, k, P, t, 1)", f"(R[1]) = DS({n}, {p}, k, P, t, 1)"])
        yield Row(f"s1220_degree_{p}", "sisl", f"k[{n + p + 1}] increasing; t in [{inner})",
               f"double R[{2 * p + 2}], W[{2 * p + 2}]; int left = {p}, status; s1220(k, {p + 1}, {n}, &left, t, 1, R, &status); "
               f"for (int i = 0; i <= {p}; i++) {{ W[2 * i] = N(left - {p} + i, {p}, k, t, 0); "
               f"W[2 * i + 1] = D(left - {p} + i, {p}, k, t, 0); }}", [f"R[{2 * p + 2}] = W"])
        yield Row(f"s1221_rational_degree_{p}", "sisl", f"k[{2 * p + 2}] increasing; P[{p + 1}]; w[{p + 1}] in [1/1000, 4]; t in [k[{p}], k[{p + 1}])",
               f"double R[2], Q[{2 * p + 2}], A[{p + 1}]; int left = 0, status; "
               f"for (int i = 0; i <= {p}; i++) {{ A[i] = Q[2 * i] = w[i] * P[i]; Q[2 * i + 1] = w[i]; }} "
               f"SISLCurve *c = newCurve({p + 1}, {p + 1}, k, Q, 2, 1, 1); s1221(c, 1, t, &left, R, &status); "
               f"double s = S({p + 1}, {p}, k, w, t, 0), x = S({p + 1}, {p}, k, A, t, 0), "
               f"ds = DS({p + 1}, {p}, k, w, t, 0), dx = DS({p + 1}, {p}, k, A, t, 0);",
               ["(R[0]) = x / s", "(R[1]) = (dx * s - x * ds) / (s * s)"])
        yield Row(f"s1018_degree_{p}", "sisl", f"{knots}; u in ({inner}); t in [{inner})",
               f"SISLCurve *q = 0; int status; {curve(p, n)} s1018(c, &u, 1, &q, &status);",
               [f"(S(q->in, {p}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"])
        yield Row(f"s1710_degree_{p}", "sisl", f"{knots}; u in ({inner}); t in [k[{p}], u)" + apart(n + p + 1, p, n),
               f"SISLCurve *q = 0, *r = 0; int status; {curve(p, n)} s1710(c, u, &q, &r, &status);",
               [f"(S(q->in, {p}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"])
        if p < 4:
            yield Row(f"s1750_degree_{p}", "sisl", f"{knots}; t in [{inner})",
                   f"SISLCurve *q = 0; int status; {curve(p, n)} s1750(c, {p + 2}, &q, &status);",
                   [f"(S(q->in, {p + 1}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"], MOVES)
            yield Row(f"s1730_degree_{p}", "sisl", f"{knots}; t in [{inner})",
                   f"SISLCurve *q = 0; int status; {curve(p, n)} s1730(c, &q, &status);",
                   [f"(S(q->in, {p}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"])
            made = (f"double k[{2 * p + 3}]; for (int i = 0; i < {2 * p + 3}; i++) k[i] = x[i <= {p} ? 0 : i == {p + 1} ? 1 : 2]; ")
            yield Row(f"s1730_full_ends_degree_{p}", "sisl", f"x[3] increasing; P[{n}]; t in [x[0], x[2])",
                      made + f"SISLCurve *q = 0; int status; {curve(p, n)} s1730(c, &q, &status);",
                      [f"(S(q->in, {p}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)", f"(q->in) = {2 * p + 2}"])
    yield from curvature_rows()
    yield from surface_rows()


def curvature_rows():
    """The square of the curvature of a plane Bezier curve: (x'y'' - y'x'')^2 / (x'^2 + y'^2)^3.  SISL takes lengths and curvatures near
    0 for 0, and where the first derivative vanishes it returns what was never computed: so the point is regular, and no inflection."""
    for p in (2, 3):
        n = p + 1

        def d(r, c):
            return f"SN({r}, {n}, {p}, k, {c}, t, 0)"
        speed, cross = f"({d(1, 'X')} * {d(1, 'X')} + {d(1, 'Y')} * {d(1, 'Y')})", f"({d(1, 'X')} * {d(2, 'Y')} - {d(1, 'Y')} * {d(2, 'X')})"
        for regular in (True, False)[:p - 1]:
            yield Row(f"s2550_bezier_degree_{p}" + ("" if regular else "_anywhere"), "sisl",
                      f"k[{2 * n}] = {'0 ' * n}{'1 ' * n}; X[{n}]; Y[{n}]; t in [0, 1)",
                      f"double P[{2 * n}], R; int status; for (int i = 0; i < {n}; i++) {{ P[2 * i] = X[i]; P[2 * i + 1] = Y[i]; }} "
                      f"SISLCurve *c = newCurve({n}, {n}, k, P, 1, 2, 1); s2550(c, &t, 1, &R, &status); "
                      f"double s = {speed}, a = {cross};", ["(R * R) = a * a / (s * s * s)"],
                      f":where: {speed} >= 1\n:where: {cross} >= 1 || {cross} <= -1\n" if regular else "")


def surface_rows():
    """A patch of one coordinate, with its two first derivatives, right of the knots."""
    for p in (1, 2, 3):
        n, knots = p + 1, 2 * p + 2
        yield Row(f"s1421_degree_{p}", "sisl",
                  f"k[{knots}] increasing; l[{knots}] increasing; P[{n * n}]; u in [k[{p}], k[{n}]); v in [l[{p}], l[{n}])",
                  f"double R[3], M[1], W[3] = {{0}}, at[2] = {{u, v}}; int left = 0, right = 0, status; "
                  f"SISLSurf *s = newSurf({n}, {n}, {n}, {n}, k, l, P, 1, 1, 1); s1421(s, 1, at, &left, &right, R, M, &status); "
                  f"for (int j = 0; j < {n}; j++) for (int i = 0; i < {n}; i++) {{ double c = P[{n} * j + i]; "
                  f"W[0] += c * N(i, {p}, k, u, 0) * N(j, {p}, l, v, 0); W[1] += c * D(i, {p}, k, u, 0) * N(j, {p}, l, v, 0); "
                  f"W[2] += c * N(i, {p}, k, u, 0) * D(j, {p}, l, v, 0); }}", ["R[3] = W"])


def search_rows():
    """The search for the interval of the parameter, among five, from different beginnings."""
    for start in (0, 3, 5):
        yield Row(f"s1219_from_{start}", "sisl", "k[8] increasing; t in [k[1], k[6])",
                  f"int left = {start}, status, wanted = 1; s1219(k, 2, 6, &left, t, &status); "
                  "while (t >= k[wanted + 1]) wanted++;", ["(1.0 * left) = wanted"])  # a double: faults.py prints it


def remarkable_rows():
    """What no shape above has: a curve with a knot too many at its beginning."""
    yield Row("newCurve_knot_too_many", "sisl", "P[3]; t in [0, 1)",
              "double k[5] = {0, 0, 0, 1, 1}, R[1]; int left = 0, status; SISLCurve *c = newCurve(3, 2, k, P, 1, 1, 1); "
              "s1221(c, 0, t, &left, R, &status);", ["(R[0]) = (1 - t) * P[1] + t * P[2]"])


def gsl_rows():
    """GSL makes the knots of three breakpoints: the outer ones p+1 times."""
    for p in range(1, 5):
        n = p + 2
        made = (f"gsl_bspline_workspace *w = gsl_bspline_alloc({p + 1}, 3); gsl_vector_view v = gsl_vector_view_array(x, 3); "
                f"gsl_bspline_knots(&v.vector, w); const double *k = w->knots->data; ")
        yield Row(f"gsl_bspline_eval_degree_{p}", "gsl", "x[3] increasing; t in [x[0], x[2])",
                  made + f"double R[{n}], W[{n}]; v = gsl_vector_view_array(R, {n}); gsl_bspline_eval(t, &v.vector, w); "
                  f"for (int i = 0; i < {n}; i++) W[i] = N(i, {p}, k, t, 0);", [f"R[{n}] = W"])
        yield Row(f"gsl_bspline_deriv_eval_degree_{p}", "gsl", "x[3] increasing; t in [x[0], x[2])",
                  made + f"double R[{3 * n}], W[{3 * n}]; gsl_matrix_view m = gsl_matrix_view_array(R, {n}, 3); "
                  f"gsl_bspline_deriv_eval(t, 2, &m.matrix, w); "
                  f"for (int i = 0; i < {n}; i++) for (int r = 0; r <= 2; r++) W[3 * i + r] = DN(r, i, {p}, k, t, 0);",
                  [f"R[{3 * n}] = W"])


def eigen_rows():
    for p in range(1, 5):
        n = p + 2
        yield Row(f"eigen_spline_degree_{p}", "eigen", f"k[{n + p + 1}] increasing; P[{n}]; t in [k[{p}], k[{n}])",
                  f"double R[2]; eigen_{p}({n}, k, P, t, R);",
                  [f"(R[0]) = S({n}, {p}, k, P, t, 0)", f"(R[1]) = DS({n}, {p}, k, P, t, 0)"])


def snl_rows():
    """Curves of C++; the points lie on a line, with a weight."""
    for p in (1, 2, 3):
        n = p + 2
        m = n + p + 1
        knots = f"k[{m}] increasing"
        made = (f"snlCtrlPoint *c = new snlCtrlPoint[{n}]; double *kk = new double[{m}], y, z, w1; for (int i = 0; i < {m}; i++) kk[i] = k[i]; "
                f"for (int i = 0; i < {n}; i++) c[i].components(P[i], 0, 0, 1); snlCurve curve({p}, {n}, c, kk); ")
        told = ("for (int i = 0; i < N; i++) curve.controlPointNet().getCtrlPtsPtr()[i].components(Q + i, &y, &z, &w1); "
                f"for (int i = 0; i < N + q + 1; i++) K[i] = curve.param(i);")
        wanted = f"S({n}, {p}, k, P, t, 0)"
        yield Row(f"snl_eval_rational_degree_{p}", "snl", f"{knots}; P[{n}]; w[{n}] > 0; t in [k[{p}], k[{n}])",
                  f"double A[{n}]; for (int i = 0; i < {n}; i++) A[i] = w[i] * P[i]; " + made.replace("P[i], 0, 0, 1", "A[i], 0, 0, w[i]")
                  + "double x; curve.eval(t).components(&x, &y, &z);", [f"x = S({n}, {p}, k, A, t, 0) / S({n}, {p}, k, w, t, 0)"])
        yield Row(f"snl_evalDerivs_degree_{p}", "snl", f"{knots}; P[{n}]; t in [k[{p}], k[{n}])",
                  made + "double R[2]; snlPoint *d = curve.evalDerivs(t, 1); d[0].components(R, &y, &z); d[1].components(R + 1, &y, &z);",
                  [f"(R[0]) = {wanted}", f"(R[1]) = DS({n}, {p}, k, P, t, 0)"])
        yield Row(f"snl_insertKnot_degree_{p}", "snl", f"{knots}; P[{n}]; u in (k[{p}], k[{n}]); t in [k[{p}], k[{n}])",
                  made + f"curve.insertKnot(u, true); double Q[{n + 1}], K[{m + 1}]; int N = {n + 1}, q = {p}; " + told,
                  [f"(S({n + 1}, {p}, K, Q, t, 0)) = {wanted}"])
        yield Row(f"snl_elevateDegree_degree_{p}", "snl", f"x[3] increasing; P[{n}]; t in [x[0], x[2])",
                  f"double k[{m}]; for (int i = 0; i < {m}; i++) k[i] = x[i <= {p} ? 0 : i == {p + 1} ? 1 : 2]; " + made
                  + f"curve.elevateDegree(1); double Q[20], K[30]; int N = curve.size(), q = {p + 1}; " + told,
                  [f"(S(N, {p + 1}, K, Q, t, 0)) = {wanted}"])


def boost_rows():
    """Interpolation; knots that are nearer than the smallest normal number are taken for equal ones by the barycentric form."""
    for n in (3, 4):
        yield Row(f"boost_barycentric_rational_{n}_points", "boost", f"x[{n}] increasing; y[{n}]; t",
                  f"double R = barycentric({n}, {n - 1}, x, y, t), W = 0; for (int i = 0; i < {n}; i++) {{ double l = y[i]; "
                  f"for (int j = 0; j < {n}; j++) if (j != i) l *= (t - x[j]) / (x[i] - x[j]); W += l; }}", ["R = W"],
                  "".join(f":where: t != x[{i}]\n" for i in range(n)) + "".join(f":where: x[{i}] - x[{i - 1}] > 1.0 / 1000\n" for i in range(1, n)))
    yield Row("boost_cubic_hermite", "boost", "x[3] increasing; y[3]; d[3]; t in [x[0], x[2])",
              "double R[2]; cubic_hermite(3, x, y, d, t, R); int i = t >= x[1]; double h = x[i + 1] - x[i], s = (t - x[i]) / h, r = 1 - s; "
              "double W[2] = {r * r * (1 + 2 * s) * y[i] + s * s * (3 - 2 * s) * y[i + 1] + s * r * r * h * d[i] - s * s * r * h * d[i + 1], "
              "6 * s * r * (y[i + 1] - y[i]) / h + r * (1 - 3 * s) * d[i] + s * (3 * s - 2) * d[i + 1]};", ["R[2] = W"])
    # The quintic of the interval by its Bezier points.
    yield Row("boost_quintic_hermite", "boost", "x[3] increasing; y[3]; d[3]; e[3]; t in [x[0], x[2])",
              "double R[2]; quintic_hermite(3, x, y, d, e, t, R); int i = t >= x[1]; double h = x[i + 1] - x[i], k[12] = "
              "{x[i], x[i], x[i], x[i], x[i], x[i], x[i + 1], x[i + 1], x[i + 1], x[i + 1], x[i + 1], x[i + 1]}, "
              "b[6] = {y[i], y[i] + h * d[i] / 5, y[i] + 2 * h * d[i] / 5 + h * h * e[i] / 20, "
              "y[i + 1] - 2 * h * d[i + 1] / 5 + h * h * e[i + 1] / 20, y[i + 1] - h * d[i + 1] / 5, y[i + 1]};",
              ["(R[0]) = S(6, 5, k, b, t, 0)", "(R[1]) = DS(6, 5, k, b, t, 0)"])
    # Of a line all slopes are the same.
    yield Row("boost_makima_line", "boost", "a; b; t in [0, 4)",
              "double x[5] = {0, 1, 2, 3, 4}, y[5]; for (int i = 0; i < 5; i++) y[i] = a * x[i] + b; double R = modified_akima(5, x, y, t);",
              ["R = a * t + b"])
    yield Row("boost_legendre_p_degree_3", "boost", "t in [-1, 1]", "double R = legendre(3, t);", ["R = (5 * t * t * t - 3 * t) / 2"])


def alglib_rows():
    """Its first act is to look at the bits of a number."""
    yield Row("alglib_polynomialbuild_3_points", "alglib", "x[3] increasing; y[3]; t",
              "alglib::real_1d_array X, Y; X.setcontent(3, x); Y.setcontent(3, y); alglib::barycentricinterpolant b; "
              "alglib::polynomialbuild(X, Y, b); double R = alglib::barycentriccalc(b, t), W = 0; for (int i = 0; i < 3; i++) { double l = y[i]; "
              "for (int j = 0; j < 3; j++) if (j != i) l *= (t - x[j]) / (x[i] - x[j]); W += l; }", ["R = W"])


def every_row():
    for rows in (search_rows, sisl_rows, remarkable_rows, gsl_rows, eigen_rows, snl_rows, boost_rows, alglib_rows):
        yield from rows()
