#!/usr/bin/env python3
"""Writes assets/samples/*.hariko from the polygon files in tests/golden. The results are checked in.

Run it from anywhere; it needs nothing but Python. It writes exactly what the program itself would write, which a
test checks.
"""

import json
from decimal import Decimal
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
GOLDEN = ROOT / "tests" / "golden"
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


def document(name, vertices, faces, tension):
    source = [
        '        "kind": "polyhedron"',
        '        "mode": "fair"',
        '        "origin": [0, 0, 0]',
        rows("vertices", [(i, *vertex) for i, vertex in enumerate(vertices)]),
        rows("faces", [(i, *face) for i, face in enumerate(faces)]),
        *tension_lists(tension),
    ]
    members = [
        '      "id": 1',
        f'      "name": {json.dumps(name, ensure_ascii=False)}',
        '      "visible": true',
        '      "locked": false',
        '      "transform": {"rotation": [1, 0, 0, 0], "scale": 1, "translation": [0, 0, 0]}',
        '      "display": {"surface": true, "polyhedron": true, "network": true, "map": "shaded", "density": 8, '
        '"colour": "#b9b4ac"}',
        '      "source": {\n' + ",\n".join(source) + "\n      }",
    ]
    return (
        '{\n  "format": "hariko",\n  "version": 1,\n  "unit": "mm",\n  "next_object_id": 2,\n  "objects": [\n    {\n'
        + ",\n".join(members)
        + "\n    }\n  ]\n}\n"
    )


def main():
    SAMPLES.mkdir(parents=True, exist_ok=True)
    for file_name, polygons, tension_name, name in MODELS:
        vertices, faces = read_obj(GOLDEN / f"{polygons}.obj")
        if file_name == "concave_split":
            faces = split_concave(faces)
        tension = json.loads((GOLDEN / f"{tension_name}.tension.json").read_text()) if tension_name else {}
        text = document(name, vertices, faces, tension)
        (SAMPLES / f"{file_name}.hariko").write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
