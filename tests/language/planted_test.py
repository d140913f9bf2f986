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
                    "char c = '\"'; commit(document, fill(translatable(\"Move {0} things\"), {n}));\n",
}
CATALOGUE = {
    "E_BAD": "悪い", "E_BAD.remedy": "直す", "File": "ファイル", "Heading of it": "見出し", "Help text.": "ヘルプ。",
    "Move {0} things": "{0}個移動", "One of two": "一", "Open…": "開く…", "Other of two": "二", "Shown": "表示",
    "W_ODD": "変",
}


def findings(script, sources, catalogue):
    with tempfile.TemporaryDirectory() as root:
        for path, text in {**sources, "assets/languages/ja.json": json.dumps(catalogue)}.items():
            os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
            with open(os.path.join(root, path), "w", encoding="utf-8") as file:
                file.write(text)
        done = subprocess.run([sys.executable, script, "--root", root], capture_output=True, text=True, check=False)
        assert not done.stderr, done.stderr
        assert (done.returncode == 0) == (not done.stdout), (done.returncode, done.stdout)
        return done.stdout


def expect(script, what, sources=None, catalogue=None):
    found = findings(script, {**SOURCES, **(sources or {})}, catalogue if catalogue is not None else CATALOGUE)
    assert (what in found) if what else not found, f"expected {what!r}, got:\n{found}"


def main():
    script = sys.argv[1]
    expect(script, "")
    for entry in CATALOGUE:
        expect(script, f"no entry: {json.dumps(entry, ensure_ascii=False)}",
               catalogue={k: v for k, v in CATALOGUE.items() if k != entry})
    panel = SOURCES["ui/panel.cpp"]
    expect(script, 'no entry: "Nobody translated me"', {"ui/panel.cpp": panel + 'x = "Nobody translated me";\n'})
    expect(script, 'no entry: "mixed"', {"ui/panel.cpp": panel + 'x = context.tr("mixed");\n'})
    expect(script, "is shown in English always", {"ui/panel.cpp": panel + 'ImGui::Checkbox("Shown", &x);\n'})
    expect(script, "is shown in English always", {"ui/panel.cpp": panel + 'ImGui::Text("off %d", 3);\n'})
    expect(script, 'no entry: "E_NEW"', {"core/more.hpp": 'inline constexpr Code e_new{\n    "E_NEW"};\n'})
    expect(script, 'nothing uses: "Gone"', catalogue=dict(sorted({**CATALOGUE, "Gone": "無い"}.items())))
    expect(script, "other placeholders", catalogue={**CATALOGUE, "Move {0} things": "移動"})
    expect(script, "empty", catalogue={**CATALOGUE, "Shown": " "})
    counted = 'return make_warning(w_odd, std::to_string(n) + (n == 1 ? " thing is odd." : " things are odd."));\n'
    expect(script, "no sentence for what is counted: \"7 thing is odd.\"", {"core/more.cpp": counted})
    sentences = {"{0} thing is odd.": "{0}個変", "{0} things are odd.": "{0}個変"}
    expect(script, "no sentence for what is counted: \"7 thing is odd.\"", {"core/more.cpp": counted},
           dict(sorted({**CATALOGUE, "{0} things are odd.": "{0}個変"}.items())))
    expect(script, "", {"core/more.cpp": counted}, dict(sorted({**CATALOGUE, **sentences}.items())))
    expect(script, "not sorted", catalogue=dict(reversed(list(CATALOGUE.items()))))
    print("passed")


if __name__ == "__main__":
    main()
