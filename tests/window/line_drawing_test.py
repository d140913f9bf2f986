"""The lines of the view as SVG: format and options in the dialog, layers in the file, and lines where the picture of the
same view has its edges."""

import json
import math
import os
import shutil
import struct
import tempfile
import xml.etree.ElementTree
import zlib

from driver import Window, check, run

SVG = "{http://www.w3.org/2000/svg}"


def alpha_of(path):
    """Rows of opacity of a PNG with eight bits a channel and alpha, not interlaced."""
    with open(path, "rb") as file:
        data = file.read()
    at, packed = 8, b""
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack_from(">IIBB", body)
            check((depth, colour) == (8, 6), "not the kind of PNG that is written")
        if kind == b"IDAT":
            packed += body
        at += 12 + length
    raw, rows, before = zlib.decompress(packed), [], bytes(4 * width)
    for y in range(height):
        start = y * (4 * width + 1)
        method, row = raw[start], bytearray(raw[start + 1:start + 1 + 4 * width])
        for i in range(3, len(row), 4):
            left, up = row[i - 4] if i > 3 else 0, before[i]
            corner = before[i - 4] if i > 3 else 0
            guess = left + up - corner
            nearest = min((abs(guess - left), 0, left), (abs(guess - up), 1, up), (abs(guess - corner), 2, corner))[2]
            row[i] = (row[i] + (0, left, up, (left + up) // 2, nearest)[method]) & 255
        before = bytes(row)
        rows.append(before[3::4])
    return rows


def layers_of(path):
    """The page's size in millimetres and the lines of each layer."""
    root = xml.etree.ElementTree.parse(path).getroot()
    check(root.tag == SVG + "svg", f"{root.tag} is no drawing")
    size = [float(root.get(side).removesuffix("mm")) for side in ("width", "height")]
    check(root.get("viewBox") == f"0 0 {root.get('width')[:-2]} {root.get('height')[:-2]}", root.get("viewBox"))
    layers = {}
    for layer in root:
        lines = layers.setdefault(layer.get("id"), [])
        for item in layer:
            text = item.get("d")
            numbers = [float(n) for n in text.strip("MZ").replace("L", " ").split()]
            points = list(zip(numbers[::2], numbers[1::2]))
            lines.append(points + points[:1] if text.endswith("Z") else points)
    return size, layers


def along(lines, scale):
    """Places on lines, at most half a pixel apart."""
    for points in lines:
        for (ax, ay), (bx, by) in zip(points, points[1:]):
            count = max(1, math.ceil(2 * scale * math.hypot(bx - ax, by - ay)))
            for k in range(count + 1):
                yield scale * (ax + k / count * (bx - ax)), scale * (ay + k / count * (by - ay))


def compare(rows, lines, scale):
    """Every line lies on the model or at its end, and wherever the model ends there is a line."""
    width, height = len(rows[0]), len(rows)

    def covered(x, y):
        return 0 <= x < width and 0 <= y < height and rows[y][x] > 127

    near = set()
    for px, py in along(lines, scale):
        x, y = math.floor(px), math.floor(py)
        around = [(x + dx, y + dy) for dx in range(-2, 3) for dy in range(-2, 3)]
        near.update(around)
        check(any(covered(*place) for place in around), f"a line beside the model at {x}, {y}")
    ends = 0
    for y in range(1, height - 1):
        for x in range(1, width - 1):
            if not covered(x, y) or (covered(x - 1, y) and covered(x + 1, y) and covered(x, y - 1) and covered(x, y + 1)):
                continue
            ends += 1
            check((x, y) in near, f"no line where the model ends, at {x}, {y}")
    check(ends > 300, f"only {ends} pixels at the end of the model")


def choose_format(window, ending):
    window.click_on("dialog.format")
    window.click_on("dialog.format" + ending)
    window.wait(lambda: "dialog.format" + ending not in window.last("layout")["rects"], "the list to close")


def open_dialog(window):
    window.key("F3")
    window.rect("palette.input")
    window.wait_idle()  # the field takes letters from its second frame on
    window.type("export picture")
    window.rect("palette.selected.file.export_picture")
    window.key("Return")
    window.rect("dialog.format")
    window.wait_idle()


def accept(window, name, folder):
    count = window.count("exported")
    window.click_on("dialog.name")
    window.key("ctrl+a")
    window.type(os.path.join(folder, name))
    window.click_on("dialog.accept")
    window.wait(lambda: window.count("exported") == count + 1, "the file " + name)
    window.wait_idle()


def surface_alone(sample, folder):
    """A copy of the document that shows neither polyhedron nor network."""
    with open(sample, encoding="utf-8") as file:
        document = json.load(file)
    for item in document["objects"]:
        item["display"].update(polyhedron=False, network=False)
    path = os.path.join(folder, "alone.hariko")
    with open(path, "w", encoding="utf-8") as file:
        json.dump(document, file)
    return path


def session(program, source, output):
    folder = tempfile.mkdtemp(prefix="hariko-lines-")
    window = Window(program, surface_alone(os.path.join(source, "assets", "samples", "fig2.hariko"), folder))
    try:
        window.wait_event("opened", 0)
        window.wait_idle()

        # A picture and the lines of the same view.
        open_dialog(window)
        window.click_on("picture.transparent")
        window.click_on("picture.grid")
        accept(window, "a.png", folder)
        open_dialog(window)
        choose_format(window, ".svg")
        window.rect("picture.page_width")
        window.wait_idle()
        window.click_on("picture.hidden")
        window.wait_idle()
        window.screenshot(os.path.join(output, "line_drawing_dialog.png"))
        accept(window, "a.svg", folder)
        size, layers = layers_of(os.path.join(folder, "a.svg"))
        check(size[0] == 180, f"the page is {size[0]} mm wide")
        # It bends outwards everywhere: nothing hides its outline.
        expected = {"silhouette", "network", "network-hidden"}
        check(set(layers) == expected, f"the layers {sorted(layers)}")
        rows = alpha_of(os.path.join(folder, "a.png"))
        check(abs(size[0] / size[1] - len(rows[0]) / len(rows)) < 1e-3, "the page has another shape than the picture")
        compare(rows, [line for lines in layers.values() for line in lines], len(rows[0]) / size[0])

        # Another page, without the network and what is hidden; the format is remembered.
        open_dialog(window)
        window.click_on("picture.page_width")
        window.key("ctrl+a")
        window.type("9 cm")
        window.key("Tab")
        window.click_on("picture.hidden")
        window.click_on("picture.network")
        accept(window, "b.svg", folder)
        small, few = layers_of(os.path.join(folder, "b.svg"))
        check(small[0] == 90, f"the page is {small[0]} mm wide")
        check(set(few) == {"silhouette"}, f"the layers {sorted(few)}")
        check(window.quit() == 0, "the program did not end well")
    finally:
        window.close()
        shutil.rmtree(folder, ignore_errors=True)


run(session)
