from math import comb


def powers(p):
    n = len(p) - 1
    return [comb(n, k) * sum((-1) ** (k - i) * comb(k, i) * p[i] for i in range(k + 1)) for k in range(n + 1)]


def points(a):
    n = len(a) - 1
    return [sum(comb(i, k) / comb(n, k) * a[k] for k in range(i + 1)) for i in range(n + 1)]
