"""make.py -- writes the files of this folder: measurements of our own in the formats and with the flaws that people have.

Airfoils are computed by their published formulas and rounded to the usual digits; sections are drawn, rasterised and traced pixel by
pixel; tracks and scans are simulated.  The same bytes on every machine: decimals are printed from few digits."""
import json
import math
import pathlib
import random

HERE = pathlib.Path(__file__).resolve().parent


def write(name, text):
    (HERE / name).write_bytes(text.encode("utf-8"))


def half_thickness(x, t, closed=False):
    """NACA's four-digit thickness (Jacobs, Ward and Pinkerton 1933); closed: the last coefficient makes the trailing edge sharp."""
    return 5 * t * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - (0.1036 if closed else 0.1015) * x**4)


def cambered(x, m, p, t, side, closed=False):
    camber = m / p**2 * (2 * p * x - x * x) if x < p else m / (1 - p) ** 2 * (1 - 2 * p + 2 * p * x - x * x)
    slope = 2 * m / (p if x < p else 1 - p) ** 2 * (p - x)
    a, y = math.atan(slope), half_thickness(x, t, closed)
    return x - side * y * math.sin(a), camber + side * y * math.cos(a)


def cosine(n):
    return [(1 - math.cos(math.pi * i / n)) / 2 for i in range(n + 1)]


def traced(inside, low, high, step):
    """The outer boundary of the pixels whose centres are inside, as corners of pixels, counter-clockwise (edges between pixels, followed)."""
    n = round((high - low) / step)
    pixel = [[inside(low + (i + 0.5) * step, low + (j + 0.5) * step) for j in range(n)] for i in range(n)]
    after = {}
    for i in range(n):
        for j in range(n):
            if pixel[i][j]:
                for di, dj, a, b in ((0, -1, (i, j), (i + 1, j)), (1, 0, (i + 1, j), (i + 1, j + 1)), (0, 1, (i + 1, j + 1), (i, j + 1)), (-1, 0, (i, j + 1), (i, j))):
                    if not (0 <= i + di < n and 0 <= j + dj < n and pixel[i + di][j + dj]):
                        after[a] = b
    start = min(after)
    path, at = [start], after[start]
    while at != start:
        path.append(at)
        at = after[at]
    return path


def main():
    xs = cosine(30)
    upper, lower = [cambered(x, 0.02, 0.4, 0.12, 1) for x in xs], [cambered(x, 0.02, 0.4, 0.12, -1) for x in xs]
    write("naca2412.dat", "NACA 2412\n" + "".join(f"  {x:8.5f}  {y:8.5f}\n" for x, y in upper[::-1] + lower[1:]))
    write("naca0015-lednicer.dat", "NACA 0015 (Lednicer)\n       31.       31.\n\n" + "".join(f" {x:9.6f} {half_thickness(x, 0.15):9.6f}\n" for x in xs) + "\n"
          + "".join(f" {x:9.6f} {-half_thickness(x, 0.15):9.6f}\n" for x in xs))
    fine = cosine(100)
    upper, lower = [cambered(x, 0.04, 0.4, 0.15, 1, True) for x in fine], [cambered(x, 0.04, 0.4, 0.15, -1, True) for x in fine]
    write("naca4415-fine.dat", "NACA 4415, sharp\n" + "".join(f"  {x:10.8f}  {y:11.8f}\n" for x, y in upper[::-1] + lower[1:]))
    sharp = [(x, half_thickness(x, 0.12, True)) for x in xs]
    write("naca0012-sharp.dat", "NACA 0012 CLOSED TE\r\n" + "".join(f"{x:.4f} {abs(round(y, 4)):.4f}\r\n" for x, y in sharp[::-1]) + "".join(f"{x:.4f} {-y:.4f}\r\n" for x, y in sharp[1:]))
    cam = traced(lambda x, y: math.hypot(x, y) < 10 + 4 * math.exp(-6 * (1 - math.cos(math.atan2(y, x) - 1))), -16, 16, 0.4)
    write("cam-traced.csv", "column;row\n" + "".join(f"{i};{j}\n" for i, j in cam))
    disc = traced(lambda x, y: (x - 0.3) ** 2 + (y + 0.2) ** 2 < 81, -12, 12, 0.25)
    write("disc-traced.tsv", "# boundary of a disc, corners of pixels, radius 36 pixels\n" + "".join(f"{i}\t{j}\n" for i, j in disc))
    r = random.Random(101)
    arc = [(40 + 25 * math.cos(math.radians(a)) + r.gauss(0, 0.02), 12 + 25 * math.sin(math.radians(a)) + r.gauss(0, 0.02)) for a in range(20, 141, 2)]
    write("scan-arc.txt", "x [mm]      y [mm]\n" + "".join(f"{x:9.3f}   {y:9.3f}\n".replace(".", ",") for x, y in arc))
    ring = [(100.5 + 8 * math.cos(a) + r.gauss(0, 0.01), 55.25 + 8 * math.sin(a) + r.gauss(0, 0.01)) for a in (2 * math.pi * r.random() for _ in range(90))]
    write("pipe-unordered.csv", "x,y,quality\n" + "".join(f"{x:.3f},{y:.3f},{90 + k % 7}\n" for k, (x, y) in enumerate(ring)))
    lat, lon = 47.0, 8.0
    track = [(30 * k + r.gauss(0, 2), 120 * math.sin(k / 9) + r.gauss(0, 2)) for k in range(70)]
    write("track.gpx", '<?xml version="1.0"?>\n<gpx version="1.1" creator="cagd"><trk><trkseg>\n'
          + "".join(f'<trkpt lat="{lat + y / 111195:.7f}" lon="{lon + x / (111195 * math.cos(math.radians(lat))):.7f}"><ele>{430 + k % 3}</ele></trkpt>\n' for k, (x, y) in enumerate(track))
          + "</trkseg></trk></gpx>\n")
    lake = [[round(8.5 + 0.02 * (1 + 0.25 * math.cos(2 * a) + 0.1 * math.sin(3 * a)) * math.cos(a), 5), round(47.3 + 0.012 * (1 + 0.25 * math.cos(2 * a) + 0.1 * math.sin(3 * a)) * math.sin(a), 5)]
            for a in (2 * math.pi * k / 60 for k in range(60))]
    write("lake.geojson", json.dumps({"type": "Feature", "properties": {"name": "lake"}, "geometry": {"type": "Polygon", "coordinates": [lake + lake[:1]]}}) + "\n")
    stroke = [(20 + 2 * k, 60 - 30 * math.sin(k / 6)) for k in range(40)]
    write("stroke.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="120" height="120"><path d="M ' + " L ".join(f"{x:.1f},{y:.1f}" for x, y in stroke) + '" fill="none"/></svg>\n')
    slot = [(50 + (30 + 6 * math.cos(2 * a)) * math.cos(a), 40 + (30 + 6 * math.cos(2 * a)) * math.sin(a)) for a in (2 * math.pi * k / 48 for k in range(48))]
    write("slot.dxf", "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n90\n48\n70\n1\n" + "".join(f"10\n{x:.3f}\n20\n{y:.3f}\n" for x, y in slot) + "0\nENDSEC\n0\nEOF\n")
    coil = [[round(10 * math.cos(t) + r.gauss(0, 0.005), 3), round(10 * math.sin(t) + r.gauss(0, 0.005), 3), round(2 * t, 3)] for t in (0.08 * k for k in range(100))]
    write("coil.json", json.dumps({"x": [q[0] for q in coil], "y": [q[1] for q in coil], "z": [q[2] for q in coil]}) + "\n")
    write("thousands.csv", "x;y\n" + "".join(f"1,00{k},250;{k}\n" for k in range(9)))


if __name__ == "__main__":
    main()
