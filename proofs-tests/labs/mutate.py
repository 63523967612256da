"""Faults planted in the right solutions of the labs, each judged as a student's answer.

    python3 mutate.py CAGD LABS [--one-in N] [--lab NAME]... [--list]

A fault is one change of the text: an operator, a relation, a whole number, an index, the step of a loop. All faults of a lab are
judged by one `cagd lab test`, as right solutions of a copy of the lab. A fault is caught when a point is lost, or when the code no
longer compiles; it is harmless by proof when each requirement is right for all inputs by the proof in the field; those that are
neither have to stand in harmless.txt with the reason.

Of the seven labs in C that came last (conic-arcs, divided-differences, fit-points, fit-weights, knot-derivative, nurbs-circle, standard-form),
one in nine: 322 faults, 309 caught, 13 harmless by proof, none not caught; 2026-11."""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zlib

HERE = pathlib.Path(__file__).parent

# What is matched, and by what it is replaced: whole tokens only, outside comments, texts and directives.
RULES = [
    (r"(?<![-+*/<>=!&|])\+(?![+=])", ["-"]),
    (r"(?<![-+*/<>=!&|(,\[?:])\s-(?![-=>])", [" +"]),
    (r"(?<![/*(,])\s\*(?![/=])(?=\s)", [" /"]),
    (r"(?<![/*])/(?![/*=])", ["*"]),
    (r"\+=", ["-="]),
    (r"-=", ["+="]),
    (r"<=", ["<"]),
    (r"(?<![<>-])>=", [">"]),
    (r"(?<![<])<(?![<=])", ["<="]),
    (r"(?<![->])>(?![>=])", [">="]),
    (r"==", ["!="]),
    (r"!=", ["=="]),
    (r"&&", ["||"]),
    (r"\|\|", ["&&"]),
    (r"\+\+", ["--"]),
    (r"(?<![\w.])\d+(?![\w.])", ["{n+1}", "{n-1}"]),
    (r"(?<=\w\[)(\w+)(?=\])", ["\\g<0> + 1", "\\g<0> - 1"]),
]


def blanked(text):
    """The text, of the same length, with blanks where nothing is changed: comments, texts and directives."""
    pattern = r'/\*.*?\*/|//[^\n]*|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|^[ \t]*#[^\n]*'
    return re.sub(pattern, lambda m: re.sub(r"[^\n]", "\0", m.group()), text, flags=re.S | re.M)


def faults(text):
    """(place and change, text with it), in the order of the text."""
    code = blanked(text)
    found = []
    for pattern, replacements in RULES:
        for m in re.finditer(pattern, code):
            for r in replacements:
                old = m.group()
                if r.startswith("{"):
                    new = str(int(old) + (1 if "+" in r else -1))
                else:
                    new = m.expand(r) if "\\" in r else r
                line = text.count("\n", 0, m.start()) + 1
                found.append((m.start(), line, f"{old.strip()} -> {new.strip()}", text[:m.start()] + new + text[m.end():]))
    found.sort(key=lambda f: (f[0], f[2]))
    return [(f"{line}:{start - text.rfind(chr(10), 0, start)} {what}", new) for start, line, what, new in found]


def all_of(lab):
    """Name -> text with the fault; the name tells the file, the place and the change."""
    return {f"{lab.name}/{path.name}:{what}": text
            for path in sorted((lab / "right").glob("*.c")) for what, text in faults(path.read_text())}


def chosen(texts, one_in):
    return {name: text for name, text in texts.items() if zlib.crc32(name.encode()) % one_in == 0}


def judged(cagd, lab, texts):
    """name -> the requirements with their verdicts, by one process."""
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder) / lab.name
        shutil.copytree(lab, copy, ignore=shutil.ignore_patterns("right"))
        (copy / "right").mkdir()
        page = (lab / "lab.md").read_text()  # without its wrong solutions: no hints are asked for
        (copy / "lab.md").write_text(re.sub(r"^:::\{wrong\}.*?^:::$", "", page, flags=re.S | re.M))
        names = list(texts)
        for k, name in enumerate(names):
            (copy / "right" / f"{k}.c").write_text(texts[name])
        ran = subprocess.run([cagd, "lab", "test", str(copy), "--json"], capture_output=True, text=True)
        rows = json.loads(ran.stdout)["solutions"]
        results = {row["name"]: row["result"] for row in rows}
        return {name: results[f"right/{k}.c"] for k, name in enumerate(names)}


def verdict(result):
    if result["points"] < result["of"]:
        return "caught"
    rows = [r for r in result["requirements"] if r["verdict"] != "clean"]
    return "proved" if all(r["verdict"] == "proved" for r in rows) else "open"


def main():
    a = argparse.ArgumentParser()
    a.add_argument("cagd")
    a.add_argument("labs", type=pathlib.Path)
    a.add_argument("--one-in", type=int, default=1)
    a.add_argument("--lab", action="append")
    a.add_argument("--list", action="store_true", help="print the faults only")
    a = a.parse_args()
    known = {}
    for line in (HERE / "harmless.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            name, _, why = line.partition(" | ")
            known[name] = why
    labs = [p.parent for p in sorted(a.labs.glob("*/lab.md")) if (p.parent / "reference.c").exists()]
    sums = {"caught": 0, "proved": 0, "argued": 0, "open": 0}
    for lab in labs:
        if a.lab and lab.name not in a.lab:
            continue
        every = all_of(lab)
        stale = [name for name in known if name.startswith(lab.name + "/") and name not in every]
        if stale:
            sys.exit(f"harmless.txt: there is no such fault any more: {stale}")
        texts = chosen(every, a.one_in)
        if a.list:
            print("\n".join(texts))
            continue
        here = dict.fromkeys(sums, 0)
        for name, result in (judged(a.cagd, lab, texts) if texts else {}).items():
            v = verdict(result)
            if v == "open" and name in known:
                v = "argued"
            here[v] += 1
            if v == "open":
                print("not caught:", name, [(r["name"], r["verdict"], r["text"]) for r in result["requirements"]])
        for v in sums:
            sums[v] += here[v]
        print(f"{lab.name}: {here}", flush=True)
    if not a.list:
        total = sum(sums.values())
        print(f"{total} faults: {sums['caught']} caught, {sums['proved']} harmless by proof, {sums['argued']} harmless by a reason,"
              f" {sums['open']} not caught")
        sys.exit(total == 0 or sums["open"] > 0)


if __name__ == "__main__":
    main()
