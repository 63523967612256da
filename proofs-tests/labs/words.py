"""Which word a right solution gets, for every lab and requirement: a table, kept in chapters/labs/README.md.

    python3 words.py CAGD ROOT LAB         cagd lab test of that lab, and: are its rows there what was decided?
    python3 words.py CAGD ROOT --write     all rows are put there
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
    return json.loads(ran.stdout)["requirements"]


def rows_of_test(cagd, lab):
    """The same by cagd lab test, whose words are printed and whose complaints end this program."""
    ran = subprocess.run([cagd, "lab", "test", str(lab), "--json"], stdout=subprocess.PIPE, text=True, timeout=900)
    if ran.returncode != 0:
        raise SystemExit(ran.returncode)
    results = {row["name"]: row["result"] for row in json.loads(ran.stdout)["solutions"]}
    return results["right/" + sorted((lab / "right").iterdir())[0].name]["requirements"]


def word_of(row):
    """Without the numbers of points and ways, which depend on how a solution is written."""
    text = row["text"]
    if row["verdict"] == "clean":
        return "seen at some points alone"
    if row["verdict"] == "sampled":
        text = "right in exact cases" + (text[text.index(","):] if "," in text else "")
        return text + (": " + row["because"] if "because" in row else ": not every way through the code was closed")
    end = ", on each way that there is" if text.endswith("ways that there are") else ", on each way that was found"
    return text.split(", on each")[0] + (end if ", on each" in text else "")


def rows_of_table(lab, rows):
    for row in rows:
        if row["verdict"] not in ("proved", "clean", "sampled"):
            raise SystemExit(f"{lab.name}: a right solution fails {row['name']}: {row['text']}")
    return "".join(f"| {'`' + lab.name + '`' if k == 0 else ''} | {row['name']} | {row['of']} | {word_of(row)} |\n" for k, row in enumerate(rows))


def main():
    cagd, root = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    page, labs = root / "chapters/labs/README.md", root / "chapters/labs"
    text = page.read_text()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    if "--write" in sys.argv:
        made = "| lab | requirement | points | word |\n|---|---|---|---|\n"
        for lab in sorted(p.parent for p in labs.glob("*/lab.md")):
            made += rows_of_table(lab, rows_of(cagd, lab))
        page.write_text(text[:begin] + made + text[end:])
        return
    lab = labs / sys.argv[3]
    made = rows_of_table(lab, rows_of_test(cagd, lab))
    if made not in text[begin:end]:
        sys.stdout.write(made)
        raise SystemExit(f"{page}: the rows of {lab.name} are others; words.py --write puts them there")


main()
