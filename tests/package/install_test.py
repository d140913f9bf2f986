"""`cmake --install` into a prefix, which is then moved: the program works from its new place, by whatever name it is
called, and nothing in it names the place where it was built or installed."""

import os
import subprocess
import sys
import tempfile

CMAKE, BUILD = sys.argv[1:3]
EXPECTED = """bin/hariko share/applications/hariko.desktop share/bash-completion/completions/hariko
share/hariko/languages/ja.po share/hariko/samples/cube.hariko share/icons/hicolor/16x16/apps/hariko.png
share/icons/hicolor/512x512/apps/hariko.png share/icons/hicolor/scalable/apps/hariko.svg
share/icons/hicolor/scalable/mimetypes/application-x-hariko.svg share/man/man1/hariko.1.gz
share/metainfo/local.hariko.Hariko.metainfo.xml share/mime/packages/hariko.xml share/thumbnailers/hariko.thumbnailer""".split()


def run(*command, **options):
    done = subprocess.run(command, capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, (command, done.stdout, done.stderr)
    return done.stdout


def files_below(folder):
    return sorted(os.path.join(where, name) for where, _, names in os.walk(folder) for name in names)


def thumbnail_of(program, sample, out):
    """As the thumbnailer's entry says it, on a machine that knows nothing but the prefix."""
    prefix = os.path.dirname(os.path.dirname(os.path.realpath(program)))
    with open(os.path.join(prefix, "share/thumbnailers/hariko.thumbnailer"), encoding="utf-8") as file:
        entry = next(line for line in file if line.startswith("Exec=hariko "))
    words = entry.strip().removeprefix("Exec=hariko ").split()
    values = {"%i": sample, "%o": out, "%sx%s": "64x64"}
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    run(program, *[values.get(word, word) for word in words], env=environment)
    with open(out, "rb") as file:
        assert file.read(4) == b"\x89PNG"


def step_of(program, sample, out):
    """The part for CAD is found beside the program; a build without OpenCASCADE has none."""
    if os.path.exists(os.path.join(os.path.dirname(os.path.dirname(os.path.realpath(program))), "lib/hariko/modules/hariko_cad.so")):
        run(program, "export", sample, out)
        with open(out, "rb") as file:
            assert file.read(12) == b"ISO-10303-21"


def names_no_place(prefix, places):
    for path in files_below(prefix):
        if path.endswith(("bin/hariko", ".so")):
            # Debugging information, which packages leave out, names the sources.
            run("strip", path)
        with open(path, "rb") as file:
            content = file.read()
        for place in places:
            assert place.encode() not in content, (path, place)


def main():
    with tempfile.TemporaryDirectory() as top:
        first, moved = os.path.join(top, "first"), os.path.join(top, "moved to here", "usr")
        run(CMAKE, "--install", BUILD, "--prefix", first)
        installed = files_below(first)
        missing = [path for path in EXPECTED if os.path.join(first, path) not in installed]
        assert not missing, missing
        odd = [path for path in installed if os.stat(path).st_mode & 0o777 != (0o755 if "/bin/" in path else 0o644)]
        assert not odd, odd

        os.makedirs(os.path.dirname(moved))
        os.rename(first, moved)
        link = os.path.join(top, "hariko-by-another-name")
        os.symlink(os.path.join(moved, "bin/hariko"), link)
        assert run(link, "--version").startswith("hariko ")
        thumbnail_of(link, os.path.join(moved, "share/hariko/samples/cube.hariko"), os.path.join(top, "thumbnail.XYZ"))
        step_of(link, os.path.join(moved, "share/hariko/samples/cube.hariko"), os.path.join(top, "cube.step"))
        names_no_place(moved, [first, BUILD])


main()
