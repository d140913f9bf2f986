"""Files dropped on the window, as a file manager drops them: a document opens, a mesh joins it, junk is refused with a
reason, and unsaved work is asked about."""

import os
import shutil
import subprocess
import tempfile
import urllib.request

from driver import Window, check, run


def drop(window, output, *files):
    x, y = 600, 400
    uris = ["file://" + urllib.request.pathname2url(file) for file in files]
    done = subprocess.run([os.path.join(output, "drop_source"), window.id, str(x), str(y), *uris],
                          env=window.environment, capture_output=True, text=True, timeout=40)
    check(done.returncode == 0, "the drop failed: " + done.stderr)


def session(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        # Names that a URI has to be decoded from, and that are no ASCII.
        model = shutil.copy(os.path.join(source, "assets", "samples", "cube.hariko"), os.path.join(folder, "W\u00fcrfel 1.hariko"))
        mesh = os.path.join(folder, "tent.obj")
        with open(mesh, "w", encoding="ascii") as file:
            file.write("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 2\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n")
        junk = os.path.join(folder, "holiday.jpg")
        with open(junk, "wb") as file:
            file.write(bytes(range(256)) * 20)
        with Window(program) as window:
            drop(window, output, model)
            window.until_opened()
            drop(window, output, mesh)
            window.wait_event("imported", 0)
            window.wait(lambda: window.position() == 1, "the step of the import")
            check("2" in window.last("vertices")["objects"], "the mesh did not become an object")
            notices = window.count("notice")
            drop(window, output, junk)
            window.wait(lambda: window.count("notice") > notices and window.last("notice")["text"], "the reason")
            check(window.position() == 1, "junk changed the document")
            # The import is unsaved: another document must not replace it silently.
            drop(window, output, os.path.join(source, "assets", "samples", "torus.hariko"))
            window.rect("prompt.discard")
            check(window.count("opened") == 1, "the document was replaced without a question")
            window.click_on("prompt.cancel")
            window.wait_idle()
            check(window.position() == 1, "Cancel lost the document")
            drop(window, output, os.path.join(source, "assets", "samples", "torus.hariko"))
            window.click_on("prompt.discard")
            window.wait_event("opened", 1)


run(session)
