"""cagd check --basis: the sheets of published bases, against the same functions written in Python.

    python3 test_basis.py CAGD

What a sheet says is attacked from outside: at the ends of a range the property holds at many points, and a little beyond them points are
found where it does not.
"""
import itertools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction as F

HERE = pathlib.Path(__file__).resolve().parent
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
UNIT = [F(k, 40) for k in range(41)]


def binomial_product(n, i, t, a):
    value = F(math.comb(n, i))
    for k in range(i):
        value *= t + k * a
    for k in range(n - i):
        value *= 1 - t + k * a
    return value


def deng(t, b, middle):
    s = 1 - t
    p3, p4 = (35 + 5 * b - 5 * b * t, 35 + 5 * b * t) if middle else (35 + 5 * b - 9 * b * t, 35 + b * t)
    return [(1 - b * t) * s**7, (7 + b - 5 * b * t) * s**6 * t, (21 + 4 * b - 9 * b * t) * s**5 * t**2, p3 * s**4 * t**3,
            p4 * s**3 * t**4, (21 - 5 * b + 9 * b * t) * s**2 * t**5, (7 - 4 * b + 5 * b * t) * s * t**6, (1 - b + b * t) * t**7]


def said_ball(t, _):
    left = [math.comb(2 + i, i) * t**i * (1 - t)**3 for i in range(3)]
    return left + [math.comb(2 + i, i) * (1 - t)**i * t**3 for i in (2, 1, 0)]


def quasi_quadratic(t, x):
    common = 1 - x * t + x * t * t
    return [(1 - t)**2 * common, 2 * t * (1 - t) * (x / 2 + common), t**2 * common]


def rational(t, w):
    d = (1 - t)**2 + 2 * w * t * (1 - t) + t * t
    return [(1 - t)**2 / d, 2 * w * t * (1 - t) / d, t * t / d]


def bernstein(n, i, t):
    return math.comb(n, i) * t**i * (1 - t)**(n - i)


def lambda_bernstein(n, t, x):
    inner = [bernstein(n, i, t) + x * (F(n - 2 * i + 1, n * n - 1) * bernstein(n + 1, i, t) - F(n - 2 * i - 1, n * n - 1) * bernstein(n + 1, i + 1, t))
             for i in range(1, n)]
    return [bernstein(n, 0, t) - x * bernstein(n + 1, 1, t) / (n + 1)] + inner + [bernstein(n, n, t) - x * bernstein(n + 1, n, t) / (n + 1)]


def lupas(t, q):
    common = (1 - t + q * t) * (1 - t + q * q * t)
    return [f / common for f in ((1 - t)**3, (1 + q + q * q) * t * (1 - t)**2, (1 + q + q * q) * q * t * t * (1 - t), q**3 * t**3)]


def recursive(first, u):
    """b_i^3 = (1-u) b_i^2 + u b_{i-1}^2."""
    return [(1 - u) * first[0], (1 - u) * first[1] + u * first[0], (1 - u) * first[2] + u * first[1], u * first[2]]


def sine_and_cosine(x):
    return 2 * x / (1 + x * x), (1 - x * x) / (1 + x * x)


def trigonometric_quadratic(x, k):
    s, c = sine_and_cosine(x)
    return [(1 - s) * (1 - k * s), (1 + k) * (s + c - 1), (1 - c) * (1 - k * c)]


def trigonometric_cubic(x, k):
    s, c = sine_and_cosine(x)
    return [(1 - s)**2 * (1 - k * s), s * (1 - s) * (2 + k - k * s), c * (1 - c) * (2 + k - k * c), (1 - c)**2 * (1 - k * c)]


FUNCTIONS = {
    "bernstein": lambda t, _: [math.comb(8, i) * t**i * (1 - t)**(8 - i) for i in range(9)],
    "deng-zhang-2022": lambda t, b: deng(t, b, False),
    "deng-zhang-2022-corrected": lambda t, b: deng(t, b, True),
    "said-ball": said_ball,
    "ball": lambda t, _: [(1 - t)**2, 2 * t * (1 - t)**2, 2 * t**2 * (1 - t), t**2],
    "quasi-cubic": lambda t, x: [(1 - x * t) * (1 - t)**2, (2 + x) * (1 - t)**2 * t, (2 + x) * (1 - t) * t**2, (1 - x + x * t) * t**2],
    "quasi-quadratic": quasi_quadratic,
    "q-bernstein": lambda t, q: [(1 - t) * (1 - q * t) * (1 - q * q * t), (1 + q + q * q) * t * (1 - t) * (1 - q * t),
                                 (1 + q + q * q) * t * t * (1 - t), t**3],
    "polya": lambda t, a: [binomial_product(3, i, t, a) / ((1 + a) * (1 + 2 * a)) for i in range(4)],
    "rational": rational,
    "pulled-to-the-chord": lambda t, c: [(1 - t)**2 + c * t * (1 - t), (2 - 2 * c) * t * (1 - t), t * t + c * t * (1 - t)],
    "other-interval": lambda t, _: [math.comb(3, i) * t**i * (1 - t)**(3 - i) for i in range(4)],
    "not-symmetric": lambda t, _: [(1 - t)**2 + (t - F(1, 2))**2, t * (1 - t), 1 - (1 - t)**2 - (t - F(1, 2))**2 - t * (1 - t)],
    "negative": lambda t, _: [t + 1, t - 2],
    "lambda-4": lambda t, x: lambda_bernstein(4, t, x),
    "alpha-3": lambda t, a: [(1 - a * t) * (1 - t)**2, t * (1 - t) * (1 - a + 3 * a * (1 - t)), t * (1 - t) * (1 - a + 3 * a * t),
                             t * t * (1 - a + a * t)],
    "cubic-alternative": lambda t, a: [(1 - t)**2 * (1 + (2 - a) * t), a * t * (1 - t)**2, 3 * t * t * (1 - t), t**3],
    "timmer": lambda t, _: [(1 - 2 * t) * (1 - t)**2, 4 * t * (1 - t)**2, 4 * t * t * (1 - t), (2 * t - 1) * t * t],
    "delgado-pena": lambda t, _: [(1 - t)**5, t * (1 - t)**4, t * (1 - t)**3 + (1 - t**3 - (1 - t)**3) / 2,
                                  t**3 * (1 - t) + (1 - t**3 - (1 - t)**3) / 2, t**4 * (1 - t), t**5],
    "lupas": lupas,
    "trigonometric-quadratic": trigonometric_quadratic,
    "trigonometric-recursive": lambda x, k: recursive(trigonometric_quadratic(x, k), sine_and_cosine(x)[0]),
    "trigonometric-cubic": trigonometric_cubic,
    "angle-quadratic": trigonometric_quadratic,
    "angle-cubic": trigonometric_cubic,
    "half-a-turn": lambda x, _: [sine_and_cosine(x)[1]**2, sine_and_cosine(x)[0]**2],  # by half of the angle, of which x is the tangent of a half
    "recursive-cubic": lambda t, x: recursive(quasi_quadratic(t, x), t),
    "one-of-two": lambda t, x: [(1 - x * t) * (1 - t)**3, (3 + x - x * t) * (1 - t)**2 * t, 3 * (1 - t)**2 * t * t, (4 - 3 * t) * t**3],
}
# linearly independent, sum 1, nonnegative, symmetric, 1 and 0 at the ends, Bernstein, totally positive; a range is (low, high),
# None being no end; True and False are for all and for no value, a list is one of single values.
ORDER = ("linearly_independent", "partition_of_unity", "nonnegative", "symmetric", "interpolates_ends", "bernstein", "totally_positive")
EXPECTED = {
    "bernstein": (True,) * 7,
    "deng-zhang-2022": ("β < −7, −7 < β < −21/4 and β > −21/4", [0], (F(-21, 4), 1), [0], True, [0], (F(-21, 4), 1)),
    "deng-zhang-2022-corrected": ("β < −7, −7 < β < −21/4 and β > −21/4", True, (F(-21, 4), 1), True, True, [0], (F(-21, 4), 1)),
    "said-ball": (True, True, True, True, True, False, True),
    "ball": (True, True, True, True, True, False, True),
    "quasi-cubic": ("λ < −2 and λ > −2", True, (-2, 1), True, True, [1], (-2, 1)),
    "quasi-quadratic": (True, True, (-2, 4), True, True, [0], (-2, F(10, 3))),
    "q-bernstein": (True, True, (-1, 1), [1], True, [1], (-1, 1)),
    "polya": ("a < −1, −1 < a < −1/2 and a > −1/2", True, (0, None), True, True, [0], (0, None)),
    "rational": (True, True, True, True, True, [1], True),
    "pulled-to-the-chord": ("c < 1 and c > 1", True, (0, 1), True, True, [0], (0, 1)),
    "other-interval": (True,) * 7,
    "not-symmetric": (True, True, False, False, False, False, False),
    "negative": (True, False, False, False, False, False, False),
    # shape.md: -1 <= λ <= 1 and 0 <= α <= 1 are what the papers have; by the tangent of half the angle nothing is symmetric
    "lambda-4": ("λ < −9, −9 < λ < −4 and λ > −4", True, (-4, 1), True, True, [0], (-4, 1)),
    "alpha-3": ("α < −2, −2 < α < 0 and α > 0", True, (F(-1, 2), 1), True, True, [1], (0, 1)),
    "cubic-alternative": ("α < 0 and α > 0", True, (0, 3), [3], True, [3], (0, 3)),
    "timmer": (True, True, False, True, True, False, False),
    "delgado-pena": (True, True, True, True, True, False, True),
    "lupas": (True, True, True, [1], True, [1], True),
    "trigonometric-quadratic": ("λ < −1 and λ > −1", True, (-1, 1), False, True, False, (-1, 1)),
    "trigonometric-recursive": (True, True, (-1, 1), False, True, False, (-1, 1)),
    "trigonometric-cubic": (True, True, (-2, 1), False, True, False, (-2, 1)),
    "angle-quadratic": ("λ < −1 and λ > −1", True, (-1, 1), True, True, None, (-1, 1)),
    "angle-cubic": (True, True, (-2, 1), True, True, None, (-2, 1)),
    "half-a-turn": (True, True, True, True, True, None, True),
    "recursive-cubic": (True, True, (-3, 4), True, True, [0], f"−3 ≤ λ ≤ {(33 - 9 * 5**0.5) / 4:.6f}…"), # of 4λ² − 66λ + 171
    "one-of-two": ("λ < −3 and λ > −3", True, (-3, 1), [-3], True, False, (-3, 1)),
}


def text_of(parameter, expected):
    if isinstance(expected, str):
        return expected
    number = lambda x: str(F(x)).replace("-", "−")
    if isinstance(expected, list):
        return " and ".join(f"{parameter} = {number(x)}" for x in expected) if expected else f"no {parameter}"
    low, high = expected
    return f"{parameter} ≥ {number(low)}" if high is None else f"{number(low)} ≤ {parameter} ≤ {number(high)}"


def determinant(rows):
    rows, value = [list(r) for r in rows], F(1)
    for k in range(len(rows)):
        pivot = next((r for r in range(k, len(rows)) if rows[r][k] != 0), None)
        if pivot is None:
            return F(0)
        if pivot != k:
            rows[k], rows[pivot], value = rows[pivot], rows[k], -value
        value *= rows[k][k]
        for r in range(k + 1, len(rows)):
            factor = rows[r][k] / rows[k][k]
            rows[r] = [a - factor * b for a, b in zip(rows[r], rows[k])]
    return value


def some_minor_is_negative(functions, parameter, tries=200):
    """Minors of neighbouring columns at points that lie closely together, everywhere in (0,1)."""
    columns = len(functions(F(1, 3), parameter))
    for order in range(1, min(columns, 4) + 1):
        for first in range(columns - order + 1):
            for t in UNIT[:-1]:
                for h in (F(1, 100), F(1, 10000)):
                    rows = [functions(t + (k + 1) * h, parameter)[first:first + order] for k in range(order)]
                    if t + (order + 1) * h < 1 and determinant(rows) < 0:
                        return True
    return False


class Sheets(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.results = [subprocess.run([CAGD, "check", "--basis", "--json", HERE / name], capture_output=True, text=True, timeout=300)
                       for name in ("bases.md", "shape.md")]
        cls.json = [json.loads(r.stdout) for r in cls.results]
        cls.sheets = {s["name"]: s for j in cls.json for s in j["bases"]}

    def test_all_is_decided(self):
        for r, j in zip(self.results, self.json):
            self.assertEqual(r.returncode, 0)
            self.assertEqual(j["statements"], [])
        self.assertEqual(set(self.sheets), set(FUNCTIONS))

    def test_limits_are_told(self):
        """x^{i-1} has no value at x = 0, i = 0."""
        told = {name for name, s in self.sheets.items() for p in s["properties"] if p.get("of_limits")}
        self.assertEqual(told, {"alpha-3"})

    def test_every_property_has_its_range(self):
        for name, expected in EXPECTED.items():
            sheet = self.sheets[name]
            found = {p["property"]: p for p in sheet["properties"]}
            for key, value in zip(ORDER, expected):
                if value is None:
                    self.assertNotIn(key, found)
                    continue
                p = found[key]
                with self.subTest(basis=name, property=key):
                    self.assertTrue(p["complete"])
                    if value is True or value is False:
                        self.assertEqual(p["verdict"], "holds" if value else "fails", p)
                    else:
                        self.assertEqual(p["values"].replace("− ", "−"), text_of(sheet["parameter"].replace("\\beta", "β").replace("\\lambda", "λ").replace("\\omega", "ω").replace("\\alpha", "α"), value))
                    if p["verdict"] != "holds":
                        self.assertTrue(p.get("fails_for") or key == "linearly_independent", p)

    def test_ranges_from_outside(self):
        for name, expected in EXPECTED.items():
            f, attempts = FUNCTIONS[name], dict(zip(ORDER, expected))
            for key in ("nonnegative", "totally_positive"):
                if not isinstance(attempts[key], tuple):
                    continue
                for end, outwards in zip(attempts[key], (-1, 1)):
                    if end is None:
                        continue
                    beyond = F(end) + outwards * F(1, 20)
                    with self.subTest(basis=name, property=key, end=end):
                        if key == "nonnegative":
                            self.assertTrue(all(y >= 0 for t in UNIT for y in f(t, F(end))))
                            self.assertTrue(any(y < 0 for t in [F(k, 400) for k in range(401)] for y in f(t, beyond)))
                        else:
                            self.assertFalse(some_minor_is_negative(f, F(end)))
                            self.assertTrue(some_minor_is_negative(f, beyond))

    def test_minors_of_distant_points_are_nonnegative_where_it_says_so(self):
        r = random.Random(2022)
        for name, expected in EXPECTED.items():
            value = expected[ORDER.index("totally_positive")]
            if value is False:
                continue
            for _ in range(12):
                low, high = value if isinstance(value, tuple) else (0, 1)
                parameter = F(low) + F(r.randint(1, 99), 100) * ((F(high) if high is not None else F(low) + 3) - F(low))
                t = sorted(F(k, 1000) for k in r.sample(range(1001), 5))
                rows = [FUNCTIONS[name](x, parameter) for x in t]
                for order in (1, 2, 3):
                    for columns in itertools.combinations(range(len(rows[0])), order):
                        for lines in itertools.combinations(rows, order):
                            self.assertGreaterEqual(determinant([[line[c] for c in columns] for line in lines]), 0, (name, parameter, t))

    def test_negative_minors_are_negative(self):
        p = next(p for p in self.sheets["not-symmetric"]["properties"] if p["property"] == "totally_positive")
        self.assertIn("G₂ at", p["fails_for"])

    def test_coefficients_give_the_functions(self):
        for name in ("bernstein", "said-ball", "ball", "other-interval", "not-symmetric", "negative"):
            rows = [[F(c.replace("−", "-")) for c in row] for row in self.sheets[name]["bernstein_coefficients"]]
            n = len(rows[0]) - 1
            for t in UNIT:
                B = [math.comb(n, j) * t**j * (1 - t)**(n - j) for j in range(n + 1)]
                self.assertEqual([sum(c * b for c, b in zip(row, B)) for row in rows], FUNCTIONS[name](t, None), name)

    def test_values_at_the_ends(self):
        sheet = self.sheets["deng-zhang-2022-corrected"]
        ends = {(e["at"], e["order"]): e["values"] for e in sheet["ends"]}
        self.assertEqual(ends["0", 0], ["1"] + ["0"] * 7)
        self.assertEqual(ends["0", 1][:2], ["−β − 7", "β + 7"])
        self.assertEqual(ends["1", 1][6:], ["−β − 7", "β + 7"])

    def test_values_at_the_ends_of_an_angle(self):
        """Derivatives by the angle: K_0' = -(1 - s) (2 + lambda - 3 lambda s) c and K_1' = (2 + lambda - 4 (1 + lambda) s + 3 lambda s^2) c, by hand."""
        ends = {(e["at"], e["order"]): e["values"] for e in self.sheets["angle-cubic"]["ends"]}
        self.assertEqual(self.sheets["angle-cubic"]["interval"], ["0", "π/2"])
        self.assertEqual(ends["0", 0], ["1", "0", "0", "0"])
        self.assertEqual(ends["0", 1], ["−λ − 2", "λ + 2", "0", "0"])
        self.assertEqual(ends["0", 2], ["4λ + 2", "−4λ − 4", "2", "0"])
        self.assertEqual(ends["π/2", 1], ["0", "0", "−λ − 2", "λ + 2"])
        ends = {(e["at"], e["order"]): e["values"] for e in self.sheets["half-a-turn"]["ends"]}
        self.assertEqual([ends["0", 2], ends["π", 2]], [["−1/2", "1/2"], ["1/2", "−1/2"]])

    def test_monotony(self):
        self.assertEqual(self.sheets["quasi-cubic"]["with_parameter"], ["decreasing", "increasing", "increasing", "decreasing"])
        self.assertEqual(self.sheets["pulled-to-the-chord"]["with_parameter"], ["increasing", "decreasing", "increasing"])
        self.assertEqual(self.sheets["deng-zhang-2022-corrected"]["with_parameter"][1], "neither")


class Pages(unittest.TestCase):
    def check(self, block, *options, let="b_i(t) = \\binom{2}{i} t^i (1-t)^{2-i}\n\\lambda \\in \\mathbb{R}"):
        text = f":::{{let}}\n{let}\n:::\n:::{{basis}} mine\n{block}\n:::\n"
        return subprocess.run([CAGD, "check", *options, "-"], input=text, capture_output=True, text=True, timeout=60)

    def test_a_page(self):
        r = self.check(":functions: b_i(t)\n:for: i = 0..2, 0 \\le t \\le 1")
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        for words in ("bᵢ(t), i = 0 to 2, 0 ≤ t ≤ 1", "sum is 1                  yes (proved)", "totally positive          yes (decided)"):
            self.assertIn(words, r.stdout)

    def test_mistakes(self):
        ranges = "\n:for: i = 0..2, 0 \\le t \\le 1"
        for block, words in ((":functions: b_1(t)" + ranges, "one index and an argument"), (":functions: b_i(0)" + ranges, "one index and an argument"),
                             (":functions: b_i(t)\n:for: 0 \\le t \\le 1", "i is not defined"), (":functions: b_i(t)\n:for: i = 0..99, 0 \\le t \\le 1", "2 to 33 functions"),
                             (ranges[1:], "without functions"), (":functions: b_i(t)" + ranges + "\n:find: z", "not defined"),
                             (":functions: b_i(t)\n:for: i = 0, 2, 1, 0 \\le t \\le 1", "the range of the index is not known"),
                             (":functions: b_i(t)\n:for: i = 0, 2, \\dots, 4, 0 \\le t \\le 1", "the range of the index is not known"),
                             (":functions: b_i(t)" + ranges + "\n:at: 1, 2, 3, 4", "at most 3"), (":function: b_i(t)", ":functions:")):
            r = self.check(block)
            self.assertEqual((r.returncode, r.stdout), (2, ""), block)
            self.assertIn(words, r.stderr)

    def test_what_is_not_decided_is_told(self):
        ranges = "\n:for: i = 0..2, 0 \\le t \\le 1"
        r = self.check(":functions: b_i(t)\n:for: i = 0..2")
        self.assertEqual(r.returncode, 1)
        self.assertIn("the interval of the argument is not known", r.stdout)
        r = self.check(":functions: c_i(t)" + ranges, let="\\lambda, \\mu \\in \\mathbb{R}\nc_i(t) = t^i (\\lambda + \\mu t)")
        self.assertEqual(r.returncode, 1)
        self.assertIn("there are other variables", r.stdout)

    def test_the_parameter_may_stand_before_the_argument(self):
        """Ye, Long and Zeng (2010) write b_i(\\lambda; t): the argument is the letter that is not asked for."""
        told = []
        for arguments in ("t;\\lambda", "\\lambda;t"):
            let = f"\\lambda \\in [-9, 9]\nb_0({arguments}) = (1-t)^2 (1-\\lambda t)\nb_1({arguments}) = t(1-t) (2+\\lambda)\nb_2({arguments}) = t^2 (1-\\lambda+\\lambda t)"
            r = self.check(f":functions: b_i({arguments})\n:for: i = 0..2, 0 \\le t \\le 1\n:find: \\lambda", let=let)
            self.assertEqual((r.returncode, r.stderr), (0, ""))
            told.append(r.stdout.split("Properties")[1])
        self.assertEqual(told[0], told[1])
        self.assertIn("nonnegative               −2 ≤ λ ≤ 1", told[0])

    def test_the_angle_of_a_sheet_is_the_argument(self):
        let = "f_0(t) = 1 - \\sin\\frac{\\pi t}{2}\nf_1(t) = \\sin\\frac{\\pi t}{2}"
        r = self.check(":functions: f_i(t)\n:for: i = 0..1, 0 \\le t \\le 1", let=let)
        self.assertEqual(r.returncode, 1)
        self.assertIn("take the angle as the argument", r.stdout)

    def test_where_the_denominators_are_not_0(self):
        let = "m \\in \\mathbb{R}\nr_i(t;m) = \\frac{\\binom{2}{i} t^i (1-t)^{2-i}}{(1-t)^2 + 2 m t (1-t) + t^2}\ns_i(t) = \\frac{t^i}{2 t - 1}"
        r = self.check(":functions: r_i(t;m)\n:for: i = 0..2, 0 \\le t \\le 1\n:find: m", let=let)
        self.assertIn("defined                   m > −1 (decided)", r.stdout)
        self.assertIn("totally positive          not decided: a denominator is 0 somewhere", r.stdout)
        self.assertIn("defined                   no (decided)", self.check(":functions: s_i(t)\n:for: i = 0..1, 0 \\le t \\le 1", let=let).stdout)

    def test_pieces(self):
        """The functions of one piece; what has another piece at the end says so, and the next sheet knows nothing of it."""
        let = "v_i = i\n:use: bspline D_{i,p}(u) over v_i\nN_i(u) = D_{i-2,2}(u)\nb_i(t) = \\binom{2}{i} t^i (1-t)^{2-i}"
        r = self.check(":functions: N_i(u)\n:for: i = 0..2, 0 \\le u < 1", let=let)
        for words in ("0 ≤ u < 1", "sum is 1                  yes", "totally positive          yes", "N₀ = 1/2, N₁ = 1/2"):
            self.assertIn(words, r.stdout)
        r = self.check(":functions: N_i(u)\n:for: i = 0..2, 0 \\le u \\le 1\n:::\n:::{basis} other\n:functions: b_i(t)\n:for: i = 0..2, 0 \\le t \\le 1", let=let)
        self.assertIn("a definition changes within the interval", r.stdout)
        r = self.check(":functions: N_i(u)\n:for: i = 0..2, 0 \\le u \\le 1", "--json", let=let)
        self.assertEqual(r.returncode, 1)
        self.assertIn("a definition changes", json.loads(r.stdout)["bases"][0]["reason"])
        r = self.check(":functions: N_i(u)\n:for: i = 0..2, 0 \\le u \\le 1\n:::\n:::{basis} other\n:functions: b_i(t)\n:for: i = 0..2, 0 \\le t \\le 1", let=let)
        self.assertIn("the Bernstein basis       yes", r.stdout)

    def test_single_values_that_are_not_decided_are_told(self):
        """For k = 0 the functions are 0 and t, and every minor is at least 0, which the signs of Wronskians do not tell."""
        def page(definitions, find="k"):
            text = f":::{{let}}\nk \\in \\mathbb{{R}}\n{definitions}\n:::\n\n:::{{basis}} b\n:functions: b_i(t)\n:for: i = 0..1, 0 \\le t \\le 1\n" + (f":find: {find}\n" if find else "") + ":::\n"
            r = subprocess.run([CAGD, "check", "--basis", "-"], input=text, capture_output=True, text=True, timeout=120)
            return " ".join(r.stdout.split()), r.stderr
        self.assertIn("totally positive no k (decided; undecided for k = 0)", page("b_0(t) = -k^2\nb_1(t) = t")[0])
        self.assertIn("totally positive not decided: the functions are not independent", page("b_0(t) = 0\nb_1(t) = t", None)[0])
        self.assertIn("defined k < −1 and k > 0 (decided)", page("b_0(t) = \\frac{1}{t+k}\nb_1(t) = 1 - \\frac{1}{t+k}")[0])

    def test_dependent_functions_are_found(self):
        r = self.check(":functions: c_i(t)\n:for: i = 0..2, 0 \\le t \\le 1", "--json", let="c_0(t) = 1\nc_1(t) = t\nc_2(t) = 1 + t")
        p = {p["property"]: p["verdict"] for p in json.loads(r.stdout)["bases"][0]["properties"]}
        self.assertEqual(p["linearly_independent"], "fails")
        self.assertEqual(p["nonnegative"], "holds")

    def test_other_indices_are_numbers(self):
        let = "c_{n,i}(t) = \\binom{n}{i} t^i (1-t)^{n-i}\na_{i,i}(t) = 1\na_{n,i}(t) = t"
        for functions, ranges, line in (("c_{3,i}(t)", "i = 0..3", "the Bernstein basis       yes"), ("c_{n,i}(t)", "n = 3, i = 0..3", "the Bernstein basis       yes"),
                                        ("a_{1,i}(t)", "i = 0..1", "linearly independent      yes"), ("a_{2,i}(t)", "i = 0..1", "linearly independent      no")):
            r = self.check(f":functions: {functions}\n:for: {ranges}, 0 \\le t \\le 1", let=let)
            self.assertIn(line, r.stdout, functions)
        for n in ("2..3", "3..3"):
            r = self.check(f":functions: c_{{n,i}}(t)\n:for: n = {n}, i = 0..2, 0 \\le t \\le 1", let=let)
            self.assertEqual(r.returncode, 2)
            self.assertIn("one index and an argument", r.stderr)

    def test_a_picture(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "b.svg"
            r = self.check(":functions: b_i(t)\n:for: i = 0..2, 0 \\le t \\le 1", "--svg", str(path))
            self.assertEqual(r.returncode, 0)
            self.assertEqual(path.read_text().count("<path") >= 3, True)

    def test_twelve_panels_are_drawn_at_most(self):
        basis = ":::{basis} b%d\n:functions: B_i^1(t)\n:for: i = 0..1, 0 \\le t \\le 1\n:::\n"
        text = ":::{let}\n:use: bernstein B_i^n(t)\n:::\n" + "".join(f":::{{statement}} s{k}\n:printed: B_0^1(t) \\ge {k + 1}\n:for: 0 \\le t \\le 1\n:::\n" for k in range(11))
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "b.svg"
            r = subprocess.run([CAGD, "check", "-", "--svg", str(path)], input=text + "".join(basis % k for k in range(3)), capture_output=True, text=True)
            self.assertEqual((r.returncode, r.stderr), (1, ""))
            self.assertEqual(r.stdout.count("linearly independent      yes"), 3)
            self.assertEqual(path.read_text().count("fails at"), 11)

    def test_without_a_basis_there_is_no_sheet(self):
        text = ":::{statement} s\n:printed: 1 = 1\n:::\n"
        r = subprocess.run([CAGD, "check", "--basis", "-"], input=text, capture_output=True, text=True)
        self.assertEqual(r.returncode, 2)
        self.assertIn(":::{basis}", r.stderr)


if __name__ == "__main__":
    unittest.main()
