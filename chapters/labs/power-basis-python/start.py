"""See README.md.  Any functions of your own may be added, and math, fractions, functools, itertools and operator imported."""


def powers(p):
    return [0 for _ in p]


def points(a):
    return [0 for _ in a]
