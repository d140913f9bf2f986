"""A session in the real window: move a vertex, set tensions, undo and redo, save, reopen, export; the files are
checked."""

import collections
import json
import os
import struct
import tempfile

from driver import Window, check, run


def objects(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)["objects"]


def edges_are_closed(triangles):
    """Every directed edge once, and its opposite once."""
    edges = collections.Counter()
    for triangle in triangles:
        for i in range(3):
            edges[(triangle[i], triangle[(i + 1) % 3])] += 1
    return bool(edges) and all(n == 1 and edges[(b, a)] == 1 for (a, b), n in edges.items())


def obj_triangles(path):
    with open(path, encoding="ascii") as file:
        return [tuple(int(corner.split("/")[0]) for corner in line.split()[1:]) for line in file
                if line.startswith("f ")]


def stl_triangles(path):
    with open(path, "rb") as file:
        data = file.read()
    (count,) = struct.unpack_from("<I", data, 80)
    check(len(data) == 84 + 50 * count, "the STL file has another size than its count says")
    return [tuple(data[at + 12 + 12 * i:at + 24 + 12 * i] for i in range(3)) for at in range(84, len(data), 50)]


def session(program, source, output):
    sample = os.path.join(source, "assets", "samples", "fig2.hariko")
    with tempfile.TemporaryDirectory() as folder:
        saved, exported = os.path.join(folder, "a.hariko"), os.path.join(folder, "b.obj")
        model(program, sample, folder, saved, output)
        reopen_and_export(program, saved, exported, folder)


def model(program, sample, folder, saved, output):
    window = Window(program, sample)
    try:
        # Drag a vertex: the surface follows while the button is down, and one step comes of it.
        vertex = window.nearest_vertex()
        x, y, _ = window.vertex(vertex)
        drags = window.count("rebuild", quality="drag")
        window.drag((x, y), (x + 60, y + 40),
                    before_release=lambda: window.wait_event("rebuild", drags + 1, quality="drag"))
        window.wait(lambda: window.last("document")["position"] == 1 and not window.last("document")["gesture"],
                    "the step of the drag")
        check(window.last("document")["label"] == "Move vertex", "the step is called " + window.last("document")["label"])
        window.wait_idle()
        check(window.last("rebuild")["quality"] == "final", "the last surface is not final")
        moved = window.vertex(vertex)
        check(abs(moved[0] - x - 60) < 2 and abs(moved[1] - y - 40) < 2, f"the vertex is at {moved}, not at the pointer")

        # Esc in the middle of a drag restores exactly.
        window.move(moved[0], moved[1])
        window.press()
        window.move(moved[0] - 30, moved[1])
        window.move(moved[0] - 60, moved[1])
        window.wait(lambda: window.last("document")["gesture"], "the gesture")
        window.key("Escape")
        window.release()
        window.wait_idle()
        check(window.last("document")["position"] == 1, "a cancelled drag made a step")
        check(window.vertex(vertex) == moved, "a cancelled drag left the vertex elsewhere")

        # The vertex is selected: drag the slider of its tension.
        window.screenshot(os.path.join(output, "modelling_vertex.png"))
        left, top, width, height = window.rect("slider.alpha")
        rebuilds = window.count("rebuild", quality="drag")
        window.drag((left + 8, top + height / 2), (left + width * 0.6, top + height / 2),
                    before_release=lambda: window.wait_event("rebuild", rebuilds + 1, quality="drag"))
        window.wait(lambda: window.last("document")["position"] == 2 and not window.last("document")["gesture"],
                    "the step of the slider")
        check(window.last("document")["label"] == "Tension of vertex", "the slider's step has another label")

        # An edge: select it in the middle between two neighbouring vertices, and type its tension.
        window.key("2")
        window.click(*edge_pixel(window, sample, vertex))
        window.wait(lambda: window.last("document")["selection"] == "1 edge", "a selected edge")
        window.click_on("field.beta")
        window.key("ctrl+a")
        window.type("25")
        window.key("Return")
        window.wait(lambda: window.last("document")["position"] == 3, "the step of the typed tension")

        # Undo and redo everything.
        for position in (2, 1, 0):
            window.key("ctrl+z")
            window.wait(lambda: window.last("document")["position"] == position, f"undo to {position}")
        check(not window.last("document")["dirty"], "back at the start the document still counts as edited")
        window.key("ctrl+shift+z")
        window.key("ctrl+y")
        window.key("ctrl+shift+z")
        window.wait(lambda: window.last("document")["position"] == 3, "redo")
        window.wait_idle()
        window.screenshot(os.path.join(output, "modelling_edge.png"))

        window.key("ctrl+shift+s")
        window.type_path(saved)
        window.wait_event("saved", 0)
        window.wait_idle()
        check(not window.last("document")["dirty"], "the saved document counts as edited")
        check(window.quit() == 0, "the program did not end well")
    finally:
        window.close()
    before, after = objects(sample)[0], objects(saved)[0]
    compare(before["source"], after["source"], int(vertex))


def edge_pixel(window, sample, vertex):
    """A point on an edge between two vertices near the eye: a quarter of the way, where nothing else is."""
    faces = objects(sample)[0]["source"]["faces"]
    neighbours = set()
    for _, *face in faces:  # an id, then the corners
        for i, corner in enumerate(face):
            if corner == int(vertex):
                neighbours |= {face[i - 1], face[(i + 1) % len(face)]}
    nearest = min(neighbours, key=lambda v: window.vertex(v)[2])
    a, b = window.vertex(vertex), window.vertex(nearest)
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2


def flat(value):
    """All numbers of a JSON value with their paths."""
    if isinstance(value, dict):
        return {(k,) + p: v for k, child in value.items() for p, v in flat(child).items()}
    if isinstance(value, list):
        return {(i,) + p: v for i, child in enumerate(value) for p, v in flat(child).items()}
    return {(): value}


def compare(before, after, vertex):
    old, new = flat(before), flat(after)
    changed = [path for path in old if old[path] != new.get(path)]
    added = {path: value for path, value in new.items() if path not in old}
    check(changed and all(path[0] == "vertices" and path[1] == vertex for path in changed),
          f"other things than vertex {vertex} changed: {changed}")
    numbers = [value for value in added.values() if isinstance(value, (int, float))]
    check(25 in numbers, f"the typed edge tension is not in the file: {added}")
    check(any("alpha" in path for path in map(str, added)) and any(0.1 < n < 1000 and n != 25 for n in numbers),
          f"the vertex tension is not in the file: {added}")


def reopen_and_export(program, saved, exported, folder):
    window = Window(program)
    try:
        window.key("ctrl+o")
        window.type_path(saved)
        window.wait_event("opened", 0)
        window.wait_idle()
        window.key("ctrl+e")
        window.type_path(exported)
        window.wait_event("exported", 0)
        stl = os.path.join(folder, "c.stl")
        window.key("ctrl+e")
        window.type_path(stl)
        window.wait_event("exported", 1)
        check(window.quit() == 0, "the program did not end well")
    finally:
        window.close()
    check(edges_are_closed(obj_triangles(exported)), "the exported OBJ is not closed")
    triangles = stl_triangles(stl)
    # What the 32-bit numbers of STL lose is taken from the tolerance, so that it may need a few triangles more.
    check(len(obj_triangles(exported)) <= len(triangles) <= 1.01 * len(obj_triangles(exported)),
          f"the OBJ has {len(obj_triangles(exported))} triangles, the STL {len(triangles)}")
    check(edges_are_closed(triangles), "the exported STL is not closed")


run(session)
