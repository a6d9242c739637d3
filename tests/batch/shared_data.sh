#!/usr/bin/env bash
# Bakes the whole of the large set by one command; the failures must be those of expected_failures.txt, and a second run must do nothing
# within 2 seconds. Prints the table of docs/BATCH.md; exit code 1 where anything is otherwise.
#
#   tests/batch/shared_data.sh [--list] [-o FILE.md]
#
#   --list  print the failures as expected_failures.txt has them, and stop
#   -o      put the table into FILE.md (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail
source "$(dirname "$0")/common.sh"

page='' list=''
while (($#)); do
    case $1 in
        --list) list=yes ;;
        -o) page=$2 && shift ;;
        *) usage ;;
    esac
    shift
done
[[ -d $data/heights ]] || { echo "SKIPPED: $data is missing" && exit 0; }

bake() { "$tool" batch "$data" --out "$scratch/out" --name '{stem}_{from}_{kind}' 2>"$scratch/err" >"$scratch/events" || code=$?; }

code=0 begin=$(now)
bake
first=$(difference "$(now)" "$begin")
[[ $code == 3 ]] || fail "expected exit code 3, found $code: $(cat "$scratch/err")"
jq -r '.failures[].source' "$scratch/out/.reliefbake/summary.json" | sort >"$scratch/failures"
if [[ $list ]]; then cat "$scratch/failures" && exit; fi
diff "$here/expected_failures.txt" "$scratch/failures" >&2 || fail "the failures are not those of expected_failures.txt"
assets=$(summary "$scratch/out" assets) baked=$(summary "$scratch/out" baked) failed=$(summary "$scratch/out" failed) skipped=$(summary "$scratch/out" skipped_files)
outputs_in "$scratch/out" >"$scratch/before"

code=0 begin=$(now)
bake
second=$(difference "$(now)" "$begin")
[[ $code == 3 ]] || fail "the second run: expected exit code 3, found $code"
! grep -q '"event":"start"' "$scratch/events" || fail "the second run baked: $(grep '"event":"start"' "$scratch/events" | head -n 1)"
[[ $(summary "$scratch/out" failed_before) == "$failed" ]] || fail "the second run met other failures"
outputs_in "$scratch/out" | diff "$scratch/before" - >&2 || fail "the second run changed files"
awk "BEGIN { exit !($second < 2) }" || fail "the second run took $second s"

put shared "$page" <<END
| the large set | |
| --- | ---: |
| files that are no assets | $skipped |
| assets | $assets |
| baked | $baked |
| refused, exactly those of \`tests/batch/expected_failures.txt\` | $failed |
| first run | $first s |
| second run: nothing started, refusals included | $second s |
END
