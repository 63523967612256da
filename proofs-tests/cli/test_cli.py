"""The command as its users meet it: exit codes, formats, one clear line for every mistake.

    python3 test_cli.py CAGD ROOT WHOLE_RUN REGISTER.json

WHOLE_RUN is the folder that whole_run.py wrote: a run over everything.
"""
import collections
import functools
import json
import os
import pathlib
import pty
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

import figure_words  # beside this file

REGISTER_FILE = sys.argv.pop(4)
WHOLE_RUN = pathlib.Path(sys.argv.pop(3)).resolve()
ROOT = pathlib.Path(sys.argv.pop(2)).resolve()
sys.path.insert(0, str(ROOT / "proofs-tests/scripts"))
from register import claims_of, load  # noqa: E402

REGISTER = load(REGISTER_FILE)
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())

VERDICTS = {"holds", "conditional", "fails", "undecided", "open", "definition"}
EVIDENCE = {"proved", "decided", "argued", "sampled", "enclosed", "measured", "none"}
# The chapter that is decided anew where a part is enough: it is soon done, and has claims of every kind and type.
CHAPTER = "foundations"
PART = CHAPTER + ".*"
CLASSES = set(REGISTER["lists"]["classes"])


def run(*args, **options):
    return subprocess.run([CAGD, *args], capture_output=True, text=True, timeout=600, **options)


@functools.cache
def whole_run():
    """What `cagd verify --json` says of everything."""
    return json.loads((WHOLE_RUN / "verify.json").read_text())


def report(name):
    """One of the files of `cagd verify --report`."""
    return (WHOLE_RUN / "report" / name).read_text()


class Case(unittest.TestCase):
    def refuses(self, *args, words=()):
        """Exit 2, nothing on stdout, one line on stderr that has the words."""
        r = run(*args)
        self.assertEqual(r.returncode, 2, r)
        self.assertEqual(r.stdout, "")
        self.assertEqual(len(r.stderr.splitlines()), 1, r.stderr)
        for word in words:
            self.assertIn(word, r.stderr)


class Usage(Case):
    def test_no_command(self):
        r = run()
        self.assertEqual(r.returncode, 2)
        self.assertIn("Examples", r.stderr)

    def test_unknown_command(self):
        self.refuses("frobnicate", words=["frobnicate", "verify"])

    def test_unknown_option(self):
        self.refuses("verify", "--frobnicate", words=["frobnicate"])

    def test_help_has_examples_first(self):
        for command in re.findall(r"^  (\w+)  ", run("--help").stdout, re.M):
            r = run(command, "--help")
            self.assertEqual(r.returncode, 0)
            self.assertLess(r.stdout.index("Examples"), r.stdout.index("--help"))
        self.assertIn("Examples", run("--help").stdout)

    def test_manual_and_completion_have_the_options_of_every_command(self):
        option = re.compile(r"(?<![\w-])--[a-z-]+")
        commands = re.findall(r"^  (\w+)  ", run("--help").stdout, re.M)
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(run("--write-documents", folder).returncode, 0)
            pages = {p.name: p.read_text() for p in pathlib.Path(folder).iterdir()}
            self.assertEqual(sorted(pages), ["_cagd", "cagd.1", "cagd.bash", "cagd.fish"])
            manual = re.sub(r"\\f[BIR]", "", pages["cagd.1"]).replace("\\", "")
            described = dict(re.findall(r"^\.SS cagd (\w+)\n(.*?)(?=^\.S)", manual, re.S | re.M))
            synopsis = dict(re.findall(r"^\.B cagd (\w+)\n(.*?)(?=^\.[HS])", manual, re.S | re.M))
            arms = dict(re.findall(r"^    (\w+)\)\n(.*?);;", pages["_cagd"], re.S | re.M))
            for found in described, synopsis, arms:
                self.assertEqual(list(found), commands)
            for command in commands:
                with self.subTest(command=command):
                    own = set(option.findall(run(command, "--usage").stdout)) - {"--help", "--usage"}
                    self.assertEqual(set(re.findall(r"^(?:-\w, )?(--[a-z-]+)", described[command], re.M)), own)
                    self.assertEqual(set(option.findall(synopsis[command])), own)
                    self.assertEqual(set(self.completed(folder, command, "-")) - {"--help"}, own)
                    self.assertEqual(set(re.findall(r"^ *'\*(--[a-z-]+)", arms[command], re.M)), own)
                    lines = re.findall(r"from %s' -l (\S+)" % command, pages["cagd.fish"])
                    self.assertEqual({"--" + name for name in lines}, own)

    def completed(self, folder, *words):
        """What bash completes when the last of the words is begun."""
        script = ('source "$1/cagd.bash"; shift; COMP_WORDS=(cagd "$@"); COMP_CWORD=$#; COMP_LINE="cagd $*"; '
                  'COMP_POINT=${#COMP_LINE}; _cagd; printf "%s\\n" "${COMPREPLY[@]}"')
        path = str(pathlib.Path(CAGD).parent) + os.pathsep + os.environ["PATH"]
        return subprocess.run(["bash", "-c", script, "bash", folder, *words], capture_output=True, text=True, check=True,
                              env={**os.environ, "PATH": path}).stdout.split()

    def test_bash_completes_commands_words_names_and_files(self):
        with tempfile.TemporaryDirectory() as folder:
            run("--write-documents", folder)
            self.assertEqual(self.completed(folder, "ver"), ["verify"])
            self.assertEqual(self.completed(folder, "fit", "--loss", "h"), ["huber"])
            self.assertEqual(self.completed(folder, "figures", "envelope_ex"), ["envelope_extra"])
            name = "rational-bezier.elevation_keeps_rational_curve"
            self.assertEqual(self.completed(folder, "show", name[:-3]), [name])
            self.assertEqual(self.completed(folder, "curve", f"{folder}/cagd.f"), [f"{folder}/cagd.fish"])
            self.assertEqual(self.completed(folder, "verify", "--jobs", ""), [])

    def test_the_other_shells_read_their_completions(self):
        with tempfile.TemporaryDirectory() as folder:
            run("--write-documents", folder)
            for shell, name in (("bash", "cagd.bash"), ("zsh", "_cagd"), ("fish", "cagd.fish")):
                if shutil.which(shell):
                    self.assertEqual(subprocess.run([shell, "-n", f"{folder}/{name}"]).returncode, 0, shell)

    def test_version(self):
        self.assertRegex(run("--version").stdout, r"^cagd \d+\.\d+\.\d+\n$")

    def test_numbers_out_of_range(self):
        self.refuses("verify", "--jobs", "0", words=["--jobs", "from 1 to 64", "'0'"])
        self.refuses("verify", "--jobs", "many", words=["'many'"])
        self.refuses("verify", "--shard", "3", words=["K/N"])
        self.refuses("verify", "--shard", "3/2", words=["from 1 to 2"])
        self.refuses("verify", "--shard", "0/2", words=["from 1 to 2"])

    def test_mistyped_ids_get_the_nearest(self):
        self.refuses("show", "wang-ch3:thm-3.3.3", words=["wang-ch3:thm-3.3.2"])
        self.refuses("show", "elevation_keeps_rational_curv", words=["elevation_keeps_rational_curve"])
        self.refuses("verify", "no-such-claim")
        self.refuses("list", "no-such-claim")
        self.refuses("ledger", "no-such-source:*")
        self.refuses("figures", "no-such-figure", words=["no figure"])
        self.refuses("figures", "envelope_extr", words=["envelope_extra"])
        self.refuses("show", "envelope_extra", words=["it is a figure"])
        for command in "verify", "list", "ledger":  # one pattern that matches does not excuse another
            self.refuses(command, "wang-ch3:*", "no-such-claim", words=["no-such-claim"])

    def test_show_takes_ids(self):
        self.refuses("show", words=["which id"])
        self.refuses("show", "--json", "a", "b", words=["one id"])
        self.refuses("show", "wang-ch3:thm-3.2.1", "thm", words=["thm"])

    def test_output_that_cannot_be_written(self):
        self.refuses("verify", "elevation_keeps_rational_curve", "--junit", "/nonexistent/folder/x.xml",
                     words=["/nonexistent/folder/x.xml", "make it first"])
        self.refuses("figures", "--out", "/dev/null/x", "elevation*", words=["/dev/null/x", "choose another name"])
        with open("/dev/full", "w") as full:
            r = subprocess.run([CAGD, "list"], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(r.returncode, 3)


class Verify(Case):
    @classmethod
    def setUpClass(cls):
        cls.doc = whole_run()

    def part(self):
        """The claims of PART, as the run over everything has them."""
        return [c for c in self.doc["claims"] if c["chapter"] == CHAPTER]

    def test_everything_is_as_expected(self):
        self.assertEqual([c["name"] for c in self.doc["claims"] if not c["as_expected"]], [])
        self.assertEqual(self.doc["schema"], "cagd-verify-1")
        self.assertEqual(self.doc["not_as_expected"], 0)

    def test_every_claim_compared_something_and_its_control_was_caught(self):
        for claim in self.doc["claims"]:
            self.assertTrue(claim["types"], claim["name"])
            for name, result in claim["types"].items():
                self.assertGreater(result["compared"], 0, (claim["name"], name))
                self.assertTrue(result["control_caught"], (claim["name"], name))

    def test_no_empty_field(self):
        for claim in self.doc["claims"]:
            for field in ("name", "title", "title_zh", "given", "then", "method", "control", "scope"):
                self.assertTrue(claim[field].strip(), (claim["name"], field))

    def test_counterexamples_show_their_numbers(self):
        for claim in self.doc["claims"]:
            if claim["kind"] == "counterexample":
                shown = [s for r in claim["types"].values() for s in r["shown"]]
                self.assertTrue(shown, claim["name"])

    def test_names_are_unique_and_without_numbers_of_chapters(self):
        names = [c["name"] for c in self.doc["claims"]]
        self.assertEqual(len(names), len(set(names)))
        for name in names:
            self.assertRegex(name, r"^[a-z][a-z0-9_]*$")

    def test_jobs_do_not_change_the_output(self):
        self.assertEqual(run("verify", "--jobs", "1", PART).stdout, run("verify", "--jobs", "5", PART).stdout)

    def test_shards_are_a_partition(self):
        names = []
        for k in (1, 2, 3):
            doc = json.loads(run("verify", "--json", "--shard", f"{k}/3", PART).stdout)
            names += [c["name"] for c in doc["claims"]]
        self.assertEqual(sorted(names), sorted(c["name"] for c in self.part()))

    def test_tap(self):
        lines = run("verify", "--tap", PART).stdout.splitlines()
        self.assertEqual(lines[:2], ["TAP version 13", f"1..{len(self.part())}"])
        for k, line in enumerate(lines[2:], 1):
            self.assertRegex(line, rf"^ok {k} - ")

    def test_junit(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "report.xml")
            self.assertEqual(run("verify", "--junit", path, "--jobs", "2", PART).returncode, 0)
            suite = xml.dom.minidom.parse(path).documentElement
            self.assertEqual(suite.tagName, "testsuite")
            self.assertEqual(int(suite.getAttribute("tests")), len(self.part()))
            self.assertEqual(len(suite.getElementsByTagName("testcase")), len(self.part()))
            self.assertEqual(os.listdir(folder), ["report.xml"])

    def test_patterns(self):
        doc = json.loads(run("verify", "--json", PART).stdout)
        self.assertEqual(doc["claims"], self.part())
        doc = json.loads(run("verify", "--json", "wang-ch3:3.2.4-right").stdout)
        named = claims_of(REGISTER, next(s for s in REGISTER["statements"] if s["id"] == "wang-ch3:3.2.4-right"))
        self.assertEqual(sorted(c["name"] for c in doc["claims"]), sorted(named))


class Terminal(Case):
    def on_terminal(self, *args, **env):
        master, slave = pty.openpty()
        process = subprocess.Popen([CAGD, *args], stdout=slave, stderr=slave, env={**os.environ, **env})
        os.close(slave)
        text = b""
        while True:
            try:
                block = os.read(master, 65536)
            except OSError:
                break
            if not block:
                break
            text += block
        os.close(master)
        self.assertEqual(process.wait(), 0)
        return text.decode()

    def test_progress_and_colour_only_on_a_terminal(self):
        text = self.on_terminal("verify", "elevation_keeps_rational_curve", NO_COLOR="")
        self.assertIn("\x1b[32m", text)
        self.assertIn("1/4", text)
        piped = run("verify", "elevation_keeps_rational_curve")
        self.assertNotIn("\x1b", piped.stdout + piped.stderr)

    def test_no_color(self):
        text = self.on_terminal("verify", "elevation_keeps_rational_curve", NO_COLOR="1")
        self.assertNotIn("\x1b[3", text)


class Ledger(Case):
    @classmethod
    def setUpClass(cls):
        cls.rows = json.loads(report("ledger.json"))["statements"]

    def test_json_is_the_report(self):
        some = json.loads(run("ledger", "--json", "wang-ch3:3.1.*").stdout)["statements"]
        self.assertTrue(some)
        self.assertEqual(some, [r for r in self.rows if r["id"].startswith("wang-ch3:3.1.")])

    def test_rows_are_complete(self):
        seen = collections.Counter(row["id"] for row in self.rows)
        self.assertEqual([i for i, n in seen.items() if n > 1], [])
        for row in self.rows:
            printed = row["as_printed"]
            with self.subTest(row["id"]):
                self.assertIn(printed["verdict"], VERDICTS)
                self.assertIn(printed["evidence"], EVIDENCE)
                for field in ("title", "title_zh", "printed_tex"):
                    self.assertTrue(row[field].strip(), field)
                if printed["verdict"] == "fails":
                    self.assertIn(printed["class"], CLASSES)
                    self.assertTrue(printed["counterexample"]["values"])
                    self.assertEqual(row["corrected"]["verdict"], "holds")
                if printed["verdict"] == "conditional":
                    self.assertTrue(printed["hypotheses"])
                if printed["verdict"] == "undecided":
                    self.assertTrue(printed["readings"])
                if printed["verdict"] in ("holds", "conditional", "fails"):
                    self.assertTrue(row["claims"])
                    self.assertNotEqual(printed["evidence"], "none")

    def test_nothing_is_open(self):
        self.assertEqual([r["id"] for r in self.rows if r["as_printed"]["verdict"] == "open"], [])

    def test_the_table_counts_what_the_rows_say(self):
        lines = report("summary.txt").splitlines()
        for line in lines[1:]:
            source, total, *counts = line.split()
            rows = [r for r in self.rows if r["id"].split(":")[0] == source]
            self.assertEqual(int(total), len(rows))
            self.assertEqual(sum(map(int, counts)), len(rows))

    def test_chapter_three_is_covered(self):
        """Every number that the source prints has an entry."""
        ids = " ".join(r["id"] for r in self.rows)
        wanted = [f"3.1.{k}" for k in range(1, 6)] + [f"3.2.{k}" for k in range(1, 15)]
        wanted += [f"3.3.{k}" for k in range(1, 5)] + [f"3.4.{k}" for k in range(1, 9)]
        wanted += [f"3.5.{k}" for k in range(1, 7)]
        wanted += [f"prop-3.2.{k}" for k in range(1, 13)]
        wanted += ["def-3.2.1", "def-3.2.2", "def-3.4.1", "thm-3.2.1", "thm-3.3.1", "thm-3.3.2", "thm-3.4.1",
                   "thm-3.4.2", "thm-3.4.3", "thm-3.5.1", "thm-3.5.2", "cor-3.5.1"]
        missing = [w for w in wanted if not re.search(r"wang-ch3:%s(?![0-9])" % re.escape(w), ids)]
        self.assertEqual(missing, [])

    def test_show_prints_every_entry(self):
        """The three quarters that are decided most quickly: they are decided anew to be shown."""
        cases = xml.dom.minidom.parse(str(WHOLE_RUN / "verify.xml")).getElementsByTagName("testcase")
        seconds = {c.getAttribute("name"): float(c.getAttribute("time")) for c in cases}
        cost = [sum(seconds[name] for name in row["claims"]) for row in self.rows]
        limit = sorted(cost)[3 * len(cost) // 4]
        quick = [row for row, its in zip(self.rows, cost) if its <= limit]
        r = run("show", *[row["id"] for row in quick])
        self.assertEqual(r.returncode, 0)
        pages = r.stdout.split("\n\n\n")
        self.assertEqual(len(pages), len(quick))
        for row, page in zip(quick, pages):
            self.assertIn(row["id"], page)
            self.assertIn("\nVerdict\n", page, row["id"])
            self.assertNotIn("\\", page, row["id"])

    def test_show_names_the_book_and_the_literature(self):
        titles = {source["key"]: source["has"]["zh"][0] for source in REGISTER["sources"] if "zh" in source["has"]}
        first = {}
        for row in self.rows:
            first.setdefault(row["id"].split(":")[0], row["id"])
        self.assertEqual(set(first), set(titles))
        for key, identifier in first.items():
            self.assertIn(titles[key], run("show", identifier).stdout.split("\nPrinted\n")[0].replace("\n", " "))
        cited = [(c["name"], key) for c in whole_run()["claims"] for key in re.findall(r"\[([a-z]+(?:-[a-z]+)*-\d{4})", c["method"])]
        self.assertTrue(cited)
        for name, key in cited:
            self.assertIn(key, run("show", name).stdout.split("\nLiterature\n")[1])

    def test_chapter_four_is_covered(self):
        """Every number that the source prints has an entry."""
        ids = " ".join(r["id"] for r in self.rows)
        wanted = [f"formula-4.1.{k}" for k in range(1, 10)] + ["cor-4.1.1", "thm-4.1.1", "def-4.1.1", "def-4.2.1"]
        wanted += ["lemma-4.2.1", "lemma-4.2.2", "thm-4.2.1", "thm-4.2.2", "cor-4.3.1", "def-4.3.1", "lemma-4.4.1"]
        wanted += [f"thm-4.3.{k}" for k in (1, 2, 3)] + [f"thm-4.4.{k}" for k in (1, 2, 3)] + ["def-4.4.1", "def-4.4.2"]
        wanted += [f"formula-4.3.{k}" for k in range(1, 19) if k != 2] # (4.3.2) is what theorem 4.3.1 says
        wanted += [f"formula-4.4.{k}" for k in range(1, 24)]
        missing = [w for w in wanted if not re.search(r"wang-ch4:%s(?![0-9])" % re.escape(w), ids)]
        self.assertEqual(missing, [])


class Readme(Case):
    def test_every_transcript_is_what_the_program_prints(self):
        text = (ROOT / "README.md").read_text()
        blocks = re.findall(r"^```\n(.*?)^```", text, re.S | re.M)
        commands = [b for b in blocks if b.startswith("$ cagd ")]
        self.assertTrue(commands)
        for block in commands:
            command, _, said = block.partition("\n")
            printed = run(*command.split()[2:], cwd=ROOT).stdout
            # The line of a statement moves with every edit above it.
            said, printed = (re.sub(r"(\.claims\.h):\d+\)", r"\1)", text.strip()) for text in (said, printed))
            self.assertEqual(printed, said)

    def test_the_numbers_are_those_of_the_run(self):
        text = (ROOT / "README.md").read_text()
        claims = whole_run()["claims"]
        runs = [r for c in claims for r in c["types"].values()]
        kinds = collections.Counter("counterexample" if c["kind"] == "counterexample" else c["evidence"] for c in claims)
        sampled = sum(kinds[e] for e in ("sampled", "measured", "enclosed"))
        self.assertIn(f"{len(claims)} claims: {kinds['proved']} proved, {kinds['decided']} decided, {kinds['argued']} argued, "
                      f"{sampled} sampled, {kinds['counterexample']} counterexamples, 0 not as expected", text)
        caught = sum(r["control_caught"] for r in runs)
        self.assertIn(f"{sum(r['compared'] for r in runs)} comparisons in {len(runs)} runs; {caught} of {len(runs)} controls "
                      "caught", text)
        for line in report("summary.txt").splitlines():
            self.assertIn(line, text)

    def test_the_last_lines_count_the_claims(self):
        lines = run("verify", PART).stdout.splitlines()[-2:]
        claims = [c for c in whole_run()["claims"] if c["chapter"] == CHAPTER]
        self.assertRegex(lines[0], rf"^{len(claims)} claims: ")
        compared = sum(r["compared"] for c in claims for r in c["types"].values())
        self.assertRegex(lines[1], rf"^{compared} comparisons in ")

    def test_every_link_leads_somewhere(self):
        for name in ("README.md", "CONTRIBUTING.md"):
            for target in re.findall(r"\]\((?!http)([^)#]+)\)", (ROOT / name).read_text()):
                self.assertTrue((ROOT / target).exists(), (name, target))


class Figures(Case):
    def test_the_gallery_is_what_is_drawn(self):
        drawn = {p.name: p.read_bytes() for p in (WHOLE_RUN / "figures").iterdir()}
        kept = {p.name: p.read_bytes() for p in (ROOT / "figures" / "gallery").glob("*.svg")}
        self.assertEqual(sorted(drawn), sorted(kept))
        for name in drawn:
            self.assertEqual(drawn[name], kept[name], name)

    def test_jobs_do_not_change_them(self):
        for jobs in "1", "3":
            with tempfile.TemporaryDirectory() as folder:
                self.assertEqual(run("figures", "--jobs", jobs, "--out", folder, "e*").returncode, 0)
                drawn = {p.name: p.read_bytes() for p in pathlib.Path(folder).iterdir()}
            self.assertGreater(len(drawn), 10)
            for name, text in drawn.items():
                self.assertEqual(text, (ROOT / "figures" / "gallery" / name).read_bytes(), name)

    def test_nothing_more_is_drawn_after_a_failure(self):
        with tempfile.TemporaryDirectory() as folder:  # no file has room there
            r = run("figures", "--jobs", "1", "--out", folder, "e*",
                    preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)))
            self.assertEqual((r.returncode, r.stdout, len(r.stderr.splitlines())), (3, "", 1))
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])
        self.refuses("figures", "--out", "/proc/self", "e*", words=["/proc/self"])

    def test_words_do_not_touch_in_a_wider_font(self):
        """DejaVu takes the place of fonts that are not there.  Captions, legends and headings keep a distance, labels do not overlap."""
        tried = 0
        for path in sorted((ROOT / "figures" / "gallery").glob("*.svg")):
            words, width, height = figure_words.boxes(path)
            for k, (x0, y0, x1, y1, kind, text) in enumerate(words):
                tried += 1
                self.assertTrue(0 <= x0 and x1 <= width and 0 <= y0 and y1 <= height, (path.name, text))
                for u0, v0, u1, v1, other, said in words[:k]:
                    gap = 8 if kind in "nd" and other in "nd" else 0
                    self.assertFalse(x0 < u1 + gap and u0 < x1 + gap and y0 < v1 and v0 < y1, (path.name, text, said))
        self.assertGreater(tried, 1000)

    def test_figures_say_which_curve_is_which(self):
        """What a reader looked for in them and did not find."""
        for name, wanted in (("marsden_identity", ["ω1N1", "ω2N2", "ω3N3", "ω4N4", "ω5N5", "(x−t)2", "knots"]),
                             ("two_twists", ["the twist in M is 0", "the twist in M is 1", "asked for", "what the patch has"]),
                             ("bezier_patch", ["the net", "lines, and Pu×Pw", "borders", "parameter lines", "normals"]),
                             ("worked_table", ["printed points", "error of x", "error of y"]),
                             ("circular_arc", ["θ", "2θ", "r", "l", "C", "weights 1, 3/5, 1: the arc of angle 2θ", "weights 1, −3/5, 1: the arc of angle 2π−2θ"]),
                             ("hermite_blending_functions", ["q00", "q01", "q10", "q11", "4/27 at u=1/3", "−4/27 at u=2/3"]),
                             ("convex_hull", ["outside 0 ≤ t ≤ 1", "t=1/2", "t=1", "t=3/2", "R(2)", "outside the hull", "convex hull"])):
            words = [text for *_, text in figure_words.boxes(ROOT / "figures" / "gallery" / (name + ".svg"))[0]]
            self.assertEqual([text for text in wanted if text not in words], [], (name, words))

    def test_no_word_of_a_title_is_left_over(self):
        """Its lines are about as long as one another."""
        broken = 0
        for path in sorted((ROOT / "figures" / "gallery").glob("*.svg")):
            lines = [x1 - x0 for x0, _, x1, _, kind, _ in figure_words.boxes(path)[0] if kind == "t"]
            broken += len(lines) > 1
            self.assertGreater(min(lines), 0.5 * max(lines), path.name)
        self.assertGreater(broken, 10)

    def test_one_scale_of_markers_and_a_short_title(self):
        """A mark of one shape has one size in all figures, whatever their windows are, and figures are shown in one scale; above each
        its title, as long as two lines at most."""
        sizes = {}
        for path in sorted((ROOT / "figures" / "gallery").glob("*.svg")):
            text = path.read_text()
            width, height = re.search(r'<svg [^>]*width="([\d.]+)" height="([\d.]+)"', text).groups()
            self.assertIn(f'viewBox="0 0 {width} {height}"', text, path.name)
            title = re.findall(r'<g class="title"[^>]*>(.*?)</g>', text, re.S)
            self.assertEqual(len(title), 1, path.name)
            lines = [re.sub("<[^>]*>", "", line) for line in re.findall("<text.*?</text>", title[0], re.S)]
            self.assertTrue(1 <= len(lines) <= 2 and 0 < len(" ".join(lines)) <= 72, (path.name, lines))
            for tag in re.findall(r"<(?:circle|rect) [^>]*>", text):
                kind, size = re.search(r'class="([mo]) ', tag + " "), re.search(r' (?:r|width)="([\d.]+)"', tag)
                if kind and size:
                    sizes.setdefault((tag[1], kind[1]), set()).add(size[1])
        self.assertEqual({kind: len(found) for kind, found in sizes.items()}, dict.fromkeys(sizes, 1), sizes)
        self.assertGreater(len(sizes), 1)

    def test_figures_are_accessible(self):
        for path in (ROOT / "figures" / "gallery").glob("*.svg"):
            root = xml.dom.minidom.parse(str(path)).documentElement
            self.assertEqual(root.getAttribute("role"), "img", path)
            for tag in ("title", "desc"):
                self.assertTrue(root.getElementsByTagName(tag)[0].firstChild.data.strip(), path)

    def test_every_figure_of_the_ledger_exists(self):
        names = set(run("figures", "--list").stdout.split())
        for row in json.loads(report("ledger.json"))["statements"]:
            if row["figure"]:
                self.assertIn(row["figure"], names)


# The unit circle in four quarters: double knots, weights 1, 1, 2.
CIRCLE = {"kind": "nurbs", "degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4],
          "points": [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]],
          "weights": [1, 1, 2, 1, 1, 1, 2, 1, 1]}


class Curves(Case):
    def curve(self, curve, *args, code=0):
        text = curve if isinstance(curve, str) else json.dumps(curve)
        r = run("curve", *args, "-", input=text)
        self.assertEqual(r.returncode, code, r)
        return r

    def values(self, curve, *parameters, options=()):
        args = [x for t in parameters for x in ("--at", t)]
        return json.loads(self.curve(curve, "--json", *options, *args).stdout)["values"]

    def points(self, curve, *parameters):
        return [v["derivatives"][0] for v in self.values(curve, *parameters)]

    def bad(self, words, text=None, args=(), **change):
        text = text if text is not None else json.dumps({**CIRCLE, **change})
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "c.json"
            path.write_text(text)
            self.refuses("curve", str(path), *args, words=[str(path), *words])

    def test_values_are_exact(self):
        a, b = self.values(CIRCLE, "1/3", "2", options=("--derivatives", "1"))
        self.assertEqual(a["derivatives"], [["4/5", "3/5"], ["-27/25", "36/25"]])
        self.assertEqual(a["rounded"][0], [0.8, 0.6])
        self.assertEqual(a["curvature_squared"], 1)
        self.assertEqual(b["derivatives"][0], [-1, 0])

    def test_sides_of_a_knot(self):
        corner = {"kind": "bspline", "degree": 1, "points": [[0, 0], [1, 0], [1, 3]], "knots": [0, 0, 1, 2, 2]}
        right, = self.values(corner, "1", options=("--derivatives", "1"))
        left, = self.values(corner, "1", options=("--derivatives", "1", "--left"))
        self.assertEqual((left["derivatives"], right["derivatives"]), ([[1, 0], [1, 0]], [[1, 0], [0, 3]]))

    def test_order_is_degree_plus_one(self):
        by_order = {k: v for k, v in CIRCLE.items() if k != "degree"} | {"order": 3}
        self.assertEqual(self.points(by_order, "1/3"), self.points(CIRCLE, "1/3"))

    def test_numbers_as_people_write_them(self):
        line = {"kind": "bezier", "points": [["0x1p-1"], ["1/3"]]}
        self.assertEqual(self.points(line, "0", "1"), [["1/2"], ["1/3"]])
        line["points"] = [["0.1"], [0.1]]
        self.assertEqual(self.points(line, "0", "1"), [["1/10"], ["3602879701896397/36028797018963968"]])

    def test_changed_curves_are_the_same_curve(self):
        at = ["0", "1/3", "1/2", "1", "7/4", "3", "22/7", "4"]
        wanted = self.points(CIRCLE, *at)
        finer = self.curve(CIRCLE, "--insert", "1/2", "--insert", "22/7", "--insert", "1/2").stdout
        higher = self.curve(CIRCLE, "--elevate").stdout
        again = self.curve(finer, "--remove", "22/7", "--remove", "1/2", "--remove", "1/2").stdout
        for changed in finer, higher, again, self.curve(higher, "--reduce").stdout:
            self.assertEqual(self.points(changed, *at), wanted)
        self.assertEqual(json.loads(again)["knots"], CIRCLE["knots"])
        self.assertEqual(json.loads(higher)["knots"].count(1), 3)
        left, right = json.loads(self.curve(CIRCLE, "--split", "1/2").stdout)
        self.assertEqual(self.points(left, "0", "1/3", "1/2"), wanted[:3])
        self.assertEqual(self.points(right, "1/2", "1", "4"), [wanted[2], wanted[3], wanted[7]])
        quarters = json.loads(self.curve(CIRCLE, "--bezier").stdout)
        self.assertEqual(len(quarters), 4)
        self.assertEqual(self.points(quarters[1], "1", "7/4"), wanted[3:5])

    def test_what_cannot_be_removed(self):
        self.assertIn("the knot 1", self.curve(CIRCLE, "--remove", "1", code=1).stderr)
        self.assertIn("segment from 0", self.curve(CIRCLE, "--reduce", code=1).stderr)

    def test_description(self):
        text = self.curve(CIRCLE).stdout
        for words in ["NURBS curve of degree 2 (order 3) in the plane", "[0, 4], 4 segments", "1 (2 times)", "positive"]:
            self.assertIn(words, text)
        signs = self.curve({**CIRCLE, "weights": [1, -3, 2, 1, 1, 1, 2, 1, 1]}).stdout
        self.assertIn("vanishes somewhere", signs)

    def test_bad_knots(self):
        k = CIRCLE["knots"]
        self.bad(["knots[4]", "1/2", "smaller", "1"], knots=k[:4] + ["1/2"] + k[5:])
        self.bad(["knots[3]", "more than 3 times"], knots=[0, 0, 0, 0] + k[4:])
        self.bad(["10 given", "expected 12"], knots=k[:10])
        self.bad(["domain", "empty"], text=json.dumps({"kind": "bspline", "degree": 1, "points": [[0], [1]],
                                                       "knots": [0, 1, 1, 2]}))

    def test_bad_counts_and_fields(self):
        self.bad(["weights", "8 given", "expected 9"], weights=CIRCLE["weights"][:8])
        self.bad(["points[3]", "1 given", "expected 2"], points=CIRCLE["points"][:3] + [[1]] + CIRCLE["points"][4:])
        self.bad(["points[0]", "1 to 3"], points=[[1, 2, 3, 4]])
        self.bad(["at least 13"], degree=12, knots=list(range(22)))
        self.bad(["degree", "0 to 64"], degree=65)
        self.bad(["degree", "0 to 64"], degree="2")
        self.bad(["kind", "rational-bezier"], kind="spline")
        self.bad(["knot", "no such field"], knot=[1])
        self.bad(["points[0]", "3/7"], points=[["x", 1]] + CIRCLE["points"][1:])
        self.bad(["points[0]", "3/7"], points=[["1/0", 1]] + CIRCLE["points"][1:])
        self.bad(["weights", "missing"], text=json.dumps({k: v for k, v in CIRCLE.items() if k != "weights"}))

    def test_bad_files(self):
        self.bad(["line 1"], text=json.dumps(CIRCLE)[:-5])
        self.bad(["line 1"], text='{"kind": "bezier", "points": [[NaN]]}')
        self.bad(["object"], text="[1]")
        self.refuses("curve", "/does/not/exist.json", words=["/does/not/exist.json"])
        self.refuses("curve", words=["file"])

    def test_bad_parameters(self):
        self.bad(["outside", "5"], args=["--at", "5"])
        self.bad(["total weight is 0", "1/2"], args=["--at", "1/2"],
                 text='{"kind": "rational-bezier", "points": [[0], [1]], "weights": [1, -1]}')
        self.bad(["as many knots", "1"], args=["--insert", "1", "--insert", "1"])
        self.bad(["not at 4"], args=["--insert", "4"])
        self.bad(["no inner knot 1/2"], args=["--remove", "1/2"])
        self.bad(["not at 0"], args=["--split", "0"])
        self.refuses("curve", "c.json", "--at", "x", words=["--at", "x"])
        self.refuses("curve", "c.json", "--elevate", "--reduce", words=["one change"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
