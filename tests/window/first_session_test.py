"""A designer's first session, by mouse and keys alone: start page, box, extrude, move, tension, crease, zebra, save,
export; then everything is undone and done again, and the document is what was saved, byte for byte."""

import json
import os
import tempfile

from driver import Window, check, run


def saved_as(window, path):
    """Contents of the file then."""
    window.save_as(path)
    with open(path, "rb") as file:
        return file.read()


def click_top_face(window):
    """Points at the middle of the face on top, seen from above."""
    pixels = window.vertices()
    near = sorted(pixels.values(), key=lambda pixel: pixel[2])[:4]
    window.click(sum(p[0] for p in near) / 4, sum(p[1] for p in near) / 4)


def session(program, source, output):
    del source
    with tempfile.TemporaryDirectory() as folder:
        with Window(program) as window:
            window.click_on("start.polyhedron")
            window.wait(lambda: window.last("vertices") is not None, "the box")
            window.wait_idle()
            first = saved_as(window, os.path.join(folder, "first.hariko"))
            position = window.position()

            window.key("KP_7")  # from above: the top face is under the middle
            window.wait_idle()
            window.key("3")
            click_top_face(window)
            window.selected("1 face")
            window.key("e")
            window.move(*window.center("viewport"))
            window.keys("5", "Return")
            position = window.step(position=position + 1)
            check(len(window.vertices()) == 12, "extruding made no new vertices")

            window.keys("g", "x", "3", "Return")
            position = window.step(position=position + 1)

            window.key("KP_0")
            window.wait_idle()
            window.key("Home")  # the extruded end is out of sight
            window.wait_idle()
            window.key("1")
            vertex = window.nearest_vertex()
            window.click(*window.vertex(vertex)[:2])
            window.selected("1 vertex")
            window.keys("t", "4", "Return")
            position = window.step(position=position + 1)

            window.key("ctrl+shift+a")  # the gizmo at the vertex would cover the edge
            window.selected("nothing selected")
            window.key("2")
            a = window.vertex(vertex)
            others = [p for v, p in window.vertices().items() if v != vertex]
            b = min(others, key=lambda p: p[2] + 1e-3 * abs(p[0] - a[0]))
            window.click((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
            window.wait(lambda: window.selection().endswith("edge"), "the selected edge")
            window.key("c")
            position = window.step(position=position + 1)
            window.screenshot(os.path.join(output, "first_session_model.png"))

            window.run_by_name("zebra")
            window.step(position=position)  # zebra is a way of looking and no step
            window.screenshot(os.path.join(output, "first_session_zebra.png"))

            last = saved_as(window, os.path.join(folder, "last.hariko"))
            check(last != first, "the session changed nothing")
            exported = os.path.join(folder, "last.obj")
            window.key("ctrl+e")
            window.rect("export.distance")
            window.wait_event("export_counted", 0)  # the number of triangles, before they are written
            window.wait_idle()
            window.screenshot(os.path.join(output, "first_session_export.png"))
            window.type_path(exported)
            window.wait_event("exported", 0)
            check(os.path.getsize(exported) > 1000, "the export is empty")

            window.undo(position)
            window.redo(position)
            again = saved_as(window, os.path.join(folder, "again.hariko"))
            check(again == last, "undoing and redoing everything gave another document")
            check(json.loads(again)["objects"], "the document is empty")
            check(window.quit() == 0, "the program did not end well")


run(session)
