"""test_real.py CAGD [FOLDER] -- the defaults of cagd fit on the files of proofs-tests/fit/real and, where it is, of the folder of shared data.

For every file: what a good answer is, and why."""
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
CAGD = str(pathlib.Path(sys.argv.pop(1)).resolve())
SHARED = [HERE.parents[2] / "shared/data", HERE.parents[3] / "shared/data"]


def shared(name):
    """The file of the shared data, or None."""
    return next((folder / name for folder in SHARED if (folder / name).is_file()), None)


def fit(path, *options):
    r = subprocess.run([CAGD, "fit", path, "--json", "--no-verify", *options], capture_output=True, text=True)
    assert r.returncode == 0 and r.stderr == "", (path, r.returncode, r.stderr)
    return json.loads(r.stdout)


# file: points; closing; the kind; at most so many control points; rms between; and why
GOOD = {
    "naca2412.dat": (61, "corner", "spline", 14, (1e-6, 3e-5), "five decimals leave 0.3e-5; the trailing edge is a corner"),
    "naca0015-lednicer.dat": (61, "corner", "spline", 16, (1e-7, 5e-6), "six decimals; the nose stands there with 0 and with -0, and is one; the trailing edge is blunt"),
    "naca0012-sharp.dat": (61, "corner", "spline", 12, (1e-5, 5e-5), "four decimals leave 2.9e-5; first and last point are one, with a corner"),
    "naca4415-fine.dat": (201, "corner", "spline", 36, (1e-8, 5e-7), "as panel codes write them, to 1e-8, with a sharp trailing edge, where errors let both sides cross"),
    "cam-traced.csv": (216, "around", "spline", 8, (0.25, 0.5), "corners of pixels scatter by 0.3 to 0.5 of a pixel about the section"),
    "disc-traced.tsv": (288, "around", "circle", 9, (0.25, 0.5), "a disc of radius 36 pixels about (49.2, 47.2)"),
    "scan-arc.txt": (61, "open", "conic", 3, (0.01, 0.03), "noise of 0.02 about an arc of 120 degrees"),
    "pipe-unordered.csv": (90, "around", "circle", 9, (0.005, 0.02), "noise of 0.01 about a circle of radius 8"),
    "track.gpx": (70, "open", "spline", 8, (1, 3), "errors of 2 m in both coordinates"),
    "lake.geojson": (60, "repeated", "spline", 16, (1e-6, 1e-5), "five decimals of a degree leave 0.3e-5; the first point is repeated"),
    "stroke.svg": (40, "open", "spline", 10, (0.005, 0.1), "one decimal leaves 0.03"),
    "slot.dxf": (48, "repeated", "spline", 16, (1e-4, 2e-2), "a closed polyline, without repeated point"),
    "coil.json": (100, "open", "spline", 16, (0.002, 0.01), "noise of 0.005 about a helix"),
}
OPTIONS = {"pipe-unordered.csv": ["--unordered"]}
# of others: what today gave nothing usable
OF_OTHERS = {
    "ffa-w3-211.dat": (80, "corner", "spline", 20, (3e-6, 5e-5), "five decimals; the trailing edge is open by 0.003, a corner"),
    "cuba.geojson": (41, "repeated", "spline", 14, (0.05, 0.3), "an outline with corners every half degree"),
    "newfoundland.csv": (32, "repeated", "spline", 12, (0.1, 0.5), "an outline with corners every half degree"),
    "roszman1.txt": (25, "open", "conic", 3, (1e-3, 1e-2), "of scales 10^4 apart a conic"),
}


class Real(unittest.TestCase):
    def answers(self, path, good, options=()):
        count, closing, kind, most, (low, high), _ = good
        d = fit(path, *options)
        e = d["ellipse"]
        closed = closing in ("repeated", "around")
        name = (d["choice"]["candidates"] or [{"name": ""}])[0]["name"]
        self.assertEqual((d["points"]["count"], d["choice"]["points_are"], d["choice"]["closed"]), (count, closing, closed))
        self.assertTrue(d["at_minimum"])
        own = len(d["curve"]["points"]) - (d["curve"].get("degree", 0) if closed and not e else 0)
        self.assertLessEqual(own, most)
        self.assertTrue(low <= d["distances"]["rms"] <= high, d["distances"]["rms"])
        self.assertEqual("circle" if e and e["circle"] else "ellipse" if e else "conic" if "conic" in name else "spline", kind)
        self.assertFalse(d["quality"]["crossings"] > d["quality"]["crossings_of_points"])
        if not math.isnan(d["length_ratio"] or math.nan):
            self.assertLess(d["length_ratio"], 1.26)
        return d

    def test_files_of_our_own(self):
        for name, good in GOOD.items():
            with self.subTest(name=name):
                q = self.answers(HERE / "real" / name, good, OPTIONS.get(name, ()))["quality"]
                self.assertTrue(q["good"], q["problems"])
                self.assertEqual(q["structure_beneath"], {"naca4415-fine.dat": "size"}.get(name))

    def test_files_of_others(self):
        for name, good in OF_OTHERS.items():
            path = shared(name)
            with self.subTest(name=name):
                if path is None:
                    self.skipTest(f"{name} of the shared data is not there")
                self.answers(path, good)

    def airfoils(self):
        own = [HERE / "real" / name for name in ("naca2412.dat", "naca0015-lednicer.dat", "naca0012-sharp.dat")]
        other = shared("ffa-w3-211.dat")
        return own + ([other] if other else [])

    def test_so_many_control_points(self):
        """Over even knots some of these do not converge; then the knots are placed by the points, not the curve smoothed to a line."""
        placed = 0
        for path in self.airfoils():
            for count in (8, 10, 12, 14):
                with self.subTest(name=path.name, count=count):
                    d = fit(path, "--degree", "3", "--control-points", str(count))
                    self.assertEqual((d["at_minimum"], len(d["curve"]["points"]), d["choice"]["smoothing"]), (True, count, None))
                    self.assertLess(d["distances"]["rms"], 3e-4)  # of the chord
                    self.assertLess(d["length_ratio"], 1.01)
                    self.assertEqual(d["quality"]["crossings"], 0)
                    placed += d["choice"]["knots_chosen"]
                    if d["choice"]["knots_chosen"]:  # by the same points: no intervals
                        self.assertEqual({u["low"] for u in d["unknowns"]}, {None})
        self.assertGreater(placed, 0)

    def test_smoothing_follows_an_airfoil(self):
        """Upper and lower side are not smoothed into the chord between them, the weight of which is a minimum of cross-validation too."""
        for path in self.airfoils():
            with self.subTest(name=path.name):
                d = fit(path, "--smooth", "auto")
                self.assertLess(d["distances"]["rms"], 1e-4)
                self.assertTrue(d["quality"]["good"], d["quality"]["problems"])

    def test_a_chord_is_not_called_good(self):
        for path in self.airfoils():
            with self.subTest(name=path.name):
                d = fit(path, "--degree", "3", "--control-points", "12", "--smooth", "1000")
                self.assertGreater(d["distances"]["rms"], 0.05)
                self.assertTrue(any("the smoothing term may be" in p for p in d["quality"]["problems"]), d["quality"])

    def test_fewest_control_points(self):
        """Of good curves alone, and with neighbours of a knot that is taken out moved; no more than splprep needs for this rms, where it can do it."""
        naca, cuba = HERE / "real/naca2412.dat", shared("cuba.geojson")
        for within, most in (("7e-5", 9), ("2.742e-5", 11), ("2.285e-5", 11)):
            with self.subTest(within=within):
                d = fit(naca, "--degree", "3", "--tolerance-distance", within)
                self.assertIs(d["choice"]["tolerance_met"], True)
                self.assertLessEqual(d["distances"]["largest"], float(within))
                self.assertLessEqual(len(d["curve"]["points"]), most)
        with self.subTest("cuba.geojson"):
            if cuba is None:
                self.skipTest("cuba.geojson of the shared data is not there")
            for within, most in (("0.6", 6), ("0.85", 5)):  # splprep: 11, 10
                d = fit(cuba, "--degree", "3", "--tolerance-distance", within)
                self.assertEqual((d["choice"]["tolerance_met"], d["choice"]["smoothing"]), (True, None))
                self.assertLessEqual(d["distances"]["largest"], float(within))
                self.assertLessEqual(len(d["curve"]["points"]) - 3, most)
                self.assertLess(d["distances"]["rms"], 0.2)

    def test_a_tolerance_asks_for_no_degrees_of_freedom(self):
        """Finer than half of the equations allow, down to what the digits of the files leave: kept without a smoothing term, and without loops."""
        asked = [("naca0015-lednicer.dat", "3e-6", 14), ("naca2412.dat", "1e-5", 15), ("slot.dxf", "0.001", 18), ("stroke.svg", "0.01", 16)]
        other = shared("ffa-w3-211.dat")
        asked = [(HERE / "real" / name, within, most) for name, within, most in asked]
        for path, within, most in asked + ([(other, "1.6e-5", 21), (other, "1e-5", 23)] if other else []):
            with self.subTest(name=path.name, within=within):
                d = fit(path, "--degree", "3", "--tolerance-distance", within)
                closed = d["choice"]["closed"]
                self.assertEqual((d["choice"]["tolerance_met"], d["choice"]["smoothing"], d["at_minimum"]), (True, None, True))
                self.assertLessEqual(d["distances"]["largest"], float(within))
                self.assertLessEqual(len(d["curve"]["points"]) - (3 if closed else 0), most)
                self.assertLess(d["length_ratio"], 1.02)
                self.assertEqual(d["quality"]["crossings"], d["quality"]["crossings_of_points"])

    def test_tolerances_that_only_smoothed_curves_keep(self):
        """Outlines with a corner every half degree: no minimum of the squares alone that was found keeps every point within half a degree."""
        sharp = HERE / "real/naca0012-sharp.dat"  # of four decimals: finer than they are
        for path, within, most in (shared("cuba.geojson"), 0.5, 10), (shared("cuba.geojson"), 0.3, 17), (shared("newfoundland.csv"), 0.5, 10), (sharp, 2e-5, 50):
            with self.subTest(path=path, within=within):
                if path is None:
                    self.skipTest("the shared data are not there")
                d = fit(path, "--degree", "3", "--tolerance-distance", str(within))
                self.assertEqual((d["choice"]["tolerance_met"], d["at_minimum"]), (True, True))
                self.assertLessEqual(d["distances"]["largest"], within)
                self.assertEqual(d["choice"]["smoothing"]["by"], "the distance")
                self.assertLessEqual(len(d["curve"]["points"]) - (3 if d["choice"]["closed"] else 0), most)
                self.assertLessEqual(d["quality"]["crossings"], d["quality"]["crossings_of_points"])

    def test_of_a_tolerance_that_is_not_met_the_smallest_is_told(self):
        for name, nearest in ("cuba.geojson", 0.3), ("newfoundland.csv", 0.5):
            with self.subTest(name=name):
                path = shared(name)
                if path is None:
                    self.skipTest(f"{name} of the shared data is not there")
                d = fit(path, "--degree", "3", "--tolerance-distance", "0.1")
                self.assertIs(d["choice"]["tolerance_met"], False)
                self.assertTrue(0.1 < d["distances"]["largest"] < nearest, d["distances"]["largest"])
                self.assertLessEqual(d["quality"]["crossings"], d["quality"]["crossings_of_points"])

    def test_scales_far_apart_are_verified(self):
        """The second coordinate is 10^4 times the first one: most of the squares of derivatives is along the curve, and cancels."""
        path = shared("roszman1.txt")
        if path is None:
            self.skipTest("roszman1.txt of the shared data is not there")
        r = subprocess.run([CAGD, "fit", path, "--json"], capture_output=True, text=True)
        self.assertEqual(json.loads(r.stdout)["verification"]["status"], "verified")

    def test_known_circles(self):
        for name, centre, radius, options in (("disc-traced.tsv", (49.2, 47.2), 36, []), ("pipe-unordered.csv", (100.5, 55.25), 8, ["--unordered"])):
            e = fit(HERE / "real" / name, *options)["ellipse"]
            for got, true in zip(e["centre"] + [e["radius"]], (*centre, radius)):
                self.assertLess(abs(got["value"] - true), 4 * got["standard_error"], name)

    def test_thousands_are_refused(self):
        r = subprocess.run([CAGD, "fit", HERE / "real/thousands.csv"], capture_output=True, text=True)
        self.assertEqual((r.returncode, r.stdout), (2, ""))
        self.assertIn("'1,000,250' is not a number", r.stderr)

    def test_the_files_are_those_that_are_made(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "make.py"
            copy.write_bytes((HERE / "real/make.py").read_bytes())
            subprocess.run([sys.executable, copy], check=True)
            made = {p.name: p.read_bytes() for p in pathlib.Path(folder).iterdir() if p.is_file()}
        self.assertEqual(made, {p.name: p.read_bytes() for p in (HERE / "real").iterdir() if p.is_file()})
        self.assertLessEqual(10, len(made) - 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
