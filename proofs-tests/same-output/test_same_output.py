"""The same source gives the same bytes: builds a preset and compares its output with that of another build.

    test_same_output.py ROOT PRESET WHOLE_RUN [all]

WHOLE_RUN is the folder that whole_run.py wrote with the other build.  To be quick the preset is built with few number
types: binary64, which the compiler computes, and at -O0 rationals; with `all`, in every type, which takes minutes.  What the claims did in these types, with every exhibit and measured error, is compared byte
for byte, and so is every figure.  The preset `sanitize` is gcc at -O0: with it, this is also the run over everything
that no sanitizer may complain about.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

root, preset, reference = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
every_type = sys.argv[4:] == ["all"]
TYPES = (("field", "rational", "interval", "double") if every_type else
         ("double",) if preset == "clang" else ("rational", "double"))
sys.path.insert(0, str(root / "proofs-tests" / "whole-run"))
from whole_run import whole_run  # noqa: E402

folder = root / "build" / (preset if preset == "sanitize" else f"{preset}-{len(TYPES)}-types")
options = [] if preset == "sanitize" else ["-DBUILD_TESTING=OFF", "-DCAGD_TYPES=" + ";".join(TYPES).upper()]
subprocess.run(["cmake", "--preset", preset, "-B", str(folder), *options], cwd=root, check=True, stdout=subprocess.DEVNULL)
subprocess.run(["cmake", "--build", str(folder), "--target", "cagd"], cwd=root, check=True, stdout=subprocess.DEVNULL)


def outputs(run):
    """What every claim did in these types, and every figure."""
    said = {path.name: path.read_bytes() for path in sorted((run / "figures").iterdir())}
    for claim in json.loads((run / "verify.json").read_text())["claims"]:
        types = {name: result for name, result in claim["types"].items() if name in TYPES}
        if types:
            said[claim["name"]] = json.dumps(types, indent=1).encode()
    return said


with tempfile.TemporaryDirectory() as place:
    status = whole_run(str(folder / "cagd"), place)
    if preset == "sanitize":
        certificates = ["--certificates", place + "/certificates", "bezier.*", "shape-parameter.*"]
        subprocess.run([str(folder / "cagd"), "verify", *certificates], check=True, stdout=subprocess.DEVNULL)
    ours, theirs = outputs(reference), outputs(pathlib.Path(place))
different = [name for name in sorted(ours.keys() | theirs.keys()) if ours.get(name) != theirs.get(name)]
for name in different:
    print("differs:", name)
    for a, b in zip(ours.get(name, b"").splitlines(), theirs.get(name, b"").splitlines()):
        if a != b:
            print("  -", a[:200].decode())
            print("  +", b[:200].decode())
            break
assert len(ours) > 500, "too little was compared"
print(f"{len(ours)} outputs compared, {len(different)} differ; exit status {status}")
sys.exit(bool(different) or status != 0)
