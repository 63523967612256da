"""Signs of rational functions where their variables have bounds.

    {"fact":"sign_in_box","of":[d],"constant":[c],"factors":[f,...],"powers":[e,...],"signs":[s,...],"cuts":[...],
     "variables":[x,...],"low":[...],"high":[...],"open":[...],"strict":0,"is":1}

says that d >= 0 (d > 0 if strict) wherever d is defined in the box low <= x <= high, -1 being no bound, and "open" two bits for each
variable: whether low, and high, do not belong to the box.  d is c f^e ..., which is an identity.  A factor whose power is odd has the sign s
in the whole box, 1 or -1; if strict, and the power is positive, it is nowhere 0 there, and neither is one whose power is even.

The sign is shown part by part: "cuts" has, one factor after the other, the tree of its parts, -1 for one that is not cut, or a variable by its
place, the node of the number that cuts, and the trees of the parts below and above.  A part that is not cut is mapped to the positive u by
x = a + u, b - u or (a + b u)/(1 + u), and the numerator has coefficients >= 0, some of which is positive.  On a face of the box it has those coefficients
where u has the lowest power, or the highest: if strict, one of them is positive on every face that belongs to the box."""
import math
from fractions import Fraction
from itertools import product
import recheck_format, recheck_formula

PRIME = 2**127 - 1
node, end, several, bit = recheck_format.node, recheck_format.end, recheck_format.several, recheck_format.bit
recheck_format.FACTS["sign_in_box"] = [{
    "of": several(node, 1), "constant": several(node, 1), "factors": several(node), "variables": several(node), "low": several(end),
    "high": several(end), "open": several(bit), "powers": several(lambda x: type(x) is int and x != 0), "signs": several(recheck_format.sign),
    "cuts": several(end), "strict": bit, "is": lambda x: type(x) is int and x == 1}]
recheck_formula.DECISIONS["is_positive_in_box"] = ("sign_in_box", {"": lambda fact: fact["strict"]})
recheck_formula.DECISIONS["is_nonnegative_in_box"] = ("sign_in_box", {"": lambda fact: fact["is"]})

def over_positive_numbers(p, k, low, high):
    """The numerator of p, {exponents: coefficient}, with x_k = low + u, high - u or (low + high u)/(1 + u), u being the new x_k."""
    n, out = max([e[k] for e in p] + [0]), {}
    # x^j (1+u)^(n-j) = (a + b u)^j (1 + d u)^(n-j)
    a, b, d = (low, high, 1) if None not in (low, high) else (low, 1, 0) if low is not None else (high, -1, 0)
    power = lambda c, e: [math.comb(e, i) * c[0] ** (e - i) * c[1] ** i for i in range(e + 1)]
    def times(f, g):
        h = [0] * (len(f) + len(g) - 1)
        for i, x in enumerate(f):
            for j, y in enumerate(g):
                h[i + j] += x * y
        return h
    basis = [times(power((a, b), j), power((1, d), n - j)) for j in range(n + 1)]
    for e, c in p.items():
        for i, x in enumerate(basis[e[k]]):
            key = e[:k] + (i,) + e[k + 1 :]
            out[key] = out.get(key, 0) + c * x
    return out, n if d else 0

def part_has_sign(p, strict, box):
    """box: (low, high, low is open, high is open) for each variable; all coefficients >= 0, and one is positive on each face."""
    highest = []
    for k, (low, high, _, _) in enumerate(box):
        if low is None and high is None:
            if any(e[k] for e in p):
                return False
            highest.append(0)
            continue
        p, n = over_positive_numbers(p, k, low, high)
        highest.append(n)
    positive = [e for e, c in p.items() if c > 0]
    if not positive or any(c < 0 for c in p.values()):
        return False
    def faces(low, high, low_open, high_open, n): # exponents that count on the smallest faces, None: all
        ends = [0] * (low is not None and not low_open) + [n if low is not None else 0] * (high is not None and not high_open)
        return ends or [None]
    smallest = product(*(faces(*side, n) for side, n in zip(box, highest)))
    return not strict or all(any(all(i in (None, x) for i, x in zip(face, e)) for e in positive) for face in smallest)

def has_sign(p, strict, box, cuts, v):
    """Takes one tree from the front of the list `cuts`."""
    k = cuts.pop(0)
    if k < 0:
        return part_has_sign(p, strict, box)
    at, (low, high, low_open, high_open) = Fraction(v[cuts.pop(0)]), box[k]
    if not (low is None or low < at) or not (high is None or at < high):
        return False
    below, above = list(box), list(box)
    below[k], above[k] = (low, at, low_open, 0), (at, high, 0, high_open)
    return has_sign(p, strict, below, cuts, v) and has_sign(p, strict, above, cuts, v)

def check(f, v, program, require, fraction_text, _):
    nodes, x, m = program.case["nodes"], f["variables"], len(f["variables"])
    require(all(nodes[i][0] == "x" for i in x) and len(set(x)) == m, "the variables of a box")
    require(len(f["low"]) == len(f["high"]) == m and len(f["open"]) == 2 * m, "the bounds of a box")
    require(len(f["factors"]) == len(f["powers"]) == len(f["signs"]), "the factors of a sign")
    constants = f["constant"] + [i for i in f["low"] + f["high"] if i >= 0]
    require(all(nodes[i][0] == "c" for i in constants), "a bound that is no number")
    names = [program.case["inputs"][nodes[i][1]][0] for i in x]
    number = lambda i: None if i < 0 else Fraction(v[i])
    box = [(number(a), number(b), f["open"][2 * k], f["open"][2 * k + 1]) for k, (a, b) in enumerate(zip(f["low"], f["high"]))]
    sign, cuts = (v[f["constant"][0]] > 0) - (v[f["constant"][0]] < 0), list(f["cuts"])
    require(sign != 0 or not (f["strict"] or f["factors"]), "the number 0")
    for i, e, s in zip(f["factors"], f["powers"], f["signs"]):
        if s == 0:
            require(e % 2 == 0 and not (f["strict"] and e > 0), "a factor without a sign")
            continue
        top, bottom = fraction_text(names[x.index(i)] if nodes[i][0] == "x" else nodes[i][1])
        require(nodes[i][0] in "xf" and bottom == [(1, {})] and all(set(q) <= set(names) for _, q in top), "a factor that is no polynomial")
        p = {}
        for c, powers in top:
            e_of = tuple(powers.get(name, 0) for name in names)
            p[e_of] = p.get(e_of, 0) + s * c
        require(has_sign(p, f["strict"] and e > 0, box, cuts, v), "the sign of a factor")
        sign *= s if e % 2 else 1
    require(not cuts and sign >= f["strict"], "the sign of a product")
    d, degrees = f["of"][0], program.degrees()
    require(degrees[d] is not None, "a sign of what is no rational function")
    bound = sum(degrees[d]) + sum(abs(e) * sum(degrees[i]) for i, e in zip(f["factors"], f["powers"]))
    for _, w in program.random_runs(bound):
        top, bottom = w[f["constant"][0]], w[d]
        for i, e in zip(f["factors"], f["powers"]):
            top, bottom = (top * w[i] ** e, bottom) if e > 0 else (top, bottom * w[i] ** -e)
        require((top - bottom) % PRIME == 0, "a product that is another function")
