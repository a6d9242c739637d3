#!/usr/bin/env bash
# Bakes every shape at every bit depth, clamped and repeated, signed or not, squares and anti-aliased, verifies every kind of solid of it against the exact
# oracle, and prints the table of docs/EXTRUSION.md.
# Exit code 0: no ray missed, none stopped early, no distance too long, no command failed. Otherwise 4.
#
#   tests/shapes_all.sh [--quick] [--rays N] [--points N] [--jobs N] [--keep DIR] [-o FILE.md]
#
#   --quick    the bundled shapes alone, fewer rays (ctest: verify_shapes)
#   --rays     rays a map (default 60000), --points  points of the direct check a map (default 20000)
#   --jobs     maps at a time (default: the number of processors)
#   --keep     folder of results, one file a case; those already there are not done again
#   -o         put the table into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
export tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
export MESA_SHADER_CACHE_DISABLE=true OMP_NUM_THREADS=1 LP_NUM_THREADS=1

# One case: bakes, verifies, prints one JSON line. Never fails: a failure is a line with "error".
if [[ ${1-} == --case ]]; then
    IFS='|' read -r shape bits extension options <<<"$2"
    map=$scratch/$$.$extension
    trap 'rm -f "$scratch/$$".*' EXIT
    # shellcheck disable=SC2086 # options are words
    "$tool" shape "$shape" -o "$map" --bits "$bits" $options --threads 1 --quiet 2>"$scratch/$$.said" || true
    verified=$("$tool" verify "$map" --rays "$rays" --points "$points" --threads 1 --json 2>>"$scratch/$$.said") || true
    jq -cn --arg shape "${shape##*/}" --arg bits "$bits" --arg options "$options" --argjson verified "${verified:-null}" \
        --rawfile said "$scratch/$$.said" '{shape: $shape, bits: $bits, options: $options} +
        if $verified == null then {error: $said} else {points: $verified.points, violations: $verified.violations,
            solids: [$verified.solids[] | {name, rays, hits, missed, early, not_finite, out_of_steps, gap_mean, normal_mean, steps_mean, steps_max}]} end' >"$scratch/$$.json"
    mv "$scratch/$$.json" "$results/${shape##*/}.$bits.${options// /_}"
    exit 0
fi

rays=60000 points=20000 jobs=$(getconf _NPROCESSORS_ONLN) page= quick= results=
while (($#)); do
    case $1 in
        --quick) quick=yes rays=6000 points=2000 ;;
        --rays) rays=$2 && shift ;;
        --points) points=$2 && shift ;;
        --jobs) jobs=$2 && shift ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,15s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
command -v jq >/dev/null || { echo "shapes_all: needs jq (apt install jq)" >&2 && exit 2; }
[[ -x $tool ]] || { echo "shapes_all: no $tool: build first, or set RELIEFBAKE_BINARY" >&2 && exit 2; }

folder=${RELIEFBAKE_DATA:-$here/../../shared/data}/shapes
if [[ $quick ]]; then folder=$here/data/shapes
elif [[ ! -d $folder ]]; then
    echo "shapes_all: SKIPPED the large set: no $folder (RELIEFBAKE_DATA names its parent); taking the bundled shapes" >&2
    folder=$here/data/shapes
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
mkdir -p "$results"
export scratch results rays points

for shape in "$folder"/*; do
    for bits in 8:png 16:png half:exr float:exr; do
        for options in '--wrap clamp' '--wrap repeat --signed' '--antialiased' '--antialiased --wrap repeat --signed'; do
            [[ -s $results/${shape##*/}.${bits%:*}.${options// /_} ]] || printf '%s|%s|%s|%s\0' "$shape" "${bits%:*}" "${bits#*:}" "$options"
        done
    done
done | xargs -0 -r -P "$jobs" -n 1 "$here/${0##*/}" --case
cat "$results"/* >"$scratch/lines"

{
    printf '| shape | maps | rays | missed | early | points | too long |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: |\n'
    jq -rs '(group_by(.shape)[] | [.[].solids // [] | .[]] as $s | "| \(.[0].shape) | \(length) | \($s | map(.rays) | add) | \($s | map(.missed) | add) | \($s | map(.early) | add) | \(map(.points // 0) | add) | \(map(.violations // 0) | add) |"),
        "", "\(length) maps, \([.[].solids // [] | .[].rays] | add) rays: \([.[].solids // [] | .[].missed] | add) missed, \([.[].solids // [] | .[].early] | add) early, \([.[].solids // [] | .[].out_of_steps] | add) without an end; \(map(.points // 0) | add) points: \(map(.violations // 0) | add) distances too long; \(map(select(.error)) | length) failures.",
        "", "| solid | gap at the hit, texture widths | normal, degrees | steps, mean | steps, max |", "| --- | ---: | ---: | ---: | ---: |",
        ([.[].solids // [] | .[]] | group_by(.name)[] | "| \(.[0].name) | \(map(.gap_mean) | add / length * 1e6 | round / 1e6) | \(map(.normal_mean) | add / length * 100 | round / 100) | \(map(.steps_mean) | add / length * 10 | round / 10) | \(map(.steps_max) | max) |")' "$scratch/lines"
} | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" <"$scratch/table"; fi

bad=$(jq -r 'select(.error or .violations > 0 or ([.solids[] | .missed + .early + .not_finite + .out_of_steps] | add) > 0)
    | "FAILED: \(.shape), \(.bits) bits, \(.options): \(.error // ([.solids[] | select(.missed + .early + .not_finite + .out_of_steps > 0)] | tostring))"' "$scratch/lines")
if [[ $bad ]]; then
    echo "$bad" >&2
    exit 4
fi
