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


def solids(window):
    return window.last("vertices")["objects"]["1"]


def selection(window):
    return window.last("document")["selection"]


def place_with(window, kind, act, step):
    """Places a solid with the mouse; its id."""
    before = set(solids(window))
    window.click_on("menu.Solids")
    window.click_on("menu.Place")
    window.click_on("command.solid.place_" + kind)
    act()
    window.wait(lambda: label(window) == step, step)
    window.wait_idle()
    new = set(solids(window)) - before
    check(len(new) == 1, f"placing a {kind} made {len(new)} solids")
    check(selection(window) == "1 solid", "after placing there is selected: " + selection(window))
    return new.pop()


def place_by_hand(window, output):
    # A box on the ground and a ball on the box, their sizes by drags; a cone by a click.
    x, y, width, height = window.rect("viewport")
    ground = (x + width * 0.25, y + height * 0.72)
    box = place_with(window, "box", lambda: window.drag(ground, (ground[0] + 50, ground[1] + 20)), "Add box")
    at = window.vertex(box)
    check(abs(at[0] - ground[0]) < 20 and at[1] < ground[1], f"the box stands at {at}, not at {ground}")
    window.screenshot(os.path.join(output, "solids_placed_box.png"))
    ball = place_with(window, "sphere", lambda: window.drag(at[:2], (at[0] + 30, at[1])), "Add sphere")
    check(window.vertex(ball)[2] < at[2], "the ball is not in front of what was clicked on")
    window.screenshot(os.path.join(output, "solids_placed.png"))
    far = (x + width * 0.75, y + height * 0.72)
    cone = place_with(window, "cone", lambda: window.click(*far), "Add cone")
    check(abs(window.vertex(cone)[0] - far[0]) < 20, "the cone does not stand where the click was")
    window.key("ctrl+z")
    window.wait(lambda: cone not in solids(window), "undo of the cone")
    window.wait_idle()

    # Esc leaves everything as it is.
    before = position(window)
    window.click_on("menu.Solids")
    window.click_on("menu.Place")
    window.click_on("command.solid.place_cone")
    window.move(*ground)
    window.press()
    window.move(ground[0] + 40, ground[1])
    window.key("Escape")
    window.release()
    window.wait_idle()
    check(position(window) == before and cone not in solids(window), "Esc did not take the cone back")


def copy_and_convert(window, output):
    count = len(solids(window))
    choose(window, "solid.row")
    window.wait(lambda: label(window) == "Row of solids", "a row")
    window.wait_idle()
    check(len(solids(window)) == count + 3, "the row has not three copies")
    check(selection(window) == "3 solids", "the copies are not selected: " + selection(window))
    before = position(window)
    type_into(window, "copies", "2")
    window.wait(lambda: len(solids(window)) == count + 2, "two copies")
    window.wait_idle()
    check(position(window) == before, "adjusting the row made another step")
    window.screenshot(os.path.join(output, "solids_row.png"))
    window.key("ctrl+z")
    window.wait(lambda: len(solids(window)) == count, "undo of the row")
    window.wait_idle()
    choose(window, "solid.to_polyhedron")
    window.wait(lambda: label(window) == "Convert to polyhedron", "a polyhedron", 60)
    window.wait_idle()
    points = window.last("vertices")["objects"].get("2")  # none where they are not shown
    check(points is None or len(points) > count, "the polyhedron has too few vertices")
    check(selection(window) == "nothing selected", "on the polyhedron there is selected: " + selection(window))
    window.screenshot(os.path.join(output, "solids_converted.png"))
    window.key("ctrl+z")
    window.wait(lambda: len(solids(window)) == count, "undo of the conversion")
    window.wait_idle()


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
        type_into(window, "rounding", "0.06")
        window.wait(lambda: label(window) == "Rounding of the surface", "another rounding")
        window.wait_idle()
        window.rect("solids.contains")
        window.screenshot(os.path.join(output, "solids_rounding.png"))
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
        window.key("ctrl+shift+a")
        window.wait(lambda: selection(window) == "nothing selected", "no selection")
        window.move(1110, 450)
        for _ in range(20):
            window.xdotool("click", "4")  # the panel is scrolled to its end
        type_into(window, "tightness", "0")
        window.wait(lambda: label(window) == "Tightness of the surface", "the hull again")
        window.wait_idle()
        place_by_hand(window, output)
        copy_and_convert(window, output)
    finally:
        window.close()


run(session)
