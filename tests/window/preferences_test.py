"""Preferences in the real window: a key is recorded, a conflict is explained and replaced, theme and scale follow at once,
and the key works."""

import json
import os
import subprocess

from driver import Window, check, run


def brightness(path, rect):
    """Mean grey of a rectangle of a picture, 0 to 1."""
    x, y, width, height = rect
    done = subprocess.run(["convert", path, "-crop", f"{width}x{height}+{x}+{y}", "-colorspace", "Gray", "-format",
                           "%[fx:mean]", "info:"], capture_output=True, text=True, check=True)
    return float(done.stdout)


def keys_of(window, command):
    window.read()
    return next(c["keys"] for c in window.last("commands")["table"] if c["id"] == command)


def record(window, chord):
    window.click_on("preferences.key.shape.crease.0")
    window.key(chord)


def preferences(program, source, output):
    with Window(program, os.path.join(source, "assets", "samples", "cube.hariko")) as window:
        window.key("ctrl+comma")
        picture = os.path.join(output, "preferences.png")

        def shade():
            window.screenshot(picture)
            return brightness(picture, window.rect("preferences"))

        window.rect("preferences")
        window.wait(lambda: shade() < 0.3, "a dark window")
        window.click_on("preferences.theme.light")
        window.wait(lambda: shade() > 0.7, "a light window")
        window.click_on("preferences.theme.dark")
        window.wait(lambda: shade() < 0.3, "a dark window again")

        # Scale: everything grows by it, and still fits.
        width = window.rect("button.select.edges")[2]
        window.click_on("preferences.scale.150")
        window.wait(lambda: window.rect("button.select.edges")[2] == round(width * 1.5), "larger buttons")
        window.click_on("preferences.scale.100")
        window.wait(lambda: window.rect("button.select.edges")[2] == width, "buttons as before")

        # A key that nobody has: C of Crease becomes F8.
        window.click_on("preferences.page.keys")
        window.click_on("preferences.search")
        window.type("crease")
        # The row moves up when the others go.
        window.gone("preferences.key.mesh.knife.0")
        record(window, "F8")
        window.wait(lambda: keys_of(window, "shape.crease") == "F8", "F8 for Crease")
        # One that another command has: nothing changes before it is decided.
        record(window, "k")
        window.rect("preferences.conflict")
        check(keys_of(window, "mesh.knife") == "K" and keys_of(window, "shape.crease") == "F8",
              "the keys changed before the conflict was decided")
        window.click_on("preferences.keep")
        window.gone("preferences.conflict")
        check(keys_of(window, "shape.crease") == "F8", "Cancel changed the key")
        record(window, "k")
        window.click_on("preferences.replace")
        window.wait(lambda: keys_of(window, "shape.crease") == "K" and keys_of(window, "mesh.knife") == "",
                    "K for Crease instead of Corner")
        # Esc while a key is awaited leaves everything.
        record(window, "Escape")
        check(keys_of(window, "shape.crease") == "K" and "preferences" in window.rects(),
              "Esc did more than to stop recording")
        window.keys("Escape", "Escape")
        window.gone("preferences")

        # It works: K creases, C does nothing.
        count = window.count("command", id="shape.crease")
        window.keys("c", "k")
        window.wait(lambda: window.count("command", id="shape.crease") == count + 1, "K to crease")
        check(window.last("cursor")["text"], "a refused key did not say why")

        # The keys go to a file, the defaults come back, and the file brings the keys again.
        window.key("ctrl+comma")
        window.click_on("preferences.page.keys")
        window.click_on("preferences.keys.export")
        path = os.path.join(window.folder, "mine.json")
        window.type_path(path)
        window.wait(lambda: os.path.exists(path), "the file of keys")
        window.wait_idle()
        with open(path, encoding="utf-8") as file:
            written = json.load(file)["keys"]
        check(written == {"mesh.knife": "", "shape.crease": "K"}, f"the file of keys holds {written}")
        window.click_on("preferences.reset")
        window.wait(lambda: keys_of(window, "shape.crease") == "C", "the default keys")
        window.wait_idle()
        window.click_on("preferences.keys.import")
        window.type_path(path)
        window.wait(lambda: keys_of(window, "shape.crease") == "K" and keys_of(window, "mesh.knife") == "",
                    "the keys of the file")
        window.wait_idle()

        # Back to the defaults.
        window.click_on("preferences.reset")
        window.wait(lambda: keys_of(window, "shape.crease") == "C" and keys_of(window, "mesh.knife") == "K",
                    "the default keys")


run(preferences)
