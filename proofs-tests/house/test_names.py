"""The names of the libraries, read from the archives: whoever links them meets no name without prefix.

    test_names.py ROOT NM ARCHIVE...
"""
import pathlib
import re
import subprocess
import sys
import unittest

ROOT, NM, ARCHIVES = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]
del sys.argv[1:]


def names(archive):
    listed = subprocess.run([NM, "-g", "--defined-only", archive], check=True, capture_output=True, text=True).stdout
    return [line.split()[2] for line in listed.splitlines() if len(line.split()) == 3]


def without_comments(path):
    return re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.S)


def prototypes(path):
    """Name and parameters of every function that a header declares or defines."""
    text = re.sub(r"\s+", " ", without_comments(path))
    return dict(re.findall(r"\b(cagd_\w+)\(((?:[^()]|\([^()]*\))*)\) ?[;{]", text))


class Names(unittest.TestCase):
    def test_every_external_name_has_the_prefix(self):
        for archive in ARCHIVES:
            found = names(archive)
            self.assertTrue(found, archive)
            self.assertEqual([n for n in found if not n.startswith("cagd_")], [], archive)

    def test_the_public_header_has_no_other_names(self):
        for header in re.findall(r'#include "(exact/[^"]*)"', (ROOT / "exact/cagd_exact.h").read_text()):
            text = re.sub(r'"[^"]*"|#.*', "", without_comments(ROOT / header))
            for tag in re.findall(r"\b(?:struct|enum) (\w+)", text):
                self.assertTrue(tag.startswith("cagd_"), f"{header}: {tag}")
            for listed in re.findall(r"enum[ \w]*\{([^}]*)\}", text):
                for enumerator in re.findall(r"(\w+)(?: = [^,]*)?(?:,|\s*$)", listed):
                    self.assertTrue(enumerator.startswith("CAGD_"), f"{header}: {enumerator}")
            for function in re.findall(r"^(?:static inline )?[\w ]+[ *](\w+)\(", text, re.M):
                self.assertTrue(function.startswith("cagd_"), f"{header}: {function}")


class TwoFamilies(unittest.TestCase):
    """What decides records nothing; what testifies is a twin of what decides."""

    RECORD = sorted((ROOT / "exact/record").glob("*.h"))
    PLAIN = {k: v for room in ("number", "decide") for p in (ROOT / "exact" / room).glob("*.h") for k, v in prototypes(p).items()}

    def test_numbers_and_decisions_know_no_record(self):
        for room, forbidden in (("number", "decide|record|fit|curve"), ("decide", "record|fit|curve"), ("record", "fit|curve")):
            for path in (ROOT / "exact" / room).iterdir():
                self.assertNotRegex(path.read_text(encoding="utf-8"), f'#include "exact/({forbidden})/', str(path))
        for path in (ROOT / "exact/decide").iterdir():
            self.assertNotIn("recorder", path.read_text(encoding="utf-8"), str(path))

    def test_every_witness_has_a_plain_twin(self):
        seen = 0
        for path in self.RECORD:
            for name, parameters in prototypes(path).items():
                if name.startswith("cagd_testify_") and name != "cagd_testify_operations":  # that one is told, not asked
                    twin = name.replace("testify_", "", 1)
                    self.assertIn(twin, self.PLAIN, path.name)
                    self.assertEqual(parameters, self.PLAIN[twin], name)
                    seen += 1
        self.assertGreater(seen, 30)

    def test_short_words_testify_where_there_is_a_witness(self):
        plain = dict(re.findall(r"#define (\w+) +(\w+)", (ROOT / "exact/words.h").read_text()))
        for path in self.RECORD:
            defined = dict(re.findall(r"#define (\w+) +(cagd_\w+)", path.read_text(encoding="utf-8")))
            for name in prototypes(path):
                if name.startswith("cagd_testify_") and name != "cagd_testify_operations":
                    word = name.replace("cagd_testify_", "", 1)
                    self.assertEqual(defined.get(word), name, path.name)
                    self.assertNotIn(word, plain)


if __name__ == "__main__":
    unittest.main(verbosity=2)
