"""A chapter of one's own, as CONTRIBUTING has it: found without any list, and told what is wrong with it.

    python3 test_chapter.py ROOT BUILD

BUILD is a build of the program; what the chapter adds is compiled in a copy of the tree and linked with the rest of it.
"""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv.pop(2)).resolve()
ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
EXAMPLE = pathlib.Path(__file__).resolve().parent / "chapter"


def run(*command, **options):
    return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=600, **options)


class Chapter(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.holder.cleanup)
        cls.root = pathlib.Path(cls.holder.name) / "tree"
        shutil.copytree(ROOT, cls.root, ignore=shutil.ignore_patterns("build", "build-*", ".git", "gallery"))
        cls.must("cmake", "--preset", "release", "-DBUILD_TESTING=OFF")
        cls.mine = cls.root / "chapters" / "mine"
        cls.mine.mkdir()
        shutil.copy(EXAMPLE / "index.md", cls.mine)
        shutil.copy(EXAMPLE / "plain.claims.h", cls.mine / "elevation.claims.h")

    @classmethod
    def must(cls, *command):
        r = run(*command, cwd=cls.root)
        if r.returncode != 0:
            raise AssertionError(r.stdout[-4000:])
        return r.stdout

    def compiled(self, *options):
        """What the compiler and weave say of this chapter alone."""
        return run("cmake", "--build", "build/release", "-j", "4", "--target", "cagd_chapters", *options, cwd=self.root)

    def cagd(self):
        """The program of BUILD with the chapters of the copy."""
        r = self.compiled()
        self.assertEqual(r.returncode, 0, r.stdout[-4000:])
        link = run("ninja", "-C", BUILD, "-t", "commands", "cagd").stdout.splitlines()[-1]
        words = shlex.split(link[link.index("/"):] if link.startswith(": &&") else link)
        words = words[: words.index("&&")] if "&&" in words else words
        program = self.root / "cagd"
        words[words.index("-o") + 1] = str(program)
        words = [str(self.root / "build/release" / word) if word.endswith("libcagd_chapters.a") else word for word in words]
        r = run(*words, cwd=BUILD)
        self.assertEqual(r.returncode, 0, r.stdout[-4000:])
        return program

    def test_from_nothing(self):
        # The folder is new: nothing was configured since, and no list names it.
        self.must("cmake", "--build", "build/release", "--target", "weave")
        rules = (self.root / "build/release/build.ninja").read_text()
        for section in "mine-elevation", "fitting-gauge":
            self.assertTrue(f"{section}_q.c" in rules, section)
        self.must("cmake", "--preset", "release", "-DBUILD_TESTING=OFF", "-DCAGD_ONLY_CHAPTERS=mine")

        # What is wrong with a line is told once, not once for each number type.
        section = self.mine / "elevation.claims.h"
        plain = section.read_text()
        section.write_text(plain.replace("left, right, t = parameter", "left, right, u = parameter"))
        r = self.compiled("--", "-k", "0")
        self.assertNotEqual(r.returncode, 0)
        self.assertEqual((r.stdout.count("FAILED: "), r.stdout.count("‘t’ undeclared") + r.stdout.count("identifier 't'")), (1, 1), r.stdout)

        # The plain claim fails, and says where.
        section.write_text(plain)
        cagd = self.cagd()
        r = run(cagd, "verify", "mine.*")
        self.assertEqual(r.returncode, 1, r.stdout)
        self.assertIn("small instance:\n         n = 1\n         t = 1/2\n         P0 to P1 = 0, 1\n", r.stdout)
        self.assertIn("left = 1/2\n         right = 1/4\n", r.stdout)
        r = run(cagd, "show", "my-paper:2.1")
        self.assertIn("It is open.", r.stdout)
        self.assertIn("P0 to P1 = 0, 1", r.stdout)

        # With these numbers it is refuted; the corrected formula and a bound are decided.
        shutil.copy(EXAMPLE / "elevation.claims.h", section)
        cagd = self.cagd()
        r = run(cagd, "verify", "mine.*")
        self.assertEqual(r.returncode, 0, r.stdout)
        self.assertIn("6 of 6 controls caught", r.stdout)
        r = run(cagd, "show", "my-paper:*", env={**os.environ, "COLUMNS": "88"})
        for words in ("It fails as printed: a misprint (decided).", "It holds: proved for n = 1 to 4; all data.",
                      "It holds as printed: decided for 0 ≤ t ≤ 1.", "A. Author: On curves, 2026\n"):
            self.assertIn(words, r.stdout)

        # A decision that fails shows its data, those of the block and random ones, and the condition, wherever it is told.
        right = (EXAMPLE / "elevation.claims.h").read_text()
        wrong = right.replace("c = 1/2\n:instead: c = 1/3", "c = 1/3\n:instead: c = 1/4").replace(
            "    agree(T, sign_on(", "    gap = poly_mul(gap, poly_constant(positive(T, \"w\", 0)));\n    agree(T, sign_on(")
        self.assertEqual(wrong.count(":instead: c = 1/4") + wrong.count("positive("), 2)
        section.write_text(wrong)
        cagd = self.cagd()
        condition = "sign_on gap from_int 0 from_int 1 CLOSED SIGN_NONNEGATIVE"
        report = self.root / "report.xml"
        for args in ["verify"], ["verify", "--tap"], ["verify", "--json"], ["verify", "--junit", report], ["show"]:
            r = run(cagd, *args, "middle_function_is_at_most_one_half", env={**os.environ, "COLUMNS": "100"})
            self.assertEqual(r.returncode, 1, r.stdout)
            said = report.read_text() if report in args else r.stdout
            said = " ".join(re.sub(r"\b(name|value)\b|[^\w/]", " ", said).split())
            for words in r"w0 \d+/\d+ c 1/3 condition " + condition, r"mall.instance[a-z ]* w0 1 c 1/3 condition " + condition:
                self.assertRegex(said, words)


if __name__ == "__main__":
    unittest.main(verbosity=2)
