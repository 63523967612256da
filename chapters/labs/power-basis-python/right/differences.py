"""The forward differences of the points, and their sums."""


def powers(p):
    n = len(p) - 1
    row, out, binomial = list(p), [], 1
    for k in range(n + 1):
        out.append(binomial * row[0])
        row = [b - a for a, b in zip(row, row[1:])]
        binomial = binomial * (n - k) // (k + 1)
    return out


def points(a):
    n = len(a) - 1
    first, binomial = [], 1
    for k in range(n + 1):
        first.append(a[k] / binomial)
        binomial = binomial * (n - k) // (k + 1)
    out = []
    while first:
        out.append(first[0])
        first = [first[i] + first[i + 1] for i in range(len(first) - 1)]
    return out
