"""Drives the real window: starts it on a display of its own, finds things through its test log, and sends real mouse
and key events. No window manager: the window then sits at 0,0 and its pixels are the screen's."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time

# Presses must outlast a frame: software rendering on a loaded machine is slow.
# Programs with sanitizers are several times slower, and four tests run side by side.
PATIENCE = float(os.environ.get("HARIKO_TEST_PATIENCE", "1"))
HOLD = 0.12
# Buttons of the X server that are steps of the wheel.
WHEEL = (4, 5, 6, 7)


class Failure(Exception):
    pass


def check(condition, text):
    if not condition:
        raise Failure(text)


def start_server(width, height):
    """An X server of its own, and the name of its display."""
    read_end, write_end = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp"],
                              pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    os.close(write_end)
    with os.fdopen(read_end) as pipe:
        return server, ":" + pipe.readline().strip()


class Window:
    """`home` is the folder of settings, state and cache; without one each window has its own. Give the same to
    several windows to restart a session or to run two side by side. A sample is copied first, as a file of the
    user's: the shipped one would open without a file. `arguments` are options of the program."""

    def __init__(self, program, *files, size=(1280, 800), home=None, arguments=()):
        self.folder = tempfile.mkdtemp(prefix="hariko-window-")
        self.log_path = os.path.join(self.folder, "log.jsonl")
        self.display_server = self.program = None
        self.events = []
        self._saved_as = None
        self._log = None
        self._rest = b""
        self.home = home or os.path.join(self.folder, "home")
        try:
            self._start(program, [*arguments, *(self._own(file) for file in files)], size)
        except BaseException:
            self.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def _own(self, file):
        shipped = os.path.basename(os.path.dirname(file)) == "samples"
        return shutil.copy(file, self.folder) if shipped else file

    def _start(self, program, files, size):
        self.display_server, display = start_server(max(1600, size[0]), max(1000, size[1]))
        check(display != ":", "Xvfb did not start")
        self.environment = dict(os.environ, DISPLAY=display, XDG_CONFIG_HOME=os.path.join(self.home, "config"),
                                XDG_STATE_HOME=os.path.join(self.home, "state"),
                                XDG_CACHE_HOME=os.path.join(self.home, "cache"))
        self.errors = open(os.path.join(self.folder, "stderr.txt"), "w+")
        self.program = subprocess.Popen(
            [program, "--test-log", self.log_path, "--width", str(size[0]), "--height", str(size[1]), *files],
            env=self.environment, stderr=self.errors, cwd=self.folder)
        found = self.xdotool("search", "--sync", "--onlyvisible", "--name", "Hariko", timeout=40 * PATIENCE)
        self.id = found.split()[0]
        self.xdotool("windowfocus", "--sync", self.id)
        self.wait_idle()

    def xdotool(self, *arguments, timeout=20 * PATIENCE):
        done = subprocess.run(["xdotool", *arguments], env=self.environment, capture_output=True, text=True,
                              timeout=timeout)
        check(done.returncode == 0, f"xdotool {arguments}: {done.stderr}")
        return done.stdout

    # The log, in which the program says what it does.
    def read(self):
        if self._log is None:
            if not os.path.exists(self.log_path):
                return
            self._log = open(self.log_path, "rb")
        # The end may lie within a character.
        *lines, self._rest = (self._rest + self._log.read()).split(b"\n")
        self.events += [json.loads(line) for line in lines]

    def last(self, event):
        self.read()
        return next((e for e in reversed(self.events) if e["event"] == event), None)

    def count(self, event, **values):
        self.read()
        return sum(1 for e in self.events if e["event"] == event and all(e.get(k) == v for k, v in values.items()))

    def wait(self, condition, what, seconds=30, or_end=False):
        """With `or_end` the end of the program ends the waiting, too."""
        end = time.monotonic() + seconds * PATIENCE
        while time.monotonic() < end:
            self.read()
            if condition():
                return
            status = self.program.poll()
            if status is not None:
                if or_end:
                    return
                self.errors.seek(0)
                raise Failure(f"the program ended with {status} while waiting for {what}: {self.errors.read()[-2000:]}")
            time.sleep(0.02)
        picture = self._picture_of_failure()
        recent = [{k: v for k, v in e.items() if k not in ("rects", "objects")} for e in self.events[-12:]]
        raise Failure(f"timeout waiting for {what}; {picture}last events: {recent}")

    def _picture_of_failure(self):
        """Picture of the window when nothing more came; where it is, for the message."""
        path = os.path.join(sys.argv[3], "timeout_" + os.path.basename(sys.argv[0]).replace("_test.py", ".png"))
        try:
            self.screenshot(path)
        except (OSError, AttributeError, subprocess.SubprocessError):
            return ""
        return f"the window is in {path}; "

    def wait_event(self, event, since, **values):
        self.wait(lambda: self.count(event, **values) > since, f"{event} {values}")

    def wait_idle(self):
        """Until nothing is left to do: the last event of the log is `idle`, or nothing came after it."""
        self.wait(lambda: self.events and self.events[-1]["event"] == "idle", "idle")

    def rects(self):
        """Rectangles of everything that is marked now, by its name: left, top, width, height."""
        return (self.last("layout") or {"rects": {}})["rects"]

    def rect(self, name):
        self.wait(lambda: name in self.rects(), f"something called {name}")
        return self.rects()[name]

    def gone(self, name):
        """Waits until nothing is called so."""
        self.wait(lambda: name not in self.rects(), f"{name} to go")

    def resting_rect(self, name):
        """Rectangle of something once it has stopped moving: a hand does not click on what still moves."""
        before, now = None, self.rect(name)
        while now != before:
            time.sleep(HOLD)
            self.read()
            before, now = now, self.rect(name)
        return now

    def center(self, name):
        x, y, width, height = self.resting_rect(name)
        return x + width // 2, y + height // 2

    def vertex(self, vertex, object_id=1):
        return self.vertices(object_id)[str(vertex)]

    def nearest_vertex(self, object_id=1):
        """Id of the vertex nearest to the eye: nothing hides it."""
        pixels = self.vertices(object_id)
        return min(pixels, key=lambda v: pixels[v][2])

    # The document: its last step, what is selected in it, and its vertices.
    def position(self):
        return self.last("document")["position"]

    def label(self):
        return self.last("document")["label"]

    def selection(self):
        return self.last("document")["selection"]

    def vertices(self, object_id=1):
        return self.last("vertices")["objects"][str(object_id)]

    def step(self, label=None, position=None):
        """Waits for the end of a step, by its label, its number or both, and until all rests; its number."""
        def reached():
            now = self.last("document")
            return (not now["gesture"] and label in (None, now["label"]) and position in (None, now["position"]))
        self.wait(reached, f"the step {label or ''} {'' if position is None else position}")
        self.wait_idle()
        return self.position()

    def selected(self, text):
        self.wait(lambda: self.selection() == text, "this selection: " + text)

    # Hands. What is sent is waited for, so that the log speaks of what came after it.
    def send(self, counted, changes, *arguments):
        """Sends keys or buttons, and waits until a frame has acted on all `changes` of them."""
        self.read()
        before = (self.last("input") or {counted: 0})[counted]
        self.xdotool(*arguments)
        self.wait(lambda: (self.last("input") or {counted: 0})[counted] >= before + changes, f"{arguments} to be taken",
                  or_end=True)
        time.sleep(HOLD)

    def move(self, x, y):
        self.xdotool("mousemove", str(round(x)), str(round(y)))
        time.sleep(HOLD)

    def press(self, button=1):
        self.send("buttons", 0 if button in WHEEL else 1, "mousedown", str(button))

    def release(self, button=1):
        self.send("buttons", 0 if button in WHEEL else 1, "mouseup", str(button))

    def arrive(self, x, y):
        """Moves there, and waits until the window has seen it, and with that all that came before."""
        self.move(x, y)
        target = [round(x), round(y)]
        self.wait(lambda: (self.last("pointer") or {"at": None})["at"] == target, f"the pointer at {target}")

    def click(self, x, y):
        self.arrive(x, y)
        self.press()
        self.release()

    def click_on(self, name):
        """Clicks where the thing is once it rests: two frames after all that came before."""
        at = None
        while self.center(name) != at:
            at = self.center(name)
            self.arrive(at[0] + 1, at[1])
            self.arrive(*at)
        self.press()
        self.release()

    def drag(self, start, end, button=1, steps=6, before_release=None):
        self.arrive(*start)
        self.press(button)
        for i in range(1, steps + 1):
            self.move(start[0] + (end[0] - start[0]) * i / steps, start[1] + (end[1] - start[1]) * i / steps)
        if before_release:
            before_release()
        self.release(button)

    def drag_vertex(self, vertex, by, **options):
        x, y, _ = self.vertex(vertex)
        self.drag((x, y), (x + by[0], y + by[1]), **options)

    def slide(self, slider, **options):
        """Drags a slider from its left end to six tenths of its way."""
        left, top, width, height = self.rect(slider)
        self.drag((left + 8, top + height / 2), (left + width * 0.6, top + height / 2), **options)

    def key(self, chord):
        self.send("keys", 2 * len(chord.split("+")), "key", "--delay", "60", chord)

    def type(self, text):
        self.send("keys", 2 * len(text), "type", "--delay", "40", "--", text)

    def keys(self, *chords):
        for chord in chords:
            self.key(chord)

    def undo(self, steps=1):
        for _ in range(steps):
            before = self.position()
            self.key("ctrl+z")
            self.step(position=before - 1)

    def redo(self, steps=1):
        for _ in range(steps):
            before = self.position()
            self.key("ctrl+shift+z")
            self.step(position=before + 1)

    def enter(self, name, text, end="Return"):
        """Types over what a field holds."""
        self.click_on(name)
        self.key("ctrl+a")
        self.type(text)
        self.key(end)

    def pick_of(self, field, ending):
        """An item of a list in a dialog."""
        self.click_on(field)
        self.click_on(field + ending)
        self.gone(field + ending)

    def choose(self, menu, *items):
        """Goes through a menu."""
        self.click_on("menu." + menu)
        for item in items:
            self.click_on(item)

    def pick(self, combo, number):
        """An item of a list in the properties."""
        self.click_on("combo." + combo)
        self.click_on(f"choice.{combo}.{number}")

    def run_by_name(self, words, command=None, keys="F3"):
        """Runs what the palette finds, which has to be the command."""
        self.key(keys)
        self.rect("palette.input")
        self.wait_idle()  # the field takes letters from its second frame on
        self.type(words)
        if command:
            self.rect("palette.selected." + command)
        self.wait_idle()
        self.key("Return")

    def save_as(self, path):
        saved = self.count("saved")
        self.type_path(path, "ctrl+shift+s")
        self.wait_event("saved", saved)
        self.wait_idle()
        self._saved_as = path

    def saved(self, path):
        """The document as a file has it. The name is typed once: a dialog takes seconds."""
        if self._saved_as == path:
            saved = self.count("saved")
            self.key("ctrl+s")
            self.wait_event("saved", saved)
            self.wait_idle()
        else:
            self.save_as(path)
        with open(path, encoding="utf-8") as file:
            return json.load(file)

    def until_opened(self):
        self.wait_event("opened", 0)
        self.wait_idle()

    def type_path(self, path, opening=None):
        """Fills in the file dialog and accepts it; `opening`: the keys that open it first."""
        if opening:
            self.key(opening)
        self.rect("dialog.name")
        time.sleep(0.3)
        self.key("ctrl+a")
        self.type(path)
        self.key("Return")

    def screenshot(self, path):
        subprocess.run(["import", "-window", self.id, path], env=self.environment, check=True, timeout=30 * PATIENCE)

    def quit(self):
        """Leaves by the shortcut; the exit code."""
        self.key("ctrl+q")
        return self.program.wait(timeout=20)

    def close(self):
        for process in (self.program, self.display_server):
            if process and process.poll() is None:
                process.kill()
                process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


def run(test):
    """Calls test(program, source, output) and turns a failure into an exit code."""
    program, source, output = sys.argv[1:4]
    try:
        test(program, source, output)
    except (Failure, subprocess.SubprocessError, AssertionError) as failure:
        print("FAILED:", failure)
        sys.exit(1)
    print("passed")
