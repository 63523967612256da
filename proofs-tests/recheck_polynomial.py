"""Polynomials in one variable and their real roots: in fractions, and modulo the prime 2^127 - 1."""
import functools, math
from fractions import Fraction
from itertools import zip_longest

PRIME = 2**127 - 1

class Wrong(Exception):
    """Something was computed again and is different, or the certificate makes no sense."""
class Cannot(Exception):
    """There is nothing here that can be computed again."""
def require(condition, what):
    if not condition:
        raise Wrong(what)

# ---- two fields -----------------------------------------------------------------------------------------
class Rationals:
    """Whole numbers are integers, which are faster, and the others fractions.  Of integers / makes a float: `quotient` divides."""
    reduce = staticmethod(lambda x: x if type(x) is int or x.denominator != 1 else x.numerator)
    number = staticmethod(functools.cache(lambda text: Rationals.reduce(Fraction(text))))
    quotient = staticmethod(lambda x, y: Rationals.reduce(Fraction(x, y)))
    @staticmethod
    def root(x, n):
        def whole_root(m):
            low, high = 0, 1 << (m.bit_length() // n + 1)
            while high - low > 1:
                middle = (low + high) // 2
                low, high = (middle, high) if middle**n <= m else (low, middle)
            require(low**n == m, "a root is not exact")
            return low
        require(x >= 0 and n >= 1, "a root of a negative number")
        return Fraction(whole_root(x.numerator), whole_root(x.denominator))
class Modular:
    number = staticmethod(functools.cache(lambda text: Modular.quotient(*Fraction(text).as_integer_ratio())))
    reduce = staticmethod(lambda x: x % PRIME)
    @staticmethod
    def quotient(x, y):
        if y % PRIME == 0:
            raise ZeroDivisionError
        return x * pow(y, -1, PRIME) % PRIME
    @staticmethod
    def root(x, n):
        raise Cannot("a root is no rational function")

# ---- polynomials: lists of coefficients, the constant one first, without leading zeros --------------------
def trim(a):
    while a and a[-1] == 0:
        a.pop()
    return a
def p_add(K, a, b, sign=1):
    return trim([K.reduce(x + sign * y) for x, y in zip_longest(a, b, fillvalue=0)])
def p_mul(K, a, b):
    c = [0] * max(len(a) + len(b) - 1, 0)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            c[i + j] = K.reduce(c[i + j] + x * y)
    return trim(c)
def p_divmod(K, a, b):
    require(b, "division by the zero polynomial")
    a, q, lead = list(a), [0] * max(len(a) - len(b) + 1, 0), K.quotient(1, b[-1])
    while len(a) >= len(b):
        f, shift = K.reduce(a[-1] * lead), len(a) - len(b)
        q[shift] = f
        for i, y in enumerate(b):
            a[i + shift] = K.reduce(a[i + shift] - f * y)
        trim(a)
    return trim(q), a
def whole(a):
    """A positive multiple of the numbers, in whole numbers without a common divisor."""
    common = math.lcm(*[x.denominator for x in a])
    a = [x.numerator * (common // x.denominator) for x in a]
    divisor = math.gcd(*a)
    return [x // divisor for x in a] if divisor > 1 else a
def remainder(a, b):
    """A positive multiple of the remainder of rational polynomials, found without leaving the whole numbers."""
    a, b = whole(a), whole(b)
    while len(a) >= len(b):
        f, shift = a[-1] if b[-1] > 0 else -a[-1], len(a) - len(b)
        a = [abs(b[-1]) * x for x in a]
        for i, y in enumerate(b):
            a[i + shift] -= f * y
        trim(a)
    return whole(a)
def p_gcd(K, a, b):
    while b:
        a, b = b, remainder(a, b) if K is Rationals else p_divmod(K, a, b)[1]
    return [K.quotient(x, a[-1]) for x in a]
def p_value(K, a, t):
    v = 0
    for c in reversed(a):
        v = K.reduce(v * t + c)
    return v
def p_compose(K, a, b):
    r = []
    for c in reversed(a):
        r = p_add(K, p_mul(K, r, b), trim([c]))
    return r
def p_derivative(K, a):
    return trim([K.reduce(k * c) for k, c in enumerate(a)][1:])
def p_bernstein(K, b):
    """The coefficient of t^k in sum b_i C(n,i) t^i (1-t)^(n-i) is C(n,k) times the k-th difference of the b_i."""
    difference = lambda k: sum((-1) ** (k - i) * math.comb(k, i) * b[i] for i in range(k + 1))
    return trim([K.reduce(math.comb(len(b) - 1, k) * difference(k)) for k in range(len(b))])
def bernstein_coefficient(K, p, a, b, n, k):
    """The k-th of n+1 coefficients over [a,b]: with q(s) = p(a + (b-a) s) = sum q_j s^j it is sum_j C(k,j)/C(n,j) q_j."""
    q = p_compose(K, p, trim([a, K.reduce(b - a)]))
    require(len(q) <= n + 1, "a Bernstein form of too low a degree")
    return K.reduce(sum(K.number(Fraction(math.comb(k, j), math.comb(n, j))) * c for j, c in enumerate(q[: k + 1])))

# ---- real roots ----------------------------------------------------------------------------------------
Q = Rationals
def squarefree(p):
    """Yun: [(factor, multiplicity)], in whole numbers."""
    slope = p_derivative(Q, p)
    c = whole(p_gcd(Q, p, slope))
    w, y, m, out = p_divmod(Q, p, c)[0], p_divmod(Q, slope, c)[0], 1, []
    while len(w) > 1:
        z = p_add(Q, y, p_derivative(Q, w), -1)
        g = whole(p_gcd(Q, w, z))
        if len(g) > 1:
            out.append((g, m))
        w, y, m = p_divmod(Q, w, g)[0], p_divmod(Q, z, g)[0], m + 1
    return out
@functools.lru_cache(64)
def sturm_chain(p):
    chain = [list(p), p_derivative(Q, p)]
    while chain[-1]:
        chain.append([-c for c in remainder(chain[-2], chain[-1])])
    return chain[:-1]
def sturm_inside(p, a, b):
    """Different roots in (a,b), a < b or None for infinity; p squarefree."""
    chain = sturm_chain(tuple(p))
    def changes(t, side):
        values = [p_value(Q, f, t) if t is not None else f[-1] * (side if len(f) % 2 == 0 else 1) for f in chain]
        signs = [x > 0 for x in values if x != 0]
        return sum(x != y for x, y in zip(signs, signs[1:]))
    count = changes(a, -1) - changes(b, 1)
    return count - (b is not None and p_value(Q, p, b) == 0)
def count_roots(p, a, b, left, right):
    require(p and (a is None or b is None or a <= b), "roots of the zero polynomial, or from right to left")
    total = {"distinct": 0, "counted": 0, "crossings": 0, "touches": 0}
    for f, m in squarefree(p):
        inside = sturm_inside(f, a, b) if a is None or b is None or a < b else 0
        ends = (left and a is not None and p_value(Q, f, a) == 0) + (
            right and b is not None and b != a and p_value(Q, f, b) == 0)
        if a is not None and a == b and not (left and right):
            ends = 0
        total["distinct"] += inside + ends
        total["counted"] += m * (inside + ends)
        total["crossings" if m % 2 else "touches"] += inside
    return total
