"""The formulas of the ledger, read from their print: the verdicts are those of the claims, which share nothing with the reader of TeX.

    python3 test_print.py CAGD WHOLE_RUN

chapters/*/print.md says how they are read.  A formula that the ledger has as false has to fail, one that it has as true to hold.  Where the
ledger has hypotheses to be added, the block says what comes out (`:expected:`), for it says which of them it supposes.
"""
import json
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
WHOLE_RUN = pathlib.Path(sys.argv.pop(1))
AT_LEAST = 150


class Print(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rows = json.loads((WHOLE_RUN / "report/ledger.json").read_text())["statements"]
        cls.ledger = {s["id"]: s["as_printed"]["verdict"] for s in rows}
        cls.told = {s["id"] for s in rows if s["read_from_print"]}
        cls.read = []
        cls.trouble = []
        for path in sorted((ROOT / "chapters").glob("*/print*.md")):
            r = subprocess.run([CAGD, "check", "--json", path], capture_output=True, text=True, timeout=600)
            if r.returncode not in (0, 1):
                cls.trouble.append(r.stderr)
                continue
            asked = re.findall(r"^:::\{printed\} (\S+)\n(.*?)^:::$", path.read_text(), re.M | re.S)
            cls.read += [(id, body, s) for (id, body), s in zip(asked, json.loads(r.stdout)["statements"])]

    def test_every_formula_can_be_read(self):
        self.assertEqual(self.trouble, [])

    def test_the_verdicts_are_those_of_the_ledger(self):
        for id, body, s in self.read:
            with self.subTest(entry=id):
                self.assertEqual(s["name"], id)
                expected = re.search(r"^:expected: (\w+)$", body, re.M)
                verdict = self.ledger[id]
                if verdict in ("holds", "fails"):
                    self.assertIsNone(expected, "the ledger says what comes out")
                    self.assertEqual(s["verdict"], verdict)
                else:
                    self.assertIsNotNone(expected, f"what comes out of what the ledger has as {verdict}?")
                    self.assertEqual(s["verdict"], expected.group(1))

    def test_the_ledger_tells_which_ones(self):
        self.assertEqual(self.told, {id for id, _, _ in self.read})
        r = subprocess.run([CAGD, "ledger", "--summary", "deng-zhang-2022:*"], capture_output=True, text=True, timeout=600)
        all, read = [sum(id.startswith("deng-zhang-2022:") for id in ids) for ids in (self.ledger, self.told)]
        self.assertIn(f"\n{read} of {all} statements are read from their print", r.stdout)

    def test_sums_for_every_number(self):
        """A range without end is proved, and the ledger counts the entries."""
        every = {id: s for id, body, s in self.read if re.search(r"^:for: .*\.\. *(,|$)", body, re.M)}
        for id, s in every.items():
            self.assertEqual((s["verdict"], s["evidence"]), ("holds", "proved"), id)
            self.assertIn("every", s["scope"], id)
            self.assertIn("telescoper", s, id)
        r = subprocess.run([CAGD, "ledger", "--summary", *every], capture_output=True, text=True, timeout=600)
        self.assertIn(f"\nof these a sum for every n, by creative telescoping: {len(every)}\n", r.stdout)
        self.assertGreaterEqual(len(every), 3)

    def test_there_are_many(self):
        decided = {id for id, _, s in self.read if s["verdict"] != "undecided"}
        self.assertGreaterEqual(len(decided), AT_LEAST)

    def test_no_formula_says_nothing(self):
        for id, _, s in self.read:
            if s["verdict"] == "holds":
                self.assertFalse(s.get("says_nothing"), id)


if __name__ == "__main__":
    unittest.main()
