#!/usr/bin/env python3
"""Draws the pictures of docs/approximation.md with the program's own command line: meshes of the reference surfaces and
their errors, after the figures 3, 4, 6, 9 and 10 of Yamamoto and Saitoh.

    python3 scripts/approximation_pictures.py build/release/app/hariko

Needs rsvg-convert (librsvg2-bin) and ImageMagick."""

import csv
import json
import math
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PICTURES = os.path.join(ROOT, "docs", "pictures")
WIDTH, HEIGHT, HEAD = 460, 330, 30  # sizes of one picture, pixels
GRID = 4  # intervals a facet's side between samples of the surface, as the program writes them
PALE, DARK, PLAIN = (247, 243, 236), (122, 32, 20), (214, 209, 201)
LIGHT = (0.35, -0.5, 0.79)


def mesh(program, folder, surface, *options):
    """Facets with corners, errors and samples of a reference surface under some tolerances."""
    with open(os.path.join(ROOT, "tests", "golden", "approximation", "surfaces.json"), encoding="utf-8") as file:
        patches = json.load(file)[surface]
    source, out, errors = (os.path.join(folder, name) for name in ("surface.json", "mesh.obj", "errors.csv"))
    with open(source, "w", encoding="utf-8") as file:
        json.dump({surface: patches}, file)
    done = subprocess.run([program, "mesh", source, out, "--json", "--errors", errors, *map(str, options)], check=True,
                          capture_output=True, text=True, timeout=300)
    result = json.loads(done.stdout)["objects"][0]
    points, facets = [], []
    with open(out, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                points.append(tuple(map(float, words[1:4])))
            elif words and words[0] == "f":
                facets.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    samples = [[] for _ in facets]
    with open(errors, encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            if row["kind"] == "sample":
                samples[int(row["facet"])].append({"distance": float(row["distance"]),
                                                   "normal": float(row["normal_angle_degrees"])})
    return {"points": points, "facets": facets, "samples": samples, "result": result}


def turned(point):
    """From above and the side: right, up, and towards the viewer."""
    x, y, z = point
    turn, tilt = math.radians(32), math.radians(38)
    x, y = x * math.cos(turn) + y * math.sin(turn), -x * math.sin(turn) + y * math.cos(turn)
    return x, y * math.sin(tilt) + z * math.cos(tilt), -y * math.cos(tilt) + z * math.sin(tilt)


def blend(share):
    share = min(max(share, 0), 1)
    return tuple(round(a + share * (b - a)) for a, b in zip(PALE, DARK))


def parts(corners, values):
    """A facet as small triangles between its samples, with their mean values."""
    def number(i, j):
        return j * (GRID + 1) - j * (j - 1) // 2 + i

    def at(i, j):
        a, b = i / GRID, j / GRID
        return tuple((1 - a - b) * p + a * q + b * r for p, q, r in zip(*corners))

    for j in range(GRID):
        for i in range(GRID - j):
            cells = [((i, j), (i + 1, j), (i, j + 1))]
            if i + j < GRID - 1:
                cells.append(((i + 1, j), (i + 1, j + 1), (i, j + 1)))
            for cell in cells:
                yield [at(*c) for c in cell], sum(values[number(*c)] for c in cell) / 3


def picture(made, left, top, caption, kind=None, tolerance=1):
    """One mesh: shaded, or with an error in colours that are darker where it is larger."""
    seen = [turned(p) for p in made["points"]]
    low = [min(p[k] for p in seen) for k in range(2)]
    high = [max(p[k] for p in seen) for k in range(2)]
    scale = min((WIDTH - 30) / (high[0] - low[0]), (HEIGHT - HEAD - 20) / (high[1] - low[1]))
    middle = [(a + b) / 2 for a, b in zip(low, high)]

    def on_page(p):
        x, y, _ = turned(p)
        return (f"{left + WIDTH / 2 + scale * (x - middle[0]):.2f},"
                f"{top + HEAD + (HEIGHT - HEAD) / 2 - scale * (y - middle[1]):.2f}")

    out = [f'<text x="{left + WIDTH / 2}" y="{top + 21}" text-anchor="middle">{caption}</text>']
    order = sorted(range(len(made["facets"])), key=lambda f: sum(seen[v][2] for v in made["facets"][f]))
    for f in order:
        corners = [made["points"][v] for v in made["facets"][f]]
        edge = " ".join(on_page(p) for p in corners)
        if kind:
            values = [sample[kind] / tolerance for sample in made["samples"][f]]
            for triangle, value in parts(corners, values):
                colour = "rgb(%d,%d,%d)" % blend(value)
                out.append(f'<polygon points="{" ".join(on_page(p) for p in triangle)}" fill="{colour}" '
                           f'stroke="{colour}" stroke-width="0.6"/>')
        else:
            a, b, c = corners
            u, v = [q - p for p, q in zip(a, b)], [q - p for p, q in zip(a, c)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            length = math.sqrt(sum(x * x for x in n)) or 1
            shade = 0.55 + 0.45 * abs(sum(x * l for x, l in zip(n, LIGHT)) / length)
            out.append(f'<polygon points="{edge}" fill="rgb(%d,%d,%d)"/>' % tuple(round(shade * x) for x in PLAIN))
        out.append(f'<polygon points="{edge}" fill="none" stroke="#3b3a38" stroke-width="0.7" stroke-linejoin="round"/>')
    return out


def sheet(name, cells, columns=2):
    rows = (len(cells) + columns - 1) // columns
    body = []
    for number, cell in enumerate(cells):
        body += picture(cell[0], number % columns * WIDTH, number // columns * HEIGHT, *cell[1:])
    svg = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{columns * WIDTH}" height="{rows * HEIGHT}" '
           f'font-family="Inter" font-size="14" fill="#222"><rect width="100%" height="100%" fill="#fbfaf8"/>'
           + "\n".join(body) + "</svg>")
    done = subprocess.run(["rsvg-convert", "--format=png"], input=svg.encode(), check=True, capture_output=True,
                          timeout=120)
    subprocess.run(["convert", "png:-", "-strip", "+dither", "-colors", "128",
                    "PNG8:" + os.path.join(PICTURES, name + ".png")], input=done.stdout, check=True, timeout=120)


def count(made):
    return f'{len(made["facets"])} triangles'


def two_by_two(program, folder, name, surface, distance, angle):
    """Figures 3 and 4: made by distance and by angle, with both errors of each."""
    cells = []
    for what, options in (("by distance", ["--distance", distance]), ("by angle", ["--normal", angle])):
        made = mesh(program, folder, surface, *options)
        for kind, tolerance in (("distance", distance), ("normal", angle)):
            title = "distance" if kind == "distance" else "angle of normals"
            cells.append((made, f"{what}, {count(made)}: {title}", kind, tolerance))
    sheet(name, cells)


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        two_by_two(program, folder, "approximation_dome", "dome", 0.03, 10)
        two_by_two(program, folder, "approximation_fender", "fender", 0.02, 10)
        # Figure 6: by folds, and by the distance that this happens to keep.
        folds = mesh(program, folder, "fender", "--fold", 10)
        largest = folds["result"]["errors"]["distance"]["largest"]
        same = mesh(program, folder, "fender", "--distance", largest)
        # Figure 9: the same folds, cut where the normal halves the angle.
        halved = mesh(program, folder, "fender", "--fold", 10, "--split", "halving")
        sheet("approximation_folds", [(folds, f"folds of 10\u00b0, {count(folds)}"),
                                      (same, f"the distance of that, {count(same)}"),
                                      (halved, f"folds of 10\u00b0, halved normals, {count(halved)}"),
                                      (mesh(program, folder, "quarterpipe", "--fold", 10, "--split", "halving"),
                                       "the same on a surface that is bent one way")])
        # Figure 10: inflections.
        cells = []
        for title, rule in (("midpoint", "mid"), ("halved normals", "halving"), ("Gauss image", "gauss"),
                            ("root of curvature", "curvature")):
            made = mesh(program, folder, "wave", "--distance", 0.03, "--split", rule)
            cells.append((made, f"{title}, {count(made)}"))
        sheet("approximation_wave", cells)


if __name__ == "__main__":
    main()
