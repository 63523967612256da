"""Code of others called from Python, and by way of it the functions of cagd_exactly.h.

    python3 test_interface.py FOLDER-OF-PROGRAMS ROOT"""
import os
import pathlib
import shutil
import sys
import tempfile
import unittest
from fractions import Fraction as F

PROGRAMS, ROOT = map(lambda text: pathlib.Path(text).resolve(), sys.argv[1:3])
del sys.argv[1:3]
sys.path.insert(0, str(ROOT / "exact/code"))
os.environ["CAGD_EXACTLY_SESSION"] = str(PROGRAMS / "cagd-exactly-session")
from cagd_exactly import Code, Refused  # noqa: E402

CURVES = str(ROOT / "exact/code/example/curves.c")


class Interface(unittest.TestCase):
    def code(self, **parts):
        made = Code(**parts)
        self.addCleanup(made.close)
        return made

    def casteljau(self):
        return self.code(source=CURVES, declare="double casteljau(int n, const double *p, double t);", input="p[4]; t",
                         call="double R = casteljau(3, p, t);", output="R")

    def test_fractions_in_and_out(self):
        code = self.casteljau()
        for t in [F(0), F(2, 7), F(-5, 3), F(10**30 + 1, 3)]:
            p = [F(1), F(-2, 3), F(5, 11), F(7)]
            exact = sum(b * x * t**k * (1 - t) ** (3 - k) for k, (b, x) in enumerate(zip([1, 3, 3, 1], p)))
            self.assertEqual(code(p=p, t=t)["R"], exact)

    def test_a_float_is_the_number_that_it_is_and_a_text_the_one_that_it_says(self):
        code = self.casteljau()
        self.assertEqual(code(p=[0.1] * 4, t=0)["R"], F(0.1))
        self.assertEqual(code(p=["0.1"] * 4, t=0)["R"], F(1, 10))

    def test_functions_and_conditions(self):
        code = self.code(source=CURVES, declare="double deboor(int n, int degree, const double *k, const double *c, double t);",
                         input="k[4] = 0 0 1 1; c[2]; t in [0, 1]", call="double R = deboor(1, 1, k, c, t);", output="R")
        self.assertEqual(code.function(c=[1, 2], t="1/2"), {"R": "-c[0]*t+c[0]+c[1]*t"})
        self.assertEqual(code.conditions(), ["t < 1"])

    def test_rounding(self):
        computed, ulps = self.casteljau().rounding(p=[1, 2, 4, 8], t=0.1)["R"]
        t, b = 0.1, [1.0, 2.0, 4.0, 8.0]
        for r in range(3):
            b = [(1 - t) * x + t * y for x, y in zip(b, b[1:])]
        self.assertEqual(computed, b[0])
        exact = sum(c * x * F(t)**k * (1 - F(t)) ** (3 - k) for k, (c, x) in enumerate(zip([1, 3, 3, 1], [1, 2, 4, 8])))
        self.assertAlmostEqual(ulps, float(abs(F(computed) - exact) * 2**52), places=6)

    def test_arrays_and_several_outputs(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "two.c"
            source.write_text("void two(double x, double *r) { r[0] = x / 3; r[1] = x * x; }\n")
            code = self.code(source=str(source), declare="void two(double, double *);", input="x", call="double r[2]; two(x, r);",
                             output="r[2]")
            self.assertEqual(code(x=F(1, 2)), {"r[0]": F(1, 6), "r[1]": F(1, 4)})

    def remembering(self, text, call="double R = next();"):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        source = pathlib.Path(folder.name) / "remembers.c"
        source.write_text(text)
        return self.code(source=str(source), declare="double next(void);", input="x", call=call, output="R")

    def processes(self, code):
        """Of the session: those of the code that wait for another call."""
        pid = code._process.pid
        return pathlib.Path(f"/proc/{pid}/task/{pid}/children").read_text().split()

    def test_no_call_knows_of_another(self):
        for says, text in [
                ("a static variable", "static double n; double next(void) { return n += 1; }"),
                ("one in a function", "double next(void) { static int n; n++; return n; }"),
                ("memory of a constructor", "#include <stdlib.h>\nstatic double *p; __attribute__((constructor)) static void make(void) "
                                            "{ p = malloc(sizeof *p); *p = 0; } double next(void) { return *p += 1; }"),
                ("a static pointer", "#include <stdlib.h>\nstatic double *p; double next(void) { if (!p) p = calloc(1, sizeof *p); return *p += 1; }"),
                ("the library", "#include <stdlib.h>\ndouble next(void) { static const double one = 1; int first = rand(); srand(1); "
                                "return first == rand() ? one : 2; }"),
                ("what lies on the stack", "double next(void) { double a[50]; a[7] = 1; return a[7]; }")]:
            with self.subTest(says):
                code = self.remembering(text)
                self.assertEqual([code(x=k)["R"] for k in range(4)], [1] * 4)

    def test_what_was_never_computed_is_found_in_later_calls_too(self):
        code = self.remembering("#include <stdlib.h>\nstatic double of(double x) { double *p = malloc(64); p[3] = x; double r = p[x == 7 ? 4 : 3]; free(p); "
                                "return r; }\ndouble next(void) { return 0; }\ndouble part(double x) { return of(x); }",
                                "double part(double); double R = part(x);")
        for k in range(10):
            if k == 7:
                with self.assertRaisesRegex(Refused, "never computed"):
                    code(x=k)
            else:
                self.assertEqual(code(x=k)["R"], k)

    def test_one_process_serves_many_calls(self):
        code = self.casteljau()
        p = [F(1), F(-2, 3), F(5, 11), F(7)]
        code(p=p, t=0)
        first = self.processes(code)
        self.assertEqual(len(first), 1)
        for k in range(200):
            self.assertEqual(code(p=p, t=F(k, 200))["R"], sum(
                b * x * F(k, 200)**i * (1 - F(k, 200)) ** (3 - i) for i, (b, x) in enumerate(zip([1, 3, 3, 1], p))))
        self.assertEqual(self.processes(code), first)
        os.kill(int(first[0]), 9)  # from outside: the next call has another
        while self.processes(code) == first and pathlib.Path(f"/proc/{first[0]}/stat").read_text().split()[2] != "Z":
            pass
        self.assertEqual(code(p=p, t=1)["R"], 7)
        self.assertNotEqual(self.processes(code), first)
        leaking = self.remembering("#include <stdlib.h>\ndouble next(void) { double *p = malloc(8); *p = 3; return *p; }")
        leaking(x=0)
        first = self.processes(leaking)
        for _ in range(5000):
            self.assertEqual(leaking(x=0)["R"], 3)
        self.assertNotEqual(self.processes(leaking), first)

    def test_the_call_after_one_that_crashed_is_answered(self):
        code = self.remembering("double next(void) { return 0; }", "double R = x; if (x == 1) { int *p = 0; *p = 1; }")
        self.assertEqual(code(x=2)["R"], 2)
        with self.assertRaises(Refused):
            code(x=1)
        self.assertEqual(code(x=3)["R"], 3)

    def test_what_goes_wrong_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "bad.c"
            source.write_text("double bad(double x)\n{\n    double a[2] = {x, x}, *p = a;\n    return x > 0 ? 1 / (x - 1) : p[-1];\n}\n")
            code = self.code(source=str(source), declare="double bad(double);", input="x", where="x < 5", call="double R = bad(x);", output="R")
            for x, end, says in [(1, "undefined", "a division by zero, at .*bad.c:4 in bad"), (7, "outside", "a precondition is not true"),
                                 (-1, "refused", "8 bytes before the beginning of a, which has 16 bytes, at .*bad.c:4")]:
                with self.assertRaisesRegex(Refused, says) as caught:
                    code(x=x)
                self.assertEqual(caught.exception.end, end)
            self.assertEqual(code(x=3)["R"], F(1, 2))
            with self.assertRaisesRegex(Refused, "no such input"):
                code(y=3)
        with self.assertRaisesRegex(Refused, "there is no :call:"):
            Code(source=CURVES, call="", output="")
        with self.assertRaisesRegex(Refused, "^y: \"\\s+z\" is not known; .* was expected$"):  # one line, whatever is wrong
            Code(source=CURVES, input="x; y\nz", call="double R = x;", output="R")
        with self.assertRaisesRegex(Refused, "was not set"):
            self.casteljau()(t=1)

    def of_text(self, text, **parts):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        source = pathlib.Path(folder.name) / "code.c"
        source.write_text(text)
        return self.code(source=str(source), **parts)

    def test_every_part_of_the_code_is_used(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "one.c").write_text("double one(double x) { return x + ONE; }\n")
            (folder / "two.c").write_text("double two(double x) { return x * TWO; }\n")
            (folder / "three.h").write_text("#define THREE 3\n")
            (folder / "four.h").write_text("#define FOUR 4\n")
            code = self.code(source=f"{folder}/one.c {folder}/two.c", flags=f"-DONE=1 -DTWO=2 -I{folder}", include="<three.h> <four.h>",
                             declare="double one(double);\ndouble two(double);", input="x; y; z = 7", where="x < 5\n&& y < 5",
                             call="double R = two(one(x));\ndouble S = R + THREE * y, T[2] = {FOUR, z};", output="R S T[2]")
            self.assertEqual(code(x=F(1, 3), y=F(1, 7)), {"R": F(8, 3), "S": F(8, 3) + F(3, 7), "T[0]": 4, "T[1]": 7})
            with self.assertRaisesRegex(Refused, "a precondition is not true"):
                code(x=1, y=6)

    def test_what_is_set_stays_and_what_is_wrong_changes_nothing(self):
        code = self.of_text("double f(double x, const double *p) { return x + 10 * p[0] + 100 * p[1]; }", declare="double f(double, const double *);",
                            input="x; p[2]; a = 1", call="double R = f(x, p);", output="R")
        with self.assertRaisesRegex(Refused, "the input x was not set"):
            code(p=[2, 3])
        with self.assertRaisesRegex(Refused, "the input x was not set"):
            code()
        self.assertEqual(code(x=1)["R"], 321)
        for wrong in [{"p": [5]}, {"p": [5, 6, 7]}, {"p": [5, "x"]}, {"p": ["1/0", 5]}, {"x": [5, 5]}, {"q": 5}, {"x": "5x"}]:
            with self.assertRaisesRegex(Refused, "no such input of so many numbers, or one is no number"):
                code(**wrong)
        self.assertEqual(code()["R"], 321)
        self.assertEqual(code(p=["-1/2", "0.5"])["R"], 46)

    def test_inputs_that_do_not_decrease_are_variables_of_their_own(self):
        code = self.of_text("double f(const double *u) { return u[0] + 10 * u[1] + 100 * u[2]; }", declare="double f(const double *);",
                            input="u[3] nondecreasing", call="double R = f(u);", output="R")
        self.assertEqual(code.function(u=[1, 1, 2]), {"R": "u[0]+10*u[1]+100*u[2]"})
        self.assertEqual(code(u=[1, 1, 2])["R"], 211)

    def test_what_is_asked_of_the_last_call(self):
        code = self.of_text("#include <math.h>\ndouble f(double x, double y) { if (x > 2) x = x / 7; if (y < x) y = y / 3; return fabs(x - y); }",
                            declare="double f(double, double);", input="x > 0; y",
                            where="y > -9", call="double R = f(x, y), S = x, T = 1 / (x + 2);", output="R S T")
        self.assertEqual(code(x=3, y=F(1, 7))["R"], F(3, 7) - F(1, 21))
        for asked in ["function R", "condition 0", "get Q", "get R S Q"]:
            with self.assertRaisesRegex(Refused, "there is none"):
                code._ask(asked)
        self.assertEqual(code._ask("get T R S"), f"1/5\t{F(3, 7) - F(1, 21)}\t3")
        self.assertEqual(code.function(x=3, y=F(1, 7))["T"], "1/(x+2)")
        self.assertEqual(code.conditions(), ["x > 2", "y < x/7", "(3*x-7*y)/21 >= 0"])  # without those that are given
        rounded = code.rounding(x=3, y=F(1, 7))
        self.assertEqual(rounded["S"], (3.0, 0.0))
        self.assertEqual(rounded["T"][0], 0.2)
        self.assertAlmostEqual(rounded["T"][1], float(abs(F(0.2) - F(1, 5)) * 2**55), places=9)
        self.assertEqual(code._ask("run interval"), "")
        self.assertTrue(code._ask("get S").startswith("in [3, 3") or code._ask("get S") == "3")
        with self.assertRaises(Refused) as caught:
            code(x=-1)
        self.assertEqual(caught.exception.end, "outside")
        for asked in ["get R", "function R", "condition 9"]:
            with self.assertRaisesRegex(Refused, "there is none"):
                code._ask(asked)
        self.assertEqual(code._ask("computed R"), "nan")
        self.assertEqual(code._ask("ulps R"), "nan")

    def test_every_end_has_its_word(self):
        code = self.of_text("#include <stdlib.h>\n#include <math.h>\ndouble f(double x)\n{\n    if (x == 1)\n        return 1 / (x - 1);\n    if (x == 2)\n        return tgamma(x);\n"
                            "    for (; x == 3;)\n        for (double y = 3;;)\n            y *= y;\n    if (x == 4)\n        abort();\n    return x == 6 ? sqrt(2) : x;\n}\n",
                            declare="double f(double);", input="x", where="x < 9", call="double R = f(x);", output="R")
        for x, end, says in [(1, "undefined", "^a division by zero, at .*code.c:6 in f$"), (2, "refused", "^the function tgamma, at .*code.c:8 in f$"),
                             (3, "bound", "^a number of more than .* bits, at .*code.c:11 in f$"), (4, "crashed", "aborted; .*, at .*code.c:13 in f$"),
                             (10, "outside", "^a precondition is not true, at ")]:
            for numbers in ["rational", "field", "rounding"]:
                with self.subTest(f"{x} {numbers}"):
                    with self.assertRaisesRegex(Refused, says) as caught:
                        code._ask(f"set x {x}", f"run {numbers}")
                    self.assertEqual(caught.exception.end, end)
            self.assertEqual(code(x=5)["R"], 5)
        self.assertRegex(code(x=6)["R"], r"^in \[1\.41421356237309.*, 1\.414213562373")

    def test_the_compiler_that_is_named_is_used(self):
        had = os.environ.get("CAGD_COMPILE_EXACTLY")
        try:
            os.environ["CAGD_COMPILE_EXACTLY"] = "/nowhere/compiler"
            with self.assertRaisesRegex(Refused, "^/nowhere/compiler cannot be started: No such file or directory"):
                self.casteljau()
            os.environ["CAGD_COMPILE_EXACTLY"] = ""
            self.assertEqual(self.casteljau()(p=[1, 1, 1, 1], t=3)["R"], 1)
        finally:
            os.environ.pop("CAGD_COMPILE_EXACTLY")
            if had is not None:
                os.environ["CAGD_COMPILE_EXACTLY"] = had

    def test_the_compiler_is_looked_for_in_path_last(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = pathlib.Path(folder) / "session"
            shutil.copy(PROGRAMS / "cagd-exactly-session", alone)
            had = os.environ["PATH"]
            self.addCleanup(os.environ.__setitem__, "PATH", had)
            self.addCleanup(os.environ.__setitem__, "CAGD_EXACTLY_SESSION", os.environ["CAGD_EXACTLY_SESSION"])
            os.environ["CAGD_EXACTLY_SESSION"] = str(alone)
            with self.assertRaisesRegex(Refused, "was not found beside this program or in PATH"):
                self.casteljau()
            for path in [f"/nowhere:{PROGRAMS}:/usr/bin", f"{PROGRAMS}:/usr/bin", f"/usr/bin:{PROGRAMS}"]:
                os.environ["PATH"] = path
                self.assertEqual(self.casteljau()(p=[1, 1, 1, 1], t=3)["R"], 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
