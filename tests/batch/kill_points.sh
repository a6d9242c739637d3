#!/usr/bin/env bash
# kill -9 at N moments spread over a batch, each followed by a rerun, whose files must equal those of an undisturbed run byte for byte
# without a stray temporary. Prints the table of docs/BATCH.md; exit code 1 where anything is otherwise.
#
#   tests/batch/kill_points.sh [N] [-o FILE.md]        N: 200 by default
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail
source "$(dirname "$0")/common.sh"

page='' points=200
while (($#)); do
    case $1 in
        -o) page=$2 && shift ;;
        [0-9]*) points=$1 ;;
        *) usage ;;
    esac
    shift
done

heights=$here/../data/heights
mkdir "$scratch/src"
for k in 1 2 3; do # the same maps under other names: more assets, not longer ones
    for name in gz_dem_squared_129.tif gz_dem_landscape_200x125.tif terrain3d_terrain1_crop128_half.exr; do cp "$heights/$name" "$scratch/src/$k$name"; done
done
cp "$heights/gz_dem_squared_129.tif" "$scratch/src/rock_mask.tif"
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0.7\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 1\n' >"$scratch/src/mesh.obj"

bake() { "$tool" batch "$scratch/src" --out "$1" --jobs 2 --cache "$scratch/cache.$2" --quiet; }
# What is in $1 and not in an undisturbed run.
foreign() { grep -vxFf "$scratch/expected" "$1" || true; }
begin=$(now)
bake "$scratch/whole" 0
whole=$(difference "$(now)" "$begin")
outputs_in "$scratch/whole" >"$scratch/expected"

hit=0 temporaries=0 unfinished=0
for ((k = 1; k <= points; ++k)); do
    rm -rf "$scratch/out" "$scratch"/cache.[1-9]*
    (exec "$tool" batch "$scratch/src" --out "$scratch/out" --jobs 2 --cache "$scratch/cache.$k" --quiet) & # exec: the kill must meet the tool
    pid=$!
    sleep "$(awk "BEGIN { print $whole * $k / $points }")"
    if kill -9 "$pid" 2>/dev/null; then hit=$((hit + 1)); fi
    wait "$pid" 2>/dev/null || true
    [[ -d $scratch/out ]] || mkdir "$scratch/out"
    (cd "$scratch/out" && find . -path ./.reliefbake -prune -o -type f ! -name '.reliefbake-*' -print | sort | xargs -rd '\n' sha256sum) >"$scratch/found"
    [[ -z $(foreign "$scratch/found") ]] || fail "kill $k left a file that is not whole: $(foreign "$scratch/found")"
    [[ $(wc -l <"$scratch/found") == $(wc -l <"$scratch/expected") ]] || unfinished=$((unfinished + 1))
    [[ -z $(find "$scratch/out" -name '.reliefbake-*.tmp') ]] || temporaries=$((temporaries + 1))
    bake "$scratch/out" "$k" || fail "the run after kill $k failed"
    outputs_in "$scratch/out" | diff "$scratch/expected" - >&2 || fail "the run after kill $k gave other files"
    [[ -z $(find "$scratch/out" -name '.reliefbake-*.tmp') ]] || fail "the run after kill $k left temporaries"
done
((hit * 10 >= points * 8)) || fail "only $hit of $points kills met a run at work"

put kills "$page" <<END
| killed with SIGKILL | |
| --- | ---: |
| moments, spread evenly over a run of $whole s with $(wc -l <"$scratch/expected") files | $points |
| kills that met the run at work | $hit |
| of these, runs with files still missing | $unfinished |
| runs that left a temporary, removed by the next | $temporaries |
| files that were not whole | 0 |
| reruns that differ from the undisturbed run in any byte | 0 |
END
