#!/usr/bin/env bash
# Says what to do where a build folder belongs to another checkout: CMake writes whole paths into it, so it does not
# survive that the checkout is moved or copied.
#   scripts/check_build_folder.sh FOLDER...
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
for folder in "$@"; do
  if [ ! -f "$folder/CMakeCache.txt" ]; then continue; fi
  made_for=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$folder/CMakeCache.txt")
  if [ "$made_for" != "$(pwd -P)" ] && [ "$made_for" != "$PWD" ]; then
    echo "$folder was made when this folder was $made_for. Remove build/ and try again:" >&2
    echo "  rm -r '$PWD/build'" >&2
    exit 1
  fi
done
