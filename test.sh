#!/usr/bin/env bash
# Installs what is missing, builds what changed, runs every test. Arguments go to ctest (-L cpu, -R name, ...).
# `./test.sh web` builds the page and tests it in Chromium against the native program.
# CI=true: warnings are errors, and a machine without OpenGL fails the tests that need it instead of skipping them.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
werror=OFF
[[ ${CI:-} == true ]] && werror=ON

if [[ ${1:-} == web ]]; then
    "$root/third_party/install.sh" tests web
    [[ -f $root/build/release/build.ninja ]] || cmake -S "$root" --preset release -DSANDBOX_TESTS=OFF
    cmake --build "$root/build/release" --target shading-sandbox
    [[ -f $root/build/web/build.ninja ]] || cmake -S "$root" --preset web
    cmake --build "$root/build/web"
    cd "$root/tests/web"
    npm ci --no-audit --no-fund
    PROGRAM=$root/build/release/shading-sandbox PAGE=$root/build/web exec node --test
fi

"$root/third_party/install.sh" tests
cmake -S "$root" --preset release -DSANDBOX_TESTS=ON -DSANDBOX_WERROR=$werror
cmake --build "$root/build/release"
cd "$root"
exec ctest --preset release --parallel "$(nproc)" "$@"
