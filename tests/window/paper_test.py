"""A paper model in the real window: unfold, mesh finer, split and join by clicks, tabs, dragging and turning, undo, the folding
slider, a changed model, export, saving and opening again; and a mesh that cannot be unfolded."""

import glob
import os
import re
import tempfile

from driver import Window, check, run


def paper(window):
    return window.last("paper")


def settled(window, what, condition=lambda now: True):
    window.wait(lambda: paper(window) and not paper(window)["pending"] and condition(paper(window)), what)
    window.wait_idle()
    return paper(window)


def step(window, position, label):
    window.wait(lambda: window.last("document")["position"] == position and window.last("document")["label"] == label,
                f"step {position}, {label}; it is {window.last('document')}")
    window.wait_idle()


def marks(window, kind):
    rects = window.last("layout")["rects"]
    return {int(name.rsplit(".", 1)[1]): (x + w // 2, y + h // 2)
            for name, (x, y, w, h) in rects.items() if name.startswith(f"paper.{kind}.")}


def tolerance(window, text):
    window.click_on("field.paper_distance")
    window.key("ctrl+a")
    window.type(text)
    window.key("Return")
    window.wait_idle()


def unfold(window, output):
    window.key("ctrl+p")
    settled(window, "the paper view", lambda now: now["shown"])
    tolerance(window, "0.08")
    step(window, 1, "Tolerance of the paper model")
    window.click_on("paper.unfold")
    now = settled(window, "the pages", lambda now: "pieces" in now)
    step(window, 2, "Unfold")
    check(now["overlaps"] == 0 and now["off_page"] == 0, f"the pages are wrong: {now}")
    window.screenshot(os.path.join(output, "paper.png"))

    # A coarser mesh has fewer facets; undo brings the pages back as they were.
    tolerance(window, "0.2")
    step(window, 3, "Tolerance of the paper model")
    settled(window, "coarser facets", lambda coarse: coarse.get("facets", 1e9) < now["facets"])
    window.key("ctrl+z")
    back = settled(window, "the pages of before", lambda fine: fine.get("facets") == now["facets"])
    check(back["places"] == now["places"] and back["pieces"] == now["pieces"], "undo gives other pages")
    return now


def cut_and_join(window, now, output):
    # The longest way from other marks: a click is sure to mean this edge.
    folds, others = marks(window, "folded"), [*marks(window, "cut").values(), *marks(window, "tab").values()]
    check(folds, "no fold can be seen")
    edge = max(folds, key=lambda e: min(abs(folds[e][0] - x) + abs(folds[e][1] - y) for x, y in others))
    window.click(*folds[edge])
    split = settled(window, "one piece more", lambda after: after["pieces"] == now["pieces"] + 1)
    step(window, 3, "Split at an edge")
    check(split["joints"] == now["joints"] + 1, "the split made no joint")
    window.screenshot(os.path.join(output, "paper_split.png"))
    window.click(*marks(window, "cut")[edge])
    settled(window, "the pieces joined again", lambda after: after["pieces"] == now["pieces"])
    step(window, 4, "Join at an edge")
    window.key("ctrl+z")
    settled(window, "undo", lambda after: after["pieces"] == now["pieces"] + 1)
    window.key("ctrl+z")
    settled(window, "undo", lambda after: after["places"] == now["places"])

    # Tabs are small: come closer.
    window.move(*next(iter(marks(window, "tab").values())))
    for _ in range(12):
        window.xdotool("click", "4")
    window.wait_idle()
    for edge in marks(window, "tab"):
        window.click(*marks(window, "tab")[edge])
        window.wait_idle()
        if window.last("document")["label"] != "Unfold":
            break
    step(window, 3, "Side of a tab")
    window.screenshot(os.path.join(output, "paper_tab.png"))
    window.key("ctrl+z")
    step(window, 2, "Unfold")
    window.key("ctrl+shift+p")
    window.rect("palette.input")
    window.type("All pages")
    window.wait_idle()
    window.key("Return")
    window.wait_idle()


def drag(window, now, output):
    pieces = marks(window, "piece")
    x, y = pieces[0]
    window.drag((x, y), (x + 30, y + 24))
    moved = settled(window, "a moved piece", lambda after: after["places"] != now["places"])
    step(window, 3, "Move a piece")
    check(moved["selected"] == 0, "the piece that was dragged is not selected")
    x, y = window.center("paper.handle")
    window.drag((x, y), (x + 70, y + 40), before_release=lambda: window.screenshot(os.path.join(output, "paper_turn.png")))
    step(window, 4, "Turn a piece")
    # Esc lets a piece go.
    x, y = marks(window, "piece")[0]
    before = paper(window)["places"]
    window.move(x, y)
    window.press()
    window.move(x + 20, y + 20)
    window.move(x + 40, y + 40)
    window.wait(lambda: paper(window)["places"] != before, "the piece in the hand")
    window.key("Escape")
    window.release()
    window.wait_idle()
    check(paper(window)["places"] == before, "Esc did not put the piece back")
    window.click_on("paper.straighten")
    step(window, 5, "Straighten a piece")
    window.click_on("paper.arrange")
    step(window, 6, "Arrange the pages")
    check(paper(window)["overlaps"] == 0 and paper(window)["off_page"] == 0, "arranged pages are wrong")
    for _ in range(4):
        window.key("ctrl+z")
    settled(window, "undo", lambda after: after["places"] == now["places"])
    step(window, 2, "Unfold")


def linked(window, output):
    """What the pointer is on is known in both views."""
    window.move(*marks(window, "piece")[0])
    window.wait(lambda: paper(window)["hovered"] is not None, "a facet under the pointer, on paper")
    window.move(*window.center("view.0"))
    window.wait(lambda: paper(window)["hovered"] is not None, "a facet under the pointer, in space")
    window.screenshot(os.path.join(output, "paper_linked.png"))
    x, y, width, height = window.rect("paper.fold")
    window.drag((x + width - 6, y + height // 2), (x + width * 0.45, y + height // 2))
    window.key("Home")
    window.wait_idle()
    check(0.3 < paper(window)["folded"] < 0.6, f"the slider says {paper(window)['folded']}")
    window.screenshot(os.path.join(output, "paper_folding.png"))
    window.drag((x + width * 0.45, y + height // 2), (x + width + 30, y + height // 2))
    window.wait(lambda: paper(window)["folded"] == 1, "the solid")
    window.key("Home")
    window.wait_idle()


def follow(window, now):
    """The model changes: facets that are still there keep their cuts."""
    window.click_on("paper.in_space")
    window.wait_idle()
    vertex = window.nearest_vertex()
    x, y, _ = window.vertex(vertex)
    window.key("1")
    window.click(x, y)
    window.drag((x, y), (x + 8, y - 8))
    window.wait(lambda: window.last("document")["position"] == 3, "a moved vertex")
    after = settled(window, "pages of the changed model")
    check(after["facets"] > 0 and after["error"] is None, f"no pages of the changed model: {after}")
    check(after["places"] != now["places"] or after["facets"] == now["facets"], "the pages did not follow")
    window.key("ctrl+z")
    settled(window, "undo", lambda back: back["places"] == now["places"])
    window.click_on("paper.in_space")


def export(window, folder, now):
    for number, ending in enumerate(("pdf", "svg", "dxf", "png"), 1):
        window.click_on("paper.export")
        window.type_path(os.path.join(folder, "pages." + ending))
        window.wait(lambda: window.count("exported") == number, "an exported file")
        window.wait_idle()
    facets = 0
    for name in glob.glob(os.path.join(folder, "pages*.svg")):  # one file a page
        with open(name, encoding="utf-8") as file:
            facets += len(re.findall('class="face"', file.read()))
    check(facets == now["facets"], f"the SVG files have {facets} of {now['facets']} facets")
    beginnings = {"pdf": b"%PDF-1.4", "dxf": b"0\nSECTION", "png": b"\x89PNG"}
    for ending, beginning in beginnings.items():
        with open(os.path.join(folder, "pages." + ending), "rb") as file:
            check(file.read().startswith(beginning), f"this is no {ending}")


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        saved = os.path.join(folder, "a.hariko")
        window = Window(program, os.path.join(source, "tests", "golden", "cube.obj"), size=(1560, 960))
        try:
            now = unfold(window, output)
            cut_and_join(window, now, output)
            drag(window, now, output)
            linked(window, output)
            follow(window, now)
            export(window, folder, now)
            window.key("ctrl+s")
            window.type_path(saved)
            window.wait(lambda: window.count("saved") == 1, "the saved file")
        finally:
            window.close()
        window = Window(program, saved, size=(1560, 960))
        try:
            window.key("ctrl+p")
            again = settled(window, "the saved pages", lambda after: "pieces" in after)
            check(again["places"] == now["places"] and again["pieces"] == now["pieces"], "saving changed the pages")
        finally:
            window.close()


def refused(program, file, code, output, prepare):
    """The message says what is wrong; what it names is outlined."""
    window = Window(program, file, size=(1560, 960))
    try:
        prepare(window)
        window.click_on("paper.unfold")
        window.wait(lambda: paper(window)["error"] == code, f"{code}; it is {paper(window)}")
        window.wait_idle()
        window.screenshot(os.path.join(output, f"paper_{code}.png"))
        check(window.last("document")["label"] != "Unfold", "what cannot be unfolded made a step")
    finally:
        window.close()


def of_polyhedra(window):
    window.key("ctrl+p")
    settled(window, "the paper view", lambda now: now["shown"])
    window.click_on("combo.paper_facets")
    window.click_on("choice.paper_facets.1")
    window.wait_idle()


def as_reference(window):
    window.click_on("prompt.reference")
    window.wait(lambda: window.count("opened") == 1, "the mesh as a reference")
    window.key("ctrl+p")
    settled(window, "the paper view", lambda now: now["shown"])


def refusals(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        flat, three = os.path.join(folder, "flat.obj"), os.path.join(folder, "three.obj")
        with open(flat, "w", encoding="ascii") as out:  # four corners on one line: no triangle that opening leaves out
            out.write("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 3 0 0\nf 1 2 3 5\nf 1 5 4\n")
        with open(three, "w", encoding="ascii") as out:  # three triangles on one edge
            out.write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n")
        refused(program, flat, "E_FACET_DEGENERATE", output, of_polyhedra)
        refused(program, three, "E_EDGE_NONMANIFOLD_OR_FLIPPED", output, as_reference)


def cancelled(program, source):
    """A search that would take minutes shows how far it is and can be stopped; the document stays as it was."""
    window = Window(program, os.path.join(source, "tests", "golden", "car.obj"), size=(1560, 960))
    try:
        window.key("ctrl+p")
        settled(window, "the paper view", lambda now: now["shown"])
        window.click_on("field.paper_steps")
        window.key("ctrl+a")
        window.type("100000000")
        window.key("Return")
        step(window, 1, "Effort of the search")
        window.click_on("paper.unfold")
        window.click_on("status.cancel_job")
        window.wait_idle()
        check(window.last("document")["position"] == 1, "a search that was stopped changed the document")
        check("pieces" not in paper(window), "a search that was stopped gave pages")
    finally:
        window.close()


def test(program, source, output):
    session(program, source, output)
    refusals(program, source, output)
    cancelled(program, source)


run(test)
