"""What the window tests of skins share: steps by their labels, strokes of the mouse, a session that is opened again."""

import json
import math
import os
import tempfile

from driver import Window, check


def empty_document(window):
    window.wait_idle()
    window.key("ctrl+n")
    window.wait(lambda: window.last("document")["serial"] is not None and not window.last("vertices")["objects"], "an empty document")
    window.wait_idle()


def save(window, path):
    """Saves the document under a new name; the source of its only object, as the file has it."""
    window.wait_idle()
    window.key("ctrl+s")
    window.type_path(path)
    window.wait(lambda: os.path.exists(path), "the file")
    window.wait_idle()
    with open(path, encoding="utf-8") as file:
        source = json.load(file)["objects"][0]["source"]
    check(source["kind"] == "skin", f"saved: {source}")
    return source


def session_and_again(program, source, work, again):
    """A window for work(window, path), which saves a skin at `path`; another one that opens it, for again(window, path)."""
    # Not from the start page: the pictures of all samples take a while.
    cube = os.path.join(source, "assets", "samples", "cube.hariko")
    with tempfile.TemporaryDirectory(prefix="hariko-skin-") as folder:
        path = os.path.join(folder, "skin.hariko")
        for opened, act in ((cube, work), (path, again)):
            window = Window(program, opened, size=(1280, 800))
            try:
                act(window, path)
                check(window.quit() == 0, "the program failed at the end")
            finally:
                window.close()


def names(window, prefix):
    """What is marked in the view with names that begin so."""
    return [name for name in window.last("layout")["rects"] if name.startswith(prefix)]


def label(window, text, what=None):
    window.wait(lambda: window.last("document")["label"] == text, what or f"step {text}; it is {window.last('document')}")
    window.wait_idle()
    return window.last("document")["position"]


def choose(window, menu, *items):
    window.click_on("menu." + menu)
    for item in items:
        window.click_on(item)


def skin_mark(window, name):
    return window.center("skin." + name)


def stroke(window, *corners, steps=8):
    """One stroke of the left button along a polyline."""
    window.move(*corners[0])
    window.press()
    for a, b in zip(corners, corners[1:]):
        for i in range(1, steps + 1):
            window.move(a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps)
    window.release()


def between(a, b, share=0.5):
    return a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share


def capsule(a, b, radius):
    """A closed curve round two points, at about this distance."""
    angle = math.atan2(b[1] - a[1], b[0] - a[0])
    points = []
    for centre, begin in ((b, angle - math.pi / 2), (a, angle + math.pi / 2)):
        for i in range(7):
            turn = begin + math.pi * i / 6
            points.append((centre[0] + radius * math.cos(turn), centre[1] + radius * math.sin(turn)))
    return points + [points[0]]
