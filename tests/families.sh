# shellcheck shell=bash disable=SC2034
# Sourced by the scripts of this folder: the tool, the height maps, and every family of cones with the command that bakes it.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
this=${0##*/} this=${this%.sh}
export tool=${RELIEFBAKE_BINARY:-$here/../build/release/bin/reliefbake}
export MESA_SHADER_CACHE_DISABLE=true OMP_NUM_THREADS=1 LP_NUM_THREADS=1

# Name | command that bakes it | cones a texel | whether rays that pass through are promised away.
families() {
    cat <<'END'
conservative|cone|1|yes
conservative, cell lookup|cone --lookup cell|1|yes
cone normal|cone-normal|1|yes
cone normal, relaxed|cone-normal --kind relaxed|1|yes
relaxed, strict|cone --kind relaxed|1|yes
relaxed, slope:4|cone --kind relaxed --relaxed slope:4|1|no
relaxed, top|cone --kind relaxed --relaxed top|1|no
hybrid, delta 0.05|cone --kind hybrid --delta 0.05|1|yes
4 sectors|acm --sectors 4|4|yes
4 sectors, relaxed|acm --sectors 4 --kind relaxed|4|yes
8 sectors|acm --sectors 8|8|yes
8 sectors, relaxed|acm --sectors 8 --kind relaxed|8|yes
4 sectors, adaptive (002)|acm --sectors 4 --method adaptive|4|no
3 stacked cones|cone-stack --levels 3|3|yes
3 pieces|cone-stack --levels 3 --method 2|3|yes
END
}

# Sets source_options to what the file does not say of itself.
set_source_options() {
    source_options=()
    case ${1##*/} in
        *_depth_*) source_options=(--input depth) ;;
        *_NM_height.tga) source_options=(--channel A) ;;
    esac
}

require_tools() {
    command -v jq >/dev/null || { echo "$this: needs jq (apt install jq)" >&2 && exit 2; }
    [[ -x $tool ]] || { echo "$this: no $tool: build first, or set RELIEFBAKE_BINARY" >&2 && exit 2; }
}

# Sets heights to the folder of the large set, or with an argument that is not empty to that of the bundled maps.
set_heights() {
    heights=${RELIEFBAKE_DATA:-$here/../../shared/data}/heights
    if [[ ${1-} ]]; then heights=$here/data/heights
    elif [[ ! -d $heights ]]; then
        echo "$this: SKIPPED the large set: no $heights (RELIEFBAKE_DATA names its parent); taking the bundled maps" >&2
        heights=$here/data/heights
    fi
}

# Sets maps to those of the four that docs look at closely that are there; after set_heights.
set_close_maps() {
    local name
    maps=()
    for name in ambientcg_Moss001_1K_Displacement.png ambientcg_RoofingTiles009_1K_Displacement.png polyhaven_metal_plate_disp_1k.png bgfx_heightmap_float.exr; do
        [[ ! -f $heights/$name ]] || maps+=("$heights/$name")
    done
}

# Runs a command; its complaints are shown only when it fails. Needs scratch.
quietly() {
    local code=0
    "$@" 2>"$scratch/said" || code=$?
    ((code == 0)) || cat "$scratch/said" >&2
    return $code
}

machine() { sed -n 's/^model name.*: //p' /proc/cpuinfo | head -1; }
