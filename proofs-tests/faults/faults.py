"""Planted faults: one operator, operand, condition, statement or constant at a time is changed, and a test must notice.

    faults.py ROOM [--per-function N] [--one-in N] [--seed WORD] [--file PATH,...] [--function NAME,...] [--shard K/N] [--jobs N]
              [--list] [--kinds] [--equivalent] [--again LOG] [--given FILE] [--slow] [--chapters LIST] [--types LIST] [--register FILE]

ROOM is kernels, exact, expression, code, check, judge, core, fit or files.  planter.py says which places and kinds there are.  In a copy of the tree every place that is chosen
gets a switch, so that one build holds as many faults as do not overlap; the environment says which of them is on.  A fault is tried
by the tests of its room, those of its file first, until one fails, crashes or takes many times its usual time; in the kernels by
the claims that define the kernel, by all claims, and by the unit test under both sanitizers, which sees what is read or written
behind the end of an array and changes no result.  A fault that survives is printed, and the exit status is 1.

Without --one-in and --per-function every fault is tried.  Both choose by the hash of a fault's name, which is made of file, function,
kind and the line before and after: whether it is chosen does not depend on what is edited elsewhere.  --one-in N takes those whose hash is
divisible by N, with --seed another choice of as many for each word; --per-function N takes from each function N of them, of kinds as different as possible.  --slow tries the tests that take long as well.  equivalent.txt lists the faults that no test can notice, each with
its reason; they are left out, and with --equivalent they alone are tried.  --again tries those that survived in the output of
a former run.  --given tries those that somebody wrote down, each a line `file:number | the line as it stands | the line as changed | what it is`,
those of the room; what a test needs is built for each of them before it.  For the kernels, --chapters builds only these
chapters, with those whose claims they name, for faults in the kernels that they define, and --types only these number types.
"""
import argparse
import collections
import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

import planter

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "proofs-tests/scripts"))
from register import USUAL, claims_of, load, words  # noqa: E402
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.txt")


def sources(*patterns):
    return sorted(str(path.relative_to(ROOT)) for pattern in patterns for path in ROOT.glob(pattern))


class Room:
    """What can be faulty: files by the translation unit that shows them, and the tests, the quick ones first.  The targets are those that
    are built for tests that are scripts."""

    optimised, targets, tests, slow, options, configured = "-O1", [], {}, [], [], []

    def units(self):
        raise NotImplementedError

    def first(self, file):
        """The tests that know most of a file."""
        return []


class Exact(Room):
    """A test in the order of the time that it takes."""
    tests = {name: [f"proofs-tests/unit/{name}"] for name in (
        "test_sums test_resultant test_cylinders test_polynomial test_sign test_sturm test_total_positivity test_crossings test_ends test_record test_field test_numbers "
        "test_linear test_hull test_simplex test_fraction test_exact_curve test_comparison test_command test_region test_roots test_svg test_judge test_stationary_parts test_stationary test_expression").split()}
    slow = {"test_exact_memory": ["proofs-tests/unit/test_exact_memory"], "test_kernels": ["proofs-tests/unit/test_kernels"]}
    KNOWS = {"interval": "test_ends test_numbers", "rational": "test_numbers", "field": "test_field test_fraction test_numbers", "fraction": "test_fraction",
             "polynomial": "test_polynomial", "region": "test_region", "slots": "test_region", "recorder": "test_record", "parallel": "test_region",
             "spline": "test_exact_curve", "algebraic": "test_cylinders"}

    def units(self):
        found = {c: [c] for c in sources("exact/number/*.c", "exact/decide/*.c", "exact/record/*.c", "exact/curve/*.c", "exact/fit/*.c")}
        found["exact/decide/resultant.c"].append("exact/decide/resultant.tmpl.h")
        return found

    def first(self, file):
        stem = pathlib.Path(file).name.split(".")[0]
        if file.startswith("exact/fit"):
            return ["test_stationary_parts", "test_stationary"]
        if file.startswith("exact/record"):
            return ["test_record"]
        return self.KNOWS.get(stem, f"test_{stem}").split()


class Expression(Room):
    """What reads formulas and decides them, judged by what `cagd check` says of formulas and bases that are known."""
    configured, targets = ["-DCAGD_ONLY_CHAPTERS=fitting", "-DCAGD_TYPES=RATIONAL"], ["cagd"]
    SCRIPT = [sys.executable, ROOT / "proofs-tests/check/test_check.py", "cagd", "-f"]
    LATEX = [sys.executable, ROOT / "proofs-tests/check/test_latex.py", "cagd", "-f"]
    tests = {**{name: [f"proofs-tests/unit/{name}"] for name in "test_latex test_changes test_statements test_expression test_cells test_for_every test_drawn test_known test_example".split()},
             "page": [sys.executable, ROOT / "proofs-tests/check/test_page.py", "cagd"], "standard functions": [*SCRIPT, "Standard"], "what is said": [*SCRIPT, "Reasons", "Verdicts", "Language", "Ranges", "Pictures"], "mistakes": [*SCRIPT, "Mistakes"],
             "for every number, and opponents": [*SCRIPT, "EveryChoice", "Opponents"], "as papers have it": [*SCRIPT, "RowsAndLists", "AsPapersHaveIt"], "papers": LATEX, "what holds for small numbers": [*SCRIPT, "Cells"], "bases": [sys.executable, ROOT / "proofs-tests/check/test_basis.py", "cagd", "-f"],
             "certificates": [*SCRIPT, "Certificates"], "the literature": [*SCRIPT, "Literature"]}
    KNOWS = {"basis": "bases", "latex": "papers", "latex_commands": "papers", "positive": "certificates", "standard": "standard functions", "token": "mistakes"}

    def units(self):
        return {c: [c] for c in sources("exact/expression/*.c")}

    def first(self, file):
        stem = pathlib.Path(file).stem
        return ["mistakes"] if stem.startswith("read") else [self.KNOWS[stem]] if stem in self.KNOWS else []


class Code(Room):
    """What executes code of others, judged by its unit tests, by small programs of every feature of the language, and by what `cagd exactly` says."""
    configured, targets = Expression.configured, ["cagd", "cagd-compile-exactly", "cagd-exactly-session", "run_programs"]
    tests = {**{name: [f"proofs-tests/unit/{name}"] for name in "test_harness test_border test_shares test_machine test_conditions test_decide".split()},
             "language": [sys.executable, ROOT / "proofs-tests/code/test_language.py", "./cagd-compile-exactly", "proofs-tests/code/run_programs", "-f"],
             "what is said": [sys.executable, ROOT / "proofs-tests/cli/test_exactly.py", "cagd", ROOT, "-f", "Verdicts", "Mistakes"],
             "pages": [sys.executable, ROOT / "proofs-tests/cli/test_exactly.py", "cagd", ROOT, "-f", "Page", "Certificates"],
             "formulas": [sys.executable, ROOT / "proofs-tests/cli/test_exactly.py", "cagd", ROOT, "-f", "Printed"],
             "interface": [sys.executable, ROOT / "proofs-tests/code/test_interface.py", ".", ROOT, "-f"]}
    KNOWS = {"driver": "test_harness", "conditions": "test_conditions", "polyhedron": "test_conditions", "signs": "test_conditions", "border": "test_border",
             "harness": "test_harness", "points": "test_harness", "formula": "formulas", "orders": "test_shares", "decide": "test_decide", "exactly": "interface", "resident": "interface"}

    def units(self):
        return {c: [c] for c in sources("exact/code/*.c") if not c.endswith("session.c")}

    def first(self, file):
        return self.KNOWS.get(pathlib.Path(file).stem, "language").split()


class Check(Room):
    """`cagd check`: pages and papers that are read, and what is told of them; what the ledger has as printed, by a chapter that has all of its
    verdicts."""
    configured, targets = ["-DCAGD_ONLY_CHAPTERS=fitting;shape-parameter", "-DCAGD_TYPES=RATIONAL"], ["cagd"]
    SCRIPT = Expression.SCRIPT
    tests = {"page": [sys.executable, ROOT / "proofs-tests/check/test_page.py", "cagd"], "test_statements": ["proofs-tests/unit/test_statements"], "mistakes": [*SCRIPT, "Mistakes"], "papers": Expression.LATEX,
             "what is said": [*SCRIPT, "Verdicts", "Language", "Ranges", "Pictures", "Standard"], "as papers have it": Expression.tests["as papers have it"], "bases": Expression.tests["bases"],
             "certificates": [*SCRIPT, "Certificates"], "the literature": [*SCRIPT, "Literature"],
             "the ledger": ["./cagd", "check", ROOT / "chapters/shape-parameter/print.md"]}
    KNOWS = {"paper": "papers", "document": "mistakes", "sheet": "bases", "graphs": "bases", "certificate": "certificates"}

    def units(self):
        return {c: [c] for c in sources("cli/check/*.c")}

    def first(self, file):
        return [self.KNOWS.get(pathlib.Path(file).stem, "what is said")]


class Judge(Room):
    """The judge, and the commands that report what it found."""
    tests = {name: [f"proofs-tests/unit/{name}"] for name in ("test_comparison", "test_judge", "test_judge_ends", "test_command")}

    def units(self):
        return {c: [c] for c in [*sources("chapters/judge/*.c"), *(f"cli/{name}.c" for name in "verify ledger page report junit manifest".split())]}

    def first(self, file):
        return ["test_command"] if file.startswith("cli/") or file.endswith("certificate.c") else []


class Core(Room):
    tests = {name: [f"proofs-tests/unit/{name}"] for name in
             "test_cagd_api test_spline_api test_curve_api test_exact_curve test_kernels".split()}

    def units(self):
        found = {c: [c] for c in sources("core/api/*.c")}
        found["core/api/cagd.c"] += ["core/api/checks.h"]
        found["core/api/spline.c"] += ["core/spline.tmpl.h"]
        return found


class Files(Room):
    """`cagd fit` and the files that it reads and writes."""
    configured, targets = ["-DCAGD_ONLY_CHAPTERS=fitting", "-DCAGD_TYPES=RATIONAL"], ["cagd"]
    tests = {name: [sys.executable, ROOT / "proofs-tests/cli/test_fit.py", "cagd", ROOT, "-f", *name.split()] for name in ("Mistakes", "Input", "Files", "Results Fits")}
    KNOWS = {"picture": "Files", "drawings": "Files", "dxf": "Files", "verdict": "Results Fits", "json": "Results Fits", "fit": "Results Fits"}

    def units(self):
        return {c: [c] for c in sources("cli/fit/*.c")}

    def first(self, file):
        return [self.KNOWS.get(pathlib.Path(file).stem, "Input")]


class Fit(Room):
    optimised = "-O2"
    tests = {**{name: [f"proofs-tests/unit/{name}"] for name in "test_fit_statistics test_fit_parts test_fit_monotone test_fit_choices".split()},
             "test_certified": ["proofs-tests/fit/test_certified", ROOT / "proofs-tests/fit/problems",
                                *(p.stem for p in sorted((ROOT / "proofs-tests/fit/problems").glob("*.json")) if p.stem != "twenty-thousand")],
             "test_fit": ["proofs-tests/unit/test_fit"], "test_circle": ["proofs-tests/fit/test_circle", "20"], "test_coverage": ["proofs-tests/fit/test_coverage"],
             "test_memory": ["proofs-tests/fit/test_memory"], "test_verdict": ["proofs-tests/fit/test_verdict"],
             "test_splines": ["proofs-tests/fit/test_splines"]}
    KNOWS = {"circle": "test_circle", "beneath": "test_verdict", "detour": "test_verdict", "conic": "test_verdict", "quality": "test_verdict"}

    def first(self, file):
        return [self.KNOWS[stem]] if (stem := pathlib.Path(file).stem) in self.KNOWS else []

    def units(self):
        return {c: [c] for c in sources("core/fit/*.c")}


class Kernels(Room):
    """Judged by cagd verify, and by unit tests what no claim sees."""
    optimised, targets = "-O0", ["cagd"]
    tests = {name: [f"proofs-tests/unit/{name}"] for name in ("test_overlap", "test_kernels_checked", "test_exact_curve")}

    def units(self):
        return {"exact/kernels_q.c": sources("core/kernels/*.tmpl.h")}


ROOMS = {"kernels": Kernels, "exact": Exact, "expression": Expression, "code": Code, "check": Check, "judge": Judge, "core": Core, "fit": Fit, "files": Files}


def equivalents():
    """{(file, line as it stands, line as changed)}, where * stands for every change.  A line that nobody finds any more is an error."""
    known = set()
    for line in EQUIVALENT.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            file, old, new, _ = (part.strip() for part in line.split(" | ", 3))
            if old not in {code.strip() for code in (ROOT / file).read_text().splitlines()}:
                sys.exit(f"equivalent.txt: {file} has no line '{old}'")
            known.add((file, old, new))
    return known


def include_flags(build):
    """Of an ordinary build, for reading the sources: every -I, under "", and the -D of each source."""
    path = pathlib.Path(build) / "compile_commands.json"
    text = path.read_text() if path.exists() else subprocess.run(["ninja", "-C", build, "-t", "compdb"], check=True, capture_output=True, text=True).stdout
    found, defined = {}, {}
    for entry in json.loads(text):
        at = pathlib.Path(entry["directory"])
        for word in re.findall(r"-(?:I|isystem ?)(\S+)", entry["command"]):
            found[str((at / word).resolve())] = 1
        source = (at / entry["file"]).resolve()
        if source.is_relative_to(ROOT):
            defined[str(source.relative_to(ROOT))] = [word for word in shlex.split(entry["command"]) if word.startswith("-D")]
    return {"": [f"-I{folder}" for folder in found], **defined}


def clang(root, flags, *more):
    moved = [f.replace(f"-I{ROOT}", f"-I{root}") if "/build" not in f else f for f in flags[""]]
    return ["clang", "-std=c17", "-w", "-I.", *moved, *flags.get(more[-1], []), *more]


def all_faults(room, flags, seed=""):
    """Every fault of a room with its number and its hash; faults of one name differ in which of them it is.  The seed stands before the name."""
    found, named = [], collections.Counter()
    for unit, files in room.units().items():
        command = clang(ROOT, flags, "-Xclang", "-ast-dump=json", "-fsyntax-only", unit)
        for f in planter.Planter(planter.Tree(command, ROOT, set(files))).found:
            name = " | ".join(f[key] for key in ("file", "function", "kind", "old", "new"))
            named[name] += 1
            digest = hashlib.sha256(f"{seed}{name} | {named[name]}".encode()).digest()
            found.append({**f, "unit": unit, "number": len(found) + 1, "hash": int.from_bytes(digest[:8], "big")})
    return found


def per_function(faults, most):
    """From each function as many, the kinds that were not taken yet first, among them those of the smallest hash."""
    by_function = {}
    for f in faults:
        by_function.setdefault((f["file"], f["function"]), []).append(f)
    chosen = []
    for here in by_function.values():
        own = collections.Counter()
        for _ in range(min(most, len(here))):
            f = min(here, key=lambda f: (own[f["kind"]], f["hash"]))
            here.remove(f)
            own[f["kind"]] += 1
            chosen.append(f)
    return chosen


def definitional_claims(register, chapters):
    """For each kernel the claims of these chapters that define it; of all when there are none."""
    found = {}
    for claim in register["claims"]:
        if not chapters or claim["chapter"] in chapters:
            for kernel in words(claim, "defines"):
                found.setdefault(kernel, []).append(claim["name"])
    return found


def with_what_they_name(register, chapters):
    """These chapters, and those whose claims their statements name, which are built as well."""
    home = {claim["name"]: claim["chapter"] for claim in register["claims"]}
    needed, new = set(), set(chapters)
    while new:
        needed |= new
        new = {home[name] for s in register["statements"] if s["chapter"] in new for name in claims_of(register, s)} - needed
    return [chapter["name"] for chapter in register["chapters"] if chapter["name"] in needed]


class Copy:
    """A copy of the tree, built with the switches of one list of faults at a time."""

    def __init__(self, folder, room, a, flags, register):
        self.root, self.jobs, self.room, self.flags = pathlib.Path(folder) / "tree", a.jobs, room, flags
        shutil.copytree(ROOT, self.root, ignore=shutil.ignore_patterns("build", "build-*", ".git"))
        self.original = {file: (self.root / file).read_bytes() for files in room.units().values() for file in files}
        self.tests = dict(room.tests) | (dict(room.slow) if a.slow and room.slow else {})
        configured = ["-DCAGD_ONLY_CHAPTERS=" + ";".join(with_what_they_name(register, a.chapters))] if a.chapters else []
        self.must("cmake", "-G", "Ninja", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Debug",
                  f"-DCMAKE_C_FLAGS_DEBUG={room.optimised} -w", f"-DCMAKE_CXX_FLAGS_DEBUG={room.optimised} -w",
                  "-DCAGD_TYPES=" + ";".join(a.types), *configured, *room.configured)
        self.verified = isinstance(room, Kernels)
        self.targets = sorted({words[0].split("/")[-1] for words in self.tests.values() if words[0] != sys.executable} | set(room.targets))
        self.usual, self.as_needed = {}, False

    def must(self, *command):
        r = subprocess.run(command, cwd=self.root, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if r.returncode != 0:
            raise SystemExit(r.stdout[-6000:])

    def write(self, batch):
        for file, text in self.original.items():
            here = [f for f in batch if f["file"] == file]
            planted = planter.SWITCH.encode() + planter.plant(text, here) if here else text
            if (self.root / file).read_bytes() != planted:
                (self.root / file).write_bytes(planted)

    def compiles(self, batch):
        """Those faults of a list with which the file is C: all, or those of each half."""
        if not batch:
            return []
        self.write(batch)
        r = subprocess.run(clang(self.root, self.flags, "-fsyntax-only", batch[0]["unit"]), cwd=self.root, capture_output=True)
        if r.returncode == 0:
            return batch
        if len(batch) == 1:
            return []
        return self.compiles(batch[:len(batch) // 2]) + self.compiles(batch[len(batch) // 2:])

    def build(self, batch):
        by_unit = {}
        for f in batch:
            by_unit.setdefault(f["unit"], []).append(f)
        batch = [f for here in by_unit.values() for f in self.compiles(here)]
        self.write(batch)
        self.must("cmake", "--build", "build", "-j", str(self.jobs), "--target", *self.targets)
        if self.verified:
            listed = subprocess.run(["build/cagd", "list", "--json"], cwd=self.root, check=True, capture_output=True).stdout
            self.claims = {claim["name"] for claim in json.loads(listed)["claims"]}
        return batch

    def write_given(self, fault):
        """The tree with this fault alone; whether it is C.  Of what the tests need the rest is built when their turn comes."""
        for file, text in self.original.items():
            lines = text.decode().split("\n")
            if file == fault["file"]:
                lines[fault["line"] - 1] = fault["new"]
            planted = "\n".join(lines).encode()
            if (self.root / file).read_bytes() != planted:
                (self.root / file).write_bytes(planted)
        self.as_needed = True
        first = [test for test in self.room.first(fault["file"]) if test in self.tests] or list(self.tests)
        return self.is_built("cagd" if self.verified else self.target_of(first[0]))

    def target_of(self, test):
        command = str(self.tests[test][0])
        return self.room.targets[0] if command in (sys.executable, "./cagd") else command.split("/")[-1]

    def is_built(self, *targets):
        return subprocess.run(["cmake", "--build", "build", "-j", str(self.jobs), "--target", *targets], cwd=self.root, capture_output=True).returncode == 0

    def fails(self, command, number, limit):
        with tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "CAGD_FAULT": str(number), "TMPDIR": folder}
            with subprocess.Popen(list(map(str, command)), cwd=self.root / "build", stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL, env=environment, start_new_session=True) as process:
                try:
                    return process.wait(limit) != 0
                except subprocess.TimeoutExpired:
                    os.killpg(process.pid, 9)
                    return True

    def holds_without_fault(self):
        for test, command in self.tests.items():
            start = time.monotonic()
            if self.fails(command, 0, 600):
                raise SystemExit(f"{test} fails without any fault")
            self.usual[test] = max(self.usual.get(test, 0), time.monotonic() - start)
        start = time.monotonic()
        if self.verified and self.fails(["./cagd", "verify", "--jobs", 1], 0, 3000):
            raise SystemExit("cagd verify fails without any fault")
        self.usual["verify"] = time.monotonic() - start

    def judge(self, fault, defining):
        """What notices the fault; None when nothing does."""
        if self.verified:
            claims = [claim for claim in defining.get(kernel_of(fault), []) if claim in self.claims]
            if claims and self.fails(["./cagd", "verify", "--jobs", 1, *claims], fault["number"], 5 * self.usual["verify"] + 5):
                return "its claim"
            if self.fails(["./cagd", "verify", "--jobs", 1], fault["number"], 5 * self.usual["verify"] + 5):
                return "other claims"
        first = [test for test in self.room.first(fault["file"]) if test in self.tests]
        for test in first + [test for test in self.tests if test not in first]:
            if self.as_needed and not self.is_built(self.target_of(test), *(self.room.targets if self.tests[test][0] == sys.executable else [])):
                raise SystemExit(f"{test} is not built")
            if self.fails(self.tests[test], fault["number"], 10 * self.usual[test] + 5):
                return test
        return None


def given(path, room):
    """The faults of a room that a file lists."""
    files, found = {file for files in room.units().values() for file in files}, []
    for line in path.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            place, old, new, kind = (part.strip() for part in line.split(" | ", 3))
            file, number = place.rsplit(":", 1)
            if file in files:
                lines = (ROOT / file).read_text().splitlines()
                stands = lines[int(number) - 1].strip()
                if stands != old:
                    sys.exit(f"{path}: {place} is '{stands}' and not '{old}'")
                kernels = re.findall(r"^\w.*\bG\((\w+)\)\(", "\n".join(lines[:int(number)]), re.M)
                found.append({"file": file, "line": int(number), "old": old, "new": new, "kind": kind, "function": (kernels or [""])[-1], "number": 0})
    return found


def told(outcome, f):
    return f"{outcome:20s} {f['file']}:{f['line']}: {f['function']}: {f['kind']}: {f['old']}  ->  {f['new']}"


def kernel_of(fault):
    return re.sub(r"^cagd_|_[a-z]$", "", fault["function"])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("room", choices=ROOMS)
    comma = {"type": lambda text: text.split(","), "default": []}
    parser.add_argument("--per-function", type=int)
    parser.add_argument("--one-in", type=int, metavar="N", help="only the faults whose hash is divisible by N")
    parser.add_argument("--seed", default="", metavar="WORD", help="another choice of --one-in and --per-function for each word")
    parser.add_argument("--file", **comma, help="only faults in these files; the end of the path suffices")
    parser.add_argument("--function", **comma)
    parser.add_argument("--shard", help="K/N: only the K-th of N parts")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--kinds", action="store_true", help="only count them")
    parser.add_argument("--equivalent", action="store_true")
    parser.add_argument("--again", type=pathlib.Path)
    parser.add_argument("--given", type=pathlib.Path)
    parser.add_argument("--slow", action="store_true")
    parser.add_argument("--chapters", **comma)
    parser.add_argument("--types", type=lambda text: text.split(","), default=["FIELD", "RATIONAL", "INTERVAL", "DOUBLE"])
    parser.add_argument("--register", default=USUAL, help="register.json of a build")
    a = parser.parse_args()
    register, room, known = load(a.register), ROOMS[a.room](), equivalents()
    flags = include_flags(pathlib.Path(a.register).resolve().parents[2])
    defining = definitional_claims(register, a.chapters)
    every = given(a.given, room) if a.given else all_faults(room, flags, a.seed)
    is_known = lambda f: (f["file"], f["old"], f["new"]) in known or (f["file"], f["old"], "*") in known
    chosen = [f for f in every if not a.file or f["file"].endswith(tuple(a.file))]
    chosen = [f for f in chosen if not a.function or f["function"] in a.function]
    if a.chapters:
        chosen = [f for f in chosen if kernel_of(f) in defining]
    if a.again:
        again = {re.sub(r":\d+:", ":", line, count=1) for line in a.again.read_text().splitlines() if line.startswith("SURVIVES")}
        chosen = [f for f in chosen if re.sub(r":\d+:", ":", told("SURVIVES", f), count=1) in again]
    if a.per_function:
        chosen = per_function(chosen, a.per_function)
    if a.one_in:
        chosen = [f for f in chosen if f["hash"] % a.one_in == 0]
    left_out = sum(is_known(f) for f in chosen)
    chosen = [f for f in chosen if is_known(f) == a.equivalent]
    if a.shard:
        k, n = map(int, a.shard.split("/"))
        chosen = chosen[k - 1::n]
    if not chosen:
        raise SystemExit("no fault is chosen; --file takes the end of a path, such as bezier.tmpl.h")
    if a.kinds:
        for kind, count in collections.Counter(f["kind"] for f in chosen).most_common():
            print(f"{count:6d} {kind}")
    if a.list:
        for f in chosen:
            print(told("", f).strip())
    if a.list or a.kinds:
        print(f"{len(every)} faults, {len(chosen)} chosen")
        return 0
    outcomes, kinds = collections.Counter(), set()
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(folder, room, a, flags, register)
        for f in chosen if a.given else []:
            if not copy.usual:
                copy.build([])
                copy.holds_without_fault()
            outcome = "no C" if not copy.write_given(f) else copy.judge(f, defining) or "SURVIVES"
            outcomes["no C" if outcome == "no C" else "SURVIVES" if outcome == "SURVIVES" else "caught"] += 1
            kinds.add(f["kind"])
            print(told(outcome, f), flush=True)
        for number, batch in enumerate([] if a.given else planter.batches(chosen)):
            meaningful = copy.build(batch)
            outcomes["no C"] += len(batch) - len(meaningful)
            if number == 0:
                copy.holds_without_fault()
            with concurrent.futures.ThreadPoolExecutor(a.jobs) as pool:
                for f, judge in zip(meaningful, pool.map(lambda f: copy.judge(f, defining), meaningful)):
                    outcomes["caught" if judge else "SURVIVES"] += 1
                    kinds.add(f["kind"])
                    print(told(judge or "SURVIVES", f), flush=True)
    tried = outcomes["caught"] + outcomes["SURVIVES"]
    print(f"{len(every)} faults, {len(chosen)} chosen beside {left_out} that are known to change nothing; {outcomes['no C']} are no C, {tried} of {len(kinds)} "
          f"kinds tried, {outcomes['caught']} caught, {outcomes['SURVIVES']} survive")
    return 1 if (outcomes["SURVIVES"] != (tried if a.equivalent else 0)) or not tried else 0


if __name__ == "__main__":
    sys.exit(main())
