#!/usr/bin/env python3
"""Counts what the code is made of: sizes of files and functions, and how often core has one idea.

  scripts/structure.py                       the table of the working tree
  scripts/structure.py --before REV          beside it the same of a revision of git
  scripts/structure.py --list                also the names of long functions and long files
  scripts/structure.py --comments            instead, comments that begin with Of, What, Where, How and the like, not
                                             with what they are about; fails when there are some

Sources are *.cpp and *.hpp. Only the top folders are named here, not what they are divided into.

lines           as they are, comments and empty lines too
statements      semicolons outside of parentheses, and blocks in braces: bodies of functions, lambdas, classes,
                enumerations, namespaces, loops and branches. Braces round values are no blocks. Comments, strings
                and preprocessor lines do not count, so layout changes nothing
long functions  from the first line of the declaration to the closing brace, tests too
longest folder  by the number of sources directly in it

A class is a mesh type when its name follows MESH_NAMES and a container of faces, triangles or half edges is among its
own members (FACE_MEMBERS). Meshes, hulls and trees that hold another one as a member stand on it and are no further
implementation. Union-finds and conjugate gradients are found by the lines that define them (UNION_FIND,
CONJUGATE_GRADIENTS), so also where they are written by hand.

A question of kind asks an object for its source: object.skin() or another of KINDS whose answer is tested or kept
(not read at once, by -> or *), &Object::skin, or get_if and holds_alternative of a kind of source. It counts in app
and in the folders of ui that are no workspace (GENERIC_FOLDERS), where ObjectKind, a visitor of all sources or the
workspace should answer; files of one kind there (KIND_FILES) are left out.

A name is declared twice when two headers of core declare it in the same namespace, outside of classes: types
(definitions and aliases), constants, and functions with equal types of parameters. Functions whose overloads are
spread over headers have a row of their own."""

import argparse
import collections
import io
import os
import re
import signal
import subprocess
import sys
import tarfile
import tempfile

sys.dont_write_bytecode = True
from cpp_source import HELD, Source, odd_comments  # noqa: E402

LAYERS = ["core", "render", "ui", "app", "tests"]
ENDINGS = (".cpp", ".hpp")
COMMENTED = LAYERS + ["bench", "shaders"]
SHORT_FILE, LONG_FILE, LONG_FUNCTION = 50, 500, 60

# Classes that hold a mesh of their own.
MESH_NAMES = re.compile(r"\w*(Mesh|Polyhedron|Polytope|Cage|Loops|Graph|Complex)|Mesh(Draft|Editor|Surgery)")
FACE_MEMBERS = re.compile(
    r"(\w+_)?(faces|facets|triangles|quads|polygons|half_edges|face_vertices|corners|twins?|sides)_?")
CONTAINERS = {"vector", "array", "map", "unordered_map", "set", "span", "FlatMap", "ChunkedArray", "shared_ptr"}
HULL_NAMES = re.compile(r"\w*Hull")
# Octrees and trees of words are none.
TREE_NAMES = re.compile(r"(Box|Point|Sample|Segment|Triangle|Winding|Bounding\w*)Tree|\w*(Bvh|BVH)")
# To the root of a set: while (parent[i] != i) ...
UNION_FIND = re.compile(r"while\s*\([^;{}]*\bparent\w*[^;{}]*!=")
# A step, n / dot(...), and later in it the next direction's share of the last one, m / n; also as ratio(n, dot(...)).
CONJUGATE_GRADIENTS = re.compile(
    r"(?:\bratio \( (?P<a>\w+) ,|\b(?P<b>\w+) /) (?:\w+ \. )?dot \( [^{}]{0,600}?\w+ (?:/|,) (?:(?P=a)|(?P=b))\b")

# The kinds of sources, as members of Object.
KINDS = "polyhedron|mesh|patches|bezier|solids|skin|outline|picture"
CALL = r"(?: \( (?:[^()]|\( [^()]* \))*\))?"
KIND_QUESTION = re.compile(
    rf"(?:(?<= )(?P<read>[*&]) )?(?:\w+{CALL} (?:\.|->|::) )*(?P<of>\w+){CALL} (?:\.|->) "
    rf"(?:{KINDS}) \( \)(?! (?:->|\.))"
    rf"|& Object :: (?:{KINDS})\b"
    r"|\b(?:get_if|holds_alternative) < (?!Unknown)\w+Source >")
NO_OBJECTS = {"surface", "surface_", "patches", "request"}  # what has patches, a skin or a picture in another sense
GENERIC_FOLDERS = re.compile(r"ui/(base|editor|widgets|view|shell)/|app/")
KIND_FILES = re.compile(
    r"ui/editor/(\w+_kinds?|guide|operations|outlines|reference_pictures|skin_\w+)\.\wpp|ui/view/patch_jumps\.cpp|"
    r"app/commands/patch_evaluation\.cpp|app/engines/(gauss_engine|reference_loader)\.cpp|"
    r"app/jobs/(conversion|reference|skin)_jobs\.cpp|app/scripts/polyhedron_guesses\.cpp")


# --- over a tree


def texts(top, layers, endings):
    """Path from the top and text of each file, in the order of their paths."""
    for layer in layers:
        for folder, folders, names in os.walk(os.path.join(top, layer)):
            folders.sort()
            for name in sorted(names):
                if name.endswith(endings):
                    path = os.path.join(folder, name)
                    with open(path, encoding="utf-8", errors="replace") as stream:
                        yield os.path.relpath(path, top).replace(os.sep, "/"), stream.read()


def read_tree(top):
    files = {}
    for path, text in texts(top, LAYERS, ENDINGS):
        files[path] = Source(path, text)
        if not files[path].balanced:
            print(f"structure.py: braces of {path} do not match", file=sys.stderr)
    return files


def of_layer(files, layer):
    return [f for path, f in files.items() if path.startswith(layer + "/")]


def layer_rows(files):
    rows = collections.OrderedDict()
    for layer in LAYERS:
        own = of_layer(files, layer)
        folders = collections.Counter(os.path.dirname(f.path) for f in own)
        lengths = [length for f in own for _, length, _ in f.functions]
        longest = max(folders.items(), key=lambda x: (x[1], x[0]), default=("", 0))
        for name, value in (
                ("files", len(own)),
                ("lines", sum(f.lines for f in own)),
                ("statements", sum(f.statements for f in own)),
                (f"files below {SHORT_FILE} lines", sum(f.lines < SHORT_FILE for f in own)),
                (f"files above {LONG_FILE} lines", sum(f.lines > LONG_FILE for f in own)),
                (f"functions above {LONG_FUNCTION} lines", sum(n > LONG_FUNCTION for n in lengths)),
                ("sources in the longest folder", longest[1])):
            rows.setdefault(name, []).append(value)
        rows.setdefault("longest folder", []).append(longest[0])
    return rows


def implementations(files, names, members=None):
    """Classes of core by their names, [(name, file, the one that it stands on or '')]."""
    found = [(name, f.path, held) for f in of_layer(files, "core") for name, held in f.classes if names.fullmatch(name)]
    known = {name for name, _, _ in found}
    out = []
    for name, path, held in found:
        data = [m for m in held if "(" not in m or HELD in m]
        below = sorted({t for m in data for t in m if t in known and t != name})
        own = members is None or any(
            any(members.fullmatch(t) for t in m[1:]) and any(t in CONTAINERS for t in m) for m in data)
        if below or own:
            out.append((name, path, below[0] if below else ""))
    return sorted(out)


def matches(files, pattern):
    return sorted((f.path, len(pattern.findall(f.code))) for f in of_layer(files, "core") if pattern.search(f.code))


def kind_questions(files):
    """[(path, number)] of the generic files of the interface and the application that ask what kind an object is."""
    out = []
    for path, f in sorted(files.items()):
        if not GENERIC_FOLDERS.match(path) or KIND_FILES.fullmatch(path):
            continue
        number = sum(not m["read"] and m["of"] not in NO_OBJECTS for m in KIND_QUESTION.finditer(f.code))
        if number:
            out.append((path, number))
    return out


def twice(files):
    """Names that two headers of core declare: types, constants, functions with equal parameters, overloads."""
    headers = collections.defaultdict(lambda: collections.defaultdict(set))
    for f in of_layer(files, "core"):
        if f.path.endswith(".hpp"):
            for kind, space, name, types in f.names:
                headers[(space, name)][(kind, types)].add(f.path)
    same, overloads = [], []
    for (space, name), declared in sorted(headers.items()):
        paths = sorted(set().union(*declared.values()))
        if len(paths) < 2:
            continue
        kinds = {kind for kind, _ in declared}
        equal = any(len(p) > 1 for p in declared.values())
        repeated = equal or kinds != {"function"}
        (same if repeated else overloads).append((f"{space}::{name}", " and ".join(sorted(kinds)), paths))
    return same, overloads


def core_rows(files):
    """Name of each row, its number, and the lines that say what was counted."""
    rows = []
    for title, found in (("mesh types", implementations(files, MESH_NAMES, FACE_MEMBERS)),
                         ("convex hulls", implementations(files, HULL_NAMES)),
                         ("bounding volume trees", implementations(files, TREE_NAMES))):
        lines = [f"{name}  {path}" for name, path, below in found if not below]
        lines += [f"({name} stands on {below})  {path}" for name, path, below in found if below]
        rows.append((title, sum(not below for _, _, below in found), lines))
    for title, pattern in (("union-finds", UNION_FIND), ("conjugate gradients", CONJUGATE_GRADIENTS)):
        found = matches(files, pattern)
        rows.append((title, len(found), [path for path, _ in found]))
    casts = matches(files, re.compile(r"\bdynamic_cast\b"))
    rows.append(("dynamic_casts", sum(n for _, n in casts), [f"{n}  {path}" for path, n in casts]))
    same, overloads = twice(files)
    for title, found in (("names declared in two headers", same), ("functions overloaded over headers", overloads)):
        rows.append((title, len(found), [f"{name} ({kind})  {', '.join(paths)}" for name, kind, paths in found]))
    asked = kind_questions(files)
    rows.append(("questions of kind, in ui and app", sum(n for _, n in asked), [f"{n}  {path}" for path, n in asked]))
    return rows


# --- printing


def number(value):
    return f"{value:,}" if isinstance(value, int) else value


def print_table(rows):
    widths = [max(len(row[c]) for row in rows) for c in range(len(rows[0]))]
    for k, row in enumerate(rows):
        cells = [cell.rjust(w) if c else cell.ljust(w) for c, (cell, w) in enumerate(zip(row, widths))]
        print("  ".join(cells).rstrip())
        if k == 0:
            print("  ".join("-" * w for w in widths))


def both(before, now):
    if before is None or before == now:
        return number(now)
    return f"{number(before)} > {number(now)}"


def print_all(files, before, revision):
    now, then = layer_rows(files), layer_rows(before) if before else None
    head = f"{revision} > now" if before else ""
    print_table([[head] + LAYERS] + [
        [name] + [both(then[name][k] if then else None, value) for k, value in enumerate(values)]
        for name, values in now.items()])
    print()
    core, old = core_rows(files), core_rows(before) if before else None
    rows = [["in core", revision, "now"]] if before else [["in core", "now"]]
    for k, (title, count, _) in enumerate(core):
        rows.append([title] + ([number(old[k][1])] if before else []) + [number(count)])
    print_table(rows)
    for k, (title, _, lines) in enumerate(core):
        if title.startswith("dynamic"):
            continue
        if before and old[k][2] != lines:
            print_names(f"{title}, {revision}", old[k][2])
        print_names(title, lines)


def print_names(title, lines):
    if lines:
        print(f"\n{title}:")
        for line in lines:
            print("  " + line)


def print_lists(files):
    long = sorted(((n, name, f"{f.path}:{line}") for f in files.values() for name, n, line in f.functions
                   if n > LONG_FUNCTION), reverse=True)
    print_names(f"functions above {LONG_FUNCTION} lines", [f"{n}  {name}  {place}" for n, name, place in long])
    print_names(f"files above {LONG_FILE} lines",
                [f"{f.lines}  {f.path}" for f in sorted(files.values(), key=lambda f: -f.lines) if f.lines > LONG_FILE])
    casts = matches(files, re.compile(r"\bdynamic_cast\b"))
    print_names("dynamic_casts", [f"{n}  {path}" for path, n in casts])


def print_odd_comments(top):
    """Prints places and texts; returns how many there are."""
    count = 0
    for path, text in texts(top, COMMENTED, ENDINGS + (".glsl",)):
        for line, comment in odd_comments(text):
            print(f"{path}:{line}: {comment}")
            count += 1
    return count


def tree_of(top, revision):
    archive = subprocess.run(["git", "-C", top, "archive", revision], check=True, capture_output=True).stdout
    with tempfile.TemporaryDirectory() as folder:
        with tarfile.open(fileobj=io.BytesIO(archive)) as tar:
            tar.extractall(folder, members=[m for m in tar.getmembers() if m.name.endswith(ENDINGS) and m.isfile()])
        return read_tree(folder)


def main():
    top = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", default=top, help="the folder of the sources; otherwise that of this script")
    parser.add_argument("--before", metavar="REV", help="a revision of git to compare with")
    parser.add_argument("--list", action="store_true", help="also name long functions and long files")
    parser.add_argument("--comments", action="store_true", help="only comments that begin with Of, What ...")
    options = parser.parse_args()
    if options.comments:
        sys.exit(1 if print_odd_comments(options.root) else 0)
    before = tree_of(options.root, options.before) if options.before else None
    files = read_tree(options.root)
    print_all(files, before, options.before or "")
    if options.list:
        print_lists(files)


if __name__ == "__main__":
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # as `| head` expects
    main()
