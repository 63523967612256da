"""The language: small programs of every feature, run exactly and compared with what Python computes apart.

    python3 test_language.py CAGD-COMPILE-EXACTLY RUN_PROGRAMS

Above each program of language/ stands what it should give (see the first lines of the files)."""
import math
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction as F

COMPILER, RUNNER = sys.argv[1:3]
del sys.argv[1:3]
FOLDER = pathlib.Path(__file__).resolve().parent / "language"
PROGRAM = re.compile(r"^/\* ([=!~#]) (.*?) \*/\n(?:double|static double) (\w+)\(void\)", re.M)
FUNCTIONS = """
#ifdef __cplusplus
extern "C" {
#endif
void cagd_code_input(const char *, long, double *);
void cagd_code_output(const char *, long, const double *);
double input_x(void) { double x; cagd_code_input("x", 1, &x); return x; }
double input_y(void) { double y; cagd_code_input("y", 1, &y); return y; }
"""
NAMES = {"F": F, "sum": sum, "range": range, "math": math, "struct": struct, "float": float, "int": int}


def programs(name):
    """Of each: its sign, what is said, its name, and the line marked "// here" or None."""
    text = (FOLDER / name).read_text()
    found = list(PROGRAM.finditer(text))
    for k, m in enumerate(found):
        end = found[k + 1].start() if k + 1 < len(found) else len(text)
        here = text.find("// here", m.start(), end)
        yield m[1], m[2], m[3], text.count("\n", 0, here) + 1 if here >= 0 else None


class Language(unittest.TestCase):
    count = 0

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def compiled(self, name, *others, flags=()):
        path = pathlib.Path(self.folder.name)
        names = [p[2] for p in programs(name)]
        driver = FUNCTIONS + "".join(
            f'double {n}(void);\nvoid run_{n}(void) {{ double r = {n}(); cagd_code_output("r", 1, &r); }}\n' for n in names)
        driver += "#ifdef __cplusplus\n}\n#endif\n"
        source = path / ("driver" + pathlib.Path(name).suffix)
        source.write_text(driver)
        made = subprocess.run([COMPILER, "-o", path / "object.so", source, FOLDER / name, *others, "--", "-w", *flags],
                              capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        return path / "object.so"

    def lines(self, numbers, name, *others, flags=()):
        """What the runner says of each program: its result, or its message and place."""
        made = self.compiled(name, *others, flags=flags)
        ran = subprocess.run([RUNNER, numbers, made] + ["run_" + p[2] for p in programs(name)], capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        answers = [line for line in ran.stdout.splitlines() if line.startswith("run_")]
        listed = list(programs(name))
        self.assertEqual(len(answers), len(listed), ran.stdout)
        Language.count += len(listed)
        return zip(listed, answers)

    def refused(self, program, answer):
        sign, said, name, here = program
        message, line = re.fullmatch(r"run_%s! (.*) \(.*:(\d+)\)" % name, answer, re.S).groups()
        self.assertIn(said, message)
        if here is not None:
            self.assertEqual(int(line), here, answer)

    def exact(self, name, *others, flags=(), numbers="rational"):
        for program, answer in self.lines(numbers, name, *others, flags=flags):
            with self.subTest(program[2]):
                if program[0] == "!":
                    self.refused(program, answer)
                else:
                    self.assertEqual(answer, f"run_{program[2]}: {F(eval(program[1], dict(NAMES)))}")

    def test_arithmetic(self):
        self.exact("arithmetic.c")

    def test_storage(self):
        self.exact("storage.c")

    def test_library(self):
        self.exact("library.c")

    def test_library_where_calls_are_intrinsics(self):
        """Without errno clang makes of a call an intrinsic, whose name may begin as that of another one does."""
        self.exact("library.c", flags=["-fno-math-errno", "-ffp-model=precise"])

    def test_refused(self):
        self.exact("refused.c")

    def test_outside_of_arrays(self):
        self.exact("outside.c")

    def test_addresses_that_have_an_order(self):
        self.exact("ordered.c", numbers="ordered")
        for program, answer in self.lines("rational", "ordered.c"):
            self.assertNotIn("!", answer)

    def test_cpp(self):
        self.exact("cpp.cc", flags=["-std=c++17"])

    def test_further(self):
        self.exact("further.c", flags=["-std=c17"])

    def test_rarer(self):
        self.exact("rarer.c", flags=["-std=gnu17"])

    def test_rarer_cpp(self):
        self.exact("rarer.cc", flags=["-std=c++17", "-fsized-deallocation"])

    def test_further_cpp(self):
        self.exact("further.cc", flags=["-std=c++17"])

    def bitcode(self, name, *flags):
        """A file of language/ as bitcode, called .o, as makefiles do."""
        made = pathlib.Path(self.folder.name) / (pathlib.Path(name).stem + ".o")
        tools = subprocess.run([COMPILER, "--tools"], capture_output=True, text=True, check=True).stdout.strip()
        compiler = ["clang"] if name.endswith(".c") else ["clang++", "-std=c++17"]
        subprocess.run([tools + "/" + compiler[0], *compiler[1:], *(flags or ["-O0", "-ffp-model=strict"]), "-g", "-fPIC", "-c",
                        "-emit-llvm", FOLDER / name, "-o", made], check=True)
        return made

    def archive(self, name, members, kind="rc"):
        made = pathlib.Path(self.folder.name) / name
        subprocess.run(["ar", kind, made, *members], check=True)
        return made

    def test_several_files_and_an_archive(self):
        members = [self.bitcode(name) for name in ["archived.c", "archived_too.c", "archived_twice.c", "archived_alias.c", "archived_number.c"]]
        self.exact("several.c", FOLDER / "other.c", self.archive("archive.a", members))

    def test_several_files_of_cpp(self):
        parts = ["parts_plain.c", "parts_one.cc", "parts_constructor.cc", "parts_instance.cpp", "parts_two.cpp"]
        with self.subTest("sources; of the flags each language takes its own"):
            self.exact("several.cc", *[FOLDER / name for name in parts], flags=["-std=c++17", "-std=c11"])
        made = [self.bitcode(name) for name in parts]
        with self.subTest("bitcode"):
            self.exact("several.cc", *made)
        with self.subTest("archives that miss each other's members, whatever their order; one is thin: its members lie beside it"):
            self.exact("several.cc", self.archive("plain.a", made[:1]), self.archive("thin.a", made[1:4], "rcT"), self.archive("two.a", made[4:]))
        with self.subTest("optimised, where constructors are aliases"):
            self.exact("several.cc", self.archive("optimised.a", [self.bitcode(name, "-O1") for name in parts]))

    def test_each_language_by_the_ends_of_its_files(self):
        """Wherever the file stands among others; `new` is a name in C, and a word in C++."""
        folder = pathlib.Path(self.folder.name)
        (folder / "number.c").write_text("double number(int new); double number(int new) { return 1.0 / new; }\n")
        for end in [".cc", ".cpp", ".cxx", ".C"]:
            other = folder / ("other" + end)
            other.write_text('extern "C" double from_another_file(double); template <class T> T third(T x) { return x / 3; }\n'
                             "double from_another_file(double x) { return third(x); }\n")
            for sources in [[other, folder / "number.c"], [folder / "number.c", other]]:
                with self.subTest(end):
                    subprocess.run([COMPILER, "-o", folder / "object.so", *sources], check=True)
        for sources in [["number.c"], ["none.c"], ["number.c", "none.cc"]]:
            made = subprocess.run([COMPILER, "-o", folder / "object.so", *[folder / name for name in sources]], capture_output=True, text=True)
            self.assertEqual(made.returncode, int("none" in sources[-1]), made.stderr)

    def test_wrong_usage_is_told(self):
        folder = pathlib.Path(self.folder.name)
        archive = self.archive("archive.a", [self.bitcode("archived.c")])
        (folder / "text.txt").write_text("no source")
        out = ["-o", folder / "object.so"]
        for words, code, says in [([], 2, "usage: "), (out, 2, "usage: "), ([FOLDER / "other.c"], 2, "usage: "), ([FOLDER / "other.c", "-o"], 2, "usage: "),
                                  ([*out, folder / "text.txt"], 2, "a source in C or C.., bitcode or an archive of it was expected: .*text.txt"),
                                  ([*out, archive], 2, "nothing but archives, of which nothing is missed"), ([*out, archive, archive], 2, "nothing but archives"),
                                  ([*out, folder / "none.a", FOLDER / "other.c"], 1, "No such file or directory: .*none.a"),
                                  ([*out, "--names", folder / "none/list", FOLDER / "other.c"], 1, "No such file or directory: .*none/list")]:
            with self.subTest(says):
                made = subprocess.run([COMPILER, *words], capture_output=True, text=True)
                self.assertEqual((made.returncode, made.stdout), (code, ""), made.stderr)
                self.assertRegex(made.stderr.splitlines()[-1], "^cagd-compile-exactly: " + says)
        self.assertEqual(list(pathlib.Path(self.folder.name).glob("cagd-code-*")), [])
        made = subprocess.run([COMPILER, "--stores", *out, FOLDER / "other.c", archive, "--", "-O0", "-DX"], capture_output=True, text=True)
        self.assertEqual((made.returncode, made.stdout, made.stderr), (0, "", ""))
        made = subprocess.run([COMPILER, "--tools"], capture_output=True, text=True)
        self.assertTrue((pathlib.Path(made.stdout.strip()) / "clang").exists())

    def test_nothing_is_left_in_tmpdir(self):
        folder = pathlib.Path(self.folder.name) / "tmp"
        folder.mkdir()
        environment = {**os.environ, "TMPDIR": str(folder)}
        for source, code in [("other.c", 0), ("none.c", 1)]:
            made = subprocess.run([COMPILER, "-o", folder.parent / "object.so", FOLDER / source], capture_output=True, env=environment)
            self.assertEqual((made.returncode, list(folder.iterdir())), (code, []))
        environment["TMPDIR"] = str(folder / "none")
        made = subprocess.run([COMPILER, "-o", folder.parent / "object.so", FOLDER / "other.c"], capture_output=True, text=True, env=environment)
        self.assertEqual((made.returncode, made.stderr), (1, "cagd-compile-exactly: no temporary folder: No such file or directory\n"))

    def test_what_is_no_archive_of_bitcode_is_told(self):
        folder = pathlib.Path(self.folder.name)
        source, native = FOLDER / "several.c", folder / "native.o"
        subprocess.run(["cc", "-c", FOLDER / "archived.c", "-o", native], check=True)
        cut = self.archive("cut.a", [self.bitcode("archived.c")])
        cut.write_bytes(cut.read_bytes()[:-100])
        (folder / "text.a").write_text("no archive at all")
        thin = self.archive("away.a", [self.bitcode("archived_too.c")], "rcT")
        (folder / "archived_too.o").unlink()
        for file, code, says in [(self.archive("native.a", [native]), 1, "the member native.o of the archive is no bitcode"), (cut, 1, "ends too early"),
                                 (folder / "text.a", 1, "no archive"), (thin, 1, "archived_too.o"),
                                 (native, 2, "a source in C or C.., bitcode or an archive")]:
            with self.subTest(file.name):
                made = subprocess.run([COMPILER, "-o", folder / "object.so", source, file], capture_output=True, text=True)
                self.assertEqual(made.returncode, code)
                self.assertRegex(made.stderr, says)
                self.assertEqual(made.stderr.count("\n"), 1)

    def test_names_of_sources(self):
        """Those that a source defines and those that it misses, against nm and a compiler that makes code of the machine."""
        folder = pathlib.Path(self.folder.name)
        sources = ["several.c", "other.c", "archived.c", "archived_too.c", "archived_alias.c", "archived_number.c"]
        subprocess.run([COMPILER, "--names", folder / "list", "-o", folder / "object.bc", *[FOLDER / name for name in sources]], check=True)
        expected = []
        for name in sources:
            subprocess.run(["cc", "-O0", "-c", FOLDER / name, "-o", folder / "native.o"], check=True)
            nm = subprocess.run(["nm", folder / "native.o"], capture_output=True, text=True, check=True).stdout
            expected += (["U" if kind == "U" else "T", name] for kind, name in (line.split()[-2:] for line in nm.splitlines()))
        said = [line.split() for line in (folder / "list").read_text().splitlines() if "." not in line]  # those are of the compiler
        self.assertEqual(sorted(said), sorted(expected))
        self.assertIn(["T", "hidden"], said)
        self.assertIn(["U", "from_an_alias"], said)

    def test_each_function_of_long_double(self):
        self.exact("long_double.c", flags=["-mlong-double-64"])

    def test_long_double_as_double(self):
        for program, answer in self.lines("rational", "refused.c", flags=["-mlong-double-64"]):
            if program[2] == "r_long_double":
                self.assertEqual(answer, "run_r_long_double: 1/3")

    def test_optimised_code_has_plain_operations(self):
        folder = pathlib.Path(self.folder.name)
        tools = subprocess.run([COMPILER, "--tools"], capture_output=True, text=True, check=True).stdout.strip()
        for level in ["-O1", "-O2", "-O3", "-O3 -fassociative-math -fno-signed-zeros -fno-trapping-math"]:  # the last with sums of vectors
            subprocess.run([tools + "/clang", *level.split(), "-march=x86-64-v3", "-g", "-fPIC", "-c", "-emit-llvm",
                            FOLDER / "optimised.c", "-o", folder / "optimised.bc"], check=True)
            with self.subTest(level):
                self.exact("optimised_calls.c", folder / "optimised.bc")

    def test_field(self):
        places = [(F(2, 3), F(-5, 7)), (F(7, 11), F(-13, 17)), (F(19, 23), F(-29, 31))]
        for program, answer in self.lines("field", "field.c"):
            with self.subTest(program[2]):
                if program[0] == "!":
                    self.refused(program, answer)
                    continue
                said, _, said_of = program[1].partition(" | ")
                condition = [c.strip() for c in said_of.split("|") if c.strip()]
                value, *conditions = answer.partition(": ")[2].split(" | ")
                for x, y in places:
                    names = dict(NAMES, x=x, y=y)
                    formula = re.sub(r"\b(\d+)\b", r"F(\1)", value.replace("^", "**"))
                    formula = re.sub(r"\*\*F\((\d+)\)", r"**\1", formula)
                    self.assertEqual(eval(formula, dict(names)), eval(said, dict(names)), answer)
                for one in condition:
                    self.assertIn(one, conditions)
                if said_of.endswith("|"):
                    self.assertEqual(conditions, condition)
                if not condition:
                    self.assertNotIn("needs_no_condition", "" if not conditions else program[2])

    def test_rounding(self):
        """The computed value is the binary64 that Python computes by the same operations."""
        for program, answer in self.lines("rounding", "rounding.c"):
            with self.subTest(program[2]):
                if program[0] == "!":
                    self.refused(program, answer)
                    continue
                said, _, exact = program[1].partition(" ; ")
                computed, ulps = re.search(r" computed (\S+) ulps (\S+)", answer).groups()
                self.assertEqual(float(computed), float(eval(said, dict(NAMES))), answer)
                if exact:
                    value = F(eval(exact, dict(NAMES)))
                    self.assertEqual(answer.split(": ")[1].split()[0], str(value))
                    error = abs(F(float(computed)) - value)
                    ulp = F(2) ** (math.frexp(float(value))[1] - 53)
                    self.assertAlmostEqual(float(ulps), float(error / ulp) if value != 0 else math.inf if error else 0, delta=1e-5 * float(error / ulp))

    def test_enclosures(self):
        """In intervals, and in rationals where roots are enclosed: around what Python has to 15 digits."""
        for numbers in ["enclose", "interval"]:
            for program, answer in self.lines(numbers, "enclosed.c"):
                with self.subTest(program[2]):
                    if program[0] == "!":
                        self.refused(program, answer)
                        continue
                    low, high = map(float, re.search(r"in \[(.*), (.*)\]", answer).groups())
                    value = eval(program[1], dict(NAMES))
                    self.assertLessEqual(abs(low - value), 1e-14 * abs(value), answer)
                    self.assertLessEqual(low, high)
                    self.assertLessEqual(high - low, 1e-15 * abs(value))

    @classmethod
    def tearDownClass(cls):
        print(f"{Language.count} programs")


if __name__ == "__main__":
    unittest.main(verbosity=2)
