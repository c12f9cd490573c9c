#!/bin/bash
# Runs the window under a virtual X server: what only a real window shows. All else is tested by scripts, without a
# display (tests/commands/script_gl_test.cpp).
# usage: window_test.sh PROGRAM SHADERS_FOLDER          exit 77: a tool is missing, nothing was tested
set -u
program=$(realpath "$1")
shaders=$(realpath "$2")
for tool in Xvfb xdotool import convert; do
    command -v "$tool" >/dev/null || { echo "SKIPPED: $tool is not installed"; exit 77; }
done
# Pixels are compared, so the machine's own GPU and its quirks stay out.
export LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY

folder=$(mktemp -d)
cd "$folder" || exit 1
server=
window_pid=
cleanup() {
    [ -n "$window_pid" ] && kill "$window_pid" 2>/dev/null
    [ -n "$server" ] && kill "$server" 2>/dev/null
    rm -rf "$folder"
}
trap cleanup EXIT

failures=0
fail() { echo "FAILED: $*"; failures=$((failures + 1)); }
pass() { echo "ok: $*"; }

exec 3<>"$folder/display"
# -noreset: when the last window closes the server would start afresh, and refuse a window that opens meanwhile.
Xvfb -displayfd 3 -noreset -screen 0 1280x720x24 >/dev/null 2>&1 &
server=$!
for _ in $(seq 100); do [ -s "$folder/display" ] && break; sleep 0.1; done
export DISPLAY=":$(cat "$folder/display")"

# The pixels of the two pictures, without names, times and panels.
pictures() { import -window root -crop 900x480+360+110 +repage rgb:- | md5sum; }
lower_half() { import -window root -crop 900x220+360+370 +repage rgb:- | md5sum; }
# Waits until the pictures, or what WHAT takes, are the same as, or other than, HASH; at most 20 s.
await() { # same|other HASH [WHAT]
    for _ in $(seq 100); do
        now=$("${3:-pictures}")
        if { [ "$1" = same ] && [ "$now" = "$2" ]; } || { [ "$1" = other ] && [ "$now" != "$2" ]; }; then return 0; fi
        sleep 0.2
    done
    return 1
}
# Waits until nothing changes any more, then prints the pictures' hash. Smooth ones come a second or so after the first.
settled() {
    local before now still=0
    before=$(pictures)
    while [ $still -lt 8 ]; do
        sleep 0.3
        now=$(pictures)
        if [ "$now" = "$before" ]; then still=$((still + 1)); else still=0; fi
        before=$now
    done
    echo "$now"
}
expect_other() { if await other "$2"; then pass "$1"; else fail "$1: the pictures did not change"; fi; }
expect_same() { if await same "$2"; then pass "$1"; else fail "$1: the pictures are not as they were"; fi; }
drag() { # from x y to x y
    xdotool mousemove "$1" "$2" mousedown 1 sleep 0.1 mousemove $((($1 + $3) / 2)) $((($2 + $4) / 2)) sleep 0.1 \
        mousemove "$3" "$4" sleep 0.2 mouseup 1
}
start() {
    "$program" "$@" >out.txt 2>&1 &
    window_pid=$!
    for _ in $(seq 100); do xdotool search --name 'Shading Sandbox' >/dev/null 2>&1 && break; sleep 0.1; done
    settled >/dev/null
}
quit() {
    xdotool key ctrl+q
    for _ in $(seq 100); do kill -0 "$window_pid" 2>/dev/null || break; sleep 0.1; done
    kill -0 "$window_pid" 2>/dev/null && { fail "$1: Ctrl+Q did not close the window"; return; }
    wait "$window_pid"
    local code=$?
    window_pid=
    if [ $code -eq 0 ]; then pass "$1"; else fail "$1: exit code $code: $(cat out.txt)"; fi
}

start
opened=$(settled)
colors=$(import -window root -crop 900x480+360+110 +repage -format '%k' info:)
if [ "$colors" -gt 1000 ]; then pass "opens on a picture"; else fail "opens on a picture: $colors colours: $(cat out.txt)"; fi

xdotool mousemove 291 106 click 1 # A: flat
expect_other "a toggle by mouse" "$opened"
xdotool key ctrl+z
expect_same "undo" "$opened"
drag 600 300 700 330
expect_other "orbit" "$opened"
settled >/dev/null
xdotool key r
expect_same "camera as opened" "$opened"
xdotool key 3
flip=$(settled)
xdotool keydown space
expect_other "flip while Space is held" "$flip"
xdotool keyup space
expect_same "flip back" "$flip"
xdotool key 1
expect_same "side by side again" "$opened"

window=$(xdotool search --name 'Shading Sandbox' | head -1)
for size in "800 500" "480 320" "1280 720"; do
    # shellcheck disable=SC2086
    xdotool windowsize "$window" $size
    settled >/dev/null
done
expect_same "resized and back" "$opened"
quit "Ctrl+Q"

cp -r "$shaders" shaders
start --shaders shaders
expect_same "shaders from disk" "$opened"
sed -i 's/gl_Position = \(.*\);/gl_Position = \1;\n    gl_Position.x *= 0.5;/' shaders/*.glsl
expect_other "an edited shader reloads" "$opened"
edited=$(settled)
edited_below=$(lower_half)
for part in shaders/*.glsl; do echo 'this is no GLSL' >>"$part"; done
expect_other "a broken shader is shown" "$edited" # the message lies over the pictures' upper part
if await same "$edited_below" lower_half; then pass "the last good picture stays"; else fail "the last good picture is gone"; fi
rm -rf shaders/* && cp "$shaders"/*.glsl shaders/
expect_same "the shader mended" "$opened"
quit "Ctrl+Q after a broken shader"

[ $failures -eq 0 ] || { echo "$failures failed"; exit 1; }
