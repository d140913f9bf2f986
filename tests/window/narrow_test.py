"""A narrow window that is started with a large interface: the last menu can be reached by way of the one at the end."""

import os

from driver import Window, check, run


def session(program, source, output):
    sample = os.path.join(source, "assets", "samples", "fig2.hariko")
    with Window(program, sample, size=(800, 600), arguments=("--scale", "1.5")) as window:
        window.wait_event("opened", 0)
        window.wait_idle()
        left, _, width, _ = window.rect("menu.more")
        check(left >= 0 and left + width <= 800, f"the menu at the end ends at {left + width}")
        window.click_on("menu.more")
        window.click_on("menu.Help")
        window.rect("command.help.about")
        window.wait_idle()
        window.screenshot(os.path.join(output, "narrow_large.png"))
        window.key("Escape")
        window.wait_idle()
        window.quit()


run(session)
