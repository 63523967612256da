"""How a condition combines facts: its formula, as it stands in C, evaluated on the facts that were noted before it.

A decision that is asked in a formula, sign_q(x) or hull_membership(d, n, P, x).inside, is the next fact of its kind, in the order in which
C asks them: && and || from the left, the right side only where it counts; operands of other operators in either order.  The facts that
a condition asks are the last ones before it.  fault(T, right, wrong) is what is printed in a counterexample, and right elsewhere.  A formula
with a name of another kind, such as a variable of the program, is not evaluated: its facts are checked one by one, and the program combines them."""
import re
IS = lambda fact: fact["is"]
COUNTS = {"contained": 0, "common_closed": 1, "common_open": 2, "crossings": 3, "touches": 4, "poles": 5, "jumps": 6}
PIECES = {"crossings": 0, "common_runs": 1, "components": 2, "contained_edges": 3}
SIGNS = ["SIGN_ZERO", "SIGN_POSITIVE", "SIGN_NONNEGATIVE", "SIGN_NONPOSITIVE", "SIGN_NEGATIVE", "SIGN_MIXED"]
# The decision: the kind of fact, and what of it is the answer, by the member of a structure or without one.
DECISIONS = {
    **{name: ("order", {"": IS}) for name in ("sign_q", "compare_q", "turn_2d")},
    **{name: ("equal", {"": IS}) for name in ("equal_q", "is_zero_q", "is_zero_f")},
    **{name: ("pequal", {"": IS}) for name in ("poly_equal", "poly_is_zero")},
    **{name: ("roots", {"": lambda fact: fact["distinct"]}) for name in ("sturm_count", "sturm_count_above", "sturm_count_below", "sturm_count_line")},
    **{name: ("minors", {"": IS}) for name in ("is_totally_nonnegative", "is_totally_positive", "all_minors_nonnegative")},
    **{name: ("roots", {field: lambda fact, field=field: fact[field] for field in ("distinct", "counted", "crossings", "touches")})
       for name in ("count_roots", "count_roots_above", "count_roots_below")},
    "is_whole_q": ("whole", {"": IS}), "poly_degree": ("degree", {"": IS}), "hull_membership": ("hull", {"inside": IS}),
    "sign_on": ("sign", {"": IS}), "is_nonnegative_on": ("sign", {"": lambda fact: int(SIGNS[fact["is"]] in SIGNS[:3])}),
    "polygon_is_convex": ("convex_polygon", {"": IS}), "polygon_crossings": ("polygon_and_line", {"": lambda fact: fact["is"][0]}),
    "polygon_meets_line": ("polygon_and_line", {name: lambda fact, k=k: fact["is"][k] for name, k in PIECES.items()}),
    "curve_meets_line": ("curve_and_line", {name: lambda fact, k=k: fact["is"][k] for name, k in COUNTS.items()}),
}
TOKEN = re.compile(r"\s*([A-Za-z_]\w*|[0-9]+|&&|\|\||[<>=!]=|[-+*<>!().,\[\]{}&|^%/?:~\"\\])")
LEVELS = [["||"], ["&&"], ["==", "!="], ["<", ">", "<=", ">="], ["+", "-"], ["*"]]
APPLY = {"==": lambda a, b: int(a == b), "!=": lambda a, b: int(a != b), "<": lambda a, b: int(a < b), ">": lambda a, b: int(a > b),
         "<=": lambda a, b: int(a <= b), ">=": lambda a, b: int(a >= b), "+": lambda a, b: a + b, "-": lambda a, b: a - b, "*": lambda a, b: a * b}
class Unknown(Exception):
    """Something else than decisions, whole numbers and operators."""
class Parser:
    """A tree: ("fact", kind, answer), ("told", kind, answer) of the fact before, ("number", n), ("!", tree), ("-", tree), (operator, left,
    right), ("?", condition, tree, tree)."""
    def __init__(self, text, faulty):
        self.tokens, at, text, self.faulty, self.orientation = [], 0, text.strip(), faulty, None
        while at < len(text):
            m = TOKEN.match(text, at)
            if not m:
                raise Unknown(text[at:])
            self.tokens.append(m[1])
            at = m.end()
        self.at = 0
    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else ""
    def take(self, token=None):
        found = self.peek()
        if not found or token not in (None, found):
            raise Unknown(found)
        self.at += 1
        return found
    def level(self, n=0):
        if n == len(LEVELS):
            return self.unary()
        tree = self.level(n + 1)
        while self.peek() in LEVELS[n]:
            tree = (self.take(), tree, self.level(n + 1))
        return tree
    def unary(self):
        if self.peek() in ("!", "-"):
            return (self.take(), self.unary())
        if self.peek() == "(":
            return (self.take(), self.up_to(")"))[1]
        word = self.take()
        if word == "G":  # G(is_zero)(x)
            word = (self.take("("), self.take() + "_q", self.take(")"))[1]
        if word.isdigit() or word in SIGNS:
            return ("number", int(word) if word.isdigit() else SIGNS.index(word))
        if word == "fault":
            found = (self.take("("), self.take("T"), self.take(","), self.up_to(","), self.up_to(")"))
            return found[4 if self.faulty else 3]
        if word == self.orientation:
            return ("told", "convex_polygon", lambda fact: fact["orientation"])
        if word not in DECISIONS:
            raise Unknown(word)
        self.arguments()
        if word == "polygon_is_convex" and self.tokens[self.at - 3] == "&": # its last argument, &orientation, is told by the fact as well
            self.orientation = self.tokens[self.at - 2]
        member = (self.take(), self.take())[1] if self.peek() == "." else ""
        kind, answers = DECISIONS[word]
        if member not in answers:
            raise Unknown(member)
        return ("fact", kind, answers[member])
    def arguments(self):
        """Passed over, unless something is decided in them."""
        self.take("(")
        depth = 1
        while depth > 0:
            token = self.take()
            depth += (token == "(") - (token == ")")
            if token in DECISIONS:
                raise Unknown(token)
    def up_to(self, end):
        tree = self.level()
        if self.peek() == "?":
            tree = (self.take(), tree, self.up_to(":"), self.up_to(end))
        elif end or self.peek():
            self.take(end)
        return tree
def values(tree, facts, at):
    """{(value, how many facts were asked up to there)}, for each order of operands that C leaves open."""
    op = tree[0]
    if op == "number":
        return {(tree[1], at)}
    if op == "fact":
        return {(tree[2](facts[at]), at + 1)} if at < len(facts) and facts[at]["fact"] == tree[1] else set()
    if op == "told":
        return {(tree[2](fact), at) for fact in [f for f in facts[:at] if f["fact"] == tree[1]][-1:]}
    if op == "?":
        return {found for x, to in values(tree[1], facts, at) for found in values(tree[2 if x else 3], facts, to)}
    if len(tree) == 2:
        return {(int(x == 0) if op == "!" else -x, to) for x, to in values(tree[1], facts, at)}
    found = set()
    if op in ("&&", "||"):
        for x, to in values(tree[1], facts, at):
            decided = (x != 0) == (op == "||")
            found |= {(int(x != 0), to)} if decided else {(int(y != 0), end) for y, end in values(tree[2], facts, to)}
        return found
    for first, second in ((1, 2), (2, 1)):
        for x, to in values(tree[first], facts, at):
            for y, end in values(tree[second], facts, to):
                found.add((APPLY[op](x, y) if first == 1 else APPLY[op](y, x), end))
    return found
def outcomes(formula, facts, faulty):
    """What the formula is on the facts, or where it does not ask so many on as many of the last ones as it does: a set, of two truth values
    where that depends on the order; None where it has names that are not known here."""
    try:
        tree = Parser(formula, faulty).up_to("")
    except Unknown:
        return None
    for k in range(len(facts)):
        found = {x != 0 for x, to in values(tree, facts, k) if to == len(facts)}
        if found:
            return found
    return set()
evaluated = [0, 0]  # conditions: by their formula, and all that have one
formulas = {}  # each of these formulas once: whether it is evaluated
def follows(step, facts, faulty):
    """Whether a condition is what its formula says of the facts before it; it has a formula where there are any.  Faulty is what a counterexample computes."""
    if not facts or "formula" not in step:
        return not facts and "formula" not in step
    found = outcomes(step["formula"], facts, faulty)
    formulas[step["formula"]] = found is not None
    evaluated[0] += found is not None
    evaluated[1] += 1
    return found is None or step["agree"] in found
def told():
    return (f"{evaluated[0]} of {evaluated[1]} conditions about facts evaluated by their formulas, {sum(formulas.values())} of {len(formulas)} different ones; "
            "in the others the program combines them")
