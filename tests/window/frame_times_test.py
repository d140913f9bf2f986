"""The overlay of frame times in the real window: it reports both shares while a vertex of a model of a thousand faces is
dragged."""

import math
import os
import tempfile
import time

from driver import Window, check, run


def torus(path, around=40, across=25):
    with open(path, "w", encoding="ascii") as file:
        for i in range(around):
            for j in range(across):
                a, b = 2 * math.pi * i / around, 2 * math.pi * j / across
                r = 3 + math.cos(b)
                file.write(f"v {r * math.cos(a):.6f} {r * math.sin(a):.6f} {math.sin(b):.6f}\n")
        for i in range(around):
            for j in range(across):
                k, m = (i + 1) % around, (j + 1) % across
                file.write("f " + " ".join(str(p * across + q + 1) for p, q in ((i, j), (k, j), (k, m), (i, m))) + "\n")


def frame_times(program, folder, output):
    model = os.path.join(folder, "torus1000.obj")
    torus(model)
    with Window(program, model) as window:
        window.key("F12")
        window.wait_idle()
        x, y, w, h = window.rect("view.0")
        window.screenshot(os.path.join(output, "frame_times_torus.png"))
        # Places of the vertices of so many are not in the log: look for one.
        found = False
        for step in range(24):  # over the part of the ring that is in front
            at = x + w / 2 + 5 * step, y + h / 2 + 90 + 4 * (step % 3)
            window.move(*at)
            before = window.count("document")
            window.press()
            window.move(at[0] + 12, at[1] - 10)
            patience = time.monotonic() + 1  # a frame may take long; where there is no vertex nothing comes
            while not found and time.monotonic() < patience:
                time.sleep(0.05)
                found = window.count("document") > before and window.last("document")["gesture"]
            if found:
                break
            window.release()
        check(found, "no vertex of the torus could be dragged")
        for step in range(60):
            window.xdotool("mousemove", str(round(x + w / 2 + 60 * math.sin(step / 8))), str(round(y + h / 2 - step)))
            time.sleep(0.016)
        window.screenshot(os.path.join(output, "frame_times.png"))
        window.release()
        window.wait(lambda: not window.last("document")["gesture"], "the end of the drag")
        window.wait_idle()
        times = window.last("frame_times")
        check(times and times["frames"] > 20, f"frame times were not measured: {times}")
        for name in ("ours", "renderer", "total", "latency"):
            check(0 < times[name][0] <= times[name][1], f"{name}: {times[name]}")
        print("frame times in ms (p50, p95) of a thousand faces:",
              {name: [round(v, 2) for v in times[name]] for name in ("ours", "renderer", "total", "latency")})


def session(program, source, output):
    del source
    with tempfile.TemporaryDirectory() as folder:
        frame_times(program, folder, output)


run(session)
