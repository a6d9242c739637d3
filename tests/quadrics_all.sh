#!/usr/bin/env bash
# Prints the tables of docs/QUADRICS.md: the error of each fit on surfaces of known curvature, and its time on a torus of a million vertices.
#
#   tests/quadrics_all.sh [-o FILE.md]
#
#   -o   put the tables into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY   default build/release/bin/reliefbake; build it with -DRELIEFBAKE_CGAL=ON for the rows of CGAL's jets
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
page=
while (($#)); do
    case $1 in
        -o) page=$2 && shift ;;
        *) sed -n '2,8s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
command -v jq >/dev/null || { echo "quadrics_all: needs jq (apt install jq)" >&2 && exit 2; }
[[ -x $tool ]] || { echo "quadrics_all: no $tool: build first, or set RELIEFBAKE_BINARY" >&2 && exit 2; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

accuracy() {
    # shellcheck disable=SC2016 # backquotes are Markdown's
    printf '## Accuracy\n`reliefbake bench quadric --accuracy`\n\n'
    "$tool" bench quadric --accuracy --json | jq -r '
        def percent: . * 100 | if . >= 10 then . * 10 | round / 10 elif . >= 1 then . * 100 | round / 100 else . * 1000 | round / 1000 end | tostring;
        "| surface | mesh | frames turned | fit | coarse: RMS % (max %) | twice as fine | four times |",
        "| --- | --- | ---: | --- | ---: | ---: | ---: |",
        (.accuracy[] | "| \(.surface) | \(if .irregular then "irregular" else "regular" end) | \(.degrees)° | \(.fit) |"
            + ([.steps[] | " \(.rms | percent) (\(.max | percent)) |"] | add))'
}

speed() {
    # shellcheck disable=SC2016
    printf '\n## Speed\n`reliefbake bench quadric --threads 1`, `--threads 2`: a torus of 1024 x 1024 vertices, ns/vertex; %s, %s processors\n\n' \
        "$(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1)" "$(nproc)"
    for threads in 1 2; do "$tool" bench quadric --threads $threads --json >"$scratch/$threads"; done
    jq -rs '. as $r | "| stage | 1 thread | 2 threads |", "| --- | ---: | ---: |",
        (["total", "weld", "adjacency", "ring", "paper", "jet"][] | select($r[0].ns_per_vertex[.])
            | "| \(if . == "total" then "welding, adjacency and default fit" else . end) | \($r[0].ns_per_vertex[.] | round) | \($r[1].ns_per_vertex[.] | round) |")' \
        "$scratch/1" "$scratch/2"
}

{ accuracy && speed; } | tee "$scratch/tables"
if [[ $page ]]; then "$here/put_table.sh" "$page" <"$scratch/tables"; fi
