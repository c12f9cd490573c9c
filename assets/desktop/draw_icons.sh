#!/usr/bin/env bash
# Draws the icon in every size: draw_icons.sh PROGRAM [FOLDER]. The program draws it itself.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$1
folder=${2:-$here}
for size in 48 128 256; do
    "$program" capture "$here/icon.json" --left flat/blinn-phong --right per-pixel/blinn-phong --layout wipe \
        --samples 16 --size "${size}x$size" --no-sidecar --out "$folder/icon-$size.png"
done
