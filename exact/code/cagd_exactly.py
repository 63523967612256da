"""Other people's C and C++ called from Python, over exact numbers.

    from fractions import Fraction
    from cagd_exactly import Code

    code = Code(source="curves.c", declare="double casteljau(int n, const double *p, double t);",
                input="p[3]; t", call="double R = casteljau(2, p, t);", output="R")
    code(p=[0, 1, Fraction(1, 3)], t=Fraction(2, 7))["R"]            Fraction(64, 147)
    code.function(p=[0, 1, 2], t=Fraction(2, 7))["R"]                "p[0]*t^2-..."; code.conditions() has the comparisons
    code.rounding(p=[0, 1, 0.1], t=0.3)["R"]                         the binary64 and its error in ulps

The parts are those of a block of `cagd exactly`.  Python's standard library alone; the program cagd-exactly-session does the work: it is
the one that the variable CAGD_EXACTLY_SESSION of the environment names, else the one in PATH."""
import os
import re
import subprocess
from fractions import Fraction


class Refused(Exception):
    """The code did not end well: `end` is outside, undefined, refused, bound or crashed; the text says why, and at which line."""

    def __init__(self, end, text):
        super().__init__(text)
        self.end = end


class Code:
    def __init__(self, *, source, call, output, declare="", input="", include="", where="", flags=""):
        self._sizes = {name: int(count or 1) for name, count in re.findall(r"(\w+)(?:\[(\d+)\])?[^;\n]*(?:[;\n]|$)", input)}
        self._outputs = [f"{name}[{k}]" if int(count or 1) > 1 else name
                         for name, count in re.findall(r"(\w+)(?:\[(\d+)\])?", output) for k in range(int(count or 1))]
        self._process = subprocess.Popen([os.environ.get("CAGD_EXACTLY_SESSION", "cagd-exactly-session")], text=True,
                                         stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        parts = {"source": source, "flags": flags, "include": include, "declare": declare, "input": input, "where": where,
                 "call": call, "output": output}
        for key, text in parts.items():
            for line in text.splitlines():
                self._process.stdin.write(f"{key} {line}\n")
        try:
            self._ask("load")
        except Refused:
            self.close()
            raise

    def close(self):
        if self._process.poll() is None:
            self._process.stdin.close()
            self._process.wait()
        self._process.stdout.close()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _ask(self, *lines):
        """The answer to the last of the lines, which are sent at once; the first that is not answered well is told."""
        self._process.stdin.write("\n".join(lines) + "\n")
        self._process.stdin.flush()
        answers = [self._process.stdout.readline().rstrip("\n").partition(" ") for _ in lines]
        for word, _, text in answers:
            if word not in ("ok", "value"):
                raise Refused(word, text)
        return answers[-1][2]

    def _run(self, numbers, inputs, *asked):
        """What is asked of each output after a run, as texts; the inputs are an int, a Fraction, a float (the binary64 it is) or a text
        ("3/7", "0.1") for each number."""
        lines = []
        for name, values in inputs.items():
            values = values if isinstance(values, (list, tuple)) else [values]
            lines.append(" ".join(["set", name, *[x if isinstance(x, str) else str(Fraction(x)) for x in values]]))
        names = " ".join(self._outputs)
        lines.append("run " + numbers)
        texts = self._ask(*lines, f"{asked[0]} {names}").split("\t")
        more = [self._ask(f"{key} {names}").split("\t") for key in asked[1:]]
        return zip(self._outputs, texts, *more)

    def __call__(self, **inputs):
        """The outputs, fractions; a text "in [a, b]" where one is not rational."""
        return {name: text if text.startswith("in") else Fraction(text) for name, text in self._run("rational", inputs, "get")}

    def function(self, **inputs):
        """The outputs as rational functions of the inputs, on the way through the code that the values take."""
        return dict(self._run("field", inputs, "function"))

    def conditions(self):
        """The comparisons of the last call of `function`."""
        found = []
        while True:
            try:
                found.append(self._ask(f"condition {len(found)}"))
            except Refused:
                return found

    def rounding(self, **inputs):
        """Of each output what binary64 computes, and its error in ulps of the exact value."""
        return {name: (float(computed), float(ulps)) for name, computed, ulps in self._run("rounding", inputs, "computed", "ulps")}
