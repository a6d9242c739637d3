#!/usr/bin/env bash
# Whole cones above each other against pieces of one, at equal bytes a texel (001 sec. 3.4, methods 1 and 2): a table of docs/FAMILIES.md.
#
#   tests/stack_table.sh [--quick] [--rays N] [-o FILE.md]
#
#   --quick    one bundled map, two levels, fewer rays
#   --rays     rays a measurement (default 13000)
#   -o         put the table into FILE.md (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

rays=13000 page='' quick=''
while (($#)); do
    case $1 in
        --quick) quick=yes rays=1300 ;;
        --rays) rays=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,10s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

maps=(ambientcg_Moss001_1K_Displacement.png ambientcg_RoofingTiles009_1K_Displacement.png bgfx_heightmap_float.exr polyhaven_metal_plate_disp_1k.png)
[[ -f $heights/${maps[0]} ]] || maps=(gz_dem_squared_129.tif)
stacks=('one cone|cone' '2 cones|cone-stack --levels 2' '2 pieces|cone-stack --levels 2 --method 2'
    '4 cones|cone-stack --levels 4' '4 pieces|cone-stack --levels 4 --method 2')
if [[ $quick ]]; then stacks=("${stacks[@]:1:2}"); fi

# A march that is cut short may end unsafe; its error is what is asked here.
verified() { "$tool" verify "$scratch/map.exr" --crop 0 --points 0 --rays "$rays" "$@" --json 2>/dev/null || (($? == 4)); }

{
    printf '## Whole cones above each other, or pieces of one\n'
    printf 'At equal bytes a texel, sqrt codes in floats, %s rays of all views of `verify` each. A stack costs one more texture read a step than one cone.\n\n' "$rays"
    printf '| map | cones | steps, mean | mse at 10 steps | at 20 | at 30 |\n| --- | --- | ---: | ---: | ---: | ---: |\n'
    for name in "${maps[@]}"; do
        set_source_options "$name"
        for stack in "${stacks[@]}"; do
            # shellcheck disable=SC2086 # the command is words
            "$tool" ${stack#*|} "$heights/$name" "${source_options[@]}" -o "$scratch/map.exr" --quiet 2>/dev/null
            whole=$(verified | jq .steps_mean) errors=()
            for steps in 10 20 30; do errors+=("$(verified --steps $steps | jq .mse)"); done
            LC_ALL=C printf '| %s | %s | %.1f | %.2e | %.2e | %.2e |\n' "${name%.*}" "${stack%|*}" "$whole" "${errors[@]}"
        done
    done
} | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" stacks <"$scratch/table"; fi
