"""Every command of the table, through the palette by its name, on the start page and on a full document: it runs or says
why not, and nothing crashes."""

import os
import shutil
import tempfile
import time

from driver import Failure, Window, check, run

# Leaving has tests of its own; the log's folder would be shown by another program.
LEAVE_OUT = {"file.quit", "help.log"}


def text_for(command):
    """Text to type: the label as far as a keyboard has it, else the help."""
    label = "".join(c for c in command["label"] if ord(c) < 128).strip()
    return label if len(label) > 1 else command["help"]


def keys(window, *chords):
    window.xdotool("key", "--delay", "30", *chords)


def choose(window, command):
    """Types the label until the command is the selected row, going down where several are called alike. Whether it
    ran."""
    keys(window, "F3")
    window.rect("palette.input")
    window.wait_idle()  # the field takes letters from its second frame on
    window.xdotool("type", "--delay", "12", text_for(command))
    row = "palette." + command["id"]
    window.wait(lambda: row in window.rects(), f"{command['id']} for {text_for(command)!r}")
    time.sleep(0.15)
    window.wait_idle()  # every letter has arrived
    mark = "palette.selected." + command["id"]
    end = time.monotonic() + 60  # letters arrive late on a busy machine
    while mark not in window.rects():
        check(time.monotonic() < end, f"the palette does not come to {command['id']} by {text_for(command)!r}")
        rects = window.rects()
        selected = next((name for name in rects if name.startswith("palette.selected.")), None)
        keys(window, "Down")
        try:
            window.wait(lambda: selected not in window.rects(), "the next row", seconds=2)
        except Failure:
            pass  # the last letters of the text were on their way and moved the selection back
    before = window.count("command", id=command["id"])
    keys(window, "Return")
    window.wait(lambda: window.count("command", id=command["id"]) > before, command["id"] + " to run or be refused")
    outcome = [e for e in window.events if e["event"] == "command" and e["id"] == command["id"]][-1]
    check(outcome["ran"] or len(outcome["reason"]) > 8, f"{command['id']} neither ran nor said why not: {outcome}")
    # Dialogs, tools, notices and the palette of a refused command go.
    keys(window, "Escape", "Escape", "Escape", "Escape")
    window.gone("palette.input")
    return outcome["ran"]


def walk(window, prepare):
    ran, refused = [], []
    for command in window.last("commands")["table"]:
        if command["id"] in LEAVE_OUT:
            continue
        prepare()
        (ran if choose(window, command) else refused).append(command["id"])
    print(len(ran), "ran;", len(refused), "refused:", " ".join(refused), flush=True)
    return ran, refused


def no_document(window):
    """The start page, whatever the last command did: New leaves an empty document, adding an unsaved one."""
    def shown(name):
        return name in window.rects()
    if shown("viewport"):
        keys(window, "ctrl+w")
        window.wait(lambda: shown("prompt.discard") or not shown("viewport"), "the start page or a question")
        if shown("prompt.discard"):
            window.wait_idle()  # in its first frame the question is not yet where it stays
            window.click_on("prompt.discard")
        window.wait(lambda: not shown("viewport"), "the start page")


def full_document(window, model):
    """The document is open and everything in it is selected, whatever the last command did."""
    for _ in range(6):
        if window.position() == 0:
            break
        keys(window, "ctrl+z")
        window.wait_idle()
    shows = "viewport" in window.rects() and (window.last("vertices") or {"objects": {}})["objects"]
    if not shows:
        opened = window.count("opened")
        window.type_path(model, "ctrl+o")
        window.wait(lambda: window.count("opened") > opened or "prompt.discard" in window.rects(),
                    "the model or a question")
        if window.count("opened") == opened:
            window.click_on("prompt.discard")
            window.wait_event("opened", opened)
    keys(window, "1", "ctrl+a")


def commands(program, source, output):
    with tempfile.TemporaryDirectory() as folder:
        with Window(program) as window:
            ids = {c["id"] for c in window.last("commands")["table"]}
            ran, refused = walk(window, lambda: no_document(window))
            # Without a document most commands cannot run.
            check("file.save" in refused and "file.open" in ran and "edit.undo" in refused, "on nothing: " + str(ran))
            check({"help.palette", "help.keys", "edit.preferences"} <= set(ran), "the helpers do not run")
        model = shutil.copy(os.path.join(source, "assets", "samples", "car.hariko"), folder)
        with Window(program, model) as window:
            ran, refused = walk(window, lambda: full_document(window, model))
            check({"file.save", "select.all", "view.frame_all"} <= set(ran), "with a document: " + str(refused))
            # The language may have changed on the way: the table is the same.
            check({c["id"] for c in window.last("commands")["table"]} == ids, "the table changed")


run(commands)
