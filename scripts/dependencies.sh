#!/usr/bin/env bash
# Installs the Debian packages that are missing, as root or with sudo; does nothing when all are there.
#   scripts/dependencies.sh [build] [cad] [test] [full] [package] [bench]      (default: build)
set -euo pipefail

build_packages=(build-essential cmake ninja-build pkg-config ccache
  libglfw3-dev libx11-dev libimgui-dev libstb-dev libepoxy-dev libglm-dev libeigen3-dev libosd-dev nlohmann-json3-dev libtbb-dev
  libcli11-dev libzip-dev libexpat1-dev libpng-dev libfreetype-dev zlib1g-dev
  fonts-inter fonts-font-awesome fonts-noto-cjk libmuparser-dev libegl1 libgl1 libgl1-mesa-dri)
test_packages=(libgtest-dev libgmock-dev libassimp-dev lib3mf-dev xvfb xauth xdotool libx11-dev x11-utils imagemagick python3 git)
full_packages=(clang-14 libclang-rt-14-dev clang-tidy clang-format valgrind librsvg2-bin poppler-utils python3-ezdxf)
# STEP and IGES: the program builds without them, and says so.
cad_packages=(libocct-data-exchange-dev libocct-modeling-algorithms-dev libocct-modeling-data-dev libocct-foundation-dev
  libocct-visualization-dev libocct-ocaf-dev)
bench_packages=(libbenchmark-dev libgtest-dev libassimp-dev "${cad_packages[@]}")
# What the package is made and checked with (scripts/check_package.sh).
package_packages=(dpkg-dev file librsvg2-bin lintian desktop-file-utils appstream man-db mandoc libxml2-utils shared-mime-info
  libglib2.0-bin xvfb xauth x11-utils imagemagick)

wanted=()
for group in "${@:-build}"; do
  case "$group" in
    build) wanted+=("${build_packages[@]}") ;;
    cad) wanted+=("${cad_packages[@]}") ;;
    test) wanted+=("${test_packages[@]}") ;;
    full) wanted+=("${full_packages[@]}") ;;
    package) wanted+=("${package_packages[@]}") ;;
    bench) wanted+=("${bench_packages[@]}") ;;
    *) echo "dependencies.sh: unknown group '$group' (build, cad, test, full, package, bench)" >&2; exit 2 ;;
  esac
done

missing=()
for package in "${wanted[@]}"; do
  status=$(dpkg-query -W -f='${db:Status-Status} ' "$package" 2>/dev/null || true)
  [[ "$status" == *installed\ * && "$status" != *not-installed* ]] || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then exit 0; fi

if [ "$(id -u)" -eq 0 ]; then
  as_root=(env DEBIAN_FRONTEND=noninteractive)
elif command -v sudo >/dev/null; then
  as_root=(sudo env DEBIAN_FRONTEND=noninteractive)
else
  echo "These packages are missing, and installing them needs root or sudo:" >&2
  echo "  apt-get install ${missing[*]}" >&2
  exit 1
fi
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
