#!/usr/bin/env bash
# What the relaxed modes get wrong, side by side with the published original: a table of docs/FAMILIES.md.
# The original (GPU Gems 3, chapter 18) looks from every texel at every other, so all are baked for a mip level of each map that it can
# do in seconds. Its time for the full map is that of some of its texels.
#
#   tests/relaxed_table.sh [--quick] [--side N] [--rays N] [-o FILE.md]
#
#   --quick    the bundled maps, 32 texels a side, fewer rays
#   --side     longest side of the level taken (default 128)
#   --rays     rays a map (default 100000)
#   -o         put the table into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

side=128 rays=100000 points=4000 page='' quick=''
while (($#)); do
    case $1 in
        --quick) quick=yes side=32 rays=13000 points=500 ;;
        --side) side=$2 && shift ;;
        --rays) rays=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,13s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

modes=(strict slope:4 top)

# One line of JSON: what the map is wrong in after enough steps. Rays may miss, so verify may fail (4).
judge() {
    { "$tool" verify "$1" ${3+--level "$3"} --steps 512 --crop 0 --rays "$rays" --points "$points" --json 2>/dev/null || (($? == 4)); } |
        jq -c --arg map "$height" --arg mode "$2" '{map: $map, mode: $mode, rays, points, missed: (.missed * .rays | round), violations, steps_mean}'
}

# The level of a map whose sides are at most `side`.
level_of() {
    "$tool" explain "$1" --json | jq --argjson side "$side" '[.width, .height] | max | [., 0] | until(.[0] <= $side; [(.[0] / 2 | floor), .[1] + 1]) | .[1]'
}

for path in "$heights"/*; do
    height=${path##*/}
    set_source_options "$path"
    for mode in "${modes[@]}"; do
        quietly "$tool" cone "$path" "${source_options[@]}" --kind relaxed --relaxed "$mode" --mips -o "$scratch/$mode.exr" --quiet
        level=$(level_of "$scratch/$mode.exr")
        judge "$scratch/$mode.exr" "$mode" "$level"
    done
    "$tool" bench peer sampled-relaxed "$scratch/top.exr" --level "$level" -o "$scratch/sampled.exr" >/dev/null
    judge "$scratch/sampled.exr" sampled
    quietly "$tool" bench cone "$path" "${source_options[@]}" --kind relaxed --relaxed top --peers --threads 1 --repeat 1 --json |
        jq -c --arg map "$height" '{map: $map, mode: "time", ours: .search_ns_per_texel, times: .peers[0].times_ours}'
done >"$scratch/lines"

{
    printf '## Relaxed modes side by side\nRays that passed through the relief, and points with a cone that holds what its mode forbids (the original: as `top`), on the level of each map with at most %s texels a side; %s rays and %s points each, 512 steps. Last: the original'\''s time on the full map, over that of `top` (one thread, %s).\n\n' \
        "$side" "$rays" "$points" "$(machine)"
    jq -rs '
        def percent: if . == 0 then "0" else "\(. * 1e6 | round / 1e4) %" end;
        def cell: "\(.missed / .rays | percent), \(.violations / .points | percent)";
        ["strict", "slope:4", "top", "sampled"] as $modes
        | "| map | strict | slope:4 | top | sampled original | steps, mean: " + ($modes | join(" / ")) + " | bake: times `top` |",
          "| --- | ---: | ---: | ---: | ---: | ---: | ---: |",
        (group_by(.map)[] | . as $g | [$modes[] as $m | $g[] | select(.mode == $m)] as $rows | ($g[] | select(.mode == "time")) as $time
            | "| \($g[0].map) | \($rows | map(cell) | join(" | ")) | \($rows | map(.steps_mean * 10 | round / 10 | tostring) | join(" / ")) | \($time.times | round) |"),
        (. as $all | "| all | " + ([$modes[] as $m | [$all[] | select(.mode == $m)]
            | {missed: (map(.missed) | add), rays: (map(.rays) | add), violations: (map(.violations) | add), points: (map(.points) | add)} | cell] | join(" | ")) + " | | |")' "$scratch/lines"
} | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" relaxed <"$scratch/table"; fi
