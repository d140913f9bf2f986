"""A designer's first session, by mouse and keys alone: start page, box, extrude, move, tension, crease, zebra, save,
export; then everything is undone and done again, and the document is what was saved, byte for byte."""

import json
import os
import tempfile

from driver import Window, check, run


def steps(window):
    return window.last("document")["position"]


def wait_step(window, position, what):
    window.wait(lambda: steps(window) == position and not window.last("document")["gesture"], "the step: " + what)
    window.wait_idle()


def save_as(window, path):
    saved = window.count("saved")
    window.key("ctrl+shift+s")
    window.type_path(path)
    window.wait_event("saved", saved)
    window.wait_idle()
    with open(path, "rb") as file:
        return file.read()


def center(window):
    x, y, width, height = window.rect("viewport")
    return x + width // 2, y + height // 2


def click_top_face(window):
    """Points at the middle of the face on top, seen from above."""
    pixels = window.last("vertices")["objects"]["1"]
    near = sorted(pixels.values(), key=lambda pixel: pixel[2])[:4]
    window.click(sum(p[0] for p in near) / 4, sum(p[1] for p in near) / 4)


def session(program, source, output):
    del source
    with tempfile.TemporaryDirectory() as folder:
        window = Window(program)
        try:
            window.click_on("start.polyhedron")
            window.wait(lambda: window.last("vertices") is not None, "the box")
            window.wait_idle()
            first = save_as(window, os.path.join(folder, "first.hariko"))
            position = steps(window)

            window.key("KP_7")  # from above: the top face is under the middle
            window.wait_idle()
            window.key("3")
            click_top_face(window)
            window.wait(lambda: window.last("document")["selection"] == "1 face", "the selected face")
            window.key("e")
            window.move(*center(window))
            window.key("5")
            window.key("Return")
            position += 1
            wait_step(window, position, "extrude")
            check(len(window.last("vertices")["objects"]["1"]) == 12, "extruding made no new vertices")

            window.key("g")
            window.key("x")
            window.key("3")
            window.key("Return")
            position += 1
            wait_step(window, position, "move")

            window.key("KP_0")
            window.wait_idle()
            window.key("Home")  # the extruded end is out of sight
            window.wait_idle()
            window.key("1")
            vertex = window.nearest_vertex()
            window.click(*window.vertex(vertex)[:2])
            window.wait(lambda: window.last("document")["selection"] == "1 vertex", "the selected vertex")
            window.key("t")
            window.key("4")
            window.key("Return")
            position += 1
            wait_step(window, position, "tension")

            window.key("ctrl+shift+a")  # the gizmo at the vertex would cover the edge
            window.wait(lambda: window.last("document")["selection"] == "nothing selected", "nothing selected")
            window.key("2")
            a = window.vertex(vertex)
            others = [p for v, p in window.last("vertices")["objects"]["1"].items() if v != vertex]
            b = min(others, key=lambda p: p[2] + 1e-3 * abs(p[0] - a[0]))
            window.click((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
            window.wait(lambda: window.last("document")["selection"].endswith("edge"), "the selected edge")
            window.key("c")
            position += 1
            wait_step(window, position, "crease")
            window.screenshot(os.path.join(output, "first_session_model.png"))

            window.key("F3")
            window.type("zebra")
            window.key("Return")
            wait_step(window, position, "zebra, which is a way of looking and no step")
            window.screenshot(os.path.join(output, "first_session_zebra.png"))

            last = save_as(window, os.path.join(folder, "last.hariko"))
            check(last != first, "the session changed nothing")
            exported = os.path.join(folder, "last.obj")
            window.key("ctrl+e")
            window.rect("export.distance")
            window.wait_event("export_counted", 0)  # how many triangles there will be, before they are written
            window.wait_idle()
            window.screenshot(os.path.join(output, "first_session_export.png"))
            window.type_path(exported)
            window.wait_event("exported", 0)
            check(os.path.getsize(exported) > 1000, "the export is empty")

            while steps(window) > 0:
                before = steps(window)
                window.key("ctrl+z")
                window.wait(lambda before=before: steps(window) < before, "undo")
            while steps(window) < position:
                before = steps(window)
                window.key("ctrl+shift+z")
                window.wait(lambda before=before: steps(window) > before, "redo")
            again = save_as(window, os.path.join(folder, "again.hariko"))
            check(again == last, "undoing and redoing everything gave another document")
            check(json.loads(again)["objects"], "the document is empty")
            check(window.quit() == 0, "the program did not end well")
        finally:
            window.close()


run(session)
