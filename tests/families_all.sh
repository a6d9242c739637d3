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

source "$(dirname "$0")/families.sh"

# One case: bakes, verifies, prints one JSON line. Never fails: a failure is a line with "error".
if [[ ${1-} == --case ]]; then
    IFS='|' read -r height family bake _ promised <<<"$2"
    set_source_options "$height"
    map=$scratch/$$.exr
    trap 'rm -f "$scratch/$$".*' EXIT
    # shellcheck disable=SC2086 # the family's command is words
    "$tool" $bake "$height" -o "$map" "${source_options[@]}" --threads 1 --quiet 2>"$scratch/$$.said" || true
    verified=$("$tool" verify "$map" --crop 0 --steps 512 --rays "$rays" --points "$points" --threads 1 --json 2>>"$scratch/$$.said") || true
    jq -cn --arg map "${height##*/}" --arg family "$family" --arg promised "$promised" --argjson verified "${verified:-null}" \
        --rawfile said "$scratch/$$.said" '{map: $map, family: $family, promised: ($promised == "yes")} +
        if $verified == null then {error: $said}
        else $verified | {rays, missed: (.missed * .rays | round), points, violations, steps_mean} end' >"$scratch/$$.json"
    mv "$scratch/$$.json" "$results/${height##*/}.$family"
    exit 0
fi

rays=10000 points=4000 jobs=$(getconf _NPROCESSORS_ONLN) page='' quick='' results=''
while (($#)); do
    case $1 in
        --quick) quick=yes rays=2600 points=1500 ;;
        --rays) rays=$2 && shift ;;
        --points) points=$2 && shift ;;
        --jobs) jobs=$2 && shift ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,13s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
mkdir -p "$results"
export scratch results rays points

# Every family on every map.
for height in "$heights"/*; do
    families | while IFS= read -r line; do
        [[ -s $results/${height##*/}.${line%%|*} ]] || printf '%s|%s\0' "$height" "$line"
    done
done | xargs -0 -r -P "$jobs" -n 1 "$here/${0##*/}" --case
cat "$results"/* >"$scratch/lines"

{
    printf '## Every family on every map\nRays that passed through the relief and points with a cone that holds what it must not; a dash where both are 0.\n\n'
    jq -rs --arg names "$(families | cut -d'|' -f1)" '
        ($names | split("\n")) as $families
        | "| map | " + ($families | join(" | ")) + " |", "| --- |" + ($families | map(" ---: |") | add),
        (group_by(.map)[] | . as $g | "| \($g[0].map) | " + ([$families[] as $f | [$g[] | select(.family == $f)][0] |
            if . == null then "" elif .error then "failed" elif .missed == 0 and .violations == 0 then "-" else "\(.missed * 1e6 / .rays | round / 1e4) %, \(.violations)" end] | join(" | ")) + " |"),
        "",
        "\(length) maps, \(map(.rays // 0) | add) rays, \(map(.points // 0) | add) points; where the family promises it: \(map(select(.promised) | .missed // 0) | add) missed, \(map(select(.promised) | .violations // 0) | add) violations; \(map(select(.error)) | length) failures.",
        "", "## Steps that cell lookups save",
        "Mean steps of conservative cones until the ray arrives (512 at most), from 13 views.", "",
        "| map | filtered | cell | saved |", "| --- | ---: | ---: | ---: |",
        (group_by(.map)[] | ([.[] | select(.family == "conservative")][0].steps_mean) as $filtered
            | ([.[] | select(.family == "conservative, cell lookup")][0].steps_mean) as $cell | select($filtered and $cell)
            | "| \(.[0].map) | \($filtered * 10 | round / 10) | \($cell * 10 | round / 10) | \((1 - $cell / $filtered) * 1000 | round / 10) % |")' "$scratch/lines"
} | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" every <"$scratch/table"; fi

bad=$(jq -r 'select(.error or (.promised and (.missed > 0 or .violations > 0)))
    | "FAILED: \(.map), \(.family): missed \(.missed), violations \(.violations) \(.error // "" | rtrimstr("\n"))"' "$scratch/lines")
if [[ $bad ]]; then
    echo "$bad" >&2
    exit 4
fi
