"""A monkey at the window: random clicks, drags, wheel turns, keys and typed text for two minutes. The program must neither
crash nor hang. HARIKO_SEED repeats a run, HARIKO_MONKEY_SECONDS changes its length."""

import os
import random
import shutil
import subprocess
import tempfile
import time

import driver
from driver import Failure, Window, check, run

driver.HOLD = 0.03  # a hasty monkey

# Everything but leaving; saving is fine, since the model is a copy in a temporary folder. Menus, dialogs and the palette
# are found by these too.
KEYS = (["1", "2", "3", "4", "Escape", "Escape", "Return", "Return", "Delete", "Home", "Tab", "space", "BackSpace",
         "ctrl+z", "ctrl+z", "ctrl+shift+z", "ctrl+y", "ctrl+s", "ctrl+o", "ctrl+e", "ctrl+i", "ctrl+n", "ctrl+a",
         "ctrl+d", "ctrl+b", "ctrl+r", "ctrl+l", "ctrl+comma", "ctrl+shift+p", "F1", "F2", "F3", "F9", "F12",
         "KP_1", "KP_3", "KP_5", "KP_7", "minus", "period", "Down", "Up", "Left", "Right", "shift+x", "shift+y"]
        + list("abcdefghijklmnopqrstuvwxyz0123456789"))
TEXTS = ["12", "-3.5mm", "1/0", "2*pi", "((", "cube", "1e9", "Δ"]


def act(window, rng, size):
    x, y = rng.randrange(size[0]), rng.randrange(size[1])
    kind = rng.random()
    if kind < 0.35:
        window.click(x, y)
    elif kind < 0.6:
        window.drag((x, y), (rng.randrange(size[0]), rng.randrange(size[1])), button=rng.choice([1, 1, 1, 2, 3]), steps=3)
    elif kind < 0.7:
        window.move(x, y)
        window.xdotool("click", "--repeat", "3", "--delay", "40", rng.choice(["4", "5"]))
    elif kind < 0.75:
        window.type(rng.choice(TEXTS))
    elif kind < 0.8:
        # A place where something was, whatever is there now; a row that is scrolled away is nowhere.
        rects = window.rects()
        left, top, width, height = rects[rng.choice(sorted(rects))]
        at = left + width // 2, top + height // 2
        if 0 <= at[0] < size[0] and 0 <= at[1] < size[1]:
            window.click(*at)
    else:
        window.key(rng.choice(KEYS))


def monkey(program, source, output):
    seed = int(os.environ.get("HARIKO_SEED") or random.SystemRandom().randrange(2**32))
    print(f"HARIKO_SEED={seed}", flush=True)
    rng = random.Random(seed)
    size = (1100, 720)
    with tempfile.TemporaryDirectory() as folder:
        model = shutil.copy(os.path.join(source, "assets", "samples", "car.hariko"), folder)
        window = Window(program, model, size=size)
        actions = left = 0
        try:
            end = time.monotonic() + float(os.environ.get("HARIKO_MONKEY_SECONDS") or 120)
            while time.monotonic() < end:
                try:
                    act(window, rng, size)
                except (Failure, subprocess.SubprocessError):
                    if window.program.poll() is None:
                        raise
                actions += 1
                status = window.program.poll()
                if status == 0:  # it found Quit
                    left += 1
                    window.close()
                    window = Window(program, model, size=size)
                else:
                    check(status is None, f"the program ended with {status} after {actions} actions")
            print(f"{actions} actions, left by Quit {left} times", flush=True)
            # Not hung: it still answers and comes to rest.
            for _ in range(6):
                window.key("Escape")
            window.wait_idle()
        finally:
            window.close()


run(monkey)
