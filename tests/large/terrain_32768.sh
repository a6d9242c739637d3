#!/usr/bin/env bash
# tests/large/terrain_32768.sh [--cgroup] [-o docs/LARGE.md] [SIZE:MEMORY...]: bakes fractal terrains of SIZE x SIZE texels out of core within MEMORY
# (8192:1GiB 32768:4GiB) and prints a row of docs/LARGE.md for each; then 16 texels at random are compared with all others (exit code 4 when
# one stands in a cone). --cgroup, as root: within a memory cgroup of that size, which counts the page cache as well.
# 32768 wants 15 GiB of disk: 2 of terrain, 4 of heights, 4 of rows that wait, and the map.
set -euo pipefail
page= cgroup=
while [[ ${1-} == -* ]]; do
    case $1 in
    --cgroup) cgroup=/sys/fs/cgroup/memory ;;
    -o) page=$(realpath "$2") && shift ;;
    *) echo "terrain_32768: unknown option $1" >&2 && exit 2 ;;
    esac
    shift
done
(($#)) || set -- 8192:1GiB 32768:4GiB
root=$(cd "$(dirname "$0")/../.." && pwd)
. "$root/tests/large/peak.sh"
tool=${RELIEFBAKE:-$root/build/release/bin/reliefbake}
check=${CHECK_TEXELS:-$root/build/release/bin/check_texels}
work=$(mktemp -d "${TMPDIR:-/tmp}/large.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"

# Runs a command in a cgroup (version 1, or 2) of $1 bytes.
confined() (
    local group=$cgroup/reliefbake.$BASHPID limit=memory.limit_in_bytes
    [[ -d $cgroup ]] || group=/sys/fs/cgroup/reliefbake.$BASHPID limit=memory.max
    mkdir "$group"
    trap 'until rmdir "$group" 2>/dev/null; do sleep 0.1; done' EXIT # the helper leaves a moment after the tool
    numfmt --from=auto "${1%B}" >"$group/$limit"
    shift
    (echo "$BASHPID" >"$group/cgroup.procs" && exec "$@")
)

bake() {
    local size=$1 memory=$2
    "$tool" bench terrain -o terrain.tif --width "$size" --height "$size"
    local run=(peak all)
    [[ -z $cgroup ]] || run=(peak all confined "$memory")
    "${run[@]}" "$tool" cone terrain.tif -o map.exr --bits half --channels cone,depth --wrap clamp --out-of-core --memory "$memory" --json >result.json
    jq -r --arg all "$(cat all)" --arg memory "$memory${cgroup:+, cgroup}" '
        .out_of_core as $o | .seconds as $s | $o.rows[1] as $n | def mib: . / 1048576 | round; def each: . * 1e9 / ($n * $n) | round;
        "| \($n) x \($n) | \($memory) | \($all | tonumber * 1024 | mib) MiB | \(if $o.pyramid_in_memory then "memory" else "disk" end) | \($o.working_space | mib) MiB | \($s.total | round) s | \($s.cone | each) | \($s.write | each) | \($s.total | each) |"' result.json
    "$check" map.exr 16 >&2
}

rows=$(for run in "$@"; do bake "${run%:*}" "${run#*:}"; done)
table="| terrain | ceiling | peak | pyramid in | disk meanwhile | time | cones, ns/texel | writing | all |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
$rows"
if [[ -n $page ]]; then "$root/tests/put_table.sh" "$page" <<<"$table"; else echo "$table"; fi
