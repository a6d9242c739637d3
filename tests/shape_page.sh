#!/usr/bin/env bash
# Draws the pictures of docs/EXTRUSION.md and measures what they show; prints the table beside them.
#
#   tests/shape_page.sh [--rays N] [-o docs/EXTRUSION.md]
#
#   --rays   rays of each measurement (default 60000)
#   -o       put the table into FILE.md (tests/put_table.sh), and the pictures into pictures/solids beside it; else only the table
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
data=${RELIEFBAKE_DATA:-$here/../../shared/data}
export MESA_SHADER_CACHE_DISABLE=true

rays=60000 page=
while (($#)); do
    case $1 in
        --rays) rays=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,10s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
command -v jq >/dev/null || { echo "shape_page: needs jq (apt install jq)" >&2 && exit 2; }
[[ -d $data/shapes ]] || { echo "shape_page: SKIPPED: no $data/shapes (RELIEFBAKE_DATA names its parent)" >&2 && exit 0; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
pictures=$scratch
if [[ $page ]]; then pictures=$(dirname "$page")/pictures/solids && mkdir -p "$pictures"; fi

# Half the outline of a vase beside the axis, anti-aliased: foot, belly, neck, lip; hollow from above.
awk 'function radius(v) { return v > 0.94 ? 0.30 : v > 0.88 ? 0.30 - 1.6 * (0.94 - v) : v < 0.05 ? 0.27 : 0.22 + 0.16 * sin(3.14159 * (v - 0.12) * 1.28)^3 }
    function clamp(x) { return x < 0 ? 0 : x > 1 ? 1 : x }
    BEGIN {
        w = 300; h = 768; print "P2", w, h, 255
        for (j = 0; j < h; ++j) for (i = 0; i < w; ++i) {
            v = (j + 0.5) / h; r = radius(v)
            outer = clamp(512 * r - i); inner = v < 0.9 ? clamp(512 * (r - 0.035) - i) : 0
            print int(255 - 255 * (outer - inner) + 0.5)
        }
    }' >"$scratch/vase.pgm"

# Anti-aliased: their walls are smooth.
bake() {
    local name=$1 source=$2
    shift 2
    "$tool" shape "$source" -o "$scratch/$name.exr" --antialiased --quiet "$@" 2>"$scratch/said"
}
bake gear "$data/shapes/bsicon_gear-wide-connected_1024.png"
bake glyph "$data/shapes/glyph_dejavuserif_ampersand_1024.png" --invert
bake tiling "$data/shapes/flipper128.png" --wrap repeat
bake text "$data/shapes/sdf_text_and_dots.png"
bake vase "$scratch/vase.pgm"
"$tool" cone "$data/shapes/bsicon_gear-wide-connected_1024.png" --channel A -o "$scratch/gear.cone.exr" --wrap clamp --depth-uv 0.2 --kind relaxed --quiet
"$tool" bump "$here/data/heights/ambientcg_RoofingTiles009_512.png" -o "$scratch/roof.bump.exr" --quiet

# draw NAME MAP OPTIONS...
draw() {
    local name=$1 map=$2
    shift 2
    "$tool" render "$scratch/$map.exr" -o "$pictures/$name.png" --size 256x192 --supersample 4 "$@"
}
plane=(--view 50 --azimuth 20 --shadow hard)
box=(--on box --view 58 --azimuth 20 --depth-scale 0.25)
turned=(--solid revolution --view 75 --azimuth 30 --steps 100)

# 004, figure 6.
draw extrusion-basic gear "${plane[@]}"
draw extrusion-extended gear "${plane[@]}" --e 0.03
draw extrusion-bevelled gear "${plane[@]}" --b 0.08
draw extrusion-chamfered gear "${plane[@]}" --b 0.08 --c 0.5
draw box-basic gear "${box[@]}"
draw box-chamfered gear "${box[@]}" --b 0.08 --c 0.6
draw tiling tiling --tiles 3 --view 45 --azimuth 20 --shadow hard --steps 100
draw glyph glyph --view 40 --azimuth -15 --shadow hard --b 0.02 --c 0.4
# 003, figures 6, 10, 11.
for e in 0 0.06 0.12; do draw "vase-e-$e" vase "${turned[@]}" --e $e; done
for b in 0.1 0.2 0.4; do draw "vase-b-$b" vase "${turned[@]}" --b $b; done
for c in 0.25 0.5 0.75; do draw "vase-c-$c" vase "${turned[@]}" --b 0.4 --c $c; done
# 003, figures 12 and 13.
draw vase-bumps vase "${turned[@]}" --bump "$scratch/roof.bump.exr" --bump-scale 0.03 --texture-tiles 4,2
draw vase-texture vase "${turned[@]}" --texture "$here/data/heights/ambientcg_RoofingTiles009_512.png" --bump "$scratch/roof.bump.exr" --bump-scale 0.03 --texture-tiles 4,2
draw gear-turned gear "${turned[@]}" --axis 0.1
draw glyph-turned glyph "${turned[@]}" --axis 0.25
draw repeated tiling "${turned[@]}" --tiles 3
# 000, figure 39.
"$tool" render "$scratch/gear.cone.exr" -o "$pictures/cone-map.png" --size 256x192 --supersample 4 --view 50 --azimuth 20
# The printed scheme beside the corrected one, the papers' counts.
for scheme in published corrected; do draw $scheme text --view 72 --azimuth 60 --span 0.6 --b 0.1 --scheme $scheme; done

# measure TITLE MAP NAME OPTIONS...: the named solid of a verification, as a row.
measure() {
    local title=$1 map=$2 name=$3
    shift 3
    { "$tool" verify "$scratch/$map.exr" --rays "$rays" --points 0 --json "$@" || true; } |
        jq -r --arg title "$title" --arg name "$name" '.solids[] | select(.name == $name) |
            "| \($title) | \(.rays) | \(.missed * 1e4 / .rays | round / 100) % | \(.early * 1e4 / .rays | round / 100) % | \(.out_of_steps * 1e4 / .rays | round / 100) % | \(.gap_mean * 1e7 | round / 1e4) | \(.normal_mean * 100 | round / 100) | \(.steps_mean * 10 | round / 10) | \(.steps_max) |"'
}
# cones TITLE MAP: the same figures of a cone map.
cones() {
    { "$tool" verify "$scratch/$2.exr" --rays "$((rays / 12))" --points 0 --crop 0 --json || true; } |
        jq -r --arg title "$1" '"| \($title) | \(.rays) | \(.missed * 1e4 | round / 100) % | \(.early * 1e4 | round / 100) % | \(.out_of_steps * 1e4 | round / 100) % | | | \(.steps_mean * 10 | round / 10) | \(.steps_max) |"'
}
{
    printf '| solid | rays | missed | early | no end | gap, 1/1000 width | normal, degrees | steps, mean | max |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n'
    measure 'gear, basic' gear 'extrusion, basic, plane'
    measure 'gear, e 0.03' gear 'extrusion, extended, plane' --e 0.03
    measure 'gear, b 0.08' gear 'extrusion, bevelled, plane' --b 0.08
    measure 'gear, b 0.08, c 0.5' gear 'extrusion, chamfered, plane' --e 0 --b 0.08 --c 0.5
    measure 'gear, basic, 25 steps and 5 halvings' gear 'extrusion, basic, plane' --steps 25 --binary-steps 5
    measure 'gear, b 0.08, 25 and 5' gear 'extrusion, bevelled, plane' --b 0.08 --steps 25 --binary-steps 5
    measure 'gear, b 0.08, printed scheme, 25 and 5' gear 'extrusion, bevelled, plane' --b 0.08 --steps 25 --binary-steps 5 --scheme published
    measure 'gear, b 0.3, 25 and 5' gear 'extrusion, bevelled, plane' --b 0.3 --steps 25 --binary-steps 5
    measure 'gear, b 0.3, printed scheme, 25 and 5' gear 'extrusion, bevelled, plane' --b 0.3 --steps 25 --binary-steps 5 --scheme published
    measure 'text, b 0.1, 25 and 5' text 'extrusion, bevelled, plane' --b 0.1 --steps 25 --binary-steps 5
    measure 'text, b 0.1, printed scheme, 25 and 5' text 'extrusion, bevelled, plane' --b 0.1 --steps 25 --binary-steps 5 --scheme published
    cones 'gear as a relaxed cone map' gear.cone
    for e in 0.06 0.12; do measure "vase, e $e" vase 'revolution, extended, box' --e $e; done
    for b in 0.1 0.4; do measure "vase, b $b" vase 'revolution, bevelled, box' --b $b; done
    for c in 0.25 0.75; do measure "vase, b 0.4, c $c" vase 'revolution, chamfered, box' --e 0 --b 0.4 --c $c; done
    measure 'vase, b 0.4, 20 and 10' vase 'revolution, bevelled, box' --b 0.4 --steps 20 --binary-steps 10
    measure 'vase, b 0.4, printed scheme, 20 and 10' vase 'revolution, bevelled, box' --b 0.4 --steps 20 --binary-steps 10 --scheme published
    measure 'glyph, turned about u 0.25' glyph 'revolution, basic, box' --axis 0.25
} | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" pictures <"$scratch/table"; fi
