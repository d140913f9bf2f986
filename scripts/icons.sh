#!/usr/bin/env bash
# Draws the icons' PNG files from their SVG files (needs rsvg-convert, in the group `package` of dependencies.sh).
#   scripts/icons.sh      after every change of an SVG in assets/icons; the PNG files are committed
# Up to 32 pixels are drawn from assets/icons/small, whose lines are as wide as pixels.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../assets/icons"

for size in 16 24 32 48 64 128 256 512; do
  for name in apps/hariko mimetypes/application-x-hariko; do
    svg=hicolor/scalable/$name.svg
    if [ $size -le 32 ]; then svg=small/$(basename $name).svg; fi
    png=hicolor/${size}x$size/$name.png
    mkdir -p "$(dirname "$png")"
    rsvg-convert --width $size --height $size "$svg" --output "$png"
  done
done
