"""What real use met: where output goes, terminals, names that people type, files that are none.

    python3 test_manners.py CAGD ROOT WHOLE_RUN

WHOLE_RUN is the folder that whole_run.py wrote: a run over everything.
"""
import csv
import fcntl
import fractions
import json
import math
import os
import pathlib
import pty
import re
import resource
import select
import shutil
import stat
import struct
import subprocess
import sys
import tempfile
import termios
import threading
import time
import unicodedata
import unittest
import xml.etree.ElementTree

try:
    import jsonschema
except ImportError:  # ./test installs it on Debian
    jsonschema = None


WHOLE_RUN = pathlib.Path(sys.argv.pop(3)).resolve()
ROOT = pathlib.Path(sys.argv.pop(2)).resolve()
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
ARCH = ROOT / "chapters/fitting/arch.csv"
CIRCLE = ROOT / "chapters/nurbs/circle.json"
NAME = "elevation_keeps_rational_curve"


def run(*args, **options):
    return subprocess.run([CAGD, *map(str, args)], capture_output=True, text=True, timeout=600, **options)


def on_terminal(*args, rows=24, columns=60, messages=False, **environment):
    """What stands on a terminal when the program has ended, without colours, and its exit code."""
    main, other = pty.openpty()
    fcntl.ioctl(other, termios.TIOCSWINSZ, struct.pack("HHHH", rows, columns, 0, 0))
    env = {k: v for k, v in os.environ.items() if k not in ("COLUMNS", "LINES", "PAGER", "LESS")}
    p = subprocess.Popen([CAGD, *map(str, args)], stdin=other, stdout=other, stderr=other if messages else subprocess.DEVNULL,
                         env={**env, **environment})
    os.close(other)
    said = b""
    while True:
        try:
            more = os.read(main, 1 << 16)
        except OSError:
            break
        if not more:
            break
        said += more
    os.close(main)
    return re.sub(r"\x1b\[[0-9;]*m", "", said.decode().replace("\r\n", "\n")), p.wait()


def columns(line):
    return sum(0 if unicodedata.combining(c) else 2 if unicodedata.east_asian_width(c) in "WF" else 1 for c in line)


class Case(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = pathlib.Path(holder.name)
        os.chmod(self.folder, 0o755)

    def refuses(self, *args, words=(), code=2, **options):
        """Nothing on stdout, one line on stderr that has the words."""
        r = run(*args, **options)
        self.assertEqual((r.returncode, r.stdout), (code, ""), r)
        lines = r.stderr.splitlines()
        self.assertEqual(len(lines), 1, r.stderr)
        for word in words:
            self.assertIn(str(word), lines[0])
        return lines[0]


class Output(Case):
    """Nothing that was there is lost or replaced."""

    def picture(self, path, **options):
        """The picture of a fit, written to the path."""
        r = run("fit", ARCH, "--svg", path, **options)
        self.assertEqual((r.returncode, r.stderr), (0, ""), r)

    def is_picture(self, text):
        self.assertTrue(text.rstrip().endswith("</svg>"), text[-100:])

    def test_a_device_stays_one(self):
        full = self.folder / "full"  # as /dev/full, which a program that fails here would replace
        try:
            os.mknod(full, stat.S_IFCHR | 0o666, os.stat("/dev/full").st_rdev)
            open(full, "w").close()
        except OSError:
            if os.geteuid() == 0:
                self.skipTest("no devices can be made here")
            full = pathlib.Path("/dev/full")
        r = run("fit", ARCH, "--svg", full)
        self.assertEqual(r.returncode, 3)
        self.assertEqual(r.stderr, f"cagd: {full}: No space left on device; make room there, or choose another name\n")
        self.assertTrue(stat.S_ISCHR(full.stat().st_mode))

    def test_a_fifo_is_written_to(self):
        fifo, said = self.folder / "fifo", []
        os.mkfifo(fifo)
        reader = threading.Thread(target=lambda: said.append(fifo.read_text()), daemon=True)
        reader.start()
        self.picture(fifo)
        reader.join(10)
        self.assertTrue(stat.S_ISFIFO(fifo.stat().st_mode))
        self.is_picture(said[0])

    def test_links_are_followed(self):
        (self.folder / "deep").mkdir()
        target, link, second = self.folder / "deep" / "t.svg", self.folder / "l.svg", self.folder / "deep" / "m.svg"
        link.symlink_to("deep/m.svg")
        second.symlink_to("t.svg")
        self.picture(link)  # to nothing yet
        self.is_picture(target.read_text())
        target.write_text("old")
        self.picture(link)
        self.is_picture(target.read_text())
        self.assertTrue(link.is_symlink() and second.is_symlink())
        self.assertEqual(sorted(p.name for p in (self.folder / "deep").iterdir()), ["m.svg", "t.svg"])
        link.unlink()
        link.symlink_to("l.svg")
        self.refuses("fit", ARCH, "--svg", link, words=[link, "choose another name"])

    def test_both_names_of_a_file_stay_one_file(self):
        a, b = self.folder / "a.svg", self.folder / "b.svg"
        a.write_text("old")
        os.link(a, b)
        self.picture(a)
        self.assertEqual(a.stat().st_ino, b.stat().st_ino)
        self.is_picture(b.read_text())
        b.write_text("short")  # where there is no room it is not lost, though it is written in place
        r = run("fit", ARCH, "--svg", a, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)))
        self.assertEqual((r.returncode, b.read_text(), a.stat().st_ino), (3, "short", b.stat().st_ino), r)
        self.assertEqual(r.stderr, f"cagd: {a}: File too large; what was there is unchanged; make room there, or choose another name\n")
        b.write_text("long" * 100000)
        self.picture(a)
        self.is_picture(b.read_text())

    def test_modes_are_those_of_the_umask_or_stay(self):
        a, b = self.folder / "a.svg", self.folder / "b.svg"
        self.picture(a, preexec_fn=lambda: os.umask(0o077))
        self.assertEqual(stat.S_IMODE(a.stat().st_mode), 0o600)
        b.touch()
        b.chmod(0o640)
        self.picture(b)
        self.assertEqual(stat.S_IMODE(b.stat().st_mode), 0o640)
        new = self.folder / "new" / "newer"
        self.assertEqual(run("figures", "--out", new, "envelope_extra", preexec_fn=lambda: os.umask(0o077)).returncode, 0)
        for folder in new, new.parent:
            self.assertEqual(stat.S_IMODE(folder.stat().st_mode), 0o700)

    def test_what_is_read_is_not_written(self):
        points, link = self.folder / "in.csv", self.folder / "link"
        shutil.copy(ARCH, points)
        link.symlink_to("in.csv")
        for name in points, link, self.folder / "." / "in.csv":
            self.refuses("fit", points, "--svg", name, words=["--svg", name, "read"])
        with open(points) as stream:
            self.refuses("fit", "-", "--svg", points, stdin=stream, words=[points])
        curve = self.folder / "c.json"
        self.assertEqual(run("fit", ARCH, "--curve", curve).returncode, 0)
        kept = curve.read_text()
        self.refuses("fit", points, "--initial", curve, "--curve", curve, words=[curve, "read"])
        self.assertEqual((points.read_bytes(), curve.read_text()), (ARCH.read_bytes(), kept))

    def test_a_name_is_given_once(self):
        a = self.folder / "a"
        (self.folder / "link").symlink_to("a")
        for other in a, self.folder / "." / "a", self.folder / "link":
            self.refuses("fit", ARCH, "--svg", a, "--curve", other, words=["--svg", "--curve", other])
        self.refuses("fit", ARCH, "--svg", a, "--svg", self.folder / "b", words=["twice"])
        self.assertFalse(a.exists())
        null = self.folder / "null"
        null.symlink_to("/dev/null")
        r = run("fit", ARCH, "--svg", null, "--curve", null)
        self.assertEqual((r.returncode, null.is_symlink()), (0, True), r)

    def test_a_name_is_given_once_for_a_file_and_a_folder(self):
        new, report = self.folder / "j.xml", self.folder / "report"
        for options in (["--junit", new, "--certificates", new], ["--certificates", new, "--junit", new],
                        ["--junit", new, "--report", new / "deep" / "er"], ["--junit", new, "--report", self.folder / "." / "j.xml"]):
            self.refuses("verify", *options, words=["--junit", "choose another name"])
            self.assertEqual(list(self.folder.iterdir()), [])  # nothing is made of what is refused
        self.refuses("verify", "--certificates", self.folder / "made", "--report", ARCH, words=["is no folder"])
        self.assertEqual(list(self.folder.iterdir()), [])
        report.mkdir()
        for option, name in ("--report", "ledger.json"), ("--report", "summary.txt"), ("--certificates", "manifest.json"):
            self.refuses("verify", option, report, "--junit", report / name, words=["--junit", name, "choose another name"])
        self.assertEqual(list(report.iterdir()), [])

    def test_the_sources_of_a_harness_are_read(self):
        code, harness = self.folder / "code.c", self.folder / "h.md"
        code.write_text("double f(double x) { return x; }\n")
        harness.write_text(":::{exactly} it\n:source: code.c\n:declare: double f(double);\n:input: x\n:call: double r = f(x);\n:expect: r = x\n:::\n")
        self.refuses("exactly", harness, "--junit", code, words=["code.c", "is read", "--junit"])
        self.assertIn("return x", code.read_text())

    def test_a_hyphen_is_no_file(self):
        self.refuses("fit", ARCH, "--svg", "-", words=["--svg -", "/dev/stdout"], cwd=self.folder)
        self.refuses("verify", NAME, "--certificates", "-", words=["folder"], cwd=self.folder)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_standard_output_is_a_place(self):
        place = self.folder / "stdout"  # as /dev/stdout, which a program that fails here would replace
        place.symlink_to("/proc/self/fd/1")
        said = run("fit", ARCH, "--svg", place).stdout
        self.assertIn("<svg", said)
        self.assertIn("Chi-squared", said)
        out = self.folder / "out"
        with open(out, "w") as stream:
            r = subprocess.run([CAGD, "fit", ARCH, "--svg", out], stdout=stream, stderr=subprocess.PIPE, text=True)
        self.assertEqual(r.returncode, 2)
        self.assertIn(str(out), r.stderr)

    def test_what_cannot_be_written_is_noticed_first(self):
        """One claim of the whole book takes a minute; a refusal takes no time."""
        a_file, held = "choose another name", self.folder / "held"
        (held / "ledger.txt").mkdir(parents=True)
        for option, name, word in (("--junit", self.folder / "no" / "x.xml", "make it first"),
                                   ("--junit", self.folder, "name a file in it"), ("--junit", ARCH / "x", a_file),
                                   ("--junit", self.folder / ("x" * 300), a_file), ("--junit", "", "give one"),
                                   ("--report", ARCH, a_file), ("--report", "", "give one"), ("--report", held, "name a file in it"),
                                   ("--certificates", ARCH / "x", "no folder can be made there: Not a directory; choose another name"),
                                   ("--certificates", self.folder / ("x" * 300), a_file)):
            with self.subTest(option=option, name=name):
                r = subprocess.run([CAGD, "verify", option, str(name)], capture_output=True, text=True, timeout=5)
                self.assertEqual((r.returncode, r.stdout, len(r.stderr.splitlines())), (2, "", 1), r)
                self.assertIn(str(name) or "''", r.stderr)
                self.assertIn(word, r.stderr)

    def test_one_rule_for_exit_codes(self):
        """2: seen first, nothing was written; 3: writing failed.  Help and manual say so."""
        self.refuses("fit", ARCH, "--svg", self.folder, code=2)
        self.assertEqual(run("fit", ARCH, "--svg", "/dev/full").returncode, 3)
        self.assertIn("2 the call, a file that is read or the name of one to write to", run("help").stdout)
        self.assertEqual(run("--write-documents", self.folder).returncode, 0)
        manual = (self.folder / "cagd.1").read_text()
        for code, words in ("2", "the name of a file to write to has to be mended"), ("3", "something failed on the way"):
            self.assertRegex(manual, rf"\.TP\n{code}\n.*{words}")

    @unittest.skipUnless(os.geteuid() == 0, "takes the rights of root away")
    def test_of_an_ordinary_user(self):
        def as_nobody():
            os.setgid(65534), os.setuid(65534)

        mine, locked = self.folder / "mine.svg", self.folder / "locked"
        mine.write_text("kept")
        mine.chmod(0o644)
        locked.mkdir()
        writable = self.folder / "writable.svg"
        writable.write_text("old")
        writable.chmod(0o666)
        points = self.folder / "p.csv"
        shutil.copy(ARCH, points)
        program = self.folder / "cagd"
        shutil.copy(CAGD, program)
        # The program may stand where others do not look.
        for name, word in ((mine, "another name"), (locked / "x.svg", "choose another")):
            r = subprocess.run([program, "fit", points, "--svg", name], capture_output=True, text=True, preexec_fn=as_nobody)
            self.assertEqual((r.returncode, r.stdout, len(r.stderr.splitlines())), (2, "", 1), r)
            self.assertIn(str(name), r.stderr)
            self.assertIn(word, r.stderr)
        self.assertEqual(mine.read_text(), "kept")
        for args in ["figures", "envelope_extra"], ["figures", "--out", locked / "deep", "envelope_extra"], ["verify", "--report", locked]:
            r = subprocess.run([program, *args], capture_output=True, text=True, cwd=locked, preexec_fn=as_nobody)
            self.assertEqual((r.returncode, r.stdout, len(r.stderr.splitlines())), (2, "", 1), r)
        self.assertEqual(list(locked.iterdir()), [])
        r = subprocess.run([program, "fit", points, "--svg", writable], capture_output=True, text=True, preexec_fn=as_nobody)
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        self.is_picture(writable.read_text())
        self.assertEqual((writable.stat().st_uid, stat.S_IMODE(writable.stat().st_mode)), (0, 0o666))

    def test_where_a_file_finds_no_room_the_old_one_stays(self):
        """A disk that is full while a file is written: here the limit on the size of files takes its part."""
        old, new = self.folder / "old.svg", self.folder / "new.svg"
        old.write_text("kept")
        for name, words in (old, "what was there is unchanged; make room"), (new, "nothing was left there; make room"):
            r = run("fit", ARCH, "--svg", name, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)))
            self.assertEqual((r.returncode, len(r.stderr.splitlines())), (3, 1), r)
            self.assertIn(f"{name}: File too large; {words}", r.stderr)
        self.assertEqual([p.name for p in self.folder.iterdir()], ["old.svg"])
        self.assertEqual(old.read_text(), "kept")

    def test_a_full_disk_is_noticed(self):
        for args in (["--help"], ["--version"], ["help", "fit"], ["fit", "--help"], ["list"], ["show", NAME],
                     ["curve", CIRCLE, "--elevate"]):
            with open("/dev/full", "w") as full:
                r = subprocess.run([CAGD, *map(str, args)], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(r.returncode, 3, args)
            self.assertRegex(r.stderr, r"^cagd: standard output: cannot be written(: No space left on device)?; make room there, or send it elsewhere\n$")
        r = subprocess.run(f"'{CAGD}' list >&-", shell=True, capture_output=True, text=True)
        self.assertEqual((r.returncode, len(r.stderr.splitlines())), (3, 1), r)


class Places(Case):
    """Every option that writes, in every place where it cannot: as root, and as an ordinary user where root can be left."""

    INPUTS = {"fit": ["in.csv"], "check": ["basis.md"], "exactly": ["harness.md"], "lab": ["grade", "subs", "--lab", "de-casteljau"],
              "lab --svg": ["check", "answer"]}
    READ = {"lab --svg": "answer/de-casteljau.c"}  # of what is given as a folder
    # Where a name leads, for what is to be a file and for what is to be a folder; None: it may be written.
    REFUSED = {"loop": ("choose another name",) * 2, "dangling": ("make it first", "choose another name"), "file/x": ("choose another name",) * 2,
               "x" * 300: ("choose another name",) * 2, "": ("give one",) * 2, "-": ("takes the name of a file", "takes the name of a folder"),
               "input": ("is read",) + ("is no folder; choose another name",), "file": (None, "is no folder; choose another name"),
               "folder": ("name a file in it", None), "none/x": ("make it first", None), "no\nne\x1b/x": ("make it first", None), "file/\ny": ("choose another name",) * 2, "/dev/full": (None, "is no folder; choose another name")}
    OF_OTHERS = {"locked": ("name a file in it", "choose another"), "locked/x": ("choose another",) * 2,
                 "unreadable/x": ("choose another",) * 2, "readonly": ("choose another name or change what it permits", "is no folder")}

    theirs = False

    def options(self):
        """Of every command, what its help says it writes: [(command, option, whether it is a folder)]."""
        found = []
        for command in re.findall(r"^  (\w+)  ", run("help").stdout, re.M):
            for option, kind in re.findall(r"--([a-z-]+)=(FILE|DIR)\b", run("help", command).stdout):
                found.append((command, "--" + option, kind == "DIR"))
        return found

    def fill(self):
        for name in "folder", "locked", "unreadable", "subs", "answer":
            (self.folder / name).mkdir()
        shutil.copy(ROOT / "chapters/labs/de-casteljau/right/iterative.c", self.folder / "answer/de-casteljau.c")
        for name in "file", "readonly", "locked/old":
            (self.folder / name).write_text("kept")
        (self.folder / "loop").symlink_to("loop")
        (self.folder / "dangling").symlink_to("nowhere/x")
        os.link(self.folder / "file", self.folder / "second")
        shutil.copy(ARCH, self.folder / "in.csv")
        shutil.copy(ROOT / "cli/check/basis.md", self.folder / "basis.md")
        (self.folder / "harness.md").write_text(":::{exactly} it\n:source: code.c\n:declare: double f(double);\n:input: x\n:call: double r = f(x);\n"
                                                ":expect: r = x\n:::\n")
        for path in [self.folder, *self.folder.iterdir()] if self.theirs else []:
            os.chown(path, 65534, 65534, follow_symlinks=False)
        (self.folder / "readonly").chmod(0o444)
        (self.folder / "locked").chmod(0o555)
        (self.folder / "unreadable").chmod(0o000)

    def state(self):
        def what(path):
            s = path.lstat()
            return s.st_mode, s.st_ino, os.readlink(path) if path.is_symlink() else path.read_bytes() if path.is_file() else None
        return {str(path): what(path) for path in self.folder.rglob("*")}

    def refused(self, program, places, **options):
        self.fill()
        before, tried = self.state(), 0
        for command, option, is_folder in self.options():
            file = self.INPUTS.get(f"{command} {option}", self.INPUTS.get(command, []))
            for place, words in places.items():
                if words[is_folder] is None or (place == "input" and not file):
                    continue
                tried += 1
                if place == "input" and self.theirs and f"{command} {option}" in self.READ:
                    continue  # the copy of the program has no labs beside it
                read = self.READ.get(f"{command} {option}", file[0] if len(file) == 1 else "in.csv")
                name = read if place == "input" else place
                with self.subTest(command=command, option=option, place=place[:20]):
                    r = subprocess.run([program, command, *file, option, name], capture_output=True, text=True, cwd=self.folder, timeout=20, **options)
                    self.assertEqual((r.returncode, r.stdout, len(r.stderr.splitlines())), (2, "", 1), r)
                    self.assertTrue(r.stderr.startswith("cagd: "), r.stderr)
                    self.assertIn(re.sub("[\0-\x1f]", "?", name) or "''", r.stderr)
                    self.assertIn(words[is_folder], r.stderr)
        self.assertEqual(self.state(), before)
        return tried

    def test_a_name_does_not_break_the_line(self):
        """Of a file that is not there, of a claim, a command, a lab, an option."""
        name = "a\nb\x1b[31m\tc"
        for args in [name], ["show", name], ["figures", name], ["fit", name], ["curve", name], ["check", name], ["exactly", name], ["verify", name], \
                ["ledger", name], ["lab", name], ["lab", "start", name], ["lab", "check", name], ["lab", "new", name], ["lab", "test", name], \
                ["lab", "grade", name, "--lab", name, "--out", name], ["fit", ARCH, "--degree", name], ["fit", ARCH, "--" + name], ["fit", ARCH, "--initial", name]:
            with self.subTest(args=args):
                line = self.refuses(*args, cwd=self.folder)
                self.assertIn("a?b?[31m?c", line)
                self.assertNotRegex(line, "[\0-\x1f]")

    def test_of_anybody(self):
        self.assertGreater(self.refused(CAGD, self.REFUSED), 60)

    def test_of_an_ordinary_user(self):
        if os.geteuid() != 0:
            self.assertGreater(self.refused(CAGD, self.OF_OTHERS), 30)
            return
        program = self.folder.parent / (self.folder.name + "-cagd")  # it may stand where others do not look
        shutil.copy(CAGD, program)
        self.addCleanup(program.unlink)
        self.theirs = True
        self.assertGreater(self.refused(program, {**self.REFUSED, **self.OF_OTHERS}, preexec_fn=lambda: (os.setgid(65534), os.setuid(65534))), 90)

    @unittest.skipUnless(os.geteuid() == 0, "mounts a small disk")
    def test_a_disk_of_16_kilobytes(self):
        disk = self.folder / "disk"
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=16k", "tmpfs", str(disk)], capture_output=True).returncode != 0:
            self.skipTest("nothing can be mounted here")
        self.addCleanup(lambda: subprocess.run(["umount", str(disk)], check=True))
        old, first, link = disk / "old.svg", disk / "first.svg", disk / "link.svg"
        old.write_text("kept")
        first.write_text("both")
        os.link(first, disk / "second.svg")
        link.symlink_to("old.svg")
        before = sorted((p.name, p.lstat().st_ino, p.read_bytes()) for p in disk.iterdir())
        for name, words in (old, "what was there is unchanged; "), (first, "what was there is unchanged; "), (link, "what was there is unchanged; "), \
                (disk / "new.svg", "nothing was left there; "):
            r = run("fit", ARCH, "--svg", name)
            self.assertEqual(r.returncode, 3)
            self.assertEqual(r.stderr, f"cagd: {name}: No space left on device; {words}make room there, or choose another name\n")
            self.assertEqual(sorted((p.name, p.lstat().st_ino, p.read_bytes()) for p in disk.iterdir()), before)
        with open(disk / "out", "w") as out:
            r = subprocess.run([CAGD, "list"], stdout=out, stderr=subprocess.PIPE, text=True)
        self.assertEqual(r.returncode, 3)
        self.assertIn("make room there, or send it elsewhere", r.stderr)
        (disk / "out").unlink()
        self.assertEqual(subprocess.run(["mount", "-o", "remount,ro", str(disk)]).returncode, 0)
        for option, name in ("--svg", disk / "new.svg"), ("--curve", old), ("--residuals", link):
            self.refuses("fit", ARCH, option, name, words=[name, "Read-only file system; choose another"])
        self.refuses("verify", NAME, "--certificates", disk / "new", words=["Read-only file system; choose another"])
        self.assertEqual(sorted((p.name, p.lstat().st_ino, p.read_bytes()) for p in disk.iterdir()), before)

    def test_every_command_on_a_full_disk(self):
        """Nothing that existed is lost, one line says where no room is, and the exit code is that of a failure on the way."""
        disk, answers = self.folder / "disk", self.folder / "answers"
        disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(disk)], capture_output=True).returncode != 0:
            self.skipTest("nothing can be mounted here")
        self.addCleanup(lambda: subprocess.run(["umount", str(disk)], check=True))
        answers.mkdir()
        for name in "ann", "bob", "cy":
            shutil.copy(ROOT / "chapters/labs/de-casteljau/right/iterative.c", answers / f"{name}.c")
            (disk / "results" / name).mkdir(parents=True)
            for kept in "result.json", "results.json", "page.html":
                (disk / "results" / name / kept).write_text(f"{kept} of {name}")
        for name in "old.svg", "old.csv", "old.json", "old.xml", "results/results.csv", "results/manifest.json", "results/envelope_extra.svg":
            (disk / name).write_text("kept")
        (disk / "fill").touch()
        with self.assertRaises(OSError), open(disk / "fill", "wb", buffering=0) as fill:
            while True:
                fill.write(bytes(4096))

        def kept():
            return sorted((str(p), p.read_bytes()) for p in disk.rglob("*") if p.is_file())
        before, example = kept(), ROOT / "cli/check/example.md"
        commands = [["verify", NAME, "--certificates", disk / "results"], ["verify", "elevation_*", "--certificates", disk / "new"], ["verify", NAME, "--junit", disk / "old.xml"],
                    ["figures", "envelope_extra", "--out", disk / "results"], ["figures", "envelope_*", "--out", disk / "new"],
                    ["fit", ARCH, "--svg", disk / "old.svg"], ["fit", ARCH, "--residuals", disk / "old.csv"], ["fit", ARCH, "--curve", disk / "old.json"],
                    ["check", ROOT / "cli/check/basis.md", "--svg", disk / "old.svg"], ["check", example, "--certificates", disk / "results"],
                    ["check", example, "--junit", disk / "old.xml"], ["exactly", ROOT / "exact/code/example/README.md", "--certificates", disk / "results"],
                    ["lab", "start", "de-casteljau", disk / "mine"]]
        if shutil.which("bwrap"):
            commands += [["lab", "grade", answers, "--lab", "de-casteljau", "--out", disk / out] for out in ("results", "anew")]
        for args in commands:
            with self.subTest(args=args):
                r = run(*args)
                self.assertEqual((r.returncode, len(r.stderr.splitlines())), (3, 1), r.stderr)
                self.assertRegex(r.stderr, rf"^cagd: {disk}/\S+: No space left on device; (what was there is unchanged|nothing was left there); make room")
                self.assertEqual(kept(), before)
        r = run("lab", "new", "mine2", cwd=disk)
        self.assertEqual((r.returncode, len(r.stderr.splitlines())), (3, 1), r.stderr)
        self.assertEqual(kept(), before)


class Labs(Case):
    """Folders that a lab is written to, and those that it is read from."""

    def kept(self):
        return {p: p.read_bytes() if p.is_file() else None for p in self.folder.rglob("*")}

    def test_nothing_is_left_of_what_is_refused(self):
        (self.folder / "mine").mkdir()
        (self.folder / "mine/README.md").write_text("kept")
        (self.folder / "linked").mkdir()
        (self.folder / "linked/start.c").symlink_to("nowhere")
        (self.folder / "file").write_text("kept")
        (self.folder / "subs/ann").mkdir(parents=True)
        (self.folder / "subs/ann/result.json").write_text("kept")
        before, taken = self.kept(), "is not written over; name another folder"
        for args, words in ((["new", "mine"], ["mine/README.md", taken]), (["start", "de-casteljau", "mine"], ["mine/README.md", taken]),
                            (["new", "linked"], ["linked/start.c", taken]), (["new", "file"], ["file", "choose another name"]), (["new", ""], ["a name of"]),
                            (["start", "de-casteljau", "-"], ["'-'", "give one"]), (["start", "de-casteljau", ""], ["''", "give one"]),
                            (["start", "de-casteljau", "/dev/null"], ["/dev/null", "choose another name"]),
                            (["start", "conic"], ["conic", "cagd lab lists"]), (["frob"], ["frob", "grade"]), (["check"], ["cagd lab check DIR"]),
                            (["list", "--out", "made"], ["--out", "leave it out"]), (["check", "subs", "--out", "made"], ["--out", "leave it out"]),
                            (["list", "--watch"], ["--watch"]), (["check", "subs", "--watch", "--json"], ["--watch", "--json"]),
                            (["grade", "subs"], ["--lab NAME --out DIR"])):
            with self.subTest(args=args):
                self.refuses("lab", *args, words=words, cwd=self.folder)
        for out in "subs", "./subs/", "subs/ann", "subs/new/deep":
            self.refuses("lab", "grade", "subs", "--lab", "de-casteljau", "--out", out, words=[out, "is read", "choose another"], cwd=self.folder)
        self.assertEqual(self.kept(), before)

    @unittest.skipUnless(shutil.which("bwrap"), "no bubblewrap")
    def test_results_do_not_go_to_the_submissions(self):
        (self.folder / "bob").mkdir()
        (self.folder / "bob/bob.c").write_text("kept")
        (self.folder / "alias").symlink_to("bob")
        for out, student in (".", "bob"), (self.folder, "bob"), ("other/..", "bob"):
            self.refuses("lab", "grade", "bob", "--lab", "de-casteljau", "--out", out,
                         words=[f"--out {out}", f"'{student}'", "choose another folder"], cwd=self.folder)
        self.assertEqual([p.name for p in (self.folder / "bob").iterdir()], ["bob.c"])

    def test_an_answer_is_a_file(self):
        answer = self.folder / "de-casteljau.c"
        os.mkfifo(answer)
        self.refuses("lab", "check", self.folder, words=[answer, "expected the file of an answer"])
        answer.unlink()
        answer.symlink_to("other.c")
        (self.folder / "other.c").touch()
        self.refuses("lab", "check", self.folder, words=[answer, "symbolic link"])


class Terminal(Case):
    COMMANDS = [["--help"], ["help", "fit"], ["verify", "--help"], ["curve", "--help"], ["list", "end_*"], ["verify", "end_*"],
                ["ledger", "wang-ch3:3.2.*"], ["ledger", "--summary", "wang-ch3:3.2.*"], ["show", "wang-ch3:3.2.8"],
                ["show", NAME], ["fit", ARCH], ["curve", CIRCLE], ["curve", CIRCLE, "--at", "1/3", "-d", "2"],
                ["ledger", "--striking", "2", "wang-ch3:*"], ["list", "--names", "thm-*"], ["show", "table-bezier"], ["show", "--numbers", "3.4.8"],
                ["figures", "--list"], ["check", ROOT / "cli/check/example.md"], ["check", ROOT / "cli/check/basis.md"], ["help", "exactly"], ["lab", "list"], ["help", "lab"]]

    def test_every_command_is_tried(self):
        commands = re.findall(r"^  (\w+)  ", run("help").stdout, re.M)
        self.assertEqual(set(commands) - {args[k] for args in self.COMMANDS for k in (0, 1) if k < len(args)}, set())

    def test_no_line_is_wider_than_the_terminal(self):
        for args in self.COMMANDS:
            with self.subTest(args=args):
                said, code = on_terminal(*args, PAGER="")
                self.assertEqual(code, 0)
                self.assertTrue(said.strip())
                self.assertEqual([line for line in said.splitlines() if columns(line) > 60], [])

    def test_progress_is_not_wider_either(self):
        """A line of progress that is broken by the terminal cannot be taken away again."""
        said, code = on_terminal("verify", "end_*", PAGER="", messages=True)
        self.assertEqual(code, 0)
        told = [line for line in re.split(r"\r|\x1b\[K|\n", said) if line.startswith("[")]
        self.assertGreater(len(told), 5)
        self.assertEqual([line for line in told if columns(line) > 59], [])
        self.assertTrue(any(line.endswith("...") for line in told))

    def test_nothing_is_lost_in_the_breaks(self):
        said, _ = on_terminal("list", "end_*", PAGER="")
        self.assertEqual("".join(said.split()), "".join(run("list", "end_*").stdout.split()))

    def test_what_is_read_by_programs_is_not_broken(self):
        said, _ = on_terminal("list", "--json", "end_*", PAGER="")
        self.assertEqual(said, run("list", "--json", "end_*").stdout)

    def test_a_pager_for_what_is_longer_than_the_screen(self):
        pager = "sed 's/^/PAGED /'"
        said, code = on_terminal("list", PAGER=pager)
        self.assertEqual(code, 0)
        self.assertTrue(all(line.startswith("PAGED ") for line in said.splitlines()))
        self.assertNotIn("PAGED", on_terminal("list", NAME, PAGER=pager)[0])
        self.assertNotIn("PAGED", on_terminal("list", PAGER=pager, rows=5000)[0])
        self.assertNotIn("PAGED", run("list", env={**os.environ, "PAGER": pager}).stdout)

    def test_without_a_pager_all_is_printed(self):
        whole = "".join(run("list").stdout.split())
        self.assertEqual("".join(on_terminal("list", PAGER="")[0].split()), whole)
        self.assertTrue("".join(on_terminal("list", PAGER="no-such-pager 2>/dev/null")[0].split()).endswith(whole))

    def test_a_pager_may_be_left(self):
        self.assertEqual(on_terminal("list", PAGER="head -1")[1], 0)


class Help(Case):
    def test_help_of_a_command(self):
        for command in re.findall(r"^  (\w+)  ", run("help").stdout, re.M):
            self.assertEqual(run("help", command).stdout, run(command, "--help").stdout)
        self.refuses("help", "frobnicate", words=["frobnicate", "verify"])

    def test_every_name_in_an_example_exists(self):
        """Claims and statements; files are of the reader."""
        tried = 0
        for command in "verify", "list", "show", "ledger", "figures":
            for line in re.findall(r"^  cagd (%s .*)$" % command, run("help", command).stdout, re.M):
                words = re.sub(r"  .*", "", line).replace("'", "").split()[1:]
                names = [w for k, w in enumerate(words) if not w.startswith("-") and words[k - 1] not in ("--out", "--jobs")]
                if names:
                    tried += 1
                    with self.subTest(names=names):
                        r = run(*(["figures", "--list"] if command == "figures" else ["list"]), *names)
                        if command != "show":
                            self.assertEqual(r.returncode, 0, r)
                        elif r.returncode != 0:
                            self.assertEqual(run("show", *names).returncode, 0)
        self.assertGreater(tried, 6)

    def test_contributors_are_told_what_a_test_takes(self):
        """Every call of a test in CONTRIBUTING gives what its first lines ask for."""
        tried = 0
        for script, given in re.findall(r"python3 (proofs-tests/\S+/test_\w+\.py)([^`\n]*)", (ROOT / "CONTRIBUTING.md").read_text()):
            asked = re.search(r"python3 test_\w+\.py((?: \S+)*)", (ROOT / script).read_text())
            if asked:
                tried += 1
                self.assertEqual(len([w for w in given.split() if w != "CLASS"]), len(asked[1].split()), script)
        self.assertGreater(tried, 0)

    def test_there_are_changes_and_a_citation_of_this_version(self):
        version = run("--version").stdout.split()[1]
        self.assertRegex((ROOT / "CHANGELOG.md").read_text(), rf"(?m)^## {re.escape(version)}\b")
        citation = dict(re.findall(r"(?m)^([a-z-]+): *(.*)$", (ROOT / "CITATION.cff").read_text()))
        self.assertEqual(citation.get("version", "").strip('"'), version)
        self.assertLessEqual({"cff-version", "message", "title", "authors", "license"}, set(citation))

    def test_an_option_that_is_not_understood(self):
        for args, words in ((["verify", "--jsn"], "there is no option --jsn; the nearest: --json"),
                            (["fit", "--tolerence=3"], "there is no option --tolerence; the nearest: --tolerance"),
                            (["list", "--frobnicate"], "there is no option --frobnicate; the help names all"),
                            (["fit", ARCH, "-Q"], "there is no option -Q; the help names all"),
                            (["verify", "-JQ"], "there is no option -Q; the help names all"),
                            (["verify", "--=3"], "there is no option --; the help names all"),
                            (["verify", "--j"], "--j may be --junit or --json or --jobs; which is meant?"),
                            (["verify", "--json=3"], "--json takes no value; leave out '=3'"),
                            (["curve", CIRCLE, "--at"], "--at takes a value: --at T"),
                            (["figures", "-o"], "--out takes a value: --out DIR"),
                            (["verify", "-Jj"], "--jobs takes a value: --jobs N"),
                            (["verify", "--jobs", "a\nb"], "--jobs takes a whole number from 1 to 64, not 'a?b'"),
                            (["curve"], "expected the file of a curve")):
            self.assertEqual(self.refuses(*args), f"cagd {args[0]}: {words} (cagd {args[0]} --help)")
        self.refuses("verfy", words=["there is no command 'verfy'; the nearest: verify"])
        self.refuses("frobnicate", words=["expected verify, list,", "or lab"])

    def test_every_command_refuses_what_it_does_not_know(self):
        for command in re.findall(r"^  (\w+)  ", run("help").stdout, re.M):
            for word in "--frobnicate", "-_":
                self.refuses(command, word, words=[f"cagd {command}: there is no option {word}; ", f"(cagd {command} --help)"])

    def test_options_may_be_short_and_shortened(self):
        for args in (["list", "--js", NAME], ["list", "-J", NAME], ["list", NAME, "-J"]):
            self.assertEqual(run(*args).stdout, run("list", "--json", NAME).stdout)
        for args in (["-t1/2", "-d", "1"], ["-lt", "1/2", "--der=1"], ["-t", "1/2", "--derivatives", "1", "--"]):
            r = run("curve", *args, CIRCLE)
            self.assertEqual((r.returncode, r.stderr), (0, ""), args)
            self.assertIn("derivative 1", r.stdout)
        self.assertEqual(run("curve", "--hel", "--frobnicate").stdout, run("help", "curve").stdout)
        self.assertIn("[--junit=FILE]", run("verify", "--usage").stdout)
        self.refuses("verify", "--", "--json", words=["no statement or claim is called '--json'"])

    def test_options_that_contradict_each_other(self):
        self.refuses("verify", "--json", "--tap", NAME, words=["--json", "--tap"])
        self.refuses("ledger", "--json", "--summary", words=["one form"])
        self.refuses("figures", "--list", "--out", self.folder, words=["--out"])


class Formulas(Case):
    FILE = """:::{statement} square
:printed: (1+2)^2 = 9
:::

:::{let}
x \\in \\mathbb{R}
:::

:::{statement} <wrong>
:printed: x^2 \\ge x
:::

:::{statement} known
:printed: x = x + 1
:expected: fails
:::
"""

    def test_junit(self):
        file, out = self.folder / "f.md", self.folder / "r.xml"
        file.write_text(self.FILE)
        r = run("check", file, "--junit", out)
        self.assertEqual((r.returncode, r.stderr), (1, ""))
        self.assertEqual(r.stdout, run("check", file).stdout)
        suite = xml.etree.ElementTree.parse(out).getroot()
        self.assertEqual([suite.get(key) for key in ("name", "tests", "failures", "errors")], ["cagd check", "3", "1", "0"])
        self.assertEqual([(case.get("classname"), case.get("name"), len(case)) for case in suite],
                         [(str(file), "square", 0), (str(file), "<wrong>", 1), (str(file), "known", 0)])
        failure = suite[1][0]
        self.assertEqual(failure.get("message"), "fails, expected holds")
        x = fractions.Fraction(re.match(r"x = (\S+); left", failure.text)[1])
        self.assertLess(x * x, x)
        self.refuses("check", file, "--junit", file, words=[file, "read"])
        self.refuses("check", file, "--junit", self.folder / "no" / "x", words=["make it first"])


class Completion(Case):
    """What zsh and fish complete.  The shells themselves read the files where they are installed (test_cli.py); here the grammar
    that the files use is read by its rules, and that of zsh is executed by bash, which has the same words for it."""

    def setUp(self):
        super().setUp()
        self.assertEqual(run("--write-documents", self.folder).returncode, 0)
        self.helps = {c: run("help", c).stdout for c in re.findall(r"^  (\w+)  ", run("help").stdout, re.M)}

    def is_described(self, command, option, text):
        """The text is what the help says of the option, every sign of it."""
        squeezed = "".join(self.helps[command].split())
        self.assertIn("".join(text.split()), squeezed[squeezed.index("--" + option):], (command, option))

    def options(self, command):
        return set(re.findall(r"--([a-z-]+)", run(command, "--usage").stdout)) - {"help", "usage"}

    def fish_words(self, line):
        """The words of a line by the rules of fish: between single quotes a backslash stands before a quote or a backslash alone."""
        words, word, at = [], None, 0
        while at < len(line):
            c = line[at]
            if c == " ":
                words += [word] if word is not None else []
                word = None
            elif c == "'":
                word, at = word or "", at + 1
                while line[at] != "'":
                    at += line[at] == "\\" and line[at + 1] in "\\'"
                    word, at = word + line[at], at + 1
            else:
                at += c == "\\"
                self.assertTrue(c == "\\" or re.match(r"[\w./=-]", c), line)
                word = (word or "") + line[at]
            at += 1
        return words + ([word] if word is not None else [])

    def test_fish(self):
        options, commands = {c: {} for c in self.helps}, {}
        for line in (self.folder / "cagd.fish").read_text().splitlines():
            if line.startswith("#"):
                continue
            words = iter(self.fish_words(line))
            self.assertEqual([next(words), next(words), next(words)], ["complete", "-c", "cagd"])
            said = {}
            for flag in words:
                self.assertIn(flag, ("-n", "-f", "-F", "-r", "-x", "-a", "-l", "-d"), line)
                self.assertNotIn(flag, said, line)
                said[flag] = True if flag in ("-f", "-F", "-r", "-x") else next(words)
            if said.get("-n") == "__fish_use_subcommand":
                commands[said["-a"]] = said["-d"]
            elif "-n" in said:
                seen, command = said["-n"].split()
                self.assertEqual(seen, "__fish_seen_subcommand_from")
                if "-l" in said:
                    options[command][said["-l"]] = said
                    self.is_described(command, said["-l"], said["-d"])
                elif "-a" in said:
                    self.assertRegex(said["-a"], r"^\(cagd (list --names|figures --list) 2>/dev/null\)$")
        self.assertEqual(list(commands), list(self.helps))
        for command, summary in commands.items():
            self.assertIn(summary, " ".join(run("help").stdout.split()))
            self.assertEqual(set(options[command]), self.options(command))
        self.assertEqual(options["fit"]["loss"]["-a"].split()[1], "huber")
        self.assertTrue({"-r", "-F"} <= set(options["fit"]["svg"]) and "-x" in options["verify"]["jobs"])

    # What is zsh's own, in bash's words; _arguments and _describe print what they are given.
    IN_BASH = (("$words[2]", "$COMMAND"), ("shift words", ":"), ("_describe command commands", 'printf "%s\\0" "${commands[@]}"'))

    def given_by_zsh(self, command=""):
        text = (self.folder / "_cagd").read_text()
        self.assertTrue(text.startswith("#compdef cagd\n"))
        for zsh, bash in self.IN_BASH:
            self.assertEqual(text.count(zsh), 1)
            text = text.replace(zsh, bash)
        script = '_arguments() { printf "%s\\0" "$@"; }\n_complete() {\n' + text + "}\n_complete\n"
        r = subprocess.run(["bash", "-c", script], capture_output=True, text=True,
                           env={**os.environ, "COMMAND": command, "CURRENT": "3" if command else "2"})
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        return r.stdout.split("\0")[:-1]

    def test_zsh(self):
        rows = [re.fullmatch(r"([a-z]+):((?:[^\\:]|\\.)+)|([a-z]+):(.+)", row) for row in self.given_by_zsh()]
        self.assertTrue(all(rows))
        self.assertEqual([row[1] or row[3] for row in rows], list(self.helps))
        for command in self.helps:
            found = {}
            *specs, last = self.given_by_zsh(command)
            for spec in specs:
                # *--option=[what it is]:argument:action, brackets and colons of texts behind a backslash.
                row = re.fullmatch(r"(\*?)--([a-z-]+)(=?)\[((?:[^\\\[\]:]|\\[\[\]:\\])+)\](?::((?:[^\\:]|\\.)+):(_files|\([\w ,-]+\))?)?", spec)
                self.assertTrue(row, spec)
                self.assertEqual(bool(row[3]), row[5] is not None, spec)
                found[row[2]] = row
                if row[2] != "help":
                    self.is_described(command, row[2], re.sub(r"\\(.)", r"\1", row[4]))
            self.assertEqual(set(found) - {"help"}, self.options(command))
            self.assertRegex(last, r"^(\*:\w+:\{compadd -- \$\(cagd (list --names|figures --list) 2>/dev/null\)\}|\*?:file:_files)$")

    # A command in its own words, completed with the tabulator; what it prints begins with the completed name.
    BEGUN = (("wang-ch3:thm-3.3.2-con", "wang-ch3:thm-3.3.2-contact"), ("elevation_keeps_rational_c", NAME),
             ("rational-bezier.elevation_keeps_rational_c", NAME), ("'wang-ch3:thm-3.3.2-con", "wang-ch3:thm-3.3.2-contact"),
             ("slides-ch4:table-b", "slides-ch4:table-bezier"))

    def typed(self, shell, prepare, line):
        """What stands on the terminal of the shell when the line was typed."""
        main, other = pty.openpty()
        env = {**os.environ, "PATH": str(pathlib.Path(CAGD).parent) + os.pathsep + os.environ["PATH"], "TERM": "dumb", "PAGER": "",
               "HOME": str(self.folder)}
        p = subprocess.Popen(shell, stdin=other, stdout=other, stderr=other, env=env, start_new_session=True)
        os.close(other)
        said = b""

        def until(mark):
            nonlocal said
            end = time.monotonic() + 60
            while mark not in said and time.monotonic() < end:
                if select.select([main], [], [], 1)[0]:
                    said += os.read(main, 1 << 16)
            self.assertIn(mark, said)

        os.write(main, f"{prepare}; printf '%s%s\\n' READ Y\n".encode())
        until(b"READY\r\n")
        os.write(main, f"{line}\t".encode())
        os.write(main, b"\nprintf '%s%s\\n' DO NE\n")
        until(b"DONE\r\n")
        p.kill(), p.wait(), os.close(main)
        return said.decode(errors="replace").replace("\r\n", "\n")

    def test_ids_are_completed_in_bash_whose_words_end_at_a_colon(self):
        for begun, wanted in self.BEGUN:
            with self.subTest(begun=begun):
                said = self.typed(["bash", "--norc", "--noprofile", "-i"], f"source {self.folder}/cagd.bash", f"cagd list --names {begun}")
                self.assertIn(f"\n{wanted}\n", said)
                self.assertNotIn("cagd: no ", said)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is missing")
    def test_ids_are_completed_in_zsh(self):
        prepare = f"fpath=({self.folder} $fpath); autoload -U compinit; compinit -u -D"
        for begun, wanted in self.BEGUN:
            with self.subTest(begun=begun):
                said = self.typed(["zsh", "-f", "-i"], prepare, f"cagd list --names {begun}")
                self.assertIn(f"\n{wanted}\n", said)
                self.assertNotIn("cagd: no ", said)

    @unittest.skipUnless(shutil.which("fish"), "fish is missing")
    def test_ids_are_completed_in_fish(self):
        env = {**os.environ, "PATH": str(pathlib.Path(CAGD).parent) + os.pathsep + os.environ["PATH"], "HOME": str(self.folder)}
        for begun, wanted in self.BEGUN:
            if begun[0] != "'":
                r = subprocess.run(["fish", "-c", f"source {self.folder}/cagd.fish; complete -C 'cagd show {begun}'"],
                                   capture_output=True, text=True, env=env)
                self.assertIn(wanted, [name.split(".")[-1] if "." in begun and ":" not in begun else name for name in r.stdout.split()], r)


class Names(Case):
    """What people type for a statement."""

    def shown(self, text):
        r = run("show", "--json", text)
        self.assertEqual((r.returncode, r.stderr), (0, ""), r)
        return json.loads(r.stdout)["statement"]["id"]

    def test_the_end_of_an_id_and_the_words_of_the_book(self):
        for text in ("thm-3.3.2", "定理3.3.2", "定理 3.3.2", "Theorem 3.3.2", "theorem 3.3.2", "wang-ch3:定理3.3.2"):
            self.assertEqual(self.shown(text), "wang-ch3:thm-3.3.2", text)
        for text in "(3.2.8)", "式(3.2.8)", "公式（3.2.8）", "formula 3.2.8", "eq. (3.2.8)":
            self.assertEqual(self.shown(text), "wang-ch3:3.2.8", text)
        self.assertEqual(self.shown("曲线是族的包络"), "wang-ch3:thm-3.3.2")
        for command in "list", "verify":  # the same names, wherever claims are meant
            self.assertEqual(run(command, "thm-3.2.1").stdout.split()[:3], run(command, "wang-ch3:thm-3.2.1").stdout.split()[:3])

    def test_what_may_be_several_is_listed(self):
        self.refuses("show", "3.3.2", words=["wang-ch3:3.3.2", "wang-ch3:thm-3.3.2", "which"])
        self.refuses("show", "3.2.4", words=["wang-ch3:3.2.4-left", "wang-ch3:prop-3.2.4"])
        self.refuses("show", "包络", words=["titles", "wang-ch3:thm-3.3.2", "cagd list '包络'"])

    def test_titles_are_searched(self):
        for text in "包络", "envelope", "ENVELOPE":
            self.assertGreater(len(run("list", text).stdout.splitlines()), 5)
        rows = json.loads(run("list", "--json", "升阶").stdout)["claims"]
        self.assertIn(NAME, [row["name"] for row in rows])
        self.assertTrue(all("升阶" in row["title_zh"] for row in rows))

    def test_the_end_of_an_id_is_taken_where_only_one_ends_so(self):
        """Whatever words it begins with: what is behind the source of every id."""
        ids = [s["id"] for s in json.loads((WHOLE_RUN / "report/ledger.json").read_text())["statements"]]
        names = [name for name in run("list", "--names").stdout.split() if name not in ids]
        tried = 0
        for word in "formula-", "properties-", "prop-", "thm-", "def-", "fig-", "sec-", "eq-", "alg", "lemma-", "cor-":
            places = [i.split(":")[1] for i in ids if i.split(":")[1].startswith(word)]
            for place in [p for p in places if sum(re.search(r"(^|[:_-])" + re.escape(p) + "$", n) is not None for n in ids + names) == 1][:4]:
                tried += 1
                wanted = next(i for i in ids if i.endswith(":" + place))
                self.assertIn(wanted, run("list", "--names", place).stdout.split(), place)
        self.assertGreater(tried, 25)

    def test_every_name_is_listed(self):
        claims = json.loads((WHOLE_RUN / "verify.json").read_text())["claims"]
        ids = [s["id"] for s in json.loads((WHOLE_RUN / "report/ledger.json").read_text())["statements"]]
        tables = {i[:i.index("-row-")] for i in ids if "-row-" in i}
        names = run("list", "--names").stdout.split("\n")[:-1]
        self.assertEqual(len(names), len(set(names)))
        self.assertEqual(set(names), {*ids, *tables, *(c["name"] for c in claims), *(c["chapter"] + "." + c["name"] for c in claims)})
        for name in "slides-ch4:table-bezier", "wang-ch3:3.2.8", NAME, "rational-bezier." + NAME:
            self.assertIn(name, names)
            self.assertEqual(run("show", name).returncode, 0)
        self.assertEqual(set(run("list", "--names", "thm-3.3.2").stdout.split()) & set(ids), {"wang-ch3:thm-3.3.2"})
        self.refuses("list", "--names", "--json", words=["--names", "--json"])

    def test_a_table_without_its_source(self):
        self.assertEqual(run("show", "table-bezier").stdout, run("show", "slides-ch4:table-bezier").stdout)
        for command in "list", "ledger":
            rows = run(command, "table-bezier").stdout
            self.assertEqual(rows, run(command, "slides-ch4:table-bezier-row-*").stdout)
            self.assertGreater(len(rows.splitlines()), 10)

    def test_patterns_without_a_source(self):
        for command in "show", "list", "ledger":
            said = run(command, "thm-3.3.*")
            self.assertEqual((said.returncode, said.stdout), (0, run(command, "*:thm-3.3.*").stdout))
        self.assertIn("wang-ch3:thm-3.3.2 ", said.stdout)

    def test_patterns_in_show(self):
        pages = run("show", "wang-ch3:thm-3.2.*").stdout.split("\n\n\n")
        wanted = [w for w in run("ledger", "wang-ch3:thm-3.2.*").stdout.split() if re.fullmatch(r"wang-ch3:thm-3\.2\..*", w)]
        self.assertEqual(len(pages), len(wanted))
        self.refuses("show", "--json", "wang-ch3:thm-3.*", words=["one id", "matches"])
        self.refuses("show", "no-such-*", words=["matches"])

    def test_names_are_near_or_not_offered(self):
        for name in "xyzzy", "定理9.9.9", "no-such-claim", "nothing-of-the-kind:*":
            self.assertNotIn("nearest", self.refuses("show", name, words=[name, "cagd list", "cagd ledger"]))
        self.refuses("show", "wang-ch3:thm-3.3.3", words=["nearest: wang-ch3:thm-3.3"])
        self.refuses("show", NAME[:-1] + "s", words=["nearest: " + NAME])
        self.refuses("show", "envelope_extra", words=["figure", "cagd figures"])
        self.assertNotIn("nearest", self.refuses("figures", "xyzzy", words=["cagd figures --list"]))


class Curves(Case):
    BIG = 200

    def big(self, weights, n=BIG, p=30):
        """Degree 30, 200 points: what a curve may be, and is not printed by hand."""
        inner = [f"{i}/{n - p}" for i in range(1, n - p)]
        curve = {"kind": "nurbs" if weights else "bspline", "degree": p, "knots": [0] * (p + 1) + inner + [1] * (p + 1),
                 "points": [[f"{i * i % 97}/{i % 13 + 1}", i * 31 % 101] for i in range(n)]}
        if weights:
            curve["weights"] = [i % 7 + 1 for i in range(n)]
        path = self.folder / "big.json"
        path.write_text(json.dumps(curve))
        return path

    def curve(self, document):
        path = self.folder / "c.json"
        path.write_text(document if isinstance(document, str) else json.dumps(document))
        return path

    def values(self, path, *options):
        return json.loads(run("curve", path, "--json", *options).stdout)["values"]

    def test_a_large_curve_takes_seconds(self):
        """Before, elevation took half a minute and more, and 300 MB; the same limits for all."""
        def limited():
            resource.setrlimit(resource.RLIMIT_CPU, (12, 12))
            resource.setrlimit(resource.RLIMIT_AS, (150 << 20, 150 << 20))

        for weights in False, True:
            path = self.big(weights)
            wanted = self.values(path, "--at", "0.3")[0]["derivatives"]
            for options in ["--elevate"], ["--bezier"], ["--at", "0.3", "-d", "64"]:
                r = run("curve", path, *options, preexec_fn=limited)
                self.assertEqual((r.returncode, r.stderr), (0, ""), options)
                if options == ["--elevate"]:
                    higher = json.loads(r.stdout)
                    self.assertEqual(higher["degree"], 31)
                    self.assertEqual(self.values(self.curve(higher), "--at", "0.3")[0]["derivatives"], wanted)
                if options == ["--bezier"]:
                    segments = json.loads(r.stdout)
                    self.assertEqual(len(segments), self.BIG - 30)
                    self.assertEqual(self.values(self.curve(segments[51]), "--at", "0.3")[0]["derivatives"], wanted)

    def test_what_takes_longer_says_so_on_a_terminal(self):
        path = self.big(True, 150, 64)
        main, other = pty.openpty()
        p = subprocess.Popen([CAGD, "curve", str(path), "--bezier"], stdout=subprocess.DEVNULL, stderr=other)
        os.close(other)
        said = b""
        while b" s, " not in said or not said.endswith(b"\r\x1b[K"):
            try:
                more = os.read(main, 1 << 16)
            except OSError:
                break
            said += more
        self.assertEqual(p.wait(), 0)
        os.close(main)
        self.assertRegex(said.decode(), r"^\r\x1b\[Kcurve of degree 64: 2 s, \d+ of 86 segments\r\x1b\[K")
        self.assertTrue(said.endswith(b"\r\x1b[K"))
        self.assertEqual(run("curve", path, "--bezier").stderr, "")
        self.assertLess(max(map(len, re.split(r"\r\x1b\[K", said.decode()))), 61)

    def test_a_curve_is_called_what_it_is(self):
        points, knots = [[0, 0], [1, 2], [3, 0]], [0, 0, 0, 1, 1, 1]
        for document, words in (({"kind": "bezier"}, "Bézier curve of degree 2"), ({"kind": "rational-bezier", "weights": [1, 2, 1]}, "rational Bézier curve of degree 2"),
                                ({"kind": "bspline", "degree": 2, "knots": [0, 0, 0, 2, 2, 2]}, "B-spline curve of degree 2"),
                                ({"kind": "nurbs", "degree": 2, "knots": knots, "weights": [1, 2, 1]}, "rational Bézier curve of degree 2"),
                                ({"kind": "nurbs", "degree": 2, "knots": [0, 0, 0, 2, 2, 2], "weights": [1, 2, 1]}, "NURBS curve of degree 2")):
            said = run("curve", self.curve({**document, "points": points})).stdout
            self.assertTrue(said.startswith(words), said)
            self.assertEqual("knots" in said, "Bézier" not in words)

    def test_a_bezier_curve_is_written_back_as_one(self):
        for document in ({"kind": "bezier", "degree": 2, "points": [[0, 0], [1, 2], [3, 0]]},
                         {"kind": "rational-bezier", "degree": 2, "points": [[0, 0], [1, 2], [3, 0]], "weights": [1, 2, 1]}):
            path = self.curve(document)
            self.assertEqual(json.loads(run("curve", path, "--json").stdout)["curve"], document)
            higher = json.loads(run("curve", path, "--elevate").stdout)
            self.assertEqual((higher["kind"], "knots" in higher), (document["kind"], False))
            self.assertIn("knots", json.loads(run("curve", path, "--insert", "1/2").stdout))

    def test_curvature_has_a_sign_in_the_plane(self):
        left = {"kind": "bezier", "points": [[0, 0], [1, 0], [1, 1]]}
        right = {"kind": "bezier", "points": [[0, 0], [1, 0], [1, -1]]}
        space = {"kind": "bezier", "points": [[0, 0, 0], [1, 0, 0], [1, -1, 0]]}
        for document, sign in (left, 1), (right, -1), (space, 1):
            path = self.curve(document)
            value = self.values(path, "--at", "0")[0]
            self.assertEqual((value["curvature"], value["curvature_squared"]), (sign * 0.5, "1/4"))
            self.assertIn(f"  curvature     {sign * 0.5}\n", run("curve", path, "--at", "0").stdout)
        self.assertNotIn("curvature", self.values(self.curve({"kind": "bezier", "points": [[0], [1]]}), "--at", "0")[0])

    def test_options_that_do_nothing_are_refused(self):
        self.refuses("curve", CIRCLE, "--derivatives", "2", words=["--derivatives", "--at"])
        self.refuses("curve", CIRCLE, "--left", words=["--left"])
        self.refuses("curve", CIRCLE, "--csv", words=["--csv"])
        self.refuses("curve", CIRCLE, "--csv", "--json", "--at", "0", words=["one format"])
        self.refuses("curve", CIRCLE, "--elevate", "--at-file", "x.txt", words=["--at belongs"])
        self.refuses("curve", "-", "--at-file", "-", words=["standard input"])

    def test_many_parameters_from_a_file(self):
        rows = [f"{k}/1000" for k in range(0, 4001)]
        file = self.folder / "t.txt"
        file.write_text("# parameters\n\n" + "\r\n".join(rows))
        table = list(csv.DictReader(run("curve", CIRCLE, "--at-file", file, "--csv", "-d", "1").stdout.splitlines()))
        self.assertEqual(list(table[0]), ["t", "x", "y", "x_1", "y_1", "curvature"])
        self.assertEqual(len(table), len(rows))
        for row, text in zip(table, rows):
            self.assertEqual(float(row["t"]), float(fractions.Fraction(text)))
            self.assertAlmostEqual(math.hypot(float(row["x"]), float(row["y"])), 1, 15)
            self.assertAlmostEqual(float(row["curvature"]), 1, 15)
        exact = self.values(CIRCLE, "--at-file", file)
        self.assertEqual([v["rounded"][0] for v in exact], [[float(row["x"]), float(row["y"])] for row in table])
        self.assertEqual(len(re.findall("^at t = ", run("curve", CIRCLE, "--at-file", file).stdout, re.M)), len(rows))
        file.write_text("0\n1/3\nzwei\n")
        self.refuses("curve", CIRCLE, "--at-file", file, "--csv", words=[file, "line 3", "'zwei'"])
        file.write_text("0\n9\n")
        self.refuses("curve", CIRCLE, "--at-file", file, "--csv", words=["outside the domain", "9"])
        self.refuses("curve", CIRCLE, "--at-file", self.folder / "none", words=["none", "one a line"])
        self.refuses("curve", CIRCLE, "--at-file", self.folder, words=["directory"])

    def test_every_command_says_which_file_it_expects(self):
        empty, noise, huge = (self.folder / name for name in ("empty", "noise", "huge.json"))
        empty.touch()
        noise.write_bytes(bytes(range(255, 127, -1)) * 4)
        huge.write_text('{"kind": "bezier", "points": [[0, 0], [1e99999, 1]]}')
        for command, what in ("fit", "the points"), ("check", "formulas"), ("curve", "a curve"), ("exactly", "blocks"):
            self.refuses(command, self.folder / "none", words=["none", "No such file", "expected the file of " + what])
            self.refuses(command, self.folder, words=[self.folder, "is a folder", "expected the file of " + what])
            for file in empty, noise, pathlib.Path("/dev/null"), huge:
                self.refuses(command, file, words=[file, "quotes" if (command, file) == ("curve", huge) else "expected"])

    def test_what_does_not_end_is_told(self):
        for command in "check", "exactly", "curve":
            self.refuses(command, "/dev/zero", words=["/dev/zero", "largest size that is read; "])
        self.refuses("fit", "", words=["'': No such file"])

    def test_files_that_are_none(self):
        line = {"kind": "bezier", "points": [[0], [1]]}
        marked = self.folder / "marked.json"
        marked.write_bytes(b"\xef\xbb\xbf" + json.dumps(line).encode())
        self.assertEqual(run("curve", marked).stdout, run("curve", self.curve(line)).stdout)
        self.refuses("curve", self.folder, words=[self.folder, "is a folder", "the file of a curve"])
        self.refuses("curve", self.folder / "none", words=["No such file", "the file of a curve"])
        self.refuses("curve", self.curve(" \n"), words=["empty", "kind"])
        self.refuses("curve", self.curve('{"kind": "bezier", "points": [[1e400], [1]]}'), words=["in quotes", "line 1"])
        self.refuses("curve", self.curve({"kind": "bezier", "points": [["1e999999999"], [1]]}),
                     words=["points[0]", "exponent", "99999"])
        self.refuses("curve", CIRCLE, "--at", "1e999999", words=["exponent", "99999"])
        large = self.curve({"kind": "bezier", "points": [["1e5000"], [1]]})
        self.assertEqual(self.values(large, "--at", "0")[0]["rounded"], [[None]])
        self.assertIn("1" + 5000 * "0", run("curve", large, "--at", "0", "--json").stdout)
        self.assertIn("beyond binary64", run("curve", large, "--at", "0").stdout)


@unittest.skipIf(jsonschema is None, "python3-jsonschema is missing")
class Schemas(Case):
    """What is printed and written as JSON is what the installed schemas say."""

    @classmethod
    def setUpClass(cls):
        cls.schemas = {p.name: json.loads(p.read_text()) for p in sorted((ROOT / "cli/schemas").iterdir())}

    def validator(self, name):
        schema = self.schemas[name + ".schema.json"]
        return jsonschema.Draft202012Validator(schema, resolver=jsonschema.RefResolver("", schema, store=self.schemas))

    def errors(self, document, name=None):
        name = name or document["schema"]
        return [f"{'/'.join(map(str, e.absolute_path))}: {e.message[:200]}" for e in self.validator(name).iter_errors(document)]

    def fits(self, document, name=None):
        self.assertEqual(self.errors(document, name), [])

    def said(self, *args, code=0):
        r = run(*args)
        self.assertEqual(r.returncode, code, r)
        return json.loads(r.stdout)

    def test_every_schema_is_one_and_is_named_by_its_file(self):
        for name, schema in self.schemas.items():
            jsonschema.Draft202012Validator.check_schema(schema)
            self.assertEqual(schema["$id"], name)

    def test_every_format_has_one(self):
        formats = set()
        for path in [*(ROOT / "cli").rglob("*.c"), *(ROOT / "chapters/judge").rglob("*.c")]:
            formats |= set(re.findall(r"cagd-[a-z]+(?:-[a-z]+)*-\d+(?=\\?\")", path.read_text()))
        self.assertGreater(len(formats), 8)
        self.assertEqual({name + ".schema.json" for name in formats} - set(self.schemas), set())

    def test_the_whole_book(self):
        self.fits(json.loads((WHOLE_RUN / "verify.json").read_text()))
        self.fits(json.loads((WHOLE_RUN / "report/ledger.json").read_text()))
        self.fits(json.loads((WHOLE_RUN / "certificates/manifest.json").read_text()))
        tried = 0
        for folder in sorted((WHOLE_RUN / "certificates").iterdir()):
            for path in sorted(folder.iterdir() if folder.is_dir() else [])[::10]:
                if path.stat().st_size < 100000:
                    tried += 1
                    self.fits(json.loads(path.read_text()))
        self.assertGreater(tried, 100)

    def test_what_commands_print(self):
        for args in (["check", "--json", ROOT / "proofs-tests/check/bases.md"], ["check", "--json", ROOT / "proofs-tests/check/every.md"], ["check", "--json", ROOT / "proofs-tests/check/c-curves.md"], ["verify", "--json", "end_*"], ["list", "--json"], ["ledger", "--json", "wang-ch3:3.2.*"],
                     ["show", "--json", "wang-ch3:thm-3.3.2"], ["show", "--json", NAME], ["fit", ARCH, "--json"],
                     ["show", "--json", "slides-ch4:table-bezier"], ["fit", ARCH, "--json", "--no-verify"],
                     ["fit", ARCH, "--json", "--loss", "cauchy"], ["fit", ARCH, "--json", "--unordered"],
                     *(["fit", ROOT / "proofs-tests/fit/real" / name, "--json"] for name in ("disc-traced.tsv", "coil.json", "naca2412.dat")),
                     ["curve", CIRCLE, "--json"], ["curve", CIRCLE, "--json", "--at", "1/3", "--at", "2", "-d", "3"]):
            with self.subTest(args=args):
                self.fits(self.said(*args))
        with tempfile.TemporaryDirectory() as folder: # formulas of all kinds, and what is certified of them
            r = run("check", "--json", "--certificates", folder, ROOT / "proofs-tests/check/page.md")
            self.fits(json.loads(r.stdout))
            for path in pathlib.Path(folder).rglob("*.json"):
                self.fits(json.loads(path.read_text()))

    @unittest.skipUnless(pathlib.Path(CAGD).with_name("cagd-compile-exactly").exists(), "built without LLVM")
    def test_code_that_is_run_exactly(self):
        page = ROOT / "exact/code/example/README.md"
        for options in [], ["--rounding=20", "--only", "casteljau_is_bernstein"]:
            r = run("exactly", page, "--json", *options)
            self.assertEqual(r.returncode, 0 if options else 1, r.stderr)
            self.fits(json.loads(r.stdout))

    @unittest.skipUnless(pathlib.Path(CAGD).with_name("cagd-compile-exactly").exists(), "built without LLVM")
    def test_labs(self):
        self.fits(self.said("lab", "list", "--json"))
        lab, labs = self.folder / "lab", ROOT / "chapters/labs/de-casteljau"
        self.assertEqual(run("lab", "start", "de-casteljau", lab).returncode, 0)
        self.fits(self.said("lab", "check", lab, "--json", code=1))  # what is begun with
        for answer, code in ((labs / "right/iterative.c").read_text(), 0), ("#error\n", 1), ("#include <stdlib.h>\nint f(void) { return system(0); }\n", 1):
            (lab / "de-casteljau.c").write_text(answer)
            self.fits(self.said("lab", "check", lab, "--json", code=code))
        self.assertEqual(run("lab", "new", "mine", cwd=self.folder).returncode, 0)
        self.fits(self.said("lab", "test", self.folder / "mine", "--json"))
        if shutil.which("bwrap"):
            (self.folder / "class/cy").mkdir(parents=True)
            shutil.copy(lab / "de-casteljau.c", self.folder / "class/bob.c")
            r = run("lab", "grade", self.folder / "class", "--lab", "de-casteljau", "--out", self.folder / "out")
            self.assertEqual(r.returncode, 0, r)
            for student in "bob", "cy":
                self.fits(json.loads((self.folder / "out" / student / "result.json").read_text()))

    def test_every_format_that_commands_print_is_validated(self):
        """A format without a document in these tests is one that nobody tried."""
        tests = pathlib.Path(__file__).read_text()
        for word in re.findall(r"^  (\w+)  ", run("help").stdout, re.M):
            if "--json" in run("help", word).stdout:
                self.assertRegex(tests, rf'(said\(|\[)"{word}"|run\("{word}", page, "--json"', word)

    def test_what_is_printed_of_claims_that_fail(self):
        tried = 0
        for path in sorted((ROOT / "proofs-tests/unit/command-output").glob("*.json")):
            document = json.loads(path.read_text())
            if "schema" in document:
                tried += 1
                with self.subTest(path=path.name):
                    self.fits(document)
        self.assertGreater(tried, 8)

    def test_formulas_of_a_reader(self):
        for path in sorted((ROOT / "proofs-tests/fuzz/corpus/formula").glob("*.md"))[:12]:
            r = run("check", "--json", path)
            if r.returncode in (0, 1):
                self.fits(json.loads(r.stdout))

    def test_curves_as_files_have_them(self):
        for path in [CIRCLE, *sorted((ROOT / "chapters").rglob("*.json"))]:
            self.fits(json.loads(path.read_text()), "cagd-curve-file-1")
        for option in ["--elevate"], ["--bezier"], ["--split", "1/2"], ["--insert", "1/2"]:
            self.fits(self.said("curve", CIRCLE, *option), "cagd-curve-file-1")
        curve = self.folder / "c.json"
        run("fit", ARCH, "--curve", curve)
        self.fits(json.loads(curve.read_text()), "cagd-curve-file-1")

    def test_other_documents_do_not_fit(self):
        """What the program refuses, and fields that nobody knows."""
        good = json.loads(CIRCLE.read_text())
        for change in ({"kind": "spline"}, {"degree": 65}, {"knot": [1]}, {"points": [[1, 2, 3, 4]]}, {"points": [["x", 1]]},
                       {"weights": None}, {"kind": "bezier"}):
            self.assertNotEqual(self.errors({**good, **change}, "cagd-curve-file-1"), [], change)
        for args in ["list", "--json", "end_*"], ["show", "--json", NAME], ["curve", CIRCLE, "--json", "--at", "0"]:
            document = self.said(*args)
            self.assertNotEqual(self.errors({**document, "further": 1}), [])
            for field in document:
                if field != "schema":
                    self.assertNotEqual(self.errors({k: v for k, v in document.items() if k != field}), [], field)


if __name__ == "__main__":
    unittest.main(verbosity=1, warnings="ignore")  # RefResolver, which Debian 12 has, is called old by later versions
