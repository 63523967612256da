from math import comb


def point(p, t):
    n = len(p) - 1
    return sum(comb(n, i) * t ** i * (1 - t) ** (n - i) * p[i] for i in range(n + 1))


def split(p, t):
    left, right = [], []
    for k in range(len(p)):
        left.append(point(p[:k + 1], t))
        right.append(point(p[k:], t))
    return left, right
