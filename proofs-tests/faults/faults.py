"""Planted faults: changes one operator, index, sign or constant of a kernel at a time; `cagd verify` must notice.

    faults.py [--sample N] [--seed S] [--file NAME] [--list] [--jobs N]

Each fault is one replacement at one place of core/*.tmpl.h, made in a copy of the tree, built without
optimisation and judged: first by the claims in rationals alone, which build fastest, then, if these all
hold, by all of them.  A fault that survives is a claim that nobody has written, and the exit status is 1.
equivalent.txt lists the replacements that change nothing, each with the reason.
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
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.txt")

# What is looked for, and what it becomes.  \g<...> keep what stands around.
RULES = [
    ("sum to difference", r"\badd\(", "sub("),
    ("difference to sum", r"\bsub\(", "add("),
    ("product to sum", r"\bmul\(", "add("),
    ("quotient to product", r"\bdiv\(", "mul("),
    ("sign lost", r"\bneg\(([^()]*(?:\([^()]*\))?[^()]*)\)", r"(\1)"),
    ("one to two", r"\bfrom_int\(1\)", "from_int(2)"),
    ("zero to one", r"\bfrom_int\(0\)", "from_int(1)"),
    ("two to three", r"\bfrom_int\(2\)", "from_int(3)"),
    ("numerator", r"\bfrom_ratio\(1, (\d)\)", r"from_ratio(2, \1)"),
    ("degree plus one lost", r"\bn \+ 1\b(?=\))", "n"),
    ("index one too low", r"\[\(?i \+ 1\b", lambda m: m.group(0).replace("i + 1", "i")),
    ("index not lowered", r"\[\(?(i|j|k|m) - 1\b", lambda m: m.group(0).replace(f"{m.group(1)} - 1", m.group(1))),
    ("loop one short", r"(?<=; )(i|j|k|m) <= ([^;]*);", r"\1 < \2;"),
    ("loop starts late", r"\(int (i|j|k|m) = 1;", r"(int \1 = 2;"),
    ("constant order", r"\b(root)\(2,", r"\1(1,"),
    ("binomial of the wrong row", r"\bbinomial\(n, ", "binomial(n + 1, "),
    ("binomial of the wrong row", r"\bbinomial\((k|m), ", r"binomial(\1 + 1, "),
    ("t for 1-t", r"\bmul\((s|mu), ", "mul(t, "),
    ("factor n lost", r"\bfrom_int\((n|m)\)", "from_int(1)"),
    ("sign of the factor", r"\bfrom_int\(-(m|n)\)", r"from_int(\1)"),
]


def without_comments(text):
    """The text with comments blanked, so that places keep their offsets."""
    return re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group(0)), text, flags=re.S)


def faults():
    for path in sorted((ROOT / "core").glob("*.tmpl.h")):
        text = path.read_text()
        code = without_comments(text)
        for rule, pattern, becomes in RULES:
            for m in re.finditer(pattern, code):
                new = m.expand(becomes) if isinstance(becomes, str) else becomes(m)
                if "tmpl.h" in text[text.rfind("\n", 0, m.start()) : m.end()] or new == m.group(0):
                    continue
                mutated = text[: m.start()] + new + text[m.end() :]
                line = text.count("\n", 0, m.start())
                old, now = text.splitlines()[line].strip(), mutated.splitlines()[line].strip()
                inside = re.findall(r"^static inline [^\n]*G\((\w+)\)\(", code[: m.start()], re.M)
                yield {"file": path.name, "line": line + 1, "kernel": inside[-1] if inside else "", "rule": rule,
                       "old": old, "new": now, "text": mutated}


def equivalents():
    """Lines `kernel | line as it stands | line as changed | reason`."""
    found = {}
    for line in EQUIVALENT.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            kernel, old, new, reason = [part.strip() for part in line.split(" | ")]
            found[(kernel, old, new)] = reason
    return found


class Copy:
    """A copy of the tree with two builds: the claims in rationals, and all of them."""

    def __init__(self, folder, jobs):
        self.root, self.jobs = pathlib.Path(folder) / "tree", jobs
        shutil.copytree(ROOT, self.root, ignore=shutil.ignore_patterns("build", "build-*", ".git"))
        for name, types in (("rational", "RATIONAL"), ("all", "FIELD;RATIONAL;INTERVAL;DOUBLE")):
            self.must("cmake", "-G", "Ninja", "-S", ".", "-B", f"build/{name}", "-DCMAKE_BUILD_TYPE=Debug",
                      "-DCMAKE_C_FLAGS_DEBUG=-O0", "-DBUILD_TESTING=OFF", f"-DCAGD_TYPES={types}")

    def must(self, *command):
        subprocess.run(command, cwd=self.root, check=True, stdout=subprocess.DEVNULL)

    def verdict(self, name):
        """caught, not caught, or not compiled."""
        built = subprocess.run(["cmake", "--build", f"build/{name}", "--target", "cagd", "-j", str(self.jobs)],
                               cwd=self.root, capture_output=True)
        if built.returncode != 0:
            return "not compiled"
        try:
            r = subprocess.run([f"build/{name}/cagd", "verify"], cwd=self.root, capture_output=True, timeout=300)
        except subprocess.TimeoutExpired:
            return "caught"
        return "not caught" if r.returncode == 0 else "caught"

    def judge(self, fault):
        path = self.root / "core" / fault["file"]
        before = path.read_text()
        path.write_text(fault["text"])
        outcome = self.verdict("rational")
        if outcome == "not caught":
            outcome = self.verdict("all")
        path.write_text(before)
        return outcome


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, help="only N faults, chosen at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--file", help="only faults of this template")
    parser.add_argument("--shard", help="K/N: only the K-th of N parts")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    a = parser.parse_args()
    known = equivalents()
    every = [f for f in faults() if a.file in (None, f["file"])]
    chosen = [f for f in every if (f["kernel"], f["old"], f["new"]) not in known]
    if a.sample:
        chosen = random.Random(a.seed).sample(chosen, min(a.sample, len(chosen)))
    if a.shard:
        k, n = map(int, a.shard.split("/"))
        chosen = chosen[k - 1 :: n]
    if a.list:
        for f in chosen:
            print(f"{f['file']}:{f['line']}: {f['kernel']}: {f['rule']}: {f['new']}")
        return 0
    survivors = compiled = 0
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(folder, a.jobs)
        for name in ("rational", "all"):
            if copy.verdict(name) != "not caught":
                print("cagd verify fails without any fault")
                return 1
        for f in chosen:
            outcome = copy.judge(f)
            compiled += outcome != "not compiled"
            survivors += outcome == "not caught"
            print(f"{'SURVIVES' if outcome == 'not caught' else outcome:12s} {f['file']}:{f['line']}: {f['kernel']}: "
                  f"{f['rule']}: {f['new']}", flush=True)
    print(f"{len(every)} faults, {len(every) - len(chosen)} left out; {compiled} compiled, {survivors} survive")
    return 1 if survivors or not compiled else 0


if __name__ == "__main__":
    sys.exit(main())
