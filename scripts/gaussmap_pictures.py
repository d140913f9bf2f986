#!/usr/bin/env python3
"""Draws the picture of docs/gaussmap.md with the program's own command line: zebra stripes of surfaces over the control
points of outlines, with their normals alone and with the tangents that are fitted to them.

    python3 scripts/gaussmap_pictures.py build/release/app/hariko

Needs ImageMagick (montage)."""

import json
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PICTURES = os.path.join(ROOT, "docs", "pictures")
SAMPLES = {"sphere_holes": ["--view", "left"], "ellipsoid_cap": ["--view", "iso"]}


def with_normals_alone(program, sample, path):
    """The polyhedron of an outline's control points, whose normals are pinned but not its tangents."""
    done = subprocess.run([program, "evaluate", sample], check=True, capture_output=True, text=True, timeout=300)
    points = json.loads(done.stdout)
    count = len(points["points"])
    source = {
        "kind": "polyhedron", "mode": "fair", "origin": [0, 0, 0],
        "vertices": [[v, *points["points"][v]] for v in range(count)],
        "faces": [[f, *triangle] for f, triangle in enumerate(points["triangles"])],
        "tag": [[v, "smooth"] for v in range(count) if points["boundary"][v]],
        "pin": [{"vertex": v, "kind": "normal", "vectors": [points["normals"][v]]} for v in range(count)],
    }
    with open(path, "w", encoding="utf-8") as file:
        json.dump({"format": "hariko", "version": 2, "objects": [{"id": 1, "name": "Normals alone", "source": source}]},
                  file)


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        cells = []
        for name, view in SAMPLES.items():
            sample = os.path.join(ROOT, "assets", "samples", name + ".hariko")
            plain = os.path.join(folder, name + ".hariko")
            with_normals_alone(program, sample, plain)
            for model, kind in ((plain, "plain"), (sample, "fitted")):
                cells.append(os.path.join(folder, f"{name}_{kind}.png"))
                subprocess.run([program, "render", model, cells[-1], "--size", "1000x720", "--map", "zebra", "--background",
                                "transparent", *view], check=True, timeout=300)
                subprocess.run(["convert", cells[-1], "-trim", "+repage", cells[-1]], check=True, timeout=60)
        subprocess.run(["montage", *cells, "-tile", "4x", "-geometry", "380x280+14+14", "-background", "#2b2d31",
                        os.path.join(folder, "all.png")], check=True, timeout=120)
        subprocess.run(["convert", os.path.join(folder, "all.png"), "-alpha", "off", "-strip", "+dither", "-colors", "64",
                        "PNG8:" + os.path.join(PICTURES, "gaussmap_zebra.png")], check=True, timeout=120)


main()
