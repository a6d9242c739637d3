#!/usr/bin/env bash
# Times the distance transform beside the textbook's, OpenCV's and SciPy's, and prints the table of docs/SHAPES.md. Wants a quiet machine.
# Exit code 4: our distances differ from the textbook's somewhere.
#
#   tests/shape_speed.sh [--sizes "1024 4096"] [--threads "1 2"] [--repeat N] [--full] [-o FILE.md]
#
#   --full   only compare with the textbook's at 32768 x 32768, one run (14 GB of memory, a quarter of an hour)
#   -o       put the table into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY   the tool (default build/release/bin/reliefbake)
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
sizes="1024 2048 4096 8192 16384" threads="1 2" repeat=5 table=
while (($#)); do
    case $1 in
        --sizes) sizes=$2 && shift ;;
        --threads) threads=$2 && shift ;;
        --repeat) repeat=$2 && shift ;;
        --full) exec "$tool" bench shape --size 32768 --repeat 1 --plain ;;
        -o) table=$2 && shift ;;
        *) sed -n '2,11s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
command -v jq >/dev/null || { echo "shape_speed: needs jq (apt install jq)" >&2 && exit 2; }
[[ -x $tool ]] || { echo "shape_speed: no $tool: build first, or set RELIEFBAKE_BINARY" >&2 && exit 2; }

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for size in $sizes; do
    for count in $threads; do
        "$tool" bench shape --size "$size" --threads "$count" --repeat "$repeat" --plain --peers --json >>"$scratch/runs"
    done
done
jq -rs '
    def two: . * 100 | round / 100;
    def mean: (map(log) | add / length | exp);
    "| side | threads | ours: blobs, lines, pixel, diagonal; dots | mean of four | fresh output | GB/s; a copy | others: mean of four, times ours, wrong pixels |",
    "| ---: | ---: | --- | ---: | ---: | --- | --- |",
    (.[] | . as $run | .results as $r | [
        .size, .threads,
        (([$r[0:4][].ns_per_pixel | two | tostring] | join(", ")) + "; \($r[4].ns_per_pixel | two)"),
        (.geometric_mean_ns_per_pixel.ours | two),
        ([$r[0:4][].fresh_ns_per_pixel] | mean | two),
        "\([$r[0:4][].gb_per_second] | mean | two); \([$r[0:4][].copy_gb_per_second] | mean | two)",
        ([range($r[0].peers | length) as $k | $r[0].peers[$k].name as $name | $run.geometric_mean_ns_per_pixel[$name] |
            "\($name): \(two), \(. / $run.geometric_mean_ns_per_pixel.ours | two) x, \([$r[].peers[$k].wrong] | max | . * 1e4 | round / 100) %"] | join("; "))
    ] | map(tostring) | "| " + join(" | ") + " |")' "$scratch/runs" | tee "$scratch/table"
if [[ $table ]]; then "$here/put_table.sh" "$table" <"$scratch/table"; fi
