#!/bin/bash
# Runs the window under a virtual X server and works it by mouse and keyboard.
# usage: window_test.sh PROGRAM SHADERS_FOLDER          exit 77: a tool is missing, nothing was tested
# Rows of the panel have the same height with any font (16-pixel text), so places are fixed.
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
pictures() { import -window root -crop 900x570+360+60 +repage rgb:- | md5sum; }
upper_half() { import -window root -crop 900x270+360+60 +repage rgb:- | md5sum; } # above an open tab
lower_half() { import -window root -crop 900x270+360+360 +repage rgb:- | md5sum; }
# Waits until the pictures are the same as, or other than, HASH; at most 20 s.
await() { # same|other HASH
    for _ in $(seq 100); do
        now=$(pictures)
        if { [ "$1" = same ] && [ "$now" = "$2" ]; } || { [ "$1" = other ] && [ "$now" != "$2" ]; }; then return 0; fi
        sleep 0.2
    done
    return 1
}
# Waits until nothing changes any more, then prints the pictures' hash.
settled() {
    local before now
    before=$(pictures)
    while sleep 0.3; now=$(pictures); [ "$now" != "$before" ]; do before=$now; done
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
colors=$(import -window root -crop 900x570+360+60 +repage -format '%k' info:)
if [ "$colors" -gt 1000 ]; then pass "opens on a picture"; else fail "opens on a picture: $colors colours: $(cat out.txt)"; fi

xdotool mousemove 291 106 click 1 # A: flat
expect_other "a toggle by mouse" "$opened"
xdotool key ctrl+z
expect_same "undo" "$opened"
xdotool key ctrl+shift+z
expect_other "redo" "$opened"
xdotool key ctrl+z
expect_same "undo again" "$opened"
xdotool key m
expect_other "a model by keyboard" "$opened"
xdotool key ctrl+z
expect_same "undo of a model" "$opened"

xdotool key k
expect_other "the masks" "$opened"
xdotool key k
expect_same "the pictures without masks" "$opened"

for y in 603 628 653 678; do # the first light's diffuse; a model or a kind of light more moves the sliders down
    drag 216 $y 290 $y
    [ "$(settled)" != "$opened" ] && break
done
expect_other "a slider" "$opened"
settled >/dev/null
xdotool key ctrl+z
expect_same "one undo takes a whole drag back" "$opened"

drag 600 300 700 330
expect_other "orbit" "$opened"
settled >/dev/null
xdotool key r
expect_same "camera as opened" "$opened"
xdotool mousemove 600 300 click 4
expect_other "dolly" "$opened"
xdotool mousemove 600 300 click --repeat 2 --delay 60 1
expect_same "a double click brings the camera back" "$opened"

xdotool key 2
expect_other "wipe" "$opened"
wipe=$(settled)
drag 816 400 1000 400
divider_at=1000
expect_other "the divider" "$wipe"
xdotool key 3
flip=$(settled)
xdotool keydown space
expect_other "flip while Space is held" "$flip"
xdotool keyup space
expect_same "flip back" "$flip"
xdotool key 4
expect_other "difference" "$flip"
xdotool key 1
expect_same "side by side again" "$opened"

xdotool key F12
for _ in $(seq 100); do [ -s three-point-lights-001.png.json ] && break; sleep 0.1; done
xdotool key F12
for _ in $(seq 100); do [ -s three-point-lights-002.png.json ] && break; sleep 0.1; done
if cmp -s three-point-lights-001.png three-point-lights-002.png; then pass "captures"; else fail "captures: $(ls)"; fi
if "$program" capture three-point-lights-001.png.json --out again.png && cmp -s again.png three-point-lights-001.png
then pass "the sidecar gives the same picture"; else fail "the sidecar gives another picture"; fi

xdotool key 2
expect_other "wipe again" "$opened"
settled >/dev/null
drag "$divider_at" 400 700 400
wipe=$(settled)
xdotool key F12
for _ in $(seq 100); do [ -s three-point-lights-003.png.json ] && break; sleep 0.1; done
xdotool key 1
expect_same "side by side after a wipe" "$opened"

xdotool key s
expect_other "the tab of the extreme cases" "$opened"
settled >/dev/null
above=$(upper_half)
xdotool mousemove 420 483 click 1 # some case of the list
settled >/dev/null
if [ "$(upper_half)" != "$above" ]; then pass "a click opens a case"; else fail "a click opens no case"; fi
xdotool key ctrl+z
xdotool key s
expect_same "undo and folding bring the scene back" "$opened"

window=$(xdotool search --name 'Shading Sandbox' | head -1)
for size in "800 500" "480 320" "1280 720"; do
    # shellcheck disable=SC2086
    xdotool windowsize "$window" $size
    settled >/dev/null
done
expect_same "resized and back" "$opened"
quit "Ctrl+Q"

start three-point-lights-001.png.json
expect_same "a sidecar restores the view" "$opened"
quit "Ctrl+Q of a sidecar"

start three-point-lights-003.png.json
expect_same "a wipe's sidecar restores its divider" "$wipe"
quit "Ctrl+Q of a wipe"

# A named technique replaces all that a sidecar says of A, a textbook's picture too.
sed 's/"layout"/"textbook_left": true, "layout"/' three-point-lights-001.png.json >textbook.json
start view textbook.json --left flat/lambert --right per-pixel/phong
xdotool key F12
for _ in $(seq 100); do [ -s textbook-001.png.json ] && break; sleep 0.1; done
if tr -d ' \n' <textbook-001.png.json | grep -q '"techniques":\["flat/lambert","per-pixel/phong"\]' &&
    ! grep -q textbook_left textbook-001.png.json
then pass "view --left --right"; else fail "view --left --right: $(head -20 textbook-001.png.json)"; fi
quit "Ctrl+Q of named techniques"

# The tab "Error vs run time". Its buttons stand in one line, whose places hold for fonts a little wider or narrower.
run_button="474 405"
export_button="528 405" # the progress bar, while it runs
start box-1-colour
without_tab=$(settled)
xdotool key e
expect_other "a tab opens" "$without_tab"
# shellcheck disable=SC2086
xdotool mousemove $run_button click 1
for _ in $(seq 60); do
    sleep 0.5
    # shellcheck disable=SC2086
    xdotool mousemove $export_button click 1
    [ -s box-1-colour-report-001/report.csv ] && break # the last of the three
done
without_times() { cut -d, -f1-8,12-15,21-44 "$1"; } # the renderer's name holds a comma
"$program" report box-1-colour --quick --out by-command >/dev/null 2>&1
if [ -s by-command/report.csv ] &&
    [ "$(without_times by-command/report.csv)" = "$(without_times box-1-colour-report-001/report.csv)" ]
then pass "the tab measures what the command measures"; else fail "the tab measures something else: $(ls; cat out.txt)"; fi
if "$program" report --merge box-1-colour-report-001/report.json --out merged >/dev/null 2>&1
then pass "its report.json can be read"; else fail "its report.json cannot be read"; fi
xdotool key e
expect_same "the panel folds" "$without_tab"
quit "Ctrl+Q after a measurement"

start
xdotool key e
settled >/dev/null
# shellcheck disable=SC2086
xdotool mousemove $run_button click 1
sleep 1
quit "Ctrl+Q while it measures"

cp -r "$shaders" shaders
start --shaders shaders
expect_same "shaders from disk" "$opened"
sed -i 's/gl_Position = \(.*\);/gl_Position = \1;\n    gl_Position.x *= 0.5;/' shaders/*.glsl
expect_other "an edited shader reloads" "$opened"
edited=$(settled)
edited_below=$(lower_half)
for part in shaders/*.glsl; do echo 'this is no GLSL' >>"$part"; done
expect_other "a broken shader is shown" "$edited" # the message lies over the pictures' upper part
if [ "$(lower_half)" = "$edited_below" ]; then pass "the last good picture stays"; else fail "the last good picture is gone"; fi
rm -rf shaders/* && cp "$shaders"/*.glsl shaders/
expect_same "the shader mended" "$opened"
quit "Ctrl+Q after a broken shader"

[ $failures -eq 0 ] || { echo "$failures failed"; exit 1; }
