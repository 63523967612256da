"""The red team: answers that try to talk the grader into a mark, graded as one class together with honest ones.

Each attack is the same wrong answer, with something beside it. Its mark must be at most that of the wrong answer alone, and it must have
none for what is wrong; the honest answers have their marks, and nothing is written but the results.

    python3 test_attacks.py CAGD ROOT
"""
import csv
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

ROOT = pathlib.Path(sys.argv.pop(2)).resolve()
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
LAB = ROOT / "chapters/labs/de-casteljau"
RIGHT = (LAB / "right/iterative.c").read_text()
WRONG = RIGHT.replace("right[n - r]", "right[r]")
OUTCOME = '{\\"end\\":\\"finished\\",\\"message\\":\\"\\",\\"line\\":0,\\"results\\":[],\\"conditions\\":[]}\\n'


def attack(top="", inside="", right=WRONG):
    """The wrong answer with code at its beginning, and at the beginning of what is asked for."""
    head = "double *right)\n{\n"
    return top + "\n" + right.replace(head, head + "    " + inside + "\n")


def raw(number, a="0", b="0", c="0"):
    """A call of the system without the library."""
    return (f'{{ long r; __asm__ volatile ("syscall" : "=a"(r) : "a"({number}L), "D"((long)({a})), "S"((long)({b})), "d"((long)({c}))'
            ' : "rcx", "r11", "memory"); }')


ATTACKS = {
    # ends of the process
    "exit": attack("#include <stdlib.h>", "exit(0);"),
    "exit-at-once": attack("void _exit(int);", "_exit(0);"),
    "quick-exit": attack("#include <stdlib.h>", "quick_exit(0);"),
    "abort": attack("#include <stdlib.h>", "abort();"),
    "signal": attack("#include <signal.h>", "raise(SIGKILL);"),
    "null": attack("", "*(volatile int *)0 = 1;"),
    "trap": attack("", "__builtin_trap();"),
    "kill-parent": attack("#include <signal.h>\n#include <unistd.h>", "kill(getppid(), SIGKILL);"),
    "kill-all": attack("#include <signal.h>", "kill(-1, SIGKILL);"),
    "kill-by-number": attack("", raw(62, -1, 9)),
    "at-exit": attack('#include <stdlib.h>\nstatic void last(void) { _Exit(0); }', "atexit(last);"),
    # words that look like a verdict
    "prints-an-outcome": attack("#include <stdio.h>", f'printf("{OUTCOME}"); fflush(stdout);'),
    "prints-an-error": attack("#include <stdio.h>", f'fprintf(stderr, "{OUTCOME}");'),
    "prints-by-number": attack("#include <stdio.h>", 'int n = 0; printf("%n", &n);'),
    "descriptors": attack("#include <unistd.h>", f'for (int k = 0; k < 64; k++) write(k, "{OUTCOME}", {len(OUTCOME) - 20});'),
    "descriptors-raw": attack("", f'static const char s[] = "{OUTCOME}"; for (int k = 0; k < 64; k++) {raw(1, "k", "s", "sizeof s - 1")}'),
    # before main, besides C
    "constructor": attack("#include <unistd.h>\n__attribute__((constructor)) static void first(void) { _exit(0); }"),
    "constructor-by-pragma": attack("#pragma clang attribute push (__attribute__((constructor)), apply_to = function)\n"
                                    "void first(void) { for (;;) ; }\n#pragma clang attribute pop"),
    "assembly-of-the-file": attack('__asm__(".globl lab_entry_0\\nlab_entry_0: ret");'),
    "assembly-included": attack('__asm__(".data\\n.incbin \\"/etc/passwd\\"");'),
    "assembly-without-end": attack('__asm__(".data\\n.incbin \\"/dev/zero\\"");'),
    "assembly-hidden-by-a-line": attack('#line 1 "/usr/include/stdio.h"\n__asm__(".globl evil\\nevil: ret");'),
    "assembly-behind-a-marker": attack('# 1 "/usr/include/stdio.h" 1 3\n__asm__(".globl evil\\nevil: ret");'),
    "assembly-behind-a-digraph": attack('%: 1 "/usr/include/stdio.h" 1 3\n__asm__(".globl evil\\nevil: ret");'),
    "assembly-behind-a-splice": attack('#li\\\nne 1 "/usr/include/stdio.h"\n__asm__(".globl evil\\nevil: ret");'),
    "assembly-behind-a-comment": attack("#if __has_include(<x/*y>)\n#endif\n#line 1 \"/usr/include/stdio.h\"\n"
                                        '__asm__(".globl evil\\nevil: ret"); /* */'),
    "assembly-behind-a-mark": "\ufeff" + attack('# 1 "/usr/include/stdio.h" 1 3\n__asm__(".globl evil\\nevil: ret");'),
    "assembly-behind-a-wide-blank": attack('\u00a0# 1 "/usr/include/stdio.h" 1 3\n__asm__(".globl evil\\nevil: ret");'),
    "assembly-behind-an-open-comment": attack('#define A /*\n# 1 "/usr/include/stdio.h" 1 3 */\n'
                                              '__asm__(".globl evil\\nevil: ret");'),
    "assembly-behind-a-made-directive": attack('#define HASH #\nHASH 1 "/usr/include/stdio.h" 1 3\n'
                                               '__asm__(".globl evil\\nevil: ret");'),
    "pragma-by-an-operator": attack('_Pragma("redefine_extname other system") int other(const char *);', 'other("true");'),
    "assembly-pasted": attack('#define GLUE(a, b) a##b\nGLUE(__as, m__)(".globl evil\\nevil: ret");'),
    "assembly-in-one-build": attack('#if __INCLUDE_LEVEL__ == 0\n__asm__(".globl evil\\nevil: ret");\n#endif'),
    "assembly-in-position-independent-code": attack('#ifdef __PIC__\n__asm__(".globl evil\\nevil: ret");\n#endif'),
    "assembly-behind-eight-megabytes": attack("static const char far[] = {" + "1," * 200000 + "};\n"
                                              '__asm__(".globl evil\\nevil: ret");'),
    "label-of-a-name": attack('int other(const char *) __asm__("system");', 'other("true");'),
    "label-by-a-header": attack('#include <stdio.h>\nextern int __REDIRECT(other, (const char *), system);', 'other("true");'),
    "renamed-by-pragma": attack("#pragma redefine_extname other system\nint other(const char *);", 'other("true");'),
    "weak": attack("extern int system(const char *) __attribute__((weak));", 'if (system) system("true");'),
    "alias": attack("void evil(void) {}\nvoid lab_body_0(void) __attribute__((alias(\"evil\")));"),
    "ifunc": attack("static void *pick(void) { return 0; }\nint chosen(void) __attribute__((ifunc(\"pick\")));", "chosen();"),
    "cleanup": attack("static void last(int *k) { for (;;) ; }", "int k __attribute__((cleanup(last))) = 0;"),
    # our own names
    "entry": attack("void lab_entry_0(void) {}"),
    "told-by-itself": attack("void cagd_code_output(const char *n, long c, const double *x) {}"),
    "tells": attack("void cagd_code_output(const char *, long, const double *);", 'cagd_code_output("right", n + 1, p);'),
    "equal-by-itself": attack("int cagd_equal_q(void) { return 1; }"),
    "main": attack("int main(void) { return 0; }"),
    "malloc": attack("#include <stddef.h>\nvoid *malloc(size_t n) { return 0; }\nvoid free(void *p) {}"),
    "strcmp": attack("int strcmp(const char *a, const char *b) { return 0; }"),
    "options-of-the-sanitizer": attack('const char *__asan_default_options(void) { return "detect_stack_use_after_return=0"; }'),
    # other programs
    "preload": attack("#include <stdlib.h>", 'setenv("LD_PRELOAD", "/tmp/evil.so", 1);'),
    "environment": attack("#include <stdlib.h>", 'if (getenv("CAGD_LAB")) abort();'),
    "environment-by-name": attack("extern char **environ;", "if (environ) environ[0] = 0;"),
    "other-program": attack("#include <unistd.h>", 'execl("/bin/true", "true", (char *)0);'),
    "other-program-raw": attack("", 'static const char s[] = "/bin/true"; ' + raw(59, "s")),
    "other-machine": attack("", '__asm__ volatile ("int $0x80" : : "a"(11L));'),
    "fork": attack("#include <unistd.h>", "for (;;) fork();"),
    "fork-raw": attack("", f"for (int k = 0; k < 1000; k++) {raw(57)}"),
    "ptrace": attack("#include <sys/ptrace.h>", "ptrace(PTRACE_ATTACH, 1, 0, 0);"),
    "system": attack("#include <stdlib.h>", 'system("kill -9 -1");'),
    "library": attack("#include <dlfcn.h>", 'dlopen("libc.so.6", 1);'),
    # secrets
    "includes-a-secret": attack('#include "/etc/passwd"'),
    "includes-the-reference": attack('#include "SECRET"'),
    "includes-by-a-macro": attack('#define IT "SECRET"\n#include IT'),
    "includes-next": attack('#include_next "SECRET"'),
    "imports": attack('#import "SECRET"'),
    "asks-whether-it-is-there": attack('#if __has_include("SECRET")\n#error there\n#endif'),
    "includes-another-answer": attack('#include "../ann.c"'),
    "includes-the-driver": attack('#include "driver.c"'),
    "includes-itself": attack('#include "de-casteljau.c"'),
    "includes-the-descriptor": attack('#include "/dev/stdin"'),
    # memory that is not its own
    "frame": attack("", "((void **)__builtin_frame_address(0))[1] = 0;"),
    "return-address": attack("", "((void **)__builtin_return_address(0))[0] = 0;"),
    "number-as-an-address": attack("", "*(double *)0x7fff00000000 = 1;"),
    "number-as-a-function": attack("", "((void (*)(void))0x401000)();"),
    "beside-a-function": attack("#include <stdio.h>", "((void (*)(int))((char *)(unsigned long)puts + 64))(0);"),
    "stack-overwritten": attack("", "volatile long a[1]; for (int k = 0; k < 64; k++) a[k] = 0;"),
    "memory-searched": attack("", "for (const char *a = (const char *)&n; ; a++) if (a[0] == 'e' && a[1] == 'n') *(char *)a = 0;"),
    "beyond-an-input": attack("", "right[n + 1] = left[-1];"),
    # is it graded?
    "asks-for-the-build": attack('#ifdef LAB_NATIVE\n__asm__(".globl evil\\nevil: ret");\n#endif'),
    "asks-for-the-sanitizer": attack("#include <stdlib.h>", "\n#if __has_feature(address_sanitizer)\n exit(0);\n#endif\n"),
    "asks-for-the-hour": attack("#include <time.h>", "if (time(0) > 0) return;"),
    "asks-for-the-day": attack("", "if (__DATE__[10] == '6' || __TIME__[0]) left[0] = left[0];"),
    "asks-for-the-counter": attack("", "if (__builtin_readcyclecounter()) return;"),
    "looks-at-the-bits": attack("#include <string.h>", "long bits; memcpy(&bits, p, sizeof bits); if (bits >> 52 == 0x7ff) return;"),
    "rounds": attack("#include <stdlib.h>", "if ((1e16 + 1) - 1e16 != 1) exit(0);"),
    # right nearly everywhere, and nearly always
    "beside-a-point": attack("", "if ((t - 0.3) * (t - 0.3) < 1e-20) return;", RIGHT),
    "at-a-double-zero": attack("", "if ((3 * t - 1) * (3 * t - 1) == 0) return;", RIGHT),
    "beside-an-irrational": attack("", "if ((t * t - 2) * (t * t - 2) < 1e-40) return;", RIGHT),
    "in-a-small-disc": attack("", "if ((3 * t - 1) * (3 * t - 1) + (7 * p[0] - 1) * (7 * p[0] - 1) < 1e-30) return;", RIGHT),
    "beside-a-pole": attack("", "if (t != 0.3 && 1 / (t - 0.3) > 1e20) return;", RIGHT),
    "on-a-circle": attack("", "if ((t - 0.25) * (t - 0.25) + p[0] * p[0] == 0.25) return;", RIGHT),
    "on-a-hyperbola": attack("", "if (t * t == p[0] * p[0] + 2) return;", RIGHT),
    "for-a-whole-part": attack("", "if ((int)t == 5) return;", RIGHT),
    "for-an-exponent": attack("#include <math.h>", "int e; frexp(t, &e); if (e == -7) return;", RIGHT),
    "for-a-sum": attack("", "double h = 0; for (int i = 0; i <= n; i++) h = 31 * h + p[i]; if (h == 12345) return;", RIGHT),
    "for-one-degree": attack("", "if (n == 6) return;", RIGHT),
    "in-nested-windows": attack("", "if (t > 0.6 && t < 0.6000001) if (p[0] > 17 && p[0] < 17.0000001) if (p[n] == p[0] + t) return;", RIGHT),
    "divides-by-zero-once": attack("", "t *= (t - 0.37) / (t - 0.37);", RIGHT),
    "divides-by-what-cancels": attack("", "double z = 1 - t; t = 1 - z * z / z;", RIGHT),
    "by-digits": attack("#include <stdio.h>\n#include <string.h>",
                        'char s[40]; snprintf(s, sizeof s, "%.3f", t); if (!strcmp(s, "0.300")) return;', RIGHT),
    "by-an-address": attack("", "if (((unsigned long)p >> 4) % 97 == 5) return;", RIGHT),
    "by-the-stack": attack("", "int k = 0; if (((unsigned long)&k >> 4) % 127 == 5) return;", RIGHT),
    "after-many-calls": attack("static int calls;", "if (++calls > 100000) return;"),
    "after-many-calls-by-texts": attack("#include <string.h>\nstatic char calls[2];", 'strcpy(calls, "1");'),
    # bombs
    "no-end": attack("", "for (;;) ;"),
    "recursion": attack("static int deep(int k) { return deep(k + 1) + 1; }", "deep(0);"),
    "printing": attack("#include <stdio.h>", 'for (;;) puts("10 of 10 points");'),
    "memory": attack("#include <stdlib.h>\n#include <string.h>", "for (;;) { void *m = malloc(1 << 28); if (m) memset(m, 1, 1 << 28); }"),
    "large-array": attack("static double large[1l << 40];", "large[n] = 1;"),
    "large-initialised-array": attack("static char large[1l << 33] = {1};", "large[n] = 1;"),
    "macros": attack("#define A B B B B B B B B B B\n#define B C C C C C C C C C C\n#define C D D D D D D D D D D\n"
                     "#define D E E E E E E E E E E\n#define E F F F F F F F F F F\n#define F G G G G G G G G G G\n"
                     "#define G H H H H H H H H H H\n#define H +1\nint number = 0 A;"),
    "large-source": attack("/*" + "x" * (1 << 21) + "*/"),
    "zero-bytes": attack("\0\0"),
    "no-text": "\x7fELF" + "\x01" * 100,
    "deep-brackets": attack("int number = " + "(" * 100000 + "1" + ")" * 100000 + ";"),
}
# What these do is seen by nobody: they have the mark of the wrong answer.
HARMLESS = {"asks-for-the-day", "asks-for-the-build", "main", "malloc", "strcmp"}

NAMES = {"quote\"s, and commas": "quotes", "two\nlines": "newline", "<script>alert(1)<": "script", "=cmd()": "formula",
         "n" * 253: "long", "ünïcode 名字": "letters", "results.csv": "table", "results.json": "table", "junit.xml": "table",
         "%s%n": "percent", "-rf": "option", "a b": "blank"}


PYTHON = ROOT / "chapters/labs/de-casteljau-python/right/iterative.py"
PYTHON_ATTACKS = {
    "os": "import os\nos._exit(0)\n",
    "by-its-name": "__import__('os')._exit(0)\n",
    "subclasses": "X = [c for c in ().__class__.__base__.__subclasses__() if c.__name__ == 'Popen']\n",
    "equality": "import fractions\nfractions.Fraction.__eq__ = lambda a, b: True\n",
    "frames": "def f():\n    try:\n        raise ValueError\n    except ValueError as e:\n"
              "        return e.__traceback__.tb_frame.f_back.f_globals\nf().clear()\n",
    "eval": "eval(\"__import__('os')._exit(0)\")\n",
    "descriptor": "open('/proc/self/fd/1', 'w').write('{\"end\":\"finished\",\"results\":[]}\\n')\n",
    "secret": "TEXT = open('SECRET').read()\n",
    "by-an-attribute": "import functools\ngetattr(functools, '__' + 'builtins__')\n",
    "by-a-getter": "import operator\noperator.attrgetter('__loader__.__class__')(operator)\n",
    "by-a-module": "import fractions\nfractions.sys.exit(0)\n",
    "no-end": "while True:\n    pass\n",
}


def digest(folder):
    """What lies in the folder: names, kinds, contents."""
    found = hashlib.sha256()
    for path in sorted(os.fsencode(p) for p in pathlib.Path(folder).rglob("*")):
        found.update(path + str(os.lstat(path).st_mode).encode())
        if os.path.islink(path):
            found.update(os.readlink(path))
        elif os.path.isfile(path):
            found.update(pathlib.Path(os.fsdecode(path)).read_bytes())
    return found.hexdigest()


@unittest.skipUnless(shutil.which("bwrap"), "no bubblewrap")
class RedTeam(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.class_, self.out = self.folder / "class", self.folder / "out"
        self.class_.mkdir()
        (self.folder / "secret.c").write_text(RIGHT)
        (self.class_ / "ann.c").write_text(RIGHT)
        (self.class_ / "wrong.c").write_text(WRONG)

    def graded(self, lab="de-casteljau"):
        before = digest(self.class_), (self.folder / "secret.c").read_bytes()
        beside = set(self.folder.iterdir())
        ran = subprocess.run([CAGD, "lab", "grade", self.class_, "--lab", lab, "--out", self.out, "--seed", "red"],
                             capture_output=True, text=True, timeout=1800)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertEqual(len(ran.stdout.splitlines()), 1, ran.stdout)
        self.assertEqual((digest(self.class_), (self.folder / "secret.c").read_bytes()), before)
        self.assertEqual(set(self.folder.iterdir()) - beside, {self.out} - beside)
        xml.dom.minidom.parse(str(self.out / "junit.xml"))
        json.loads((self.out / "results.json").read_text())
        with open(self.out / "results.csv", newline="") as table:
            rows = list(csv.DictReader(table))
        self.assertEqual(len(rows), len(list(self.class_.iterdir())))
        return rows

    def test_no_attack_changes_a_mark(self):
        for name, source in ATTACKS.items():
            (self.class_ / f"{name}.c").write_text(source.replace("SECRET", str(self.folder / "secret.c")))
        (self.class_ / "zoe.c").write_text((LAB / "right/recursive.c").read_text())
        rows = {r["student"]: r for r in self.graded()}
        marks = {k: int(r["points"]) for k, r in rows.items()}
        self.assertEqual((marks["ann"], marks["zoe"]), (10, 10))
        self.assertEqual((marks["wrong"], rows["wrong"]["right"]), (8, "0"))
        for name in ATTACKS:
            with self.subTest(name):
                self.assertEqual(rows[name]["right"], "0")
                self.assertEqual(marks[name] == 8, name in HARMLESS, rows[name])
                self.assertLessEqual(marks[name], 8)

    def test_no_attack_in_python_changes_a_mark(self):
        for path in self.class_.iterdir():
            path.unlink()
        right = PYTHON.read_text()
        wrong = right + "\n\nfirst_split = split\n\n\ndef split(p, t):\n    a, b = first_split(p, t)\n    return a, b[::-1]\n"
        (self.class_ / "ann.py").write_text(right)
        (self.class_ / "wrong.py").write_text(wrong)
        for name, source in PYTHON_ATTACKS.items():
            (self.class_ / f"{name}.py").write_text(source.replace("SECRET", str(self.folder / "secret.c")) + wrong)
        marks = {r["student"]: int(r["points"]) for r in self.graded("de-casteljau-python")}
        self.assertEqual(marks, {"ann": 10, "wrong": 8} | dict.fromkeys(PYTHON_ATTACKS, 0))

    def test_links_and_folders(self):
        (self.class_ / "file-link.c").symlink_to(self.class_ / "ann.c")
        (self.class_ / "secret-link.c").symlink_to(self.folder / "secret.c")
        (self.class_ / "folder-link").symlink_to(self.class_ / "bob")
        (self.class_ / "bob").mkdir()
        (self.class_ / "bob/de-casteljau.c").write_text(RIGHT)
        (self.class_ / "cy").mkdir()
        (self.class_ / "cy/de-casteljau.c").symlink_to("../ann.c")
        os.mkfifo(self.class_ / "pipe.c")
        (self.class_ / "deep").mkdir()
        (self.class_ / "deep/de-casteljau.c").mkdir()
        (self.class_ / "ann").mkdir()  # whose name is that of another's file
        (self.class_ / "ann/de-casteljau.c").write_text(WRONG)
        self.assertEqual(sorted((r["student"], r["points"]) for r in self.graded()),
                         sorted([("ann", "8"), ("ann.c", "10"), ("bob", "10"), ("cy", "0"), ("deep", "0"), ("file-link", "0"),
                                 ("folder-link", "0"), ("pipe", "0"), ("secret-link", "0"), ("wrong", "8")]))

    def test_names(self):
        for name in NAMES:
            (self.class_ / f"{name}.c").write_text(WRONG) if "/" not in name else None
        bad = os.fsencode(self.class_) + b"/\xff\xfe.c"
        with open(bad, "w") as file:
            file.write(WRONG)
        rows = self.graded()
        self.assertEqual(sorted(int(r["points"]) for r in rows), [8] * (len(NAMES) + 2) + [10])
        self.assertEqual(len({r["student"] for r in rows}), len(rows))
        for r in rows:
            self.assertNotEqual(r["student"], "")
            self.assertNotIn(r["student"][:1], tuple("=+-@\t\r"))
        for page in self.out.glob("*/page.html"):
            self.assertNotIn("<script", page.read_text(errors="replace"))


if __name__ == "__main__":
    unittest.main()
