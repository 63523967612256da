"""Feeds the readers with libFuzzer, under AddressSanitizer and UndefinedBehaviorSanitizer, from the corpora that are kept.

    fuzz.py [--runs N] [--keep FOLDER] [--from ROUND] [NAME...]

Builds the preset `fuzz` and runs every fuzzer N times, 20 000 if nothing is said: some seconds each.  With --keep the inputs
that reach something new are kept in FOLDER/NAME, and what was found wrong in FOLDER/NAME-crash-...; otherwise they are forgotten.
The exit status is 1 when a fuzzer found something, 2 when it was ended before: then the round under way does not
count.  executions.txt is the record of the longest runs.

What is fuzzed is the reading.  Long inputs take long and say little more: four rounds of five have inputs of at most 256 bytes, the
others those of the corpus and of libFuzzer's own limit.  Words that are written in a reader's source are its dictionary.  What
is computed with what was read is computed for one input in 64 (file.h).  A file of formulas has smaller limits than elsewhere,
and what commands of LaTeX stand for grows less; such inputs reach them (CAGD_SMALL_LIMITS).  Weave and the parser of arguments free nothing where they give up, so no round of theirs is longer
than 100 000 runs.  The number of a round is its seed: --from goes on where a run before with the same folder was ended.
"""
import argparse
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
LONGEST_ROUND, ROUNDS, SHORT = 100000, 5, 256
LONGEST_ROUND_OF = {"formula": 400000, "latex": 400000}
WORDS_OF = {
    "arguments": ["cli/options.c", "cli/fit/options.c"],
    "blocks": ["chapters/weave/*.c"],
    "curve": ["cli/curve_json.c"],
    "formula": ["cli/check/document.c", "exact/expression/read*.c", "exact/expression/token.c", "exact/expression/standard.c"],
    "harness": ["exact/code/harness.c", "exact/code/points.c", "exact/code/formula.c"],
    "latex": ["cli/check/document.c", "cli/check/paper.c", "exact/expression/latex*.c"],
    "number": [],
    "patterns": ["cli/names.c", "cli/select.c"],
    "points": ["cli/fit/points.c", "cli/fit/table.c", "cli/fit/json_points.c", "cli/fit/drawings.c", "cli/fit/dxf.c", "cli/fit/tags.c"],
}


def dictionary(name):
    """The words between quotation marks in the sources of a reader, a line each as libFuzzer wants them."""
    words = set()
    for pattern in WORDS_OF[name]:
        for path in ROOT.glob(pattern):
            text = re.sub(r"^#.*$", "", path.read_text(), flags=re.M)
            words.update(re.findall(r'"((?:[!#-$&-\[\]-~]|\\\\){2,24})"', text))
    return "".join(f'"{w}"\n' for w in sorted(words))


def fuzz(program, name, folder, words, runs, number):
    """One round: how many inputs were run, whether something was found, and what the fuzzer said."""
    length = [] if number % ROUNDS == 1 else [f"-max_len={SHORT}"]
    options = "detect_leaks=0:malloc_context_size=0:quarantine_size_mb=8"
    r = subprocess.run([program, f"-runs={runs}", f"-seed={number}", *length, *[f"-dict={words}"] * (words.stat().st_size > 0), "-entropic=0", "-timeout=60", "-close_fd_mask=1",
                        f"-artifact_prefix={folder}-", "-rss_limit_mb=4000", folder, HERE / "corpus" / name],
                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                       env={**os.environ, "ASAN_OPTIONS": options, "UBSAN_OPTIONS": "print_stacktrace=1"})
    text = r.stderr.decode(errors="replace")
    ran = re.findall(r"^Done (\d+) runs", text, re.M)
    return int(ran[-1]) if ran else 0, r.returncode != 0 or not ran, text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=20000)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--from", type=int, default=1, dest="first", metavar="ROUND")
    parser.add_argument("name", nargs="*")
    a = parser.parse_args()
    names = a.name or sorted(p.stem.removeprefix("fuzz_") for p in HERE.glob("fuzz_*.c"))
    build = ROOT / "build/fuzz"
    if not (build / "build.ninja").exists():
        subprocess.run(["cmake", "--preset", "fuzz"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", build, "-j2", "--target", *(f"fuzz_{n}" for n in names)], check=True, stdout=subprocess.DEVNULL)
    bad = ended = 0
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    with tempfile.TemporaryDirectory() as temporary:
        for name in names:
            folder = (a.keep or pathlib.Path(temporary)) / name
            folder.mkdir(parents=True, exist_ok=True)
            words = pathlib.Path(temporary) / f"{name}.words"
            words.write_text(dictionary(name))
            done, number, start, found = 0, a.first - 1, time.monotonic(), False
            while done < a.runs and not found and not ended:
                number += 1
                share = min(LONGEST_ROUND_OF.get(name, LONGEST_ROUND), -(-a.runs // ROUNDS), a.runs - done)
                try:
                    ran, found, text = fuzz(build / f"proofs-tests/fuzz/fuzz_{name}", name, folder, words, share, number)
                    done += ran
                except KeyboardInterrupt:
                    ended = 1
            print(f"{name}: {done} executions, {'something found' if found else 'nothing found'}{', ended before' if ended else ''} ({time.monotonic() - start:.0f} s)", flush=True)
            if found:
                print(text[-3000:])
            bad += found
            if ended:
                return 2
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
