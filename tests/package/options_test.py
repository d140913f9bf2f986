"""The manual page and the completion know every option that the program's help lists, and no other."""

import os
import re
import subprocess
import sys

PROGRAM, DESKTOP = sys.argv[1:3]
COMMANDS = ["info", "export", "render", "mesh", "sections", "evaluate", "unfold", "run"]


def help_of(*command):
    return subprocess.run([PROGRAM, *command, "--help"], capture_output=True, text=True, check=True).stdout


def options_in(text):
    """Options named by the lines that list them: `  -h,--help  ...`, `  --size TEXT ...`."""
    found = set()
    for line in text.splitlines():
        if match := re.match(r"\s+((?:-\w,\s*)?--[a-z][a-z0-9-]*)", line):
            found.add(match.group(1).split(",")[-1].strip())
    return found - {"--help"}


def completed(*words):
    script = (f"source {DESKTOP}/hariko.bash-completion; compopt() {{ :; }}; COMP_WORDS=(\"$@\"); COMP_CWORD=$(($# - 1)); "
              "_hariko; printf '%s\\n' \"${COMPREPLY[@]}\"")
    out = subprocess.run(["bash", "--norc", "-c", script, "bash", "hariko", *words], capture_output=True, text=True, check=True)
    return {word for word in out.stdout.split() if word.startswith("--")} - {"--help"}


def main():
    with open(os.path.join(DESKTOP, "hariko.1"), encoding="utf-8") as file:
        page = {f"--{name}" for name in re.findall(r"Fl -([a-z][a-z0-9-]*)", file.read())}
    helps = {command: options_in(help_of(command)) for command in COMMANDS}
    wrong = []
    for command, options in helps.items():
        assert options, f"no options in the help of {command}"
        if missing := options - page:
            wrong.append(f"{command}: not in hariko.1: {sorted(missing)}")
        if differing := options ^ completed(command, "--"):
            wrong.append(f"{command}: in help or in completion only: {sorted(differing)}")
    every = set().union(*helps.values(), options_in(help_of()), completed("--"))
    if unknown := page - every - {"--help"}:
        wrong.append(f"hariko.1 has what no help lists: {sorted(unknown)}")
    if missing := options_in(help_of()) - completed("--"):
        wrong.append(f"not completed: {sorted(missing)}")
    assert not wrong, "\n".join(wrong)


main()
