"""The register that weave writes, build/…/chapters/generated/register.json: claims, statements and sources as the tests read them."""
import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
USUAL = ROOT / "build/release/chapters/generated/register.json"


def load(path=USUAL):
    """The register; each claim, statement and source has its options as `has`, a dictionary of lists of texts."""
    path = pathlib.Path(path)
    if not path.exists():
        raise SystemExit(f"{path}: there is no register; cmake --build build/release --target cagd makes one")
    register = json.loads(path.read_text(encoding="utf-8"))
    for entry in register["claims"] + register["statements"] + register["sources"]:
        entry["has"] = {}
        for key, text in entry["options"]:
            entry["has"].setdefault(key, []).append(text)
    return register


def words(entry, key):
    """The words of all options of that key."""
    return [word for text in entry["has"].get(key, []) for word in text.split()]


def claims_of(register, statement):
    """The names of the claims that a statement names, under whatever key, each once."""
    names = {c["name"] for c in register["claims"]}
    found = []
    for _, text in statement["options"]:
        for word in text.split("|")[0].split():
            if word in names and word not in found:
                found.append(word)
    return found
