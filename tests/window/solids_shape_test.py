"""The surface round solids: its bodies, its plane of symmetry, its methods, a drag that changes its patches."""

import os

from driver import Window, check, run


def position(window):
    return window.last("document")["position"]


def label(window):
    return window.last("document")["label"]


def pixels(path):
    """The picture as lines of text, to be compared."""
    import subprocess
    return subprocess.run(["convert", path, "-depth", "8", "rgb:-"], capture_output=True, check=True).stdout


def show_bodies(window, output):
    with_bodies, without = (os.path.join(output, f"solids_bodies_{name}.png") for name in ("on", "off"))
    window.screenshot(with_bodies)
    window.key("alt+b")
    window.wait_idle()
    window.screenshot(without)
    check(pixels(with_bodies) != pixels(without), "Alt+B changes nothing")
    check(position(window) == 0, "showing bodies made a step")
    window.key("alt+b")
    window.wait_idle()


def choose_symmetry(window, number, text):
    window.click_on("combo.envelope_symmetry")
    window.click_on(f"choice.envelope_symmetry.{number}")
    window.wait(lambda: label(window) == text, text)
    window.wait_idle()


def choose_curves(window, output):
    """The network of curves is one step, and has rows of its own."""
    before = position(window)
    window.rect("field.rounding")
    window.click_on("combo.envelope_method")
    window.click_on("choice.envelope_method.1")
    window.wait(lambda: label(window) == "Method of the surface", "the other method")
    window.wait_idle()
    window.rect("field.roundness")
    check("field.rounding" not in window.last("layout")["rects"], "the network has the ball's rows")
    window.screenshot(os.path.join(output, "solids_curves.png"))
    window.key("ctrl+z")
    window.wait(lambda: position(window) == before, "undo of the method")
    window.wait_idle()


def make_symmetric(window, output):
    before = position(window)
    choose_symmetry(window, 1, "Symmetry of the surface")
    check(position(window) == before + 1, "the plane is not one step")
    window.rect("solids.symmetric")
    window.screenshot(os.path.join(output, "solids_symmetric.png"))
    window.key("ctrl+z")
    window.wait(lambda: position(window) == before, "undo of the plane")
    window.wait_idle()
    check("solids.symmetric" not in window.last("layout")["rects"], "without a plane there is a row about it")


def drag_through(window):
    """Patches change on the way and pictures are faded; the window comes to rest, and undo takes all of it back."""
    before = position(window)
    start = window.vertex(0)[:2]
    end = window.vertex(3)[:2]
    window.drag(start, end, steps=25)
    window.wait(lambda: position(window) == before + 1, "a solid dragged through the others")
    window.wait_idle()
    window.key("ctrl+z")
    window.wait(lambda: position(window) == before, "undo")
    window.wait_idle()


def session(program, source, output):
    window = Window(program, os.path.join(source, "assets", "samples", "solids_four.hariko"), size=(1280, 800))
    try:
        show_bodies(window, output)
        make_symmetric(window, output)
        choose_curves(window, output)
        drag_through(window)
    finally:
        window.close()


run(session)
