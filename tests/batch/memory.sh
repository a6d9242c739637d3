#!/usr/bin/env bash
# Peak memory of tool and helpers together (proportional set size, sampled), beside what was predicted, and a ceiling kept by many jobs.
# Prints the table of docs/BATCH.md; exit code 1 where a prediction is exceeded.
#
#   tests/batch/memory.sh [--large] [-o FILE.md]
#
#   --large  maps of 16384 x 16384, too, one of them out of core (16 GB of memory, minutes)
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail
source "$(dirname "$0")/common.sh"

page='' large=''
while (($#)); do
    case $1 in
        --large) large=yes ;;
        -o) page=$2 && shift ;;
        *) usage ;;
    esac
    shift
done

# noise SIDE > FILE.pgm: white noise, which compresses worst.
noise() { printf 'P5\n%d %d\n255\n' "$1" "$1" && { openssl enc -aes-128-ctr -nosalt -pass pass:x -pbkdf2 </dev/zero 2>/dev/null || true; } | head -c $(($1 * $1)); }
# smooth SIDE > FILE.pgm: rows of one slope; a bake of it takes as much memory and little time.
smooth() { printf 'P5\n%d %d\n255\n' "$1" "$1" && head -c "$1" /dev/zero | tr '\0' '\200' >"$scratch/row" && for ((y = 0; y < $1; ++y)); do cat "$scratch/row"; done; }

# peak COMMAND...: its largest memory with all its children, in MB.
peak() {
    "$@" >/dev/null &
    local pid=$! most=0 now
    while [[ -d /proc/$pid ]] && kill -0 "$pid" 2>/dev/null; do
        now=0
        for process in $pid $(cat "/proc/$pid/task/"*/children 2>/dev/null); do
            now=$((now + $(awk '/^Pss:/ { print $2 }' "/proc/$process/smaps_rollup" 2>/dev/null || echo 0)))
        done
        ((now <= most)) || most=$now
        sleep 0.02
    done
    wait "$pid"
    echo $((most / 1000))
}

rows=''
# measure NAME RULE LIMITS...: bakes src with a recipe of this rule, adds a row.
measure() {
    local name=$1 rule=$2 ceiling most predicted
    shift 2
    printf '[[rule]]\nfiles = ["*"]\n[[rule.bake]]\n%s\n' "$rule" >"$scratch/r.toml"
    rm -rf "$scratch/out"
    predicted=$("$tool" batch "$scratch/src" --out "$scratch/out" --recipe "$scratch/r.toml" --dry-run | jq -s 'map(select(.event == "planned").bytes_predicted) | max / 1e6 | floor')
    most=$(peak "$tool" batch "$scratch/src" --out "$scratch/out" --recipe "$scratch/r.toml" --quiet "$@")
    ceiling=$predicted
    [[ ${1-} != --memory ]] || ceiling=${2%MB}
    rows+="| $name | $predicted | $ceiling | $most |"$'\n'
    ((most <= ceiling)) || fail "$name: took $most MB, more than $ceiling MB"
}

mkdir "$scratch/src"
noise 3000 >"$scratch/src/a.pgm"
measure 'cone, 16 bits, 3000 x 3000' 'kind = "cone"'
measure 'cone, float EXR' $'kind = "cone"\noutput = "{stem}.exr"'
measure 'cone with mips, 16 bits' $'kind = "cone"\noptions = ["--mips"]\noutput = "{stem}.tif"'
measure 'acm, 4 sectors, float EXR' 'kind = "acm"'
measure 'acm, 8 sectors, float EXR' $'kind = "acm"\noptions = ["--sectors", "8"]'
measure 'cone-stack, 3 levels, float EXR' $'kind = "cone-stack"\noptions = ["--levels", "3"]'
measure 'shape, 16 bits' 'kind = "shape"'
measure 'bump, horizons' $'kind = "bump"\noptions = ["--kind", "horizon"]'
for k in b c d e f g h; do cp "$scratch/src/a.pgm" "$scratch/src/$k.pgm"; done
measure 'eight of them, 4 jobs, --memory 1200MB' 'kind = "cone"' --memory 1200MB --jobs 4 --threads 4
if [[ $large ]]; then
    rm "$scratch"/src/*
    smooth 16384 >"$scratch/src/large.pgm"
    measure 'cone, 16 bits, 16384 x 16384' 'kind = "cone"'
    rm "$scratch"/src/*
    "$tool" bench terrain -o "$scratch/src/terrain.tif" --width 16384 --height 16384
    measure 'cone, half EXR, 16384 x 16384, --memory 2000MB' $'kind = "cone"\noptions = ["--bits", "half"]\noutput = "{stem}.exr"' --memory 2000MB
fi

put memory "$page" <<END
| bake | predicted, MB | ceiling, MB | peak, MB |
| --- | ---: | ---: | ---: |
${rows%$'\n'}
END
