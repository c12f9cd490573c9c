#!/usr/bin/env bash
# Runs a command that opens a window, under an X server that ends when the window is there: lost_display.sh COMMAND...
# -noreset: it would begin anew, and refuse whoever comes meanwhile, each time that xdotool leaves it alone.
number=$(mktemp)
Xvfb -displayfd 3 -noreset -screen 0 1280x720x24 3>"$number" >/dev/null 2>&1 &
server=$!
until [[ -s $number ]] || ! kill -0 $server 2>/dev/null; do sleep 0.05; done
export DISPLAY=:$(<"$number")
rm "$number"
"$@" &
command=$!
until xdotool search --onlyvisible --name 'Shading Sandbox' >/dev/null 2>&1 || ! kill -0 $command 2>/dev/null; do
    sleep 0.1
done
sleep 0.5 # the window rests
kill $server
wait $command
