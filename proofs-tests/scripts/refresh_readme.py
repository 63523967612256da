"""Writes into README.md what the program says now: the transcripts of commands, and the end of ./run.

    python3 proofs-tests/scripts/refresh_readme.py build/release/cagd

The tests of the command compare the same; this saves the typing.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CAGD = str(pathlib.Path(sys.argv[1]).resolve())


def said(*arguments):
    return subprocess.run([CAGD, *arguments], cwd=ROOT, stdout=subprocess.PIPE, text=True, check=True).stdout


def transcript(match):
    command, _, _ = match.group(1).partition("\n")
    return f"```\n{command}\n{said(*command.split()[2:])}```"


def end_of_run():
    with tempfile.TemporaryDirectory() as folder:
        counts = "\n".join(said("verify", "--report", folder).splitlines()[-2:])
        return f"```\n{counts}\n\n{(pathlib.Path(folder) / 'summary.txt').read_text()}```"


path = ROOT / "README.md"
text = re.sub(r"```\n(\$ cagd .*?)```", transcript, path.read_text(encoding="utf-8"), flags=re.S)
text = re.sub(r"```\n\d+ claims: .*?```", lambda _: end_of_run(), text, flags=re.S)
path.write_text(text, encoding="utf-8")
