"""A normal of an outline with 200 points in the fill is dragged: the surface follows every step, before the button is
released, and lies where it was after an undo."""

import json
import math
import os
import statistics
import subprocess
import tempfile

from driver import Window, check, run

GIVEN = 36
SQUARES = (4.0, 2.25, 1.0)
SIZE = 25.0
STEPS = 4


def cap():
    """The ellipsoid (2, 1.5, 1) over a circle of normals 60 degrees round z, with its curvature."""
    loop = {"points": [], "normals": [], "K": []}
    for i in range(GIVEN):
        turn, polar = 2 * math.pi * i / GIVEN, math.pi / 3
        normal = [math.sin(polar) * math.cos(turn), math.sin(polar) * math.sin(turn), math.cos(polar)]
        square = sum(a * n * n for a, n in zip(SQUARES, normal))
        loop["points"].append([SIZE * a * n / math.sqrt(square) for a, n in zip(SQUARES, normal)])
        loop["normals"].append(normal)
        loop["K"].append(square ** 2 / math.prod(SQUARES) / SIZE ** 2)
    return loop


def write_cap(source, path):
    with open(os.path.join(source, "assets", "samples", "ellipsoid_cap.hariko"), encoding="utf-8") as file:
        document = json.load(file)
    document["objects"][0]["source"]["loops"] = [cap()]
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document, file)


def inserted(program, path):
    said = subprocess.run([program, "info", path, "--json"], capture_output=True, text=True, check=True).stdout
    return json.loads(said)["objects"][0]["outline"]["inserted"]


def pixels(window, box):
    """What is seen in a box of the window, as bytes."""
    x, y, width, height = box
    return subprocess.run(
        ["import", "-window", window.id, "-crop", f"{width}x{height}+{x}+{y}", "+repage", "-depth", "8", "rgb:-"],
        env=window.environment, capture_output=True, check=True).stdout


def differing(a, b):
    return sum(a[i:i + 3] != b[i:i + 3] for i in range(0, len(a), 3))


def beside(window, number):
    """A box on the surface, from a point of the outline a fifth of the way to the middle of all points."""
    rects = window.last("layout")["rects"]
    places = [(x + w / 2, y + h / 2) for x, y, w, h in (rects[f"outline.point.{i}"] for i in range(GIVEN))]
    middle = [sum(place[i] for place in places) / GIVEN for i in (0, 1)]
    x, y = (round(p + (m - p) / 5) for p, m in zip(places[number], middle))
    return x - 20, y - 20, 40, 40


def leftmost(window):
    """The point furthest to the left in the view: its arrow is seen from the side, and the surface lies beside it."""
    rects = window.last("layout")["rects"]
    return min((i for i in range(GIVEN) if f"outline.normal.{i}" in rects),
               key=lambda i: rects[f"outline.point.{i}"][0])


def follow(window, output):
    """Drags step by step: each has its surface and another picture before the next one."""
    number = leftmost(window)
    box = beside(window, number)
    before = [pixels(window, box)]
    x, y = window.center(f"outline.normal.{number}")
    window.arrive(x, y)
    window.press()
    times = []
    for i in range(1, STEPS + 1):
        rebuilds, finals = window.count("rebuild"), window.count("rebuild", quality="final")
        # A first step that the program takes for a drag, and not for a click.
        window.arrive(x + 2 + i, y - 3 - 3 * i // 2)
        window.wait(lambda: window.count("rebuild") > rebuilds, f"the surface of step {i}")
        # The button is held, and a gesture is never idle: what rests is the surface of this step.
        window.wait(lambda: window.count("rebuild", quality="final") > finals, f"the final surface of step {i}")
        made = [event for event in window.events if event["event"] == "rebuild"][rebuilds:]
        check(all(event["error"] is None for event in made), f"step {i} has no surface: {made}")
        times += [event["milliseconds"] for event in made]
        before.append(pixels(window, box))
        check(differing(before[-1], before[-2]) > 20, f"the surface of step {i} looks as before")
    check(window.last("document")["position"] == 0, "the gesture made a step before its end")
    window.screenshot(os.path.join(output, "outline_drag.png"))
    window.release()
    window.wait(lambda: window.last("document")["label"] == "Turn normal", "the step")
    window.wait_idle()
    return box, before[0], times


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "cap.hariko")
        write_cap(source, path)
        sites = inserted(program, path)
        check(sites >= 200, f"only {sites} points inside")
        window = Window(program, path, size=(1280, 800))
        try:
            window.wait(lambda: window.count("rebuild", quality="final") > 0, "the surface")
            window.wait_idle()
            window.screenshot(os.path.join(output, "outline_drag_before.png"))
            box, first, times = follow(window, output)
            window.key("ctrl+z")
            window.wait(lambda: window.last("document")["position"] == 0, "the undo")
            window.key("Escape")
            x, y, width, height = window.rect("view.0")
            window.arrive(x + width - 30, y + height - 60)
            window.wait_idle()
            check(differing(pixels(window, box), first) < 20, "undo did not bring the surface back")
            print(f"{sites} points inside; milliseconds a surface while a normal is dragged: "
                  f"median {statistics.median(times):.1f}, largest {max(times):.1f}, of {len(times)}")
        finally:
            window.close()


run(session)
