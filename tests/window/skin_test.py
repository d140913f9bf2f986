"""A skin in the real window: two sections are added, a point is dragged, each of the three gestures is drawn with the mouse, a
diamond is dragged, all is undone and done again, methods are tried, a section is taken from the surface, and the skin is saved,
opened again and exported."""

import math
import os
import subprocess

from driver import check, run
from skin_hands import (between, capsule, choose, empty_document, label, names, save, session_and_again,
                        skin_mark, stroke)


def add(window, output):
    empty_document(window)
    choose(window, "Add", "command.add.skin")
    check(label(window, "Add skin") == 1, "the skin is not one step")
    window.screenshot(os.path.join(output, "skin_added.png"))
    # A point of the curve goes where it is dragged.
    x, y = skin_mark(window, "limit.3")
    window.drag((x, y), (x, y - 50), before_release=lambda: window.screenshot(os.path.join(output, "skin_drag.png")))
    check(label(window, "Move section points") == 2, "the drag is not one step")
    now = skin_mark(window, "limit.3")
    check(abs(now[0] - x) < 25 and abs(now[1] - (y - 50)) < 25, f"the point went from {(x, y)} to {now}")
    window.key("ctrl+z")
    label(window, "Add skin")
    check(skin_mark(window, "limit.3") == (x, y), "undo leaves the point elsewhere")
    window.key("ctrl+y")
    label(window, "Move section points")


def gestures(window, output):
    choose(window, "Skin", "command.skin.correspond")
    window.wait_idle()
    stroke(window, skin_mark(window, "limit.1"), skin_mark(window, "limit.9"))
    position = label(window, "Join points")
    # A wedge from both sides of points 2 to 4, with its tip well before the middle of the way: its legs are far from parallel.
    start = skin_mark(window, "limit.3")
    first = between(skin_mark(window, "limit.1"), skin_mark(window, "limit.2"))
    last = between(skin_mark(window, "limit.4"), skin_mark(window, "limit.5"))
    stroke(window, first, between(start, skin_mark(window, "limit.10"), 0.4), last)
    check(label(window, "Merge points") == position + 1, "the wedge is not one step")
    window.screenshot(os.path.join(output, "skin_wedge.png"))
    diamond = names(window, "skin.diamond.")[0]
    before = window.center(diamond)
    window.drag(before, between(before, start, 0.5),
                before_release=lambda: window.screenshot(os.path.join(output, "skin_diamond.png")))
    label(window, "Move a merge")
    after = window.center(diamond)
    check(math.dist(after, start) < 0.8 * math.dist(before, start), f"the diamond went from {before} to {after}")
    # In the tool, too, undo takes back one gesture at a time.
    window.key("ctrl+z")
    label(window, "Merge points")
    check(math.dist(window.center(diamond), before) < 3, "undo leaves the diamond elsewhere")
    window.key("ctrl+shift+z")
    label(window, "Move a merge")
    stroke(window, *capsule(skin_mark(window, "limit.5"), skin_mark(window, "limit.12"), 12), steps=2)
    label(window, "Group points")
    window.screenshot(os.path.join(output, "skin_gestures.png"))
    # A stroke that means nothing changes nothing.
    position = window.last("document")["position"]
    stroke(window, (300, 700), (360, 700), (360, 760), (420, 760))
    window.wait_idle()
    check(window.last("document")["position"] == position, "a stroke beside everything made a step")
    window.key("Return")
    window.wait_idle()


def settings(window, output):
    window.click_on("combo.skin_method")
    window.click_on("choice.skin_method.0")
    position = label(window, "Method of the skin")
    window.screenshot(os.path.join(output, "skin_smooth.png"))
    window.key("ctrl+z")
    window.wait(lambda: window.last("document")["position"] == position - 1, "undo of the method")
    window.wait_idle()
    # A section from the surface, behind that of the selected point.
    window.click(*skin_mark(window, "limit.3"))
    window.wait_idle()
    since = window.count("section_added")
    choose(window, "Skin", "command.skin.add_section")
    window.wait_event("section_added", since)
    label(window, "Add section")
    check(window.last("rebuild")["error"] is None, f"with the section: {window.last('rebuild')}")
    window.screenshot(os.path.join(output, "skin_section.png"))


def mirror(window, output):
    """With the mirror of the skin what is done to one half happens to the other. That half is behind the surface, which is seen through
    from here on."""
    check("skin.limit.4" not in names(window, "skin.limit."), "a point behind the surface is shown")
    window.key("alt+x")
    window.click_on("section.skin_more")
    window.click_on("combo.skin_mirror")
    window.click_on("choice.skin_mirror.2")
    position = label(window, "Mirror of the skin")
    skin_mark(window, "mirror")
    before = {i: skin_mark(window, f"limit.{i}") for i in (2, 3, 4)}
    window.drag(before[2], (before[2][0], before[2][1] - 40),
                before_release=lambda: window.screenshot(os.path.join(output, "skin_mirror.png")))
    check(label(window, "Move section points") == position + 1, "the drag is not one step")
    moved = {i: math.dist(before[i], skin_mark(window, f"limit.{i}")) for i in before}
    check(moved[2] > 20 and moved[4] > 10 and moved[3] < 3, f"points moved by {moved}")
    window.key("ctrl+z")
    label(window, "Mirror of the skin")
    check(math.dist(before[4], skin_mark(window, "limit.4")) < 3, "undo leaves the other half elsewhere")


def session(program, source, output):
    def work(window, path):
        add(window, output)
        mirror(window, output)
        gestures(window, output)
        settings(window, output)
        saved = save(window, path)
        check(len(saved["sections"]) == 3, "the sections are not saved")
        check(saved["mirror"]["axis"] == "y", f"the mirror is not saved: {saved.get('mirror')}")
        check(len(saved["merges"]) == 1, f"the merge is not saved: {saved.get('merges')}")
        check(any(link.get("lasso") for link in saved["links"]), "the group is not saved")

    def again(window, path):
        window.wait_idle()
        skin_mark(window, "limit.3")
        check(names(window, "skin.diamond."), "no diamond is shown")
        check(names(window, "skin.mirror"), "the mirror is not shown")
        window.screenshot(os.path.join(output, "skin_again.png"))
        for arguments in (["export", path, path + ".stl"], ["export", "--control", path, path + ".obj"]):
            done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=120)
            check(done.returncode == 0, f"{arguments}: {done.stderr}")

    session_and_again(program, source, work, again)


run(session)
