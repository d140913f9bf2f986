"""Failures are said and harm nothing: no display, a broken file, a place that cannot be written."""

import os
import subprocess
import tempfile

from driver import Window, check, run


def session(program, source, output):
    del output
    environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "WAYLAND_DISPLAY")}
    done = subprocess.run([program], env=environment, capture_output=True, text=True, timeout=30)
    check(done.returncode == 1, f"without a display the exit code is {done.returncode}")
    check("window" in done.stderr and "command line" in done.stderr, "no readable message: " + done.stderr)

    with tempfile.TemporaryDirectory() as folder:
        broken = os.path.join(folder, "broken.hariko")
        with open(broken, "w", encoding="ascii") as file:
            file.write('{"hariko": ')
        with Window(program, broken) as window:
            window.wait(lambda: window.last("notice") is not None and window.last("notice")["text"], "the message")
            check(window.count("opened") == 0, "a broken file was opened")
            window.key("Escape")
            window.key("ctrl+s")  # nothing is open: it says so
            window.wait(lambda: "Nothing is open" in (window.last("cursor") or {"text": ""})["text"], "the reason")
            window.type_path(os.path.join(source, "assets", "samples", "cube.hariko"), "ctrl+o")
            window.until_opened()
            window.type_path("/proc/nowhere.hariko", "ctrl+shift+s")
            window.wait(lambda: window.count("notice") >= 3 and window.last("notice")["text"], "the message on saving")
            check(window.count("saved") == 0, "saved into a place that cannot be written")
            check(window.quit() == 0, "the program did not end well")


run(session)
