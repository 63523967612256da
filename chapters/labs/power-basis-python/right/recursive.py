from fractions import Fraction
from functools import reduce


def product(a, b):
    out = [0] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            out[i + j] += x * y
    return out


def powers(p):
    """(1 - t) R(P0 ... Pn-1) + t R(P1 ... Pn)"""
    if len(p) == 1:
        return list(p)
    left, right = product([1, -1], powers(p[:-1])), product([0, 1], powers(p[1:]))
    return [x + y for x, y in zip(left, right)]


def blossom(a, ones):
    """Of the polynomial, at so many ones and zeros else."""
    n, out = len(a) - 1, 0
    for k, x in enumerate(a):
        share = reduce(lambda s, j: s * Fraction(ones - j, n - j), range(k), 1)
        out = out + share * x
    return out


def points(a):
    return [blossom(a, i) for i in range(len(a))]
