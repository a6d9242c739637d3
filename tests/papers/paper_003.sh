#!/usr/bin/env bash
# Tables 1 to 3 of 003 (revolution-bump mapping, extended, bevelled, chamfered), measured anew: a table of docs/PAPERS.md.
#
#   tests/papers/paper_003.sh [--quick] [-o FILE.md]
#
#   --quick   fewer rays
#   -o        put the table into FILE.md (tests/put_table.sh)
#
# Published: frames a second on a GeForce GT 630M, 20 linear and 10 binary steps (p. 34 f.). Ours: mean steps and texture reads a ray of `verify`, over four views; with 20 and 10,
# and with steps enough. e and b are taken for shares of the largest distance, the code 1 of the papers' maps. Costs alone: bumps are shaded after the march and add the same to each.
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/../families.sh"

rays=24000 page=''
while (($#)); do
    case $1 in
        --quick) rays=4000 ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,12s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
unit=$("$tool" shape "$here/data/shapes/flipper128.png" -o "$scratch/shape.png" --antialiased --json | jq .map.tau)

# cost SOLID OPTIONS...: steps, reads, share without an end
cost() {
    local solid=$1
    shift
    "$tool" verify "$scratch/shape.png" --json --rays $rays --points 1000 "$@" >"$scratch/report" || (($? == 4))
    jq -r --arg solid "$solid" '.solids[] | select(.name == $solid) | "\(.steps_mean * 10 | round / 10), \(.fetches_mean * 10 | round / 10), \(.out_of_steps * 1000 / .rays | round / 10) %"' "$scratch/report"
}

table() {
    local row label solid options published how
    echo '| | published, frames a second: 800 x 600; 1366 x 706 | as printed, 20 and 10: steps, reads, no end | corrected, 20 and 10 | corrected, steps enough |'
    echo '| --- | ---: | ---: | ---: | ---: |'
    for row in 'Table 1, e 0.25|extended|--e 0.25|180; 150' 'Table 1, e 0.5|extended|--e 0.5|170; 145' 'Table 1, e 0.8|extended|--e 0.8|160; 130' \
        'Table 2, b 0.25|bevelled|--b 0.25|200; 190' 'Table 2, b 0.5|bevelled|--b 0.5|210; 195' 'Table 2, b 0.8|bevelled|--b 0.8|230; 200' \
        'Table 3, b 0.8, c 0.25|chamfered|--b 0.8 --c 0.25|195; 174' 'Table 3, c 0.5|chamfered|--b 0.8 --c 0.5|209; 176' 'Table 3, c 0.7|chamfered|--b 0.8 --c 0.7|216; 182'; do
        IFS='|' read -r label solid options published <<<"$row"
        options=$(awk -v unit="$unit" '{ for (k = 2; k <= NF; ++k) if ($(k - 1) ~ /--[eb]/) $k *= unit; print }' <<<"$options")
        local cells=()
        # shellcheck disable=SC2086 # options are words
        for how in '--steps 20 --binary-steps 10 --scheme published' '--steps 20 --binary-steps 10' ''; do cells+=("$(cost "revolution, $solid, box" $options $how)"); done
        printf '| %s | %s | %s | %s | %s |\n' "$label" "$published" "${cells[@]}"
    done
}
table | tee "$scratch/table"
if [[ $page ]]; then "$here/put_table.sh" "$page" 003-tables <"$scratch/table"; fi
