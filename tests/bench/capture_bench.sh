#!/usr/bin/env bash
# A 1280x720 PNG from process start to exit: `shading-sandbox capture` against the least program that does the same
# (bare_capture). They take turns; only the median of the paired ratios means anything.
# usage: capture_bench.sh BUILD_FOLDER [TURNS]
set -euo pipefail

build=${1:?usage: capture_bench.sh BUILD_FOLDER [TURNS]}
turns=${2:-31}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/scene.json" <<'JSON'
{"lights": [
   {"type": "point", "color": [0.8, 0, 0], "ambient": 0.2, "diffuse": 0.8, "specular": 0.8,
    "position": [0, 0, 3], "attenuation": {"constant": 0.2, "linear": 0.1, "quadratic": 0.1}},
   {"type": "point", "color": [0, 0.8, 0], "ambient": 0.2, "diffuse": 0.8, "specular": 0.8,
    "position": [-4, 0, -1.5], "attenuation": {"constant": 0.2, "linear": 0.1, "quadratic": 0.1}},
   {"type": "point", "color": [0.8, 0.8, 0.8], "ambient": 0.2, "diffuse": 0.8, "specular": 0.8,
    "position": [0, 6, 3], "attenuation": {"constant": 0.2, "linear": 0.1, "quadratic": 0.1}}],
 "objects": [{"name": "ball", "mesh": {"shape": "sphere", "radius": 1, "rings": 64, "segments": 128}}]}
JSON

ours() { "$build/shading-sandbox" capture "$folder/scene.json" --size 1280x720 --out "$folder/ours.png"; }
bare() { "$build/tests/bench/bare_capture" "$folder/bare.png"; }

# Microseconds from start to exit.
took() {
    local begin=${EPOCHREALTIME/./}
    "$1" >/dev/null
    echo $((${EPOCHREALTIME/./} - begin))
}

for _ in 1 2 3; do # caches warm: the shader compiler's, the disk's
    took ours >/dev/null
    took bare >/dev/null
done
for ((turn = 0; turn < turns; ++turn)); do
    if ((turn % 2)); then
        a=$(took ours) b=$(took bare)
    else
        b=$(took bare) a=$(took ours)
    fi
    echo "$a $b"
done >"$folder/times"

median() { sort -n | awk '{v[NR] = $1} END {print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2}'; }
awk '{print $1 / $2}' "$folder/times" >"$folder/ratios"
printf 'shading-sandbox capture %.1f ms | bare %.1f ms | median of %d paired ratios %.3f\n' \
    "$(awk '{print $1 / 1000}' "$folder/times" | median)" "$(awk '{print $2 / 1000}' "$folder/times" | median)" \
    "$turns" "$(median <"$folder/ratios")"
