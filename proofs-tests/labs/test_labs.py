"""cagd lab as its users meet it: a student from start to full marks, a lecturer with a lab of one's own and a class.

    python3 test_labs.py CAGD ROOT
"""
import concurrent.futures
import csv
import fractions
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

ROOT = pathlib.Path(sys.argv.pop(2)).resolve()
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
LABS = ROOT / "chapters/labs"
CACHE = tempfile.TemporaryDirectory()
os.environ["XDG_CACHE_HOME"] = CACHE.name


def run(*args, **options):
    return subprocess.run([CAGD, "lab", *map(str, args)], capture_output=True, text=True, timeout=600, **options)


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def checked(self, source, *options):
        (self.folder / "de-casteljau.c").write_text(source)
        ran = run("check", self.folder, "--json", *options)
        self.assertIn(ran.returncode, (0, 1), ran.stderr)
        return json.loads(ran.stdout)


RIGHT = (LABS / "de-casteljau/right/iterative.c").read_text()


class Student(InFolder):
    def test_list_has_every_lab_in_two_languages(self):
        rows = json.loads(run("list", "--json").stdout)["labs"]
        self.assertEqual([r["name"] for r in rows], sorted(p.parent.name for p in LABS.glob("*/lab.md")))
        for r in rows:
            self.assertTrue(r["title"] and r["zh"] and r["chapter"] and r["learn"] and r["points"] > 0, r)

    def test_places_in_the_texts_are_there(self):
        """The same in both languages of every assignment, and `cagd show` has them."""
        for page in sorted(LABS.glob("*/README.md")):
            parts, lab = re.split(r"(?m)^# ", page.read_text())[1:], (page.parent / "lab.md").read_text()
            english, chinese = (re.findall(r"`cagd show ([^`]+)`", part) for part in parts)
            with self.subTest(page.parent.name):
                self.assertEqual(english, chinese)
                if page.parent.name.startswith("mistake-"):  # it would show what is wrong; the text is named
                    self.assertEqual([english, *(bool(re.search(r"`(wang-ch3|deng-zhang-2022)`", part)) for part in parts)], [[], True, True])
                else:
                    self.assertTrue(english or ":chapter: fitting" in lab)
                for name in english:
                    self.assertEqual(subprocess.run([CAGD, "show", name], capture_output=True).returncode, 0, name)

    def test_from_start_to_full_marks(self):
        place = self.folder / "mine"
        self.assertEqual(run("start", "de-casteljau", place).returncode, 0)
        self.assertEqual(sorted(p.name for p in place.iterdir()), ["Makefile", "README.md", "de-casteljau.c", "figure.svg"])
        begun = run("check", place)
        self.assertEqual(begun.returncode, 1)
        self.assertIn("0 of 10 points", begun.stdout)
        (place / "de-casteljau.c").write_text(RIGHT)
        done = run("check", place)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("right for all inputs, n = 1 to n = 6", done.stdout)
        self.assertIn("10 of 10 points", done.stdout)

    def test_nothing_is_written_over(self):
        self.assertEqual(run("start", "de-casteljau", self.folder).returncode, 0)
        self.assertEqual(run("start", "de-casteljau", self.folder).returncode, 2)

    def test_a_small_counterexample_and_its_misconception(self):
        result = self.checked(RIGHT.replace("(1 - t) * b[i] + t * b[i + 1]", "t * b[i] + (1 - t) * b[i + 1]"))
        row = result["requirements"][0]
        self.assertEqual(row["verdict"], "wrong")
        self.assertEqual(row["case"], "n = 1")
        self.assertEqual(row["hint"]["name"], "exchanged")
        for values in row["inputs"].values():
            for value in values:
                self.assertLessEqual(len(value.strip("-")), 1, row)

    def test_a_branch_that_no_random_point_takes_is_found(self):
        result = self.checked(RIGHT.replace("double b[n + 1];", "if (t == 0.123456789) return 7;\n    double b[n + 1];", 1))
        self.assertEqual(result["requirements"][0]["verdict"], "wrong")
        result = self.checked(RIGHT.replace(
            "double b[n + 1];", "if (t > 0.75 && t < 0.750000000001) return 7;\n    double b[n + 1];", 1))
        self.assertEqual(result["requirements"][0]["verdict"], "wrong")

    def test_a_branch_that_two_borders_close_together_is_found(self):
        for condition in ("n == 3 && (p[0] - 1.23456) * (p[1] - 2.34567) > 0 && p[0] - 1.23456 < 1e-12 && p[0] > 1.23456 && "
                          "(p[3] - 5.4321) * (p[3] - 5.4321) < 1e-18",
                          "n == 1 && ({ double y = 1; for (int k = 0; k < 20; k++) y *= p[0] - 3.3; y < 1e-60; })"):
            result = self.checked(RIGHT.replace("double b[n + 1];", f"if ({condition}) return 7;\n    double b[n + 1];", 1))
            self.assertEqual(result["requirements"][0]["verdict"], "wrong", condition)

    def test_a_branch_inside_a_border_that_is_no_line_is_found(self):
        for condition in ("(t - 0.3) * (t - 0.3) < 1e-20", "(3 * t - 1) * (3 * t - 1) == 0", "(t * t - 2) * (t * t - 2) < 1e-40",
                          "(3 * t - 1) * (3 * t - 1) + (7 * p[0] - 1) * (7 * p[0] - 1) < 1e-30", "(p[0] - t) * (p[0] - t) < 1e-40"):
            result = self.checked(RIGHT.replace("double b[n + 1];", f"if ({condition}) return 7;\n    double b[n + 1];", 1))
            self.assertEqual(result["requirements"][0]["verdict"], "wrong", condition)
        result = self.checked(RIGHT.replace("double b[n + 1];", "if (t * t + 1 < 0) return 7;\n    double b[n + 1];", 1))
        self.assertEqual(result["requirements"][0]["verdict"], "proved")

    def test_what_is_kept_is_named_however_late_it_matters(self):
        for top, inside, name in (("", "static int calls; if (++calls > 100000) return 7;", "calls, in line 6"),
                                  ("static double last;\n", "last = t;", "last, in line 7"), ("static char s[3];\n", 'strcpy(s, "1");', "s")):
            result = self.checked(top + RIGHT.replace("double b[n + 1];", inside + "\n    double b[n + 1];", 1))
            row = result["requirements"][-1]
            variable, _, line = name.partition(", in line ")
            self.assertEqual((row["points"], row["text"]), (0, f"remembers earlier calls: {variable} outlives them, and changes"))
            self.assertEqual(str(row.get("line", "")), line)
        table = "static double one[2] = {1, 1}; if (one[n > 1] != 1) return 7;"
        self.assertEqual(self.checked(RIGHT.replace("double b[n + 1];", table + "\n    double b[n + 1];", 1))["points"], 10)

    def test_what_rounding_and_cost_are_against_the_best_known(self):
        """The least error and the fewest operations of the right solutions."""
        plain = self.checked(RIGHT)["measured"]
        self.assertEqual((plain["case"], plain["operations"], plain["best_operations"], plain["stable"]), ("n = 6", 63, 63, True))
        self.assertLessEqual(plain["best_ulps"], plain["ulps"])
        costly = self.checked((LABS / "de-casteljau/right/recursive.c").read_text())["measured"]
        self.assertGreater(costly["operations"], 800)
        self.assertEqual((costly["best_operations"], costly["best_ulps"]), (63, plain["best_ulps"]))
        lossy = RIGHT.replace("right[n - r] = b[n - r];", "right[n - r] = b[n - r] + 1e6 * t - 1e6 * t;")
        self.assertNotEqual(lossy, RIGHT)
        result = self.checked(lossy)
        self.assertEqual((result["points"], result["measured"]["stable"], result["measured"]["best_ulps"]), (10, False, plain["best_ulps"]))
        self.assertIn("not stable at 12 points that were drawn: ", " ".join(run("check", self.folder).stdout.split()))
        lost = self.checked(RIGHT.replace("right[n - r] = b[n - r];", "right[n - r] = b[n - r] + (t * 1e300 * 1e300 - t * 1e300 * 1e300);"))
        self.assertEqual(lost["points"], 10)
        self.assertNotIn("measured", lost)
        self.assertIn("in binary64 no number comes out at some point that was drawn, where exactly one does", [n["text"] for n in lost["notes"]])

    def test_a_picture_of_what_is_wrong(self):
        picture = self.folder / "difference.svg"
        wrong = RIGHT.replace("(1 - t) * b[i] + t * b[i + 1]", "t * b[i] + (1 - t) * b[i + 1]").replace("right[n - r]", "right[0]")
        graph = self.checked(wrong, "--svg", picture)["requirements"][0]["graph"]
        self.assertEqual((graph["of"], graph["over"], graph["at"][0], graph["at"][-1]), ("R", "t", "0", "1"))
        self.assertIn(graph["here"], graph["at"])
        self.assertNotEqual(graph["got"], graph["expected"])
        self.assertEqual(xml.dom.minidom.parse(str(picture)).documentElement.tagName, "svg")
        picture.unlink()
        (self.folder / "de-casteljau.c").write_text(RIGHT)
        ran = run("check", self.folder, "--svg", picture)
        self.assertEqual((ran.returncode, len(ran.stderr.splitlines()), picture.exists()), (0, 1, False))

    def test_a_value_that_was_never_computed_is_bad_manners(self):
        for top, inside, says in (("", "int calls; if (calls == 77) return 7; calls = 77;", "uses calls, which has no value yet"),
                                  ("", "int k[3]; if (k[1] == 77) return 7; k[1] = 77;", "decides by a value that was never computed"),
                                  ("#include <stdlib.h>\n", "int *m = malloc(8); if (*m == 77) { free(m); return 7; } *m = 77; free(m);",
                                   "decides by a value that was never computed")):
            row = self.checked(top + RIGHT.replace("double b[n + 1];", inside + "\n    double b[n + 1];", 1))["requirements"][-1]
            self.assertEqual((row["points"], row["text"]), (0, says))
            self.assertEqual(row["line"], RIGHT[:RIGHT.index("double b[n + 1];")].count("\n") + 1 + (top != ""))

    def test_a_division_by_zero_is_found_and_what_the_reference_divides_by_is_none(self):
        result = self.checked(RIGHT.replace("double b[n + 1];", "double s = (7 * t - 2) / (7 * t - 2);\n    t *= s;\n    double b[n + 1];", 1))
        row = result["requirements"][0]
        self.assertEqual((row["verdict"], row["text"], row["inputs"]["t"]), ("stopped", "divides by zero, in line 6", ["2/7"]))

    def test_a_whole_number_that_may_be_any_is_undecided(self):
        for condition in ("(int)(p[0] * 1000) == 31400 + 15", "n == 2 && floor(p[0] * 1000) == 12345 && floor(p[1] * 1000) == -777"):
            row = self.checked("#include <math.h>\n" + RIGHT.replace("double b[n + 1];", f"if ({condition}) return 7;\n    double b[n + 1];", 1))["requirements"][0]
            self.assertEqual((row["verdict"], row["points"], row["line"]), ("undecided", 0, 7), row)

    def test_addresses_decide_nothing(self):
        for top, condition in (("static double g;\n", "({ double x; (&x - &g) % 4099 == 77; })"), ("", "p < &t"),
                               ("#include <stdlib.h>\n", "({ char *a = malloc(24), *c = malloc(24); int less = a < c; free(a); free(c); !less; })")):
            row = self.checked(top + RIGHT.replace("double b[n + 1];", f"if ({condition}) return 7;\n    double b[n + 1];", 1))["requirements"][0]
            self.assertEqual((row["verdict"], row["text"].partition(",")[0]), ("stopped", "addresses of different arrays are compared"), condition)
        inside = "const double *end = p + n, *at = p; while (at < end) at++; if (at - p != n) return 7;"
        self.assertEqual(self.checked(RIGHT.replace("double b[n + 1];", inside + "\n    double b[n + 1];", 1))["points"], 10)

    def test_all_ways_are_closed(self):
        lab = LABS / "basis-functions"
        (self.folder / "basis-functions.c").write_text((lab / "right/iterative.c").read_text())
        rows = json.loads(run("check", self.folder, "--json").stdout)["requirements"]
        self.assertEqual([r["text"].split(" ways ")[-1] for r in rows[:3]], ["that there are"] * 3)

    def test_no_number_is_a_solution_of_an_equation_with_irrational_solutions_alone(self):
        circle = (LABS / "nurbs-circle/right/plain.c").read_text()
        changed = circle.replace("w[i] = i % 2 == 0 ? 1 : s;", "w[i] = i % 2 == 0 ? 1 : s * s == 0.5 ? 1 : s;")
        self.assertNotEqual(circle, changed)
        (self.folder / "nurbs-circle.c").write_text(changed)
        rows = json.loads(run("check", self.folder, "--json").stdout)["requirements"]
        self.assertEqual(rows[1]["verdict"], "proved")

    def test_a_comparison_that_rounding_turns_is_told(self):
        result = self.checked(RIGHT.replace("double b[n + 1];", "if ((1e16 + t) - 1e16 != t) return 7;\n    double b[n + 1];", 1))
        self.assertEqual([(n["line"], "another way" in n["text"]) for n in result["notes"]], [(6, True)])

    def test_a_right_branch_stays_right(self):
        result = self.checked(RIGHT.replace("double b[n + 1];", "if (t == 0) return p[0];\n    double b[n + 1];", 1))
        self.assertEqual(result["points"], 10, result)
        self.assertIn("each of the", result["requirements"][0]["text"])

    def test_errors_of_the_compiler_have_their_line(self):
        result = self.checked("double point(int n, const double *p, double t)\n{\n    return x;\n}\n")
        self.assertIn("line 3: use of undeclared identifier 'x'", result["compiler"])

    def test_a_function_that_is_not_there_and_a_result_that_is_not_put(self):
        """Neither has a line of the answer."""
        result = self.checked(RIGHT.replace("double point(", "double pont(").replace("left[", "right["))
        point, left = result["requirements"][:2]
        self.assertEqual((point["verdict"], point["text"], point["line"]), ("stopped", "there is no function point", 0), point)
        self.assertEqual((left["text"], left["line"]), ("left[0] was never computed", 0), left)
        self.assertEqual(result["requirements"][3]["text"], "there is no function point")

    def test_lines_are_those_of_the_answer_behind_headers_too(self):
        result = self.checked("#include <math.h>\n#include <stdio.h>\n" + RIGHT.replace("return b[0];", "return x;"))
        self.assertIn("use of undeclared identifier 'x'\n        return x;", result["compiler"])
        result = self.checked("#include <stdlib.h>\n" + RIGHT.replace("return b[0];", 'system("true");\n    return b[0];'))
        line = RIGHT[:RIGHT.index("return b[0];")].count("\n") + 2
        self.assertEqual(result["refused"], f"line {line}: system is no function for an assignment")

    def test_another_type_is_an_error(self):
        result = self.checked(RIGHT.replace("double point(int n,", "float point(int n,"))
        self.assertIn("conflicting types for 'point'", result["compiler"])

    def test_float_is_named(self):
        result = self.checked(RIGHT.replace("double b[n + 1];", "float b[n + 1];\n    for (int i = 0; i <= n; i++) b[i] = p[i];", 1)
                              .replace("memcpy(b, p, sizeof b);", "", 1))
        self.assertIn("float", result["notes"][0]["text"])
        self.assertEqual(result["notes"][0]["line"], 6)

    def test_printing_is_bad_manners(self):
        result = self.checked("#include <stdio.h>\n" + RIGHT.replace("return b[0];", 'printf("point 4 of 4\\n");\n    return b[0];'))
        self.assertEqual(result["points"], 8, result)
        self.assertEqual(result["requirements"][-1]["text"], "prints")

    def test_there_is_no_lab(self):
        ran = run("check", self.folder)
        self.assertEqual((ran.returncode, len(ran.stderr.splitlines())), (2, 1))


PYTHON = (LABS / "de-casteljau-python/right/iterative.py").read_text()


class Levels(InFolder):
    """Which level of a triangle, and which point of it, is the first that an answer does not compute."""

    def told(self, lab, file, *changes):
        """{requirement: what is told of levels}, of a right solution in which texts are replaced."""
        source = (LABS / lab / "right" / file).read_text()
        for old, new in changes:
            self.assertEqual(source.count(old), 1, old)
            source = source.replace(old, new)
        (self.folder / (lab + pathlib.Path(file).suffix)).write_text(source)
        ran = run("check", self.folder, "--lab", lab, "--json")
        rows = json.loads(ran.stdout)["requirements"]
        self.assertTrue(any(row["verdict"] == "wrong" for row in rows), rows)
        return {row["name"]: row["levels"] for row in rows if "levels" in row}

    def test_the_first_point_that_is_not_computed_is_named(self):
        step = "b[i] = (1 - t) * b[i] + t * b[i + 1];\n    return b[0];"
        for lab, file, requirement, old, new, begins in (
                ("de-casteljau", "iterative.c", "point", step, "b[i] = (1 - (r == 2) - t) * b[i] + t * b[i + 1];\n    return b[0];",
                 "level 1 is computed; b_0^2 "),
                ("de-casteljau", "iterative.c", "point", "r <= n; r++)\n        for (int i = 0; i <= n - r; i++)\n            " + step,
                 "r <= n; r++)\n        for (int i = 0; i < n - r; i++)\n            " + step,
                 "for n = 6: the first 5 points of level 1 are computed; b_5^1 is not"),
                ("de-casteljau", "recursive.c", "right", "point(n - k, p + k, t)", "point(n - k, p, t)",
                 "for n = 6: the whole triangle is computed"),
                ("de-casteljau-python", "iterative.py", "point", "b[i] = (1 - t) * b[i]", "b[i] = (1 - t - int(r == 2)) * b[i]",
                 "level 1 is computed; b_0^2 "),
                ("rational-casteljau", "iterative.c", "point", "b[i] = left + right;", "b[i] = k < 2 ? left + right : b[i];",
                 "level 1 is computed; (R,w)_0^2 "),
                ("derivatives", "iterative.c", "derivative", "(b[i + 1] - b[i])", "(b[i + 1] - (1 + (k == 1)) * b[i])",
                 "level 1 is computed; P_0^(2) "),
                ("divided-differences", "iterative.c", "differences", "/ (x[i] - x[i - k])", "/ (x[i] - x[i - 1])",
                 "level 1 is computed; [x_0,…,x_2]f "),
                ("basis-functions", "iterative.c", "index", "(u[i + j + k] - u[i + j]) * b[j]", "(u[i + j + 1] - u[i + j]) * b[j]",
                 "level 1 is computed; N_1,2 "),
                ("knot-insertion", "iterative.c", "refine", "a * c[i]", "a * c[i] * (n > 3 ? 2 : 1)",
                 "level 1 is computed, and the first 2 points of level 2; Q_2^2 ")):
            with self.subTest(lab=lab, new=new):
                told = self.told(lab, file, (old, new))[requirement]
                self.assertTrue(told.startswith(begins), told)

    def test_its_number_is_right(self):
        step = "b[i] = (1 - t) * b[i] + t * b[i + 1];\n    return b[0];"
        told = self.told("de-casteljau", "iterative.c", (step, step.replace("(1 -", "(1 - (r == 2) -")))["point"]
        numbers = re.fullmatch(r".*: for p = (.*); t = (.*) it is (.*); the first other number from the same place, line 10, is (.*)", told)
        p, (t,), (right,), (wrong,) = ([fractions.Fraction(x) for x in part.split(",")] for part in numbers.groups())
        below = [(1 - t) * a + t * b for a, b in zip(p, p[1:])]
        self.assertEqual((right, wrong), ((1 - t) * below[0] + t * below[1], -t * below[0] + t * below[1]))

    def test_nothing_is_told_of_a_triangle_where_none_is_computed(self):
        """Right solutions, each in its own style, to whose result 1 is added: all of a triangle, or nothing."""
        for lab, name, parameters, arguments, whole in (
                ("de-casteljau", "point", "int n, const double *p, double t", "n, p, t", {"iterative.c", "recursive.c"}),
                ("rational-casteljau", "point", "int n, const double *p, const double *w, double t", "n, p, w, t", {"iterative.c", "recursive.c"}),
                ("divided-differences", "value", "int n, const double *x, const double *f, double t", "n, x, f, t", {"iterative.c", "recursive.c"}),
                ("basis-functions", "basis", "int i, int p, const double *u, double t", "i, p, u, t", {"iterative.c", "recursive.c"})):
            for path in sorted((LABS / lab / "right").iterdir()):
                with self.subTest(path=path):
                    source = (f"#define {name} right_one\n{path.read_text()}\n#undef {name}\n"
                              f"double {name}({parameters}) {{ return right_one({arguments}) + 1; }}\n")
                    (self.folder / (lab + ".c")).write_text(source)
                    rows = json.loads(run("check", self.folder, "--lab", lab, "--json").stdout)["requirements"]
                    told = {row["levels"].partition("the ")[2] for row in rows if "levels" in row}
                    self.assertTrue(any(row["verdict"] == "wrong" for row in rows), rows)
                    self.assertEqual(told, {"whole triangle is computed: what is wrong is what becomes of it"} if path.name in whole else set())


class InPython(InFolder):
    def judged(self, source):
        (self.folder / "de-casteljau-python.py").write_text(source)
        ran = run("check", self.folder, "--json")
        self.assertIn(ran.returncode, (0, 1), ran.stderr)
        return json.loads(ran.stdout)

    def test_right_for_all_inputs(self):
        result = self.judged(PYTHON)
        self.assertEqual(result["points"], result["of"])
        self.assertEqual(result["requirements"][0]["text"], "right for all inputs, n = 1 to n = 5")

    def test_a_branch_that_no_random_point_takes_is_found(self):
        result = self.judged(PYTHON.replace("b = list(p)", "b = list(p)\n    if 4 * t > 3 and t < 0.750000000001:\n        return 7"))
        self.assertEqual(result["requirements"][0]["verdict"], "wrong", result["requirements"][0])

    def test_a_pole_and_a_division_by_zero_are_found(self):
        for condition in ("t != 0.25 and 1 / (t - 0.25) > 10 ** 20", "(3 * t - 1) ** 2 == 0", "1 / (3 * t - 1) == 0"):
            result = self.judged(PYTHON.replace("b = list(p)", f"b = list(p)\n    if {condition}:\n        return 7"))
            self.assertIn(result["requirements"][0]["verdict"], ("wrong", "stopped"), condition)

    def test_a_right_branch_stays_right(self):
        result = self.judged(PYTHON.replace("b = list(p)", "b = list(p)\n    if t == 0:\n        return p[0]"))
        self.assertEqual(result["points"], result["of"], result["requirements"])
        self.assertIn("each of the", result["requirements"][0]["text"])

    def test_a_third_is_a_third_and_a_root_is_refused(self):
        result = self.judged(PYTHON.replace("return b[0]", "return 3 * (1 / 3) * b[0]"))
        self.assertEqual(result["points"], result["of"], result["requirements"])
        result = self.judged("import math\n" + PYTHON.replace("return b[0]", "return math.sqrt(b[0]) ** 2"))
        self.assertIn("not exact", result["requirements"][0]["text"])

    def test_what_is_kept_is_named(self):
        cache = "import functools\n@functools.lru_cache(None)\ndef row(n):\n    return [1] * n\n"
        for top, inside, name in (("calls = []\n", "calls.append(1)", "calls"), ("import itertools\nc = itertools.count()\n", "next(c)", "c"),
                                  ("", "point.k = 1", "point"), ("", "global q; q = 3", "q"), (cache, "row(2).append(t)", "what a cache remembers"),
                                  (cache, "row(2)[0] * t", "")):
            row = self.judged(top + PYTHON.replace("b = list(p)", inside + "; b = list(p)"))["requirements"][-1]
            self.assertEqual(row["text"], f"remembers earlier calls: {name} outlives them, and changes" if name else "nothing was seen")

    def test_ways_out_lead_nowhere(self):
        for way in ("().__class__", "open('/etc/passwd')", "eval('1')", "point.func_globals", "(x for x in p).gi_frame",
                    "getattr(p, 'x')", "globals()", "__builtins__"):
            result = self.judged(PYTHON.replace("return b[0]", f"return ({way}, b[0])[1]"))
            self.assertEqual(result["points"], 0, way)
            self.assertIn("refused", result, way)
        for module in ("os", "sys", "ctypes", "subprocess", "operator.attrgetter"):
            name, _, part = module.partition(".")
            line = f"from {name} import {part}" if part else f"import {name}"
            self.assertIn("refused", self.judged(line + "\n" + PYTHON), module)
        for inner in ("fractions.sys", "functools.GenericAlias", "operator.methodcaller"):  # no name of the module as an answer has it
            result = self.judged(f"import {inner.split('.')[0]}\n" + PYTHON.replace("return b[0]", f"return ({inner}, b[0])[1]"))
            self.assertEqual(result["requirements"][0]["verdict"], "stopped", inner)

    def test_no_digits_decide(self):
        for text in ("str(t)", "repr(p[0])", "f'{t}'", "'%s' % t", "str([t])", "str(ValueError(t))", "t.value", "t.function"):
            row = self.judged(PYTHON.replace("return b[0]", f"return b[0] if {text} != '1/7' else 7"))["requirements"][0]
            self.assertEqual((row["verdict"], row["points"]), ("stopped", 0), text)
        self.assertIn("refused", self.judged(PYTHON.replace("return b[0]", "return b[0] if '{0.numerator}'.format(t) else 7")))
        rows = self.judged(PYTHON.replace("return b[0]", "print(t, p)\n    return b[0]"))["requirements"]
        self.assertEqual([(row["verdict"], row["text"]) for row in rows if row["points"] == 0], [("unclean", "prints")])

    def test_what_the_field_cannot_carry_is_no_way_to_know_it(self):
        grows = ("def hidden(p):\n    x = p[0]\n    try:\n        for k in range(12):\n            x = x * (x + p[0] * p[1]) + p[1]\n"
                 "    except Exception:\n        return True\n    return False\n\n\n")
        row = self.judged(grows + PYTHON.replace("return b[0]", "return b[0] if hidden(p) or t != 0.109375 else 7"))["requirements"][0]
        self.assertEqual((row["verdict"], row["points"]), ("undecided", 0))
        row = self.judged("def deep(n):\n    try:\n        return deep(n + 1)\n    except Exception:\n        return n\n\n\n" +
                          PYTHON.replace("return b[0]", "return b[0] if deep(0) else 7"))["requirements"][0]
        self.assertEqual((row["verdict"], row["text"]), ("stopped", "RecursionError is caught"))
        self.assertIn("refused", self.judged(PYTHON.replace("return b[0]", "try:\n        return b[0]\n    finally:\n        return 7")))

    def test_memory_time_and_depth_are_bounded(self):
        for code, says in (("x = [0] * 10 ** 10", "memory"), ("x = 9 ** 9 ** 9", ""), ("x = point(p, t)", "without end")):
            row = self.judged(PYTHON.replace("return b[0]", code + "\n    return b[0]"))["requirements"][0]
            self.assertEqual(row["verdict"], "stopped", code)
            self.assertIn(says, row["text"])


class Numbers(InFolder):
    def judged(self, text):
        (self.folder / "mistake-arc.txt").write_text(text)
        return json.loads(run("check", self.folder, "--json").stdout)

    def test_numbers_are_ranked_and_formulas_compared(self):
        right = (LABS / "mistake-arc/right/small.txt").read_text()
        result = self.judged(right)
        self.assertEqual(result["points"], result["of"])
        self.assertEqual(result["requirements"][0]["text"], "right, decided exactly")
        self.assertIn("3 digits", result["notes"][0]["text"])

    def test_what_is_no_number_has_its_line(self):
        for text, line in (("counterexample = 1, x", 1), ("\n\nf(l) = l +", 3), ("f(l) = q", 1), ("a = 1/0", 1), ("a = 1234567890123456", 1),
                           ("a = 1; system(\"x\")", 1), ("f(l) = l } int x {", 1), ("cagd_x = 1", 1)):
            result = self.judged(text)
            self.assertIn(f"line {line}:", result["compiler"], text)
            self.assertEqual(result["points"], 0)


NOBODY = "p[0] * p[0] * p[0] == p[1] * p[1] + 1e-30"  # whether fractions are solutions is not known here


class Branches(InFolder):
    """A branch that is not known to be taken by no numbers leaves the points to a person, whatever it does."""

    def verdicts(self, changes, right=RIGHT, lab="de-casteljau"):
        """Of each changed solution the row of its first requirement."""
        def row(change):
            old, new, top = change
            self.assertIn(old, right)
            folder = tempfile.mkdtemp(dir=self.folder)
            pathlib.Path(folder, lab + (".c" if right == RIGHT else ".py")).write_text(top + right.replace(old, new, 1))
            return json.loads(run("check", folder, "--json").stdout)["requirements"][0]
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            return list(pool.map(row, changes))

    def look(self, wanted, changes):
        for change, row in zip(changes, self.verdicts(changes)):
            self.assertEqual((row["verdict"], row["points"]), (wanted, 4 if wanted == "proved" else 0), (change, row))

    @staticmethod
    def returning(condition, what="7", top="#include <math.h>\n"):
        return "double b[n + 1];", f"if ({condition}) return {what};\n    double b[n + 1];", top

    def test_what_nobody_knows_has_no_points(self):
        others = f"static int bad(const double *p) {{ return {NOBODY}; }}\n"
        difference = "p[0] * p[0] * p[0] - p[1] * p[1] - 1e-30"
        self.look("undecided", [
            self.returning(NOBODY), self.returning("n == 3 && " + NOBODY), self.returning("bad(p)", top=others),
            self.returning(NOBODY, "t"), self.returning(f"fabs({difference}) == 0"),
            self.returning(f"fmax({difference}, 0) == fmin({difference}, 0)"), self.returning(f"({NOBODY}) && t * t * t == t + 1e-20"),
            self.returning("p[0] * p[0] + p[1] * p[1] == 3"), self.returning("(t - 1e-300) * (t * t - 2) == 0"),
            self.returning("p[0] * p[0] * p[0] + p[1] * p[1] * p[1] == t * t * t && p[0] * p[1] * t != 0"),
            self.returning("(p[0] * p[0] + p[1] * p[1] - 2) * (p[0] * p[0] + p[1] * p[1] - 2) < 1e-20 && "
                           "(p[0] * p[1] - 0.3) * (p[0] * p[1] - 0.3) < 1e-20"),
            self.returning("fabs(p[0] * p[0] - p[1] - 0.123) < 1e-15 && fabs(p[1] * p[1] - t - 0.77) < 1e-15 && "
                           "fabs(t * t - p[0] - 0.3) < 1e-15"),
            ("double b[n + 1];", "for (int k = 0; k < n; k++) if (p[k] * p[k] * p[k] == p[k + 1] * p[k + 1] + 1e-30) return 7;\n"
                                 "    double b[n + 1];", ""),
            ("double b[n + 1];", f"switch (({difference} > 0) + ({difference} < 0)) {{ case 0: return 7; }}\n    double b[n + 1];", ""),
            ("return b[0];", f"return {NOBODY} ? 7 : b[0];", ""), ("return b[0];", f"return b[0] + 7 * ({NOBODY});", ""),
            self.returning("n == 1 && p[0] * p[1] == 1", "(1 - t) * p[0] + t * p[1] + (p[0] - 1) * (p[0] + 1) * (p[0] - 2) * (2 * p[0] - 1)")])

    def test_a_branch_that_is_met_is_judged(self):
        self.look("wrong", [self.returning("p[0] * p[0] + p[1] * p[1] == 3 * t * t"), self.returning("p[0] * p[0] + p[1] * p[1] == 2"),
                            self.returning("p[0] * p[0] + p[1] * p[1] < 1e-40"), self.returning("p[0] * p[1] * p[1] == 1e-31 * t + 2"),
                            self.returning("n == 1 && p[0] * p[1] == 1", "(1 - t) * p[0] + p[1]")])

    def test_a_branch_that_no_number_takes_or_that_is_right_costs_nothing(self):
        self.look("proved", [
            self.returning("t * t == 0.5"), self.returning("t * t * t == 2"), self.returning("t * t == -1"),
            self.returning("t * t * t * t == 5 * t * t - 6"), self.returning("t == 1", "p[n]"),
            self.returning("t * (1 - t) == 0", "t == 0 ? p[0] : p[n]"), self.returning("n == 1 && p[0] == p[1]", "p[0]"),
            self.returning("n == 1 && p[0] == p[1] * p[1]", "(1 - t) * p[1] * p[1] + t * p[1]"),
            self.returning("n == 1 && p[0] * p[1] == 1", "(1 - t) * p[0] * p[0] * p[1] + t * p[1]")])

    def test_what_waits_is_told(self):
        [row] = self.verdicts([self.returning(NOBODY)])
        self.assertRegex(row["text"], r"^right in \d+ exact cases, n = 1 to n = 6; its points wait for a person$")
        self.assertEqual(row["because"], "line 7: whether any numbers take the other way is not known")
        [row] = self.verdicts([self.returning("p[0] * p[0] + p[1] * p[1] == 3")])
        self.assertEqual(row["because"], "line 7: whether any numbers take the other way than p[0]^2+p[1]^2 != 3 is not known")

    def test_python_is_no_other(self):
        right = (LABS / "de-casteljau-python/right/iterative.py").read_text()
        [row] = self.verdicts([("b = list(p)", "b = list(p)\n    if p[0] * p[0] + p[1] * p[1] == 3:\n        return 7", "")], right, "de-casteljau-python")
        self.assertEqual((row["verdict"], row["points"]), ("undecided", 0), row)

    def test_a_lab_may_say_that_cases_are_enough(self):
        shutil.copytree(LABS / "de-casteljau", self.folder / "mine")
        page = self.folder / "mine/lab.md"
        page.write_text(page.read_text().replace(":points: 4\n", ":points: 4\n:enough: cases\n"))
        place = self.folder / "place"
        place.mkdir()
        (place / "de-casteljau.c").write_text(RIGHT.replace(*self.returning(NOBODY)[:2], 1))
        row = json.loads(run("check", place, "--lab", self.folder / "mine", "--json").stdout)["requirements"][0]
        self.assertEqual((row["verdict"], row["points"]), ("sampled", 4), row)


class Kept(InFolder):
    """What is compiled of a lab is kept from one check to the next: it changes nothing that is said."""

    def setUp(self):
        super().setUp()
        self.cache = self.folder / "cache"
        self.mine = self.folder / "mine"
        self.mine.mkdir()
        (self.mine / "de-casteljau.c").write_text(RIGHT.replace("(1 - t) * b[i] + t * b[i + 1]", "t * b[i] + (1 - t) * b[i + 1]"))

    def said(self):
        ran = run("check", self.mine, env=os.environ | {"XDG_CACHE_HOME": str(self.cache)})
        self.assertEqual((ran.returncode, ran.stderr), (1, ""))
        return ran.stdout

    def kept(self):
        return {p.name: p for p in (self.cache / "cagd/labs/de-casteljau").glob("*")}

    def test_nothing_but_the_time_changes(self):
        first = self.said()
        self.assertIn("exchanged", first)
        kept = self.kept()
        self.assertLessEqual({"driver.bc", "reference.so"}, set(kept))
        self.assertTrue(any(name.startswith("wrong-") for name in kept), kept)
        self.assertEqual((self.cache / "cagd").stat().st_mode & 0o777, 0o700)
        seen = {name: p.stat().st_ino for name, p in kept.items()}
        self.assertEqual(self.said(), first)
        self.assertEqual({name: p.stat().st_ino for name, p in self.kept().items()}, seen)

    def test_what_is_damaged_or_old_is_made_again(self):
        first = self.said()
        whole = {name: p.read_bytes() for name, p in self.kept().items()}
        for spoil in (lambda b: b[:-100], lambda b: b[:200] + bytes([b[200] ^ 1]) + b[201:], lambda b: b"", lambda b: b"g" + b[1:],
                      lambda b: b[:1000] + b[900:]):
            for name, p in self.kept().items():
                p.write_bytes(spoil(whole[name]))
            self.assertEqual(self.said(), first)
            for name, p in self.kept().items():
                self.assertTrue(p.read_bytes() != spoil(whole[name]), name)
        kept = self.kept()
        kept["driver.bc"].write_bytes(whole["reference.so"])  # one for another
        kept["reference.so"].write_bytes(whole["driver.bc"])
        self.assertEqual(self.said(), first)

    def test_what_others_may_write_is_not_read(self):
        first = self.said()
        store = self.cache / "cagd/labs/de-casteljau"
        for p in store.glob("*"):
            p.write_text("not read")
        store.chmod(0o777)
        self.assertEqual(self.said(), first)
        self.assertEqual({p.read_text() for p in store.glob("*")}, {"not read"})
        shutil.rmtree(self.cache)
        self.cache.write_text("no folder")
        self.assertEqual(self.said(), first)
        self.assertEqual(self.cache.read_text(), "no folder")

    def test_another_reference_is_another_object(self):
        own = self.folder / "own"
        shutil.copytree(LABS / "de-casteljau", own)
        place = {"env": os.environ | {"XDG_CACHE_HOME": str(self.cache)}}
        (self.mine / "de-casteljau.c").write_text(RIGHT)
        self.assertEqual(run("check", self.mine, "--lab", own, **place).returncode, 0)
        reference = (own / "reference.c").read_text()
        self.assertEqual(reference.count("return "), reference.count("return"))
        (own / "reference.c").write_text(reference.replace("return ", "return 1 + "))
        self.assertEqual(run("check", self.mine, "--lab", own, **place).returncode, 1)


class Lecturer(InFolder):
    def test_make_in_a_lab_in_python_leaves_nothing(self):
        self.assertEqual(run("start", "de-casteljau-python", self.folder).returncode, 0)
        files = sorted(p.name for p in self.folder.iterdir())
        ran = subprocess.run(["make"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""), ran.stdout)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), files)
        (self.folder / "de-casteljau-python.py").write_text("def point(p, t):\n    return (p\n")
        ran = subprocess.run(["make"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(ran.returncode, 2)
        self.assertIn('File "de-casteljau-python.py", line 2', ran.stderr)

    def test_a_lab_of_ones_own(self):
        ran = run("new", "mine", cwd=self.folder)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        ran = run("test", self.folder / "mine")
        self.assertEqual(ran.returncode, 0, ran.stdout)
        self.assertEqual(run("start", "./mine", "place", cwd=self.folder).returncode, 0)
        (self.folder / "place/mine.c").write_text((self.folder / "mine/right/plain.c").read_text())
        ran = subprocess.run(["make", "all", "check"], cwd=self.folder / "place", capture_output=True, text=True)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""), ran.stdout)
        self.assertEqual(sorted(p.name for p in (self.folder / "place").iterdir()), ["Makefile", "README.md", "mine.c"])
        ran = run("check", "place", "--lab", "mine", cwd=self.folder)
        self.assertEqual((ran.returncode, ran.stderr), (2, "cagd: there is no lab 'mine'; the folder of that name is ./mine\n"))
        page = self.folder / "mine/lab.md"
        page.write_text(page.read_text().replace(":fails: sum manners", ":fails: manners"))
        self.assertEqual(run("test", self.folder / "mine").returncode, 1)

    def test_a_requirement_that_catches_nothing_is_told(self):
        run("new", "mine", cwd=self.folder)
        page = self.folder / "mine/lab.md"
        extra = ":::{requirement} twice\n:title: b + a\n:points: 1\n:input: a; b\n:call: double S = sum(b, a) * 0;\n:output: S\n:::\n"
        page.write_text(page.read_text() + extra)
        ran = run("test", self.folder / "mine")
        self.assertEqual(ran.returncode, 1)
        self.assertIn("twice: no wrong solution fails this requirement", ran.stdout)

    PRINTED = ((":call: double R = point($n, p, t);\n:output: R\n", ":use: bernstein B_i^n(t)\n:printed: R = \\sum_{i=0}^{$n} B_i^{$n}(t) p_i\n"),
               (":output: left[$(n+1)]\n", ":let: C_i^m(t) = \\binom{m}{i} t^i (1-t)^{m-i}\n:printed: \\mathrm{left}_k = \\sum_{i=0}^k C_i^k(t) p_i\n:index: k = 0..$n\n"))

    def with_formulas(self, *changes):
        """A lab of which two requirements have formulas, with changes."""
        own = self.folder / "own"
        shutil.rmtree(own, ignore_errors=True)
        shutil.copytree(LABS / "de-casteljau", own)
        page = own / "lab.md"
        text = page.read_text()
        for place, lines in self.PRINTED:
            self.assertEqual(text.count(place), 1)
            text = text.replace(place, place + lines)
        for old, new in changes:
            self.assertIn(old, text)
            text = text.replace(old, new)
        page.write_text(text)
        return own

    def test_what_is_right_may_be_a_formula(self):
        """It stands in for the reference, which is judged by it."""
        ran = run("test", self.with_formulas())
        self.assertEqual(ran.returncode, 0, ran.stdout)
        self.assertRegex(ran.stdout, r"reference.c +right .* as it should be")
        own = self.with_formulas()
        reference = own / "reference.c"
        reference.write_text(reference.read_text().replace("s += factorial", "s += 2 * factorial"))
        ran = run("test", own)
        self.assertEqual(ran.returncode, 1)
        self.assertRegex(ran.stdout, r"reference.c +right .* a right solution fails: point left( manners)?\n")
        self.assertRegex(ran.stdout, r"right/iterative.c +right .* a right solution fails: right( manners)?\n")
        (self.folder / "de-casteljau.c").write_text(RIGHT)
        for change in (("(t) p_i", "(t) p_i + t(1-t)"), ("\\sum_{i=0}^k", "\\sum_{i=1}^k"), ("_k = ", "_{$n-k} = ")):
            result = json.loads(run("check", self.folder, "--lab", self.with_formulas(change), "--json").stdout)
            self.assertEqual([r["verdict"] for r in result["requirements"]][1:3], ["wrong", "proved"], change)

    def test_formulas_that_are_none(self):
        for change, words in (((":index: k = 0..$n\n", ""), "k is not defined"), ((":index: k = 0..$n", ":index: k = 0..$(n-1)"), "every result of :output: needs its formula"),
                              ((":index: k = 0..$n", ":index: k = 0..$(n+1)"), "an index of a result that it has not"), ((":index: k = 0..$n", ":index: k = 1.."), "an index runs between whole numbers"),
                              (("(t) p_i", "(t) p_{i+1}"), "a name that is no input, or an index that it has not"), (("_k = ", "_0 = "), "two equations for one result"),
                              (("R = \\sum", "p_0 = \\sum"), "on the left of an equation stands a result of :output:"), (("(t) p_i", "(t) q_i"), "q_i is not defined"),
                              (("R = \\sum", "R = \\sqrt{t} + \\sum"), "a root that is no rational function"), (("R = \\sum", "R = |t| + \\sum"), "depends on variables"), (("R = \\sum", "R \\ge \\sum"), "an equation was expected")):
            ran = run("test", self.with_formulas(change))
            self.assertEqual((ran.returncode, len(ran.stderr.splitlines())), (2, 1), change)
            self.assertIn(words, ran.stderr, change)

    def test_the_rubric(self):
        ran = run("list", "de-casteljau")
        self.assertIn("  left                  2        the control points of the part from 0 to t\n", ran.stdout)
        [lab] = json.loads(run("list", "de-casteljau", "--json").stdout)["labs"]
        self.assertEqual(sum(r["points"] for r in lab["requirements"]), lab["points"])
        ran = run("list", "nothing")
        self.assertEqual((ran.returncode, ran.stdout, len(ran.stderr.splitlines())), (2, "", 1))

    @unittest.skipUnless(shutil.which("bwrap"), "no bubblewrap")
    def test_the_script_of_gradescope(self):
        root = self.folder / "autograder"
        (root / "submission").mkdir(parents=True)
        (root / "submission/de-casteljau.c").write_text(RIGHT.replace("right[n - r]", "right[r]"))
        script = [LABS / "run_autograder", root]
        ran = subprocess.run(script, env={**os.environ, "CAGD": CAGD, "CAGD_LAB": "de-casteljau"}, capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(json.loads((root / "results/results.json").read_text())["score"], 8)
        self.assertTrue((root / "results/page.html").exists())
        ran = subprocess.run(script, env={**os.environ, "CAGD": CAGD, "CAGD_LAB": "nothing"}, capture_output=True, text=True)
        self.assertEqual((ran.returncode, len(ran.stderr.splitlines())), (1, 1))
        self.assertNotIn("score", json.loads((root / "results/results.json").read_text()))

    @unittest.skipUnless(shutil.which("bwrap"), "no bubblewrap")
    def test_a_class(self):
        class_ = self.folder / "class"
        class_.mkdir()
        (class_ / "ann.c").write_text(RIGHT)
        (class_ / "bob").mkdir()
        (class_ / "bob/de-casteljau.c").write_text(RIGHT.replace("right[n - r]", "right[r]"))
        (class_ / "cy").mkdir()
        (class_ / "dan.c").write_text("#error <b>\n")
        out = self.folder / "out"
        ran = run("grade", class_, "--lab", "de-casteljau", "--out", out, "--seed", "autumn")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        rows = {r["student"]: r for r in csv.DictReader((out / "results.csv").read_text().splitlines())}
        self.assertEqual({k: r["points"] for k, r in rows.items()}, {"ann": "10", "bob": "8", "cy": "0", "dan": "0"})
        xml.dom.minidom.parse(str(out / "junit.xml"))
        scores = json.loads((out / "bob/results.json").read_text())
        self.assertEqual(scores["score"], 8)
        self.assertEqual(sum(t["max_score"] for t in scores["tests"]), 10)
        self.assertIn("expected", (out / "bob/page.html").read_text())
        self.assertNotIn("<b>", (out / "dan/page.html").read_text())


if __name__ == "__main__":
    unittest.main()
