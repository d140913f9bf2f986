#!/usr/bin/env python3
"""Draws the sheets of materials, maps, marks, modes, skins and lines of docs/manual.md with the program's command line.

    python3 scripts/manual_pictures.py build/release/app/hariko [sheet ...]

Needs ImageMagick (montage) to put the pictures side by side, and rsvg-convert for lines. The pictures of the window come from
manual_windows.py."""

import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PICTURES = os.path.join(ROOT, "docs", "pictures")
SIZE = "720x540"  # drawn larger than shown: legends take less room

# Sheet -> (caption, sample, options) from left to right and down.
SHEETS = {
    "manual_materials": [(name.capitalize(), "car", ["--material", name])
                         for name in ("clay", "porcelain", "metal", "wax", "rubber", "plastic")],
    "manual_maps": [
        ("Gaussian curvature", "fig2", ["--map", "gauss"]),
        ("Mean curvature", "fig2", ["--map", "mean"]),
        ("Continuity", "fig5d", ["--map", "continuity"]),
        ("Greatest curvature k1", "fig2", ["--map", "k1"]),
        ("Least curvature k2", "fig2", ["--map", "k2"]),
        ("Isophotes", "car", ["--map", "isophotes", "--stripes", "16"]),
        ("Zebra", "car", ["--map", "zebra", "--stripes", "16"]),
        ("Patches", "car", ["--map", "patches"]),
        ("Gaussian, safe colours", "fig2", ["--map", "gauss", "--colour-blind-safe"]),
    ],
    "manual_marks": [
        ("Tensions", "fig5d", ["--show", "polyhedron,network,tensions"]),
        ("Continuity of edges", "fig5c", ["--show", "marks"]),
        ("Curvature combs", "fig2", ["--show", "network,combs"]),
        ("Borders of patches", "genus3", ["--wire", "borders"]),
        ("Display mesh", "fig2", ["--wire", "mesh"]),
        ("Section", "genus3", ["--section", "y=0.1", "--show", "network"]),
    ],
    "manual_g2": [(caption, "fig2", ["--mode", mode, "--map", surface_map, "--range=-1.5,1.5"])
                  for caption, mode, surface_map in [
                      ("Fair, zebra", "fair", "zebra"),
                      ("G2, zebra", "g2", "zebra"),
                      ("Fair, mean curvature", "fair", "mean"),
                      ("G2, mean curvature", "g2", "mean"),
                  ]],
    "manual_skins": [(caption, "skin_" + sample, ["--show", "network"]) for caption, sample in [
        ("Smooth, 8 columns", "smooth"),
        ("Ridges by themselves", "ridges"),
        ("Ridges joined", "joined"),
        ("Ridges grouped", "grouped"),
        ("Joined on a regular grid", "between"),
        ("Merged on the way", "merge_inside"),
        ("Merged at the end", "merge_end"),
        ("Car, smooth", "car_smooth"),
        ("Car, pleated", "car"),
    ]],
    "manual_lines": [
        ("Outlines and network", "skin_car", ["--hidden", "--lines", "silhouette,border,network"]),
        ("Outlines alone", "torus", ["--lines", "silhouette"]),
        ("A section", "genus3", ["--section=-y=0.1"]),
    ],
}


def draw_lines(program, model, path, options):
    """On paper of a width at which pens look as they do on a page."""
    drawing = path.removesuffix(".png") + ".svg"
    subprocess.run([program, "render", model, drawing, "--size", "400x300", *options], check=True, timeout=300)
    subprocess.run(["rsvg-convert", "-z", "2", "-b", "white", "-o", path, drawing], check=True, timeout=120)


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        for sheet in sys.argv[2:] or SHEETS:
            cells = SHEETS[sheet]
            arguments = []
            for number, (caption, sample, options) in enumerate(cells):
                path = os.path.join(folder, f"{sheet}_{number}.png")
                model = os.path.join(ROOT, "assets", "samples", sample + ".hariko")
                if sheet == "manual_lines":
                    draw_lines(program, model, path, options)
                else:
                    subprocess.run([program, "render", model, path, "--size", SIZE, "--background", "transparent",
                                    *options], check=True, timeout=300)
                arguments += ["-label", caption, path]
            whole = os.path.join(folder, sheet + ".png")
            columns = "2x" if len(cells) == 4 else "3x"
            subprocess.run(["montage", *arguments, "-tile", columns, "-geometry", "400x300+3+3", "-background", "#2b2d31",
                            "-fill", "#e6e6e6", "-font", "Inter-Regular", "-pointsize", "15", whole],
                           check=True, timeout=120)
            subprocess.run(["convert", whole, "-alpha", "off", "-strip", "+dither", "-colors", "160",
                            "PNG8:" + os.path.join(PICTURES, sheet + ".png")], check=True, timeout=120)


main()
