"""Every command without memory: one request of memory is refused, alone or with all that follow, for each request in its turn.

    test_commands.py CAGD REFUSE.SO ROOT [--every | --one-in N] [--jobs N] [--only NAME...]

Asked is that the command either does without, and prints and writes what it does otherwise, or ends with exit status 3 (a reader of
files: 2) and a line on standard error that says so, where `cagd exactly` may say it of the code that it runs; every file that it was to write is then the whole file or is not there.  A crash, another result or a
part of a file is a fault.

Requests with the same twelve innermost callers are taken for one, which is tried at its first place; --every tries every
request.  --one-in N tries those whose command and number have a hash that N divides.
"""
import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

LIMIT = 120

# What is asked; OUT is the folder that files are written to.
COMMANDS = {
    "help": "--help", "help-verify": "help verify", "version": "--version", "none": "lits",
    "list": "list", "list-json": "list --json",
    "show": "show wang-ch3:prop-3.2.4-step-2", "show-claim": "show elevation_keeps_rational_curve", "show-table": "show slides-ch4:table-bezier",
    "show-json": "show wang-ch4:thm-4.3.1 --json",
    "verify": "verify elevation_keeps_rational_curve --jobs 1", "verify-json": "verify elevation_keeps_rational_curve --jobs 1 --json",
    "verify-files": "verify elevation_keeps_rational_curve --jobs 1 --junit OUT/r.xml --certificates OUT/c",
    "ledger": "ledger wang-ch3:prop-3.2.4-step-2 --jobs 1", "ledger-json": "ledger wang-ch3:prop-3.2.4-step-2 --json --jobs 1",
    "figures": "figures envelope_extra --jobs 1 --out OUT",
    "check": "check cli/check/example.md", "check-json": "check cli/check/example.md --json",
    "curve": "curve chapters/nurbs/circle.json --at 7/3 --derivatives 2", "curve-json": "curve chapters/nurbs/circle.json --json",
    "curve-insert": "curve chapters/nurbs/circle.json --insert 1/2", "curve-elevate": "curve chapters/nurbs/circle.json --elevate",
    "curve-split": "curve chapters/nurbs/circle.json --split 7/3", "curve-bezier": "curve chapters/nurbs/circle.json --bezier",
    "fit": "fit chapters/fitting/arch.csv", "fit-json": "fit chapters/fitting/arch.csv --json",
    "fit-files": "fit chapters/fitting/arch.csv --svg OUT/a.svg --residuals OUT/a.csv",
    "exactly": "exactly exact/code/example/README.md",
}


class Trial:
    def __init__(self, a, words):
        self.a, self.words = a, words

    def run(self, **environment):
        """(exit status, standard output, standard error, {file: bytes}) of the command, run in a folder of its own."""
        with tempfile.TemporaryDirectory() as out:
            words = [w.replace("OUT", out) for w in self.words]
            try:
                r = subprocess.run([self.a.cagd, *words], cwd=self.a.root, stdin=subprocess.DEVNULL, capture_output=True, timeout=LIMIT,
                                   env={**os.environ, "TMPDIR": out, **environment})
            except subprocess.TimeoutExpired:
                return None, b"", b"", {}
            files = {str(p.relative_to(out)): re.sub(rb'time="[0-9.]*"', b"", p.read_bytes()) for p in pathlib.Path(out).rglob("*") if p.is_file()}
            return r.returncode, r.stdout.replace(out.encode(), b"OUT"), r.stderr.replace(out.encode(), b"OUT"), files

    def requests(self):
        """The numbers of the requests that are tried, and how many there are."""
        with tempfile.NamedTemporaryFile() as listed:
            self.run(LD_PRELOAD=self.a.refuse, REFUSE_LIST=listed.name)
            numbers = [int(line) for line in pathlib.Path(listed.name).read_text().split()]
        return sorted(set(numbers[:-1])), numbers[-1]

    def judge(self, request, later, usual):
        """A word on how it ended, or a sentence on what is wrong."""
        with tempfile.TemporaryDirectory() as folder:
            tell = pathlib.Path(folder) / "tell"
            status, out, err, files = self.run(LD_PRELOAD=self.a.refuse, REFUSE=f"{request}{'+' if later else ''},{tell}")
            if not tell.exists():
                return "not reached"
        if status is None:
            return f"no end in {LIMIT} s"
        if (status, out, files) == (usual[0], usual[1], usual[3]):
            return "did without"
        last = err.decode(errors="replace").strip().rpartition("\n")[2]
        if status == 2 and "memory" in last:  # said of a file, by its reader
            return "ended"
        if status == 0 and b"there is not enough memory" in out:  # said of a fit
            return "ended"
        if status == 1 and self.words[0] == "exactly" and b"no memory" in out:  # said of the code that ran
            return "ended"
        if status != 3:
            return f"exit status {status} instead of {usual[0]} or 3; {last[:200]}"
        if "memory" not in err.decode(errors="replace"):
            return f"nothing about memory: {last[:200]}"
        halves = [f for f, text in files.items() if usual[3].get(f) != text]
        return f"a part of a file: {halves}" if halves else "ended"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cagd")
    parser.add_argument("refuse")
    parser.add_argument("root")
    parser.add_argument("--every", action="store_true")
    parser.add_argument("--one-in", type=int, default=1, metavar="N")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", nargs="*", metavar="NAME")
    a = parser.parse_args()
    a.cagd, a.refuse = os.path.abspath(a.cagd), os.path.abspath(a.refuse)
    wrong, start, everything = 0, time.monotonic(), 0
    for name in a.only or COMMANDS:
        trial = Trial(a, COMMANDS[name].split())
        usual = trial.run()
        numbers, all_there_are = trial.requests()
        if a.every:
            numbers = range(1, all_there_are + 1)
        digest = lambda k: int.from_bytes(hashlib.sha256(f"{name} {k}".encode()).digest()[:8], "big")
        asked = [(k, later) for k in numbers if digest(k) % a.one_in == 0 for later in (False, True)]
        ends = {}
        with concurrent.futures.ThreadPoolExecutor(a.jobs) as pool:
            for (k, later), end in zip(asked, pool.map(lambda q: trial.judge(*q, usual), asked)):
                ends[end] = ends.get(end, 0) + 1
                if end not in ("did without", "ended", "not reached"):
                    wrong += 1
                    print(f"{name}: request {k}{' and all later ones' if later else ''}: {end}")
        everything += len(asked)
        print(f"{name}: {all_there_are} requests, {len(asked)} trials: " +
              ", ".join(f"{ends[e]} {e}" for e in ("did without", "ended", "not reached") if e in ends), flush=True)
    print(f"{everything} trials, {wrong} wrong, {time.monotonic() - start:.0f} s")
    return wrong > 0 or everything == 0


if __name__ == "__main__":
    sys.exit(main())
