"""Curves round solids pulled by hand: vertices and curves dragged, put back by a double click and by the panel, kept
while a solid moves; the same in a valley."""

import json
import os
import tempfile

from driver import Window, check, run


def position(window):
    return window.last("document")["position"]


def label(window):
    return window.last("document")["label"]


def handles(window, kind):
    return sorted(n for n in window.last("layout")["rects"] if n.startswith(f"network.{kind}."))


def undo_to(window, wanted):
    window.key("ctrl+z")
    window.wait(lambda: position(window) == wanted, "undo")
    window.wait_idle()


def in_the_middle(window, names):
    """The handle nearest to the middle of the view, where no panel and no other view hides it."""
    x, y, width, height = window.rect("viewport")
    middle = (x + width / 2, y + height / 2)
    return min(names, key=lambda n: sum((a - b) ** 2 for a, b in zip(window.center(n), middle)))


def switch_on(window):
    check(not handles(window, "vertex"), "handles are there before anyone asked for them")
    window.key("alt+n")
    window.wait(lambda: handles(window, "vertex") and handles(window, "curve"), "handles on the network")
    window.wait_idle()
    check(position(window) == 0, "showing handles made a step")
    check(not [n for n in window.last("layout")["rects"] if n.startswith("waist.")], "rings lie under the handles")


def drag_vertex(window, output):
    name = in_the_middle(window, handles(window, "vertex"))
    start = window.center(name)
    window.arrive(*start)
    window.press()
    for i in range(1, 5):
        window.move(start[0] + 8 * i, start[1] - 8 * i)
    window.key("Escape")
    window.release()
    window.wait_idle()
    check(position(window) == 0, "Esc did not cancel the drag of the vertex")

    window.drag(start, (start[0] + 40, start[1] - 30), before_release=lambda: window.screenshot(
        os.path.join(output, "network_vertex_dragged.png")))
    window.wait(lambda: position(window) == 1, "a dragged vertex")
    window.wait_idle()
    check(label(window) == "Move vertex of solids", "the drag made the step " + label(window))
    now = window.center(name)
    check(now[0] > start[0] + 15 and now[1] < start[1] - 10, f"the vertex did not follow the pointer: {start} {now}")
    window.screenshot(os.path.join(output, "network_vertex.png"))

    # Shift is finer: a fifth of the way.
    window.xdotool("keydown", "shift")
    window.drag(now, (now[0] + 50, now[1]))
    window.xdotool("keyup", "shift")
    window.wait_idle()
    return name


def put_back(window, name):
    """A double click forgets what was pulled."""
    before = position(window)
    x, y = window.center(name)
    window.arrive(x, y)
    window.xdotool("click", "--repeat", "2", "--delay", "60", "1")
    window.wait(lambda: position(window) == before + 1, "a double click on the handle")
    window.wait_idle()
    check(label(window) == "Reset curves of solids", "the double click made the step " + label(window))
    check("button.reset_network" not in window.last("layout")["rects"], "something is still pulled")
    undo_to(window, before)


def drag_curve(window, output):
    before = position(window)
    name = in_the_middle(window, handles(window, "curve"))
    x, y = window.center(name)
    # One of two opposite drags can be held back by the largest or the least factor.
    window.drag((x, y), (x + 24, y - 24), before_release=lambda: window.screenshot(
        os.path.join(output, "network_curve_dragged.png")))
    window.wait(lambda: position(window) == before + 1, "a dragged curve")
    window.wait_idle()
    check(label(window) == "Fullness of curve", "the drag made the step " + label(window))


def survives_a_moved_solid(window, output):
    """What was pulled stays pulled while a solid moves; the panel puts all of it back."""
    before = position(window)
    window.key("alt+n")
    window.wait(lambda: not handles(window, "vertex"), "no handles")
    window.wait_idle()
    start = window.vertex(0)[:2]
    window.drag(start, (start[0] - 30, start[1] + 10))
    window.wait(lambda: position(window) == before + 1 and label(window) == "Move solid", "a moved solid")
    window.wait_idle()
    window.key("ctrl+shift+a")
    window.wait(lambda: window.last("document")["selection"] == "nothing selected", "no selection")
    window.wait_idle()
    window.screenshot(os.path.join(output, "network_moved_solid.png"))
    window.click_on("button.reset_network")
    window.wait(lambda: label(window) == "Reset curves of solids", "the reset of all")
    window.wait_idle()
    check("button.reset_network" not in window.last("layout")["rects"], "something is still pulled after the reset")


def drag_in_valley(window, output):
    """Where the surface goes into a notch its vertices have handles as well."""
    window.key("alt+n")
    window.wait(lambda: handles(window, "vertex"), "handles on the network")
    window.wait_idle()
    window.screenshot(os.path.join(output, "network_valley_before.png"))
    name = in_the_middle(window, [n for n in handles(window, "vertex") if "+" in n])
    start = window.center(name)
    window.drag(start, (start[0] - 12, start[1] - 28))
    window.wait(lambda: position(window) == 1, "a dragged vertex of a valley")
    window.wait_idle()
    now = window.center(name)
    check(now[1] < start[1] - 12, f"the vertex in the valley did not follow the pointer: {start} {now}")
    window.screenshot(os.path.join(output, "network_valley.png"))
    window.click_on("button.reset_network")
    window.wait(lambda: label(window) == "Reset curves of solids", "the reset of all")
    window.wait_idle()
    back = window.center(name)
    check(abs(back[0] - start[0]) + abs(back[1] - start[1]) < 2, f"the reset left the vertex elsewhere: {start} {back}")


def network_document(source, name, folder):
    """A copy of a sample whose surface is the network of curves."""
    with open(os.path.join(source, "assets", "samples", name + ".hariko"), encoding="utf-8") as file:
        document = json.load(file)
    document["objects"][0]["source"]["method"] = "network"
    path = os.path.join(folder, name + ".hariko")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document, file)
    return path


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        window = Window(program, network_document(source, "solids_four", folder), size=(1280, 800))
        try:
            switch_on(window)
            pulled = drag_vertex(window, output)
            while position(window) > 1:
                undo_to(window, position(window) - 1)
            put_back(window, pulled)
            drag_curve(window, output)
            survives_a_moved_solid(window, output)
        finally:
            window.close()
        window = Window(program, network_document(source, "solids_l", folder), size=(1280, 800))
        try:
            drag_in_valley(window, output)
        finally:
            window.close()


run(session)
