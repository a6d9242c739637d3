#!/usr/bin/env bash
# Installs the tool and builds assets_example under Ninja and Makefiles: what is baked again, and what that builds again.
#
#   tests/package/assets_example.sh BUILD_DIR
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) build=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "assets_example: $*" >&2 && exit 1; }
cmake --install "$build" --prefix "$scratch/prefix" >/dev/null

try() {
    local generator=$1 home="$scratch/$1 of mine" # a space in every path
    cp -r "$here/assets_example" "$home"
    cp "$here/../data/heights/gz_dem_squared_129.tif" "$home/first.tif"
    cp "$here/../data/heights/gz_dem_squared_129.tif" "$home/second.tif"
    { printf 'P5 129 129 255\n' && head -c 16641 /dev/zero | tr '\0' '\377'; } >"$home/mask.pgm" # solid everywhere
    cmake -S "$home" -B "$home/build" -G "$generator" -DCMAKE_PREFIX_PATH="$scratch/prefix" >"$scratch/said" 2>&1 || { cat "$scratch/said" >&2 && fail "$generator: cannot configure"; }
    local notes="$home/build/CMakeFiles/reliefs.reliefbake"
    # rebuild WHAT FIRST SECOND PACK: builds; then how many times in all each bake and the pack have run.
    local -A runs=([first]=0 [second]=0) seen=([first]='' [second]='')
    rebuild() {
        sleep 1.1 # make compares seconds on some file systems
        cmake --build "$home/build" >"$scratch/said" 2>&1 || { cat "$scratch/said" >&2 && fail "$generator, $1: does not build"; }
        local name time
        for name in first second; do
            time=$(stat -c %y "$notes/${name}_cone.exr.stamp")
            [[ $time == "${seen[$name]}" ]] || runs[$name]=$((${runs[$name]} + 1))
            seen[$name]=$time
        done
        local found="${runs[first]} ${runs[second]} $(wc -l <"$home/build/packed.log")"
        [[ $found == "$2" ]] || { cat "$scratch/said" >&2 && fail "$generator, $1: expected $2 runs of first, second and pack; found $found"; }
    }
    rebuild 'all is new' '1 1 1'
    rebuild 'nothing has changed' '1 1 1'
    sleep 1.1 && touch "$home/first.tif"
    rebuild 'first touched' '2 1 1'
    rebuild 'nothing has changed since' '2 1 1'
    sleep 1.1 && "$scratch/prefix/bin/reliefbake" bump "$home/first.tif" -o "$home/second.tif" --kind normal --quiet
    rebuild 'second is another picture' '2 2 2'
    sleep 1.1 && touch "$home/mask.pgm" # known by the depfile alone
    rebuild 'the mask touched' '3 3 2'
    echo "$generator: as expected"
}
command -v ninja >/dev/null && try Ninja
command -v make >/dev/null && try 'Unix Makefiles'
