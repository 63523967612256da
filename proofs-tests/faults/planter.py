"""Where a fault can be planted in a C file, of which kind, and how it is switched on in a program that holds many.

The places are those of clang's syntax tree (`-ast-dump=json`), so that a fault replaces a whole expression or statement.  What
stands there becomes a choice, `(fault_is(N) ? fault : original)`, which the environment variable CAGD_FAULT makes when
the program runs.
"""
import json
import pathlib
import re
import subprocess

SWITCH = """#ifndef CAGD_FAULT_SWITCH
#define CAGD_FAULT_SWITCH
#include <stdlib.h>
static inline int fault_is(int number)
{
    static int planted = -1;
    if (planted < 0) {
        const char *text = getenv("CAGD_FAULT");
        planted = text == NULL ? 0 : atoi(text);
    }
    return number == planted;
}
#endif
"""

ARITHMETIC = {"+": ("sum to difference", "-"), "-": ("difference to sum", "+"), "*": ("product to sum", "+"),
              "/": ("quotient to product", "*"), "%": ("remainder to quotient", "/")}
COMPARED = {"<": ("strict to weak", "<="), ">": ("strict to weak", ">="), "<=": ("weak to strict", "<"),
            ">=": ("weak to strict", ">"), "==": ("equal to unequal", "!="), "!=": ("unequal to equal", "==")}
TURNED = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
BITS = {"&": ("bits exchanged", "|"), "|": ("bits exchanged", "&"), "<<": ("shift turned", ">>"), ">>": ("shift turned", "<<")}
ASSIGNED = {"+=": "-=", "-=": "+=", "*=": "+=", "/=": "*=", "|=": "=", "&=": "=", "<<=": ">>=", ">>=": "<<="}
# What a function whose name contains the one word would do under the other.
OPPOSITE = [("add", "sub"), ("sub", "add"), ("mul", "add"), ("div", "mul"), ("min", "max"), ("max", "min"), ("floor", "ceil"),
            ("ceil", "floor"), ("fdiv_q", "cdiv_q"), ("cdiv_q", "fdiv_q"), ("lower", "upper"), ("upper", "lower"),
            ("numref", "denref"), ("denref", "numref"), ("left", "right"), ("right", "left")]
ROUNDING = {"MPFR_RNDD": "MPFR_RNDU", "MPFR_RNDU": "MPFR_RNDD"}
# Memory that is given back, and locks, are judged by the sanitizers: no fault is planted in functions and calls of such names.
HOUSEKEEPING = re.compile(r"clear|free|unlock|lock|destroy|close|cleanup|region_drop|thread_end|assert|fprintf|printf|fputs|abort")
# Their two operands may change places.
COMMUTE = re.compile(r"(?:^|_)(?:add|mul|min|max|fmin|fmax|equal|gcd|lcm|hull|hypot)(?:_[a-z]|_p|_si|_fmpz)?$")
# The two texts may, where the answer is asked to be 0 or not.
COMPARES = {"strcmp", "strncmp", "memcmp"}
WHOLE = {"int", "long", "unsigned int", "unsigned", "unsigned long", "size_t", "char", "unsigned char", "slong", "ulong", "long long",
         "mp_bitcnt_t", "_Bool", "ptrdiff_t"}
REAL = {"double", "float", "long double"}


class Node:
    __slots__ = ("kind", "start", "end", "name", "type", "plain", "op", "value", "children", "parent", "id", "file", "macro",
                 "refers", "refers_kind", "postfix", "has_else", "cast")

    def is_number(self):
        return self.plain in WHOLE or self.plain in REAL


class Tree:
    """The syntax tree of one translation unit, of which only what stands in the given files is kept."""

    def __init__(self, command, root, files):
        r = subprocess.run(command, cwd=root, capture_output=True)
        if not r.stdout:
            raise SystemExit(r.stderr.decode())
        self.root, self.files, self.at = root, files, ""
        self.fields, self.constants, self.functions, self.names, self.declared = {}, {}, [], {}, set()
        self.texts = {f: (root / f).read_bytes() for f in files}
        self.walk(json.loads(r.stdout), None)

    def resolve(self, place):
        if "offset" not in place:
            return None
        if "file" in place:
            name = place["file"]
            if name not in self.names:
                path = (self.root / name).resolve()
                self.names[name] = str(path.relative_to(self.root)) if path.is_relative_to(self.root) else name
            self.at = self.names[name]
        return self.at, place["offset"], place["offset"] + place["tokLen"]

    def location(self, place):
        """(file, first, end, whether it was made by a macro)"""
        if "spellingLoc" in place:
            spelled, expanded = self.resolve(place["spellingLoc"]), self.resolve(place["expansionLoc"])
            argument = place["expansionLoc"].get("isMacroArgExpansion") and spelled and spelled[0] in self.files
            return (*spelled, False) if argument else (*expanded, True) if expanded else None
        found = self.resolve(place)
        return (*found, False) if found else None

    def walk(self, raw, parent):
        if not raw:
            return None
        if "loc" in raw:
            self.location(raw["loc"])
        begin = self.location(raw["range"].get("begin", {})) if "range" in raw else None
        end = self.location(raw["range"].get("end", {})) if "range" in raw else None
        here = begin is not None and end is not None and begin[0] in self.files and end[0] == begin[0]
        node = None
        if here:
            node = Node()
            node.kind, node.file, node.start, node.end = raw["kind"], begin[0], begin[1], end[2]
            node.macro = begin[3] and end[3] and begin[1] == end[1]
            text = self.texts[node.file]
            if end[3] and text[node.end:node.end + 1] == b"(":
                node.end = after_parenthesis(text, node.end)
            node.type = raw.get("type", {}).get("qualType", "")
            node.plain = raw.get("type", {}).get("desugaredQualType", node.type)
            node.op, node.value = raw.get("opcode"), raw.get("value")
            node.name, node.id = raw.get("name"), raw.get("id")
            node.postfix, node.has_else, node.cast = raw.get("isPostfix"), raw.get("hasElse"), raw.get("castKind")
            refers = raw.get("referencedDecl", {})
            node.refers = refers.get("id") or raw.get("referencedMemberDecl")
            node.refers_kind = refers.get("kind")
            node.name = node.name or refers.get("name")
            node.parent, node.children = parent, []
        inner = []
        for child in raw.get("inner", []):
            made = self.walk(child, node)
            inner.append(made)
        kind = raw.get("kind")
        if kind == "FunctionDecl":
            self.declared.add(raw.get("name"))
        if kind in ("RecordDecl", "EnumDecl"):
            wanted = "FieldDecl" if kind == "RecordDecl" else "EnumConstantDecl"
            members = [c for c in raw.get("inner", []) if c.get("kind") == wanted and c.get("name")]
            for c in members:
                (self.fields if kind == "RecordDecl" else self.constants)[c["id"]] = [
                    (m["id"], m["name"], m.get("type", {}).get("qualType", "")) for m in members]
        if node is not None:
            node.children = inner
            if kind == "FunctionDecl" and inner and inner[-1] is not None and inner[-1].kind == "CompoundStmt":
                self.functions.append(node)
        return node


def after_parenthesis(text, at):
    depth = 0
    while at < len(text):
        depth += {b"(": 1, b")": -1}.get(text[at:at + 1], 0)
        at += 1
        if depth == 0:
            return at
    return at


class Planter:
    """The faults of the functions of a tree, as dictionaries: file, function, kind, first, end, what stands there, the fault, and the
    text with the switch, in which ON stands for the question."""

    def __init__(self, tree):
        self.tree, self.found, self.seen = tree, [], set()
        for function in tree.functions:
            self.function = function
            self.locals = []
            for child in function.children:
                if child is not None and child.kind == "ParmVarDecl" and child.name:
                    self.locals.append(child)
            self.text = tree.texts[function.file]
            if not HOUSEKEEPING.search(function.name):
                self.start_of_function(function)
                self.visit(function.children[-1])

    def source(self, node):
        return self.text[node.start:node.end].decode()

    def add(self, kind, first, end, now, switched):
        was = self.text[first:end].decode()
        key = (self.function.file, first, end, now, kind)
        if key in self.seen or was == now:
            return
        self.seen.add(key)
        line = self.text.count(b"\n", 0, first)
        after = self.text[:first] + now.encode() + self.text[end:]
        stands = self.text.split(b"\n")[line].decode().strip()
        changed = after.split(b"\n")[line].decode().strip() or "(nothing)"
        self.found.append({"file": self.function.file, "function": self.function.name, "kind": kind, "first": first, "end": end,
                           "line": line + 1, "old": stands, "new": changed, "text": now, "switched": switched})

    def replace(self, kind, node, now):
        if node.file != self.function.file or node.start >= node.end:
            return
        self.add(kind, node.start, node.end, now, f"(ON ? ({now}) : ({self.source(node)}))")

    def drop(self, kind, node):
        """A statement, with its semicolon."""
        end = node.end
        if node.kind != "CompoundStmt" and self.source(node)[-1:] != ";":
            while self.text[end:end + 1].isspace():
                end += 1
            if self.text[end:end + 1] != b";":
                return
            end += 1
        self.add(kind, node.start, end, ";" if node.kind != "CompoundStmt" else "{}",
                 "{ if (!ON) " + self.text[node.start:end].decode() + " }")

    # ---- statements ------------------------------------------------------------------------------------

    def start_of_function(self, function):
        body, result = function.children[-1], function.plain.split(" (")[0].split("(")[0].strip()
        at = body.start + 1
        answers = ["return;"] if result == "void" else ["return 0;"] if result in WHOLE | REAL else []
        for answer in answers:
            self.add("early return", at, at, f" {answer}", f" if (ON) {answer}")
        for v in self.locals:
            if v.plain == result or v.type == result:
                self.add("argument returned", at, at, f" return {v.name};", f" if (ON) return {v.name};")
                break

    def visit(self, node):
        if node is None or node.file != self.function.file:
            return
        if not (node.macro and node.kind not in ("DeclRefExpr", "CallExpr", "IntegerLiteral", "ImplicitCastExpr")):
            handler = getattr(self, "on_" + node.kind, None)
            if handler:
                handler(node)
        shielded = node.kind in ("CaseStmt", "EnumDecl", "RecordDecl")
        is_static = node.kind == "VarDecl" and b"static" in self.text[self.text.rfind(b"\n", 0, node.start):node.start + 8]
        for k, child in enumerate(node.children):
            if not (shielded and k == 0) and not is_static:
                self.visit(child)
                self.statement(node, child, k)
        if node.kind == "VarDecl" and node.name:
            self.locals.append(node)  # behind its first value, in which it has none

    def statement(self, parent, child, k):
        """A statement is what stands in a block or is the body of an if or a loop."""
        if child is None or child.macro:
            return
        bodies = {"CompoundStmt": True, "IfStmt": k > 0, "ForStmt": k == 4, "WhileStmt": k == 1}
        if not bodies.get(parent.kind):
            return
        if child.kind in ("CallExpr", "BinaryOperator", "CompoundAssignOperator", "UnaryOperator"):
            if not HOUSEKEEPING.search(self.source(child)):
                self.drop("statement dropped", child)
        elif child.kind == "BreakStmt":
            self.drop("break lost", child)
        elif child.kind == "ContinueStmt":
            self.add("continue to break", child.start, child.end, "break", "if (ON) break; else continue")
        elif child.kind == "ReturnStmt" and parent.kind != "CompoundStmt" or child.kind == "GotoStmt":
            self.drop("return lost", child)
        elif child.kind in ("ForStmt", "WhileStmt") and parent.kind == "CompoundStmt":
            self.add("loop dropped", child.start, child.start, "if (0) ", "if (!ON) ")

    def condition(self, node, loop=False):
        text = self.source(node)
        if not loop:
            self.replace("condition always true", node, "1")
            self.replace("condition negated", node, f"!({text})")
        self.replace("condition never true", node, "0")

    def on_IfStmt(self, node):
        self.condition(node.children[0])
        if node.has_else and len(node.children) > 2 and node.children[2].kind == "CompoundStmt":
            self.drop("else dropped", node.children[2])
        if node.children[1].kind == "CompoundStmt":
            self.drop("branch dropped", node.children[1])

    def on_WhileStmt(self, node):
        self.condition(node.children[0], loop=True)

    def on_ForStmt(self, node):
        condition = node.children[2]
        if condition is not None:
            self.condition(condition, loop=True)
            if condition.kind == "BinaryOperator" and condition.op in ("<", "<="):
                left, right = map(self.source, condition.children)
                self.replace("loop one short", condition, f"{left} {condition.op} {right} - 1")

    def on_ReturnStmt(self, node):
        if not node.children or node.children[0] is None:
            return
        value = node.children[0]
        if value.plain in WHOLE:
            self.replace("answer negated", value, f"!({self.source(value)})")
            self.replace("answer zero", value, "0")
        elif value.plain in REAL:
            self.replace("sign of the answer", value, f"-({self.source(value)})")

    # ---- expressions -----------------------------------------------------------------------------------

    def on_ConditionalOperator(self, node):
        self.condition(node.children[0])

    def on_BinaryOperator(self, node):
        if None in node.children or len(node.children) != 2:
            return
        left, right = map(self.source, node.children)
        pointers = "*" in node.plain or "[" in node.plain
        if node.op in ARITHMETIC and node.is_number() and "*" not in node.children[0].plain:
            kind, op = ARITHMETIC[node.op]
            self.replace(kind, node, f"{left} {op} {right}")
            self.replace("second operand lost", node, left)
        elif node.op in "+-" and pointers:
            self.replace("offset lost", node, left)
        elif node.op in COMPARED:
            kind, op = COMPARED[node.op]
            self.replace(kind, node, f"{left} {op} {right}")
            if node.op in TURNED:
                self.replace("comparison turned", node, f"{left} {TURNED[node.op]} {right}")
        elif node.op in ("&&", "||"):
            kind, op = ("and to or", "||") if node.op == "&&" else ("or to and", "&&")
            self.replace(kind, node, f"({left}) {op} ({right})")
            self.replace("first condition lost", node, right)
            self.replace("second condition lost", node, left)
        elif node.op in BITS and node.is_number():
            kind, op = BITS[node.op]
            self.replace(kind, node, f"{left} {op} {right}")

    def on_CompoundAssignOperator(self, node):
        if node.op in ASSIGNED:
            left, right = map(self.source, node.children)
            self.replace("another assignment", node, f"{left} {ASSIGNED[node.op]} {right}")

    def on_UnaryOperator(self, node):
        text = self.source(node)
        if node.op == "-":
            self.replace("sign lost", node, self.source(node.children[0]))
        elif node.op == "!":
            self.replace("negation lost", node, self.source(node.children[0]))
        elif node.op in ("++", "--") and node.parent is not None and node.parent.kind != "ForStmt":
            self.replace("step turned", node, text.replace(node.op, {"++": "--", "--": "++"}[node.op]))

    def on_IntegerLiteral(self, node):
        text = self.source(node)
        if not node.macro:
            self.replace("constant one more", node, f"{text} + 1")
            if node.value not in ("0", "1") or node.plain == "int":
                self.replace("constant one less", node, f"{text} - 1")

    def on_FloatingLiteral(self, node):
        if not node.macro:
            self.replace("constant doubled", node, f"2 * {self.source(node)}")

    def on_ArraySubscriptExpr(self, node):
        index = node.children[1]
        if index is not None and index.plain in WHOLE and index.kind != "IntegerLiteral":
            self.replace("index one more", index, f"{self.source(index)} + 1")
            self.replace("index one less", index, f"{self.source(index)} - 1")

    def on_CallExpr(self, node):
        callee, arguments = node.children[0], node.children[1:]
        if callee is None or None in arguments:
            return
        name = re.match(rb"\w+", self.text[node.start:])
        if name is None:
            return
        name = name.group().decode()
        if HOUSEKEEPING.search(name) or name.endswith(("_init", "_init2", "_inits2", "_set_prec")):
            return
        for word, other in OPPOSITE:
            if re.search(rf"(?:^|_){word}(?![a-z])", name):
                now = re.sub(rf"((?:^|_)){word}(?![a-z])", rf"\g<1>{other}", name, count=1)
                # mpz_add is __gmpz_add, add_q is cagd_add_q, and add of a kernel add_q.
                if self.tree.declared & {now, f"__g{now}", f"cagd_{now}", f"{now}_q"}:
                    self.replace("the opposite function", node, now + self.source(node)[len(name):])
                break
        asks_whether_equal = node.parent is not None and node.parent.op in ("==", "!=")
        for a, b in zip(arguments, arguments[1:]):
            if a.type == b.type and a.end < b.start and self.source(a) != self.source(b):
                between = self.text[a.end:b.start].decode()
                whole = self.source(node)
                here = lambda x, y: whole[:a.start - node.start] + x + between + y + whole[b.end - node.start:]
                if len(whole) == len(whole.encode()):
                    if not COMMUTE.search(name) and not (asks_whether_equal and name in COMPARES):
                        self.replace("operands exchanged", node, here(self.source(b), self.source(a)))
                    self.replace("operand repeated", node, here(self.source(a), self.source(a)))
        for a in arguments:
            if a.plain == node.plain and node.plain != "void" and not node.plain.endswith("*"):
                self.replace("call lost", node, self.source(a))
                break

    def on_ImplicitCastExpr(self, node):
        inner = node.children[0] if node.children else None
        if inner is None or node.cast not in ("LValueToRValue", "ArrayToPointerDecay", "NoOp", "IntegralCast"):
            return
        if inner.kind == "DeclRefExpr" and inner.refers_kind in ("VarDecl", "ParmVarDecl") and not inner.macro:
            same = [v for v in self.locals if v.type == inner.type]
            names = list(dict.fromkeys(v.name for v in same))
            if inner.name in names and len(names) > 1:
                self.replace("another variable", node, names[(names.index(inner.name) + 1) % len(names)])
        elif inner.kind == "MemberExpr" and inner.refers in self.tree.fields:
            members = self.tree.fields[inner.refers]
            own = next(m for m in members if m[0] == inner.refers)
            same = [m for m in members if m[2] == own[2]]
            if len(same) > 1:
                other = same[(same.index(own) + 1) % len(same)][1]
                text = self.source(inner)
                if text.endswith(own[1]):
                    self.replace("another member", node, text[:len(text) - len(own[1])] + other)

    def on_DeclRefExpr(self, node):
        text = self.source(node)
        if text in ROUNDING:
            self.replace("rounding turned", node, ROUNDING[text])
        elif node.refers_kind == "EnumConstantDecl" and node.refers in self.tree.constants:
            members = self.tree.constants[node.refers]
            own = next(k for k, m in enumerate(members) if m[0] == node.refers)
            if len(members) > 1:
                self.replace("another constant of the list", node, members[(own + 1) % len(members)][1])

    def on_VarDecl(self, node):
        value = node.children[-1] if node.children else None
        if value is not None and node.is_number() and value.kind != "IntegerLiteral" and not node.macro:
            self.replace("start value zero", value, "0")


def plant(text, faults):
    """The text of a file, bytes, with the switches of faults that do not overlap but may be of one place."""
    places = {}
    for f in faults:
        places.setdefault((f["first"], f["end"]), []).append(f)
    for (first, end), here in sorted(places.items(), reverse=True):
        was = text[first:end].decode()
        if first == end:
            now = "".join(on(f) for f in here)
        elif any(f["switched"].startswith(("{", "if")) for f in here):
            now = on(here[0])
        else:
            now = "(" + "".join(f"fault_is({f['number']}) ? ({f['text']}) : " for f in here) + f"({was}))"
        text = text[:first] + now.encode() + text[end:]
    return text


def on(fault):
    return re.sub(r"\bON\b", f"fault_is({fault['number']})", fault["switched"])


def batches(chosen):
    """The faults in as few lists as it takes for no two of a list to overlap, unless they are replacements of one expression."""
    lists = []
    for f in sorted(chosen, key=lambda f: (f["file"], f["first"], -f["end"])):
        expression = not f["switched"].startswith(("{", "if", " if"))
        for batch in lists:
            last = batch[-1]
            same = (last["file"], last["first"], last["end"]) == (f["file"], f["first"], f["end"]) and expression \
                and not last["switched"].startswith(("{", "if", " if"))
            apart = last["file"] != f["file"] or last["end"] < f["first"] or \
                (last["end"] <= f["first"] and last["first"] < last["end"] and f["first"] < f["end"])
            if same or apart:
                batch.append(f)
                break
        else:
            lists.append([f])
    return lists
