#!/usr/bin/env bash
# Installs what is missing, builds what changed, then runs shading-sandbox with the arguments given. Without any: the
# window, or where there is no display, a captured comparison. `./run.sh web [PORT]` builds the page and serves it to this
# machine's browsers.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$root/build/release

if [[ ${1:-} == web ]]; then
    port=${2:-8000}
    "$root/third_party/install.sh" web
    [[ -f $root/build/web/build.ninja ]] || cmake -S "$root" --preset web
    cmake --build "$root/build/web"
    echo "The page: http://127.0.0.1:$port/ (Ctrl-C ends), and as one file: $root/build/web/shading-sandbox.html"
    exec python3 -m http.server --bind 127.0.0.1 --directory "$root/build/web/split" "$port"
fi

"$root/third_party/install.sh"
# The folder is test.sh's too: once configured it is left as it is, and only the program is built.
[[ -f $build/build.ninja ]] || cmake -S "$root" --preset release -DSANDBOX_TESTS=OFF
cmake --build "$build" --target shading-sandbox

if [[ $# -gt 0 || -n ${DISPLAY:-} || -n ${WAYLAND_DISPLAY:-} ]]; then
    exec "$build/shading-sandbox" "$@"
fi
echo "No display: capturing a comparison of two techniques."
"$build/shading-sandbox" capture studio --left per-vertex/blinn-phong --right per-pixel/blinn-phong \
    --layout side-by-side --labels --samples 16 --size 1600x660 --out comparison.png
echo "Wrote $PWD/comparison.png"
