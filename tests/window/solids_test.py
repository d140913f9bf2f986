"""Solids: placed from the menu, picked and dragged with the mouse, changed in the properties, undone, deleted."""

import os

from driver import Window, check, run


def position(window):
    return window.last("document")["position"]


def label(window):
    return window.last("document")["label"]


def choose(window, command):
    window.click_on("menu.Solids")
    window.click_on("command." + command)


def type_into(window, field, text):
    window.wait_idle()  # the rows have come to rest
    window.click_on("field." + field)
    window.key("ctrl+a")
    window.type(text)
    window.key("Return")


def place(window, command, step):
    choose(window, command)
    window.wait(lambda: label(window) == step, step)
    window.wait_idle()


def drag_solid(window, solid, by):
    start = window.vertex(solid)[:2]
    before = position(window)
    window.drag(start, (start[0] + by[0], start[1] + by[1]))
    window.wait(lambda: position(window) == before + 1, "a dragged solid")
    window.wait_idle()
    check(label(window) == "Move solid", "the drag made the step " + label(window))
    now = window.vertex(solid)
    check(abs(now[0] - start[0] - by[0]) < 12 and abs(now[1] - start[1] - by[1]) < 12,
          f"the solid did not follow the pointer: {start} {now}")


def session(program, source, output):
    window = Window(program, os.path.join(source, "assets", "samples", "solids_one.hariko"), size=(1280, 800))
    try:
        # Three more solids into the object that is there.
        for command, step in (("solid.sphere", "Add sphere"), ("solid.cylinder", "Add cylinder"),
                              ("solid.cone", "Add cone")):
            place(window, command, step)
        check(position(window) == 3, "three solids are not three steps")
        check(len(window.last("vertices")["objects"]) == 1, "the solids went into several objects")
        check(len(window.last("vertices")["objects"]["1"]) == 4, "the object does not have four solids")
        window.key("Home")
        window.wait_idle()
        window.screenshot(os.path.join(output, "solids_four.png"))

        # A click takes a solid; the one that is chosen is dragged, and one undo takes the drag back.
        start = window.vertex(1)[:2]
        window.key("ctrl+shift+a")
        window.wait(lambda: window.last("document")["selection"] == "nothing selected", "no selection")
        window.click(*start)
        window.wait(lambda: window.last("document")["selection"] != "nothing selected", "a clicked solid")
        window.wait_idle()
        window.click_on("solid.1")
        window.wait_idle()
        window.rect("field.solid.radius")
        drag_solid(window, 1, (-60, -90))
        window.screenshot(os.path.join(output, "solids_dragged.png"))
        window.key("ctrl+z")
        window.wait(lambda: position(window) == 3, "undo")
        window.wait_idle()
        back = window.vertex(1)
        check(abs(back[0] - start[0]) < 2 and abs(back[1] - start[1]) < 2, "undo left the solid elsewhere")

        # Its own number, then those of the surface.
        window.click_on("solid.1")
        window.wait_idle()
        type_into(window, "solid.radius", "0.3")
        window.wait(lambda: label(window) == "Size of solid", "another radius")
        window.wait_idle()
        window.key("ctrl+shift+a")  # without a selection the rows of the surface come into sight
        window.wait(lambda: window.last("document")["selection"] == "nothing selected", "no selection")
        type_into(window, "waist", "0.2")
        window.wait(lambda: label(window) == "Waist of the surface", "another waist")
        window.wait_idle()
        window.rect("solids.contains")
        window.screenshot(os.path.join(output, "solids_waist.png"))
        type_into(window, "tightness", "1")
        window.wait(lambda: label(window) == "Tightness of the surface", "a tight surface")
        window.wait_idle()
        window.screenshot(os.path.join(output, "solids_tight.png"))

        # Del takes the selected solid only.
        window.click_on("solid.0")
        window.move(400, 700)
        window.key("Delete")
        window.wait(lambda: label(window) == "Delete solid", "a deleted solid")
        window.wait_idle()
        check(len(window.last("vertices")["objects"]["1"]) == 3, "another number of solids was deleted")
        window.screenshot(os.path.join(output, "solids_three.png"))
    finally:
        window.close()


run(session)
