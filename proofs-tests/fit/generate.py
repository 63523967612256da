"""Makes the certified problems of the fit: points of curves whose weights are known exactly.

    generate.py --out DIR [NAME ...]          without names all of them

Every problem is NAME.csv, the points, and NAME.json, what is asked and the true curve; `certify` then adds the
certified answer to the JSON.  The files are the same on every machine: the curve is evaluated in rational
numbers, the noise is made of integers, and a number is rounded once, when it is written.

The generator.  x <- 6364136223846793005 x + 1442695040888963407 mod 2^64, from x = the 64-bit FNV-1a hash of the
problem's name; a draw is the upper 32 bits.  uniform() = (draw + 1/2)/2^32; normal() is the sum of twelve of these
minus 6: mean 0, standard deviation 1, and a rational number.

Points without noise are written to the nearest double (17 digits); points with noise, as a measuring machine would, in
decimals.  The first and the last point have no noise: where the ends are not free, they are these points.
"""
import argparse
import json
import math
import pathlib
from fractions import Fraction as Q


class Generator:
    def __init__(self, name):
        self.x = 14695981039346656037
        for byte in name.encode():
            self.x = (self.x ^ byte) * 1099511628211 % 2**64
        for _ in range(8):
            self.draw()

    def draw(self):
        self.x = (6364136223846793005 * self.x + 1442695040888963407) % 2**64
        return self.x >> 32

    def uniform(self):
        return Q(2 * self.draw() + 1, 2**33)

    def normal(self):
        return sum((self.uniform() for _ in range(12)), Q(-6))

    def shuffle(self, items):
        for i in range(len(items) - 1, 0, -1):
            j = self.draw() % (i + 1)
            items[i], items[j] = items[j], items[i]


def bernstein_knots(p):
    return [Q(0)] * (p + 1) + [Q(1)] * (p + 1)


def basis(i, p, u, t):
    """N_{i,p}(t) by the recursion that defines it; at the end of the domain the limit from the left."""
    if p == 0:
        return Q(1) if u[i] <= t < u[i + 1] or (t == u[-1] and u[i] < t == u[i + 1]) else Q(0)
    left = (t - u[i]) / (u[i + p] - u[i]) * basis(i, p - 1, u, t) if u[i + p] > u[i] else Q(0)
    right = (u[i + p + 1] - t) / (u[i + p + 1] - u[i + 1]) * basis(i + 1, p - 1, u, t) if u[i + p + 1] > u[i + 1] else Q(0)
    return left + right


def point(p, u, weights, points, t):
    if len(u) == 2 * (p + 1):
        N = [math.comb(p, i) * t**i * (1 - t) ** (p - i) for i in range(p + 1)]
    else:
        N = [basis(i, p, u, t) for i in range(len(points))]
    R = [n * w for n, w in zip(N, weights)]
    return [sum(r * x[c] for r, x in zip(R, points)) / sum(R) for c in range(len(points[0]))]


def even(g, count):
    """Parameters 0 = t_1 < ... < t_N = 1, nearly evenly spaced, none in its even place."""
    inner = [(Q(i) + (g.uniform() - Q(1, 2)) / 2) / (count - 1) for i in range(1, count - 1)]
    return [Q(0)] + inner + [Q(1)]


def within(g, count):
    """Parameters in [1/16, 15/16]: no point has its foot at an end."""
    return [Q(1, 16) + s * 7 / 8 for s in even(g, count)]


def geometric(octaves):
    """Parameters for which t/(1-t) goes, in eighths of an octave, over that many octaves to both sides of 1."""
    def parameters(g, count):
        steps = [16 * octaves * i // (count - 1) for i in range(1, count - 1)]
        ratios = [Q(2) ** (k // 8 - octaves) * Q(8 + k % 8, 8) for k in steps]
        return [Q(0)] + [s / (1 + s) for s in ratios] + [Q(1)]
    return parameters


def decimals(x, digits):
    """The rational x rounded to that many decimals, halves upwards, as text."""
    n = math.floor(x * 10**digits + Q(1, 2))
    text = f"{abs(n):0{digits + 1}d}"
    return ("-" if n < 0 else "") + text[:-digits] + "." + text[-digits:]


def number(x):
    return str(x.numerator) if x.denominator == 1 else f"{x.numerator}/{x.denominator}"


PROBLEMS = {}


def problem(name, about, points, weights, count, noise="0", knots=None, parameters=even, digits=9, free=("weights", "inner"),
            sigma=None, outliers=0, outlier_size=0, unordered=False, hold=(), undetermined=None, by_cost=None, **options):
    """noise: standard deviation of every coordinate; sigma: decades over which the given deviations go, up to 7 times noise;
    outliers: every so many-th point is off by up to outlier_size in every coordinate; hold: coordinates (point, number) that
    the certifier holds, because the curves that slide along themselves have one cost; undetermined, by_cost: why
    only the cost, or the estimates only as far as the cost shows, is compared."""
    PROBLEMS[name] = dict(about=about, points=[[Q(x) for x in row.split()] for row in points.split(",")],
                          weights=[Q(w) for w in weights.split()], count=count, noise=Q(noise),
                          knots=[Q(u) for u in knots.split()] if knots else None, parameters=parameters, digits=digits,
                          free=list(free), sigma=sigma, outliers=outliers, outlier_size=Q(outlier_size),
                          unordered=unordered, hold=hold, undetermined=undetermined, by_cost=by_cost, options=options)


def initial(points, weights):
    return {"points": [[float(Q(x)) for x in row.split()] for row in points.split(",")],
            "weights": [float(Q(w)) for w in weights.split()]}


def make(name, folder):
    it = PROBLEMS[name]
    g, n, dim = Generator(name), it["count"], len(it["points"][0])
    p = it["options"].get("degree", len(it["points"]) - 1)
    u = it["knots"] or bernstein_knots(p)
    span = u[-1] - u[0]
    rows = []
    for i, s in enumerate(it["parameters"](g, n)):
        x = point(p, u, it["weights"], it["points"], u[0] + span * s)
        sd, end = it["noise"], i in (0, n - 1)
        if it["sigma"]:
            sd *= Q([10, 15, 20, 30, 50, 70][g.draw() % 6], 10 ** (1 + g.draw() % it["sigma"]))
        kick = [Q(0)] * dim
        if it["outliers"] and not end and i % it["outliers"] == it["outliers"] // 2:
            kick = [it["outlier_size"] * (2 * g.uniform() - 1) for _ in range(dim)]
        if sd and not (end and "ends" not in it["free"]):
            x = [a + sd * g.normal() + k for a, k in zip(x, kick)]
        row = [decimals(a, it["digits"]) if it["noise"] else repr(float(a)) for a in x]
        rows.append(row + ([decimals(sd, 9)] if it["sigma"] else []))
    if it["unordered"]:
        g.shuffle(rows)
    lines = [f"# {name}: {it['about']}",
             f"# Made by proofs-tests/fit/generate.py (version 1) from the curve in {name}.json; integer noise, nothing measured."]
    lines += [",".join("xyz"[:dim]) + (",sigma" if it["sigma"] else "")]
    (folder / f"{name}.csv").write_text("\n".join(lines + [",".join(row) for row in rows]) + "\n")
    options = {"degree": p, "free": it["free"]}
    if it["knots"]:
        options["knots"] = [float(x) for x in u]
    if it["unordered"]:
        options["unordered"] = True
    options.update(it["options"])
    record = {"schema": "cagd-fit-problem/1", "name": name, "about": it["about"], "data": f"{name}.csv",
              "options": options, "noise": float(it["noise"]),
              "truth": {"points": [[number(x) for x in row] for row in it["points"]],
                        "weights": [number(w) for w in it["weights"]]}}
    if it["hold"]:
        record["hold"] = it["hold"]
    if it["by_cost"]:
        record["by-cost"] = it["by_cost"]
    if it["undetermined"]:
        record["undetermined"] = it["undetermined"]
    (folder / f"{name}.json").write_text(json.dumps(record, indent=1) + "\n")


# Noise-free.  The weights come back to the last digits that the rounding of the data leaves.
problem("ellipse", "twelve points of an elliptic arc, no noise", "0 0, 1 2, 3 1/2", "1 3/5 1", 12)
problem("parabola-exact", "a polynomial parabola at dyadic parameters: every number is a double and the minimum is 0",
        "0 0, 1 3, 4 1", "1 1 1", 17, parameters=lambda g, n: [Q(i, n - 1) for i in range(n)])
problem("hyperbola", "an arc of a hyperbola that turns sharply, no noise", "-1 2, 0 -3, 5/2 3", "1 7 1", 30)
problem("cubic", "a rational cubic with an inflection, no noise", "0 0, 1 2, 3 -2, 4 1", "1 5/2 3/5 1", 25, starts=5)
problem("quartic", "a rational quartic, no noise", "0 0, 0 2, 2 3, 4 1, 5 2", "1 2 3/4 3/2 1", 60)
problem("quartic-loop", "a rational quartic with a loop, no noise", "0 0, 0 3, 4 3, 4 0, 1 1", "1 2 3/4 3/2 1", 60, starts=10)
problem("space-quartic", "a rational quartic in space, no noise", "0 0 0, 1 2 1, 2 -1 3, 3 1 -1, 4 0 1",
        "1 3/2 2/3 5/4 1", 50)
problem("six-decades", "degree 6, weights from 1 to 1 000 000, no noise, from a tenth of the true weights",
        "0 0, 1 2, 2 -1, 7/2 3, 5 -1, 6 2, 7 0", "1 1000 100000 1000000 100000 1000 1", 120, parameters=geometric(20),
        initial=initial("0 0, 1 2, 2 -1, 7/2 3, 5 -1, 6 2, 7 0", "1 100 10000 100000 10000 100 1"))

# With noise.
problem("parabola", "a parabola through its ends, noise 1/500", "0 0, 1 3, 4 1", "1 1 1", 40, "1/500")
problem("hyperbola-noise", "an arc of a hyperbola, noise 1/1000", "0 2, 0 0, 3 0", "1 5/2 1", 45, "1/1000")
problem("cubic-noise", "a rational cubic, noise 1/500", "0 0, 1 2, 3 -2, 4 1", "1 5/2 3/5 1", 60, "1/500", starts=5)
problem("large-noise", "a conic, noise of a tenth of its height", "0 0, 2 2, 4 0", "1 3/2 1", 30, "1/10")
problem("nearly-flat", "a cubic whose height is a thousandth of its length, noise 1/10 000 000",
        "0 0, 1 1/1000, 2 -1/1000, 3 1/2000", "1 2 3/4 1", 60, "1/10000000", digits=12)
problem("nearly-cusped", "a cubic that nearly has a cusp, noise 1/20 000",
        "0 0, 1 1, 1/8 1, 1 0", "1 6/5 9/10 1", 120, "1/20000")
problem("sigmas", "a cubic, standard deviations over two decades, given", "0 0, 1 2, 3 2, 4 -1", "1 3/4 2 1", 50, "1/200",
        sigma=2)
problem("space-cubic", "a cubic in space, given standard deviations over one decade", "0 0 0, 1 2 0, 2 -1 2, 3 1 3",
        "1 2 3/2 1", 40, "1/500", sigma=1)
problem("spline", "a cubic spline of three spans, noise 1/5000: every weight but the first is free",
        "0 0, 1/2 2, 2 2, 3 -1, 9/2 0, 5 2", "1 2 3/4 3/2 1/2 5/4", 150, "1/5000",
        knots="0 0 0 0 1/4 5/8 1 1 1 1", degree=3, starts=5,
        by_cost="the valley is so curved that the last steps of Gauss and Newton change the cost by less than its rounding")
problem("fixed-points", "only the weights of a quintic are free, noise 1/1000",
        "0 0, 1 3, 2 -2, 3 3, 4 -2, 5 1", "1 3 1/2 2 2/3 1", 80, "1/1000", free=("weights",),
        initial=initial("0 0, 1 3, 2 -2, 3 3, 4 -2, 5 1", "1 1 1 1 1 1"))
problem("unordered", "a conic whose points come in no order, noise 1/1000", "0 0, 1 4, 4 1", "1 4/5 1", 60, "1/1000",
        unordered=True, initial=initial("0 0, 2 2, 4 1", "1 1 1"))
problem("free-ends", "a conic whose ends are free and slide along it: rank two less than unknowns; noise 1/1000",
        "0 0, 1 2, 3 1/2", "1 3/5 1", 50, "1/1000", free=("weights", "inner", "ends"),
        parameters=within, hold=[[0, 0], [2, 0]])
problem("cubic-free-ends", "a cubic all of whose points are free and slide: rank two less than unknowns; noise 1/1000; the minimum "
        "beside the true curve, for there is a slightly lower one with other weights",
        "0 0, 1 2, 3 -2, 4 1", "1 3/2 3/5 1", 80, "1/1000", free=("weights", "inner", "ends"),
        parameters=within, hold=[[0, 0], [3, 0]], initial=initial("0 0, 1 2, 3 -2, 4 1", "1 3/2 3/5 1"))
problem("at-bound", "a conic whose weight may not pass 2 but is 3, noise 1/1000", "0 0, 1 2, 3 0", "1 3 1", 40, "1/1000",
        **{"weights-between": [0.5, 2]})

# Near a curve with a cusp, where the manifold of rational cubics has an edge: the minimum may lie on the edge itself, and there
# J has one rank less although the minimum is strict.
problem("cuspidal-edge", "a cubic whose closest curve has a cusp (outside the arc), noise 1/500", "0 0, 1 2, 3 -2, 4 1",
        "1 3/2 3/5 1", 72, "1/500", starts=10,
        undetermined="J has rank 5 of 6 at the minimum, which binary64 cannot tell from 6, and the cost is flat to its last digit over "
                     "1e-7 of the weights")

# Bad starts.
problem("bad-start", "a cubic from a start whose inner points are exchanged and whose weights are 1/20 and 20",
        "0 0, 1 2, 3 2, 4 -1", "1 2 3/4 1", 60, "1/1000", initial=initial("0 0, 3 2, 1 2, 4 -1", "1 1/20 20 1"))
problem("bad-weights", "a quartic, noise 1/500 000, from weights 1000 and 1/1000", "0 0, 1 3, 5/2 -1, 4 2, 5 0", "1 2 3/4 3/2 1", 80,
        "1/500000", initial=initial("0 0, 1 1, 2 1, 3 1, 5 0", "1 1000 1/1000 1000 1"), starts=8)

# Outliers.
problem("huber", "a cubic with eight outliers, Huber's loss", "0 0, 1 2, 3 2, 4 -1", "1 2 3/4 1", 72, "1/500",
        outliers=9, outlier_size="1/5", starts=5, loss="huber", scale=0.003)
problem("cauchy", "a conic with five outliers, Cauchy's loss", "0 0, 1 3, 4 1", "1 3/2 1", 60, "1/500",
        outliers=12, outlier_size="1/2", loss="cauchy", scale=0.005)

# Many.
problem("twenty-thousand", "a cubic, 20 000 points, noise 1/500", "0 0, 1 2, 3 2, 4 -1", "1 2 3/4 1", 20000, "1/500",
        digits=6)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("names", nargs="*", default=[])
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name in arguments.names or PROBLEMS:
        make(name, arguments.out)


if __name__ == "__main__":
    main()
