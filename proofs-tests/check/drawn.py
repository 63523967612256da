"""Statements that are drawn, and what is true of them by a reader of its own: proofs-tests/unit/drawn_statements.h.

    drawn.py                    the statements of that file, once more: is each what it should be?  Exit status 1 where one is not.
    drawn.py --write CAGD       makes the file; a statement is written where the answer agrees with what was found here

A statement is drawn with its conditions, as TeX and as a function of the values of its names.  True ones are made of laws: one side is the
other in other words.  Of every statement all choices of small numbers for its names are tried (x, y, u, v within
their bounds and conditions): one that is said to hold is false for none; one that fails is false for some in just as many cases of the
whole numbers n, k as the program says.  A derivative that does not exist is undecided.
"""
import fractions
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import sys

FILE = pathlib.Path(__file__).resolve().parents[1] / "unit/drawn_statements.h"
F = fractions.Fraction
VALUES = [F(v) for v in ("-2", "-1", "-1/2", "0", "1/3", "1", "2")]
GRID = [F(-40), *VALUES, F(40)]
REALS = ("x", "y", "u", "v")
RATIOS, TIES, JOINTS, COUNT = 1500, 1900, 2200, 2400  # from there on: quotients; names that are tied by equalities of higher degree; derivatives of what has pieces


class Undefined(Exception):
    """A value that is none."""


def divided(a, b):
    if b == 0:
        raise Undefined
    return a / b


def power(a, n):
    if n < 0 and a == 0:
        raise Undefined
    return a ** n


def choose(a, b):
    """a (a-1) ... (a-b+1) / b!, and 0 for b < 0."""
    return math.prod((a - j for j in range(b)), start=F(1)) / math.factorial(b) if b >= 0 else F(0)


def slope(f, at, order, degree=12):
    """The derivative of a polynomial of a degree below `degree`, from its values: Newton's divided differences about the place."""
    points = [at + k for k in range(degree)]
    values = [f(p) for p in points]
    coefficients = []
    for k in range(degree):
        coefficients.append(values[0])
        values = [(b - a) / (k + 1) for a, b in zip(values, values[1:])]
    # The Taylor coefficients of sum c_k (z)(z-1)...(z-k+1) in z = t - at.
    taylor, basis = [F(0)] * degree, [F(1)]
    for k, c in enumerate(coefficients):
        for j, b in enumerate(basis):
            taylor[j] += c * b
        basis = [(basis[j - 1] if j else 0) - k * (basis[j] if j < len(basis) else 0) for j in range(len(basis) + 1)]
    return taylor[order] * math.factorial(order), taylor


def integral(f, a, b):
    _, taylor = slope(f, a, 0)
    return sum(c * (b - a) ** (j + 1) / (j + 1) for j, c in enumerate(taylor))


# What the names of the definitions mean.
LET = (r"x, y, u, v \in \mathbb{R}", r"w_i \in \mathbb{R}", r"B_i^m(t) = \binom{m}{i} t^i (1-t)^{m-i}", r"p(t) = t^3 - 2 t + 1", r"q(s,t) = s^2 t - 3 s", r"h(t) = \begin{cases} -t & t < 0 \\ t^2 & 0 \le t < 1 \\ 2 t - 1 & \text{otherwise} \end{cases}",
       r"c_0 = 1", r"c_1 = 2", r"c_m = c_{m-1} + 2 c_{m-2} - 1, \quad m \ge 2", r"d_i^r = i^2 - r", r"\mathbf{a}_i = (i, x, 1 - i)", r"\mathbf{b}(t) = (t, 2, t^2)",
       r"e(t;y) = t y - t^2", r"g_i(t) = t + i, \quad i < 2", r"g_i(t) = i t^2")


def recursive(m):
    a, b = F(1), F(2)
    for _ in range(m):
        a, b = b, b + 2 * a - 1
    return a


def piecewise(t):
    return -t if t < 0 else t * t if t < 1 else 2 * t - 1


class Drawing:
    """Formulas: (TeX, function of the values, degree as a polynomial in t or None)."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.whole = []      # the whole numbers in sight: ranges, sums
        self.letter = 0

    def pick(self, *what):
        return self.random.choice(what)

    def atom(self):
        kind = self.random.randrange(10)
        if kind < 5:
            name = self.pick(*REALS[:3])
            return name, lambda v: v[name]
        if kind < 7 and self.whole:
            name = self.pick(*self.whole)
            return name, lambda v: v[name]
        if kind == 7:
            i, shift = (self.pick(*self.whole), self.pick(0, 1, -1)) if self.whole else ("0", self.pick(0, 1))
            index = i if shift == 0 else f"{i}{shift:+d}" if self.whole else str(shift)
            return f"w_{{{index}}}", lambda v: v["w"](int(v[i] if i in v else 0) + shift)
        n = self.pick(0, 1, 2, 3, F(1, 2), F(2, 3))
        return (str(n) if n.denominator == 1 else f"\\frac{{{n.numerator}}}{{{n.denominator}}}") if isinstance(n, F) else str(n), lambda v: F(n)

    def small(self):
        """A whole number of a name: what binomial coefficients, exponents and indices are made of."""
        if self.whole and self.random.random() < .8:
            name, shift = self.pick(*self.whole), self.pick(0, 0, 1, 2)
            return (f"{name}+{shift}" if shift else name), lambda v: int(v[name]) + shift
        n = self.pick(0, 1, 2, 3)
        return str(n), lambda v: n

    def number(self, depth):
        if depth <= 0:
            return self.atom()
        return getattr(self, self.pick(*(name for name in dir(self) if name.startswith("of_"))))(depth - 1)

    def of_sum(self, d):
        (a, f), (b, g) = self.number(d), self.number(d)
        return f"({a} + {b})", lambda v: f(v) + g(v)

    def of_difference(self, d):
        (a, f), (b, g) = self.number(d), self.number(d)
        return f"({a} - {b})", lambda v: f(v) - g(v)

    def of_product(self, d):
        (a, f), (b, g) = self.number(d), self.atom()
        return self.pick(f"({a}) \\cdot {b}", f"({b}) ({a})"), lambda v: f(v) * g(v)

    def of_negative(self, d):
        a, f = self.number(d)
        return f"(-{a})" if a[0] != "-" else f"(-({a}))", lambda v: -f(v)

    def of_square(self, d):
        (a, f), n = self.atom(), self.pick(0, 1, 2, 3)
        return f"({a})^{{{n}}}", lambda v: f(v) ** n

    def of_power(self, d):
        (a, f), (n, g) = self.atom(), self.small()
        return f"({a})^{{{n}}}", lambda v: power(f(v), g(v))

    def of_quotient(self, d):
        (a, f), n, (b, g) = self.number(d), self.pick(1, 2, 5), self.atom()
        return f"\\frac{{{a}}}{{{n} + ({b})^2}}", lambda v: f(v) / (n + g(v) ** 2)

    def of_amount(self, d):
        (a, f), (b, g) = self.number(d), self.atom()
        return f"|{a} - {b}|", lambda v: abs(f(v) - g(v))

    def of_greatest(self, d):
        (a, f), (b, g), least = self.atom(), self.atom(), self.random.random() < .5
        return f"\\{'min' if least else 'max'}({a}, {b})", lambda v: min(f(v), g(v)) if least else max(f(v), g(v))

    def of_cases(self, d):
        (a, f), (b, g), (truth, h) = self.number(d), self.number(d), self.comparison(0)
        return f"\\begin{{cases}} {a} & {truth} \\\\ {b} & \\text{{otherwise}} \\end{{cases}}", lambda v: f(v) if h(v) else g(v)

    def of_sum_over(self, d):
        return self.over("\\sum", sum, F(0), d)

    def of_product_over(self, d):
        return self.over("\\prod", math.prod, F(1), 0)

    def over(self, sign, fold, nothing, d):
        """A sum or product over a letter: from .. to, or a chain, or with a condition; its ends may be names, or leave nothing."""
        letter = "ijlm"[self.letter % 4]
        self.letter += 1
        (high, top), low = self.small(), self.pick(0, 0, 1, 2)
        self.whole.append(letter)
        term, f = self.number(d)
        self.whole.pop()
        self.letter -= 1
        form = self.random.randrange(6)
        where, keep = {0: (f"_{{{letter}={low}}}^{{{high}}}", lambda i, n: low <= i <= n), 1: (f"_{{{low} \\le {letter} \\le {high}}}", lambda i, n: low <= i <= n),
                       2: (f"_{{{low} < {letter} < {high}}}", lambda i, n: low < i < n), 3: (f"_{{{low} \\le {letter} < {high}}}", lambda i, n: low <= i < n),
                       4: (f"_{{{letter}={low}, {letter} \\ne 1}}^{{{high}}}", lambda i, n: low <= i <= n and i != 1), 5: (f"_{{{letter}={low}}}^{{{high}-1}}", lambda i, n: low <= i < n)}[form]

        def value(v):
            kept = [f({**v, letter: F(i)}) for i in range(8) if keep(i, top(v))]
            return fold(kept, start=nothing)
        return f"({sign}{where} ({term}))", value

    def of_binomial(self, d):
        (a, f), (b, g) = self.small(), self.small()
        if self.random.random() < .3:
            a, f = self.atom()
        return f"\\binom{{{a}}}{{{b}}}", lambda v: choose(F(f(v)), g(v))

    def of_factorial(self, d):
        a, f = self.small()
        return f"({a})!", lambda v: F(math.factorial(f(v)))

    def of_floor(self, d):
        (a, f), n, up = self.small(), self.pick(2, 3), self.random.random() < .5
        return (f"\\lceil \\frac{{{a}}}{{{n}}} \\rceil" if up else f"\\lfloor \\frac{{{a}}}{{{n}}} \\rfloor"), lambda v: F(math.ceil(F(f(v), n)) if up else math.floor(F(f(v), n)))

    def of_definition(self, d):
        kind = self.random.randrange(8)
        a, f = self.atom()
        i, g = self.small()
        if kind == 0:
            k, m = self.pick(0, 1, 2), 3
            return f"B_{{{k}}}^{{{m}}}({a})", lambda v: choose(F(m), k) * f(v) ** k * (1 - f(v)) ** (m - k)
        if kind == 1:
            return f"p({a})", lambda v: f(v) ** 3 - 2 * f(v) + 1
        if kind == 2:
            b, h = self.atom()
            return f"q({a}, {b})", lambda v: f(v) ** 2 * h(v) - 3 * f(v)
        if kind == 3:
            return f"h({a})", lambda v: piecewise(f(v))
        if kind == 4:
            return f"c_{{{i}}}", lambda v: recursive(g(v))
        if kind == 5:
            r = self.pick(0, 1, 2)
            return f"d_{{{i}}}^{{{r}}}", lambda v: F(g(v) ** 2 - r)
        if kind == 6:
            return f"e({a})", lambda v: f(v) * v["y"] - f(v) ** 2
        return f"g_{{{i}}}({a})", lambda v: f(v) + g(v) if g(v) < 2 else g(v) * f(v) ** 2

    def of_derivative(self, d):
        """Of polynomials, at a place: a quotient of differentials, primes, an order above, under the integral."""
        a, f = self.atom()
        kind, order = self.random.randrange(6), self.pick(1, 2)
        if kind == 0:
            return f"p{chr(39) * order}({a})", lambda v: slope(lambda t: t ** 3 - 2 * t + 1, f(v), order)[0]
        if kind == 1:
            return f"p^{{({order})}}({a})", lambda v: slope(lambda t: t ** 3 - 2 * t + 1, f(v), order)[0]
        if kind == 2:
            b, g = self.atom()
            return f"\\left. \\frac{{d}}{{dt}} (({b}) t^3 - t) \\right|_{{t={a}}}", lambda v: slope(lambda t: t ** 3 * g(v) - t, f(v), 1)[0]
        if kind == 3:
            return f"\\left. \\frac{{\\partial^{order}}}{{\\partial s^{order}}} q(s, 2) \\right|_{{s={a}}}", \
                lambda v: slope(lambda s: s ** 2 * 2 - 3 * s, f(v), order)[0]
        if kind == 4:
            b, g = self.atom()
            return f"\\int_0^{{{a}}} (t^2 + ({b}) t) dt", lambda v: integral(lambda t: t ** 2 + g(v) * t, F(0), f(v))
        return f"\\left. (t^2 - 3 t) \\right|_{{t={a}}}", lambda v: f(v) ** 2 - 3 * f(v)

    def of_vector(self, d):
        (a, f), k, j = self.atom(), self.pick(0, 1, 2), self.pick(0, 1, 2)
        A = lambda v, i: (F(i), v["x"], F(1 - i))
        B = lambda v: (f(v), F(2), f(v) ** 2)
        dot = lambda p, q: sum(s * t for s, t in zip(p, q))
        cross = lambda p, q: (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])
        kind = self.random.randrange(5)
        if kind == 0:
            return f"\\mathbf{{a}}_{k} \\cdot \\mathbf{{b}}({a})", lambda v: dot(A(v, k), B(v))
        if kind == 1:
            return f"\\|\\mathbf{{a}}_{k} - \\mathbf{{b}}({a})\\|^2", lambda v: sum((s - t) ** 2 for s, t in zip(A(v, k), B(v)))
        if kind == 2:
            return f"(\\mathbf{{a}}_{k} \\times \\mathbf{{b}}({a})) \\cdot \\mathbf{{a}}_{j}", lambda v: dot(cross(A(v, k), B(v)), A(v, j))
        if kind == 3:
            return f"\\begin{{vmatrix}} {a} & 2 \\\\ x & {k} \\end{{vmatrix}}", lambda v: f(v) * k - 2 * v["x"]
        return f"\\mathbf{{b}}'({a}) \\cdot (1, x, {j})", lambda v: 1 + 2 * f(v) * j

    # ---- truths --------------------------------------------------------------------------------------------

    RELATIONS = {"=": lambda a, b: a == b, "\\ne": lambda a, b: a != b, "<": lambda a, b: a < b, "\\le": lambda a, b: a <= b, ">": lambda a, b: a > b, "\\ge": lambda a, b: a >= b}

    def comparison(self, depth):
        (a, f), (b, g), relation = self.number(depth), self.atom(), self.pick("=", "\\ne", "<", "\\le", ">", "\\ge")
        return f"{a} {relation} {b}", lambda v: self.RELATIONS[relation](f(v), g(v))

    def truth(self):
        """Two comparisons, joined in some way, beside the same truth in other words or not."""
        (a, f), (b, g) = self.comparison(self.pick(0, 1)), self.comparison(0)
        kind = self.random.randrange(10)
        both, one_of, if_then = (lambda v: f(v) and g(v)), (lambda v: f(v) or g(v)), (lambda v: not f(v) or g(v))
        if kind == 0:
            return f"{a} \\Rightarrow {b}", if_then
        if kind == 1:
            return f"{a} \\lor {b}", one_of
        if kind == 2:
            return f"{a}, {b}", both
        if kind == 3:
            return f"{a} \\iff {b}", lambda v: f(v) == g(v)
        if kind == 4:
            return f"\\neg ({a} \\lor {b})", lambda v: not one_of(v)
        if kind == 5:
            return f"{a}, {b} \\Rightarrow {a} \\lor {b}", lambda v: True
        if kind == 6:
            return f"\\neg ({a}) \\iff ({a} \\Rightarrow ({b}) \\land \\neg ({b}))", lambda v: True
        if kind == 7:
            return f"({a} \\iff {a}) \\land ({a} \\iff {b})", lambda v: f(v) == g(v)
        if kind == 8:
            return f"({a} \\Rightarrow {a}) \\land ({b} \\Rightarrow {a})", lambda v: not g(v) or f(v)
        return f"({a} \\lor {b}) \\iff \\neg (\\neg ({a}) \\land \\neg ({b}))", lambda v: True

    def quantified(self):
        letter, (high, top), every = "i", self.small(), self.random.random() < .5
        self.whole.append(letter)
        a, f = self.comparison(0)
        self.whole.pop()
        fold = all if every else any
        return f"\\{'forall' if every else 'exists'} i = 0..{high}: {a}", lambda v: fold(f({**v, letter: F(i)}) for i in range(top(v) + 1))

    def law(self):
        """Two sides that are equal, or in that order."""
        (a, f), (b, g), (c, h) = self.number(2), self.number(1), self.atom()
        kind = self.random.randrange(12)
        n, top = self.small()
        true = lambda v: (f(v), g(v), h(v)) and True
        return [(f"({a}) ({b}) = ({b}) ({a})", true), (f"({a} + {c})^2 = ({a})^2 + 2 ({c}) ({a}) + ({c})^2", true), (f"{a} - ({b}) = -({b} - ({a}))", true),
                (f"|{a}| = \\max({a}, -({a}))", true), (f"|{c} - ({a})|^2 = ({a} - {c})^2", true), (f"\\max({c}, u) + \\min({c}, u) + {a} = {c} + u + {a}", true),
                (f"\\sum_{{m=0}}^{{{n}}} ({c}) m = ({c}) \\frac{{({n})({n}+1)}}{{2}}", lambda v: h(v) is not None), (f"\\sum_{{m=0}}^{{{n}}} \\binom{{{n}}}{{m}} ({c})^m = (1 + {c})^{{{n}}}", lambda v: h(v) is not None),
                (f"({c})^2 + u^2 \\ge 2 ({c}) u", lambda v: h(v) is not None), (f"({c} - u)^2 + {self.pick('1', 'v^2 + 2')} > 0", lambda v: h(v) is not None),
                (f"{a} \\le {a} + y^2", true), (f"2 ({a}) - ({a}) = {a} < {a} + 1 + ({c})^2 \\ne {a}", true)][kind]

    def two_terms(self):
        (a, f), (b, g) = self.number(3), self.number(2)
        return f"{a} - {b}" if b[0] != "-" else f"{a} - ({b})", lambda v: f(v) - g(v)

    def value(self, case):
        """(The numbers of the names, a formula with its value there): right, or compared with a number beside it."""
        (a, f), v = self.two_terms(), {name: self.pick(*VALUES) for name in REALS} | case
        given = ", ".join(f"{name} = {number(v[name])}" for name in REALS)
        relation, by = self.pick("=", "=", "=", "<", "\\le", ">", "\\ge", "\\ne"), self.pick(0, 0, 0, 1, -1)
        return given, f"{a} {relation} {number(f(v) + by)}", self.RELATIONS[relation](0, by)

    def polynomial(self, case):
        """The same as a function of x, which is a polynomial: its coefficients from its values."""
        (a, f), v = self.two_terms(), {name: self.pick(*VALUES) for name in REALS} | case
        given = ", ".join(f"{name} = {number(v[name])}" for name in REALS[1:])
        at = lambda x: f({**v, "x": x})
        coefficients = slope(at, F(0), 0)[1]
        if not any(coefficients[1:]) or any(at(F(p, 7)) != sum(c * F(p, 7) ** j for j, c in enumerate(coefficients)) for p in (-9, -4, 3, 5, 11)):
            return None
        by = self.pick(0, 0, 1)
        right = " ".join(f"+ {number(c)} x^{j}" for j, c in enumerate(coefficients) if c != 0 or j == 0).replace("+ -", "- ").lstrip("+ ")
        return given, f"{a} = {right}" + " + x" * by, by == 0

    def statement(self):
        kind = self.random.randrange(9)
        if kind < 2:
            return self.law()
        if kind in (2, 3):
            return self.truth()
        if kind == 4:
            (a, f), (b, g), relation = self.number(2), self.number(1), self.pick("=", "<", "\\le", ">", "\\ge", "\\ne")
            return f"{a} {relation} {b}", lambda v: self.RELATIONS[relation](f(v), g(v))
        if kind == 5:
            (a, f), (b, g), (c, h) = self.number(1), self.atom(), self.number(1)
            r, s = self.pick("=", "<", "\\le"), self.pick("=", "<", "\\le")
            return f"{a} {r} {b} {s} {c}", lambda v: self.RELATIONS[r](f(v), g(v)) and self.RELATIONS[s](g(v), h(v))
        return self.quantified() if kind == 6 else self.truth()

    def ratio(self):
        """What is divided by a difference of names, or a product of two, on either side; of where it is defined."""
        def linear():
            name, other, by = self.pick("x", "y", "u"), self.pick("x", "y", "u", "1", "0"), self.pick(1, 1, 2, -1)
            return f"({'-' if by < 0 else ''}{'2' if by == 2 else ''}{name} - {other})", lambda v: by * v[name] - (v[other] if other in v else F(int(other)))
        (a, f), (b, g), (c, h), (e, i) = linear(), linear(), linear(), self.atom()
        power, two, relation = self.pick(1, 1, 2, 3), self.random.random() < .3, self.pick("=", "\\ne", "<", "\\le", ">", "\\ge", "<", ">")
        value = lambda v: divided(f(v), g(v) ** power * (h(v) if two else 1))
        tex = f"\\frac{{{a}}}{{{b}^{power}{' ' + c if two else ''}}}"
        if self.random.random() < .5:
            tex, value = tex.replace(a, "1", 1), lambda v: divided(F(1), g(v) ** power * (h(v) if two else 1))
        if self.random.random() < .5:
            e, i = "0", lambda v: F(0)
        if self.random.random() < .5:
            return f"{tex} {relation} {e}", lambda v: self.RELATIONS[relation](value(v), i(v))
        return f"{e} {relation} {tex}", lambda v: self.RELATIONS[relation](i(v), value(v))

    def conditions(self):
        """(TeX, whether the values meet it)"""
        one = self.random.randrange(12)
        return [("", lambda v: True), ("", lambda v: True), ("0 \\le x \\le 1", lambda v: 0 <= v["x"] <= 1), ("x > 0, y \\ge 0", lambda v: v["x"] > 0 and v["y"] >= 0), ("x \\le y", lambda v: v["x"] <= v["y"]),
                ("x < y, y \\le u", lambda v: v["x"] < v["y"] <= v["u"]), ("x + y = 1", lambda v: v["x"] + v["y"] == 1), ("x \\ne y", lambda v: v["x"] != v["y"]), ("0 < x < y, y \\le 2", lambda v: 0 < v["x"] < v["y"] <= 2),
                ("-1 \\le u < 1, x \\ge u", lambda v: -1 <= v["u"] < 1 and v["x"] >= v["u"]), ("y = 2 x - 1", lambda v: v["y"] == 2 * v["x"] - 1), ("x = 1/3", lambda v: v["x"] == F(1, 3))][one]

    def tie(self):
        """(TeX, values of x, y, u that meet it, many)"""
        steps = [F(k, 8) for k in range(-40, 41)] + [F(-40), F(40)]
        circle = [((1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)) for t in steps] + [(F(-1), F(0))]
        plane = [(F(a, 4), F(b, 4)) for a in range(-12, 13) for b in range(-12, 13)] + [(F(40), F(1, 40)), (F(-40), F(40)), (F(1, 40), F(40))]
        kind = self.random.randrange(12)
        return [("x^2 + y^2 = 1", circle), ("x^2 + y^2 = 1, y \\ge 0", [p for p in circle if p[1] >= 0]), ("x^2 + y^2 = 1, x > 0", [p for p in circle if p[0] > 0]), ("x^2 + y^2 = 1, x \\le 0, y < 0", [p for p in circle if p[0] <= 0 and p[1] < 0]),
                ("\\frac{x^2}{4} + y^2 = 1", [(2 * a, b) for a, b in circle]), ("x^2 = y", [(t, t * t) for t in steps]), ("y^2 = x, y \\ge 0", [(t * t, t) for t in steps if t >= 0]), ("x^2 + y = 1, y \\ge 0", [(t, 1 - t * t) for t in steps if t * t <= 1]),
                ("x y = 1, x > 0", [(t, 1 / t) for t in steps if t > 0]), ("x^2 + y^2 \\le 1", [p for p in plane if p[0] ** 2 + p[1] ** 2 <= 1] + circle), ("x y \\ge 1", [p for p in plane if p[0] * p[1] >= 1]),
                ("x^2 = 4", [(a, b) for a in (F(2), F(-2)) for b in steps])][kind]

    def tied(self):
        """What is said of names that are tied; (condition, TeX, truth, values)"""
        condition, points = self.tie()
        (a, b, c), relation = (self.pick(-2, -1, 1, 2, 3) for _ in range(3)), self.pick("=", "\\ne", "<", "\\le", ">", "\\ge", "\\le", "\\ge")
        right = self.pick(F(-3), F(-2), F(-1), F(0), F(1, 2), F(1), F(5, 4), F(2), F(3))
        left, f = [(f"{a} x + {b} y", lambda x, y: a * x + b * y), (f"{a} x y", lambda x, y: a * x * y), (f"{a} x^2 + {b} y", lambda x, y: a * x * x + b * y), (f"{a} x^2 + {b} y^2", lambda x, y: a * x * x + b * y * y),
                   (f"|x| + {abs(b)} |y|", lambda x, y: abs(x) + abs(b) * abs(y)), (f"x^3 - {abs(b)} x", lambda x, y: x ** 3 - abs(b) * x), (f"{a} x + {c}", lambda x, y: a * x + c), (f"\\max(x, {b} y)", lambda x, y: max(x, b * y)),
                   (f"(x - y)^2", lambda x, y: (x - y) ** 2), (f"x^4 + {abs(a)} x^2 y^2 + y^4", lambda x, y: x ** 4 + abs(a) * x * x * y * y + y ** 4)][self.random.randrange(10)]
        tex = f"{left} {relation} {number(right)}".replace("+ -", "- ")
        if self.random.random() < .3:
            return "", f"{condition} \\Rightarrow {tex}", lambda v: self.RELATIONS[relation](f(v["x"], v["y"]), right), points
        return condition, tex, lambda v: self.RELATIONS[relation](f(v["x"], v["y"]), right), points

    def joint(self):
        """A derivative of what has pieces, at the place where two of them meet: p for t < a, and p + c (t-a)^m behind it, which have the same derivatives below
        order m.  (TeX, whether it is true; None where there is no derivative)"""
        a = self.pick("0", "1", "x", "2x", "-\\frac{1}{2}", "x + y")
        degree, m, c, order = self.pick(1, 2, 3), self.pick(0, 1, 2, 3), self.pick(0, 1, -2, 1), self.pick(1, 1, 2, 3)
        p = [self.pick(-1, 0, 1, 2) for _ in range(degree + 1)]
        tex = " + ".join(f"{q} t^{j}" for j, q in enumerate(p)).replace("+ -", "- ")
        behind = f"{tex} + {c} (t - ({a}))^{m}".replace("+ -", "- ")
        weak, apart, away = self.random.random() < .5, self.random.random() < .15, self.pick(0, 0, 0, 1, -1)
        less = "\\le" if weak else "<"
        pieces = f"{tex} & t {less} {a} \\\\ {behind} & \\text{{otherwise}}"
        value = 0
        if apart:  # at the joint itself another value, or the same by a piece of its own
            value = self.pick(0, 1)
            other = f"{tex} + {value}"
            pieces = f"{tex} & t < {a} \\\\ {behind} & t > {a} \\\\ {other} & \\text{{otherwise}}"
        at = f"{a} + {away}" if away > 0 else f"{a} - {-away}" if away < 0 else a
        exists = away != 0 or ((c == 0 or order < m) and not (apart and value))
        wrong = self.random.random() < .4
        # as a polynomial in the place: the derivative of p there, and that of c (t - a)^m, at distance `away`
        slope_p = [(math.factorial(j) // math.factorial(j - order), q, j - order) for j, q in enumerate(p) if j >= order]
        extra = c * math.perm(m, order) * away ** (m - order) if away > 0 and m >= order else 0
        right = " + ".join([f"{f * q} ({at})^{e}" for f, q, e in slope_p] + [str(extra + wrong)]).replace("+ -", "- ")
        return f"\\left. \\frac{{d^{order}}}{{dt^{order}}} \\begin{{cases}} {pieces} \\end{{cases}} \\right|_{{t={at}}} = {right}", (not wrong) if exists else None

    def ranges(self):
        """(TeX, the names, their values one after another)"""
        kind = self.random.randrange(6)
        return [("n = 1", ("n",), [(1,)]), ("n = 1..3", ("n",), [(1,), (2,), (3,)]), ("n = 0..2", ("n",), [(0,), (1,), (2,)]),
                ("n = 1..3, k = 0..n", ("n", "k"), [(n, k) for n in range(1, 4) for k in range(n + 1)]), ("n = 2..4, k = 1..n-1", ("n", "k"), [(n, k) for n in range(2, 5) for k in range(1, n)]),
                ("n = 1..2, k = n..3", ("n", "k"), [(n, k) for n in range(1, 3) for k in range(n, 4)])][kind]


def number(q):
    return str(q) if q.denominator == 1 else f"{'-' if q < 0 else ''}\\frac{{{abs(q.numerator)}}}{{{q.denominator}}}"


def computed(d, k):
    """A formula whose value is known, for one choice of the whole numbers."""
    ranges, names, cases = d.ranges()
    case = d.pick(*cases)
    d.whole = list(names)
    try:
        found = (d.value if k % 8 < 3 else d.polynomial)(dict(zip(names, map(F, case))))
    except (Undefined, KeyError):
        return None
    if found is None:
        return None
    given, tex, holds = found
    return ", ".join([*(f"{name} = {n}..{n}" for name, n in zip(names, case)), given]), tex, int(not holds), 1


def drawn(k):
    """The k-th statement: (ranges with conditions, TeX, the cases that are false for some small numbers, of how many, whether it is true there at all);
    None where it has a value that is none everywhere, or its reader here has none."""
    d = Drawing(f"2026-{k}")
    if k >= JOINTS:
        tex, holds = d.joint()
        return "n = 1", tex, -1 if holds is None else int(not holds), 1
    if k >= TIES:
        condition, tex, truth, points = d.tied()
        false = any(not truth({"x": x, "y": y}) for x, y in points)
        return condition or "n = 1", tex, int(false), 1
    if k < RATIOS and k % 8 < 5:
        return computed(d, k)
    ranges, names, cases = d.ranges()
    d.whole = list(names)
    condition, meets = d.conditions()
    tex, truth = d.statement() if k < RATIOS else d.ratio()
    used = [name for name in REALS if re.search(rf"(?<![\\a-z]){name}(?![a-z])", tex + " " + condition + (" x" if "mathbf" in tex else "") + (" y" if "e(" in tex else ""))]
    heads = [name for name in names if re.search(rf"(?<![\\a-z]){name}(?![a-z])", tex + " " + condition)]
    if "k" in heads:  # and the name with which its range begins or ends
        heads = list(names)
    cases = sorted({tuple(n for name, n in zip(names, case) if name in heads) for case in cases})
    names, shift, failing, seen = heads, F(1, 3), 0, 0
    for case in cases:
        false = 0
        for values in itertools.product(GRID if len(used) < 4 else VALUES, repeat=len(used)):
            v = {name: F(0) for name in (*REALS, "n", "k")} | dict(zip(used, values)) | {name: F(n) for name, n in zip(names, case)}
            for w in (lambda i: F(i), lambda i: shift - 2 * i * i, lambda i: F(0)) if "w_" in tex else (lambda i: F(0),):
                v["w"] = w
                if not meets(v):
                    continue
                try:
                    false |= not truth(v)
                    seen += 1
                except Undefined:
                    pass
            if false:
                break
        failing += false
    return (ranges + (", " + condition if condition else ""), tex, failing, len(cases)) if seen else None


def written():
    """What the file has: {number: (ranges, TeX, answer, cases, failing)}"""
    row = re.compile(r'^    \{(\d+), "(.*)", "(.*)", CAGD_(\w+), (\d+), (\d+)\},$')
    found = {}
    for line in FILE.read_text().splitlines():
        m = row.match(line)
        if m:
            k, ranges, tex, answer, cases, failing = m.groups()
            found[int(k)] = (ranges.replace("\\\\", "\\"), tex.replace("\\\\", "\\"), answer, int(cases), int(failing))
    return found


def agrees(mine, answer, cases, failing):
    ranges, tex, false, all_cases = mine
    return cases == all_cases and {"HOLDS": false == 0 == failing, "FAILS": false == failing > 0, "UNDECIDED": True}[answer] and (false >= 0 or answer == "UNDECIDED")


def write(cagd, first=0):
    rows, counts = [], {"HOLDS": 0, "FAILS": 0, "UNDECIDED": 0}
    let = ":::{let}\n" + "".join(line + "\n" for line in LET) + ":::\n"
    for k in range(first, COUNT):
        mine = drawn(k)
        if mine is None:
            continue
        r = subprocess.run([cagd, "check", "--json", "-"], input=f"{let}:::{{statement}} s\n:printed: {mine[1]}\n:for: {mine[0]}\n:seconds: 20\n:::\n", capture_output=True, text=True)
        if r.returncode > 1:
            print(k, mine[1], r.stderr, file=sys.stderr)
            continue
        s = json.loads(r.stdout)["statements"][0]
        answer = s["verdict"].upper()
        if not agrees(mine, answer, s["cases"], s["failing"]):
            print("not agreed:", k, mine, answer, s["cases"], s["failing"], file=sys.stderr)
            continue
        counts[answer] += 1
        quoted = [text.replace("\\", "\\\\") for text in mine[:2]]
        rows.append(f'    {{{k}, "{quoted[0]}", "{quoted[1]}", CAGD_{answer}, {s["cases"]}, {s["failing"]}}},')
    lines = [f'    "{line}",'.replace("\\", "\\\\") for line in LET]
    FILE.write_text("/* drawn_statements.h -- made by proofs-tests/check/drawn.py, which says what the rows are and tries each by a reader of its own. */\n"
                    "/* clang-format off */\nstatic const char *const drawn_definitions[] = {\n" + "\n".join(lines) + "\n};\n"
                    "static const struct {\n    int number;\n    const char *ranges, *statement;\n    cagd_answer answer;\n    long cases, failing;\n} drawn_statements[] = {\n"
                    + "\n".join(rows) + "\n};\n")
    print(counts)


def main():
    if sys.argv[1:2] == ["--write"]:
        write(sys.argv[2])
        return 0
    rows, wrong = written(), 0
    for k, (ranges, tex, *answer) in rows.items():
        mine = drawn(k)
        if mine[:2] != (ranges, tex) or not agrees(mine, *answer):
            print(k, ranges, tex, answer, mine)
            wrong += 1
    print(f"{len(rows)} statements, {wrong} not as they should be")
    return 1 if wrong or len(rows) < 500 else 0


if __name__ == "__main__":
    sys.exit(main())
