"""Choices of the export for CAD are there again in the next session of the real window."""

import json
import os
import tempfile

from driver import Window, check, run


def export(window, path):
    window.choose("File", "command.file.export_cad")
    window.rect("export.result")
    window.type_path(path)
    window.wait_event("exported", 0)
    with open(path, "rb") as file:
        step = file.read()
    check(b"AP242" in step and b"SI_UNIT(.CENTI.,.METRE.)" in step.replace(b" ", b""), "not what was chosen in the dialog")


def choose(window):
    window.choose("File", "command.file.export_cad")
    window.rect("export.result")
    window.enter("export.cad_tolerance", "0.02 mm", "Tab")
    window.pick_of("export.cad_unit", ".cm")
    window.click_on("export.ap242")
    window.wait_idle()
    window.click_on("dialog.cancel")


def kept(home):
    """Choices that the dialog keeps for the next session."""
    with open(os.path.join(home, "config", "hariko", "settings.json"), encoding="utf-8") as file:
        return json.load(file)["exports"]["cad"]


def session(program, source, output):
    cube = os.path.join(source, "assets/samples/cube.hariko")
    with tempfile.TemporaryDirectory() as folder:
        home = os.path.join(folder, "home")
        for number in range(2):
            with Window(program, cube, home=home) as window:
                window.wait_event("rebuild", 0)
                if number == 0:
                    choose(window)
                export(window, os.path.join(folder, f"{number}.step"))
                check(kept(home)["tolerance"] == 0.02, f"the tolerance that was typed: {kept(home)}")
                check(window.quit() == 0, "the program did not end well")


if __name__ == "__main__":
    run(session)
