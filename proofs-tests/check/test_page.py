"""All that `cagd check` tells of page.md, which has every kind of answer, and of page-forms.md and page-bases.md, with forms of them that are rare: the page, JSON, JUnit's XML, and the
pictures, to the letter.

    python3 test_page.py CAGD             compares with page.txt, page.json, page.xml, page.svg, those of the other two, page-mistakes.txt
    python3 test_page.py CAGD --write     writes them anew, to be read before they are kept
"""
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())


PAGES = ("page", "page-forms", "page-bases")


def told(name):
    """{ending: text}; times are left out."""
    with tempfile.TemporaryDirectory() as folder:
        svg, xml = pathlib.Path(folder) / "page.svg", pathlib.Path(folder) / "page.xml"
        run = lambda *options: subprocess.run([CAGD, "check", *options, f"{name}.md"], cwd=HERE, capture_output=True, text=True, timeout=600)
        page, as_json = run("--svg", svg, "--junit", xml), run("--json")
        assert (page.returncode, page.stderr, as_json.returncode, as_json.stderr) == (1, "", 1, ""), (page.stderr, as_json.stderr)
        times = lambda text: re.sub(r'(time|timestamp|hostname|version)="[^"]*"', r'\1=""', text)
        return {"txt": page.stdout, "json": re.sub(r'"(seconds|version)": [^,\n]*', r'"\1": 0', as_json.stdout), "xml": times(xml.read_text()), "svg": svg.read_text()}


def mistakes():
    """What is told of each block of page-mistakes.md, the first one being before it."""
    first, *blocks = (HERE / "page-mistakes.md").read_text().split("\n\n")[1:]
    lines = []
    for block in blocks:
        r = subprocess.run([CAGD, "check", "-"], input=f"{first}\n\n{block}\n", cwd=HERE, capture_output=True, text=True, timeout=60)
        lines += [f"{r.returncode} {r.stdout}".strip(), *r.stderr.splitlines()]
    return "\n".join(lines) + "\n"


class Page(unittest.TestCase):
    maxDiff = None

    def test_everything_is_told_as_it_was(self):
        for name in PAGES:
            for ending, text in told(name).items():
                with self.subTest(name=name, ending=ending):
                    self.assertEqual(text.splitlines(), (HERE / f"{name}.{ending}").read_text().splitlines())

    def test_every_mistake_of_a_block_is_told(self):
        self.assertEqual(mistakes().splitlines(), (HERE / "page-mistakes.txt").read_text().splitlines())


if __name__ == "__main__":
    if sys.argv[1:] == ["--write"]:
        for name in PAGES:
            for ending, text in told(name).items():
                (HERE / f"{name}.{ending}").write_text(text)
        (HERE / "page-mistakes.txt").write_text(mistakes())
    else:
        unittest.main(verbosity=2)
