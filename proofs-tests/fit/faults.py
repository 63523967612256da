"""Planted faults in core/fit: one sign, index, factor or condition at a time; the tests of the fit must notice.

    faults.py BUILD [--sample N] [--seed S] [--list]

BUILD is a configured build of this tree; it says how a copy is configured.  In a copy of the tree every fault is put in by itself, the library and
the tests are built, and fit-certified (without the largest problem), the unit tests of the fit and fit-coverage run until one of them
fails, crashes or takes ten times its usual time.  A fault that survives is listed, and the exit status is 1.
"""
import argparse
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
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
# Where a fault changes how long the way is, not where it ends, or what is allocated, tests of the answer cannot see it.
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
                found.append({"file": path.relative_to(ROOT), "line": line + 1, "rule": rule, "text": mutated,
                              "old": old.strip(), "new": mutated.splitlines()[line].strip()})
    return found


def outcome(command, limit):
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=limit).returncode
    except subprocess.TimeoutExpired:
        return "time"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--sample", type=int, default=30)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()
    every = faults()
    chosen = random.Random(arguments.seed).sample(every, min(arguments.sample, len(every)))
    if arguments.list:
        for f in chosen:
            print(f"{f['file']}:{f['line']}  {f['rule']}: {f['old']}  ->  {f['new']}")
        print(f"{len(every)} faults")
        return 0
    cache = (arguments.build / "CMakeCache.txt").read_text()
    kept = re.findall(r"^((?:CMAKE_C|CMAKE_CXX)_COMPILER(?:_LAUNCHER)?):\w+=(.+)$", cache, re.M)
    survivors = []
    with tempfile.TemporaryDirectory() as folder:
        tree = pathlib.Path(folder) / "tree"
        shutil.copytree(ROOT, tree, ignore=shutil.ignore_patterns("build", "build-*", ".git"))
        subprocess.run(["cmake", "-G", "Ninja", "-S", tree, "-B", tree / "build", "-DCAGD_TYPES=RATIONAL"] +
                       [f"-D{name}={value}" for name, value in kept], check=True, stdout=subprocess.DEVNULL)
        build = ["cmake", "--build", tree / "build", "-j1", "--target", "test_certified", "test_coverage"]
        units = [name for name in ("test_fit", "test_fit_statistics") if (ROOT / f"proofs-tests/unit/{name}.c").exists()]
        programs = tree / "build/proofs-tests"
        names = [p.stem for p in sorted((ROOT / "proofs-tests/fit/problems").glob("*.json")) if p.stem != "twenty-thousand"]
        certified = [programs / "fit/test_certified", ROOT / "proofs-tests/fit/problems"]
        judges = [(certified, 120)]
        judges += [([programs / "unit" / unit], 120) for unit in units]
        judges += [([programs / "fit/test_coverage"], 240)]
        subprocess.run(build + units, check=True, stdout=subprocess.DEVNULL)
        certified += [name for name in names if outcome(certified + [name], 60) == 0]
        quiet = [k for k, (command, limit) in enumerate(judges) if outcome(command, limit) == 0]
        print(f"{len(certified) - 2} of {len(names)} problems and {len(quiet)} of {len(judges)} tests hold without a fault, and judge",
              flush=True)
        for f in chosen:
            target, text = tree / f["file"], (tree / f["file"]).read_text()
            target.write_text(f["text"])
            what = "does not build"
            if outcome(build + units, 600) == 0:
                what = next((f"noticed by {judges[k][0][0].name}" for k in quiet if outcome(*judges[k]) != 0), "SURVIVES")
            target.write_text(text)
            print(f"{what}: {f['file']}:{f['line']}  {f['rule']}: {f['old']}  ->  {f['new']}", flush=True)
            if what == "SURVIVES":
                survivors.append(f)
    print(f"{len(chosen)} faults of {len(every)}, {len(survivors)} survive")
    return len(survivors) > 0


if __name__ == "__main__":
    sys.exit(main())
