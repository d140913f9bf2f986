"""A monkey at the window: random clicks, drags, wheel turns and keys for a minute. The program must neither end nor
hang. HARIKO_SEED repeats a run, HARIKO_MONKEY_SECONDS changes its length."""

import os
import random
import shutil
import tempfile
import time

from driver import Window, check, run

# Everything but leaving; saving is fine, since the model is a copy in a temporary folder.
KEYS = ["1", "2", "3", "Escape", "Delete", "Home", "f", "ctrl+z", "ctrl+shift+z", "ctrl+y", "ctrl+s", "ctrl+o",
        "ctrl+e", "ctrl+i", "Tab", "Return", "a", "ctrl+a", "KP_1", "KP_3", "KP_7", "5", "minus", "period", "Down", "Up"]


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
        try:
            end = time.monotonic() + float(os.environ.get("HARIKO_MONKEY_SECONDS") or 60)
            actions = 0
            while time.monotonic() < end:
                act(window, rng, size)
                actions += 1
                status = window.program.poll()
                check(status is None, f"the program ended with {status} after {actions} actions")
            # Not hung: it still answers the pointer with a frame and comes to rest.
            window.key("Escape")
            window.key("Escape")
            window.wait_idle()
            print(actions, "actions")
        finally:
            window.close()


run(monkey)
