"""The same source gives the same bytes: builds a preset and compares all its output with another build's.

    test_same_output.py ROOT PRESET CAGD
"""
import pathlib
import pickle
import subprocess
import sys
import tempfile

root, preset, reference = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
subprocess.run(["cmake", "--preset", preset], cwd=root, check=True, stdout=subprocess.DEVNULL)
subprocess.run(["cmake", "--build", f"build/{preset}", "--target", "cagd"], cwd=root, check=True,
               stdout=subprocess.DEVNULL)
other = str(root / "build" / preset / "cagd")


def outputs_of_reference():
    """The same for the reference, kept beside it for the next preset as long as it is newer."""
    kept = pathlib.Path(reference + "-outputs.pickle")
    if not kept.exists() or kept.stat().st_mtime < pathlib.Path(reference).stat().st_mtime:
        kept.write_bytes(pickle.dumps(outputs(reference)))
    return pickle.loads(kept.read_bytes())


def outputs(program):
    """What the program prints about every claim and some statements, and every figure it draws."""
    said = {}
    for arguments in (["verify", "--json"], ["list"], ["ledger", "bezier.*"], ["ledger", "--json", "wang-ch3:3.2.*"]):
        said[" ".join(arguments)] = subprocess.run([program, *arguments], capture_output=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "figures", "--out", folder], check=True, stdout=subprocess.DEVNULL)
        for path in sorted(pathlib.Path(folder).iterdir()):
            said[path.name] = path.read_bytes()
    return said


ours, theirs = outputs_of_reference(), outputs(other)
different = [name for name in sorted(ours.keys() | theirs.keys()) if ours.get(name) != theirs.get(name)]
for name in different:
    print("differs:", name)
    for a, b in zip(ours.get(name, b"").splitlines(), theirs.get(name, b"").splitlines()):
        if a != b:
            print("  -", a[:200].decode())
            print("  +", b[:200].decode())
            break
assert len(ours) > 6, "no figures were compared"
print(f"{len(ours)} outputs compared, {len(different)} differ")
sys.exit(bool(different))
