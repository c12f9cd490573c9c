#!/usr/bin/env bash
# Installs what is missing, builds what changed, runs every test. Arguments go to ctest (-L cpu, -R name, ...).
# CI=true: warnings are errors, and a machine without OpenGL fails the tests that need it instead of skipping them.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
werror=OFF
[[ ${CI:-} == true ]] && werror=ON

"$root/third_party/install.sh" tests
cmake -S "$root" --preset release -DSANDBOX_TESTS=ON -DSANDBOX_WERROR=$werror
cmake --build "$root/build/release"
cd "$root"
exec ctest --preset release --parallel "$(nproc)" "$@"
