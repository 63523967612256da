"""Which word a right solution gets, for every lab and requirement: a table, kept in chapters/labs/README.md.

    python3 words.py CAGD ROOT             is the table there what is decided now?
    python3 words.py CAGD ROOT --write     put it there
"""
import json
import pathlib
import subprocess
import sys
import tempfile

BEGIN, END = "<!-- words: made by proofs-tests/labs/words.py -->\n", "<!-- end of words -->\n"


def rows_of(cagd, lab):
    """Of each requirement its name, points and word, for the first of the right solutions."""
    right = sorted((lab / "right").iterdir())[0]
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / (lab.name + right.suffix)).write_text(right.read_text())
        ran = subprocess.run([cagd, "lab", "check", folder, "--lab", lab.name, "--json"], capture_output=True, text=True, timeout=300)
    rows = json.loads(ran.stdout)["requirements"]
    for row in rows:
        if row["verdict"] not in ("proved", "clean", "sampled"):
            raise SystemExit(f"{lab.name}: {right.name} fails {row['name']}: {row['text']}")
    return rows


def word_of(row):
    """Without the numbers of points and ways, which depend on how a solution is written."""
    text = row["text"]
    if row["verdict"] == "clean":
        return "seen at some points alone"
    if row["verdict"] == "sampled":
        text = "right in exact cases" + (text[text.index(","):] if "," in text else "")
        return text + (": " + row["because"] if "because" in row else ": not every way through the code was closed")
    return text.split(", on each")[0] + (", on each way that was found" if ", on each" in text else "")


def table(cagd, root):
    lines = ["| lab | requirement | points | word |\n", "|---|---|---|---|\n"]
    for lab in sorted(p.parent for p in (root / "chapters/labs").glob("*/lab.md")):
        for k, row in enumerate(rows_of(cagd, lab)):
            lines.append(f"| {'`' + lab.name + '`' if k == 0 else ''} | {row['name']} | {row['of']} | {word_of(row)} |\n")
    return "".join(lines)


def main():
    cagd, root = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    page = root / "chapters/labs/README.md"
    text = page.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    made = table(cagd, root)
    if "--write" in sys.argv:
        page.write_text(text[:begin] + made + text[end:])
    elif text[begin:end] != made:
        sys.stdout.write(made)
        raise SystemExit(f"{page}: the table of words is another one; words.py --write puts it there")


main()
