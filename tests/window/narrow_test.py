"""A narrow window: every menu can be reached and nothing ends outside, whatever the language and the size of the interface."""

import os

from driver import Window, check, run

LAST = "command.help.about"  # of the last menu


def within(window, name, width):
    left, _, size, _ = window.rect(name)
    check(left >= 0 and left + size <= width, f"{name} ends at {left + size} of {width}")


def open_last_menu(window, output, name, width):
    """The menu at the end, by way of the one for those without room where there is one."""
    window.wait_idle()
    within(window, "menu.search", width)
    within(window, "status.right", width)
    if "menu.Help" in window.last("layout")["rects"]:
        check(window.rect("menu.Help")[0] + window.rect("menu.Help")[2] <= window.rect("menu.search")[0],
              "the last menu lies under the field")
    else:
        within(window, "menu.more", width)
        window.click_on("menu.more")
    window.click_on("menu.Help")
    window.rect(LAST)
    window.wait_idle()
    window.screenshot(os.path.join(output, "narrow_" + name + ".png"))


def session(program, source, output):
    sample = os.path.join(source, "assets", "samples", "fig2.hariko")
    window = Window(program, sample, size=(800, 600))
    try:
        window.wait_event("opened", 0)
        open_last_menu(window, output, "english", 800)
        check("menu.more" not in window.last("layout")["rects"], "the menus have room beside a button")
        window.click_on("command.help.japanese")
        window.wait_idle()
        open_last_menu(window, output, "japanese", 800)
        window.key("Escape")
        window.wait_idle()
        window.click_on("menu.search")
        window.wait(lambda: "palette.input" in window.last("layout")["rects"], "the palette")
        window.key("Escape")
        window.wait_idle()
        window.quit()
    finally:
        window.close()

    window = Window(program, sample, size=(800, 600), arguments=("--scale", "1.5"))
    try:
        window.wait_event("opened", 0)
        open_last_menu(window, output, "large", 800)
        check("menu.more" in window.last("layout")["rects"], "no menu for those without room")
        window.key("Escape")
        window.wait_idle()
        window.quit()
    finally:
        window.close()


run(session)
