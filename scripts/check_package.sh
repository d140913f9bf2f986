#!/usr/bin/env bash
# Checks a package that `cpack -G DEB` made; stops at the first fault.
#   scripts/check_package.sh DEB             its files, size and control data; installs the tools that are missing
#   scripts/check_package.sh --install DEB   also installs it with apt, uses it as another user and removes it again: for
#                                            a machine with nothing on it, by
#       scripts/bare_machine.sh --copy DEB --take package-window.png bookworm scripts/check_package.sh --install DEB
#     leaves package-window.png, a picture of the window
set -euo pipefail

install=no
if [ "${1:-}" = --install ]; then install=yes; shift; fi
[ $# -eq 1 ] && [ -f "$1" ] || { echo "usage: scripts/check_package.sh [--install] DEB" >&2; exit 2; }
package=$(realpath "$1")
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
largest=$((20 * 1000 * 1000))
work=$(mktemp -d)
chmod 755 "$work"
trap 'rm -rf "$work"' EXIT

step() { printf '\n== %s\n' "$*"; }
fail() { echo "check_package.sh: $*" >&2; exit 1; }

# --- What needs the package alone

control_data() {
  step "Control data"
  dpkg-deb --info "$package"
  local size
  size=$(stat -c %s "$package")
  echo "$size bytes"
  [ "$size" -le $largest ] || fail "larger than $largest bytes"
  local release
  release=$(. /etc/os-release && echo "~deb$VERSION_ID")
  [[ $(dpkg-deb --field "$package" Version) == *"$release" ]] || fail "the version does not end in $release"
  local depends needed
  depends=$(dpkg-deb --field "$package" Depends)
  for needed in libc6 libstdc++6 libx11-6 libgl1 libegl1 libgl1-mesa-dri fonts-inter fonts-font-awesome libglfw3 libosd libocct-data-exchange; do
    [[ $depends == *"$needed"* ]] || fail "does not depend on $needed"
  done
  [[ $(dpkg-deb --field "$package" Recommends) == *fonts-noto-cjk* ]] || fail "does not recommend fonts-noto-cjk"
}

content() {
  step "Content"
  dpkg-deb --contents "$package" >"$work/contents"
  awk '{print $3}' "$work/contents" | sort -n | awk '{sum += $1} END {print NR " files and folders, " sum " bytes"}'
  awk '$2 != "root/root"' "$work/contents" | grep . && fail "files that are not root's"
  awk '$1 !~ /^(drwxr-xr-x|-rw-r--r--|-rwxr-xr-x)$/' "$work/contents" | grep . && fail "odd permissions"
  dpkg-deb --extract "$package" "$work/files"
  local path
  for path in bin/hariko lib/hariko/modules/hariko_cad.so share/applications/hariko.desktop share/bash-completion/completions/hariko \
    share/doc/hariko/copyright share/doc/hariko/changelog.gz share/doc/hariko/docs/manual.md \
    share/hariko/languages/ja.po share/hariko/samples/fig2.hariko share/icons/hicolor/scalable/apps/hariko.svg \
    share/icons/hicolor/scalable/mimetypes/application-x-hariko.svg share/man/man1/hariko.1.gz \
    share/metainfo/local.hariko.Hariko.metainfo.xml share/mime/packages/hariko.xml share/thumbnailers/hariko.thumbnailer; do
    [ -f "$work/files/usr/$path" ] || fail "no /usr/$path"
  done
  local size sample theme
  for size in 16 24 32 48 64 128 256 512; do
    file "$work/files/usr/share/icons/hicolor/${size}x$size/apps/hariko.png" | grep -q "PNG image data, $size x $size" ||
      fail "no icon of $size pixels"
  done
  # The start page shows samples at once by pictures that were drawn when the package was made.
  for sample in "$work/files/usr/share/hariko/samples"/*.hariko; do
    for theme in dark light; do
      [ -s "$work/files/usr/share/hariko/pictures/$(basename "$sample" .hariko)-$theme.png" ] ||
        fail "no $theme picture of $(basename "$sample")"
    done
  done
  for path in bin/hariko lib/hariko/modules/hariko_cad.so; do
    file "$work/files/usr/$path" | grep -q ', stripped' || fail "/usr/$path is not stripped"
  done
}

for_desktops() {
  step "Menu entry, type, description, manual page, completion"
  local share=$work/files/usr/share
  desktop-file-validate "$share/applications/hariko.desktop"
  xmllint --noout "$share/mime/packages/hariko.xml" "$share/metainfo/local.hariko.Hariko.metainfo.xml" \
    "$share"/icons/hicolor/scalable/*/*.svg
  # A home page and a name under a domain are what the project does not have yet.
  local said
  said=$(appstreamcli validate --no-net --no-color "$share/metainfo/local.hariko.Hariko.metainfo.xml") || true
  echo "$said"
  grep -E '^[EW]: ' <<<"$said" | grep -v -E ' url-homepage-missing$' && fail "the description for software centres has faults"
  gzip -dc "$share/man/man1/hariko.1.gz" >"$work/hariko.1"
  mandoc -T lint -W warning "$work/hariko.1"
  said=$(LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -E UTF-8 -l -Tutf8 -Z "$work/hariko.1" 2>&1 >/dev/null)
  [ -z "$said" ] || fail "the manual page has faults: $said"
  bash -n "$share/bash-completion/completions/hariko"
  [ "$(zcat "$share/doc/hariko/changelog.gz" | dpkg-parsechangelog -l - -S Version)" = \
    "$(dpkg-deb --field "$package" Version)" ] || fail "the change log is of another version"
  update-mime-database -n "$share/mime" 2>/dev/null
  local sample=$share/hariko/samples/fig2.hariko
  cp "$sample" "$work/without an ending"
  local file
  for file in "$sample" "$work/without an ending"; do
    said=$(XDG_DATA_DIRS=$share:/usr/share XDG_DATA_HOME=$work/none gio info -a standard::content-type "$file")
    grep -q 'standard::content-type: application/x-hariko' <<<"$said" || fail "not known as a document: $said"
  done
}

# The maintainer (in the change log, too) has no address and the project no home page (which makes the description for
# software centres fail in Debian 13; for_desktops has looked at all of that): anything else is a fault.
words_of_lintian() {
  step "Lintian"
  local allowed='(maintainer-address-missing|no-homepage-field|malformed-contact|bogus-mail-host-in-debian-changelog|appstream-metadata-validation-failed)'
  lintian --allow-root --tag-display-limit 0 --display-info "$package" >"$work/lintian" || true
  cat "$work/lintian"
  grep -E '^[EW]:' "$work/lintian" | grep -v -E "$allowed" && fail "lintian found faults"
  return 0
}

# --- What installs it

# The program takes the place of the shell that calls it, so that signals reach it. A session gives its user a folder
# for what lasts as long as it does; OpenGL complains where there is none.
in_other_home() {
  install -d -m 700 -o package-user -g package-user "$work/session"
  exec setpriv --reuid=package-user --regid=package-user --init-groups env -i PATH="$PATH" HOME=/home/package-user \
    XDG_RUNTIME_DIR="$work/session" "$@"
}

# Nothing but the package and what it depends on is there, so a dependency that is missing shows.
installed_alone() {
  step "Installed by apt, without what it recommends"
  apt-get update -q
  DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "$package"
  dpkg --verify hariko
  useradd --create-home --shell /bin/bash package-user
  mkdir "$work/out"
  chown package-user "$work/out"
  (in_other_home hariko --version)
  (in_other_home test -r /usr/share/hariko/samples/fig2.hariko)
  (in_other_home hariko info /usr/share/hariko/samples/fig2.hariko)
  (in_other_home hariko render /usr/share/hariko/samples/fig2.hariko "$work/out/fig2.png" --size 320x240)
  [ -s "$work/out/fig2.png" ] || fail "no picture"
  (in_other_home hariko export /usr/share/hariko/samples/cube.hariko "$work/out/cube.step")
  grep -q ISO-10303-21 "$work/out/cube.step" || fail "no STEP file"
  local entry
  entry=$(sed -n 's/^Exec=//p' /usr/share/thumbnailers/hariko.thumbnailer |
    sed "s|%i|/usr/share/hariko/samples/cube.hariko|; s|%o|$work/out/thumbnail|; s|%s|128|g")
  (in_other_home $entry)
  [ -s "$work/out/thumbnail" ] || fail "no thumbnail"
}

# Waits for what needs a moment: at most a minute.
wait_for() {
  local tries
  for ((tries = 0; tries < 300; ++tries)); do
    if "$@"; then return 0; fi
    sleep 0.2
  done
  fail "waited in vain: $*"
}

has_window() { xwininfo -root -tree 2>/dev/null | grep -q '("hariko" "hariko")'; }
# The surface is there, and the screen is twice the same.
is_drawn() {
  grep -q '"rebuild"' "$work/out/log" || return 1
  local before=${picture_before:-}
  import -window root "$work/window.png"
  picture_before=$(identify -format '%#' "$work/window.png")
  [ "$picture_before" = "$before" ] && [ "$(identify -format %k "$work/window.png")" -gt 2000 ]
}

window_opens() {
  step "The window"
  local number=90
  while [ -e /tmp/.X11-unix/X$number ]; do ((++number)); done
  Xvfb :$number -screen 0 1280x800x24 -nolisten tcp -ac >/dev/null 2>&1 &
  local server=$!
  export DISPLAY=:$number
  wait_for xwininfo -root >/dev/null 2>&1
  in_other_home DISPLAY=$DISPLAY hariko --test-log "$work/out/log" /usr/share/hariko/samples/fig2.hariko 2>"$work/stderr" &
  local program=$!
  wait_for has_window
  wait_for is_drawn
  local id
  id=$(xwininfo -root -tree | awk '/\("hariko" "hariko"\)/ {print $1; exit}')
  xprop -id "$id" WM_CLASS WM_NAME
  xprop -id "$id" -len 64 _NET_WM_ICON | grep -q 'Icon\|CARDINAL' || fail "the window has no icon"
  cp "$work/window.png" "$top/package-window.png"
  kill -TERM $program
  wait $program || true
  kill $server
  wait $server 2>/dev/null || true
  unset DISPLAY
  [ ! -s "$work/stderr" ] || { cat "$work/stderr"; fail "the program complained"; }
  echo "$top/package-window.png"
}

leaves_nothing() {
  step "Removed again"
  dpkg -L hariko | sort >"$work/installed"
  DEBIAN_FRONTEND=noninteractive apt-get purge -y -q hariko
  dpkg-query -W -f='${db:Status-Status}\n' hariko 2>/dev/null | grep . && fail "dpkg still knows it"
  # The settings of users are theirs.
  find / -xdev \( -path /proc -o -path /sys -o -path "$top" -o -path "$work" -o -path /var/cache/apt -o -path /home \) -prune \
    -o -iname '*hariko*' -print | grep . && fail "these were left behind"
  grep -rl hariko /usr/share/applications /usr/share/mime 2>/dev/null && fail "the desktop still knows it"
  userdel --remove package-user 2>/dev/null
  echo "nothing was left"
}

if [ $install = yes ]; then installed_alone; fi
"$top/scripts/dependencies.sh" package
control_data
content
for_desktops
words_of_lintian
if [ $install = yes ]; then
  window_opens
  leaves_nothing
fi
echo
echo "The package is fine."
