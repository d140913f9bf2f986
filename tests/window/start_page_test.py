"""The start page opens samples; maps, menus and the smallest sensible window work; unsaved work is asked about."""

import os

from driver import Window, check, run


def session(program, source, output):
    del source
    with Window(program, size=(1024, 700)) as window:
        window.screenshot(os.path.join(output, "start_page.png"))
        check(window.count("first_frame") == 1, "the first frame was not measured once")

        # By keys: the drawing of an outline begins, and Close leads back.
        window.keys("Tab", "Tab", "Right", "Right", "Right", "Return")
        window.wait(lambda: "viewport" in window.rects(), "the outline to be drawn")
        window.key("Escape")
        window.wait_idle()
        window.key("ctrl+w")
        window.gone("viewport")
        window.wait_idle()
        window.click_on("sample.cube_crease.hariko")
        window.until_opened()

        # The Gaussian map, from its combo box.
        window.pick("map", 3)
        window.step("Map Gaussian curvature")
        window.screenshot(os.path.join(output, "gauss_map.png"))

        # A menu: undo from there.
        window.choose("Edit", "command.edit.undo")
        window.wait(lambda: window.position() == 0, "undo from the menu")

        # Orbit and zoom change the picture and not the document.
        x, y = window.center("viewport")
        before = window.last("vertices")
        window.drag((x, y), (x + 90, y + 20), button=2)
        window.xdotool("click", "4")
        window.wait_idle()
        check(window.last("vertices") != before, "neither orbit nor zoom did anything")
        check(window.position() == 0, "the camera got into the history")
        window.key("Home")

        # Delete, then try to leave: the question comes; Esc stays, Discard leaves.
        window.key("Delete")
        window.wait(lambda: window.label() == "Delete object", "the deletion")
        window.key("ctrl+q")
        window.rect("prompt.cancel")
        window.key("Escape")
        window.gone("prompt.cancel")
        check(window.program.poll() is None, "Esc at the prompt ended the program")
        window.key("ctrl+q")
        window.click_on("prompt.discard")
        check(window.program.wait(timeout=20) == 0, "Discard did not end the program well")


run(session)
