#!/usr/bin/env python3
"""Prints what STEP or IGES files of documents weigh and how near they are, as a table for docs/export.md.

  scripts/cad_table.py [--limit SECONDS] [--iges] PROGRAM DOCUMENT...     PROGRAM: the hariko to run

One line a document and quality: faces, control points, kilobytes, largest distance in parts of the tolerance, largest
angle between faces, largest jump of the curvature (models in mode G2), kilobytes of the file read back and written
again, seconds of processor time, on all cores together, that writing it took. Documents of several objects are added
up. Files that OpenCASCADE finds faults in are "not valid"; those that take longer than the limit, of processor time as
well, have a line that says so.
"""

import argparse
import pathlib
import re
import resource
import signal
import subprocess
import tempfile

QUALITIES = ("light", "balanced", "fine")


def numbers(pattern, text):
    return [float(x) for x in re.findall(pattern, text)]


def used_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def export(program, document, out, quality, limit):
    """The ended program and its seconds; the program is nothing where it took longer than the limit."""
    before = used_seconds()
    command = [program, "export", document, out, "--quality", quality]
    limits = (lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))) if limit else None
    run = subprocess.run(command, capture_output=True, text=True, preexec_fn=limits)
    stopped = -run.returncode in (signal.SIGXCPU, signal.SIGKILL)
    return None if stopped else run, used_seconds() - before


def written_again(program, file, quality, folder, limit):
    """Kilobytes of a file that was read and is written again."""
    out = folder / f"b{file.suffix}"
    run, _ = export(program, file, out, quality, limit)
    if run is None:
        return "over the limit"
    return f"{out.stat().st_size / 1000:.0f}" if run.returncode == 0 else run.stderr.strip().splitlines()[0]


def line(program, document, quality, out, limit):
    name = pathlib.Path(document).stem
    run, seconds = export(program, document, out, quality, limit)
    if run is None:
        return f"| {name} | {quality} | over {limit} s | | | | | | | |"
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
    again = written_again(program, out, quality, out.parent, limit)
    return (
        f"| {name} | {quality} | {faces:.0f} | {points:.0f} | {size} | {share:.2f} | {angle:.3f} | {jump} | {again} |"
        f" {seconds:.1f} |"
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--limit", type=int, help="seconds of processor time for one file")
    parser.add_argument("--iges", action="store_true", help="IGES instead of STEP")
    parser.add_argument("program")
    parser.add_argument("documents", nargs="+")
    chosen = parser.parse_args()
    print(
        "| document | quality | faces | control points | kB | distance / tolerance | angle, degrees | jump of curvature |"
        " kB again | s |"
    )
    print("| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / ("a.igs" if chosen.iges else "a.step")
        for document in chosen.documents:
            for quality in QUALITIES:
                print(line(chosen.program, document, quality, out, chosen.limit), flush=True)


if __name__ == "__main__":
    main()
