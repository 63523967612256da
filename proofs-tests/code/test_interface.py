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
