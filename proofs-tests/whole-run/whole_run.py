"""One run over everything, whose output the other tests read: the fixture `whole-run` of CTest.

    whole_run.py CAGD FOLDER

writes FOLDER/verify.json, FOLDER/verify.xml, FOLDER/report (the ledger), FOLDER/certificates and FOLDER/figures.
"""
import pathlib
import shutil
import subprocess
import sys


def whole_run(cagd, folder, *options):
    """The exit status is that of `cagd verify`: 0 when every claim and every statement is as expected."""
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    figures = subprocess.Popen([cagd, "figures", "--out", str(folder / "figures")], stdout=subprocess.DEVNULL)
    with open(folder / "verify.json", "w") as said:
        status = subprocess.run([cagd, "verify", "--json", *options], stdout=said).returncode
    if figures.wait() != 0:
        raise RuntimeError("the figures were not drawn")
    return status


if __name__ == "__main__":
    place = sys.argv[2]
    sys.exit(whole_run(sys.argv[1], place, "--junit", place + "/verify.xml", "--report", place + "/report", "--certificates",
                       place + "/certificates"))
