#!/usr/bin/env bash
# Sweeps techniques, steps, bits, encodings, tolerances and resolutions on four maps: the tables and plots of docs/TRADEOFF.md.
#
#   tests/tradeoff_page.sh [--quick] [--rays N] [--keep DIR] [-o FILE.md]
#
#   --quick   one bundled map, `tradeoff --quick`
#   --rays    rays a candidate (default 28000)
#   --keep    folder of the sweep; what it holds is not measured again
#   -o        put the tables into FILE.md (tests/put_table.sh), and the plots into pictures/tradeoff/ beside it
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

rays=28000 page='' quick='' results=''
while (($#)); do
    case $1 in
        --quick) quick=yes ;;
        --rays) rays=$2 && shift ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,11s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"
set_close_maps
((${#maps[@]})) || maps=("$here/data/heights/gz_dem_squared_129.tif")

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
axes=(--refinements 8 --bits 16,8 --encodings sqrt,ratio --resolutions 1,0.5 --tolerances 0.001,0.1 --rays "$rays" --repeat 1)
[[ ! $quick ]] || axes=(--quick)
quietly "$tool" tradeoff "${maps[@]}" "${axes[@]}" -o "$results" >&2

# What each method needs to come under an error, and what the other axes change at 32 steps.
definitions='def short: if . == null then "-" elif . == 0 then "0" elif . >= 10 then (round | tostring) else (. as $x | ($x | log10 | floor) as $e | pow(10; $e - 1) as $u | ($x / $u | round) * $u * 1e9 | round / 1e9 | tostring) end;
    def percent: if . == 0 then "0" else (. * 100 | short) + " %" end;
    def least($cost; $error): map(select(.figures.error_mean <= $error)) | min_by(.figures[$cost]);'
needs() {
    printf '## What an error costs\nOf each method at 16 bits (sqrt), among 8, 16, 32, 64, 128 steps: the cheapest with a mean height error of at most 1/256, and of at most 1/4096, of the depth. A dash: none.\n\n'
    jq -r "$definitions"'
        .inputs[] | "### \(.input | split("/") | last)\n\n| technique | bytes a texel | 1/256: steps, fetches, instructions, missed | 1/4096: steps, fetches, instructions, missed |\n| --- | ---: | ---: | ---: |",
        (.measurements | map(select(.base)) | group_by(.method) | sort_by(least("fetches_mean"; 1/256).figures.fetches_mean // 1e9)[] | . as $all |
            "| \(.[0].method) | \(.[0].figures.bytes_per_texel | short) | " + ([1/256, 1/4096] | map(. as $e | $all | least("fetches_mean"; $e) |
                if . == null then "-" else "\(.candidate.steps): \(.figures.steps_mean | short), \(.figures.fetches_mean | short), \(.figures.instructions | if . == 0 then "-" else short end), \(.figures.missed | percent)" end) | join(" | ")) + " |"), ""' "$results/tradeoff.json"
}
axes_table() {
    printf '## What the other axes change\nCone stepping and strict relaxed cones, 32 steps; one axis at a time.\n\n| map | technique | changed | bytes a texel | bake, s | fetches | missed | early | mean error | 1 - SSIM |\n| --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n'
    jq -r "$definitions"'
        .inputs[] | (.input | split("/") | last) as $map | .measurements[] | select((.method == "cone" or .method == "relaxed") and .candidate.steps == 32) |
        (.candidate | [if .bits != "16" then "\(.bits) bits" else empty end, if .encoding != "sqrt" then .encoding else empty end,
            if .resolution != 1 then "resolution \(.resolution)" else empty end, if .tolerance != 0.001 then "tolerance \(.tolerance)" else empty end] | join(", ")) as $changed |
        "| \($map) | \(.method) | \(if $changed == "" then "-" else $changed end) | \(.figures | "\(.bytes_per_texel | short) | \(.bake_seconds | short) | \(.fetches_mean | short) | \(.missed | percent) | \(.early | percent) | \(.error_mean | short) | \(.dissimilarity | short)") |"' "$results/tradeoff.json"
}
# Beginning, middle and end of the front of fetches.
pictures_table() {
    printf '| map | candidate | fetches, mean error | picture | distance from the exact hit |\n| --- | --- | ---: | --- | --- |\n'
    jq -r "$definitions"'
        .inputs[] | select((.input | test("Roof|metal|gz_dem"))) | (.input | split("/") | last) as $map | .pictures as $folder | .measurements as $all | .fronts.fetches | [.[1], .[length / 2 | floor], .[-1]][] as $id |
        ($all[] | select(.candidate.id == $id).figures) as $f |
        "\($folder)/\($id)|| \($map) | \($id) | \($f.fetches_mean | short), \($f.error_mean | short) |"' "$results/tradeoff.json" | while IFS='|' read -r file _ row; do
        local name
        name=${row%%.*} name=${name//[ |]/}-${file##*/}
        [[ ! $page ]] || { cp "$results/$file.png" "$pictures/$name.png" && cp "$results/$file-error.png" "$pictures/$name-error.png"; }
        printf '|%s ![its picture](pictures/tradeoff/%s.png) | ![its error](pictures/tradeoff/%s-error.png) |\n' "$row" "$name" "$name"
    done
}
if [[ $page ]]; then
    pictures=$(dirname "$page")/pictures/tradeoff
    rm -rf "$pictures" && mkdir -p "$pictures"
    cp "$results"/*-{steps,fetches,instructions,time}.svg "$pictures"
fi
needs | tee "$scratch/needs"
axes_table | tee "$scratch/axes"
pictures_table | tee "$scratch/pictures"

if [[ $page ]]; then
    "$here/put_table.sh" "$page" pictures <"$scratch/pictures"
    "$here/put_table.sh" "$page" needs <"$scratch/needs"
    "$here/put_table.sh" "$page" axes <"$scratch/axes"
fi
