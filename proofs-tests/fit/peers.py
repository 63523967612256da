"""The certified problems with SciPy: scipy.odr and scipy.optimize.least_squares, all unknowns and feet together, from the true curve.

    peers.py [NAME ...]      without names all problems of up to 200 points that have no bounds, fixed unknowns or free ends

Prints the digits of the certified cost, weights and standard errors that each gets.  Not a test; needs python3-scipy.
"""
import json
import math
import pathlib
import sys
import time

try:
    import numpy as np
    from scipy import odr, optimize
except ImportError:
    sys.exit("peers.py: python3-scipy is not installed: skipped")

PROBLEMS = pathlib.Path(__file__).resolve().parent / "problems"


def rational(text):
    a, _, b = text.partition("/")
    return int(a) / int(b or 1)


def digits(x, certified):
    error = abs(x - certified) / abs(certified)
    return 16.0 if error < 1e-16 else max(0.0, -math.log10(error)) if error < 1 else 0.0


class Problem:
    def __init__(self, name):
        self.file = json.loads((PROBLEMS / f"{name}.json").read_text())
        rows = [line.split(",") for line in (PROBLEMS / f"{name}.csv").read_text().splitlines() if line[0] not in "#x"]
        header = next(line for line in (PROBLEMS / f"{name}.csv").read_text().splitlines() if line[0] == "x").split(",")
        data, options = np.array(rows, float), self.file["options"]
        self.dim = 3 if "z" in header else 2
        self.Q, self.known = data[:, : self.dim], "sigma" in header
        self.sigma = data[:, self.dim] if self.known else np.ones(len(data))
        self.p, self.truth = options["degree"], self.file["truth"]
        self.points = np.array([[rational(x) for x in row] for row in self.truth["points"]])
        self.weights = np.array([rational(w) for w in self.truth["weights"]])
        self.points[0], self.points[-1] = self.Q[0], self.Q[-1]
        self.loss, self.scale = options.get("loss", "squares"), options.get("scale", 1.0)
        self.good = ("knots" not in options and options["free"] == ["weights", "inner"] and "weights-between" not in options
                     and not options.get("unordered") and len(data) <= 200)
        self.start = np.concatenate([np.log(self.weights[1:-1]), self.points[1:-1].ravel()])
        grid = np.linspace(0, 1, 4001)
        where = self.curve(self.start, grid)
        self.t = np.array([grid[np.argmin(((where - q) ** 2).sum(1))] for q in self.Q])

    def curve(self, theta, t):
        w, P = self.weights.copy(), self.points.copy()
        w[1:-1] = np.exp(theta[: self.p - 1])
        P[1:-1] = theta[self.p - 1 :].reshape(-1, self.dim)
        N = np.array([math.comb(self.p, i) * t**i * (1 - t) ** (self.p - i) for i in range(self.p + 1)]).T * w
        return (N @ P) / N.sum(1)[:, None]

    def least_squares(self):
        n, N = len(self.start), len(self.Q)
        def residuals(x):
            r = (self.curve(x[:n], x[n:]) - self.Q) / self.sigma[:, None]
            if self.loss == "squares":
                return r.ravel()
            s = (r**2).sum(1)
            a = self.scale
            rho = np.where(s <= a * a, s, 2 * a * np.sqrt(s) - a * a) if self.loss == "huber" else a * a * np.log1p(s / a**2)
            return (r * np.sqrt(rho / np.maximum(s, 1e-300))[:, None]).ravel()
        low = np.concatenate([np.full(n, -np.inf), np.full(N, -1e-12)])
        high = np.concatenate([np.full(n, np.inf), np.full(N, 1 + 1e-12)])
        x0 = np.concatenate([self.start, np.clip(self.t, 0, 1)])
        found = optimize.least_squares(residuals, x0, jac="3-point", bounds=(low, high), xtol=1e-15, ftol=1e-15, gtol=1e-15,
                                       x_scale="jac", max_nfev=500)
        C = np.linalg.pinv(found.jac.T @ found.jac)
        return found.cost, found.x[:n], np.sqrt(np.diag(C)[:n])

    def odr(self):
        """t is a variable without observation: its error is nearly free.  A smaller weight than this makes ODRPACK stop early."""
        model = odr.Model(lambda theta, t: self.curve(theta, np.clip(t, 0, 1)).T)
        data = odr.Data(np.clip(self.t, 0, 1), self.Q.T, wd=1e-10,
                        we=np.array([np.eye(self.dim) / s**2 for s in self.sigma]).transpose(1, 2, 0))
        found = odr.ODR(data, model, beta0=self.start, maxit=500, sstol=1e-15, partol=1e-15).run()
        return found.sum_square / 2, found.beta, np.sqrt(np.diag(found.cov_beta))


def main():
    names = sys.argv[1:] or sorted(p.stem for p in PROBLEMS.glob("*.json") if p.stem != "twenty-thousand")
    print(f"{'':18} {'peer':14} {'cost':>5} {'w':>5} {'errors':>6} {'ms':>8}")
    for name in names:
        it = Problem(name)
        if not it.good:
            continue
        certified = it.file["certified"]
        exact = it.file["noise"] == 0
        scale = math.sqrt(float(certified["scale_squared"])) if "scale_squared" in certified else math.nan
        errors = {e["log-weight"]: e for e in certified["estimates"] if "log-weight" in e}
        for peer, run in (("least_squares", it.least_squares), ("odr", it.odr)):
            if peer == "odr" and it.loss != "squares":
                continue
            begin = time.perf_counter()
            cost, theta, error = run()
            passed = time.perf_counter() - begin
            w = min(digits(math.exp(theta[j - 1]), float(certified["weights"][j])) for j in errors)
            e = min((digits(error[j - 1] * scale, float(x["standard_error"])) for j, x in errors.items()
                     if "standard_error" in x), default=math.nan)
            shown = ("    -", "     -") if exact else (f"{digits(cost, float(certified['cost'])):5.1f}", f"{e:6.1f}")
            print(f"{name:18} {peer:14} {shown[0]} {w:5.1f} {shown[1]} {1e3 * passed:8.0f}", flush=True)


if __name__ == "__main__":
    main()
