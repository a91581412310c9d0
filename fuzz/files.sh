#!/bin/bash
# Runs the target `files` on every body, or on those named, for SECONDS of processor time each, and prints rows for
# docs/hardening.md.
#
#     fuzz/files.sh SECONDS [BODY]…
#
# Corpora in fuzz/corpus/BODY begin with the seeds of `fuzz-files` and grow from run to run; what fails is left in
# fuzz/artifacts/BODY. Memory of a body is counted in what it asks for, without the sanitizer's share; `-rss_limit_mb`
# bounds both together, and is only a net.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=$1
shift

# Sets `used` to what children have had of the processor so far, in seconds. `times` in a subshell would tell of its own.
measure() {
    times >"$artifacts/times"
    used=$(awk 'NR == 2 { split($1 " " $2, t, /[ms ]+/); printf "%d", (t[1] + t[3]) * 60 + t[2] + t[4] }' "$artifacts/times")
}

cargo build --quiet -p delone-filekit
cargo +nightly fuzz build files
[ $# -gt 0 ] || set -- $(target/debug/fuzz-files --list)
for body; do
    corpus=fuzz/corpus/$body artifacts=fuzz/artifacts/$body
    mkdir -p "$artifacts"
    rm -f "$artifacts/log"
    target/debug/fuzz-files --only "$body" --seeds-to "$corpus"
    measure
    begin=$used spent=0 failed=
    # The fuzzer counts seconds of the clock: on a busy machine it has to be asked again.
    until [ "$spent" -ge "$seconds" ] || [ "$failed" ]; do
        DELONE_BODY=$body cargo +nightly fuzz run files "$corpus" -- -artifact_prefix="$artifacts/" \
            -max_total_time="$((seconds - spent))" -timeout=10 -rss_limit_mb=6144 -print_final_stats=1 \
            2>>"$artifacts/log" || failed=yes
        measure
        spent=$((used - begin))
    done
    runs=$(awk '/^stat::number_of_executed_units:/ { sum += $2 } END { print sum + 0 }' "$artifacts/log")
    edges=$(grep -o 'cov: [0-9]*' "$artifacts/log" | tail -n 1 | cut -c 6-)
    found=$(find "$artifacts" -type f ! -name log ! -name times | wc -l)
    echo "| \`$body\` | $runs | $edges | $spent | $found |"
done
