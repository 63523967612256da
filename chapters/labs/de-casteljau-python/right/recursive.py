def point(p, t):
    if len(p) == 1:
        return p[0]
    return point(p[:-1], t) + t * (point(p[1:], t) - point(p[:-1], t))


def split(p, t):
    n = len(p)
    return [point(p[:k + 1], t) for k in range(n)], [point(p[k:], t) for k in range(n)]
