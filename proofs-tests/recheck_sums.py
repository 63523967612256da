"""Sums for every n, by creative telescoping.

    {"fact":"sum_for_every_n","n":x,"k":x,"by_n":[p,q],"by_k":[p,q],"ratio":[p,q],"R":[p,q],"a":[a_0,...,a_J],"first":F(from,0),"from":m,
     "left":[...],"right":[...],"rest":[...],"counts":[...],"factors":[...],"powers":[...],"is":1}

and with "by" = p > 1 and "beyond" = e, 0 <= e < p, of a sum over k = 0, ..., N, N = p n + e; without them N = n.

A term F(n,k) is given by F(n+1,k)/F(n,k) = by_n and F(n,k+1)/F(n,k) = by_k, numerator and denominator each, and by F(from,0).  With
S(n+1)/S(n) = ratio and S(from) = right[0] it is shown that sum F(n,k) over k = 0, ..., N is S(n) for every whole n >= from:

    a_0 F(n,k) + ... + a_J F(n+J,k) = G(n,k+1) - G(n,k),  G = R F           divided by F(n,k), an identity of rational functions
    R(n,0) = 0, and what the terms beyond k = N - 1 and G(n,N) leave is 0                                        identities in n
    a_0 S(n) + ... + a_J S(n+J) = 0                                           divided by S(n), an identity in n
    the sums and S agree for n = from, ..., from+J+1, and are left[i] and right[i], which the statement is, computed from its names
    the denominators of the four fractions and a_J are not 0 for n >= from, 0 <= k <= N: each is "rest", free of n and k, times so many
    ("counts") of the "factors" to the "powers", and of each of these, or of a coefficient that it has as a polynomial in one other variable,
    all coefficients have one sign, and one is left for n = k = from, when it is written in n - k and k - from, and likewise for each k < from; where
    k is in it and N is not n, with N in the place of n, and p from + e in that of from.

Identities are computed at random points modulo a prime, as those of programs are.  Names other than n and k are variables: what is 0 for
some of their values alone is no harm."""
import math
import recheck_format, recheck_formula

PRIME = 2**127 - 1
node, several, count = recheck_format.node, recheck_format.several, recheck_format.count
SHAPE = {
    "n": node, "k": node, **{name: several(node, 2) for name in ("by_n", "by_k", "ratio", "R")}, "a": several(node), "first": node, "from": count,
    "left": several(node), "right": several(node), "rest": several(node, 5), "counts": several(count, 5), "factors": several(node),
    "powers": several(recheck_format.positive), "is": lambda x: type(x) is int and x == 1}
recheck_format.FACTS["sum_for_every_n"] = [SHAPE, {**SHAPE, "by": recheck_format.positive, "beyond": count}]
recheck_formula.DECISIONS["sum_for_every_n"] = ("sum_for_every_n", {"": lambda fact: fact["is"]})

def shifted(p, x, by):
    """The polynomial {frozenset of (name, exponent): coefficient} with x + by in the place of x, by a number or a name."""
    out = {}
    for key, c in p.items():
        powers = dict(key)
        e = powers.pop(x, 0)
        for i in range(e + 1):
            new, factor = dict(powers), c * math.comb(e, i)
            new[x] = e - i
            if type(by) is str:
                new[by] = new.get(by, 0) + i
            else:
                factor *= by**i
            key_of = frozenset((name, m) for name, m in new.items() if m > 0)
            out[key_of] = out.get(key_of, 0) + factor
    return {key: c for key, c in out.items() if c != 0}
def at_number(p, x, value):
    """x is that number."""
    return {key: c for key, c in shifted(shifted(p, x, value), x, 0).items() if x not in dict(key)}
def coefficients(p, x):
    found = {}
    for key, c in p.items():
        found.setdefault(dict(key).get(x, 0), {})[frozenset(pair for pair in key if pair[0] != x)] = c
    return found.values()
def has_sign_of_constant(p, n, k):
    return len({c > 0 for c in p.values()}) == 1 and any(not {n, k} & set(dict(key)) for key in p)
def has_one_sign(p, n, k, first):
    low = all(has_sign_of_constant(at_number(shifted(p, n, first), k, j), n, k) for j in range(first))
    return low and has_sign_of_constant(shifted(shifted(shifted(p, k, first), n, first), n, k), n, k)
def by_last(p, n, by, beyond):
    """p times a power of `by`, with n = (N - beyond)/by and N in the place of n."""
    degree = max((dict(key).get(n, 0) for key in p), default=0)
    return shifted({key: c * by**(degree - dict(key).get(n, 0)) for key, c in p.items()}, n, -beyond)
def is_never_zero(p, n, k, first, by=1, beyond=0):
    if any(k in dict(key) for key in p):
        p, first = by_last(p, n, by, beyond), by * first + beyond
    names = {name for key in p for name, _ in key} - {n, k}
    return has_one_sign(p, n, k, first) or any(has_one_sign(c, n, k, first) for x in sorted(names) for c in coefficients(p, x))

def check(f, _, program, require, fraction_text, quotient):
    nodes, inputs, J, first = program.case["nodes"], program.case["inputs"], len(f["a"]) - 1, f["from"]
    by, beyond = f.get("by", 1), f.get("beyond", 0)
    require(beyond < by, "the end of a sum")
    require(all(nodes[i][0] == "x" for i in (f["n"], f["k"])) and f["n"] != f["k"], "the letters of a sum")
    n, k = (inputs[nodes[i][1]][0] for i in (f["n"], f["k"]))
    fractions = ("by_n", "by_k", "ratio", "R")
    told = [i for name in fractions for i in f[name]] + f["a"] + f["rest"] + f["factors"] + [f["first"]]
    require(all(nodes[i][0] in "fxc" for i in told), "a sum of what is no rational function")
    text = {i: fraction_text(inputs[nodes[i][1]][0] if nodes[i][0] == "x" else nodes[i][1]) for i in told}
    def polynomial(i):
        top, bottom = text[i]
        require(bottom == [(1, {})], "a polynomial with a denominator")
        out = {}
        for c, powers in top:
            key = frozenset(powers.items())
            out[key] = out.get(key, 0) + c
        return {key: c for key, c in out.items() if c != 0}
    free = lambda i: not {n, k} & {x for side in text[i] for _, powers in side for x in powers}
    require(free(f["first"]) and all(free(i) for i in f["rest"]) and len(f["left"]) == len(f["right"]) == J + 2, "the shape of a sum")
    require(sum(f["counts"]) == len(f["factors"]) == len(f["powers"]), "the factors of a sum")
    require(all(is_never_zero(polynomial(i), n, k, first, by, beyond) for i in f["factors"]), "a factor that can be 0")
    require(all(polynomial(i) for i in f["rest"]) and J >= 1, "a factor that is 0")
    for i in [i for name in fractions for i in f[name]] + f["a"]:
        polynomial(i)
    require(all(k not in powers for i in f["a"] + f["ratio"] for c, powers in text[i][0]), "a recurrence with k in it")
    degree = lambda i: max([sum(powers.values()) for side in text[i] for _, powers in side] + [1])
    at_rows = program.degrees()
    require(all(at_rows[i] is not None for i in f["left"] + f["right"]), "a side that is no rational function")
    bound = by ** 2 * (J + 4) ** 2 * (first + J + 4) ** 2 * sum(degree(i) for i in told) + max(sum(at_rows[i]) for i in f["left"] + f["right"])
    for point, w in program.random_runs(bound):
        value = dict(zip((name for name, _ in inputs), point))
        def at(i, **other):
            """The polynomial or fraction at the point, with other values for n and k."""
            here = {**value, **{{"n": n, "k": k}[letter]: x for letter, x in other.items()}}
            top, bottom = (sum(c * math.prod([pow(here[x], e, PRIME) for x, e in powers.items()]) for c, powers in side) for side in text[i])
            return quotient(top, bottom)
        ratio_of = lambda name, **other: quotient(at(f[name][0], **other), at(f[name][1], **other))
        N, K = value[n], value[k]
        def steps(m, k, j): # F(m+j,k)/F(m,k)
            return math.prod([ratio_of("by_n", n=m + i, k=k) for i in range(j)])
        left = sum(at(f["a"][j]) * steps(N, K, j) for j in range(J + 1))
        require((left - ratio_of("R", k=K + 1) * ratio_of("by_k") + ratio_of("R")) % PRIME == 0, "what does not telescope")
        require(ratio_of("R", k=0) % PRIME == 0, "what is left at the lower end of a sum")
        end = by * N + beyond
        rest = ratio_of("R", k=end)
        for j in range(J + 1):
            term = at(f["a"][j]) * steps(N, end, j)
            for i in range(by * j + 1):
                rest += term
                term *= ratio_of("by_k", n=N + j, k=end + i)
        require(rest % PRIME == 0, "what is left at the upper end of a sum")
        S = lambda j: math.prod([ratio_of("ratio", n=N + i) for i in range(j)])
        require(sum(at(f["a"][j]) * S(j) for j in range(J + 1)) % PRIME == 0, "a recurrence that the other side does not satisfy")
        start, right = at(f["first"]), w[f["right"][0]]
        for m in range(first, first + J + 2):
            term, total = start, 0
            for i in range(by * m + beyond + 1):
                total += term
                term *= ratio_of("by_k", n=m, k=i)
            require((total - w[f["left"][m - first]]) % PRIME == 0, "another sum than the statement's")
            require((right - w[f["right"][m - first]]) % PRIME == 0, "another value than the statement's")
            require((total - right) % PRIME == 0, "a first value of the sum")
            start, right = start * ratio_of("by_n", n=m, k=0) % PRIME, right * ratio_of("ratio", n=m) % PRIME
        place = 0
        for i, wanted in enumerate([f[name][1] for name in fractions] + [f["a"][J]]):
            product = at(f["rest"][i])
            for m in range(place, place + f["counts"][i]):
                product *= pow(at(f["factors"][m]), f["powers"][m], PRIME)
            place += f["counts"][i]
            require((product - at(wanted)) % PRIME == 0, "factors of another polynomial")
