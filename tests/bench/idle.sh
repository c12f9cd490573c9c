#!/bin/bash
# What the window costs while nothing happens: processor time over ten seconds, in per cent of one core.
# usage: idle.sh PROGRAM [SCENE]
set -eu
folder=$(mktemp -d)
window= server=
trap 'kill $window $server 2>/dev/null; rm -rf "$folder"' EXIT
exec 3<>"$folder/display"
Xvfb -displayfd 3 -noreset -screen 0 1280x720x24 >/dev/null 2>&1 &
server=$!
until [ -s "$folder/display" ]; do sleep 0.1; done
DISPLAY=":$(cat "$folder/display")" "$@" &
window=$!
ticks() { awk '{print $14 + $15}' "/proc/$window/stat"; }
sleep 5 # opened and settled
before=$(ticks)
sleep 10
after=$(ticks)
awk -v ticks=$((after - before)) -v rate="$(getconf CLK_TCK)" 'BEGIN {printf "idle: %.2f %% of a core\n", 10 * ticks / rate}'
