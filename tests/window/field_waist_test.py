"""The waist of a bar through a gap, on a surface over a field's cage: its ring is dragged, typed and undone; and that
of a notch between solids that touch."""

import json
import os
import tempfile

from driver import Window, check, run

SCENE = {
    "tightness": 1,
    "method": "field",
    "primitives": [
        {"type": "box", "size": [1, 0.8, 0.6], "position": [0, 0, 0], "rotation": [0, 0, 0]},
        {"type": "sphere", "radius": 0.45, "position": [1.55, 0, 0], "rotation": [0, 0, 0]},
    ],
}


def position(window):
    return window.last("document")["position"]


def label(window):
    return window.last("document")["label"]


def drag_ring(window, output):
    window.wait(lambda: "waist.0-1" in window.last("layout")["rects"], "a ring on the bar")
    window.wait_idle()
    window.screenshot(os.path.join(output, "field_waist_before.png"))
    x, y = window.center("waist.0-1")
    window.drag((x, y), (x + 5, y - 40), before_release=lambda: window.screenshot(
        os.path.join(output, "field_waist_dragged.png")))
    window.wait(lambda: position(window) == 1, "a dragged waist")
    window.wait_idle()
    check(label(window) == "Waist of bridge", "the drag made the step " + label(window))
    now = window.center("waist.0-1")
    check(abs(now[0] - x) + abs(now[1] - y) > 8, f"the surface did not follow: {(x, y)} {now}")
    window.screenshot(os.path.join(output, "field_waist_after.png"))
    window.key("ctrl+z")
    window.wait(lambda: position(window) == 0, "undo of the waist")
    window.wait_idle()
    again = window.center("waist.0-1")
    check(abs(again[0] - x) + abs(again[1] - y) < 2, f"undo left the ring elsewhere: {(x, y)} {again}")


def type_waist(window, output):
    window.click_on("waist.0-1")
    window.wait(lambda: window.last("document")["selection"] == "2 solids", "both solids")
    window.wait_idle()
    for text in ("0.2", "0.9"):
        before = position(window)
        window.click_on("field.bridge_waist")
        window.key("ctrl+a")
        window.type(text)
        window.key("Return")
        window.wait(lambda: label(window) == "Waist of bridge" and position(window) == before + 1, "a typed waist")
        window.wait_idle()
        window.screenshot(os.path.join(output, f"field_waist_{text}.png"))


def rings_make_room_for_handles(window):
    window.key("alt+n")
    window.wait(lambda: "waist.0-1" not in window.last("layout")["rects"], "handles in place of rings")
    window.wait_idle()
    window.key("alt+n")
    window.wait(lambda: "waist.0-1" in window.last("layout")["rects"], "rings again")
    window.wait_idle()


def drag_notch(window, output):
    """Where solids touch the ring lies in their notch, which fills as it is drawn out."""
    window.wait(lambda: "waist.0-1" in window.last("layout")["rects"], "a ring in the notch")
    window.wait_idle()
    window.screenshot(os.path.join(output, "field_notch_before.png"))
    x, y = window.center("waist.0-1")
    window.drag((x, y), (x + 30, y - 30), before_release=lambda: window.screenshot(
        os.path.join(output, "field_notch_dragged.png")))
    window.wait(lambda: position(window) == 1, "a dragged notch")
    window.wait_idle()
    check(label(window) == "Waist of bridge", "the drag made the step " + label(window))
    window.screenshot(os.path.join(output, "field_notch_after.png"))
    window.key("ctrl+z")
    window.wait(lambda: position(window) == 0, "undo of the waist")
    window.wait_idle()


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        scene = os.path.join(folder, "gap.json")
        with open(scene, "w", encoding="utf-8") as file:
            json.dump(SCENE, file)
        window = Window(program, scene, size=(1280, 800))
        try:
            drag_ring(window, output)
            type_waist(window, output)
            rings_make_room_for_handles(window)
        finally:
            window.close()
    window = Window(program, os.path.join(source, "assets", "samples", "solids_camera.hariko"), size=(1280, 800))
    try:
        drag_notch(window, output)
    finally:
        window.close()


run(session)
