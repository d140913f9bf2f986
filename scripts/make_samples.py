#!/usr/bin/env python3
"""Writes assets/samples/*.hariko from the polygon files, scenes and outlines in tests/golden, the sections in
tests/skinning/data, a knot, a wheel arch, and a shell. The results are checked in.

Run it from anywhere; it needs nothing but Python. It writes exactly what the program itself would write, which a
test checks.
"""

import json
import math
from decimal import Decimal
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests" / "golden"
SECTIONS = ROOT / "tests" / "skinning" / "data"
SAMPLES = ROOT / "assets" / "samples"

# File name, polygons, tensions, name of the object.
MODELS = [
    ("fig2", "fig2", None, "Vase"),
    ("fig2_open", "fig2_open", None, "Vase without a lid"),
    ("fig5c", "fig2", "fig5c", "Vase with a flat lid"),
    ("fig5d", "fig2", "fig5d", "Vase with a pointed rim"),
    ("concave", "concave", None, "Concave block"),
    ("concave_split", "concave", None, "Concave block, split"),
    ("genus3", "genus3", None, "Three holes"),
    ("cube", "cube", None, "Cube"),
    ("torus", "torus", None, "Torus"),
    ("grid3", "grid3", None, "Open grid"),
    ("cube_crease", "cube", "cube_crease", "Cube with a sharp rim"),
    ("car", "car", None, "Car"),
]


# File name, scene of tests/golden/envelope, name of the object.
SCENES = [
    ("solids_one", "box", "Box"),
    ("solids_apart", "two_apart", "Two boxes apart"),
    ("solids_touching", "two_touch", "Two boxes that touch"),
    ("solids_four", "four", "Four solids"),
    ("solids_ten", "ten", "Ten solids"),
    ("solids_l", "ell_tight", "L"),
    ("solids_t", "tee", "T"),
    ("solids_u", "you", "U"),
    ("solids_bottle", "bottle", "Bottle"),
    ("solids_dryer", "dryer", "Hair dryer"),
    ("solids_car", "car", "Car of two boxes"),
    ("solids_camera", "camera", "Camera"),
]


# File name, sections of tests/skinning/data, method, columns and rows of the smooth method, name of the object.
SKINS = [
    ("skin_smooth", "fig5", "smooth", 8, 7, "Two sections, smooth"),
    ("skin_ridges", "fig6a", "pleat", 0, 0, "Ridges as they match by themselves"),
    ("skin_joined", "fig6b", "pleat", 0, 0, "Ridges joined by lines"),
    ("skin_grouped", "fig6c", "pleat", 0, 0, "Ridges grouped by curves"),
    ("skin_between", "fig6b", "anchored", 21, 9, "Ridges joined on a regular grid"),
    ("skin_car_smooth", "car_edited", "smooth", 13, 19, "Car body, smooth"),
    ("skin_car", "car_edited", "pleat", 0, 0, "Car body, pleated"),
    ("skin_merge_inside", "fig9_interior", "pleat", 0, 0, "Two ridges merge on the way"),
    ("skin_merge_end", "fig9_section", "pleat", 0, 0, "Two ridges merge at the end"),
]


def read_obj(path):
    vertices, faces = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words and words[0] == "v":
            vertices.append([float(word) for word in words[1:4]])
        elif words and words[0] == "f":
            faces.append([int(word) - 1 for word in words[1:]])
    return vertices, faces


def split_concave(faces):
    """Both octagons of the U-shaped block, cut into three quadrilaterals each without new vertices."""
    pieces = [(0, 5, 6, 7), (0, 1, 4, 5), (1, 2, 3, 4)]
    result = []
    for face in faces:
        if len(face) != 8:
            result.append(face)
        elif min(face) == 8:
            result += [[v + 8 for v in piece] for piece in pieces]
        else:
            result += [list(reversed(piece)) for piece in pieces]
    return result


def knot(along=125, around=8):
    """A trefoil knot as a tube of 1,000 quadrilaterals that swells and narrows three times: the model for measuring
    how the program keeps up. Rounded to 6 decimals, so that every machine writes the same."""
    def centre(t):
        return (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -1.2 * math.sin(3 * t))

    def minus(a, b):
        return tuple(x - y for x, y in zip(a, b))

    def dot(a, b):
        return sum(x * y for x, y in zip(a, b))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def unit(a):
        return tuple(x / math.sqrt(dot(a, a)) for x in a)

    def carried(normal, tangent):
        return unit(minus(normal, tuple(dot(normal, tangent) * x for x in tangent)))

    step = 2 * math.pi / along
    tangents = [unit(minus(centre((i + 1) * step), centre((i - 1) * step))) for i in range(along)]
    normals = [carried((0, 0, 1), tangents[0])]
    for tangent in tangents[1:]:
        normals.append(carried(normals[-1], tangent))
    # The turn of the frame when it comes round is shared out, so that the last ring meets the first.
    last = carried(normals[-1], tangents[0])
    twist = math.atan2(dot(tangents[0], cross(last, normals[0])), dot(last, normals[0]))
    vertices, faces = [], []
    for i in range(along):
        c, normal = centre(i * step), normals[i]
        binormal = cross(tangents[i], normal)
        radius = 0.62 + 0.16 * math.cos(3 * i * step)
        for k in range(around):
            angle = 2 * math.pi * k / around + twist * i / along
            vertices.append([round(c[j] + radius * (math.cos(angle) * normal[j] + math.sin(angle) * binormal[j]), 6)
                             for j in range(3)])
            ring, turn = (i + 1) % along, (k + 1) % around
            faces.append([i * around + k, ring * around + k, ring * around + turn, i * around + turn])
    return vertices, [face[::-1] for face in faces]


def number(value):
    """The shortest text that reads back as the same double; plain notation unless the other is shorter."""
    if value == 0:
        return "0"
    sign, digits, exponent = Decimal(repr(value)).normalize().as_tuple()
    text = "".join(map(str, digits))
    power = len(text) + exponent - 1
    scientific = text[0] + ("." + text[1:] if len(text) > 1 else "") + f"e{'-' if power < 0 else '+'}{abs(power):02d}"
    plain = format(Decimal((0, digits, exponent)), "f")
    return ("-" if sign else "") + (plain if len(plain) <= len(scientific) else scientific)


def row(entries):
    return "[" + ", ".join(entry if isinstance(entry, str) else number(entry) for entry in entries) + "]"


def rows(name, entries):
    lines = ",\n".join("          " + row(entry) for entry in entries)
    return f'        "{name}": [\n{lines}\n        ]'


def tension_lists(tension):
    """The lists of a polyhedron from a tension file of tests/golden, in the order of the ids."""
    lists = []
    if "alpha" in tension:
        entries = sorted((int(vertex), value) for vertex, value in tension["alpha"].items())
        lists.append(rows("alpha", entries))
    if "beta" in tension:
        edges = {tuple(sorted(map(int, edge.split("-")))): value for edge, value in tension["beta"].items()}
        lists.append(rows("beta", [(*edge, value) for edge, value in sorted(edges.items())]))
    if "crease" in tension:
        lists.append(rows("crease", sorted(tuple(sorted(edge)) for edge in tension["crease"])))
    return lists


def polyhedron(vertices, faces, lists):
    return [
        '        "kind": "polyhedron"',
        '        "mode": "fair"',
        '        "frames": "metric"',
        '        "origin": [0, 0, 0]',
        rows("vertices", [(i, *vertex) for i, vertex in enumerate(vertices)]),
        rows("faces", [(i, *face) for i, face in enumerate(faces)]),
        *lists,
    ]


USUAL_SOLID = {"radius": 0.5, "height": 1, "length": 1, "tube": 0.2, "sides": 6}
SIZES = {
    "sphere": ["radius"],
    "cylinder": ["radius", "height"],
    "cone": ["radius", "height"],
    "prism": ["radius", "height", "sides"],
    "pyramid": ["radius", "height", "sides"],
    "capsule": ["radius", "length"],
    "torus": ["radius", "tube"],
}


def solid_text(place, solid):
    """One solid on one line, its members in the order of the program."""
    kind = solid["type"]
    members = [f'"type": "{kind}"', f'"id": {place}']
    if kind == "box":
        members.append(f'"size": {row(solid.get("size", [1, 1, 1]))}')
    for name in SIZES.get(kind, []):
        members.append(f'"{name}": {number(solid.get(name, USUAL_SOLID[name]))}')
    for name, usual in (("position", 0), ("rotation", 0), ("scale", 1)):
        if name in solid and any(x != usual for x in solid[name]):
            members.append(f'"{name}": {row(solid[name])}')
    return "{" + ", ".join(members) + "}"


# Rounding and radius of the ball of each sample of solids.
BALLS = {
    "solids_apart": (0.0875, "hull"),
    "solids_bottle": (0.0733, 0.88),
    "solids_camera": (0.0528, 0.253),
    "solids_car": (0.112, 1.35),
    "solids_dryer": (0.0775, 0.93),
    "solids_four": (0.13, 1.56),
    "solids_l": (0.108, 1.3),
    "solids_one": (0.0433, 0.52),
    "solids_t": (0.108, 1.3),
    "solids_ten": (0.186, 2.23),
    "solids_touching": (0.0612, 0.735),
    "solids_u": (0.0937, 0.75),
}


def solids(scene, ball):
    lines = ",\n".join("          " + solid_text(k, solid) for k, solid in enumerate(scene["primitives"]))
    usual = {"roundness": 0.5, "clearance": 0}
    return [
        '        "kind": "solids"',
        f'        "primitives": [\n{lines}\n        ]',
        *(f'        "{name}": {number(scene.get(name, value))}' for name, value in usual.items()),
        f'        "rounding": {number(ball[0])}',
        f'        "ball_radius": {json.dumps(ball[1]) if ball[1] == "hull" else number(ball[1])}',
        '        "method": "ball"',
        '        "symmetry": "none"',
    ]


def skin_curve(name, curve):
    points = ", ".join(row(p) for p in curve["points"])
    members = [f'          "points": [{points}]', f'          "closed": {json.dumps(curve.get("closed", False))}']
    if curve.get("sharp"):
        members.append(f'          "sharp": {row(sorted(curve["sharp"]))}')
    return f'        "{name}": {{\n' + ",\n".join(members) + "\n        }"


def skin(layout, method, columns, row_count):
    """Sections along a path; ids are numbered from section to section."""
    sections, ids = [], []
    for k, section in enumerate(layout["sections"]):
        first = ids[-1][-1] + 1 if ids else 0
        ids.append(list(range(first, first + len(section["points"]))))
        points = ", ".join(row(p) for p in section["points"])
        members = [
            f'            "id": {k}',
            f'            "v": {number(section["v"])}',
            f'            "closed": {json.dumps(section.get("closed", False))}',
            f'            "points": [{points}]',
            f'            "ids": {row(ids[-1])}',
        ]
        if section.get("sharp"):
            members.append(f'            "sharp": {row(sorted(section["sharp"]))}')
        sections.append("          {\n" + ",\n".join(members) + "\n          }")
    lines = [
        '        "kind": "skin"',
        skin_curve("path", layout["path"]),
        f'        "frame": "{layout.get("frame", "automatic")}"',
        '        "sections": [\n' + ",\n".join(sections) + "\n        ]",
        f'        "method": "{method}"',
        '        "caps": "none"',
        '        "creases": true',
        '        "flip_normals": false',
        f'        "smooth": {{\n          "columns": {columns},\n          "rows": {row_count},\n'
        '          "parameters": "per-section",\n          "blend": "automatic"\n        }',
        '        "pleat": {\n          "rows": "even",\n          "quad_fans": true,\n          "collars": true,\n'
        '          "exact": "fair",\n          "cost": "parameter",\n          "tension": 200,\n          "density": 1\n        }',
    ]
    count = len(layout["sections"])
    links, merges = [], []
    for link in layout.get("links", []):
        a, b = link["strip"], (link["strip"] + 1) % count
        links.append(f'          {{"id": {len(links)}, "sections": [{a}, {b}], "a": {row(ids[a][i] for i in link["a"])}, '
                     f'"b": {row(ids[b][j] for j in link["b"])}}}')
    for merge in layout.get("merges", []):
        a, b = merge["strip"], (merge["strip"] + 1) % count
        own, other = (ids[a], ids[b]) if merge["side"] == "a" else (ids[b], ids[a])
        merges.append(f'          {{"id": {len(links) + len(merges)}, "sections": [{a}, {b}], "side": "{merge["side"]}", '
                      f'"members": {row(own[i] for i in merge["members"])}, "target": {other[merge["target"]]}, '
                      f'"v": {number(merge["v"])}}}')
    for name, entries in (("links", links), ("merges", merges)):
        if entries:
            lines.append(f'        "{name}": [\n' + ",\n".join(entries) + "\n        ]")
    return lines


def patches(columns, row_count, points):
    return [
        '        "kind": "patches"',
        '        "origin": [0, 0, 0]',
        f'        "columns": {columns}',
        f'        "rows": {row_count}',
        rows("points", points),
    ]


def object_text(number_, name, source, cage=True, network=True):
    members = [
        f'      "id": {number_}',
        f'      "name": {json.dumps(name, ensure_ascii=False)}',
        '      "visible": true',
        '      "locked": false',
        '      "transform": {"rotation": [1, 0, 0, 0], "scale": 1, "translation": [0, 0, 0]}',
        '      "display": {"surface": true, "polyhedron": ' + ("true" if cage else "false") + ', "network": ' + ("true" if network else "false") + ', "map": "shaded", "density": 8, '
        '"colour": "#b9b4ac"}',
        '      "source": {\n' + ",\n".join(source) + "\n      }",
    ]
    return "    {\n" + ",\n".join(members) + "\n    }"


def document(*objects):
    return (
        f'{{\n  "format": "hariko",\n  "version": 10,\n  "unit": "mm",\n  "next_object_id": {len(objects) + 1},\n'
        '  "objects": [\n' + ",\n".join(objects) + "\n  ]\n}\n"
    )


def outline(loops, method, sign="positive", radius=0.6):
    """`loops`: (points, normals, curvature or None)."""
    texts = []
    for points, normals, curvature in loops:
        members = [f'            "{name}": [' + ", ".join(row(entry) for entry in entries) + "]"
                   for name, entries in (("points", points), ("normals", normals))]
        if curvature:
            members.append('            "K": ' + row(curvature))
        texts.append("          {\n" + ",\n".join(members) + "\n          }")
    return [
        '        "kind": "outline"',
        '        "loops": [\n' + ",\n".join(texts) + "\n        ]",
        f'        "method": "{method}"',
        f'        "curvature_sign": "{sign}"',
        f'        "radius": {number(radius)}',
        '        "most_points": 20000',
        '        "mode": "fair"',
        '        "frames": "metric"',
    ]


# File name, outline in tests/golden/gaussmap, millimetres a unit there, mode, name of the object.
OUTLINES = [
    ("sphere_cap", "sphere_cap", 25, "curvature", "Sphere cap"),
    ("ellipsoid_cap", "ellipsoid_cap", 25, "curvature", "Ellipsoid cap"),
    ("paraboloid", "paraboloid", 50, "curvature", "Paraboloid"),
    ("sphere_band", "sphere_band", 50, "curvature", "Spherical band"),
    ("sphere_holes", "three_holes", 50, "curvature", "Sphere with three holes"),
    ("catenoid", "catenoid", 40, "umbilic", "Catenoid"),
    ("saddle", "saddle", 50, "umbilic", "Saddle"),
]


def golden_outline(name, scale):
    """An outline in another size. Rounded, so that every machine writes the same."""
    def vectors(entries, factor):
        return [[round(factor * x, 9) for x in entry] for entry in entries]

    cases = json.loads((GOLDEN / "gaussmap" / f"{name}.json").read_text())["loops"]
    return [(vectors(loop["points"], scale), vectors(loop["normals"], 1),
             [round(k / scale**2, 15) for k in loop["K"]]) for loop in cases]


def shell():
    """The shell of a hand-held device: a flat rim, nearly a superellipse and narrower in front, whose normals lean as those
    of an ellipsoid would, steeper at the back."""
    count, length, width = 32, 62, 40
    points = []
    for i in range(count):
        angle = 2 * math.pi * i / count
        c, s = math.cos(angle), math.sin(angle)
        x = length * math.copysign(abs(c) ** (2 / 2.3), c)
        y = width * math.copysign(abs(s) ** (2 / 2.3), s) * (1 - 0.08 * c)
        points.append((round(x, 6), round(y, 6), 0))
    normals = []
    for i, (x, y, _) in enumerate(points):
        (ax, ay, _), (bx, by, _) = points[i - 1], points[(i + 1) % count]
        chord = math.hypot(bx - ax, by - ay)
        tilt = math.atan(1.4 * width * math.hypot(x / length**2, y / width**2) * (1 - 0.2 * x / length))
        normals.append((round(math.sin(tilt) * (by - ay) / chord, 9), round(-math.sin(tilt) * (bx - ax) / chord, 9),
                        round(math.cos(tilt), 9)))
    return [(points, normals, None)]


PARTS = 8  # patches round the wheel


def fender(ring, angle):
    """A point of the fender on curve `ring` (0: the outer edge, 3: round the wheel), and its derivative."""
    across, up, bulge = [(95, 62, 0), (72, 55, 4), (52, 46, 12), (40, 40, 13)][ring]
    c, s = math.cos(angle), math.sin(angle)
    x, z = across * c, up * s + (8 if ring == 0 else 4 if ring == 1 else 0)
    dx, dz = -across * s, up * c
    # The side of the car is arched along and across; towards the viewer is -y.
    return (x, x * x / 700 + z * z / 500 - bulge, z), (dx, 2 * x * dx / 700 + 2 * z * dz / 500, dz)


def wheel_arch():
    """Bicubic patches round a wheel's opening, and a polyhedron that closes it, tangent-continuous all round."""
    points = []
    for ring in range(4):
        for i in range(3 * PARTS + 1):
            corner = (i + 1) // 3 % PARTS
            at, slope = fender(ring, 2 * math.pi * corner / PARTS)
            step = ((i + 1) % 3 - 1) * 2 * math.pi / PARTS / 3
            points.append(tuple(p + step * d for p, d in zip(at, slope)))
    rim = [points[3 * (3 * PARTS + 1) + 3 * k] for k in range(PARTS)]
    vertices = list(rim)
    for share, bulge in ((0.66, 14), (0.32, 14.5)):
        for x, y, z in rim:
            x, z = round(share * x, 6), round(share * z, 6)
            vertices.append((x, round(x * x / 700 + z * z / 500 - bulge, 6), z))
    faces = []
    for ring in (0, PARTS):
        for k in range(PARTS):
            after = (k + 1) % PARTS
            faces.append([ring + k, ring + after, ring + PARTS + after, ring + PARTS + k])
    faces.append([2 * PARTS + k for k in range(PARTS)])
    attached = []
    for k in range(PARTS):
        low, high = sorted((k, (k + 1) % PARTS))
        attached.append(((low, high), PARTS - 1 - k))
    lines = ",\n".join(
        f'          {{"edge": [{low}, {high}], "patch": 1, "side": [2, {place}], "reversed": true, '
        '"continuity": "g1", "adapts": "surface"}'
        for (low, high), place in sorted(attached)
    )
    joined = f'        "attached": [\n{lines}\n        ]'
    return document(
        object_text(1, "Fender", patches(PARTS, 1, points), cage=False),
        object_text(2, "Wheel cover", polyhedron(vertices, faces, [joined])),
    )


def main():
    SAMPLES.mkdir(parents=True, exist_ok=True)
    for file_name, polygons, tension_name, name in MODELS:
        vertices, faces = read_obj(GOLDEN / f"{polygons}.obj")
        if file_name == "concave_split":
            faces = split_concave(faces)
        tension = json.loads((GOLDEN / f"{tension_name}.tension.json").read_text()) if tension_name else {}
        text = document(object_text(1, name, polyhedron(vertices, faces, tension_lists(tension))))
        (SAMPLES / f"{file_name}.hariko").write_text(text, encoding="utf-8", newline="\n")
    for file_name, scene_name, name in SCENES:
        scene = json.loads((GOLDEN / "envelope" / f"{scene_name}.json").read_text())
        text = document(object_text(1, name, solids(scene, BALLS[file_name]), network=False))
        (SAMPLES / f"{file_name}.hariko").write_text(text, encoding="utf-8", newline="\n")
    for file_name, sections, method, columns, row_count, name in SKINS:
        layout = json.loads((SECTIONS / f"{sections}.json").read_text())
        text = document(object_text(1, name, skin(layout, method, columns, row_count)))
        (SAMPLES / f"{file_name}.hariko").write_text(text, encoding="utf-8", newline="\n")
    text = document(object_text(1, "Knot", polyhedron(*knot(), [])))
    (SAMPLES / "knot.hariko").write_text(text, encoding="utf-8", newline="\n")
    for file_name, case, scale, method, name in OUTLINES:
        sign = "negative" if method == "umbilic" else "positive"
        text = document(object_text(1, name, outline(golden_outline(case, scale), method, sign)))
        (SAMPLES / f"{file_name}.hariko").write_text(text, encoding="utf-8", newline="\n")
    text = document(object_text(1, "Shell", outline(shell(), "umbilic")))
    (SAMPLES / "shell.hariko").write_text(text, encoding="utf-8", newline="\n")
    (SAMPLES / "wheel_arch.hariko").write_text(wheel_arch(), encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
