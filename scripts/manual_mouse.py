#!/usr/bin/env python3
"""Models the mouse of docs/manual/a-mouse-over-pictures.md and takes its pictures with the real window.

    python3 scripts/manual_mouse.py build/release/app/hariko [picture ...]
    python3 scripts/manual_mouse.py build/release/app/hariko --check    models and exports it, without a window

Both drawings are made here, the steps of the page are those of a script (hariko run). Needs what manual_windows.py needs."""

import json
import math
import os
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
PICTURES = os.path.join(ROOT, "docs", "pictures")
sys.path.insert(0, os.path.join(ROOT, "tests", "window"))
sys.dont_write_bytecode = True

PIXELS_PER_MILLIMETRE = 10
# Outlines of the drawings in millimetres: from the side x and z, from above x and y of one half.
SIDE = [(-58.5, 0), (-56, 6), (-52, 15), (-46.5, 21.5), (-36, 30), (-25, 36), (-14, 39), (-4, 39.5), (7, 38),
        (18, 34), (29, 28), (40, 20.5), (48, 13), (54, 6.5), (59, 0)]
ABOVE = [(-59, 0), (-58.5, 10), (-57, 18), (-53, 24), (-44, 28), (-32, 30.5), (-18, 32), (0, 32.7), (18, 32),
         (32, 30), (44, 27), (53, 23), (57, 17), (58.5, 9), (59, 0)]


def step(command_name, **arguments):
    return {"command": command_name, "arguments": arguments}


def move(low, high, by):
    """Moves the vertices in a box, as a drag over them and G do."""
    return [step("select.vertices", **{"from": low, "to": high}), step("transform.move", by=by)]


def scale(low, high, factor):
    """The same, narrower."""
    return [step("select.vertices", **{"from": low, "to": high}),
            step("transform.scale", factors=[1, factor, 1], about=[0, 0, 0])]


BOX = [step("file.new", unit="mm"),
       step("add.box", width=106, depth=64, height=39, segments_x=3, segments_y=2, at=[0, 0, 19.5], name="Mouse")]
UNDERSIDE = [step("select.faces", **{"object": "Mouse", "from": [-60, -40, -1], "to": [60, 40, 1]}),
             step("select.boundary"), step("shape.crease")]
FROM_THE_SIDE = (move([52, -40, 38], [54, 40, 40], [-6, 0, -26]) + move([17, -40, 38], [18, 40, 40], [0, 0, -6]) +
                 move([-54, -40, 38], [-52, 40, 40], [5, 0, -18]))
FROM_ABOVE = (scale([46, -40, -1], [54, 40, 40], 0.72) + scale([-54, -40, -1], [-46, 40, 40], 0.75) +
              move([-54, -40, 5], [54, -1, 40], [0, 5, -5]) + move([-54, 1, 5], [54, 40, 40], [0, -5, -5]) +
              move([52, -1, -1], [54, 1, 1], [6, 0, 0]) + move([-54, -1, -1], [-52, 1, 1], [-6, 0, 0]))
MENDED = move([-18, -40, 5], [18, -1, 40], [0, 4, 0]) + move([-18, 1, 5], [18, 40, 40], [0, -4, 0])


def run(program, steps, path):
    """A document that a script makes."""
    text = json.dumps({"format": "hariko-script", "version": 1,
                       "steps": steps + [step("select.objects", names=["Mouse"]), step("file.save", path=path)]})
    subprocess.run([program, "run", "-"], input=text, text=True, check=True, timeout=300)


def smooth(points):
    """A path of SVG through points, with tangents along their neighbours."""
    out = "M {:.1f},{:.1f}".format(*points[0])
    for i in range(len(points) - 1):
        before, a, b, after = points[max(i - 1, 0)], points[i], points[i + 1], points[min(i + 2, len(points) - 1)]
        out += " C {:.1f},{:.1f} {:.1f},{:.1f} {:.1f},{:.1f}".format(
            a[0] + (b[0] - before[0]) / 6, a[1] + (b[1] - before[1]) / 6,
            b[0] - (after[0] - a[0]) / 6, b[1] - (after[1] - a[1]) / 6, *b)
    return out


def draw(path, size, middle, outline, lines):
    """A drawing of so many millimetres, with a point of the model in its middle."""
    pixels = [PIXELS_PER_MILLIMETRE * side for side in size]

    def on_paper(point):
        return (pixels[0] / 2 + PIXELS_PER_MILLIMETRE * (point[0] - middle[0]),
                pixels[1] / 2 - PIXELS_PER_MILLIMETRE * (point[1] - middle[1]))

    commands = ["-fill", "none", "-stroke", "#c9c2b2", "-strokewidth", "2"]
    for a, b in lines:
        commands += ["-draw", "line {:.1f},{:.1f} {:.1f},{:.1f}".format(*on_paper(a), *on_paper(b))]
    commands += ["-stroke", "#2b4a66", "-strokewidth", "7", "-draw",
                 "path '{} Z'".format(smooth([on_paper(p) for p in outline]))]
    subprocess.run(["convert", "-size", "{}x{}".format(*pixels), "xc:#f6f3ea", *commands, path], check=True, timeout=60)
    return pixels


def add_drawings(document, folder):
    """Draws both pictures, and puts them behind the model."""
    ends = [((x, -60), (x, 60)) for x in (-59, 59)]
    around = ABOVE + [(x, -y) for x, y in reversed(ABOVE[:-1])]
    quarter = [math.sqrt(0.5), math.sqrt(0.5), 0, 0]  # upright, facing the front
    for name, only_from, size, middle, rotation, outline, lines in (
            ("side", "front", [150, 60], (0, 20), quarter, SIDE, ends + [((-80, 0), (80, 0))]),
            ("above", "top", [150, 90], (0, 0), [1, 0, 0, 0], around,
             ends + [((-80, 0), (80, 0))])):
        pixels = draw(os.path.join(folder, name + ".png"), size, middle, outline, lines)
        height = [0, 0, middle[1]] if only_from == "front" else [0, 0, 0]
        # Before the mouse, which is the active object then.
        document["objects"].insert(len(document["objects"]) - 1, {
            "id": document["next_object_id"], "name": name.capitalize(), "visible": True, "locked": True,
            "transform": {"rotation": rotation, "scale": 1, "translation": height},
            "display": document["objects"][-1]["display"],
            "source": {"kind": "picture", "path": name + ".png", "pixels": pixels, "width": size[0], "layer": "behind",
                       "opacity": 0.8, "only_from": only_from}})
        document["next_object_id"] += 1


def add_dimensions(document):
    """The length along the underside, and the height."""
    mouse = document["objects"][-1]
    at = {v[0]: v[1:] for v in mouse["source"]["vertices"]}
    ends = [min(at, key=lambda v: at[v][0]), max(at, key=lambda v: at[v][0])]
    top = max((v for v in at if at[v][1] == 0), key=lambda v: at[v][2])
    below = min((v for v in at if at[v][1] == 0), key=lambda v: (at[v][2], abs(at[v][0] - at[top][0])))
    document["dimensions"] = [
        {"id": number, "kind": "distance", "anchors": [{"object": mouse["id"], "vertex": v} for v in pair],
         "label": label}
        for number, (pair, label) in enumerate((((ends[0], ends[1]), [0, 0, -8]), ((below, top), [0, 0, 0])))]


def mouse(program, folder, steps, drawings=True, dimensions=False):
    path = os.path.join(folder, "mouse.hariko")
    run(program, steps, path)
    with open(path, encoding="utf-8") as file:
        document = json.load(file)
    if drawings:
        add_drawings(document, folder)
    if dimensions:
        add_dimensions(document)
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document, file)
    return path


def check(program):
    """What the page promises: it opens, its draft is enough, and STEP keeps its volume."""
    def volume(path):
        done = subprocess.run([program, "info", path], capture_output=True, text=True, check=True, timeout=300)
        return sum(float(line.split()[1]) for line in done.stdout.splitlines()
                   if line.startswith("volume") and line.split()[1] != "-")

    with tempfile.TemporaryDirectory() as folder:
        path = mouse(program, folder, BOX + UNDERSIDE + FROM_THE_SIDE + FROM_ABOVE + MENDED, dimensions=True)
        step_file = os.path.join(folder, "mouse.step")
        subprocess.run([program, "export", path, step_file, "--quality", "light"], check=True, timeout=600)
        before, after = volume(path), volume(step_file)
        print("volume", before, "in STEP", after)
        assert abs(after - before) < 1e-3 * before


# What is done in the window before a picture is taken.


def command(window, name):
    window.key("ctrl+shift+p")
    window.rect("palette.input")
    window.type(name)
    window.wait_idle()
    window.key("Return")
    window.wait_idle()


def four_views(window):
    window.key("ctrl+alt+q")
    window.wait_idle()


def from_the_side(window):
    window.key("KP_1")
    window.wait_idle()
    window.key("1")
    window.wait_idle()


def draft(window):
    command(window, "Draft angle")
    window.wait_idle()


def to_step(window):
    command(window, "Export for CAD")
    window.wait_event("export_counted", 0)
    window.wait_idle()


SHAPED = BOX + UNDERSIDE + FROM_THE_SIDE + FROM_ABOVE
# Picture -> (steps of the model, what is done in the window, whether it has drawings, and dimensions)
TAKEN = {
    "manual_mouse_box": (BOX + UNDERSIDE, four_views, True, False),
    "manual_mouse_side": (BOX + UNDERSIDE + FROM_THE_SIDE, from_the_side, True, False),
    "manual_mouse_shaped": (SHAPED, four_views, True, True),
    "manual_mouse_draft": (SHAPED, draft, False, False),
    "manual_mouse_step": (SHAPED + MENDED, to_step, False, False),
}


def take(program, name):
    from driver import Window  # beside the tests of the window
    steps, action, drawings, dimensions = TAKEN[name]
    with tempfile.TemporaryDirectory() as home:
        folder = os.path.join(home, "Mouse")
        os.makedirs(folder)
        path = mouse(program, folder, steps, drawings, dimensions)
        window = Window(program, path, home=home)
        try:
            window.move(4, 796)  # off everything that answers to the pointer
            time.sleep(0.5)
            window.wait_idle()
            action(window)
            time.sleep(0.6)
            picture = os.path.join(home, "picture.png")
            window.screenshot(picture)
            subprocess.run(["convert", picture, "-resize", "1000x", "-strip", "+dither", "-colors", "224",
                            "PNG8:" + os.path.join(PICTURES, name + ".png")], check=True, timeout=120)
        finally:
            window.close()


def main():
    program = os.path.abspath(sys.argv[1])
    if sys.argv[2:] == ["--check"]:
        return check(program)
    for name in sys.argv[2:] or TAKEN:
        take(program, name)


main()
