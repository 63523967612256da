"""See README.md.  Any functions of your own may be added, and math, fractions, functools, itertools and operator imported."""


def point(p, t):
    return 0


def split(p, t):
    return [0 for _ in p], [0 for _ in p]
