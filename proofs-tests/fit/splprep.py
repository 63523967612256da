"""splprep.py CAGD [--write] -- control points of cagd fit and of SciPy's splprep at the same root mean square, on ten sets of points.

cagd fits a cubic spline whose knots it chooses.  splprep, FITPACK's parametric smoothing spline, is given smaller and smaller sums of
squares s until its curve is as near to the points as that: as many steps as are needed to see every number of knots it can be made
to choose.  Nearness is the root mean square of the orthogonal distances, which is found here for both, from 400 places in every
segment and by thirds between those beside the nearest.  A closed curve counts its own points alone.

Prints a table; --write puts it into splprep.md.  Exit status 1: more control points than splprep somewhere, or more than half of them on a
smooth section.  Needs python3-scipy (Debian) and numpy; not a test."""
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

try:
    import numpy as np
    from scipy.interpolate import BSpline, splev, splprep
except ImportError:
    sys.exit("splprep.py: python3-scipy is not installed: skipped")

HERE = pathlib.Path(__file__).resolve().parent
REAL = ["naca2412.dat", "naca0015-lednicer.dat", "naca0012-sharp.dat", "cam-traced.csv", "lake.geojson", "coil.json", "track.gpx", "stroke.svg"]
SMOOTH = {"naca2412.dat", "naca0015-lednicer.dat", "naca0012-sharp.dat", "cam-traced.csv"}  # sections of one smooth body


def simulated():
    r = random.Random(17)
    def noisy(points, sigma): return [[x + r.gauss(0, sigma) for x in q] for q in points]
    wave = noisy([[6 * i / 199, math.sin(6 * i / 199)] for i in range(200)], 0.01)
    spiral = noisy([[(0.3 + i / 199) * math.cos(9 * i / 199), (0.3 + i / 199) * math.sin(9 * i / 199)] for i in range(200)], 0.005)
    return {"wave": wave, "spiral": spiral}


def rms(curve, knots, Q):
    """curve(t): one row a point of the array t; over the knots of the domain."""
    spans = [(a, b) for a, b in zip(knots, knots[1:]) if a < b]
    t = np.concatenate([np.linspace(a, b, 400, endpoint=False) for a, b in spans] + [[knots[-1]]])
    P = curve(t)
    best = np.array([np.argmin(((P - q) ** 2).sum(1)) for q in Q])
    a, b = t[np.maximum(best - 1, 0)], t[np.minimum(best + 1, len(t) - 1)]
    def square(x): return ((curve(x) - Q) ** 2).sum(1)
    for _ in range(50):  # a third of the way less each time
        left, right = a + (b - a) / 3, b - (b - a) / 3
        nearer = square(left) < square(right)
        a, b = np.where(nearer, a, left), np.where(nearer, right, b)
    return math.sqrt(square((a + b) / 2).mean())


def of_cagd(cagd, path, dim):
    """rms, control points, the points, closed, seconds."""
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "table.csv"
        r = subprocess.run([cagd, "fit", path, "--degree", "3", "--control-points", "auto", "--json", "--no-verify",
                            "--residuals", table, *(["--dim", "3"] if dim == 3 else [])], capture_output=True, text=True)
        if r.returncode not in (0, 1):
            sys.exit(r.stderr)
        d = json.loads(r.stdout)
        rows = list(csv.DictReader(table.open()))
    Q = np.array([[float(row[c]) for c in "xyz"[:dim]] for row in rows])
    c = d["curve"]
    if "knots" not in c:
        n = len(c["points"])
        c = dict(c, degree=n - 1, knots=[0.0] * n + [1.0] * n)
    p, n = c["degree"], len(c["points"])
    closed = bool(d["choice"]["closed"])
    if any(w != 1 for w in c.get("weights") or []):
        sys.exit(f"{path}: the curve has weights, which splprep's has not")
    s = BSpline(np.array(c["knots"], float), np.array(c["points"], float), p)
    found = rms(s, c["knots"][p : n + 1], Q)
    return found, n - (p if closed else 0), Q, closed


def of_splprep(Q, closed, target):
    """The fewest control points with which splprep's curve is as near."""
    keep = np.concatenate([[True], (np.diff(Q, axis=0) ** 2).sum(1) > 0])
    X = list(Q[keep].T)
    if closed:
        X = [np.append(x, x[0]) for x in X]
    fewest = best = None
    s = len(Q) * target**2 * 30
    while s > len(Q) * target**2 * 0.01:
        try:
            (t, c, k), _ = splprep(X, s=s, k=3, per=closed, quiet=True)[:2]
        except (ValueError, TypeError):
            break
        n = len(t) - k - 1 - (k if closed else 0)
        near = rms(lambda u: np.array(splev(u, (t, c, k))).T, t[k : len(t) - k], Q)
        if near <= target * (1 + 1e-9):  # a few roundings of a mean over the points
            if fewest is None or n < fewest:
                fewest, best = n, near
        s *= 0.97
        if fewest is not None and n > 2 * fewest:
            break
    return fewest, best


def main():
    cagd, rows, bad = pathlib.Path(sys.argv[1]).resolve(), [], []
    with tempfile.TemporaryDirectory() as folder:
        sets = [(name, HERE / "real" / name) for name in REAL]
        for name, points in simulated().items():
            path = pathlib.Path(folder) / f"{name}.csv"
            path.write_text("".join(",".join(map(repr, q)) + "\n" for q in points))
            sets.append((name, path))
        for name, path in sets:
            near, own, Q, closed = of_cagd(cagd, path, 3 if name == "coil.json" else 2)
            other, its = of_splprep(Q, closed, near)
            rows.append((name, len(Q), "closed" if closed else "open", f"{near:.3g}", own, other if other else "none as near", f"{its:.3g}" if its else ""))
            if other and own > other:
                bad.append(f"{name}: {own} control points, splprep {other}")
            if other and name in SMOOTH and 2 * own > other:
                bad.append(f"{name}: {own} control points are more than half of splprep's {other}")
            print(*rows[-1], flush=True, file=sys.stderr)
    head = ("points", "number", "found", "rms", "control points", "of splprep", "its rms")
    text = "".join("| " + " | ".join(map(str, row)) + " |\n" for row in [head, ["---"] * len(head), *rows])
    if "--write" in sys.argv:
        (HERE / "splprep.md").write_text("# Control points at the same distance\n\nMade by `/usr/bin/python3 proofs-tests/fit/splprep.py build/release/cagd --write`, which says what is compared.\n\n" + text
                                         + "".join(f"\nNot as asked: {line}." for line in bad) + ("\n" if bad else ""))
    else:
        print(text, end="")
    for line in bad:
        print("BAD", line, file=sys.stderr)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
