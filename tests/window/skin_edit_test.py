"""A skin drawn in the real window: a path by points and two sections by hand, skinned both ways; a section is added where the
surface is clicked and slid along the path; the skin becomes a polyhedron, and its control mesh is exported."""

import json
import math
import os
import tempfile

from driver import Window, check, run
from skin_hands import between, choose, label, skin_mark, stroke


def in_view(window, x, y):
    left, top, width, height = window.resting_rect("view.0")
    return left + x * width, top + y * height


def arch(window, width, height):
    """Corners of a stroke over the middle of the view, from left to right."""
    middle, ground = in_view(window, 0.5, 0.6)
    return [(middle - width * math.cos(math.pi * i / 16), ground - height * math.sin(math.pi * i / 16)) for i in range(17)]


def draw(window, output):
    window.wait_idle()
    window.key("ctrl+n")
    window.wait(lambda: window.last("document")["serial"] is not None and not window.last("vertices")["objects"], "an empty document")
    window.wait_idle()
    choose(window, "Skin", "command.skin.draw")
    window.wait_idle()
    for x, y in ((0.25, 0.62), (0.42, 0.58), (0.58, 0.5), (0.75, 0.38)):
        window.click(*in_view(window, x, y))
    window.screenshot(os.path.join(output, "skin_draw_path.png"))
    window.key("Return")
    window.wait_idle()
    stroke(window, *arch(window, 150, 170), steps=2)
    window.wait_idle()
    window.screenshot(os.path.join(output, "skin_draw_section.png"))
    window.key("Return")
    window.wait_idle()
    stroke(window, *arch(window, 190, 90), steps=2)
    window.key("Return")
    check(label(window, "Draw skin") == 1, "the skin is not one step")
    window.screenshot(os.path.join(output, "skin_drawn.png"))


def methods(window, output):
    for number, name in ((0, "smooth"), (2, "pleat")):
        window.click_on("combo.skin_method")
        window.click_on(f"choice.skin_method.{number}")
        label(window, "Method of the skin")
        check(window.last("rebuild")["error"] is None, f"{name}: {window.last('rebuild')}")
        window.screenshot(os.path.join(output, f"skin_drawn_{name}.png"))


def points_of(window):
    """Ids of the points of the curves, by their numbers."""
    return sorted(int(name.rsplit(".", 1)[1]) for name in window.last("layout")["rects"] if name.startswith("skin.limit."))


def place_marks(window):
    return [name for name in window.last("layout")["rects"] if name.startswith("skin.place.")]


def sections(window, output):
    # The tops of both arches: the surface is seen between them.
    ids = points_of(window)
    gap = max(range(1, len(ids)), key=lambda i: ids[i] - ids[i - 1])
    first, last = ids[:gap], ids[gap:]
    top = between(skin_mark(window, f"limit.{first[len(first) // 2]}"), skin_mark(window, f"limit.{last[len(last) // 2]}"))
    check(not place_marks(window), "sections at the ends can slide")
    choose(window, "Skin", "command.skin.section_here")
    window.wait_idle()
    window.move(*top)
    window.wait_idle()
    window.screenshot(os.path.join(output, "skin_section_here.png"))
    window.click(*top)
    label(window, "Add section")
    window.key("Return")
    window.wait_idle()
    marks = place_marks(window)
    check(len(marks) == 1, f"places of sections: {marks}")
    x, y = window.center(marks[0])
    end = window.center("skin.path.3")
    window.drag((x, y), between((x, y), end, 0.25), before_release=lambda: window.screenshot(os.path.join(output, "skin_slide.png")))
    position = label(window, "Slide section")
    now = window.center(marks[0])
    check(math.dist(now, end) < 0.9 * math.dist((x, y), end), f"the section went from {(x, y)} to {now}, towards {end}")
    window.key("ctrl+z")
    label(window, "Add section")
    check(math.dist(window.center(marks[0]), (x, y)) < 3, "undo leaves the section elsewhere")
    window.key("ctrl+y")
    check(label(window, "Slide section") == position, "redo")


def convert(window, output):
    since = window.count("converted")
    choose(window, "Skin", "command.skin.to_polyhedron")
    window.wait_event("converted", since)
    label(window, "Convert to polyhedron")
    window.screenshot(os.path.join(output, "skin_converted.png"))
    window.key("ctrl+z")
    label(window, "Slide section")


def export(window, path):
    since = window.count("control_exported")
    choose(window, "File", "command.file.export_control")
    window.type_path(path)
    window.wait_event("control_exported", since)
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    vertices = sum(line.startswith("v ") for line in lines)
    faces = [line.split()[1:] for line in lines if line.startswith("f ")]
    check(vertices > 12 and len(faces) > 6, f"{vertices} vertices, {len(faces)} faces")
    check(all(1 <= int(corner.split("/")[0]) <= vertices for face in faces for corner in face), "a face has no such vertex")


def session(program, source, output):
    # Not from the start page: the pictures of all samples take a while.
    cube = os.path.join(source, "assets", "samples", "cube.hariko")
    with tempfile.TemporaryDirectory(prefix="hariko-skin-") as folder:
        path = os.path.join(folder, "drawn.hariko")
        window = Window(program, cube, size=(1280, 800))
        try:
            draw(window, output)
            methods(window, output)
            sections(window, output)
            convert(window, output)
            export(window, os.path.join(folder, "control.obj"))
            window.wait_idle()
            window.key("ctrl+s")
            window.type_path(path)
            window.wait(lambda: os.path.exists(path), "the file")
            window.wait_idle()
            with open(path, encoding="utf-8") as file:
                saved = json.load(file)["objects"][0]["source"]
            check(saved["kind"] == "skin" and len(saved["sections"]) == 3 and len(saved["path"]["points"]) == 4, f"saved: {saved}")
            check(window.quit() == 0, "the program failed at the end")
        finally:
            window.close()
        window = Window(program, path, size=(1280, 800))
        try:
            window.wait_idle()
            check(len(place_marks(window)) == 1, "the section in the middle is not shown")
            check(window.quit() == 0, "the program failed at the end")
        finally:
            window.close()


run(session)
