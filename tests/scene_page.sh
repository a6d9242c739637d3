#!/usr/bin/env bash
# Bakes the example scene, and everything that could be baked of its sources: the tables of docs/SCENE.md.
#
#   tests/scene_page.sh [--scene FILE] [--no-times] [-o FILE.md]
#
#   --scene      another scene (default tests/data/scene/courtyard.toml)
#   --no-times   plans alone: the tables of needs and outputs
#   -o           put the tables into FILE.md (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

page='' times=yes scene=$here/data/scene/courtyard.toml
while (($#)); do
    case $1 in
        --scene) scene=$2 && shift ;;
        --no-times) times='' ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,10s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
quietly "$tool" scene "$scene" -o "$scratch/planned" --dry-run --json >"$scratch/plan.json"

definitions='def thousands: tostring | [while(length > 0; .[:-3])] | map(.[-3:]) | reverse | join(" ");'
needs_table() {
    printf '| asset | drawn by | features | maps | chosen |\n| --- | --- | --- | --- | --- |\n'
    jq -r '.assets[] | "| \(.name) | \(.technique) | \(.features | join(", ")) | \(if .maps == [] then "-" else [.maps[] | .map + (if .as == "relief" then "" else " (" + .as + ")" end)] | unique | join(", ") end) | \([.choice, .left_out] | map(select(. != "")) | join("; ")) |"' "$scratch/plan.json"
}
outputs_table() {
    printf '| map | holds | command | texels | files | bytes |\n| --- | --- | --- | ---: | ---: | ---: |\n'
    jq -r "$definitions"' (.runs[].maps[] | "| \(.output) | \(.what) | `\(([.command] + .options) | join(" "))` | \(if .files[0].width == 0 then "-" else "\(.files[0].width) x \(.files[0].height)" end) | \(.files | length) | \(.bytes | thousands) |"),
        "| all that the scene needs | | | | \([.runs[].maps[].files | length] | add) | \(.bytes | thousands) |",
        "| everything | | | | | \(.everything.bytes | thousands) |",
        "| saved | | | | | \(.saved_bytes | thousands) (\(1000 * .saved_bytes / .everything.bytes | round / 10) %) |"' "$scratch/plan.json"
}
times_table() {
    printf '| what | ns a texel, or a vertex |\n| --- | ---: |\n'
    sed -n 's/^\(.*[^ ]\)  *\([0-9][0-9]*\) ns a .*/| \1 | \2 |/p' "$scratch/times"
    printf '\n| | seconds | bytes of texels and vertices | bytes of files |\n| --- | ---: | ---: | ---: |\n'
    sed -n 's/^\(needed\|everything\) *\([^ ]*\) s (predicted [^)]*), \([0-9]*\) bytes of texels and vertices, \([0-9]*\) of files$/| \1 | \2 | \3 | \4 |/p' "$scratch/times"
}

put() {
    if [[ $page ]]; then "$here/put_table.sh" "$page" "$1"; else cat && echo; fi
}
needs_table | put needs
outputs_table | put outputs
[[ ! $times ]] || {
    quietly "$tool" bench scene "$scene" -o "$scratch/baked" >"$scratch/times"
    times_table | put times
}
