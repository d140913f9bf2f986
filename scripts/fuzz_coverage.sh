#!/usr/bin/env bash
# Lines of each reader that its fuzzer reaches, as a table: the fuzzers built with clang's coverage instrumentation,
# run over the seeds and the corpora that ./test.sh --full has left in build/debug/corpus, and then for a while.
#   scripts/fuzz_coverage.sh [SECONDS] [FORMAT...]   each fuzzer's time beyond the corpora (default: 0); which (default: all)
# Needs the packages of scripts/dependencies.sh build full, and llvm-14.
set -euo pipefail
seconds=${1:-0}
formats=("${@:2}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
profiles=build/coverage/profiles

cmake -S . -B build/coverage -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++ \
  "-DCMAKE_CXX_FLAGS=-fprofile-instr-generate -fcoverage-mapping" \
  -DHARIKO_CAD=OFF -DHARIKO_FUZZ=ON -DHARIKO_SANITIZE=ON -DHARIKO_TESTS=OFF >/dev/null
if [ ${#formats[@]} -eq 0 ]; then mapfile -t formats < <(basename -s _fuzz.cpp tests/fuzz/*_fuzz.cpp); fi
cmake --build build/coverage --target "${formats[@]/%/_fuzz}"

# The files that make up each fuzzer's reader: its own and those that only readers of its kind use.
readers() {
  case "$1" in
    obj | off | stl) echo "core/exchange/read_$1.cpp core/exchange/text_scanner.cpp" ;;
    ply) echo "core/exchange/triangles/read_ply.cpp core/exchange/triangles/ply_header.cpp core/exchange/text_scanner.cpp" ;;
    patches) echo "core/exchange/read_patches.cpp core/exchange/text_scanner.cpp" ;;
    gltf) echo "core/exchange/gltf/read_gltf.cpp core/exchange/gltf/gltf_container.cpp core/exchange/gltf/gltf_fields.cpp" \
      "core/exchange/gltf/gltf_accessor.cpp core/exchange/scene_collector.cpp" ;;
    three_mf) echo "core/exchange/archive_3mf/read_3mf.cpp core/exchange/archive_3mf/model_3mf.cpp core/exchange/archive_3mf/xml_reader.cpp" \
      "core/exchange/archive_3mf/zip_reader.cpp core/exchange/scene_collector.cpp" ;;
    pictures) echo "render/reference_image.cpp render/read_jpeg.cpp render/read_webp.cpp render/photo_orientation.cpp" \
      "render/read_radiance.cpp" ;;
    po) echo "core/base/text/po_file.cpp core/base/text/plural_forms.cpp" ;;
    cad_text) echo "core/cad/kernel/cad_text.cpp" ;;
    document) find core/document -name 'read_*.cpp' -o -name 'json_*.cpp' | sort ;;
    *) echo "fuzz_coverage.sh: no reader is known for '$1'" >&2; return 1 ;;
  esac
}

rm -rf "$profiles"
mkdir -p "$profiles"
for format in "${formats[@]}"; do
  name=${format}_fuzz
  fuzzer=build/coverage/tests/fuzz/$name
  found=build/coverage/corpus/$name
  mkdir -p "$found"
  inputs=("$found" "tests/fuzz/seeds/$format" tests/golden assets/samples)
  if [ -d "build/debug/corpus/$name" ]; then inputs+=("build/debug/corpus/$name"); fi
  limit=(-runs=0)
  if [ "$seconds" -gt 0 ]; then limit=("-max_total_time=$seconds"); fi
  LLVM_PROFILE_FILE="$profiles/$name.profraw" "$fuzzer" "${limit[@]}" -rss_limit_mb=4096 "-dict=tests/fuzz/$format.dict" \
    "${inputs[@]}" 2>"$profiles/$name.log"
  llvm-profdata-14 merge -sparse "$profiles/$name.profraw" -o "$profiles/$name.profdata"
  printf '== %s\n' "$format"
  # shellcheck disable=SC2046
  llvm-cov-14 export -summary-only "-instr-profile=$profiles/$name.profdata" "$fuzzer" |
    python3 -c '
import json, sys
def say(covered, count, name):
    print("%5d of %5d lines %4.0f %%  %s" % (covered, count, 100 * covered / max(count, 1), name))
found = []
for file in json.load(sys.stdin)["data"][0]["files"]:
    name = next((wanted for wanted in sys.argv[1:] if file["filename"].endswith(wanted)), None)
    if name:
        found.append((file["summary"]["lines"]["covered"], file["summary"]["lines"]["count"]))
        say(*found[-1], name)
say(sum(covered for covered, _ in found), sum(count for _, count in found), "together")' $(readers "$format")
done
