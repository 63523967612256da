"""The house: which room may see which, what must stand beside what.

    python3 test_house.py ROOT REGISTER.json
"""
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(ROOT / "proofs-tests/scripts"))
from register import load, words  # noqa: E402

REGISTER = load(sys.argv.pop(1))
ROOMS = ["core", "exact", "figures", "chapters", "cli"]
SOURCES = [p for room in ROOMS for p in sorted((ROOT / room).rglob("*")) if p.suffix in (".c", ".h", ".cpp")]


def includes(path):
    return re.findall(r'^\s*#\s*include\s*([<"][^>"]+[>"])', path.read_text(), re.M)


class Arrows(unittest.TestCase):
    """core <- exact <- figures <- chapters <- cli"""

    def test_each_room_sees_only_the_rooms_before_it(self):
        for path in SOURCES:
            room = path.relative_to(ROOT).parts[0]
            for inc in includes(path):
                target = inc[1:-1].split("/")[0]
                if inc[0] == '"' and target in ROOMS:
                    self.assertLessEqual(ROOMS.index(target), ROOMS.index(room), f"{path} includes {inc}")

    def test_project_includes_start_at_the_root(self):
        for path in SOURCES:
            for inc in includes(path):
                if inc[0] == '"' and not inc.startswith('"generated/'):
                    self.assertTrue((ROOT / inc[1:-1]).exists(), f"{path} includes {inc}, which is not there")

    def test_core_is_free_of_exact_libraries(self):
        for path in SOURCES:
            if path.relative_to(ROOT).parts[0] == "core":
                for inc in includes(path):
                    self.assertNotRegex(inc, "gmp|mpfr|flint|calcium|arb", f"{path}")

    def test_flint_stays_behind_exact(self):
        for path in SOURCES:
            if any(re.search("flint|calcium|arb", i) for i in includes(path)):
                self.assertEqual(path.relative_to(ROOT).parts[0], "exact", f"{path}")
                self.assertTrue(path.suffix == ".c" or path.name.endswith("_slot.h"), f"{path}")

    def test_chapters_never_include_one_another(self):
        for path in (ROOT / "chapters").rglob("*.[ch]"):
            mine = path.relative_to(ROOT).parts[1]
            for inc in includes(path):
                parts = inc[1:-1].split("/")
                if parts[0] == "chapters":
                    self.assertIn(parts[1], ("judge", mine), f"{path} includes {inc}")

    def test_no_section_is_longer_than_900_lines(self):
        for path in sorted((ROOT / "chapters").glob("*/*.claims.h")):
            self.assertLessEqual(len(path.read_text().splitlines()), 900, f"{path.name}: two themes are two sections")

    def test_the_words_of_drawings_are_defined_once(self):
        words = re.findall(r"^static inline \w+ (\w+)\(", (ROOT / "figures/words.h").read_text(), re.M)
        self.assertTrue(words)
        for path in sorted((ROOT / "chapters").rglob("*.figure.c")) + sorted((ROOT / "chapters").rglob("*.h")):
            again = re.findall(r"^static (?:inline )?[\w ]+?\b(%s)\([^G]" % "|".join(words), path.read_text(), re.M)
            self.assertEqual(again, [], f"{path} has words of figures/words.h")

    def test_commands_refuse_by_one_function(self):
        """Which keeps what it says in one line.  A terminal's progress and the place in a document, below that line, are none;
        native.c is a program of its own, which only the grader reads."""
        for path in sorted((ROOT / "cli").rglob("*.c")):
            for text in re.findall(r'(?:printf|fputs|fputc|perror)\([^;]*?stderr[^;]*;|perror\([^;]*;', path.read_text()):
                self.assertTrue(path.name in ("refuse.c", "progress.c", "waiting.c", "document.c", "native.c") or "verifying" in text, f"{path}: {text}")

    def test_commands_are_given_their_register(self):
        knowing = [p.relative_to(ROOT).as_posix() for p in SOURCES if '"chapters/chapters.h"' in includes(p)]
        self.assertEqual([p for p in knowing if p.startswith("cli/")], ["cli/main.c"])


class Claims(unittest.TestCase):
    """Right and wrong stand side by side: fault(T, right, wrong)."""

    def test_only_the_judge_knows_which_run_is_the_control(self):
        for path in SOURCES:
            parts = path.relative_to(ROOT).parts
            if parts[0] == "chapters" and parts[1] != "judge":
                for number, line in enumerate(path.read_text().splitlines(), 1):
                    self.assertNotRegex(line, r"\bplanted\b", f"{path}:{number}: say fault(T, right, wrong)")


class Kernels(unittest.TestCase):
    """Four parts or it does not exist: kernel, contract comment, claim, register line."""

    TEMPLATES = sorted((ROOT / "core/kernels").glob("*.tmpl.h"))

    def kernels(self, path):
        return re.findall(r"^KERNEL [\w ]+?\**\s*G\((\w+)\)\(", path.read_text(), re.M)

    def test_every_template_is_in_the_one_list(self):
        listed = (ROOT / "core/kernels/kernels.tmpl.h").read_text()
        for path in self.TEMPLATES:
            # span.tmpl.h is for ordered numbers alone
            if path.name not in ("kernels.tmpl.h", "span.tmpl.h") and not path.name.endswith("_type.tmpl.h"):
                self.assertIn(f'"core/kernels/{path.name}"', listed)

    def test_every_kernel_has_a_contract(self):
        for path in self.TEMPLATES:
            text = path.read_text()
            for name in self.kernels(path):
                before = text[: re.search(r"^KERNEL [^\n]*G\(%s\)\(" % name, text, re.M).start()].rstrip()
                self.assertTrue(before.endswith("*/"), f"{path.name}: {name} has no comment above it")

    def test_every_kernel_has_a_definitional_claim(self):
        defined = {kernel for claim in REGISTER["claims"] for kernel in words(claim, "defines")}
        missing = [n for p in self.TEMPLATES for n in self.kernels(p) if n not in defined]
        self.assertEqual(missing, [], "kernels without a definitional claim")
        known = {n for p in self.TEMPLATES for n in self.kernels(p)}
        self.assertEqual(sorted(defined - known), [], "claims that define what is not there")

    def test_no_kernel_has_more_parameters_than_the_guide_says(self):
        most = int(re.search(r"no kernel has more than (\d+) parameters", (ROOT / "CONTRIBUTING.md").read_text().replace("\n   ", " "))[1])
        count = {name: 1 + re.search(r"^KERNEL [^\n]*G\(%s\)\(([^)]*)\)" % name, path.read_text(), re.M)[1].count(",")
                 for path in self.TEMPLATES for name in self.kernels(path)}
        self.assertEqual(max(count.values()), most, sorted(count.items(), key=lambda c: c[1])[-3:])

    def test_no_kernel_compares_or_leaves_the_vocabulary(self):
        for path in self.TEMPLATES:
            text = re.sub(r"/\*.*?\*/", "", path.read_text(), flags=re.S)
            self.assertNotRegex(text, r"\b(double|float|mpq_|mpfr_|fabs|sqrt)\b", f"{path.name}")


class Faults(unittest.TestCase):
    def test_every_fault_that_changes_nothing_is_one_of_a_line_that_stands(self):
        for line in (ROOT / "proofs-tests/faults/equivalent.txt").read_text().splitlines():
            if line.strip() and not line.startswith("#"):
                file, code, _, reason = (part.strip() for part in line.split(" | ", 3))
                stands = code in [each.strip() for each in (ROOT / file).read_text().splitlines()]
                self.assertTrue(stands, f"{file} has no line '{code}'")
                self.assertTrue(reason, line)


class Contents(unittest.TestCase):
    """The page on the table of contents of a source names claims that exist, and every section of the book once."""

    SECTIONS = {1: 9, 2: 10, 3: 6, 4: 9, 5: 7, 6: 11, 7: 3, 8: 8, 9: 7}

    def setUp(self):
        text = (ROOT / "chapters/foundations/contents.claims.h").read_text()
        self.rows = [line.strip("|").split("|") for line in re.findall(r"^\|.*\|$", text, re.M)][2:]

    def test_every_claim_exists(self):
        claims = {claim["name"] for claim in REGISTER["claims"]}
        named = [name for row in self.rows for name in re.findall(r"`([^`]*)`", "|".join(row))]
        self.assertTrue(named)
        self.assertEqual([name for name in named if name not in claims], [], "names of no claim")

    def test_every_section_of_the_book_is_there_once(self):
        expected = [f"{c}-{k}" for c, count in self.SECTIONS.items() for k in range(1, count + 1)]
        self.assertEqual([row[0].strip() for row in self.rows], expected)

    def test_what_is_not_covered_is_open(self):
        for row in self.rows:
            self.assertEqual(len(row), 4, row)
            self.assertTrue(row[2].strip() or row[3].strip(), f"{row[0]} is neither covered nor open")


class Sources(unittest.TestCase):
    """The bibliography: every key that is cited is in it, and every key in it is cited."""

    KEY = r"\b[a-z]+(?:-[a-z]+)*-(?:1[789]\d\d|20[012]\d)\b|\b(?:wang|slides)-ch\d\b"

    def setUp(self):
        listed = [source["key"] for source in REGISTER["sources"]]
        self.assertEqual(len(listed), len(set(listed)))
        self.listed = set(listed)
        self.texts = {}
        for room in ROOMS + ["proofs-tests"]:
            for path in (ROOT / room).rglob("*"):
                is_input = "corpus" in path.parts  # of the fuzzers: bytes that cite nothing
                if path.suffix in (".c", ".h", ".cpp", ".md", ".py") and not is_input and path.parts[-2:] != ("sources", "index.md"):
                    self.texts[path] = path.read_text()

    def test_every_key_that_is_cited_is_listed(self):
        for path, text in self.texts.items():
            self.assertEqual(set(re.findall(self.KEY, text)) - self.listed, set(), path)

    def test_every_key_that_is_listed_is_cited(self):
        cited = {key for text in self.texts.values() for key in re.findall(self.KEY, text)}
        self.assertEqual(self.listed - cited, set())

    def test_a_contract_names_its_sources_by_key(self):
        for path, text in self.texts.items():
            for items in re.findall(r"\bSource: (.*?)\.(?= \*/|  |\s*$|\n \*$)", text, re.S | re.M):
                for item in re.sub(r"\s+\*?\s*", " ", items).split("; "):
                    if not item.startswith("the "):
                        self.assertRegex(item, "^(hu-1987|" + self.KEY + ")", path)


if __name__ == "__main__":
    unittest.main(verbosity=2)
