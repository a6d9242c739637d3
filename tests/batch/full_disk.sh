#!/usr/bin/env bash
# A disk that is full for real: a small tmpfs, which then grows. Needs root (mount). Prints the table of docs/BATCH.md; exit code 1
# where anything is otherwise than promised.
#
#   tests/batch/full_disk.sh [-o FILE.md]
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail
source "$(dirname "$0")/common.sh"

page=''
while (($#)); do
    case $1 in
        -o) page=$2 && shift ;;
        *) usage ;;
    esac
    shift
done
((EUID == 0)) || { echo "SKIPPED: mounting a tmpfs needs root" && exit 0; }

mkdir "$scratch/src" "$scratch/disk"
for k in 1 2 3 4 5 6; do cp "$here/../data/heights/gz_dem_squared_129.tif" "$scratch/src/map$k.tif"; done
"$tool" batch "$scratch/src" --out "$scratch/whole" --quiet
outputs_in "$scratch/whole" >"$scratch/expected"

rows=''
for option in size=200k size=400k nr_inodes=6; do
    mount -t tmpfs -o "$option" tmpfs "$scratch/disk"
    trap 'umount "$scratch/disk"; rm -rf "$scratch"' EXIT
    code=0
    "$tool" batch "$scratch/src" --out "$scratch/disk/out" --jobs 1 >"$scratch/events" 2>"$scratch/err" || code=$?
    [[ $code == 74 ]] || fail "$option: expected exit code 74, found $code: $(cat "$scratch/err")"
    grep -q 'No space left' "$scratch/err" || fail "$option: does not say that the disk is full: $(cat "$scratch/err")"
    [[ -z $(find "$scratch/disk" -name '.reliefbake-*.tmp') ]] || fail "$option: left temporaries"
    outputs_in "$scratch/disk/out" >"$scratch/found"
    [[ -z $(grep -vxFf "$scratch/expected" "$scratch/found") ]] || fail "$option: left a file that is not whole"
    left=$(wc -l <"$scratch/found")
    mount -o remount,size=64m,nr_inodes=1000 "$scratch/disk"
    "$tool" batch "$scratch/src" --out "$scratch/disk/out" --quiet || fail "$option: the run on the grown disk failed"
    outputs_in "$scratch/disk/out" | diff "$scratch/expected" - >&2 || fail "$option: the run on the grown disk gave other files"
    rows+="| \`$option\` | $code | $left of $(wc -l <"$scratch/expected") | all, the same bytes |"$'\n'
    umount "$scratch/disk"
    trap 'rm -rf "$scratch"' EXIT
done

put disk "$page" <<END
| tmpfs | exit code | whole files | after it has grown |
| --- | ---: | ---: | --- |
${rows%$'\n'}
END
