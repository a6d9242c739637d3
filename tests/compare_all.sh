#!/usr/bin/env bash
# Prints the tables of docs/COMPARE.md: our maps beside those of other methods, all through one verifier, and the speed of the bake.
# Each table stands below the command that makes its numbers.
#
#   tests/compare_all.sh [--threads N] [-o FILE.md]
#
#   --threads  of the bake (default 1)
#   -o         put the tables into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
export MESA_SHADER_CACHE_DISABLE=true

threads=1 page=
while (($#)); do
    case $1 in
        --threads) threads=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,11s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
command -v jq >/dev/null || { echo "compare_all: needs jq (apt install jq)" >&2 && exit 2; }
[[ -x $tool ]] || { echo "compare_all: no $tool: build first, or set RELIEFBAKE_BINARY" >&2 && exit 2; }

heights=${RELIEFBAKE_DATA:-$here/../../shared/data}/heights
maps=(
    "ambientcg_Moss001_1K_Displacement.png"
    "ambientcg_Wood062_1K_Displacement.png"
    "ambientcg_RoofingTiles009_1K_Displacement.png"
    "polyhaven_metal_plate_disp_1k.png"
    "godot_texture_bricks_depth_1000.jpg --input depth"
    "panda3d_heightfield_16.png"
    "pom_rocks_NM_height.tga --channel A"
    "pom_stones_NM_height.tga --channel A"
)
if [[ ! -d $heights ]]; then
    echo "compare_all: SKIPPED the large set: no $heights (RELIEFBAKE_DATA names its parent); taking two bundled maps" >&2
    heights=$here/data/heights
    maps=("ambientcg_RoofingTiles009_512.png" "pom_rocks_NM_height.tga --channel A")
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# One map: its table, and its row of the table of speeds.
compare() {
    local options=$1 json=$scratch/one.json
    # shellcheck disable=SC2086 # options are words
    "$tool" bench cone "$heights"/$options --threads "$threads" --compare --peers --json >"$json"
    printf '### %s\n`reliefbake bench cone %s --threads %s --compare --peers`\n\n' "${options%% *}" "$options" "$threads"
    jq -r '
        def sci: if . == 0 then "0" else (. * 1e6 | round / 1e4 | tostring) + " %" end;
        "| method | violations | of points | missed rays | of rays | steps, mean | steps, max | tightness | bake, ns/texel |",
        "| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
        (.compare[] | "| \(.method) | \(.violations) | \(.points) | \(.missed * .rays | round) (\(.missed | sci)) | \(.rays) | \(.steps_mean * 10 | round / 10) "
            + "| \(.steps_max) | \(.tightness * 1e3 | round / 1e3) | \(.bake_ns_per_texel | round) |")' "$json"
    echo
    jq -r 'def peer($name): .peers[] | select(.name == $name) | .times_ours | if . < 10 then . * 10 | round / 10 else round end | tostring + " x";
        "| \(.name) | \(.width)x\(.height) | \(.search_ns_per_texel | round) | \(peer("brute force")) | \(peer("expanding ring")) | \(peer("quick cone map")) |"' \
        "$json" >>"$scratch/speeds"
    jq -r '.machine + ", " + .simd' "$json" >"$scratch/machine"
}

{
    printf '## Maps\n\n'
    for map in "${maps[@]}"; do compare "$map"; done
    printf '## Speed\nThe commands above; %s, %s thread(s), %s processors. How many times longer the others take:\n\n' \
        "$(cat "$scratch/machine")" "$threads" "$(nproc)"
    echo '| map | size | ours, ns/texel | brute force | expanding ring | quick cone map |'
    echo '| --- | --- | ---: | ---: | ---: | ---: |'
    cat "$scratch/speeds"
} | tee "$scratch/tables"
if [[ $page ]]; then "$here/put_table.sh" "$page" <"$scratch/tables"; fi
