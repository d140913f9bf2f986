"""scripts/structure.py and scripts/architecture_figure.py count and draw what is there, in small trees.

  scripts_test.py SCRIPTS    the folder of both scripts"""

import os
import re
import subprocess
import sys
import tempfile

HEADER = """#pragma once
// All things; { not a block
#include "core/base/b.hpp"
namespace n {
enum class Kind : unsigned char { one, two };
template <class T>
struct Fine final : Base<T> {
  Fine() : first_{1}, second_(2) { f(); }
  std::vector<int> values{1, 2};  ///< each
};
auto f(const Fine<int>& x, std::vector<int> z = {1, 2}) -> std::vector<int>;
void g(double);
}  // namespace n
"""
BODY = """#include "core/a/a.hpp"
namespace n {
auto f(const Fine<int>& x, std::vector<int> z) -> std::vector<int> {
  for (int i = 0; i < 3; ++i) z.push_back(i);
  if (auto l = [&](int k) { return k; }; l(1)) return {1};
  switch (z[0]) {
    case 1: { return std::vector<int>{1}; }
    default: break;
  }
  const char* text = R"(; { ; )";
  return use('{', text);
}
int find(int i) {
  while (parent_[i] != i) i = parent_[i];
  return dynamic_cast<int>(i);
}
}
"""
TREE = {
    "core/a/a.hpp": HEADER,
    "core/a/a.cpp": BODY,
    "core/base/b.hpp": "namespace n {\nstruct Fine {};\nvoid g(int);\nclass Forward;\n}\n",
    "core/c/c.cpp": '#include "core/a/a.hpp"\n#include "core/base/b.hpp"\nclass Hull { int x; };\nclass Forward;\n',
    "render/r.cpp": '#include "core/c/c.hpp"\n',
    "app/main.cpp": '#include "render/r.hpp"\n#include "core/a/a.hpp"\nvoid long_one() {\n' + "\n" * 60 + "}\n",
    "tests/t.cpp": "TEST(A, B) { f(); }\n",
    "docs/architecture.md": "".join(f"| `{name}/` | x |\n" for name in ("core", "render", "app", "a", "base", "c")),
    "docs/pictures/readme": "",
}


def write(root, tree):
    for path, text in tree.items():
        os.makedirs(os.path.dirname(os.path.join(root, path)), exist_ok=True)
        with open(os.path.join(root, path), "w", encoding="utf-8") as file:
            file.write(text)


def run(scripts, name, root, *options):
    command = [sys.executable, os.path.join(scripts, name), "--root", root, *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


def row(table, name):
    return re.search(rf"^{re.escape(name)} +(.+)$", table, re.M)[1].split()


def check_structure(scripts, root):
    code, table, errors = run(scripts, "structure.py", root, "--list")
    assert code == 0 and not errors, errors
    assert row(table, "files") == ["4", "1", "0", "1", "1"], table
    # Blocks and semicolons: a.hpp 4 and 6, a.cpp 6 and 9, b.hpp 2 and 3, c.cpp 1 and 3.
    assert row(table, "statements") == ["34", "0", "0", "1", "2"], table
    assert row(table, "functions above 60 lines") == ["0", "0", "0", "1", "0"], table
    assert row(table, "longest folder") == ["core/a", "render", "app", "tests"], table
    assert row(table, "convex hulls") == ["1"] and row(table, "union-finds") == ["1"], table
    assert row(table, "dynamic_casts") == ["1"] and row(table, "names declared in two headers") == ["1"], table
    assert "n::Fine (type)  core/a/a.hpp, core/base/b.hpp" in table, table
    assert "n::g (function)  core/a/a.hpp, core/base/b.hpp" in table and "n::Forward" not in table, table


def check_comments(scripts, root):
    """Lines that go on, strings and numbers are no beginnings of comments."""
    assert run(scripts, "structure.py", root, "--comments") == (0, "", "")
    write(root, {"bench/b.cpp": """// Sums
// of all, officially.
int a = 1'000;  ///< count
                ///< of all
/// When a is known.
double b = 'x';  // which is b
// Where they meet.
const char *c = "// what", *d = "\\"// how";
const char* e = R"x(
// Of text
")x";
f();  // wherever
""", "shaders/s.glsl": "//Whose s is it?\nuniform float s;\n"})
    code, found, errors = run(scripts, "structure.py", root, "--comments")
    assert code == 1 and not errors, errors
    assert found == """bench/b.cpp:5: /// When a is known.
bench/b.cpp:6: // which is b
bench/b.cpp:7: // Where they meet.
shaders/s.glsl:1: //Whose s is it?
""", found


def check_figure(scripts, root):
    script = "architecture_figure.py"
    code, arrows, _ = run(scripts, script, root, "--arrows")
    assert code == 0 and arrows == "app -> render\nrender -> core\na -> base\nc -> a\n", arrows
    assert run(scripts, script, root, "--check")[0] == 1, "there is no picture yet"
    assert run(scripts, script, root)[0] == 0
    code, faults, _ = run(scripts, script, root, "--check")
    assert code == 0, faults
    write(root, {"core/d/d.cpp": '#include "core/c/c.hpp"\n'})
    code, faults, _ = run(scripts, script, root, "--check")
    assert code == 1 and "is not what the sources give" in faults and "the folder d" in faults, faults
    write(root, {"core/base/b.cpp": '#include "core/d/d.hpp"\n'})
    code, _, errors = run(scripts, script, root)
    assert code == 1 and "a, base, c, d" in errors, errors


def main():
    with tempfile.TemporaryDirectory() as root:
        write(root, TREE)
        check_structure(sys.argv[1], root)
        check_figure(sys.argv[1], root)
    with tempfile.TemporaryDirectory() as root:
        check_comments(sys.argv[1], root)


if __name__ == "__main__":
    main()
