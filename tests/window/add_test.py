"""Primitives from the menu: the first makes a document, its numbers are adjusted in the same step; delete, mirror."""

import os

from driver import Window, check, run


def choose(window, menu, *items):
    window.click_on("menu." + menu)
    for item in items:
        window.click_on(item)


def session(program, source, output):
    del source
    window = Window(program, size=(1280, 800))
    try:
        # From the start page: a new document with a torus, framed.
        choose(window, "Add", "command.add.torus")
        window.wait(lambda: window.last("document")["label"] == "Add torus", "the torus")
        window.wait_idle()
        check(window.last("document")["position"] == 1, "the first object is not one step")
        check(len(window.last("vertices")["objects"]["1"]) == 32, "a torus of 8 by 4 has 32 vertices")
        window.screenshot(os.path.join(output, "add_torus.png"))

        # Twelve segments, typed; one step still.
        window.click_on("field.segments")
        window.key("ctrl+a")
        window.type("12")
        window.key("Return")
        window.wait(lambda: len(window.last("vertices")["objects"]["1"]) == 48, "48 vertices")
        check(window.last("document")["position"] == 1, "adjusting made a step of its own")
        window.wait_idle()
        window.screenshot(os.path.join(output, "add_torus_adjusted.png"))

        # Undo and redo the whole of it.
        window.key("ctrl+z")
        window.wait(lambda: window.last("document")["position"] == 0, "undo")
        window.key("ctrl+y")
        window.wait(lambda: window.last("document")["position"] == 1, "redo")
        check(len(window.last("vertices")["objects"]["1"]) == 48, "redo gave another torus")

        # Del deletes elements when elements are selected: all of them cannot go, so the document stays.
        window.key("ctrl+a")
        window.key("Delete")
        window.wait_idle()
        check(window.last("document")["position"] == 1, "every face of the object was deleted")
        window.key("Escape")

        # A live mirror takes half of it away and gives it back.
        choose(window, "Mesh", "menu.Mirror", "command.mirror.live_x")
        window.wait(lambda: window.last("document")["label"] == "Live mirror", "the mirror")
        window.wait_idle()
        check(len(window.last("vertices")["objects"]["1"]) < 48, "the half has all vertices")
        window.screenshot(os.path.join(output, "live_mirror.png"))
        choose(window, "Mesh", "menu.Mirror", "command.mirror.apply")
        window.wait(lambda: window.last("document")["label"] == "Apply live mirror", "the whole")
        window.wait(lambda: len(window.last("vertices")["objects"]["1"]) == 48, "48 vertices again")
        window.wait_idle()
        window.screenshot(os.path.join(output, "mirror_applied.png"))
    finally:
        window.close()


run(session)
