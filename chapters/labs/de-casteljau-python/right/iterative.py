def triangle(p, t):
    rows = [list(p)]
    while len(rows[-1]) > 1:
        row = rows[-1]
        rows.append([(1 - t) * row[i] + t * row[i + 1] for i in range(len(row) - 1)])
    return rows


def point(p, t):
    b = list(p)
    for r in range(1, len(p)):
        for i in range(len(p) - r):
            b[i] = (1 - t) * b[i] + t * b[i + 1]
    return b[0]


def split(p, t):
    rows = triangle(p, t)
    left = [row[0] for row in rows]
    right = [row[-1] for row in reversed(rows)]
    return left, right
