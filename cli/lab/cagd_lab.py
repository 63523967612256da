"""What runs an answer in Python for `cagd lab`: plain functions over exact numbers.

    python3 -I cagd_lab.py ANSWER CASES          jobs from standard input, outcomes to standard output, as in play.c
    python3 -I cagd_lab.py --inspect ANSWER      what is seen in the source before it runs

The answer is ordinary Python.  Numbers in it are exact: a float literal is the binary64 that it is, 1/3 is a third, and the arguments are
numbers with a value and, in the field, a quotient of polynomials in the inputs.  A comparison of two numbers is decided by their values,
and noted with the line, unless both are the same function.  Each job runs in a process of its own, which may ask the system for memory and
its own end alone; no expected value is in it.  Python's standard library alone."""
import ast
import ctypes
import fractions
import functools
import gc
import itertools
import json
import math
import operator
import os
import resource
import select
import signal
import struct
import sys
import time
import types

Q = fractions.Fraction
MOST_CONDITIONS, MOST_TERMS, MOST_PLAIN, MOST_MESSAGE, MOST_RESULTS, MEGABYTES = 4096, 200000, 200, 300, 1 << 12, 1024


class Refused(Exception):
    """What cannot be carried exactly.  It ends the run, even where the answer catches it: else it could tell one kind of run from another."""

    def __init__(self, message):
        super().__init__(message)
        Run.refused = Run.refused or message


def tried(make, instead):
    """What the judge itself may try in vain."""
    before = Run.refused
    try:
        return make()
    except Refused:
        Run.refused = before
        return instead


# ---- polynomials: {monomial: coefficient}, a monomial is a sorted tuple of (variable, power) ----------------------

def times_monomial(a, b):
    powers = dict(a)
    for name, k in b:
        powers[name] = powers.get(name, 0) + k
    return tuple(sorted(powers.items()))


def times(a, b):
    if len(a) * len(b) > MOST_TERMS * 10:
        raise Refused("an expression grows too large for the field")
    out = {}
    for m, x in a.items():
        for n, y in b.items():
            mn = times_monomial(m, n)
            out[mn] = out.get(mn, 0) + x * y
    return {m: x for m, x in out.items() if x != 0}


def plus(a, b):
    out = dict(a)
    for m, x in b.items():
        out[m] = out.get(m, 0) + x
    return {m: x for m, x in out.items() if x != 0}


def is_constant(a):
    return not a or (len(a) == 1 and () in a)


def text_of(a):
    """Of a polynomial, as the judge reads it."""
    terms = []
    for m, x in sorted(a.items()):
        factors = [n if k == 1 else f"{n}^{k}" for n, k in m]
        terms.append("(" + "*".join([str(abs(x)), *factors]) + ")" if x > 0 else "(0-" + "*".join([str(abs(x)), *factors]) + ")")
    return "+".join(terms) or "0"


def plain_text(a):
    """Of a polynomial times a positive number: whole coefficients, "3*k[1]*t-t^2+5", as polyhedron.h reads it; "" of a long one."""
    if len(a) > MOST_PLAIN:
        return ""
    common = math.lcm(*(Q(x).denominator for x in a.values())) if a else 1
    text = ""
    for m, x in sorted(a.items(), reverse=True):
        factors = [n if k == 1 else f"{n}^{k}" for n, k in sorted(m, key=lambda f: Run.names.get(f[0], 0))]
        amount = abs(int(x * common))
        text += ("-" if x < 0 else "+") + "*".join(([str(amount)] if amount != 1 or not factors else []) + factors)
    return text.removeprefix("+") or "0"


class Function:
    """numerator / product of factors^power, factors being polynomials that are no constants."""

    def __init__(self, numerator, factors=()):
        self.numerator, self.factors = numerator, dict(factors)  # {frozenset of terms: power}

    def expanded(self, factors):
        out = {(): Q(1)}
        for f, k in factors.items():
            for _ in range(k):
                out = times(out, dict(f))
        return out

    def __add__(self, other):
        common = dict(self.factors)
        for f, k in other.factors.items():
            common[f] = max(k, common.get(f, 0))
        def lifted(x):
            return times(x.numerator, self.expanded({f: k - x.factors.get(f, 0) for f, k in common.items()}))
        return Function(plus(lifted(self), lifted(other)), common)

    def __mul__(self, other):
        factors = dict(self.factors)
        for f, k in other.factors.items():
            factors[f] = factors.get(f, 0) + k
        return cancelled(times(self.numerator, other.numerator), factors)

    def inverse(self):
        """1 over it; its numerator is not zero."""
        if is_constant(self.numerator):
            return Function(times(self.expanded(self.factors), {(): 1 / self.numerator[()]}))
        lead = self.numerator[max(self.numerator)]
        monic = frozenset((m, x / lead) for m, x in self.numerator.items())
        return Function(times(self.expanded(self.factors), {(): 1 / lead}), {monic: 1})

    def polynomial_of_sign(self):
        """A polynomial that has its sign, wherever its factors are not 0."""
        return times(self.numerator, self.expanded({f: k % 2 for f, k in self.factors.items()}))

    def text(self):
        below = "*".join(f"({text_of(dict(f))})" for f, k in self.factors.items() for _ in range(k))
        return f"({text_of(self.numerator)})" + (f"/({below})" if below else "")


def cancelled(numerator, factors):
    """A factor that is the numerator itself, up to a constant, goes."""
    if numerator and not is_constant(numerator):
        lead = numerator[max(numerator)]
        monic = frozenset((m, x / lead) for m, x in numerator.items())
        if factors.get(monic, 0) > 0:
            factors[monic] -= 1
            numerator = {(): lead}
    return Function(numerator, {f: k for f, k in factors.items() if k > 0})


# ---- numbers --------------------------------------------------------------------------------------------------------

class Run:
    """What is noted while an answer runs."""
    answer = ""
    conditions, seen, path, operations, printed, field, caches = [], set(), 0, 0, 0, False, {}
    denominators, names = [], {}  # what is divided by; the variables in the order of the inputs
    refused = ""  # the first thing that could not be carried, or the end of memory or depth that the answer caught
    computed = None  # where that is asked for: [result, line, place of the operation in that line's code]


def frame_of_answer():
    frame = sys._getframe(1)
    while frame is not None and frame.f_code.co_filename != Run.answer:
        frame = frame.f_back
    return frame


def line_of_answer():
    frame = frame_of_answer()
    return frame.f_lineno if frame is not None else 0


def noted(x):
    """x, to which an operation of the answer came; all of them are known, or none."""
    if Run.computed is not None:
        frame = frame_of_answer()
        Run.computed.append([str(x._value), frame.f_lineno, frame.f_lasti] if frame is not None else [str(x._value), 0, 0])
        if len(Run.computed) > MOST_RESULTS:
            Run.computed = None
    return x


def exact(x):
    """A Number, or None for what is none."""
    if isinstance(x, Number):
        return x
    if isinstance(x, bool) or not isinstance(x, (int, Q, float)):
        return None
    if isinstance(x, float):
        raise Refused("a float takes part in the computation: math.sqrt and the like are not exact")
    return Number(Q(x), Function({(): Q(x)} if x else {}) if Run.field else None)


class Number:
    """A value and, in the field, the function of the inputs that it is the value of.  An answer knows it by operations and comparisons alone:
    names with a low line in front are refused in it, and so is a text, whose digits would decide."""
    __slots__ = ("_value", "_function")
    __hash__ = None

    def __init__(self, value, function):
        self._value, self._function = value, function

    def _with(self, other, value, function):
        other = exact(other)
        if other is None:
            return NotImplemented
        Run.operations += 1
        out = Number(value(self._value, other._value), function(self._function, other._function) if Run.field else None)
        return noted(out)

    def __add__(self, other):
        return self._with(other, operator.add, operator.add)

    __radd__ = __add__

    def __mul__(self, other):
        return self._with(other, operator.mul, operator.mul)

    __rmul__ = __mul__

    def __neg__(self):
        return noted(Number(-self._value, self._function * Function({(): Q(-1)}) if Run.field else None))

    def __pos__(self):
        return self

    def __sub__(self, other):
        other = exact(other)
        return NotImplemented if other is None else self + -other

    def __rsub__(self, other):
        other = exact(other)
        return NotImplemented if other is None else other + -self

    def __truediv__(self, other):
        other = exact(other)
        if other is None:
            return NotImplemented
        if other._value == 0:
            raise ZeroDivisionError("division by zero")
        Run.operations += 1
        if Run.field and not is_constant(other._function.numerator):
            text = plain_text(other._function.numerator) or text_of(other._function.numerator)
            if text not in Run.denominators and len(Run.denominators) < MOST_CONDITIONS:
                Run.denominators.append(text)
        return noted(Number(self._value / other._value, self._function * other._function.inverse() if Run.field else None))

    def __rtruediv__(self, other):
        other = exact(other)
        return NotImplemented if other is None else other / self

    def __pow__(self, n):
        if isinstance(n, Number) and (not Run.field or is_constant(n._function.numerator)) and n._value.denominator == 1:
            n = int(n._value)
        if not isinstance(n, int):
            raise Refused("a power whose exponent is no whole number is not exact")
        out = exact(1)
        for _ in range(abs(n)):
            out = out * self
        return out if n >= 0 else exact(1) / out

    def __abs__(self):
        return -self if self < 0 else self

    def _compared(self, other, holds, name):
        other = exact(other)
        if other is None:
            return NotImplemented
        is_true = holds(self._value, other._value)
        if Run.field:
            difference = self._function + other._function * Function({(): Q(-1)})
            if is_constant(difference.numerator):
                return is_true
        sign = (self._value > other._value) - (self._value < other._value)
        line = line_of_answer()
        Run.path = (Run.path * 1000003 + line * 8 + 2 * (sign if name != "=" else abs(sign)) + is_true + 5) % (1 << 61)
        if Run.field:
            relation = {True: name, False: {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "=": "!="}[name]}[is_true]
            first = next(iter(difference.numerator))
            alone = len(difference.numerator) == 1 and not difference.factors and len(first) == 1 and first[0][1] == 1
            text = first[0][0] if alone else difference.text()
            polynomial = tried(lambda: plain_text(difference.polynomial_of_sign()), "")
            if (text, relation, line) not in Run.seen and len(Run.conditions) < MOST_CONDITIONS:
                Run.seen.add((text, relation, line))
                Run.conditions.append({"left": self._function.text(), "relation": relation, "right": other._function.text(),
                                       "difference": text, "polynomial": polynomial, "given": False, "line": line,
                                       "holding": {"=": 1, ">": 2, ">=": 3, "<": 4, "<=": 5, "!=": 6}[relation]})
        return is_true

    def __lt__(self, other):
        return self._compared(other, operator.lt, "<")

    def __le__(self, other):
        return self._compared(other, operator.le, "<=")

    def __gt__(self, other):
        return self._compared(other, operator.gt, ">")

    def __ge__(self, other):
        return self._compared(other, operator.ge, ">=")

    def __eq__(self, other):
        return self._compared(other, operator.eq, "=")

    def __ne__(self, other):
        same = self == other
        return same if same is NotImplemented else not same

    def __bool__(self):
        return not self == 0

    def __float__(self):
        raise Refused("a float is made of an exact number: math.sqrt and the like are not exact")

    __int__ = __index__ = __round__ = __floor__ = __ceil__ = __trunc__ = __float__

    def __repr__(self):
        raise Refused("no text is made of a number")


class OfFraction(type):
    """fractions.Fraction as an answer sees it: it takes the numbers of the inputs too."""

    def __call__(cls, a=0, b=None):
        a = Q(a) if isinstance(a, (str, float)) else a
        return (a if isinstance(a, Number) else Q(a)) if b is None else divide(a, b)

    def __instancecheck__(cls, x):
        return isinstance(x, (Number, Q))


class Fraction(metaclass=OfFraction):
    pass


def caught():
    """At the begin of a handler: the ends of memory and depth, which come earlier in the field, are none of the answer's business."""
    e = sys.exc_info()[1]
    if isinstance(e, (RecursionError, MemoryError)):
        Run.refused = Run.refused or f"{type(e).__name__} is caught"


def divide(a, b):
    """a / b, where two whole numbers have an exact quotient."""
    return Q(a, b) if isinstance(a, int) and isinstance(b, int) else a / b


def power(a, n):
    return Q(a) ** n if isinstance(a, int) and isinstance(n, int) and n < 0 else a ** n


# ---- the source -------------------------------------------------------------------------------------------------------

MODULES = {"math": (math, [n for n in dir(math) if n[0] != "_"]), "fractions": (None, ["Fraction"]),
           "functools": (functools, ["reduce", "partial", "lru_cache", "cache"]),
           "itertools": (itertools, [n for n in dir(itertools) if n[0] != "_"]),
           "operator": (operator, [n for n in operator.__all__ if n not in ("attrgetter", "methodcaller")])}
BUILTINS = ["abs", "all", "any", "bool", "dict", "divmod", "enumerate", "filter", "float", "frozenset", "int", "isinstance", "iter",
            "len", "list", "map", "max", "min", "next", "pow", "range", "repr", "reversed", "round", "set", "slice", "sorted", "str",
            "sum", "tuple", "zip", "Exception", "ValueError", "TypeError", "IndexError", "ZeroDivisionError", "AssertionError",
            "StopIteration", "ArithmeticError", "NotImplementedError", "True", "False", "None", "print"]
INNER = ("f_", "gi_", "tb_", "co_", "cr_", "ag_", "func_", "_")  # attributes that lead out of what is handed in


def refusal(tree):
    """The line and the text of what is no part of an answer, or None."""
    for node in ast.walk(tree):
        line = getattr(node, "lineno", 0)
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            wanted = [a.name for a in node.names] if isinstance(node, ast.Import) else [node.module or "."]
            for name in wanted:
                if name not in MODULES:
                    return line, f"import {name}: math, fractions, functools, itertools and operator are all that is there"
            if isinstance(node, ast.ImportFrom):
                for a in node.names:
                    if a.name != "*" and a.name not in MODULES[node.module][1]:
                        return line, f"{node.module}.{a.name} is no function for an assignment"
        if isinstance(node, ast.Attribute) and (node.attr.startswith(INNER) or node.attr in ("mro", "format", "format_map")):
            return line, f".{node.attr} is no part of an assignment"
        if isinstance(node, ast.Name) and node.id.startswith("__") and node.id != "__name__":
            return line, f"{node.id} is no part of an assignment"
        if isinstance(node, (ast.Await, ast.AsyncFunctionDef, ast.ClassDef, ast.Match)):
            return line, "plain functions are asked for"
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in (
                "eval", "exec", "open", "compile", "getattr", "setattr", "globals", "locals", "vars", "dir", "input", "type", "object",
                "breakpoint", "memoryview", "super", "id", "hash", "callable", "delattr", "help", "exit", "quit"):
            return line, f"{node.func.id} is no function for an assignment"
        if isinstance(node, ast.Try) and any(isinstance(n, (ast.Return, ast.Break, ast.Continue)) for part in node.finalbody for n in ast.walk(part)):
            return line, "finally does not end what went wrong in an assignment"
        if isinstance(node, ast.ExceptHandler) and node.type is None:
            return line, "except without a name catches what is not the answer's business"
    return None


def notes_of(tree):
    notes = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, float) and math.isfinite(node.value):
            q = Q(node.value)
            is_exact = Q(repr(node.value)) == q
            notes.append({"line": node.lineno, "text": f"the float {node.value!r} is exactly {q}" if is_exact else
                          f"the float {node.value!r} is not what it says, but {q}: write Fraction({str(Q(repr(node.value))).replace('/', ', ')})"})
    return notes


class Exactly(ast.NodeTransformer):
    """a / b, a ** b and float literals become exact."""

    def visit_BinOp(self, node):
        self.generic_visit(node)
        name = {ast.Div: "__divide", ast.Pow: "__power"}.get(type(node.op))
        if name is None:
            return node
        return ast.copy_location(ast.Call(ast.Name(name, ast.Load()), [node.left, node.right], []), node)

    def visit_AugAssign(self, node):
        self.generic_visit(node)
        if not isinstance(node.op, (ast.Div, ast.Pow)) or not isinstance(node.target, ast.Name):
            return node
        name = "__divide" if isinstance(node.op, ast.Div) else "__power"
        value = ast.Call(ast.Name(name, ast.Load()), [ast.Name(node.target.id, ast.Load()), node.value], [])
        return ast.copy_location(ast.Assign([node.target], value), node)

    def visit_ExceptHandler(self, node):
        self.generic_visit(node)
        node.body.insert(0, ast.copy_location(ast.Expr(ast.Call(ast.Name("__caught", ast.Load()), [], [])), node))
        return node

    def visit_Constant(self, node):
        if isinstance(node.value, float):
            return ast.copy_location(ast.Call(ast.Name("__float", ast.Load()), [node], []), node)
        return node


def inspect(path):
    source = open(path, encoding="utf-8").read()
    try:
        tree = ast.parse(source)
        found = refusal(tree)
        seen = {"notes": notes_of(tree)}
        if found is not None:
            seen["refused"] = f"line {found[0]}: {found[1]}"
    except (SyntaxError, ValueError, RecursionError, MemoryError) as e:
        line = getattr(e, "lineno", None) or 0
        row = source.split("\n")[line - 1] if 0 < line <= source.count("\n") + 1 else ""
        seen = {"notes": [], "compiler": f"line {line}: {getattr(e, 'msg', type(e).__name__)}\n    {row}"}
    print(json.dumps(seen))


# ---- a run --------------------------------------------------------------------------------------------------------------

def deliver(name, globals_=None, locals_=None, wanted=(), level=0):
    """import, for an answer."""
    if name not in MODULES or level != 0:
        raise ImportError(f"import {name}")
    module, names = MODULES[name]
    return types.SimpleNamespace(__all__=names, __name__=name, __dict__={}, **{
        n: Fraction if n == "Fraction" else divide if n == "truediv" else power if name == "operator" and n == "pow"
        else getattr(module, n) for n in names})


def say(*words, **_):
    Run.printed += len(words) + 1  # what of, nobody asks


def as_is(x):
    """float(x): a number stays what it is."""
    return x if isinstance(x, Number) else Q(x)


def namespace():
    builtins = {n: __builtins__[n] if isinstance(__builtins__, dict) else getattr(__builtins__, n) for n in BUILTINS
                if n not in ("True", "False", "None")}
    builtins.update({"print": say, "float": as_is, "pow": lambda a, b, m=None: power(a, b) if m is None else pow(a, b, m),
                     "__import__": deliver})
    return {"__builtins__": builtins, "__name__": "answer", "__divide": divide, "__power": power, "__float": Q, "__caught": caught}


def put(results, name, count, x):
    values = [x] if count == 0 else list(x)
    if count > 0 and len(values) != count:
        raise Refused(f"{name} has {len(values)} numbers; {count} are expected")
    for k, value in enumerate(values):
        if value is None:
            raise Refused(f"{name} is None: never computed, or not returned")
        value = exact(value)
        if value is None:
            raise Refused(f"{name} is no number")
        row = {"name": name if count <= 1 else f"{name}[{k}]", "got": str(value._value)}
        if Run.field:
            row["field"] = value._function.text()
        results.append(row)


def inputs_of(job, make):
    """{(name, count): number or list of numbers}"""
    out = {}
    for given in job["inputs"]:
        name, count = given["name"], given["count"]
        if (name, count) in out:
            continue
        values = [make(name if count == 0 else f"{name}[{like}]", Q(v), given["variable"]) for v, like in zip(given["value"], given["like"])]
        out[name, count] = values[0] if count == 0 else values
    return out


def content(x, seen=None):
    """What can change in x, as a value that is compared: numbers and texts, what containers and functions hold, how far an iterator is."""
    seen = set() if seen is None else seen
    if x is None or isinstance(x, (Number, Q, int, float, complex, str, bytes, range, slice)) or x is Fraction:
        return type(x).__name__, str(x._value) if isinstance(x, Number) else repr(x)
    if id(x) in seen:
        return "again"
    seen.add(id(x))
    if isinstance(x, (list, tuple)):
        return type(x).__name__, tuple(content(e, seen) for e in x)
    if isinstance(x, (set, frozenset)):
        return type(x).__name__, tuple(sorted(map(repr, x)))
    if isinstance(x, dict):
        return "dict", tuple((content(k, seen), content(v, seen)) for k, v in x.items())
    if isinstance(x, types.FunctionType):
        return "function", content([x.__defaults__, x.__kwdefaults__, x.__dict__, [c.cell_contents for c in x.__closure__ or () if holds(c)]], seen)
    if isinstance(x, functools._lru_cache_wrapper):  # what it remembers is no state, unless that changes: see remembered
        Run.caches[id(x)] = x
        return "cache", content(x.__wrapped__, seen)
    if isinstance(x, types.GeneratorType):
        return "generator", x.gi_frame and (x.gi_frame.f_lasti, content(dict(x.gi_frame.f_locals), seen))
    if isinstance(x, types.SimpleNamespace):
        return "module", tuple(sorted((n, id(v)) for n, v in vars(x).items() if n != "__dict__"))
    try:
        return type(x).__name__, content(list(x.__reduce_ex__(2)[1:]), seen)
    except Exception:
        return type(x).__name__, id(x)


def holds(cell):
    try:
        return cell.cell_contents is not cell
    except ValueError:
        return False


def remembered():
    """The lists, sets and the like among the results that caches of functools remember, each with its content: id -> (object, content)."""
    found, seen = {}, set()
    for cache in Run.caches.values():
        first = [x for x in gc.get_referents(cache) if x is not cache.__wrapped__ and x is not cache.__dict__]
        todo, own = list(first), set(map(id, first))
        while todo:
            x = todo.pop()
            if id(x) in seen or isinstance(x, (type, types.FunctionType, types.ModuleType, types.BuiltinFunctionType, Number, Q)):
                continue
            seen.add(id(x))
            if id(x) not in own and (isinstance(x, (list, dict, set)) or hasattr(x, "__next__")):
                found[id(x)] = x, content(x)
            todo += gc.get_referents(x)
    return found


def contents(answer):
    return {name: content(x) for name, x in answer.items() if not name.startswith("__")}


def changed(before, old, answer, given):
    """A name of the answer's own that is not what it was, or what a cache remembered; or "".  given: names of the calls."""
    name = next((name for name, was in before.items() if name not in answer or content(answer[name]) != was), "")
    name = name or next((name for name in answer if not name.startswith("__") and name not in before and name not in given), "")
    return name or ("what a cache remembers" if any(content(x) != was for x, was in old.values()) else "")


def one_call(answer, case, given, results):
    for row in case["inputs"]:
        value = given[row["name"], row["count"]]
        answer[row["name"]] = list(value) if row["count"] > 0 else value
    kept = {row["name"]: answer[row["name"]] for row in case["inputs"]}
    exec(case["compiled"], answer)
    for row in case["outputs"]:
        put(results, row["name"], row["count"], answer[row["name"]])
    for row in case["inputs"]:
        if row["count"] > 0:
            put(results, row["name"], row["count"], kept[row["name"]])


def number(name, value, variable):
    function = None
    if Run.field:
        Run.names.setdefault(name, len(Run.names))
        function = Function({((name, 1),): Q(1)} if variable else {(): value} if value else {})
    return Number(value, function)


def play(code, cases, job):
    """The outcome of the job."""
    kind, _, which = job["entry"].rpartition("_")
    case = cases[int(which)]
    Run.conditions, Run.seen, Run.path, Run.operations, Run.printed = [], set(), 1, 0, 0
    Run.denominators, Run.names = [], {}
    Run.refused = ""
    Run.computed = [] if job.get("note") else None
    Run.field = job["numbers"] == "field"
    results = []
    order = [case, case] if kind == "lab_again" else [case]
    if kind == "lab_again":
        order.insert(0, cases[case["earlier"]])
    out = {"end": "finished", "message": "", "line": 0}
    try:
        given = inputs_of(job, number)
        answer = namespace()
        exec(code, answer)
        given_names = {row["name"] for c in cases for row in c["inputs"] + c["outputs"]}
        before, old = {name: was for name, was in contents(answer).items() if name not in given_names}, {}
        for one in order:
            one_call(answer, one, given, results)
            given_names.update(one["compiled"].co_names)
            out["kept"] = out.get("kept") or changed(before, old, answer, given_names)
            old = remembered()
        if job["numbers"] == "rounding":
            in_binary64(code, case, job, results)
    except Refused as e:
        out = ended("refused", str(e), e)
    except ZeroDivisionError as e:
        out = ended("undefined", "division by zero", e)
    except MemoryError as e:
        out = ended("bound", "memory: it takes more than it is given", e)
    except RecursionError as e:
        out = ended("crashed", "calls itself without end", e)
    except IndexError as e:
        out = ended("crashed", "reads or writes outside an array: the list is shorter", e)
    except UnboundLocalError as e:
        out = ended("undefined", f"a value was never computed: {e}", e)
    except NameError as e:
        out = ended("crashed", str(e), e)
    except (Exception, SystemExit) as e:
        out = ended("crashed", told_of(e), e)
    if Run.refused and out["end"] == "finished":
        out = {"end": "refused", "message": Run.refused[:MOST_MESSAGE], "line": 0}
    out.update(results=results if out["end"] == "finished" else [], conditions=Run.conditions, denominators=Run.denominators,
               operations=Run.operations,
               path=f"{Run.path:x}", printed=Run.printed)
    if Run.computed is not None:
        out["computed"] = Run.computed
    return out


def in_binary64(code, case, job, results):
    answer, rounded = namespace(), []
    answer["__float"], answer["__builtins__"]["float"] = float, float
    answer["__divide"] = lambda a, b: a / b
    exec(code, answer)
    given = inputs_of(job, lambda name, value, variable: float(value))
    for row in case["inputs"]:
        value = given[row["name"], row["count"]]
        answer[row["name"]] = list(value) if row["count"] > 0 else value
    exec(case["compiled"], answer)
    for row in case["outputs"]:
        rounded += [answer[row["name"]]] if row["count"] == 0 else list(answer[row["name"]])
    for row, x in zip(results, rounded):
        want = Q(row["got"])
        if not math.isfinite(x):
            row["lost"] = True
        elif want != 0 or x == 0:
            row["ulps"] = float(abs(Q(x) - want) / Q(math.ulp(float(want))))


def told_of(e):
    """An exception, in words; of one that has numbers of the inputs in it, its name."""
    return tried(lambda: f"{type(e).__name__}: {e}", type(e).__name__)


def ended(end, message, e):
    line, at = 0, e.__traceback__
    while at is not None:
        if at.tb_frame.f_code.co_filename == Run.answer:
            line = at.tb_lineno
        at = at.tb_next
    return {"end": end, "message": message[:MOST_MESSAGE], "line": line}


# ---- what the process of an answer may ask of the system ---------------------------------------------------------------

CALLS = {"x86_64": (0xC000003E, {"read": 0, "write": 1, "close": 3, "fstat": 5, "lseek": 8, "mmap": 9, "mprotect": 10, "munmap": 11,
                                 "brk": 12, "rt_sigaction": 13, "rt_sigprocmask": 14, "rt_sigreturn": 15, "mremap": 25, "madvise": 28,
                                 "getpid": 39, "exit": 60, "gettid": 186, "futex": 202, "clock_gettime": 228, "exit_group": 231,
                                 "getrandom": 318}),
         "aarch64": (0xC00000B7, {"read": 63, "write": 64, "close": 57, "fstat": 80, "lseek": 62, "mmap": 222, "mprotect": 226,
                                  "munmap": 215, "brk": 214, "rt_sigaction": 134, "rt_sigprocmask": 135, "rt_sigreturn": 139,
                                  "mremap": 216, "madvise": 233, "getpid": 172, "exit": 93, "gettid": 178, "futex": 98,
                                  "clock_gettime": 113, "exit_group": 94, "getrandom": 278})}


def prepare_bounds():
    """The library for prctl, found before anything is bounded."""
    return ctypes.CDLL(None, use_errno=True)


def bound(libc, seconds, descriptor):
    """Memory, time, no file, no process: reading nothing, and writing the outcome."""
    resource.setrlimit(resource.RLIMIT_AS, (MEGABYTES << 20,) * 2)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds + 1,) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    for k in range(64):
        if k != descriptor:
            try:
                os.close(k)
            except OSError:
                pass
    architecture, calls = CALLS[os.uname().machine]
    def step(code, k, yes=0, no=0):
        return struct.pack("HBBI", code, yes, no, k)
    allow, refuse = step(0x06, 0x7FFF0000), step(0x06, 0x00050001)  # SECCOMP_RET_ALLOW; ERRNO with EPERM
    rules = [step(0x20, 4), step(0x15, architecture, 1, 0), refuse, step(0x20, 0)]
    for number_of_call in calls.values():
        rules += [step(0x15, number_of_call, 0, 1), allow]
    rules.append(refuse)
    program = ctypes.create_string_buffer(b"".join(rules))
    class Program(ctypes.Structure):
        _fields_ = [("length", ctypes.c_ushort), ("rules", ctypes.c_void_p)]
    whole = Program(len(rules), ctypes.addressof(program))
    if libc.prctl(38, 1, 0, 0, 0) != 0 or libc.prctl(22, 2, ctypes.byref(whole), 0, 0) != 0:
        raise OSError("the system does not bound what a process may ask of it")


def apart(code, cases, job, libc):
    """The outcome, as a line, of the job in a process of its own."""
    seconds = max(1, int(job.get("seconds", 1)))
    from_child, to_parent = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            bound(libc, seconds, to_parent)
            text = json.dumps(play(code, cases, job))
        except BaseException as e:  # whatever it is, the process ends here
            text = json.dumps({"end": "crashed", "message": f"{type(e).__name__}"})
        data = text.encode()
        while data:
            data = data[os.write(to_parent, data):]
        os._exit(0)
    os.close(to_parent)
    said, until = b"", time.monotonic() + seconds + 1
    while len(said) < 1 << 25:
        left = until - time.monotonic()
        if left <= 0 or not select.select([from_child], [], [], left)[0]:
            said = b""
            break
        part = os.read(from_child, 1 << 16)
        if not part:
            break
        said += part
    os.close(from_child)
    os.kill(child, signal.SIGKILL)
    status = os.waitpid(child, 0)[1]
    late = time.monotonic() >= until or (os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGXCPU)
    if not said:
        return json.dumps({"end": "bound" if late else "crashed", "message": "time: it takes too long" if late else "the process ended"})
    return said.decode()


def main():
    if sys.argv[1] == "--inspect":
        return inspect(sys.argv[2])
    Run.answer = "answer"
    tree = Exactly().visit(ast.parse(open(sys.argv[1], encoding="utf-8").read()))
    code = compile(ast.fix_missing_locations(tree), Run.answer, "exec")
    cases = json.load(open(sys.argv[2], encoding="utf-8"))
    for case in cases:
        case["compiled"] = compile(case["call"], "call", "exec")
    libc = prepare_bounds()
    for line in sys.stdin:
        print(apart(code, cases, json.loads(line), libc), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
