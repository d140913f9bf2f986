#!/usr/bin/env python3
"""Checks the catalogues of translations (assets/languages/*.json) against the sources.

  scripts/catalogue.py [--root FOLDER]           says what is missing, unused or wrong; exit code 1 when anything is
  scripts/catalogue.py --missing                 prints the missing entries as JSON, to be filled in
  scripts/catalogue.py --merge FILE [CODE]       takes the entries of FILE into the catalogue and sorts it (ja)

What must have an entry: every string given to tr(), language() or translatable(); whatever else looks like English in
ui/ and app/ (labels, help and reasons of commands, labels of steps, hints); the code of every message, and its remedy
where one is given; a sentence for every message that says a number, so that translations say it too. A literal that
looks like English and is none for the eyes of users is put on ALLOWED."""

import argparse
import glob
import json
import os
import re
import sys

# Words that are the same in every language, or that no user sees.
ALLOWED = {
    "Hariko", "Blender", "Maya", "Rhino", "English", "DISPLAY", "UTF-8",
    "Ctrl + ", "Shift + ", "Alt + ", "Viewport", "object:", "view:", "OpenGL ",
    # Families of fonts.
    "Inter", "FontAwesome", "Noto Sans CJK JP",
    # Names, and what a report of a mistake needs.
    "Dear ImGui (MIT), GLFW (zlib), GLM (MIT), libepoxy (MIT), FreeType (FTL), fontconfig (MIT), Eigen (MPL 2.0), oneTBB (Apache 2.0), "
    "JSON for Modern C++ (MIT), CLI11 (BSD), libpng (libpng), libjpeg-turbo (IJG). Inter, Font Awesome and Noto Sans CJK (SIL OFL).",
    "Hariko ", "\nGLFW ", "\nDear ImGui ", "\nlog.txt:\n", ", scale ",
     # of the test log
    "OpenGL", "k1  k2", "view menu ",
    # of replays, on stderr
    "The replay ended otherwise than it was recorded: ", "the program did not come to rest.",
    "the program was left before the end.", "the document is another one (", " instead of ", "there are ",
    " steps to undo instead of ", "a number is not finite", "something follows the end", "the scale is out of range",
    "times descend", "unknown kind \"", "version ", " is unknown",
}
# The command line and what scripts are told there, the log of tests, and the names of keys, which are the same
# everywhere.
UNSEEN = {"app/main.cpp", "app/crash_report.cpp", "app/input/test_log.cpp", "app/input/replay.cpp", "ui/base/key_chord.cpp",
          "ui/editor/command_arguments.cpp", "ui/view/select_scripts.cpp", "ui/view/transform_scripts.cpp",
          "ui/shell/property_scripts.cpp", "ui/analysis/section_scripts.cpp", "ui/shell/file_scripts.cpp", "app/scripts/script_file.cpp",
          "app/scripts/script_session.cpp"}
# Calls whose literals are not for users, or are translated by the code of their message.
SILENT = {"HARIKO_ASSERT", "make_error", "make_warning", "static_assert", "getenv", "glfwWindowHintString", "PushID",
          "begin_panel", "FindWindowByName", "OpenPopup", "BeginPopup", "IsPopupOpen", "BeginChild"}
MARKING = {"tr", "language", "language_", "translatable", "phrase"}
IMGUI_TEXT = re.compile(
    r"^(Text|TextUnformatted|TextDisabled|TextColored|TextWrapped|BulletText|LabelText|Button|SmallButton|Checkbox|"
    r"RadioButton|MenuItem|BeginMenu|Selectable|SetTooltip|BeginCombo|Combo|CollapsingHeader|TreeNode|TreeNodeEx|"
    r"BeginTabItem|Slider\w+|Drag\w+|Input\w+|ColorEdit\d|ColorPicker\d|SeparatorText|AddText|BeginPopupModal)$")
KEYS = re.compile(r"^((Ctrl|Shift|Alt)\+)*([A-Z0-9,.;'\[\]\\/=`+-]|F\d+|Num( [0-9+\-*/.]| \w+)?|Home|End|Esc|Del|Ins|Enter|"
                  r"Space|Tab|Backspace|Menu|"
                  r"PgUp|PgDn|Ctrl|Shift|Alt|Ctrl\+|Shift\+|Alt\+)$")
PLACEHOLDER = re.compile(r"\{(\d)\}")
TOKEN = re.compile(r"""
    (?P<comment>//[^\n]*|/\*.*?\*/)
  | (?P<raw>R"(?P<delimiter>[^(\s]*)\(.*?\)(?P=delimiter)")
  | (?P<string>(?:u8|L|u|U)?"(?:[^"\\\n]|\\.)*")
  | (?P<char>'(?:[^'\\\n]|\\.)+')
  | (?P<include>^[ \t]*\#[ \t]*(?:include|error|pragma)[^\n]*)
  | (?P<name>[A-Za-z_]\w*(?:::[A-Za-z_]\w*)*)
  | (?P<number>[0-9][0-9a-fA-F'.xX]*)
  | (?P<other>[^\s])
""", re.X | re.S | re.M)
ESCAPE = re.compile(r"\\(u[0-9a-fA-F]{4}|U[0-9a-fA-F]{8}|x[0-9a-fA-F]+|[0-7]{1,3}|.)", re.S)


def decode(literal):
    def one(match):
        body = match.group(1)
        if body[0] in "uUx":
            return chr(int(body[1:], 16))
        if body[0].isdigit():
            return chr(int(body, 8))
        return {"n": "\n", "t": "\t", "r": "\r"}.get(body, body)

    return ESCAPE.sub(one, literal[literal.index('"') + 1:-1])


class Literal:
    """Adjacent literals as one, with the names of the calls round it, innermost last, and its line."""

    def __init__(self, text, calls, path, line, added):
        self.text, self.calls, self.path, self.line = text, calls, path, line
        self.added = added  # joined to something else by +: a piece of a sentence

    def inside(self, names):
        return any(call.split("::")[-1] in names for call in self.calls)

    def place(self):
        return f"{self.path}:{self.line}"


def literals_of(path, source):
    out, stack, previous, last_was_string = [], [], "", False
    for match in TOKEN.finditer(source):
        kind, text = match.lastgroup, match.group()
        if kind == "delimiter":
            kind = "raw"
        if kind in ("comment", "include"):
            continue
        if kind == "string":
            if last_was_string:
                out[-1].text += decode(text)
            else:
                line = source.count("\n", 0, match.start()) + 1
                out.append(Literal(decode(text), list(stack), path, line, previous == "+"))
            last_was_string, previous = True, "string"
            continue
        if text == "+" and last_was_string:
            out[-1].added = True
        last_was_string = False
        if text in "([{" and kind == "other":
            # A brace or a bracket is no call, but keeps the calls round it.
            stack.append(previous if text == "(" and re.match(r"[A-Za-z_]", previous) else "")
        elif text in ")]}" and kind == "other" and stack:
            stack.pop()
        previous = text
    return out


def has_words(text):
    bare = re.sub(r"%[-+ 0-9.*]*[a-zA-Z]+|\{\d\}", "", text)
    return re.search(r"[A-Za-z]{2,}", bare) is not None


def looks_english(text):
    if text in ALLOWED or text.startswith("#") or not has_words(text):
        return False
    if all(KEYS.match(part) for part in text.split(" / ")):
        return False
    if re.match(r"^[\w.#/-]*$", text) and not re.match(r"^[A-Z][a-z]", text):
        return False  # ids, marks, endings of files
    if re.match(r"^[/~.]|^[A-Z]?[\w-]+\.(ttf|otf|ttc|png|json|hariko)$", text) or re.match(r"^[a-z]+[A-Z]\w*$", text):
        return False
    return re.match(r"^[A-Z][a-z]", text) is not None or re.search(r"[A-Za-z]{2,}[ ,:]", text) is not None


def source_files(root, *folders):
    for folder in folders:
        for ending in ("cpp", "hpp"):
            yield from sorted(glob.glob(os.path.join(root, folder, "**", "*." + ending), recursive=True))


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def codes_of(root):
    """Name of the code -> whether a remedy is ever given with it."""
    constants, remedies = {}, set()
    sources = {path: read(path) for path in source_files(root, "core", "render", "ui", "app")}
    for source in sources.values():
        for match in re.finditer(r'constexpr\s+Code\s+(\w+)\s*\{\s*"([EW]_\w+)"', source):
            constants[match.group(1)] = match.group(2)
    for source in sources.values():
        for match in re.finditer(r"\bmake_(?:error|warning)\(\s*(\w+)", source):
            given = arguments_at(source, match.end() - len(match.group(1)))
            if match.group(1) in constants and len(given) > 2 and not re.match(r'\{|Element\b|""$', given[2]):
                remedies.add(constants[match.group(1)])
    return {name: name in remedies for name in constants.values()}


def arguments_at(source, start):
    """The arguments of a call whose first begins at `start`."""
    depth, begin, out = 0, start, []
    for match in TOKEN.finditer(source, start):
        text = match.group()
        if match.lastgroup != "other":
            continue
        if text in "([{":
            depth += 1
        elif text in ")]}":
            if depth == 0:
                out.append(source[begin:match.start()])
                break
            depth -= 1
        elif text == "," and depth == 0:
            out.append(source[begin:match.start()])
            begin = match.end()
    return [argument.strip() for argument in out]


COUNTING = re.compile(r"to_string\(|counted\(|percent\(|number\(|length_text\(")


def split_at(expression, separators):
    """Parts of an expression between separators that stand in no brackets and no literal."""
    depth, begin, out = 0, 0, []
    for match in TOKEN.finditer(expression):
        text = match.group()
        if match.lastgroup != "other":
            continue
        depth += (text in "([{") - (text in ")]}")
        if text in separators and depth == 0:
            out.append(expression[begin:match.start()].strip())
            begin = match.end()
    return out + [expression[begin:].strip()]


def sentences_of(expression):
    """What an expression that puts a sentence together may give, with 7 for what is no literal."""
    if match := re.fullmatch(r"\((.*)\)", expression, re.S):
        if len(split_at(expression, "?+")) == 1:
            return sentences_of(match.group(1).strip())
    if len(chosen := split_at(expression, "?")) > 1:
        return [s for part in split_at("?".join(chosen[1:]), ":") for s in sentences_of(part)]
    out = [""]
    for part in split_at(expression, "+"):
        texts = [literal.text for literal in literals_of("", part)]
        if part.startswith("("):
            given = sentences_of(part)
        elif re.match(r'"|(std::)?string\("', part):
            given = texts
        elif part.startswith("counted") and texts:
            given = ["7" + text for text in texts]
        else:
            given = ["7"]
        out = [before + text for before in out for text in given]
    return out


def counting_sentences(root):
    """Of messages that say numbers or names: what they may be, and where."""
    for path in source_files(root, "core", "render", "ui", "app"):
        source = read(path)
        for match in re.finditer(r"\bmake_(?:error|warning)\(\s*(\w+)", source):
            given = arguments_at(source, match.end() - len(match.group(1)))
            if len(given) > 1 and COUNTING.search(given[1]):
                place = f"{os.path.relpath(path, root)}:{source.count(chr(10), 0, match.start()) + 1}"
                for sentence in sentences_of(re.sub(r"\s+", " ", given[1])):
                    yield sentence, place


def sentence_patterns(catalogue):
    """Entries that are whole sentences with places, as the program takes them for messages."""
    return [re.compile(".+".join(re.escape(piece) for piece in PLACEHOLDER.split(entry)[::2]), re.S)
            for entry in catalogue if PLACEHOLDER.search(entry) and entry[-1] in ".?!"]


def has_sentence(sentence, patterns, catalogue):
    """As Language::text_of looks for it: whole, or behind what it is about."""
    return any(rest.strip(".") == "7" or takes(rest, patterns, catalogue) for rest in rests_of(sentence))


def rests_of(sentence):
    parts = sentence.split(": ")
    return [": ".join(parts[k:]) for k in range(len(parts))]


def takes(rest, patterns, catalogue):
    return rest in catalogue or any(p.fullmatch(rest) for p in patterns)


class Check:
    def __init__(self, root):
        self.root = root
        self.required = {}  # entry -> where
        self.bare = []
        self.all_literals = []
        self.counting = list(counting_sentences(root))
        for path in source_files(root, "core", "render", "ui", "app"):
            literals = literals_of(os.path.relpath(path, root), read(path))
            self.all_literals += [literal.text for literal in literals]
            relative = os.path.relpath(path, root)
            for literal in literals:
                self.look_at(literal, relative)
        for name, has_remedy in codes_of(root).items():
            self.required.setdefault(name, "a code")
            if has_remedy:
                self.required.setdefault(name + ".remedy", "a remedy")

    def look_at(self, literal, path):
        marked = literal.inside(MARKING)
        identifier = re.match(r"^[a-z0-9_]+(\.[a-z0-9_]+)+$", literal.text)
        if marked and not identifier and not literal.inside({"item"}) and has_words(literal.text) and \
                literal.text not in ALLOWED:
            self.required.setdefault(literal.text, literal.place())
        shown = path.startswith(("ui/", "app/")) and not path.startswith("app/commands/") and path not in UNSEEN
        if not shown or marked or literal.inside(SILENT) or "item" in literal.calls[-1:]:
            return
        if looks_english(literal.text):
            self.required.setdefault(literal.text, literal.place())
        call = literal.calls[-1] if literal.calls else ""
        if path.startswith("ui/") and call.startswith("ImGui::") and IMGUI_TEXT.match(call[7:]):
            if has_words(literal.text) and not literal.text.startswith("#") and literal.text not in ALLOWED:
                self.bare.append(f'{literal.place()}: {call}("{literal.text}") is shown in English always')

    def used(self, entry):
        if entry in self.required:
            return True
        if entry.endswith(".remedy") and entry[:-7] in self.required:
            return True
        if entry in self.texts or any(text.endswith(": " + entry) for text in self.texts):
            return True
        patterns = sentence_patterns([entry])
        if any(takes(rest, patterns, {entry}) for sentence, _ in self.counting for rest in rests_of(sentence)):
            return True
        # The sentence of a message that is put together of several literals.
        pieces = [piece for piece in PLACEHOLDER.split(entry)[::2] if piece.strip(" .,:")]
        return bool(PLACEHOLDER.search(entry)) and all(any(piece.strip() in text for text in self.texts) for piece in pieces)

    def findings(self, catalogue):
        self.texts = set(self.all_literals)
        out = [f"no entry: {json.dumps(entry, ensure_ascii=False)}   ({place})"
               for entry, place in sorted(self.required.items()) if entry not in catalogue]
        for entry, translation in catalogue.items():
            shown = json.dumps(entry, ensure_ascii=False)
            if not self.used(entry):
                out.append(f"nothing uses: {shown}")
            if not translation.strip():
                out.append(f"empty: {shown}")
            if not re.match(r"^[EW]_", entry) and sorted(PLACEHOLDER.findall(entry)) != sorted(PLACEHOLDER.findall(translation)):
                out.append(f"other placeholders: {shown} and {translation}")
        patterns = sentence_patterns(catalogue)
        out += [f"no sentence for what is counted: {json.dumps(sentence, ensure_ascii=False)}   ({place})"
                for sentence, place in self.counting if not has_sentence(sentence, patterns, catalogue)]
        return out + self.bare


def load(path):
    def unique(pairs):
        keys = [key for key, _ in pairs]
        for key in keys:
            if keys.count(key) > 1:
                sys.exit(f"{path}: {key!r} stands there twice")
        return dict(pairs)

    return json.loads(read(path), object_pairs_hook=unique)


def save(path, catalogue):
    with open(path, "w", encoding="utf-8") as file:
        json.dump(dict(sorted(catalogue.items())), file, ensure_ascii=False, indent=2)
        file.write("\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    parser.add_argument("--missing", action="store_true")
    parser.add_argument("--merge", nargs="+", metavar=("FILE", "CODE"))
    arguments = parser.parse_args()
    folder = os.path.join(arguments.root, "assets", "languages")
    if arguments.merge:
        path = os.path.join(folder, (arguments.merge + ["ja"])[1] + ".json")
        save(path, {**load(path), **load(arguments.merge[0])})
        return 0
    check = Check(arguments.root)
    wrong = 0
    for path in sorted(glob.glob(os.path.join(folder, "*.json"))):
        catalogue = load(path)
        if arguments.missing:
            print(json.dumps({entry: "" for entry in sorted(check.required) if entry not in catalogue},
                             ensure_ascii=False, indent=2))
            continue
        found = check.findings(catalogue)
        if list(catalogue) != sorted(catalogue):
            found.append("the entries are not sorted; scripts/catalogue.py --merge sorts them")
        for finding in found:
            print(f"{os.path.basename(path)}: {finding}")
        wrong += len(found)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
