"""For which values of a parameter relations hold, exactly.

    {"fact":"range_of_parameter","parameter":[x],"of":[d,...],"numerator":[n,...],"denominator":[m,...],"relation":[r,...],"other":[t,...],
     "low":[...],"high":[...],"open":[...],"domain":[a,b],"domain_open":[...],"terms":[...],"roots":[...],"between":[...],"holds":[...],"is":1}

Each d = n/m is compared with 0; that is the relation 0: n is the function 0; 1: d != 0; 2: d >= 0; 3: d > 0, for all t with low <= t <= high, -1 being no t and no
bound, and "open" two bits: whether low, and high, do not count; 4: n is not the function 0, and with the relations 1 to 3 m must not be it.

The real numbers of the domain are cut by roots of polynomials in the parameter, of which "terms" has the numbers of coefficients and "roots" the coefficients; each is the only
root of its own in the open interval of two numbers of "between", or that number if they are one.  "holds" is said of the cells and of the numbers that cut, in
increasing order: 1 if all relations hold, 0 if they do not, -1 where there is nothing.

It is checked by a cylindrical decomposition of our own.  n m is c(x) times a polynomial in t, of which s is the squarefree part.  Where no leading coefficient
in the remainders of s by its derivative is 0, no common divisor of their coefficients, and not c, s(low) and s(high), s has constantly many roots t, and none crosses an end: what holds
for one x holds for its neighbours.  So one fraction between two such numbers decides, and each of these numbers itself: it is a root a of a polynomial q, one computes with polynomials in
a, and such a number is 0 if that root is one of the common divisor with q.  Roots t are counted by Sturm's theorem, with remainders times positive numbers."""
from fractions import Fraction
import recheck_format, recheck_formula
from recheck_polynomial import (PRIME, Rationals as Q, p_add, p_derivative, p_divmod, p_gcd, p_mul, p_value, require, sturm_inside, trim, whole)

node, end, several, bit = recheck_format.node, recheck_format.end, recheck_format.several, recheck_format.bit
RELATIONS = range(5)
ZERO, DIFFERENT, AT_LEAST, MORE, DIVISOR = RELATIONS
recheck_format.FACTS["range_of_parameter"] = [{
    "parameter": several(node, 1), **{name: several(node) for name in ("of", "numerator", "denominator", "roots", "between")},
    "relation": several(lambda x: type(x) is int and x in RELATIONS), **{name: several(end) for name in ("other", "low", "high")}, "domain": several(end, 2),
    "open": several(bit), "domain_open": several(bit, 2), "terms": several(recheck_format.positive),
    "holds": several(lambda x: type(x) is int and x in (-1, 0, 1)), "is": lambda x: type(x) is int and x == 1}]
recheck_formula.DECISIONS["range_of_parameter"] = ("range_of_parameter", {"": lambda fact: fact["is"]})

# ---- real algebraic numbers -------------------------------------------------------------------------------
NARROW = 40 # a value that may be 0 where the number is known to 2^-40 is looked at by divisors
sign_of = lambda x: (x > 0) - (x < 0)
class Number:
    """The only root of the squarefree q between low and high, which are none, or the fraction low = high."""
    def __init__(self, q, low, high):
        self.low, self.high = low, high
        self.use(q)
    def use(self, q):
        self.q, self.slope = q, 0 if self.low == self.high else sign_of(p_value(Q, q, self.high))
    def halve(self):
        middle = Fraction(self.low + self.high) / 2
        side = sign_of(p_value(Q, self.q, middle)) * self.slope
        if side <= 0:
            self.low = middle
        if side >= 0:
            self.high = middle
    def enclosure(self, f):
        """Two numbers between which f is, by Horner's rule."""
        least = most = 0
        for c in reversed(f):
            products = [x * y for x in (least, most) for y in (self.low, self.high)]
            least, most = min(products) + c, max(products) + c
        return least, most
    def is_root_of(self, f):
        common = p_gcd(Q, self.q, f)
        return len(common) > 1 and sturm_inside(common, self.low, self.high) > 0
    def sign(self, f):
        """Of the polynomial f at the number."""
        asked = False
        while self.low < self.high:
            least, most = self.enclosure(f)
            if least > 0 or most < 0 or not f:
                return sign_of(least)
            if not asked and (self.high - self.low) * 2**NARROW < 1:
                if self.is_root_of(f):
                    return 0
                asked = True
            self.halve()
        return sign_of(p_value(Q, f, self.low))
    def order(self, x):
        """Below the fraction x: -1, above it: 1."""
        return self.sign([-x, 1])

def squarefree_part(f):
    return whole(p_divmod(Q, f, p_gcd(Q, f, p_derivative(Q, f)))[0])
def real_roots(q):
    """Of a squarefree polynomial, in increasing order."""
    bound = 2 + int(max([abs(Fraction(c) / q[-1]) for c in q])) # Cauchy's
    todo, out = [(Fraction(-bound), Fraction(bound))], []
    while todo:
        low, high = todo.pop()
        count = sturm_inside(q, low, high)
        if count == 0:
            continue
        if count == 1 and p_value(Q, q, low) != 0 and p_value(Q, q, high) != 0:
            out.append(Number(q, low, high))
            continue
        middle = (low + high) / 2
        if p_value(Q, q, middle) == 0:
            out.append(Number([-middle, 1], middle, middle))
        todo += [(low, middle), (middle, high)]
    for a in out: # until they are apart
        while any(a is not b and a.low <= b.high and b.low <= a.high for b in out):
            a.halve()
            for b in out:
                b.halve()
    return sorted(out, key=lambda a: a.low)

# ---- polynomials in t, whose coefficients are polynomials in the parameter ---------------------------------
def common_divisor(coefficients):
    g = []
    for c in coefficients:
        g = p_gcd(Q, g, c) if g or c else g
    return g
def primitive(f):
    """The common divisor of the coefficients, and what is left."""
    c = common_divisor(f)
    return c, [p_divmod(Q, x, c)[0] for x in f] if len(c) > 1 else f
def derivative(f):
    return [p_mul(Q, [k], c) for k, c in enumerate(f)][1:]
def cut(f, is_zero=lambda c: not c):
    f = list(f)
    while f and is_zero(f[-1]):
        f.pop()
    return f
def step(a, b, factor):
    """a times the factor's first, minus b times its second, shifted to the degree of a."""
    shift = len(a) - len(b)
    return [p_add(Q, p_mul(Q, factor[0], x), p_mul(Q, factor[1], b[k - shift] if k >= shift else []), -1) for k, x in enumerate(a)]
def remainders(a, b):
    """The last remainder that is not 0, and the polynomials in the parameter without whose roots all remainders are those of numbers."""
    seen = []
    while b:
        seen.append(b[-1])
        r = a
        while len(r) >= len(b):
            r = cut(step(r, b, (b[-1], r[-1])))
        c, r = primitive(r) if r else ([], r)
        seen.append(c)
        a, b = b, r
    return a, seen
def divided(a, b):
    quotient = [[]] * (len(a) - len(b) + 1)
    while a:
        quotient[len(a) - len(b)], rest = p_divmod(Q, a[-1], b[-1])
        require(not rest, "a division with a remainder")
        a = cut(step(a, b, ([1], quotient[len(a) - len(b)])))
    return quotient
def value(f, t):
    out = []
    for c in reversed(f):
        out = p_add(Q, p_mul(Q, out, trim([t])), c)
    return out
def critical(f, low, high):
    """The polynomials in the parameter at whose roots the signs of f between low and high may become others."""
    c, f = primitive(f)
    if len(f) == 1:
        return [c]
    s = divided(f, primitive(remainders(f, derivative(f))[0])[1])
    return [c, s[-1], *remainders(s, derivative(s))[1], *[value(s, t) for t in (low, high) if t is not None]]

# ---- one value of the parameter ---------------------------------------------------------------------------
def signs_between(f, a, low, high):
    """f not 0 at the number a: whether it is 0 for low, for high, how many roots are between them, and its signs between roots."""
    reduced = lambda c: p_divmod(Q, c, a.q)[1]
    clean = lambda f: cut([reduced(c) for c in f], lambda c: a.sign(c) == 0)
    f, zeros, turned = clean(f), [0, 0], 1
    for k, t in enumerate((low, high)):
        while t is not None and len(f) > 1 and a.sign(value(f, t)) == 0:
            quotient = [] # by t - low, or by high - t
            for c in reversed(f[1:]):
                quotient.append(p_add(Q, c, p_mul(Q, quotient[-1], trim([t])) if quotient else []))
            f, zeros[k], turned = clean(reversed(quotient)), 1, turned * (-1 if k else 1)
    chain = [f, clean(derivative(f))]
    while chain[-1]:
        r, b = chain[-2], chain[-1]
        s = a.sign(b[-1])
        while len(r) >= len(b):
            r = clean(step(r, b, ([s * c for c in b[-1]], [s * c for c in r[-1]])))
        scale = [x for c in r for x in c]
        numbers = iter(whole([-x for x in scale])) if scale else iter([])
        chain.append([[next(numbers) for _ in c] for c in r])
    chain.pop()
    def at(g, t, side):
        return a.sign(value(g, t)) if t is not None else a.sign(g[-1]) * (side if len(g) % 2 == 0 else 1)
    def changes(t, side):
        signs = [x for g in chain if (x := at(g, t, side)) != 0]
        return sum(x != y for x, y in zip(signs, signs[1:]))
    ends = [low, high]
    for k, side in ((0, -1), (1, 1)): # beyond all roots
        if ends[k] is None:
            ends[k] = side + (ends[1 - k] or 0)
            while a.sign(value(f, ends[k])) == 0 or changes(ends[k], side) != changes(None, side):
                ends[k] += side * (1 + abs(ends[k]))
    count = changes(ends[0], -1) - changes(ends[1], 1)
    signs, todo = {turned * a.sign(value(f, t)) for t in ends}, [(*ends, count)]
    while todo:
        left, right, inside = todo.pop()
        if inside > 1:
            k = 2
            while a.sign(value(f, middle := left + Fraction(right - left) / k)) == 0:
                k += 1
            signs.add(turned * a.sign(value(f, middle)))
            here = changes(left, -1) - changes(middle, 1)
            todo += [(left, middle, here), (middle, right, inside - here)]
    return zeros, count, signs
def holds(one, a):
    """Whether the relation holds for the number a."""
    relation, n, m, (low, high, low_open, high_open) = one
    is_zero = lambda f: all(a.sign(c) == 0 for row in f for c in row)
    if relation in (ZERO, DIVISOR):
        return is_zero(n) == (relation == ZERO)
    if is_zero(m):
        return False
    f = product(n, m)[0] if relation != DIFFERENT else n[0]
    if is_zero([f]):
        return relation == AT_LEAST
    if low is not None and low == high:
        s = a.sign(value(f, low))
        return s != 0 if relation == DIFFERENT else s >= (relation == MORE)
    zeros, count, signs = signs_between(f, a, low, high)
    none = count == 0 and not (zeros[0] and not low_open) and not (zeros[1] and not high_open)
    return none if relation == DIFFERENT else signs == {1} and (none or relation == AT_LEAST)
def product(n, m):
    out = [[]] * (len(n[0]) + len(m[0]) - 1)
    for i, x in enumerate(n[0]):
        for j, y in enumerate(m[0]):
            out[i + j] = p_add(Q, out[i + j], p_mul(Q, x, y))
    return [out]

# ---- the fact ---------------------------------------------------------------------------------------------
def rows(side, x, t):
    """A polynomial as rows of coefficients, each a polynomial in x: for each product of powers of names other than x and t the one of a polynomial in t."""
    out = {}
    for c, powers in side:
        powers = dict(powers)
        i, j = powers.pop(t, 0), powers.pop(x, 0)
        row = out.setdefault(frozenset(powers.items()), [])
        row += [[] for _ in range(i + 1 - len(row))]
        row[i] = p_add(Q, row[i], [0] * j + [c])
    return [cut(row) for row in out.values()] or [[]]
def read(f, k, v, program, fraction_text):
    nodes, inputs = program.case["nodes"], program.case["inputs"]
    name = lambda i: inputs[nodes[i][1]][0]
    text = lambda i: fraction_text(name(i) if nodes[i][0] == "x" else nodes[i][1])
    x, t, relation = f["parameter"][0], f["other"][k], f["relation"][k]
    require(nodes[x][0] == "x" and (t < 0 or nodes[t][0] == "x") and t != x, "the letters of a range")
    sides = [f["numerator"][k], f["denominator"][k]]
    require(all(nodes[i][0] in "xfc" and text(i)[1] == [(1, {})] for i in sides), "a side that is no polynomial")
    bounds = [None if i < 0 else Fraction(v[i]) for i in (f["low"][k], f["high"][k])]
    require(all(i < 0 or nodes[i][0] == "c" for i in (f["low"][k], f["high"][k])), "a bound that is no number")
    require(None in bounds or bounds[0] <= bounds[1], "bounds from right to left")
    n, m = (rows(text(i)[0], name(x), None if t < 0 else name(t)) for i in sides)
    require(relation in (ZERO, DIVISOR) or len(n) == len(m) == 1, "a sign in more than one name")
    require(t >= 0 or bounds == [None, None], "bounds of nothing")
    return relation, n, m, (*bounds, *f["open"][2 * k : 2 * k + 2])
def check(f, v, program, require, fraction_text, _):
    size = len(f["of"])
    require(size > 0 and all(len(f[name]) == size for name in ("numerator", "denominator", "relation", "other", "low", "high")) and len(f["open"]) == 2 * size, "the shape of a range")
    nodes, degrees = program.case["nodes"], program.degrees()
    cuts = len(f["terms"])
    require(sum(f["terms"]) == len(f["roots"]) and len(f["between"]) == 2 * cuts and len(f["holds"]) == 2 * cuts + 1, "the cells of a range")
    every = [read(f, k, v, program, fraction_text) for k in range(size)]
    require(all(degrees[d] is not None for d in f["of"]), "a relation of what is no rational function")
    bound = max(sum(degrees[d]) + sum(sum(degrees[i]) for i in (n, m)) for d, n, m in zip(f["of"], f["numerator"], f["denominator"]))
    for _, w in program.random_runs(bound):
        require(all((w[d] * w[m] - w[n]) % PRIME == 0 for d, n, m in zip(f["of"], f["numerator"], f["denominator"])), "a quotient that is another function")
    domain = [None if i < 0 else Fraction(v[i]) for i in f["domain"]]
    own, place = [], 0
    for terms in f["terms"]:
        own.append(trim([v[i] for i in f["roots"][place : place + terms]]))
        place += terms
    require(all(len(p) > 1 for p in own), "a root of a constant")
    # All numbers at which anything may change, those of the fact, and the ends of the domain, as roots of one polynomial.
    everything = [1]
    polynomials = [*own, *[[-t, 1] for t in domain if t is not None]]
    for relation, n, m, (low, high, *_) in every:
        for side in ([n] if relation in (ZERO, DIVISOR) else [n, m]):
            polynomials.append(common_divisor([c for row in side for c in row]))
        if relation not in (ZERO, DIVISOR) and n[0]:
            polynomials += critical(product(n, m)[0], low, high)
    for p in polynomials:
        if len(p) > 1:
            p = squarefree_part(p)
            everything = whole(p_mul(Q, everything, p_divmod(Q, p, p_gcd(Q, p, everything))[0]))
    points = real_roots(everything) if len(everything) > 1 else []
    for a in points: # as a root of the shortest of them
        a.use(min((squarefree_part(p) for p in polynomials if len(p) > 1 and a.sign(p) == 0), key=len))
    inside = lambda a: all(t is None or a.order(t) * side > 0 or (a.order(t) == 0 and not is_open)
                           for t, side, is_open in zip(domain, (1, -1), f["domain_open"]))
    # Which of them are those of the fact.
    which = []
    for k, p in enumerate(own):
        low, high = (Fraction(v[i]) for i in f["between"][2 * k : 2 * k + 2])
        found = [i for i, a in enumerate(points) if a.sign(p) == 0 and ((a.order(low) > 0 and a.order(high) < 0) if low < high else a.order(low) == 0)]
        require(len(found) == 1 and (not which or which[-1] < found[0]), "the numbers that cut a range")
        which += found
    cell, seen = 0, set()
    for i, right in enumerate([*points, None]):
        left = points[i - 1] if i > 0 else None
        middle = (Fraction(left.high + right.low) / 2 if left and right else left.high + 1 if left else right.low - 1 if right else Fraction(0))
        of_cell, of_right = 2 * cell, 2 * cell + (i in which)
        for place, a in ((of_cell, Number([-middle, 1], middle, middle)), (of_right, right)):
            if a is not None and inside(a):
                seen.add(place)
                require(f["holds"][place] == all(holds(one, a) for one in every), "the values of a parameter for which something holds")
        cell += i in which
    require(all(claim == -1 for place, claim in enumerate(f["holds"]) if place not in seen), "values of a parameter beyond its domain")
