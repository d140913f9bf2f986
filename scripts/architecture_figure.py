#!/usr/bin/env python3
"""Draws who includes whom, from the #include lines: the layers, and the folders of core.

  scripts/architecture_figure.py             writes docs/pictures/architecture.svg
  scripts/architecture_figure.py --check     exit code 1 when that picture is not what the sources give, or when
                                             docs/architecture.md lacks a sentence about a folder or has one too many
  scripts/architecture_figure.py --arrows    prints the arrows instead

A folder stands above all that it includes, as low as that allows. An arrow that follows from others is left out
(transitive reduction). Folders are found, not listed: a layer is a folder at the top with sources, but for tests and
benchmarks, which may include everything. The same sources give the same picture, to the byte."""

import argparse
import os
import random
import re
import sys

ENDINGS = (".cpp", ".hpp")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.M)
OUTSIDE = {"build", "tests", "bench"}
INNER = "core"  # the layer whose folders are shown
PICTURE = "docs/pictures/architecture.svg"
PAGE = "docs/architecture.md"
SENTENCE = re.compile(r"^\| `(\w+)/` \|", re.M)

BOX_HEIGHT, LETTER = 34, 8.4  # sizes of a folder of core; no letter of a name is wider on average
LAYER = (220, 40)
GAP = 26           # between boxes of a row
ROW = 78           # from row to row
LAYER_ROW = 72
THREAD = 22        # room of an arrow that passes a row
MARGIN = 24


# --- the arrows


def sources(top):
    for layer in sorted(os.listdir(top)):
        if layer in OUTSIDE or layer.startswith(".") or not os.path.isdir(os.path.join(top, layer)):
            continue
        for folder, folders, names in os.walk(os.path.join(top, layer)):
            folders.sort()
            for name in sorted(names):
                if name.endswith(ENDINGS):
                    yield os.path.relpath(os.path.join(folder, name), top).replace(os.sep, "/")


def read_arrows(top):
    """(arrows between layers, arrows between folders of the inner layer), each {folder: set of folders}."""
    layers, rooms = {}, {}
    files = list(sources(top))
    compiled = {path.split("/")[0] for path in files if path.endswith(".cpp")}  # others hold no code of their own
    files = [path for path in files if path.split("/")[0] in compiled]
    for path in files:
        parts = path.split("/")
        layers.setdefault(parts[0], set())
        if parts[0] == INNER and len(parts) > 2:
            rooms.setdefault(parts[1], set())
    for path in files:
        own = path.split("/")
        with open(os.path.join(top, path), encoding="utf-8", errors="replace") as stream:
            for target in INCLUDE.findall(stream.read()):
                other = target.split("/")
                if other[0] != own[0] and other[0] in layers:
                    layers[own[0]].add(other[0])
                elif own[0] == other[0] == INNER and len(own) > 2 and len(other) > 2 and own[1] != other[1]:
                    rooms[own[1]].add(other[1])
    return layers, rooms


def reached(graph, start, left_out=None):
    seen, open_ = set(), [start]
    while open_:
        here = open_.pop()
        for other in graph.get(here, ()):
            if (here, other) != left_out and other not in seen:
                seen.add(other)
                open_.append(other)
    return seen


def reduced(graph):
    """Arrows that do not follow from the others, sorted. Ends the program where folders include each other."""
    for folder in sorted(graph):
        if folder in reached(graph, folder):
            ring = sorted(x for x in reached(graph, folder) if folder in reached(graph, x))
            sys.exit("architecture_figure.py: these folders include each other: " + ", ".join(ring))
    return [(a, b) for a in sorted(graph) for b in sorted(graph[a]) if b not in reached(graph, a, (a, b))]


# --- the places


def rows_of(nodes, arrows):
    """Row of each node, 0 at the bottom: as low as possible, then up where that makes arrows shorter."""
    below = {n: [b for a, b in arrows if a == n] for n in nodes}
    above = {n: [a for a, b in arrows if b == n] for n in nodes}
    row = {}

    def lowest(n):
        if n not in row:
            row[n] = 1 + max((lowest(b) for b in below[n]), default=-1)
        return row[n]

    for n in nodes:
        lowest(n)
    for n in sorted(nodes, key=lambda n: -row[n]):
        if len(above[n]) > len(below[n]):
            row[n] = max(row[n], min(row[a] for a in above[n]) - 1)
    return row


class Layout:
    """Rows from bottom to top; an arrow over several rows has a thread, a place of its own, in each between."""

    def __init__(self, nodes, arrows, width):
        self.row = rows_of(nodes, arrows)
        self.width = {n: width for n in nodes}
        self.chains = []  # chain of each arrow: from its upper end to its lower one
        for a, b in arrows:
            threads = [(a, b, r) for r in range(self.row[a] - 1, self.row[b], -1)]
            for t in threads:
                self.row[t], self.width[t] = t[2], THREAD
            self.chains.append([a] + threads + [b])
        self.height = 1 + max(self.row.values())
        self.links = sorted({(u, v) for chain in self.chains for u, v in zip(chain, chain[1:])}, key=str)
        self.up = {n: [u for u, v in self.links if v == n] for n in self.row}
        self.down = {n: [v for u, v in self.links if u == n] for n in self.row}
        self.order = self.best_order()
        self.x = self.places(self.order, 400)

    # Orders of few crossings: rows are sorted by the means of their neighbours, from many shuffled beginnings.

    def best_order(self):
        chance = random.Random(1)
        best, best_cost = None, None
        for _ in range(60):
            order = [sorted((n for n in self.row if self.row[n] == r), key=str) for r in range(self.height)]
            for row in order:
                for k in range(len(row) - 1, 0, -1):
                    other = int(chance.random() * (k + 1))
                    row[k], row[other] = row[other], row[k]
            for sweep in range(12):
                self.sort_rows(order, sweep % 2 == 0)
            while self.exchange(order):
                pass
            crossings = sum(self.crossings(order, r) for r in range(self.height - 1))
            if best is None or crossings <= best_cost[0]:
                x = self.places(order, 40)
                cost = (crossings, round(sum((x[u] - x[v]) ** 2 for u, v in self.links), 3))
                if best is None or cost < best_cost:
                    best, best_cost = order, cost
        return best

    def sort_rows(self, order, upwards):
        rows = range(1, self.height) if upwards else range(self.height - 2, -1, -1)
        for r in rows:
            place = {n: k for row in order for k, n in enumerate(row)}
            near = self.down if upwards else self.up
            middle = {n: sum(place[m] for m in near[n]) / len(near[n]) if near[n] else place[n] for n in order[r]}
            order[r].sort(key=lambda n: middle[n])

    def exchange(self, order):
        """Swaps neighbours where that saves crossings; whether it did."""
        better = False
        for r, row in enumerate(order):
            for k in range(len(row) - 1):
                before = self.crossings(order, r) + self.crossings(order, r - 1)
                row[k], row[k + 1] = row[k + 1], row[k]
                if self.crossings(order, r) + self.crossings(order, r - 1) < before:
                    better = True
                else:
                    row[k], row[k + 1] = row[k + 1], row[k]
        return better

    def crossings(self, order, lower):
        """Between a row and the one above it."""
        if lower < 0 or lower + 1 >= self.height:
            return 0
        place = {n: k for row in order[lower:lower + 2] for k, n in enumerate(row)}
        ends = [(place[u], place[v]) for v in order[lower] for u in self.up[v]]
        return sum((a[0] - b[0]) * (a[1] - b[1]) < 0 for k, a in enumerate(ends) for b in ends[:k])

    # Places: everybody goes to the mean of its neighbours, as near as the order and the widths allow.

    def places(self, order, rounds):
        x = {}
        for row in order:
            at = 0.0
            for n in row:
                x[n] = at + self.width[n] / 2
                at += self.width[n] + GAP
        for k in range(rounds):
            rows = order if k % 2 == 0 else order[::-1]
            for row in rows:
                self.settle(row, x)
        return x

    def settle(self, row, x):
        wishes, weights = [], []
        for n in row:
            near = self.up[n] + self.down[n]
            # Threads pull hard, so that long arrows are straight.
            pulls = [24.0 if isinstance(m, tuple) and isinstance(n, tuple) else 1.0 for m in near] or [0.1]
            wishes.append(sum(w * x[m] for w, m in zip(pulls, near)) / sum(pulls) if near else x[n])
            weights.append(sum(pulls))
        offsets, at = [], 0.0
        for k, n in enumerate(row):
            at += (self.width[row[k - 1]] + self.width[n]) / 2 + GAP if k else 0
            offsets.append(at)
        blocks = []  # (weighted wish, weight, count), ascending: pool adjacent violators
        for wish, weight, offset in zip(wishes, weights, offsets):
            blocks.append([(wish - offset) * weight, weight, 1])
            while len(blocks) > 1 and blocks[-2][0] / blocks[-2][1] >= blocks[-1][0] / blocks[-1][1]:
                last = blocks.pop()
                blocks[-1] = [p + q for p, q in zip(blocks[-1], last)]
        level = [total / weight for total, weight, count in blocks for _ in range(count)]
        for n, base, offset in zip(row, level, offsets):
            x[n] = base + offset


# --- the picture

STYLE = """
  .ground { fill: #fffdf8 }
  .frame { fill: #f6efe2; stroke: #b8ab97 }
  .box { fill: #fffdf8; stroke: #8d857a }
  .layer { fill: #fdebcb; stroke: #b07a3c }
  .arrow { fill: none; stroke: #7a5a36; stroke-width: 1.4 }
  .tip { fill: #7a5a36 }
  text { fill: #2b2620; font: 15px system-ui, "Segoe UI", "Noto Sans", "DejaVu Sans", Helvetica, Arial, sans-serif }
  .name { text-anchor: middle }
  .note { font-size: 13px; fill: #6b6155 }
  @media (prefers-color-scheme: dark) {
    .ground { fill: #1d1b19 }
    .frame { fill: #26231f; stroke: #5c5449 }
    .box { fill: #34302a; stroke: #8d857a }
    .layer { fill: #4a3822; stroke: #b07a3c }
    .arrow { stroke: #d0a878 }
    .tip { fill: #d0a878 }
    text { fill: #f2ece2 }
    .note { fill: #b3a898 }
  }
"""


def box(name, x, y, size, kind):
    w, h = size
    return (f'<rect class="{kind}" x="{x - w / 2:.1f}" y="{y - h / 2:.1f}" width="{w}" height="{h}" rx="6"/>'
            f'<text class="name" x="{x:.1f}" y="{y + 5:.1f}">{name}</text>')


def ports(layout):
    """Places where arrows leave and reach boxes: side by side in the order of their other ends."""
    x, out = layout.x, {}
    for n in layout.row:
        for ends, key in ((layout.down[n], lambda m, n=n: (n, m)), (layout.up[n], lambda m, n=n: (m, n))):
            ordered = sorted(ends, key=lambda m: x[m])
            step = min(20.0, (layout.width[n] - 24) / max(1, len(ordered) - 1)) if not isinstance(n, tuple) else 0.0
            for k, m in enumerate(ordered):
                # An arrow may leave straight towards its other end, as far as its neighbours leave room.
                out[(n,) + key(m)] = x[n] + step * (k - (len(ordered) - 1) / 2)
    return out


def arrow(chain, layout, height, place):
    """One path from the lower side of the upper box to the upper side of the lower one."""
    port = ports(layout)
    path = []
    for k, (u, v) in enumerate(zip(chain, chain[1:])):
        (x0, y0), (x1, y1) = (port[(u, u, v)], place(u)[1]), (port[(v, u, v)], place(v)[1])
        y0 += height / 2
        y1 -= height / 2 + (6 if k == len(chain) - 2 else 0)
        bend = (y1 - y0) * 0.55
        path.append(f"{'M' if k == 0 else 'L'}{x0:.1f} {y0:.1f}")
        path.append(f"C{x0:.1f} {y0 + bend:.1f} {x1:.1f} {y1 - bend:.1f} {x1:.1f} {y1:.1f}")
    return f'<path class="arrow" d="{"".join(path)}" marker-end="url(#tip)"/>'


def picture(layers, rooms):
    room = (round(max(map(len, rooms)) * LETTER) + 20, BOX_HEIGHT)
    inner = Layout(sorted(rooms), reduced(rooms), room[0])
    left = min(inner.x[n] - inner.width[n] / 2 for n in inner.row)
    right = max(inner.x[n] + inner.width[n] / 2 for n in inner.row)
    outer = Layout(sorted(layers), reduced(layers), LAYER[0])
    frame_width = right - left + 2 * MARGIN
    outer_top = MARGIN + LAYER[1] / 2
    frame_top = outer_top + (outer.height - 1) * LAYER_ROW - LAYER[1] / 2
    frame_height = (inner.height - 1) * ROW + BOX_HEIGHT + 2 * MARGIN + 10
    centre = MARGIN + frame_width / 2
    middle = outer.x[INNER]

    def outer_place(n):
        y = outer_top + (outer.height - 1 - outer.row[n]) * LAYER_ROW
        return centre + outer.x[n] - middle, y

    def inner_place(n):
        return (inner.x[n] - left + 2 * MARGIN,
                frame_top + MARGIN + 10 + BOX_HEIGHT / 2 + (inner.height - 1 - inner.row[n]) * ROW)

    for layout, place in ((inner, inner_place), (outer, outer_place)):
        layout.x = {n: place(n)[0] for n in layout.row}
        moved = layout.x
        layout.at = {n: (moved[n], place(n)[1]) for n in layout.row}
    width, height = round(frame_width + 2 * MARGIN), round(frame_top + frame_height + 54)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        'role="img">',
        "<title>The folders of Hariko and who includes whom</title>",
        "<!-- Made by scripts/architecture_figure.py from the #include lines. -->",
        f"<style>{STYLE}</style>",
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="2" refY="4" markerWidth="8" markerHeight="8" '
        'markerUnits="userSpaceOnUse" orient="auto"><path class="tip" d="M0 0.5L8 4L0 7.5Z"/></marker></defs>',
        f'<rect class="ground" width="{width}" height="{height}" rx="10"/>',
        f'<rect class="frame" x="{MARGIN}" y="{frame_top:.1f}" width="{frame_width:.1f}" height="{frame_height:.1f}" '
        'rx="8"/>',
        f'<text x="{MARGIN + 16}" y="{frame_top + 28:.1f}">{INNER}</text>',
    ]
    for layout, size in ((outer, LAYER), (inner, room)):
        lines += [arrow(chain, layout, size[1], layout.at.get) for chain in layout.chains]
    lines += [box(n, *outer.at[n], LAYER, "layer") for n in sorted(layers) if n != INNER]
    lines += [box(n, *inner.at[n], room, "box") for n in sorted(rooms)]
    lines += [f'<text class="note" x="{MARGIN + 2}" y="{height - 20}">An arrow points to what is included. '
              "What follows from other arrows is left out.</text>", "</svg>"]
    return "\n".join(lines) + "\n"


def faults(top, layers, rooms, text):
    """Differences of the page and its picture from the sources, as sentences."""
    def read(path):
        try:
            with open(os.path.join(top, path), encoding="utf-8") as stream:
                return stream.read()
        except OSError:
            return ""

    out = []
    if read(PICTURE) != text:
        out.append(f"{PICTURE} is not what the sources give: run scripts/architecture_figure.py")
    told = SENTENCE.findall(read(PAGE))
    for folder in sorted(set(layers) | set(rooms)):
        if folder not in told:
            out.append(f"{PAGE} has no sentence about the folder {folder}")
    for folder in told:
        if not any(os.path.isdir(os.path.join(top, layer, folder)) for layer in ["", *layers]):
            out.append(f"{PAGE} has a sentence about {folder}, which is no folder")
    return out


def main():
    top = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", default=top, help="the folder of the sources; otherwise that of this script")
    parser.add_argument("--check", action="store_true", help="only say whether page and picture are up to date")
    parser.add_argument("--arrows", action="store_true", help="print the arrows and write nothing")
    options = parser.parse_args()
    layers, rooms = read_arrows(options.root)
    if options.arrows:
        for graph in (layers, rooms):
            for a, b in reduced(graph):
                print(f"{a} -> {b}")
        return 0
    text = picture(layers, rooms)
    if not options.check:
        with open(os.path.join(options.root, PICTURE), "w", encoding="utf-8") as stream:
            stream.write(text)
        return 0
    found = faults(options.root, layers, rooms, text)
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
