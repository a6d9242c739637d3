#!/usr/bin/env bash
# Bakes bump maps of the bundled heights, verifies them, and prints the tables of docs/BUMP.md.
#
#   tests/bump_table.sh [-o FILE.md]     -o: put the tables into FILE.md too (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY   the tool (default build/release/bin/reliefbake)
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
export MESA_SHADER_CACHE_DISABLE=true
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

maps=(ambientcg_RoofingTiles009_512.png bevy_parallax_cube_depth_348.png gz_dem_squared_129.tif pom_rocks_NM_height.tga)
for map in "${maps[@]}"; do
    source=("$here/data/heights/$map" --wrap repeat --quiet)
    case $map in
        *_depth_*) source+=(--input depth) ;;
        *_NM_height.tga) source+=(--channel A) ;;
    esac
    for kind in derivative normal horizon; do
        for bits in 8 16 half float; do
            case $kind/$bits in
                horizon/8 | horizon/16) continue ;; # two files without depth; the codes are those of the others
                */8 | */16) out=$scratch/map.png ;;
                *) out=$scratch/map.exr ;;
            esac
            "$tool" bump "${source[@]}" --kind "$kind" --bits "$bits" -o "$out"
            "$tool" verify "$out" --json | jq -c --arg map "$map" --arg kind "$kind" --arg bits "$bits" '{map: $map, kind: $kind, bits: $bits} + .'
        done
    done
done >"$scratch/lines"

jq -rs '
    def percent: . * 1e4 | round | . / 1e2 | tostring | . + " %";
    def mean(f): (map(f) | add) / length;
    "| map | sun | in shadow | horizons: wrong pixels | of them lit | march of 64 steps: wrong pixels |",
    "| --- | --- | ---: | ---: | ---: | ---: |",
    (.[] | select(.kind == "horizon" and .bits == "float") | .map as $map
     | (.shadows | map(. + {place: (if .sun_azimuth == 112.5 then "half-way between two azimuths" elif .sun_azimuth == 350 then "10 degrees from an azimuth" else "along an azimuth" end)})
        | group_by(.place)[])
     | "| \($map) | \(.[0].place) | \(mean(.dark) | percent) | \(mean(.horizons.disagreement) | percent) | \(mean(.horizons.leaks) | percent) | \(mean(.march.disagreement) | percent) |"),
    "",
    "| kind | bits | values | beyond the stated error | worst error over the stated one |",
    "| --- | --- | ---: | ---: | ---: |",
    (group_by([.kind, .bits])[]
     | "| \(.[0].kind) | \(.[0].bits) | \(map(.points) | add) | \(map(.violations) | add) | \(map(.worst.error / .bound) | max | . * 1e3 | round | . / 1e3) |")
    ' "$scratch/lines" | tee "$scratch/table"
if [[ ${1-} == -o ]]; then "$here/put_table.sh" "$2" <"$scratch/table"; fi
