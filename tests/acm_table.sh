#!/usr/bin/env bash
# 002's Table I again: its original ring search, its Algorithm 1 and our exact search bake the same sectors. A table of docs/FAMILIES.md.
#
#   tests/acm_table.sh [--quick] [-o FILE.md]
#
#   --quick    two bundled maps, few options
#   -o         put the tables into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

page='' quick=''
while (($#)); do
    case $1 in
        --quick) quick=yes ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,9s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

maps=() options=('3 0.05') repeat=1 frames=3
for name in pom_four_NM_height.tga pom_rocks_NM_height.tga pom_saint_NM_height.tga pom_stones_NM_height.tga gz_dem_squared_129.tif terrain3d_brush_stones_half.exr \
    bevy_parallax_cube_depth_348.png; do
    [[ ! -f $heights/$name ]] || maps+=("$heights/$name")
done
if [[ $quick ]]; then maps=("${maps[@]:0:2}")
else
    options=('1 0.05' '2 0.05' '3 0.01' '3 0.02' '3 0.05' '3 0.1' '4 0.05') repeat=5 frames=20
fi

# missed PATH SECTORS LEVELS SIMILARITY: share of rays that pass through the relief of the map that `acm --method adaptive` writes.
missed() {
    quietly "$tool" acm "$1" "${source_options[@]}" --sectors "$2" --method adaptive --levels "$3" --similarity "$4" -o "$scratch/adaptive.exr" --quiet
    { "$tool" verify "$scratch/adaptive.exr" --crop 0 --rays 26000 --points 0 --json 2>/dev/null || (($? == 4)); } | jq .missed
}

# measure PATH LEVELS SIMILARITY SECTORS: one line of JSON.
measure() {
    local path=$1 levels=$2 similarity=$3 sectors=$4 by_rings by_adaptive
    set_source_options "$path"
    by_rings=$(missed "$path" "$sectors" 0 "$similarity")
    by_adaptive=$(missed "$path" "$sectors" "$levels" "$similarity")
    quietly "$tool" bench cone "$path" "${source_options[@]}" --sectors "$sectors" --adaptive "$levels" --similarity "$similarity" --threads 1 --repeat $repeat --json |
        jq -c --arg map "${path##*/}" --argjson levels "$levels" --argjson similarity "$similarity" --argjson sectors "$sectors" --argjson missed "[$by_rings, $by_adaptive]" '
            {map: $map, levels: $levels, similarity: $similarity, sectors: $sectors, size: "\(.width)x\(.height)", exact: .search_ns_per_texel,
             ring: .adaptive[0].ns_per_texel, adaptive: .adaptive[1].ns_per_texel, too_wide: .adaptive[1].too_wide, missed: $missed}'
}

columns='def ratio: if . < 10 then . * 10 | round / 10 else round end; def percent: . * 1e4 | round / 100;
    def columns: "\(.exact | round) | \(.ring | round) | \(.adaptive | round) | \(.ring / .adaptive | ratio) | \(.ring / .exact | ratio) | \(.adaptive / .exact | ratio) | \(.too_wide | percent) % | \(.missed | map("\(percent) %") | join(", ")) |";'
heads='exact, ns/texel | ring search | Algorithm 1 | Algorithm 1 is faster than the ring search | exact is, than the ring search | exact is, than Algorithm 1 | cones of Algorithm 1 too wide | rays missed: ring search, Algorithm 1 |'
rule='---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |'
{
    printf '## Sectors: the published adaptive method\n`bench cone MAP --sectors N --adaptive LEVELS --similarity S --threads 1`, %s. Too wide: cones that hold the texel centre that limits those of the ring search. Missed: rays of `verify` over the maps of `acm --method adaptive` (levels 0: the ring search, whose cones hold at texel centres alone); the exact method misses none.\n\n' "$(machine)"
    printf '| map | size | sectors | %s\n| --- | --- | ---: | %s\n' "$heads" "$rule"
    for path in "${maps[@]}"; do
        for sectors in 4 8; do measure "$path" 3 0.05 "$sectors"; done
    done >"$scratch/lines"
    jq -r "$columns"' "| \(.map) | \(.size) | \(.sectors) | \(columns)"' "$scratch/lines"
    jq -rs 'map(.ring / .adaptive) as $a | map(.ring / .exact) as $e | def r: . * 10 | round / 10;
        "\nAlgorithm 1 over the ring search: \($a | min | r) to \($a | max | r) times (published, Table I: 6.2 to 13.3). The exact method over the ring search: \($e | min | r) to \($e | max | r) times."' "$scratch/lines"
    if [[ ! $quick ]]; then
        path=$heights/pom_rocks_NM_height.tga
        printf '\n%s with other options, 4 sectors:\n\n| levels | similarity | %s\n| ---: | ---: | %s\n' "${path##*/}" "$heads" "$rule"
        for option in "${options[@]}"; do measure "$path" ${option% *} ${option#* } 4; done | jq -r "$columns"' "| \(.levels) | \(.similarity) | \(columns)"'
    fi
    printf '\n### Moving water\n`bench dynamic --size N`: maps a second, 4 sectors, one thread (002, fig. 7: about 50 a second with drawing, Algorithm 1, on a Pentium 4).\n\n'
    printf '| size | exact | Algorithm 1 | ring search |\n| ---: | ---: | ---: | ---: |\n'
    for size in 128 256; do
        "$tool" bench dynamic --size $size --frames $frames --threads 1 --json
    done | jq -r 'def rate: if . < 10 then . * 100 | round / 100 else . * 10 | round / 10 end;
        "| \(.size) | \(.exact_maps_per_second | rate) | \(.adaptive_maps_per_second | rate) | \(.ring_search_maps_per_second | rate) |"'
} | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" acm <"$scratch/table"; fi
