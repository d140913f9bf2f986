"""Several views in the real window: a drag in each of four moves a vertex in its plane, the axis gizmo looks along
axes and orbits, titles maximise, the probe reads the surface, the overlay of frame times reports both shares while
a vertex of a model of a thousand faces is dragged."""

import json
import math
import os
import tempfile
import time

from driver import Window, check, run


def drag_in_each_view(window, output):
    window.key("ctrl+alt+q")
    window.wait_idle()
    window.screenshot(os.path.join(output, "views_four.png"))
    left, top, width, height = window.rect("viewport")
    rects = [window.rect(f"view.{i}") for i in range(4)]
    check(sum(w * h for _, _, w, h in rects) > 0.97 * width * height, "the views do not fill the viewport")
    for number, view in enumerate((1, 2, 3, 0), start=1):
        window.move(*window.center(f"view.{view}"))
        x, y, w, h = window.rect(f"view.{view}")

        def nearest(left=x, top=y, right=x + w, bottom=y + h):
            vx, vy, _ = window.vertex(window.nearest_vertex())
            return left <= vx < right and top <= vy < bottom
        window.wait(nearest, f"view {view} to become the active one")
        window.wait_idle()
        vertex = window.nearest_vertex()
        vx, vy, _ = window.vertex(vertex)
        window.drag((vx, vy), (vx + 24, vy - 16))
        window.wait(lambda: window.last("document")["position"] == number, f"the step of the drag in view {view}")
        window.wait_idle()
        now = window.vertex(vertex)
        check(abs(now[0] - vx - 24) < 2 and abs(now[1] - vy + 16) < 2, f"view {view}: the vertex is at {now}")


def splitter_and_titles(window):
    x, y = window.center("splitter.middle")
    window.drag((x, y), (x - 100, y + 60))
    window.wait_idle()
    moved = window.center("splitter.middle")
    check(abs(moved[0] - x + 100) <= 2 and abs(moved[1] - y - 60) <= 2, f"the splitter went to {moved}")
    tx, ty = window.center("view.2.title")
    window.move(tx, ty)
    window.xdotool("click", "--repeat", "2", "--delay", "90", "1")
    window.wait(lambda: "view.0" not in window.last("layout")["rects"], "the maximised view")
    check(window.rect("view.2") == window.rect("viewport"), "the maximised view does not fill the viewport")
    window.wait_idle()
    window.key("ctrl+space")
    window.rect("view.0")
    window.wait_idle()


def gizmo(window, output):
    window.move(*window.center("view.0"))
    window.wait_idle()
    window.screenshot(os.path.join(output, "views_gizmo.png"))
    window.click(*window.center("view.0.axes+z"))
    time.sleep(0.4)
    window.wait_idle()
    # From the top x points to the right and y upwards.
    gx, gy = window.center("view.0.axes+z")
    xx, xy = window.center("view.0.axes+x")
    yx, yy = window.center("view.0.axes+y")
    check(xx - gx > 20 and abs(xy - gy) <= 2, f"x points to {xx - gx}, {xy - gy}")
    check(gy - yy > 20 and abs(yx - gx) <= 2, f"y points to {yx - gx}, {yy - gy}")
    window.drag((gx + 8, gy + 8), (gx + 60, gy + 40))
    window.wait_idle()
    turned = window.center("view.0.axes+x")
    check(turned[1] != xy, "dragging the gizmo did not turn the view")


def probe(window, output):
    window.key("ctrl+alt+q")
    window.wait_idle()
    x, y = window.center("view.0")
    window.move(x + 20, y - 30)
    window.rect("probe")
    window.wait_idle()
    window.key("ctrl+alt+p")
    window.rect("probe.kept")
    window.wait_idle()
    window.screenshot(os.path.join(output, "views_probe.png"))


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
    window = Window(program, model)
    try:
        window.key("F12")
        window.wait_idle()
        x, y, w, h = window.rect("view.0")
        window.screenshot(os.path.join(output, "views_torus.png"))
        # Where the vertices of so many are is not in the log: look for one.
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
        window.screenshot(os.path.join(output, "views_frame_times.png"))
        window.release()
        window.wait(lambda: not window.last("document")["gesture"], "the end of the drag")
        window.wait_idle()
        times = window.last("frame_times")
        check(times and times["frames"] > 20, f"frame times were not measured: {times}")
        for name in ("ours", "renderer", "total", "latency"):
            check(0 < times[name][0] <= times[name][1], f"{name}: {times[name]}")
        print("frame times in ms (p50, p95) of a thousand faces:",
              {name: [round(v, 2) for v in times[name]] for name in ("ours", "renderer", "total", "latency")})
    finally:
        window.close()


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(source, "assets", "samples", "fig2.hariko"), encoding="utf-8") as file:
            document = json.load(file)
        document["objects"][0].setdefault("display", {})["map"] = "mean"
        curved = os.path.join(folder, "curved.hariko")
        with open(curved, "w", encoding="utf-8") as file:
            json.dump(document, file)
        window = Window(program, curved)
        try:
            drag_in_each_view(window, output)
            splitter_and_titles(window)
            gizmo(window, output)
            probe(window, output)
        finally:
            window.close()
        frame_times(program, folder, output)


run(session)
