"""Modelling in the real window: a cube is extruded, inset, bevelled, loop cut and connected with real keys and the
pointer; refusals are said and change nothing; the saved file has the elements that it should have."""

import json
import os
import tempfile

from driver import Window, check, run

# tests/golden/cube.obj
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def middle(window, vertices):
    pixels = [window.vertex(v) for v in vertices]
    return tuple(sum(p[i] for p in pixels) / len(pixels) for i in range(3))


def move_onto_edge(window, edge, away):
    """Edges are where their curves are drawn: outside of the straight line, on the side away from a point."""
    x, y, _ = middle(window, edge)
    name = f"edge {min(edge)}-{max(edge)}"
    step = 3 / max(1, ((x - away[0]) ** 2 + (y - away[1]) ** 2) ** 0.5)
    for number in range(60):
        at = (x + number * step * (x - away[0]), y + number * step * (y - away[1]))
        window.arrive(*at)
        window.wait_idle()
        if (window.last("hovered") or {"element": ""})["element"] == name:
            return at
    check(False, f"{name} is nowhere under the pointer")


def nearest_face(window):
    return min(FACES, key=lambda face: middle(window, face)[2])


def position(window, number, label):
    window.wait(lambda: window.last("document")["position"] == number and not window.last("document")["gesture"],
                f"step {number}, {label}")
    check(window.last("document")["label"] == label, f"the step is called {window.last('document')['label']}, not {label}")
    window.wait_idle()


def steps(window, output):
    face = nearest_face(window)
    x, y, _ = middle(window, face)
    window.key("3")
    window.click(x, y)
    window.wait(lambda: window.last("document")["selection"] == "1 face", "a selected face")

    # Esc in the middle of an extrusion leaves nothing behind.
    window.key("e")
    window.move(x + 40, y - 60)
    window.wait(lambda: window.last("document")["gesture"], "the extrusion")
    window.screenshot(os.path.join(output, "mesh_extrude.png"))
    window.key("Escape")
    window.wait_idle()
    check(window.last("document")["position"] == 0, "a cancelled extrusion made a step")
    check(window.last("document")["selection"] == "1 face", "the selection got lost")

    # Typed.
    window.move(x, y)
    window.key("e")
    window.type("1.5")
    window.key("Return")
    position(window, 1, "Extrude face")
    check(window.last("document")["selection"] == "1 face", "the extruded face is not selected")

    # By the pointer: to the right is more.
    window.key("i")
    window.move(x + 30, y)
    window.move(x + 60, y)
    window.wait(lambda: window.last("document")["gesture"], "the inset")
    window.screenshot(os.path.join(output, "mesh_inset.png"))
    window.click(x + 60, y)
    position(window, 2, "Inset face")

    # What cannot be done is said, and stays undone: the inset would be wider than the face.
    window.key("i")
    window.type("50")
    window.key("Return")
    window.wait_idle()
    window.screenshot(os.path.join(output, "mesh_refused.png"))
    check(window.last("document")["position"] == 2, "a refused inset made a step")
    window.key("Escape")

    window.key("2")
    window.key("ctrl+a")
    window.wait(lambda: window.last("document")["selection"] == "28 edges", "all edges")
    window.key("ctrl+b")
    window.type("0.05")
    window.key("Return")
    position(window, 3, "Bevel 28 edges")
    window.screenshot(os.path.join(output, "mesh_bevel.png"))
    window.key("ctrl+z")
    position(window, 2, "Inset face")

    # Loop cut through the walls of the extrusion: they are the new faces at the old rim.
    a, b = face[0], face[1]
    window.key("ctrl+shift+a")
    at = move_onto_edge(window, (a, b), middle(window, face))
    window.key("ctrl+r")
    window.move(*[c + 1 for c in at])
    window.wait_idle()
    window.screenshot(os.path.join(output, "mesh_loop_cut.png"))
    window.type("2")
    window.press()
    window.release()
    window.wait(lambda: window.last("document")["gesture"], "the cut that slides")
    window.key("Return")
    position(window, 3, "2 loop cuts")

    # Cut a corner off.
    window.key("1")
    corner = next(v for v in range(8) if v not in face)
    window.key("ctrl+a")
    window.key("ctrl+shift+b")
    window.type("0.02")
    window.key("Return")
    window.wait(lambda: window.last("document")["position"] == 4, "the cut corners")
    check(window.last("document")["label"].startswith("Bevel "), "the step is called " + window.last("document")["label"])
    window.key("ctrl+z")
    window.wait(lambda: window.last("document")["position"] == 3, "undo")
    window.wait_idle()
    return corner


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        saved = os.path.join(folder, "a.hariko")
        window = Window(program, os.path.join(source, "tests", "golden", "cube.obj"))
        try:
            window.wait_idle()
            start = window.last("document")["position"]
            check(start == 0, f"an opened mesh starts at step {start}")
            steps(window, output)
            window.key("ctrl+shift+s")
            window.type_path(saved)
            window.wait_event("saved", 0)
            window.wait_idle()
            # Everything back and forth.
            for number in (2, 1, 0):
                window.key("ctrl+z")
                window.wait(lambda: window.last("document")["position"] == number, f"undo to {number}")
            for number in (1, 2, 3):
                window.key("ctrl+y")
                window.wait(lambda: window.last("document")["position"] == number, f"redo to {number}")
            window.wait_idle()
            check(not window.last("document")["dirty"], "undo and redo led to another document")
            check(window.quit() == 0, "the program did not end well")
        finally:
            window.close()
        with open(saved, encoding="utf-8") as file:
            mesh = json.load(file)["objects"][0]["source"]
        vertices, faces = len(mesh["vertices"]), len(mesh["faces"])
        corners = sum(len(row) - 1 for row in mesh["faces"])
        check(vertices - corners // 2 + faces == 2, f"{vertices} vertices, {corners // 2} edges, {faces} faces")


if __name__ == "__main__":
    run(session)
