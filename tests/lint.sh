#!/usr/bin/env bash
# Checks of the code itself, by Clang's tools: the layout (clang-format), what a second compiler warns of, and a few
# checks for faults (clang-tidy; all of .clang-tidy's by the target tidy). Exit code 77 where a tool is not installed.
#   tests/lint.sh [FILE.cpp ...]: default: all of sandbox/, and the layout of all. Needs a configured build in build/release, or in $BUILD.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
build=${BUILD:-build/release}
for tool in clang-format clang++ clang-tidy; do
    command -v "$tool" >/dev/null || { echo "lint: $tool is not installed" >&2; exit 77; }
done
[[ -f $build/compile_commands.json ]] || { echo "lint: no compile_commands.json in $build; run ./test.sh" >&2; exit 2; }

sources=("$@")
if ((${#sources[@]} == 0)); then
    mapfile -t sources < <(python3 -c '
import json, sys
for entry in json.load(open(sys.argv[1])):
    if entry["file"].startswith(sys.argv[2]): print(entry["file"])' "$build/compile_commands.json" "$root/")
    mapfile -t sources < <(printf '%s\n' "${sources[@]}" | grep "^$root/sandbox/" | sort -u)
    find sandbox tests -name '*.h' -print0 -o -name '*.cpp' -print0 | xargs -0 clang-format --dry-run -Werror
fi

# Of what is read once more for every check, the compiler's own warnings are part: one pass over a file for both.
checks='-*,clang-diagnostic-*,bugprone-use-after-move,bugprone-dangling-handle,bugprone-infinite-loop,'
checks+='bugprone-sizeof-*,bugprone-suspicious-*,bugprone-undelegated-constructor,bugprone-string-*,'
checks+='bugprone-unhandled-self-assignment,bugprone-copy-constructor-init,bugprone-macro-*,'
checks+='performance-for-range-copy,performance-unnecessary-copy-initialization,performance-move-const-arg,'
checks+='modernize-use-override,misc-definitions-in-headers'
printf '%s\0' "${sources[@]}" | nice xargs -0 -n 4 -P "$(nproc)" \
    clang-tidy --quiet -p "$build" --checks="$checks" --warnings-as-errors='*' --extra-arg=-Wno-unknown-warning-option \
    2> >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2)
echo "lint: ${#sources[@]} files are clean"
