#!/usr/bin/env bash
# Installs what is missing, builds and tests.
#   ./test.sh          one optimised build with assertions; the tests labelled core and window, but for those of the
#                      window labelled long
#   ./test.sh --core   the same build, and the tests labelled core only
#   ./test.sh --full   also: formatting before, those labelled long and full, the core tests as long random runs with a
#                      fresh seed (set HARIKO_SEED to repeat one), the sanitizer build with the core tests, with anything
#                      that can be done by commands and with two minutes of a monkey at the window, a minute of every
#                      fuzzer, and program and core tests on a bare Debian 13 (needs to be root). About two hours.
# Stops at the first step that fails; --full goes on after a failure and names the steps that failed at its end. Window
# tests start an X server of their own.
set -euo pipefail

full=no core_only=no
case "${1:-}" in
  "") ;;
  --core) core_only=yes ;;
  --full) full=yes ;;
  *) echo "usage: ./test.sh [--core|--full]" >&2; exit 2 ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")"
# Tests of the window wait most of their time, for the screen and the hand that moves the mouse.
window_jobs=4
step() { printf '\n== %s\n' "$*"; }

# Builds a preset with the tests, and says what it cost. A warning that the compiler's cache repeats is no error to the
# compiler, so the output is searched for them.
build() { # preset options...
  local preset=$1 log=build/$1/build.log
  shift
  step "Build: $preset"
  scripts/check_build_folder.sh "build/$preset"
  cmake --preset "$preset" -DHARIKO_WERROR=ON "$@"
  rm -f "build/$preset/ccache.log"
  TIMEFORMAT="built in %R s, %U s of them the processors' for us"
  time CCACHE_STATSLOG=$PWD/build/$preset/ccache.log cmake --build --preset "$preset" 2>&1 | tee "$log"
  if [ -f "build/$preset/ccache.log" ]; then CCACHE_STATSLOG=$PWD/build/$preset/ccache.log ccache --show-log-stats; fi
  if grep -n 'warning:' "$log"; then
    echo "test.sh: the build has warnings" >&2
    return 1
  fi
}

core_tests() {
  step "Tests"
  ctest --test-dir build/release -L core -LE full --output-on-failure --no-tests=error -j2
}

window_tests() {
  step "Tests of the window"
  local left_out=full
  if [ $full = no ]; then left_out='full|long'; fi
  ctest --test-dir build/release -L window -LE "$left_out" --output-on-failure --no-tests=error -j$window_jobs
}

# They take minutes, and no other work beside them.
full_tests() {
  step "Tests of whole walks"
  ctest --test-dir build/release -L full --output-on-failure --no-tests=error -j1
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
  build debug
  export UBSAN_OPTIONS=print_stacktrace=1 LSAN_OPTIONS=suppressions=$PWD/tests/leaks.supp:print_suppressions=0
  # The module that reads and writes CAD files has the core linked in once more, as it has to.
  ASAN_OPTIONS=detect_leaks=1:detect_odr_violation=0 ctest --test-dir build/debug -L core -LE full --output-on-failure --no-tests=error -j2
  # Graphics drivers keep memory until the end, so leaks are looked for in the core tests only. What the other tests of
  # the window do, the monkey and the random user do as well.
  ASAN_OPTIONS=detect_leaks=0:detect_odr_violation=0 ctest --test-dir build/debug -R '^(RandomCommands|Table)\.|^window\.monkey$' --output-on-failure --no-tests=error -j2
}

fuzz() {
  step "Fuzzers"
  local fuzzers=()
  mapfile -t fuzzers < <(find build/debug/tests/fuzz -maxdepth 1 -type f -executable | sort)
  if [ ${#fuzzers[@]} -eq 0 ]; then
    echo "test.sh: the sanitizer build has no fuzzers" >&2
    return 1
  fi
  mkdir -p build/debug/artifacts
  export -f run_fuzzer
  printf '%s\n' "${fuzzers[@]}" | xargs -P2 -I{} bash -euo pipefail -c 'run_fuzzer {}'
}

run_fuzzer() {
  local name format corpus
  name=$(basename "$1")
  format=${name%_fuzz}
  corpus=build/debug/corpus/$name
  mkdir -p "$corpus"
  local report
  report=$("$1" -max_total_time=60 -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
    "-artifact_prefix=build/debug/artifacts/$name-" "-dict=tests/fuzz/$format.dict" \
    "$corpus" "tests/fuzz/seeds/$format" tests/golden assets/samples 2>&1 | tail -n 25) ||
    { printf '%s\n== Fuzzer %s failed\n' "$report" "$name"; return 1; }
  printf '\n== Fuzzer %s, one minute\n%s\n' "$name" "$report"
}

long_random_tests() {
  local seed=${HARIKO_SEED:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
  step "Long random runs: HARIKO_SEED=$seed HARIKO_REPEAT_SCALE=4"
  HARIKO_SEED=$seed HARIKO_REPEAT_SCALE=4 \
    ctest --test-dir build/release -L core -LE full --output-on-failure --no-tests=error -j2
}

# The tests first: as root they fill the compiler cache, which the second root may read.
bare_debian_13() {
  step "A bare Debian 13: the core tests"
  scripts/bare_machine.sh --ccache trixie ./test.sh --core
  step "A bare Debian 13: the program, for a user with sudo"
  scripts/bare_machine.sh --ccache --user trixie ./run.sh info assets/samples/fig2.hariko
}

if [ $full = no ]; then
  scripts/dependencies.sh build cad webp test
  build release -DHARIKO_TESTS=ON
  core_tests
  if [ $core_only = no ]; then window_tests; fi
  exit 0
fi

scripts/dependencies.sh build cad webp test full bare
failed=()
# In a shell of its own, so that the first failing command ends the step.
for this in check_formatting "build release -DHARIKO_TESTS=ON" window_tests full_tests long_random_tests sanitizer_tests \
  fuzz bare_debian_13; do
  set +e
  (set -e; $this)
  [ $? -eq 0 ] || failed+=("$this")
  set -e
done
step "Failed: ${failed[*]:-nothing}"
[ ${#failed[@]} -eq 0 ]
