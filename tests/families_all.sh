#!/usr/bin/env bash
# Bakes every height map as every family of cones, verifies each, and prints the tables of docs/FAMILIES.md.
# Exit code 0: no ray missed and no cone violated where the family promises it, no command failed. Otherwise 4.
#
#   tests/families_all.sh [--quick] [--rays N] [--points N] [--jobs N] [--keep DIR] [-o FILE.md]
#
#   --quick    the bundled maps alone, fewer rays (ctest: verify_families)
#   --rays     rays a map (default 10000), --points  points of the direct check a map (default 4000)
#   --jobs     maps at a time (default: the number of processors)
#   --keep     folder of results, one file a case; those already there are not done again
#   -o         put the tables into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
export tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
export MESA_SHADER_CACHE_DISABLE=true OMP_NUM_THREADS=1 LP_NUM_THREADS=1

# Name, command that bakes it, floats of cones a texel, options of `bench cone`, whether rays that pass through are promised away.
families() {
    cat <<'END'
conservative|cone|1||yes
conservative, cell lookup|cone --lookup cell|1|--lookup cell|yes
cone normal|cone-normal|1||yes
relaxed, strict|cone --kind relaxed|1|--kind relaxed|yes
relaxed, slope:4|cone --kind relaxed --relaxed slope:4|1|--kind relaxed --relaxed slope:4|no
relaxed, top|cone --kind relaxed --relaxed top|1|--kind relaxed --relaxed top|no
hybrid, delta 0.05|cone --kind hybrid --delta 0.05|1|--kind hybrid --delta 0.05|yes
4 sectors|acm --sectors 4|4|--sectors 4|yes
4 sectors, relaxed|acm --sectors 4 --kind relaxed|4|--sectors 4 --kind relaxed|yes
8 sectors|acm --sectors 8|8|--sectors 8|yes
3 stacked cones|cone-stack --levels 3|3|--levels 3|yes
END
}

# One case: bakes, verifies, prints one JSON line. Never fails: a failure is a line with "error".
if [[ ${1-} == --case ]]; then
    IFS='|' read -r height family bake _ _ promised <<<"$2"
    source_options=()
    case ${height##*/} in
        *_depth_*) source_options=(--input depth) ;;
        *_NM_height.tga) source_options=(--channel A) ;;
    esac
    map=$scratch/$$.exr
    trap 'rm -f "$scratch/$$".*' EXIT
    # shellcheck disable=SC2086 # the family's command is words
    "$tool" $bake "$height" -o "$map" "${source_options[@]}" --threads 1 --quiet 2>"$scratch/$$.said" || true
    verified=$("$tool" verify "$map" --crop 0 --rays "$rays" --points "$points" --threads 1 --json 2>>"$scratch/$$.said") || true
    jq -cn --arg map "${height##*/}" --arg family "$family" --arg promised "$promised" --argjson verified "${verified:-null}" \
        --rawfile said "$scratch/$$.said" '{map: $map, family: $family, promised: ($promised == "yes")} +
        if $verified == null then {error: $said}
        else $verified | {rays, missed: (.missed * .rays | round), points, violations, steps_mean} end' >"$scratch/$$.json"
    mv "$scratch/$$.json" "$results/${height##*/}.$family"
    exit 0
fi

rays=10000 points=4000 jobs=$(getconf _NPROCESSORS_ONLN) page= quick= results=
while (($#)); do
    case $1 in
        --quick) quick=yes rays=2600 points=1500 ;;
        --rays) rays=$2 && shift ;;
        --points) points=$2 && shift ;;
        --jobs) jobs=$2 && shift ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,14s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
command -v jq >/dev/null || { echo "families_all: needs jq (apt install jq)" >&2 && exit 2; }
[[ -x $tool ]] || { echo "families_all: no $tool: build first, or set RELIEFBAKE_BINARY" >&2 && exit 2; }

folder=${RELIEFBAKE_DATA:-$here/../../shared/data}/heights
if [[ $quick ]]; then folder=$here/data/heights
elif [[ ! -d $folder ]]; then
    echo "families_all: SKIPPED the large set: no $folder (RELIEFBAKE_DATA names its parent); taking the bundled maps" >&2
    folder=$here/data/heights
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
mkdir -p "$results"
export scratch results rays points

# Every family on every map.
for height in "$folder"/*; do
    families | while IFS= read -r line; do
        [[ -s $results/${height##*/}.${line%%|*} ]] || printf '%s|%s\0' "$height" "$line"
    done
done | xargs -0 -r -P "$jobs" -n 1 "$here/${0##*/}" --case
cat "$results"/* >"$scratch/lines"

# Some maps closely: size, time, steps, and what is left wrong after few steps.
closely() {
    local path=$1 options=$2 name=${1##*/}
    [[ -f $path ]] || return 0
    printf '### %s\n\n| family | bytes a texel, halfs | bake, ns/texel | steps, mean | mse at 10 steps | at 20 | at 30 |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n' "$name"
    families | while IFS='|' read -r family bake planes bench _; do
        # shellcheck disable=SC2086 # words
        "$tool" $bake "$path" $options -o "$scratch/close.exr" --quiet 2>/dev/null
        local measures=()
        for steps in 10 20 30; do
            # A march that is cut short may end unsafe; its error is what is asked here.
            measures+=("$({ "$tool" verify "$scratch/close.exr" --crop 0 --points 0 --rays 6500 --steps $steps --json 2>/dev/null || true; } | jq '.mse')")
        done
        local mean ns
        mean=$("$tool" verify "$scratch/close.exr" --crop 0 --points 0 --rays 6500 --json 2>/dev/null | jq '.steps_mean')
        # shellcheck disable=SC2086
        ns=$("$tool" bench cone "$path" $options $bench --threads 1 --repeat 2 --json | jq '.search_ns_per_texel')
        LC_ALL=C printf '| %s | %d | %.0f | %.1f | %.2e | %.2e | %.2e |\n' "$family" $((2 * (planes + 3))) "$ns" "$mean" "${measures[@]}"
    done
    echo
}

{
    printf '## Every family on every map\nRays that passed through the relief and points with a cone that holds what it must not; a dash where both are 0.\n\n'
    jq -rs '
        (map(.family) | reduce .[] as $f ([]; if index($f) then . else . + [$f] end)) as $unsorted
        | ["conservative", "conservative, cell lookup", "cone normal", "relaxed, strict", "relaxed, slope:4", "relaxed, top", "hybrid, delta 0.05",
           "4 sectors", "4 sectors, relaxed", "8 sectors", "3 stacked cones"] as $families
        | "| map | " + ($families | join(" | ")) + " |", "| --- |" + ($families | map(" ---: |") | add),
        (group_by(.map)[] | . as $g | "| \($g[0].map) | " + ([$families[] as $f | ($g[] | select(.family == $f)) |
            if .error then "failed" elif .missed == 0 and .violations == 0 then "-" else "\(.missed * 1e6 / .rays | round / 1e4) %, \(.violations)" end] | join(" | ")) + " |"),
        "",
        "\(length) maps, \(map(.rays // 0) | add) rays, \(map(.points // 0) | add) points; where the family promises it: \(map(select(.promised) | .missed // 0) | add) missed, \(map(select(.promised) | .violations // 0) | add) violations; \(map(select(.error)) | length) failures."' "$scratch/lines"
    if [[ ! $quick ]]; then
        printf '\n## Some maps closely\nTimes: one thread, %s.\n\n' "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1)"
        closely "$folder/ambientcg_RoofingTiles009_1K_Displacement.png" ''
        closely "$folder/ambientcg_Moss001_1K_Displacement.png" ''
        closely "$folder/polyhaven_metal_plate_disp_1k.png" ''
        closely "$folder/pom_stones_NM_height.tga" '--channel A'
    fi
} | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" <"$scratch/table"; fi

bad=$(jq -r 'select(.error or (.promised and (.missed > 0 or .violations > 0)))
    | "FAILED: \(.map), \(.family): missed \(.missed), violations \(.violations) \(.error // "" | rtrimstr("\n"))"' "$scratch/lines")
if [[ $bad ]]; then
    echo "$bad" >&2
    exit 4
fi
