"""Libraries that others wrote, executed exactly, routine by shape by verdict.  Not a test: it takes long, and needs their sources.

    apt-get source sisl gsl; apt-get install libeigen3-dev
    python3 foreign.py CAGD CAGD-COMPILE-EXACTLY FOLDER [PATTERN]

FOLDER is where the sources of Debian's packages sisl and gsl were unpacked; Eigen is a library of headers.  What is made of them is
put into FOLDER/exactly; nothing of them is part of this project.  Each row asks whether a routine computes, for a degree, what the
recursion of the basis functions says; the points, the weights, the knots and the parameter are variables.  The table has the
verdict, how many ways through the code were proved, the comparisons that stay as conditions, and the worst error in binary64;
foreign.md has one."""
import fnmatch
import json
import pathlib
import re
import subprocess
import sys
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


class Workshop:
    """What is made of the sources of others, in a folder of its own."""

    def __init__(self, cagd, compiler, folder):
        self.cagd, self.compiler, self.folder = cagd, compiler, pathlib.Path(folder).resolve()
        self.work = self.folder / "exactly"
        self.work.mkdir(exist_ok=True)
        (self.work / "reference.h").write_text(REFERENCE)
        self.made = {}

    def unpacked(self, package):
        return next(f for f in sorted(self.folder.glob(package + "*")) if f.is_dir())

    def clang(self):
        return subprocess.run([self.compiler, "--tools"], capture_output=True, text=True, check=True).stdout.strip() + "/clang"

    def archive(self, name, sources, flags):
        """The sources as bitcode; a file that does not compile is left out, and a routine that needs it is refused by name."""
        made, parts = self.work / f"{name}.a", self.work / name
        if not made.exists():
            parts.mkdir(exist_ok=True)
            for source in sources:
                subprocess.run([self.clang(), "-O0", "-ffp-model=strict", "-ftrivial-auto-var-init=pattern", "-fno-builtin", "-g",
                                "-fPIC", "-w", *flags, "-c", "-emit-llvm", source, "-o", parts / f"{source.parent.name}_{source.stem}.o"],
                               stderr=subprocess.DEVNULL)
            subprocess.run(["ar", "rc", made, *parts.glob("*.o")], check=True)

    def sisl(self):
        folder = self.unpacked("sisl")
        self.archive("sisl", sorted((folder / "src").glob("*.c")), [f"-I{folder}/include"])
        return "sisl.a", f"-I{folder}/include", ['"sislP.h"']

    def gsl(self):
        """The headers stand apart in the sources; what `configure` would say matters little to B-splines."""
        folder, headers = self.unpacked("gsl"), self.work / "include" / "gsl"
        headers.mkdir(parents=True, exist_ok=True)
        for header in [*folder.glob("gsl_*.h"), *folder.glob("*/gsl_*.h")]:
            if not (headers / header.name).exists():
                (headers / header.name).symlink_to(header)
        (headers.parent / "config.h").write_text("#define RETURN_IF_NULL(x) if (!x) { return; }\n#define HAVE_INLINE 1\n")
        sources = [folder / f for f in ["bspline/bspline.c", "vector/vector.c", "vector/init.c", "vector/view.c", "vector/oper.c", "vector/copy.c",
                                        "matrix/matrix.c", "matrix/init.c", "matrix/rowcol.c", "matrix/submatrix.c", "matrix/view.c",
                                        "block/block.c", "block/init.c", "sys/minmax.c", "err/error.c", "err/stream.c", "err/strerror.c"]]
        self.archive("gsl", sources, [f"-I{headers.parent}", f"-I{folder}"])
        return "gsl.a", f"-I{headers.parent}", ["<gsl/gsl_bspline.h>"]

    def eigen(self):
        (self.work / "eigen.cc").write_text(EIGEN)
        declared = "".join(f" void eigen_{p}(int, const double *, const double *, double, double *);" for p in range(1, 5))
        (self.work / "eigen.h").write_text('extern "C" {' + declared + " }\n")
        return "eigen.cc", "-I/usr/include/eigen3", ['"eigen.h"']

    def ask(self, row, rounding=0, sources=(), points=12, apart=""):
        """What cagd exactly says of a row, as JSON, or a line where it says nothing; `sources` come before the library; `apart`
        names the page, where a row is asked more than once at a time."""
        if row.library not in self.made:
            self.made[row.library] = getattr(self, row.library)()
        source, flags, headers = self.made[row.library]
        page = self.work / f"{row.name}{apart}.md"
        page.write_text(f":::{{exactly}} {row.name}\n" + "".join(f":source: {s}\n" for s in [*sources, source])
                        + f":flag: {flags} -w\n" + "".join(f":include: {h}\n" for h in [*headers, '"reference.h"'])
                        + f":input: {row.inputs}\n:call: {row.statements}\n"
                        + "".join(f":expect: {e}\n" for e in row.expected) + row.keys + f":points: {points}\n:::\n")
        ran = subprocess.run([self.cagd, "exactly", page, "--json"] + [f"--rounding={rounding}"] * (rounding > 0),
                             capture_output=True, text=True)
        return json.loads(ran.stdout)["blocks"][0] if ran.returncode in (0, 1) else ran.stderr.strip().splitlines()[-1]

    def line(self, row):
        v = self.ask(row, rounding=40)
        if isinstance(v, str):
            return [row.name, "not compiled", "", "", "", v]
        told = max((sum(not c["precondition"] and not c["implied"] for c in w["conditions"]) for w in v["ways"]), default=0)
        worst = max((w["ulps"] or 0 for w in v.get("rounding", {}).get("worst", [])), default=None)
        note = v.get("because") or v.get("open") and "open: " + v["open"] or ""
        if v.get("memcpy_overlaps"):
            note = f"memcpy of overlapping pieces taken for memmove, at {v['memcpy_overlaps']}; {note}".rstrip("; ")
        if v["verdict"] == "differs":
            note = "at " + ", ".join(f"{k} = {' '.join(x)}" for k, x in v["point"].items())
        word = v["verdict"] + (", all inputs" if v.get("exhaustive") else "")
        return [row.name, word, f"{v['paths_proved']}/{v['paths']}", str(told), f"{worst:.3g}" if worst is not None else "",
                re.sub(r"\S*/(?=\w+\.\w+:\d)", "", note)]


def main():
    workshop = Workshop(*sys.argv[1:4])
    print("| routine | verdict | ways proved | conditions, most | ulps, worst | remark |\n|---|---|---|---|---|---|")
    for row in [*search_rows(), *sisl_rows(), *remarkable_rows(), *gsl_rows(), *eigen_rows()]:
        if fnmatch.fnmatch(row.name, sys.argv[4] if len(sys.argv) > 4 else "*"):
            print("|", " | ".join(workshop.line(row)), "|", flush=True)


if __name__ == "__main__":
    main()
