"""Export for CAD in the real window: a sample as STEP and as IGES; the files are whole."""

import os
import tempfile

from driver import Window, check, run


def export(window, path, number):
    window.click_on("menu.File")
    window.click_on("command.file.export_cad")
    window.rect("export.cad_tolerance")
    window.type_path(path)
    window.wait_event("exported", number)
    with open(path, "rb") as file:
        return file.read()


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        window = Window(program, os.path.join(source, "assets/samples/cube.hariko"))
        try:
            window.wait_event("rebuild", 0)
            step = export(window, os.path.join(folder, "cube.step"), 0)
            check(step.startswith(b"ISO-10303-21;") and step.rstrip().endswith(b"END-ISO-10303-21;"), "half a STEP file")
            check(step.count(b"MANIFOLD_SOLID_BREP") == 1, "the cube is no solid")
            window.screenshot(os.path.join(output, "cad_exported.png"))
            iges = export(window, os.path.join(folder, "cube.igs"), 1)
            check(iges.splitlines()[-1][72:73] == b"T", "half an IGES file")
            window.quit()
        finally:
            window.close()


if __name__ == "__main__":
    run(session)
