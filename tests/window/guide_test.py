"""The guided first model, done to its end by mouse and keys: every step is recognised by what happened."""

import os

from driver import Window, check, run


def at_step(window, number):
    window.wait(lambda: f"guide.step.{number}" in window.last("layout")["rects"], f"step {number} of the guide")
    window.wait_idle()


def session(program, source, output):
    del source
    window = Window(program)
    try:
        window.click_on("start.guide")
        at_step(window, 0)
        window.screenshot(os.path.join(output, "guide_0.png"))
        window.click_on("guide.box")
        at_step(window, 1)

        # Pull the vertex that is nearest to the eye.
        window.key("1")
        vertex = window.nearest_vertex()
        x, y = window.vertex(vertex)[:2]
        window.drag((x, y), (x + 40, y + 60))
        at_step(window, 2)
        window.screenshot(os.path.join(output, "guide_2.png"))

        left, top, width, height = window.rect("slider.alpha")
        window.drag((left + 8, top + height / 2), (left + width * 0.6, top + height / 2))
        at_step(window, 3)

        # Leaving and coming back keeps the place.
        window.click_on("guide.leave")
        window.wait(lambda: "guide.step.3" not in window.last("layout")["rects"], "the guide to go")
        window.click_on("menu.Help")
        window.click_on("command.help.guide")
        at_step(window, 3)

        # An edge: in the middle between the nearest vertex and its nearest neighbour on the screen.
        window.key("2")
        pixels = window.last("vertices")["objects"]["1"]
        x, y = pixels[vertex][:2]
        for other in sorted(pixels, key=lambda v: (pixels[v][0] - x) ** 2 + (pixels[v][1] - y) ** 2)[1:5]:
            window.click((x + pixels[other][0]) / 2, (y + pixels[other][1]) / 2)
            window.wait_idle()
            if window.last("document")["selection"] == "1 edge":
                break
        check(window.last("document")["selection"] == "1 edge", "no edge was selected")
        window.key("c")
        at_step(window, 4)

        window.click_on("combo.map")
        window.click_on("choice.map.2")
        at_step(window, 5)
        window.screenshot(os.path.join(output, "guide_5.png"))

        window.key("ctrl+e")
        window.type_path(os.path.join(window.folder, "first.obj"))
        at_step(window, 6)
        check(os.path.getsize(os.path.join(window.folder, "first.obj")) > 1000, "nothing was exported")
        window.screenshot(os.path.join(output, "guide_6.png"))
        window.click_on("guide.leave")
        window.wait(lambda: "guide.step.6" not in window.last("layout")["rects"], "the guide to go")
    finally:
        window.close()


run(session)
