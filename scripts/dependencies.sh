#!/usr/bin/env bash
# Installs the Debian packages that are missing, as root or with sudo; does nothing when all are there.
#   scripts/dependencies.sh [build] [cad] [test] [full] [package] [bench] [bare] [spacenav] [webp]      (default: build)
# Names the libraries that are needed where packages are not Debian's, and goes on: CMake tells which are missing.
set -euo pipefail

build_packages=(build-essential clang lld cmake ninja-build pkg-config ccache
  libglfw3-dev libx11-dev libimgui-dev libstb-dev libepoxy-dev libglm-dev libeigen3-dev libosd-dev nlohmann-json3-dev libtbb-dev
  libcli11-dev libzip-dev libexpat1-dev libpng-dev libjpeg-dev libfreetype-dev libfontconfig-dev zlib1g-dev
  fonts-inter fonts-font-awesome fonts-noto-cjk libmuparser-dev libegl1 libgl1 libgl1-mesa-dri)
test_packages=(libgtest-dev libgmock-dev libassimp-dev lib3mf-dev xvfb xauth xdotool libx11-dev x11-utils imagemagick python3 git)
full_packages=(libclang-rt-dev clang-tidy clang-format valgrind librsvg2-bin poppler-utils python3-ezdxf)
# STEP and IGES: the program builds without them, and says so.
cad_packages=(libocct-data-exchange-dev libocct-modeling-algorithms-dev libocct-modeling-data-dev libocct-foundation-dev
  libocct-visualization-dev libocct-ocaf-dev)
# 3D mice: the program builds without it, and says so.
spacenav_packages=(libspnav-dev)
# WebP pictures: the program builds without it, and says so.
webp_packages=(libwebp-dev)
# Bare roots of Debian (scripts/bare_machine.sh).
bare_packages=(mmdebstrap git util-linux)
bench_packages=(libbenchmark-dev libgtest-dev libassimp-dev "${cad_packages[@]}")
# Tools that make and check the package (scripts/check_package.sh).
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
    bare) wanted+=("${bare_packages[@]}") ;;
    spacenav) wanted+=("${spacenav_packages[@]}") ;;
    webp) wanted+=("${webp_packages[@]}") ;;
    *) echo "dependencies.sh: unknown group '$group' (build, cad, test, full, package, bench, bare, spacenav, webp)" >&2; exit 2 ;;
  esac
done

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  cat >&2 <<TEXT
This script installs packages on Debian and Ubuntu only. Hariko needs these, with their development files:
  a C++20 compiler (clang 14 or GCC 12, or later), CMake 3.25, Ninja, pkg-config
  GLFW 3.3, Dear ImGui 1.86 with FreeType and the backends for GLFW and OpenGL 3, stb, libepoxy, GLM, X11
  Eigen 3.4, OpenSubdiv 3.5, oneTBB, nlohmann-json 3.11, CLI11, muParser, libzip, Expat, libpng, libjpeg-turbo, FreeType, Fontconfig, zlib
  OpenCASCADE 7.6 for STEP and IGES; libspnav for 3D mice; libwebp for WebP pictures; the fonts Inter, Font Awesome 4 and Noto Sans CJK; ccache makes later builds faster
TEXT
  exit 0
fi

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
