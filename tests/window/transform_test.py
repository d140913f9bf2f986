"""Selecting and transforming in the real window: typed and dragged transforms, gizmo, boxes, loops, soft selection,
tension; the saved file is checked."""

import json
import math
import os
import tempfile

from driver import Window, check, run

# A flat grid of 4 x 4 squares of side 10 beside nothing else: its numbers are easy to read.
SIDE, STEP = 4, 10


def write_grid(path):
    with open(path, "w", encoding="ascii") as file:
        for y in range(SIDE + 1):
            for x in range(SIDE + 1):
                file.write(f"v {x * STEP} {y * STEP} 0\n")
        for y in range(SIDE):
            for x in range(SIDE):
                a = y * (SIDE + 1) + x + 1
                file.write(f"f {a} {a + 1} {a + SIDE + 2} {a + SIDE + 1}\n")


def vertices(path):
    with open(path, encoding="utf-8") as file:
        source = json.load(file)["objects"][0]["source"]
    origin = source.get("origin", [0, 0, 0])
    table = {}
    for entry in source["vertices"]:
        key, *position = entry
        table[int(key)] = tuple(o + p for o, p in zip(origin, position))
    return table


class Session:
    def __init__(self, window, folder):
        self.window, self.folder, self.named = window, folder, False
        self.position = 0

    def place(self, vertex):
        """Where a vertex is, by what a saved file says."""
        path = os.path.join(self.folder, "state.hariko")
        saved = self.window.count("saved")
        if self.named:
            self.window.key("ctrl+s")
        else:
            # The name is typed once: a dialog takes seconds.
            self.window.key("ctrl+shift+s")
            self.window.type_path(path)
            self.named = True
        self.window.wait_event("saved", saved)
        return vertices(path)[vertex]

    def step(self, label=None):
        self.position += 1
        self.window.wait(lambda: self.window.last("document")["position"] == self.position and
                         not self.window.last("document")["gesture"], f"step {self.position} ({label})")
        if label:
            check(self.window.last("document")["label"] == label, f"{self.window.last('document')['label']}, not {label}")

    def selected(self, text):
        self.window.wait(lambda: self.window.last("document")["selection"] == text, f"the selection {text}")

    def undo(self):
        self.position -= 1
        self.window.key("ctrl+z")
        self.window.wait(lambda: self.window.last("document")["position"] == self.position, "undo")
        self.window.wait_idle()


def near(a, b, tolerance=1e-9):
    return all(abs(x - y) <= tolerance for x, y in zip(a, b))


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "grid.obj")
        write_grid(path)
        window = Window(program, path)
        try:
            work(window, Session(window, folder), output)
            check(quit_without_saving(window) == 0, "the program did not end well")
        finally:
            window.close()


def quit_without_saving(window):
    window.key("ctrl+q")
    try:
        return window.program.wait(timeout=3)
    except Exception:  # asks about unsaved changes
        window.click_on("prompt.discard")
        return window.program.wait(timeout=20)


def click_vertex(window, vertex):
    x, y, _ = window.vertex(vertex)
    window.click(x, y)


def work(window, s, output):
    middle = 12
    window.wait(lambda: window.last("vertices") and window.last("vertices")["objects"], "the grid")
    window.key("KP_7")  # from above
    window.key("Home")
    window.wait_idle()

    # G X 1 0 Enter moves exactly 10.
    click_vertex(window, middle)
    s.selected("1 vertex")
    for key in ("g", "x", "1", "0", "Return"):
        window.key(key)
    s.step("Move vertex")
    check(near(s.place(middle), (30, 20, 0), 0), f"G X 10 led to {s.place(middle)}")
    s.undo()

    # A gizmo's arrow moves along its axis only.
    window.wait_idle()
    window.screenshot(os.path.join(output, "transform_gizmo.png"))
    grip = window.center("gizmo.move.y")
    window.drag(grip, (grip[0] + 25, grip[1] - 60))
    s.step("Move vertex")
    x, y, z = s.place(middle)
    check(x == 20 and z == 0 and y > 21, f"the y arrow moved to {(x, y, z)}")
    s.undo()

    # A click on a handle asks for the number.
    window.click(*window.center("gizmo.move.x"))
    for key in ("minus", "3", "Return"):
        window.key(key)
    s.step("Move vertex")
    check(near(s.place(middle), (17, 20, 0), 0), "the number typed at the arrow")
    s.undo()

    # Boxes: from left to right what lies inside, from right to left what it touches.
    window.key("3")
    corner = {v: window.vertex(v)[:2] for v in (6, 8, 16, 18)}  # the middle four faces
    low = (min(p[0] for p in corner.values()), min(p[1] for p in corner.values()))
    high = (max(p[0] for p in corner.values()), max(p[1] for p in corner.values()))
    margin = 12
    window.key("b")
    window.drag((low[0] - margin, low[1] - margin), (high[0] + margin, high[1] + margin))
    s.selected("4 faces")
    window.key("b")
    window.drag((high[0] + margin, high[1] + margin), (low[0] - margin, low[1] - margin),
                before_release=lambda: window.screenshot(os.path.join(output, "transform_box.png")))
    s.selected("16 faces")
    window.key("ctrl+minus")
    window.key("ctrl+shift+a")

    # A double click on an edge takes its loop.
    window.key("2")
    a, b = window.vertex(11), window.vertex(12)
    window.move((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
    window.xdotool("click", "--repeat", "2", "--delay", "60", "1")
    s.selected("4 edges")

    # R Z 90 and S 2 about the middle of what is selected, which is the middle of the grid.
    window.key("ctrl+1")
    s.selected("5 vertices")
    for key in ("r", "z", "9", "0", "Return"):
        window.key(key)
    s.step("Rotate 5 vertices")
    check(near(s.place(10), (20, 0, 0), 0), f"R Z 90 led to {s.place(10)}")
    for key in ("s", "2", "Return"):
        window.key(key)
    s.step("Scale 5 vertices")
    check(near(s.place(10), (20, -20, 0), 0), f"S 2 led to {s.place(10)}")
    s.undo()
    s.undo()
    s.selected("5 vertices")

    # Soft selection: neighbours follow in part.
    window.key("1")
    window.key("ctrl+shift+a")
    window.key("KP_0")
    window.wait_idle()
    click_vertex(window, middle)
    s.selected("1 vertex")
    window.key("o")
    final = window.count("rebuild", quality="final")
    for key in ("g", "z", "8"):
        window.key(key)
    window.wait(lambda: window.last("document")["gesture"], "the soft drag")
    window.wait_event("rebuild", final, quality="final")  # a gesture that rests is never idle, but its surface is made
    window.screenshot(os.path.join(output, "transform_soft.png"))
    window.key("Return")
    s.step("Move vertex")
    middle_z, near_z = s.place(middle)[2], s.place(middle + 1)[2]
    check(middle_z == 8 and 0 < near_z < 8, f"soft selection: {middle_z}, {near_z}")
    window.key("o")

    # The view turns in the middle of a move without ending it.
    before = window.vertex(middle)
    window.key("g")
    x, y, _ = before
    window.move(x + 40, y)
    window.drag((x + 40, y), (x + 120, y + 10), button=2)
    window.wait(lambda: window.last("document")["gesture"], "a move that goes on")
    window.key("Escape")
    window.wait_idle()
    check(window.last("document")["position"] == s.position, "the cancelled move made a step")

    # T: tension by dragging, and by typing.
    window.move(640, 500)
    window.key("t")
    window.move(720, 500)
    window.wait(lambda: window.last("document")["gesture"], "the tension drag")
    window.screenshot(os.path.join(output, "transform_tension.png"))
    window.click(720, 500)
    s.step("Tension of vertices")
    for key in ("t", "7", "Return"):
        window.key(key)
    s.step("Tension of vertices")
    while s.position > 0:
        s.undo()


run(session)
