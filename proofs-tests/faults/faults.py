"""Planted faults: changes one operator, index, sign or constant of a kernel at a time; `cagd verify` must notice.

    faults.py [--sample N] [--seed S] [--file NAME] [--chapters LIST] [--types LIST] [--shard K/N] [--list] [--jobs N]

Each fault is one replacement at one place of core/kernels/*.tmpl.h.  In a copy of the tree every place gets a switch that
chooses, when the program runs, between what stands there and the fault; the switch of one fault is on when the
environment names its number.  So one build holds as many faults as do not overlap.  A fault is judged first by the
claims that define its kernel, then, if these all hold, by all claims.  A fault that survives is a claim that
nobody has written, and the exit status is 1.  With --chapters only these chapters are built, with those whose claims
they name, for faults in the kernels that they define; with --types only these number types.  equivalent.txt lists the replacements that change nothing, each with the
reason.
"""
import argparse
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "proofs-tests/scripts"))
from register import USUAL, claims_of, load, words  # noqa: E402
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.txt")


def token(now):
    """A word becomes another one of the same use."""
    return lambda m: (now, f"(ON ? {now} : {m.group(0)})")


def value(now):
    """An expression that is complete in itself becomes another one."""
    return lambda m: (m.expand(now), f"(ON ? {m.expand(now)} : {m.group(0)})")


def part(was, now, switched):
    """Within the match the text `was` becomes `now`; `switched` means the first with ON = 0, the second with ON = 1."""
    return lambda m: tuple(re.sub(was, to, m.group(0), count=1) for to in (now, switched))


# What is looked for, and what it becomes: the text with the fault, and that with the switch ON in it.
RULES = [
    ("sum to difference", r"\badd(?=\()", token("sub")),
    ("difference to sum", r"\bsub(?=\()", token("add")),
    ("product to sum", r"\bmul(?=\()", token("add")),
    ("quotient to product", r"\bdiv(?=\()", token("mul")),
    ("sign lost", r"\bneg\(([^()]*(?:\([^()]*\))?[^()]*)\)", value(r"(\1)")),
    ("one to two", r"\bfrom_int\(1\)", value("from_int(2)")),
    ("zero to one", r"\bfrom_int\(0\)", value("from_int(1)")),
    ("two to three", r"\bfrom_int\(2\)", value("from_int(3)")),
    ("numerator", r"\bfrom_ratio\(1, (\d)\)", value(r"from_ratio(2, \1)")),
    ("degree plus one lost", r"\b[np] \+ 1\b(?=\))", part(r" \+ 1", "", " + !ON")),
    ("index one too low", r"\[\(?[a-z]\w* \+ 1\b", part(r" \+ 1", "", " + !ON")),
    ("index not lowered", r"\[\(?[a-z]\w* - 1\b", part(" - 1", "", " - !ON")),
    ("knot one too far", r"\bu\[i \+ [kp]\b", part("$", " + 1", " + ON")),
    ("span one too far", r"\bmu - p\b", part("$", " + 1", " + ON")),
    ("loop one short", r"(?<=; )[a-z]\w* <=", part(" <=", " <", " + ON <=")),
    ("loop starts late", r"\(int [a-z]\w* = 1;", part("1;", "2;", "1 + ON;")),
    ("constant order", r"\broot\(2,", part("2", "1", "2 - ON")),
    ("binomial of the wrong row", r"\bbinomial\([a-z],", part(",", " + 1,", " + ON,")),
    ("t for 1-t", r"(?<=\bmul\()(?:s|mu)(?=, )", token("t")),
    ("factor n lost", r"\bfrom_int\([a-z]\)", value("from_int(1)")),
    ("sign of the factor", r"\bfrom_int\(-(m|n)\)", value(r"from_int(\1)")),
]

SWITCH = """#ifndef CAGD_FAULT_SWITCH
#define CAGD_FAULT_SWITCH
#include <stdlib.h>
static inline int fault_is(int number)
{
    static int planted = -1;
    if (planted < 0) {
        const char *text = getenv("CAGD_FAULT");
        planted = text == NULL ? 0 : atoi(text);
    }
    return number == planted;
}
#endif
"""


def without_comments(text):
    """The text with comments blanked, so that places keep their offsets."""
    return re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m.group(0)), text, flags=re.S)


def faults():
    found = []
    for path in sorted((ROOT / "core/kernels").glob("*.tmpl.h")):
        text = path.read_text()
        code = without_comments(text)
        for rule, pattern, becomes in RULES:
            for m in re.finditer(pattern, code):
                new, switched = becomes(m)
                mutated = text[: m.start()] + new + text[m.end() :]
                line = text.count("\n", 0, m.start())
                old, now = text.splitlines()[line].strip(), mutated.splitlines()[line].strip()
                inside = re.findall(r"^KERNEL [^\n]*G\((\w+)\)\(", code[: m.start()], re.M)
                number = len(found) + 1
                found.append({"number": number, "file": path.name, "line": line + 1, "start": m.start(),
                              "end": m.end(), "kernel": inside[-1] if inside else "", "rule": rule, "old": old,
                              "new": now, "text": mutated, "switched": switched.replace("ON", f"fault_is({number})")})
    return found


def equivalents():
    """Lines `kernel | line as it stands | line as changed | reason`."""
    found = {}
    for line in EQUIVALENT.read_text().splitlines():
        if line.strip() and not line.startswith("#"):
            kernel, old, new, reason = [part.strip() for part in line.split(" | ")]
            found[(kernel, old, new)] = reason
    return found


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


def batches(chosen):
    """The faults in as few lists as it takes for no two of a list to overlap."""
    lists = []
    for f in sorted(chosen, key=lambda f: (f["file"], f["start"])):
        for batch in lists:
            if batch[-1]["file"] != f["file"] or batch[-1]["end"] <= f["start"]:
                batch.append(f)
                break
        else:
            lists.append([f])
    return lists


class Copy:
    """A copy of the tree, built with the switches of one list of faults at a time."""

    def __init__(self, folder, jobs, chapters, types):
        self.root, self.jobs = pathlib.Path(folder) / "tree", str(jobs)
        shutil.copytree(ROOT, self.root, ignore=shutil.ignore_patterns("build", "build-*", ".git"))
        self.original = {path.name: path.read_text() for path in (self.root / "core/kernels").glob("*.tmpl.h")}
        self.must("cmake", "-G", "Ninja", "-S", ".", "-B", "build", "-DCMAKE_BUILD_TYPE=Debug",
                  "-DCMAKE_C_FLAGS_DEBUG=-O0", "-DBUILD_TESTING=OFF", "-DCAGD_TYPES=" + ";".join(types),
                  *(["-DCAGD_CHAPTERS=" + ";".join(chapters)] if chapters else []))

    def must(self, *command):
        r = subprocess.run(command, cwd=self.root, stdout=subprocess.PIPE, text=True)
        if r.returncode != 0:
            raise SystemExit(r.stdout)

    def compiles(self, fault):
        """Whether the kernels are C with this fault, as it would be written: seen by the double instance."""
        path = self.root / "core/kernels" / fault["file"]
        path.write_text(fault["text"])
        r = subprocess.run(["cc", "-std=c17", "-fsyntax-only", "-I.", "-include", "core/kernels/kernels_d.h", "-include",
                            "core/kernels/span.h", "-x", "c", "/dev/null"], cwd=self.root, capture_output=True)
        path.write_text(self.original[fault["file"]])
        return r.returncode == 0

    def build(self, batch):
        for name, text in self.original.items():
            for f in sorted((f for f in batch if f["file"] == name), key=lambda f: -f["start"]):
                text = text[: f["start"]] + f["switched"] + text[f["end"] :]
            (self.root / "core/kernels" / name).write_text(SWITCH + text)
        self.must("cmake", "--build", "build", "--target", "cagd", "-j", self.jobs)
        listed = subprocess.run(["build/cagd", "list", "--json"], cwd=self.root, check=True, capture_output=True).stdout
        self.claims = {claim["name"] for claim in json.loads(listed)["claims"]}

    def holds(self, number, *patterns):
        """Whether these claims, or all, are as expected with this fault; 0 is none.  A crash is no success."""
        try:
            r = subprocess.run(["build/cagd", "verify", "--jobs", self.jobs, *patterns], cwd=self.root,
                               capture_output=True, timeout=300 if number else 3000, env={**os.environ, "CAGD_FAULT": str(number)})
        except subprocess.TimeoutExpired:
            return False
        if r.returncode == 2:
            raise RuntimeError(r.stderr.decode())
        return r.returncode == 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sample", type=int, help="only N faults, chosen at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--file", action="append", help="only faults of this template; repeatable")
    parser.add_argument("--chapters", type=lambda text: text.split(","), default=[], help="such as bezier,nurbs")
    parser.add_argument("--types", type=lambda text: text.split(","), default=["FIELD", "RATIONAL", "INTERVAL", "DOUBLE"])
    parser.add_argument("--register", default=USUAL, help="register.json of a build")
    parser.add_argument("--shard", help="K/N: only the K-th of N parts")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--jobs", type=int, default=2)
    a = parser.parse_args()
    register = load(a.register)
    known, defining = equivalents(), definitional_claims(register, a.chapters)
    every = [f for f in faults() if a.file is None or f["file"] in a.file]
    chosen = [f for f in every if (f["kernel"], f["old"], f["new"]) not in known]
    if a.chapters:
        chosen = [f for f in chosen if f["kernel"] in defining]
    if a.sample:
        chosen = random.Random(a.seed).sample(chosen, min(a.sample, len(chosen)))
    if a.shard:
        k, n = map(int, a.shard.split("/"))
        chosen = chosen[k - 1 :: n]
    if not chosen:
        raise SystemExit("no fault is chosen; --file takes the whole name, such as bezier.tmpl.h")
    if a.list:
        for f in chosen:
            print(f"{f['file']}:{f['line']}: {f['kernel']}: {f['rule']}: {f['new']}")
        return 0
    compiled = by_definition = survivors = 0
    with tempfile.TemporaryDirectory() as folder:
        copy = Copy(folder, a.jobs, with_what_they_name(register, a.chapters), a.types)
        meaningful = []
        for f in chosen:
            if copy.compiles(f):
                meaningful.append(f)
            else:
                print(f"{'no C':12s} {f['file']}:{f['line']}: {f['kernel']}: {f['rule']}: {f['new']}", flush=True)
        for batch in batches(meaningful):
            copy.build(batch)
            if not copy.holds(0):
                print("cagd verify fails without any fault")
                return 1
            for f in batch:
                # A claim may have no body in the number types that were built.
                claims = [claim for claim in defining.get(f["kernel"], []) if claim in copy.claims]
                began = time.monotonic()
                outcome = "SURVIVES"
                if claims and not copy.holds(f["number"], *claims):
                    outcome = "by its claim"
                elif not copy.holds(f["number"]):
                    outcome = "by others"
                compiled += 1
                by_definition += outcome == "by its claim"
                survivors += outcome == "SURVIVES"
                print(f"{outcome:12s} {f['file']}:{f['line']}: {f['kernel']}: {f['rule']}: {f['new']} "
                      f"({time.monotonic() - began:.1f} s)", flush=True)
    print(f"{len(every)} faults, {len(every) - len(chosen)} left out; {compiled} compiled, {by_definition} caught by the "
          f"claims that define the kernel, {compiled - by_definition - survivors} by others, {survivors} survive")
    return 1 if survivors or not compiled else 0


if __name__ == "__main__":
    sys.exit(main())
