"""cagd check on LaTeX sources: what is read of them, and what is no formula.

    python3 test_latex.py CAGD

Every way to write a formula is tried with a true formula, which has to hold, and with the same changed in one place, which has to
fail; so what was passed over is not taken for what was read.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
LET = "% cagd: let x, y, u, x_i \\in \\mathbb{R}\n% cagd: let B_i^n(t) = \\binom{n}{i} t^i (1-t)^{n-i}\n% cagd: let F(t) = t^2\n"


def check(text, *options):
    return subprocess.run([CAGD, "check", *options, "-"], input=text, capture_output=True, text=True, timeout=120)


def source(body, preamble=""):
    return f"\\documentclass{{article}}\n{preamble}\n\\begin{{document}}\n{LET}{body}\n\\end{{document}}\n"


def statements(text):
    r = check(text, "--json")
    assert r.returncode in (0, 1), r.stderr
    return json.loads(r.stdout)["statements"]


def verdicts(text):
    return {s["name"]: s["verdict"] for s in statements(text)}


# What stands around a formula; @ is the formula, and each has the label a or the name a.
SETTINGS = [
    "\\begin{equation}\\label{a} @ \\end{equation}",
    "\\begin{equation} @ \\label{a}\\end{equation}",
    "\\begin{equation*} @ \\tag{a} \\end{equation*}",
    "\\begin{equation*} % cagd: statement a\n @ \\end{equation*}",
    "\\[ @ % cagd: statement a\n\\]",
    "\\[ @ \\] % cagd: statement a\n\\[ u = u \\] % cagd: statement b",
    "$$ @ % cagd: statement a\n$$",
    "% cagd: statement a\n\\[ @ \\]",
    "% cagd: statement: a\n\n\\begin{displaymath} @ \\end{displaymath}",
    "\\begin{align} @ \\label{a} \\end{align}",
    "\\begin{align} u &= u \\label{b} \\\\ @ \\label{a} \\\\[2pt] x &= x \\end{align}",
    "\\begin{align*} @ \\\\ % cagd: statement a\n u &= u \\end{align*}",
    "\\begin{gather} @ \\label{a} \\\\* u = u \\notag \\end{gather}",
    "\\begin{alignat}{2} @ &\\label{a} \\end{alignat}",
    "\\begin{flalign} && @ && \\label{a} \\end{flalign}",
    "\\begin{eqnarray} @ \\label{a} \\nonumber \\end{eqnarray}",
    "\\begin{multline}\\label{a} @ \\end{multline}",
    "\\begin{IEEEeqnarray}{rCl} u & = & u \\IEEEnonumber \\\\ @ \\IEEEyesnumber\\label{a} \\end{IEEEeqnarray}",
    "\\begin{IEEEeqnarray*}[\\small]{c} @ \\label{a} \\end{IEEEeqnarray*}",
    "\\begin{xalignat}{2} @ &\\label{a} \\end{xalignat}",
    "\\begin{equation}\\label{a}\\begin{split} @ \\end{split}\\end{equation}",
    "\\begin{equation}\\label{a}\\begin{aligned}[t] @ \\end{aligned}\\end{equation}",
    "\\begin{subequations}\n\\begin{equation}\\label{a} @ \\end{equation}\\end{subequations}",
    "\\begin{theorem} It is $x = 1$ and \\verb|\\begin{equation}|: % a remark, 100\\% sure\n\\begin{equation}\\label{a} @ . \\end{equation}\\end{theorem}",
    "\\begin{verbatim}\n\\begin{equation}\\label{b} x = 1 \\end{equation}\n\\end{verbatim}\n\\begin{equation}\\label{a} @ , \\end{equation}",
    "\\begin{equation}\\label{a} @ \\quad;\\end{equation}",
    "\\begin{equation}\\label{a}\n  % a comment with \\end{equation}\n  @\n\\hspace{2em}\\end{equation}",
]
# In a preamble; a true formula, and the same changed in one place.
COMMANDS = [
    ("\\newcommand{\\half}{\\frac12}", "\\half + \\half = 1", "\\half + \\half = 2"),
    ("\\newcommand\\two{2}", "\\two x = x + x", "\\two x = x"),
    ("\\newcommand*{\\B}[2]{B_{#1}^{#2}}", "\\B{1}{2}(t) = 2 t (1-t)", "\\B{1}{2}(t) = t (1-t)"),
    ("\\newcommand{\\B}[2][3]{B_{#2}^{#1}}", "\\B{0}(t) = (1-t)^3", "\\B[2]{0}(t) = (1-t)^3"),
    ("\\newcommand{\\B}[2][3]{B_{#2}^{#1}}", "\\B[2]{0}(t) = (1-t)^2", "\\B{0}(t) = (1-t)^2"),
    ("\\renewcommand{\\vec}[1]{#1}", "\\vec x + \\vec{y} = y + x", "\\vec x + \\vec{y} = y"),
    ("\\def\\sq#1{{#1}^2}", "\\sq x = x x", "\\sq x = x"),
    ("\\def\\add#1#2{(#1+#2)}", "\\add xy \\add{x}{y} = x^2 + 2 x y + y^2", "\\add xy \\add{x}{y} = x^2 + x y + y^2"),
    ("\\newcommand{\\a}{\\b x}\\newcommand{\\b}{3}", "\\a = 3 x", "\\a = 2 x"),
    ("\\newcommand{\\vx}{\\mathbf#1}\\renewcommand{\\vx}[1]{\\hat#1}", "\\hat{x} = \\vx x", "\\hat{x} = 2 \\vx x"),
    ("\\DeclareMathOperator{\\sq}{sq}", "\\sq(x) = x^2", "\\sq(x) = x"),
    ("\\DeclarePairedDelimiter{\\abs}{\\lvert}{\\rvert}", "\\abs{x}^2 = \\abs*{x} \\cdot \\abs[\\big]{x}", "\\abs{x}^2 = \\abs{x}"),
    ("\\NewDocumentCommand{\\pr}{m m}{#1 #2}", "\\pr{x}{y} = y x", "\\pr{x}{y} = y"),
    ("\\let\\al=\\lambda\n\\let\\R\\mathbb", "\\al - \\al = 0", "\\al - 2 \\al = 0"),
    ("\\providecommand{\\k}{1}\\providecommand{\\k}{2}", "\\k = 1", "\\k = 2"),
    ("\\newcommand{\\lx}{\\lambda x}", "\\frac\\lx2 = \\lambda x / 2", "\\frac\\lx2 = 2 \\lambda / x"),
    ("\\newcommand{\\lx}{\\lambda x}", "\\frac{\\dfrac\\lx2}\\lx \\lx = \\lambda x / 2 \\text{ for } \\lx > 0", "\\dfrac % two\n\\lx\\lx \\lx = \\lambda^2 \\text{ for } \\lx > 0"),
    ("\\newcommand{\\N}{12}", "\\frac\\N 3 + \\frac1\\N = \\frac{49}\\N", "\\frac\\N 3 = \\frac{2}{3}"),
    ("\\newcommand{\\N}{12}", "\\binom\\N2 = 66", "\\binom\\N2 = 0"),
    ("\\let\\f\\frac\\newcommand{\\lx}{\\lambda x}\\newcommand{\\g}{\\f\\lx}", "\\f\\lx2 + \\g2 = \\lambda x", "\\g2 = 2 \\lambda / x"),
    ("\\newcommand{\\q}[2]{\\frac#1#2}\\newcommand{\\lx}[1][\\lambda]{#1 x}", "\\q\\lx2 = \\lambda x / 2", "\\q\\lx2 = 2 \\lambda / x"),
    ("\\newcommand{\\N}{27}", "\\sqrt[3]\\N = 3", "\\sqrt[3]\\N = 2"),
    ("\\newcommand{\\lx}{x + \\lambda}", "\\underbrace\\lx_{u} y = x y + \\lambda y", "\\underbrace\\lx_{u} y = x + \\lambda y"),
    ("\\newcommand{\\D}{\\mathrm{d}}", "\\int_0^1 t^2 \\D t = \\frac13", "\\int_0^1 t^2 \\D t = \\frac12"),
]
# Formulas: true, and changed in one place.
FORMULAS = [
    ("F(x) &= x^2 \\\\ &= x x", "F(x) &= x^2 \\\\ &= x"),
    ("F(x) = \\begin{cases} x^2 & x > 0, \\\\ x^2 & \\text{otherwise} \\end{cases}", "F(x) = \\begin{cases} x^2 & x > 0, \\\\ x & \\text{otherwise} \\end{cases}"),
    ("\\left( x + y \\right)^2 - \\bigl[ x^2 + y^2 \\bigr] = 2 x y", "\\left( x + y \\right)^2 - \\bigl[ x^2 + y^2 \\bigr] = x y"),
    ("x +{}\\mathstrut\\phantom{y} x = 2 x", "x + \\phantom{y} x + y = 2 x"),
    ("\\begin{vmatrix} x & y \\\\ u & 1 \\end{vmatrix} = x - u y", "\\begin{vmatrix} x & y \\\\ u & 1 \\end{vmatrix} = x + u y"),
    ("x = x, \\quad y + y = 2 y", "x = x, \\quad |y| = y"),
    ("|x_1|^2 = x_1^2", "|x_1|^2 = x_1"),
]
# What is no formula, or no source: the body, the line and column, and the beginning of what is told.
MISTAKES = [
    ("\\begin{equation}\\label{a} x = 1 % cagd: for n = 1\n", "7:1", "this environment does not end"),
    ("text \\[ x = 1", "7:6", "this formula does not end: expected \\]"),
    ("$$ x = 1", "7:1", "this formula does not end: expected $$"),
    ("\\newcommand\\pair[2]{#1$ #2}\\pair$r", "7:28", "this formula does not end: expected $$"),
    ("% cagd: for n = 1..2\nText, and no formula.", "7:9", "no formula follows"),
    ("% cagd: for n = 1..2", "7:9", "no formula follows"),
    ("\\[ x = x % cagd: fro n = 1..2\n\\]", "7:18", "expected let, definition"),
    ("\\[ x = x % cagd:\n\\]", None, "expected let, definition"),
    ("\\[ x = x \\foo % cagd: statement a\n\\]", "7:10", ""),
    ("\\[ x = z % cagd: statement a\n\\]", "7:8", "z is not defined"),
    ("\\[ x = \n  z % cagd: statement a\n\\]", "8:3", "z is not defined"),
    ("\\[ x = x % cagd: for n = 1..\\foo\n\\]", "7:29", ""),
    ("\\[ x = x % cagd: expected true\n\\]", "7:27", "expected holds, fails or undecided"),
    ("\\[ x = x % cagd: seconds many\n\\]", "7:26", "expected the seconds"),
    ("\\[ x = x % cagd: find 2\n\\]", "7:23", ""),
    ("% cagd: let z", "7:14", "expected '='"),
    ("% cagd: let x = \\frac{1", None, ""),
    ("\\newcommand{\\w}[1]{#1 + z}\\[ x = \\w{y} % cagd: statement a\n\\]", "7:34", "z is not defined"),
    ("\\newcommand{\\w}[1]{#1 + x}\\[ x = \\w{z} % cagd: statement a\n\\]", "7:37", "z is not defined"),
    ("\\newcommand{\\w}{\\w x}\\[ x = \\w % cagd: statement a\n\\]", "7:29", "the expansion of this command does not end"),
    ("\\newcommand{\\w}{\\v\\v}\\newcommand{\\v}{\\w\\w}\\[ x = \\w % cagd: statement a\n\\]", None, "the expansion of this command does not end"),
    ("\\newcommand{\\w}[1]{#1#1}\\[ x = \\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{\\w{x}}}}}}}}}}}}}}}}}} % cagd: statement a\n\\]", None, ""),
    ("\\newcommand{\\w}[1]{#1^2}\\[ x = \\frac\\w{x}2 % cagd: statement a\n\\]", "7:37", "as an argument this command gets none of its own"),
    ("text \\iffalse \\[ x = 1 \\]", "7:6", "this \\iffalse does not end"),
    ("\\iffalse a \\else \\[ x = 1 \\]", "7:12", "this \\else does not end"),
    ("\\newcommand{\\w}[2]{#1#2}\\[ x = \\w % cagd: statement a\n\\]", None, ""),
    ("\\begin{align} x &= x \\end{align}\n% cagd: statement a\n \\[ \\]", "8:9", "no formula follows"),
    ("\\[ \\] % cagd: statement a", "7:15", "no formula follows"),
    ("\\[ % cagd: statement a\n \\]", "7:12", "the row that this is said of has no formula"),
    ("\\[ \\begin{foo} x \\end{foo} = x % cagd: statement a\n\\]", None, ""),
    ("% cagd: for n = 1\n" * 17 + "\\[ x = x \\]", "23:9", "more than 16 comments for one formula"),
    ("\\[ x = x % cagd: statement a\n" + "% cagd: for n = 1\n" * 17 + "\\]", "23:9", "more than 16 comments for one formula"),
]


class Reading(unittest.TestCase):
    def test_cases_with_numbers_of_their_own(self):
        """The left side stands once, and behind & is text with formulas in it."""
        for second, expected in (("-x", "holds"), ("x", "fails")):
            for name in ("numcases", "subnumcases"):
                body = f"\\begin{{{name}}}{{|x| =}} x, & if $x \\ge 0$, \\label{{a}} \\\\ {second} & otherwise. \\label{{b}} \\end{{{name}}}"
                self.assertEqual(verdicts(source(body)), {"a": expected})
            self.assertEqual(verdicts(source(f"\\begin{{numcases}}{{|x| =}} x & for $x \\ge 0$ \\\\ {second} & $x < 0$ \\label{{b}} \\end{{numcases}}")), {"b": expected})

    def test_commands_in_comments(self):
        """The commands of the author stand for the same there, before the document begins, too."""
        preamble = "\\newcommand{\\R}{\\mathbb{R}}\n\\let\\eps\\varepsilon\n\\newcommand{\\vc}[1]{\n\\mathbf{#1}}\n% cagd: let \\eps, z \\in \\R\n% cagd: let \\vc{a} \\in \\R^2 % two\n\\newcommand{\\unit}{0 \\le z \\le 1}"
        formula = "\\begin{equation}\\label{a} \\eps + z \\le \\eps + 1, \\quad \\vc a + \\vc{a} = 2 \\vc a % cagd: for \\unit\n\\end{equation}"
        self.assertEqual(verdicts(source(formula, preamble)), {"a": "holds"})
        self.assertEqual(verdicts(source(formula.replace("\\eps + 1", "\\eps"), preamble)), {"a": "fails"})

    def test_what_is_not_followed_is_told(self):
        formula = "\\begin{equation}\\label{a} x + y = y + x \\end{equation}"
        r = check(source(formula, "\\input{macros}\n\\include{one}"))
        self.assertEqual(r.returncode, 0)
        self.assertEqual([line.split(": ", 2)[1:] for line in r.stderr.splitlines() if line.startswith("cagd:")],
                         [["standard input:2:1", "this file is not read: its commands and formulas are not known here"], ["standard input:3:1", "this file is not read: its commands and formulas are not known here"]])
        r = check(source(formula + "\n\\begin{empheq}{align} x = y \\label{b} \\end{empheq}"))
        self.assertEqual(r.returncode, 0)
        self.assertIn("standard input:8:1: formulas in this environment are not read", r.stderr)

    def test_settings(self):
        for setting in SETTINGS:
            for formula, expected in (("x + x = 2 x", "holds"), ("x + x = 3 x", "fails")):
                with self.subTest(setting=setting, formula=formula):
                    self.assertEqual(verdicts(source(setting.replace("@", formula)))["a"], expected)

    def test_commands(self):
        let = "% cagd: let \\hat x, \\lambda \\in \\mathbb{R}\n% cagd: let \\operatorname{sq}(t) = t^2\n"
        for preamble, true, false in COMMANDS:
            for formula, expected in ((true, "holds"), (false, "fails")):
                for before, behind in ((preamble, ""), ("", preamble + "\n")):
                    with self.subTest(preamble=preamble, formula=formula):
                        text = source(f"{let}{behind}\\begin{{equation}}\\label{{a}} {formula}. \\end{{equation}}", before)
                        self.assertEqual(verdicts(text), {"a": expected})

    def test_formulas(self):
        for true, false in FORMULAS:
            for formula, expected in ((true, "holds"), (false, "fails")):
                with self.subTest(formula=formula):
                    self.assertEqual(verdicts(source(f"\\begin{{align}}\\label{{a}} {formula} \\end{{align}}"))["a"], expected)

    def test_a_command_may_be_an_environment(self):
        preamble = "\\newcommand{\\be}{\\begin{equation}}\\newcommand\\ee{\\end{equation}}"
        self.assertEqual(verdicts(source("\\be\\label{a} x + x = 2 x\\ee and \\be x = 1 \\ee", preamble)), {"a": "holds"})

    def test_rows_are_formulas_unless_they_go_on(self):
        text = source("\\begin{align} x &= x \\label{a} \\\\ F(x) &= x^2 \\label{b} \\\\ &= x \\\\ y &\\le y \\\\ u &= 2 u \\label{c} \\end{align}")
        self.assertEqual(verdicts(text), {"a": "holds", "b": "fails", "c": "fails"})
        text = source("\\begin{multline}\\label{a} x + x \\\\ + x \\\\ = 3 x \\end{multline}")
        self.assertEqual(verdicts(text), {"a": "holds"})

    def test_comments_belong_to_their_rows(self):
        text = source("\\begin{align} \\sum_{i=0}^n B_i^n(t) &= 1 \\label{a} \\\\ % cagd: for n = 1..3\n"
                      "  % cagd: for n = 2..4\n  % cagd: expected fails\n  \\sum_{i=1}^n B_i^n(t) &= 1 \\label{b} \\end{align}")
        s = statements(text)
        self.assertEqual([(x["name"], x["verdict"], x["cases"]) for x in s], [("a", "holds", 3), ("b", "fails", 3)])
        self.assertEqual(check(text).returncode, 0)

    def test_comments_in_front_belong_to_all_rows(self):
        s = statements(source("% cagd: for n = 1..3\n% cagd: for i = 0..n\n\\begin{align} B_i^n(t) &= B_{n-i}^n(1-t) \\label{a} \\\\ "
                              "n &= i \\label{b} \\end{align}"))
        self.assertEqual([(x["name"], x["cases"]) for x in s], [("a", 9), ("b", 9)])

    def test_definitions(self):
        for definition in ("\\begin{equation}\\label{d} G(t) = 3 t % cagd: definition\n\\end{equation}", "\\[ G(t) := 3 t \\]", "\\[ G(t) \\coloneqq 3 t. \\]",
                           "\\[ G(t) \\overset{\\text{def}}{=} 3 t \\]", "% cagd: let G(t) = 3 t"):
            with self.subTest(definition=definition):
                for value, expected in ((3, "holds"), (2, "fails")):
                    text = source(f"{definition}\n\\begin{{equation}}\\label{{a}} G(x) = {value} x \\end{{equation}}")
                    self.assertEqual(verdicts(text), {"a": expected})

    def test_definitions_as_papers_print_them(self):
        """With the range of an index or a dotted sum behind the sign of equality, and several in one brace."""
        body = r"""
\begin{equation}\label{b} b_i^n(t) = \binom{n}{i} t^i (1-t)^{n-i}, \qquad i = 0,1,\dots,n, \end{equation} % cagd: definition
\begin{equation}\label{s} S_n(t) = 1 + t + \cdots + t^n \end{equation} % cagd: definition
\begin{equation}\label{c} \left\{ \begin{aligned} c_0(t) &= 1 - t, \ c_1(t) &= t. \end{aligned} \right. \end{equation} % cagd: definition
\begin{equation}\label{one} \sum_{i=0}^n b_i^n(t) = @ \end{equation} % cagd: for n = 1..
\begin{equation}\label{two} (1-u) S_n(u) = @ - u^{n+1} \end{equation} % cagd: for n = 0..4
\begin{equation}\label{three} c_0(u) + c_1(u) = @ \end{equation}
"""
        for value, expected in (("1", "holds"), ("2", "fails")):
            self.assertEqual(verdicts(source("% cagd: let t \in \mathbb{R}\n" + body.replace("@", value))), dict.fromkeys(("one", "two", "three"), expected))

    def test_rows_of_a_formula_are_its_rows(self):
        """Conditions and arrows reach over their own row, as in Markdown; and a row that begins with a sign is one."""
        inner = {"a": r"\begin{aligned} B_i^n(0) &= 0, \\ B_i^n(1) &= 0 \quad \text{for } 0 < i < n \end{aligned} % cagd: for n = 1..3, i = 0..n",
                 "b": r"\begin{gathered} x \ge 2 \Rightarrow x^2 \ge 4, \\ x^3+x \ge 0 \end{gathered}", "c": r"\begin{gathered} x = 1 \\ x = 1 \iff x-1 = 0 \end{gathered}",
                 "d": r"\begin{aligned} x^2 \ge 1 \\ x^3 \ge 1 \quad \text{for } x \ge 1 \end{aligned}", "e": r"\begin{split} (x+1)^2 &= x^2+2x+1 \\ x &\ge 0 \end{split}",
                 "f": r"\left\{\begin{array}{ll} F(x) \ge 1 \\ F(x) \ge 0, & x \ge 1 \end{array}\right.", "g": r"\begin{split} (x+1)^2 &= x^2+2x+1 \\ &= (1+x)^2 \end{split}",
                 "h": r"\begin{aligned}[t] (x+1)^2 &= x^2 \\ &\quad + 2x + 1 \end{aligned}"}
        found = verdicts(source("\n".join(f"\\begin{{equation}}\\label{{{name}}} {text}\n\\end{{equation}}" for name, text in inner.items())))
        self.assertEqual({name for name in inner if found[name] == "holds"}, {"g", "h"})
        self.assertEqual((found["a"], found["c"], found["d"]), ("fails", "fails", "fails"))
        body = r"""\begin{align} 0 &= x \label{a} \\ -x &= 0 \label{b} \end{align}
\begin{align} 1 &= (1-x) + x \label{c} \\ -1 &= (x-1) - x \label{d} \end{align}
\begin{align} F(x) &= x^2 \label{e} \\ -x &\le |x| \label{f} \end{align}
\begin{align} (x+1)^2 &= x^2 \label{g} \\ &\quad + 2 x \\ &\quad +1 \end{align}
\begin{align} (x+1)^2 &= x^2+2x+1 \label{h} \\ &= (1+x)^2 \label{i} \end{align}"""
        r = check(source(body), "--json")
        self.assertIn("this row goes on with the formula before it: its label names none", r.stderr)
        found = {s["name"]: s["verdict"] for s in json.loads(r.stdout)["statements"]}
        self.assertEqual(found, {**dict.fromkeys("ab", "fails"), **dict.fromkeys("cdefgh", "holds")})

    def test_formulas_without_a_label_are_counted(self):
        text = source("\\begin{equation}\\label{a} x = x \\end{equation}\n\\[ 1 = 2 \\]\n\\begin{align} x &= 1 \\\\ u &= u \\label{b} \\end{align}\n\\begin{equation} x = 3 \\end{equation} % cagd: skip")
        self.assertIn("Not read, for they have no label: 2 displayed formulas", check(text).stdout)
        self.assertEqual(json.loads(check(text, "--json").stdout)["without_label"], 2)
        self.assertNotIn("Not read", check(source("\\begin{equation}\\label{a} x = x \\end{equation}")).stdout)

    def test_one_formula_without_a_label_is_one(self):
        text = source("\\begin{equation}\\label{a} x = x \\end{equation}\n\\[ 1 = 2 \\]")
        self.assertIn("Not read, for they have no label: 1 displayed formula\n", check(text).stdout)
        text = source("".join(f"\\begin{{equation}}\\label{{{name}}} \\Psi = x \\end{{equation}}" for name in "ab") + "\\begin{equation}\\label{c} x = x \\end{equation}")
        self.assertIn("Left out, for they could not be read: 2 labelled formulas\n", check(text).stdout)

    def test_a_word_of_a_comment_is_a_whole_word(self):
        """format, finds and skipped are none of the words that comments begin with, though for, find and skip are; a colon may stand behind each."""
        for word in ("format n = 1", "finds x", "skipped", "expectedly holds", "secondsx 3", "statements a", "definitions", "titled", "sources", "withouts", "letter x"):
            with self.subTest(word=word):
                r = check(source(f"\\[ x = x % cagd: {word}\n\\]"))
                self.assertEqual((r.returncode, r.stdout), (2, ""))
                self.assertIn("expected let, definition", r.stderr)
        for colon in ("", ":"):
            text = source(f"\\[ n x = x n % cagd: statement{colon} a\n% cagd: for{colon} n = 1..2\n% cagd: for{colon} m = 1..2\n% cagd: expected{colon} holds\n% cagd: seconds{colon} 5\n% cagd: title{colon} one\n% cagd: source{colon} two\n\\]")
            s = statements(text)
            self.assertEqual([(x["name"], x["verdict"], x["cases"], x["expected"]) for x in s], [("a", "holds", 2, "holds")])

    def test_what_is_switched_off_is_not_there(self):
        found = verdicts(source("\\newcommand{\\k}{2}\\iffalse\\renewcommand{\\k}{3}\\ifx a b \\fi \\begin{equation}\\label{z} 1 = 2 \\end{equation}\\fi\n\\begin{equation}\\label{a} \\k = 2 \\end{equation}"))
        self.assertEqual(found, {"a": "holds"})

    def test_what_stands_behind_else_is_there(self):
        equation = lambda name: f"\\begin{{equation}}\\label{{{name}}} 1 = 2 \\end{{equation}}\n"
        for body, names in (("\\iffalse @a\\else @b\\fi @c", "bc"), ("\\iffalse @a\\fi @c", "c"), ("\\iffalse \\begin{equation} x = 1 \\iff x = 1 \\end{equation}\\fi @c", "c"),
                            ("\\iffalse \\ifx a b @z\\else \\fi @a\\else @b\\fi @c", "bc"), ("\\iffalse @a\\else @b\\iffalse @d\\else @e\\fi @f\\fi @c", "befc"),
                            ("\\iffalse % \\fi \\else\n@a\\fi @c", "c"), ("\\iffalse \\ifthenelse{a}{b}{c} @a\\fi @c", "c")):
            with self.subTest(body=body):
                text = "".join(equation(piece[0]) + piece[1:] if k > 0 else piece for k, piece in enumerate(body.split("@")))
                self.assertEqual(verdicts(source(text)), {name: "fails" for name in names})
        self.assertEqual(verdicts(source("\\begin{equation}\\label{a} x \\iffalse + 1 \\else + 2 \\fi = x + 2 \\end{equation}")), {"a": "holds"})

    def test_a_system_in_an_array(self):
        """As it was printed before amsmath: rows of definitions in a brace, and ranges behind formulas."""
        body = r"""
\begin{equation}\label{d}
\left\{\begin{array}{l}
b_0(t) = (1-t)^2, \\
b_1(t) = 2t(1-t), \\[2pt]
b_2(t) = t^2
\end{array}\right.
% cagd: definition
\end{equation}
\begin{align} b_i(t) &= b_{2-i}(1-t), \quad i=0,1,2, \label{one} \\ b_i(t) &\geqslant @, \quad i=0,1,2, \ t \in [0,1] \label{two} \end{align}
\begin{equation}\label{three} \left[\begin{array}{cc} 1 & t \end{array}\right] \left[\begin{array}{c} t \\ 1 \end{array}\right] = 2 t \end{equation}
"""
        for value, expected in (("0", "holds"), ("\\dfrac12", "fails")):
            self.assertEqual(verdicts(source("% cagd: let t \\in \\mathbb{R}\n" + body.replace("@", value))), {"one": "holds", "two": expected, "three": "holds"})

    def test_rows_in_a_brace(self):
        for begin, end in (("\\left\\{\\begin{aligned}", "\\end{aligned}\\right."), ("\\left\\{ \\begin{aligned}", "\\end{aligned} \\right."), ("\\left\\{\n\\begin{split}", "\\end{split}\n\\right."),
                           ("\\left\\{ \\begin{gathered}", "\\end{gathered}\\right.")):
            for factor, expected in ((2, "holds"), (3, "fails")):
                body = f"\\begin{{equation}}\\label{{a}}\n{begin} x + x = {factor} x, \\\\ y + y = 2 y {end}\n\\end{{equation}}"
                with self.subTest(body=body):
                    self.assertEqual(verdicts(source(body)), {"a": expected})

    def test_rows_without_a_comma_are_formulas_unless_they_go_on(self):
        """Of an inner environment: a row that begins at the place of the relation, or with a sign, goes on."""
        for rows, expected in (("F(u) &= u^2 \\\\ F(2) &= @", {"4": "holds", "5": "fails"}), ("&F(u) = u^2 \\\\[1mm] &F(2) = @", {"4": "holds", "5": "fails"}), ("F(u) &= u^2 \\\\ &= u \\cdot u + @ - 4 \\\\ F(1) &= 1", {"4": "holds", "5": "fails"}),
                               ("(u + 2)^2 = {}& u^2 \\\\ & + @ u \\\\ & {} + 4", {"4": "holds", "5": "fails"}), ("(u + 2)^2 &= u^2 + \\\\ &\\quad @ u + 4", {"4": "holds", "5": "fails"}), ("(u + 2)^2 =& u^2 + @ \\cdot \\\\ & u + 4", {"4": "holds", "5": "fails"}),
                               ("F(u) &= \\begin{cases} u^2 & u \\ge 0 \\\\ u^2 & u < 0 \\end{cases} \\\\ F(2) &= @", {"4": "holds", "5": "fails"}), ("u F(2) &= @ u \\\\ u F(1) &= u", {"4": "holds", "5": "fails"})):
            for name in ("aligned", "split"):
                for value, verdict in expected.items():
                    body = f"\\begin{{equation}}\\label{{a}}\n\\begin{{{name}}}\n{rows.replace('@', value)}\n\\end{{{name}}}\n\\end{{equation}}"
                    with self.subTest(body=body):
                        self.assertEqual(verdicts(source(body)), {"a": verdict})

    def test_definitions_below_one_another(self):
        """In a brace of every kind, the second for a list of indices, and the recursion of B-splines without a comma between."""
        rows = "c_{0,m}(t) = (1-t)^m,\\\\[2mm]\nc_{i,m}(t) = \\binom{m}{i} t^i (1-t)^{m-i}, \\quad i = 1, 2, \\ldots, m-1,\\\\\nc_{m,m}(t) = t^m."
        for begin, end in (("\\left\\{\\begin{array}{l}", "\\end{array}\\right."), ("\\begin{cases}", "\\end{cases}"), ("\\left\\{\\begin{aligned}", "\\end{aligned}\\right."), ("\\begin{gathered}", "\\end{gathered}")):
            for last, expected in (("t^m", "holds"), ("t^m + t", "fails")):
                body = f"% cagd: let t \\in \\mathbb{{R}}\n\\begin{{equation}}% cagd: definition\n{begin}\n{rows.replace('t^m.', last + '.')}\n{end}\n\\end{{equation}}\n\\begin{{equation}}\\label{{a}}% cagd: for n = 2..4\n\\sum_{{i=0}}^n c_{{i,n}}(t) = 1 \\end{{equation}}"
                with self.subTest(body=body):
                    self.assertEqual(verdicts(source(body)), {"a": expected})
        body = "% cagd: let v_i \\le v_{i+1}\n% cagd: let 0/0 = 0\n\\begin{equation}% cagd: definition\n\\begin{aligned}\nN_{i,0}(t) &= \\begin{cases} 1, & \\text{if $v_i \\le t < v_{i+1}$,}\\\\ 0, & \\text{otherwise.} \\end{cases}\\\\\nN_{i,p}(t) &= \\frac{t-v_i}{v_{i+p}-v_i} N_{i,p-1}(t)\\\\\n&\\quad + \\frac{v_{i+p+1}-t}{v_{i+p+1}-v_{i+1}} N_{i+1,p-1}(t)\n\\end{aligned}\n\\end{equation}\n\\begin{equation}\\label{a} N_{0,1}(u) @ \\end{equation}"
        self.assertEqual([verdicts(source(body.replace("@", said))) for said in ("\\ge 0", "> 0")], [{"a": "holds"}, {"a": "fails"}])

    def test_what_is_skipped(self):
        self.assertEqual(verdicts(source("\\begin{equation}\\label{a} x = x\\end{equation}\\begin{equation}\\label{b} x = 1 % cagd: skip\n\\end{equation}")),
                         {"a": "holds"})
        self.assertEqual(verdicts(source("\\begin{equation}\\label{a} x = x\\end{equation}\n\\end{document}\n\\begin{equation}\\label{b} x = 1 \\end{equation}")),
                         {"a": "holds"})

    def test_find(self):
        s = statements(source("\\[ t \\le x \\le t + 1 % cagd: find x\n % cagd: for 0 \\le t \\le 1\n\\]"))
        self.assertEqual((s[0]["name"], s[0]["values"]), ("line-7", "x = 1"))


class Mistakes(unittest.TestCase):
    def test_every_mistake_is_named_where_it_is(self):
        """latex-mistakes.txt has the whole line that is told of each, and the part of the source that is marked."""
        told = (HERE / "latex-mistakes.txt").read_text().splitlines()
        for (body, place, message), line in zip(MISTAKES, told, strict=True):
            with self.subTest(body=body):
                r = check(source(body).replace("\n\\end{document}", "") if "not end" in message else source(body))
                self.assertEqual((r.returncode, r.stdout), (2, ""), r.stderr)
                lines = r.stderr.splitlines()
                self.assertTrue(lines[0].startswith(f"cagd: standard input:{place or ''}"), lines[0])
                self.assertIn(message, lines[0])
                if place is not None and len(lines) > 2:
                    self.assertEqual(lines[2].index("^") - 2, int(place.split(":")[1]) - 1)
                marks = lines[2] if len(lines) > 2 and lines[2].strip().startswith("^") else ""
                self.assertEqual(lines[0].replace("cagd: standard input:", "") + "\t" + (lines[1][marks.index("^"):len(marks)] if marks else ""), line)

    def test_commands_of_the_author_in_comments(self):
        text = source("\\newcommand{\\Reals}{\\mathbb{R}}\\newcommand{\\bern}[2]{\\beta_{#1}^{#2}}\n% cagd: let z_i \\in \\Reals^2\n% cagd: let \\bern{i}{n}(t) = \\binom{n}{i} t^i (1-t)^{n-i}\n"
                      "\\begin{equation}\\label{a} \\sum_{i=0}^n \\bern{i}{n}(x) (z_i - z_i) = \\mathbf{0} % cagd: for n = 1..3\n\\end{equation}")
        self.assertEqual([s["verdict"] for s in statements(text)], ["holds"])

    def test_what_nobody_asked_for_is_left_out_and_told(self):
        text = source("\\begin{equation}\\label{a} x = x \\end{equation}\n\\begin{equation}\\label{b} \\Psi = x \\end{equation}")
        r = check(text, "--json")
        j = json.loads(r.stdout)
        self.assertEqual(r.returncode, 1)
        self.assertEqual([(x["name"], x["line"], x["column"]) for x in j["left_out"]], [("b", 8, 27)])
        self.assertIn("b is left out: \\Psi is not defined", r.stderr)
        self.assertIn("Left out, for they could not be read: 1 labelled formula\n    b  (standard input:8)", check(text).stdout)

    def test_a_source_without_formulas(self):
        for text in (source("Text."), source("\\[ x = x \\]")):
            r = check(text)
            self.assertEqual(r.returncode, 2)

    def test_what_is_large_gets_few_lines(self):
        for body in ("\\newcommand{\\w}[1]{#1}\\[" + "\\w{" * 10**5, "{" * 10**6, "\\[" * 10**5, "\\begin{align}" * 10**4 + "\\\\" * 10**5,
                     "\\newcommand{\\a}{" + "x" * 10**5 + "}\\[" + "\\a" * 1000 + "\\]", "\\def" * 10**5, "%" * 10**6, "\\begin{split}" * 10**5,
                     "\\newcommand{\\x}{\\x\\x}" + "\\x " * 10**5, "\\newcommand{\\b}{}\\newcommand{\\a}{" + "\\b" * 4000 + "}" + "\\a " * 10**5, "\\newcommand{\\1}{}" + "\\1a" * 10**5,
                     "\\begin{align}" + "\\\\[" * 10**5 + "\\end{align}", "\\[" + "\\tag{" * 10**5 + "\\]", "\\def\\x" * 10**5, "\\[a=b\\]% cagd: for n = 1\n" * 2 * 10**4):
            r = check(source(body))
            self.assertEqual((r.returncode, r.stdout), (2, ""), body[:30])
            self.assertLess(len(r.stderr), 12000, body[:30])


class FromPaper(unittest.TestCase):
    """A file of formulas that takes them from a source."""

    def run_beside(self, markdown, paper):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "paper.tex").write_text(paper)
            (pathlib.Path(folder) / "notes.md").write_text(markdown)
            return subprocess.run([CAGD, "check", "--json", pathlib.Path(folder) / "notes.md"], capture_output=True, text=True, timeout=60)

    PAPER = ("\\newcommand{\\G}{G}\n\\begin{equation}\\label{eq:g} \\G(t) = 3 t, \\end{equation}\n"
             "\\begin{equation}\\label{eq:a} \\G(x) = 3 x. \\end{equation}\n\\begin{equation}\\label{eq:b} \\G(x) = z \\end{equation}\n")

    def test_definitions_and_statements(self):
        r = self.run_beside(":::{let}\n:from: paper.tex eq:g\nx \\in \\mathbb{R}\n:::\n:::{statement} s\n:from: paper.tex eq:a\n:::\n", self.PAPER)
        s = json.loads(r.stdout)["statements"]
        self.assertEqual((r.returncode, s[0]["verdict"], s[0]["printed_tex"], s[0]["line"]), (0, "holds", "G(x) = 3 x", 5))

    def test_papers_of_either_name_and_place(self):
        """NAME.ltx is a source, too; a path from the root is no path beside the document; of the labels that there are the first three are named, wherever they stand."""
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as other:
            paper = source("\\begin{equation}\\label{a} x + x = 2 x \\end{equation}")
            (pathlib.Path(folder) / "paper.ltx").write_text(paper)
            r = subprocess.run([CAGD, "check", "--json", pathlib.Path(folder) / "paper.ltx"], capture_output=True, text=True, timeout=60)
            self.assertEqual([(s["name"], s["verdict"]) for s in json.loads(r.stdout)["statements"]], [("a", "holds")])
            (pathlib.Path(other) / "paper.tex").write_text("\\[ 1 = 1 \\]" * 4 + "".join(f"\\begin{{equation}}\\label{{l{k}}} 1 + {k} = {k} + 1 \\end{{equation}}" for k in range(4)))
            for label, expected in (("l0", "holds"), ("l3", "holds"), ("l4", None)):
                (pathlib.Path(folder) / "notes.md").write_text(f":::{{statement}} s\n:from: {other}/paper.tex {label}\n:::\n:::{{statement}} t\n:from: {other}/paper.tex l1\n:::\n")
                r = subprocess.run([CAGD, "check", "--json", pathlib.Path(folder) / "notes.md"], capture_output=True, text=True, timeout=60)
                if expected is not None:
                    self.assertEqual([s["verdict"] for s in json.loads(r.stdout)["statements"]], [expected] * 2)
                else:
                    self.assertIn("it has l0, l1, l2\n", r.stderr)

    def test_mistakes_are_named_in_the_paper(self):
        let = ":::{let}\n:from: paper.tex eq:g\nx \\in \\mathbb{R}\n:::\n"
        for line, place, words in ((":from: paper.tex eq:b", "paper.tex:4:38", "z is not defined"), (":from: paper.tex eq:c", "notes.md:6:18", "it has eq:g, eq:a, eq:b"),
                                   (":from: other.tex eq:c", "notes.md:6:8", "not read"), (":from: paper.tex", "notes.md:6:8", "expected a LaTeX source"),
                                   (":from: notes.md x", "notes.md:6:8", "expected a LaTeX source")):
            with self.subTest(line=line):
                r = self.run_beside(f"{let}:::{{statement}} s\n{line}\n:::\n", self.PAPER)
                self.assertEqual((r.returncode, r.stdout), (2, ""))
                self.assertIn(place, r.stderr)
                self.assertIn(words, r.stderr)

    def test_what_an_entry_has_as_printed_is_in_no_paper(self):
        """:from: and :printed: say what the formula of a statement or an equation is; that of an entry is what the ledger has."""
        let = ":::{let}\n:from: paper.tex eq:g\nx \\in \\mathbb{R}\n:::\n"
        for kind, is_refused in (("statement", False), ("equation", False), ("printed", True)):
            for line in (":from: paper.tex eq:a", ":printed: x = x"):
                with self.subTest(kind=kind, line=line):
                    r = self.run_beside(f"{let}:::{{{kind}}} deng-zhang-2022:property-2.2\n{line}\n:::\n", self.PAPER)
                    self.assertEqual(r.returncode == 2, is_refused, r.stderr)
                    self.assertEqual("notes.md:6:1: expected :printed:, :from:" in r.stderr, is_refused, r.stderr)


class Counts(unittest.TestCase):
    def test_there_are_sixty_cases(self):
        self.assertGreaterEqual(len(SETTINGS) + len(COMMANDS) + len(FORMULAS) + len(MISTAKES), 60)


if __name__ == "__main__":
    unittest.main(verbosity=1)
