"""The export dialog for four formats: unit, scale and up axis, remembered for each format; only what is selected; what was
written comes back in the right size by import."""

import os
import struct

from driver import Window, check, run


def corners_of_stl(path):
    with open(path, "rb") as file:
        data = file.read()
    count = struct.unpack_from("<I", data, 80)[0]
    check(len(data) == 84 + 50 * count and count > 0, f"{path} is no binary STL")
    return [struct.unpack_from("<3f", data, 84 + 50 * t + 12 + 12 * c) for t in range(count) for c in range(3)]


def extent(points):
    return [max(p[a] for p in points) - min(p[a] for p in points) for a in range(3)]


def rewrite_name(window, path):
    """Another name in the dialog, which stays open."""
    window.click_on("dialog.name")
    window.key("ctrl+a")
    window.type(path)


def choose(window, combo, item):
    window.click_on(combo)
    window.click_on(item)
    window.wait(lambda: item not in window.last("layout")["rects"], "the list to close")


def number(window, field, text):
    window.click_on(field)
    window.key("ctrl+a")
    window.type(text)
    window.key("Tab")


def export(window, path, before=lambda: None):
    count = window.count("exported")
    window.key("ctrl+e")
    window.rect("export.by")
    rewrite_name(window, path)
    before()
    window.click_on("dialog.accept")
    window.wait(lambda: window.count("exported") == count + 1, "the file")
    window.wait_idle()


def session(program, source, output):
    window = Window(program, os.path.join(source, "assets", "samples", "fig2.hariko"))
    try:
        folder = window.folder

        def path(name):
            return os.path.join(folder, name)

        export(window, path("plain.stl"))
        plain = extent(corners_of_stl(path("plain.stl")))

        def in_centimetres():
            choose(window, "export.unit", "export.unit.cm")
            number(window, "export.scale", "3")
            window.click_on("export.up.y")
            window.wait_idle()
            window.screenshot(os.path.join(output, "export_stl.png"))

        export(window, path("other.stl"), in_centimetres)
        other = extent(corners_of_stl(path("other.stl")))
        expected = [0.3 * plain[0], 0.3 * plain[2], 0.3 * plain[1]]
        check(all(abs(a - b) < 1e-5 * max(expected) for a, b in zip(other, expected)),
              f"{other} instead of {expected}")

        # glTF leaves no choice of unit and axis; its settings are its own.
        def of_gltf():
            window.wait(lambda: "export.unit" not in window.last("layout")["rects"], "no unit to choose")
            check("export.up.y" not in window.last("layout")["rects"], "an axis to choose for glTF")
            window.wait_idle()
            window.screenshot(os.path.join(output, "export_glb.png"))

        export(window, path("a.glb"), of_gltf)
        with open(path("a.glb"), "rb") as file:
            check(file.read(4) == b"glTF", "no glTF file")
        export(window, path("a.3mf"))
        with open(path("a.3mf"), "rb") as file:
            check(file.read(2) == b"PK", "no 3MF file")

        # The settings of STL are still there.
        export(window, path("again.stl"))
        check(open(path("again.stl"), "rb").read() == open(path("other.stl"), "rb").read(),
              "the settings of the format were not remembered")

        # Back in.
        objects = len(window.last("layout")["rects"])
        window.key("ctrl+i")
        window.rect("dialog.name")
        count = window.count("imported")
        window.type_path(path("other.stl"))
        window.wait(lambda: window.count("imported") == count + 1, "the mesh")
        check(len(window.last("layout")["rects"]) > 0 and objects > 0, "an empty window")
    finally:
        window.close()


run(session)
