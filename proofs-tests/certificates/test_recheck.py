"""Every certificate is rechecked, and recheck.py refuses certificates that were tampered with.

    test_recheck.py CAGD RECHECK WHOLE_RUN

WHOLE_RUN is the folder that whole_run.py wrote: a run over everything.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

WHOLE_RUN = pathlib.Path(sys.argv.pop(3)).resolve()
RECHECK = str(pathlib.Path(sys.argv.pop(2)).resolve())
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())


def recheck(folder):
    return subprocess.run([sys.executable, RECHECK, str(folder)], capture_output=True, text=True)


def certificate(name):
    """The text of a certificate of the run over everything."""
    return (WHOLE_RUN / "certificates" / name).read_text()


class Everything(unittest.TestCase):
    def test_nothing_is_wrong_and_most_is_rechecked(self):
        r = recheck(WHOLE_RUN / "certificates")
        self.assertEqual(r.returncode, 0, r.stdout[-2000:] + r.stderr)
        words = [line.partition(": ")[2].split(" (")[0] for line in r.stdout.splitlines()[:-1]]
        self.assertEqual(words.count("wrong"), 0)
        self.assertGreater(words.count("rechecked"), 9 * words.count("cannot recheck this kind"))

    def test_it_can_be_read_in_one_sitting(self):
        self.assertLessEqual(len(pathlib.Path(RECHECK).read_text().splitlines()), 600)


class Patterns(unittest.TestCase):
    def test_a_part_has_the_certificates_of_the_whole(self):
        """The claims of one statement, and one claim more."""
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([CAGD, "verify", "--certificates", folder, Tampered.STATEMENT_ID, Tampered.PROVED], check=True,
                           stdout=subprocess.DEVNULL)
            written = {str(p.relative_to(folder)): p.read_text() for p in pathlib.Path(folder).rglob("*.json")}
            r = recheck(folder)
        self.assertLessEqual({Tampered.STATEMENT, *map(claim, (Tampered.PROVED, Tampered.FAILS))}, set(written))
        for name, text in written.items():
            self.assertEqual(text, certificate(name), name)
        self.assertEqual((r.returncode, r.stderr), (0, ""), r.stdout)


def claim(name):
    return f"claims/{name}.json"


class Tampered(unittest.TestCase):
    """One statement with a claim that is proved, one with signs of coefficients, one with root counts, one that fails.
    The certificates are those of the run over everything, in which nothing is wrong."""

    def refuses(self, name, change):
        """After the change recheck.py says `wrong`.  A claim is rechecked by itself, a statement with its claims."""
        original = certificate(name)
        document = json.loads(original)
        texts = {claim(link["claim"]): certificate(claim(link["claim"])) for link in document.get("links", [])}
        changed = change(document)
        texts[name] = changed if isinstance(changed, str) else json.dumps(document)
        self.assertNotEqual(texts[name], json.dumps(json.loads(original)))
        with tempfile.TemporaryDirectory() as folder:
            for other, text in texts.items():
                place = pathlib.Path(folder) / other
                place.parent.mkdir(exist_ok=True)
                place.write_text(text)
            r = recheck(folder)
        self.assertEqual(r.returncode, 1, r.stdout + r.stderr)
        self.assertIn("wrong (", r.stdout)
        self.assertEqual(r.stderr, "")

    def last(self, steps, key, value=None):
        return next(s for s in reversed(steps) if key in s and (value is None or s[key] == value))

    def node(self, case, op):
        """The last node of this operation that some comparison stands on."""
        needed, stack = set(), [i for s in case["steps"] for i in s.get("same", [])]
        while stack:
            i = stack.pop()
            if i not in needed:
                needed.add(i)
                o, *a = case["nodes"][i]
                stack += [] if o in "xcof" else a
        return case["nodes"][max(i for i in needed if case["nodes"][i][0] == op)]

    PROVED, SIGNS, ROOTS = "elevation_keeps_rational_curve", "curve_points_are_convex_combinations", "roots_are_at_most_sign_changes"
    LINES, HULL = "designed_curves_cross_no_more", "curve_points_have_hull_certificates"
    WHOLE, MINORS = "third_way_closes_for_two_radii", "totally_positive_exactly_in_the_range"
    COST = "step_costs_additions_only"
    FAILS = "printed_second_derivative_of_quotient_is_wrong"
    STATEMENT, STATEMENT_ID = "wang-ch3/prop-3.2.4-step-2.json", "wang-ch3:prop-3.2.4-step-2"

    def tamper(self, name, change):
        self.refuses(claim(name), lambda d: change(d["cases"][0]))

    def test_programs(self):
        self.tamper(self.PROVED, lambda c: self.node(c, "*").__setitem__(0, "+"))
        self.tamper(self.PROVED, lambda c: self.node(c, "+").__setitem__(0, "-"))
        self.tamper(self.PROVED, lambda c: self.node(c, "/").__setitem__(1, 0))
        self.tamper(self.PROVED, lambda c: self.node(c, "c").__setitem__(1, "22/7"))
        self.tamper(self.PROVED, lambda c: self.node(c, "*").__setitem__(1, len(c["nodes"]) + 5))
        self.tamper(self.PROVED, lambda c: self.node(c, "*").__setitem__(0, "**"))
        self.tamper(self.PROVED, lambda c: self.last(c["steps"], "same")["same"].__setitem__(0, 0))
        self.tamper(self.PROVED, lambda c: self.last(c["steps"], "same")["same"].__setitem__(0, -1))

    def test_steps(self):
        self.tamper(self.PROVED, lambda c: self.last(c["steps"], "same").update(equal=False))
        self.tamper(self.PROVED, lambda c: c.pop("steps"))
        self.tamper(self.SIGNS, lambda c: self.last(c["steps"], "nonnegative").update(text="1"))
        self.tamper(self.SIGNS, lambda c: self.last(c["steps"], "nonnegative").update(sign=-1))

    def test_decisions(self):
        self.tamper(self.ROOTS, lambda c: (lambda f: f.update(distinct=f["distinct"] + 1))(self.last(c["steps"], "fact", "roots")))
        self.tamper(self.ROOTS, lambda c: (lambda f: f.update(counted=f["counted"] + 1))(self.last(c["steps"], "counted")))
        self.tamper(self.LINES, lambda c: (lambda f: f["is"].__setitem__(3, f["is"][3] + 1))(
            self.last(c["steps"], "fact", "curve_and_line")))
        self.tamper(self.HULL, lambda c: (lambda f: f["coefficients"].reverse())(self.last(c["steps"], "fact", "hull")))
        self.tamper(self.HULL, lambda c: (lambda f: f.update({"is": 0}))(self.last(c["steps"], "fact", "hull")))
        self.tamper(self.WHOLE, lambda c: (lambda f: f.update({"is": 1 - f["is"]}))(self.last(c["steps"], "fact", "whole")))
        self.tamper(self.MINORS, lambda c: (lambda f: f.update({"is": 1 - f["is"]}))(self.last(c["steps"], "fact", "minors")))
        for kind in ("additions", "multiplications", "shifts"):
            self.tamper(self.COST, lambda c: (lambda f: f.update({kind: f[kind] + 1}))(self.last(c["steps"], "fact", "operations")))

    def test_counterexamples(self):
        self.tamper(self.FAILS, lambda c: self.last(c["steps"], "same").update(equal=True))
        self.refuses(claim(self.FAILS), lambda d: d.update(outcome="holds"))

    def test_claims_and_statements(self):
        self.refuses(claim(self.ROOTS), lambda d: d.update(evidence="proved"))
        self.refuses(self.STATEMENT, lambda d: d.update(verdict="holds"))
        self.refuses(self.STATEMENT, lambda d: d.update(evidence="proved"))
        self.refuses(self.STATEMENT, lambda d: d["links"].append({"role": "holds-by", "claim": self.FAILS}))
        self.refuses(self.STATEMENT, lambda d: d["links"].append({"role": "holds-by", "claim": "no_such_claim"}))
        self.refuses(self.STATEMENT, lambda d: json.dumps(d)[:-20])


if __name__ == "__main__":
    unittest.main(verbosity=2)
