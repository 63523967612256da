"""Numbers in the prose of a claim are those of its data and results.

    python3 test_numbers.py REGISTER.json        the test
    python3 test_numbers.py REGISTER.json list   the numbers that nothing carries, one a line

A claim's block owns its data: what its given, let, then, method, control and title say in numbers stands in data, instead or
result, which the body asks for by name and compares with.  A number in prose that no entry carries can be changed without
anybody noticing.  Not counted: 0, 1 and 2, indices and exponents, numbers of formulas, theorems and sections of the sources,
and the bounds of :degrees:.  numbers-in-prose.txt lists what is left, each with the reason.
"""
import pathlib
import re
import sys
import unittest
from fractions import Fraction

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "scripts"))
from register import load  # noqa: E402

ALLOWED = pathlib.Path(__file__).with_name("numbers-in-prose.txt")
PROSE = ("title", "given", "let", "then", "method", "control")

NOT_DATA = [
    r"`[^`]*`",                                                     # names of claims and files
    r"(?:[Tt]heorem|[Ll]emma|[Cc]orollary|[Ff]ormula|[Aa]lgorithm|[Ss]ection|[Pp]roperty|[Ff]igure|[Tt]able|[Dd]efinition|"
    r"[Cc]hapter|[Pp]roposition|§|step|steps|Eq\.?|equation|level|order|item|line) ?\(?\d+(?:[.-]\d+)*",
    r"\(\d+(?:[.-]\d+)+(?:[a-z]|'|′)?\)",                          # (3.2.4), (1-4-4)
    r"[_^](?:\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|-?\d|\\frac\d\d)",   # indices and exponents
]
NUMBER = re.compile(
    r"\\[td]?frac\s*(\d)\s*(\d)|\\[td]?frac\s*(\d)\s*\{(\d+)\}|\\[td]?frac\s*\{(\d+)\}\s*\{(\d+)\}|\\[td]?frac\s*\{(\d+)\}\s*(\d)"
    r"|(?<![\w.])(\d+)/(\d+)(?![\w.])|(\d+\.\d+)|(?<![a-zA-Z_\d.])(\d+)(?!\d*\.\d)")


def numbers(text):
    """The numbers of the prose, as fractions, with the text they are written in."""
    for pattern in NOT_DATA:
        text = re.sub(pattern, " ", text)
    for m in NUMBER.finditer(text):
        g = [x for x in m.groups() if x is not None]
        yield (Fraction(g[0]) if len(g) == 1 else Fraction(int(g[0]), int(g[1]) or 1)), m.group(0)


def value(text):
    """The size of the number as it is written in a block, or None."""
    try:
        return abs(Fraction(text))
    except ValueError:
        pass
    try:
        return abs(Fraction(float.fromhex(text)))
    except ValueError:
        return None


def carried(claim):
    known = {Fraction(0), Fraction(1), Fraction(2)}
    for entry in claim["data"]:
        if entry["columns"] == 0:
            known.update(abs(n) for n, _ in numbers(entry["values"][0]))
            known.update(Fraction(n) for n in re.findall(r"\d+", entry["values"][0]))
        known.update(v for v in map(value, entry["values"]) if v is not None)
    for key, text in claim["options"]:
        if key == "degrees":
            known.update(Fraction(n) for n in re.findall(r"\d+", text))
    return known


def uncarried(claim):
    known = carried(claim)
    for key, text in claim["options"]:
        if key in PROSE:
            for n, written in numbers(text):
                if n not in known:
                    yield key, n, written


def allowed():
    found = {}
    for line in ALLOWED.read_text(encoding="utf-8").splitlines():
        if line.strip() and not line.startswith("#"):
            name, listed, reason = [part.strip() for part in line.split("|")]
            found[name] = ({Fraction(n) for n in listed.split()}, reason)
    return found


REGISTER = load(sys.argv[1])
CLAIMS = [c for c in REGISTER["claims"] if c["kind"] == "counterexample" or c["data"]]


class Numbers(unittest.TestCase):
    def test_every_number_is_carried(self):
        exceptions = allowed()
        for claim in CLAIMS:
            left = {n for _, n, _ in uncarried(claim)} - exceptions.get(claim["name"], (set(), ""))[0]
            self.assertEqual(left, set(), f"{claim['file']}:{claim['line']}: numbers that no data or result carries")

    def test_exceptions_are_needed(self):
        by_name = {c["name"]: c for c in CLAIMS}
        for name, (listed, reason) in allowed().items():
            self.assertIn(name, by_name)
            self.assertTrue(reason, f"{name} has no reason")
            self.assertEqual(listed - {n for _, n, _ in uncarried(by_name[name])}, set(), f"{name}: no longer needed")

    def test_counterexamples_have_data(self):
        for claim in CLAIMS:
            if claim["kind"] == "counterexample":
                self.assertTrue(claim["data"], f"{claim['file']}:{claim['line']}: a counterexample without data")

    def test_reading_of_numbers(self):
        for text, expected in (
            (r"$\frac12$ and $\frac{10}3$", [(1, 2), (10, 3)]), (r"$x_{12}^3+4$, $t^{10}$", [(4, 1)]),
            (r"by (3.2.4) and theorem 4.1.1, $-7$", [(7, 1)]), (r"$(1/8,0.35)$", [(1, 8), (7, 20)]),
            (r"$R_0=(0,5)$, $2^{-52}$, $8s^3$", [(0, 1), (5, 1), (2, 1), (8, 1)]), (r"`claim_3` $\tfrac{1}{12}$", [(1, 12)])):
            self.assertEqual([n for n, _ in numbers(text)], [Fraction(*p) for p in expected], text)


if __name__ == "__main__":
    if sys.argv[2:] == ["list"]:
        for c in CLAIMS:
            for key, _, written in uncarried(c):
                print(f"{c['file']}:{c['line']}: {c['name']}: {key}: {written}")
        sys.exit(0)
    sys.argv.pop(1)
    unittest.main(verbosity=2)
