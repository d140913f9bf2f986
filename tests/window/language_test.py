"""The language switches at once, by menu, both ways; every panel is shown in Japanese for someone to look at."""

import os

from driver import Window, check, run


def shot(window, output, name):
    window.wait_idle()
    window.screenshot(os.path.join(output, name))


def session(program, source, output):
    with Window(program, size=(1024, 700)) as window:
        before = window.rect("menu.File")
        window.choose("Help", "command.language.japanese")
        window.wait(lambda: window.rects()["menu.File"] != before, "menus of another width")
        shot(window, output, "ja_start.png")
        for menu in ("File", "Edit", "Select", "View", "Help"):
            window.click_on("menu." + menu)
            shot(window, output, f"ja_menu_{menu}.png")
            window.key("Escape")
            window.wait_idle()

        window.click_on("sample.cube_crease.hariko")
        window.until_opened()
        shot(window, output, "ja_objects.png")
        window.click_on("section.placement")
        shot(window, output, "ja_placement.png")
        vertex = window.nearest_vertex()
        x, y = window.vertex(vertex)[:2]
        window.click(x, y)
        shot(window, output, "ja_vertex.png")
        window.drag((x, y), (x + 30, y + 30))
        window.wait(lambda: window.position() == 1, "a step")
        window.click_on("section.history")
        shot(window, output, "ja_history.png")
        window.key("ctrl+e")
        window.rect("dialog.name")
        shot(window, output, "ja_export.png")
        window.key("Escape")
        window.wait_idle()
        window.key("ctrl+q")
        window.rect("prompt.cancel")
        shot(window, output, "ja_prompt.png")
        window.key("Escape")
        window.wait_idle()

        # And back.
        window.choose("Help", "command.language.english")
        window.wait(lambda: window.rects()["menu.File"] == before, "menus of the first width")
        shot(window, output, "en_again.png")
        check(window.position() == 1, "the language is no step of the document")


run(session)
