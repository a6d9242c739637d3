# For paper_000.sh and paper_004.sh: frames of curved relief, their steps, their times and what the displaced mesh says of them.
# Sourced after tests/families.sh; uses $scratch, $rounds.

# frame NAME VERIFY-ARGUMENTS...: judges one view, drawn twice, the second time without the shader's compilation; keeps the least time of all rounds in
# $scratch/NAME.ms and the report in $scratch/NAME.json.
frame() {
    local name=$1 found
    shift
    "$tool" verify "$@" --json >"$scratch/$name.json"
    found=$(jq '.views[-1].milliseconds' "$scratch/$name.json")
    if [[ -s $scratch/$name.ms ]]; then found=$(jq -n --argjson a "$found" --argjson b "$(<"$scratch/$name.ms")" '[$a, $b] | min'); fi
    echo "$found" >"$scratch/$name.ms"
}

# steps NAME; ratio NAME BASE: its time over that of BASE; judged NAME: IoU, band, cut.
steps() { jq -r '.views[-1].steps_mean * 10 | round / 10' "$scratch/$1.json"; }
ratio() { jq -n --argjson a "$(<"$scratch/$1.ms")" --argjson b "$(<"$scratch/$2.ms")" '$a / $b * 100 | round / 100'; }
judged() { jq -r '[.iou, .band_agreement, .cut_iou] | map(. * 1000 | round / 1000 | tostring) | join(", ")' "$scratch/$1.json"; }
