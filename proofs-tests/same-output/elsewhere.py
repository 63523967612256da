"""The same bytes elsewhere: with newer compilers and libraries, and on another processor.

    elsewhere.py ROOT CAGD WHERE...

WHERE is `newer`, Debian 13 (gcc 14, FLINT 3, GMP 6.3, MPFR 4.2, Ceres 2.2), `testing`, the Debian that is being made, whose versions
are printed, or `arm64`, Debian 12 compiled for that processor and run by an emulator.  Each is set up in a
folder of its own by debootstrap, as root; the committed sources are compiled there;
everything is decided, in every number type, drawn and certified, here and there; and every file is compared, without the
times.  A certificate lists operations in the order in which a compiler evaluates the arguments of a call, which C leaves open:
on arm64 gcc has another one, so those of arm64 are not compared but rechecked.  `newer` takes two minutes on two cores
that have nothing else to do, `arm64` six.  The last run of `testing` had gcc 16.1, FLINT 3.6 and MPFR 4.2.2: of 2164 files none differed.
"""
import argparse
import filecmp
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

TOOLS = ["cmake", "ninja-build", "pkg-config", "python3"]
LIBRARIES = ["libgmp-dev", "libmpfr-dev", "libflint-dev", "libjansson-dev", "libxml2-dev", "libceres-dev", "libmimalloc-dev"]
OLDER_FLINT = ["libflint-arb-dev", "libcalcium-dev"]  # which FLINT 3 contains
ARM64 = """set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CROSSCOMPILING_EMULATOR /usr/bin/qemu-aarch64-static)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
"""


class Newer:
    suite, before, options, emulator, same_order = "trixie", "", "", "", True
    packages = TOOLS + ["gcc", "g++", "libc6-dev"] + LIBRARIES


class Testing(Newer):
    suite, before = "testing", "echo 'Acquire::Check-Valid-Until \"false\";' >/etc/apt/apt.conf.d/any-day && "


class Arm64:
    suite, before = "bookworm", "dpkg --add-architecture arm64 && "
    options = "-DCMAKE_TOOLCHAIN_FILE=/src/arm64.cmake"
    emulator, same_order = "qemu-aarch64-static ", False
    packages = (TOOLS + ["gcc-aarch64-linux-gnu", "g++-aarch64-linux-gnu", "qemu-user-static"] +
                [name + ":arm64" for name in ["libc6-dev", "libstdc++-12-dev"] + LIBRARIES + OLDER_FLINT])


CANNOT = 3  # recheck.py: nothing is wrong, and some kinds of claims it does not recheck, here as there
PLACES = {"newer": Newer, "testing": Testing, "arm64": Arm64}
SHOWN = "gcc libflint-dev libgmp-dev libmpfr-dev libceres-dev"


def must(*command):
    r = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if r.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))[:200]}\n{r.stdout[-3000:]}")
    return r.stdout


class Elsewhere:
    """A folder with a system of its own."""

    def __init__(self, place, folder):
        self.place, self.folder = place, folder
        must("debootstrap", "--variant=minbase", place.suite, folder)
        shutil.copy("/etc/resolv.conf", folder / "etc/resolv.conf")
        self.inside(f"{place.before} apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "
                    + " ".join(place.packages))

    def inside(self, command):
        return must("chroot", self.folder, "env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "sh", "-c", command)

    def versions(self):
        """What was installed, in one line."""
        return self.inside(f"dpkg-query -W -f '${{Package}} ${{Version}}, ' {SHOWN} 2>&1 || true").rstrip(", ")

    def compile(self, root):
        (self.folder / "src").mkdir()
        must("sh", "-c", f"git -C '{root}' archive HEAD | tar -x -C '{self.folder}/src'")
        (self.folder / "src/arm64.cmake").write_text(ARM64)
        self.inside("cd /src && PKG_CONFIG_LIBDIR=$(ls -d /usr/lib/%s-linux-gnu/pkgconfig):/usr/share/pkgconfig "
                    "cmake --preset release -DBUILD_TESTING=OFF %s && cmake --build build/release -j 2"
                    % ("aarch64" if self.place is Arm64 else "*", self.place.options))

    def run(self):
        self.inside("cd /src && " + whole(f"{self.place.emulator}build/release/cagd", "/out"))
        return self.folder / "out"


def whole(cagd, folder):
    """The command that decides, certifies and draws everything."""
    return (f"mkdir -p {folder} && {cagd} figures --out {folder}/figures >{folder}/figures.txt && {cagd} verify --json --jobs 2 "
            f"--report {folder}/report --certificates {folder}/certificates >{folder}/verify.json")


def without_times(value):
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if k != "seconds"}
    return [without_times(v) for v in value] if isinstance(value, list) else value


def same(a, b):
    if a.name == "verify.json":
        return without_times(json.loads(a.read_text())) == without_times(json.loads(b.read_text()))
    return filecmp.cmp(a, b, shallow=False)


def compare(here, there, certificates):
    """How many files were compared, and the names of those that differ or are in one place only."""
    files = [{p.relative_to(top) for p in top.rglob("*") if p.is_file() and p.name not in ("figures.txt", "verify.txt")} for top in (here, there)]
    common = {p for p in files[0] & files[1] if certificates or p.parts[0] != "certificates"}
    return len(common), sorted(files[0] ^ files[1]) + sorted(p for p in common if not same(here / p, there / p))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("cagd", type=pathlib.Path)
    parser.add_argument("where", nargs="+", choices=PLACES)
    a = parser.parse_args()
    if shutil.which("debootstrap") is None:
        sys.exit("debootstrap is missing: apt-get install debootstrap")
    result = 0
    with tempfile.TemporaryDirectory() as work:
        here = pathlib.Path(work) / "here"
        must("sh", "-c", whole(a.cagd.resolve(), here))
        for where in a.where:
            start = time.monotonic()
            elsewhere = Elsewhere(PLACES[where], pathlib.Path(work) / where)
            print(f"{where}: {elsewhere.versions()}", flush=True)
            elsewhere.compile(a.root.resolve())
            there, same_order = elsewhere.run(), PLACES[where].same_order
            count, different = compare(here, there, same_order)
            if not same_order:
                r = subprocess.run([sys.executable, a.root / "proofs-tests/recheck.py", there / "certificates"], stdout=subprocess.PIPE, text=True)
                print(r.stdout.splitlines()[-1])
                result |= r.returncode not in (0, CANNOT)
            for name in different:
                print("differs:", name)
            print(f"{where}: {count} files compared, {len(different)} differ; {time.monotonic() - start:.0f} s", flush=True)
            result |= bool(different) or count < 200
    return result


if __name__ == "__main__":
    sys.exit(main())
