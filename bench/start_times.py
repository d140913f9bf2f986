#!/usr/bin/env python3
"""Processor time from the start of the program to the first complete frame of its start page, on a display of its own
without a graphics card: user and system time, all threads. Needs Xvfb, xdotool and ImageMagick; on a machine that does
nothing else.

    python3 bench/start_times.py build/release/app/hariko [RUNS]

The first start has an empty home: no cache of shaders. Later ones find what the first one left. Beside it, where they
are installed: Blender and FreeCAD, until their windows do not change any more, and Hariko in the same way."""

import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

SIZE = "1280x800x24"
REST = 2.0  # seconds without a change after which a window counts as complete


class Display:
    """An X server, for as long as it is needed."""

    def __enter__(self):
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", SIZE, "-nolisten", "tcp"], pass_fds=[write_end],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            self.name = ":" + pipe.readline().strip()
        return self

    def __exit__(self, *_):
        self.server.kill()
        self.server.wait()

    def picture(self):
        return subprocess.run(["import", "-window", "root", "-depth", "8", "rgb:-"], stdout=subprocess.PIPE,
                              env=dict(os.environ, DISPLAY=self.name), check=True).stdout


def environment(display, home):
    return dict(os.environ, DISPLAY=display.name, HOME=home,
                **{f"XDG_{kind}_HOME": os.path.join(home, kind.lower()) for kind in ("CONFIG", "STATE", "CACHE", "DATA")})


def stop(program):
    if program.poll() is None:
        program.kill()
    program.wait()


def processor_seconds(pid):
    """Processor time of a process, its threads and its children that have ended, seconds."""
    with open(f"/proc/{pid}/stat", encoding="utf-8") as file:
        fields = file.read().rpartition(")")[2].split()
    return sum(int(field) for field in fields[11:15]) / os.sysconf("SC_CLK_TCK")


def by_its_log(program, home):
    """Times that Hariko's log gives of its first frame."""
    log = os.path.join(home, "log.jsonl")
    with Display() as display:
        running = subprocess.Popen([program, "--test-log", log], env=environment(display, home), cwd=home)
        try:
            end = time.monotonic() + 60
            while time.monotonic() < end and running.poll() is None:
                if os.path.exists(log):
                    with open(log, encoding="utf-8") as file:
                        for line in file:
                            if line.endswith("\n") and '"first_frame"' in line:
                                return json.loads(line)
                time.sleep(0.02)
        finally:
            stop(running)
            if os.path.exists(log):
                os.remove(log)
    sys.exit("the program drew no frame")


def by_the_screen(command, home):
    """Milliseconds until the screen rests, of any program."""
    with Display() as display:
        empty = display.picture()
        running = subprocess.Popen(command, env=environment(display, home), cwd=home, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        try:
            shown, used, changed = empty, 0.0, time.monotonic()
            while running.poll() is None and time.monotonic() < changed + (60 if shown == empty else REST):
                now = processor_seconds(running.pid)
                picture = display.picture()
                if picture != shown:
                    shown, used, changed = picture, now, time.monotonic()
                time.sleep(0.02)
            return None if shown == empty else 1000 * used
        finally:
            stop(running)


def series(runs, measure):
    """The first start of a fresh home, and the median of later ones; of `runs` homes and starts."""
    first, later = [], []
    for _ in range(runs):
        home = tempfile.mkdtemp(prefix="hariko-start-")
        try:
            first.append(measure(home))
            later.append(measure(home))
        finally:
            shutil.rmtree(home, ignore_errors=True)
    if None in first + later:
        return "shows no window"
    return (f"first start {statistics.median(first):.0f} ms ({min(first):.0f} to {max(first):.0f}), "
            f"later {statistics.median(later):.0f} ms ({min(later):.0f} to {max(later):.0f})")


def main():
    program = os.path.abspath(sys.argv[1])
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 7
    load = os.getloadavg()
    print(f"load before: {load[0]:.1f} on {os.cpu_count()} cores; processor time, medians of {runs}")

    def own(home):
        frame = by_its_log(program, home)
        if frame["pictures_missing"]:
            sys.exit(f"the first frame lacks {frame['pictures_missing']} pictures: build hariko_sample_pictures")
        return frame["cpu_ms"]

    print("Hariko, by its log:   ", series(runs, own), flush=True)
    others = (("Hariko", [program]), ("Blender", ["blender", "--factory-startup"]), ("FreeCAD", ["freecad"]))
    for name, command in others:
        if shutil.which(command[0]):
            print(f"{name + ', by the screen:':23}", series(min(runs, 3), lambda home, c=command: by_the_screen(c, home)),
                  flush=True)


main()
