#!/usr/bin/env python3
"""Prints what STEP files of documents weigh and how near they are, as a table for docs/export.md.

  scripts/cad_table.py [--limit SECONDS] PROGRAM DOCUMENT...     PROGRAM: the hariko to run

One line a document and quality: faces, control points, kilobytes, largest distance in parts of the tolerance, largest
angle between faces, largest jump of the curvature (models in mode G2), kilobytes of the file read back and written
again, seconds. Documents of several objects are added up. Files that OpenCASCADE finds faults in are "not valid"; those
that take longer than the limit have a line that says so.
"""

import argparse
import pathlib
import re
import subprocess
import tempfile
import time

QUALITIES = ("light", "balanced", "fine")


def numbers(pattern, text):
    return [float(x) for x in re.findall(pattern, text)]


def export(program, document, out, quality, limit):
    command = [program, "export", document, out, "--quality", quality]
    return subprocess.run(command, capture_output=True, text=True, timeout=limit)


def written_again(program, step, quality, folder, limit):
    """Kilobytes of a file that was read and is written again."""
    out = folder / "b.step"
    try:
        run = export(program, step, out, quality, limit)
    except subprocess.TimeoutExpired:
        return "over the limit"
    return f"{out.stat().st_size / 1000:.0f}" if run.returncode == 0 else run.stderr.strip().splitlines()[0]


def line(program, document, quality, folder, limit):
    out = folder / "a.step"
    name = pathlib.Path(document).stem
    began = time.monotonic()
    try:
        run = export(program, document, out, quality, limit)
    except subprocess.TimeoutExpired:
        return f"| {name} | {quality} | over {limit:.0f} s | | | | | | | |"
    seconds = time.monotonic() - began
    if run.returncode != 0:
        return f"| {name} | {quality} | {run.stderr.strip().splitlines()[0]} | | | | | | | |"
    text = run.stdout
    distances = zip(numbers(r"distance: largest ([\d.e+-]+)", text), numbers(r"tolerance ([\d.e+-]+) ", text))
    share = max(distance / tolerance for distance, tolerance in distances)
    faces = sum(numbers(r": (\d+) faces", text))
    points = sum(numbers(r"(\d+) control points", text))
    angle = max(numbers(r"smooth edges: ([\d.e+-]+) degrees", text))
    jumps = numbers(r"curvature jump across smooth edges: ([\d.e+-]+) %", text)
    jump = f"{max(jumps):g} %" if jumps else ""
    size = f"{out.stat().st_size / 1000:.0f}" + (", not valid" if "NOT VALID" in text else "")
    again = written_again(program, out, quality, folder, limit)
    return (
        f"| {name} | {quality} | {faces:.0f} | {points:.0f} | {size} | {share:.2f} | {angle:.3f} | {jump} | {again} |"
        f" {seconds:.1f} |"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", type=float, help="seconds for one file")
    parser.add_argument("program")
    parser.add_argument("documents", nargs="+")
    chosen = parser.parse_args()
    print(
        "| document | quality | faces | control points | kB | distance / tolerance | angle, degrees | jump of curvature |"
        " kB again | s |"
    )
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        for document in chosen.documents:
            for quality in QUALITIES:
                print(line(chosen.program, document, quality, pathlib.Path(folder), chosen.limit), flush=True)


if __name__ == "__main__":
    main()
