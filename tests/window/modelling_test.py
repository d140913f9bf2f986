"""A vertex under the real pointer: its surface follows while the button is down, one step comes of it, and Esc in the
middle of a drag restores it; the saved file is opened again."""

import json
import os
import tempfile

from driver import Window, check, run


def drag(window, vertex):
    x, y, _ = window.vertex(vertex)
    drags = window.count("rebuild", quality="drag")
    window.drag_vertex(vertex, (60, 40), before_release=lambda: window.wait_event("rebuild", drags + 1, quality="drag"))
    window.step("Move vertex", 1)
    check(window.last("rebuild")["quality"] == "final", "the last surface is not final")
    moved = window.vertex(vertex)
    check(abs(moved[0] - x - 60) < 2 and abs(moved[1] - y - 40) < 2, f"the vertex is at {moved}, not at the pointer")
    return moved


def give_up(window, vertex, moved):
    window.move(moved[0], moved[1])
    window.press()
    window.move(moved[0] - 30, moved[1])
    window.move(moved[0] - 60, moved[1])
    window.wait(lambda: window.last("document")["gesture"], "the gesture")
    window.key("Escape")
    window.release()
    window.wait_idle()
    check(window.position() == 1, "a cancelled drag made a step")
    check(window.vertex(vertex) == moved, "a cancelled drag left the vertex elsewhere")


def session(program, source, output):
    del output
    sample = os.path.join(source, "assets", "samples", "fig2.hariko")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "a.hariko")
        with Window(program, sample) as window:
            vertex = window.nearest_vertex()
            give_up(window, vertex, drag(window, vertex))
            saved = window.saved(path)
            check(not window.last("document")["dirty"], "the saved document counts as edited")
            check(window.quit() == 0, "the program did not end well")
        with open(sample, encoding="utf-8") as file:
            before = json.load(file)["objects"][0]["source"]["vertices"]
        after = saved["objects"][0]["source"]["vertices"]
        changed = [a[0] for a, b in zip(after, before) if a != b]
        check(changed == [int(vertex)], f"other vertices than {vertex} moved: {changed}")
        with Window(program) as window:
            window.type_path(path, "ctrl+o")
            window.until_opened()
            check(window.position() == 0, "an opened document has steps")
            check(window.quit() == 0, "the program did not end well")


run(session)
