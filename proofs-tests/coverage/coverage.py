"""Which statements and branches of exact, the judge and core the unit tests and the tests of formulas, of code and of fits reach, by gcov.

    coverage.py [--jobs N] [--lines] [--keep]

Builds the unit tests and cagd, with one chapter, in build/coverage at -O0 with --coverage, runs the tests, also those of `cagd check`,
of code that is run exactly and of `cagd fit`, and the inputs that are kept for the fuzzers, and prints for every file the statements and branches that were reached, and how many there are; a line of a template or a header counts once, reached in whatever number type.  Then the lines
that nothing reached: with --lines all of them, otherwise those for which unreached.txt has no reason.  --keep reads what the last
run left, of the files that have not changed since.  Not a test; about fifteen minutes of processor time.
"""
import argparse
import collections
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/coverage"
ROOMS = ("exact/", "chapters/judge/", "core/")
LEFT_OUT = {"test_svg"}  # figures are none of these rooms
FITS = {"test_certified": [ROOT / "proofs-tests/fit/problems"], "test_memory": [], "test_splines": [], "test_verdict": [], "test_circle": ["10"]}
FUZZED = ("curve", "formula", "harness", "latex", "number")  # whose readers are of these rooms


# A process of exact/code ends by _exit, which keeps no counts: the linker puts this in its place.
ENDING = """void __gcov_dump(void);
_Noreturn void __real__exit(int status);
_Noreturn void __wrap__exit(int status);
_Noreturn void __wrap__exit(int status)
{
    __gcov_dump();
    __real__exit(status);
}
"""


def must(*command):
    r = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if r.returncode != 0:
        sys.exit(r.stdout[-4000:])


def reasons():
    """[(file or *, the line or a part of it, or with < before it the line that it hangs on, the reason)]"""
    text = pathlib.Path(__file__).with_name("unreached.txt").read_text()
    return [tuple(part.strip() for part in line.split(" | ", 2)) for line in text.splitlines() if line.strip() and not line.startswith("#")]


def run_tests(jobs):
    tests = sorted({p.stem for p in (ROOT / "proofs-tests/unit").glob("test_*.c")} - LEFT_OUT)
    BUILD.mkdir(parents=True, exist_ok=True)
    (BUILD / "ending.c").write_text(ENDING)
    must("cc", "-c", str(BUILD / "ending.c"), "-o", str(BUILD / "ending.o"))
    must("cmake", "-G", "Ninja", "-S", ".", "-B", str(BUILD), "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_C_FLAGS_DEBUG=-O0 -w --coverage",
         "-DCMAKE_CXX_FLAGS_DEBUG=-O0 -w --coverage", "-DCAGD_TYPES=RATIONAL", "-DCAGD_ONLY_CHAPTERS=fitting", "-DCAGD_REPLAY=ON",
         f"-DCMAKE_EXE_LINKER_FLAGS_DEBUG=-Wl,--wrap=_exit {BUILD / 'ending.o'}")
    programs = ["cagd", "run_programs", "cagd-compile-exactly", "cagd-exactly-session", *FITS,
                *(f"fuzz_{name}" for name in FUZZED)]
    must("cmake", "--build", str(BUILD), "-j", str(jobs), "--target", *tests, *programs)
    for old in BUILD.rglob("*.gcda"):
        old.unlink()
    for test in tests:
        r = subprocess.run([BUILD / "proofs-tests/unit" / test], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if r.returncode != 0:
            sys.exit(f"{test} fails")
    cagd, fit = BUILD / "cagd", BUILD / "proofs-tests/fit"
    python = lambda script, *arguments: [sys.executable, ROOT / "proofs-tests" / script, *arguments]
    others = [python("check/test_check.py", cagd), python("check/test_latex.py", cagd), python("check/test_basis.py", cagd),
              python("cli/test_exactly.py", cagd, ROOT), python("cli/test_fit.py", cagd, ROOT),
              python("code/test_language.py", BUILD / "cagd-compile-exactly", BUILD / "proofs-tests/code/run_programs"),
              python("code/test_interface.py", BUILD, ROOT), python("fit/test_real.py", cagd), python("fit/kinds.py", cagd),
              *([BUILD / f"proofs-tests/fuzz/fuzz_{name}", *sorted((ROOT / "proofs-tests/fuzz/corpus" / name).iterdir())] for name in FUZZED),
              python("labs/test_labs.py", cagd, ROOT), *([fit / name, *arguments] for name, arguments in FITS.items())]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:  # whatever they say of a program that is so slow and has one chapter, it has run
        list(pool.map(lambda command: subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL), others))
    return len(tests) + len(others)


def counts():
    """{file: {line: [how often, [how often each branch]]}}, added up over all units."""
    found = collections.defaultdict(dict)
    for data in BUILD.rglob("*.gcda"):
        r = subprocess.run(["gcov", "--json-format", "--stdout", "--branch-probabilities", str(data)], cwd=BUILD, check=True,
                           capture_output=True, text=True)
        for unit in map(json.loads, r.stdout.splitlines()):
            for file in unit["files"]:
                path = (pathlib.Path(unit["current_working_directory"]) / file["file"]).resolve()
                if not path.is_relative_to(ROOT) or not str(path.relative_to(ROOT)).startswith(ROOMS):
                    continue
                lines = found[str(path.relative_to(ROOT))]
                for line in file["lines"]:
                    have = lines.setdefault(line["line_number"], [0, []])
                    have[0] += line["count"]
                    for k, branch in enumerate(line["branches"]):
                        have[1] += [0] * (k + 1 - len(have[1]))
                        have[1][k] += branch["count"]
    return found


def hangs_on(text, number):
    """The line above, of less indentation: the condition under which that line runs."""
    indentation = lambda line: len(line) - len(line.lstrip())
    above = (line for line in reversed(text[:number - 1]) if line.strip() and indentation(line) < indentation(text[number - 1]))
    return next(above, "").strip()


def reason_for(file, text, number, known):
    line, condition = text[number - 1].strip(), hangs_on(text, number)
    return next((reason for path, part, reason in known if path in ("*", file) and
                 (part[2:] in condition if part.startswith("< ") else part in line)), None)


def share(reached, all_there_are):
    return f"{reached:6d} of {all_there_are:6d} {100 * reached / max(all_there_are, 1):6.1f} %"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--lines", action="store_true")
    parser.add_argument("--keep", action="store_true")
    a = parser.parse_args()
    start, known = time.monotonic(), reasons()
    tests = 0 if a.keep else run_tests(a.jobs)
    found, total = counts(), collections.defaultdict(lambda: [0, 0, 0, 0])
    unreached, reasoned, changed = [], 0, []
    last_run = (BUILD / "ending.o").stat().st_mtime
    for file in sorted(found):
        text, lines = (ROOT / file).read_text().splitlines(), found[file]
        if max(lines) > len(text) or (a.keep and (ROOT / file).stat().st_mtime > last_run):
            changed.append(file)
            continue
        branches = [b for _, line in lines.values() for b in line]
        row = [sum(n > 0 for n, _ in lines.values()), len(lines), sum(b > 0 for b in branches), len(branches)]
        for name in (file, next(room for room in ROOMS if file.startswith(room))):
            total[name] = [x + y for x, y in zip(total[name], row)]
        for number in sorted(n for n, (times, _) in lines.items() if times == 0):
            line = text[number - 1].strip()
            why = reason_for(file, text, number, known)
            reasoned += why is not None
            if a.lines or why is None:
                unreached.append(f"{file}:{number}: {line}" + (f"   [{why}]" if why else ""))
    for name in sorted(total, key=lambda n: (n not in ROOMS, n)):
        print(f"{name:44s} statements {share(*total[name][:2])}   branches {share(*total[name][2:])}")
    print(*unreached, *(f"{file}: has changed since the tests ran, and is left out" for file in changed), sep="\n")
    print(f"{len(unreached) - (reasoned if a.lines else 0)} lines that nothing reached have no reason, {reasoned} have one; "
          f"{tests} tests in {time.monotonic() - start:.0f} s")


if __name__ == "__main__":
    main()
