#!/usr/bin/env bash
# tests/large/equal_8192.sh [--size N]: a map baked at once, out of core, and by two bands merged: the same bytes, or exit code 1.
set -euo pipefail
size=8192 half=
[[ ${1-} == --size ]] && size=$2
root=$(cd "$(dirname "$0")/../.." && pwd)
tool=${RELIEFBAKE:-$root/build/release/bin/reliefbake}
work=$(mktemp -d "${TMPDIR:-/tmp}/large.XXXXXX")
trap 'rm -rf "$work"' EXIT
cd "$work"
"$tool" bench terrain -o terrain.tif --width "$size" --height "$size"
"$tool" cone terrain.tif -o whole.exr --bits half --memory 64GiB --quiet
"$tool" cone terrain.tif -o large.exr --bits half --out-of-core --memory 1GiB --quiet
cmp whole.exr large.exr
rm large.exr
half=$((size / 128 * 64))
"$tool" cone terrain.tif -o 0.band --bits half --rows "0:$half" --memory 1GiB --quiet
"$tool" cone terrain.tif -o 1.band --bits half --rows "$half:$size" --memory 1GiB --quiet
"$tool" merge 1.band 0.band -o merged.exr --quiet
cmp whole.exr merged.exr
echo "$size x $size: in core, out of core within 1 GiB, and merged from two bands: the same $(stat -c %s whole.exr) bytes"
