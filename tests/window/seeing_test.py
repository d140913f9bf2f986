"""Ways of looking: maps with their ranges, materials, marks, combs, tensions and sections, by panel, legend and keys."""

import os
import subprocess

from driver import Window, check, run


def session(program, source, output):
    window = Window(program, os.path.join(source, "assets", "samples", "fig5d.hariko"), size=(1280, 800))

    def step(label):
        window.wait(lambda: window.last("document")["label"] == label, "the step " + label)
        window.wait_idle()

    def keep(name):
        window.wait_idle()
        window.screenshot(os.path.join(output, "seeing_" + name + ".png"))

    def choose(combo, number):
        window.click_on("combo." + combo)
        window.rect("choice." + combo + "." + str(number))
        window.wait_idle()  # a popup finds its place in its second frame
        window.click_on("choice." + combo + "." + str(number))

    def rects():
        return window.last("layout")["rects"]

    try:
        window.wait_event("opened", 0)
        window.wait_idle()
        keep("clay")

        # A material, and zebra with its rows.
        choose("material", 1)
        step("Material")
        keep("porcelain")
        # By its key on all surfaces, which is no step; as the object's own it is one.
        before = window.last("document")["position"]
        window.key("alt+z")
        window.rect("combo.lock")
        check(window.last("document")["position"] == before, "a map of the view made a step")
        window.key("alt+z")
        window.wait(lambda: "combo.lock" not in rects(), "the view's zebra to go")
        choose("map", 2)
        step("Map Zebra")
        choose("lock", 1)
        x, y = window.center("ball.stripes")
        window.drag((x, y), (x + 14, y - 10))
        keep("zebra")
        check(window.last("document")["label"] == "Map Zebra", "the stripes made a step")

        # A range of its own: typed in the legend, chosen from its menu, reset by the right button.
        choose("map", 3)
        step("Map Gaussian curvature")
        window.rect("legend.high")
        steps = window.last("document")["position"]
        window.click_on("legend.high")
        window.type("2.5")
        window.key("Return")
        step("Range of the map")
        check(window.last("document")["position"] == steps + 1, "one typed end is one step")
        check("field.range_low" in rects(), "a typed range shows its fields")
        keep("typed_range")
        window.click_on("legend.mode")
        window.rect("legend.mode.2")
        window.wait_idle()
        window.click_on("legend.mode.2")
        window.wait(lambda: window.last("document")["position"] == steps + 2, "the range's mode")
        window.wait_idle()
        keep("full_range")
        x, y = window.center("legend.low")
        window.xdotool("mousemove", str(x), str(y))
        window.press(3)
        window.release(3)
        window.wait(lambda: window.last("document")["position"] == steps + 3, "the reset of the range")
        check("field.range_low" not in rects(), "the fields of a typed range stayed")

        # Marks, combs and tensions by their keys; all are steps of the document.
        choose("map", 2)
        step("Map Zebra")
        for key, label, name in (("alt+e", "Edge continuity", "marks"), ("alt+c", "Curvature combs", "combs"),
                                 ("alt+t", "Show tensions", "tensions")):
            window.key(key)
            step(label)
            keep(name)
        window.bring_up("combs.longer")
        window.click_on("combs.longer")
        window.wait_idle()
        keep("combs_longer")

        # The section belongs to the view.
        position = window.last("document")["position"]
        window.key("alt+s")
        window.wait(lambda: "slider.section" in rects(), "the rows of the section")
        window.bring_up("check.section_flipped")
        keep("section_one_half")
        window.click_on("check.section_flipped")
        window.arrive(1100, 600)
        keep("section_other_half")
        same = subprocess.run(["compare", "-metric", "AE", *(os.path.join(output, "seeing_section_" + half + "_half.png[900x700+50+40]")
                                                             for half in ("one", "other")), "null:"],
                              capture_output=True, text=True, timeout=60).stderr.split()[0]
        check(float(same) > 5000, "the other side of the section looks the same")
        choose("wire", 2)
        step("Lines over the surface")
        check(window.last("document")["position"] == position + 1, "the section made a step")
        keep("section")
        window.key("ctrl+z")
        window.wait(lambda: window.last("document")["position"] == position, "undo")
        window.wait_idle()
    finally:
        window.close()


run(session)
