"""Where the words of a figure stand, by the widths of a font.

    boxes(path)   every text of an SVG file of the gallery: (x0, y0, x1, y1, its class, its words)

The widths are those of DejaVu, which takes the place of the fonts of the figures where they are not there, and is wider.
"""
import json
import pathlib
import re
import xml.etree.ElementTree

FONTS = json.loads((pathlib.Path(__file__).parent / "dejavu-widths.json").read_text(encoding="utf-8"))
SIZES = {"n": 12.5, "k": 11.5, "d": 13.5, "t": 16}  # as the style of the figures has them; others are 14.5
TEXT = "{http://www.w3.org/2000/svg}text"


def width_of(words, font, size):
    return sum(FONTS[font].get(c, 1000) for c in words) * size / 1000


def text_width(text, size, bold):
    """How far to the right the words go: scripts are set back by dx."""
    pen = furthest = width_of(text.text or "", bold, size)
    for span in text:
        names = span.get("class", "").split()
        scale = (1.12 if {"i", "u"} & set(names) else 1) * (0.8 if "s" in names else 1)
        pen += float(span.get("dx", 0)) + width_of(span.text or "", "serif" if {"i", "u"} & set(names) else bold, size * scale)
        furthest = max(furthest, pen)
        pen += width_of(span.tail or "", bold, size)
        furthest = max(furthest, pen)
    return furthest


def boxes(path):
    found = []

    def visit(element, x, y):
        moved = re.match(r"translate\((\S+) (\S+)\)$", element.get("transform", ""))
        if moved:
            x, y = x + float(moved[1]), y + float(moved[2])
        if element.tag == TEXT:
            names = element.get("class").split()
            size = next((SIZES[name] for name in names if name in SIZES), 14.5)
            width = text_width(element, size, "bold" if names[0] in "dt" else "sans")
            left = x + float(element.get("x")) - width * {"middle": 0.5, "end": 1}.get(element.get("text-anchor"), 0)
            base = y + float(element.get("y"))
            found.append((left, base - 0.75 * size, left + width, base + 0.2 * size, names[0], "".join(element.itertext())))
        for child in element:
            visit(child, x, y)

    root = xml.etree.ElementTree.parse(path).getroot()
    visit(root, 0, 0)
    return found, float(root.get("width")), float(root.get("height"))
