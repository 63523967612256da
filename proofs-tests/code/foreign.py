"""Libraries that others wrote, executed exactly, routine by shape by verdict.  Not a test: it takes half an hour, and their sources.

    cmake --build build/release --target foreign
    python3 foreign.py CAGD CAGD-COMPILE-EXACTLY FOLDER [--rows PATTERN] [--record PAGE]

From nothing to the table, FOLDER/table.md: the packages are fetched from Debian into FOLDER (foreign_sources.py), compiled to bitcode, and
each row of foreign_rows.py is asked: does a routine compute, for a degree, what the recursion of the basis functions says?  The points, the
weights, the knots and the parameter are variables.  What was answered by the same two programs is kept, so that a run that was stopped
goes on; what others answered is asked again.  --record puts the table into PAGE (foreign.md), between its marks.  Nothing of the
libraries is part of this project."""
import argparse
import fnmatch
import json
import pathlib
import re
import resource
import subprocess

import foreign_rows
from foreign_sources import Workshop, fetch

MARKS = "<!-- the table begins -->", "<!-- the table ends -->"
HEAD = ["routine", "verdict", "ways proved", "conditions, most", "ulps, worst", "seconds", "remark"]


def seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def told(name, v, took):
    """The line of a row, of what cagd exactly said."""
    if isinstance(v, str):
        return [name, "not compiled", "", "", "", f"{took:.0f}", v]
    most = max((sum(not c["precondition"] and not c["implied"] for c in w["conditions"]) for w in v["ways"]), default=0)
    worst = max((w["ulps"] or 0 for w in v.get("rounding", {}).get("worst", [])), default=None)
    note = v.get("because") or v.get("open") and "open: " + v["open"] or ""
    if v.get("memcpy_overlaps"):
        note = f"memcpy of overlapping pieces taken for memmove, at {v['memcpy_overlaps']}; {note}".rstrip("; ")
    if v["verdict"] == "differs":
        note = "at " + ", ".join(f"{k} = {' '.join(x)}" for k, x in v["point"].items())
    word = v["verdict"] + (", all inputs" if v.get("exhaustive") else "")
    return [name, word, f"{v['paths_proved']}/{v['paths']}", str(most), f"{worst:.3g}" if worst is not None else "", f"{took:.0f}",
            re.sub(r" in _Z\w+", "", re.sub(r"\S*/(?=[\w.]+:\d)", "", note))]


def asked(shop, row, build):
    """A row's line; it is kept with what was asked and by which programs."""
    kept = shop.work / "told" / f"{row.name}.json"
    kept.parent.mkdir(exist_ok=True)
    key = [build, list(row)]
    if kept.exists() and json.loads(kept.read_text())["key"] == key:
        return json.loads(kept.read_text())["line"]
    if row.library not in shop.made:
        shop.made[row.library] = getattr(shop, row.library)()  # once, and not counted as this row's time
    before = seconds()
    line = told(row.name, shop.ask(row, rounding=40), seconds() - before)
    kept.write_text(json.dumps({"key": key, "line": line}))
    return line


def version_of(cagd):
    """With the commit that is checked out, where the programs were built from it."""
    def git(*words):
        return subprocess.run(["git", *words], capture_output=True, text=True, cwd=pathlib.Path(__file__).parent).stdout.strip()
    version = subprocess.run([cagd, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    changed = git("status", "--porcelain", "--", ":/core", ":/exact", ":/cli")
    return f"{version} ({git('log', '-1', '--format=%h of %cs')}{', with changes' if changed else ''})"


def introduction(version, shop, lines):
    clang = subprocess.run([shop.clang(), "--version"], capture_output=True, text=True, check=True).stdout.split("\n")[0]
    packages = ", ".join(f"{name} {v}" for name, v in shop.versions().items())
    proved = [line for line in lines if line[1].startswith("proved")]
    everywhere = sum(line[1] == "proved, all inputs" for line in lines)
    took = sum(float(line[5]) for line in lines)
    return (f"All rows are of one build, {version}, with {clang}; Debian's packages: {packages}. {len(proved)} of {len(lines)} rows "
            f"are proved on all ways that were met, {everywhere} of them for all inputs that satisfy the preconditions. "
            f"The rows took {took / 60:.0f} minutes of processor time.")


def main():
    words = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    for name in ("cagd", "compiler", "folder"):
        words.add_argument(name)
    words.add_argument("--rows", default="*")
    words.add_argument("--record")
    a = words.parse_args()
    folder = pathlib.Path(a.folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    fetch(folder)
    shop, version = Workshop(a.cagd, a.compiler, folder), version_of(a.cagd)
    build, lines = shop.build(), []
    for row in foreign_rows.every_row():
        if fnmatch.fnmatch(row.name, a.rows):
            lines.append(asked(shop, row, build))
            print("|", " | ".join(lines[-1]), "|", flush=True)
    table = "\n".join(["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD), *["| " + " | ".join(line) + " |" for line in lines]])
    text = f"{introduction(version, shop, lines)}\n\n{table}\n"
    (folder / "table.md").write_text(text)
    if a.record:
        page = pathlib.Path(a.record)
        before, rest = page.read_text().split(MARKS[0])
        page.write_text(f"{before}{MARKS[0]}\n{text}{MARKS[1]}{rest.split(MARKS[1])[1]}")


if __name__ == "__main__":
    main()
