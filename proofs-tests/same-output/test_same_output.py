"""The same source gives the same bytes: builds a preset and compares its output with another build's.

    test_same_output.py ROOT PRESET CAGD

To be quick the other build has the number types that are computed by this project's own code and the compiler's: binary64,
and rationals.  What the claims did in these types, with every exhibit and measured error, is compared byte for byte, and so
is every figure.
"""
import json
import pathlib
import pickle
import subprocess
import sys
import tempfile

TYPES = ("rational", "double")
root, preset, reference = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
folder = root / "build" / f"{preset}-two-types"
subprocess.run(["cmake", "--preset", preset, "-B", str(folder), "-DBUILD_TESTING=OFF", "-DCAGD_TYPES=RATIONAL;DOUBLE"],
               cwd=root, check=True, stdout=subprocess.DEVNULL)
subprocess.run(["cmake", "--build", str(folder), "--target", "cagd"], cwd=root, check=True, stdout=subprocess.DEVNULL)


def outputs(program):
    """What every claim did in the two types, and every figure."""
    said = {}
    for claim in json.loads(subprocess.run([program, "verify", "--json"], capture_output=True).stdout)["claims"]:
        types = {name: result for name, result in claim["types"].items() if name in TYPES}
        if types:
            said[claim["name"]] = json.dumps(types, indent=1).encode()
    with tempfile.TemporaryDirectory() as drawn:
        subprocess.run([program, "figures", "--out", drawn], check=True, stdout=subprocess.DEVNULL)
        for path in sorted(pathlib.Path(drawn).iterdir()):
            said[path.name] = path.read_bytes()
    return said


def outputs_of_reference():
    """The same for the reference, kept beside it for the next preset as long as it is newer."""
    kept = pathlib.Path(reference + "-outputs.pickle")
    if not kept.exists() or kept.stat().st_mtime < pathlib.Path(reference).stat().st_mtime:
        kept.write_bytes(pickle.dumps(outputs(reference)))
    return pickle.loads(kept.read_bytes())


ours, theirs = outputs_of_reference(), outputs(str(folder / "cagd"))
different = [name for name in sorted(ours.keys() | theirs.keys()) if ours.get(name) != theirs.get(name)]
for name in different:
    print("differs:", name)
    for a, b in zip(ours.get(name, b"").splitlines(), theirs.get(name, b"").splitlines()):
        if a != b:
            print("  -", a[:200].decode())
            print("  +", b[:200].decode())
            break
assert len(ours) > 500, "too little was compared"
print(f"{len(ours)} outputs compared, {len(different)} differ")
sys.exit(bool(different))
