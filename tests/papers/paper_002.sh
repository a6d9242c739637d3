#!/usr/bin/env bash
# Figures 2 and 3 and Table I of 002 (Chen & Chuang, anisotropic cone mapping), measured anew: tables and plots of docs/PAPERS.md.
#
#   tests/papers/paper_002.sh [--quick] [-o FILE.md]
#
#   --quick   one small map, fewer rays and repeats, no plots
#   -o        put the tables into FILE.md (tests/put_table.sh), and the plots into pictures/papers/ beside it (needs gnuplot)
#
# Published: histograms of a brick texture (fig. 2), error and frames a second at 10 to 50 steps (fig. 3), seconds for maps of 128 x 128 (Table I). Ours: cones of `explain --histogram`, rays of
# `tradeoff`, times of `bench cone` and `bench dynamic`, one thread.
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/../families.sh"
source "$(dirname "$0")/draw_curves.sh"

page='' quick='' rays=60000 repeat=5 frames=20
while (($#)); do
    case $1 in
        --quick) quick=yes rays=7000 repeat=1 frames=2 ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,12s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
if [[ $page ]]; then command -v gnuplot >/dev/null || { echo "$this: needs gnuplot (apt install gnuplot-nox)" >&2 && exit 2; }; fi
set_heights bundled
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
names=(ambientcg_RoofingTiles009_512.png pom_rocks_NM_height.tga bevy_parallax_cube_depth_348.png gz_dem_squared_129.tif)
if [[ $quick ]]; then names=("${names[@]:3}"); fi

# Figure 2. bake NAME KIND OPTIONS...: writes $scratch/NAME.KIND.exr.
bins=50
count() {
    local name=$1 kind=$2
    shift 2
    set_source_options "$name"
    quietly "$tool" "$@" "$heights/$name" "${source_options[@]}" --wrap repeat --encoding ratio --bits float --cone-max 1000 -o "$scratch/$name.$kind.exr" --quiet
    "$tool" explain "$scratch/$name.$kind.exr" --json --histogram $bins | jq -c .ratio_histogram >"$scratch/$name.$kind"
}
{
    echo '| map | one cone: mean ratio, below 0.25 | mean of four sectors | widest of four | above 1: one cone, widest of four |'
    echo '| --- | ---: | ---: | ---: | ---: |'
    for name in "${names[@]}"; do
        count "$name" one cone
        count "$name" four acm --sectors 4
        jq -rn --arg name "$name" --slurpfile one "$scratch/$name.one" --slurpfile four "$scratch/$name.four" '
            def total: (.counts | add) + .wider; def percent: . * 1000 | round / 10 | "\(.) %";
            def low: ([.counts[:('$bins' / 4 | floor)][]] | add) / total;
            def mean: [.counts, (.counts | keys)] | transpose | (map(.[0] * (.[1] + 0.5) / '$bins') | add);
            def capped: (mean + .wider) / total | . * 1000 | round / 1000;
            "| \($name) | \($one[0].each | "\(capped), \(low | percent)") | \($four[0].mean | "\(capped), \(low | percent)") | \($four[0].widest | "\(capped), \(low | percent)") | \($one[0].each | .wider / total | percent), \($four[0].widest | .wider / total | percent) |"'
    done
} | tee "$scratch/figure-2"
for name in "${names[@]:0:1}"; do
    jq -r --arg bins $bins '.each | .wider as $wider | ((.counts | add) + $wider) as $all | .counts | to_entries[] | "one cone\t\((.key + 0.5) / ($bins | tonumber))\t\(.value * 100 / $all)"' "$scratch/$name.one"
    jq -r --arg bins $bins '(["mean", "mean of four"], ["widest", "widest of four"]) as [$key, $title] | .[$key] | .wider as $wider | ((.counts | add) + $wider) as $all | .counts | to_entries[] | "\($title)\t\((.key + 0.5) / ($bins | tonumber))\t\(.value * 100 / $all)"' "$scratch/$name.four"
done >"$scratch/figure-2-curves"

# Figure 3.
axes=(--techniques cone,sectors-4,sectors-8 --steps 10,20,30,40,50 --encodings ratio --bits 16 --resolutions 1 --tolerances 0.001 --rays "$rays" --repeat $([[ $quick ]] && echo 1 || echo 3))
for name in "${names[@]}"; do
    set_source_options "$name"
    options=("${source_options[@]}")
    quietly "$tool" tradeoff "$heights/$name" "${options[@]}" --wrap repeat "${axes[@]}" -o "$scratch/sweep-$name" >/dev/null
done
rows='def exponent: if . == 0 then "0" else (log10 | floor) as $e | "\(. / pow(10; $e) * 100 | round / 100)e\($e)" end; def short: . * 100 | round / 100;'
{
    echo '| map | steps at most | root mean square error: one cone, 4 sectors, 8 sectors | steps, mean | texture reads | processor time over that of one cone, 10 steps |'
    echo '| --- | ---: | ---: | ---: | ---: | ---: |'
    for name in "${names[@]}"; do
        jq -r --arg name "$name" "$rows"'.inputs[0].measurements as $all
            | def of($steps): [("cone", "sectors-4", "sectors-8") as $m | $all[] | select(.method == $m and .candidate.steps == $steps) | .figures];
            of(10)[0].cpu_ms_per_frame as $first
            | (10, 20, 30, 40, 50) as $steps | of($steps) as $three
            | "| \($name) | \($steps) | \($three | map(.mse | sqrt | exponent) | join(", ")) | \($three | map(.steps_mean | short) | join(", ")) | \($three | map(.fetches_mean | short) | join(", ")) | \($three | map(.cpu_ms_per_frame / $first | short) | join(", ")) |"' "$scratch/sweep-$name/tradeoff.json"
    done
} | tee "$scratch/figure-3"
jq -r '.inputs[0].measurements[] | "\({"cone": "one cone", "sectors-4": "4 sectors", "sectors-8": "8 sectors"}[.method])\t\(.figures.cpu_ms_per_frame)\t\(.figures.mse | sqrt)"' "$scratch/sweep-${names[0]}/tradeoff.json" >"$scratch/figure-3-curves"

# Table I, on the middle of the maps; and moving water (fig. 7).
{
    echo '| map, 4 sectors | published, s: original, adaptive | speed-up | ours, ns/texel: ring search, Algorithm 1, exact | speed-up | exact over the ring search | too wide |'
    echo '| --- | ---: | ---: | ---: | ---: | ---: | ---: |'
    published=('brick: 0.195, 0.017 | 11.5' 'rockwall: 0.186, 0.014 | 13.3' 'stone: 0.08, 0.013 | 6.2')
    for k in "${!names[@]}"; do
        name=${names[$k]}
        set_source_options "$name"
        "$tool" bench cone "$heights/$name" "${source_options[@]}" --sectors 4 --adaptive 3 --similarity 0.05 --threads 1 --repeat $repeat --json 2>/dev/null |
            jq -r --arg name "$name" --arg published "${published[$k]:- | }" 'def short: if . < 10 then . * 10 | round / 10 else round end;
                "| \($name), \(.width) x \(.height) | \($published) | \([.adaptive[0].ns_per_texel, .adaptive[1].ns_per_texel, .search_ns_per_texel] | map(round | tostring) | join(", ")) | \(.adaptive[0].ns_per_texel / .adaptive[1].ns_per_texel | short) | \(.adaptive[0].ns_per_texel / .search_ns_per_texel | short) | \(.adaptive[1].too_wide * 1000 | round / 10) % |"'
    done
    printf '\nMoving water, 128 x 128, one thread, maps a second (published: about 50 frames with drawing): '
    "$tool" bench dynamic --size 128 --frames $frames --threads 1 --json | jq -r '"exact \(.exact_maps_per_second * 10 | round / 10), Algorithm 1 \(.adaptive_maps_per_second * 10 | round / 10), ring search \(.ring_search_maps_per_second * 100 | round / 100)."'
} | tee "$scratch/table"

if [[ $page ]]; then
    "$here/put_table.sh" "$page" 002-figure-2 <"$scratch/figure-2"
    "$here/put_table.sh" "$page" 002-figure-3 <"$scratch/figure-3"
    "$here/put_table.sh" "$page" 002-table <"$scratch/table"
    pictures=$(dirname "$page")/pictures/papers
    mkdir -p "$pictures"
    draw_curves "$scratch/figure-2-curves" "$pictures/002-figure-2.svg" 'cone ratio' 'texels, %'
    draw_curves "$scratch/figure-3-curves" "$pictures/002-figure-3.svg" 'processor time, milliseconds a frame' 'root mean square error' 'set logscale y' 'set format y "%.0e"'
fi
