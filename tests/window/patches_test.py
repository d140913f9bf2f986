"""Files of Bezier patches: each layout opens as one object a name, is meshed as one surface, taken apart into patches
that can be edited, put together, saved and opened again."""

import os
import tempfile

from driver import Window, check, run

# Two bicubic patches that share a row of points: text, and the same by numbers of points.
POINTS = [(x, y, 0.3 * (x - 3) ** 2 / 9 + 0.2 * y) for x in range(7) for y in range(4)]
INDEXED = ("2\n" + ",".join(map(str, range(1, 17))) + "\n" + ",".join(map(str, range(13, 29))) + "\n28\n" +
           "".join(f"{x},{y},{z}\n" for x, y, z in POINTS))
PLAIN = "2\n" + "".join("3 3\n" + "".join(f"{x} {y} {z}\n" for x, y, z in POINTS[first:first + 16]) for first in (0, 12))
# A quarter of a cylinder, exact, and a plane of degree 4 by 1 at its side.
RATIONAL = """{"arc": [{"ctrl": [[[1,0,0],[1,0,2]],[[1,1,0],[1,1,2]],[[0,1,0],[0,1,2]]],
  "weights": [[1,1],[0.70710678118654752,0.70710678118654752],[1,1]]},
  {"ctrl": [[[1,0,0],[1,0,2]],[[1,-0.5,0],[1,-0.5,2]],[[1,-1,0],[1,-1,2]],[[1,-1.5,0],[1,-1.5,2]],
  [[1,-2,0],[1,-2,2]]]}]}"""


def rows(window):
    """The objects that the list shows."""
    return {name for name in window.last("layout")["rects"] if name.startswith("object.")}


def wait_rows(window, count):
    window.wait(lambda: len(rows(window)) == count, f"{count} objects, not {sorted(rows(window))}")
    window.wait_idle()


def wait_label(window, label):
    window.wait(lambda: window.last("document")["label"] == label, f"the step {label!r}")
    window.wait_idle()


def facets(window):
    """The triangles that the panel for meshes counts, opened and closed again."""
    made = window.count("meshed")
    window.key("ctrl+alt+t")
    window.wait(lambda: window.count("meshed") > made, "a mesh")
    window.wait_idle()
    counts = [name for name in window.last("layout")["rects"] if name.startswith("meshing.count.")]
    check(len(counts) == 1, "the panel shows no count")
    window.click_on("meshing.close")
    window.wait_idle()
    return int(counts[0].rsplit(".", 1)[1])


def save_as(window, path):
    saved = window.count("saved")
    window.key("ctrl+shift+s")
    window.type_path(path)
    window.wait_event("saved", saved)
    window.wait_idle()


def opened(program, path):
    window = Window(program, path)
    window.wait_event("opened", 0)
    window.wait_idle()
    return window


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        def write(name, text):
            path = os.path.join(folder, name)
            with open(path, "w", encoding="ascii") as file:
                file.write(text)
            return path

        # Both texts are the same surface: one object, one mesh.
        window = opened(program, write("sheet.bpt", PLAIN))
        try:
            wait_rows(window, 1)
            window.rect("patches.count")
            plain = facets(window)
        finally:
            window.close()
        window = opened(program, write("indexed.bpt", INDEXED))
        try:
            wait_rows(window, 1)
            check(facets(window) == plain, "the indexed file is meshed otherwise")
            window.screenshot(os.path.join(output, "patches_welded.png"))

            # Taken apart, back, and again; put together.
            window.key("4")
            window.click_on("button.separate_patches")
            wait_label(window, "Separate patches")
            wait_rows(window, 2)
            window.screenshot(os.path.join(output, "patches_separate.png"))
            window.key("ctrl+z")
            wait_rows(window, 1)
            window.key("ctrl+shift+z")
            wait_rows(window, 2)
            window.key("ctrl+a")
            window.wait_idle()
            window.key("F3")
            window.rect("palette.input")
            window.type("weld patches")
            window.rect("palette.selected.shape.weld_patches")
            window.key("Return")
            wait_label(window, "Weld patches")
            wait_rows(window, 1)
            check(facets(window) == plain, "the welded surface is meshed otherwise")
            save_as(window, os.path.join(folder, "sheet.hariko"))
        finally:
            window.close()
        window = opened(program, os.path.join(folder, "sheet.hariko"))
        try:
            wait_rows(window, 1)
            check(facets(window) == plain, "the saved surface is meshed otherwise")
        finally:
            window.close()

        # Weights and another degree; and names, each an object.
        window = opened(program, write("arc.json", RATIONAL))
        try:
            wait_rows(window, 1)
            window.rect("patches.weights")
            check(facets(window) > 10, "the arc is not meshed")
            window.screenshot(os.path.join(output, "patches_rational.png"))

            # Another file comes in beside it.
            window.key("ctrl+i")
            imported = window.count("imported")
            window.type_path(os.path.join(folder, "sheet.bpt"))
            window.wait_event("imported", imported)
            wait_rows(window, 2)
        finally:
            window.close()
        window = opened(program, os.path.join(source, "tests", "golden", "approximation", "surfaces.json"))
        try:
            # The list shows the last of the eight; the first has scrolled out.
            window.wait(lambda: "object.8" in rows(window), f"eight objects, not {sorted(rows(window))}")
            window.wait_idle()
            window.screenshot(os.path.join(output, "patches_names.png"))
        finally:
            window.close()


if __name__ == "__main__":
    run(session)
