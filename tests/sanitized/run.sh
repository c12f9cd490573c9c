#!/usr/bin/env bash
# Builds everything with the address and undefined-behaviour sanitizers, leaks among them, and runs every test.
# Arguments go to ctest (-L cpu, -R name, ...).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root"
cmake --preset asan -DSANDBOX_TESTS=ON
cmake --build --preset asan
exec ctest --preset asan --parallel "$(nproc)" "$@"
