"""kinds.py CAGD [--write [FOLDER]] -- what the defaults of cagd fit do on twenty-seven kinds of simulated measurement, whose truth is known.

A table: the kind, how many points, what was chosen, whether it was found closed, how far the truth is from the fitted curve at the
most and how far the fitted curve from the truth, in standard deviations of the noise, and what the report says against it.
--write puts it into kinds.md, with what they do on the files of real/ and of a folder of other files; without, it is printed.  Exit status 1: a kind misses what is asked of it.

Nothing of cagd computes here: curves are evaluated by Cox and de Boor's recursion."""
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent


def curve_point(c, t):
    """The point at t, by Cox and de Boor in homogeneous coordinates."""
    p, U = c["degree"], c["knots"]
    n = len(c["points"])
    mu = max(i for i in range(p, n) if U[i] <= t and U[i] < U[i + 1])
    w = c.get("weights") or [1.0] * n
    d = [[w[i] * x for x in c["points"][i]] + [w[i]] for i in range(mu - p, mu + 1)]
    for r in range(1, p + 1):
        for j in range(p, r - 1, -1):
            i = mu - p + j
            a = (t - U[i]) / (U[i + p + 1 - r] - U[i])
            d[j] = [(1 - a) * x + a * y for x, y in zip(d[j - 1], d[j])]
    return [x / d[p][-1] for x in d[p][:-1]]


def samples(c, count=300):
    if "knots" not in c:
        n = len(c["points"]) - 1
        c = dict(c, degree=n, knots=[0.0] * (n + 1) + [1.0] * (n + 1))
    low, high = c["knots"][c["degree"]], c["knots"][len(c["points"])]
    return [curve_point(c, low + (high - low) * k / count) for k in range(count + 1)]


def to_polyline(q, line):
    """The distance of q from a polygon."""
    best = math.inf
    for a, b in zip(line, line[1:]):
        ab = [y - x for x, y in zip(a, b)]
        square = sum(x * x for x in ab)
        s = max(0.0, min(1.0, sum((y - x) * z for x, y, z in zip(a, q, ab)) / square)) if square else 0.0
        best = min(best, math.dist(q, [x + s * z for x, z in zip(a, ab)]))
    return best


# ---- truths: curves over 0 <= u <= 1 ------------------------------------------------------------------------
def wave(u): return [6 * u, math.sin(6 * u)]
def bends(u): return [u, math.sin(6 * u)]  # in a circle of radius 1/36
def circle(u): return [3 + 2 * math.cos(2 * math.pi * u), 1 + 2 * math.sin(2 * math.pi * u)]
def ellipse(u): return [3 + 2 * math.cos(2 * math.pi * u), 1 + 1.2 * math.sin(2 * math.pi * u)]
def parabola(u): return [2 * u - 1, u * (1 - u)]
def flower(u):
    a = 2 * math.pi * u + 0.4
    r = 1 + 0.2 * math.sin(3 * a)
    return [r * math.cos(a), r * math.sin(a)]
def eight(u): return [math.sin(2 * math.pi * u + 0.1), math.sin(4 * math.pi * u + 0.2) / 2]
def spiral(u): return [(0.3 + u) * math.cos(9 * u), (0.3 + u) * math.sin(9 * u)]
def helix(u): return [math.cos(5 * u), math.sin(5 * u), u]
def line(u): return [3 * u, 1 + u]
def hook(u): return [u, 0.0] if u < 0.5 else [0.5, u - 0.5]
def section(u):  # a thick cam: two radii, smoothly
    a = 2 * math.pi * u
    r = 1 + 0.35 * math.exp(-8 * (1 - math.cos(a - 2)))
    return [r * math.cos(a), r * math.sin(a)]


def measure(truth, n, sigma, seed, closed=False):
    r = random.Random(seed)
    return [[x + r.gauss(0, sigma) for x in truth(i / (n if closed else n - 1))] for i in range(n)]


def cases():
    """name, truth, points, sigma, options, asked: closed (None: either), most sigmas of truth and of curve (None: not asked)."""
    def far(points, by): return [[x + by for x in q] for q in points]
    def quantised(points, step): return [[round(x / step) * step for x in q] for q in points]
    r = random.Random(77)
    uneven = [[x + r.gauss(0, 0.01) for x in wave(u)] for u in sorted(r.random() ** 3 for _ in range(150))]
    gap = [q for i, q in enumerate(measure(wave, 150, 0.01, 3)) if not 60 <= i < 80]
    twice = [q for q in measure(wave, 80, 0.01, 4) for _ in range(1 + (r.random() < 0.3))]
    along = [[6 * u + s, math.sin(6 * u + s)] for i in range(150) for u, s in [(i / 149, r.gauss(0, 0.05))]]
    along = [[x, y + r.gauss(0, 0.005)] for x, y in along]
    swapped = measure(wave, 120, 0.01, 5)
    for i in (20, 21, 60, 90):
        swapped[i], swapped[i + 3] = swapped[i + 3], swapped[i]
    there = measure(wave, 80, 0.01, 6)
    strokes = there[:50] + there[40:]
    across = [[i / 2000, math.sin(6 * i / 2000) + r.gauss(0, 0.03)] for i in range(2001)]
    ring = measure(circle, 60, 0.01, 7, True)
    wild = measure(wave, 120, 0.01, 8)
    for i in (30, 70):
        wild[i][1] += 0.5
    return [
        ("a parabola with noise", parabola, measure(parabola, 101, 0.003, 1), 0.003, [], False, 4, 4),
        ("a wave with noise", wave, measure(wave, 200, 0.01, 2), 0.01, [], False, 4, 4),
        ("quantised to 0.02", wave, quantised(measure(wave, 200, 0.0, 2), 0.02), 0.02 / math.sqrt(12), [], False, 6, 6),
        ("of uneven density", wave, uneven, 0.01, [], False, 12, 12),
        ("with a gap", wave, gap, 0.01, [], False, 12, 12),
        ("with duplicates", wave, twice, 0.01, [], False, 5, 5),
        ("with noise along the curve", wave, along, 0.05, [], False, 4, 4),
        ("in wrong order in places", wave, swapped, 0.01, [], False, 5, 5),
        ("in two strokes that overlap", wave, strokes, 0.01, [], False, 8, 8),
        ("with two outliers", wave, wild, 0.01, ["--loss", "huber", "--control-points", "8", "--degree", "3"], False, 6, 6),
        ("a wave of 5001 points", wave, measure(wave, 5001, 0.01, 9), 0.01, [], False, 4, 4),
        ("scattered by more than they are apart", wave, measure(wave, 5001, 0.05, 21), 0.05, [], False, 2, 2),
        ("as many where the curve bends within the scatter", bends, across, 0.03, [], False, 3, 3),
        ("nine points of a wave", wave, measure(wave, 9, 0.001, 10), 0.001, [], False, None, None),
        ("a whole circle", circle, ring, 0.01, [], True, 4, 4),
        ("a circle, first point repeated", circle, ring + ring[:1], 0.01, [], True, 4, 4),
        ("a circle in no order", circle, random.Random(3).sample(ring, 60), 0.01, ["--unordered"], True, 4, 4),
        ("a whole ellipse", ellipse, measure(ellipse, 60, 0.01, 12, True), 0.01, [], True, 4, 4),
        ("three quarters of an ellipse", lambda u: ellipse(0.75 * u), measure(lambda u: ellipse(0.75 * u), 60, 0.01, 13), 0.01, [], False, 4, 4),
        ("a closed section", section, measure(section, 150, 0.005, 14, True), 0.005, [], True, 6, 6),
        ("a closed section in no order", flower, random.Random(4).sample(measure(flower, 200, 0.01, 15, True), 200), 0.01, ["--unordered"], True, 5, 5),
        ("a figure of eight", eight, measure(eight, 200, 0.005, 16, True), 0.005, [], True, 6, 6),
        ("a spiral", spiral, measure(spiral, 200, 0.005, 17), 0.005, [], False, 6, 6),
        ("a helix in space", helix, measure(helix, 120, 0.005, 18), 0.005, [], False, 6, 6),
        ("far from the origin", lambda u: far([wave(u)], 1e7)[0], far(measure(wave, 200, 0.01, 2), 1e7), 0.01, [], False, 4, 4),
        ("a straight line", line, measure(line, 50, 0.01, 19), 0.01, [], False, 6, 6),
        ("a corner", hook, measure(hook, 81, 0.002, 20), 0.002, [], False, None, None),
    ]


def chosen(d):
    name = (d["choice"]["candidates"] or [{"name": f"degree {d['curve'].get('degree', len(d['curve']['points']) - 1)}, {len(d['curve']['points'])} control points"}])[0]["name"]
    e = d["ellipse"]
    name = name.replace("ellipse", "circle").replace("an arc of an circle", "an arc of a circle") if e and e["circle"] else name
    return name + (", smoothed" if d["choice"]["smoothing"] else "")


def of_files(cagd, files):
    """The same without a truth: distances in the units of the file."""
    rows = []
    for path in files:
        more = ["--unordered"] if "unordered" in path.name else []
        r = subprocess.run([cagd, "fit", path, "--json", "--no-verify", *more], capture_output=True, text=True)
        if r.returncode not in (0, 1) or not r.stdout:
            rows.append((path.name, "", "refused: " + r.stderr.strip().splitlines()[0].split(": ", 2)[-1], "", "", "", ""))
            continue
        d = json.loads(r.stdout)
        said = "; ".join(s.split(" (")[0] for s in d["quality"]["problems"]) or "nothing"
        rows.append((path.name, d["points"]["count"], chosen(d), "closed" if d["choice"]["closed"] else "open",
                     f"{d['distances']['rms']:.2g}", f"{d['distances']['largest']:.2g}", said))
    return rows


def table(head, rows):
    return "".join("| " + " | ".join(map(str, row)) + " |\n" for row in [head, ["---"] * len(head), *rows])


def main():
    cagd, write = pathlib.Path(sys.argv[1]).resolve(), "--write" in sys.argv
    rows, bad = [], []
    for name, truth, points, sigma, options, closed, most_truth, most_curve in cases():
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "points.csv"
            path.write_text("".join(",".join(map(repr, q)) + "\n" for q in points))
            more = ["--dim", "3"] if len(points[0]) == 3 else []
            r = subprocess.run([cagd, "fit", path, "--json", "--no-verify", *more, *options], capture_output=True, text=True)
        if r.returncode not in (0, 1) or not r.stdout:
            bad.append(f"{name}: {r.stderr.strip()}")
            continue
        d = json.loads(r.stdout)
        fitted = samples(d["curve"])
        true = [truth(k / 240) for k in range(241)]
        of_truth = max(to_polyline(q, fitted) for q in true) / sigma
        of_curve = max(to_polyline(q, true) for q in fitted) / sigma
        said = "; ".join(s.split(" (")[0] for s in d["quality"]["problems"]) or "nothing"
        rows.append((name, len(points), chosen(d), "closed" if d["choice"]["closed"] else "open", f"{of_truth:.1f}", f"{of_curve:.1f}", said))
        if not d["at_minimum"]:
            bad.append(f"{name}: no minimum")
        if closed is not None and d["choice"]["closed"] != closed:
            bad.append(f"{name}: closed is {d['choice']['closed']}")
        for what, got, most in ("the truth", of_truth, most_truth), ("the curve", of_curve, most_curve):
            if most is not None and got > most:
                bad.append(f"{name}: {what} is {got:.1f} standard deviations away, more than {most}")
    head = ("kind", "points", "chosen", "found", "truth away", "curve away", "said against it")
    text = table(head, rows)
    if write:
        others = pathlib.Path(sys.argv[sys.argv.index("--write") + 1]) if sys.argv[-1] != "--write" else None
        files = [p for folder in (HERE / "real", others) if folder for p in sorted(folder.iterdir()) if p.suffix not in (".py", ".md")]
        text += "\n## On files\n\nDistances are in the units of the file.\n\n" + table(
            ("file", "points", "chosen", "found", "rms", "largest", "said against it"), of_files(cagd, files))
        (HERE / "kinds.md").write_text("# What the defaults do\n\nMade by `cmake --build build/release --target fit-kinds-table`. Away: the largest distance, in standard\n"
                                       "deviations of the noise. With `--unordered` where the points are in no order, and `--loss huber` where there are outliers.\n\n" + text)
    else:
        print(text, end="")
    for line_ in bad:
        print("BAD", line_, file=sys.stderr)
    print(f"{len(rows)} kinds, {len(bad)} not as asked", file=sys.stderr)
    return 1 if bad or len(rows) < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
