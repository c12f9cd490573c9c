#!/usr/bin/env bash
# Runs a command, and interrupts it as Ctrl+C does once its standard error matches a pattern:
# interrupted.sh PATTERN COMMAND...
set -m # a job of its own, or it would ignore the signal
pattern=$1
shift
said=$(mktemp)
"$@" 2>"$said" &
until grep -q "$pattern" "$said" || ! kill -0 $! 2>/dev/null; do sleep 0.05; done
kill -INT $! 2>/dev/null
wait $!
code=$?
cat "$said" >&2
rm "$said"
exit $code
