#!/usr/bin/env bash
# Measures every family closely, on four maps, and draws one scene with each: tables and pictures of docs/FAMILIES.md.
#
#   tests/family_page.sh [--quick] [--rays N] [--repeat N] [--jobs N] [--keep DIR] [-o FILE.md]
#
#   --quick    two bundled maps, fewer rays, no sampled cones in the pictures
#   --rays     rays a map and march (default 26000)
#   --repeat   bakes timed, the fastest counts (default 3)
#   --jobs     maps at a time while errors are measured (default: the number of processors); times are taken one by one
#   --keep     folder of results, one file a case; those already there are not done again
#   -o         put the tables into FILE.md (tests/put_table.sh), and the pictures into pictures/families/ beside it
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

# One family on one map: steps until rays arrive, and what is wrong after 10, 20 and 30. A march that is cut short may end
# unsafe; its error is what is asked here.
if [[ ${1-} == --case ]]; then
    IFS='|' read -r height family bake _ <<<"$2"
    set_source_options "$height"
    trap 'rm -f "$scratch/$$".*' EXIT
    # shellcheck disable=SC2086 # the family's command is words
    "$tool" $bake "$height" "${source_options[@]}" -o "$scratch/$$.exr" --threads 1 --quiet
    for steps in 512 10 20 30; do
        "$tool" verify "$scratch/$$.exr" --crop 0 --points 0 --rays "$rays" --steps $steps --threads 1 --json 2>/dev/null || (($? == 4))
    done | jq -sc --arg map "${height##*/}" --arg family "$family" '{map: $map, family: $family, steps_mean: .[0].steps_mean,
        after: (.[1:] | map({missed, early, mse}))}' >"$scratch/$$.json"
    mv "$scratch/$$.json" "$results/${height##*/}.$family"
    exit 0
fi

rays=26000 jobs=$(getconf _NPROCESSORS_ONLN) page='' quick='' results='' repeat=3
while (($#)); do
    case $1 in
        --quick) quick=yes rays=2600 repeat=1 ;;
        --rays) rays=$2 && shift ;;
        --repeat) repeat=$2 && shift ;;
        --jobs) jobs=$2 && shift ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,13s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"
set_close_maps
((${#maps[@]})) || maps=("$here"/data/heights/{ambientcg_RoofingTiles009_512.png,pom_rocks_NM_height.tga})

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
mkdir -p "$results"
export scratch results rays

for height in "${maps[@]}"; do
    families | while IFS= read -r line; do
        [[ -s $results/${height##*/}.${line%%|*} ]] || printf '%s|%s\0' "$height" "$line"
    done
done | xargs -0 -r -P "$jobs" -n 1 "$0" --case

# Nanoseconds a texel of the search, the fastest of some bakes, one thread.
bake_ns() {
    local height=$1 command=$2 k
    for ((k = 0; k < repeat; ++k)); do
        # shellcheck disable=SC2086 # words
        "$tool" $command "$height" "${source_options[@]}" -o "$scratch/timed.exr" --threads 1 --json 2>/dev/null
    done | jq -s 'map(.seconds.cone / (.map.width * .map.height) * 1e9) | min'
}

percent='def percent: . * 1e6 | round / 1e4; def exponent: if . == 0 then "0" else (log10 | floor) as $e | "\(. / pow(10; $e) * 100 | round / 100)e\($e)" end;'
closely() {
    local height=$1
    set_source_options "$height"
    printf '### %s\n\n| family | bytes a texel | bake, ns/texel | steps, mean | 10 steps: missed, early, mse | 20 steps | 30 steps |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n' "${height##*/}"
    families | while IFS='|' read -r family bake cones _; do
        local ns_file=$results/${height##*/}.$family.ns
        [[ -s $ns_file ]] || bake_ns "$height" "$bake" >"$ns_file"
        jq -r --argjson bytes $((2 * (cones + 3))) --argjson ns "$(cat "$ns_file")" "$percent"'
            "| \(.family) | \($bytes) | \($ns | round) | \(.steps_mean * 10 | round / 10) | "
            + (.after | map("\(.missed | percent) %, \(.early | percent) %, \(.mse | exponent)") | join(" | ")) + " |"' "$results/${height##*/}.$family"
    done
    echo
}

{
    printf '## Some maps closely\nBytes: halfs, with depth and normals. Times: one thread, %s. Steps: until the ray arrives, 512 at most. Relaxed families: up to 8 of the steps are halvings.\nErrors: after so many steps of the march (relaxed families: and 8 halvings); `missed` beyond and `early` before the first hit.\n\n' "$(machine)"
    for height in "${maps[@]}"; do closely "$height"; done
} | tee "$scratch/closely"

# One scene with every family, 10 steps each.
pictures=${page:+$(dirname "$page")/pictures/families}
pictures=${pictures:-$scratch/pictures}
mkdir -p "$pictures"
scene=$here/data/heights/pom_rocks_NM_height.tga
shot=(--view 68 --azimuth 30 --span 0.5 --endless --size 180x120)
set_source_options "$scene"

# draw FAMILY MAP [STEPS]: its pictures, and their row of the table.
draw() {
    local name=${1,,} steps=${3:-10}
    name=${name//[^a-z0-9]/-}
    name=${name//--/-} name=${name//--/-} name=${name%-}
    "$tool" render "$2" "${shot[@]}" --steps "$steps" -o "$pictures/$name.png" --error "$pictures/$name-error.png"
    printf '| %s | ![%s](pictures/families/%s.png) | ![its error](pictures/families/%s-error.png) |\n' "$1" "$1" "$name" "$name"
}
{
    printf '| family | 10 steps | distance from the exact hit |\n| --- | --- | --- |\n'
    families | while IFS='|' read -r family bake _; do
        # shellcheck disable=SC2086 # words
        "$tool" $bake "$scene" "${source_options[@]}" -o "$scratch/scene.exr" --quiet
        draw "$family" "$scratch/scene.exr"
        if [[ $family == 'relaxed, top' && ! $quick ]]; then
            sampled=$results/scene-sampled.exr # minutes
            [[ -s $sampled ]] || "$tool" bench peer sampled-relaxed "$scratch/scene.exr" -o "$sampled" --threads "$jobs" >/dev/null
            draw 'sampled original (GPU Gems 3)' "$sampled"
        fi
        if [[ $family == conservative ]]; then draw 'conservative, 256 steps' "$scratch/scene.exr" 256; fi
    done
} | tee "$scratch/pictures.md"

if [[ $page ]]; then
    "$here/put_table.sh" "$page" closely <"$scratch/closely"
    "$here/put_table.sh" "$page" pictures <"$scratch/pictures.md"
fi
