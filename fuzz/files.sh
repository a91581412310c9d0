#!/bin/sh
# Runs the target `files` on every body, or on those named, SECONDS each, and prints rows for docs/hardening.md.
#
#     fuzz/files.sh SECONDS [BODY]…
#
# Corpora in fuzz/corpus/BODY begin with the seeds of `fuzz-files` and grow from run to run; what fails is left in
# fuzz/artifacts/BODY. Memory of a body is counted in what it asks for, without the sanitizer's share; `-rss_limit_mb`
# bounds both together, and is only a net.
set -eu
cd "$(dirname "$0")/.."
seconds=$1
shift
cargo build --quiet --release -p delone-filekit
cargo +nightly fuzz build files
[ $# -gt 0 ] || set -- $(target/release/fuzz-files --list)
for body; do
    corpus=fuzz/corpus/$body artifacts=fuzz/artifacts/$body
    log=$artifacts/log
    mkdir -p "$artifacts"
    target/release/fuzz-files --only "$body" --seeds-to "$corpus"
    DELONE_BODY=$body cargo +nightly fuzz run files "$corpus" -- -artifact_prefix="$artifacts/" \
        -max_total_time="$seconds" -timeout=10 -rss_limit_mb=6144 -print_final_stats=1 2>"$log" || true
    runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
    edges=$(grep -o 'cov: [0-9]*' "$log" | tail -n 1 | cut -c 6-)
    found=$(find "$artifacts" -type f ! -name log | wc -l)
    echo "| \`$body\` | $runs | $edges | $seconds | $found |"
done
