"""Every certificate is rechecked, and recheck.py refuses certificates that were tampered with.

    test_recheck.py CAGD RECHECK WHOLE_RUN

WHOLE_RUN is the folder that whole_run.py wrote: a run over everything.
"""
import copy
import fractions
import hashlib
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

WHOLE_RUN = pathlib.Path(sys.argv.pop(3)).resolve()
RECHECK = str(pathlib.Path(sys.argv.pop(2)).resolve())
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())


def recheck(folder, *more):
    return subprocess.run([sys.executable, RECHECK, str(folder), *more], capture_output=True, text=True)


def certificate(name):
    """The text of a certificate of the run over everything."""
    return (WHOLE_RUN / "certificates" / name).read_text()


class Everything(unittest.TestCase):
    def test_nothing_is_wrong_and_most_is_rechecked(self):
        r = recheck(WHOLE_RUN / "certificates")
        self.assertEqual(r.returncode, 3, r.stdout[-2000:] + r.stderr)
        words = [line.partition(": ")[2].split(" (")[0] for line in r.stdout.splitlines()[:-1]]
        self.assertEqual(words.count("wrong"), 0)
        self.assertGreater(words.count("rechecked"), 9 * words.count("cannot recheck this kind"))

    def test_what_cannot_be_rechecked_stands_on_the_front_page(self):
        r = recheck(WHOLE_RUN / "certificates")
        cannot = {name for name, _, word in (line.partition(": ") for line in r.stdout.splitlines()) if word.startswith("cannot recheck")}
        text = pathlib.Path(RECHECK).parents[1].joinpath("README.md").read_text()
        paragraph = re.search(r"Of (\d+) statements it cannot say more(.*?)\n\n(?!\*)", text, re.S)
        self.assertEqual(set(re.findall(r"`([a-z0-9-]+:[^`]+)`", paragraph[2])), cannot)
        self.assertEqual(int(paragraph[1]), len(cannot))

    def test_it_can_be_read_in_one_sitting(self):
        files = [pathlib.Path(RECHECK), pathlib.Path(RECHECK).with_name("recheck_format.py")]
        self.assertLessEqual(sum(len(file.read_text().splitlines()) for file in files), 800)
        self.assertLessEqual(len(pathlib.Path(RECHECK).with_name("recheck_formula.py").read_text().splitlines()), 150)

    def test_conditions_follow_from_their_facts(self):
        """By their formulas, each counted once, for some claims have thousands of cases; those with variables of the program are counted."""
        r = recheck(WHOLE_RUN / "certificates")
        known, every = map(int, re.search(r"evaluated by their formulas, (\d+) of (\d+) different ones", r.stdout).groups())
        self.assertGreater(every, 300)
        self.assertGreater(5 * known, 2 * every)


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
            if name != "manifest.json":
                self.assertEqual(text, certificate(name), name)
        self.assertEqual(json.loads(written["manifest.json"]), manifest(written))
        self.assertEqual((r.returncode, r.stderr), (0, ""), r.stdout)


def claim(name):
    return f"claims/{name}.json"


def manifest(names):
    """The entries of the manifest of the run over everything that these certificates have."""
    whole = json.loads((WHOLE_RUN / "certificates/manifest.json").read_text())
    statement = lambda s: s["statement"].replace(":", "/", 1) + ".json"
    return {"schema": whole["schema"], "claims": [c for c in whole["claims"] if claim(c["claim"]) in names],
            "statements": [s for s in whole["statements"] if statement(s) in names]}


def cases(document):
    """What a manifest says of the cases of a certificate that is what it seems; None when it is too strange for that."""
    try:
        return [{"type": c["type"], "degree": c["degree"], "inputs": len(c["inputs"]), "nodes": len(c["nodes"]),
                 "compared": sum("fact" not in s for s in c["steps"]), "facts": sum("fact" in s for s in c["steps"]),
                 "of_the_same": sum(c["nodes"][s["same"][0]] == c["nodes"][s["same"][1]] for s in c["steps"] if "same" in s)}
                for c in document["cases"]]
    except (KeyError, IndexError, TypeError):
        return None


def value(nodes, i):
    """Of a node that is a constant, or a difference of such."""
    op, *a = nodes[i]
    return fractions.Fraction(a[0]) if op == "c" else value(nodes, a[0]) - value(nodes, a[1])


class Tampered(unittest.TestCase):
    """One statement with a claim that is proved, one with signs of coefficients, one with root counts, one that fails.
    The certificates are those of the run over everything, in which nothing is wrong."""

    def refuses(self, name, change, fitting=True, hashed=True):
        """After the change recheck.py says `wrong`.  A claim is rechecked by itself, a statement with its claims.  The manifest is made
        to fit the changed certificate, so that what is refused is the certificate; unless `fitting` is false, and then it has its
        hash alone; nor that where `hashed` is false."""
        original = certificate(name)
        document = json.loads(original)
        texts = {claim(link["claim"]): certificate(claim(link["claim"])) for link in document.get("links", []) if "claim" in link}
        listed = manifest({name, *texts})
        changed = change(document)
        texts[name] = changed if isinstance(changed, str) else json.dumps(document)
        self.assertNotEqual(texts[name], json.dumps(json.loads(original)))
        for entry in listed["claims"] if fitting and not isinstance(changed, str) else []:
            if claim(entry["claim"]) == name:
                entry["certificate"] = cases(document) or entry["certificate"]
                entry["kind"] = document["kind"]
        for entry in listed["statements"] if fitting and "links" in document else []:
            entry["links"] = document["links"]
        for entry in [*listed["claims"], *listed["statements"]] if hashed else []:
            if name in (claim(entry.get("claim")), entry.get("statement", "").replace(":", "/", 1) + ".json"):
                entry["sha256"] = hashlib.sha256(texts[name].encode()).hexdigest()
        self.is_wrong(texts, listed)

    def is_wrong(self, texts, listed):
        with tempfile.TemporaryDirectory() as folder:
            for other, text in {**texts, "manifest.json": json.dumps(listed)}.items():
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

    FORMULA = "cubics_leave_the_plane_and_inflect"
    PROVED, SIGNS, ROOTS = "elevation_keeps_rational_curve", "curve_points_are_convex_combinations", "roots_are_at_most_sign_changes"
    LINES, HULL = "designed_curves_cross_no_more", "curve_points_have_hull_certificates"
    WHOLE, MINORS = "third_way_closes_for_two_radii", "totally_positive_exactly_in_the_range"
    SIGN, ROOTS_HALF = "weight_zero_hides_the_vertex", "roots_must_be_counted_up_to_one"
    COST, DEGREES = "step_costs_additions_only", "degree_of_the_equation_of_the_foot"
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

    def test_formats(self):
        """Words, keys and shapes that no certificate has."""
        both = self.STATEMENT, claim(self.ROOTS)
        for name in both:
            self.refuses(name, lambda d: d.update(schema="cagd-certificate-2"))
            self.refuses(name, lambda d: d.update(more=1))
            self.refuses(name, lambda d: d.pop("schema") and None)
            self.refuses(name, lambda d: d.update(evidence="certain"))
            self.refuses(name, lambda d: json.dumps(d)[:-1] + ',"evidence":"decided"}')
            self.refuses(name, lambda d: "[" + json.dumps(d) + "]")
        self.refuses(self.STATEMENT, lambda d: d.update(statement="wang-ch3:prop-3.2.5"))
        self.refuses(self.STATEMENT, lambda d: d.update(definition="no"))
        self.refuses(self.STATEMENT, lambda d: d["links"][0].update(role="shown-by"))
        self.refuses(self.STATEMENT, lambda d: d["links"][0].pop("claim") and None)
        self.refuses(self.STATEMENT, lambda d: d.update(links=[]))
        self.refuses(claim(self.ROOTS), lambda d: d.update(kind="theorem"))
        self.refuses(claim(self.ROOTS), lambda d: d.update(claim=self.HULL))
        self.refuses(claim(self.ROOTS), lambda d: d.update(cases=[]), fitting=False)
        self.tamper(self.ROOTS, lambda c: c.update(type="real"))
        self.tamper(self.ROOTS, lambda c: c.update(degree=-1))
        self.tamper(self.ROOTS, lambda c: c.update(steps=[]))
        self.tamper(self.PROVED, lambda c: c.update(type="rational"))
        self.tamper(self.ROOTS, lambda c: c["steps"].append({"fact": "prime", "of": [0, -1], "is": 1}))
        self.tamper(self.ROOTS, lambda c: c["steps"].append({"agree": 1}))
        self.tamper(self.ROOTS, lambda c: c["steps"].append({}))
        self.tamper(self.ROOTS, lambda c: c["steps"].append({"same": [0]}))
        self.tamper(self.ROOTS, lambda c: c["nodes"].append(["c"]))
        self.tamper(self.ROOTS, lambda c: c["nodes"].append(["sin", 0]))
        self.tamper(self.ROOTS, lambda c: c["nodes"].append([]))
        self.tamper(self.ROOTS, lambda c: c["inputs"].append(["t"]))

    def test_facts(self):
        def fact(name, kind, change):
            self.tamper(name, lambda c: change(self.last(c["steps"], "fact", kind)))
        for key in ("distinct", "counted", "crossings", "touches"):
            self.tamper(self.ROOTS, lambda c: self.last(c["steps"], key).update({key: -1}))
            self.tamper(self.ROOTS, lambda c: self.last(c["steps"], key).update({key: "1"}))
        fact(self.ROOTS, "roots", lambda f: f.pop("distinct") and None)
        fact(self.ROOTS, "roots", lambda f: f.update(with_ends=[2, 0]))
        fact(self.ROOTS, "roots", lambda f: f["from"].append(0))
        fact(self.COST, "operations", lambda f: f.update(out=[]))
        fact(self.COST, "operations", lambda f: f.update(out=[], additions=0, multiplications=0, shifts=0))
        fact(self.HULL, "hull", lambda f: f["x"].append(f["x"][0]))
        fact(self.HULL, "hull", lambda f: f["points"].append(f["points"][0]))
        fact(self.HULL, "hull", lambda f: f["coefficients"].append(f["coefficients"][0]))
        fact(self.HULL, "hull", lambda f: f.update(dim=0))
        fact(self.LINES, "curve_and_line", lambda f: f["line"].append(f["line"][0]))
        fact(self.LINES, "curve_and_line", lambda f: f["w"].append(f["w"][0]))
        fact(self.LINES, "curve_and_line", lambda f: f["is"].append(0))
        fact(self.MINORS, "minors", lambda f: f["A"].append(f["A"][0]))
        fact(self.MINORS, "minors", lambda f: f.update(strict=2))
        fact(self.MINORS, "minors", lambda f: f.update(rows=0, A=[]))
        fact(self.WHOLE, "whole", lambda f: f.update({"is": True}))
        fact(self.DEGREES, "degrees", lambda f: f["is"].__setitem__(0, f["is"][0] + 1))
        fact(self.DEGREES, "degrees", lambda f: f["is"].reverse())

    def test_intervals(self):
        """From right to left there is no interval, and a sign on none; one number is an interval with both of its ends alone."""
        def interval(name, kind, change):
            def on_last(c):
                f = self.last(c["steps"], "fact", kind)
                self.assertLess(*(value(c["nodes"], i) for i in f["from"]))
                change(f)
            self.tamper(name, on_last)
        for name, kind in ((self.SIGN, "sign"), (self.ROOTS_HALF, "roots")):
            interval(name, kind, lambda f: f["from"].reverse())
        interval(self.SIGN, "sign", lambda f: f.update({"from": 2 * f["from"][:1], "with_ends": [1, 0]}))
        self.tamper(self.WHOLE, lambda c: self.last(c["steps"], "fact", "whole")["of"].__setitem__(1, 0))
        self.tamper(self.WHOLE, lambda c: self.last(c["steps"], "fact", "whole")["of"].reverse())

    def test_what_is_nested_without_end(self):
        deep = 100000
        for name in (self.STATEMENT, claim(self.ROOTS)):
            self.refuses(name, lambda d: deep * "[" + deep * "]")
            self.refuses(name, lambda d: json.dumps(d)[:-1] + ',"more":' + deep * '{"a":' + "0" + deep * "}" + "}")
        for formula in (deep * "!" + "0", deep * "(" + "1" + deep * ")", deep * "1?" + "1" + deep * ":1"):
            self.tamper(self.FORMULA, lambda c: self.last(c["steps"], "formula").update(formula=formula))

    def test_formulas(self):
        """A condition is what its formula says of the facts before it."""
        def formula(name, change):
            def on_last(c):
                change(self.last(c["steps"], "formula"))
            self.tamper(name, on_last)
        name = self.FORMULA
        formula(name, lambda s: s.update(formula=f"!({s['formula']})"))
        formula(name, lambda s: s.pop("formula") and None)
        formula(name, lambda s: s.update(formula="0"))
        formula(name, lambda s: s.update(formula=1))
        formula(name, lambda s: s.update(formula="sturm_count_line(p) > 100"))
        self.tamper(self.PROVED, lambda c: c["steps"].append({"agree": True, "formula": "1"}))

    def test_what_is_bound(self):
        """Certificates that are right in themselves, and are not what the manifest says."""
        trivial = {"type": "field", "degree": 0, "inputs": [["t", "1/2"]], "nodes": [["x", 0]], "steps": [{"same": [0, 0], "equal": True}]}
        loose = lambda name, change: self.refuses(claim(name), change, fitting=False)
        loose(self.PROVED, lambda d: d.update(cases=[trivial]))
        loose(self.PROVED, lambda d: d.update(cases=d["cases"][:1] if len(d["cases"]) > 1 else []))
        loose(self.PROVED, lambda d: d["cases"].append(d["cases"][0]))
        loose(self.PROVED, lambda d: d["cases"][0].update(degree=d["cases"][0]["degree"] + 1))
        loose(self.PROVED, lambda d: d["cases"][0]["inputs"].append(["unused", "1/2"]))
        loose(self.PROVED, lambda d: d["cases"][0]["nodes"].append(["c", "1"]))
        loose(self.PROVED, lambda d: d["cases"][0]["steps"].append({"same": [0, 0], "equal": True}))
        loose(self.PROVED, lambda d: self.last(d["cases"][0]["steps"], "same").update(same=[0, 0]))
        loose(self.ROOTS, lambda d: d.update(evidence="sampled", kind="identity"))
        self.refuses(self.STATEMENT, lambda d: d["links"].pop() and None, fitting=False)
        self.refuses(self.STATEMENT, lambda d: d["links"].append({"role": "needs", "claim": self.PROVED}), fitting=False)
        self.refuses(self.STATEMENT, lambda d: d.update(definition=not d["definition"]), fitting=False)

    def test_numbers_names_and_facts(self):
        for text in (" 1/2", "1/2 ", "+1/2", "1_0", "0.5", "1e3", "1/", "/2", "", "½", "1/-2", "0x1"):
            self.tamper(self.ROOTS, lambda c: c["inputs"].append(["another", text]))
            self.tamper(self.PROVED, lambda c: self.node(c, "c").__setitem__(1, text))
        self.tamper(self.PROVED, lambda c: c["inputs"][1].__setitem__(0, c["inputs"][0][0]))
        for name in (self.ROOTS, self.HULL, self.COST, self.MINORS):
            steps = lambda d: d["cases"][0]["steps"]
            self.refuses(claim(name), lambda d: steps(d).remove(self.last(steps(d), "fact")), fitting=False)
            self.refuses(claim(name), lambda d: steps(d).append(self.last(steps(d), "fact")), fitting=False)

    def test_anything_else(self):
        """Sixty changes at random places, of which many leave a certificate of something true: of the claim that the manifest names it
        is none."""
        def change(document, rng):
            at = document
            while isinstance(at, (dict, list)) and at:
                parent, key = at, rng.choice(sorted(at) if isinstance(at, dict) else range(len(at)))
                at = parent[key]
            ways = [lambda: parent.__delitem__(key) if isinstance(parent, dict) else parent.pop(key),
                    lambda: parent.__setitem__(key, {int: lambda x: x + 1, bool: lambda x: not x, str: lambda x: x + "1"}.get(type(at), str)(at)),
                    lambda: parent.__setitem__(key, [copy.deepcopy(at)])]
            if isinstance(parent, list):
                ways += [lambda: parent.insert(key, copy.deepcopy(at)), lambda: parent.append(parent.pop(0) if len(parent) > 1 else at)]
            rng.choice(ways)()
        names = [claim(n) for n in (self.PROVED, self.SIGNS, self.ROOTS, self.LINES, self.HULL, self.WHOLE, self.MINORS, self.COST, self.FAILS)]
        for seed in range(60):
            rng, name = random.Random(seed), [*names, self.STATEMENT][seed % 10]
            while True:
                document = json.loads(certificate(name))
                change(document, rng)
                if document != json.loads(certificate(name)):
                    break
            with self.subTest(seed=seed, name=name):
                self.refuses(name, lambda _: json.dumps(document), fitting=False, hashed=False)

    def test_the_manifest(self):
        names = {claim(self.PROVED)}
        texts, listed = {name: certificate(name) for name in names}, manifest(names)
        self.is_wrong(texts, {**listed, "schema": "cagd-manifest-2"})
        self.is_wrong(texts, {**listed, "claims": []})
        self.is_wrong(texts, {**listed, "claims": 2 * listed["claims"]})
        self.is_wrong({}, listed)
        self.is_wrong(texts, manifest({*names, self.STATEMENT}))
        never = json.loads(json.dumps(listed))
        never["claims"][0]["types"] = [t for t in never["claims"][0]["types"] if t["type"] != "field"]
        self.is_wrong(texts, never)


if __name__ == "__main__":
    unittest.main(verbosity=2)
