#!/usr/bin/env bash
# Bakes every height map in every encoding, bit depth and addressing, verifies each, and prints the table of docs/VERIFY.md.
# Exit code 0: no ray missed, no cone violated, no command failed. Otherwise 4, and the failing commands are printed.
#
#   tests/verify_all.sh [--quick] [--rays N] [--points N] [--jobs N] [--keep DIR] [-o FILE.md]
#
#   --quick    the bundled maps alone, 2 bit depths x 2 encodings, fewer rays (ctest: verify_some)
#   --rays     rays a map (default 30000), --points  points of the direct check a map (default 20000)
#   --jobs     maps at a time, one thread each (default: the number of processors)
#   --keep     folder of results, one file a case; those already there are not done again
#   -o         put the table into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY   the tool (default build/release/bin/reliefbake)
#   RELIEFBAKE_DATA     folder with heights/ (default ../shared/data; without it the bundled maps, and it says so)
set -euo pipefail

source "$(dirname "$0")/families.sh"

# One case: bakes, verifies, prints one JSON line. Never fails: a failure is a line with "error".
if [[ ${1-} == --case ]]; then
    IFS=$'\t' read -r height wrap bits encoding <<<"$2"
    case $wrap/$bits in # repeated maps go through PNG and EXR, clamped ones through TIFF and EXR
        repeat/8 | repeat/16) suffix=png ;;
        */float) suffix=exr ;;
        clamp/*) suffix=tif ;;
        *) suffix=exr ;;
    esac
    set_source_options "$height"
    bake=(cone "$height" -o "$scratch/$$.$suffix" "${source_options[@]}" --wrap "$wrap" --bits "$bits"
        --encoding "$encoding" --threads 1 --json)
    crop=0 # tightness is a matter of the bake, before encoding
    if [[ $bits == float && $encoding == ratio ]]; then crop=48; fi
    check=(verify "$scratch/$$.$suffix" --crop "$crop" --rays "$rays" --points "$points" --threads 1 --json)
    trap 'rm -f "$scratch/$$".*' EXIT

    baked=$("$tool" "${bake[@]}" 2>"$scratch/$$.said") || baked=
    code=0
    verified=
    if [[ $baked ]]; then verified=$("$tool" "${check[@]}" 2>>"$scratch/$$.said") || code=$?; fi
    jq -cn --arg map "${height##*/}" --arg wrap "$wrap" --arg bits "$bits" --arg encoding "$encoding" \
        --argjson baked "${baked:-null}" --argjson verified "${verified:-null}" --arg code "$code" \
        --rawfile said "$scratch/$$.said" --arg command "reliefbake ${bake[*]} && reliefbake ${check[*]}" '
        {map: $map, wrap: $wrap, bits: $bits, encoding: $encoding, command: $command,
         size: "\($baked.map.width)x\($baked.map.height)", zero_codes: $baked.statistics.zero_codes} +
        if $verified == null then {error: $said}
        else ($verified | {rays, missed: (.missed * .rays | round), early, out_of_steps, points, violations, steps_mean,
              steps_max, tightness, verdict}) + (if ($code | tonumber) == 0 then {} else {error: $said} end) end' \
        >"$scratch/$$.json"
    mv "$scratch/$$.json" "$results/${height##*/}.$wrap.$bits.$encoding"
    exit 0
fi

rays=30000 points=20000 jobs=$(getconf _NPROCESSORS_ONLN) table='' quick='' results=''
while (($#)); do
    case $1 in
        --quick) quick=yes ;;
        --rays) rays=$2 && shift ;;
        --points) points=$2 && shift ;;
        --jobs) jobs=$2 && shift ;;
        --keep) results=$2 && shift ;;
        -o) table=$2 && shift ;;
        *) sed -n '2,15s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"
if [[ $quick ]]; then rays=10000 points=5000; fi
all_bits=(8 16 half float) all_encodings=(ratio sqrt radius normal)
if [[ $quick ]]; then all_bits=(8 float) all_encodings=(ratio sqrt); fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
mkdir -p "$results"
export scratch results rays points

# Maps innermost: what a run that is cut short has seen covers all of them.
for bits in "${all_bits[@]}"; do
    for encoding in "${all_encodings[@]}"; do
        for wrap in repeat clamp; do
            for height in "$heights"/*; do
                [[ -s $results/${height##*/}.$wrap.$bits.$encoding ]] ||
                    printf '%s\t%s\t%s\t%s\0' "$height" "$wrap" "$bits" "$encoding"
            done
        done
    done
done | xargs -0 -r -P "$jobs" -n 1 "$here/${0##*/}" --case
cat "$results"/* >"$scratch/lines"

jq -rs --arg version "$("$tool" --version)" '
    def percent: . * 1e6 | round | . / 1e4;
    def dead($encoding): [.[] | select(.bits == "8" and .encoding == $encoding) | .zero_codes][0] // "-" | tostring;
    "| map | size | wrap | rays | missed | points | violations | early, worst | out of steps, worst | steps, mean | steps, max | code 0 at 8 bits: ratio / sqrt / radius / normal | tightness |",
    "| --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |",
    (group_by([.map, .wrap])[] | . as $g | [.[] | select(.verdict)] | [
        $g[0].map, $g[0].size, $g[0].wrap,
        (map(.rays) | add), (map(.missed) | add), (map(.points) | add), (map(.violations) | add),
        "\(map(.early) | max // 0 | percent) %", "\(map(.out_of_steps) | max // 0 | percent) %",
        (map(.steps_mean) | max // 0 | . * 10 | round / 10), (map(.steps_max) | max),
        ([dead("ratio", "sqrt", "radius", "normal")] | join(" / ")),
        ([.[] | select(.bits == "float" and .encoding == "ratio") | .tightness][0] // 0 | . * 1e4 | round / 1e4)
    ] | map(tostring) | "| " + join(" | ") + " |"),
    "",
    "\($version): \(length) maps baked and verified: \(map(.rays // 0) | add) rays, \(map(.missed // 0) | add) missed; "
    + "\(map(.points // 0) | add) points, \(map(.violations // 0) | add) violations; \(map(select(.error)) | length) failures."
    ' "$scratch/lines" | tee "$scratch/table"
if [[ $table ]]; then "$here/put_table.sh" "$table" <"$scratch/table"; fi

bad=$(jq -r 'select(.error or .missed > 0 or .violations > 0)
    | "FAILED: \(.command)\n  missed \(.missed), violations \(.violations), \(.error // "" | rtrimstr("\n"))"' "$scratch/lines")
if [[ $bad ]]; then
    echo "$bad" >&2
    exit 4
fi
