"""Export for CAD in the real window: a sample as STEP and as IGES, measured before it is written, anew when the tolerance
changes; the files are whole and come back in by import, and half a file is refused with its reason. The settings are still there
in the next session."""

import json
import os
import tempfile

from driver import Window, check, run


def open_dialog(window):
    """With what the file will be like."""
    counted = window.count("export_counted")
    window.click_on("menu.File")
    window.click_on("command.file.export_cad")
    window.wait_event("export_counted", counted)
    window.rect("export.result")


def export(window, path, number):
    open_dialog(window)
    window.type_path(path)
    window.wait_event("exported", number)
    with open(path, "rb") as file:
        return file.read()


def import_file(window, path):
    window.key("ctrl+i")
    window.rect("dialog.name")
    window.type_path(path)


def kept(home):
    """What the dialog keeps for the next session."""
    with open(os.path.join(home, "config", "hariko", "settings.json"), encoding="utf-8") as file:
        return json.load(file)["exports"]["cad"]


def check_choices(step):
    check(b"AP242" in step and b"SI_UNIT(.CENTI.,.METRE.)" in step.replace(b" ", b""), "not what was chosen in the dialog")


def session(program, source, output):
    cube = os.path.join(source, "assets/samples/cube.hariko")
    with tempfile.TemporaryDirectory() as folder:
        home = os.path.join(folder, "home")
        window = Window(program, cube, home=home)
        try:
            window.wait_event("rebuild", 0)
            open_dialog(window)
            counted = window.count("export_counted")
            window.click_on("export.cad_tolerance")
            window.key("ctrl+a")
            window.type("0.02 mm")
            window.key("Tab")
            window.wait_event("export_counted", counted)
            window.rect("export.result")
            window.click_on("export.cad_unit")
            window.click_on("export.cad_unit.cm")
            window.wait(lambda: "export.cad_unit.cm" not in window.last("layout")["rects"], "the list to close")
            window.click_on("export.ap242")
            window.wait_idle()
            check(window.count("export_counted") == counted + 1, "the unit and the schema do not change the faces")
            window.screenshot(os.path.join(output, "cad_dialog.png"))
            window.click_on("dialog.cancel")
            step = export(window, os.path.join(folder, "cube.step"), 0)
            window.wait(lambda: "Exported" in (window.last("notice") or {"text": ""})["text"], "the report")
            told = window.last("notice")["text"]
            check(" faces, " in told and told.endswith("B."), f"the report: {told}")
            check_choices(step)
            check(kept(home)["tolerance"] == 0.02, f"the tolerance that was typed: {kept(home)}")
            check(step.startswith(b"ISO-10303-21;") and step.rstrip().endswith(b"END-ISO-10303-21;"), "half a STEP file")
            check(step.count(b"MANIFOLD_SOLID_BREP") == 1, "the cube is no solid")
            window.screenshot(os.path.join(output, "cad_exported.png"))
            iges = export(window, os.path.join(folder, "cube.igs"), 1)
            check(iges.splitlines()[-1][72:73] == b"T", "half an IGES file")
            for number, name in enumerate(["cube.step", "cube.igs"]):
                import_file(window, os.path.join(folder, name))
                window.wait_event("imported", number)
                window.wait_idle()
            window.wait(lambda: window.last("document")["position"] == 2, "the steps of the imports")
            window.screenshot(os.path.join(output, "cad_imported.png"))
            half = os.path.join(folder, "half.step")
            with open(half, "wb") as file:
                file.write(step[:len(step) // 2])
            notices = window.count("notice")
            import_file(window, half)
            window.wait(lambda: window.count("notice") > notices and window.last("notice")["text"], "the reason")
            check(window.last("document")["position"] == 2, "half a file changed the document")
            window.key("ctrl+q")
            window.click_on("prompt.discard")
            window.program.wait(timeout=20)
        finally:
            window.close()
        window = Window(program, cube, home=home)
        try:
            check_choices(export(window, os.path.join(folder, "again.step"), 0))
            check(window.quit() == 0, "the program did not end well")
        finally:
            window.close()


if __name__ == "__main__":
    run(session)
