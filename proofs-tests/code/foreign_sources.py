"""The sources of libraries that others wrote: taken from Debian's packages, compiled to bitcode, and asked (foreign.py)."""
import glob
import hashlib
import json
import os
import pathlib
import re
import subprocess

from foreign_rows import BOOST, EIGEN, REFERENCE

SOURCE_PACKAGES = ["sisl", "gsl", "libsnl-dev", "alglib"]  # as `apt-get source` finds them
HEADER_PACKAGES = ["libeigen3-dev", "libboost1.74-dev"]   # headers alone: what is installed would do


def debian_lines():
    """The sources of packages that apt knows of Debian itself, each once as a source of binary and once of source packages."""
    for file in ["/etc/apt/sources.list", *glob.glob("/etc/apt/sources.list.d/*.list")]:
        for line in pathlib.Path(file).read_text().splitlines() if os.path.exists(file) else []:
            if re.match(r"deb(-src)?\s.*debian", line):
                yield from (f"{kind} {line.split(None, 1)[1]}" for kind in ("deb", "deb-src"))
    for file in glob.glob("/etc/apt/sources.list.d/*.sources"):
        for block in re.split(r"\n\s*\n", pathlib.Path(file).read_text()):
            field = dict(re.findall(r"^(\w[\w-]*):[ \t]*(.*)$", block, re.M))
            if "debian" not in field.get("URIs", ""):
                continue
            signed = f"[signed-by={field['Signed-By']}] " if "Signed-By" in field else ""
            for uri in field["URIs"].split():
                for suite in field["Suites"].split():
                    yield from (f"{kind} {signed}{uri} {suite} {field.get('Components', '')}" for kind in ("deb", "deb-src"))


def fetch(folder):
    """What is not in the folder yet is fetched by apt, with lists of its own, and unpacked there; nothing is installed."""
    missing = [p for p in SOURCE_PACKAGES if not any(f.is_dir() for f in folder.glob(p.removesuffix("-dev") + "-*"))]
    headers = [p for p in HEADER_PACKAGES if not (folder / p).is_dir()]
    if not missing and not headers:
        return
    for part in ["apt/lists/partial", "apt/cache/archives/partial"]:
        (folder / part).mkdir(parents=True, exist_ok=True)
    (folder / "apt/sources.list").write_text("\n".join(dict.fromkeys(debian_lines())) + "\n")
    apt = ["apt-get", "-q", "-o", f"Dir::Etc::SourceList={folder}/apt/sources.list", "-o", "Dir::Etc::SourceParts=-", "-o",
           f"Dir::State::Lists={folder}/apt/lists", "-o", f"Dir::Cache={folder}/apt/cache", "-o", "APT::Sandbox::User=root"]
    for arguments in [["update"], *[["source", p] for p in missing], *[["download", p] for p in headers]]:
        subprocess.run(apt + arguments, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    for package in headers:
        subprocess.run(["dpkg-deb", "-x", next(folder.glob(package + "_*.deb")), folder / package], check=True)


class Workshop:
    """What is made of the sources of others, in a folder of its own."""

    def __init__(self, cagd, compiler, folder):
        self.cagd, self.compiler, self.folder = cagd, compiler, pathlib.Path(folder).resolve()
        self.work = self.folder / "exactly"
        self.work.mkdir(parents=True, exist_ok=True)
        (self.work / "reference.h").write_text(REFERENCE)
        self.made = {}

    def build(self):
        """The programs that answer, by what they are: rows of another build are not told."""
        return hashlib.sha256(b"".join(pathlib.Path(p).read_bytes() for p in (self.cagd, self.compiler))).hexdigest()[:16]

    def versions(self):
        """Of the packages, by the names of what was fetched."""
        found = {}
        for dsc in sorted(self.folder.glob("*.dsc")):
            field = dict(re.findall(r"^(\w+): (.*)$", dsc.read_text(errors="replace"), re.M))
            found[field["Source"]] = field["Version"]
        for deb in sorted(self.folder.glob("*.deb")):
            name, version, _ = deb.name.split("_")
            found[name] = version.replace("%3a", ":")
        return found

    def unpacked(self, package):
        return next(f for f in sorted(self.folder.glob(package + "-*")) if f.is_dir())

    def clang(self, cpp=False):
        tools = subprocess.run([self.compiler, "--tools"], capture_output=True, text=True, check=True).stdout.strip()
        return tools + ("/clang++" if cpp else "/clang")

    def archive(self, name, sources, flags):
        """The sources as bitcode; a file that does not compile is left out, and a routine that needs it is refused by name."""
        made, parts = self.work / f"{name}.a", self.work / name
        if not made.exists():
            parts.mkdir(exist_ok=True)
            for source in sources:
                standard = ["-std=gnu++17"] if source.suffix == ".cpp" else []
                subprocess.run([self.clang(source.suffix == ".cpp"), "-O0", "-ffp-model=strict", "-ftrivial-auto-var-init=pattern",
                                "-fno-builtin", "-g", "-fPIC", "-w", *standard, *flags, "-c", "-emit-llvm", source, "-o",
                                parts / f"{source.parent.name}_{source.stem}.o"], stderr=subprocess.DEVNULL)
            subprocess.run(["ar", "rc", made, *parts.glob("*.o")], check=True)

    # Of each library: the source that a harness names, its flags, and the headers.

    def sisl(self):
        folder = self.unpacked("sisl")
        self.archive("sisl", sorted((folder / "src").glob("*.c")), [f"-I{folder}/include"])
        return "sisl.a", f"-I{folder}/include", ['"sislP.h"']

    def gsl(self):
        """The headers stand apart in the sources; what `configure` would say matters little to B-splines."""
        folder, headers = self.unpacked("gsl"), self.gsl_headers()
        self.archive("gsl", self.gsl_sources(), [f"-I{headers}", f"-I{folder}"])
        return "gsl.a", f"-I{headers}", ["<gsl/gsl_bspline.h>"]

    def gsl_headers(self):
        folder, headers = self.unpacked("gsl"), self.work / "include" / "gsl"
        headers.mkdir(parents=True, exist_ok=True)
        for header in [*folder.glob("gsl_*.h"), *folder.glob("*/gsl_*.h")]:
            if not (headers / header.name).exists():
                (headers / header.name).symlink_to(header)
        (headers.parent / "config.h").write_text("#define RETURN_IF_NULL(x) if (!x) { return; }\n#define HAVE_INLINE 1\n")
        return headers.parent

    def gsl_sources(self):
        return [self.unpacked("gsl") / f for f in [
            "bspline/bspline.c", "vector/vector.c", "vector/init.c", "vector/view.c", "vector/oper.c", "vector/copy.c", "matrix/matrix.c",
            "matrix/init.c", "matrix/rowcol.c", "matrix/submatrix.c", "matrix/view.c", "block/block.c", "block/init.c", "sys/minmax.c",
            "err/error.c", "err/stream.c", "err/strerror.c"]]

    def snl(self):
        folder = self.unpacked("libsnl") / "src"
        self.archive("snl", sorted(folder.glob("*.cpp")), [f"-I{folder}"])
        return "snl.a", f"-std=gnu++17 -I{folder}", ['"snlCurve.h"']

    def alglib(self):
        folder = self.unpacked("alglib") / "src"
        self.archive("alglib", sorted(folder.glob("*.cpp")), [f"-I{folder}"])
        return "alglib.a", f"-std=gnu++17 -I{folder}", ['"interpolation.h"']

    def headers_alone(self, name, text, package, below):
        """A library of headers: functions in C that call its templates, compiled once."""
        source, declared = self.work / f"{name}.cc", re.findall(r"^extern \"C\" (.*\))$", text, re.M)
        source.write_text(text)
        (self.work / f"{name}.h").write_text('extern "C" { ' + " ".join(d + ";" for d in declared) + " }\n")
        compiled = self.work / f"{name}.bc"
        if not compiled.exists():
            subprocess.run([self.clang(True), "-O0", "-ffp-model=strict", "-ftrivial-auto-var-init=pattern", "-fno-builtin", "-g", "-fPIC",
                            "-w", "-std=gnu++17", f"-I{self.folder}/{package}/{below}", "-c", "-emit-llvm", source, "-o", compiled], check=True)
        return f"{name}.bc", "-std=gnu++17", [f'"{name}.h"']

    def eigen(self):
        return self.headers_alone("eigen", EIGEN, "libeigen3-dev", "usr/include/eigen3")

    def boost(self):
        return self.headers_alone("boost", BOOST, "libboost1.74-dev", "usr/include")

    def ask(self, row, rounding=0, sources=(), points=12, apart=""):
        """What cagd exactly says of a row, as JSON, or a line where it says nothing; `sources` come before the library; `apart`
        names the page, where a row is asked more than once at a time."""
        if row.library not in self.made:
            self.made[row.library] = getattr(self, row.library)()
        source, flags, headers = self.made[row.library]
        page = self.work / f"{row.name}{apart}.md"
        page.write_text(f":::{{exactly}} {row.name}\n" + "".join(f":source: {s}\n" for s in [*sources, source])
                        + f":flag: {flags} -w\n" + "".join(f":include: {h}\n" for h in [*headers, '"reference.h"'])
                        + f":input: {row.inputs}\n:call: {row.statements}\n"
                        + "".join(f":expect: {e}\n" for e in row.expected) + row.keys + f":points: {points}\n:::\n")
        ran = subprocess.run([self.cagd, "exactly", page, "--json"] + [f"--rounding={rounding}"] * (rounding > 0),
                             capture_output=True, text=True)
        if ran.returncode in (0, 1):
            return json.loads(ran.stdout)["blocks"][0]
        return (ran.stderr.strip().splitlines() or ["it ended without a word"])[-1]
