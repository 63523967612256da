"""A library that others wrote, executed exactly: SISL, routine by shape by verdict.  Not a test: it takes long, and needs its sources.

    python3 foreign.py CAGD CAGD-COMPILE-EXACTLY FOLDER [PATTERN]

FOLDER has the sources of Debian's package sisl (apt-get source sisl), with include/ and src/; what is made of them is put into
FOLDER/exactly.  Nothing of them is part of this project.  Each row asks whether a routine of SISL computes, for a degree, what
the recursion of the basis functions says; the points, the weights, the knots and the parameter are variables.  The table has the
verdict, how many ways through the code were proved, the comparisons that stay as conditions, and the worst error in binary64; foreign.md has one."""
import fnmatch
import json
import pathlib
import subprocess
import sys

CAGD, COMPILER, FOLDER = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
PATTERN = sys.argv[4] if len(sys.argv) > 4 else "*"
WORK = FOLDER / "exactly"

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
static double S(int n, int p, const double *k, const double *c, double t, int side)
{
    double s = 0;
    for (int i = 0; i < n; i++)
        s += c[i] * N(i, p, k, t, side);
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


def curve(p, n):
    return f"SISLCurve *c = newCurve({n}, {p + 1}, k, P, 1, 1, 1);"


def apart(count, first, last):
    """SISL takes for one number what differs by 1e-12 of the larger: the knots, of size 100 at most, are farther apart, and u is
    one of them or farther from them."""
    return (f"\n:where: k[0] > -100 && k[{count - 1}] < 100"
            + "".join(f"\n:where: k[{i}] - k[{i - 1}] > 1.0 / 1000" for i in range(1, count))
            + "".join(f"\n:where: u == k[{i}] || u - k[{i}] > 1.0 / 1000 || k[{i}] - u > 1.0 / 1000" for i in range(first, last + 1)))


def rows():
    """Name, inputs, statements, and what is expected."""
    for p in range(1, 5):
        n = p + 2
        knots, inner = f"k[{n + p + 1}] increasing; P[{n}]", f"k[{p}], k[{n}]"
        yield (f"s1221_degree_{p}", f"{knots}; t in [{inner})",
               f"double R[2]; int left = 0, status; {curve(p, n)} s1221(c, 1, t, &left, R, &status);",
               [f"(R[0]) = S({n}, {p}, k, P, t, 0)", f"(R[1]) = DS({n}, {p}, k, P, t, 0)"])
        yield (f"s1227_degree_{p}", f"{knots}; t in ({inner}]",
               f"double R[2]; int left = 0, status; {curve(p, n)} s1227(c, 1, t, &left, R, &status);",
               [f"(R[0]) = S({n}, {p}, k, P, t, 1)", f"(R[1]) = DS({n}, {p}, k, P, t, 1)"])
        yield (f"s1220_degree_{p}", f"k[{n + p + 1}] increasing; t in [{inner})",
               f"double R[{2 * p + 2}], W[{2 * p + 2}]; int left = {p}, status; s1220(k, {p + 1}, {n}, &left, t, 1, R, &status); "
               f"for (int i = 0; i <= {p}; i++) {{ W[2 * i] = N(left - {p} + i, {p}, k, t, 0); "
               f"W[2 * i + 1] = D(left - {p} + i, {p}, k, t, 0); }}", [f"R[{2 * p + 2}] = W"])
        yield (f"s1221_rational_degree_{p}", f"k[{2 * p + 2}] increasing; P[{p + 1}]; w[{p + 1}] in [1/1000, 4]; t in [k[{p}], k[{p + 1}])",
               f"double R[2], Q[{2 * p + 2}], A[{p + 1}]; int left = 0, status; "
               f"for (int i = 0; i <= {p}; i++) {{ A[i] = Q[2 * i] = w[i] * P[i]; Q[2 * i + 1] = w[i]; }} "
               f"SISLCurve *c = newCurve({p + 1}, {p + 1}, k, Q, 2, 1, 1); s1221(c, 1, t, &left, R, &status); "
               f"double s = S({p + 1}, {p}, k, w, t, 0), x = S({p + 1}, {p}, k, A, t, 0), "
               f"ds = DS({p + 1}, {p}, k, w, t, 0), dx = DS({p + 1}, {p}, k, A, t, 0);",
               ["(R[0]) = x / s", "(R[1]) = (dx * s - x * ds) / (s * s)"])
        yield (f"s1018_degree_{p}", f"{knots}; u in ({inner}); t in [{inner})",
               f"SISLCurve *q = 0; int status; {curve(p, n)} s1018(c, &u, 1, &q, &status);",
               [f"(S(q->in, {p}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"])
        yield (f"s1710_degree_{p}", f"{knots}; u in ({inner}); t in [k[{p}], u)" + apart(n + p + 1, p, n),
               f"SISLCurve *q = 0, *r = 0; int status; {curve(p, n)} s1710(c, u, &q, &r, &status);",
               [f"(S(q->in, {p}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"])
        if p < 4:
            yield (f"s1750_degree_{p}", f"{knots}; t in [{inner})",
                   f"SISLCurve *q = 0; int status; {curve(p, n)} s1750(c, {p + 2}, &q, &status);",
                   [f"(S(q->in, {p + 1}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"])
            yield (f"s1730_degree_{p}", f"{knots}; t in [{inner})",
                   f"SISLCurve *q = 0; int status; {curve(p, n)} s1730(c, &q, &status);",
                   [f"(S(q->in, {p}, q->et, q->ecoef, t, 0)) = S({n}, {p}, k, P, t, 0)"])


def archive():
    """All of SISL as bitcode; a file that does not compile is left out, and a routine that needs it is refused by name."""
    made = WORK / "sisl.a"
    if not made.exists():
        clang = subprocess.run([COMPILER, "--tools"], capture_output=True, text=True, check=True).stdout.strip() + "/clang"
        for source in sorted((FOLDER / "src").glob("*.c")):
            subprocess.run([clang, "-O0", "-ffp-model=strict", "-ftrivial-auto-var-init=pattern", "-fno-builtin", "-g", "-fPIC", "-w",
                            f"-I{FOLDER}/include", "-c", "-emit-llvm", source, "-o", WORK / (source.stem + ".o")], stderr=subprocess.DEVNULL)
        subprocess.run(["ar", "rc", made, *WORK.glob("*.o")], check=True)
    return made


def ask(name, inputs, statements, expected):
    page = WORK / f"{name}.md"
    page.write_text(f":::{{exactly}} {name}\n:source: sisl.a\n:flag: -I{FOLDER}/include -w\n:include: \"sislP.h\"\n"
                    f":include: \"reference.h\"\n:input: {inputs}\n:call: {statements}\n"
                    + "".join(f":expect: {e}\n" for e in expected) + ":points: 12\n:::\n")
    ran = subprocess.run([CAGD, "exactly", page, "--json", "--rounding=40"], capture_output=True, text=True)
    if ran.returncode not in (0, 1):
        return [name, "not compiled", "", "", ran.stderr.strip().splitlines()[-1]]
    (v,) = json.loads(ran.stdout)["blocks"]
    told = max((sum(not c["precondition"] and not c["implied"] for c in w["conditions"]) for w in v["ways"]), default=0)
    worst = max((w["ulps"] or 0 for w in v.get("rounding", {}).get("worst", [])), default=None)
    note = (v.get("because") or v.get("open") and "open: " + v["open"] or "").replace(f"{WORK}/", "").replace(f"{FOLDER}/src/", "")
    if v["verdict"] == "differs":
        note = "at " + ", ".join(f"{k} = {' '.join(x)}" for k, x in v["point"].items())
    word = v["verdict"] + (", all inputs" if v.get("exhaustive") else "")
    return [name, word, f"{v['paths_proved']}/{v['paths']}", str(told), f"{worst:.3g}" if worst is not None else "", note]


WORK.mkdir(exist_ok=True)
(WORK / "reference.h").write_text(REFERENCE)
archive()
print("| routine | verdict | ways proved | conditions, most | ulps, worst | remark |\n|---|---|---|---|---|---|")
for row in rows():
    if fnmatch.fnmatch(row[0], PATTERN):
        print("|", " | ".join(ask(*row)), "|", flush=True)
