"""cagd exactly as its users meet it: the page that explains it, every verdict, every mistake.

    python3 test_exactly.py CAGD ROOT
"""
import hashlib
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom
from fractions import Fraction as F

ROOT = pathlib.Path(sys.argv.pop(2)).resolve()
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
PAGE = ROOT / "exact/code/example/README.md"


def run(*args, **options):
    return subprocess.run([CAGD, "exactly", *map(str, args)], capture_output=True, text=True, timeout=300, **options)


class Exactly(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def harness(self, block, code="", name="code.c"):
        """A page with that block beside that code; run as JSON: the one verdict, and the exit code."""
        (self.folder / name).write_text(code)
        (self.folder / "page.md").write_text("# Text\n\n" + block)
        return self.folder / "page.md"

    def verdict(self, block, code="", name="code.c", *options):
        ran = run(self.harness(block, code, name), "--json", *options)
        self.assertIn(ran.returncode, (0, 1), ran.stderr)
        document = json.loads(ran.stdout)
        self.assertEqual(document["schema"], "cagd-exactly-1")
        (one,) = document["blocks"]
        self.assertEqual(ran.returncode, int(one["verdict"] in ("differs", "undecided")))
        return one

    def refused(self, block, words, code=""):
        ran = run(self.harness(block, code))
        self.assertEqual(ran.returncode, 2, ran.stdout)
        self.assertEqual(ran.stdout, "")
        self.assertIn(words, ran.stderr)
        self.assertEqual(len(ran.stderr.splitlines()), 1, ran.stderr)


class Page(Exactly):
    """What the page shows is what the program prints."""

    def test_transcripts(self):
        text = PAGE.read_text()
        shown = re.findall(r"^```\n(.*?)^```$", text, re.M | re.S)
        printed = run(PAGE)
        self.assertEqual(printed.returncode, 1, printed.stderr)
        self.assertGreaterEqual(len(shown), 3)
        for one in shown:
            self.assertIn(one, printed.stdout)

    def test_what_is_built_lies_below_tmpdir(self):
        ran = run(PAGE, env={**os.environ, "TMPDIR": str(self.folder / "missing")})
        self.assertEqual((ran.returncode, ran.stdout), (2, ""))
        self.assertIn("no temporary folder: No such file or directory", ran.stderr)
        run(PAGE, env={**os.environ, "TMPDIR": str(self.folder)})
        self.assertEqual(list(self.folder.iterdir()), [], "nothing is left")

    def test_rounding_names_a_line(self):
        ran = run(PAGE, "--only", "casteljau_is_bernstein", "--rounding=60")
        self.assertRegex(ran.stdout, r"R +[0-9.e+]+ ulps of the exact value at worst; \d+ % .* arises at \S*curves\.c:13\n")

    def test_other_orders_of_a_sum(self):
        """At one point, what Python computes: the terms of one sum, however the code groups it, in three orders."""
        code = """double f(const double *x) {
            double s = 0;
            for (int i = 0; i < 9; i += 3)
                s += x[i] * x[i] / 7 - (x[i + 1] / 3 - -(x[i + 2] / 1024));
            return s;
        }"""
        block = ":::{exactly} a\n:source: a.c\n:declare: double f(const double *);\n:input: x[9]\n:call: double R = f(x);\n:output: R\n:::\n"
        told = self.verdict(block, code, "a.c", "--rounding=1")["rounding"]["worst"][0]
        x = [F(v) for v in told["point"]["x"]]
        d = [float(v) for v in x]
        terms = [term for i in (0, 3, 6) for term in (d[i] * d[i] / 7, -(d[i + 1] / 3), -(d[i + 2] / 1024))]
        exact = sum(x[i] * x[i] / 7 - x[i + 1] / 3 - x[i + 2] / 1024 for i in (0, 3, 6))
        ulp = F(2) ** (math.frexp(float(exact))[1] - 53)

        def added(numbers):
            s = 0.0
            for number in numbers:
                s += number
            return s

        def written():
            s = 0.0
            for i in (0, 3, 6):
                s += d[i] * d[i] / 7 - (d[i + 1] / 3 - -(d[i + 2] / 1024))
            return s
        by_size = sorted(terms, key=abs)
        wanted = {"as_written": written(), "smallest_first": added(by_size), "largest_first": added(by_size[::-1])}
        mean = {"as_written": told["mean"]["as_written"], **told["mean"]["other_orders"]}
        self.assertEqual(told["mean"]["points"], 1)
        for name, sum_in_order in wanted.items():
            self.assertAlmostEqual(mean[name], float(abs(F(sum_in_order) - exact) / ulp), places=9, msg=name)
        self.assertIn("in_halves", mean)

    def test_junit(self):
        path = self.folder / "cases.xml"
        run(PAGE, "--junit", path)
        suite = xml.dom.minidom.parse(str(path)).documentElement
        self.assertEqual((suite.getAttribute("tests"), suite.getAttribute("failures")), ("6", "1"))


class Certificates(Exactly):
    """What is proved is rechecked by a program that shares nothing with this one; what was tampered with is not."""

    def certified(self, page):
        folder = self.folder / "certificates"
        ran = run(page, "--certificates", folder)
        self.assertIn(ran.returncode, (0, 1), ran.stderr)
        return folder

    def recheck(self, folder):
        ran = subprocess.run([sys.executable, ROOT / "proofs-tests/recheck.py", folder], capture_output=True, text=True, timeout=100)
        return ran.returncode, ran.stdout

    def test_the_page_is_rechecked(self):
        folder = self.certified(PAGE)
        code, out = self.recheck(folder)
        self.assertEqual(code, 0, out)
        self.assertIn("5 rechecked, 0 wrong, 0 cannot recheck this kind", out)
        ways = json.loads((folder / "claims/deboor_is_the_sum_of_basis_functions.json").read_text())["cases"]
        self.assertEqual(len(ways), 2)
        self.assertTrue(all(any(s.get("fact") == "order" for s in w["steps"]) for w in ways))

    def test_names_that_begin_alike_are_rechecked(self):
        code = "double f(const double *a, double ab, double abc) { if (ab > a[0]) ab = a[1] * abc; if (abc > a[11]) return ab - abc; return ab + abc; }"
        block = (":::{exactly} it\n:source: code.c\n:declare: double f(const double *, double, double);\n:input: a[12]; ab; abc\n:call: double r = f(a, ab, abc);\n"
                 ":expect: r = (ab > a[0] ? a[1] * abc : ab) + (abc > a[11] ? -abc : abc)\n:::\n")
        code, out = self.recheck(self.certified(self.harness(block, code)))
        self.assertEqual(code, 0, out)
        self.assertIn("1 rechecked, 0 wrong", out)

    def test_what_differs_is_not_certified(self):
        folder = self.certified(PAGE)
        self.assertFalse((folder / "claims/divided_horner_is_casteljau.json").exists())

    def test_blocks_of_one_name_have_certificates_of_their_own(self):
        code = "double f(double x, double y) { return x + y; }\ndouble g(double x, double y) { return x * y; }"
        other = (Verdicts.BLOCK % "x * y").replace("double f(", "double g(").replace("r = f(", "r = g(")
        folder = self.certified(self.harness(Verdicts.BLOCK % "y + x" + "\n" + other, code))
        self.assertEqual({path.name for path in (folder / "claims").iterdir()}, {"it.json", "it-2.json"})
        code, out = self.recheck(folder)
        self.assertEqual(code, 0, out)
        self.assertIn("2 rechecked, 0 wrong", out)

    def test_roots_are_not_rechecked(self):
        block = Verdicts.BLOCK % "x*x + y*y + 1"
        folder = self.certified(self.harness(block, "#include <math.h>\ndouble f(double x, double y) { double r = sqrt(x * x + y * y + 1); return r * r; }"))
        self.assertIn("it: cannot recheck this kind", self.recheck(folder)[1])

    def test_every_corruption_is_refused(self):
        """Of the program, of what it compared and of the list of ways; the manifest's digests made to fit."""
        folder = self.certified(PAGE)
        path, manifest = folder / "claims/deboor_is_the_sum_of_basis_functions.json", folder / "manifest.json"
        text, listed = path.read_text(), manifest.read_text()
        good = json.loads(text)

        def constant(claim):
            nodes, below = claim["cases"][0]["nodes"], claim["cases"][0]["steps"][-1]["same"][:1]
            for k in below:  # the first of those from which one side is made
                if nodes[k][0] == "c":
                    nodes[k][1] = "2" if nodes[k][1] != "2" else "3"
                    return
                below += nodes[k][1:] if nodes[k][0] in "+-*/" else []

        def operation(claim):
            case = claim["cases"][1]
            i = case["steps"][-1]["same"][0]
            case["nodes"][i][0] = {"+": "-", "-": "+", "*": "/", "/": "*"}[case["nodes"][i][0]]

        def another_node(claim):
            claim["cases"][0]["steps"][-1]["same"][1] -= 1

        def sign(claim):
            fact = next(s for s in claim["cases"][0]["steps"] if s.get("fact") == "order" and s["is"] != 0)
            fact["is"] = -fact["is"]

        def fewer_ways(claim):
            claim["cases"].pop()

        def value(claim):
            claim["cases"][0]["inputs"][0][1] = "1000"

        def nothing_compared(claim):
            claim["cases"][0]["steps"] = [s for s in claim["cases"][0]["steps"] if "fact" in s]

        for change in [constant, operation, another_node, sign, fewer_ways, value, nothing_compared]:
            with self.subTest(change.__name__):
                claim = json.loads(text)
                change(claim)
                self.assertNotEqual(claim, good)
                path.write_text(json.dumps(claim))
                self.assertEqual(self.recheck(folder)[0], 1)  # another file than the manifest says
                everything = json.loads(listed)
                row = next(c for c in everything["claims"] if c["claim"] == claim["claim"])
                row["sha256"] = hashlib.sha256(path.read_bytes()).hexdigest()
                manifest.write_text(json.dumps(everything))
                code, out = self.recheck(folder)
                # Where branches are noted, what stays equal at the point of the way but is no identity is not called wrong.
                self.assertRegex(out, "exactly:deboor_is_the_sum_of_basis_functions: (wrong|cannot recheck this kind .a program that depends)")
                self.assertIn(code, (1, 3), out)
                path.write_text(text)
                manifest.write_text(listed)


class Verdicts(Exactly):
    BLOCK = ":::{exactly} it\n:source: code.c\n:declare: double f(double, double);\n:input: x; y\n:call: double r = f(x, y);\n:expect: r = %s\n:::\n"

    def test_proved(self):
        v = self.verdict(self.BLOCK % "x*x + 2*x*y + y*y", "double f(double x, double y) { return (x + y) * (x + y); }")
        self.assertEqual((v["verdict"], v["paths"], v["paths_proved"]), ("proved", 1, 1))
        self.assertEqual(v["ways"][0]["conditions"], [])

    def test_another_function_is_not_proved(self):
        v = self.verdict(self.BLOCK % "x*x + 2*x*y - y*y", "double f(double x, double y) { return (x + y) * (x + y); }")
        self.assertEqual(v["verdict"], "differs")
        self.assertEqual(v["point"], {"x": ["0"], "y": ["1"]})
        self.assertEqual((v["results"][0]["value"], v["results"][0]["expected"]), ("1", "-1"))

    def test_conditions_are_told(self):
        v = self.verdict(self.BLOCK % "x > y ? x - y : y - x", "#include <math.h>\ndouble f(double x, double y) { return fabs(x - y); }")
        self.assertEqual(v["verdict"], "proved")
        told = {tuple(f"{c['left']} {c['relation']} {c['right']}" for c in w["conditions"] if not c["implied"]) for w in v["ways"]}
        self.assertGreaterEqual(len(told), 2)
        self.assertTrue(all(c["line"] > 0 for w in v["ways"] for c in w["conditions"]))

    def test_a_tolerance_is_a_condition(self):
        v = self.verdict(self.BLOCK % "x - y < 1e-9 ? 0 : x", "double f(double x, double y) { return x - y < 1e-9 ? 0 : x; }")
        self.assertEqual(v["verdict"], "proved")
        self.assertTrue(any("/" in c["right"] for w in v["ways"] for c in w["conditions"]))

    def test_an_error_on_a_rare_way_is_found_once_it_is_taken(self):
        code = "double f(double x, double y) { return x == 0 ? 1 : x * y; }"
        v = self.verdict(self.BLOCK % "x * y", code, "code.c", "--points", "200")
        self.assertEqual(v["verdict"], "differs")
        self.assertEqual(v["point"]["x"], ["0"])

    def test_preconditions_keep_points_out(self):
        block = self.BLOCK.replace(":call:", ":where: x != 0\n:call:") % "x * y"
        v = self.verdict(block, "double f(double x, double y) { return x == 0 ? 1 : x * y; }", "code.c", "--points", "100")
        self.assertEqual(v["verdict"], "proved")
        self.assertGreater(v["outside"], 0)
        self.assertTrue(all(c["precondition"] or c["implied"] for w in v["ways"] for c in w["conditions"]))

    def test_a_power_to_infinity_asks_on_which_side_of_1_its_base_is(self):
        code = "#include <math.h>\ndouble f(double x, double y) { return pow(x, INFINITY) + 0 * y; }"
        block = self.BLOCK.replace("x; y", "x in (999999/1000000, 3); y")
        self.assertEqual(self.verdict(block % "__builtin_inf()", code)["verdict"], "differs")
        v = self.verdict(block % "x > 1 ? __builtin_inf() : x == 1", code)
        self.assertEqual((v["verdict"], v["paths"]), ("proved", 3))

    def test_the_ends_of_a_range_are_of_any_size(self):
        n = 2**200 + 1
        for low, high, verdict in [(-n, n, "proved"), ("1/100000000000000000000000", "1e400", "proved"), (f"{n}/7", f"{n}/7", "proved"),
                                   (-2**63, 2**64 - 1, "proved"), (n, n - 1, "undecided"), (2**53 + 1, 2**53, "undecided")]:
            with self.subTest(f"[{low}, {high}]"):
                block = self.BLOCK.replace("x; y", f"x in [{low}, {high}]; y") % "x + y"
                path = self.harness(block, "double f(double x, double y) { return x + y; }")
                ran = run(path, "--json")
                self.assertEqual(ran.stderr, "")
                self.assertEqual(json.loads(ran.stdout)["blocks"][0]["verdict"], verdict)

    def test_what_is_divided_by_is_told(self):
        v = self.verdict(self.BLOCK % "x + y", "double f(double x, double y) { return (x * x - y * y) / (x - y); }")
        self.assertEqual((v["verdict"], v["ways"][0]["not_zero"]), ("proved", ["x-y"]))
        self.assertIn("a division by zero, at", v["no_value"]["because"])
        self.assertEqual(v["no_value"]["point"]["x"], v["no_value"]["point"]["y"])

    def test_conditions_that_are_multiples_of_one_another_are_one(self):
        code = "double f(double x, double y) { if (x <= y && 3 * x >= 3 * y) return x - y; return 0; }"
        self.assertEqual(self.verdict(self.BLOCK % "0", code)["verdict"], "proved")

    def test_a_condition_that_is_an_equality_is_used(self):
        v = self.verdict(self.BLOCK % "x", "double f(double x, double y) { return x == y ? y : x; }", "code.c", "--points", "100")
        self.assertEqual((v["verdict"], v["paths"]), ("proved", 2))

    def test_memcpy_between_pieces_that_overlap(self):
        code = "#include <string.h>\ndouble f(double x, double y)\n{\n    double a[3] = {0, x, y};\n    memcpy(a, a + 1, 2 * sizeof *a);\n    return a[0] - a[1];\n}\n"
        v = self.verdict(self.BLOCK % "x - y", code)
        self.assertEqual(v["verdict"], "undecided")
        self.assertRegex(v["because"], r"memcpy of 16 bytes to 8 bytes before, which overlap, at \S*code\.c:5 in f")
        moves = self.BLOCK.replace(":call:", ":memcpy: moves\n:call:") % "x - y"
        v = self.verdict(moves, code)
        self.assertEqual(v["verdict"], "proved")
        self.assertRegex(v["memcpy_overlaps"], r"code\.c:5$")
        self.assertRegex(run(self.harness(moves, code)).stdout, r"memcpy does what memmove does between pieces that overlap, first at\s")
        apart = "#include <string.h>\ndouble f(double x, double y)\n{\n    double a[4] = {0, 0, x, y};\n    memcpy(a, a + 2, 2 * sizeof *a);\n    return a[0] - a[1];\n}\n"
        self.assertNotIn("memcpy_overlaps", self.verdict(moves, apart))

    HORNER = """static double c[3];
double f(double x, double y)
{
    double s = y, *p = c;
    for (int i = 0; i < 3; i++) {
        s = s * x;
        s += i;
        p[i] = s;
    }
    return s;
}
"""

    def known(self, wrong, *lines):
        code = self.HORNER.replace("s += i;", "s += i * i;") if wrong else self.HORNER
        block = self.BLOCK.replace(":call:", ":call: double W[3] = {y * x, (y * x) * x + 1, ((y * x) * x + 1) * x + 2};\n:call:")
        return (block % "((y * x) * x + 1) * x + 2").replace(":expect:", "".join(f":known: {line}\n" for line in lines) + ":expect:"), code

    def test_the_first_known_value_that_is_wrong_is_told(self):
        block, code = self.known(True, "code.c:8[3] = W", "code.c:7[2] = W", "code.c:6 = y * x")
        v = self.verdict(block, code)
        self.assertEqual((v["verdict"], v["first_wrong"]["place"], v["first_wrong"]["variable"]), ("differs", "code.c:8[2]", "p"))
        x, y = (F(v["point"][name][0]) for name in "xy")
        self.assertEqual(F(v["first_wrong"]["value"]) - F(v["first_wrong"]["known"]), 2)
        self.assertEqual(F(v["first_wrong"]["known"]), ((y * x) * x + 1) * x + 2)
        block, code = self.known(True, "code.c:8[3] = W", "code.c:7[3] = W")  # line 7 comes first
        v = self.verdict(block, code)
        self.assertEqual((v["first_wrong"]["place"], v["first_wrong"]["variable"]), ("code.c:7[2]", "s"))
        self.assertRegex(run(self.harness(block, code)).stdout, r"first wrong +s at code\.c:7\[2\] is \S+; known is \S+\n")

    def test_known_values_are_proved_like_others(self):
        block, code = self.known(False, "code.c:8[3] = W", "code.c:4 = y")
        self.assertEqual(self.verdict(block, code)["verdict"], "proved")
        block, code = self.known(False, "code.c:7 = y * x + 1")  # wrongly known: the result is right
        v = self.verdict(block, code)
        self.assertEqual((v["verdict"], v["first_wrong"]["place"]), ("differs", "code.c:7"))
        block, code = self.known(False, "ode.c:8[3] = W")  # the end of a name is another name
        v = self.verdict(block, code)
        self.assertEqual(v["verdict"], "undecided")
        self.assertIn("ode.c:8 puts 0 numbers into variables on this way; 3 are known", v["because"])
        block, code = self.known(False, f"{self.folder.name}/code.c:8[3] = W", "code.c:6[3] = V")
        block = block.replace(":call: double W", ":call: double V[3] = {y * x, (y * x) * x, ((y * x) * x + 1) * x};\n:call: double W")
        self.assertEqual(self.verdict(block, code)["verdict"], "proved")
        block, code = self.known(False, "code.c:8[4] = W")
        v = self.verdict(block, code)
        self.assertEqual(v["verdict"], "undecided")
        self.assertIn("code.c:8 puts 3 numbers into variables on this way; 4 are known", v["because"])

    def test_where_two_versions_go_apart_is_told(self):
        code = self.HORNER + self.HORNER.replace("s += i;", "s += i * i;").replace("double f", "double g").replace("static double c[3];", "")
        block = self.BLOCK.replace("f(double, double);", "f(double, double); double g(double, double);")
        v = self.verdict(block % "g(x, y)", code)
        self.assertEqual(v["verdict"], "differs")
        apart = v["first_apart"]
        self.assertEqual((apart["variable"], apart["time"], apart["place"], apart["other_place"]), ("s", 7, "code.c:7", "code.c:18"))
        self.assertEqual(F(apart["other_value"]) - F(apart["value"]), 2)
        self.assertNotIn("first_apart", self.verdict(block % "x", code), "nothing to compare with")

    def test_numbers_in_floats_are_known_too(self):
        code = "double f(double x, double y)\n{\n    float a;\n    a = x;\n    a = a * y;\n    return a + 1;\n}\n"
        block = (self.BLOCK % "x * y").replace(":expect:", ":known: code.c:5 = x * y\n:expect:")
        v = self.verdict(block, code)
        self.assertEqual([r["answer"] for r in v["results"]], ["equal", "different"])
        self.assertNotIn("first_wrong", v)

    def test_refusals_name_the_line(self):
        v = self.verdict(self.BLOCK % "x", "#include <math.h>\ndouble f(double x, double y)\n{\n    return tgamma(x);\n}\n")
        self.assertEqual(v["verdict"], "undecided")
        self.assertRegex(v["because"], r"the function tgamma, at \S*code\.c:4 in f")

    def test_proved_for_all_inputs(self):
        """No input takes another way, which is proved; or there is one, and it is found however rare it is."""
        for code in ["return x * y;", "return x > y ? x * y : y * x;", "return fabs(x) * y * (x < 0 ? -1 : 1);",
                     "return x > 1 && x < 0 ? 7 : x * y;",
                     "return x + y < x + y - 1 ? 7 : x * y;"]:
            v = self.verdict(self.BLOCK % "x * y", "#include <math.h>\ndouble f(double x, double y) { %s }" % code)
            self.assertEqual((v["verdict"], v.get("exhaustive")), ("proved", True), code)

    def test_a_branch_that_chance_does_not_find_is_found(self):
        for condition, point in [("x == 0.123", lambda x, y: x == F(0.123)), ("x > 1000 && y < x - 5000", lambda x, y: x > 1000 and y < x - 5000),
                                 ("x + y == 7 && x - y == 1", lambda x, y: (x, y) == (4, 3)), ("3 * x > 1e9", lambda x, y: 3 * x > 10**9)]:
            v = self.verdict(self.BLOCK % "x * y", "double f(double x, double y) { return %s ? 7777 : x * y; }" % condition)
            self.assertEqual(v["verdict"], "differs", condition)
            self.assertTrue(point(F(v["point"]["x"][0]), F(v["point"]["y"][0])), v["point"])

    def test_a_read_outside_on_a_rare_way_leaves_nothing_proved(self):
        code = "double f(double x, double y) { double a[2] = {x, y}, *p = a; return x == 0.123 ? p[2] : x * y; }"
        v = self.verdict(self.BLOCK % "x * y", code)
        self.assertEqual(v["verdict"], "undecided")
        self.assertIn("0 bytes behind the end of a, which has 16 bytes, at", v["because"])

    def test_preconditions_close_branches(self):
        code = "double f(double x, double y) { return x * y < 0 || x + y > 7 ? 7777 : x * y; }"
        for inputs, word, exhaustive in [("x in [0, 3]; y in (0, 4)", "proved", True), ("x > 0; y in (0, 4)", "differs", None),
                                         ("x in (1, 3); y in (1/2, 4]", "proved", True)]:
            v = self.verdict(self.BLOCK.replace(":input: x; y", ":input: " + inputs) % "x * y", code)
            self.assertEqual((v["verdict"], v.get("exhaustive")), (word, exhaustive), v)

    def test_conditions_that_follow_from_others_are_not_told(self):
        code = "double f(double x, double y) { return x > 1 && y > 2 && x + y > 3 && x + 2 * y > 4 ? x * y : y * x; }"
        v = self.verdict(self.BLOCK % "x * y", code, "code.c", "--points", "60")
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", True))
        self.assertIn([("x", ">", "1"), ("y", ">", "2")],
                      [[(c["left"], c["relation"], c["right"]) for c in w["conditions"] if not c["implied"]] for w in v["ways"]])
        v = self.verdict(self.BLOCK.replace(":input: x; y", ":input: x in (0, 1); y in (2, 3)") % "1 / (x + y) - 1 / (3 * x - y - 4)",
                         "double f(double x, double y) { return 1 / (x + y) - 1 / (3 * x - y - 4); }")
        self.assertEqual([w["not_zero"] for w in v["ways"]], [[]])

    def test_a_branch_of_higher_degree_stays_open(self):
        v = self.verdict(self.BLOCK % "x * y", "double f(double x, double y) { return x * x * y > 1e9 + x ? 7777 : x * y; }")
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", False))
        self.assertIn("x^2*y", v["open"])

    def test_where_a_root_is_taken_is_a_condition(self):
        code = "#include <math.h>\ndouble f(double x, double y) { double r = sqrt(x - y); return r * r; }"
        v = self.verdict(self.BLOCK % "x - y", code)
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", True))
        self.assertEqual([(c["left"], c["relation"], c["right"]) for c in v["ways"][0]["conditions"]], [("x", ">=", "y")])

    def test_roots(self):
        code = "#include <math.h>\ndouble f(double x, double y) { double r = sqrt(x * x + y * y + 1); return r * r; }"
        self.assertEqual(self.verdict(self.BLOCK % "x*x + y*y + 1", code)["verdict"], "proved")
        self.assertEqual(self.verdict(self.BLOCK % "x*x + y*y + 2", code)["verdict"], "differs")
        v = self.verdict(self.BLOCK.replace(":call:", ":roots: refuse\n:call:") % "x*x + y*y + 1", code)
        self.assertIn("not rational", v["because"])
        v = self.verdict(self.BLOCK.replace(":call:", ":roots: enclose\n:call:") % "x*x + y*y + 1", code)
        self.assertEqual(v["verdict"], "enclosed")
        self.assertIn("asked for as an interval", v["because"])

    def test_no_end_of_time(self):
        v = self.verdict(self.BLOCK % "x", "double f(double x, double y)\n{\n    for (;;)\n        y = y * y + 1;\n    return x;\n}\n")
        self.assertEqual(v["verdict"], "undecided")
        self.assertRegex(v["because"], r"a number of more than \d+ bits, at \S*code\.c:4")

    def test_sources_flags_and_includes_are_seen_from_the_page(self):
        (self.folder / "sub/inc").mkdir(parents=True)
        (self.folder / "sub/inc/two.h").write_text("#define TWO 2\n")
        (self.folder / "one.h").write_text("static double one(double x) { return x + ONE; }\n")
        (self.folder / "sub/twice.c").write_text('#include <two.h>\ndouble twice(double x) { return x * TWO; }\n')
        (self.folder / "more.cc").write_text('extern "C" double thrice(double x) { auto y = x + x; return y + x; }\n')
        for source in ["sub/twice.c", str(self.folder / "sub/twice.c")]:
            for flags in [":flag: -Isub/inc -DONE=1", f":flag: -DONE=1\n:flag: -I{self.folder}/sub/inc", f":flag: -DONE=1 -I {self.folder}/sub/inc"]:
                v = self.verdict(f':::{{exactly}} it\n:source: {source}\n{flags}\n:include: "one.h"\n:declare: double twice(double);\n'
                                 ":input: x\n:call: double r = twice(one(x));\n:expect: r = 2 * x + 2\n:::\n")
                self.assertEqual(v["verdict"], "proved", flags)
        for sources in ["sub/twice.c\n:source: more.cc", "more.cc\n:source: sub/twice.c"]:
            v = self.verdict(f':::{{exactly}} it\n:source: {sources}\n:flag: -Isub/inc -DONE=1 -std=c++17\n:include: "one.h"\n'
                             ':declare: extern "C" double twice(double);\n  extern "C" double thrice(double);\n'
                             ":input: x\n:call: double r = twice(thrice(one(x)));\n:expect: r = 6 * x + 6\n:::\n")
            self.assertEqual(v["verdict"], "proved")
        ran = run(self.harness(":::{exactly} it\n:source: none.c\n:input: x\n:call: double r = x;\n:expect: r = x\n:::\n"))
        self.assertEqual((ran.returncode, ran.stdout), (2, ""))
        self.assertRegex(ran.stderr, r"/none\.c(?s:.*)page\.md: line 3: it: the sources were not compiled\n$")

    def test_an_output(self):
        block = ":::{exactly} it\n:source: code.c\n:declare: void g(double, double *);\n:input: x\n:call: double r[2]; g(x, r);\n:output: r[2]\n:::\n"
        v = self.verdict(block, "void g(double x, double *r) { r[0] = x / 3; r[1] = 1 - x; }")
        self.assertEqual(v["verdict"], "computed")
        self.assertEqual([r["name"] for r in v["results"]], ["r[0]", "r[1]"])

    def test_arrays_are_compared_element_by_element(self):
        block = (":::{exactly} it\n:source: code.c\n:declare: void g(double, double *);\n:input: x\n"
                 ":call: double r[2], w[2] = {x / 3, x}; g(x, r);\n:expect: r[2] = w\n:::\n")
        v = self.verdict(block, "void g(double x, double *r) { r[0] = x / 3; r[1] = 1 - x; }")
        self.assertEqual(v["verdict"], "differs")
        self.assertEqual([r["answer"] for r in v["results"]], ["equal", "different"])

    def test_cpp(self):
        block = self.BLOCK.replace("code.c", "code.cc") % "x * y"
        code = "#include <vector>\ndouble f(double x, double y) { std::vector<double> v{x, y}; double p = 1; for (double a : v) p *= a; return p; }"
        self.assertEqual(self.verdict(block, code, "code.cc")["verdict"], "proved")

    def test_patterns_of_knots(self):
        block = (":::{exactly} it\n:source: code.c\n:declare: double h(const double *);\n:input: k[4] nondecreasing\n:call: double r = h(k);\n"
                 ":expect: r = k[3] - k[0]\n:::\n")
        v = self.verdict(block, "double h(const double *k) { double s = 0; for (int i = 0; i < 3; i++) if (k[i] != k[i + 1]) s += k[i + 1] - k[i]; return s; }")
        self.assertEqual((v["verdict"], v["patterns"]), ("proved", {"all": 8, "met": 8}))

    def test_a_turned_comparison_is_told(self):
        v = self.verdict(self.BLOCK % "1", "double f(double x, double y) { double a = x / 3 + y / 7; return (a - y / 7) * 3 == x; }", "code.c",
                         "--rounding=50")
        self.assertEqual(v["verdict"], "proved")
        self.assertGreater(v["rounding"]["turned"], 0)


class Printed(Exactly):
    """What should come out is a formula as it is printed."""
    CURVES = (ROOT / "exact/code/example/curves.c").read_text()
    BLOCK = (":::{exactly} it\n:source: code.c\n:declare: double deboor(int n, int degree, const double *k, const double *c, double t);\n"
             "   double basis(int i, int degree, const double *k, double t);\n%s\n:::\n")

    def of_curves(self, lines, *options):
        return self.verdict(self.BLOCK % lines, self.CURVES, "code.c", *options)

    def of(self, code, inputs, call, lines):
        declared = code.split("{")[0].strip().splitlines()[-1]
        return self.verdict(f":::{{exactly}} it\n:source: code.c\n:declare: {declared};\n:input: {inputs}\n:call: {call}\n{lines}\n:::\n", code)

    @staticmethod
    def conditions(v):
        return [f"{c['left']} {c['relation']} {c['right']}" for way in v["ways"] for c in way["conditions"]]

    def test_definitions_of_ones_own_and_cases(self):
        lines = (":input: knot[7] increasing; t in [knot[0], knot[6])\n:call: double N[4]; for (int i = 0; i < 4; i++) N[i] = basis(i, 2, knot, t);\n"
                 ":output: N[4]\n:let: $M_{i,0}(x) = 1, \\quad \\mathrm{knot}_i \\le x < \\mathrm{knot}_{i+1}$\n:let: M_{i,0}(x) = 0\n"
                 ":let: M_{i,p}(x) = \\frac{x-\\mathrm{knot}_i}{\\mathrm{knot}_{i+p}-\\mathrm{knot}_i} M_{i,p-1}(x)\n"
                 "  + \\frac{\\mathrm{knot}_{i+p+1}-x}{\\mathrm{knot}_{i+p+1}-\\mathrm{knot}_{i+1}} M_{i+1,p-1}(x)\n"
                 ":printed: $N_j = M_{j,%s}(t)$\n:for: j = 0..3")
        v = self.of_curves(lines % "2")
        self.assertEqual((v["verdict"], v["exhaustive"], len(v["ways"])), ("proved", True, 6))
        v = self.of_curves(lines % "1")
        self.assertEqual(v["verdict"], "differs")
        self.assertEqual([r["name"] for r in v["results"] if "expected" in r], [f"N_j, j = {j}" for j in range(4)])

    def test_a_misprint_is_found_with_the_smallest_numbers(self):
        lines = (":input: u[7] increasing; c[4]; t in [u[2], u[4])\n:call: double R = deboor(3, 2, u, c, t);\n:output: R\n"
                 ":use: bspline N_{i,p}(t) over u_i\n:printed: R = \\sum_{i=0}^%s N_{i,2}(t) c_i")
        self.assertEqual(self.of_curves(lines % "3")["verdict"], "proved")
        v = self.of_curves(lines % "2")
        self.assertEqual(v["verdict"], "differs")
        c = v["point"]["c"]
        self.assertEqual((c[:3], c[3] in ("1", "-1", "2")), (["0", "0", "0"], True), v["point"])

    def test_multiple_knots(self):
        v = self.of_curves(":input: u[7] nondecreasing; c[4]; t in [u[2], u[4])\n:call: double R = deboor(3, 2, u, c, t);\n:output: R\n"
                           ":use: bspline N_{i,p}(t) over u_i\n:printed: R = \\sum_{i=0}^3 N_{i,2}(t) c_i")
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", True))

    SLOPE = """double slope(const double *u, const double *c, double t)
{
    int k = t < u[3] ? 2 : 3;
    double a = 2 * (c[k - 1] - c[k - 2]) / (u[k + 1] - u[k - 1]), b = 2 * (c[k] - c[k - 1]) / (u[k + 2] - u[k]);
    return ((u[k + 1] - t) * a + (t - u[k]) * b) / (u[k + 1] - u[k]);
}"""

    def test_derivatives_at_knots_too(self):
        """The conditions t = u[2], u[3] are ways of the formula; there the derivatives from both sides are equal."""
        lines = ":output: s\n:use: bspline N_{i,p}(t) over u_i\n:printed: s = \\sum_{i=0}^3 N_{i,2}%s(t) c_i"
        v = self.of(self.SLOPE, "u[7] increasing; c[4]; t in [u[2], u[4])", "double s = slope(u, c, t);", lines % "'")
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", True))
        self.assertIn("t = u[3]", self.conditions(v))
        v = self.of(self.SLOPE, "u[7] increasing; c[4]; t in [u[2], u[4])", "double s = slope(u, c, t);", lines % "''")
        self.assertEqual(v["verdict"], "differs")

    def test_the_derivative_of_a_rational_spline(self):
        """A quotient of sums with pieces, at knots too: what is divided by is meant at the place, not beside it."""
        code = """#include <math.h>
static double basis(int i, int p, const double *u, double t)
{
    if (p == 0)
        return u[i] <= t && t < u[i + 1];
    return (t - u[i]) / (u[i + p] - u[i]) * basis(i, p - 1, u, t) + (u[i + p + 1] - t) / (u[i + p + 1] - u[i + 1]) * basis(i + 1, p - 1, u, t);
}
static double slope(int i, const double *u, double t)
{
    return 2 * (basis(i, 1, u, t) / (u[i + 2] - u[i]) - basis(i + 1, 1, u, t) / (u[i + 3] - u[i + 1]));
}
void curve(const double *u, const double *P, const double *w, double t, double *r) {
    double x = 0, dx = 0, s = 0, ds = 0;
    for (int i = 0; i < 3; i++) {
        x += w[i] * P[i] * basis(i, 2, u, t), dx += w[i] * P[i] * slope(i, u, t);
        s += w[i] * basis(i, 2, u, t), ds += w[i] * slope(i, u, t);
    }
    r[0] = x / s, r[1] = (dx * s - x * ds) / (s * s);
}"""
        block = (":::{exactly} it\n:source: code.c\n:declare: void curve(const double *, const double *, const double *, double, double *);\n"
                 ":input: u[6] increasing; P[3]; omega[3] > 0; t in [u[2], u[3])\n:call: double R[2]; curve(u, P, omega, t, R);\n:output: R[2]\n"
                 ":use: bspline N_{i,p}(t) over u_i\n"
                 ":let: C(t) = \\frac{\\sum_{i=0}^2 \\omega_i P_i N_{i,2}(t)}{\\sum_{i=0}^2 \\omega_i N_{i,2}(t)}\n:printed: R_0 = C(t), \\quad R_1 = %s\n:::\n")
        v = self.verdict(block % "C'(t)", code)
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", True))
        self.assertIn("t = u[2]", self.conditions(v))
        self.assertEqual(self.verdict(block % "C''(t)", code)["verdict"], "differs")

    def test_there_is_no_derivative_at_a_corner(self):
        code = """double slope(const double *u, const double *c, double t)
{
    int k = t < u[2] ? 1 : 2;
    return (c[k] - c[k - 1]) / (u[k + 1] - u[k]);
}"""
        v = self.of(code, "u[5] increasing; c[3]; t in (u[1], u[3])", "double s = slope(u, c, t);",
                    ":output: s\n:use: bspline N_{i,p}(t) over u_i\n:printed: s = \\sum_{i=0}^2 N_{i,1}'(t) c_i\n:points: 200")
        self.assertEqual(v["verdict"], "proved", v)
        self.assertIn("no derivative at a joint", v["no_value"]["because"])
        self.assertEqual(v["no_value"]["point"]["t"], v["no_value"]["point"]["u"][2:3])
        self.assertNotIn("t = u[2]", self.conditions(v))

    def test_equations_that_are_not_solved_and_irrational_results(self):
        code = "#include <math.h>\nvoid unit(double x, double y, double *r) { double l = sqrt(x * x + y * y); r[0] = x / l; r[1] = y / l; }"
        unit = code, "x; y", "double r[2]; unit(x, y, r);"
        lines = ":where: x != 0 || y != 0\n:output: r[2]\n:printed: %s"
        self.assertEqual(self.of(*unit, lines % "r_0^2 + r_1^2 = 1")["verdict"], "proved")
        v = self.of(*unit, lines % "r_0 r_1 = \\frac{x y}{x^2 + 2y^2}")
        self.assertEqual(v["verdict"], "differs")
        x, y = F(v["point"]["x"][0]), F(v["point"]["y"][0])
        self.assertNotEqual(x * y / (x * x + y * y), x * y / (x * x + 2 * y * y), "the point is a counterexample")
        lines = lines.replace("x != 0 || y != 0", "x != 0 && y != 0")
        self.assertEqual(self.of(*unit, lines % "\\frac{r_0}{r_1} = \\frac{x}{y}")["verdict"], "proved")
        turn = "#include <math.h>\nvoid turn(double t, double *r) { r[0] = cos(t); r[1] = sin(t); }", "t", "double r[2]; turn(t, r);"
        for printed, verdict in [("r_0^2 + r_1^2 = 1", "proved"), ("r_0^2 - r_1^2 = 1", "differs")]:
            self.assertEqual(self.of(*turn, f":output: r[2]\n:printed: {printed}")["verdict"], verdict)

    def test_a_division_by_zero_in_the_formula(self):
        code = "double f(double a, double b) { return a + b; }"
        v = self.of(code, "a; b", "double s = f(a, b);", ":output: s\n:printed: s = \\frac{a^2 - b^2}{a - b}\n:points: 100")
        self.assertEqual(v["verdict"], "proved")
        self.assertIn("a-b", json.dumps(v["ways"]))
        v = self.of(code, "a = 1; b = 1", "double s = f(a, b);", ":output: s\n:printed: s = \\frac{a^2 - b^2}{a - b}")
        self.assertEqual(v["verdict"], "undecided")
        self.assertIn("a division by 0, at", v["because"])

    def test_what_is_said_of_0_divided_by_0(self):
        code = "double f(double x, double a, double b) { return a == b ? 0 : x; }"
        v = self.of(code, "x; a; b", "double s = f(x, a, b);", ":output: s\n:let: 0/0 = 0\n:printed: s = \\frac{x(a - b)}{a - b}")
        self.assertEqual((v["verdict"], v["exhaustive"], "no_value" in v), ("proved", True, False))

    def test_a_value_at_a_place(self):
        code = "double f(double x) { return x >= 2; }"
        for tex, verdict in [("\\ge", "proved"), (">", "differs")]:
            v = self.of(code, "x", "double s = f(x);",
                        f":output: s\n:let: h(y) = 1, \\quad y {tex} 2\n:let: h(y) = 0\n:let: z \\in \\mathbb{{R}}\n:printed: s = \\left. h(z) \\right|_{{z=x}}")
            self.assertEqual(v["verdict"], verdict)

    def test_a_way_on_which_the_formula_has_no_value(self):
        code = "double f(double a, double b) { if (a == b) return 7; return a + b; }"
        v = self.of(code, "a; b", "double s = f(a, b);", ":output: s\n:printed: s = \\frac{a^2 - b^2}{a - b}")
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", True))
        self.assertEqual(self.conditions(v), ["a != b"])

    def test_each_relation(self):
        """1 where x relation 2, else 0; and the same code with the other relations is found wrong at 2 or beside it."""
        signs = {"<": "<", "<=": "\\le", ">": ">", ">=": "\\ge", "==": "=", "!=": "\\ne"}
        for sign in signs:
            code = f"double f(double x) {{ return x {sign} 2; }}"
            for other, tex in signs.items():
                with self.subTest(f"{sign} {other}"):
                    v = self.of(code, "x", "double s = f(x);", f":output: s\n:let: h(y) = 1, \\quad y {tex} 2\n:let: h(y) = 0\n:printed: s = h(x)")
                    self.assertEqual(v["verdict"], "proved" if sign == other else "differs")

    def test_elements_of_two_digits_and_of_one(self):
        code = "double f(const double *p) { return p[0] + 2 * p[1] + 3 * p[10] + 4 * p[11]; }"
        for printed, verdict in [("s = p_0 + 2p_1 + 3p_{10} + 4p_{11}", "proved"), ("s = p_0 + 2p_1 + 3p_{11} + 4p_{10}", "differs"), ("s = p_{10} + 2p_1 + 3p_0 + 4p_{11}", "differs"),
                                 ("s = \\sum_{i=0}^1 (i+1) p_i + \\sum_{i=10}^{11} (i-7) p_i", "proved"), ("s = p_0 + 2p_1 + 3p_{10} + 4p_{12}", "undecided")]:
            with self.subTest(printed):
                self.assertEqual(self.of(code, "p[12]", "double s = f(p);", f":output: s\n:printed: {printed}")["verdict"], verdict)

    def test_arrays_of_outputs_and_several_ranges(self):
        """Every case of every range, the later ones depending on the earlier; each is told by its letters."""
        code = "void f(const double *p, double *r) { for (int k = 0; k < 12; k++) r[k] = p[k / 4] * (k % 4); }"
        lines = ":output: r[12]\n:printed: r_{4i+j} = %s\n:for: i = 0..2\n:for: j = %s"
        v = self.of(code, "p[3]", "double r[12]; f(p, r);", lines % ("j p_i", "0..3"))
        self.assertEqual(v["verdict"], "proved")
        for wrong in ["j p_i + (i-0)(i-1)(j-0)(j-1)(j-2)", "j p_i + (i-1)(i-2)(j-1)(j-2)(j-3)", "j p_0 + i(i-1)(i-2)"]:  # in one case alone
            with self.subTest(wrong):
                self.assertEqual(self.of(code, "p[3]", "double r[12]; f(p, r);", lines % (wrong, "0..3"))["verdict"], "differs")
        v = self.of(code, "p[3] = 1 2 3", "double r[12]; f(p, r);", lines % ("j p_i", "i..3"))
        self.assertEqual([r["name"] for r in v["results"] if "expected" in r], [f"r_{{4i+j}}, i = {i}, j = {j}" for i in range(3) for j in range(i, 4)])

    def test_what_is_no_number_in_a_formula(self):
        for given in ["HUGE_VAL", "NAN"]:
            v = self.verdict(f":::{{exactly}} it\n:include: <math.h>\n:input: x\n:call: double s = {given};\n:output: s\n:printed: s = x\n:::\n")
            self.assertEqual(v["verdict"], "undecided")
            self.assertRegex(v["because"], "s is an infinity or no number, at .*page.md:8 in the formula")

    def test_several_equations(self):
        code = "double f(double x) { return 2 * x; }"
        for printed, verdict in [("s = x + x, \\quad \\frac{s}{2} = x", "proved"), ("s = x, \\quad s = 2x", "differs"), ("s = 2x, \\quad s = x", "differs"),
                                 ("x + x = s = 2x", "proved"), ("s = 2x = 3x", "differs"), ("s = 3x = x + 2x", "differs")]:
            with self.subTest(printed):
                self.assertEqual(self.of(code, "x", "double s = f(x);", f":output: s\n:printed: {printed}")["verdict"], verdict)

    def test_inputs_are_what_they_were(self):
        code = "double f(double *p) { double s = p[0] + p[1]; p[0] = 7; p[1] = s; return s; }"
        v = self.of(code, "p[2]", "double s = f(p);", ":output: s\n:printed: s = p_0 + p_1")
        self.assertEqual(v["verdict"], "proved")
        v = self.of(code, "p[2]", "double s = f(p);", ":output: s\n:output: p[2]\n:printed: s = p_0 + p_1")
        self.assertEqual(v["verdict"], "proved", "an output of that name is told, and the formula has the input")

    def test_amounts_and_greatest(self):
        code = "double f(double a, double b) { return a > b ? a - b : b - a; }"
        v = self.of(code, "a; b", "double s = f(a, b);", ":output: s\n:printed: s = |a - b| = \\max(a, b) - \\min(a, b)")
        self.assertEqual((v["verdict"], v["exhaustive"]), ("proved", True))

    def test_rounding_is_that_of_the_outputs(self):
        code = "double f(double x) { return x / 3; }"
        block = ":::{exactly} it\n:source: code.c\n:declare: double f(double);\n:input: x\n:call: double s = f(x);\n:output: s\n:printed: 3s = x\n:::\n"
        v = self.verdict(block, code, "code.c", "--rounding=20")
        self.assertEqual((v["verdict"], [w["name"] for w in v["rounding"]["worst"]]), ("proved", ["s"]))

    def test_rounding_where_nothing_is_put_in(self):
        code = "double f(void) { double x = 0.1; return x + 1.0 / 3; }"
        v = self.verdict(":::{exactly} it\n:source: code.c\n:declare: double f(void);\n:call: double s = f();\n:output: s\n:::\n", code, "code.c", "--rounding=20")
        self.assertEqual([w["name"] for w in v["rounding"]["worst"]], ["s"])

    def test_certificates(self):
        page = self.harness(self.BLOCK % (":input: u[7] increasing; c[4]; t in [u[2], u[4])\n:call: double R = deboor(3, 2, u, c, t);\n:output: R\n"
                                          ":use: bspline N_{i,p}(t) over u_i\n:printed: R = \\sum_{i=0}^3 N_{i,2}(t) c_i"), self.CURVES)
        folder = self.folder / "certificates"
        self.assertEqual(run(page, "--certificates", folder).returncode, 0)
        checked = subprocess.run([sys.executable, ROOT / "proofs-tests/recheck.py", folder], capture_output=True, text=True)
        self.assertIn("1 rechecked, 0 wrong", checked.stdout)
        (statement,) = json.loads((folder / "manifest.json").read_text())["statements"]
        self.assertIn("R = \\sum_{i=0}^3 N_{i,2}(t) c_i, where :use: bspline", statement["printed"])

    def test_what_differs_is_shown_where_it_does(self):
        """Where outputs are told, too, the first point is kept until one differs."""
        code = "double f(double x) { return x > 2 ? x : 0; }"
        v = self.of(code, "x", "double s = f(x);", ":output: s\n:expect: s = 0")
        self.assertEqual(v["verdict"], "differs")
        self.assertGreater(F(v["point"]["x"][0]), 2)
        self.assertIn(["different"], [[r.get("answer")] for r in v["results"]])

    def test_refusals(self):
        good = ":::{exactly} it\n:input: x; p[3]\n:call: double r = x;\n:output: r\n%s\n:::\n"
        for lines, words in [
            (":printed: r = q", "line 7: \"r = q\", at \"q\": "),
            (":printed: r = p", "line 7: \"r = p\", at \"p\": "),
            (":printed: r \\le x", "an equation was expected"),
            (":printed: r = x \\Rightarrow x = r", "an equation was expected"),
            (":printed: r", "line 7: \"r\""),
            (":printed: r = x^{j}\n:for: 0 \\le j \\le 1", "a range such as j = 0..2"),
            (":printed: r = x^{j}\n:for: j = 1..", "a range such as j = 0..2"),
            (":printed: r = x y\n:for: 0 \\le y \\le 1", "a range such as j = 0..2"),
            (":let: x \\ne 0\n:printed: r = x", "line 7: "),
            (":let: p_0 \\le p_1\n:printed: r = x", "conditions stand in :where:"),
            (":use: bernsten B_i^n(t)\n:printed: r = x", "bernsten"),
            (":use: bernstein B_i^n(t)", "there is no :printed:"),
            (":for: j = 0..1", "there is no :printed:"),
            (":printed: x + 1 = 1 + x", "none of the outputs"),
            (":printed: r = 2x, \\quad r + x = r + x", "both sides are the same"),
            (":output: p[3]\n:printed: p_0 = p_1 + x", "a name that is an input, too, is the input"),
        ]:
            with self.subTest(lines):
                self.refused(good % lines, words)
        v = self.verdict(good % ":printed: r = j x\n:for: j = 1..0")
        self.assertEqual((v["verdict"], "a range is empty, so that nothing is compared" in v["because"]), ("undecided", True))
        v = self.verdict(good % ":let: z \\in \\mathbb{R}\n:printed: r = \\int_0^x \\frac{z^2 - z}{z - 1} dz")
        self.assertEqual((v["verdict"], "the variable of an integral" in v["because"]), ("undecided", True))
        v = self.verdict(good % ":printed: r = p_3")
        self.assertEqual((v["verdict"], "a name without a value" in v["because"]), ("undecided", True))
        v = self.verdict(good % ":printed: r = \\sqrt{x}")
        self.assertEqual(v["verdict"], "undecided")
        self.assertRegex(v["because"], "^a root that is no rational function, at .*page.md:7 in the formula$")

    def test_outputs_in_what_names_mean(self):
        code = "double f(double x) { return 2 * x; }"
        for definition, verdict in [("H = s^2", "proved"), ("H = s", "differs")]:
            v = self.of(code, "x", "double s = f(x);", f":output: s\n:let: {definition}\n:printed: H = 4x^2")
            self.assertEqual(v["verdict"], verdict)

    def test_inputs_with_the_names_of_roots_and_cosines(self):
        """A root is a variable of its own, and so is a cosine: whatever the inputs are called."""
        for name, code in [("root1", "double f(double a, double x) { return sqrt(x) == a; }"), ("cos1", "double f(double a, double x) { return cos(x) == a; }")]:
            block = (f":::{{exactly}} it\n:source: code.c\n:declare: double f(double, double);\n:input: {name}; x > 0\n:where: {name} < -1\n"
                     f":call: double s = f({name}, x);\n:expect: s = 0\n:::\n")
            v = self.verdict(block, "#include <math.h>\n" + code)
            self.assertEqual(v["verdict"], "proved", v.get("because"))

    def test_inputs_with_several_such_names_in_any_place(self):
        for names in [["x > 0", "root1", "root2"], ["root2", "x > 0", "root1"], ["a", "root2", "root1", "x > 0"]]:
            block = (f":::{{exactly}} it\n:include: <math.h>\n:input: {'; '.join(names)}\n:where: root1 < -1\n:where: root2 < -1\n"
                     ":call: double s = sqrt(x) == root1 || sqrt(x + 1) == root2;\n:expect: s = 0\n:::\n")
            v = self.verdict(block)
            self.assertEqual(v["verdict"], "proved", v.get("because"))

    def test_our_kernels(self):
        block = (":::{exactly} it\n:include: \"core/kernels/kernels_d.h\"\n:input: p[8]; t\n:call: double a[2], b[2]; bezier_casteljau_d(3, 2, p, t, a);\n"
                 "   bezier_horner_d(3, 2, p, t, b);\n:expect: a[2] = b\n:output: a[2]\n:use: bernstein B_i^n(t)\n"
                 ":printed: a_c = \\sum_{i=0}^3 B_i^3(t) p_{2i+c}\n:for: c = 0, 1\n:::\n")
        self.assertEqual(self.verdict(block)["verdict"], "proved")


class Mistakes(Exactly):
    GOOD = ":::{exactly} it\n:input: x\n:call: double r = x;\n:expect: r = x\n:::\n"

    def test_the_good_one(self):
        self.assertEqual(self.verdict(self.GOOD)["verdict"], "proved")

    def test_what_is_known_has_a_line(self):
        block = Verdicts.BLOCK.replace(":call:", ":known: %s\n:call:", 1)
        for known in ["code.c = 1", "code.c:x = 1", ":3 = 1", "code.c:3[0] = x", "code.c:3 + 1 = x"]:
            self.refused(block % (known, "x"), "FILE:LINE = what that line puts into a variable")

    def test_lines(self):
        for words, wrong in [
            ("no block is in it; expected one that begins with :::{exactly} NAME", "text\n"),
            ("line 3: the block has no name", ":::{exactly}\n:::\n"),
            ("the block does not end", self.GOOD.replace(":::\n", "")),
            ("line 4: \"2x\": a name", self.GOOD.replace("input: x", "input: 2x")),
            ("a number of elements from 1 to 1000", self.GOOD.replace("input: x", "input: x[0]")),
            ("x is an input already", self.GOOD.replace("input: x", "input: x; x")),
            ("\"big\" is not known", self.GOOD.replace("input: x", "input: x big")),
            ("is no number", self.GOOD.replace("input: x", "input: x = 1/0")),
            ("x has 1 values; 2 were expected", self.GOOD.replace("input: x", "input: x[2] = 1")),
            ("more values than the 1 expected", self.GOOD.replace("input: x", "input: x = 1 2")),
            ("a range like [0, 1]", self.GOOD.replace("input: x", "input: x in 3")),
            ("\"z\" is no end of a range", self.GOOD.replace("input: x", "input: x in [0, z]")),
            ("\"z[2]\" is no end of a range", self.GOOD.replace("input: x", "input: z[2]; x in [0, z[2]]")),
            ("\"z[-1]\" is no end of a range", self.GOOD.replace("input: x", "input: z[2]; x in [z[-1], 1]")),
            ("\"z[1]0\" is no end of a range", self.GOOD.replace("input: x", "input: z[2]; x in [0, z[1]0]")),
            ("\"z\" is no end of a range", self.GOOD.replace("input: x", "input: z[2]; x in [0, z]")),
            ("\"z[0]\" is no end of a range", self.GOOD.replace("input: x", "input: z; x in [0, z[0]]")),
            ("\"x\" is no end of a range", self.GOOD.replace("input: x", "input: x in [0, x]")),
            ("there is no key \"inputs\"", self.GOOD.replace("input", "inputs")),
            ("there is no :call:", self.GOOD.replace(":call: double r = x;\n", "")),
            ("neither :expect: nor :output:", self.GOOD.replace(":expect: r = x\n", "")),
            ("what it should be", self.GOOD.replace("r = x\n", "r\n")),
            ("a number of points", self.GOOD.replace(":call", ":points: many\n:call")),
            ("\"refuse\" or \"enclose\"", self.GOOD.replace(":call", ":roots: no\n:call")),
            ("more than 88 variables", self.GOOD.replace("input: x", "input: x; y[88]")),
            ("the end of the block", self.GOOD.replace(":call", "call")),
        ]:
            with self.subTest(words):
                self.refused(wrong, words)

    def test_a_file_that_is_not_there(self):
        ran = run(self.folder / "none.md")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("No such file or directory; expected the file of blocks", ran.stderr)

    def test_a_file_that_is_no_text(self):
        path = self.folder / "binary.md"
        path.write_bytes(self.GOOD.encode() + b"\0:::")
        ran = run(path)
        self.assertEqual(ran.returncode, 2)
        self.assertIn("is no text", ran.stderr)

    def test_a_block_that_is_not_there(self):
        ran = run(self.harness(self.GOOD), "--only", "other")
        self.assertEqual(ran.returncode, 2)
        self.assertIn("no block is named 'other'", ran.stderr)

    def test_what_clang_says_names_the_page_and_its_line(self):
        ran = run(self.harness(self.GOOD.replace("double r = x;", "double r = z;")))
        self.assertEqual(ran.returncode, 2)
        self.assertRegex(ran.stderr, r"page\.md:5:\d+: error: use of undeclared identifier 'z'")


if __name__ == "__main__":
    unittest.main(verbosity=2)
