"""scripts/catalogue.py finds what it is there to find: a small tree with one mistake of each kind."""

import json
import os
import subprocess
import sys
import tempfile

SOURCES = {
    "core/codes.hpp": 'inline constexpr Code e_bad{"E_BAD"};\ninline constexpr Code w_odd{"W_ODD"};\n',
    "core/codes.cpp": 'return make_error(e_bad, "It is bad.", "Make it good.");\n'
                      'return make_warning(w_odd, "It is odd.", {}, Element{Element::Kind::line, 1});\n'
                      'HARIKO_ASSERT(x, "A programmer sees this only");\n',
    "ui/panel.cpp": '#include "Some Header.hpp"\n'
                    '// A comment with "Words in it".\n'
                    'ImGui::TextUnformatted(tr("Shown"));\n'
                    'ImGui::TextUnformatted(tr(on ? "One of two"\n   : "Other "\n   "of two"));\n'
                    'marks.item("panel.mark"); ImGui::Button("##id"); heading(context, "Heading of it");\n'
                    'table.add({.id = "file.open", .menu = "File", .label = "Open\\u2026", .help = "Help text.",\n'
                    '           .keys = "Ctrl+Shift+O / F3"});\n'
                    "char c = '\"'; commit(document, fill(translatable(\"Move {0} things\"), {n}));\n"
                    'text = tr.counted(n, "1 thing", "{0} things") + tr("shape\\4Plane");\n',
}
CATALOGUE = {
    "E_BAD": "悪い", "E_BAD.remedy": "直す", "File": "ファイル", "Heading of it": "見出し", "Help text.": "ヘルプ。",
    "Move {0} things": "{0}個移動", "One of two": "一", "Open…": "開く…", "Other of two": "二", "Shown": "表示",
    "W_ODD": "変", "1 thing|{0} things": "{0}個", "shape\4Plane": "平面",
}
HEADER = """msgid ""
msgstr ""
"Language: ja\\n"
"Content-Type: text/plain; charset=UTF-8\\n"
"Plural-Forms: nplurals=1; plural=0;\\n"
"X-English-Name: Japanese\\n"
"X-Native-Name: 日本語\\n"
"""


def quoted(text):
    return json.dumps(text, ensure_ascii=False)


def po_text(catalogue):
    """Entries in their order; "one|several" has a plural, "context\\4text" a context."""
    out = HEADER
    for entry, translation in catalogue.items():
        context, _, text = entry.rpartition("\4")
        one, _, several = text.partition("|")
        out += f"\nmsgctxt {quoted(context)}\n" if context else "\n"
        out += f"msgid {quoted(one)}\n"
        out += f"msgid_plural {quoted(several)}\nmsgstr[0]" if several else "msgstr"
        out += f" {quoted(translation)}\n"
    return out


def in_order(catalogue):
    def key(entry):
        context, _, text = entry.rpartition("\4")
        return text.partition("|")[0], context

    return {entry: catalogue[entry] for entry in sorted(catalogue, key=key)}


def findings(script, sources, catalogues):
    with tempfile.TemporaryDirectory() as root:
        for path, text in {**sources, **catalogues}.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                file.write(text)
        done = subprocess.run([sys.executable, script, "--root", root], capture_output=True, text=True, check=False)
        assert not done.stderr, done.stderr
        assert (done.returncode == 0) == (not done.stdout), (done.returncode, done.stdout)
        return done.stdout


def expect(script, what, sources=None, catalogue=None, po=None):
    """`catalogue` in any order, or the text of a catalogue."""
    text = po or po_text(in_order(CATALOGUE if catalogue is None else catalogue))
    found = findings(script, {**SOURCES, **(sources or {})}, {"assets/languages/ja.po": text})
    assert (what in found) if what else not found, f"expected {what!r}, got:\n{found}"


def catalogues_are_read_strictly(script):
    whole = po_text(in_order(CATALOGUE))
    for wrong, what in (
            (whole.replace('msgid "File"', 'msgid "File'), "a text is not closed by a quotation mark"),
            (whole.replace('msgid "File"', 'msgid "F\\ile"'), "a backslash may stand before"),
            (whole.replace('msgid "File"', 'message "File"'), "this is no line of a catalogue"),
            (whole.replace('msgid "File"\n', ''), "cannot stand here"),
            (whole + '\nmsgid "File"\nmsgstr "x"\n', "there is another entry with this text"),
            (whole + '\nmsgid "Z"\n', "the entry has no msgstr"),
            (whole[len(HEADER):], "the file does not begin with a header")):
        expect(script, what, po=wrong)
        expect(script, "ja.po:", po=wrong)
    for field in ("Language", "X-English-Name", "X-Native-Name"):
        expect(script, f"the header has no {field}", po=whole.replace(field, "X-Other"))
    expect(script, "not say that the file is UTF-8", po=whole.replace("UTF-8", "EUC-JP"))
    expect(script, "no number of plural forms", po=whole.replace("nplurals", "plurals"))


def plurals_are_whole(script):
    without = {k: v for k, v in CATALOGUE.items() if "|" not in k}
    apart = {**without, "1 thing": "{0}個", "{0} things": "{0}個"}
    expect(script, 'no plural: "1 thing" and "{0} things"', catalogue=apart)
    whole = po_text(in_order(CATALOGUE))
    two = whole.replace("nplurals=1; plural=0", "nplurals=2; plural=(n != 1)")
    expect(script, 'not 2 forms: "1 thing"', po=two)
    expect(script, "", po=two.replace('msgstr[0] "{0}個"', 'msgstr[0] "ひとつ"\nmsgstr[1] "{0}個"'))
    expect(script, "other placeholders", po=whole.replace('msgstr[0] "{0}個"', 'msgstr[0] "{1}個"'))


def other_languages_may_lack_texts(script):
    complete = {"assets/languages/ja.po": po_text(in_order(CATALOGUE))}
    other = HEADER.replace("Language: ja", "Language: pl") + '\nmsgid "File"\nmsgstr "Plik"\n'
    with tempfile.TemporaryDirectory() as root:
        for path, text in {**SOURCES, **complete, "assets/languages/pl.po": other}.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                file.write(text)

        def run(*arguments):
            done = subprocess.run([sys.executable, script, "--root", root, *arguments], capture_output=True, text=True,
                                  check=False)
            assert done.returncode == 0 and not done.stderr, (done.stdout, done.stderr)
            return done.stdout

        def content(name):
            with open(os.path.join(root, "assets/languages", name), encoding="utf-8") as file:
                return file.read()

        assert "texts are shown in English" in run()
        run("--update")
        assert 'msgid "Shown"\nmsgstr ""' in content("pl.po") and 'msgstr "Plik"' in content("pl.po")
        assert "#: ui/panel.cpp" in content("ja.po") and "#. It is bad." in content("ja.po")
        run("--new", "fr", "French", "Français")
        assert 'msgid_plural "{0} things"\nmsgstr[0] ""\nmsgstr[1] ""' in content("fr.po")
        addition = os.path.join(root, "more.po")
        with open(addition, "w", encoding="utf-8") as file:
            file.write('msgid "File"\nmsgstr "Fichier"\n')
        run("--merge", addition, "fr")
        assert 'msgid "File"\nmsgstr "Fichier"' in content("fr.po")
        assert content("fr.po").count('msgid "File"') == 1
        run()


def main():
    script = sys.argv[1]
    expect(script, "")
    for entry in CATALOGUE:
        expect(script, "no entry: " + quoted(entry.partition("|")[0]),
               catalogue={k: v for k, v in CATALOGUE.items() if k != entry})
    panel = SOURCES["ui/panel.cpp"]
    expect(script, 'no entry: "Nobody translated me"', {"ui/panel.cpp": panel + 'x = "Nobody translated me";\n'})
    expect(script, 'no entry: "mixed"', {"ui/panel.cpp": panel + 'x = context.tr("mixed");\n'})
    expect(script, "is shown in English always", {"ui/panel.cpp": panel + 'ImGui::Checkbox("Shown", &x);\n'})
    expect(script, "is shown in English always", {"ui/panel.cpp": panel + 'ImGui::Text("off %d", 3);\n'})
    expect(script, "is shown in English always", {"ui/panel.cpp": panel + 'dim_text("Shown");\n'})
    expect(script, 'no entry: "E_NEW"', {"core/more.hpp": 'inline constexpr Code e_new{\n    "E_NEW"};\n'})
    expect(script, 'nothing uses: "Gone"', catalogue={**CATALOGUE, "Gone": "無い"})
    expect(script, "other placeholders", catalogue={**CATALOGUE, "Move {0} things": "移動"})
    expect(script, "empty", catalogue={**CATALOGUE, "Shown": " "})
    counted = 'return make_warning(w_odd, std::to_string(n) + (n == 1 ? " thing is odd." : " things are odd."));\n'
    expect(script, "no sentence for what is counted: \"7 thing is odd.\"", {"core/more.cpp": counted})
    expect(script, "no sentence for what is counted: \"7 thing is odd.\"", {"core/more.cpp": counted},
           {**CATALOGUE, "{0} things are odd.": "{0}個変"})
    expect(script, "", {"core/more.cpp": counted}, {**CATALOGUE, "{0} thing is odd.|{0} things are odd.": "{0}個変"})
    expect(script, "not sorted", po=po_text(dict(reversed(list(in_order(CATALOGUE).items())))))
    catalogues_are_read_strictly(script)
    plurals_are_whole(script)
    other_languages_may_lack_texts(script)
    print("passed")


if __name__ == "__main__":
    main()
