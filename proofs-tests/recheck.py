#!/usr/bin/env python3
"""Rechecks the certificates that `cagd verify --certificates DIR` writes.

    recheck.py DIR [MANIFEST]

Python's standard library, and nothing of the project that wrote them.  For each statement one line:

    rechecked                 all that its claims compared or decided came out the same once more, and its verdict follows from theirs
    wrong                     something came out differently, or does not follow, or is malformed
    cannot recheck this kind  some claim noted nothing, or nothing that can be computed again here

The manifest, DIR/manifest.json if no other is named, says what is certified: the printed text of every statement with its claims and
their roles, of every claim the number types, cases, inputs, comparisons and facts that its certificate must have, and the SHA-256 of every
certificate.  One that it does not list, or that is another, is wrong; so is one that is missing.  Whoever does not trust the folder names a manifest of their own run.

A certificate holds straight-line programs: nodes, each made of earlier ones by one operation, from inputs; and steps, which
are comparisons of nodes and decisions about them.  All steps are computed again at the recorded inputs, in fractions.

An equality that is claimed to be an identity is also computed at random inputs modulo the prime p = 2^127 - 1.  The degree argument: by
the rules for sums, products and quotients, the difference of two nodes has a numerator of degree at most D in the inputs.  Unless it
is 0, or p divides all its coefficients, it vanishes at a random point with probability at most D/p.  Points are taken until (D/p)^k <
2^-100.  A sign that was read off coefficients: the printed fraction has coefficients of one sign, and is the node, again as an identity.

Roots are counted by Sturm's theorem on the factors of Yun's decomposition, minors one by one, hulls by the printed combination
or separating plane.  A condition whose formula is made of facts and whole numbers alone is evaluated again (recheck_formula.py); where
it has variables of the program in it, its facts are rechecked, and how they combine is in the text of the claim.

Exit status: 0 all is rechecked, 1 something is wrong, 2 bad usage, 3 nothing is wrong and something could not be rechecked."""
import functools, hashlib, json, math, pathlib, re, sys
from fractions import Fraction
from itertools import combinations, count
import recheck_format, recheck_formula, recheck_range, recheck_sign, recheck_sums
from recheck_polynomial import (PRIME, Cannot, Modular, Rationals, Wrong, bernstein_coefficient, count_roots, p_add, p_bernstein, p_compose, p_derivative,
                                p_divmod, p_gcd, p_mul, p_value, require, sturm_inside, trim, whole)

MOST_MINORS = 200000
EVIDENCE = ["none", "measured", "enclosed", "sampled", "argued", "decided", "proved"]

# ---- programs -------------------------------------------------------------------------------------------
ARITHMETIC = {"+", "-", "*", "/"}
# How many of its arguments, the first ones, an operation takes as nodes; the operations that are not here take all.
NODES = {"x": 0, "c": 0, "o": 0, "f": 0, "opoly": 0, "root": 1, "coefficient": 1, "tobernstein": 3}
class Program:
    """The nodes of a case.  The same operation on the same arguments is the same value, and is computed once."""
    def __init__(self, case):
        self.case, self.names = case, {x[0]: i for i, x in enumerate(case["inputs"])}
        numbers, place = {}, {} # of the different operations, and for each node the number of its operation
        for k, node in enumerate(case["nodes"]): # an argument that is not yet there is a KeyError, and so malformed
            if node[0] in ARITHMETIC:
                op, i, j = node
                operation = op, place[i], place[j]
            else:
                op, *a = node
                n = NODES.get(op, len(a))
                operation = op, *[place[i] for i in a[:n]], *a[n:]
            place[k] = numbers.setdefault(operation, len(numbers))
        self.operations, self.place = list(numbers), list(place.values())
    def run(self, K, inputs):
        """The values of all nodes."""
        v, R = [], K.reduce
        make = {
            "x": lambda i: inputs[i], "c": K.number, "o": K.number,
            "f": lambda text: fraction_value(K, text, lambda x: inputs[self.names[x]]),
            "neg": lambda i: R(-v[i]), "root": lambda i, n: K.root(v[i], n),
            "opoly": lambda *c: trim([K.number(t) for t in c]),
            "poly": lambda *nodes: trim([v[i] for i in nodes]),
            "bernstein": lambda *nodes: p_bernstein(K, [v[i] for i in nodes]),
            "p+": lambda i, j: p_add(K, v[i], v[j]), "p-": lambda i, j: p_add(K, v[i], v[j], -1),
            "p*": lambda i, j: p_mul(K, v[i], v[j]), "pgcd": lambda i, j: p_gcd(K, v[i], v[j]),
            "pquo": lambda i, j: p_divmod(K, v[i], v[j])[0], "prem": lambda i, j: p_divmod(K, v[i], v[j])[1],
            "pcompose": lambda i, j: p_compose(K, v[i], v[j]),
            "pneg": lambda i: [R(-c) for c in v[i]], "pder": lambda i: p_derivative(K, v[i]),
            "value": lambda i, j: p_value(K, v[i], v[j]),
            "coefficient": lambda i, k: v[i][k] if k < len(v[i]) else K.number(0),
            "tobernstein": lambda i, a, b, n, k: bernstein_coefficient(K, v[i], v[a], v[b], n, k),
        }
        for op, *a in self.operations:
            if op in ARITHMETIC:
                x, y = v[a[0]], v[a[1]]
                v.append(R(x * y) if op == "*" else R(x + y) if op == "+" else R(x - y) if op == "-" else K.quotient(x, y))
            else:
                require(not any(isinstance(i, int) and i < 0 for i in a), "a negative argument")
                v.append(make[op](*a))
        return {k: v[i] for k, i in enumerate(self.place)} # by node: a negative number is none
    def degrees(self):
        """For each node (numerator, denominator) degrees in the inputs, or None where it is not known to be rational in them."""
        d = []
        for op, *a in self.operations:
            if op in ("x", "c"):
                d.append((int(op == "x"), 0))
            elif op == "f":
                d.append(fraction_degrees(a[0]))
            elif op == "neg":
                d.append(d[a[0]])
            elif op not in ARITHMETIC or d[a[0]] is None or d[a[1]] is None:
                d.append(None)
            else:
                (n, m), (k, l) = d[a[0]], d[a[1]]
                d.append((n + k, m + l) if op == "*" else (n + l, m + k) if op == "/" else (max(n + l, k + m), m + l))
        return {k: d[i] for k, i in enumerate(self.place)}
    def random_points(self):
        """Inputs modulo p without end, from the text of the case alone."""
        text = json.dumps([self.case["inputs"], self.operations, self.case["steps"]], sort_keys=True)
        seed = hashlib.sha256(text.encode()).digest()
        for k in count():
            yield k, [int.from_bytes(hashlib.sha256(seed + b"%d %d" % (k, i)).digest() * 2, "big") % PRIME
                      for i in range(len(self.case["inputs"]))]
    def random_runs(self, bound):
        """Enough runs at random inputs for differences of degree at most `bound`."""
        if bound.bit_length() > 120:
            raise Cannot("the degrees are too high")
        needed = math.ceil(100 / (127 - bound.bit_length()))
        for k, inputs in self.random_points():
            if k >= needed + 8:
                break
            try:
                yield inputs, self.run(Modular, inputs)
            except ZeroDivisionError:
                continue
            needed -= 1
            if needed == 0:
                return
        raise Cannot("the program divides by zero at random inputs")

# ---- decisions ------------------------------------------------------------------------------------------
Q = Rationals
def sign_pattern(p, a, b, left, right):
    require(a < b or a == b and left and right, "the sign on no interval")
    if not p or a == b and p_value(Q, p, a) == 0:
        return 0
    r, k = count_roots(p, a, b, left, right), 2
    while (v := p_value(Q, p, a + Fraction(b - a, k))) == 0:
        k += 1
    positive = v > 0
    return 5 if r["crossings"] else (2 if positive else 3) if r["distinct"] else 1 if positive else 4
def curve_and_line(R, w, line):
    weighted = [p_bernstein(Q, [wi * x for wi, x in zip(w, R[c::2])]) for c in (0, 1)] + [p_bernstein(Q, w)]
    common = p_gcd(Q, p_gcd(Q, weighted[0], weighted[1]), weighted[2])
    X, Y, W = [p_divmod(Q, f, common)[0] for f in weighted]
    g = p_add(Q, p_add(Q, [line[0] * c for c in X], [line[1] * c for c in Y]), [line[2] * c for c in W])
    g, poles = trim(g), count_roots(W, 0, 1, True, True)["distinct"]
    if not g:
        return [1, 0, 0, 0, 0, poles, 0]
    f = g
    while len(h := p_gcd(Q, f, W)) > 1:
        f = p_divmod(Q, f, h)[0]
    inside, closed = count_roots(f, 0, 1, False, False), count_roots(f, 0, 1, True, True)
    jumps = count_roots(p_mul(Q, g, W), 0, 1, False, False)["crossings"] - inside["crossings"]
    return [0, closed["distinct"], inside["distinct"], inside["crossings"], inside["touches"], poles, jumps]
def polygon_and_line(R, line):
    P = list(zip(R[::2], R[1::2]))
    side = [line[0] * x + line[1] * y + line[2] for x, y in P]
    foot = [line[0] * y - line[1] * x for x, y in P]
    signs = [s > 0 for s in side if s != 0]
    pieces, runs, contained = [], 0, 0
    for i, s in enumerate(side):
        if s == 0:
            joined = i > 0 and side[i - 1] == 0
            pieces.append(sorted([foot[i - 1] if joined else foot[i], foot[i]]))
            runs += not joined
            contained += joined and foot[i - 1] != foot[i]
        elif i > 0 and side[i - 1] * s < 0:
            at = foot[i - 1] + (foot[i] - foot[i - 1]) * Fraction(side[i - 1], side[i - 1] - s)
            pieces.append([at, at])
            runs += 1
    components, end = 0, None
    for low, high in sorted(pieces):
        components += end is None or low > end
        end = high if end is None else max(end, high)
    return [sum(x != y for x, y in zip(signs, signs[1:])), runs, components, contained]
def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
def convex_polygon(flat, closed):
    P = [tuple(flat[i : i + 2]) for i in range(0, len(flat), 2)]
    P = [p for i, p in enumerate(P) if i == 0 or p != P[i - 1]]
    if closed and len(P) > 1 and P[0] == P[-1]:
        P.pop()
    if len(P) < 3 and not closed or len(P) == 1:
        return 1, 0
    if all(turn(P[0], P[1], p) == 0 for p in P):
        d = (P[1][0] - P[0][0], P[1][1] - P[0][1])
        return not closed and all((q[0] - p[0]) * d[0] + (q[1] - p[1]) * d[1] > 0 for p, q in zip(P, P[1:])), 0
    if P[0] == P[-1] and not closed:
        P.pop()
    # Closed by its chord it is convex, and turns that way, if no edge goes back, all turns go one way, and it goes round once: seen from
    # the first point, the others turn one way.
    n = len(P)
    straight = lambda a, b, c: (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) > 0
    corners = [(P[i], P[(i + 1) % n], P[(i + 2) % n]) for i in range(n)]
    turns = [turn(*c) for c in corners]
    if any(t == 0 and not straight(*c) for t, c in zip(turns, corners)):
        return 0, 0
    for sign in (1, -1):
        if all(sign * t >= 0 for t in turns) and all(sign * turn(P[0], P[i], P[i + 1]) >= 0 for i in range(1, n - 1)):
            return (1, sign) if len(set(P)) == n else (0, 0)
    return 0, 0
def determinant(M):
    M, d = [[Fraction(x) for x in row] for row in M], Fraction(1)
    for k in range(len(M)):
        pivot = next((i for i in range(k, len(M)) if M[i][k] != 0), None)
        if pivot is None:
            return Fraction(0)
        M[k], M[pivot], d = M[pivot], M[k], d if pivot == k else -d
        d *= M[k][k]
        for i in range(k + 1, len(M)):
            f = M[i][k] / M[k][k]
            M[i] = [x - f * y for x, y in zip(M[i], M[k])]
    return d
def all_minors(M, strict):
    rows, columns = len(M), len(M[0]) if M else 0
    cells = [(i, j) for i in range(rows) for j in range(columns)]
    if not strict and all(M[i][j] == 0 for i, j in cells if j not in (i - 1, i)):
        # A minor is a sum over permutations, of which only the identity has no entry 0: with rows r < r' and columns c < c', the
        # entries (r, c') and (r', c) would need c' <= r < r' <= c + 1, so c < c' <= r <= c.
        return all(M[i][j] >= 0 for i, j in cells)
    if sum(math.comb(rows, k) * math.comb(columns, k) for k in range(1, min(rows, columns) + 1)) > MOST_MINORS:
        raise Cannot("too many minors")
    M = [whole(row) for row in M] # which are positive multiples, and so are the minors
    below = {((), ()): 1}
    for k in range(1, min(rows, columns) + 1):
        minors = {}
        for r in combinations(range(rows), k):
            for c in combinations(range(columns), k):
                m = sum((-1) ** (k - 1 - j) * M[r[-1]][c[j]] * below[r[:-1], c[:j] + c[j + 1 :]] for j in range(k))
                if m < 0 or (strict and m == 0):
                    return False
                minors[r, c] = m
        below = minors
    return True
def check_hull(f, v):
    d, P, x = f["dim"], [v[i] for i in f["points"]], [v[i] for i in f["x"]]
    points_ = [P[i : i + d] for i in range(0, len(P), d)]
    dot = lambda a, b: sum(s * t for s, t in zip(a, b))
    if f["is"]:
        c = [v[i] for i in f["coefficients"]]
        require(len(c) == len(points_) and all(t >= 0 for t in c) and sum(c) == 1, "the combination is not convex")
        require(all(dot(c, [p[k] for p in points_]) == x[k] for k in range(d)), "the combination is another point")
    else:
        normal, offset = [v[i] for i in f["normal"]], v[f["offset"][0]]
        require(len(normal) == d and all(dot(normal, p) <= offset for p in points_) and dot(normal, x) > offset,
                "the plane does not separate")
def check_hull_vertices(f, v):
    P = [v[i] for i in f["points"]]
    P = [tuple(P[i : i + 2]) for i in range(0, len(P), 2)]
    V = [P[i] for i in f["vertices"]]
    require(V and len(set(V)) == len(V), "no vertices, or one twice")
    if len(V) == 1:
        require(set(P) == set(V), "other points")
    elif len(V) == 2:
        inside = lambda p: turn(V[0], V[1], p) == 0 and sum((p[k] - V[0][k]) * (p[k] - V[1][k]) for k in (0, 1)) <= 0
        require(all(inside(p) for p in P), "a point outside")
    else:
        n = len(V)
        require(all(turn(V[i], V[(i + 1) % n], V[(i + 2) % n]) > 0 for i in range(n)), "not convex")
        require(all(turn(V[i], V[(i + 1) % n], p) >= 0 for p in P for i in range(n)), "a point outside")
def check_operations(f, nodes):
    """Sums and products below the nodes `out`; a product with a constant that is a power of two is a shift."""
    def power_of_two(op, *a):
        x = Fraction(a[0]) if op == "c" else Fraction(0)
        return x > 0 and x.numerator & (x.numerator - 1) == x.denominator & (x.denominator - 1) == 0 or (
            op == "*" and all(power_of_two(*nodes[i]) for i in a))
    below, count = set(f["out"]), {"additions": 0, "multiplications": 0, "shifts": 0}
    for i in range(len(nodes) - 1, -1, -1):
        op, *a = nodes[i]
        if i in below and op not in "xco":
            require(op in "+-*", "an operation of another kind")
            count["additions" if op != "*" else "shifts" if any(power_of_two(*nodes[j]) for j in a) else "multiplications"] += 1
            below.update(a)
    require(all(f[key] == number for key, number in count.items()), "the number of operations")
class Ratio:
    """A rational function of one variable modulo p, for the degrees that it has there."""
    def __init__(self, top, bottom=(1,)):
        divisor = p_gcd(Modular, list(top), list(bottom)) if top else list(bottom)
        self.top, self.bottom = [p_divmod(Modular, list(side), divisor)[0] for side in (top, bottom)]
    def combined(self, other, sign):
        other = other if isinstance(other, Ratio) else Ratio(trim([other % PRIME]))
        return Ratio(p_add(Modular, p_mul(Modular, self.top, other.bottom), p_mul(Modular, other.top, self.bottom), sign),
                     p_mul(Modular, self.bottom, other.bottom))
    __add__ = __radd__ = lambda self, other: self.combined(other, 1)
    __sub__ = lambda self, other: self.combined(other, -1)
    __rsub__ = lambda self, other: -self + other
    __neg__ = lambda self: Ratio([-c % PRIME for c in self.top], self.bottom)
    def __mul__(self, other):
        other = other if isinstance(other, Ratio) else Ratio(trim([other % PRIME]))
        return Ratio(p_mul(Modular, self.top, other.top), p_mul(Modular, self.bottom, other.bottom))
    __rmul__ = __mul__
    def over(self, other):
        if not other.top:
            raise ZeroDivisionError
        return self * Ratio(other.bottom, other.top)
class Ratios(Modular):
    reduce = staticmethod(lambda x: x if isinstance(x, Ratio) else x % PRIME)
    @staticmethod
    def quotient(x, y):
        if not isinstance(x, Ratio) and not isinstance(y, Ratio):
            return Modular.quotient(x, y)
        return (x if isinstance(x, Ratio) else Ratio(trim([x]))).over(y if isinstance(y, Ratio) else Ratio(trim([y])))
def degrees_in(program, i, x):
    """Of numerator and denominator of node i in the input that is node x, the other inputs being random modulo p: those of a random
    point are the highest there are, but for a probability that is smaller than that of an identity."""
    name = program.case["nodes"][x]
    require(name[0] == "x", "degrees in what is no variable")
    _, inputs = next(program.random_points())
    value = program.run(Ratios, [Ratio([0, 1]) if k == name[1] else a for k, a in enumerate(inputs)])[i]
    return [len(value.top) - 1, len(value.bottom) - 1] if isinstance(value, Ratio) else [0 if value else -1, 0]
def check_fact(f, v, program):
    kind, get = f["fact"], lambda field: [v[i] for i in f[field]]
    number = lambda i: None if i < 0 else v[i]
    if kind in ("order", "equal"):
        a, b = v[f["of"][0]], 0 if f["of"][1] < 0 else v[f["of"][1]]
        require(f["is"] == ((a > b) - (a < b) if kind == "order" else int(a == b)), f"{kind} of two numbers")
    elif kind == "whole":
        require(f["is"] == int(v[f["of"][0]].denominator == 1), "whether a number is whole")
    elif kind == "degree":
        require(f["is"] == len(v[f["of"][0]]) - 1, "the degree of a polynomial")
    elif kind == "pequal":
        require(f["is"] == int(v[f["of"][0]] == ([] if f["of"][1] < 0 else v[f["of"][1]])), "equality of polynomials")
    elif kind == "degrees":
        require(f["is"] == degrees_in(program, *f["of"]), "the degrees of a rational function")
    elif kind == "roots":
        found = count_roots(v[f["p"]], *map(number, f["from"]), *map(bool, f["with_ends"]))
        require(all(f.get(key, count) == count for key, count in found.items()), "the number of roots")
    elif kind == "sign":
        require(f["is"] == sign_pattern(v[f["p"]], *map(number, f["from"]), *map(bool, f["with_ends"])), "the sign of a polynomial")
    elif kind == "curve_and_line":
        require(f["is"] == curve_and_line(get("R"), get("w"), get("line")), "a curve and a line")
    elif kind == "polygon_and_line":
        require(f["is"] == polygon_and_line(get("R"), get("line")), "a polygon and a line")
    elif kind == "operations":
        check_operations(f, program.case["nodes"])
    elif kind in ("hull", "hull_vertices"):
        (check_hull if kind == "hull" else check_hull_vertices)(f, v)
    elif kind == "convex_polygon":
        require((f["is"], f["orientation"]) == convex_polygon(get("points"), f["closed"]), "convexity of a polygon")
    elif kind in ("minors", "determinant"):
        A, columns = get("A"), f.get("columns", f["rows"])
        M = [A[i * columns : (i + 1) * columns] for i in range(f["rows"])]
        require(len(A) == f["rows"] * columns, "the shape of a matrix")
        if kind == "minors":
            require(f["is"] == int(all_minors(M, f["strict"])), "the signs of the minors")
        else:
            require(v[f["is"][0]] == determinant(M), "a determinant")
    else: # recheck_format has refused all others
        {"sign_in_box": recheck_sign, "sum_for_every_n": recheck_sums, "range_of_parameter": recheck_range}[kind].check(f, v, program, require, fraction_text, Modular.quotient)

# ---- signs read off coefficients --------------------------------------------------------------------------
@functools.cache
def fraction_text(text):
    """(numerator, denominator), each a list of (coefficient, {variable: exponent}); the coefficients are integers."""
    def monomials(side):
        out = []
        for sign, body in re.findall(r"([+-]?)([^+-]+)", side.strip("()")):
            c, powers = -1 if sign == "-" else 1, {}
            for x, exponent in (factor.partition("^")[::2] for factor in body.split("*")):
                if x.isdigit():
                    c *= int(x)
                else:
                    powers[x] = powers.get(x, 0) + int(exponent or 1)
            out.append((c, powers))
        return out
    numerator, _, denominator = text.replace(" ", "").partition("/")
    return monomials(numerator), monomials(denominator or "1")
def fraction_degrees(text):
    return tuple(max([sum(powers.values()) for _, powers in side] + [0]) for side in fraction_text(text))
def fraction_value(K, text, at):
    """Summed in whole numbers: times the d-th powers of the denominators of the variables, (n/m)^e is n^e m^(d-e)."""
    def value(side):
        variables, d = {x for _, powers in side for x in powers}, max([e for _, powers in side for e in powers.values()] + [0])
        power = functools.cache(lambda x, e: K.reduce(at(x).numerator**e * at(x).denominator ** (d - e)))
        total = sum(c * math.prod([power(x, powers.get(x, 0)) for x in variables]) for c, powers in side)
        return K.quotient(total, math.prod(at(x).denominator**d for x in variables))
    return K.quotient(*map(value, fraction_text(text)))
def check_coefficient_signs(step):
    sides = [{c > 0 for c, _ in side if c != 0} for side in fraction_text(step["text"])]
    require(all(len(side) <= 1 for side in sides), "coefficients of both signs")
    sign = math.prod(sum(1 if positive else -1 for positive in side) for side in sides)
    require(sign == step["sign"] and (sign >= 0) == step["good"], "the sign of the coefficients")

# ---- claims and statements --------------------------------------------------------------------------------
def good(step):
    return step.get("equal", step.get("agree", step.get("good", True)))
def check_case(case, proved, faulty):
    require(all(isinstance(x, list) and len(x) == 2 for x in case["inputs"]), "the inputs")
    steps, program = case["steps"], Program(case)
    v = program.run(Q, [Q.number(x[1]) for x in case["inputs"]])
    facts, supported, last = 0, True, [] # the facts since the last step that is none
    for s in steps:
        if "same" in s:
            require(s["equal"] == (v[s["same"][0]] == v[s["same"][1]]), "equality of two numbers")
        elif "nonnegative" in s:
            require(s["good"] == (v[s["nonnegative"]] >= 0), "the sign of a number")
        elif "fact" in s:
            facts += 1
            check_fact(s, v, program)
        else:
            require(isinstance(s["agree"], bool), "a step without meaning")
            supported &= facts > 0
            require(recheck_formula.follows(s, last, faulty), "a condition that does not follow from its facts")
        last = last + [s] if "fact" in s else []
    if not supported or all("fact" in s for s in steps):
        raise Cannot("a condition without facts")
    if proved or case["type"] == "field":
        check_identity(program, facts > 0)
    return all(good(s) for s in steps)
def check_identity(program, branches):
    """What is equal is so for all inputs; a sign was read off a fraction that is the node."""
    steps, d = program.case["steps"], program.degrees()
    pairs = [s["same"] for s in steps if s.get("equal")]
    signs = [s for s in steps if "nonnegative" in s]
    if any("text" not in s for s in signs):
        raise Cannot("signs that were not read off coefficients")
    if any(d[i] is None for i in {i for pair in pairs for i in pair} | {s["nonnegative"] for s in signs}):
        raise Cannot("nodes that are no rational functions of the inputs")
    texts = [fraction_degrees(s["text"]) for s in signs]
    bound = max([sum(d[i]) + sum(d[j]) for i, j in pairs] + [sum(d[s["nonnegative"]]) + sum(t) for s, t in zip(signs, texts)] + [1])
    for s in signs:
        check_coefficient_signs(s)
    for inputs, w in program.random_runs(bound) if pairs or signs else ():
        if any(w[i] != w[j] for i, j in pairs):
            raise Cannot("a program that depends on its case") if branches else Wrong("an equality that is no identity")
        for s in signs:
            value = fraction_value(Modular, s["text"], lambda x: inputs[program.names[x]])
            require(w[s["nonnegative"]] == value, "the fraction is not what was computed")
def check_listed_claim(c, listed):
    """The certificate has the cases that the manifest says, which is evidence of that kind only in that number type."""
    require(listed is not None, "a claim that the manifest does not list")
    require(c["kind"] == listed["kind"], "a claim of another kind")
    found = [{"type": case["type"], "degree": case["degree"], "inputs": len(case["inputs"]), "nodes": len(case["nodes"]),
              "compared": sum("fact" not in s for s in case["steps"]), "facts": sum("fact" in s for s in case["steps"]),
              "of_the_same": sum(case["nodes"][i] == case["nodes"][j] for i, j in (s["same"] for s in case["steps"] if "same" in s))}
             for case in c["cases"]]
    require(found == listed["certificate"], "other cases than the manifest says")
    type_of = {"proved": "field", "sampled": "rational", "enclosed": "interval", "measured": "double"}.get(c["evidence"])
    require(type_of is None or any(t["type"] == type_of and t["compared"] > 0 for t in listed["types"]), "it never ran in that number type")
def check_claim(c, listed):
    kind, outcome, evidence = c["kind"], c["outcome"], c["evidence"]
    recheck_format.check_claim(c)
    check_listed_claim(c, listed)
    require(outcome == ("fails" if kind == "counterexample" else "holds"), "the outcome")
    require(evidence in (("decided",) if kind != "identity" else EVIDENCE[1:4] + ["proved"]) and type(c["argued"]) is bool, "the evidence")
    if not c["cases"]:
        raise Cannot("no program")
    holds = [check_case(case, evidence == "proved", kind == "counterexample") for case in c["cases"]]
    require(all(holds) if outcome == "holds" else not any(holds), "the outcome does not follow")
def derived(s, claims):
    """Verdict and evidence from the claims, by their roles."""
    evidence = lambda c: weakest([c["evidence"]] + ["argued"] * c["argued"])
    of = lambda *roles: [evidence(claims[l["claim"]]) for l in s["links"] if "claim" in l and l["role"] in roles]
    roles = [l["role"] for l in s["links"]]
    weakest = lambda evidence: min(evidence, key=EVIDENCE.index) if evidence else "none"
    against, for_it = of("refuted-by"), of("holds-by", "checked-by")
    words = any(l["role"] == "cites" or l["role"] == "argued" and not l["adds_cases"] for l in s["links"])
    for_it += ["argued"] * (words and for_it != [])
    fails = any(claims[l["claim"]]["outcome"] == "fails" for l in s["links"] if l["role"] == "reading" and "claim" in l)
    if against:
        return "fails", weakest(against)
    if s["definition"]:
        return "definition", weakest(for_it)
    if "reading" in roles and "hypothesis" not in roles and (not for_it or fails and "meant" not in roles):
        return "undecided", "none"
    if for_it:
        return ("conditional" if "hypothesis" in roles else "holds"), weakest(for_it)
    return "open", "none"
def check_listed_statement(s, listed):
    require(listed is not None, "a statement that the manifest does not list")
    links = lambda of: [(link["role"], link.get("claim")) for link in of["links"]]
    require(s["definition"] == listed["definition"] and links(s) == links(listed), "other claims or roles than the manifest says")
def check_statement(s, name, listed, claim_of):
    recheck_format.check_statement(s, name)
    check_listed_statement(s, listed)
    claims, unable = {}, None
    for link in (link for link in s["links"] if "claim" in link):
        text, outcome = claim_of(link["claim"])
        if isinstance(outcome, Wrong):
            raise outcome
        unable = unable or outcome
        claims[link["claim"]] = text
        wanted = "fails" if link["role"] == "refuted-by" else "holds" if link["role"] in (
            "holds-by", "confirmed-by", "corrected-by", "checked-by", "reading-with") else text["outcome"]
        require(text["outcome"] == wanted, f"{link['claim']} {text['outcome']}, which is not what its role asks")
    require((s["verdict"], s["evidence"]) == derived(s, claims), "the verdict does not follow")
    if unable:
        raise unable
def attempt(check, *arguments):
    """None when it went well, otherwise what went wrong."""
    try:
        check(*arguments)
    except (Wrong, Cannot) as e:
        return e
    except (KeyError, IndexError, TypeError, ValueError, ZeroDivisionError, AttributeError, RecursionError) as e:
        return Wrong(f"malformed: {type(e).__name__} {e}")
def load(path, listed=None):
    try:
        content = path.read_bytes()
        require(listed is None or hashlib.sha256(content).hexdigest() == listed["sha256"], "another file than the manifest says")
        return recheck_format.read(content.decode())
    except (OSError, ValueError, RecursionError) as e:
        raise Wrong(f"{path.name} cannot be read: {e}") from e

def read_manifest(path):
    """The printed statements and the claims, by name."""
    m = load(path)
    require(m["schema"] == "cagd-manifest-1", "the format of the manifest")
    statements, claims = {s["statement"]: s for s in m["statements"]}, {c["claim"]: c for c in m["claims"]}
    require(len(statements) == len(m["statements"]) and len(claims) == len(m["claims"]), "the manifest has an entry twice")
    return statements, claims

def main():
    if len(sys.argv) not in (2, 3) or not pathlib.Path(sys.argv[1]).is_dir():
        sys.stderr.write("usage: recheck.py DIR [MANIFEST], a folder written by 'cagd verify --certificates DIR'\n")
        return 2
    root, known, outcomes = pathlib.Path(sys.argv[1]), {}, []
    try:
        statements, claims = read_manifest(pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else root / "manifest.json"))
    except (Wrong, KeyError, TypeError) as e:
        print(f"manifest: wrong ({e})")
        return 1
    def claim_of(name):
        if name not in known:
            try:
                text = load(root / "claims" / f"{name}.json", claims.get(name))
                require(isinstance(text, dict) and text.get("claim") == name, f"{name}.json is about another claim")
                known[name] = text, attempt(check_claim, text, claims.get(name))
                text.pop("cases", None) # the statements ask for what is decided alone
            except Wrong as e:
                known[name] = {}, e
        return known[name]
    def tell(name, e):
        outcomes.append("rechecked" if e is None else "wrong" if isinstance(e, Wrong) else "cannot recheck this kind")
        print(f"{name}: {outcomes[-1]}{f' ({e})' if e else ''}")
    written = {f"{path.parent.name}:{path.stem}": path for path in root.glob("*/*.json") if path.parent.name != "claims"}
    for name in sorted(statements.keys() | written.keys()):
        path = written.get(name, root / (name.replace(":", "/", 1) + ".json"))
        tell(name, attempt(lambda: check_statement(load(path, statements.get(name)), name, statements.get(name), claim_of)))
    of_statements = list(outcomes)
    for name in sorted(claims.keys() | {path.stem for path in (root / "claims").glob("*.json")}):
        if isinstance(e := claim_of(name)[1], Wrong):
            tell(f"claim {name}", e)
    words = ("rechecked", "wrong", "cannot recheck this kind")
    print(recheck_formula.told(), ", ".join(f"{of_statements.count(word)} {word}" for word in words), sep="\n")
    return 1 if "wrong" in outcomes or "rechecked" not in outcomes else 3 if words[2] in outcomes else 0

if __name__ == "__main__":
    sys.exit(main())
