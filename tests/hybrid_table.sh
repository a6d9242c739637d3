#!/usr/bin/env bash
# Hybrid cones from conservative to relaxed as delta grows: a table and a plot of docs/FAMILIES.md.
#
#   tests/hybrid_table.sh [--quick] [--rays N] [-o FILE.md]
#
#   --quick    few deltas, fewer rays
#   --rays     rays a map (default 50000)
#   -o         put the table into FILE.md (tests/put_table.sh), and the plot into pictures/hybrid.svg beside it (needs gnuplot)
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

rays=50000 page='' quick=''
while (($#)); do
    case $1 in
        --quick) quick=yes rays=6500 ;;
        --rays) rays=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,10s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
if [[ $page ]]; then command -v gnuplot >/dev/null || { echo "$this: needs gnuplot (apt install gnuplot-nox)" >&2 && exit 2; }; fi
set_heights bundled # both maps are
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

maps=(bevy_parallax_cube_depth_348.png pom_rocks_NM_height.tga) deltas=(0.002 0.005 0.01 0.02 0.05 0.1 0.2 0.5 1)
if [[ $quick ]]; then deltas=(0.05 1); fi

# measure NAME DELTA BAKE...: one line of JSON. March alone, as hybrid cones are meant for; then 10 steps and 8 halvings.
measure() {
    local name=$1 delta=$2
    shift 2
    quietly "$tool" "$@" "$heights/$name" "${source_options[@]}" -o "$scratch/map.exr" --quiet
    local march='' short=''
    march=$("$tool" verify "$scratch/map.exr" --technique cone --crop 0 --points 0 --rays "$rays" --steps 512 --json 2>/dev/null || (($? == 4)))
    short=$("$tool" verify "$scratch/map.exr" --technique relaxed --crop 0 --points 0 --rays "$rays" --steps 15 --json 2>/dev/null || (($? == 4)))
    jq -cn --arg map "$name" --arg delta "$delta" --argjson march "$march" --argjson short "$short" \
        '{map: $map, delta: $delta, steps: $march.steps_mean, deep: $march.missed, mse: $march.mse, missed: $short.missed, early: $short.early, mse15: $short.mse}'
}

for name in "${maps[@]}"; do
    set_source_options "$name"
    measure "$name" conservative cone
    for delta in "${deltas[@]}"; do measure "$name" "$delta" cone --kind hybrid --delta "$delta"; done
    measure "$name" 'relaxed, strict' cone --kind relaxed
done >"$scratch/lines"

{
    printf '## Hybrid: from conservative to relaxed\nThe march alone, until the ray arrives: its mean steps, and its error, which delta allows; `deeper`: rays that end more than delta below the first surface met. Then GPU Gems 3'\''s 15 steps and 8 halvings.\n\n'
    printf '| map | delta | steps, mean | mse | deeper | 15 steps and 8 halvings: missed | early | mse |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n'
    jq -r 'def percent: "\(. * 1e6 | round / 1e4) %"; def exponent: if . == 0 then "0" else (log10 | floor) as $e | "\(. / pow(10; $e) * 100 | round / 100)e\($e)" end;
        "| \(.map) | \(.delta) | \(.steps * 10 | round / 10) | \(.mse | exponent) | \(.deep | percent) | \(.missed | percent) | \(.early | percent) | \(.mse15 | exponent) |"' "$scratch/lines"
} | tee "$scratch/table"
[[ $page ]] || exit 0

mkdir -p "$(dirname "$page")/pictures"
for name in "${maps[@]}"; do # the ends at deltas that a logarithmic axis has
    jq -r --arg name "$name" 'select(.map == $name) | [(if .delta == "conservative" then 0.001 elif .delta == "relaxed, strict" then 2 else .delta end), .steps, .mse] | @tsv' \
        "$scratch/lines" >"$scratch/$name.dat"
done
{
    cat <<'END'
set terminal svg size 720,320 font "sans,12" background "white"
set logscale x
set xlabel "delta"
set xtics ("conservative" 0.001, "0.002" 0.002, "0.005" 0.005, "0.01" 0.01, "0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1, "relaxed" 2) rotate by 30 right
set xrange [0.0009:2.3]
set ylabel "steps, mean"
set y2label "mse of the march alone"
set ytics nomirror
set yrange [0:*]
set y2tics
set format y2 "%.0e"
set logscale y2
set key outside top horizontal
END
    printf 'plot '
    for name in "${maps[@]}"; do
        printf '"%s" using 1:2 with linespoints title "%s: steps", "" using 1:3 axes x1y2 with linespoints dashtype 2 title "mse", ' "$scratch/$name.dat" "${name//_/ }"
    done
    echo
} | sed 's/, $//' >"$scratch/plot.gp"
SOURCE_DATE_EPOCH=0 gnuplot "$scratch/plot.gp" >"$(dirname "$page")/pictures/hybrid.svg"
"$here/put_table.sh" "$page" hybrid <"$scratch/table"
