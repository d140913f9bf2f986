"""Export for CAD in the real window: a sample as STEP and as IGES; the files are whole and come back in by import, and half a
file is refused with its reason."""

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


def import_file(window, path):
    window.key("ctrl+i")
    window.rect("dialog.name")
    window.type_path(path)


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


if __name__ == "__main__":
    run(session)
