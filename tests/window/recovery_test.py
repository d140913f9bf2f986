"""Nothing is lost: a killed program offers its work again, signals and a lost display write it, two windows do not eat
each other's work. What needs no second process is in tests/workbench/document_session_test.cpp."""

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
    before = window.position()
    window.key("ctrl+d")
    window.wait(lambda: window.position() == before + 1 and window.last("document")["dirty"], "the step")


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


def crash_and_recover(program, model, folder, output):
    """Kills the program with work in a file and with work that was never saved."""
    home = os.path.join(folder, "crash")
    autosave_every_second(home)
    committed = os.path.join(folder, "committed.hariko")
    with opened(program, model, home=home) as window:
        edit(window)
        edit_and_autosave(window)
        window.type_path(committed, "ctrl+alt+s")
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


def report_of_a_crash(program, model, folder, output):
    """A crash leaves a report beside the log, and the next start offers it above the work."""
    home = os.path.join(folder, "report")
    state = os.path.join(home, "state", "hariko")
    autosave_every_second(home)
    with opened(program, model, home=home) as window:
        edit_and_autosave(window)
        window.program.send_signal(signal.SIGSEGV)
        window.program.wait(timeout=20)
        window.errors.seek(0)
        if "AddressSanitizer" in window.errors.read():
            return  # the sanitizer reports crashes itself
        report = read(os.path.join(state, f"crash-{window.program.pid}.txt")).decode()
    for part in ("hariko crashed: SEGV\n", " UTC\n", "\nHariko ", "\nOpenGL ", "\nDear ImGui "):
        check(part in report, f"the report does not say {part!r}: {report}")
    log = read(os.path.join(state, "log.txt")).decode()
    for part in (" start Hariko ", ", model.hariko, ", " opengl OpenGL ", " opened model.hariko\n"):
        check(part in log, f"the log does not say {part!r}: {log}")
    check(folder not in log, f"the log names the user's folders: {log}")

    with opened(program, home=home, size=(1280, 800)) as window:
        window.rect("crash.dismiss")
        window.rect("recovery.recover")
        window.wait_idle()
        window.screenshot(os.path.join(output, "crash_start_page.png"))
        answer(window, "crash.dismiss")
        window.gone("crash.dismiss")
        check("recovery.recover" in window.rects(), "the work went with the report")
        check(os.path.exists(os.path.join(state, "crash.txt")), "the report that was seen is not kept")
        check(window.quit() == 0, "the program did not end well")
    check(b" end 0\n" in read(os.path.join(state, "log.txt")), "the log does not know that the program ended well")


def signals(program, model, folder, output):
    """SIGTERM and the end of the display: the work of less than a second ago is written."""
    del output
    for name, end in (("term", lambda w: w.program.send_signal(signal.SIGTERM)),
                      ("display", lambda w: w.display_server.kill())):
        home = os.path.join(folder, name)  # with the default of 20 seconds
        with opened(program, model, home=home) as window:
            edit(window)
            window.wait_event("autosaved", 0)  # the first one comes at once ...
            edit(window)  # ... and this would be written 20 seconds later
            edit(window)
            end(window)
            code = window.program.wait(timeout=20)
            expected = {"term": 143, "display": 1}[name]
            check(code == expected, f"{name}: the exit code is {code}")
            window.errors.seek(0)
            errors = window.errors.read()
            check(name != "display" or "recover" in errors, "nothing is said about the lost display: " + errors)
        with opened(program, home=home) as window:
            answer(window, "recovery.recover")
            window.wait_event("recovered", 0)
            window.wait_idle()
            saved = os.path.join(folder, name + ".hariko")
            window.save_as(saved)
            with open(saved, encoding="utf-8") as file:
                check(len(json.load(file)["objects"]) == 4, f"{name}: the last steps are not in the recovered document")
            check(window.quit() == 0, "the program did not end well")


def two_windows(program, model, folder, output):
    """The same file in two windows: the second is asked, neither eats the other's work."""
    home = os.path.join(folder, "two")
    autosave_every_second(home)
    with opened(program, model, home=home) as first:
        edit_and_autosave(first)
        check(len(slots(home)) == 1, "no copy of the first window")
        with opened(program, model, home=home) as second:
            second.rect("prompt.read_only")
            second.wait_idle()
            second.screenshot(os.path.join(output, "lock_prompt.png"))
            answer(second, "prompt.read_only")
            second.wait_event("opened", 0)
            check(second.count("offers") == 0, "a living window's work is offered")
            edit_and_autosave(second)
            check(len(slots(home)) == 2, f"two windows have these copies: {slots(home)}")
            second.program.kill()
            second.program.wait()
        check(len(slots(home)) == 2, "the copy of the killed window is gone")
        first.key("ctrl+s")
        first.wait_event("saved", 0)
        first.wait(lambda: len(slots(home)) == 1, "the first window's copy to go")
        check(first.quit() == 0, "the first window did not end well")
    with open(os.path.join(home, "config", "hariko", "settings.json"), encoding="utf-8") as file:
        check(json.load(file)["of_a_later_version"] == [1, 2], "the settings lost what a later version wrote")


def session(program, source, output):
    samples = os.path.join(source, "assets", "samples")
    with tempfile.TemporaryDirectory() as folder:
        model = os.path.join(folder, "model.hariko")
        only = os.environ.get("HARIKO_ONLY")
        for part in (crash_and_recover, report_of_a_crash, signals, two_windows):
            if only and part.__name__ not in only.split(","):
                continue
            shutil.copy(os.path.join(samples, "cube.hariko"), model)
            print(part.__name__, flush=True)
            part(program, model, folder, output)


run(session)
