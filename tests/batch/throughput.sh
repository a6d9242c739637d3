#!/usr/bin/env bash
# A folder of 100 maps, one job against as many as there are processors, and one process a map. Prints the table of docs/BATCH.md; exit
# code 1 where the batch is not at least 1.8 times as fast with two processors.
#
#   tests/batch/throughput.sh [-o FILE.md]
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail
source "$(dirname "$0")/common.sh"

page='' maps=100
while (($#)); do
    case $1 in
        -o) page=$2 && shift ;;
        *) usage ;;
    esac
    shift
done

mkdir "$scratch/src"
sources=("$here"/../data/heights/ambientcg_RoofingTiles009_512.png "$here"/../data/heights/bevy_parallax_cube_depth_348.png)
for ((k = 0; k < maps; ++k)); do cp "${sources[k % 2]}" "$scratch/src/map$k.png"; done
find "$scratch/src" -type f -exec cat {} + >/dev/null

seconds_of() {
    local begin
    begin=$(now)
    "$@" >/dev/null
    difference "$(now)" "$begin"
}
batch() { rm -rf "$scratch/out" && "$tool" batch "$scratch/src" --out "$scratch/out" --quiet "$@"; }
apart() { for file in "$scratch"/src/*; do "$tool" cone "$file" -o "$scratch/one.png" --threads 1 --quiet 2>/dev/null; done; }

cores=$(nproc)
one=$(seconds_of batch --jobs 1 --threads 1)
all=$(seconds_of batch --jobs "$cores" --threads "$cores")
inside=$(seconds_of batch --jobs 1 --threads "$cores")
processes=$(seconds_of apart)
gain=$(awk "BEGIN { printf \"%.2f\", $one / $all }")
row() { echo "| $1 | $2 | $(awk "BEGIN { printf \"%.2f\", $one / $2 }") |"; }

put throughput "$page" <<END
| $maps maps of 512 and 348 texels a side, $cores processors | seconds | times as fast |
| --- | ---: | ---: |
$(row "one job, one thread" "$one")
$(row "$cores jobs (the default)" "$all")
$(row "one job, $cores threads" "$inside")
$(row "one process a map, one after the other, one thread" "$processes")
END
((cores < 2)) || awk "BEGIN { exit !($gain >= 1.8) }" || fail "$cores jobs are only $gain times as fast as one"
