# shellcheck shell=bash disable=SC2034
# Sourced by the scripts of this folder: the tool, the data, a scratch folder that goes away.
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
this=${0##*/}
tool=${RELIEFBAKE_BINARY:-$here/../../build/release/bin/reliefbake}
data=${RELIEFBAKE_DATA:-$here/../../../shared/data}
export LC_ALL=C

usage() { sed -n '2,/^set /p' "$0" | sed -n 's/^# \{0,1\}//p' >&2 && exit 2; }
fail() { echo "$this: $*" >&2 && exit 1; }

[[ -x $tool ]] || fail "no $tool: build first, or set RELIEFBAKE_BINARY"
command -v jq >/dev/null || fail "needs jq (apt install jq)"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# The files that a batch wrote into $1, with their hashes, one a line.
outputs_in() { (cd "$1" && find . -path ./.reliefbake -prune -o -type f -print | sort | xargs -rd '\n' sha256sum); }
# One value of a run's summary: summary FOLDER KEY.
summary() { jq -r ".$2" "$1/.reliefbake/summary.json"; }
now() { date +%s.%N; }
# difference A B: A - B with three digits.
difference() { awk "BEGIN { printf \"%.3f\", $1 - $2 }"; }
# put TABLE_NAME FILE.md < TABLE, or to stdout without a file.
put() { if [[ $2 ]]; then "$here/../put_table.sh" "$2" "$1"; else cat; fi; }
