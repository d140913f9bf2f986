#!/usr/bin/env python3
"""Times of the frames of a drag on the sample of 1,000 faces: our own work, OpenGL, and from the pointer to the
surface. Needs Xvfb, xdotool and a build of the program; on a machine that does nothing else.

    python3 bench/drag_times.py build/release/app/hariko
"""

import math
import os
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "tests", "window"))

from driver import Window, check  # noqa: E402

MOVES = 240
LOOKS = (("shaded", None), ("zebra", "alt+z"))


def select_a_vertex(window):
    """Clicks near the middle of the view until a vertex is selected; where the pointer is then."""
    x, y, w, h = window.rect("view.0")
    for step in range(400):
        angle, radius = 0.7 * step, 3 * math.sqrt(step)
        at = x + w * 0.55 + radius * math.cos(angle), y + h * 0.45 + radius * math.sin(angle)
        window.click(*at)
        window.wait_idle()
        if window.last("document")["selection"] == "1 vertex":
            return at
    check(False, "no vertex could be selected")


def drag(window, at):
    """Moves the selected vertex by G for some seconds and takes the move back."""
    window.key("F12")
    window.key("g")
    for step in range(MOVES):
        window.xdotool("mousemove", str(round(at[0] + 60 * math.sin(step / 15))),
                       str(round(at[1] + 40 * math.sin(step / 11))))
        time.sleep(0.016)
    window.key("Return")
    window.wait_idle()
    times = window.last("frame_times")
    check(times and times["frames"] > 20, f"frame times were not measured: {times}")
    window.key("F12")
    window.key("ctrl+z")
    window.wait_idle()
    return times


def main():
    program = os.path.abspath(sys.argv[1])
    window = Window(program, os.path.join(ROOT, "assets", "samples", "knot.hariko"), size=(1280, 800))
    try:
        window.wait_event("opened", 0)
        window.wait_idle()
        at = select_a_vertex(window)
        load = os.getloadavg()
        print(f"load before: {load[0]:.1f} on {os.cpu_count()} cores; milliseconds, p50 / p95")
        for look, key in LOOKS:
            if key:
                window.key(key)
                window.wait_idle()
            times = drag(window, at)
            print(f"{look:8}", "  ".join(f"{name} {times[name][0]:.1f} / {times[name][1]:.1f}"
                                        for name in ("ours", "renderer", "total", "latency")),
                  f"  ({times['frames']} frames)", flush=True)
    finally:
        window.close()


main()
