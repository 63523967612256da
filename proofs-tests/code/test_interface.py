"""Code of others called from Python, and by way of it the functions of cagd_exactly.h.

    python3 test_interface.py FOLDER-OF-PROGRAMS ROOT"""
import os
import pathlib
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
        with self.assertRaisesRegex(Refused, "was not set"):
            self.casteljau()(t=1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
