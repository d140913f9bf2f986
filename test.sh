#!/usr/bin/env bash
# Installs what is missing, builds and tests.
#   ./test.sh          one optimised build with assertions; the tests labelled core and window, but for those of the
#                      window labelled long
#   ./test.sh --full   also: those, formatting, the sanitizer build with two minutes of a monkey at the window, a
#                      minute of every fuzzer, long random runs with a fresh seed (set HARIKO_SEED to repeat one),
#                      and the tests labelled full
# Stops at the first step that fails. Window tests start an X server of their own.
set -euo pipefail

full=no
case "${1:-}" in
  "") ;;
  --full) full=yes ;;
  *) echo "usage: ./test.sh [--full]" >&2; exit 2 ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")"
# Tests of the window wait most of their time, for the screen and the hand that moves the mouse.
window_jobs=4
step() { printf '\n== %s\n' "$*"; }

short_tests() {
  step "Tests"
  ctest --test-dir build/release -L core -LE full --output-on-failure --no-tests=error -j2
  step "Tests of the window"
  local left_out=full
  if [ $full = no ]; then left_out='full|long'; fi
  ctest --test-dir build/release -L window -LE "$left_out" --output-on-failure --no-tests=error -j$window_jobs
}

check_formatting() {
  step "Formatting"
  local folders=()
  for folder in core render ui app tests bench; do
    if [ -d "$folder" ]; then folders+=("$folder"); fi
  done
  find "${folders[@]}" \( -name '*.cpp' -o -name '*.hpp' \) -print0 | xargs -0 clang-format --dry-run -Werror
}

sanitizer_tests() {
  step "Sanitizer build"
  cmake --preset debug
  cmake --build --preset debug
  export UBSAN_OPTIONS=print_stacktrace=1 LSAN_OPTIONS=suppressions=$PWD/tests/leaks.supp:print_suppressions=0
  ASAN_OPTIONS=detect_leaks=1 ctest --test-dir build/debug -L core -LE full --output-on-failure --no-tests=error -j2
  # Graphics drivers keep memory until the end, so leaks are looked for in the core tests only.
  ASAN_OPTIONS=detect_leaks=0 ctest --test-dir build/debug -L 'window|monkey' -LE full --output-on-failure --no-tests=error -j$window_jobs
}

fuzz() {
  step "Fuzzers"
  cmake --preset fuzz
  cmake --build --preset fuzz
  local fuzzers=()
  mapfile -t fuzzers < <(find build/fuzz/tests/fuzz -maxdepth 1 -type f -executable | sort)
  if [ ${#fuzzers[@]} -eq 0 ]; then
    echo "test.sh: the fuzz build has no fuzzers" >&2
    return 1
  fi
  mkdir -p build/fuzz/artifacts
  export -f run_fuzzer
  printf '%s\n' "${fuzzers[@]}" | xargs -P2 -I{} bash -euo pipefail -c 'run_fuzzer {}'
}

run_fuzzer() {
  local name format corpus
  name=$(basename "$1")
  format=${name%_fuzz}
  corpus=build/fuzz/corpus/$name
  mkdir -p "$corpus"
  local report
  report=$("$1" -max_total_time=60 -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
    "-artifact_prefix=build/fuzz/artifacts/$name-" "-dict=tests/fuzz/$format.dict" \
    "$corpus" "tests/fuzz/seeds/$format" tests/golden assets/samples 2>&1 | tail -n 25) ||
    { printf '%s\n== Fuzzer %s failed\n' "$report" "$name"; return 1; }
  printf '\n== Fuzzer %s, one minute\n%s\n' "$name" "$report"
}

long_random_tests() {
  local seed=${HARIKO_SEED:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
  step "Long random runs: HARIKO_SEED=$seed HARIKO_REPEAT_SCALE=10"
  HARIKO_SEED=$seed HARIKO_REPEAT_SCALE=10 \
    ctest --test-dir build/release -L 'core|full' --output-on-failure --no-tests=error -j2
}

if [ $full = yes ]; then scripts/dependencies.sh build cad test full; else scripts/dependencies.sh build cad test; fi
step "Build"
cmake --preset release
cmake --build --preset release
short_tests
if [ $full = yes ]; then
  check_formatting
  sanitizer_tests
  fuzz
  long_random_tests
fi
