"""cagd fit as its users meet it: every form of input, every mistake, what is printed and what is written.

    python3 test_fit.py CAGD ROOT
"""
import csv
import decimal
import itertools
import io
import json
import math
import os
import pathlib
import pty
import random
import re
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

ROOT = pathlib.Path(sys.argv.pop(2)).resolve()
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(ROOT / "proofs-tests/scripts"))
import builds  # noqa: E402
ONCE = builds.once(CAGD)
ARCH = ROOT / "chapters" / "fitting" / "arch.csv"


def run(*args, **options):
    return subprocess.run([CAGD, *map(str, args)], capture_output=True, timeout=600, **options)


def quadratic(n, w=0.75, noise=0.0, seed=1):
    """Points of a rational quadratic, moved at random."""
    r = random.Random(seed)
    rows = []
    for i in range(n):
        t = i / (n - 1)
        b = [(1 - t) ** 2, 2 * t * (1 - t) * w, t * t]
        s = sum(b)
        rows.append([(4 * b[2] + b[1]) / s + r.gauss(0, noise), 2 * b[1] / s + r.gauss(0, noise)])
    return rows


def helix(n, noise=0.0):
    r = random.Random(2)
    return [[math.cos(a) + r.gauss(0, noise), math.sin(a) + r.gauss(0, noise), a / 3 + r.gauss(0, noise)]
            for a in (2.5 * i / (n - 1) for i in range(n))]


def table(rows, separator=",", end="\n", names=None, number=repr):
    lines = [separator.join(names)] if names else []
    return end.join(lines + [separator.join(map(number, row)) for row in rows]) + end


class Case(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))

    def file(self, text, name="points.csv"):
        path = self.folder / name
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    def fit(self, text, *options, code=0):
        """The JSON of the fit; nothing on stderr."""
        path = text if isinstance(text, pathlib.Path) else self.file(text)
        r = run("fit", path, "--json", *options)
        self.assertEqual((r.returncode, r.stderr), (r.returncode if code is None else code, b""), r)
        return json.loads(r.stdout)

    def points_of(self, curve, parameters, *options):
        """Rows of numbers that cagd curve prints for the parameters."""
        r = run("curve", self.file(json.dumps(curve), "curve.json"), "--csv", *options, "--at-file", self.file("\n".join(parameters), "t.txt"))
        self.assertEqual((r.returncode, r.stderr), (0, b""), r)
        return [[float(x) for x in row] for row in list(csv.reader(io.StringIO(r.stdout.decode())))[1:]]

    def refuses(self, text, words, *options):
        """Exit 2, nothing on stdout, one line on stderr that names the file and has the words; no file written."""
        path = self.file(text)
        svg = self.folder / "no.svg"
        r = run("fit", path, "--svg", svg, *options)
        said = r.stderr.decode()
        self.assertEqual((r.returncode, r.stdout), (2, b""), r)
        self.assertEqual(len(said.splitlines()), 1, said)
        for word in [str(path), *words]:
            self.assertIn(word, said)
        self.assertFalse(svg.exists())

    def refuses_usage(self, *options, words=()):
        r = run("fit", *options)
        said = r.stderr.decode()
        self.assertEqual((r.returncode, r.stdout), (2, b""), r)
        self.assertLessEqual(len(said.splitlines()), 2, said)
        for word in words:
            self.assertIn(word, said)


class Input(Case):
    """What a file says is the same in every form."""

    ROWS = quadratic(9, noise=0.01)
    WITH_SIGMA = [row + [0.01 + 0.001 * k] for k, row in enumerate(ROWS)]

    def curve(self, text, *options):
        return self.fit(text, "--no-verify", *options)["curve"]

    def test_forms_of_two_columns(self):
        wanted = self.curve(table(self.ROWS))
        comma = lambda x: repr(x).replace(".", ",")
        rows = table(self.ROWS).splitlines()
        forms = {
            "semicolons": table(self.ROWS, ";"), "tabs": table(self.ROWS, "\t"), "blanks": table(self.ROWS, "   "),
            "comma and blank": table(self.ROWS, ", "), "blank and comma": table(self.ROWS, " , "),
            "CRLF": table(self.ROWS, end="\r\n"), "CR": table(self.ROWS, end="\r"),
            "names": table(self.ROWS, names=["x", "y"]), "names with units": table(self.ROWS, names=["X [mm]", "Y [mm]"]),
            "other names": table(self.ROWS, ";", names=["East", "North"]),
            "quoted": table(self.ROWS, names=['"x"', '"y"'], number=lambda x: f'"{x!r}"'),
            "decimal comma, semicolons": table(self.ROWS, ";", number=comma),
            "decimal comma, tabs": table(self.ROWS, "\t", number=comma),
            "decimal comma, blanks": table(self.ROWS, " ", number=comma),
            "decimal comma, quoted": table(self.ROWS, number=lambda x: '"' + comma(x) + '"'),
            "hexadecimal": table(self.ROWS, " ", number=float.hex),
            "comments": "# a survey\n\n" + "\n# more\n\n".join(rows) + "\n#",
            "no newline at the end": "\n".join(rows),
            "mark of UTF-8": b"\xef\xbb\xbf" + table(self.ROWS, names=["x", "y"]).encode(),
            "separator at the end": ",\n".join(rows) + ",\n",
            "leading blanks": "\n".join("  " + r for r in rows),
            "other columns": table([["p%d" % k, r[1], "ok", r[0]] for k, r in enumerate(self.ROWS)], ";",
                                   names=["id", "y", "state", "x"], number=str),
        }
        for name, text in forms.items():
            with self.subTest(name):
                self.assertEqual(self.curve(text), wanted)

    def test_standard_input(self):
        text = table(self.ROWS).encode()
        r = run("fit", "-", "--json", "--no-verify", input=text)
        self.assertEqual((r.returncode, r.stderr), (0, b""))
        self.assertEqual(json.loads(r.stdout)["curve"], self.curve(table(self.ROWS)))

    def test_forms_of_sigma(self):
        wanted = self.curve(table(self.WITH_SIGMA, names=["x", "y", "sigma"]))
        self.assertNotEqual(wanted, self.curve(table(self.ROWS)))
        first = [[r[2], r[0], r[1]] for r in self.WITH_SIGMA]
        forms = [(table(self.WITH_SIGMA), "--dim", "2"), (table(self.WITH_SIGMA), "--sigma-column", "3"),
                 (table(first), "--sigma-column", "1"), (table(first, names=["u", "x", "y"]), "--sigma-column", "u"),
                 (table(first, ";", names=["s [mm]", "x [mm]", "y [mm]"]),),
                 (table(self.WITH_SIGMA, names=["x", "y", "σ"]),), (table(self.WITH_SIGMA, names=["x", "y", "StdDev"]),)]
        for text, *options in forms:
            with self.subTest(text[:30], options=options):
                self.assertEqual(self.curve(text, *options), wanted)
        one = self.fit(table(self.ROWS), "--sigma", "0.01")
        self.assertEqual(one["points"]["sigma"], "one")
        self.assertEqual(one["statistics"]["scale_squared"], 1)

    def test_forms_of_space(self):
        rows = helix(12)
        wanted = self.curve(table(rows, names=["x", "y", "z"]))
        self.assertEqual(len(wanted["points"][0]), 3)
        self.assertEqual(self.curve(table(rows), "--dim", "3"), wanted)
        four = [r + [0.5] for r in rows]
        self.assertEqual(self.curve(table(four)), self.curve(table(four, names=["x", "y", "z", "s"])))
        flat = self.curve(table(rows, names=["x", "y", "z"]), "--dim", "2")
        self.assertEqual(len(flat["points"][0]), 2)

    def test_large_files_are_read_in_linear_time(self):
        path = self.file(table(quadratic(200000, noise=0.001)))
        r = run("fit", path, "--sigma-column", "9")  # read as far as the first row
        self.assertIn(b"--sigma-column 9", r.stderr)
        path.write_text(path.read_text() + "1,oops\n")
        r = run("fit", path)
        self.assertIn(b"line 200001, column 3: y: 'oops'", r.stderr)


def airfoil(n=31, camber=0.02, place=0.4, thickness=0.12):
    """The upper and the lower side of an airfoil of NACA's four digits, each from the nose (Jacobs, Ward, Pinkerton 1933)."""
    sides = [], []
    for k in range(n):
        x = (1 - math.cos(math.pi * k / (n - 1))) / 2
        y = 5 * thickness * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1015 * x**4)
        c = camber / place**2 * (2 * place * x - x * x) if x < place else camber / (1 - place)**2 * (1 - 2 * place + 2 * place * x - x * x)
        for side, sign in zip(sides, (1, -1)):
            side.append([round(x, 5), round(c + sign * y, 5)])
    return sides


class Files(Case):
    """Files as people have them: what is passed over, turned or joined is named, and the points are the same."""

    UPPER, LOWER = airfoil()
    SELIG = UPPER[::-1] + LOWER[1:]

    def read(self, text, *options, name="points.csv"):
        """Points as they were read, the rows of the file they stand in, and what was noted."""
        out = self.folder / "r.csv"
        r = run("fit", self.file(text, name), "--json", "--no-verify", "--max-iterations", "1", "--residuals", out, *options)
        self.assertIn(r.returncode, (0, 1), r)
        self.assertEqual(r.stderr, b"")
        points = json.loads(r.stdout)["points"]
        rows = list(csv.DictReader(out.read_text().splitlines()))
        at = [[float(row[c]) for c in "xyz" if c in row] for row in rows]
        return at, [int(row["line"]) for row in rows], points["format"], points["notes"]

    def body(self, rows):
        return "".join("".join("%10.5f" % x for x in row) + "\n" for row in rows)

    def test_titles(self):
        for title in "RG-15", "NACA 2412", "CLARK Y AIRFOIL", "Clark Y", "E387  (10.0%)", "61", "Profil \x01 München 12", "x":
            with self.subTest(title):
                at, lines, form, notes = self.read(title + "\n" + self.body(self.SELIG))
                self.assertEqual((at, lines[0], form), (self.SELIG, 2, "table"))
                self.assertEqual(notes, [f'line 1, "{title.replace(chr(1), " ")}", is passed over'])
        at, lines, _, notes = self.read("E 387\n61\n\nx/c y/c\n" + self.body(self.SELIG))
        self.assertEqual((at, lines[0], len(notes)), (self.SELIG, 5, 2))
        said = " ".join(run("fit", self.file("NACA 2412\n" + self.body(self.SELIG)), "--no-verify").stdout.decode().split())
        self.assertIn('Read line 1, "NACA 2412", is passed over', said)

    def test_a_first_row_with_a_mistake_is_no_title(self):
        self.refuses("oops,1\n1,2\n3,4\n", ["line 1, column 1", "x: 'oops' is not a number"])
        self.refuses("x1 1.5 2.5 3 4\nx2 1.5 2.5 3 4\n", ["line 1", "5 columns"])
        self.refuses("1\n2\n3\n", ["line 1", "1 column"])
        self.refuses("1.o 2\n1 2\n", ["line 1", "'1.o' is not a number"])

    def test_names_over_blanks(self):
        for names in "x [mm]   y [mm]", "    x      y", "X Coordinate   Y Coordinate", "x, y", "x (m)\ty (m)", "x;y", "x, y\nmm, mm":
            with self.subTest(names):
                self.assertEqual(self.read(names + "\n" + self.body(self.UPPER))[0], self.UPPER)
        turned = [[y, x] for x, y in self.UPPER]
        self.assertEqual(self.read("y [mm]   x [mm]\n" + self.body(turned))[0], self.UPPER)
        self.assertEqual(self.read("Title\ny [mm]   x [mm]\n" + self.body(turned))[0], self.UPPER)

    def test_lednicer(self):
        text = "NACA 2412\n       31.      31.\n\n" + self.body(self.UPPER) + "\n" + self.body(self.LOWER)
        at, lines, _, notes = self.read(text)
        self.assertEqual(at, self.SELIG)
        self.assertEqual(lines, [*range(34, 3, -1), *range(37, 67)])
        self.assertIn("31 points of the upper and 31 of the lower side", notes[1])
        below = self.body([[-0.0, -0.0]] + self.LOWER[1:])  # the same nose
        self.assertIn("-0", below)
        self.assertEqual(self.read("31 31\n" + self.body(self.UPPER) + below)[0], self.SELIG)
        blunt = [[x, round(y - 0.001, 5)] for x, y in self.LOWER]  # a nose of its own
        self.assertEqual(self.read("31 31\n" + self.body(self.UPPER + blunt))[0], self.UPPER[::-1] + blunt)
        for text in "30 31\n" + self.body(self.UPPER + self.LOWER), "31 31\n" + self.body(self.UPPER[::-1] + self.LOWER):
            self.assertEqual(len(self.read(text)[0]), 63)  # a point as others are

    def test_thousands_are_refused(self):
        said = "nothing between the thousands"
        for text in ("x;y\n1,234.5;2\n", "x;y\n1.234,5;2\n", "1'234.5 2'345.5\n", "x;y\n1 234,5;2\n", "1\u202f234,5;2\n",
                     "1,234.5,2,345.5\n1,235.5,2,346.5\n", "x,y\n1,234.5,2,345.5\n", 'x,y\n"1,234,567",2\n', "1_234;2\n3;4\n"):
            with self.subTest(text):
                self.refuses(text, [said])

    def test_json(self):
        names = [dict(x=x, y=y) for x, y in self.UPPER]
        for value in (self.UPPER, names, {"x": [x for x, _ in self.UPPER], "y": [y for _, y in self.UPPER]}, {"points": self.UPPER},
                      [dict(X=x, Y=y, id="p") for x, y in self.UPPER]):
            at, lines, form, notes = self.read(json.dumps(value))
            self.assertEqual((at, form, notes), (self.UPPER, "JSON", []))
        self.assertEqual(self.read("\n".join(map(json.dumps, self.UPPER)))[:2], (self.UPPER, list(range(1, 32))))
        self.assertEqual(self.read(json.dumps(names, indent=1))[1][:3], [2, 6, 10])
        three = [p + [0.5] for p in self.UPPER]
        self.assertEqual(self.read(json.dumps(three), "--dim", "3")[0], three)
        self.assertEqual(self.read(json.dumps(three), "--dim", "2")[0], self.UPPER)
        self.assertEqual(self.fit(json.dumps([dict(x=x, y=y, sigma=0.1) for x, y in quadratic(9)]))["points"]["sigma"], "column")
        for text, words in [("[[1,2],[3]]", ["point 2 has 1 numbers", "expected 2"]), ("[[1,2],[3,null]]", ["point 2", "y is not a number"]),
                            ("[]", ["no line of points"]), ("[[1,2],", ["line 1", "JSON"]), ("[[1,2,3]]", ["--dim 3", "--dim 2"]),
                            ('[{"x":1}]', ["point 1", "y is missing"]), ('{"x":[1,2],"y":[1]}', ["different lengths"]),
                            ('[{"x":1,"y":2,"sigma":0}]', ["sigma is 0"]), ("[[1,2],\n[1e999,3]]", ["line 2", "JSON"]), ('["a"]', ["point 1"]),
                            ("{}", ["point 1"])]:
            with self.subTest(text):
                self.refuses(text, words)

    def test_geojson(self):
        line = {"type": "LineString", "coordinates": self.UPPER}
        ring = {"type": "Polygon", "coordinates": [self.UPPER + self.UPPER[:1]]}
        feature = lambda g: {"type": "Feature", "properties": {}, "geometry": g}
        for value, wanted in [(line, self.UPPER), (feature(line), self.UPPER), ({"type": "FeatureCollection", "features": [feature(line)]}, self.UPPER),
                              (ring, self.UPPER + self.UPPER[:1]), ({"type": "GeometryCollection", "geometries": [line]}, self.UPPER),
                              ({"type": "FeatureCollection", "features": [feature({"type": "Point", "coordinates": q}) for q in self.UPPER]}, self.UPPER),
                              ({"type": "MultiPoint", "coordinates": [q + [7] for q in self.UPPER]}, self.UPPER)]:
            at, _, form, notes = self.read(json.dumps(value), name="a.geojson")
            self.assertEqual((at, form), (wanted, "GeoJSON"))
            self.assertIn("longitude and latitude", notes[-1])
        two = {"type": "MultiLineString", "coordinates": [self.UPPER, self.LOWER[:7]]}
        self.refuses(json.dumps(two), ["2 lines", "of 31, 7 points", "expected one"])

    def test_gpx(self):
        """Degrees become metres; the distances of the plane are those on the ellipsoid, here to 1e-6 of them."""
        step = 1e-3
        track = "".join(f'<trkpt lat="{48 + step * k}" lon=\'{11 + step * k}\'><ele>{500 + k}</ele></trkpt>\n' for k in range(9))
        text = f'<?xml version="1.0"?>\n<gpx><!-- <trkpt> --><trk><name>a</name><trkseg>\n{track}</trkseg></trk></gpx>'
        at, lines, form, notes = self.read(text)
        self.assertEqual((form, lines[0], lines[8], len(at[0])), ("GPX", 3, 11, 2))
        self.assertIn("metres east and north of 11.0040, 48.0040", notes[0])
        a, e2 = 6378137, 0.00669437999014
        s = math.sin(math.radians(48.004))
        n = a / math.sqrt(1 - e2 * s * s)
        self.assertAlmostEqual((at[8][0] - at[0][0]) / (8 * math.radians(step) * n * math.cos(math.radians(48.004))), 1, 9)
        self.assertAlmostEqual((at[8][1] - at[0][1]) / (8 * math.radians(step) * a * (1 - e2) / (1 - e2 * s * s) ** 1.5), 1, 9)
        self.assertEqual([q[2] for q in self.read(text, "--dim", "3")[0]], list(range(500, 509)))
        joined = text.replace('<trkpt lat="48.004"', '</trkseg><trkseg><trkpt lat="48.004"')
        self.assertIn("2 pieces", self.read(joined)[3][1])
        self.refuses(text.replace("</trk>", "</trk><trk><trkseg>" + track + "</trkseg></trk>"), ["2 tracks", "of 9, 9 points"])
        self.refuses(text.replace('lat="48.0"', ""), ["line 3", "lat"])
        self.refuses("<gpx></gpx>", ["no track"])

    def test_svg(self):
        paths = {"M 0,0 L1 1L2-.5 3,0.25": [[0, 0], [1, 1], [2, -0.5], [3, 0.25]], "m0 0 1 1 1-1.5 1 .75": [[0, 0], [1, 1], [2, -0.5], [3, 0.25]],
                 "M0 0h1v2H4V5z": [[0, 0], [1, 0], [1, 2], [4, 2], [4, 5], [0, 0]], "M0 0c9 9 9 9 1 2A5 5 0 014 5q1 1 2 2": [[0, 0], [1, 2], [4, 5], [6, 7]]}
        for d, wanted in paths.items():
            at, _, form, notes = self.read(f'<svg>\n<path class="d" d="{d}"/></svg>', "--free", "inner")
            self.assertEqual((at, form), (wanted, "SVG"))
            self.assertEqual("3 curved pieces" in " ".join(notes), "A5" in d)
        self.assertEqual(self.read('<svg><polyline points="0,0 1,1 2,0 3,5"/></svg>', "--ends", "exact")[0], [[0, 0], [1, 1], [2, 0], [3, 5]])
        at, _, _, notes = self.read('<svg><g transform="scale(2)"><polygon points="0 0 1 1 2 0 3 5"/></g></svg>', "--ends", "exact")
        closed = '<svg><polygon points="0 0 1 1 2 0 3 5 -0 0"/></svg>'
        self.assertEqual(self.read(closed, "--ends", "exact")[0], [[0, 0], [1, 1], [2, 0], [3, 5], [0, 0]])
        self.assertEqual((at[4], notes[-1]), ([0, 0], "transformations are not applied"))
        for d, words in [("M0 0L1", ["expected a number"]), ("L1 1", ["begin with M"]), ("M0 0L1 1M2 2L3 3", ["2 paths", "of 2, 2"])]:
            self.refuses(f'<svg><path d="{d}"/></svg>', words)
        self.refuses("<svg></svg>", ["no path"])
        self.refuses("<html></html>", ["GPX", "SVG"])

    def dxf(self, entities):
        return "999\na comment\n  0\nSECTION\n  2\nENTITIES\n" + entities + "  0\nENDSEC\n  0\nEOF\n"

    def test_dxf(self):
        light = "0\nLWPOLYLINE\n 90\n31\n 70\n0\n" + "".join(f" 10\n{x}\n 20\n{y}\n" for x, y in self.UPPER)
        heavy = "0\nPOLYLINE\n70\n%d\n10\n0\n20\n0\n" + "".join(f"0\nVERTEX\n10\n{x}\n20\n{y}\n30\n{x * y}\n" for x, y in self.UPPER) + "0\nSEQEND\n"
        single = "".join(f"0\nPOINT\n10\n{x}\n20\n{y}\n" for x, y in self.UPPER)
        for entities in light, heavy % 0, single, light.replace("\n", "\r\n"), "0\nTEXT\n10\n7\n20\n8\n1\nhello\n" + light:
            at, _, form, notes = self.read(self.dxf(entities))
            self.assertEqual((at, form, notes), (self.UPPER, "DXF", []))
        self.assertEqual(self.read(self.dxf(light.replace("70\n0", "70\n1")))[0], self.UPPER + self.UPPER[:1])
        self.assertEqual(self.read(self.dxf(heavy % 8))[0], [[x, y, x * y] for x, y in self.UPPER])
        self.assertIn("1 of the pieces", self.read(self.dxf(light.replace(" 10\n", " 42\n0.5\n 10\n", 2).replace(" 42\n0.5\n", "", 1)))[3][0])
        self.assertEqual(self.read(self.dxf(light).replace("SECTION\n", "SECTION\n999\nof the drawing\n"))[0], self.UPPER)
        self.refuses(self.dxf(light + light), ["2 polylines", "of 31, 31"])
        self.refuses(self.dxf(""), ["no polyline"])
        self.refuses(self.dxf("0\nVERTEX\n10\n1\n20\n2\n0\nSEQEND\n"), ["line 8", "VERTEX stands outside of a POLYLINE"])
        self.refuses(self.dxf(single.replace("POINT", "VERTEX")), ["VERTEX stands outside"])
        self.refuses(self.dxf(light).replace(" 10\n1.0\n", " 10\nnan\n"), ["'nan' is not a number"])
        self.refuses("0\nSECTION\n2\nENTITIES\nzero\nx\n", ["line 5", "'zero' is not the code"])

    @ONCE
    def test_input_without_end(self):
        endless = subprocess.Popen(["yes", "1.25,2.5"], stdout=subprocess.PIPE)
        self.addCleanup(endless.stdout.close)
        r = run("fit", "-", stdin=endless.stdout)
        endless.kill()
        endless.wait()
        self.assertEqual((r.returncode, r.stdout), (2, b""))
        self.assertIn(b"standard input: more than 536870912 bytes, the largest size that is read; divide it", r.stderr)

    def test_measured_files(self):
        """Real files, where they lie: an airfoil with a title and its nose twice, outlines, columns of different scales."""
        folder = ROOT.parent / "shared" / "data"
        folder = folder if folder.is_dir() else ROOT.parent.parent / "shared" / "data"
        if not folder.is_dir():
            self.skipTest(f"{folder} is not there")
        for name, count, form in [("ffa-w3-211.dat", 80, "table"), ("cuba.geojson", 41, "GeoJSON"), ("newfoundland.csv", 32, "table"), ("roszman1.txt", 25, "table")]:
            at, _, is_form, notes = self.read((folder / name).read_bytes(), name=name)
            self.assertEqual((len(at), is_form), (count, form))
            self.assertEqual(notes[:1], ['line 1, "FFA-W3-211", is passed over'] if name.startswith("ffa") else notes[:1])


class Mistakes(Case):
    GOOD = table(quadratic(6))

    def test_rows(self):
        bad = {
            "1,x": ["line 7", "y", "'x' is not a number"], "1": ["line 7", "1 field, expected 2"],
            "1,2,3": ["line 7", "3 fields, expected 2"], "1,nan": ["line 7", "y is nan", "finite"],
            "-inf,1": ["line 7", "x is -inf", "finite"], "1,1e999": ["line 7", "'1e999' is larger"],
            "1,": ["line 7", "1 field"], ",1": ["line 7", "x is missing"], '1,"2': ["line 7", "quote"],
            '1,"2"3': ["line 7", "separator"], "1,2e": ["'2e' is not a number"], "1 2,3": ["'1 2' is not a number"],
            "1,2..3": ["'2..3' is not a number"], "1;2": ["line 7", "1 field"], '1,"1,234,567"': ["'1,234,567' is not"],
        }
        for row, words in bad.items():
            with self.subTest(row):
                self.refuses(self.GOOD + row + "\n", words)
                self.refuses((self.GOOD + row).replace("\n", "\r\n"), words)

    def test_the_column_is_counted_in_characters(self):
        self.refuses('x;y\n1;2\n  "µ4" ; oops\n', ["line 3, column 4: x: 'µ4' is not"])
        self.refuses('x;y\n1;2\n3 ;  µ\n', ["line 3, column 6: y: 'µ' is not"])
        self.refuses("x;y\n1;2\n\n# µ\n 3;inf\n", ["line 5, column 4: y is inf"])

    def test_knots_that_break_the_curve(self):
        path = self.file(self.GOOD)
        for degree, knots in ("2", "0.25,0.5,0.5,0.5"), ("1", "0.5,0.5"):
            self.refuses_usage(path, "--degree", degree, "--knots", knots,
                               words=["--knots: 0.5 stands more than " + degree + " times"])

    def test_decimal_marks_are_not_mixed(self):
        self.refuses("1.5;2\n1;2,5\n", ["line 2", "decimal comma", "line 1 a decimal point"])
        self.refuses("1;2,5\n1.5;2\n", ["line 2", "decimal point", "line 1 a decimal comma"])
        self.refuses("1,234.5;2\n", ["line 1", "'1,234.5' is not a number"])

    def test_columns(self):
        self.refuses("1,2,3\n", ["line 1", "three columns", "--dim 3", "--dim 2"])
        self.refuses("1\n2\n", ["line 1", "1 column"])
        self.refuses("1,2,3,4,5\n", ["line 1", "5 columns"])
        self.refuses("x,x,y\n1,2,3\n", ["line 1", "two columns are called x"])
        self.refuses("x,z,w\n1,2,3\n", ["line 1", "no column is called y"])
        self.refuses("a,b,z\n1,2,3\n", ["line 1", "a column is called z, none x and y"])
        self.refuses("a,b,c\n1,2,3\n", ["line 1", "three columns", "names do not say which", "--dim 3", "--dim 2"])
        self.refuses("1,2.5,3\n2,3.5,4\n", ["line 1", "three columns", "numbers the points", "nr x y"])
        self.refuses("x,y\n1,2\n", ["--dim 3", "z"], "--dim", "3")
        self.refuses("1,2\n", ["--sigma-column 3", "2 columns"], "--sigma-column", "3")
        self.refuses("x,y,s\n1,2,3\n", ["--sigma-column q", "no column"], "--sigma-column", "q")
        self.refuses("x,y\n1,2\n", ["--sigma-column 2", "column of y"], "--sigma-column", "2")
        self.refuses("x,y,s\n1,2,3\n", ["--sigma"], "--sigma", "1")

    def test_sigma_is_positive(self):
        for s in "0", "-1", "1e-400":
            self.refuses(f"x,y,sigma\n1,2,1\n3,4,{s}\n", ["line 3", "sigma", s, "> 0"])

    def test_files(self):
        for text in "", "\n\n", "# nothing\n", "x,y\n":
            self.refuses(text, ["no points"])
        self.refuses("1,2\n".encode("utf-16"), ["UTF-16"])
        self.refuses(b"1,2\n\0\n", ["zero byte"])
        self.refuses_usage("/does/not/exist.csv", words=["/does/not/exist.csv", "No such file"])
        self.refuses_usage("/", words=["is a folder", "expected the file of the points"])
        self.refuses_usage(words=["file of the points"])
        self.refuses_usage("a.csv", "b.csv", words=["one file", "b.csv"])

    def test_points_that_do_not_suffice(self):
        self.refuses("1,2\n", ["too few points"])
        self.refuses(table(quadratic(5)), ["too few points", "5 in the plane give 5 equations", "6 unknowns", "at least 6"],
                     "--degree", "3", "--ends", "exact")
        self.refuses(table(quadratic(5)), ["too few points", "5 in the plane give 7 equations", "10 unknowns", "at least 8"],
                     "--degree", "3")
        self.refuses(table([[1.5, 2.5]] * 20), ["all points are equal"])
        five = [[math.cos(2 * math.pi * k / 5), 2 * math.sin(2 * math.pi * k / 5)] for k in range(5)]
        for rows in five, five + five[:1]:
            self.refuses(table(rows), ["for a closed curve", "5 in the plane, expected at least 7", "an ellipse has 5 unknowns", "--open"])
            self.refuses(table(rows), ["for a closed curve", "5 equations for 8 unknowns, expected at least 8 points"], "--degree", "2")
            said = run("fit", self.file(table(rows)), "--degree", "2").stderr  # --open is named where it fits
            self.assertEqual(b"--open" in said, run("fit", self.file(table(rows)), "--degree", "2", "--open", "--no-verify").returncode == 0)
        self.refuses(table(five[:4]), ["for a closed curve", "4 in the plane, expected at least 7"], "--closed")
        self.refuses(table([row + [row[0] / 3] for row in five[:4]]), ["4 in space, expected at least 5", "an ellipse has 8 unknowns"],
                     "--closed", "--dim", "3")
        self.refuses(table(five[:3]), ["3 in the plane do not determine"], "--unordered", "--degree", "1")

    def test_nothing_free(self):
        self.refuses(self.GOOD, ["nothing is free", "--free"], "--degree", "1", "--ends", "exact")

    def test_distances_need_a_curve(self):
        path = self.file(self.GOOD)
        for degree in "1", "2":
            self.refuses_usage(path, "--free", "none", "--degree", degree, words=["--free none", "--initial"])
        for free in "none,weights", "weights,none", "":
            self.refuses_usage(path, "--free", free, words=["weights, inner and ends, or none", f"'{free}'"])

    def test_options(self):
        path = self.file(self.GOOD)
        for options, words in [
                (("--degree", "0"), ["--degree", "from 1 to 64"]), (("--degree", "two"), ["'two'"]),
                (("--knots", "0.5,0.25"), ["increasing", "0.25"]), (("--knots", "1"), ["between 0 and 1"]),
                (("--knots", "x"), ["'x'"]), (("--knots", "0.5", "--control-points", "4"), ["--control-points"]),
                (("--control-points", "2"), ["at least 3"]), (("--free", "all"), ["weights, inner and ends, or none", "'all'"]),
                (("--free", "weights"), ["--initial", "inner"]), (("--loss", "l1"), ["squares, huber or cauchy"]),
                (("--scale", "2"), ["--loss"]), (("--scale", "-1"), ["> 0"]),
                (("--weights-between", "2:3"), ["LOW < 1 < HIGH"]), (("--weights-between", "2"), ["LOW:HIGH"]),
                (("--starts", "0"), ["--starts"]), (("--tolerance", "0"), ["--tolerance"]),
                (("--max-iterations", "0"), ["--max-iterations"]), (("--dim", "4"), ["from 2 to 3"]),
                (("--sigma", "0"), ["> 0"]), (("--ends", "free"), ["measured, exact or sliding", "'free'"]),
                (("--ends", "exact", "--free", "inner,ends"), ["--ends exact", "--free"]), (("--ends", "sliding", "--free", "inner"), ["--ends sliding"]), (("--frobnicate",), ["frobnicate"]), (("--seed", "-1"), ["--seed"])]:
            with self.subTest(options):
                self.refuses_usage(path, *options, words=words)

    def test_initial_curves(self):
        path = self.file(self.GOOD)
        good = {"kind": "rational-bezier", "points": [[0, 0], [1, 2], [4, 0]], "weights": [1, 1, 1]}
        for change, words in [({"points": [[0], [1], [4]]}, ["1 coordinate"]), ({"weights": [1, -1, 1]}, ["weights[1]"]),
                              ({"kind": "spline"}, ["kind"])]:
            curve = self.file(json.dumps({**good, **change}), "c.json")
            self.refuses_usage(path, "--initial", curve, words=[str(curve), *words])
        self.refuses_usage(path, "--initial", curve, "--degree", "3", words=["--initial", "--degree"])
        self.refuses_usage(path, "--initial", "/none.json", words=["/none.json"])

    def test_files_that_cannot_be_written(self):
        for option in "--svg", "--residuals", "--curve":
            r = run("fit", self.file(self.GOOD), option, "/nonexistent/folder/x")
            self.assertEqual(r.returncode, 2)
            self.assertEqual(r.stdout, b"")
            self.assertIn(b"/nonexistent/folder/x", r.stderr)


class Results(Case):
    @classmethod
    def setUpClass(cls):
        cls.folder_of_class = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder_of_class.cleanup)
        f = cls.files = pathlib.Path(cls.folder_of_class.name)
        r = run("fit", ARCH, "--json", "--residuals", f / "r.csv", "--curve", f / "c.json", "--svg", f / "p.svg")
        assert (r.returncode, r.stderr) == (0, b""), r
        cls.doc = json.loads(r.stdout)
        cls.rows = list(csv.DictReader((f / "r.csv").read_text().splitlines()))

    def test_the_schema(self):
        d = self.doc
        self.assertEqual(d["schema"], "cagd-fit-1")
        self.assertEqual((d["converged"], d["at_minimum"]), (True, True))
        n = len(d["unknowns"])
        for field in "covariance", "correlations":
            self.assertEqual([len(row) for row in d[field]], [n] * n)
        self.assertEqual(d["points"], {"file": str(ARCH), "count": 25, "dimension": 2, "sigma": "column", "format": "table", "notes": ["not used: phi, noise"]})
        self.assertEqual(len(d["free_directions"]), n - d["rank"])
        self.assertEqual(d["statistics"]["degrees_of_freedom"], 25 + 2 - d["rank"])
        self.assertEqual([u["name"] for u in d["unknowns"]], ["P0 x", "P0 y", "w1", "P1 x", "P1 y", "P2 x", "P2 y"])
        self.assertEqual((d["end_points"], d["ends_taken_as_exact"]), ([1, 25], False))
        self.assertEqual((d["verification"]["status"], d["verification"]["strict_minimum"]), ("verified", True))
        self.assertLess(d["verification"]["weight_radius"], d["verification"]["weight_alone"])
        self.assertEqual(self.fit(ARCH, "--no-verify")["verification"], {"status": "not asked"})

    def test_intervals_and_correlations_are_those_of_the_covariance(self):
        d = self.doc
        q = d["statistics"]["quantile"]
        for k, u in enumerate(d["unknowns"]):
            error = math.sqrt(d["covariance"][k][k])
            if u["kind"] == "weight":
                self.assertAlmostEqual(u["standard_error"] / u["value"] / error, 1, 12)
                self.assertAlmostEqual(math.log(u["high"] / u["low"]) / (2 * q * error), 1, 12)
                self.assertEqual(u["value"], d["curve"]["weights"][u["index"]])
            else:
                self.assertAlmostEqual(u["standard_error"] / error, 1, 12)
                self.assertAlmostEqual((u["high"] - u["low"]) / (2 * q * error), 1, 10)
                self.assertEqual(u["value"], d["curve"]["points"][u["index"]][u["coordinate"]])
            self.assertAlmostEqual(d["correlations"][k][k], 1, 12)
        for i, j in itertools.combinations(range(len(d["unknowns"])), 2):
            self.assertAlmostEqual(d["correlations"][i][j] * math.sqrt(d["covariance"][i][i] * d["covariance"][j][j]),
                                   d["covariance"][i][j], 15)

    def test_the_truth_lies_in_the_intervals(self):
        """The data are made so that it does, as it does 95 times in 100."""
        w = self.doc["unknowns"][2]
        self.assertTrue(w["low"] < math.cos(math.radians(50)) < w["high"])
        i = self.doc["invariants"][0]
        self.assertAlmostEqual(i["value"], self.doc["curve"]["weights"][1] ** 2, 12)
        self.assertTrue(i["low"] < math.cos(math.radians(50)) ** 2 < i["high"])
        self.assertEqual(self.doc["conic"]["kind"], "certain")
        self.assertEqual(self.doc["conic"]["type"], "ellipse")

    def test_residuals_are_consistent(self):
        d, rows = self.doc, self.rows
        self.assertEqual(list(rows[0]), ["row", "line", "x", "y", "t", "foot_x", "foot_y", "residual_x", "residual_y",
                                         "distance", "standardised"])
        lines = ARCH.read_text().splitlines()
        chi = 0
        for k, row in enumerate(rows):
            value = {name: float(x) for name, x in row.items()}
            self.assertEqual(value["row"], k + 1)
            x, y, sigma = map(float, lines[int(row["line"]) - 1].split(",")[:3])
            self.assertEqual((value["x"], value["y"]), (x, y))
            self.assertAlmostEqual(value["x"] - value["residual_x"], value["foot_x"], 14)
            self.assertAlmostEqual(abs(value["distance"]), math.hypot(value["residual_x"], value["residual_y"]), 14)
            self.assertAlmostEqual(value["standardised"] * sigma, value["distance"], 14)
            chi += value["standardised"] ** 2
        self.assertAlmostEqual(chi / d["statistics"]["chi_squared"], 1, 10)
        distance = [abs(float(r["distance"])) for r in rows]
        self.assertAlmostEqual(d["distances"]["largest"], max(distance), 15)
        self.assertEqual(d["distances"]["largest_point"], 1 + distance.index(max(distance)))
        self.assertEqual(d["distances"]["largest_line"], int(rows[d["distances"]["largest_point"] - 1]["line"]))
        self.assertAlmostEqual(d["distances"]["rms"], math.sqrt(sum(x * x for x in distance) / len(rows)), 15)

    def test_the_curve_is_read_back(self):
        path = self.files / "c.json"
        self.assertEqual(json.loads(path.read_text()), self.doc["curve"])
        for row in self.rows[3::7]:
            r = run("curve", path, "--json", "--at", float(row["t"]).hex())
            at = json.loads(r.stdout)["values"][0]["rounded"][0]
            self.assertAlmostEqual(at[0], float(row["foot_x"]), 13)
            self.assertAlmostEqual(at[1], float(row["foot_y"]), 13)
        again = self.fit(ARCH, "--initial", path, "--no-verify")
        self.assertAlmostEqual(again["minimiser"]["initial_cost"] / self.doc["minimiser"]["cost"], 1, 10)

    def test_the_cost_of_the_first_curve(self):
        """It is that of all points, also where a sample of them leads to the minimum: half the squared distances from the curve as given."""
        first = self.file(json.dumps({"kind": "rational-bezier", "points": [[0, 0], [2, 1.9], [4, 0]], "weights": [1, 1, 1]}), "first.json")
        for n in 100, 3000:
            points = self.file(table(quadratic(n, 0.75, 0.01)))
            given = self.fit(points, "--initial", first, "--free", "none", "--no-verify")
            led = self.fit(points, "--initial", first, "--free", "weights,inner", "--no-verify")
            cost = n * given["distances"]["rms"] ** 2 / 2
            self.assertGreater(cost, 1.1 * led["minimiser"]["cost"])
            self.assertAlmostEqual(led["minimiser"]["initial_cost"] / cost, 1, 10)

    def test_starts_are_counted_on_a_terminal(self):
        """More of them every second, on one line; told of every one that is asked for."""
        points, starts = self.file(table(quadratic(5000, 0.75, 0.3))), 400
        main, other = pty.openpty()
        p = subprocess.Popen([CAGD, "fit", points, "--degree", "3", "--starts", str(starts), "--no-verify", "--json"],
                             stdout=subprocess.PIPE, stderr=other)
        os.close(other)
        said = b""
        while len(set(re.findall(rb" s, (\d+) of ", said))) < 2:  # the first after two seconds; how long a start takes is the machine's
            said += os.read(main, 1 << 16)
        p.kill()
        p.communicate()
        os.close(main)
        told = re.findall(r"\r\x1b\[Kfitting: (\d+) s, (\d+) of 400 starts", said.decode())
        self.assertEqual(re.sub(r"\r\x1b\[Kfitting: \d+ s, \d+ of 400 starts", "", said.decode()), "")
        self.assertEqual([int(s) for s, _ in told], list(range(2, 2 + len(told))))
        ended = [int(n) for _, n in told]
        self.assertTrue(ended[0] < ended[-1] < starts, ended)
        self.assertEqual(ended, sorted(ended))

    def test_the_same_bytes_every_time(self):
        for options in [[], ["--json"], ["--verbose"], ["--starts", "4", "--json"]]:
            a, b = (run("fit", ARCH, *options, "--residuals", self.folder / n, "--svg", self.folder / (n + ".svg"))
                    for n in "ab")
            self.assertEqual((a.stdout, a.stderr), (b.stdout, b""))
            for end in "", ".svg":
                self.assertEqual((self.folder / ("a" + end)).read_bytes(), (self.folder / ("b" + end)).read_bytes())
        self.assertEqual(len(list(self.folder.iterdir())), 4)  # nothing temporary is left

    def test_the_picture(self):
        root = xml.dom.minidom.parse(str(self.files / "p.svg")).documentElement
        self.assertEqual(root.getAttribute("role"), "img")
        for tag in "title", "desc":
            self.assertTrue(root.getElementsByTagName(tag)[0].firstChild.data.strip())
        self.assertIn("25 measured points in the plane", root.getElementsByTagName("desc")[0].firstChild.data)
        discs = [c for c in root.getElementsByTagName("circle") if c.getAttribute("class") == "m point"]
        self.assertEqual(len(discs), 2 * 25 + 1)  # the points, their distances, and the legend

    def test_the_picture_in_the_readme(self):
        self.assertEqual((self.files / "p.svg").read_bytes(), (ROOT / "figures" / "fit-arch.svg").read_bytes())
        self.assertIn("figures/fit-arch.svg", (ROOT / "README.md").read_text())

    def test_python_in_the_readme(self):
        """The lines of README.md that call cagd fit from Python, as they stand there."""
        lines = re.search(r"^    (import json, subprocess\n(?:    .*\n)+)", (ROOT / "README.md").read_text(), re.M).group(1)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "outline.csv").write_text(table(quadratic(40, 0.75, 0.01)))
            env = dict(os.environ, PATH=os.pathsep.join([str(pathlib.Path(CAGD).parent), os.environ["PATH"]]))
            r = subprocess.run([sys.executable, "-c", lines.replace("\n    ", "\n")], cwd=folder, env=env, capture_output=True, text=True)
        self.assertEqual((r.returncode, r.stderr), (0, ""))
        self.assertRegex(r.stdout, r"^a conic in one segment 0\.0\d+ \[\]\n$")

    def test_the_arch_is_what_it_says(self):
        lines = [line for line in ARCH.read_text().splitlines() if not line.startswith("#")]
        for row in csv.DictReader(lines):
            phi, noise = math.radians(float(row["phi"])), float(row["noise"])
            normal = math.cos(phi) / 6.25, math.sin(phi) / 3.6
            length = math.hypot(*normal)
            self.assertAlmostEqual(float(row["x [m]"]), 6.25 * math.cos(phi) + noise * normal[0] / length, delta=6e-5)
            self.assertAlmostEqual(float(row["y [m]"]), 3.6 * math.sin(phi) + noise * normal[1] / length, delta=6e-5)

    def test_text(self):
        text = run("fit", ARCH).stdout.decode()
        self.assertTrue(all(len(line) <= 100 for line in text.splitlines()), text)
        largest = self.doc["distances"]
        for words in ["25 in the plane", "degree 2", "converged", "w1", "P1 x", "95 % interval", "an ellipse", "verified in intervals: a strict local minimum",
                      f"point {largest['largest_point']} (line {largest['largest_line']})", "7 of 7"]:
            self.assertIn(words, text)

    def arc(self, minor, degrees, noise):
        """60 points of an arc of the ellipse with semi-axes 25 and `minor` about (3, 1)."""
        rng = random.Random(5)
        at = [math.radians(20 + degrees * i / 59) for i in range(60)]
        return table([(3 + 25 * math.cos(a) + rng.gauss(0, noise), 1 + minor * math.sin(a) + rng.gauss(0, noise)) for a in at])

    def test_a_short_arc_of_a_circle_is_told(self):
        for degrees in 60, 90:
            circle = self.fit(self.arc(25, degrees, 0.02), "--no-verify")["circle"]
            for x, truth in (circle["radius"], 25), (circle["centre"][0], 3), (circle["centre"][1], 1):
                self.assertTrue(x["low"] < truth < x["high"] and x["high"] - x["low"] < 0.4, (degrees, circle))
            self.assertAlmostEqual(circle["sweep"], degrees, delta=1)
            self.assertGreater(circle["probability"], 0.05)
        said = " ".join(run("fit", self.file(self.arc(25, 90, 0.02)), "--no-verify").stdout.decode().split())
        self.assertRegex(said, r"Circle radius 2[45]\.\d+ ± 0\.\d+; centre x [23]\.\d+ ± 0\.\d+; centre y [01]\.\d+ ± 0\.\d+, at 95 %; an arc of .* not contradicted")

    def test_other_conics_and_lines_are_no_circles(self):
        for text in self.arc(18, 90, 0.02), self.arc(0, 120, 0.02):
            self.assertIsNone(self.fit(text, "--no-verify")["circle"])
        self.assertIsNone(self.fit(self.arc(25, 90, 0.02), "--no-verify", "--degree", "3")["circle"])
        self.assertIsNone(self.fit(self.arc(25, 90, 0.02), "--no-verify", "--ends", "exact")["circle"])

    def test_an_arc_too_short_for_its_curvature(self):
        """A bend of 0.6 times the noise: a straight line, or a conic without such numbers, never a circle with a finite interval that is wrong."""
        circle = self.fit(self.arc(25, 5, 0.02), "--no-verify")["circle"]
        self.assertTrue(circle is None or circle["radius"]["low"] is None or circle["radius"]["low"] < 25 < circle["radius"]["high"], circle)

    def test_a_loose_tolerance_still_ends_at_orthogonal_feet(self):
        for tolerance in "1e-8", "1e-6", "1e-3":
            text = run("fit", ARCH, "--tolerance", tolerance).stdout.decode()
            self.assertIn("verified in intervals: a strict local minimum", text, tolerance)

    def test_verbose_prints_the_iterations(self):
        text = run("fit", ARCH, "--verbose").stdout.decode()
        table = re.findall(r"^ +(\d+) +([\d.e+-]+) +[\d.e+-]+ +[\d.e+-]+ +(?:[\d.e+-]+|inf)", text, re.M)
        history = self.doc["minimiser"]["history"]
        self.assertEqual([(int(i), float(cost)) for i, cost in table], [(h["iteration"], h["cost"]) for h in history])


class Fits(Case):
    def test_a_name_that_is_no_utf8(self):
        path = self.folder / os.fsdecode(b"b\xff\xc3d.csv")
        path.write_text(table(quadratic(9)))
        d = self.fit(path, "--no-verify")
        self.assertTrue(d["points"]["file"].endswith("/b\ufffd\ufffdd.csv"))

    def test_numbers_keep_their_digits_at_every_size(self):
        """The unit of length changes the coordinates, and nothing else."""
        rows = quadratic(30, 0.75, 0.01)
        for unit in 1e-12, 1, 1e12:
            said = self.text([[unit * x, unit * y] for x, y in rows], "--ends", "exact")
            for line in ["w1 0.739 0.025 0.689 to 0.793", "I1 0.546 0.037 0.475 to 0.629", "an ellipse at 95 %"]:
                self.assertIn(line, said)
            numbers = re.search(r"P1 x (\S+) (\S+) (\S+) to (\S+) ", said).groups()
            for number, wanted in zip(numbers, (1.002, 0.021, 0.958, 1.045)):
                self.assertAlmostEqual(float(number) / unit, wanted, 9)
                self.assertLessEqual(len(number), len("1.002e+12"))
            near = re.search(r"lies within (\S+) of these coordinates and (?:(\S+) of these )?logarithms of weights", said)
            self.assertEqual(near[2] is not None, unit != 1)
            self.assertLess(float(near[1]) / unit, 1e-13)
            self.assertLess(float(near[2] or near[1]), 1e-13)

    def test_numbers_are_no_finer_than_binary64(self):
        """Of exact points standard errors are smaller than the steps of the numbers: no digits behind these, and no other form."""
        circle = [[3 + 2 * math.cos(math.pi * i / 20), 1 + 2 * math.sin(math.pi * i / 20)] for i in range(41)]
        parabola = [[i / 20, i / 20 * (1 - i / 20)] for i in range(21)]
        for rows, name in ((circle, "radius 2.0000000000000000"), (parabola, "P2 x 1.0000000000000000")):
            said = self.text(rows)
            self.assertIn(name + " ", said)
            self.assertNotIn("e+00", said)
            for number in re.findall(r"(?<![\w.])\d+\.\d+(?:e[+-]\d+)?", said):
                self.assertLessEqual(len(re.sub(r"e.*|\.", "", number).lstrip("0")), 17, number)

    def test_far_from_the_origin(self):
        """Points that are exact there too: the same fit, verified, with all digits; and steps of binary64 are said where they are coarse."""
        near = [[round(4096 * x) / 4096, round(4096 * y) / 4096] for x, y in quadratic(60, 0.75, 0.01)]
        wanted = self.fit(table(near), "--ends", "exact")
        for shift in 1e6, 1e12:
            rows = [[x + shift, y - shift] for x, y in near]
            d = self.fit(table(rows), "--ends", "exact")
            v = d["verification"]
            self.assertEqual((v["status"], v["strict_minimum"]), ("verified", True))
            self.assertLessEqual(v["point_radius"], 10 * wanted["verification"]["point_radius"])  # told by decades
            self.assertFalse(d["points_on_curve"] or d["finer_than_points"])
            for u, w in zip(d["unknowns"], wanted["unknowns"], strict=True):
                self.assertAlmostEqual(u["standard_error"] / w["standard_error"], 1, 9)
                if u["kind"] == "point":
                    c = u["coordinate"]
                    self.assertAlmostEqual(u["from_origin"] + (d["origin"][c] - [shift, -shift][c]), w["value"], 11)
                    self.assertEqual(u["value"], d["origin"][c] + u["from_origin"])
            said = self.text(rows, "--ends", "exact", "--svg", self.folder / "p.svg")
            for c, axis in enumerate("xy"):
                printed = re.search(rf"P1 {axis} (\S+) (\S+) (\S+) to (\S+) ", said).groups()
                printed = [decimal.Decimal(x) - decimal.Decimal([shift, -shift][c]) for x in (printed[0], *printed[2:])]
                u = wanted["unknowns"][1 + c]
                for x, y in zip(printed, (u["value"], u["low"], u["high"])):
                    self.assertLess(abs(float(x) - y), 0.00051)
            self.assertIn(">%d<" % shift, self.writing(self.folder / "p.svg"))
            self.assertNotIn("Far from 0", said)
        r = random.Random(5)
        curve = lambda t, w=0.75: [(2 * t * (1 - t) * w + 4 * t * t) / (1 - 2 * t * (1 - t) * (1 - w)), 4 * t * (1 - t) * w / (1 - 2 * t * (1 - t) * (1 - w))]
        rows = [[c + 1e12 + r.gauss(0, 4e-4) for c in curve(i / 2999)] for i in range(3000)]
        # a conic, as asked: the ends, which are not exact, hold a curve away from its neighbours there, and a spline would follow
        self.assertTrue(self.fit(table(rows), "--ends", "exact", "--degree", "2")["finer_than_points"])
        self.assertRegex(self.text(rows, "--ends", "exact", "--degree", "2"), r"Far from 0 .* rounded to steps of 0\.00012, which is more than standard errors")
        rows = [[c + 1e12 for c in curve(i / 59)] for i in range(60)]
        self.assertTrue(self.fit(table(rows))["points_on_curve"])

    @ONCE
    def test_the_degree_is_chosen(self):
        """A noisy polynomial of degree 5 in one segment: no spline of degree 2, 3 or 4 does with so few unknowns.  And a parabola."""
        r = random.Random(12)
        wave = [[x, 3 * x * (x - 0.2) * (x - 0.5) * (x - 0.8) * (x - 1) * 8 + r.gauss(0, 0.0003)] for x in (i / 199 for i in range(200))]
        bow = [[x, x * (1 - x) + r.gauss(0, 0.003)] for x in (i / 100 for i in range(101))]
        for rows, degree, count in (wave, 5, 6), (bow, 2, 3):
            d = self.fit(table(rows), "--degree", "auto")
            self.assertEqual(len(d["curve"]["points"]), count)
            tried = d["choice"]["candidates"]
            self.assertEqual(tried[0]["name"], f"degree {degree} with {count} control points")
            self.assertEqual(sorted(c["name"][7] for c in tried), ["2", "3", "4", "5"])
            self.assertEqual(min(c["score"] for c in tried), tried[0]["score"])
        d = self.fit(table(wave), "--degree", "auto", "--tolerance-distance", "0.002")
        self.assertLess(d["distances"]["largest"], 0.002)
        counts = [len(self.fit(table(wave), "--degree", str(p), "--tolerance-distance", "0.002")["curve"]["points"]) for p in (2, 3, 4, 5)]
        self.assertEqual(len(d["curve"]["points"]), min(counts))
        self.assertIn("the fewest control points", self.text(wave, "--degree", "auto", "--tolerance-distance", "0.002"))
        r = run("fit", ARCH, "--degree", "auto", "--initial", self.folder / "none.json")
        self.assertEqual(r.returncode, 2)

    def test_control_points_beyond_the_frame(self):
        """An arc of nearly a half turn: its middle point stands far above, and an arrow shows where; by itself it is told as an arc of a circle."""
        r = random.Random(11)
        arc = [[math.cos(a) + r.gauss(0, 0.002), math.sin(a) + r.gauss(0, 0.002)] for a in (math.radians(165) * i / 60 for i in range(61))]
        d = self.fit(table(arc), "--degree", "2")
        self.assertGreater(d["curve"]["points"][1][1], 5)
        self.text(arc, "--degree", "2", "--svg", self.folder / "p.svg")
        said = self.writing(self.folder / "p.svg")
        self.assertIn("beyond the frame", said)
        self.assertEqual(re.findall(r">P<><>(\d)<", said), ["0", "1", "2"])
        d = self.fit(table(arc))
        self.assertTrue(d["ellipse"]["circle"])
        self.assertEqual(d["quality"]["problems"], [])
        self.assertLess(abs(d["ellipse"]["radius"]["value"] - 1), 4 * d["ellipse"]["radius"]["standard_error"])
        self.text(arc, "--svg", self.folder / "p.svg")
        self.assertNotIn("beyond the frame", self.writing(self.folder / "p.svg"))

    def writing(self, svg):
        """All text of a picture, pieces apart."""
        texts = xml.dom.minidom.parse(str(svg)).getElementsByTagName("text")
        return "".join(">" + re.sub("<[^>]*>", "<>", t.toxml()) + "<" for t in texts)

    @staticmethod
    def boxes(svg):
        """Of every panel of a picture: boxes of labels, by widths of letters that are usual, and middles of marks and dots."""
        for g in xml.dom.minidom.parse(str(svg)).getElementsByTagName("g"):
            labels, points = [], []
            for t in g.getElementsByTagName("text"):
                kinds = t.getAttribute("class").split()
                if t.parentNode is not g or kinds[:2] not in (["halo", "polygon"], ["halo", "n"]):
                    continue
                x, y = float(t.getAttribute("x")), float(t.getAttribute("y"))
                small = sum(len("".join(c.data for c in u.childNodes)) for u in t.getElementsByTagName("tspan") if " s" in u.getAttribute("class"))
                everything = len(re.sub("<[^>]*>", "", t.toxml()))
                width = 6.5 * (everything - small) + 5 * small
                left = x - {"": 0, "middle": width / 2, "end": width}[t.getAttribute("text-anchor")]
                labels.append((left, y - 10, left + width, y + 3, t.toxml()))
            for c in g.getElementsByTagName("circle"):
                points.append((float(c.getAttribute("cx")), float(c.getAttribute("cy"))))
            for path in g.getElementsByTagName("path"):
                if path.getAttribute("class").startswith("p "):
                    points += [tuple(map(float, q.split())) for q in re.findall(r"M(\S+ \S+?)h0", path.getAttribute("d"))]
            yield labels, points

    @ONCE
    def test_labels_stand_over_nothing(self):
        """Names of control points and the line of the largest distance: over no point, no control point, no other name."""
        r = random.Random(1)
        cloud = [[r.gauss(0, 1), r.gauss(0, 1)] for _ in range(40)]
        wild = [[k / 20, math.sin(k / 7) + r.gauss(0, 0.02) + (k in (30, 31, 70))] for k in range(100)]
        flower = [[(3 + math.cos(5 * a)) * math.cos(a), (3 + math.cos(5 * a)) * math.sin(a)] for a in (2 * math.pi * k / 120 for k in range(120))]
        steep = [[x, 1e4 * y] for x, y in quadratic(25, 0.75, 0.01)]
        names = 0
        for rows, options in ((cloud, ["--unordered", "--degree", "3"]), (wild, ["--loss", "huber", "--degree", "3", "--control-points", "6"]),
                              (flower, ["--degree", "3", "--control-points", "10"]), (steep, []), (helix(80, 0.01), ["--dim", "3", "--degree", "3", "--control-points", "8"]),
                              (quadratic(40, 0.75, 0.01), ["--degree", "3", "--control-points", "7"]),
                              (quadratic(3000, 0.75, 0.02), ["--degree", "3"])):
            svg = self.folder / "p.svg"
            run("fit", self.file(table(rows)), "--no-verify", "--svg", svg, *options)
            for labels, points in self.boxes(svg):
                names += len(labels)
                for k, (left, top, right, bottom, label) in enumerate(labels):
                    with self.subTest(options=options, label=label):
                        over = [p for p in points if left - 1 < p[0] < right + 1 and top - 1 < p[1] < bottom + 1]
                        self.assertEqual(over, [])
                        self.assertEqual([b[4] for b in labels[:k] if left < b[2] and b[0] < right and top < b[3] and b[1] < bottom], [])
        self.assertGreater(names, 40)

    def picture(self, rows, *options):
        svg = self.folder / "p.svg"
        r = run("fit", self.file(table(rows)), "--no-verify", "--svg", svg, *options)
        self.assertEqual(r.stderr, b"")
        root = xml.dom.minidom.parse(str(svg)).documentElement
        return root, *(root.getElementsByTagName(tag)[0].firstChild.data for tag in ("title", "desc"))

    def test_the_title_says_what_was_fitted_and_whether_it_is_good(self):
        r = random.Random(5)
        line = [[k / 40, k / 80 + r.gauss(0, 0.003)] for k in range(40)]
        turn = [2 * math.pi * k / 40 for k in range(40)]
        circle = [[math.cos(a) + r.gauss(0, 0.01), math.sin(a) + r.gauss(0, 0.01)] for a in turn]
        ellipse = [[2 * math.cos(a) + r.gauss(0, 0.01), math.sin(a) + r.gauss(0, 0.01)] for a in turn]
        wave = [[k / 20, math.sin(k / 10) + r.gauss(0, 0.01)] for k in range(100)]
        short = [[math.cos(k / 40) + r.gauss(0, 0.002), math.sin(k / 40) + r.gauss(0, 0.002)] for k in range(60)]
        parabola = [[k / 30, (k / 30) ** 2 + r.gauss(0, 0.003)] for k in range(-30, 31)]
        end = " fitted to measured points"
        for rows, options, title in [(line, ["--degree", "1"], "A straight line" + end), (circle, [], "A circle" + end), (ellipse, [], "An ellipse" + end),
                                     (quadratic(30, 0.75, 0.01), [], "An arc of a conic" + end), (short, [], "An arc of a circle" + end), (parabola, ["--free", "inner,ends"], "An arc of a parabola" + end), (wave, [], "A spline curve" + end),
                                     (wave, ["--degree", "3", "--free", "inner,ends"], "A Bézier curve" + end + ", NOT good: structure in the distances")]:
            with self.subTest(title):
                _, said, description = self.picture(rows, *options)
                self.assertEqual(said, title)
                self.assertEqual("The fit is NOT good: the distances are no noise" in description, "NOT" in title)
                self.assertEqual("rational curve" in description, any(word in title for word in ("conic", "circle", "ellipse")))

    def test_the_label_of_the_largest_distance_belongs_to_its_point(self):
        """No other point is nearer to it, or a line leads to its own; the dots in the legend are those of the picture."""
        for seed in range(12):
            r = random.Random(seed)
            root, _, _ = self.picture([[math.cos(k / 40) + r.gauss(0, 0.01), math.sin(k / 40) + r.gauss(0, 0.01)] for k in range(150)])
            paths = root.getElementsByTagName("path")
            self.assertEqual(len({p.getAttribute("stroke-width") for p in paths if p.getAttribute("class") == "p point"}), 1)
            self.assertEqual(sum(p.getAttribute("class") == "p point" for p in paths), 3)
            own = [c for c in root.getElementsByTagName("circle") if c.getAttribute("class") == "m point"]
            self.assertEqual(len(own), 1)
            at = float(own[0].getAttribute("cx")), float(own[0].getAttribute("cy"))
            (label, points), = [(b[0], points) for b, points in self.boxes(self.folder / "p.svg") if b and "line " in b[0][4]]
            far = lambda p: math.hypot(max(label[0] - p[0], 0, p[0] - label[2]), max(label[1] + 2 - p[1], 0, p[1] - label[3]))
            led = any(p.getAttribute("class") == "h point" for p in paths)
            self.assertTrue(led or min(far(p) for p in points if math.dist(p, at) > 1) > far(at), seed)

    def test_points_of_space_are_seen_from_where_they_are_broad(self):
        turn = [2 * math.pi * k / 60 for k in range(60)]
        ring = [[10 + 0.1 * math.cos(a) ** 2, math.cos(a), math.sin(a)] for a in turn]
        for rows, views in [(ring, "from above and from the side"), ([[z, y, 0.1 * x] for x, y, z in ring], "from above and from the front"),
                            ([[y, x, z] for x, y, z in ring], "from above and from the front"), ([[0.01 * x, y + z * z, z] for x, y, z in ring], "from the side"),
                            ([[math.cos(a), math.sin(a), a / 3] for a in turn], "from above and from the front")]:
            root, _, description = self.picture(rows, "--dim", "3")
            self.assertIn(views, description)
            shown = self.writing(self.folder / "p.svg")
            for view in "from above", "from the front", "from the side":
                self.assertEqual(view in description, ">" + view + "<" in shown, (view, shown))

    def test_without_degrees_of_freedom_nothing_can_be_said(self):
        self.assertIn("Fit nothing can be said of the distances: there are as many unknowns as equations", self.text(quadratic(5, 0.75, 0.01)))
        self.assertIn("Fit nothing was found against it", self.text(quadratic(12, 0.75, 0.01)))

    def test_points_on_the_curve_are_said(self):
        """Then the standard errors are those of the arithmetic."""
        for rows, on_curve in [(quadratic(15), True), (quadratic(15, 0.75, 1e-9), False),
                               ([[1e9 * x, 1e9 * y] for x, y in quadratic(15)], True)]:
            self.assertIs(self.fit(table(rows))["points_on_curve"], on_curve)
            self.assertEqual("not of a measurement" in self.text(rows), on_curve)
        self.assertNotIn("not of a measurement", self.text(quadratic(15), "--sigma", "0.1"))

    def test_a_robust_loss_is_no_chi_squared(self):
        options = ["--loss", "cauchy", "--scale", "0.03"]
        rows = quadratic(60, 0.75, 0.01)
        rows[20][1] += 50
        statistics = self.fit(table(rows), *options)["statistics"]
        self.assertEqual([statistics[k] for k in ("aic", "bic", "reduced_chi_squared")], [None] * 3)
        said = self.text(rows, *options)
        self.assertIn("Loss %.6g, the sum over all points" % statistics["chi_squared"], said)
        for word in "Chi-squared", "AIC":
            self.assertNotIn(word, said)

    def test_ends_of_points_in_no_order(self):
        rows = quadratic(20, 0.75, 0.01)
        self.assertIn("it begins and ends in two of the points", self.text(rows, "--unordered", "--ends", "exact"))
        self.assertIn("points 1 and 20 are measurements of its ends", self.text(rows, "--unordered"))
        mixed = rows[5:] + rows[:5]
        d, wanted = self.fit(table(mixed), "--unordered"), self.fit(table(rows))
        self.assertEqual(sorted(d["end_points"]), [15, 16])
        self.assertAlmostEqual(d["invariants"][0]["value"], wanted["invariants"][0]["value"], 9)
        self.assertAlmostEqual(d["invariants"][0]["standard_error"], wanted["invariants"][0]["standard_error"], 9)

    def test_points_on_a_curve(self):
        for w in 0.3, 1.0, 2.5:
            d = self.fit(table(quadratic(15, w)))
            self.assertAlmostEqual(d["curve"]["weights"][1] / w, 1, 10)
            self.assertAlmostEqual(d["curve"]["points"][1][1], 2, 9)

    def test_distances_from_a_given_curve(self):
        """Nothing is free: feet, distances and their statistics, and nothing of what is estimated."""
        rows = quadratic(40, 0.75, 0.01)
        weights = [2, 1.5, 2]
        curve = self.file(json.dumps({"kind": "rational-bezier", "points": [[0, 0], [1, 2], [4, 0]], "weights": weights}), "c.json")
        svg, out = self.folder / "p.svg", self.folder / "r.csv"
        for sigma in [], ["--sigma", "0.02"]:
            options = ["--initial", curve, "--free", "none", *sigma]
            d = self.fit(table(rows), *options, "--svg", svg, "--residuals", out)
            for field in "unknowns", "free_directions", "covariance", "correlations":
                self.assertEqual(d[field], [])
            self.assertEqual((d["rank"], d["options"]["free"], d["minimiser"]["history"]), (0, [], []))
            self.assertEqual((d["converged"], d["at_minimum"]), (True, True))
            self.assertEqual(d["curve"], {**json.loads(curve.read_text()), "degree": 2})
            self.assertEqual(d["verification"]["status"], "verified")
            corners = rows + [[0, 0], [1, 2], [4, 0]]
            excess, size = d["verification"]["excess"], max(max(x) - min(x) for x in zip(*corners))
            self.assertLessEqual(excess, 2**-44 * size)  # as exact/fit/stationary.h says
            table_of = list(csv.DictReader(out.read_text().splitlines()))
            total = 0
            for row, (x, y) in zip(table_of, rows, strict=True):
                t, distance = float(row["t"]), abs(float(row["distance"]))
                b = [(1 - t) ** 2 * 2, 2 * t * (1 - t) * 1.5, t * t * 2]
                foot = [(b[1] + 4 * b[2]) / sum(b), 2 * b[1] / sum(b)]
                self.assertAlmostEqual(math.dist(foot, (x, y)), distance, 13)
                self.assertAlmostEqual(math.dist(foot, (float(row["foot_x"]), float(row["foot_y"]))), 0, 13)
                for k in range(501):
                    s = k / 500
                    b = [(1 - s) ** 2 * 2, 2 * s * (1 - s) * 1.5, s * s * 2]
                    self.assertGreaterEqual(math.dist([(b[1] + 4 * b[2]) / sum(b), 2 * b[1] / sum(b)], (x, y)), distance - excess)
                total += (distance / (0.02 if sigma else 1)) ** 2
            statistics = d["statistics"]
            self.assertAlmostEqual(statistics["chi_squared"] / total, 1, 12)
            self.assertEqual(statistics["degrees_of_freedom"], 40)
            xml.dom.minidom.parse(str(svg))
            self.assertIn("given curve", svg.read_text())
            said = self.text(rows, *options)
            self.assertIn("nothing is free", said)
            self.assertIn("no point of the curve is nearer to any of the points than its foot", said)
            self.assertIn("w0 = 2, P1 = (1, 2), w1 = 1.5", said)
            self.assertEqual("Deviation standard deviation" in said, not sigma)
            for word in "Standard errors", "95 %", "Rank", "Correlations", "Minimiser", "estimate ":
                self.assertNotIn(word, said)
        d = self.fit(table(rows), "--initial", curve, "--free", "none", "--no-verify", "--loss", "cauchy", "--scale", "0.01")
        self.assertEqual(d["verification"], {"status": "not asked"})
        largest = d["distances"]["largest_point"]
        self.assertEqual(abs(float(table_of[largest - 1]["distance"])), d["distances"]["largest"])

    def test_the_distance_of_one_point(self):
        curve = self.file(json.dumps({"kind": "bspline", "degree": 1, "points": [[0, 0], [1, 2], [2, 0]], "knots": [0, 0, 0.5, 1, 1]}), "c.json")
        for point, distance, t in [([1, 5], 3, 0.5), ([-3, -4], 5, 0), ([1, 0], 2 / math.sqrt(5), None)]:
            d = self.fit(table([point]), "--initial", curve, "--free", "none", "--residuals", self.folder / "r.csv")
            self.assertAlmostEqual(d["distances"]["rms"], distance, 14)
            self.assertEqual(d["verification"]["status"], "verified")
            if t is not None:
                row, = csv.DictReader((self.folder / "r.csv").read_text().splitlines())
                self.assertAlmostEqual(float(row["t"]), t, 15)

    def test_what_cannot_be_verified_is_said(self):
        """The centre of a circle is as near to all of it."""
        curve = self.file(json.dumps({"kind": "rational-bezier", "points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]}), "c.json")
        d = self.fit(table([[0, 0]]), "--initial", curve, "--free", "none")
        self.assertEqual((d["verification"]["status"], d["verification"]["point"]), ("not verified", 1))
        self.assertAlmostEqual(d["distances"]["rms"], 1, 14)
        self.assertIn("not verified: ", self.text([[0, 0]], "--initial", curve, "--free", "none"))

    def test_not_converged(self):
        rows = table(quadratic(40, 0.75, 0.05))
        self.assertIs(self.fit(rows, "--degree", "2", "--max-iterations", "1", code=1)["converged"], False)
        r = run("fit", self.file(rows), "--degree", "2", "--max-iterations", "1")
        self.assertEqual((r.returncode, r.stderr), (1, b""))
        self.assertIn("NOT converged", r.stdout.decode())

    def no_statistics(self, rows, *options):
        """Of a curve that is no minimum nothing is said that is true of minima only."""
        path, svg, residuals = self.file(table(rows)), self.folder / "p.svg", self.folder / "r.csv"
        d = self.fit(path, *options, "--residuals", residuals, "--svg", svg, code=1)
        self.assertEqual((d["converged"], d["at_minimum"]), (False, False))
        for field in "rank", "covariance", "correlations", "free_directions", "conic":
            self.assertIsNone(d[field], field)
        self.assertEqual({k for k, v in d["statistics"].items() if v is not None}, {"chi_squared", "level"})
        for e in d["unknowns"] + d["invariants"]:
            self.assertEqual([e[k] for k in ("standard_error", "low", "high")], [None] * 3)
        with residuals.open() as file:
            kept = list(csv.DictReader(file))
        self.assertTrue(all(row["standardised"] == "" and row["distance"] != "" for row in kept))
        rms = math.sqrt(sum(float(row["distance"]) ** 2 for row in kept) / len(kept))
        self.assertAlmostEqual(rms / d["distances"]["rms"], 1, 12)
        for word in "closest", "±":
            self.assertNotIn(word, svg.read_text())
        r = run("fit", path, *options)
        said = " ".join(r.stdout.decode().split())
        self.assertEqual(r.returncode, 1)
        self.assertIn("No statistics", said)
        for word in ("interval ", "standard error ", "Conic ", "Rank ", "Correlations", "AIC", "as good as",
                     "not determined"):
            self.assertNotIn(word, said)
        return d

    def test_no_statistics_without_a_minimum(self):
        self.no_statistics(quadratic(40, 0.75, 0.05), "--degree", "2", "--max-iterations", "1")
        # A circle but for a gap: degree 2 in one span cannot be that, and the weight runs away.
        gap = [[math.cos(math.pi * i / 20), math.sin(math.pi * i / 20)] for i in range(40)]
        self.assertEqual(self.no_statistics(gap, "--degree", "2", "--open")["minimiser"]["termination"], "failed")

    def test_a_saddle_is_found_out(self):
        """A line between two rows of points: by symmetry stationary, and nearer to one row the cost is lower."""
        rows = [[i / 10, side] for i in range(1, 10) for side in (1, -1)]
        line = self.file(json.dumps({"kind": "rational-bezier", "points": [[0, 0], [0.5, 0], [1, 0]],
                                     "weights": [1, 1, 1]}), "line.json")
        options = ["--initial", line, "--free", "inner", "--unordered"]
        d = self.fit(table(rows), *options, code=1)
        self.assertEqual((d["converged"], d["at_minimum"], d["rank"]), (True, False, None))
        self.assertEqual((d["verification"]["status"], d["verification"]["strict_minimum"]), ("verified", False))
        said = self.text(rows, *options)
        self.assertIn("a stationary point that is NO minimum", said)
        self.assertIn("No statistics the curve was verified to be no minimum", said)
        self.assertNotIn("95 % interval ", said)

    def test_a_closed_circle_is_not_called_a_conic(self):
        """Its first and last point are one: with exact ends the best curve of degree 2 is a line to and fro, with a cusp."""
        circle = [[math.cos(math.pi * i / 20), math.sin(math.pi * i / 20)] for i in range(40)]
        said = self.text(circle + circle[:1], "--degree", "2", "--ends", "exact")
        self.assertNotIn("an ellipse", said)
        self.assertIn("as at a cusp", said)
        self.assertIn("not verified", said)

    def test_given_deviations_standardise_without_a_minimum(self):
        residuals = self.folder / "r.csv"
        self.fit(table(quadratic(40, 0.75, 0.05)), "--sigma", "0.05", "--degree", "2", "--max-iterations", "1", "--residuals", residuals,
                 code=1)
        with residuals.open() as file:
            for row in csv.DictReader(file):
                self.assertAlmostEqual(float(row["standardised"]) * 0.05, float(row["distance"]), 14)

    def test_free_directions_are_said(self):
        rows = table(quadratic(40, 0.75, 0.01))
        d = self.fit(rows, "--ends", "sliding")
        self.assertEqual((d["rank"], len(d["unknowns"]), len(d["free_directions"])), (5, 7, 2))
        for v in d["free_directions"]:
            self.assertAlmostEqual(sum(x * x for x in v), 1, 10)
        text = run("fit", self.file(rows), "--ends", "sliding").stdout.decode()
        self.assertIn("5 of 7", text)
        self.assertIn("not determined", text)

    def text(self, rows, *options):
        """The report, every run of blanks as one."""
        r = run("fit", self.file(table(rows)), *options)
        self.assertEqual(r.stderr, b"")
        return " ".join(r.stdout.decode().split())

    def test_intervals_by_the_profile_of_the_cost(self):
        """Where the cost is not quadratic: at both ends it has grown by the quantile, as a fit with that weight finds."""
        rows = quadratic(14, 0.75, 0.04)
        d = self.fit(table(rows))
        w, = [u for u in d["unknowns"] if u["kind"] == "weight"]
        self.assertEqual((w["interval_by"], d["invariants"][0]["interval_by"], d["unknowns"][0]["interval_by"]), ("profile", "profile", "standard error"))
        q, s2 = d["statistics"]["quantile"], d["statistics"]["scale_squared"]
        for end in "low", "high":
            curve = d["curve"]
            held = self.file(json.dumps({**curve, "weights": [1, w[end], 1]}), "held.json")
            there = self.fit(table(rows), "--initial", held, "--free", "inner,ends", "--no-verify")
            grown = 2 * (there["minimiser"]["cost"] - d["minimiser"]["cost"]) / s2
            self.assertAlmostEqual(math.sqrt(grown) / q, 1, delta=0.01)
            self.assertAlmostEqual(d["invariants"][0][end] / w[end] ** 2, 1, delta=0.02)
        said = self.text(rows)
        self.assertRegex(said, r"w1 (\S+ ){5}\* ")
        self.assertIn("Intervals * by the profile of the cost", said)
        self.assertNotIn("Intervals *", self.text(quadratic(40, 0.75, 0.002)))

    def test_what_is_hardly_determined_has_no_interval(self):
        """Where weights have bounds the profile is not followed."""
        rows = quadratic(14, 0.75, 0.06)
        d = self.fit(table(rows), "--weights-between", "0.01:100")
        none = [u for u in d["unknowns"] if u["interval_by"] == "none"]
        self.assertTrue(none)
        for u in none:
            self.assertEqual([u[k] for k in ("standard_error", "low", "high")], [None] * 3)
        said = self.text(rows, "--weights-between", "0.01:100")
        self.assertIn("hardly determined", said)
        self.assertIn("No intervals of what is hardly determined", said)

    def test_ends_taken_as_exact_are_said(self):
        said = "the first and the last point are taken as exact"
        rows = quadratic(40, 0.75, 0.01)
        self.assertIn(said, self.text(rows, "--ends", "exact"))
        self.assertIn("--ends measured", self.text(rows, "--free", "inner"))
        self.assertTrue(self.fit(table(rows), "--ends", "exact")["ends_taken_as_exact"])
        self.assertEqual(self.fit(table(rows), "--ends", "exact")["curve"], self.fit(table(rows), "--free", "weights,inner")["curve"])
        for options in [], ["--ends", "sliding"], ["--initial", self.start(rows), "--free", "weights,inner"]:
            self.assertNotIn(said, self.text(rows, *options))
            self.assertFalse(self.fit(table(rows), *options)["ends_taken_as_exact"])
        self.assertNotIn(said, self.text([[0, 0], [1, 1], [2, 0]], "--ends", "exact"))

    def test_ends_are_the_points_to_the_last_bit(self):
        """Working coordinates, here about x = 4, are coarser; the check knows that the curve ends in the points."""
        rows = [[x + 0.05, y] for x, y in quadratic(40, 0.75, 0.01)]
        d = self.fit(table(rows), "--ends", "exact")
        self.assertEqual([d["curve"]["points"][0], d["curve"]["points"][2]], [rows[0], rows[-1]])
        self.assertEqual(d["verification"]["status"], "verified")

    def test_feet_near_the_ends_are_verified(self):
        """A point on the normal at the end, which is the same for all weights, or beside it."""
        for beyond in -1e-17, 0, 1e-17, 1e-9:
            rows = quadratic(40, 1, 0.01)
            start = self.file(json.dumps({"kind": "rational-bezier", "points": [[0, 0], [2, 2], [4, 0]],
                                          "weights": [1, 1, 1]}), "parabola.json")
            rows.insert(0, [-0.5 - beyond, 0.5 - beyond])
            d = self.fit(table(rows), "--initial", start, "--free", "weights")
            self.assertEqual(d["verification"]["status"], "verified", (beyond, d["verification"]))

    def test_an_undetermined_weight_is_not_called_given(self):
        rows = [[0, 0], [1, 1], [2, 0]]
        self.assertIn("Conic of a type that the points do not determine", self.text(rows, "--ends", "exact"))
        self.assertEqual(self.fit(table(rows), "--ends", "exact")["conic"]["kind"], "unknown")
        self.assertIn("by its given weights", self.text(quadratic(30, 1, 0.01), "--free", "inner"))

    def test_no_number_is_infinite(self):
        """Weights of a line are as good as undetermined."""
        r = random.Random(4)
        rows = [[i / 9 + r.gauss(0, 0.01), i / 9 + r.gauss(0, 0.01)] for i in range(30)]
        for degree in "2", "3":
            words = self.text(rows, "--degree", degree, "--no-verify").replace("nan", "inf").split()
            self.assertNotIn("inf", [w.strip("-+") for w in words])

    def test_alone_is_said_only_beyond_the_radius(self):
        """Only weights, only points, or both: the part is there where the fields of the JSON say something."""
        rows = quadratic(40, 0.75, 0.01)
        for options, fields in [(["--free", "inner"], ["point"]), (["--initial", self.start(rows), "--free", "weights"], ["weight"]),
                                ([], ["point", "weight"])]:
            v = self.fit(table(rows), *options)["verification"]
            alone, near = min(v[f + "_alone"] for f in fields), max(v[f + "_radius"] for f in fields)
            self.assertGreater(alone, 100 * near)
            self.assertIn("only stationary point within 1e%d" % math.floor(math.log10(alone)), self.text(rows, *options))

    def test_a_cusp_is_said(self):
        def cubic(n, P, noise):
            r = random.Random(7)
            return [[sum(b * p[c] for b, p in zip([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3], P))
                     + r.gauss(0, noise) for c in (0, 1)] for t in (i / (n - 1) for i in range(n))]
        for noise in 0, 0.002:
            rows = cubic(61, [(0, 0), (1, 1), (0, 1), (1, 0)], noise)
            self.assertAlmostEqual(self.fit(table(rows), "--degree", "3")["cusp"], 0.5, 2)
            self.assertIn("as at a cusp", self.text(rows, "--degree", "3"))
        rows = cubic(61, [(0, 0), (1, 1), (0.2, 1), (1, 0)], 1e-4)
        self.assertIsNone(self.fit(table(rows), "--degree", "3")["cusp"])

    def test_bounds(self):
        d = self.fit(table(quadratic(40, 0.3, 0.01)), "--weights-between", "1/2:2")
        w, = [u for u in d["unknowns"] if u["kind"] == "weight"]
        self.assertTrue(w["at_bound"])
        self.assertAlmostEqual(w["value"], 0.5, 12)
        self.assertIsNone(w["standard_error"])
        self.assertIn("on its bound", run("fit", self.file(table(quadratic(40, 0.3, 0.01))), "--weights-between",
                                          "0.5:2").stdout.decode())

    def test_the_cost_grows_from_a_bound(self):
        for w, bound, options in [(0.3, 0.5, []), (3, 2, []), (0.3, 0.5, ["--free", "weights", "--initial"])]:
            rows = quadratic(40, w, 0.01)
            if options:
                options = options + [self.start(rows)]
            d = self.fit(table(rows), "--weights-between", "1/2:2", *options, *([] if options else ["--ends", "exact"]))
            self.assertAlmostEqual(d["curve"]["weights"][1], bound, 12)
            v = d["verification"]
            self.assertEqual((v["status"], v["strict_minimum"], v["leaving_bounds"], v["bound"]),
                             ("verified", True, "grows", None))
            self.assertEqual(v["dimension"], 0 if options else 2)
            said = self.text(rows, "--weights-between", "1/2:2", *options)
            self.assertIn("a strict local minimum within the bounds", said)
            self.assertEqual("with all weights on bounds" in said, bool(options))
            self.assertNotIn("stationary point", said)
        v = self.fit(table(quadratic(40, 0.75, 0.01)), "--weights-between", "1/2:2")["verification"]
        self.assertEqual((v["leaving_bounds"], v["bound"]), (None, None))

    def test_outliers_are_listed_and_marked(self):
        """The scale comes from the median of the distances; what is farther than chance puts it is named everywhere."""
        bad = [8, 21, 22, 51]
        for loss in "huber", "cauchy":
            rows = quadratic(60, 0.75, 0.01, seed=5)
            for k in bad:
                rows[k - 1][1] += 0.6
            svg, out = self.folder / "p.svg", self.folder / "r.csv"
            d = self.fit("# a comment\n" + table(rows), "--loss", loss, "--svg", svg, "--residuals", out)
            o = d["outliers"]
            self.assertEqual((o["points"], o["lines"]), (bad, [k + 1 for k in bad]))
            self.assertAlmostEqual(o["deviation"], 0.01, delta=0.005)
            self.assertAlmostEqual(d["options"]["scale"] / o["deviation"], 1.345 if loss == "huber" else 2.385, delta=0.03)
            self.assertAlmostEqual(60 * math.erfc(o["limit"] / math.sqrt(2)), 0.05, 9)
            table_of = list(csv.DictReader(out.read_text().splitlines()))
            self.assertEqual([k + 1 for k, row in enumerate(table_of) if row["outlier"] == "1"], bad)
            others = [float(row["distance"]) for row in table_of if row["outlier"] == "0"]
            self.assertAlmostEqual(o["rms_of_others"], math.sqrt(sum(x * x for x in others) / len(others)), 12)
            distances = sorted(abs(float(row["distance"])) for row in table_of)
            median = (distances[29] + distances[30]) / 2
            self.assertAlmostEqual(o["deviation"], median / 0.6744897501960817 * math.sqrt(62 / (62 - d["rank"])), 9)
            self.assertIn("outliers", self.writing(svg))
            self.assertEqual(svg.read_text().count('class="x wrong"'), 2 * len(bad) + 1)  # in both windows, and in the legend
            said = self.text(rows, "--loss", loss)
            self.assertIn("Outliers point 8 (line 8), point 21 (line 21), point 22 (line 22), point 51 (line 51); farther than 3.3", said)
            self.assertIn("estimated from the median of the distances", said)
            self.assertLess(abs(d["curve"]["weights"][1] - 0.75), 0.1)
        rows = quadratic(60, 0.75, 0.01, seed=5)
        self.assertIn("Outliers none: no point is farther", self.text(rows, "--loss", "huber"))
        self.assertIsNone(self.fit(table(rows))["outliers"])
        for rows in quadratic(20), helix(40, 0.01)[:]:
            name = ["x", "y", "z"][:len(rows[0])]
            d = self.fit(table(rows, names=name), "--loss", "cauchy", "--degree", "3" if len(name) == 3 else "2")
            self.assertEqual(d["outliers"]["points"], [])

    def test_messages_are_those_of_the_fit(self):
        """Nothing of the minimiser's own words reaches a user, whatever the end is."""
        r = random.Random(3)
        rows = [[x / 40, math.sin(x / 6) + r.gauss(0, 0.02)] for x in range(60)]
        for options in (["--max-iterations", "1"], ["--control-points", "9", "--degree", "3", "--max-iterations", "30"], ["--tolerance", "1e-300"],
                        ["--degree", "4"], ["--weights-between", "0.99:1.01"], []):
            d = json.loads(run("fit", self.file(table(rows)), "--json", "--no-verify", *options).stdout)
            self.assertRegex(d["minimiser"]["message"], r"^[A-Z].*\.$")
            for word in "Solver", "Options", "Function tolerance", "Gradient tolerance", "Parameter tolerance", "Maximum number", "|":
                self.assertNotIn(word, d["minimiser"]["message"])

    @ONCE
    def test_an_outlier_that_holds_an_end(self):
        """The end would follow it, and so it is judged by the curve of the others, which goes on behind its end: the fit is theirs, and it is listed."""
        r = random.Random(5)
        rows = [[x + r.gauss(0, 0.003), 2 * x * (1 - x) + r.gauss(0, 0.003)] for x in (i / 49 for i in range(50))]
        good = [row[:] for row in rows]
        rows[-1] = [1.0, 0.08]
        svg, out = self.folder / "p.svg", self.folder / "r.csv"
        for options in (["--degree", "2"], ["--degree", "3", "--free", "inner,ends"], ["--degree", "3", "--control-points", "6"],
                        ["--degree", "3", "--control-points", "auto"], []):
            options = [*options, "--loss", "huber"]
            with self.subTest(options=options):
                said = self.text(rows, *options)
                d = self.fit(table(rows), *options, "--svg", svg, "--residuals", out)
                without = self.fit(table(rows[:-1]), *options)
                self.assertEqual(d["curve"], without["curve"])
                self.assertEqual((d["outliers"]["points"], d["outliers"]["left_out_at_ends"]), ([50], [0, 1]))
                self.assertEqual(d["outliers"]["ends_judged"], [True, True])
                self.assertEqual(d["verification"]["status"], without["verification"]["status"])
                self.assertEqual((d["points"]["count"], d["end_points"]), (50, [1, 49]))
                self.assertIn("Outliers point 50 (line 50); farther than", said)
                self.assertIn("the first and the last point, which a measured end would follow, are judged by the curve of the others", said)
                row = list(csv.DictReader(out.read_text().splitlines()))[49]
                self.assertEqual(row["outlier"], "1")
                self.assertGreater(abs(float(row["distance"])), 0.03)
                self.assertEqual(svg.read_text().count('class="x wrong"'), 3)
                none = self.fit(table(good), *options)["outliers"]
                self.assertEqual((none["points"], none["left_out_at_ends"]), ([], [0, 0]))
        first = self.fit(table([*reversed(rows)]), "--loss", "huber")  # at the start, and two of them
        self.assertEqual((first["outliers"]["lines"], first["outliers"]["left_out_at_ends"], first["end_points"]), ([1], [1, 0], [2, 50]))
        rows[-2] = [0.98, 0.15]
        two = self.fit(table(rows), "--loss", "cauchy")
        self.assertEqual((two["outliers"]["points"], two["outliers"]["left_out_at_ends"]), ([49, 50], [0, 2]))
        said = self.text(rows, "--loss", "huber", "--unordered")
        self.assertIn("whether one of them is an outlier the distance does not tell, but a fit without it", said)
        self.assertNotIn("measure", self.text(rows, "--loss", "huber", "--ends", "sliding").split("Outliers")[1].split("Fit")[0])

    def test_robust_loss_bounds_outliers(self):
        """An outlier that goes farther away takes the least squares along, and no robust fit."""
        for options, low, high in [((), 0.1, 9), (("--loss", "huber", "--scale", "0.02"), 0, 0.002),
                                   (("--loss", "cauchy", "--scale", "0.02"), 0, 0.002)]:
            weight = []
            for far in 0.6, 1.0:
                rows = quadratic(60, 0.75, 0.01)
                rows[20][1] += far
                d = self.fit(table(rows), *options)
                self.assertEqual(d["distances"]["largest_point"], 21)
                weight.append(d["curve"]["weights"][1])
            self.assertTrue(low <= abs(weight[0] - weight[1]) <= high, (options, weight))

    def test_knots_and_control_points(self):
        rows = table([[x, math.sin(x)] for x in (6 * i / 59 for i in range(60))])
        a = self.fit(rows, "--degree", "3", "--knots", "1/4,0.5,3/4", "--no-verify", "--free", "weights,inner,ends")
        b = self.fit(rows, "--degree", "3", "--control-points", "7", "--no-verify", "--free", "weights,inner,ends")
        self.assertEqual(a["curve"], b["curve"])
        self.assertEqual(a["curve"]["kind"], "nurbs")
        self.assertEqual(a["curve"]["knots"], [0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1])

    def test_a_spline_that_is_to_have_weights_and_has_none_has_no_intervals(self):
        """A cubic of eight points, one of weight 3: with weights between 1/16 and 16 there is no better minimum, and what they would leave of the distances is
        errors, which are 0.01; of the distances themselves a sixth is misfit."""
        r, knots, far = random.Random(7), [0.2, 0.4, 0.6, 0.8], [0] * 4 + [0.2, 0.4, 0.6, 0.8] + [1] * 4
        def basis(i, p, u):
            if p == 0:
                return 1.0 if far[i] <= u < far[i + 1] or (u == 1 and far[i] < 1 == far[i + 1]) else 0.0
            part = lambda a, b, c: (a / b if b else 0) * c
            return (part(u - far[i], far[i + p] - far[i], basis(i, p - 1, u)) +
                    part(far[i + p + 1] - u, far[i + p + 1] - far[i + 1], basis(i + 1, p - 1, u)))
        def point(u):
            share = [basis(j, 3, u) * (3 if j == 4 else 1) for j in range(8)]
            return [sum(s * x for s, x in zip(share, xs)) / sum(share) for xs in ([float(j) for j in range(8)], [1.5 * math.sin(2.1 * j) for j in range(8)])]
        rows = [[x + r.gauss(0, 0.01) for x in point(i / 79)] for i in range(80)]
        options = ["--degree", "3", "--knots", ",".join(map(str, knots))]
        d = self.fit(table(rows), *options, "--no-verify")
        test = d["choice"]["weights_test"]
        self.assertEqual((test["fitted"], d["curve"]["weights"]), (False, [1] * 8))
        self.assertLess(test["probability"], 0.05)
        deviation = d["statistics"]["scale_squared"] ** 0.5
        self.assertTrue(0.008 < deviation < 0.012, deviation)
        self.assertLess(1.1 * deviation, (d["statistics"]["chi_squared"] / d["statistics"]["degrees_of_freedom"]) ** 0.5)
        self.assertEqual({u["interval_by"] for u in d["unknowns"]}, {"not sought"})
        said = self.text(rows, *options)
        self.assertIn("weights would explain something, so that this is not the curve of the points", said)
        self.assertIn("estimated from the distances that weights would leave", said)

    def test_weights_of_several_segments_are_left_out(self):
        """Unless somebody asks for them; and that is said."""
        r = random.Random(2)
        rows = [[x, math.sin(x) + r.gauss(0, 0.01)] for x in (6 * i / 99 for i in range(100))]
        options = ["--degree", "3", "--control-points", "9"]
        d = self.fit(table(rows), *options)
        self.assertEqual((d["options"]["free"], d["curve"]["weights"]), (["inner", "ends"], [1] * 9))
        self.assertIn("Weights are left out: by an F test they explain nothing", self.text(rows, *options))
        self.assertLess(0.05, d["choice"]["weights_test"]["probability"])
        coarse = self.fit(table(rows), "--degree", "3", "--knots", "0.5")  # where one knot is too few weights do explain something
        self.assertEqual((coarse["choice"]["weights_test"]["fitted"], coarse["options"]["free"]), (True, ["weights", "inner", "ends"]))
        self.assertLess(coarse["choice"]["weights_test"]["probability"], 1e-6)
        for options in ["--degree", "3"], ["--degree", "3", "--knots", "0.5", "--free", "weights,inner"], ["--initial", self.start(quadratic(9))]:
            said = run("fit", self.file(table(quadratic(30, 0.75, 0.01))), "--json", "--no-verify", *options).stdout
            self.assertIn("weights", json.loads(said)["options"]["free"])

    # ---- closed curves -------------------------------------------------------------------------------------

    @staticmethod
    def round_points(count, a=1, b=1, sigma=0.0, seed=1, turn=2 * math.pi, turns=0):
        """Of an ellipse about (3, 1), by its angle, with normal errors; without the repeated first point."""
        r = random.Random(seed)
        return [[3 + a * math.cos(turn * i / count + turns) + r.gauss(0, sigma), 1 + b * math.sin(turn * i / count + turns) + r.gauss(0, sigma)]
                for i in range(count)]

    def test_a_whole_circle_is_found(self):
        """With default options, repeated first point or not, in order or not: the circle, to 1e-12."""
        once = self.round_points(40, 2, 2)
        mixed = random.Random(5).sample(once, len(once))
        for rows, options, said in ((once + once[:1], [], "repeated"), (once, [], "around"), (mixed, ["--unordered"], "around"),
                                    (once[::-1], [], "around")):
            with self.subTest(said=said, options=options):
                d = self.fit(table(rows), *options)
                e = d["ellipse"]
                self.assertEqual((d["choice"]["points_are"], d["choice"]["closed"], e["whole"], e["circle"]), (said, True, True, True))
                for got, true in zip(e["centre"] + [e["radius"]], (3, 1, 2)):
                    self.assertAlmostEqual(got["value"], true, 12)
                for row in self.points_of(d["curve"], [f"{k}/64" for k in range(65)]):
                    self.assertAlmostEqual(math.dist(row[1:3], (3, 1)), 2, 12)

    def test_whole_ellipses_and_long_arcs(self):
        """Found as what they are, with intervals that hold the truth, in 3 standard errors."""
        for rows, whole, options in ((self.round_points(90, 2, 1.2, 0.01), True, []),
                                     (self.round_points(90, 2, 1.2, 0.01, turn=5), False, []),
                                     (self.round_points(90, 2, 1.2, 0.001, turn=3.6), False, [])):
            with self.subTest(whole=whole, rows=rows[1]):
                d = self.fit(table(rows), *options)
                e = d["ellipse"]
                self.assertEqual((e["whole"], e["circle"]), (whole, False))
                self.assertLess(e["f_ratio"] > 100, 2)
                for got, true in zip(e["centre"] + [e["major"], e["minor"], e["angle"]], (3, 1, 2, 1.2, 0)):
                    self.assertLess(abs(got["value"] - true), 3 * got["standard_error"])
                    self.assertLess(got["standard_error"], 0.3)
                self.assertTrue(d["converged"])
                self.assertEqual(d["verification"]["status"], "verified")

    @ONCE
    def test_a_circle_and_an_ellipse_are_told_apart_as_often_as_they_should(self):
        """Of 60 circles with noise some three are called an ellipse at 95 %, and hardly more than nine; of ellipses with axes 2 and 1.97 all are."""
        wrong = sum(not self.fit(table(self.round_points(50, 2, 2, 0.01, seed)), "--no-verify")["ellipse"]["circle"] for seed in range(60))
        self.assertLessEqual(wrong, 9)
        right = sum(not self.fit(table(self.round_points(50, 2, 1.97, 0.004, seed)), "--no-verify")["ellipse"]["circle"] for seed in range(10))
        self.assertEqual(right, 10)

    @staticmethod
    def flower(count, sigma, seed=3):
        r = random.Random(seed)
        return [[(1 + 0.2 * math.sin(3 * a)) * math.cos(a) + r.gauss(0, sigma), (1 + 0.2 * math.sin(3 * a)) * math.sin(a) + r.gauss(0, sigma)]
                for a in (2 * math.pi * i / count + 0.4 for i in range(count))]

    def test_a_closed_section_is_a_periodic_spline(self):
        """Without a kink: points and derivatives agree at the seam, and the minimum is verified; in order or not."""
        rows = self.flower(200, 0.01)
        for options in [], ["--unordered"], ["--control-points", "12"], ["--degree", "2", "--control-points", "14"], ["--degree", "5"]:
            with self.subTest(options=options):
                given = random.Random(2).sample(rows, len(rows)) if "--unordered" in options else rows
                d = self.fit(table(given), *options)
                c = d["curve"]
                p = c["degree"]
                self.assertEqual((d["choice"]["points_are"], d["choice"]["closed"], d["verification"]["status"]), ("around", True, "verified"))
                self.assertEqual(c["points"][:p], c["points"][-p:])
                lengths = [b - a for a, b in zip(c["knots"], c["knots"][1:])]
                period = len(c["points"]) - p
                for a, b in zip(lengths, lengths[period:]):
                    self.assertAlmostEqual(a, b, 13)
                ends = self.points_of(d["curve"], ["0", "1"], "--derivatives", str(p - 1))
                for a, b in zip(ends[0][1 : 1 + 2 * p], ends[1][1 : 1 + 2 * p]):
                    self.assertLess(abs(a - b), 1e-10 * max(map(abs, ends[0])))
                self.assertAlmostEqual(d["distances"]["rms"], 0.01, delta=0.003)
                self.assertTrue(d["quality"]["good"], d["quality"])
        self.assertIn("with continuous curvature at the seam", self.text(rows))
        self.assertIs(self.fit(table(rows), "--open")["choice"]["closed"], False)

    def test_a_corner_at_the_beginning_is_kept(self):
        """The sharp trailing edge of an airfoil: one point twice, and no closed curve unless it is asked for."""
        def naca(x):
            return 0.6 * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
        xs = [(1 - math.cos(math.pi * i / 30)) / 2 for i in range(31)]
        rows = [[x, naca(x)] for x in xs[::-1]] + [[x, -naca(x)] for x in xs[1:]]
        rows[0][1] = rows[-1][1] = 0.0
        d = self.fit(table(rows), "--no-verify")
        self.assertEqual((d["choice"]["points_are"], d["choice"]["closed"], d["points"]["count"]), ("corner", False, 61))
        self.assertLess(d["distances"]["rms"], 1e-4)
        d = self.fit(table(rows), "--closed", "--no-verify")
        self.assertEqual((d["choice"]["closed"], d["points"]["count"]), (True, 60))

    def test_what_is_open_stays_open(self):
        for rows in (quadratic(40, 0.75, 0.01), self.round_points(40, turn=5.5), [[x, math.sin(x)] for x in range(20)],
                     [[math.cos(a) * a, math.sin(a) * a] for a in (i / 5 for i in range(5, 60))]):
            self.assertEqual(self.fit(table(rows), "--no-verify")["choice"]["points_are"], "open")

    # ---- how many control points, and smoothing ---------------------------------------------------------------

    def test_control_points_are_chosen(self):
        """As many as the points ask for; a conic where that is enough, a spline where it is not."""
        r = random.Random(4)
        rows = [[x, math.sin(x) + r.gauss(0, 0.01)] for x in (6 * i / 199 for i in range(200))]
        d = self.fit(table(rows))
        self.assertTrue(d["choice"]["control_points_chosen"])
        self.assertTrue(6 <= len(d["curve"]["points"]) <= 10, len(d["curve"]["points"]))
        self.assertEqual(d["choice"]["candidates"][0]["name"], f"a cubic spline with {len(d['curve']['points'])} control points")
        self.assertEqual(min(c["score"] for c in d["choice"]["candidates"] if c["score"] is not None), d["choice"]["candidates"][0]["score"])
        self.assertTrue(d["quality"]["good"])
        self.assertEqual([c["name"] for c in self.fit(table(quadratic(60, 0.75, 0.01)))["choice"]["candidates"]], ["a conic in one segment"])
        conic = self.fit(table(rows), "--degree", "2", code=None)
        self.assertFalse(conic["quality"]["good"])
        self.assertIn("the distances are no noise", " ".join(conic["quality"]["problems"]))

    def scattered(self, truth, count, sigma, seed):
        r = random.Random(seed)
        return [[float(f"{x + r.gauss(0, sigma):.9g}") for x in truth(i / (count - 1))] for i in range(count)]

    def test_good_comes_before_a_low_score(self):
        """What goes to and fro between the points is nearer to them, and is left where something good was tried; not for a line through a wave."""
        line = self.fit(table(self.scattered(lambda u: (3 * u, u), 60, 0.1, 4000072)))
        tried = line["choice"]["candidates"]
        self.assertEqual((tried[0]["name"], [c["good"] for c in tried], line["quality"]["good"]), ("a straight line", [True, False, False, False], True))
        self.assertLess(min(c["score"] for c in tried[1:] if c["score"] is not None), tried[0]["score"])
        wave = self.fit(table(self.scattered(lambda u: (math.pi * u, math.sin(2 * math.pi * u)), 60, 0.2, 7000081)))
        tried = wave["choice"]["candidates"]
        self.assertIn("a cubic spline", tried[0]["name"])
        self.assertFalse(any(c["good"] for c in tried), tried)
        self.assertGreater(min(c["score"] for c in tried[1:] if c["score"] is not None), tried[0]["score"] + 10)

    @ONCE
    def test_an_arc_that_scatters(self):
        """A third of a circle; without means 44 control points after a minute, and a flat ellipse about the points where the first one is no circle."""
        for count, sigma, seed in (501, 0.1, 3000510), (501, 0.1, 4000513), (2001, 0.1, 1002004):
            with self.subTest(count=count, seed=seed):
                d = self.fit(table(self.scattered(lambda u: (math.cos(2 * math.pi / 3 * u), math.sin(2 * math.pi / 3 * u)), count, sigma, seed)), "--no-verify")
                e = d["ellipse"]
                self.assertEqual((d["quality"]["good"], e["whole"]), (True, False))
                self.assertLess(abs(e["radius"]["value"] - 1), 4 * e["radius"]["standard_error"])
                self.assertLess(e["radius"]["standard_error"], 0.05)
                self.assertEqual((e["radius"]["low"], e["radius"]["high"]), (None, None))  # they covered 90 to 92 %

    def test_a_line_that_scatters_is_no_circle(self):
        """Not one with a radius of 10^6, which the points do not determine."""
        d = self.fit(table(self.scattered(lambda u: (3 * u, u), 501, 0.1, 4000513)), "--no-verify")
        self.assertEqual((d["choice"]["candidates"][0]["name"], d["ellipse"], d["quality"]["good"]), ("a straight line", None, True))

    def test_bias_of_a_circle(self):
        """Errors along a circle of radius R put points farther out by s^2/(2 R): the interval of the radius lies about what is left."""
        rows = self.scattered(lambda u: (math.cos(2 * math.pi * 1999 / 2000 * u), math.sin(2 * math.pi * 1999 / 2000 * u)), 2000, 0.1, 5)
        d = self.fit(table(rows), "--no-verify")
        r, s2 = d["ellipse"]["radius"], d["statistics"]["scale_squared"]
        self.assertAlmostEqual(r["value"] - (r["low"] + r["high"]) / 2, s2 / (2 * r["value"]), delta=1e-12)  # but for rounding: of a whole circle it is that
        self.assertTrue(r["low"] < 1 < r["high"], r)

    def test_the_other_direction_gives_the_same_ellipse(self):
        """Of a whole one and of an arc the numbers, their errors and intervals do not know in which order the points were measured."""
        for turn, sigma, seed in ((1999 / 2000, 0.03, 8), (0.6, 0.01, 9)):
            rows = self.scattered(lambda u: (3 * math.cos(2 * math.pi * turn * u), math.sin(2 * math.pi * turn * u)), 400, sigma, seed)
            one, other = (self.fit(table(list(r)), "--no-verify")["ellipse"] for r in (rows, reversed(rows)))
            for name in ("major", "minor", "angle", "radius"):
                for key in ("value", "standard_error", "low", "high"):
                    self.assertIsNotNone(one[name][key], (name, key))
                    self.assertAlmostEqual(one[name][key], other[name][key], delta=1e-3 * one[name]["standard_error"], msg=(name, key))  # where the minimiser stops

    def test_a_scattered_curve_is_smoothed_by_means(self):
        """All points together would be come nearer to by a curve that goes to and fro between them."""
        wave = self.scattered(lambda u: (math.pi * u, math.sin(2 * math.pi * u)), 501, 0.1, 1000504)
        d = self.fit(table(wave), "--smooth", "auto", "--no-verify")
        self.assertLess(d["choice"]["smoothing"]["effective_unknowns"], 20)
        self.assertLess(d["length_ratio"], 1.1)
        self.assertTrue(0.09 < d["distances"]["rms"] < 0.105, d["distances"]["rms"])

    def test_a_scattered_section_is_closed(self):
        """Of means of few neighbours no knots are taken out that a closed curve has at least."""
        def section(u):
            x = (2 * u - 1) ** 2
            y = 0.9 * (0.2969 * math.sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x**3 - 0.1036 * x**4)
            return 4 * x, 4 * math.copysign(y, 1 - 2 * u)
        d = self.fit(table(self.scattered(section, 120, 0.05, 1000123)))
        self.assertEqual((d["choice"]["closed"], d["quality"]["good"]), (True, True))
        self.assertIn(len(d["curve"]["points"]) - 3, (4, 5))

    @ONCE
    def test_a_tolerance_is_met(self):
        """By the fewest control points that are found; one fewer over even knots does not meet it."""
        rows = [[x, math.sin(x)] for x in (6 * i / 99 for i in range(100))]
        counts = []
        for within in "0.1", "0.01", "1e-3", "1e-4":
            d = self.fit(table(rows), "--tolerance-distance", within, "--no-verify")
            self.assertIs(d["choice"]["tolerance_met"], True)
            self.assertLessEqual(d["distances"]["largest"], float(within))
            n = len(d["curve"]["points"])
            counts.append(n)
            if n > 4:
                fewer = self.fit(table(rows), "--degree", "3", "--control-points", str(n - 1), "--free", "inner,ends", "--no-verify")
                self.assertGreater(fewer["distances"]["largest"], float(within))
        self.assertEqual(counts, sorted(counts))
        self.assertLess(counts[-1], 16)

    @ONCE
    def test_smoothing(self):
        """By cross-validation near the truth with far too many control points; a heavy weight leaves a line, a light one nothing."""
        r = random.Random(4)
        rows = [[x, math.sin(x) + r.gauss(0, 0.05)] for x in (6 * i / 199 for i in range(200))]
        d = self.fit(table(rows), "--control-points", "40", "--degree", "3", "--smooth", "auto")
        s = d["choice"]["smoothing"]
        self.assertEqual((s["by"], d["verification"]["status"]), ("cross-validation", "verified"))
        self.assertTrue(8 < s["effective_unknowns"] < 30, s)
        worst = max(min(math.dist(row[1:3], (k / 100, math.sin(k / 100))) for k in range(-50, 650))
                    for row in self.points_of(d["curve"], [f"{k}/50" for k in range(51)]))
        self.assertLess(worst, 0.06)
        stiff = self.fit(table(rows), "--control-points", "40", "--degree", "3", "--smooth", "100", "--no-verify", code=None)
        self.assertLess(stiff["choice"]["smoothing"]["roughness"], s["roughness"])
        self.assertGreater(stiff["distances"]["rms"], 3 * d["distances"]["rms"])
        self.assertIn("how far smoothing moves it is not in them", self.text(rows, "--smooth", "auto"))

    def test_feet_in_order(self):
        """A track with stops, whose errors are as large as its points are apart: with --monotone no foot falls back, and a curve with more
        control points than the points determine is no longer wild; where no foot does there is nothing to share."""
        r = random.Random(5)
        track, x = [], 0
        for i in range(40):
            x += 0.15 if 15 < i < 25 else 1
            track.append([x + r.gauss(0, 0.6), 4 * math.sin(x / 6) + r.gauss(0, 0.6)])
        options = ["--degree", "3", "--control-points", "8", "--free", "inner,ends"]
        ratio = {}
        for more in [], ["--monotone"]:
            table_of = os.path.join(self.folder, "residuals.csv")
            d = json.loads(run("fit", self.file(table(track)), "--json", "--residuals", table_of, *options, *more).stdout)
            with open(table_of) as file:
                feet = [float(row["t"]) for row in csv.DictReader(file)]
            falls = sum(b < a for a, b in zip(feet, feet[1:]))
            self.assertEqual(falls, d["distances"]["feet_out_of_order"])
            self.assertEqual((falls == 0, d["distances"]["feet_shared"] > 0), (bool(more), bool(more)))
            ratio[bool(more)] = d["length_ratio"]
        self.assertEqual(sum(a == b for a, b in zip(feet, feet[1:])), d["distances"]["feet_shared"])
        self.assertGreater(ratio[False], 2 * ratio[True])
        said = self.text(track, "--monotone")
        for words in ("points share the foot of the one before, which theirs would fall behind", "the verification takes every foot by itself",
                      "which feet are shared was decided by these points"):
            self.assertIn(words, said)
        self.assertIn("every foot lies behind the one before by itself", self.text(quadratic(20, 0.75, 0.01), "--monotone"))
        self.assertEqual(self.fit(table(track), "--monotone", "--smooth", "auto", code=None)["quality"]["problems"], [])

    def test_points_without_order_and_feet_in_order(self):
        """Points all over the plane: feet are shared until all of them are one, which has no curve.  Once refused as out of the range of numbers."""
        for seed in range(3):
            r = random.Random(seed)
            cloud = [[round(r.gauss(0, 1), 3) for _ in "xy"] for _ in range(20)]
            options = ["--monotone", "--closed", "--degree", "3", "--control-points", "4", "--no-verify"]
            self.assertTrue(self.fit(table(cloud), *options, code=None)["quality"]["problems"])

    @ONCE
    def test_many_control_points_converge(self):
        """Splines with more control points than the points determine come to a minimum by default, and how is said."""
        r = random.Random(8)
        rows = [[x, math.sin(6 * x) + r.gauss(0, 0.01)] for x in (i / 500 for i in range(501))]
        for count in 7, 8, 9, 10, 12, 25:
            d = self.fit(table(rows), "--degree", "3", "--control-points", str(count), "--no-verify")
            self.assertTrue(d["converged"], count)
            self.assertEqual(len(d["curve"]["points"]), count)
            self.assertLess(d["distances"]["rms"], 0.0101)

    def test_what_does_not_go_together(self):
        path = self.file(table(quadratic(20)))
        for options, words in ((["--smooth", "auto", "--free", "weights,inner,ends"], "--smooth leaves weights out"),
                               (["--tolerance-distance", "1", "--control-points", "5"], "--tolerance-distance chooses the control points"),
                               (["--closed", "--ends", "exact"], "a closed curve has no ends"), (["--smooth", "1", "--degree", "1"], "a degree of 2 or more"),
                               (["--monotone", "--unordered"], "--monotone is for points in order"), (["--monotone", "--loss", "huber"], "--monotone is for points in order"),
                               (["--smooth", "-1"], "--smooth takes a number > 0"), (["--closed", "--initial", path], "do not go with --initial")):
            with self.subTest(options=options):
                said = run("fit", path, *options)
                self.assertEqual((said.returncode, said.stdout), (2, b""))
                self.assertIn(words, said.stderr.decode())

    def test_excursions_are_said(self):
        """A curve much longer than the polygon of its points goes where they do not, though it may be a minimum."""
        r = random.Random(2)
        walk, x, y = [], 0, 0
        for a in (r.uniform(0, 6.28) for _ in range(16)):
            x, y = x + math.cos(a) + 0.3, y + math.sin(a)
            walk.append([x, y])
        smooth = [[x, math.sin(x)] for x in (6 * i / 29 for i in range(30))]
        for rows, points, wild in (smooth, "7", False), (walk, "9", True):
            options = ["--degree", "3", "--control-points", points, "--free", "inner,ends", "--open", "--no-verify"]
            path = self.file(table(rows))
            ratio = json.loads(run("fit", path, "--json", *options).stdout)["length_ratio"]
            said = " ".join(run("fit", path, *options).stdout.decode().split())
            self.assertEqual(ratio > 1.26, wild, ratio)
            self.assertEqual("NOT good" in said and "times as long as the polygon" in said, wild)
            cured = json.loads(run("fit", path, "--json", *options[:4], "--open").stdout)  # by default: smoothed
            self.assertEqual((cured["choice"]["smoothing"] is not None, cured["length_ratio"] < 1.26), (wild, True))
        self.assertIsNone(self.fit(table(quadratic(20, 0.75, 0.01)), "--unordered")["length_ratio"])
        d = self.fit(table(quadratic(9)))
        chords = sum(math.dist(a, b) for a, b in zip(quadratic(9), quadratic(9)[1:]))
        fine = sum(math.dist(a, b) for a, b in zip(quadratic(999), quadratic(999)[1:]))
        self.assertAlmostEqual(d["length_ratio"], fine / chords, 4)

    def test_unordered(self):
        rows = quadratic(40, 0.75, 0.01)
        mixed = rows[:]
        random.Random(3).shuffle(mixed)
        d = self.fit(table(mixed), "--unordered", "--initial", self.start(rows))
        self.assertAlmostEqual(d["curve"]["weights"][1],
                               self.fit(table(rows), "--initial", self.start(rows))["curve"]["weights"][1], 8)

    def test_a_straight_line_unordered(self):
        r = random.Random(8)
        rows = [[k, 2 * k + r.gauss(0, 0.3)] for k in range(12)]
        mixed = rows[5:] + rows[:5]
        for options in [], ["--degree", "1"]:
            d, wanted = self.fit(table(mixed), "--unordered", *options), self.fit(table(rows), *options)
            self.assertEqual((wanted["curve"]["degree"], d["curve"]["degree"]), (1, 1))
            self.assertAlmostEqual(d["statistics"]["chi_squared"], wanted["statistics"]["chi_squared"], 12)
        self.assertIn("points 7 and 8 are measurements of its ends", self.text(mixed, "--unordered"))
        self.fit(table(quadratic(8)[:5]), "--unordered")

    def start(self, rows):
        return self.file(json.dumps({"kind": "rational-bezier", "points": [rows[0], [1, 2], rows[-1]],
                                     "weights": [1, 1, 1]}), "start.json")

    def test_points_far_off_are_named(self):
        """Squares follow them: the curve is poor, and the cure is the robust loss, which is tried here."""
        r = random.Random(11)
        rows = [[100 * t, 120 * t * (1 - t) + r.gauss(0, 0.05) + (15 if k in (20, 77, 110) else 0)] for k, t in ((k, k / 149) for k in range(150))]
        text = self.text(rows, "--no-verify")
        self.assertRegex(text, r"Far off +point 21 \(line 21\), point 78 \(line 78\), point 111 \(line 111\): farther")
        self.assertIn("(not so with --loss huber)", text)
        self.assertIn("Tried --loss huber: nothing is found against that fit", text)
        self.assertEqual(self.fit(table(rows), "--no-verify")["quality"]["far_off"], 3)
        cured = self.fit(table(rows), "--no-verify", "--loss", "huber")
        self.assertEqual((cured["quality"]["good"], cured["quality"]["far_off"]), (True, 0))
        plain = [[x, y - (15 if k in (20, 77, 110) else 0)] for k, (x, y) in enumerate(rows)]
        self.assertNotIn("Far off", self.text(plain, "--no-verify"))
        corner = [[k / 50, abs(k / 50 - 1) + r.gauss(0, 1e-4)] for k in range(101)]  # what a curve misses has neighbours
        self.assertNotIn("Far off", self.text(corner, "--no-verify", "--control-points", "9"))

    @ONCE
    def test_points_far_off_on_a_spline(self):
        """A robust loss alone asks for a conic; the one with a spline is tried, too.  Neighbours that jump together and back are named."""
        r = random.Random(9)
        rows = [[k / 6, math.sin(k / 6) + r.gauss(0, 0.01) + (0.5 if k == 30 else 0)] for k in range(60)]
        text = self.text(rows, "--no-verify")
        self.assertRegex(text, r"Far off +point 31 \(line 31\): farther")
        self.assertIn("(not so with --loss huber --degree 3 --control-points auto)", text)
        cured = self.fit(table(rows), "--no-verify", "--loss", "huber", "--degree", "3", "--control-points", "auto")
        self.assertEqual((cured["quality"]["good"], cured["outliers"]["points"]), (True, [31]))
        arc = [[100 * t, 120 * t * (1 - t) + r.gauss(0, 0.05) + (2 if k in (60, 61, 62) else 0)] for k, t in ((k, k / 149) for k in range(150))]
        self.assertRegex(self.text(arc, "--no-verify"), r"Far off +point 61 \(line 61\), point 62 \(line 62\), point 63 \(line 63\): farther")

    @ONCE
    def test_what_cures_a_fit_was_tried(self):
        """Every option that is named does what is said of it when it is put behind the others; what has not cured is not said to cure."""
        r = random.Random(5)
        track, x = [], 0
        for i in range(40):
            x += 0.15 if 15 < i < 25 else 1
            track.append([x + r.gauss(0, 0.6), 4 * math.sin(x / 6) + r.gauss(0, 0.6)])
        back = [[u + r.gauss(0, 0.05), math.sin(5 * u)] for u in (k / 60 for k in range(61))]
        wave = [[k, 2 * math.sin(1.1 * k)] for k in range(9)]
        spiral = [[u * math.cos(9 * u), u * math.sin(9 * u)] for u in (k / 60 + 0.2 for k in range(61))]
        named = set()
        for rows, options, cured in ((track, ["--degree", "3", "--control-points", "8", "--free", "inner,ends"], True),
                                     (track, ["--control-points", "12", "--degree", "3", "--free", "weights,inner,ends"], True),
                                     (back, ["--degree", "4"], True), (wave, [], True), (spiral, ["--degree", "2"], True),
                                     (spiral, ["--degree", "3", "--control-points", "9", "--max-iterations", "2"], None),
                                     (wave, ["--smooth", "100"], None)):
            path = self.file(table(rows))
            d = json.loads(run("fit", path, "--json", "--no-verify", *options).stdout)
            tried, said = d["quality"]["tried"], " ".join(d["quality"]["problems"])
            self.assertTrue(tried, options)
            helped = [t["options"] for t in tried if t["converged"] and not t["problems"]]
            if cured is not None:
                self.assertEqual(bool(helped), cured, tried)
            for cure in re.findall(r"not so with ([^)]*)\)", said):
                self.assertIn(cure, [t["options"] for t in tried if t["converged"]])
            for t in tried:
                with self.subTest(options=options, tried=t):
                    again = json.loads(run("fit", path, "--json", "--no-verify", *options, *t["options"].split()).stdout)
                    self.assertEqual(again["converged"], t["converged"])
                    self.assertAlmostEqual(again["distances"]["rms"], t["rms"], delta=1e-9)
                    if t["converged"] and "--unordered" not in t["options"]:
                        self.assertEqual(len(again["quality"]["problems"]), len(t["problems"]))
                    named.add(re.sub(r" [\d.][\d.e:-]*(?= |$)", "", t["options"]))
            text = " ".join(run("fit", path, "--no-verify", *options).stdout.decode().split())
            self.assertEqual("none of these helps" in text, not helped)
        self.assertTrue({"--unordered", "--degree --smooth auto", "--max-iterations", "--degree --control-points"} <= named, named)
        self.assertEqual(self.fit(table(quadratic(20, 0.75, 0.01)))["quality"]["tried"], [])  # of a good fit nothing
        many = [[u + r.gauss(0, 0.003), math.sin(9 * u) + r.gauss(0, 0.003)] for u in (k / 2100 for k in range(2101))]
        self.assertIn("Tried nothing else, which takes long with more than 2000 points", self.text(many, "--no-verify", "--degree", "2"))

    def test_too_few_points_and_what_would_do(self):
        """Exact ends need no more points only where the fit with them, which is tried, comes to a minimum."""
        four = table(quadratic(4))
        self.refuses(four, ["too few points", "; --ends exact, which takes the first and the last one for the ends, fits"], "--degree", "2")
        self.assertTrue(self.fit(four, "--degree", "2", "--ends", "exact", "--no-verify")["converged"])
        said = run("fit", self.file(table(quadratic(5))), "--degree", "3")
        self.assertNotIn(b"--ends exact", said.stderr)  # which wants 6 points

    def test_a_part_that_is_passed_by(self):
        """A bump of two and a half deviations over 40 of 2001 points: pairs of neighbours say nothing, their mean does.  By default knots are put there."""
        for bump in 0.0075, 0:
            r = random.Random(0)
            rows = [[u + r.gauss(0, 0.003), u * (1 - u) + bump * (0.6 < u < 0.62) + r.gauss(0, 0.003)] for u in (k / 2000 for k in range(2001))]
            q = self.fit(table(rows), "--degree", "2", "--no-verify")["quality"]
            self.assertGreater(q["probability"], 0.05)
            self.assertEqual(q["good"], bump == 0)
            self.assertEqual(q["part"]["probability"] < 1e-9, bump > 0)
            if bump > 0:
                self.assertTrue(0.59 < q["part"]["from"] < q["part"]["to"] < 0.63, q["part"])
                self.assertIn("the curve passes 32 points by on one side", q["problems"][0])
                d = self.fit(table(rows), "--no-verify")
                self.assertTrue(d["quality"]["good"])
                self.assertGreater(len(d["curve"]["points"]), 4)

    def test_a_part_that_only_scatters_more_is_not_passed_by(self):
        """Errors along y alone are six times as large across a wave at its crests, and the crests turn within three deviations: chance, not structure."""
        for count in "7", "12":
            r = random.Random(0)
            rows = [[x, math.sin(6 * x) + r.gauss(0, 0.01)] for x in (k / 5000 for k in range(5001))]
            q = self.fit(table(rows), "--control-points", count, "--no-verify")["quality"]
            self.assertGreater(q["part"]["probability"], 0.01)
            self.assertTrue(q["good"], q["problems"])

    def test_rounding_is_no_structure(self):
        """A quarter of a circle in coordinates of three decimal places: which side of it neighbours lie on is that of rounding."""
        arc = [[3456789.12 + 50 * math.cos(a), 5678901.5 + 50 * math.sin(a)] for a in (k * math.pi / 118 for k in range(60))]
        d = self.fit(table(arc, number=lambda x: f"{x:.3f}"), "--no-verify")
        self.assertEqual((d["curve"]["degree"], len(d["curve"]["points"]), d["quality"]["good"]), (2, 3, True))
        self.assertLess(d["quality"]["probability"], 0.01)
        self.assertEqual(d["quality"]["structure_beneath"], "digits")
        rows = [[x, y + 0.002 * math.sin(x / 4)] for x, y in arc]  # more than half a diagonal of a cell
        d = self.fit(table(rows, number=lambda x: f"{x:.3f}"), "--no-verify", "--degree", "2")
        self.assertFalse(d["quality"]["good"])

    def test_structure_beneath_what_the_points_are_given_to(self):
        """A parabola with a wave of 1e-7 of its size is told and good, with one of 1e-4 not good; given deviations say it otherwise."""
        waves = {wave: [[u, u * (1 - u) + wave * math.sin(40 * u)] for u in (k / 99 for k in range(100))] for wave in (1e-7, 1e-4)}
        said = {wave: self.text(rows, "--no-verify", "--degree", "2") for wave, rows in waves.items()}
        self.assertIn("structure as below Structure", said[1e-7])
        self.assertIn("not held against the fit, since all of them are within a hundred-thousandth of the extent of the points", said[1e-7])
        self.assertIn("NOT good, whatever is said of the minimum; the distances are no noise", said[1e-4])
        self.assertNotIn("not held against", said[1e-4])
        given = self.fit(table(waves[1e-4]), "--no-verify", "--degree", "2", "--sigma", "2e-4")["quality"]
        self.assertEqual((given["good"], given["structure_beneath"]), (True, "deviations"))
        given = self.fit(table(waves[1e-7]), "--no-verify", "--degree", "2", "--sigma", "1e-8")["quality"]
        self.assertEqual((given["good"], given["structure_beneath"]), (False, None))

    def test_names_of_maps_and_surveys(self):
        r = random.Random(3)
        rows = [[k, 3456700 + 50 * math.cos(k / 40), 5678900 + 50 * math.sin(k / 40) + r.gauss(0, 0.01)] for k in range(60)]
        for names in ["Nr.", "Rechtswert", "Hochwert"], ["id", "Easting [m]", "Northing [m]"], ["point", "E", "N"], ["time", "lon", "lat"]:
            text = table(rows, ";", names=names, number=lambda x: f"{x:.3f}")
            self.assertEqual(self.fit(text, "--no-verify")["points"]["count"], 60)
            out = run("fit", self.file(text), "--no-verify").stdout.decode()
            self.assertIn("are taken as they are, as coordinates x and y of a plane", " ".join(out.split()))
        other = table([[k, y, x] for k, x, y in rows], names=["id", "lat", "lon"])
        self.assertAlmostEqual(self.fit(other, "--no-verify")["curve"]["points"][0][0], rows[0][1], 1)
        self.refuses(table(rows, names=["id", "E", "lat"]), ["line 1", "no column is the other coordinate beside E"], "--no-verify")

    def notes(self, text, *options):
        """x and y of the second point, the dimension, whether standard deviations were read, and what was noted."""
        points = self.folder / "r.csv"
        d = self.fit(text, "--no-verify", "--max-iterations", "1", "--residuals", points, *options, code=None)
        row = list(csv.DictReader(points.read_text().splitlines()))[1]
        return [float(row[c]) for c in "xyz" if c in row], d["points"]["sigma"], d["points"]["notes"]

    def test_columns_that_are_no_coordinates(self):
        """Numbers and names of points are set aside, what is left over is told, and nothing else is guessed."""
        rows = [[k + 1, x, y] for k, (x, y) in enumerate(quadratic(12, noise=0.01))]
        at, sigma = rows[1][1:], [0.01]
        plane = "%s and %s are taken as coordinates x and y of a plane"
        map_of = "%s and %s are taken as they are, as coordinates x and y of a plane"
        for names, noted in [(["Punkt", "Ost", "Nord"], map_of % ("ost", "nord")), (["序号", "横坐标", "纵坐标"], None),
                             (["Pkt.-Nr.", "东坐标", "北坐标"], map_of % ("东", "北")), (["Nr", "X坐标（毫米）", "Y坐标（毫米）"], None),
                             (["point_id", "alpha", "beta"], plane % ("alpha", "beta"))]:
            with self.subTest(names):
                said = [noted] if noted else []
                unused = ["not used: " + names[0]]
                found, deviations, notes = self.notes(table(rows, ";", names=names))
                self.assertEqual((found, deviations, sorted(notes)), (at, "unknown", sorted(said + unused)))
                found, deviations, notes = self.notes(table([[*row, *sigma] for row in rows], names=[*names, "sigma"]))
                self.assertEqual((found, deviations, sorted(notes)), (at, "column", sorted(said + unused)))
        two = [row[1:] for row in rows]
        for names in ["x", "z"], ["t", "x"], ["y (m)", "z (m)"], ["Nr", "y"]:
            self.assertEqual(self.notes(table(two, names=names)), (at, "unknown", [plane % tuple(names)]))
        turned = table([[y, x, 0.01] for x, y in two], names=["Z", "X", "sigma"])
        self.assertEqual(self.notes(turned)[::2], (at, [plane % ("X", "Z")]))
        high = table([[*row, 5 + row[0] / 7, "BK"] for row in rows], ";", names=["Nr", "Ost", "Nord", "Höhe", "Code"], number=str)
        self.assertEqual(self.notes(high)[2][0], "not used: Nr, Höhe, Code (--dim 3 takes Höhe as z)")
        self.assertEqual(self.notes(high, "--dim", "3")[0], [*at, 5 + 2 / 7])
        counted = "the first column, 1, 2, 3, ..., is taken as x and the last one as the standard deviation; if it numbers the points"
        positive = [[k, x, y + 1] for k, x, y in rows]
        self.assertIn(counted, self.notes(table(positive), "--dim", "2")[2][0])
        self.assertEqual(self.notes(table([[0.5 * k, x, y + 1] for k, x, y in rows]), "--dim", "2")[2], [])

    def test_units_behind_numbers(self):
        rows = quadratic(12, noise=0.01)
        noted = ["the unit mm stands behind the numbers, which are taken as they are"]
        for separator in ",", ";", "\t", " , ":
            for unit in " mm", "mm":
                for names in None, ["x", "y"]:
                    text = table(rows, separator, names=names, number=lambda x: repr(x) + unit)
                    self.assertEqual(self.notes(text)[::2], (rows[1], noted))
        self.refuses("x,y\n1 mm,2 mm\n3 mm,4 cm\n", ["line 3", "'4 cm' has another unit than mm"])
        self.refuses("x,y\n1 mm,2 mm\n3 mm,4 oops\n", ["line 3", "'4 oops' is not a number"])
        self.refuses("1,5, 2,25\n1,75, 2,5\n", ["line 1", "some commas have a blank behind them"])

    def test_pictures_of_all_kinds(self):
        for text, options in [(table(helix(30, 0.01), names=["x", "y", "z"]), ["--degree", "3"]),
                              (table(quadratic(3000, 0.75, 0.02)), []), (table(quadratic(3, 0.75)), ["--ends", "exact"]),
                              (table([[i, 2 * i] for i in range(9)]), []),
                              (table([[5e6 + x, 4e-9 * y] for x, y in quadratic(30)]), []),
                              (table([[x, math.sin(x)] for x in (6 * i / 59 for i in range(60))]),
                               ["--degree", "3", "--control-points", "12", "--max-iterations", "20"])]:
            svg = self.folder / "p.svg"
            r = run("fit", self.file(text), "--svg", svg, "--no-verify", *options)
            self.assertIn(r.returncode, (0, 1), r)
            self.assertEqual(r.stderr, b"")
            xml.dom.minidom.parse(str(svg))
            svg.unlink()


if __name__ == "__main__":
    unittest.main(verbosity=2)
