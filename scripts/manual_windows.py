#!/usr/bin/env python3
"""Takes the pictures of the window in docs/manual.md and README.md with real mouse and key events.

    python3 scripts/manual_windows.py build/release/app/hariko [name ...]

Needs what the window tests need: Xvfb, xdotool and ImageMagick."""

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
from driver import Window  # noqa: E402  (beside the tests)


def sample(name):
    return os.path.join(ROOT, "assets", "samples", name + ".hariko")


def command(window, name):
    window.key("ctrl+shift+p")
    window.rect("palette.input")
    window.type(name)
    window.wait_idle()
    window.key("Return")
    window.wait_idle()


def empty_document(window):
    window.wait_idle()
    window.key("ctrl+n")
    window.wait(lambda: window.last("document")["serial"] is not None and not window.last("vertices")["objects"],
                "an empty document")
    window.wait_idle()


def stroke(window, *corners, steps=8):
    """One stroke of the left button along a polyline."""
    window.move(*corners[0])
    window.press()
    for a, b in zip(corners, corners[1:]):
        for i in range(1, steps + 1):
            window.move(a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps)
    window.release()


def between(a, b, share=0.5):
    return a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share


def capsule(a, b, radius):
    """A closed curve round two points, at about this distance."""
    angle = math.atan2(b[1] - a[1], b[0] - a[0])
    points = []
    for centre, begin in ((b, angle - math.pi / 2), (a, angle + math.pi / 2)):
        for i in range(7):
            turn = begin + math.pi * i / 6
            points.append((centre[0] + radius * math.cos(turn), centre[1] + radius * math.sin(turn)))
    return points + [points[0]]


def nothing(window):
    pass


def extrude(window):
    window.key("3")
    window.click(*[sum(window.vertex(v)[k] for v in window.last("vertices")["objects"]["1"]) /
                   len(window.last("vertices")["objects"]["1"]) for k in (0, 1)])
    window.wait_idle()
    window.key("e")
    x, y = window.center("viewport")
    window.move(x + 30, y - 20)
    window.move(x + 60, y - 45)


def cut(window):
    """A box, and where three cuts across it will lie."""
    empty_document(window)
    window.choose("Add", "command.add.box")
    window.step("Add box")
    window.click_on("field.depth")
    window.key("ctrl+a")
    window.type("180")
    window.key("Return")
    window.wait_idle()
    window.key("Home")
    window.wait_idle()
    window.key("2")
    corners = sorted(window.last("vertices")["objects"]["1"].values(), key=lambda pixel: pixel[2])[:2]
    window.arrive(sum(p[0] for p in corners) / 2, sum(p[1] for p in corners) / 2)
    window.key("ctrl+r")
    for number in (2, 3):
        window.xdotool("click", "4")
        window.wait_idle()


def four(window):
    window.key("ctrl+alt+q")
    window.wait_idle()
    window.key("alt+e")


def zebra(window):
    window.key("alt+z")


def gaussian(window):
    command(window, "Gaussian curvature")


def mean(window):
    command(window, "Mean curvature")
    window.key("alt+c")


def section(window):
    window.key("alt+s")


def palette(window):
    window.key("ctrl+shift+p")
    window.rect("palette.input")
    window.type("cre")


def local_editing(window):
    window.key("shift+o")
    x, y, _ = window.vertex(window.nearest_vertex())
    window.click(x, y)
    for key in ("r", "x", "2", "0", "Return"):
        window.key(key)
    window.wait_idle()


def attached(window):
    pixels = window.last("vertices")["objects"]["2"]
    nearest = sorted(pixels, key=lambda v: pixels[v][2])[:2]
    window.key("2")
    window.wait_idle()
    window.click(*[sum(pixels[v][k] for v in nearest) / 2 for k in (0, 1)])


def side_view(path):
    """A drawing of a mouse from its side, with the two points that its length is measured between."""
    subprocess.run(["convert", "-size", "1400x700", "xc:#f6f3ea", "-fill", "none", "-stroke", "#c9c2b2", "-strokewidth", "2",
                    "-draw", "path 'M 0,560 L 1400,560 M 160,0 L 160,700 M 1240,0 L 1240,700'",
                    "-stroke", "#2b4a66", "-strokewidth", "7",
                    "-draw", "path 'M 160,560 C 130,400 320,215 640,200 C 960,190 1190,330 1240,560 Z'",
                    "-strokewidth", "4", "-draw", "path 'M 250,330 C 420,420 560,470 760,490 L 1228,500 M 760,200 L 760,490'",
                    path], check=True, timeout=60)


def reference(window):
    """The drawing behind a box, in a view from the front, while its length is typed."""
    drawing = os.path.join(window.home, "mouse side.png")
    side_view(drawing)
    empty_document(window)
    window.key("KP_1")
    window.wait_idle()
    window.choose("File", "command.picture.add")
    window.type_path(drawing)
    window.wait_event("picture_added", 0)
    window.wait_idle()
    window.key("Home")
    window.wait_idle()
    command(window, "Scale by two points")
    # The picture fills this share of the view's width; its corners are those of the drawing.
    x, y, width, height = window.rect("view.0")
    pixel = 0.782 * width / 1400
    for across in (160, 1240):
        window.click(x + width / 2 + pixel * (across - 700), y + height / 2 + pixel * (560 - 350))
    window.type("118mm")


def export(window):
    window.key("ctrl+e")
    window.wait_event("export_counted", 0)


def triangles(window):
    def meshed(action):
        before = window.count("meshed")
        action()
        window.wait_event("meshed", before)
        window.wait_idle()

    meshed(lambda: window.key("ctrl+alt+t"))
    meshed(lambda: window.click_on("meshing.normal.on"))
    meshed(lambda: window.click_on("meshing.compare"))


def vase():
    """A file of Bezier patches: a profile of three cubics, each turned by four exact quarter circles."""
    profile = [(0, 0), (0.6, 0), (1, 0.05), (1.15, 0.5), (1.3, 0.95), (1, 1.5), (0.6, 1.9), (0.4, 2.1), (0.5, 2.4),
               (0.8, 2.6)]
    patches = []
    for quarter in range(4):
        arc = [(math.cos(math.pi / 4 * k) * far, math.sin(math.pi / 4 * k) * far, weight)
               for k, far, weight in ((2 * quarter, 1, 1), (2 * quarter + 1, math.sqrt(2), math.sqrt(0.5)),
                                      (2 * quarter + 2, 1, 1))]
        for first in (0, 3, 6):
            points = profile[first:first + 4]
            patches.append({"ctrl": [[[r * x, r * y, z] for r, z in points] for x, y, _ in arc],
                            "weights": [[weight] * 4 for _, _, weight in arc]})
    return json.dumps({"vase": patches})


def paper(window):
    window.key("ctrl+p")
    window.wait_idle()
    window.click_on("paper.unfold")
    window.wait(lambda: "pieces" in (window.last("paper") or {}), "the pages", 60)
    window.wait_idle()
    x, y = window.center("paper.piece.0")
    window.click(x, y)
    window.wait_idle()


def folding(window):
    paper(window)
    x, y, width, height = window.rect("paper.fold")
    window.drag((x + width - 6, y + height // 2), (x + width * 0.7, y + height // 2))
    window.move(4, 796)
    window.key("Home")
    window.wait_idle()


def gauss(window):
    window.click_on("menu.Outline")
    window.click_on("command.outline.sphere")
    x, y, width, height = window.resting_rect("gauss.step")
    window.click(x + width * 0.14, y + height // 2)
    window.wait_idle()
    x, y, width, height = window.rect("view.0")
    window.move(x + width * 0.52, y + height * 0.5)
    window.wait_idle()


def ring(window, share, count):
    """Places on the screen round the middle of the view, as a circle on the ground looks from above its side."""
    x, y, width, height = window.rect("view.0")
    radius = share * min(width, height) / 2
    return [(x + width / 2 + radius * math.cos(2 * math.pi * i / count),
             y + height / 2 + 0.6 * radius * math.sin(2 * math.pi * i / count)) for i in range(count)]


def outline(window):
    """A loop on the ground with tilted normals, and a hole that is drawn on its surface."""
    empty_document(window)
    for menu, command_id, label, share, count in (("Add", "command.add.outline", "Add outline", 0.6, 8),
                                                  ("Outline", "command.outline.add_loop", "Add loop", 0.16, 6)):
        window.choose(menu, command_id)
        for place in ring(window, share, count):
            window.click(*place)
        window.key("Return")
        window.step(label)
        if label == "Add outline":
            window.keys("1", "ctrl+a")
            window.enter("field.outline_tilt", "60")
            window.step("Turn 32 normals")
            window.key("Escape")
            window.wait_idle()


def skin(window):
    empty_document(window)
    window.choose("Add", "command.add.skin")
    window.step("Add skin")
    window.click_on("section.skin_more")
    window.click_on("combo.skin_mirror")
    window.click_on("choice.skin_mirror.2")
    window.step("Mirror of the skin")
    x, y = window.center("skin.limit.2")
    window.arrive(x, y)
    window.press()
    for i in range(1, 7):
        window.move(x - 2 * i, y - 8 * i)


def gestures(window):
    empty_document(window)
    window.choose("Add", "command.add.skin")
    window.step("Add skin")
    at = {i: window.center(f"skin.limit.{i}") for i in (1, 2, 3, 4, 5, 9, 10, 12)}
    window.choose("Skin", "command.skin.correspond")
    window.wait_idle()
    stroke(window, at[1], at[9])
    window.step("Join points")
    stroke(window, between(at[1], at[2]), between(at[3], at[10], 0.4), between(at[4], at[5]))
    window.step("Merge points")
    stroke(window, *capsule(at[5], at[12], 12), steps=2)
    window.step("Group points")


def in_a_row(window):
    """Five boxes; the panel shows the numbers of the step."""
    empty_document(window)
    window.choose("Add", "command.add.box")
    window.step("Add box")
    command(window, "Array in a row")
    window.click_on("field.array_count")
    window.key("ctrl+a")
    window.type("5")
    window.key("Return")
    window.wait_idle()
    window.key("Home")


def dimensions(window):
    """The length of an edge, and the angle between two."""
    window.key("Home")
    window.wait_idle()
    nearest = sorted(window.last("vertices")["objects"]["1"].values(), key=lambda pixel: pixel[2])[:3]
    for key, count in (("d", 2), ("alt+d", 3)):
        window.key(key)
        for x, y, _ in nearest[:count]:
            window.click(x, y)
            window.wait_idle()
        window.key("Escape")
        window.wait_idle()


def draft(window):
    command(window, "Draft angle")


# Picture -> (sample, text of a .json or none, what is done, settings of the interface)
WINDOWS = {
    "hariko": ("car", gaussian, {}),
    "manual_start": (None, nothing, {}),
    "manual_four": ("car", four, {}),
    "manual_extrude": ("fig2", extrude, {}),
    "manual_cut": ("cube", cut, {}),
    "manual_zebra": ("car", zebra, {}),
    "manual_array": ("cube", in_a_row, {}),
    "manual_dimensions": ("fig2", dimensions, {}),
    "manual_draft": ("car", draft, {}),
    "manual_mean": ("car", mean, {}),
    "manual_section": ("cube", section, {}),
    "manual_palette": ("fig2", palette, {}),
    "manual_keys": ("fig2", lambda window: window.key("F1"), {}),
    "manual_prefs": ("fig2", lambda window: window.key("ctrl+comma"), {}),
    "manual_japanese": ("fig2", nothing, {"language": "japanese"}),
    "manual_light": ("car", nothing, {"theme": "light"}),
    "manual_export": ("car", export, {}),
    "manual_triangles": ("fig2", triangles, {}),
    "manual_local": ("fig2", local_editing, {}),
    "manual_paper": ("fig2", paper, {}),
    "manual_folding": ("fig2", folding, {}),
    "manual_joins": ("wheel_arch", attached, {}),
    "manual_patches": (vase, nothing, {}),
    "manual_gauss": ("ellipsoid_cap", gauss, {}),
    "manual_outline": ("cube", outline, {}),
    "manual_skin": ("cube", skin, {}),
    "manual_gestures": ("cube", gestures, {}),
    "manual_reference": ("cube", reference, {}),
}


def take(program, name):
    model, action, settings = WINDOWS[name]
    with tempfile.TemporaryDirectory() as home:
        folder = os.path.join(home, "config", "hariko")
        os.makedirs(folder)
        if settings:
            with open(os.path.join(folder, "settings.json"), "w", encoding="utf-8") as file:
                json.dump(settings, file)
        files = [sample(model)] if isinstance(model, str) else []
        if callable(model):
            files = [os.path.join(home, model.__name__ + ".json")]
            with open(files[0], "w", encoding="ascii") as file:
                file.write(model())
        window = Window(program, *files, home=home)
        try:
            window.move(4, 796)  # off everything that answers to the pointer
            time.sleep(0.5)
            window.wait_idle()
            action(window)
            time.sleep(0.6)
            path = os.path.join(home, "picture.png")
            window.screenshot(path)
            subprocess.run(["convert", path, "-resize", "1000x", "-strip", "+dither", "-colors", "224",
                            "PNG8:" + os.path.join(PICTURES, name + ".png")], check=True, timeout=120)
        finally:
            window.close()


def main():
    program = os.path.abspath(sys.argv[1])
    for name in sys.argv[2:] or WINDOWS:
        take(program, name)


main()
