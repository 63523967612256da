"""Planted faults in core/fit: one sign, index, factor or condition at a time; the tests of the fit must notice.

    faults.py BUILD [--sample N] [--seed S] [--file NAME,...] [--from N] [--shard K/N] [--list] [--equivalent]

BUILD is a configured build of this tree with Ninja, which is brought up to date; the tree and the build stay as they are otherwise.  For each
fault only the files that contain it are compiled again, a copy of the library gets these objects, and the tests are linked with it and
run, the fastest first, until one of them fails, crashes or takes ten times its usual time.  A fault that survives is listed, and
the exit status is 1.

equivalent.txt lists, each with its reason, the faults that no test of a result can notice: those that change nothing, and those in steps on
the way that the result does not depend on.  They are left out; with --equivalent they alone are tried, and one that a test notices
does not belong there.
"""
import argparse
import json
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.txt")
RULES = [
    ("sum to difference", r" \+= ", " -= "),
    ("difference to sum", r" -= ", " += "),
    ("plus to minus", r"(?<=[\w\])]) \+ (?=[\w(])", " - "),
    ("minus to plus", r"(?<=[\w\])]) - (?=[\w(])", " + "),
    ("product to quotient", r"(?<=[\w\])]) \* (?=[\w(])(?!sizeof)", " / "),
    ("quotient to product", r"(?<=[\w\])]) / (?=[\w(])", " * "),
    ("one to two", r"\b1\b(?= [-+/*])", "2"),
    ("two to one", r"\b2\b(?= [-+/*])", "1"),
    ("root lost", r"\bsqrt\(", "("),
    ("less to greater", r" < (?=0|1)", " > "),
    ("square to third power", r"\b(\w+) \* \1\b", r"\1 * \1 * \1"),
    ("sign lost", r"(?<=[=(,] )-(?=[a-z(])", ""),
    ("minimum to maximum", r"\bfmin\(", "fmax("),
    ("maximum to minimum", r"\bfmax\(", "fmin("),
    ("and to or", r" && ", " || "),
]
# Of memory that is allocated, copied and given back the sanitizers and fit-memory judge.
SKIP = re.compile(r"malloc|calloc|sizeof|memcpy|free\(|assert|#define|for \(|static .*\{|enum|numbers\(|room")


def faults():
    found = []
    for path in sorted((ROOT / "core/fit").glob("*.[ch]*")):
        if path.suffix not in (".c", ".h", ".cpp") or path.name == "cagd_fit.h":
            continue
        text = path.read_text()
        code = re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group(0)), text, flags=re.S)
        for rule, pattern, now in RULES:
            for m in re.finditer(pattern, code):
                line = text.count("\n", 0, m.start())
                old = text.splitlines()[line]
                if SKIP.search(old) or '"' in old:
                    continue
                mutated = text[: m.start()] + m.expand(now) + text[m.end():]
                found.append({"file": path.name, "line": line + 1, "rule": rule, "text": mutated,
                              "old": old.strip(), "new": mutated.splitlines()[line].strip()})
    return found


def equivalents():
    """{(file, line as it stands, line as changed)}, where * stands for every change.  A line that nobody finds any more is an error."""
    known = set()
    for line in EQUIVALENT.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            file, old, new, _ = (part.strip() for part in line.split(" | ", 3))
            if old not in {code.strip() for code in (ROOT / "core/fit" / file).read_text().splitlines()}:
                sys.exit(f"equivalent.txt: {file} has no line '{old}'")
            known.add((file, old, new))
    return known


def outcome(command, limit):
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=limit).returncode
    except subprocess.TimeoutExpired:
        return "time"


class Build:
    """The commands of a build, carried over to another folder."""

    TESTS = {"unit/test_fit_statistics": [], "fit/test_certified": None, "unit/test_fit": [], "fit/test_coverage": [], "fit/test_memory": []}

    def __init__(self, build, folder):
        self.build, self.folder = build.resolve(), pathlib.Path(folder)
        targets = [test.split("/")[1] for test in self.TESTS]
        subprocess.run(["cmake", "--build", build, "-j1", "--target", *targets], check=True, stdout=subprocess.DEVNULL)
        self.library = self.build / "core/fit/libcagd_fit.a"
        compiled = json.loads(self.ninja("-t", "compdb"))
        # Of the library, and the same sources once more in tests.
        self.compile = {c["output"]: (pathlib.Path(c["file"]).name, shlex.split(c["command"])) for c in compiled
                        if "/core/fit/" in c["file"] and c.get("output", "").endswith(".o")}
        self.depends = {output: self.ninja("-t", "deps", output) for output in self.compile}
        self.link = {test: shlex.split(self.ninja("-t", "commands", f"proofs-tests/{test}").splitlines()[-1])[2:-2] for test in self.TESTS}
        problems = ROOT / "proofs-tests/fit/problems"
        self.TESTS["fit/test_certified"] = [problems] + sorted(p.stem for p in problems.glob("*.json") if p.stem != "twenty-thousand")
        self.usual = {}

    def ninja(self, *words):
        return subprocess.run(["ninja", "-C", self.build, *words], check=True, capture_output=True, text=True).stdout

    def run(self, test, limit):
        return outcome([self.folder / test.split("/")[1], *map(str, self.TESTS[test])], limit)

    def time(self):
        """What every test takes without a fault; only tests that hold are judges."""
        self.instead = {}
        for test in self.TESTS:
            self.linked(test)
            start = time.monotonic()
            if self.run(test, 600) == 0:
                self.usual[test] = time.monotonic() - start
        return " ".join(f"{test.split('/')[1]} {seconds:.1f} s" for test, seconds in self.usual.items())

    def linked(self, test):
        command = [self.instead.get(word, word) for word in self.link[test]]
        command[command.index("-o") + 1] = str(self.folder / test.split("/")[1])
        subprocess.run(command, check=True, cwd=self.build)

    def judge(self, fault):
        """Which test notices it."""
        overlay = self.folder / "overlay/core/fit"
        overlay.mkdir(parents=True, exist_ok=True)
        for old in overlay.iterdir():
            old.unlink()
        (overlay / fault["file"]).write_text(fault["text"])
        library = self.folder / "libcagd_fit.a"
        library.write_bytes(self.library.read_bytes())
        self.instead = {"core/fit/libcagd_fit.a": str(library)}
        objects = self.compile_with(fault, "core/fit/")
        if objects is None:
            return "the compiler"
        subprocess.run(["ar", "r", library, *objects.values()], check=True, capture_output=True)
        self.instead |= self.compile_with(fault, "proofs-tests/unit/") or {}
        for test, seconds in self.usual.items():
            if test == "fit/test_memory":
                if fault["rule"] != "and to or":  # what is wrong only without memory is a chain of conditions
                    continue
                self.instead |= self.compile_with(fault, "proofs-tests/fit/") or {}
            self.linked(test)
            if self.run(test, 10 * seconds + 5) != 0:
                return test.split("/")[1]
        return None

    def compile_with(self, fault, where):
        """The objects that stand in the place of those of the build; None where one does not compile."""
        objects = {}
        for output, (name, command) in self.compile.items():
            if not output.startswith(where) or \
                    (name != fault["file"] and f"/core/fit/{fault['file']}\n" not in self.depends[output]):
                continue
            command = [word for word in command if not word.endswith("ccache")]
            source = (self.folder / "overlay" if name == fault["file"] else ROOT) / "core/fit" / name
            compiled = self.folder / where.strip("/").replace("/", "-") / pathlib.Path(output).name
            compiled.parent.mkdir(exist_ok=True)
            for flag, value in ("-o", compiled), ("-c", source), ("-MF", "/dev/null"):
                command[command.index(flag) + 1] = str(value)
            command.insert(1, f"-I{self.folder / 'overlay'}")
            if subprocess.run(command, cwd=self.build, capture_output=True).returncode != 0:
                return None
            objects[output] = str(compiled)
        return objects


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--sample", type=int)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--file", help="only faults in these files")
    parser.add_argument("--from", type=int, default=1, dest="first", metavar="N", help="begin with the N-th")
    parser.add_argument("--shard", default="1/1")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--equivalent", action="store_true")
    arguments = parser.parse_args()
    known = equivalents()
    every = faults()
    is_known = lambda f: (f["file"], f["old"], f["new"]) in known or (f["file"], f["old"], "*") in known
    chosen = [f for f in every if is_known(f) == arguments.equivalent]
    if arguments.file:
        chosen = [f for f in chosen if f["file"] in arguments.file.split(",")]
    if arguments.sample is not None:
        chosen = random.Random(arguments.seed).sample(chosen, min(arguments.sample, len(chosen)))
    shard, shards = map(int, arguments.shard.split("/"))
    chosen = chosen[arguments.first - 1:][shard - 1::shards]
    if arguments.list:
        for f in chosen:
            print(f"{f['file']}:{f['line']}  {f['rule']}: {f['old']}  ->  {f['new']}")
        print(f"{len(every)} faults")
        return 0
    survivors = 0
    with tempfile.TemporaryDirectory() as folder:
        build = Build(arguments.build, folder)
        print("without a fault:", build.time(), flush=True)
        for f in chosen:
            start = time.monotonic()
            judge = build.judge(f)
            survivors += judge is None
            print(f"{'noticed by ' + judge if judge else 'SURVIVES'} in {time.monotonic() - start:.0f} s: "
                  f"{f['file']}:{f['line']}  {f['rule']}: {f['old']}  ->  {f['new']}", flush=True)
    print(f"{len(chosen)} faults of {len(every)}, {survivors} survive")
    return 0 if (survivors == len(chosen) if arguments.equivalent else survivors == 0) else 1


if __name__ == "__main__":
    sys.exit(main())
