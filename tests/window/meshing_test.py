"""Triangles within a tolerance: the panel, tolerances that are dragged, maps of errors, four pictures and back."""

import os
import re
import subprocess

from driver import Window, check, run


def session(program, source, output):
    window = Window(program, os.path.join(source, "assets", "samples", "fig2.hariko"), size=(1280, 800))

    def keep(name):
        window.arrive(700, 760)  # beside the model; what was asked for before has then been taken
        window.wait_idle()
        window.screenshot(os.path.join(output, "meshing_" + name + ".png"))

    def differing(first, second):
        """The share of pixels in the middle of the view that two of the kept pictures show differently."""
        files = [os.path.join(output, "meshing_" + name + ".png[480x400+410+170]") for name in (first, second)]
        done = subprocess.run(["compare", "-metric", "AE", "-fuzz", "2%", *files, "null:"], capture_output=True,
                              text=True, timeout=60)
        return float(done.stderr.split()[0]) / (480 * 400)

    def rects():
        return window.last("layout")["rects"]

    def count():
        """How many triangles the panel says there are."""
        for name in rects():
            found = re.fullmatch(r"meshing\.count\.(\d+)", name)
            if found:
                return int(found.group(1))
        return 0

    def meshed(action):
        before = window.count("meshed")
        action()
        window.wait(lambda: window.count("meshed") > before, "a mesh")
        window.wait_idle()

    try:
        window.wait_event("opened", 0)
        window.wait_idle()
        steps = window.last("document")["position"]

        # The panel opens with a tolerance in proportion to the object, and a mesh for it.
        meshed(lambda: window.key("ctrl+alt+t"))
        first = count()
        check(first > 50, "triangles: " + str(first))
        keep("triangles")

        # Their edges lie over the surface; alone they stand in its place. Neither asks for another mesh.
        made = window.count("meshed")
        window.click_on("meshing.place.1")
        keep("alone")
        check(differing("triangles", "alone") > 0.02, "the triangles alone look like their edges over the surface")
        window.click_on("meshing.place.0")
        keep("over")
        check(differing("triangles", "over") < 0.01, "back over the surface the picture is another one")
        check(window.count("meshed") == made, "a choice of what is shown made another mesh")

        # Dragging the tolerance down makes more of them, while it is dragged; no step is made.
        left, top, width, height = rects()["meshing.distance"]
        x, y = left + width * 0.55, top + height / 2
        meshed(lambda: window.drag((x, y), (left + width * 0.35, y)))
        finer = count()
        check(finer > first, "a smaller tolerance gave " + str(finer) + " after " + str(first))
        check(window.last("document")["position"] == steps, "a tolerance made a step")

        # Maps of errors, with the place of the largest.
        for kind in (1, 2, 3):
            window.click_on("meshing.show." + str(kind))
            window.rect("meshing.histogram")
            window.wait_idle()
            keep("error_" + str(kind))
            check("meshing.largest" in rects(), "the largest error has no mark")

        # Another criterion, alone with the first.
        meshed(lambda: window.click_on("meshing.normal.on"))
        keep("with_angle")

        # The search for fewer facets shows how far it is, and stops; the mesh of before stays.
        before = count()
        window.click_on("meshing.optimise")
        window.click_on("meshing.stop")
        window.rect("meshing.stopped")
        window.wait_idle()
        check(count() == before, "a search that was stopped changed the mesh")
        keep("stopped")
        meshed(lambda: window.click_on("meshing.optimise"))

        # Four pictures, and back.
        meshed(lambda: window.click_on("meshing.compare"))
        for view in range(4):
            check("meshing.picture." + str(view) in rects(), "picture " + str(view) + " is missing")
        keep("compared")
        meshed(lambda: window.click_on("meshing.compare"))
        check("meshing.picture.0" not in rects(), "the four pictures stayed")

        # Closed, the smooth surface is back.
        window.click_on("meshing.close")
        window.wait_idle()
        check("meshing.compare" not in rects(), "the panel stayed")
        keep("closed")
        window.quit()
    finally:
        window.close()


if __name__ == "__main__":
    run(session)
