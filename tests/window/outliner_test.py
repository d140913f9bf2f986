"""The list of objects: rename in place, choose several, hide, lock, isolate, drag into order; the history goes back."""

import os

from driver import Window, check, run


def wait_label(window, label):
    window.wait(lambda: window.last("document")["label"] == label, f"the step {label!r}, not "
                f"{window.last('document')['label']!r}")
    window.wait_idle()


def session(program, source, output):
    window = Window(program, os.path.join(source, "assets", "samples", "cube.hariko"))
    try:
        window.wait_event("opened", 0)
        window.wait_idle()

        # Rename: by double click, and by F2; Esc keeps the name.
        x, y = window.center("object.1")
        window.move(x - 40, y)
        window.xdotool(*("mousedown 1 sleep 0.06 mouseup 1 sleep 0.06 " * 2).split())
        window.rect("outliner.name")
        window.key("ctrl+a")
        window.type("Body")
        window.key("Return")
        wait_label(window, "Rename object")
        window.key("F2")
        window.rect("outliner.name")
        window.type("Nothing")
        window.key("Escape")
        window.wait(lambda: "outliner.name" not in window.last("layout")["rects"], "the field to go")
        check(window.last("document")["position"] == 1, "Esc renamed the object")

        # Copies, chosen by Ctrl, hidden together.
        window.key("ctrl+d")
        wait_label(window, "Duplicate object")
        window.key("ctrl+d")
        wait_label(window, "Duplicate object")
        names = {"object.1", "object.2", "object.3"}
        window.wait(lambda: names <= window.last("layout")["rects"].keys(), "three rows")
        rows = sorted(names, key=lambda name: window.rect(name)[1])
        window.click_on(rows[0])
        window.xdotool("keydown", "ctrl")
        window.click_on(rows[2])
        window.xdotool("keyup", "ctrl")
        window.wait_idle()
        window.screenshot(os.path.join(output, "outliner.png"))
        window.key("h")
        wait_label(window, "Hide 2 objects")
        window.key("alt+h")
        wait_label(window, "Show all objects")
        # What was hidden is no longer selected.
        window.click_on(rows[0])
        window.xdotool("keydown", "ctrl")
        window.click_on(rows[2])
        window.xdotool("keyup", "ctrl")
        window.wait_idle()
        window.key("shift+h")
        wait_label(window, "Isolate 2 objects")
        window.key("ctrl+z")

        # Drag the first row below the last one.
        window.click_on(rows[1])
        window.click_on(rows[0])
        left, top, width, height = window.rect(rows[2])
        start = window.center(rows[0])
        window.drag((start[0] - 40, start[1]), (left + width / 2 - 40, top + height - 3))
        wait_label(window, "Reorder objects")
        check(window.rect(rows[0])[1] > window.rect(rows[2])[1], "the row did not move")

        # The switches of a row.
        window.click_on(rows[1].replace("object", "eye"))
        wait_label(window, "Hide object")
        window.move(*window.center(rows[1]))
        window.click_on(rows[1].replace("object", "lock"))
        wait_label(window, "Lock object")

        # History: open the list, go back to the beginning by a click, and forward again.
        steps = window.last("document")["position"]
        window.click_on("section.history")
        window.rect("step.0")
        window.wait_idle()
        window.screenshot(os.path.join(output, "history.png"))
        left, top, width, height = window.rect(f"step.{steps}")
        window.move(left + 60, top + 4)
        for _ in range(12):
            window.xdotool("click", "4")
        window.wait_idle()
        window.click_on("step.0")
        window.wait(lambda: window.last("document")["position"] == 0, "the beginning")
        window.wait_idle()
        window.click_on("step.1")
        window.wait(lambda: window.last("document")["position"] == 1, "the first step")
    finally:
        window.close()


run(session)
