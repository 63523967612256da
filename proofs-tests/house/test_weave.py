"""weave: a good chapter becomes a register; every kind of bad block is refused with file and line.

    python3 test_weave.py WEAVE
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

WEAVE = str(pathlib.Path(sys.argv.pop(1)).resolve())
TYPES = "field rational interval double"

INDEX = """# A chapter (一章)

:::{letters} chapter
:over: t
:degree: p
:within: the interval | all intervals
:within: * | the interval
:::

```{toctree}
:maxdepth: 1

first
second
```
"""

# Every kind of option occurs once; the tests below spoil one line at a time.
FIRST = r"""/*
# A section

:::{statement} source:1.1
:title: A title
:zh: 标题
:printed: a=b,
  \ b="c"
:holds-by: sum_is_zero
:needs: ratio_fails | section 1 | a hypothesis that is stated
:hypothesis: ratio_fails | $a:b$ is less.b; as a
  sentence says
:reading: a way to read it
:meant: the title | what is meant
:confirmed-by: range_is_decided
:argued: every n | by induction
:cites: a book | a theorem
:figure: picture
:example: it stands for all
:striking: 2
:degree: 3

A remark: with a colon.
:::

:::{statement} source:1.2
:title: Another
:zh: 另一
:printed: a/b
:class: false
:refuted-by: ratio_fails
:corrected: b/a
:corrected-by: sum_is_zero range_is_decided
:::

:::{claim} sum_is_zero
:title: A sum
:zh: 和
:given: numbers
:then: their sum is 0
:method: by computing it
:degrees: k = 1..6 sampled 12
:over: h#: lengths
:argued: every k | by words
:types: field rational
:defines: kernel
:control: a term left out
:::
*/
CLAIM(sum_is_zero)
{
}
"""

SECOND = r"""/*
:::{claim} ratio_fails
:title: A ratio
:zh: 比
:kind: counterexample
:given: two numbers
:data: R = (0,1/2) (-3,0x1.8p-3); w = 1 0.5 w1;
  n = 2; F = "y^2; x^3"
:instead: n = 3
:result: R''(0) = (4,0)
:let: one be 0
:then: there is no ratio
:method: by dividing
:control: the other way round
:::
*/
CLAIM(ratio_fails)
{
}

/*
:::{claim} range_is_decided
:title: A range
:zh: 范围
:kind: decision
:given: an interval
:then: it is decided
:method: by roots
:scope: the interval
:where: $t>0$; all is well
:harmless: an inter | it has no hole
:control: a larger interval
:::
*/
CLAIM(range_is_decided)
{
}

/*
:::{claim} every_degree
:title: Every degree
:zh: 任意次数
:given: n
:then: it holds
:method: n is a variable
:scope: all intervals; 0 < t < 1
:degrees: all from 3
:control: n + 1
:::
*/
CLAIM(every_degree)
{
}
"""

FIGURE = """FIGURE(picture)
{
}
"""


def line_of(text, part):
    """The number of the line of text that contains part, which occurs once."""
    assert text.count(part) == 1, part
    return text[: text.index(part)].count("\n") + 1


class Weaving(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        (self.root / "chapter").mkdir()
        self.write("index.md", INDEX)
        self.write("first.claims.h", FIRST)
        self.write("second.claims.h", SECOND)
        self.write("first.figure.c", FIGURE)

    def write(self, name, text):
        (self.root / "chapter" / name).write_text(text, encoding="utf-8")

    def weave(self, types=TYPES, chapters=("chapter",)):
        return subprocess.run([WEAVE, "register.c", "register.json", types, *chapters], cwd=self.root, capture_output=True, text=True,
                              timeout=60)

    def register(self, **options):
        r = self.weave(**options)
        self.assertEqual((r.returncode, r.stderr, r.stdout), (0, "", ""))
        return (self.root / "register.c").read_text(encoding="utf-8")

    def refused(self, name, line, *words):
        """Exit 1, no register, and a complaint at that line of that file with these words in it."""
        r = self.weave()
        self.assertEqual(r.returncode, 1, r)
        self.assertFalse((self.root / "register.c").exists())
        for complaint in r.stderr.splitlines():
            self.assertRegex(complaint, r"^chapter/[a-z.]+:[1-9][0-9]*: .")
        at = [c for c in r.stderr.splitlines() if c.startswith(f"chapter/{name}:{line}: ")]
        self.assertTrue(any(all(w in c for w in words) for c in at), r.stderr)

    def spoiled(self, name, old, new, *words, at=None):
        """Put new for old; the complaint is expected in the line of `at`, a text that the spoiled file contains."""
        text = {"first.claims.h": FIRST, "second.claims.h": SECOND, "index.md": INDEX}[name]
        self.assertEqual(text.count(old), 1, old)
        spoiled = text.replace(old, new)
        self.write(name, spoiled)
        self.refused(name, line_of(spoiled, at or new), *words)


class Good(Weaving):
    def test_claims_in_reading_order(self):
        text = self.register()
        names = re.findall(r'^    {\.name = "(\w+)", \.title', text, re.M)
        self.assertEqual(names, ["sum_is_zero", "ratio_fails", "range_is_decided", "every_degree"])
        self.assertIn("FIGURE(picture);", text)
        self.assertIn('{"chapter", "A chapter (一章)"}', text)

    def claim(self, text, name):
        return re.search(r'^    {\.name = "%s".*$' % name, text, re.M).group(0)

    def test_kinds_degrees_and_types(self):
        text = self.register()
        c = self.claim(text, "sum_is_zero")
        self.assertIn(".kind = IDENTITY, .degree_low = 1, .degree_high = 6, .degree_sampled = 12, .all_degrees = 0", c)
        self.assertIn('.defines = "kernel", .over = "h#: lengths;t", .letter = "k"', c)
        self.assertIn('.argued_for = "every k", .argued = "by words"', c)
        self.assertIn('.over = "t", .letter = "p", .within = within', self.claim(text, "every_degree"))
        table = re.search(r"static const char within\[\] = \{(.*?)\};", text, re.S).group(1)
        phrases = bytes(int(x, 16) for x in re.findall(r"'\\x(\w\w)'", table)).decode()
        self.assertEqual(phrases, "the interval | all intervals;* | the interval")
        self.assertIn(f'.file = "chapter/first.claims.h", .line = {line_of(FIRST, ":::{claim} sum_is_zero")},', c)
        self.assertIn("[FIELD_TYPE] = claim_sum_is_zero_f, [RATIONAL_TYPE] = claim_sum_is_zero_q, }}", c)
        self.assertIn(".kind = COUNTEREXAMPLE", self.claim(text, "ratio_fails"))
        self.assertIn("{[RATIONAL_TYPE] = claim_ratio_fails_q, }}", self.claim(text, "ratio_fails"))
        self.assertIn(".kind = DECISION", self.claim(text, "range_is_decided"))
        self.assertIn(".degree_low = 3, .degree_high = 3, .degree_sampled = 3, .all_degrees = 1",
                      self.claim(text, "every_degree"))
        for suffix in "fqim":
            self.assertIn(f"claim_every_degree_{suffix}", self.claim(text, "every_degree"))

    def test_links_and_texts(self):
        text = self.register()
        for link in ('{HOLDS_BY, "sum_is_zero", NULL, "", NULL}', '{NEEDS, "ratio_fails", "section 1", "a hypothesis that is stated", "a hypothesis that is stated"}',
                     '{HYPOTHESIS, "ratio_fails", NULL, "$a:b$ is less.b; as a sentence says", "$a:b$ is less.b"}',
                     '{READING, NULL, NULL, "a way to read it", "a b c"}',
                     '{MEANT, NULL, "the title", "what is meant", NULL}', '{CONFIRMED_BY, "range_is_decided", NULL, "", NULL}',
                     '{ARGUED, NULL, "every n", "by induction", NULL}', '{CITES, NULL, "a book", "a theorem", NULL}',
                     '{REFUTED_BY, "ratio_fails", NULL, "", NULL}', '{CORRECTED_BY, "sum_is_zero", NULL, "", NULL}',
                     '{CORRECTED_BY, "range_is_decided", NULL, "", NULL}'):
            self.assertIn(link, text)
        self.assertIn(r'.printed = "a=b, \\ b=\"c\""', text)
        self.assertIn('.note = "A remark: with a colon."', text)
        self.assertIn(".is_definition = 0, .striking = 2, .degree = 3", text)
        self.assertIn('.example = "it stands for all"', text)

    def test_claims_of_types_that_are_not_compiled_are_left_out(self):
        text = self.register(types="double")
        self.assertEqual(re.findall(r'^    {\.name = "(\w+)", \.title', text, re.M), ["every_degree"])

    def test_two_chapters(self):
        (self.root / "other").mkdir()
        (self.root / "other" / "index.md").write_text("# Other\n", encoding="utf-8")
        self.assertIn('{"other", "Other"}', self.register(chapters=("chapter", "other")))

    def test_chapters_are_in_the_order_that_they_state(self):
        for name, order in (("last", None), ("third", 30), ("second", 20), ("also-last", None)):
            (self.root / name).mkdir()
            letters = f"\n:::{{letters}} {name}\n:order: {order}\n:::\n" if order else ""
            (self.root / name / "index.md").write_text(f"# The {name}\n{letters}", encoding="utf-8")
        self.write("index.md", INDEX.replace(":degree: p\n", ":degree: p\n:order: 3\n"))
        text = self.register(chapters=("also-last", "last", "second", "third", "chapter"))
        self.assertEqual(re.findall(r'^    {"([a-z-]+)", "(?:A|The) ', text, re.M), ["chapter", "second", "third", "also-last", "last"])

    def test_chinese_titles_only_where_the_heading_has_one(self):
        self.write("index.md", INDEX.replace("# A chapter (一章)", "# A chapter é ω"))
        for name, text in (("first.claims.h", FIRST), ("second.claims.h", SECOND)):
            self.write(name, re.sub(r"^:zh:.*\n", "", text, flags=re.M))
        self.assertIn('.title = "A sum", .title_zh = ""', self.register())

    def test_the_register_is_c(self):
        compiler = os.environ.get("CC", "cc")
        root = pathlib.Path(__file__).resolve().parents[2] / "chapters"
        (self.root / "chapters" / "judge").mkdir(parents=True, exist_ok=True)
        for header in ("chapters.h", "judge/register.h", "judge/claim.h", "judge/figure.h", "judge/lists.h"):
            (self.root / "chapters" / header).write_text((root / header).read_text(encoding="utf-8"), encoding="utf-8")
        self.register()
        r = subprocess.run([compiler, "-std=c17", "-Wall", "-Werror", "-fsyntax-only", "-I.", "register.c"], cwd=self.root,
                           capture_output=True, text=True, timeout=60)
        self.assertEqual(r.returncode, 0, r.stderr)


    def test_data(self):
        text = self.register()
        data = text[text.index("static const datum data_"):]
        for row in ('{.name = "R", .text = "(0,1/2) (-3,0x1.8p-3)", .place = IN_DATA, .rows = 2, .columns = 2, .value = values_4_0}',
                    '{.name = "w", .text = "1 0.5 w1", .place = IN_DATA, .rows = 3, .columns = 1, .value = values_4_1}',
                    '{.name = "n", .text = "2", .place = IN_DATA, .rows = 1, .columns = 1, .value = values_4_2}',
                    '{.name = "F", .text = "\\"y^2; x^3\\"", .place = IN_DATA, .rows = 1, .columns = 0, .value = values_4_3}',
                    '{.name = "n", .text = "3", .place = IN_INSTEAD, .rows = 1, .columns = 1, .value = values_4_4}',
                    """{.name = "R''(0)", .text = "(4,0)", .place = IN_RESULT, .rows = 1, .columns = 2, .value = values_4_5}"""):
            self.assertIn(row, data)
        self.assertIn('values_4_0[] = {"0", "1/2", "-3", "0x1.8p-3"}', text)
        self.assertIn('values_4_3[] = {"y^2; x^3"}', text)

    def test_json(self):
        self.register()
        r = json.loads((self.root / "register.json").read_text(encoding="utf-8"))
        self.assertEqual(r["schema"], "cagd-register-1")
        self.assertEqual(r["lists"]["types"], TYPES.split())
        self.assertEqual(r["lists"]["kinds"], ["identity", "decision", "counterexample"])
        self.assertEqual([c["name"] for c in r["claims"]], ["sum_is_zero", "ratio_fails", "range_is_decided", "every_degree"])
        c = r["claims"][1]
        self.assertEqual((c["kind"], c["types"], c["chapter"]), ("counterexample", ["rational"], "chapter"))
        self.assertEqual((c["line"], c["body"]), (line_of(SECOND, ":::{claim} ratio_fails"), line_of(SECOND, "CLAIM(ratio_fails)")))
        self.assertEqual(c["data"][4], {"place": "instead", "name": "n", "rows": 1, "columns": 1, "values": ["3"]})
        self.assertEqual([s["id"] for s in r["statements"]], ["source:1.1", "source:1.2"])
        self.assertIn(["class", "false"], r["statements"][1]["options"])
        self.assertEqual(r["statements"][0]["note"], "A remark: with a colon.")
        self.assertEqual(r["figures"], ["picture"])

    def test_sources(self):
        (self.root / "sources").mkdir()
        (self.root / "sources" / "index.md").write_text(
            "# Sources\n\n:::{source} source\n:author: A. Uthor\n:title: A book\n:year: 1987\n:::\n", encoding="utf-8")
        text = self.register(chapters=("chapter", "sources"))
        self.assertIn('{.key = "source", .author = "A. Uthor", .title = "A book", .title_zh = "", .year = "1987"', text)
        self.assertNotIn('{"sources"', text)
        (self.root / "sources" / "index.md").write_text(":::{source} other\n:author: A\n:title: A book\n:::\n", encoding="utf-8")
        r = self.weave(chapters=("chapter", "sources"))
        self.assertEqual(r.returncode, 1)
        self.assertIn("chapter/first.claims.h:4: 'source:1.1' is of no source", r.stderr)


    def test_the_letter_of_degrees(self):
        (self.root / "sources").mkdir()
        book = ":::{source} source\n:author: A\n:title: A book\n"
        for options, letter in ((":letter: k\n", "k"), (":letter: k\n:counts: order\n", "order"), (":letter: b\n:counts: order\n", "b"),
                                (":counts: degree\n", "degree")):
            (self.root / "sources" / "index.md").write_text(book + options + ":::\n", encoding="utf-8")
            self.assertIn(f'.letter = "{letter}", .letters = "a b c", .chapter = "chapter", .file = "chapter/first.claims.h", .line = 4,',
                          self.register(chapters=("chapter", "sources")))

    def test_the_parameter_of_a_source_is_a_letter_of_each_statement(self):
        (self.root / "sources").mkdir()
        (self.root / "sources" / "index.md").write_text(
            ":::{source} source\n:author: A\n:title: A book\n:parameter: beta\n:::\n", encoding="utf-8")
        self.assertIn('.letters = "a b c beta"', self.register(chapters=("chapter", "sources")))

    def test_letters_that_a_statement_prints(self):
        self.assertIn('.letters = "a b c"', self.register())  # each once, and none of a sentence
        self.write("first.claims.h", FIRST.replace(":printed: a/b", r":printed: The line $\\beta_1=x'y$ and $\\frac{zu}2$, a word"))
        self.assertIn('.letters = "x y frac z u"', self.register())  # with an index it is another one
        self.write("first.claims.h", FIRST.replace(":printed: a/b", ":printed: some words and a=ji"))
        self.assertIn('.letters = "a j i"', self.register())
        for printed, letters in ((r"x=\\sum_{i=0}^na_i+b_i+c", "x n c"),  # the index of a sum is none
                                 (r"$B_i$ and $\\sum_{i=0}^nB_i=\\prod_jc_j$", "i n"),
                                 (r"$\\sum_{i=0}^nB_i+t$ for every $i$", "n t i")):
            self.write("first.claims.h", FIRST.replace(":printed: a/b", f":printed: {printed}"))
            self.assertIn(f'.letters = "{letters}"', self.register())
        self.write("first.claims.h", FIRST.replace(":printed: a/b", ":printed: it is so of a or i"))
        self.assertIn('.letters = ""', self.register())


class BadWords(Weaving):
    def test_forms(self):
        for old, new, *words in ((":meant: the title | what is meant", ":meant: what is meant", "place | text"),
                                 (":argued: every n | by induction", ":argued: by induction", "place | text"),
                                 (":cites: a book | a theorem", ":cites: a book |", "place | text"),
                                 (":argued: every k | by words", ":argued: by words", "cases | text"),
                                 (":confirmed-by: range_is_decided", ":confirmed-by: ratio_fails", "the counterexample"),
                                 (":degrees: k = 1..6", ":degrees: k = 1...6", "degrees are written")):
            with self.subTest(new):
                at = ":::{claim} sum_is_zero" if "degrees" in new or "by words" in new else None
                self.spoiled("first.claims.h", old, new, *words,
                             at=at or (":::{statement} source:1.1" if "confirmed" in new else None))

    def test_a_hypothesis_begins_with_its_condition(self):
        old = ":needs: ratio_fails | section 1 | a hypothesis that is stated"
        for text in ("A hypothesis that is stated", "a hypothesis, as it is stated", "a " + "long " * 30 + "hypothesis", ": why"):
            with self.subTest(text):
                self.spoiled("first.claims.h", old, f":needs: ratio_fails | section 1 | {text}", "begins with its condition")
        self.spoiled("first.claims.h", ":hypothesis: ratio_fails | $a:b$ is", ":hypothesis: ratio_fails | It is", "begins with its condition")

    def test_conditions_of_claims(self):
        self.assertIn('.where = "$t>0$; all is well"', self.register())
        at = ":::{claim} range_is_decided"
        self.spoiled("second.claims.h", ":where: $t>0$; all is well", ":where:", "one condition; another", at=at)
        self.spoiled("second.claims.h", ":let: one be 0", ":where: one is 0", "one condition; another", at=":::{claim} ratio_fails")
        for bad in ("an inter", "a hole | it has none", " | it has no hole", "an inter |"):
            with self.subTest(bad):
                self.spoiled("second.claims.h", ":harmless: an inter | it has no hole", f":harmless: {bad}", "words of what is given")

    def test_letters_are_those_of_their_chapter(self):
        self.spoiled("index.md", ":::{letters} chapter", ":::{letters} other", "chapter")
        self.spoiled("index.md", ":degree: p", ":degre: p", "unknown option")

    def test_what_is_within_are_two_phrases_of_scopes(self):
        row = ":within: the interval | all intervals"
        for bad in "the interval", "* | *", "the interval | every interval", "interval | all intervals", " | all intervals", "the interval |":
            self.spoiled("index.md", row, f":within: {bad}", "narrow | wide")


class BadData(Weaving):
    def test_bad_values(self):
        for old, new, *words in (("(0,1/2)", "(0,1/)", "'1/'", "no number"), ("(0,1/2)", "(0,1,2)", "3 and 2 coordinates"),
                                 ("(0,1/2)", "(0,1/2", "no number"), ("1 0.5 w1", "1 0..5 w1", "'0..5'"),
                                 ("1 0.5 w1", "", "no value"), ("w = 1", "w is 1", "name = value"),
                                 ("(-3,", "[-3,", "Points are written"), ("w = 1", "R = 1", "R occurs twice"),
                                 ("0x1.8p-3", "0x1.8q-3", "no number"), ("(0,1/2)", "(0,-)", "no number")):
            with self.subTest(new):
                self.spoiled("second.claims.h", old, new, "'ratio_fails'", *words, at=":data:")

    def test_too_many(self):
        many = "; ".join(f"x{k} = {k}" for k in range(65))
        self.spoiled("second.claims.h", ":instead: n = 3", f":instead: {many}", "more than 64", at=":::{claim} ratio_fails")


class BadClaims(Weaving):
    def test_the_body_follows_its_block(self):
        moved = SECOND.replace("*/\nCLAIM(range_is_decided)\n{\n}\n\n/*\n", "") + "CLAIM(range_is_decided)\n{\n}\n"
        self.write("second.claims.h", moved)
        self.refused("second.claims.h", line_of(moved, ":::{claim} range_is_decided"), "'range_is_decided'", "does not follow")

    def test_every_field_is_needed(self):
        for field in ("title: A sum", "zh: 和", "given: numbers", "then: their sum is 0", "method: by computing it",
                      "control: a term left out"):
            key = field.split(":")[0]
            with self.subTest(key):
                self.spoiled("first.claims.h", f":{field}\n", "", "sum_is_zero", key, at=":::{claim} sum_is_zero")
                self.spoiled("first.claims.h", f":{field}\n", f":{key}:\n", "sum_is_zero", key, at=":::{claim} sum_is_zero")

    def test_unknown_option(self):
        self.spoiled("first.claims.h", ":types: field", ":type: field", "unknown option", "'type'")

    def test_option_twice(self):
        self.spoiled("first.claims.h", ":given: numbers\n", ":given: numbers\n:given: others\n", "'given'", "twice",
                     at=":given: others")

    def test_unknown_kind(self):
        self.spoiled("second.claims.h", ":kind: decision", ":kind: descision", "descision", at=":::{claim} range_is_decided")

    def test_unknown_type(self):
        self.spoiled("first.claims.h", ":types: field rational", ":types: field ratoinal", "ratoinal",
                     at=":::{claim} sum_is_zero")

    def test_no_type(self):
        self.spoiled("first.claims.h", ":types: field rational", ":types:", "no types", at=":::{claim} sum_is_zero")

    def test_bad_degrees(self):
        for degrees in ("6", "1-6", "6..1", "-1..2", "any"):
            with self.subTest(degrees):
                self.spoiled("first.claims.h", ":degrees: k = 1..6 sampled 12", f":degrees: {degrees}", "degrees",
                             at=":::{claim} sum_is_zero")

    def test_no_body(self):
        self.spoiled("first.claims.h", "CLAIM(sum_is_zero)", "CLAIM (sum_is_zero)", "no body", at=":::{claim} sum_is_zero")

    def test_no_block(self):
        self.spoiled("first.claims.h", "CLAIM(sum_is_zero)", "CLAIM(stray)\n{\n}\nCLAIM(sum_is_zero)", "stray", "no claim block",
                     at="CLAIM(stray)")

    def test_twice(self):
        self.spoiled("second.claims.h", ":::{claim} every_degree", ":::{claim} range_is_decided\n:given: again", "twice",
                     at=":::{claim} range_is_decided\n:given: again")

    def test_not_closed(self):
        self.spoiled("second.claims.h", ":control: n + 1\n:::", ":control: n + 1", "no closing", at=":::{claim} every_degree")


class BadStatements(Weaving):
    def test_every_field_is_needed(self):
        for field in ("title: Another", "zh: 另一", "printed: a/b"):
            key = field.split(":")[0]
            with self.subTest(key):
                self.spoiled("first.claims.h", f":{field}\n", "", "source:1.2", key, at=":::{statement} source:1.2")

    def test_unknown_option(self):
        self.spoiled("first.claims.h", ":corrected: b/a", ":correction: b/a", "unknown option", "'correction'")

    def test_unknown_class(self):
        self.spoiled("first.claims.h", ":class: false", ":class: wrong", "unknown class", "wrong",
                     at=":::{statement} source:1.2")

    def test_refuted_without_class(self):
        self.spoiled("first.claims.h", ":class: false\n", "", "class", at=":::{statement} source:1.2")

    def test_class_without_refutation(self):
        self.spoiled("first.claims.h", ":holds-by: sum_is_zero\n", ":holds-by: sum_is_zero\n:class: misprint\n", "class",
                     at=":::{statement} source:1.1")

    def test_refuted_without_correction(self):
        self.spoiled("first.claims.h", ":corrected: b/a\n:corrected-by: sum_is_zero range_is_decided\n", "", "not corrected",
                     at=":::{statement} source:1.2")

    def test_correction_without_claim(self):
        self.spoiled("first.claims.h", ":corrected-by: sum_is_zero range_is_decided\n", "", "corrected",
                     at=":::{statement} source:1.2")

    def test_claim_without_correction(self):
        self.spoiled("first.claims.h", ":corrected: b/a\n", "", "corrected", at=":::{statement} source:1.2")

    def test_figure_that_is_not_there(self):
        self.spoiled("first.claims.h", ":figure: picture", ":figure: pictures", "FIGURE(pictures)",
                     at=":::{statement} source:1.1")

    def test_twice(self):
        self.spoiled("first.claims.h", ":::{statement} source:1.2", ":::{statement} source:1.1\n:zh: 又一", "twice",
                     at=":::{statement} source:1.1\n:zh: 又一")


class BadLinks(Weaving):
    def test_claims_that_do_not_exist(self):
        for old, new in ((":holds-by: sum_is_zero", ":holds-by: sum_is_one"),
                         (":needs: ratio_fails |", ":needs: ratio_holds |"),
                         (":hypothesis: ratio_fails |", ":hypothesis: |"),
                         (":reading: a way", ":reading: no_claim | a way")):
            with self.subTest(new):
                self.spoiled("first.claims.h", old, new, "does not exist", at=":::{statement} source:1.1")

    def test_a_counterexample_decides_nothing_to_be_true(self):
        for key in ("holds-by", "checked-by"):
            with self.subTest(key):
                self.spoiled("first.claims.h", ":holds-by: sum_is_zero", f":{key}: ratio_fails", "counterexample", key,
                             at=":::{statement} source:1.1")
        self.spoiled("first.claims.h", ":corrected-by: sum_is_zero range_is_decided", ":corrected-by: ratio_fails",
                     "counterexample", at=":::{statement} source:1.2")

    def test_only_a_counterexample_refutes(self):
        self.spoiled("first.claims.h", ":refuted-by: ratio_fails", ":refuted-by: range_is_decided", "no counterexample",
                     at=":::{statement} source:1.2")

    def test_what_decides_does_not_confirm(self):
        confirms = ":confirmed-by: range_is_decided"
        for key in "holds-by", "checked-by":
            with self.subTest(key):
                self.spoiled("first.claims.h", ":holds-by: sum_is_zero\n", f":{key}: range_is_decided sum_is_zero\n", "confirmed by 'range_is_decided'",
                             f"in {key} already", at=confirms)
        corrects = ":corrected-by: sum_is_zero range_is_decided\n"
        self.spoiled("first.claims.h", corrects, corrects + ":confirmed-by: every_degree sum_is_zero\n", "confirmed by 'sum_is_zero'",
                     "in corrected-by already", at=":confirmed-by: every_degree")

    def test_a_hypothesis_is_tried(self):
        self.spoiled("first.claims.h", ":hypothesis: ratio_fails | $a:b$ is", ":hypothesis: it is", "no claim tries", "hypothesis")
        self.spoiled("first.claims.h", ":needs: ratio_fails | ", ":needs: ", "does not exist", "'section 1'",
                     at=":::{statement} source:1.1")
        self.spoiled("first.claims.h", ":needs: ratio_fails | section 1 | ", ":needs: ratio_fails | ", "where does the source",
                     at=":needs: ratio_fails | a")

    def test_a_reading_that_fails(self):
        """Of a statement that is decided it is said what is meant, whether it holds, fails, is conditional or a definition."""
        failing = FIRST.replace(":reading: a way to read it", ":reading: ratio_fails | a way to read it")
        unsaid = failing.replace(":meant: the title | what is meant\n", "")
        alone = unsaid.replace(":hypothesis: ratio_fails | a hypothesis that is not\n", "")
        refuted = FIRST.replace(":class: false\n", ":class: false\n:reading: ratio_fails | a way\n")
        defined = alone.replace(":holds-by: sum_is_zero", ":definition: yes")
        undecided = alone.replace(":holds-by: sum_is_zero\n", "")
        for text in failing, undecided:
            self.write("first.claims.h", text)
            self.assertEqual(self.weave().returncode, 0)
        (self.root / "register.c").unlink()
        for text in unsaid, alone, refuted, defined:
            self.write("first.claims.h", text)
            self.refused("first.claims.h", line_of(text, ":reading: ratio_fails"), "which reading is meant")

    def test_what_is_meant_is_no_remark(self):
        """What a statement is read as is said with that by which it is known; a remark alone does not do."""
        unsaid = FIRST.replace(":meant: the title | what is meant\n", "")
        for remark in "Read as a line.", "The index is\nread as 2.", "The first is meant.", "The word is taken to be another.":
            for text, refused in (FIRST, False), (unsaid, True):
                text = text.replace("A remark: with a colon.", remark)
                self.write("first.claims.h", text)
                if refused:
                    self.refused("first.claims.h", line_of(text, ":::{statement} source:1.1"), "is no remark")
                else:
                    self.assertEqual(self.weave().returncode, 0)
                    (self.root / "register.c").unlink()

    def test_claims_that_decide_a_reading_together(self):
        self.write("first.claims.h", FIRST.replace(":reading: a way to read it", ":reading: sum_is_zero | a way to read it\n:reading-with: range_is_decided"))
        self.assertIn('{READING_WITH, "range_is_decided", NULL, "", NULL}', self.register())
        for old, new in ((":reading: a way to read it", ":reading: a way to read it\n:reading-with: range_is_decided"),
                         (":class: false\n", ":class: false\n:reading-with: range_is_decided\n")):
            text = FIRST.replace(old, new)
            self.write("first.claims.h", text)
            self.refused("first.claims.h", line_of(text, ":reading-with:"), "behind a reading")

    def test_words_of_a_reading_agree_with_its_claim(self):
        self.spoiled("first.claims.h", ":reading: a way to read it", ":reading: ratio_fails | one way: true, as always", "derived from its claim")
        self.spoiled("first.claims.h", ":reading: a way to read it", ":reading: sum_is_zero | one way: false, as always", "derived from its claim")
        for word in "true", "false.":
            self.spoiled("first.claims.h", ":reading: a way to read it", f":reading: sum_is_zero | one way: {word}", "is derived")


class BadChapters(Weaving):
    def test_unknown_block(self):
        self.spoiled("first.claims.h", ":::{statement} source:1.2", ":::{statment} source:1.2", "neither")

    def test_section_that_is_not_there(self):
        self.write("index.md", INDEX.replace("second\n", "second\nthird\n"))
        self.refused("third.claims.h", 1, "no such file")

    def test_section_that_the_index_forgets(self):
        self.write("forgotten.claims.h", "/* nothing */\n")
        self.refused("index.md", 1, "forgotten", "toctree")

    def test_an_order_that_is_none(self):
        for order in "0", "first", "-1", "1.5", "":
            with self.subTest(order):
                self.spoiled("index.md", ":degree: p", f":degree: p\n:order: {order}", "whole number", at=":::{letters} chapter")

    def test_no_index(self):
        (self.root / "chapter" / "index.md").unlink()
        self.refused("index.md", 1, "index.md")

    def test_all_complaints_at_once(self):
        self.write("first.claims.h", FIRST.replace(":zh: 标题\n", "").replace(":zh: 另一\n", ""))
        r = self.weave()
        self.assertEqual(len(r.stderr.splitlines()), 2, r.stderr)

    def test_an_old_register_does_not_survive_a_failure(self):
        self.register()
        self.write("first.claims.h", FIRST.replace(":zh: 标题\n", ""))
        self.refused("first.claims.h", line_of(FIRST, ":::{statement} source:1.1"), "zh")

    def test_usage(self):
        r = subprocess.run([WEAVE], capture_output=True, text=True, timeout=60)
        self.assertEqual((r.returncode, r.stdout), (2, ""))
        self.assertIn("usage: weave", r.stderr)

    def test_register_that_cannot_be_written(self):
        (self.root / "register.c").mkdir()
        r = self.weave()
        self.assertEqual(r.returncode, 3)
        self.assertIn("register.c", r.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
