"""Nothing is lost: a killed program offers its work again, signals and a lost display write it, two windows do not eat
each other's work or overwrite each other's file, and a file that changed on the disk is asked about."""

import contextlib
import json
import os
import shutil
import signal
import sys
import tempfile
import time

from driver import Window, check, run


@contextlib.contextmanager
def opened(program, *files, **options):
    window = Window(program, *files, **options)
    try:
        yield window
    except BaseException:
        if window.program.poll() is None and window.display_server.poll() is None:
            window.screenshot(os.path.join(sys.argv[3], "recovery_failure.png"))
        raise
    finally:
        window.close()


def autosave_every_second(home):
    folder = os.path.join(home, "config", "hariko")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "settings.json"), "w", encoding="utf-8") as file:
        json.dump({"autosave_seconds": 1, "of_a_later_version": [1, 2]}, file)


def slots(home):
    folder = os.path.join(home, "state", "hariko", "recovery")
    if not os.path.isdir(folder):
        return []
    return [name for name in sorted(os.listdir(folder)) if any(
        copy.startswith("copy-") for copy in contents(os.path.join(folder, name)))]


def contents(path):
    try:
        return os.listdir(path)
    except OSError:  # a file, or gone meanwhile
        return []


def read(path):
    with open(path, "rb") as file:
        return file.read()


def edit(window):
    """One step: another object in the document."""
    before = window.last("document")["position"]
    window.key("ctrl+d")
    window.wait(lambda: window.last("document")["position"] == before + 1 and window.last("document")["dirty"], "the step")


def edit_and_autosave(window):
    seen = window.count("autosaved")
    edit(window)
    # A copy of an earlier step may just be under way: the one after the next is surely of this step.
    window.wait_event("autosaved", seen)
    time.sleep(1.5)
    window.wait_idle()


def answer(window, name):
    """Clicks on what has just come up, once it stays where it is."""
    window.rect(name)
    window.wait_idle()
    window.click_on(name)


def save_as(window, path):
    seen = window.count("saved")
    window.key("ctrl+shift+s")
    window.type_path(path)
    window.wait_event("saved", seen)
    window.wait_idle()


def crash_and_recover(program, model, folder, output):
    """Kills the program with work in a file and with work that was never saved."""
    home = os.path.join(folder, "crash")
    autosave_every_second(home)
    committed = os.path.join(folder, "committed.hariko")
    with opened(program, model, home=home) as window:
        edit(window)
        edit_and_autosave(window)
        window.key("ctrl+alt+s")
        window.type_path(committed)
        window.wait_event("copied", 0)
        window.wait_idle()
        check(window.last("document")["dirty"], "saving a copy made the document count as saved")
        window.program.kill()
        window.program.wait()
    original = read(model)
    check(len(slots(home)) == 1, f"after the kill there are these copies: {slots(home)}")

    with opened(program, home=home, size=(1280, 800)) as window:
        window.rect("recovery.recover")
        window.wait_idle()
        window.screenshot(os.path.join(output, "recovery_start_page.png"))
        answer(window, "recovery.recover")
        window.wait_event("recovered", 0)
        window.wait_idle()
        check(window.last("document")["dirty"], "recovered work counts as saved")
        check(read(model) == original, "recovering wrote the file")
        check(len(slots(home)) == 1, "the copy went before the work was saved")
        window.screenshot(os.path.join(output, "recovery_recovered.png"))
        window.key("ctrl+s")  # it knows its file
        window.wait_event("saved", 0)
        window.wait_idle()
        check(read(model) == read(committed), "the recovered document is not the one that was committed last")
        window.wait(lambda: not slots(home), "the copy to go once the work is saved")
        check(window.quit() == 0, "the program did not end well")

    # Never saved, killed twice; the second time after it was recovered and neither saved nor discarded.
    with opened(program, home=home) as window:
        check("recovery.recover" not in window.last("layout")["rects"], "saved work is offered again")
        window.rect("recent." + os.path.basename(model))
        window.wait_idle()
        window.screenshot(os.path.join(output, "recent_start_page.png"))
        window.click_on("recent." + os.path.basename(model))
        window.wait_event("opened", 0)
        window.wait_idle()
        edit(window)
        window.key("ctrl+n")
        answer(window, "prompt.discard")
        window.wait(lambda: window.last("document")["position"] == 0, "the new document")
        window.wait(lambda: not slots(home), "the copy of discarded work to go")
        window.key("ctrl+i")
        window.type_path(model.replace(".hariko", ".obj"))
        window.wait_event("imported", 0)
        window.wait_event("autosaved", 0)
        window.wait(lambda: len(slots(home)) == 1, "a copy of a document that has no file")
        window.program.kill()
        window.program.wait()
    with opened(program, home=home) as window:
        answer(window, "recovery.recover")
        window.wait_event("recovered", 0)
        window.program.kill()
        window.program.wait()
    with opened(program, home=home) as window:
        answer(window, "recovery.recover")
        window.wait_event("recovered", 0)
        window.wait_idle()
        never_saved = os.path.join(folder, "never_saved.hariko")
        save_as(window, never_saved)
        check(b"vertices" in read(never_saved), "the recovered document is empty")
        check(window.quit() == 0, "the program did not end well")
    check(not slots(home), "a copy is left")


def discard(program, model, folder, output):
    """A copy of a killed session over another file: a dialog; Discard asks and removes it."""
    home = os.path.join(folder, "discard")
    autosave_every_second(home)
    with opened(program, model, home=home) as window:
        edit_and_autosave(window)
        window.program.kill()
        window.program.wait()
    other = shutil.copy(model, os.path.join(folder, "other.hariko"))
    with opened(program, other, home=home) as window:
        window.rect("recovery.discard")
        window.wait_idle()
        window.screenshot(os.path.join(output, "recovery_dialog.png"))
        answer(window, "recovery.discard")
        window.rect("prompt.discard_recovery")
        window.wait_idle()
        window.screenshot(os.path.join(output, "recovery_discard_prompt.png"))
        window.key("Escape")
        window.wait(lambda: "prompt.discard_recovery" not in window.last("layout")["rects"], "the prompt to go")
        check(len(slots(home)) == 1, "Esc discarded the work")
        answer(window, "recovery.discard")
        answer(window, "prompt.discard_recovery")
        window.wait_event("discarded", 0)
        check(not slots(home), "the discarded copy is still there")
        window.wait(lambda: "recovery.discard" not in window.last("layout")["rects"], "the dialog to go")
        check(window.quit() == 0, "the program did not end well")


def signals(program, model, folder, output):
    """SIGTERM and SIGHUP, and the end of the display: the work of less than a second ago is written."""
    del output
    for name, end in (("term", lambda w: w.program.send_signal(signal.SIGTERM)),
                      ("hup", lambda w: w.program.send_signal(signal.SIGHUP)),
                      ("display", lambda w: w.display_server.kill())):
        home = os.path.join(folder, name)  # with the default of 20 seconds
        with opened(program, model, home=home) as window:
            edit(window)
            window.wait_event("autosaved", 0)  # the first one comes at once ...
            edit(window)  # ... and this would be written 20 seconds later
            edit(window)
            end(window)
            code = window.program.wait(timeout=20)
            expected = {"term": 143, "hup": 129, "display": 1}[name]
            check(code == expected, f"{name}: the exit code is {code}")
            window.errors.seek(0)
            errors = window.errors.read()
            check(name != "display" or "recover" in errors, "nothing is said about the lost display: " + errors)
        with opened(program, home=home) as window:
            answer(window, "recovery.recover")
            window.wait_event("recovered", 0)
            window.wait_idle()
            saved = os.path.join(folder, name + ".hariko")
            save_as(window, saved)
            with open(saved, encoding="utf-8") as file:
                check(len(json.load(file)["objects"]) == 4, f"{name}: the last steps are not in the recovered document")
            check(window.quit() == 0, "the program did not end well")


def two_windows(program, model, folder, output):
    """The same file in two windows, and their recovery copies."""
    home = os.path.join(folder, "two")
    autosave_every_second(home)
    with opened(program, model, home=home) as first:
        edit_and_autosave(first)
        check(len(slots(home)) == 1, "no copy of the first window")
        with opened(program, home=home) as second:
            check("recovery.recover" not in second.last("layout")["rects"], "a living window's work is offered")
            second.key("ctrl+o")
            second.type_path(model)
            second.rect("prompt.read_only")
            second.wait_idle()
            second.screenshot(os.path.join(output, "lock_prompt.png"))
            answer(second, "prompt.read_only")
            second.wait_event("opened", 0)
            second.wait_idle()
            second.screenshot(os.path.join(output, "read_only.png"))
            edit_and_autosave(second)
            check(len(slots(home)) == 2, f"two windows have these copies: {slots(home)}")
            second.key("ctrl+s")  # asks for another name
            second.rect("dialog.name")
            second.key("Escape")
            # The name of the other window's file is refused, though the dialog lets it be overwritten.
            second.key("ctrl+shift+s")
            second.type_path(model)
            second.wait_idle()
            second.click_on("dialog.accept")  # "Replace" by now
            second.wait(lambda: "another window" in (second.last("notice") or {"text": ""})["text"], "the refusal")
            second.key("Escape")
            second.program.kill()
            second.program.wait()
        check(len(slots(home)) == 2, "the copy of the killed window is gone")
        # A copy of its own.
        with opened(program, model, home=home) as third:
            answer(third, "prompt.copy")
            third.wait_event("opened", 0)
            third.wait_idle()
            answer(third, "offers.close") if "offers.close" in third.last("layout")["rects"] else None
            edit(third)
            save_as(third, os.path.join(folder, "third.hariko"))
            check(third.quit() == 0, "the third window did not end well")
        check(len(slots(home)) == 2, "the third window ate a copy")
        first.key("ctrl+s")
        first.wait_event("saved", 0)
        first.wait(lambda: len(slots(home)) == 1, "the first window's copy to go")
        check(first.quit() == 0, "the first window did not end well")
    # Nobody has the file any more: no question.
    with opened(program, model, home=home) as window:
        window.wait_event("opened", 0)
        check("prompt.read_only" not in window.last("layout")["rects"], "a stale lock is asked about")
        window.key("Escape")
        check(window.quit() == 0, "the program did not end well")


def changed_on_disk(program, model, folder, output):
    home = os.path.join(folder, "changed")
    other = read(os.path.join(os.path.dirname(model), "other_content.hariko"))
    with opened(program, model, home=home) as window:
        edit(window)
        os.utime(model)  # touched only: no question
        window.key("ctrl+s")
        window.wait_event("saved", 0)
        edit(window)
        with open(model, "wb") as file:
            file.write(other)
        window.key("ctrl+s")
        window.rect("prompt.overwrite")
        window.wait_idle()
        window.screenshot(os.path.join(output, "changed_prompt.png"))
        window.key("Escape")
        window.wait(lambda: "prompt.overwrite" not in window.last("layout")["rects"], "the prompt to go")
        check(read(model) == other, "the changed file was overwritten without an answer")
        check(window.last("document")["dirty"], "the document counts as saved")
        window.key("ctrl+s")
        answer(window, "prompt.save_as")
        elsewhere = os.path.join(folder, "elsewhere.hariko")
        window.type_path(elsewhere)
        window.wait_event("saved", 1)
        window.wait_idle()
        check(read(model) == other and os.path.exists(elsewhere), "Save as wrote the changed file")
        # Revert is a step that can be undone.
        edit(window)
        position = window.last("document")["position"]
        window.click_on("menu.File")
        window.click_on("command.file.revert")
        window.wait_event("reverted", 0)
        window.wait(lambda: not window.last("document")["dirty"], "the reverted document to count as saved")
        window.key("ctrl+z")
        window.wait(lambda: window.last("document")["position"] == position, "undo of the revert")
        window.key("ctrl+q")
        answer(window, "prompt.discard")
        check(window.program.wait(timeout=20) == 0, "the program did not end well")
    check(not slots(home), "discarded work left a copy")


def broken_settings(program, model, folder, output):
    home = os.path.join(folder, "settings")
    config = os.path.join(home, "config", "hariko")
    os.makedirs(config)
    with open(os.path.join(config, "settings.json"), "w", encoding="ascii") as file:
        file.write('{"theme": ')
    with opened(program, home=home) as window:
        window.wait(lambda: "settings" in (window.last("notice") or {"text": ""})["text"], "the message on the settings")
        window.screenshot(os.path.join(output, "broken_settings.png"))
        check(window.quit() == 0, "the program did not end well")
    check(any("broken" in name for name in os.listdir(config)), f"the broken file was not kept: {os.listdir(config)}")
    home = os.path.join(folder, "crash")  # used before: what this version does not know is still there
    with open(os.path.join(home, "config", "hariko", "settings.json"), encoding="utf-8") as file:
        check(json.load(file)["of_a_later_version"] == [1, 2], "the settings lost what a later version wrote")
    del model


def session(program, source, output):
    samples = os.path.join(source, "assets", "samples")
    with tempfile.TemporaryDirectory() as folder:
        model = shutil.copy(os.path.join(samples, "cube.hariko"), os.path.join(folder, "model.hariko"))
        shutil.copy(os.path.join(source, "tests", "golden", "torus.obj"), os.path.join(folder, "model.obj"))
        shutil.copy(os.path.join(samples, "torus.hariko"), os.path.join(folder, "other_content.hariko"))
        only = os.environ.get("HARIKO_ONLY")
        for part in (crash_and_recover, discard, signals, two_windows, changed_on_disk, broken_settings):
            if only and part.__name__ not in only.split(","):
                continue
            shutil.copy(os.path.join(samples, "cube.hariko"), model)
            print(part.__name__, flush=True)
            part(program, model, folder, output)


run(session)
