"""The export dialog for three formats: unit, scale and up axis, text or binary, remembered for each format; what was written
comes back by import, with the names and sizes that the format keeps."""

import json
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

        def coarse():
            """Few triangles: each import makes a polyhedron of them."""
            number(window, "export.distance", "0.05 mm")

        export(window, path("plain.stl"), coarse)
        plain = extent(corners_of_stl(path("plain.stl")))

        # Settings are those that the format had last, so that the triangles are coarse still.
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
            coarse()
            window.wait_idle()
            window.screenshot(os.path.join(output, "export_glb.png"))

        export(window, path("a.glb"), of_gltf)
        with open(path("a.glb"), "rb") as file:
            check(file.read(4) == b"glTF", "no glTF file")
        export(window, path("a.3mf"), coarse)
        with open(path("a.3mf"), "rb") as file:
            check(file.read(2) == b"PK", "no 3MF file")

        # The settings of STL are still there.
        export(window, path("again.stl"))
        check(open(path("again.stl"), "rb").read() == open(path("other.stl"), "rb").read(),
              "the settings of the format were not remembered")

        # The same as text.
        def as_text():
            window.click_on("export.ascii")
            window.wait_idle()
            window.screenshot(os.path.join(output, "export_text.png"))

        export(window, path("text.stl"), as_text)
        with open(path("text.stl"), encoding="ascii") as file:
            words = file.read().split()
        found = extent([[float(word) for word in words[i + 1:i + 4]] for i, word in enumerate(words) if word == "vertex"])
        check(words[0] == "solid" and all(abs(a - b) < 1e-5 * max(other) for a, b in zip(found, other)),
              f"text of {found} instead of {other}")

        # Back in: formats that say their unit have the size of the model and its name, STL has the numbers of the file.
        names = ("other.stl", "a.glb", "a.3mf")
        for number_before, name in enumerate(names):
            window.key("ctrl+i")
            window.rect("dialog.name")
            window.type_path(path(name))
            window.wait_event("imported", number_before)
            window.wait_idle()
        window.screenshot(os.path.join(output, "export_imported.png"))
        window.key("ctrl+s")
        window.wait_event("saved", 0)
        with open(path("fig2.hariko"), encoding="utf-8") as file:
            objects = json.load(file)["objects"]
        check(len(objects) == 4, f"{len(objects)} objects instead of 4")
        for item, size in zip(objects[1:], (other, plain, plain)):
            found = extent([row[1:] for row in item["source"]["vertices"]])
            check(all(abs(a - b) < 1e-5 * max(size) for a, b in zip(found, size)),
                  f"{item['name']}: {found} instead of {size}")
        found = [item["name"] for item in objects]
        check(found == ["Vase", "other", "Vase", "Vase"], f"the names {found}")
        check(window.quit() == 0, "the program did not end well")
    finally:
        window.close()


run(session)
