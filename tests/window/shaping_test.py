"""Local editing and joins in the real window: a vertex moved and its tangent plane turned by hand with the tangents
round it pinned and released; border edges of the wheel arch released, attached again and joined by their position only. The
saved files are checked."""

import json
import os
import tempfile

from driver import Window, check, run


class Session:
    def __init__(self, program, sample, folder):
        self.window = Window(program, sample)
        self.path = os.path.join(folder, os.path.basename(sample))
        self.named = False
        self.window.wait_event("opened", 0)
        self.window.wait_idle()

    def step(self, label):
        self.window.wait(lambda: self.window.last("document")["label"] == label and
                         not self.window.last("document")["gesture"], "the step " + label)
        self.window.wait_idle()

    def saved(self):
        """The document as a saved file has it."""
        count = self.window.count("saved")
        if self.named:
            self.window.key("ctrl+s")
        else:
            self.window.key("ctrl+shift+s")
            self.window.type_path(self.path)
            self.named = True
        self.window.wait_event("saved", count)
        with open(self.path, encoding="utf-8") as file:
            return json.load(file)

    def undo(self):
        position = self.window.last("document")["position"]
        self.window.key("ctrl+z")
        self.window.wait(lambda: self.window.last("document")["position"] == position - 1, "undo")
        self.window.wait_idle()

    def surface_is_well(self):
        rebuilt = self.window.last("rebuild")
        check(rebuilt["error"] is None, f"no surface: {rebuilt}")

    def run_by_name(self, name):
        self.window.key("ctrl+shift+p")
        self.window.rect("palette.input")
        self.window.type(name)
        self.window.wait_idle()
        self.window.key("Return")


def pins_of(document):
    return document["objects"][0]["source"].get("pin", [])


def local_editing(session, output):
    window = session.window
    window.key("shift+o")
    window.wait_idle()
    vertex = window.nearest_vertex()
    x, y, _ = window.vertex(vertex)
    window.click(x, y)
    window.wait(lambda: window.last("document")["selection"] == "1 vertex", "the selected vertex")
    # Turning the tangent plane fixes it and the tangents round it.
    for key in ("r", "x", "2", "0", "Return"):
        window.key(key)
    window.wait(lambda: window.last("document")["position"] == 1, "the turned tangent plane")
    window.wait_idle()
    session.surface_is_well()
    window.screenshot(os.path.join(output, "shaping_turned.png"))
    pins = pins_of(session.saved())
    check(any(str(pin["vertex"]) == vertex and pin["kind"] == "tangents" for pin in pins),
          f"vertex {vertex} has no fixed tangents: {[pin['vertex'] for pin in pins]}")
    check(len(pins) > 3, f"the tangents round it are free: {len(pins)} pins")
    # Moving changes the position, and keeps the pins.
    window.wait_idle()
    for key in ("g", "z", "1", "Return"):
        window.key(key)
    window.wait(lambda: window.last("document")["position"] == 2, "the moved vertex")
    window.wait_idle()
    session.surface_is_well()
    check(len(pins_of(session.saved())) >= len(pins), "moving has released pins")
    # A released pin is gone, and comes back by undo.
    window.key("shift+p")
    session.step("Release pins")
    left = pins_of(session.saved())
    check(all(str(pin["vertex"]) != vertex for pin in left), "the pin was not released")
    session.undo()
    session.undo()
    session.undo()
    check(pins_of(session.saved()) == [], "undo left pins")
    check(window.last("document")["position"] == 0, "not everything is undone")


def attached_of(document):
    return next(o["source"]["attached"] for o in document["objects"] if o["source"].get("attached"))


def joins(session, output):
    window = session.window
    before = attached_of(session.saved())
    # Of the cover's outer ring, the edge whose middle is nearest to the eye.
    pixels = window.last("vertices")["objects"]["2"]
    edges = [entry["edge"] for entry in before]
    edge = min(edges, key=lambda ends: sum(pixels[str(v)][2] for v in ends))
    middle = [sum(pixels[str(v)][k] for v in edge) / 2 for k in (0, 1)]

    def choose(combo, number):
        window.click_on("combo." + combo)
        window.rect(f"choice.{combo}.{number}")
        window.wait_idle()  # a popup finds its place in its second frame
        window.click_on(f"choice.{combo}.{number}")

    window.key("2")
    window.wait_idle()
    window.click(*middle)
    window.wait(lambda: window.last("document")["selection"] == "1 edge", "the selected edge")
    window.rect("combo.join")
    window.wait_idle()
    window.screenshot(os.path.join(output, "shaping_attached.png"))

    # Only the position is joined.
    choose("join", 0)
    session.step("Joint")
    session.surface_is_well()
    changed = next(a for a in attached_of(session.saved()) if a["edge"] == edge)
    check(changed["continuity"] == "g0", f"the joint is {changed}")
    session.undo()
    # The fender cannot follow one edge of a cover that follows it at the others: a notice says so.
    notices = window.count("notice")
    choose("adapts", 1)
    window.wait_event("notice", notices)
    check("follow the other" in window.last("notice")["text"], f"the notice is {window.last('notice')}")
    window.wait_idle()

    # Released, it is free; attached again, it is as it was.
    window.click_on("button.release_edges")
    session.step("Release edges")
    session.surface_is_well()
    check(all(a["edge"] != edge for a in attached_of(session.saved())), "the edge was not released")
    session.run_by_name("Attach to patch side")
    session.step("Attach edge")
    session.surface_is_well()
    check(sorted(a["edge"] for a in attached_of(session.saved())) == sorted(edges), "the edge was not attached")
    session.undo()
    session.undo()
    check(attached_of(session.saved()) == before, "undo changed the attachments")


def everything(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        for sample, part in (("fig2", local_editing), ("wheel_arch", joins)):
            session = Session(program, os.path.join(source, "assets", "samples", sample + ".hariko"), folder)
            try:
                part(session, output)
            finally:
                session.window.close()


run(everything)
