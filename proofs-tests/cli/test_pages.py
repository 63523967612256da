"""The pages of `cagd show` as they are read: their width, their matrices, what they say first.

    python3 test_pages.py CAGD REGISTER.json
"""
import os
import random
import re
import subprocess
import sys
import unicodedata
import unittest
from pathlib import Path

REGISTER_FILE = sys.argv.pop(2)
CAGD = str(Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "scripts"))
from register import load, words  # noqa: E402

REGISTER = load(REGISTER_FILE)
# Statements whose claims take longer than a page is worth here.
SLOW = {"wang-ch3:thm-3.4.1", "wang-ch3:thm-3.4.3", "wang-ch4:thm-4.4.3"}


def columns(line):
    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in line)


def show(*ids, width=92):
    r = subprocess.run([CAGD, "show", *ids], capture_output=True, text=True, env={**os.environ, "COLUMNS": str(width)})
    assert r.returncode == 0, r.stderr
    return r.stdout


class Width(unittest.TestCase):
    def test_no_line_is_wider_than_the_page(self):
        ids = [s["id"] for s in REGISTER["statements"] if s["id"] not in SLOW]
        some = random.Random(1).sample(ids, 60) + [claim["name"] for claim in random.Random(2).sample(REGISTER["claims"], 20)]
        for width in (60, 80):
            for line in show("--numbers", *some, width=width).splitlines():
                # A name without a blank, such as a file's, is longer than some lines are.
                self.assertTrue(columns(line) <= width or " " not in line.strip(), f"{width}: {columns(line)}: {line}")

    def test_a_page_is_at_least_forty_and_at_most_ninety_two_columns_wide(self):
        self.assertEqual(show("wang-ch3:3.2.8", width=10), show("wang-ch3:3.2.8", width=40))
        self.assertEqual(show("wang-ch3:3.2.8", width=500), show("wang-ch3:3.2.8"))


class Alone(unittest.TestCase):
    """A page is read on its own: what stands before it in its section is not on it."""
    ELSEWHERE = re.compile(r"\b[Aa]s (before|above)[.;,]|^As (before|above)|\b(last|next) (two |three )?claims?\b")

    def test_no_text_of_a_page_points_to_its_neighbours(self):
        self.assertRegex("For three points this is argued from the last two claims.", self.ELSEWHERE)
        self.assertRegex("As before.", self.ELSEWHERE)
        for entry in REGISTER["statements"] + REGISTER["claims"]:
            texts = [entry.get("note", "")] + [text for key, text in entry["options"] if key in ("given", "let", "then", "method")]
            for text in texts:
                self.assertNotRegex(text, self.ELSEWHERE, entry.get("id", entry.get("name")))

    def test_what_is_stated_is_on_the_page(self):
        """A decision "for the stated instance" shows it, as a step or as what decides a reading."""
        self.assertIn("r²                   = 111/20", show("deng-zhang-2022:sec-6-better"))
        page = show("hu-1987:1-2-interference")
        self.assertIn("X        = (1/2, 0, 0)", page[page.index("What decides reading 1"):])


class Matrices(unittest.TestCase):
    def test_a_determinant_has_a_line_for_each_row(self):
        lines = show("hu-1987:1-4-torsion-first-determinant").splitlines()
        at = lines.index("Printed") + 1
        self.assertEqual([line.count("│") for line in lines[at:at + 3]], [4, 4, 4])
        left = [columns(line[:line.index("│")]) for line in lines[at:at + 3]]
        self.assertEqual(len(set(left)), 1, "its rows stand below each other")
        self.assertIn("= −12", lines[at + 1])
        self.assertNotIn("= −12", lines[at] + lines[at + 2])

    def test_the_rows_of_a_matrix_behind_a_label_stand_below_each_other(self):
        lines = show("wang-ch3:prop-3.2.7-step-1").splitlines()
        first = next(i for i, line in enumerate(lines) if "⎛" in line)
        self.assertRegex(lines[first], "^ *let ")
        for above, below in ("⎛⎝", "⎞⎠"):
            self.assertEqual(columns(lines[first + 1].split(below)[0]), columns(lines[first].split(above)[0]))

    def test_a_matrix_that_is_wider_than_the_page_stands_in_one_line(self):
        narrow = show("wang-ch3:3.5.3", width=40)
        self.assertNotIn("│", narrow)
        self.assertIn("|−l − x, 2ω(x₁ − x), l − x, 0;", " ".join(narrow.split()))

    def test_every_command_of_tex_is_known_to_a_terminal(self):
        """What is not known is printed by its name."""
        source = (Path(__file__).resolve().parents[2] / "cli/tex.c").read_text(encoding="utf-8")
        known = set(re.findall(r'{"([A-Za-z]+)", "', source)) | {"frac", "tfrac", "binom", "sqrt", "begin", "end"}
        for entry in REGISTER["statements"] + REGISTER["claims"]:
            texts = [entry.get("note", "")] + [text for key, text in entry["options"] if key not in ("data", "instead", "result")]
            for text in texts:
                used = set(re.findall(r"\\([A-Za-z]+)", text.replace("\\\\", " ")))
                self.assertLessEqual(used, known, entry.get("id", entry.get("name")))

    def test_an_index_is_told_from_what_follows(self):
        """Greek indices have no small letters: parentheses and blanks stand for them; a sign that begins a formula is not binary."""
        page = show("wang-ch4:formula-4.4.19", "wang-ch4:thm-4.4.3-step-inverse", "wang-ch4:formula-4.4.22-sym", "wang-ch3:3.1-A")
        for text in "g_(μi) = ((−1)^μ μ!)/(k − 1)!", "g*_(μi)t^μ/det G_(r,k,T)", "t_(i₁)⋯t_(iⱼ)", "both terms −2λ(x + y − 1)":
            self.assertIn(text, page)
        self.assertIn("r(t−) from the left and r(t+) from the right", " ".join(show("wang-ch4:thm-4.2.1").split()))
        self.assertIn("(wᵢ^[r](τ) − wᵢ^[r](t)) = ", show("wang-ch4:thm-4.3.3-difference"))
        self.assertIn("lim_(m→∞) A(Γₖ^(T)(Tₘ′)) = ⋂ᵢ₌₁^(+∞) A(", show("wang-ch4:thm-4.2.1-step-limit"))

    def test_no_mark_of_the_layout_is_printed(self):
        everything = show("hu-1987:1-3-5", "slides-ch4:3-bicubic", "wang-ch3:3.4.1", "slides-ch4:table-bezier", width=60)
        self.assertEqual(re.findall(r"[\x00-\x09\x0b-\x1f]", everything), [])


class Words(unittest.TestCase):
    def test_readings_say_first_what_is_true(self):
        page = show("wang-ch3:thm-3.3.2")
        verdict = page.split("\nVerdict\n")[1].split("\n\n")[0]
        self.assertEqual(" ".join(verdict.split()), 'True: "an envelope", a curve that in each of its points is touched by a member, wherever '
                         'R′ ≠ 0 (1). False: "the envelope", all points that satisfy the envelope condition, as the equality sign says '
                         '(2); all points that satisfy the envelope condition, for curves without inflections (3); all points that '
                         'satisfy the envelope condition, for r = 1 and curves with R′ × R′′ ≥ 0 (4).')
        self.assertTrue(verdict.strip().startswith('True: "an envelope", a curve'))
        ways = page.split("\nWays to read it\n")[1].split("\n\n")[0]
        self.assertEqual(re.findall(r"(?m)^     (\d+)  (true|false|open) ", ways), [("1", "true"), *((k, "false") for k in "234")])
        self.assertIn("Counterexample to reading 2", page)

    def test_a_reading_is_told_with_its_evidence(self):
        """As a claim that decides a statement is: by what, and for which cases."""
        ways = show("wang-ch4:cor-4.3.1-bezier").split("\nWays to read it\n")[1].split("\n\n")[0]
        found = [" ".join(way.split()) for way in re.split(r"(?m)^     \d+  ", ways)[1:]]
        self.assertRegex(found[0], r"^true .* proved for k = 2 to \d+; \(k-1\)-fold ends of the span; the distinct knots variables .*all weights and points")
        self.assertRegex(found[1], r"^true .* proved for k = 3 to \d+; ")
        self.assertRegex(found[2], r"^false .* decided by a counterexample$")

    def test_steps_are_told_with_evidence_of_their_own(self):
        """Where it is not that of the verdict; the verdict has what is common to them."""
        page = show("wang-ch4:lemma-4.2.1-step-induction").split("\nVerdict\n")[1]
        self.assertIn("each step for its own cases", " ".join(page.split("\n\n")[0].split()))
        steps = re.split(r"(?m)^    \d+   ", page.split("\nWhy\n")[1])[1:]
        computed = [" ".join(step.split()) for step in steps if "\n        given " in step]
        self.assertGreater(len(computed), 1)
        for step in computed:
            self.assertRegex(step, r"(An identity, proved for|A decision for) .*\. given ")
        alone = next(s["id"] for s in REGISTER["statements"] if "meant" not in s["has"] and "needs" not in s["has"] and
                     "hypothesis" not in s["has"] and len(" ".join(s["has"].get("holds-by", [])).split()) == 1)
        self.assertNotRegex(show(alone).split("\nWhy\n")[1], r"(?m)^    (An identity|A decision)(,|\.| for)")

    def test_what_fails_is_said_as_a_condition(self):
        page = show("wang-ch3:3.1.2-line-pairs")
        self.assertIn("    What fails: the common points are four.\n", page)
        self.assertRegex(page, r"    Without it:\n    given  the pair of the axes .*\n.*\n    then   only two of the four points exist\n")

    def test_a_counterexample_says_what_its_letters_are(self):
        """The sentence of its claim stands before its numbers, in each of the places where one is told."""
        pages = show("wang-ch3:3.1.2-line-pairs", "hu-1987:1-4-two-inflections", "wang-ch4:cor-4.3.1-bezier", "deng-zhang-2022:eq-20")
        told = re.findall(r"(?m)^(?:    Without it:|(?:Another c|C)ounterexample.*)\n(.*)", pages)
        self.assertGreater(len(told), 5)
        for line in told:
            self.assertRegex(line, "^    given  ")

    def test_readings_that_are_known_and_that_are_not(self):
        page = " ".join(show("deng-zhang-2022:fig-2").split())
        self.assertIn("Verdict True: that the order is that of β, with the printed functions (2); that the order is that of β, with the corrected functions "
                      "(`sec-2-properties`) (3). Not decided: that this order is from right to left (1). ", page)

    def test_every_undecided_verdict_begins_with_what_is_true(self):
        """Where something is; the words are those of a reading, and each reading is in the verdict once, with its number."""
        undecided = [s["id"] for s in REGISTER["statements"] if "reading" in s["has"]]
        tried = 0
        for page in show(*undecided).split("\n\n\n"):
            verdict = " ".join(page.split("\nVerdict\n")[1].split("\n\n")[0].split())
            if not re.match("True: |False: |Not decided: ", verdict):
                continue
            tried += 1
            states = re.findall(r"(?m)^    [ \d]\d  (true|false|open) ", page.split("\nWays to read it\n")[1].split("\n\n")[0])
            self.assertEqual(verdict.startswith("True: "), "true" in states, verdict)
            self.assertEqual(sorted(int(n) for n in re.findall(r" \((\d+)\)[.;]", verdict)), list(range(1, len(states) + 1)), verdict)
        self.assertGreater(tried, 20)

    def test_a_definition_is_checked(self):
        page = show("wang-ch4:formula-4.4.19")
        self.assertIn("A definition, with what is checked of it: proved for k = 1 to 7; all knots.", page)
        self.assertIn("\nWhat is checked\n    An identity checks it.\n", page)

    def test_a_comparison_is_a_sentence(self):
        page = show("hu-1987:1-4-torsion-first-determinant")
        self.assertIn("Compared: the determinant, and -12 (A,B,C): 0 and 12 are not equal.", page)
        for word in ("compared ", "left ", "right ", "negative "):
            self.assertNotRegex(page, rf"(?m)^    {word} *= ")

    def test_steps_are_numbered_and_named(self):
        named = {s["id"]: [w for key, text in s["options"] if key == "holds-by" for w in text.split()] for s in REGISTER["statements"]}
        several = next(s for s in sorted(named) if len(named[s]) > 2)
        page = show(several).split("\nWhy\n")[1]
        steps = re.split(r"(?m)^    (\d+)   (?=\S)", page.split("\nCorrected\n")[0].split("\nRemarks\n")[0])
        self.assertEqual(steps[1::2][:len(named[several])], [str(k + 1) for k in range(len(named[several]))])
        for step in steps[2::2]:
            self.assertRegex(step, r"(?m)^        (An identity|A decision)[,. ]|^(An argument|Cited)")
        self.assertIn(" decide it together.", page.split("\n\n")[0])

    def test_a_step_names_another_by_its_number(self):
        claims = {c["name"] for c in REGISTER["claims"]}
        leaning = [s["id"] for s in REGISTER["statements"] if len(words(s, "holds-by")) > 1 and any(
            set(re.findall(r"`(\w+)`", " ".join(words(c, "method")))) & set(words(s, "holds-by"))
            for c in REGISTER["claims"] if c["name"] in words(s, "holds-by"))]
        self.assertGreater(len(leaning), 20)
        for name in sorted(set(leaning) - SLOW)[::12]:
            why = re.split("\n(?=[A-Z])", show(name).split("\nWhy\n")[1])[0]
            self.assertRegex(why, r"(?s)\bstep\s+[1-9]", name)
            self.assertEqual(set(re.findall(r"`(\w+)`", why)) & claims, set(), name)


class Tables(unittest.TestCase):
    def test_a_printed_table_is_one_page(self):
        entries = [s["id"] for s in REGISTER["statements"] if s["id"].startswith("slides-ch4:table-bezier-row-")]
        page = show("slides-ch4:table-bezier")
        self.assertEqual(len(re.findall(r"(?m)^    (?:holds|fails|conditional) ", page)), len(entries))
        self.assertIn("fails        x(0.35) = 2.248\n                 right: x(0.35) = 2.246\n", page)

    def test_every_row_belongs_to_a_table(self):
        for s in REGISTER["statements"]:
            if "-row-" in s["id"]:
                self.assertIn("A table of ", show(s["id"].split("-row-")[0]).splitlines()[0])


if __name__ == "__main__":
    unittest.main()
