#!/usr/bin/env bash
# Table 1 of 004 (Ouazzani Chahdi et al. 2021, extrusion), measured anew: a table of docs/PAPERS.md.
#
#   tests/papers/paper_004.sh [--quick] [--short] [-o FILE.md]
#
#   --quick   small pictures, one round, one row
#   --short   one round
#   -o        put the table into FILE.md (tests/put_table.sh)
#
# Published: frames a second on a GeForce GT 840M, 800 x 600, a torus of 2028 triangles, shape maps of 1024 x 1024, 25 linear and 5 binary steps, b 0.08, c 0.6
# (p. 425, Table 1). Ours: llvmpipe, times over that of the basic extrusion without correction; methods take turns, the least of three rounds counts.
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/../families.sh"
source "$(dirname "$0")/mesh_frames.sh"

page='' size=800x600 rounds=3
rows=('6,6|200 184 176 192 176 168 136' '10,10|160 144 136 152 136 128 128' '12,10|152 136 128 144 128 120 96')
while (($#)); do
    case $1 in
        --quick) size=200x150 rounds=1 rows=("${rows[0]}") ;;
        --short) rounds=1 ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,13s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

shape=$here/data/shapes/flipper128.png
"$tool" shape "$shape" -o "$scratch/shape.png" --wrap repeat --antialiased --quiet
quietly "$tool" cone "$shape" -o "$scratch/cones.exr" --wrap repeat --input depth --quiet # what is dark is inside
tube=$("$tool" bench surface torus --segments 60 -o "$scratch/torus.glb" --json | jq .radius)

kinds=('basic|' 'bevelled|--b 0.08' 'chamfered|--b 0.08 --c 0.6')
methods() {
    local kind
    for kind in "${kinds[@]}"; do echo "flat-${kind%|*}|shape.png|--correction none ${kind#*|}"; done
    for kind in "${kinds[@]}"; do echo "ray-${kind%|*}|shape.png|--correction ray ${kind#*|}"; done
    echo 'relief|cones.exr|--correction ray --technique binary'
    for kind in "${kinds[@]}"; do echo "printed-${kind%|*}|shape.png|--correction ray-published ${kind#*|}"; done
    for kind in "${kinds[@]}"; do echo "bent-${kind%|*}|shape.png|--correction bent ${kind#*|}"; done
}

for ((round = 0; round < rounds; ++round)); do
    while IFS='|' read -r name map options; do
        for row in "${rows[@]}"; do
            # shellcheck disable=SC2086 # options are words
            frame "$name-${row%|*}" "$scratch/$map" --mesh "$scratch/torus.glb" --mesh-tiles "${row%|*}" --depth-scale "$(jq -n "0.2 * $tube")" --size $size \
                --mesh-view 70,20 --mesh-view 70,20 --steps 25 --binary-steps 5 $options
        done
    done < <(methods)
done

table() {
    local row name map options column=0
    echo '| (Tx, Ty): 6 6; 10 10; 12 10 | published: frame times over the first row | ours: frame times over the first row | ours: mean steps | IoU, band, cut |'
    echo '| --- | ---: | ---: | ---: | ---: |'
    while IFS='|' read -r name map options; do
        local published=() times=() counts=() marks=()
        for row in "${rows[@]}"; do
            local fps
            read -ra fps <<<"${row#*|}"
            if ((column < ${#fps[@]})); then published+=("$(jq -n "${fps[0]} / ${fps[$column]} * 100 | round / 100")"); fi
            times+=("$(ratio "$name-${row%|*}" "flat-basic-${row%|*}")")
            counts+=("$(steps "$name-${row%|*}")")
            marks+=("$(judged "$name-${row%|*}")")
        done
        printf '| %s | %s | %s | %s | %s |\n' "$name" "$(IFS=';' && echo "${published[*]-}")" "$(IFS=';' && echo "${times[*]}")" "$(IFS=';' && echo "${counts[*]}")" "${marks[0]}"
        column=$((column + 1))
    done < <(methods) | sed 's/;/; /g; s/flat-/extrusion, no correction, /; s/ray-/curved extrusion, /; s/printed-/curved extrusion as printed, /; s/bent-/curved extrusion, bent (ours), /; s/| relief |/| curved relief mapping |/'
}
table | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" 004-table-1 <"$scratch/table"; fi
