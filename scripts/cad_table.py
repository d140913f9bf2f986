#!/usr/bin/env python3
"""Prints what STEP files of documents weigh and how near they are, as a table for docs/export.md.

  scripts/cad_table.py PROGRAM DOCUMENT...     PROGRAM: the hariko to run

One line a document and quality: faces, control points, kilobytes, largest distance in parts of the tolerance, largest
angle between faces, seconds. Documents of several objects are added up.
"""

import pathlib
import re
import subprocess
import sys
import tempfile
import time

QUALITIES = ("light", "balanced", "fine")


def numbers(pattern, text):
    return [float(x) for x in re.findall(pattern, text)]


def line(program, document, quality, folder):
    out = folder / "a.step"
    began = time.monotonic()
    run = subprocess.run([program, "export", document, out, "--quality", quality], capture_output=True, text=True)
    seconds = time.monotonic() - began
    name = pathlib.Path(document).stem
    if run.returncode != 0:
        return f"| {name} | {quality} | {run.stderr.strip().splitlines()[0]} | | | | | |"
    text = run.stdout
    distances = zip(numbers(r"distance: largest ([\d.e+-]+)", text), numbers(r"tolerance ([\d.e+-]+) ", text))
    share = max(distance / tolerance for distance, tolerance in distances)
    faces = sum(numbers(r": (\d+) faces", text))
    points = sum(numbers(r"(\d+) control points", text))
    angle = max(numbers(r"smooth edges: ([\d.e+-]+) degrees", text))
    size = out.stat().st_size / 1000
    return (
        f"| {name} | {quality} | {faces:.0f} | {points:.0f} | {size:.0f} | {share:.2f} | {angle:.3f} | {seconds:.1f} |"
    )


def main():
    program, *documents = sys.argv[1:]
    print("| document | quality | faces | control points | kB | distance / tolerance | angle, degrees | s |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for document in documents:
            for quality in QUALITIES:
                print(line(program, document, quality, pathlib.Path(folder)), flush=True)


if __name__ == "__main__":
    main()
