"""The Gauss sphere beside the model: sites step by step, points and sites lit and chosen in both, turned together, followed
while a normal is dragged."""

import os

from driver import Window, check, run


def choose(window, menu, *items):
    window.click_on("menu." + menu)
    for item in items:
        window.click_on(item)


def sites(window):
    """Numbers of the sites on the near side of the sphere."""
    names = window.last("layout")["rects"]
    return {int(name.split(".")[2]) for name in names if name.startswith("gauss.site.")}


def steps(window, output, given):
    whole = sites(window)
    check(max(whole) > given + 20, f"few sites inside: {max(whole)}")
    x, y, width, height = window.resting_rect("gauss.step")
    window.drag((x + width - 6, y + height / 2), (x - 20, y + height / 2))
    window.wait(lambda: sites(window) and max(sites(window)) < given, "the image of the outline alone")
    for _ in range(3):
        window.click_on("gauss.forward")
    window.wait(lambda: max(sites(window)) == given + 2, "three sites")
    window.screenshot(os.path.join(output, "gauss_step_3.png"))
    for _ in range(9):
        window.click_on("gauss.forward")
    window.wait(lambda: max(sites(window)) == given + 11, "twelve sites")
    window.screenshot(os.path.join(output, "gauss_step_12.png"))
    window.click_on("gauss.back")
    window.wait(lambda: max(sites(window)) == given + 10, "one site less")
    window.drag((x + width / 3, y + height / 2), (x + width + 20, y + height / 2))
    window.wait(lambda: sites(window) == whole, "all sites again")


def links(window, output, given):
    inner = max(sites(window))
    window.move(*window.center(f"gauss.site.{inner}"))
    window.wait(lambda: "gauss.hovered" in window.last("layout")["rects"], "a lit site")
    window.screenshot(os.path.join(output, "gauss_hovered.png"))
    # A point of the outline is one of its document.
    point = next(n for n in sorted(sites(window)) if n < given)
    window.click_on(f"gauss.site.{point}")
    window.wait(lambda: window.last("document")["selection"] == "1 point", "a selected point")
    # From the model to the sphere.
    window.key("Escape")
    x, y, width, height = window.rect("view.0")
    window.move(x + width / 2, y + height / 2)
    window.wait(lambda: "gauss.hovered" in window.last("layout")["rects"], "the site of the surface's normal")
    window.move(x + 20, y + height - 20)
    window.wait(lambda: "gauss.hovered" not in window.last("layout")["rects"], "nothing is lit beside the model")


def turn(window):
    before = window.center("outline.point.0")
    x, y, width, height = window.rect("gauss.view")
    window.drag((x + width / 2, y + height - 25), (x + width / 2 + 60, y + height - 45))
    window.wait_idle()
    check(window.center("outline.point.0") != before, "the view did not turn with the sphere")


def follow(window):
    """The sphere follows while the arrow of a normal is dragged, and undo puts it back."""
    number = next(n for n in sorted(sites(window))
                  if f"outline.normal.{n}" in window.last("layout")["rects"])
    before = window.center(f"gauss.site.{number}")
    x, y = window.center(f"outline.normal.{number}")

    def moved():
        rect = window.last("layout")["rects"].get(f"gauss.site.{number}")
        return rect is None or (rect[0] + rect[2] // 2, rect[1] + rect[3] // 2) != before

    window.drag((x, y), (x + 7, y - 9), before_release=lambda: window.wait(moved, "the moved site"))
    window.wait(lambda: window.last("document")["label"] == "Turn normal", "the step")
    window.wait_idle()
    window.key("ctrl+z")
    window.wait_idle()
    check(window.center(f"gauss.site.{number}") == before, "undo did not put the site back")


def session(program, source, output):
    window = Window(program, os.path.join(source, "assets", "samples", "ellipsoid_cap.hariko"), size=(1400, 850))
    try:
        window.wait(lambda: window.count("rebuild", quality="final") > 0, "the surface")
        window.wait_idle()
        choose(window, "Outline", "command.outline.sphere")
        window.rect("gauss.view")
        window.wait_idle()
        given = sum(name.startswith("outline.point.") for name in window.last("layout")["rects"])
        window.screenshot(os.path.join(output, "gauss_sphere.png"))
        steps(window, output, given)
        links(window, output, given)
        turn(window)
        follow(window)
        window.click_on("gauss.close")
        window.wait(lambda: "gauss.view" not in window.last("layout")["rects"], "the sphere is gone")
    finally:
        window.close()


run(session)
