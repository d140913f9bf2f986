"""Catalogues of translations in the format of gettext: reading, strict as the program is, and writing."""

import re

QUOTED = re.compile(r'"((?:[^"\\]|\\.)*)"\s*$')
ESCAPES = {"n": "\n", "t": "\t", "r": "\r", '"': '"', "\\": "\\"}
WORDS = re.compile(r"(msgctxt|msgid_plural|msgid|msgstr(?:\[(\d)\])?)\s*(?=\")")
PLACEHOLDER = re.compile(r"\{(\d)\}")


class PoError(Exception):
    pass


class Entry:
    """A text with its translations, one for each plural form. `text` of a plural is that for one."""

    def __init__(self, text, plural="", translations=None, context=""):
        self.context, self.text, self.plural = context, text, plural
        self.translations = translations or [""]
        self.remarks = []     # remarks of translators, "# ..."
        self.notes = []       # for translators, "#. ..."
        self.places = []      # files that use it, "#: ..."
        self.fuzzy = False
        self.line = 0

    def key(self):
        """As the sources write it."""
        return self.context + "\4" + self.text if self.context else self.text

    def english(self):
        """Every text of the sources that it translates."""
        return {self.key(), self.plural} - {""}

    def translated(self):
        return not self.fuzzy and all(text.strip() for text in self.translations)

    def counted_place(self):
        """The placeholder that the count fills, as Language finds it."""
        found = [(match.start(), match.group(1)) for match in PLACEHOLDER.finditer(self.plural)]
        if not found:
            return None
        if self.text == self.plural:
            return found[0][1]
        pairs = zip(self.text, self.plural)
        same = next((i for i, (a, b) in enumerate(pairs) if a != b), min(len(self.text), len(self.plural)))
        before = [number for start, number in found if start < same]
        return (before or [found[0][1]])[-1]


class Catalogue:
    def __init__(self, header, entries):
        self.header, self.entries = header, entries  # name -> value, in the order of the file

    def forms(self):
        match = re.search(r"nplurals\s*=\s*([1-8])\s*;", self.header.get("Plural-Forms", ""))
        if not match:
            raise PoError("the header gives no number of plural forms (Plural-Forms)")
        return int(match.group(1))

    def sort(self):
        self.entries.sort(key=lambda entry: (entry.text, entry.context))

    def sorted(self):
        keys = [(entry.text, entry.context) for entry in self.entries]
        return keys == sorted(keys)


def unescaped(text, place):
    def one(match):
        if match.group(1) not in ESCAPES:
            raise PoError(f"{place}: a backslash may stand before n, t, r, \\ and \" only")
        return ESCAPES[match.group(1)]

    return re.sub(r"\\(.)", one, text)


def escaped(text):
    return text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n").replace("\t", "\\t").replace("\r", "\\r")


class Reader:
    def __init__(self, name):
        self.name, self.line = name, 0
        self.entries, self.header = [], None
        self.begin_entry()

    def begin_entry(self):
        self.entry, self.part = Entry(""), ""
        self.entry.translations = []

    def fail(self, what):
        raise PoError(f"{self.name}:{self.line}: {what}")

    def read(self, source):
        for self.line, line in enumerate(source.split("\n"), 1):
            self.take(line.strip())
        self.finish()
        if self.header is None:
            self.fail("the file does not begin with a header")
        keys = set()
        for entry in self.entries:
            self.line = entry.line
            if entry.key() in keys:
                self.fail("there is another entry with this text")
            keys.add(entry.key())
        return Catalogue(self.header, self.entries)

    def take(self, line):
        if not line:
            return
        if line.startswith("#"):
            self.comment(line)
        elif line.startswith('"'):
            if not self.part:
                self.fail("the text belongs to no entry")
            self.append(line)
        else:
            match = WORDS.match(line)
            if not match:
                self.fail("this is no line of a catalogue")
            self.begin(match.group(1), match.group(2))
            self.append(line[match.end():])

    def comment(self, line):
        if self.part == "msgstr":
            self.finish()
        if line.startswith("#~"):
            return
        kind, text = line[1:2], line[2:].strip()
        if kind == ".":
            self.entry.notes.append(text)
        elif kind == ":":
            self.entry.places += text.split()
        elif kind == ",":
            self.entry.fuzzy = "fuzzy" in text
        elif kind != "|":
            self.entry.remarks.append(line[1:].strip())

    def begin(self, word, number):
        if word in ("msgctxt", "msgid") and self.part == "msgstr":
            self.finish()
        after = {"msgctxt": [""], "msgid": ["", "msgctxt"], "msgid_plural": ["msgid"]}
        if word.startswith("msgstr"):
            plural = self.part == "msgid_plural" or self.entry.plural != ""
            allowed = self.part in (["msgid_plural", "msgstr"] if plural else ["msgid"])
            expected = str(len(self.entry.translations)) if plural else None
            if not allowed or number != expected:
                self.fail(f"{word} cannot stand here")
            self.entry.translations.append("")
            self.part = "msgstr"
            return
        if self.part not in after[word]:
            self.fail(f"{word} cannot stand here")
        if not self.part:
            self.entry.line = self.line
        self.part = word

    def append(self, quoted):
        match = QUOTED.match(quoted)
        if not match:
            self.fail("a text is not closed by a quotation mark")
        text = unescaped(match.group(1), f"{self.name}:{self.line}")
        if self.part == "msgctxt":
            self.entry.context += text
        elif self.part == "msgid":
            self.entry.text += text
        elif self.part == "msgid_plural":
            self.entry.plural += text
        else:
            self.entry.translations[-1] += text

    def finish(self):
        if not self.part:
            return
        if self.part != "msgstr":
            self.fail("the entry has no msgstr")
        entry = self.entry
        self.begin_entry()
        if entry.text:
            if self.header is None:
                self.fail("the file does not begin with a header")
            self.entries.append(entry)
            return
        if self.header is not None or entry.context:
            self.fail("an entry has an empty text")
        self.header = {}
        for line in entry.translations[0].split("\n"):
            name, colon, value = line.partition(":")
            if line and not colon:
                self.fail("a line of the header has no colon")
            if line:
                self.header[name.strip()] = value.strip()


def parse(source, name):
    return Reader(name).read(source)


def entry_text(entry):
    lines = ["# " + remark if remark else "#" for remark in entry.remarks]
    lines += ["#. " + note for note in entry.notes]
    lines += ["#: " + place for place in entry.places]
    if entry.fuzzy:
        lines.append("#, fuzzy")
    if entry.context:
        lines.append(f'msgctxt "{escaped(entry.context)}"')
    lines.append(f'msgid "{escaped(entry.text)}"')
    if entry.plural:
        lines.append(f'msgid_plural "{escaped(entry.plural)}"')
        lines += [f'msgstr[{i}] "{escaped(text)}"' for i, text in enumerate(entry.translations)]
    else:
        lines.append(f'msgstr "{escaped(entry.translations[0])}"')
    return "\n".join(lines) + "\n"


def text_of(catalogue):
    header = 'msgid ""\nmsgstr ""\n' + "".join(f'"{escaped(name)}: {escaped(value)}\\n"\n'
                                               for name, value in catalogue.header.items())
    return "\n".join([header] + [entry_text(entry) for entry in catalogue.entries])
