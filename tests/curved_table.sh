#!/usr/bin/env bash
# Judges curved relief beside meshes really displaced: the tables and pictures of docs/CURVED.md.
#
#   tests/curved_table.sh [--quick] [--only TABLE]... [-o docs/CURVED.md]
#
#   --quick   one surface, small pictures of a small map, few rows, no pictures
#   --only    goal, steps, methods, terms, printed, extrusions, depths or pictures; several may be given (default all)
#   -o        put the tables into FILE.md (tests/put_table.sh), and the pictures into pictures/curved beside it
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

quick='' page='' only=''
while (($#)); do
    case $1 in
        --quick) quick=yes ;;
        --only) only+=" $2" && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,10s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
data=${RELIEFBAKE_DATA:-$here/../../shared/data}

surfaces=(sphere torus cylinder torus-open vase) depths=(0.05 0.1 0.2 0.4 0.6) steps=(5 10 20 25 35) level=1 size=640x480 full_size=1024x768 small_size=400x300 # full for the goal and the pictures, small for steps and depths
if [[ $quick ]]; then surfaces=(cylinder) depths=(0.1) steps=(35) level=3 size=256x192 full_size=256x192 small_size=256x192; fi
most=35

# Maps, meshes, and of each mesh its radius, repeats and views: none looks through an open end.
declare -A radius tiles views ends
for kind in conservative relaxed; do
    quietly "$tool" cone "$here/data/heights/ambientcg_RoofingTiles009_512.png" --kind $kind --wrap repeat --mips -o "$scratch/$kind.exr" --quiet
done
if [[ ! $quick ]]; then # two more for the goal: stones, and a relief that is all floor
    "$tool" cone "$here/data/heights/pom_rocks_NM_height.tga" --channel A --wrap repeat --mips -o "$scratch/stones.exr" --quiet
    { printf 'P5 64 64 255\n' && head -c 4096 /dev/zero; } >"$scratch/floor.pgm"
    quietly "$tool" cone "$scratch/floor.pgm" --wrap repeat --mips -o "$scratch/floor.exr" --quiet
fi
segments() { if [[ $1 == torus* ]]; then echo 224; else echo 64; fi; } # 64 around the tube
add_surface() {
    local name=$1 surface=$2
    shift 2
    radius[$name]=$("$tool" bench surface "$surface" --segments "$(segments "$surface")" "$@" -o "$scratch/$name.glb" --json | jq .radius)
    case $surface in
        sphere) tiles[$name]=4,2 views[$name]= ;;
        torus) tiles[$name]=5,2 views[$name]= ;;
        torus-open) tiles[$name]=4,2 views[$name]='--mesh-view 0,0 --mesh-view 20,90' ends[$name]='--ends u' ;;
        *) tiles[$name]=3,1 views[$name]='--mesh-view 90,20 --mesh-view 90,140' ends[$name]='--ends v' ;;
    esac
}
for surface in "${surfaces[@]}"; do add_surface "$surface" "$surface"; done
add_surface sheared cylinder --shear 3
ends[sheared]='' # v winds up the cylinder: no end of it is the mesh's
if [[ ! $quick ]]; then
    if [[ -f $data/meshes/mx_teapot.obj ]]; then
        "$tool" quadric "$data/meshes/mx_teapot.obj" -o "$scratch/teapot.glb" --json >"$scratch/said" 2>&1
        radius[teapot]=0.1 tiles[teapot]=2,2 views[teapot]='--mesh-view 90,20 --mesh-view 90,140' surfaces+=(teapot)
    else
        echo "curved_table: SKIPPED the teapot: no $data/meshes (RELIEFBAKE_DATA names its parent)" >&2
    fi
fi

# judge MESH DEPTH MAP OPTIONS...: one line of JSON. DEPTH: of the mesh's radius.
judge() {
    local mesh=$1 depth=$2 map=$3
    shift 3
    local where=${ends[$mesh]-}
    if [[ " $* " == *' none '* || " $* " == *' flat '* ]]; then where=; fi # the original knows nothing of ends
    # shellcheck disable=SC2086 # views are words
    "$tool" verify "$scratch/$map.exr" --level $level --mesh "$scratch/$mesh.glb" --depth-scale "$(jq -n "$depth * ${radius[$mesh]}")" --mesh-tiles "${tiles[$mesh]}" \
        ${views[$mesh]} $where --json "$@" $([[ " $* " == *' --size '* ]] || echo "--size $size")
}
# As IoU, share of the band, and IoU of what is cut away.
cell='def cell: [.iou, .band_agreement, .cut_iou] | map(. * 1000 | round / 1000 | tostring) | join(", ");'

methods() {
    cat <<'END'
cones, no correction|conservative|--correction none
cones, ray rectified|conservative|--correction ray
cones, cones rectified|conservative|--correction cone
cones, bent (ours)|conservative|--correction bent
relaxed cones, no correction|relaxed|--correction none
relaxed cones, ray rectified|relaxed|--correction ray
relaxed cones, cones rectified|relaxed|--correction cone
relaxed cones, bent (ours)|relaxed|--correction bent
relief mapping|conservative|--correction ray --technique binary
END
}

header() {
    local row rule='| --- |'
    row="| $1 |"
    shift
    for title in "$@"; do row+=" $title |" rule+=' ---: |'; done
    printf '%s\n%s\n' "$row" "$rule"
}

by_method() {
    header "$most steps, 5 halvings, depth 0.1" "${surfaces[@]:0:3}"
    methods | while IFS='|' read -r name map options; do
        printf '| %s |' "$name"
        for surface in "${surfaces[@]:0:3}"; do
            # shellcheck disable=SC2086
            judge "$surface" 0.1 "$map" --steps $most --binary-steps 5 $options | jq -r "$cell"' " \(cell), \(.depth_mean * 1000 | round / 1000) |"' | tr -d '\n'
        done
        echo
    done
    for model in flat ab abc circle; do
        printf '| march without limits, %s |' "$model"
        for surface in "${surfaces[@]:0:3}"; do
            judge "$surface" 0.1 conservative --ideal $model | jq -r "$cell"' " \(cell), \(.depth_mean * 1000 | round / 1000) |"' | tr -d '\n'
        done
        echo
    done
}

# What is asked of the correction: an IoU of 0.98, and 0.8 of the silhouette band.
goal() {
    local rows=('roof tiles, 35 steps|conservative|35' 'roof tiles, 100 steps|conservative|100')
    if [[ ! $quick ]]; then rows+=('stones, 100 steps|stones|100' 'all floor, 100 steps|floor|100'); fi
    header "depth 0.1, bent" 'IoU, band, cut' 'depth: mean, 99 %' 'holes' 'steps: mean, most' 'IoU 0.98, band 0.8'
    for surface in "${surfaces[@]}"; do
        for row in "${rows[@]}"; do
            local name map count verdict=reached
            IFS='|' read -r name map count <<<"$row"
            judge "$surface" 0.1 "$map" --size "${full_size:-$size}" --steps "$count" --binary-steps 8 --least-iou 0.98 --least-band 0.8 >"$scratch/one" 2>"$scratch/said" || { (($? == 4)) && verdict=missed; }
            jq -r --arg name "$surface, $name" --arg verdict $verdict "$cell"'"| \($name) | \(cell) | \(.depth_mean * 1000 | round / 1000), \(.depth_99 * 1000 | round / 1000) | \(.holes * 1e4 / .truth | round / 100) % | \(.steps_mean * 10 | round / 10), \(.steps_max) | \($verdict) |"' "$scratch/one"
        done
    done
}

by_depth() {
    header "$most steps" "${depths[@]}"
    for surface in "${surfaces[@]}"; do
        [[ $surface != torus-open ]] || continue
        for correction in none ray cone bent; do
            printf '| %s, %s |' "$surface" $correction
            for depth in "${depths[@]}"; do judge "$surface" "$depth" conservative --size $small_size --steps $most --binary-steps 5 --correction $correction | jq -r "$cell"' " \(cell) |"' | tr -d '\n'; done
            echo
        done
    done
}

by_steps() {
    header 'depth 0.1' "${steps[@]}"
    for surface in "${surfaces[@]}"; do
        [[ $surface != torus-open ]] || continue
        methods | grep -v 'no correction' | while IFS='|' read -r name map options; do
            printf '| %s, %s |' "$surface" "$name"
            # shellcheck disable=SC2086
            for count in "${steps[@]}"; do
                judge "$surface" 0.1 "$map" --size $small_size --steps "$count" --binary-steps 5 $options | jq -r "$cell"' " \(cell), holes \(.holes * 1e4 / .truth | round / 100) %, steps \(.steps_mean * 10 | round / 10) |"' | tr -d '\n'
            done
            echo
        done
    done
}

# A cylinder whose texture winds around it: frames lie 44 degrees across the curvature, and c holds what a and b cannot.
by_terms() {
    header 'winding texture, depth 0.1' 'a, b' 'a, b, c'
    for correction in ray cone bent; do
        printf '| %s |' $correction
        for terms in ab abc; do judge sheared 0.1 conservative --steps $most --binary-steps 5 --correction $correction --terms $terms | jq -r "$cell"' " \(cell), holes \(.holes * 1e4 / .truth | round / 100) % |"' | tr -d '\n'; done
        echo
    done
}

# 000's text as printed, in three units of the same mesh, beside the corrected one.
printed() {
    local scales=(0.1 1 10) surface
    header "$most steps, depth 0.1 of the radius" "${scales[@]/#/1 unit x }"
    for surface in "${surfaces[@]:0:3}"; do
        for scale in "${scales[@]}"; do
            radius[$surface-$scale]=$("$tool" bench surface "$surface" --segments "$(segments "$surface")" --scale "$scale" -o "$scratch/$surface-$scale.glb" --json | jq .radius)
            tiles[$surface-$scale]=${tiles[$surface]} views[$surface-$scale]=${views[$surface]} ends[$surface-$scale]=${ends[$surface]-}
        done
        for row in 'ray|conservative' 'ray-published|conservative' 'ray-published|relaxed' 'cone|conservative' 'cone-published|conservative' 'cone-published|relaxed'; do
            printf '| %s, %s cones, %s |' "$surface" "${row#*|}" "${row%|*}"
            for scale in "${scales[@]}"; do
                judge "$surface-$scale" 0.1 "${row#*|}" --size $small_size --steps $most --binary-steps 10 --correction "${row%|*}" | jq -r "$cell"' " \(cell), \(.depth_mean * 1000 | round / 1000), holes \(.holes * 1e3 / .truth | round / 10) % |"' | tr -d '\n'
            done
            echo
        done
    done
}

# Extrusions (004) beside the mesh displaced by the relief that each of them is.
by_kind() {
    local kinds=('basic|' 'extended, e 0.03|--e 0.03' 'bevelled, b 0.08|--b 0.08' 'chamfered, c 0.6|--b 0.08 --c 0.6') surface
    "$tool" shape "$here/data/shapes/flipper128.png" -o "$scratch/shape.png" --wrap repeat --antialiased --quiet
    header '25 steps, 5 halvings, depth 0.1' 'no correction' 'ray rectified (004)' 'as printed' 'bent (ours)' 'bent, 100 steps'
    for surface in "${surfaces[@]:0:3}"; do
        for kind in "${kinds[@]}"; do
            printf '| %s, %s |' "$surface" "${kind%|*}"
            for how in 'none 25' 'ray 25' 'ray-published 25' 'bent 25' 'bent 100'; do
                # shellcheck disable=SC2086 # options are words
                judge_shape "$surface" ${how% *} ${how#* } ${kind#*|} | jq -r "$cell"' " \(cell), \(.depth_mean * 1000 | round / 1000), steps \(.steps_mean * 10 | round / 10) |"' | tr -d '\n'
            done
            echo
        done
    done
}
judge_shape() {
    local surface=$1 correction=$2 steps=$3 where=${ends[$1]-}
    shift 3
    if [[ $correction == none ]]; then where=; fi
    # shellcheck disable=SC2086
    "$tool" verify "$scratch/shape.png" --mesh "$scratch/$surface.glb" --depth-scale "$(jq -n "0.1 * ${radius[$surface]}")" --mesh-tiles "${tiles[$surface]}" \
        ${views[$surface]} $where --json --size $small_size --correction "$correction" --steps "$steps" --binary-steps 5 "$@"
}

# The papers' figures: one view without and with correction beside the truth, what differs, and the numbers under each.
pictures() {
    local folder=$1
    mkdir -p "$folder"
    for surface in cylinder sphere torus vase; do
        local view=90,20 seen='' differs='' numbers=''
        if [[ $surface == torus ]]; then view=55,20; fi
        for correction in none ray bent; do
            local options=(--steps $most --binary-steps 5 --correction $correction)
            views[$surface]="--mesh-view $view"
            judge "$surface" 0.1 conservative --size $full_size "${options[@]}" >"$scratch/one"
            judge "$surface" 0.1 conservative --size 384x288 "${options[@]}" --pictures "$scratch/pictures" >/dev/null
            for plane in rendering difference; do mv "$scratch"/pictures/mesh-*-020-$plane.png "$folder/$surface-$correction-$plane.png"; done
            mv "$scratch"/pictures/mesh-*-020-truth.png "$folder/$surface-truth.png"
            seen+=" ![$surface, $correction](pictures/curved/$surface-$correction-rendering.png) |"
            differs+=" ![what differs](pictures/curved/$surface-$correction-difference.png) |"
            numbers+=$(jq -r "$cell"'" IoU, band, cut: \(cell); holes \(.holes), wrong cover \(.wrong_cover) pixels; depth error \(.depth_mean * 1000 | round / 1000), 99 %: \(.depth_99 * 1000 | round / 1000); \(.steps_mean * 10 | round / 10) steps |"' "$scratch/one")
        done
        [[ $surface == cylinder ]] || echo
        printf '| %s: no correction | ray rectified (000) | bent (ours) | displaced |\n| --- | --- | --- | --- |\n' "$surface"
        printf '|%s ![%s, displaced](pictures/curved/%s-truth.png) |\n|%s |\n|%s |\n' "$seen" "$surface" "$surface" "$differs" "$numbers"
    done
}

put() {
    tee "$scratch/table"
    if [[ $page ]]; then "$here/put_table.sh" "$page" "$1" <"$scratch/table"; fi
    echo
}
wanted() { [[ ! $only || " $only " == *" $1 "* ]]; }
if wanted goal; then
    goal | put goal
    if [[ $quick ]] && ! grep -q '100 steps.* reached' "$scratch/table"; then echo 'curved_table: the correction misses its goal' >&2 && exit 1; fi
fi
if wanted steps; then by_steps | put steps; fi
if wanted methods; then by_method | put methods; fi
if wanted terms; then by_terms | put terms; fi
if wanted printed; then printed | put printed; fi
if wanted extrusions; then by_kind | put extrusions; fi
if wanted depths; then by_depth | put depths; fi
if wanted pictures && [[ $page ]]; then pictures "$(dirname "$page")/pictures/curved" | put pictures; fi
