"""Replays: a session is recorded in the real window and played again, the saved documents are the same; so is one that
was recorded from the menu in the middle of a session; a replay whose document is another one fails; the replay that
comes with the tests ends as it was recorded."""

import json
import os
import subprocess
import tempfile

from driver import Window, check, run, start_server


def record(program, sample, recording, saved):
    """Drags vertices, sets a tension, undoes, saves over the copy that was opened."""
    with Window(program, "--record", recording, sample) as window:
        for by in ((50, 30), (-35, 45)):
            window.drag_vertex(window.nearest_vertex(), by)
            window.wait_idle()
        window.slide("slider.alpha")
        window.wait_idle()
        window.key("ctrl+alt+q")
        window.wait_idle()
        x, y = window.center("view.2")
        window.drag((x, y), (x + 40, y + 10), button=2)
        window.undo()
        window.key("ctrl+s")
        window.wait_event("saved", 0)
        window.wait_idle()
        check(window.quit() == 0, "the recorded session did not end well")
    with open(sample, encoding="utf-8") as file:
        text = file.read()
    os.rename(sample, saved)
    return text


def record_from_menu(program, sample, recording):
    """Changes the document and the look of things first; records an undo to where the recording began."""
    with Window(program, sample) as window:
        window.drag_vertex(window.nearest_vertex(), (40, 25))
        window.wait(lambda: window.position() == 1, "the first step")
        window.key("3")
        window.drag(window.center("viewport"), tuple(c + 60 for c in window.center("viewport")), button=2)
        window.choose("Help", "command.help.record")
        window.type_path(recording)
        window.wait_event("recording", 0)
        window.wait_idle()
        check(window.position() == 0, "the recording can be undone to before its beginning")
        window.drag_vertex(window.nearest_vertex(), (-45, 30))
        window.wait(lambda: window.position() == 1, "the recorded step")
        window.key("ctrl+z")
        window.key("ctrl+z")  # there is nothing to undo beyond the beginning
        window.key("ctrl+shift+z")
        window.wait(lambda: window.position() == 1, "the step again")
        window.slide("slider.alpha")
        window.step(position=2)
        window.click_on("status.stop_recording")
        window.wait_event("recorded", 0)
        window.wait(lambda: window.position() == 3, "the steps from before the recording")
        window.key("ctrl+q")
        window.click_on("prompt.discard")
        check(window.program.wait(timeout=20) == 0, "the session did not end well")


def play(program, recording, folder):
    """Exit code and error output of a replay in a window of its own."""
    server, display = start_server(1600, 1000)
    try:
        environment = dict(os.environ, DISPLAY=display)
        for name in ("CONFIG", "STATE", "CACHE", "DATA"):
            environment[f"XDG_{name}_HOME"] = os.path.join(folder, name.lower())
        done = subprocess.run([program, "--replay", recording, "--skip-pauses"], env=environment, capture_output=True, text=True,
                              timeout=170, cwd=folder)
        return done.returncode, done.stderr
    finally:
        server.kill()
        server.wait()


def session(program, source, output):
    del output
    with tempfile.TemporaryDirectory() as folder:
        sample, recording = os.path.join(folder, "vase.hariko"), os.path.join(folder, "session.jsonl")
        saved = os.path.join(folder, "recorded.hariko")
        with open(os.path.join(source, "assets", "samples", "fig2.hariko"), encoding="utf-8") as file:
            original = file.read()

        def restore():
            with open(sample, "w", encoding="utf-8") as copy:
                copy.write(original)
        restore()
        expected = record(program, sample, recording, saved)
        check(expected != original, "the recorded session changed nothing")
        restore()
        code, errors = play(program, recording, folder)
        check(code == 0, f"the replay ended with {code}: {errors}")
        with open(sample, encoding="utf-8") as file:
            check(file.read() == expected, "the replay saved another document")

        # A replay that does something else is noticed: without the second drag's moves.
        with open(recording, encoding="utf-8") as file:
            lines = [json.loads(line) for line in file]
        presses = [i for i, line in enumerate(lines)
                   if any(e["kind"] == "button" and e["down"] and e["button"] == 0 for e in line.get("events", []))]
        spoiled = [line for i, line in enumerate(lines)
                   if not presses[1] < i < presses[2] or not any(e["kind"] == "move" for e in line.get("events", []))
                   or any(e["kind"] == "button" for e in line["events"])]
        with open(recording, "w", encoding="utf-8") as file:
            file.writelines(json.dumps(line) + "\n" for line in spoiled)
        restore()
        code, errors = play(program, recording, folder)
        check(code == 1 and "otherwise" in errors, f"a spoiled replay ended with {code}: {errors}")

        restore()
        from_menu = os.path.join(folder, "from_menu.jsonl")
        record_from_menu(program, sample, from_menu)
        os.remove(sample)  # the replay has what it began with
        code, errors = play(program, from_menu, folder)
        check(code == 0, f"the replay recorded from the menu ended with {code}: {errors}")

        kept = os.path.join(os.path.dirname(os.path.abspath(__file__)), "replays")
        replays = sorted(name for name in os.listdir(kept) if name.endswith(".jsonl"))
        check(replays, "no replays are kept")
        for name in replays:
            code, errors = play(program, os.path.join(kept, name), folder)
            check(code == 0, f"{name} ended with {code}: {errors}")


run(session)
