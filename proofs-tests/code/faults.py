"""Faults planted in copies of a library that others wrote: is each one found that changes the mathematics?  Not a test: see foreign.py.

    python3 faults.py CAGD CAGD-COMPILE-EXACTLY FOLDER [COUNT [SEED [FILE...]]]

In FOLDER/exactly, copies of source files of SISL and GSL get one fault each: an operator, a comparison, an index or a constant is another one, in
a line that runs.  Who says what a fault changes is apart from what is tried: gcc compiles the copy and the original, and both run in
binary64 at 3000 points (the parameter also at the knots); the fault changes the mathematics if a number differs by more than 1e-6 of
its size, is none, or the program ends otherwise (by the address sanitizer, or after ten seconds).  Found it is if `cagd exactly` does not
say "proved": it differs at a point, or refuses what has no value; a bound that was met does not count."""
import concurrent.futures
import itertools
import math
import random
import re
import subprocess
import sys

import foreign_rows
import foreign_sources

SEED, POINTS, WORST = 1, 3000, 1e-6  # the seed is that of the points; faults are chosen by the one that is asked for
# Which row asks for which file: small ones, that each use all of it that they can.
PLANTED = {"s1219.c": ["s1219_from_0", "s1219_from_3", "s1219_from_5"], "s1220.c": ["s1220_degree_2", "s1221_degree_3"], "s1221.c": ["s1221_degree_2"],
           "s1227.c": ["s1227_degree_2"], "s6ratder.c": ["s1221_rational_degree_1"], "s1018.c": ["s1018_degree_2"],
           # the second choice
           "s1421.c": ["s1421_degree_2"], "s1730.c": ["s1730_full_ends_degree_2"], "s1701.c": ["s1730_full_ends_degree_2"],
           "bspline.c": ["gsl_bspline_deriv_eval_degree_2", "gsl_bspline_eval_degree_3"]}
FAULTS = [(r" \+ | \+(?=\w)", " - "), (r"(?<=[\w\)\]]) ?- ?(?=\w)", " + "), (r"(?<=[\w\)\]]) ?\* ?(?=[\w(])", " + "), (r"(?<=[\w\)\]]) ?/ ?(?=[\w(])", " * "),
          (r"<=", "<"), (r"(?<=\w) ?< ?(?=\w)", " <= "), (r">=", ">"), (r"==", "!="), (r"\+=", "-="), (r"\*=", "/="),
          (r"(?<=[\w\)])\]", "+1]"), (r"(?<=\w)\]", "-1]"), (r"(?<![\w.])0(?![\w.])", "1"), (r"(?<![\w.])1(?![\w.])", "2"),
          (r"(?<![\w.])[12](?![\w.])", "0"), (r"\bmin\(", "max("), (r"\bmax\(", "min("), (r"&&", "||")]


def point(inputs, chance):
    """Numbers for the inputs of a row, in their order."""
    known, numbers = {}, []

    def end(text):
        name, _, index = text.strip(" [](").partition("[")
        if name in known:
            return known[name][int(index) if index else 0]
        over, _, under = name.partition("/")
        return float(over) / float(under or 1)
    for part in inputs.split(";"):
        name, count, said = re.fullmatch(r"\s*(\w+)(?:\[(\d+)\])?\s*(.*)", part).groups()
        values = list(map(float, said[1:].split())) if said.startswith("=") else []
        for _ in range(int(count or 1) - len(values)):
            if said.startswith("in "):
                low, high = map(end, said[2:].strip()[1:-1].split(","))
                at_knots = [k for k in known.get("k", known.get("x", [])) if low < k < high] if not count else []
                if said.rstrip().endswith("]"):
                    at_knots += [high]
                if said[2:].strip()[0] == "[":
                    at_knots += [low]
                values.append(chance.choice(at_knots) if at_knots and chance.random() < 0.4 else chance.uniform(low, high))
            else:
                values.append(chance.uniform(-3, 3))
        if said == "increasing":
            values = list(itertools.accumulate(0.1 + chance.random() for _ in values))
        known[name] = values
        numbers += values
    return numbers


class Native:
    """A row in binary64: what the original gives at the points, and whether a copy gives something else."""

    def __init__(self, shop, row, archive):
        self.shop, self.row, self.archive = shop, row, archive
        chance = random.Random(SEED)
        self.points = "\n".join(" ".join(map(repr, point(row.inputs, chance))) for _ in range(POINTS))
        read, told = "", ""
        for name, count in re.findall(r"(?:^|;)\s*(\w+)(?:\[(\d+)\])?", row.inputs):
            read += f"double {name}{f'[{count}]' if count else ''}; for (int i_ = 0; i_ < {count or 1}; i_++) " \
                    f"if (scanf(\"%lf\", {name} + i_) != 1) return 0; " if count else f"double {name}; if (scanf(\"%lf\", &{name}) != 1) return 0; "
        for e in row.expected:
            left = e.split(" = ")[0]
            array = re.fullmatch(r"(\w+)\[(\d+)\]", left)
            told += f"for (int i_ = 0; i_ < {array[2]}; i_++) printf(\"%.17g \", {array[1]}[i_]); " if array else f"printf(\"%.17g \", {left}); "
        self.program = shop.work / f"native_{row.name}.c"
        headers = "".join(f"#include {h}\n" for h in shop.made[row.library][2])
        self.program.write_text(f'#include <stdio.h>\n{headers}#include "reference.h"\n'
                                f"int main(void) {{ for (;;) {{ {read} {row.statements} {told} puts(\"\"); }} }}\n")
        self.numbers = None

    def run(self, source, extra=(), apart=""):
        made = self.shop.work / f"native_{self.row.name}{apart}"
        self.shop.built(self.row.library, [*extra, self.program, source, self.archive, "-o", made])
        try:
            ran = subprocess.run([made], input=self.points, capture_output=True, text=True, timeout=10,
                                 env={"ASAN_OPTIONS": "detect_leaks=0"})
        except subprocess.TimeoutExpired:
            return None
        return [float(x) for x in ran.stdout.split()] if ran.returncode == 0 else None

    def run_original(self, source):
        self.numbers = self.run(source)
        if not self.numbers or any(map(math.isnan, self.numbers)):
            raise SystemExit(f"{self.row.name}: the original does not run")

    def changes(self, copy, apart):
        now = self.run(copy, apart=apart)
        return now is None or len(now) != len(self.numbers) or any(
            not abs(a - b) <= WORST * max(1, abs(a)) for a, b in zip(self.numbers, now))


class Shop(foreign_sources.Workshop):
    def __init__(self, *folders):
        super().__init__(*folders)
        self.made = {"sisl": self.sisl(), "gsl": self.gsl()}
        source, flags, headers = self.made["gsl"]  # a copy lies elsewhere, and asks for the header beside the original
        self.made["gsl"] = source, f"{flags} -I{self.unpacked('gsl')}/bspline", headers
        self.sources = {"sisl": sorted((self.unpacked("sisl") / "src").glob("*.c")), "gsl": self.gsl_sources()}
        self.folders = {"sisl": [self.unpacked("sisl") / "include"], "gsl": [self.gsl_headers(), self.unpacked("gsl"), self.unpacked("gsl") / "bspline"]}

    def gcc(self, library, flags, arguments):
        subprocess.run(["gcc", "-O0", "-g", "-w", *flags, *(f"-I{f}" for f in self.folders[library]), f"-I{self.work}", *arguments], check=True,
                       stderr=subprocess.PIPE, text=True)

    def built(self, library, arguments):
        self.gcc(library, ["-fsanitize=address"], [*arguments, "-lm"])

    def source(self, name):
        return next((library, file) for library, files in self.sources.items() for file in files if file.name == name)

    def native_archive(self, library):
        made, parts = self.work / f"native_{library}.a", self.work / f"native_{library}"
        if not made.exists():
            parts.mkdir(exist_ok=True)
            for source in self.sources[library]:
                try:
                    self.gcc(library, [], ["-c", source, "-o", parts / f"{source.parent.name}_{source.stem}.o"])
                except subprocess.CalledProcessError:
                    pass  # left out, as of the bitcode
            subprocess.run(["ar", "rc", made, *parts.glob("*.o")], check=True)
        return made

    def lines_that_run(self, name, native):
        """Their numbers, by gcov."""
        counted = self.work / "counted"
        counted.mkdir(exist_ok=True)
        for old in counted.glob("*"):
            old.unlink()
        library, source = self.source(name)
        self.built(library, ["--coverage", "-c", source, "-o", counted / "part.o"])
        native.run(counted / "part.o", ["--coverage"])
        told = subprocess.run(["gcov", "-t", "-o", counted, counted / "part.o"], capture_output=True, text=True, cwd=counted).stdout
        ran = re.compile(r"\s*\d+\*?:\s*(\d+):")
        if f"Source:{source}" not in told:
            raise SystemExit(f"{name}: gcov says nothing")
        part = told.split(f"Source:{source}")[1].split("0:Source:")[0]
        return {int(m[1]) for m in map(ran.match, part.splitlines()) if m}


def without_comments(text):
    """Of the same length, blanks for comments and texts."""
    return re.sub(r'/\*.*?\*/|"[^"\n]*"', lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.S)


def faults(text, lines):
    """(line, from, to, what stands there then), each place and fault once; not in declarations, whose values are soon others, nor
    in the questions whether inputs are legal."""
    begin = 0
    for number, line in enumerate(without_comments(text).splitlines(keepends=True), 1):
        if number in lines and not re.match(r"\s*(#|if .*goto err|int |double |unsigned |size_t |const )", line):
            for pattern, instead in FAULTS:
                for m in re.finditer(pattern, line):
                    if "->" not in line[m.start():m.end() + 1] and m[0] != instead:
                        yield number, begin + m.start(), begin + m.end(), instead
        begin += len(line)


def word_of(answer):
    """found, not found (proved all the same), or no answer."""
    if isinstance(answer, str):
        return "no answer", answer
    if answer["verdict"] == "proved":
        return "proved", "all inputs" if answer.get("exhaustive") else "on the ways met"
    because = answer.get("because", "")
    if answer["verdict"] == "undecided" and ("bits" in because or "more than" in because and "seconds" not in because):
        return "no answer", because
    return "found", answer["verdict"] + (": " + re.sub(r"\S*/", "", because) if because else "")


def try_fault(shop, rows, natives, number, name, fault):
    """Whether it changes the mathematics, what cagd exactly says, and a row of the table; None where it does not compile."""
    line, begin, end, instead = fault
    text = shop.source(name)[1].read_text(errors="replace")
    copy = shop.work / "planted" / str(number) / name
    copy.parent.mkdir(parents=True, exist_ok=True)
    copy.write_text(text[:begin] + instead + text[end:])
    try:
        changing = [n for n in PLANTED[name] if natives[n].changes(copy, f"_{number}")]
    except subprocess.CalledProcessError:
        return None
    row = (changing or PLANTED[name])[0]
    word, told = word_of(shop.ask(rows[row], sources=[f"planted/{number}/{name}"], apart=f"_{number}"))
    return bool(changing), word, (f"| {name} | {line} | `{text[begin:end].strip()}` is `{instead.strip()}` | "
                                  f"{'yes' if changing else 'no'} | {word}: {told[:150]} |")


def main():
    shop, count = Shop(*sys.argv[1:4]), int(sys.argv[4]) if len(sys.argv) > 4 else 60
    chance = random.Random(int(sys.argv[5]) if len(sys.argv) > 5 else SEED)
    planted = {name: asked for name, asked in PLANTED.items() if name in sys.argv[6:] or len(sys.argv) <= 6}
    rows = {r.name: r for r in foreign_rows.every_row()}
    natives = {n: Native(shop, rows[n], shop.native_archive(rows[n].library)) for names in planted.values() for n in names}
    waiting = []
    for name, asked in planted.items():
        source = shop.source(name)[1]
        for n in asked:
            natives[n].run_original(source)
        run = set().union(*(shop.lines_that_run(name, natives[n]) for n in asked))
        some = list(faults(source.read_text(errors="replace"), run))
        chance.shuffle(some)
        waiting.append([(name, fault) for fault in some])
    # one of each file in turn
    waiting = [one for several in itertools.zip_longest(*waiting) for one in several if one is not None]
    print("| file | line | fault | changes | cagd exactly |\n|---|---|---|---|---|", flush=True)
    changed, found, same, wrong, at_once = 0, 0, 0, 0, 6
    with concurrent.futures.ThreadPoolExecutor(at_once) as pool:
        for begin in range(0, len(waiting), at_once):
            trials = [(shop, rows, natives, begin + k, *one) for k, one in enumerate(waiting[begin:begin + at_once])]
            for tried in pool.map(lambda trial: try_fault(*trial), trials):
                if tried is None or changed == count:
                    continue
                changing, word, line = tried
                changed += changing
                found += changing and word == "found"
                same += not changing and word == "proved"
                wrong += not changing and word != "proved"
                print(line, flush=True)
            if changed == count:
                break
    print(f"\n{changed} faults change the mathematics, {found} of them are found; {same} more change nothing and are proved, "
          f"{wrong} change nothing that binary64 shows at the points, and are not proved.")


if __name__ == "__main__":
    main()
