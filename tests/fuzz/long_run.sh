#!/usr/bin/env bash
# Builds the fuzzers (Clang) and runs them one after the other; a target stops at its first finding.
#   tests/fuzz/long_run.sh [-n EXECUTIONS] [-l LONGEST_INPUT] [-o FOLDER] [TARGET ...]
# Default: a million executions of every target, inputs of at most 4096 bytes, in build/fuzz/runs, where corpora grow
# from run to run. After it, a hundredth as many executions with inputs of up to 16 MiB. A finding lies in
# FOLDER/TARGET/found: `build/fuzz/tests/fuzz/fuzz_TARGET FILE` shows it. Once it is mended, it goes to
# tests/fuzz/regressions/TARGET, which every test run replays.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
executions=1000000 longest=4096 folder=$root/build/fuzz/runs
while getopts n:l:o: option; do
    case $option in
        n) executions=$OPTARG ;;
        l) longest=$OPTARG ;;
        o) folder=$OPTARG ;;
        *) exit 2 ;;
    esac
done
shift $((OPTIND - 1))

cd "$root"
[[ -f build/fuzz/build.ninja ]] || cmake --preset fuzz
nice -n 19 cmake --build --preset fuzz
programs=build/fuzz/tests/fuzz
targets=("$@")
if ((${#targets[@]} == 0)); then
    for program in "$programs"/fuzz_*; do
        [[ -L $program ]] && targets+=("${program##*/fuzz_}")
    done
fi

# What of libFuzzer's log the table needs: executions, edges when four fifths were done, edges at the end.
summary() {
    awk -v all="$2" '
        /^#[0-9]+/ && match($0, /cov: [0-9]+/) {
            done = substr($1, 2) + 0; edges = substr($0, RSTART + 5, RLENGTH - 5) + 0
            if (done <= 0.8 * all) early = edges
        }
        /stat::number_of_executed_units/ { done = $2 }
        END { print done + 0, early + 0, edges + 0 }' "$1"
}

# Short stacks of allocations, and no entropic schedule, which costs more than the readers do.
export ASAN_OPTIONS=malloc_context_size=2:quarantine_size_mb=8 UBSAN_OPTIONS=print_stacktrace=1
failed=0
row='%-10s %12s %14s %12s %10s %8s\n'
# shellcheck disable=SC2059
printf "$row" target executions "edges at 80 %" "at the end" findings seconds
for target in "${targets[@]}"; do
    here=$folder/$target
    mkdir -p "$here/corpus" "$here/found"
    "$programs/write_seeds" "$target" "$here/seeds"
    dictionary=tests/fuzz/dictionaries/$target.txt
    words=()
    [[ -f $dictionary ]] && words=("-dict=$dictionary")
    for pass in "$executions $longest" "$((executions / 100)) 16777216"; do
        read -r runs most <<<"$pass"
        log=$here/log-$most
        begin=$SECONDS
        found=0
        nice -n 19 "$programs/fuzz_$target" -runs="$runs" -max_len="$most" -timeout=20 -rss_limit_mb=2048 \
            -entropic=0 -report_slow_units=5 -print_final_stats=1 -artifact_prefix="$here/found/" "${words[@]}" \
            "$here/corpus" "$here/seeds" >"$log" 2>&1 || found=1
        failed=$((failed + found))
        read -r executed early edges <<<"$(summary "$log" "$runs")"
        # shellcheck disable=SC2059
        printf "$row" "$target" "$executed" "$early" "$edges" "$found" "$((SECONDS - begin))"
        ((found == 0)) || break
    done
done
exit $((failed > 0))
