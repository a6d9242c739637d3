#!/usr/bin/env bash
# Tables 1 and 2 and figures 33, 34 and 36 of 000 (Ouazzani Chahdi et al. 2021), measured anew: tables of docs/PAPERS.md.
#
#   tests/papers/paper_000.sh [--quick] [--short] [--only table|figures] [-o FILE.md]
#
#   --quick   small pictures, one round
#   --short   one round, one resolution
#   -o        put the tables into FILE.md (tests/put_table.sh)
#
# Published: frames a second on a GeForce GT 840M, 1000 x 600, 35 linear and 10 binary steps, a torus, two views (p. 31, Table 1). Ours: llvmpipe, times over
# that of conservative cones without rectification; methods take turns, the least of three rounds counts. Times need a quiet machine.
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/../families.sh"
source "$(dirname "$0")/mesh_frames.sh"

only='' page='' size=1000x600 rounds=3 levels=(1 0)
while (($#)); do
    case $1 in
        --quick) size=250x150 rounds=1 levels=(2) ;;
        --short) rounds=1 levels=(1) ;;
        --only) only=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,14s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

for kind in conservative relaxed; do quietly "$tool" cone "$here/data/heights/ambientcg_RoofingTiles009_512.png" --kind $kind --wrap repeat --mips -o "$scratch/$kind.exr" --quiet; done
tube=$("$tool" bench surface torus --segments 224 -o "$scratch/torus.glb" --json | jq .radius)

# Name, map, options, and what Table 1 prints: 1024^2 and 2048^2 from the first view, then from the second.
methods() {
    cat <<'LIST'
conservative, none|conservative|--correction none|227 140 280 190
conservative, ray|conservative|--correction ray|210 115 230 140
conservative, cone|conservative|--correction cone|225 127 258 148
conservative, ray as printed|conservative|--correction ray-published|
conservative, cone as printed|conservative|--correction cone-published|
conservative, bent (ours)|conservative|--correction bent|
relaxed, none|relaxed|--correction none|226 141 262 168
relaxed, ray|relaxed|--correction ray|198 107 211 130
relaxed, cone|relaxed|--correction cone|210 117 227 137
relaxed, bent (ours)|relaxed|--correction bent|
relief mapping, ray|conservative|--correction ray --technique binary|202 105 197 117
LIST
}
views=(70,20 90,20)
# measure NAME MAP LEVEL VIEW DEPTH OPTIONS...
measure() {
    local name=$1 map=$2 level=$3 view=$4 depth=$5
    shift 5
    frame "$name" "$scratch/$map.exr" --level "$level" --mesh "$scratch/torus.glb" --mesh-tiles 5,2 --depth-scale "$(jq -n "$depth * $tube")" --size $size \
        --mesh-view "$view" --mesh-view "$view" "$@"
}

table_1() {
    local round name map options printed view level id base
    for ((round = 0; round < rounds; ++round)); do
        while IFS='|' read -r name map options printed; do
            for view in "${views[@]}"; do
                for level in "${levels[@]}"; do
                    # shellcheck disable=SC2086 # options are words
                    measure "${name//[^a-z]/}-$view-$level" "$map" "$level" "$view" 0.2 --steps 35 --binary-steps 10 $options
                done
            done
        done < <(methods)
    done
    echo '| 35 and 10 steps, depth 0.2 of the tube | published: frame times over the first row, 4 columns of Table 1 | ours: frame times over the first row | ours: mean steps | IoU, band, cut |'
    echo '| --- | ---: | ---: | ---: | ---: |'
    while IFS='|' read -r name map options printed; do
        id=${name//[^a-z]/} base=conservativenone
        printf '| %s | %s |' "$name" "$(jq -rn --arg p "$printed" '[$p | split(" ")[] | tonumber] as $p | [227, 140, 280, 190] as $b
            | if ($p | length) == 0 then "" else [range(4) | $b[.] / $p[.] * 100 | round / 100 | tostring] | join(", ") end')"
        for what in ratio steps; do
            local cells=()
            for view in "${views[@]}"; do for level in "${levels[@]}"; do cells+=("$($what "$id-$view-$level" "$base-$view-$level")"); done; done
            printf ' %s |' "$(printf ', %s' "${cells[@]}" | cut -c3-)"
        done
        printf ' %s |\n' "$(judged "$id-${views[1]}-${levels[0]}")"
    done < <(methods)
}

figures() {
    echo '| torus | ray, conservative | cone, conservative | ray, relaxed | cone, relaxed | bent (ours) |'
    echo '| --- | ---: | ---: | ---: | ---: | ---: |'
    local row label depth steps
    for row in 'figure 33: depth 0.4, 25 steps|0.4|25' 'figure 34: depth 0.6, 25 steps|0.6|25' 'depth 0.6, 100 steps|0.6|100' 'figure 36: depth 0.2, 5 steps|0.2|5' 'figure 36: 10 steps|0.2|10' 'figure 36: 20 steps|0.2|20'; do
        IFS='|' read -r label depth steps <<<"$row"
        printf '| %s |' "$label"
        for how in 'conservative ray' 'conservative cone' 'relaxed ray' 'relaxed cone' 'conservative bent'; do
            measure figure "${how% *}" "${levels[0]}" "${views[0]}" "$depth" --steps "$steps" --binary-steps 5 --correction "${how#* }"
            printf ' %s |' "$(judged figure)"
        done
        echo
    done
}

put() {
    tee "$scratch/table"
    if [[ $page ]]; then "$here/put_table.sh" "$page" "$1" <"$scratch/table"; fi
    echo
}
if [[ ${only:-table} == table ]]; then table_1 | put 000-table-1; fi
if [[ ${only:-figures} == figures ]]; then figures | put 000-figures; fi
