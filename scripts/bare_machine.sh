#!/usr/bin/env bash
# Runs a command on a bare machine: a Debian root with nothing but its minimal base, in which the commit that is checked
# out here is cloned. Proves that the scripts install whatever a build, a test or the program needs.
#   scripts/bare_machine.sh [OPTIONS] bookworm|trixie [COMMAND...]     (default command: ./run.sh info of a sample)
#     --user         the command runs as a user with sudo instead of root
#     --ccache       lends the root this user's compiler cache, read and written; read only where --user is given
#     --copy FILE    puts a file into the clone's folder; may be given several times
#     --take PATH    copies what the command wrote at PATH, relative to the clone, to the current folder
#     --keep         leaves the root behind and says where
# Every run begins with an untouched root. The archive it is unpacked from is kept in ~/.cache/hariko/roots beside the
# packages that were downloaded, and made anew once the distribution has newer packages for it.
# Needs mmdebstrap and git, and to be root; the exit code is the command's.
set -euo pipefail

usage() { sed -n '4,9s/^# \{0,1\}//p' "$0" >&2; exit 2; }

as_user=no keep=no lend_cache=no
copies=() takes=()
while [ $# -gt 0 ]; do
  case "$1" in
    --user) as_user=yes ;;
    --ccache) lend_cache=yes ;;
    --keep) keep=yes ;;
    --copy) copies+=("$(realpath "$2")"); shift ;;
    --take) takes+=("$2"); shift ;;
    -*) usage ;;
    *) break ;;
  esac
  shift
done
suite=${1:-}
case "$suite" in bookworm|trixie) shift ;; *) usage ;; esac
if [ $# -eq 0 ]; then set -- ./run.sh info assets/samples/fig2.hariko; fi

start_folder=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")/.."
checkout=$PWD
for program in mmdebstrap git unshare tar; do
  command -v "$program" >/dev/null || { echo "bare_machine.sh: '$program' is missing (apt-get install mmdebstrap git)" >&2; exit 1; }
done
[ "$(id -u)" -eq 0 ] || { echo "bare_machine.sh: needs to be root, to mount folders into the root" >&2; exit 1; }

cache=${XDG_CACHE_HOME:-$HOME/.cache}/hariko/roots
archive=$cache/$suite.tar
packages=$cache/$suite-packages
mkdir -p "$cache" "$packages/partial"
root=$(mktemp -d "$cache/$suite.XXXXXX")
# Mounts are made in name spaces of their own and are never seen here. Should one be there all the same, deleting would
# reach into what is mounted.
empty_root() {
  if grep -qF " $root/" /proc/self/mountinfo; then
    echo "bare_machine.sh: something is mounted in $root, which is left as it is" >&2
    return 1
  fi
  find "$root" -mindepth 1 -delete
}
cleanup() {
  if [ $keep = yes ]; then echo "bare_machine.sh: the root is left in $root" >&2; else empty_root && rmdir "$root"; fi
}
trap cleanup EXIT

# Runs a command in the root, in name spaces of its own: whatever is mounted or started ends with it.
in_root() {
  unshare --mount --pid --fork --kill-child --propagation private bash -euc '
    root=$1 packages=$2 compiler_cache=$3
    shift 3
    mount -t proc proc "$root/proc"
    mount -t sysfs -o ro sysfs "$root/sys"
    mount -t tmpfs -o mode=755 dev "$root/dev"
    for node in null zero full random urandom tty; do touch "$root/dev/$node"; mount --bind "/dev/$node" "$root/dev/$node"; done
    ln -s /proc/self/fd "$root/dev/fd"
    ln -s fd/0 "$root/dev/stdin"; ln -s fd/1 "$root/dev/stdout"; ln -s fd/2 "$root/dev/stderr"
    mkdir "$root/dev/shm" "$root/dev/pts"
    mount -t tmpfs -o mode=1777 shm "$root/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666,mode=620 devpts "$root/dev/pts" && ln -s pts/ptmx "$root/dev/ptmx"
    mount --bind "$packages" "$root/var/cache/apt/archives"
    if [ -n "$compiler_cache" ]; then mkdir -p "$root/var/cache/ccache"; mount --bind "$compiler_cache" "$root/var/cache/ccache"; fi
    exec chroot "$root" "$@"
  ' in_root "$root" "$packages" "$compiler_cache" "$@"
}
compiler_cache=

unpack() {
  empty_root
  tar -x --numeric-owner -p -f "$archive" -C "$root"
  # Names of hosts are found, and packages fetched, the way this machine does it.
  cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
  local setting
  for setting in /etc/apt/apt.conf.d/*proxy*; do
    if [ -f "$setting" ]; then cp "$setting" "$root/etc/apt/apt.conf.d/"; fi
  done
  # Packages that were downloaded are kept for the next run.
  echo 'Binary::apt-get::APT::Keep-Downloaded-Packages "true";' >"$root/etc/apt/apt.conf.d/99keep"
  rm -f "$root/etc/apt/apt.conf.d/docker-clean"
}

make_archive() {
  echo "bare_machine.sh: making a bare root of $suite" >&2
  rm -f "$packages"/*.deb
  mmdebstrap --quiet --variant=minbase "$suite" "$archive.new.tar" >&2
  mv "$archive.new.tar" "$archive"
}

outdated() { # whether the distribution has newer packages for what is in the root
  in_root sh -c 'apt-get update -qq && apt-get --simulate --quiet dist-upgrade' | grep -q '^Inst '
}

[ -f "$archive" ] || make_archive
unpack
if outdated; then
  make_archive
  unpack
fi

# The clone lies where the checkout lies here: paths are in what a compiler's cache compares.
home=/root user=root
if [ $as_user = yes ]; then
  home=/home/designer user=designer
  in_root sh -euc '
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends sudo >/dev/null
    useradd --create-home --shell /bin/bash designer
    echo "designer ALL=(ALL) NOPASSWD: ALL" >/etc/sudoers.d/designer' >&2
fi
# The untouched root has no git, so the clone is made here; it has no other tie to this checkout.
git clone --quiet --no-hardlinks --no-local "file://$checkout" "$root$checkout"
git -C "$root$checkout" remote remove origin
for file in ${copies[@]+"${copies[@]}"}; do cp "$file" "$root$checkout/"; done
in_root chown -R "$user:$user" "$home" "$checkout"
in_root sh -c 'while [ "$1" != / ]; do chmod a+x "$1"; set -- "$(dirname "$1")"; done' sh "$(dirname "$checkout")"

variables=("HOME=$home" "USER=$user" "LOGNAME=$user" LANG=C.UTF-8 TERM=dumb "CI=${CI:-}"
  PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin)
for name in http_proxy https_proxy no_proxy HARIKO_SEED; do
  if [ -n "${!name:-}" ]; then variables+=("$name=${!name}"); fi
done
if [ $lend_cache = yes ]; then
  compiler_cache=${CCACHE_DIR:-${XDG_CACHE_HOME:-$HOME/.cache}/ccache}
  mkdir -p "$compiler_cache"
  variables+=(CCACHE_DIR=/var/cache/ccache)
  if [ $as_user = yes ]; then variables+=(CCACHE_READONLY=1 CCACHE_TEMPDIR=/tmp/ccache); fi
fi
result=0
in_root setpriv --reuid="$user" --regid="$user" --init-groups env -i "${variables[@]}" \
  sh -c 'cd "$0" && exec "$@"' "$checkout" "$@" || result=$?
for path in ${takes[@]+"${takes[@]}"}; do
  # Patterns may name what the command has made.
  for found in "$root$checkout/"$path; do cp -r "$found" "$start_folder/"; done
done
exit "$result"
