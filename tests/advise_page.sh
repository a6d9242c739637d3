#!/usr/bin/env bash
# Asks advise for a map under three budgets on every height map, and judges each answer again by 90 000 other rays: the table of docs/ADVISE.md.
#
#   tests/advise_page.sh [--quick] [--keep DIR] [-o FILE.md]
#
#   --quick   the bundled maps
#   --keep    folder of the answers; what it holds is not asked again
#   -o        put the table into FILE.md (tests/put_table.sh)
#
#   RELIEFBAKE_BINARY, RELIEFBAKE_DATA   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/families.sh"

page='' quick='' results=''
while (($#)); do
    case $1 in
        --quick) quick=yes ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,10s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
set_heights "$quick"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
mkdir -p "$results"
# Compiling a shader takes longer than a measurement: keep them from run to run.
export MESA_SHADER_CACHE_DISABLE=false MESA_SHADER_CACHE_DIR=$scratch/shaders

# Name | budget.
budgets='far|--max-missed 0.02 --max-error 0.02 --steps 32 --bytes-per-texel 4
usual|--max-missed 0.005 --max-error 0.004 --steps 64 --bytes-per-texel 8
close|--max-missed 0 --max-error 0.0005 --steps 128 --bytes-per-texel 16'

# An answer that breaks its budget, or a failure, ends the page.
ask() {
    local file=$1 name=$2 options=$3 answer code=0
    answer=$results/${file##*/}-$name.json
    [[ ! -s $answer ]] || return 0
    set_source_options "$file"
    # shellcheck disable=SC2086
    "$tool" advise "$file" ${source_options[@]+"${source_options[@]}"} --angle 80deg $options --json >"$scratch/answer" 2>"$scratch/said" || code=$?
    ((code == 0 || code == 5)) || { cat "$scratch/said" >&2 && exit 1; }
    jq -e --argjson code $code '(.met == ($code == 0)) and (.met | not) or (.trials[.answer.trial] | .stage == "proof" and .faults == []) and
        (. as $a | .trials[.answer.trial].figures | .missed <= $a.budget.max_missed and .error_mean <= $a.budget.max_error and .steps_max <= $a.budget.steps and
            .bytes_per_texel <= $a.budget.bytes_per_texel)' "$scratch/answer" >/dev/null || { echo "$this: $file, $name: the answer breaks its budget" >&2 && exit 1; }
    mv "$scratch/answer" "$answer" && rm -f "$answer.again"
}

# The answer's figures by other rays, of a sweep of one candidate.
again() {
    local file=$1 answer=$2 axes
    [[ ! -s $answer.again ]] || return 0
    axes=$(jq -r '.answer as $chosen | .trials[$chosen.trial].candidate | "--techniques \($chosen.method) --steps \(.steps) --bits \(.bits) --resolutions \(.resolution)"
        + (if .refinements == null then "" else " --refinements \(.refinements)" end) + (if .encoding == null or .encoding == "normal" then "" else " --encodings \(.encoding)" end)' "$answer")
    set_source_options "$file"
    # shellcheck disable=SC2086
    "$tool" tradeoff "$file" ${source_options[@]+"${source_options[@]}"} --angle 80 $axes --rays 90000 --repeat 1 -o "$scratch/again" --json >"$scratch/sweep" 2>"$scratch/said" || { cat "$scratch/said" >&2 && exit 1; }
    rm -rf "$scratch/again"
    jq -e --arg id "$(jq -r .answer.id "$answer")" '.inputs[0].measurements[] | select(.candidate.id == $id).figures' "$scratch/sweep" >"$scratch/figures"
    mv "$scratch/figures" "$answer.again"
}

definitions='def short: if . == 0 then "0" elif . >= 100 then (round | tostring) else (. as $x | (log10 | floor) as $e | pow(10; $e - 1) as $u | ($x / $u | round) * $u * 1e9 | round / 1e9 | tostring) end;
    def percent: if . == 0 then "0" else (. * 100 | short) + " %" end;'
table() {
    printf '| map | budget | answer | bytes a texel | reads a ray | missed | mean error | most steps | by other rays | runner-up | screened, proven |\n| --- | --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | --- | ---: |\n'
    local file name options answer
    for file in "$heights"/*.*; do
        while IFS='|' read -r name options; do
            ask "$file" "$name" "$options"
            answer=$results/${file##*/}-$name.json
            jq -e .met "$answer" >/dev/null && again "$file" "$answer" || echo null >"$answer.again"
            jq -r --slurpfile again "$answer.again" "$definitions"' . as $all | (.answer // .nearest) as $chosen | .trials[$chosen.trial].figures as $f |
                "| \(.input | split("/") | last), \(.width) x \(.height) | '"$name"' | \(if .met then "" else "**cannot be met**; nearest: " end)\($chosen.id) | \($f.bytes_per_texel | short) | \($f.fetches_mean | short) | \($f.missed | percent) | \($f.error_mean | short) | \($f.steps_max) | \($again[0] | if . == null then "-" else "\(.missed | percent), \(.error_mean | short)" end) | \(if .runner_up then .runner_up.method else "-" end) | \([.trials[] | select(.stage == "screen")] | length), \([.trials[] | select(.stage == "proof")] | length) |"' "$answer"
        done <<<"$budgets"
    done
}
summary() {
    printf '\n'
    jq -rs '"\(length) questions: \(map(select(.met)) | length) answered within the budget, \(map(select(.met | not)) | length) cannot be met; reliefbake \(.[0].version); proofs of up to \(map(.trials[] | select(.stage == "proof").figures.rays) | max) rays."' "$results"/*.json
    for answer in "$results"/*.json; do jq --slurpfile again "$answer.again" 'select(.met) | [$again[0].missed > .budget.max_missed or $again[0].error_mean > .budget.max_error, $again[0].rays]' "$answer"; done |
        jq -rs '"\(map(select(.[0])) | length) of \(length) answers are over their budget by \(map(.[1]) | max) other rays."'
}
{ table && summary; } | tee "$scratch/table"
[[ ! $page ]] || "$here/put_table.sh" "$page" answers <"$scratch/table"
