"""A skin drawn in the real window: a path by points and two sections by hand, skinned both ways; sections and path are closed
and opened, rails are made and dragged; a section is added where the surface is clicked and slid along the path; the skin becomes a
polyhedron, and its control mesh is exported."""

import math
import os

from driver import check, run
from skin_hands import between, choose, empty_document, label, names, save, session_and_again, skin_mark, stroke


def in_view(window, x, y):
    left, top, width, height = window.resting_rect("view.0")
    return left + x * width, top + y * height


def arch(window, width, height):
    """Corners of a stroke over the middle of the view, from left to right."""
    middle, ground = in_view(window, 0.5, 0.6)
    return [(middle - width * math.cos(math.pi * i / 16), ground - height * math.sin(math.pi * i / 16)) for i in range(17)]


def draw(window, output):
    empty_document(window)
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


def sound(window, what):
    check(window.last("rebuild")["error"] is None, f"{what}: {window.last('rebuild')}")


def closed(window, output):
    """Sections and path are closed and opened, by command and in the panel."""
    position = window.last("document")["position"]
    check(not names(window, "combo.skin_caps"), "open sections have ends to close")
    choose(window, "Skin", "command.skin.close_sections")
    check(label(window, "Close or open sections") == position + 1, "closing the sections is not one step")
    sound(window, "a tube")
    window.rect("combo.skin_caps")
    window.screenshot(os.path.join(output, "skin_tube.png"))
    window.click_on("check.skin_closed")
    window.wait(lambda: window.last("document")["position"] == position + 2, "the step that opens the sections")
    window.wait_idle()
    check(not names(window, "combo.skin_caps"), "the sections are still closed")
    check(not names(window, "skin.place."), "sections at the ends can slide")
    choose(window, "Skin", "command.skin.close_path")
    check(label(window, "Close or open path") == position + 3, "closing the path is not one step")
    sound(window, "a closed path")
    check(len(names(window, "skin.place.")) == 2, "on a closed path every section slides")
    window.screenshot(os.path.join(output, "skin_ring.png"))
    choose(window, "Skin", "command.skin.close_path")
    window.wait(lambda: window.last("document")["position"] == position + 4, "the step that opens the path")
    window.wait_idle()
    check(not names(window, "skin.place."), "the path is still closed")
    # Opening a path keeps the part between the sections only, so all goes back as it was drawn.
    for back in (3, 2, 1, 0):
        window.key("ctrl+z")
        window.wait(lambda: window.last("document")["position"] == position + back, "undo")
        window.wait_idle()
    sound(window, "as it was drawn")


def rails(window, output):
    """Two rails are made of the skin, and can be dragged; a point of the path becomes a corner."""
    position = window.last("document")["position"]
    check(not names(window, "skin.rail."), "there is a second rail")
    window.click_on("combo.skin_frame")
    window.click_on("choice.skin_frame.3")
    check(label(window, "Frames of the skin") == position + 1, "the rails are not one step")
    sound(window, "two rails")
    check(len(names(window, "skin.rail.")) == 4, f"rails: {names(window, 'skin.')}")
    x, y = skin_mark(window, "rail.1")
    window.drag((x, y), (x + 12, y - 30), before_release=lambda: window.screenshot(os.path.join(output, "skin_rails.png")))
    check(label(window, "Move path") == position + 2, "the drag of the rail is not one step")
    sound(window, "a bent rail")
    window.click(*skin_mark(window, "path.1"))
    window.click_on("check.skin_path_sharp")
    check(label(window, "Corner") == position + 3, "the corner is not one step")
    sound(window, "a corner in a rail")
    for back in (2, 1, 0):
        window.key("ctrl+z")
        window.wait(lambda: window.last("document")["position"] == position + back, "undo")
        window.wait_idle()
    check(not names(window, "skin.rail."), "undo leaves the rail")


def points_of(window):
    """Ids of the points of the curves, by their numbers."""
    return sorted(int(name.rsplit(".", 1)[1]) for name in names(window, "skin.limit."))


def place_marks(window):
    return names(window, "skin.place.")


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
    since = window.count("section_added")
    window.click(*top)
    window.wait_event("section_added", since)
    label(window, "Add section")
    sound(window, "with one more section")
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
    def work(window, path):
        draw(window, output)
        methods(window, output)
        closed(window, output)
        rails(window, output)
        sections(window, output)
        convert(window, output)
        export(window, os.path.join(os.path.dirname(path), "control.obj"))
        saved = save(window, path)
        check(len(saved["sections"]) == 3 and len(saved["path"]["points"]) == 4, f"saved: {saved}")

    def again(window, _):
        window.wait_idle()
        check(len(place_marks(window)) == 1, "the section in the middle is not shown")

    session_and_again(program, source, work, again)


run(session)
