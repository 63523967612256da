"""What a certificate looks like.  recheck.py calls a certificate wrong that looks otherwise, so that a field with an unknown word, a
list of another length or an entry that stands twice is never taken for something that merely cannot be rechecked."""
import json, re

WORDS = {"meant", "argued", "cites"} # roles without a claim
ROLES = {"holds-by", "confirmed-by", "refuted-by", "corrected-by", "hypothesis", "needs", "reading", "reading-with", "checked-by"} | WORDS
KINDS = {"identity", "decision", "counterexample"}
EVIDENCE = {"none", "measured", "enclosed", "sampled", "argued", "decided", "proved"}
VERDICTS = {"holds", "conditional", "fails", "undecided", "definition"}

class Malformed(ValueError):
    pass
def ask(condition, what):
    if not condition:
        raise Malformed(what)

def unique(pairs):
    """An object of JSON in which no key stands twice."""
    found = dict(pairs)
    ask(len(found) == len(pairs), "a key that stands twice")
    return found
def read(text):
    """Numbers with a point are texts, so that none is an index; NaN and Infinity are no JSON."""
    def constant(name):
        raise Malformed(f"{name} is no number")
    return json.loads(text, parse_float=str, object_pairs_hook=unique, parse_constant=constant)

whole = lambda x: type(x) is int
node = lambda x: type(x) is int and x >= 0
count = node
positive = lambda x: type(x) is int and x > 0
truth = lambda x: type(x) is bool
bit = lambda x: type(x) is int and x in (0, 1)
sign = lambda x: type(x) is int and x in (-1, 0, 1)
text = lambda x: type(x) is str
number = lambda x: text(x) and re.fullmatch(r"-?[0-9]+(/[0-9]+)?", x)
inputs = lambda x: several(several(text, 2))(x) and all(number(value) for _, value in x)
program = lambda a: type(a) is list and all(whole(x) or text(x) for x in a) and (a[:1] not in (["c"], ["o"]) or all(map(number, a[1:])))
end = lambda x: type(x) is int and x >= -1
single = lambda x: several(end, 2)(x) and x[0] >= 0 and x[1] == -1
def several(of, *lengths):
    return lambda x: type(x) is list and all(map(of, x)) and (not lengths or len(x) in lengths)
def one_of(words):
    return lambda x: type(x) is str and x in words

POLYNOMIAL = {"p": node, "from": several(end, 2), "with_ends": several(bit, 2)}
HULL = {"dim": positive, "points": several(node), "x": several(node), "is": bit}
# For each kind of fact the lists of fields that it may have.
FACTS = {
    "order": [{"of": several(end, 2), "is": sign}],
    "equal": [{"of": several(end, 2), "is": bit}],
    "pequal": [{"of": several(end, 2), "is": bit}],
    "whole": [{"of": single, "is": bit}],
    "degree": [{"of": single, "is": end}],
    "degrees": [{"of": several(node, 2), "is": several(end, 2)}],
    "roots": [{**POLYNOMIAL, "distinct": count, "counted": count, "crossings": count, "touches": count}, {**POLYNOMIAL, "distinct": count}],
    "sign": [{**POLYNOMIAL, "is": lambda x: count(x) and x <= 5}],
    "curve_and_line": [{"R": several(node), "w": several(node), "line": several(node, 3), "is": several(count, 7)}],
    "polygon_and_line": [{"R": several(node), "line": several(node, 3), "is": several(count, 4)}],
    "operations": [{"out": lambda x: several(node)(x) and x, "additions": count, "multiplications": count, "shifts": count}],
    "hull": [{**HULL, "coefficients": several(node)}, {**HULL, "normal": several(node), "offset": several(node, 1)}],
    "hull_vertices": [{"points": several(node), "vertices": several(count)}],
    "convex_polygon": [{"points": several(node), "closed": bit, "orientation": sign, "is": bit}],
    "minors": [{"rows": positive, "columns": positive, "A": several(node), "strict": bit, "is": bit}],
    "determinant": [{"rows": count, "A": several(node), "is": several(node, 1)}],
}
STEPS = [{"same": several(node, 2), "equal": truth}, {"agree": truth}, {"agree": truth, "formula": text}, {"nonnegative": node, "good": truth},
         {"nonnegative": node, "good": truth, "text": text, "sign": sign}]
CASE = {"type": one_of({"field", "rational"}), "degree": count, "inputs": inputs, "nodes": several(program), "steps": several(lambda x: type(x) is dict)}
CLAIM = {"schema": one_of({"cagd-certificate-1"}), "claim": text, "kind": one_of(KINDS), "outcome": one_of({"holds", "fails", "undecided"}),
         "evidence": one_of(EVIDENCE - {"argued"}), "argued": truth, "cases": several(lambda x: type(x) is dict)}
STATEMENT = {"schema": one_of({"cagd-certificate-1"}), "statement": text, "definition": truth, "verdict": one_of(VERDICTS),
             "evidence": one_of(EVIDENCE), "links": several(lambda x: type(x) is dict)}

def has(document, fields, what):
    ask(type(document) is dict and set(document) == set(fields), f"{what} has other fields")
    for field, good in fields.items():
        ask(good(document[field]), f"{what}: the field {field}")

def check_step(step):
    if "fact" not in step:
        has(step, next((s for s in STEPS if set(s) == set(step)), {}), "a step")
        return
    ask(step["fact"] in FACTS, f"no fact is of kind {step['fact']}")
    known = FACTS[step["fact"]]
    has({k: x for k, x in step.items() if k != "fact"}, next((f for f in known if set(f) | {"fact"} == set(step)), known[0]), step["fact"])
    size = lambda field: len(step[field])
    if step["fact"] == "hull":
        d, inside = step["dim"], "coefficients" in step
        ask(bool(step["is"]) == inside and size("x") == d and size("points") % d == 0, "the shape of a hull")
        ask(size("coefficients") * d == size("points") if inside else size("normal") == d, "the shape of a hull's certificate")
    elif step["fact"] == "curve_and_line":
        ask(size("R") == 2 * size("w"), "as many weights as points")
    elif step["fact"] in ("polygon_and_line", "hull_vertices", "convex_polygon"):
        ask(size("R" if "R" in step else "points") % 2 == 0, "points of the plane")
    elif step["fact"] in ("minors", "determinant"):
        ask(size("A") == step["rows"] * step.get("columns", step["rows"]), "the shape of a matrix")

def check_claim(c):
    has(c, CLAIM, "the claim")
    for case in c["cases"]:
        has(case, CASE, "a case")
        ask(case["steps"], "a case that compares nothing")
        ask(c["evidence"] != "proved" or case["type"] == "field", "what is proved is proved in the field")
        ask(case["type"] != "field" or len(dict(case["inputs"])) == len(case["inputs"]), "two variables of one name")
        for step in case["steps"]:
            check_step(step)

def check_statement(s, name):
    has(s, STATEMENT, "the statement")
    ask(s["statement"] == name, "the file of another statement")
    for link in s["links"]:
        ask(link.get("role") in ROLES, f"no claim has the role {link.get('role')}")
        fields = {"role": text} | ({"claim": text} if "claim" in link else {}) | ({"adds_cases": truth} if link["role"] == "argued" else {})
        has(link, fields, "a link")
        ask(("claim" in link) != (link["role"] in WORDS) or link["role"] in ("hypothesis", "reading"), "a link without a claim")
