"""The installed library as a stranger meets it: a ten-line program against a fresh install tree, found once
by find_package(cagd) and once by pkg-config; the man page, the command and the completion are in place.

    test_install.py BUILD_FOLDER SOURCE_FOLDER
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

build, source = sys.argv[1], pathlib.Path(sys.argv[2])


def sh(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


with tempfile.TemporaryDirectory() as folder:
    prefix = pathlib.Path(folder) / "prefix"
    sh("cmake", "--install", build, "--prefix", str(prefix))
    lib = next(prefix.glob("lib*/**/cagd.pc")).parent.parent
    assert (prefix / "include" / "cagd.h").exists() and (prefix / "include" / "cagd_fit.h").exists()
    # The header of the exact library stands alone, and FLINT behind it.
    exact = (prefix / "include" / "cagd_exact.h").read_text()
    assert set(re.findall(r"#include (.*)", exact)) == {"<cagd.h>", "<gmp.h>", "<mpfr.h>", "<stddef.h>"}, "cagd_exact.h"
    for path in prefix.rglob("*"):
        if path.suffix in (".pc", ".cmake", ".h"):
            assert build not in path.read_text() and str(source.parent.parent) not in path.read_text(), f"{path} names a build path"
    for wanted in ("bin/cagd", "share/man/man1/cagd.1", "share/bash-completion/completions/cagd",
                   "share/zsh/site-functions/_cagd", "share/fish/vendor_completions.d/cagd.fish"):
        assert (prefix / wanted).exists(), wanted
    schemas = sorted(path.name for path in (source.parent.parent / "cli/schemas").iterdir())
    assert schemas == sorted(path.name for path in (prefix / "share/cagd/schemas").iterdir()) != [], "schemas"
    assert sh(str(prefix / "bin" / "cagd"), "--version").startswith("cagd ")

    by_cmake = pathlib.Path(folder) / "by-cmake"
    sh("cmake", "-S", str(source), "-B", str(by_cmake), f"-DCMAKE_PREFIX_PATH={prefix}")
    sh("cmake", "--build", str(by_cmake))
    first = sh(str(by_cmake / "ten_lines"))
    assert sh(str(by_cmake / "fit_in_ten_lines")) == "0.707106781\n"

    chosen = sh(str(by_cmake / "choose_in_twenty_lines"))
    assert chosen.splitlines()[0] == "a whole ellipse, radius 5.000000000" and len(chosen.splitlines()) == 10, chosen
    assert len((source / "choose_in_twenty_lines.c").read_text().splitlines()) <= 21  # and one of what it is

    roots = sh(str(by_cmake / "roots_in_ten_lines"))
    assert roots == "0.211 0.788 2\n", roots

    # Code of others over exact numbers, from C; the compiler is found in the PATH.  And from Python.
    curves, with_path = source.parent.parent / "exact/code/example/curves.c", {**os.environ, "PATH": f"{prefix}/bin:{os.environ['PATH']}"}
    compiles = (prefix / "bin/cagd-compile-exactly").exists()
    horner = "64/147 p[0]*t^2-2*p[0]*t+p[0]-2*p[1]*t^2+2*p[1]*t+p[2]*t^2\n"
    if compiles:
        assert sh(str(by_cmake / "exactly_in_twenty_lines"), str(curves), env=with_path) == horner
        page = str(prefix / "share/cagd/exactly/README.md")  # as it lies there, beside its code
        assert "\nproved: equal for all values" in sh(str(prefix / "bin/cagd"), "exactly", page, "--only", "horner_is_casteljau"), page
        python = ("from cagd_exactly import Code\nfrom fractions import Fraction as F\n"
                  f"code = Code(source='{curves}', declare='double horner(int n, const double *p, double t);', input='p[3]; t',\n"
                  "            call='double R = horner(2, p, t);', output='R')\n"
                  "print(code(p=[0, 1, F(1, 3)], t='2/7')['R'], code.function(p=[0, 1, 2], t=0)['R'])\ncode.close()\n")
        assert sh(sys.executable, "-c", python, env={**with_path, "PYTHONPATH": str(prefix / "share/cagd/python")}) == horner

    env = {**os.environ, "PKG_CONFIG_PATH": str(lib / "pkgconfig")}
    for compiler, name, package, says in (("cc", "ten_lines.c", "cagd", first), ("c++", "ten_lines.c", "cagd", first),
                                          ("cc", "fit_in_ten_lines.c", "cagd_fit", "0.707106781\n"),
                                          ("cc", "choose_in_twenty_lines.c", "cagd_fit", chosen),
                                          ("cc", "roots_in_ten_lines.c", "cagd_exact", roots),
                                          ("c++", "roots_in_ten_lines.c", "cagd_exact", roots)):
        flags = sh("pkg-config", "--cflags", "--libs", *([] if package == "cagd_fit" else ["--static"]), package, env=env).split()
        program = pathlib.Path(folder) / f"{package}-by-{compiler.replace('+', 'p')}"
        language = ["-x", "c++"] if compiler == "c++" else []
        sh(compiler, *language, str(source / name), "-x", "none", "-o", str(program), *flags)
        assert sh(str(program)) == says
    # The line of README.md, as it stands there.
    line = re.search(r"^    (cc choose_in_twenty_lines\.c .*)$", (source.parent.parent / "README.md").read_text(), re.M)
    assert line, "README.md has no line that links the fit"
    shutil.copy(source / "choose_in_twenty_lines.c", folder)
    assert sh("sh", "-c", f"cd '{folder}' && {line.group(1)} && ./choose", env=env) == chosen
    if compiles:
        flags = sh("pkg-config", "--cflags", "--libs", "--static", "cagd_exactly", env=env).split()
        sh("cc", str(source / "exactly_in_twenty_lines.c"), "-o", str(pathlib.Path(folder) / "exactly"), *flags)
        assert sh(str(pathlib.Path(folder) / "exactly"), str(curves), env=with_path) == horner
    assert first.split() == ["0.6", "0.8"], first
    print("installed, found by find_package and pkg-config, from C and C++:", first.strip())
