#!/usr/bin/env bash
# Bakes and judges the numerical extremes: the tables and plots of docs/STRESS.md.
#
#   tests/stress_page.sh [--quick|--full] [--keep DIR] [-o FILE.md]
#
#   --quick, --full   as `reliefbake stress`
#   --keep            folder of stress.json; where it is there nothing is baked
#   -o                put the tables into FILE.md (tests/put_table.sh), and the plots into pictures/stress/ beside it
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

page='' extent=() results=''
while (($#)); do
    case $1 in
        --quick | --full) extent=("$1") ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,10s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
[[ -f $results/stress.json ]] || "$tool" stress ${extent[@]+"${extent[@]}"} -o "$results" >&2

definitions='def short: if . == 0 then "0" elif . >= 100 then (round | tostring) else (. as $x | (log10 | floor) as $e | pow(10; $e - 2) as $u | ($x / $u | round) * $u * 1e9 | round / 1e9 | tostring) end;
    def percent: if . == 0 then "0" else (. * 100 | short) + " %" end;'
useful_table() {
    printf '| encoding | 8 bits | 16 bits | half | float |\n| --- | ---: | ---: | ---: | ---: |\n'
    jq -r "$definitions"'
        ([.encodings[].slope] | max) as $most | .useful | group_by(.encoding)[] | . as $all |
        "| \(.[0].encoding) | " + (["8", "16", "half", "float"] | map(. as $bits | ($all[] | select(.bits == $bits).slope) | if . == 0 then "never" elif . >= $most * 0.99 then "all measured" else short end) | join(" | ")) + " |"' "$results/stress.json"
}
kept_table() {
    printf '| slope | ratio 8 | sqrt 8 | radius 8 | normal 8 | ratio 16 | sqrt 16 | radius 16 | normal 16 |\n| ---: |%s\n' "$(printf ' ---: |%.0s' {1..8})"
    jq -r "$definitions"'
        .encodings | group_by(.width)[] | . as $all | "| \(.[0].slope | short) | " + ([("8", "16") as $bits | ("ratio", "sqrt", "radius", "normal") as $e | $all[] | select(.encoding == $e and .bits == $bits) |
            "\(.kept | percent), \(.dead_share | percent)"] | join(" | ")) + " |"' "$results/stress.json"
}
cases_table() {
    printf '| case | bakes | judge | rays through | points in cones, doubles | points in cones, rationals | least tightness, float | dead at 8 bits: ratio, sqrt, radius, normal | steps, 8 bits sqrt | out of steps | tolerance |\n'
    printf '| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n'
    jq -r "$definitions"'
        def of($part; $all): if $all == 0 then "-" else "\($part) of \($all)" end;
        [.cases | to_entries[] | .value + {order: .key}] | group_by(.case) | sort_by(.[0].order)[] | . as $all |
        def sum(f): map(f // 0) | add;
        def dead($e): [$all[] | select(.bits == "8" and .encoding == $e).dead_share] | if length == 0 then "-" else (max | percent) end;
        ([.[] | select(.bits == "8" and .encoding == "sqrt" and .rays).rays]) as $plain |
        "| \(.[0].case) | \(length) | \([.[].judge] | unique | join(", ")) | \(of(sum(.rays.violated); sum(.rays.rays))) | \(of(sum(.doubles.violated); sum(.doubles.points))) | "
        + "\(of(sum(.exact.violated) + sum(.exact.undecided); sum(.exact.points))) | \([.[] | select(.bits == "float").tightness] | if length == 0 then "-" else (min | short) end) | \(dead("ratio")), \(dead("sqrt")), \(dead("radius")), \(dead("normal")) | "
        + (if $plain == [] then "- | - | -" else "\([$plain[].steps_mean] | max | short), \([$plain[].steps_max] | max) | \([$plain[].out_of_steps] | max | percent) | \([$all[].rays.tolerance // 0] | max | short)" end) + " |"' "$results/stress.json"
    jq -r '"\nreliefbake \(.version): \(.cases | length) bakes: \([.cases[].rays.rays // 0] | add) rays, \([.cases[].doubles.points] | add) points in doubles, \([.cases[].exact.points // 0] | add) in rational numbers; \(.violated) bakes do not hold."' "$results/stress.json"
}
useful_table | tee "$scratch/useful"
kept_table | tee "$scratch/kept"
cases_table | tee "$scratch/cases"

if [[ $page ]]; then
    pictures=$(dirname "$page")/pictures/stress
    mkdir -p "$pictures"
    cp "$results"/{kept,dead}.svg "$pictures"
    for table in useful kept cases; do "$here/put_table.sh" "$page" $table <"$scratch/$table"; done
fi
