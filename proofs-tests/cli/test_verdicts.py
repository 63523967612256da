"""What verdicts may say: the rules that hold for every entry of the ledger.

    python3 test_verdicts.py WHOLE-RUN REGISTER.json
"""
import json
import re
import sys
import unittest
from pathlib import Path

REGISTER_FILE = sys.argv.pop(2)
LEDGER = json.loads((Path(sys.argv.pop(1)) / "report" / "ledger.json").read_text(encoding="utf-8"))["statements"]
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scripts"))
from register import load  # noqa: E402

BLOCKS = {s["id"]: s["has"] for s in load(REGISTER_FILE)["statements"]}


def decided(row):
    """The words that are true, and how that is known: those printed, or where these fail those put in their place."""
    fails = row["as_printed"]["verdict"] == "fails"
    return (row["corrected"]["tex"], row["corrected"]) if fails else (row["printed_tex"], row["as_printed"])


def is_one_instance(finding):
    """Decided for what is stated once, and not argued from there to more."""
    phrases = finding["scope"].split("; ")
    return finding["argued_for"] == "" and all(re.match(r"(the stated|this|one) ", phrase) for phrase in phrases)


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
                    self.assertTrue("the stated instance" not in phrases or phrases == stated, finding["scope"])
                    for letter in re.findall(r"[<≤] (\w) [<≤]", finding["scope"]):
                        self.assertNotRegex(phrases[-1], rf"every (?:\w+(?:,| and) )*{letter}\b")
                    self.assertEqual(len(phrases), len(set(phrases)), finding["scope"])

    def test_data_are_those_that_the_hypotheses_allow(self):
        """"All weights" does not stand beside "positive weights are needed"."""
        for row in LEDGER:
            printed = row["as_printed"]
            data = decided(row)[1]["scope"].split("; ")[-1]
            if (printed["hypotheses"] or printed["stated_hypotheses_needed"]) and data.startswith("all "):
                with self.subTest(row["id"]):
                    self.assertTrue(data.endswith(" that the hypotheses allow") or "all patterns" in data or "all multi" in data, data)

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


class Readings(unittest.TestCase):
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
