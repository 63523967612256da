"""Makes the certified problems again and compares them, byte by byte, with those that are kept.

    regenerate.py CERTIFY [--write] [NAME ...]     without names all of them, which takes some minutes

CERTIFY is the built program.  With --write the files are put in their place instead.  Exit status 0: nothing differs.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
sys.dont_write_bytecode = True
import generate  # noqa: E402


def main():
    certify, write = sys.argv[1], "--write" in sys.argv
    names = [name for name in sys.argv[2:] if name != "--write"] or list(generate.PROBLEMS)
    kept, different = HERE / "problems", 0
    if not sys.argv[2:]:
        for path in sorted(kept.iterdir()):
            if path.stem not in generate.PROBLEMS:
                print(f"{path.name}: no problem has this name")
                different += 1
    with tempfile.TemporaryDirectory() as folder:
        for name in names:
            generate.make(name, pathlib.Path(folder))
            subprocess.run([certify, f"{folder}/{name}.json"], check=True)
            for file in (f"{name}.csv", f"{name}.json"):
                new = pathlib.Path(folder) / file
                if write:
                    shutil.copy(new, kept / file)
                elif not (kept / file).exists() or new.read_bytes() != (kept / file).read_bytes():
                    print(f"{file}: differs from what is kept")
                    different += 1
    print(f"{len(names)} problems made, {different} differences")
    return different > 0


if __name__ == "__main__":
    sys.exit(main())
