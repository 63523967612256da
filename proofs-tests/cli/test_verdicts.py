"""What verdicts may say: the rules that hold for every entry of the ledger.

    python3 test_verdicts.py WHOLE-RUN REGISTER.json
"""
import json
import re
import sys
import unittest
from pathlib import Path

REGISTER_FILE = sys.argv.pop(2)
FOLDER = Path(sys.argv.pop(1))
LEDGER = json.loads((FOLDER / "report" / "ledger.json").read_text(encoding="utf-8"))["statements"]
RUNS = json.loads((FOLDER / "verify.json").read_text(encoding="utf-8"))["claims"]
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scripts"))
from register import load  # noqa: E402

# Of every condition those that are narrower, as the chapters declare.
WITHIN = {}
for index in (Path(__file__).resolve().parents[2] / "chapters").glob("*/index.md"):
    for narrow, wide in re.findall(r"^:within: (.*?) \| (.*)$", index.read_text(encoding="utf-8"), re.M):
        WITHIN.setdefault(wide, []).append(narrow)
BLOCKS = {s["id"]: s["has"] for s in load(REGISTER_FILE)["statements"]}
CLAIM_BLOCKS = {c["name"]: c["has"] for c in load(REGISTER_FILE)["claims"]}


def words_of(value):
    """The text of an option, which may stand once or several times."""
    return " ".join(value) if isinstance(value, list) else str(value)


def decided(row):
    """The words that are true, and how that is known: those printed, or where these fail those put in their place."""
    fails = row["as_printed"]["verdict"] == "fails"
    return (row["corrected"]["tex"], row["corrected"]) if fails else (row["printed_tex"], row["as_printed"])


def is_one_instance(finding):
    """Decided for what is stated once, and not argued from there to more."""
    phrases = finding["scope"].split("; ")
    return finding["argued_for"] == "" and all(re.match(r"(the stated|this|one) ", phrase) for phrase in phrases)


def first_clause(text):
    """What stands before the first colon, semicolon or full stop that is in no formula."""
    return re.match(r"(?:\$[^$]*\$|[^$])*?(?=[:;.](?:\s|$)|$)", text).group(0)


def as_read(text):
    """In one spelling, whether it is written in TeX or in the letters of a text."""
    for tex, letter in ((r"\le", "≤"), (r"\ge", "≥"), (r"\ne", "≠"), ("₀", "0"), ("₁", "1")):
        text = text.replace(tex, letter)
    return re.sub(r"[ $_]", "", text)


def is_told(condition, scope):
    """Whether the scope has the condition, or calls the data positive, which the condition asks."""
    positive = re.fullmatch(r"the (\w+) are positive", condition)
    return as_read(condition) in as_read(scope) or bool(positive and re.search(rf"all positive [^;]*\b{positive.group(1)}\b", scope))


DEGREES = {"linear": 1, "quadratic": 2, "cubic": 3, "quartic": 4, "quintic": 5, "sextic": 6}


def degrees_of(scope):
    """The lowest and the highest degree of a scope that begins with them, (2, 6) for "k = 3 to 7"; None where it does not."""
    found = re.match(r"(k|order|n|degree) (?:= )?(\d+)(?: to (\d+))?(?=;|,|$)", scope)
    if not found:
        return None
    letter, low, high = found.groups()
    less = letter in ("k", "order")
    return int(low) - less, int(high or low) - less


def degree_of_instance(block):
    """The one degree that the curve of a block has, by its order or the word for it, or else by the number of its weights or points; None where none
    of these is said, or several are."""
    given, data = words_of(block.get("given", "")), "; ".join(block.get("data", []))
    order = re.search(r"\$k=(\d+)\$|(?<!\w)k = (\d+)", given + "; " + data)
    said = {DEGREES[word] for word in re.findall(r"\b(?:" + "|".join(DEGREES) + r")\b", given)}
    if order or said:
        return int(order.group(1) or order.group(2)) - 1 if order else said.pop() if len(said) == 1 else None
    lists = re.findall(r"(?:^|; )[ωPR] = ([^;]*)", data)
    counts = {len(re.findall(r"\([^)]*\)|[^\s()]+", text)) for text in lists} - {1}
    return counts.pop() - 1 if len(counts) == 1 and "T = " not in data else None


def is_worked_number(text):
    """What is printed are numbers: an equation one side of which is a number other than 0, or begins with one."""
    return re.search(r"=\s*(?:\\frac|\[)?\s*[-(\[{]*\s*[\d.,]*[1-9]", text) is not None


class Scopes(unittest.TestCase):
    def test_one_instance_decides_no_general_words_unless_it_is_said_why(self):
        """`example` says why one instance is enough: that something can happen, or that a thing is the one that is printed."""
        for row in LEDGER:
            text, finding = decided(row)
            if row["as_printed"]["verdict"] in ("undecided", "open") or not is_one_instance(finding):
                continue
            with self.subTest(row["id"]):
                self.assertTrue(is_worked_number(text) or row["example"], f"{finding['scope']}: {text}")

    def test_one_degree_decides_nothing_printed_with_a_letter_for_it(self):
        for row in LEDGER:
            text, finding = decided(row)
            one = finding and re.match(r"([nk]) = (\d+)(?:;|$)", finding["scope"])
            if not one or finding["argued_for"] or row["as_printed"]["verdict"] in ("undecided", "open"):
                continue
            letter, number = one.groups()
            free = re.search(rf"(?<![A-Za-z\\]){letter}(?![A-Za-z])", text)
            with self.subTest(row["id"]):
                self.assertTrue(not free or re.search(rf"{letter}\s*=\s*{number}\b", text), f"{finding['scope']}: {text}")

    def test_an_example_is_one_instance(self):
        for row in LEDGER:
            with self.subTest(row["id"]):
                self.assertTrue(not row["example"] or is_one_instance(decided(row)[1]), decided(row)[1]["scope"])

    def test_a_scope_does_not_contradict_itself(self):
        """No instance stands beside a range, no interval of a letter beside every value of it, no argument beside itself."""
        for row in LEDGER:
            for finding in [row["as_printed"], row["corrected"] or {"scope": "", "evidence": "", "argued_for": ""}]:
                phrases = [p for p in finding["scope"].split("; ") if p]
                with self.subTest(row["id"]):
                    stated = [p for p in phrases if p.startswith("the stated ")]
                    several = len(finding.get("steps", [])) > 1
                    self.assertTrue(not stated or not several or not phrases[-1].startswith(("all ", "every ")), finding["scope"])
                    conditions = [p for p in phrases if p.startswith("where ")]
                    self.assertTrue("the stated instance" not in phrases or phrases == stated + conditions, finding["scope"])
                    for letter in re.findall(r"[<≤] (\w) [<≤]", finding["scope"]):
                        self.assertNotRegex(phrases[-1], rf"every (?:\w+(?:,| and) )*{letter}\b")
                    self.assertEqual(len(phrases), len(set(phrases)), finding["scope"])

    def test_what_hypotheses_ask_stands_in_the_scope(self):
        """"All weights" does not stand beside "positive weights are needed": the condition of every hypothesis is told, or every
        step has its own cases, and the hypotheses stand above them."""
        told = 0
        for row in LEDGER:
            printed, scope = row["as_printed"], decided(row)[1] and decided(row)[1]["scope"]
            for hypothesis in printed["hypotheses"] + printed["stated_hypotheses_needed"]:
                condition = first_clause(hypothesis["hypothesis"])
                with self.subTest(row["id"]):
                    if not scope or "each step for its own cases" in scope:
                        continue
                    self.assertTrue(any(is_told(one, scope) for one in [condition, *WITHIN.get(condition, [])]), f"{condition}: {scope}")
                    told += 1
        self.assertGreater(told, 150)

    def test_a_hypothesis_is_tried_within_the_scope(self):
        """That a statement about cubics needs a hypothesis is not shown by a line, unless it says of which degree the example is."""
        tried = 0
        for row in LEDGER:
            printed, finding = row["as_printed"], decided(row)[1]
            degrees = finding and not finding["argued_for"] and degrees_of(finding["scope"])
            for hypothesis in (printed["hypotheses"] + printed["stated_hypotheses_needed"]) if degrees else []:
                claim = (hypothesis.get("without_it") or {}).get("claim")
                degree = degree_of_instance(CLAIM_BLOCKS[claim]) if claim else None
                if degree is not None:
                    tried += 1
                    with self.subTest(row["id"], claim=claim):
                        told = re.search(rf"\$n={degree}\$|\$k={degree + 1}\$", hypothesis["hypothesis"])
                        self.assertTrue(told or degrees[0] <= degree <= degrees[1], f"degree {degree}: {finding['scope']}")
        self.assertGreater(tried, 50)
        self.assertEqual(degrees_of("k = 3 to 7; every t"), (2, 6))
        self.assertEqual(degrees_of("order 1; all knots"), (0, 0))
        self.assertIsNone(degrees_of("every n"))
        self.assertEqual(degree_of_instance({"given": "$k=2$, the knots $t_i$"}), 1)
        self.assertEqual(degree_of_instance({"given": "a curve of order $k$", "data": ["n = 5; k = 4"]}), 3)
        self.assertEqual(degree_of_instance({"given": "a curve", "data": ["R = (0,0) (1,2) (2,0); ω = 1 1 1", "t = 1/2"]}), 2)
        self.assertIsNone(degree_of_instance({"given": "a point", "data": ["R = (1/3,4/3)"]}))
        self.assertIsNone(degree_of_instance({"given": "a linear and a cubic curve"}))

    def test_the_one_degree_of_a_statement_is_visited(self):
        """A statement about degree 7 rests on no claim that is decided up to degree 4 and sampled in degree 7."""
        visited = 0
        for name, block in BLOCKS.items():
            for claim in [c for role in ("holds-by", "corrected-by", "checked-by") for c in words_of(block.get(role, "")).split()] if "degree" in block else []:
                found = re.match(r"(\d+)\.\.(\d+)", words_of(CLAIM_BLOCKS[claim].get("degrees", "")))
                if found:
                    visited += 1
                    with self.subTest(name, claim=claim):
                        self.assertTrue(int(found.group(1)) <= int(words_of(block["degree"])) <= int(found.group(2)), found.group(0))
        self.assertGreater(visited, 15)

    def test_a_condition_is_told_once(self):
        """Two conditions that differ by an index or a mark alone are one with two names, "t_0 and t_1 differ, and t_i and t_{i+1} do"."""
        told = 0
        for row in LEDGER:
            for finding in filter(None, [row["as_printed"], row["corrected"]]):
                conditions = re.findall(r"\bwhere (.*?)(?:; |$)", finding["scope"])
                alike = [re.sub(r"_(?:\{[^}]*\}|\\?\w)|\\(?:dot|ddot|mathbf|mathrm)\b|[′'$ {}]", "", one) for c in conditions for one in c.split(", and ")]
                told += len(alike) > 1
                with self.subTest(row["id"]):
                    self.assertEqual(len(alike), len(set(alike)), finding["scope"])
        self.assertGreater(told, 50)

    def test_an_argument_is_told_once(self):
        """What is argued for more cases was computed for some: "argued for n = 2 to 6; argued for every n" is never told."""
        for row in LEDGER:
            for finding in [row["as_printed"], row["corrected"]]:
                if finding and finding["argued_for"]:
                    with self.subTest(row["id"]):
                        phrases = finding["argued_for"].split("; ")
                        self.assertEqual(len(phrases), len(set(phrases)))

    def test_steps_that_are_apart_are_told_with_their_scopes(self):
        for row in LEDGER:
            for finding in [row["as_printed"], row["corrected"]]:
                if finding and "each step for its own cases" in finding["scope"]:
                    with self.subTest(row["id"]):
                        self.assertGreater(len(finding["steps"]), 1)
                        self.assertTrue(all(step["evidence"] != "none" for step in finding["steps"]))


class Sentences(unittest.TestCase):
    def test_numbers_are_not_compared_with_a_condition(self):
        """"Compared: whether it moves: -1 is negative" is no sentence: of numbers it is said what they are, of a condition that it fails."""
        told = 0
        for claim in RUNS:
            for run in claim["types"].values():
                shown = {value["name"]: value["value"] for value in run.get("shown", [])}
                if {"left", "negative"} & set(shown) and "compared" in shown:
                    told += 1
                    with self.subTest(claim["name"]):
                        self.assertNotRegex(shown["compared"], r"\bwhether\b")
        self.assertGreater(told, 150)


class Lemmas(unittest.TestCase):
    def test_what_a_method_leans_on_is_among_the_claims(self):
        """A claim that the method of another one names, to reach what it says, decides together with it."""
        leant = 0
        for name, block in BLOCKS.items():
            for role in ("holds-by", "corrected-by", "checked-by"):
                claims = words_of(block.get(role, "")).split()
                for claim in claims:
                    has = CLAIM_BLOCKS[claim]
                    for lemma in re.findall(r"`(\w+)`", words_of(has.get("method", "")) + words_of(has.get("argued", ""))):
                        if lemma in CLAIM_BLOCKS and lemma != claim:
                            with self.subTest(name, claim=claim):
                                self.assertIn(lemma, claims)
                            leant += 1
        self.assertGreater(leant, 80)

    def test_no_lemma_leans_on_itself(self):
        """Claims that lean on one another, however many are between, prove nothing."""
        lean = {name: {word for key in ("method", "argued") for word in re.findall(r"`(\w+)`", words_of(block.get(key, "")))} & set(CLAIM_BLOCKS)
                for name, block in CLAIM_BLOCKS.items()}
        self.assertGreater(sum(map(len, lean.values())), 30)
        while free := {name for name, on in lean.items() if not on & set(lean)}:
            lean = {name: on for name, on in lean.items() if name not in free}
        self.assertEqual(lean, {})

    def test_what_any_text_leans_on_is_among_the_claims(self):
        """Of an entry its note and every text of its options, of its claims all that is written in them: a claim that is named there to say that
        something is so belongs to the entry; not so where it lends its data alone, "the curves of ...".  A counterexample may be named to say what is
        not so; it stands where it is refuted."""
        statements, claims = load(REGISTER_FILE)["statements"], {c["name"]: c for c in load(REGISTER_FILE)["claims"]}
        plain, tried = {name for name, c in claims.items() if c["kind"] != "counterexample"}, 0
        for s in statements:
            own = {name for value in s["has"].values() for name in re.findall(r"\w+", words_of(value)) if name in claims}
            deciding = {name for role in ("holds-by", "refuted-by", "corrected-by", "checked-by") for name in words_of(s["has"].get(role, "")).split()}
            deciding |= {name for value in words_of(s["has"].get("reading", "")).split() for name in [value.strip("|")] if name in claims}
            blocks = [s, *(claims[c] for c in deciding & plain)]
            for text in [text for block in blocks for text in (block.get("note", ""), *map(words_of, block["has"].values()))]:
                for name in set(re.findall(r"`(\w+)`", re.sub(r"the (polygons|curves) of `\w+`", "", text))) & plain:
                    tried += 1
                    with self.subTest(s["id"]):
                        self.assertIn(name, own)
        self.assertGreater(tried, 150)  # the more of such sentences are left out, the fewer lean


class Readings(unittest.TestCase):
    def test_what_a_reading_leans_on_stands_with_it(self):
        """A claim that is named where a reading is told that holds, or in the method of one of its claims, decides the reading with it."""
        tried = 0
        for row in LEDGER:
            for reading in row["as_printed"]["readings"]:
                own = {reading.get("claim"), *reading.get("with", [])} - {None}
                texts = [json.dumps(reading, ensure_ascii=False), *(words_of(CLAIM_BLOCKS[claim].get(key, "")) for claim in own for key in ("method", "argued"))]
                for lemma in {name for text in texts for name in re.findall(r"`(\w+)`", text)} & set(CLAIM_BLOCKS):
                    if reading["outcome"] == "holds":
                        tried += 1
                        with self.subTest(row["id"], claim=reading["claim"]):
                            self.assertIn(lemma, own)
        self.assertGreater(tried, 20)

    def test_a_decided_reading_has_evidence(self):
        for row in LEDGER:
            for reading in row["as_printed"]["readings"]:
                with self.subTest(row["id"]):
                    self.assertEqual(reading["evidence"] == "none", reading["outcome"] == "not decided")
                    self.assertEqual(reading["evidence"] == "none", "claim" not in reading)

    def test_where_a_reading_fails_it_is_said_what_is_meant(self):
        for row in LEDGER:
            said = any(words["is"] == "meant" for words in row["as_printed"]["words"])
            fails = any(reading["outcome"] == "fails" for reading in row["as_printed"]["readings"])
            with self.subTest(row["id"]):
                self.assertTrue(said or not fails or row["as_printed"]["verdict"] == "undecided")
                self.assertEqual(said, "meant" in BLOCKS[row["id"]])


if __name__ == "__main__":
    unittest.main()
