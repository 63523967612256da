"""What a claim is given reaches its scope: what is positive, not 0, different, inside, in order.

    python3 test_conditions.py WHOLE-RUN REGISTER.json

A condition in `given` takes cases away.  So the scope of the claim tells it, by its phrases, its data ("all positive weights") or
its option `where`; and as the scope of a verdict is what those of its claims have in common, the verdict tells it, too.  Where
a condition takes no case away, the block says so and why: `:harmless: words of given | why`.  And the scope of a verdict says
nothing twice: no relation of numbers in it follows from the others.
"""
import json
import re
import sys
import unittest
from pathlib import Path

REGISTER_FILE = sys.argv.pop(2)
FOLDER = Path(sys.argv.pop(1))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scripts"))
from register import load  # noqa: E402

CLAIMS = json.loads((FOLDER / "verify.json").read_text(encoding="utf-8"))["claims"]
STATEMENTS = json.loads((FOLDER / "report/ledger.json").read_text(encoding="utf-8"))["statements"]
BLOCKS = {c["name"]: c["has"] for c in load(REGISTER_FILE)["claims"]}
# Letters that count: 0 <= i <= n says which sums and points there are.
COUNTING = set("hijklmnprNMKL") | {"mu", "rho", "nu"}
RELATION = r"(?:<|>|\\le(?![a-pr-z])|\\ge(?![a-pr-z])|≤|≥)"
NOT_ZERO = r"\\ne(?![a-pr-z])|≠|\bnot \$?0\b|\bnone of \w+(?: is)? \$?0|\bno zero|\bnot vanish|\bnonzero"
# What is asked, how it is written in `given`, and how a scope tells it.
WORDS = [
    ("positive", r"\bpositive\b", r"\bpositive\b|> ?0|0 ?<|\bone sign\b|\b0 ?≤"),
    ("negative", r"(?<!non)\bnegative\b", r"\bnegative\b|\bsigns?\b|<|>"),
    ("nonnegative", r"\bnonnegative\b|\bno negative\b", r"\bnonnegative\b|\bpositive\b|≤|≥|\\le|\\ge"),
    ("not 0", NOT_ZERO, NOT_ZERO + r"|\bno (?:weight|three|pair)\b|\bneither\b|\bis (?:not|invertible)\b|\bdifferent\b|\bpositive\b"),
    ("different", r"\bdifferent\b|\bdistinct\b", r"\bdifferent\b|\bdistinct\b|\bpattern|\bsimple\b|\bmultiplicit|<|" + NOT_ZERO),
    ("inside", r"\binside (?:the|a|an) (?:triangle|polygon|interval|span)\b|\binterior\b", r"\binside\b|<|\bpositive\b"),
    ("convex", r"\bconvex\b", r"\bconvex\b"),
    ("in order", r"\bincreas|\bdecreas|\bmonoton", r"\bincreas|\bdecreas|<|>|\bpositive\b"),
    ("in general position", r"\b(?:not|no|nor)\b[^,;.$]*\b(?:line|parallel|collinear|coplanar|plane)|\btrue triangle|\bregular\b",
     r"\b(?:line|parallel|collinear|coplanar|plane|triangle|regular)\b"),
]


def letters(relation):
    """The names in a relation, without indices, arguments and words of TeX that are no letters."""
    bare = re.sub(r"_(?:\{[^}]*\}|\\?\w+)|\^(?:\{[^}]*\}|\w)|\\(?:leq?|geq?|dots|frac|cdot|sum|prod|text|mathbf|mathrm|hat)(?![a-z])", " ", relation)
    return set(re.findall(r"\\?([A-Za-z]+)", bare))


def relations(text):
    """The formulas with an order relation that is not only one of numbers that count."""
    for formula in re.findall(r"\$[^$]*\$", text):
        for part in re.split(r",|\\q?quad|\\text", re.sub(r"_\{[^{}]*\}", " ", formula)):
            names = letters(part)
            if re.search(RELATION, part) and names - COUNTING:
                yield part.strip("$ "), names


GREEK = {"alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "varepsilon": "ε", "theta": "θ", "Delta": "Δ", "lambda": "λ", "mu": "μ",
         "rho": "ρ", "tau": "τ", "varphi": "φ", "omega": "ω", "pi": "π", "ne": "≠", "le": "≤", "ge": "≥"}
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹ᵐⁿᵏ", "-0123456789mnk")


def in_one_script(phrase):
    """A phrase of a scope, which may be TeX or print: δ = 2⁻ᵐ and $\\delta=2^{-m}$ are one."""
    phrase = re.sub(r"\\([A-Za-z]+) ?", lambda m: GREEK.get(m.group(1), m.group(0)), phrase.replace("$", ""))
    return re.sub(r"[\^{}\s]", "", phrase.translate(RAISED).replace(" and ", ","))


def smaller_first(phrase):
    """The relations of a phrase, "0 < t ≤ 1" as two of them, each with its smaller side first."""
    found = set()
    for part in in_one_script(phrase).split(","):
        side = re.split(r"([<>≤≥=≠])", part)
        for k in range(1, len(side) - 1, 2):
            a, sign, b = side[k - 1 : k + 2]
            found.add((b, {">": "<", "≥": "≤"}[sign], a) if sign in ">≥" else (a, sign, b))
    return found


def is_reached(a, b, known, strictly):
    """Whether a < b, or a ≤ b, by a chain of known relations."""
    seen, ahead = set(), [(a, False)]
    while ahead:
        place = ahead.pop()
        if place in seen:
            continue
        seen.add(place)
        at, strict = place
        if at == b and len(seen) > 1 and (strict or not strictly):
            return True
        ahead += [(q, strict or sign == "<") for p, sign, q in known if p == at and sign != "≠"]
        ahead += [(p, strict) for p, sign, q in known if q == at and sign == "="]
    return False


def follows(relation, known):
    a, sign, b = relation
    if relation in known or (sign in "=≠" and (b, sign, a) in known):
        return True
    return sign != "=" and any(is_reached(x, y, known, sign != "≤") for x, y in [(a, b), (b, a)][: 2 if sign == "≠" else 1])


def said_twice(scope):
    """The phrases of a scope whose relations follow from its other phrases; those in brackets are each for a step of its own."""
    phrases = re.split(r"; (?:where )?|, (?:and )?where |, and |^where ", re.sub(r"\bcases \((?:[^()]|\([^()]*\))*\)", "cases", scope))
    held = [smaller_first(phrase) for phrase in phrases]
    return [phrase for k, phrase in enumerate(phrases)
            if held[k] and all(follows(r, set().union(*held[:k], *held[k + 1 :])) for r in held[k])]


def is_told(names, scope):
    """Whether the scope has a relation of one of these letters, or calls what they stand for positive or in order."""
    greek = {"beta": "β", "tau": "τ", "lambda": "λ", "theta": "θ", "varepsilon": "ε", "alpha": "α", "omega": "ω", "delta": "δ",
             "gamma": "γ", "mu": "μ", "rho": "ρ", "varphi": "φ"}
    if re.search(r"\bpositive\b|\bincreasing\b|\binside\b", scope):
        return True
    for part in re.split(r"; |, ", scope):
        if re.search(RELATION + r"|\bfrom\b|\bevery \S+ below", part):
            told = {greek.get(name, name) for name in letters(part)} | set(re.findall(r"[α-ωΔ]", part)) | {n for n in "tuc" if n in part}
            if told & {greek.get(name, name) for name in names}:
                return True
    return False


def untold(given, scope):
    """The conditions in what is given that the scope does not tell."""
    given = re.sub(r"\b(?:distinct|different) (?:knots|gaps)\b", "knots", given)  # a pattern of knots is a phrase of the scope
    found = [f"{what}: {m.group(0)}" for what, asked, told in WORDS for m in [re.search(asked, given)] if m and not re.search(told, scope)]
    return found + [f"in order: {part}" for part, names in relations(given) if not is_told(names, scope)]


class Conditions(unittest.TestCase):
    def test_what_is_given_stands_in_the_scope_or_is_harmless(self):
        asked = 0
        for claim in CLAIMS:
            if claim["kind"] == "counterexample" or "data" in BLOCKS[claim["name"]]:
                continue  # an instance is what its block states
            given, scope = claim["given"], claim["scope"]
            for harmless in BLOCKS[claim["name"]].get("harmless", []):
                given = given.replace(harmless.split("|")[0].strip(), " ")
            asked += untold(claim["given"], "") != []
            with self.subTest(claim["name"]):
                self.assertEqual(untold(given, scope), [], f"{claim['given']}  [{scope}]")
        self.assertGreater(asked, 200)

    def test_what_is_harmless_would_else_be_a_condition(self):
        """No block excuses what nobody asks."""
        for claim in CLAIMS:
            for harmless in BLOCKS[claim["name"]].get("harmless", []):
                with self.subTest(claim["name"]):
                    given = claim["given"].replace(harmless.split("|")[0].strip(), " ")
                    self.assertNotEqual(untold(given, claim["scope"]), untold(claim["given"], claim["scope"]), harmless)

    def test_no_condition_is_said_twice(self):
        asked = 0
        for row in STATEMENTS:
            for scope in row["as_printed"]["scope"], (row["corrected"] or {}).get("scope"):
                asked += scope is not None and "where" in scope
                with self.subTest(row["id"]):
                    self.assertEqual(said_twice(scope or ""), [], scope)
        self.assertGreater(asked, 100)
        for scope in ("ε > 0; every point, where $\\varepsilon\\ne0$", "every number; δ = 2⁻ᵐ, where $\\delta=2^{-m}$", "a < t ≤ b; where $a<b$",
                      "where $a\\ne b$, and $a<b$", "0 < s < 1, where $s\\le1$"):
            self.assertNotEqual(said_twice(scope), [], scope)
        for scope in ("all points, where $a>0$, and $b>0$", "each step for its own cases (u ≥ 0 and a < t; u ≥ 0), where $x\\ne0$", "n = 2 to 5; 0 ≤ t ≤ 1",
                      "where $t\\ne0$, and $t\\ne1$", "0 < s < 1, where $s\\ne\\frac12$"):
            self.assertEqual(said_twice(scope), [], scope)

    def test_conditions_are_seen(self):
        for given, scope in (("positive weights", "all weights"), ("$t_0<t_1$, any $t$", "every t"), ("any $\\beta\\ne0$", "every β"),
                             ("a true triangle", "all points"), ("different nodes", "all data"), ("a point inside the triangle", "all points"),
                             ("a convex polygon", "n = 1 to 6; all points"), ("$s=0$ and not 0", "every s"), ("three weights, none of them 0", "all weights"), ("$c\\in(0,1)$, $\\lambda>0$", "every λ")):
            self.assertNotEqual(untold(given, scope), [], given)
        for given, scope in (("integers $0\\le i\\le n$", "every n"), ("positive weights", "all points, all positive weights"),
                             ("$t_0<t_1$", "every t, where $t_0<t_1$"), ("any $\\beta\\ne0$", "every β, where $\\beta\\ne0$")):
            self.assertEqual(untold(given, scope), [], given)


if __name__ == "__main__":
    unittest.main()
