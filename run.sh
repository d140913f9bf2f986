#!/usr/bin/env bash
# Installs what is missing, builds Hariko and starts it.
#   ./run.sh                opens the window with a sample; without a display it computes every sample instead
#   ./run.sh ARGUMENTS...   passes the arguments to hariko (./run.sh --help lists them)
set -euo pipefail

start_folder=$PWD
cd "$(dirname "${BASH_SOURCE[0]}")"
top=$PWD
# STEP is what designers export and WebP what they find, so the groups cad and webp are not left to choice.
scripts/dependencies.sh build cad webp >&2
scripts/check_build_folder.sh build/release
cmake --preset release >&2
cmake --build --preset release --target hariko hariko_sample_pictures >&2
hariko=$top/build/release/app/hariko

if [ $# -gt 0 ]; then
  cd "$start_folder"
  exec "$hariko" "$@"
fi
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  exec "$hariko" assets/samples/fig2.hariko
fi

echo "There is no display, so no window is opened. Instead the surface of every sample is computed,"
echo "and reports, pictures and meshes are written to $top/out."
mkdir -p out
failed=()
for sample in assets/samples/*.hariko; do
  name=$(basename "$sample" .hariko)
  echo
  if "$hariko" info "$sample" | tee "out/$name.txt" &&
    "$hariko" render "$sample" "out/$name.png" --size 1280x960 &&
    "$hariko" render "$sample" "out/$name-zebra.png" --size 1280x960 --map zebra &&
    "$hariko" export "$sample" "out/$name.obj" --density 8; then
    echo "$sample: out/$name.txt, out/$name.png, out/$name-zebra.png, out/$name.obj"
  else
    failed+=("$sample")
  fi
done
echo
if [ ${#failed[@]} -gt 0 ]; then
  echo "Failed: ${failed[*]}" >&2
  exit 1
fi
echo "All samples are in $top/out."
