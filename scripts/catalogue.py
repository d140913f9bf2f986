#!/usr/bin/env python3
"""Checks the catalogues of translations (assets/languages/*.po) against the sources.

  scripts/catalogue.py [--root FOLDER]           says what is missing, unused or wrong; exit code 1 when anything is
  scripts/catalogue.py --missing [CODE]          prints the missing entries, to be filled in (ja)
  scripts/catalogue.py --merge FILE [CODE]       takes the entries of FILE into the catalogue and sorts it (ja)
  scripts/catalogue.py --update                  sorts all catalogues, takes out what nothing uses, writes anew where texts
                                                 are used, and adds what is missing, empty, to those of other languages
  scripts/catalogue.py --new CODE ENGLISH NATIVE [PLURAL-FORMS]
                                                 begins another language: --new pl Polish Polski "nplurals=3; plural=..."

What must have an entry: every string given to tr(), language() or translatable(), and both texts of counted(); whatever
else looks like English in ui/ and app/ (labels, help and reasons of commands, labels of steps, hints); the code of every
message, and its remedy where one is given; a sentence for every message that says a number, so that translations say it
too. A literal that looks like English and is none for the eyes of users is put on ALLOWED. "meaning\\4Text" is an entry
with msgctxt."""

import argparse
import glob
import json
import os
import re
import sys

sys.dont_write_bytecode = True
import po_file  # noqa: E402
from cpp_literals import TOKEN, literals_of  # noqa: E402
from po_file import Entry, PoError  # noqa: E402

# Languages that have everything; of the others it is told how much is missing.
COMPLETE = {"ja"}
# Fields that a header must have.
HEADER = ("Language", "Content-Type", "Plural-Forms", "X-English-Name", "X-Native-Name")
# Words that are the same in every language, or that no user sees.
ALLOWED = {
    "Hariko", "Blender", "Maya", "Rhino", "English", "DISPLAY", "UTF-8",
    "Ctrl + ", "Shift + ", "Alt + ", "Viewport", "object:", "view:", "OpenGL ",
    # Fields of the headers of catalogues.
    "Content-Type", "Plural-Forms",
    # Families of fonts.
    "Inter", "FontAwesome", "Noto Sans CJK JP",
    # Names, and what a report of a mistake needs.
    "Dear ImGui (MIT), GLFW (zlib), GLM (MIT), libepoxy (MIT), FreeType (FTL), fontconfig (MIT), Eigen (MPL 2.0), oneTBB (Apache 2.0), "
    "JSON for Modern C++ (MIT), CLI11 (BSD), libpng (libpng), libjpeg-turbo (IJG). Inter, Font Awesome and Noto Sans CJK (SIL OFL).",
    "Hariko ", "\nGLFW ", "\nDear ImGui ", "\nlog.txt:\n", ", scale ",
     # Texts of the test log.
    "OpenGL", "k1  k2", "view menu ",
    # Texts of replays, on stderr.
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
MARKING = {"tr", "language", "language_", "translatable", "phrase", "Phrase"}
IMGUI_TEXT = re.compile(
    r"^(Text|TextUnformatted|TextDisabled|TextColored|TextWrapped|BulletText|LabelText|Button|SmallButton|Checkbox|"
    r"RadioButton|MenuItem|BeginMenu|Selectable|SetTooltip|BeginCombo|Combo|CollapsingHeader|TreeNode|TreeNodeEx|"
    r"BeginTabItem|Slider\w+|Drag\w+|Input\w+|ColorEdit\d|ColorPicker\d|SeparatorText|AddText|BeginPopupModal)$")
# Functions of ui/widgets that take nothing but a text, translated already.
OWN_TEXT = {"plain_text", "dim_text", "aligned_text", "text_in_lines", "pointer_tip"}
KEYS = re.compile(r"^((Ctrl|Shift|Alt)\+)*([A-Z0-9,.;'\[\]\\/=`+-]|F\d+|Num( [0-9+\-*/.]| \w+)?|Home|End|Esc|Del|Ins|Enter|"
                  r"Space|Tab|Backspace|Menu|"
                  r"PgUp|PgDn|Ctrl|Shift|Alt|Ctrl\+|Shift\+|Alt\+)$")
PLACEHOLDER = po_file.PLACEHOLDER
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


class CodeUse:
    """A code of messages: where it is declared, its sentence and remedy where they are whole literals, and whether a
    remedy is ever given with it."""

    def __init__(self, path):
        self.path, self.sentence, self.remedy, self.has_remedy = path, "", "", False


def whole_literal(expression):
    if not re.fullmatch(r'(translatable\()?\s*".*"\s*\)?', expression, re.S):
        return ""
    found = literals_of("", expression)
    return found[0].text if len(found) == 1 and not found[0].added else ""


def codes_of(root):
    """Name of the code -> its use."""
    constants, uses = {}, {}
    sources = {path: read(path) for path in source_files(root, "core", "render", "ui", "app")}
    for path, source in sources.items():
        for match in re.finditer(r'constexpr\s+Code\s+(\w+)\s*\{\s*"([EW]_\w+)"', source):
            constants[match.group(1)] = match.group(2)
            uses.setdefault(match.group(2), CodeUse(os.path.relpath(path, root)))
    for source in sources.values():
        for match in re.finditer(r"\bmake_(?:error|warning)\(\s*(\w+)", source):
            if match.group(1) not in constants:
                continue
            use = uses[constants[match.group(1)]]
            given = arguments_at(source, match.end() - len(match.group(1)))
            if len(given) > 1:
                use.sentence = use.sentence or whole_literal(given[1])
            if len(given) > 2 and not re.match(r'\{|Element\b|""$', given[2]):
                use.has_remedy = True
                use.remedy = use.remedy or whole_literal(given[2])
    return uses


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
    """Sentences that an expression may put together, with 7 for what is no literal."""
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
    """Messages that say numbers or names: what they may be, and where."""
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
        self.places = {}    # entry -> files that use it
        self.plurals = {}   # text for one -> text for several, and where
        self.bare = []
        self.all_literals = []
        self.files_of = {}  # any literal -> files
        self.counting = list(counting_sentences(root))
        for path in source_files(root, "core", "render", "ui", "app"):
            relative = os.path.relpath(path, root)
            literals = literals_of(relative, read(path))
            self.look_at_all(literals, relative)
        self.codes = codes_of(root)
        for name, use in self.codes.items():
            self.need(name, use.path, use.path)
            if use.has_remedy:
                self.need(name + ".remedy", use.path, use.path)
        self.texts = set(self.all_literals)

    def look_at_all(self, literals, path):
        for literal in literals:
            self.all_literals.append(literal.text)
            self.files_of.setdefault(literal.text, [path])
            self.look_at(literal, path)
        self.look_at_counts(literals, path)

    def need(self, text, place, path):
        self.required.setdefault(text, place)
        files = self.places.setdefault(text, [])
        if path not in files:
            files.append(path)

    def look_at(self, literal, path):
        counts = path.startswith(("ui/", "app/")) and literal.of_method("counted")
        marked = literal.inside(MARKING) or counts
        identifier = re.match(r"^[a-z0-9_]+(\.[a-z0-9_]+)+$", literal.text)
        if marked and not identifier and not literal.inside({"item"}) and has_words(literal.text) and \
                literal.text not in ALLOWED:
            self.need(literal.text, literal.place(), path)
        shown = path.startswith(("ui/", "app/")) and not path.startswith("app/commands/") and path not in UNSEEN
        if not shown or marked or literal.inside(SILENT) or "item" in literal.calls[-1:]:
            return
        if looks_english(literal.text):
            self.need(literal.text, literal.place(), path)
        call = literal.calls[-1] if literal.calls else ""
        if path.startswith("ui/") and (call in OWN_TEXT or call.startswith("ImGui::") and IMGUI_TEXT.match(call[7:])):
            if has_words(literal.text) and not literal.text.startswith("#") and literal.text not in ALLOWED:
                self.bare.append(f'{literal.place()}: {call}("{literal.text}") is shown in English always')

    def look_at_counts(self, literals, path):
        """The two texts of Language::counted, which follow each other."""
        if not path.startswith(("ui/", "app/")):
            return
        texts = [literal for literal in literals if literal.of_method("counted") and has_words(literal.text)]
        for one, several in zip(texts[::2], texts[1::2]):
            self.plurals.setdefault(one.text, (several.text, one.place()))

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

    def missing(self, catalogue):
        known = {text for entry in catalogue.entries for text in entry.english()}
        return [text for text in sorted(self.required) if text not in known and not self.is_plural(text)] + \
            [one for one, (several, _) in sorted(self.plurals.items()) if one in known and several not in known]

    def is_plural(self, text):
        return any(several == text for several, _ in self.plurals.values())

    def empty_entry(self, text, forms):
        context, _, rest = text.rpartition("\4")
        plural = self.plurals.get(text, ("", ""))[0]
        entry = Entry(rest, plural, [""] * (forms if plural else 1), context)
        self.describe(entry)
        return entry

    def describe(self, entry):
        """Writes anew where an entry is used, and what a code stands for."""
        entry.places = sorted({path for text in entry.english() for path in self.places_of(text)})[:3]
        use = self.codes.get(entry.text.removesuffix(".remedy"))
        entry.notes = []
        if use:
            text = use.remedy if entry.text.endswith(".remedy") else use.sentence
            entry.notes = [text.replace("\n", " ")] if text else []

    def places_of(self, text):
        """Files that use a text: marked, as a message, or as one that is put together."""
        known = self.places.get(text) or self.files_of.get(text)
        if known:
            return known
        patterns = sentence_patterns([text])
        return [place.rpartition(":")[0] for sentence, place in self.counting
                if any(takes(rest, patterns, {text}) for rest in rests_of(sentence))]

    def findings(self, catalogue, complete):
        out = [f"the header has no {name}" for name in HEADER if not catalogue.header.get(name)]
        if "charset=UTF-8" not in catalogue.header.get("Content-Type", ""):
            out.append("the header does not say that the file is UTF-8")
        if complete:
            out += [f"no entry: {shown(text)}   ({self.required.get(text, 'counted')})" for text in self.missing(catalogue)]
        forms = catalogue.forms()
        for entry in catalogue.entries:
            out += self.findings_of(entry, forms, complete)
        english = {text for entry in catalogue.entries for text in entry.english()}
        patterns = sentence_patterns(english)
        if complete:
            out += [f"no sentence for what is counted: {shown(sentence)}   ({place})"
                    for sentence, place in self.counting if not has_sentence(sentence, patterns, english)]
        if not catalogue.sorted():
            out.append("the entries are not sorted; scripts/catalogue.py --update sorts them")
        return out + self.bare

    def findings_of(self, entry, forms, complete):
        out = [f"nothing uses: {shown(text)}" for text in sorted(entry.english()) if not self.used(text)]
        if complete and not entry.translated():
            out.append(f"empty: {shown(entry.key())}")
        several, place = self.plurals.get(entry.key(), (entry.plural, ""))
        if several != entry.plural:
            out.append(f"no plural: {shown(entry.key())} and {shown(several)}   ({place})")
        if len(entry.translations) != (forms if entry.plural else 1):
            out.append(f"not {forms} forms: {shown(entry.key())}")
        if entry.plural and not entry.counted_place():
            out.append(f"a plural without a place for the count: {shown(entry.plural)}")
        if re.match(r"^[EW]_", entry.text) or not entry.translated():
            return out
        places = sorted(PLACEHOLDER.findall(entry.plural or entry.text))
        for text in entry.translations:
            found = sorted(PLACEHOLDER.findall(text))
            # A form for one need not say the number.
            if found != places and not (entry.plural and sorted(found + [entry.counted_place()]) == places):
                out.append(f"other placeholders: {shown(entry.key())} and {shown(text)}")
        return out


def shown(text):
    return json.dumps(text, ensure_ascii=False)


def load(path):
    return po_file.parse(read(path), os.path.basename(path))


def save(path, catalogue):
    catalogue.sort()
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(po_file.text_of(catalogue))


def merge(path, addition):
    """Takes in the entries of a file, which needs no header."""
    source = read(addition)
    if not re.search(r'^msgid ""\s*\nmsgstr ""\s*\n"Language', source, re.M):
        source = 'msgid ""\nmsgstr ""\n"Language: \\n"\n\n' + source
    catalogue, added = load(path), po_file.parse(source, os.path.basename(addition)).entries
    given = {entry.key() for entry in added}
    catalogue.entries = [entry for entry in catalogue.entries if entry.key() not in given] + added
    save(path, catalogue)


def update(check, path):
    catalogue = load(path)
    catalogue.entries = [entry for entry in catalogue.entries if any(check.used(text) for text in entry.english())]
    if code_of(path) not in COMPLETE:
        catalogue.entries += [check.empty_entry(text, catalogue.forms()) for text in check.missing(catalogue)]
    for entry in catalogue.entries:
        check.describe(entry)
    save(path, catalogue)


def begin_language(check, folder, code, english_name, native_name, plural_forms):
    """A catalogue with everything that is translated into Japanese, empty."""
    path = os.path.join(folder, code + ".po")
    if os.path.exists(path):
        sys.exit(f"{path} exists already")
    header = {"Project-Id-Version": "Hariko", "Language": code, "MIME-Version": "1.0",
              "Content-Type": "text/plain; charset=UTF-8", "Content-Transfer-Encoding": "8bit",
              "Plural-Forms": plural_forms, "X-English-Name": english_name, "X-Native-Name": native_name}
    catalogue = po_file.Catalogue(header, [])
    for known in load(os.path.join(folder, "ja.po")).entries:
        entry = Entry(known.text, known.plural, [""] * (catalogue.forms() if known.plural else 1), known.context)
        check.describe(entry)
        catalogue.entries.append(entry)
    save(path, catalogue)
    print(f"Fill in the translations of {path}; the program offers the language when it starts.")


def code_of(path):
    return os.path.basename(path).removesuffix(".po")


def findings_of_all(check, paths):
    wrong = 0
    for path in paths:
        name = os.path.basename(path)
        try:
            catalogue = load(path)
            complete = code_of(path) in COMPLETE
            found = check.findings(catalogue, complete)
        except PoError as error:
            print(error)
            wrong += 1
            continue
        for finding in found:
            print(f"{name}: {finding}")
        wrong += len(found)
        missing = len(check.missing(catalogue)) + sum(not entry.translated() for entry in catalogue.entries)
        if not complete and missing:
            print(f"{name}: {missing} texts are shown in English, as they have no translation (this is no mistake)")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", default=os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    parser.add_argument("--missing", nargs="?", const="ja", metavar="CODE")
    parser.add_argument("--merge", nargs="+", metavar=("FILE", "CODE"))
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--new", nargs="+", metavar=("CODE", "NAME"))
    arguments = parser.parse_args()
    folder = os.path.join(arguments.root, "assets", "languages")
    if arguments.merge:
        merge(os.path.join(folder, (arguments.merge + ["ja"])[1] + ".po"), arguments.merge[0])
        return 0
    check = Check(arguments.root)
    paths = sorted(glob.glob(os.path.join(folder, "*.po")))
    if arguments.missing:
        catalogue = load(os.path.join(folder, arguments.missing + ".po"))
        for text in check.missing(catalogue):
            print(po_file.entry_text(check.empty_entry(text, catalogue.forms())))
        return 0
    if arguments.update:
        for path in paths:
            update(check, path)
        return 0
    if arguments.new:
        if len(arguments.new) not in (3, 4):
            parser.error("--new takes CODE ENGLISH NATIVE [PLURAL-FORMS]")
        begin_language(check, folder, *(arguments.new + ["nplurals=2; plural=(n != 1);"])[:4])
        return 0
    return 1 if findings_of_all(check, paths) else 0


if __name__ == "__main__":
    sys.exit(main())
