#!/usr/bin/env bash
# Tables 4.1 to 4.15 and graphs 4.5, 4.7 to 4.11 of 001 (Burger), measured anew: tables and plots of docs/PAPERS.md.
#
#   tests/papers/paper_001.sh [--quick] [--rays N] [--keep DIR] [-o FILE.md]
#
#   --quick    every fifth row, fewer rays, one scene, no plots
#   --rays     rays of `verify` a measurement (default 325000; those of the views at 45 and 70 degrees count)
#   --keep     folder of results, two files a measurement (rays, frame); those already there are not done again
#   -o         put the tables into FILE.md (tests/put_table.sh), and the plots into pictures/papers/ beside it (needs gnuplot)
#
# What the dissertation prints is in published_001.tsv. Frame times: processor time at 1024x768, 60 degrees, the least of three frames.
#
#   RELIEFBAKE_BINARY   as for tests/verify_all.sh
set -euo pipefail

source "$(dirname "$0")/../families.sh"
source "$(dirname "$0")/draw_curves.sh"

rays=325000 page='' quick='' results=''
while (($#)); do
    case $1 in
        --quick) quick=yes rays=13000 ;;
        --rays) rays=$2 && shift ;;
        --keep) results=$2 && shift ;;
        -o) page=$2 && shift ;;
        *) sed -n '2,13s/^# \{0,1\}//p' "$0" && exit 2 ;;
    esac
    shift
done
require_tools
if [[ $page ]]; then command -v gnuplot >/dev/null || { echo "$this: needs gnuplot (apt install gnuplot-nox)" >&2 && exit 2; }; fi
set_heights bundled
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
results=${results:-$scratch/results}
mkdir -p "$results"
published=$here/papers/published_001.tsv

scenes=(ambientcg_RoofingTiles009_512.png pom_rocks_NM_height.tga bevy_parallax_cube_depth_348.png gz_dem_squared_129.tif)
main=${scenes[0]} # in the place of 'Lion': smooth stones and sharp edges

# Maps as 001 has them: texel cones, sampled linearly. Relaxed: the limit of what GPU Gems 3 samples.
bake_of() {
    case $1 in
        CSM) echo cone --surface texel ;;
        'CSM, bilinear-safe') echo cone ;;
        QCSM) echo acm --sectors 4 --method adaptive --levels 0 ;;
        RCS) echo cone --kind relaxed --relaxed top ;;
        CNS) echo cone-normal --surface texel ;;
        RCNS) echo cone-normal --kind relaxed --relaxed top ;;
        MCNS) echo cone-stack --levels 2 ;;
    esac
}

# Sets map to the map of a method on a scene, baked when it is first asked for.
set_map() {
    map=$scratch/$1-${2//[^A-Za-z]/}.exr
    [[ -s $map ]] && return
    set_source_options "$1"
    # shellcheck disable=SC2046 # words
    quietly "$tool" $(bake_of "$2") "$heights/$1" "${source_options[@]}" -o "$map" --wrap repeat --quiet
}

# Sets map and march to what a row of the tables asks for.
set_march() {
    local scene=$1 method=$2 steps=$3 refinements=$4
    case $method in
        linear) set_map "$scene" CSM && march=(--technique linear --steps "$steps") ;;
        binary | interval) set_map "$scene" CSM && march=(--technique "$method" --steps "$steps" --binary-steps "$refinements") ;;
        'no shadow') set_map "$scene" RCS && march=(--technique linear --steps 25) ;;
        hard | height-soft) set_map "$scene" RCS && march=(--technique linear --steps 25 --shadow "$method" --shadow-steps "$steps") ;;
        cone-soft) set_map "$scene" CNS && march=(--technique linear --steps 25 --shadow "$method" --shadow-steps "$steps") ;;
        *', ambient occlusion') set_map "$scene" "${method%%,*}" && march=(--technique cone --steps 30 --ao "$([[ $method == CSM* ]] && echo cone || echo cone-normal)") ;;
        *', interval') set_map "$scene" "${method%,*}" && march=(--technique relaxed-secant --steps "$steps" --binary-steps "$refinements") ;;
        *', least of four') set_map "$scene" "${method%,*}" && march=(--technique cone-raw --steps "$steps") ;;
        RCS | RCNS) set_map "$scene" "$method" && march=(--technique relaxed --steps "$steps" --binary-steps "$refinements") ;;
        *)
            set_map "$scene" "$method" && march=(--technique cone --steps "$steps")
            if [[ $steps == - ]]; then march=(--technique cone --steps 30); fi
            if ((refinements)); then march=(--technique relaxed --steps "$steps" --binary-steps "$refinements"); fi
            ;;
    esac
}

# measure SCENE METHOD STEPS REFINEMENTS [errors]: one line of JSON, with the time of a frame unless only errors are asked for.
measure() {
    local name="$results/$1 $2 $3 $4"
    set_march "$@"
    if [[ ! -s "$name rays" ]]; then
        echo null >"$name.new"
        if [[ ! ${march[*]} =~ --shadow|--ao ]]; then "$tool" verify "$map" --crop 0 --points 0 --rays "$rays" "${march[@]}" --json 2>/dev/null >"$name.new" || (($? == 4)); fi
        mv "$name.new" "$name rays"
    fi
    if [[ ! ${5-} && ! -s "$name frame" ]]; then
        "$tool" bench render "$map" --view 60 --azimuth 30 --endless --span 1 --frames 3 "${march[@]}" --json >"$name.new"
        mv "$name.new" "$name frame"
    fi
    jq -cn --arg scene "$1" --arg method "$2" --arg steps "$3" --arg refinements "$4" --slurpfile errors "$name rays" --slurpfile frame "$([[ ${5-} ]] && echo /dev/null || echo "$name frame")" '
        def over(f): [.[] | f * .rays] | add; ($errors[0].views // [] | map(select(.angle == 45 or .angle == 70))) as $views | ([$views[].rays] | add) as $rays
        | {scene: $scene, method: $method, steps: $steps, refinements: $refinements, milliseconds: $frame[0].processor_milliseconds_least}
          + if $rays then $views | {steps_mean: (over(.steps_mean) / $rays), fetches: (over(.fetches_mean) / $rays), mse: (over(.mse) / $rays), missed: (over(.missed) / $rays), skipped: (over(.skipped) / $rays),
            early: (over(.early) / $rays)} else {} end'
}

# The rows that the dissertation prints.
sed 1d "$published" | cut -f 2-4 | sort -u | { if [[ $quick ]]; then awk 'NR % 5 == 1'; else cat; fi; } | while IFS=$'\t' read -r method steps refinements; do
    measure "$main" "$method" "$steps" "$refinements"
done >"$scratch/rows"

helpers='def exponent: if . == null then "" elif . == 0 then "0" else (log10 | floor) as $e | "\(. / pow(10; $e) * 100 | round / 100)e\($e)" end;
    def rounded($places): if . == null then "" else pow(10; $places) as $p | (. * $p | round / $p | tostring) end;
    def percent: if . == null then "" else "\(. * 1e4 | round / 1e2) %" end;'

# table NUMBER TITLE: the published rows beside ours; times as ratios to the first row.
table() {
    printf '### Table %s: %s\n\n' "$1" "$2"
    printf '| method | steps | refinements | 001: steps, mean | MSE | time | ours: steps, mean | MSE | skipped | time |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n'
    sed 1d "$published" | jq -rR --arg table "$1" --slurpfile measured "$scratch/rows" "$helpers"'
        [inputs | split("\t") | select(.[0] == $table)] as $rows
        | ($measured | map({key: "\(.method)|\(.steps)|\(.refinements)", value: .}) | from_entries) as $ours
        | [$rows[] | {theirs: ., ours: ($ours["\(.[1])|\(.[2])|\(.[3])"] // empty)}] as $both
        | def number: if . == "-" then null else tonumber end;
        ($both[0].theirs[6] // "-" | number) as $first | $both[0].ours.milliseconds as $ours_first
        | $both[] | .ours as $o | .theirs as $t
        | "| \($t[1]) | \($t[2]) | \($t[3]) | \($t[4] | number | rounded(2)) | \($t[5] | number | exponent) | \(if $first and ($t[6] | number) then ($t[6] | number) / $first else null end | rounded(2)) | "
          + "\($o.steps_mean | rounded(2)) | \($o.mse | exponent) | \($o.skipped | percent) | \(if $first and $ours_first then $o.milliseconds / $ours_first else null end | rounded(2)) |"' --null-input
    echo
}

{
    printf '001: the %s scene, GTX 780, its frame times. Ours: `%s`, rays at 45 and 70 degrees (MSE, skipped, steps; skipped: rays that went through relief and came out again); processor time of a frame of llvmpipe, one thread, %s. Times are ratios to the first row of the table.\n\n' "\`Lion\`" "$main" "$(machine)"
    table 4.1 'linear search'
    table 4.2 'binary search after it'
    table 4.3 'linear alone, or with two halvings'
    table 4.4 'interval search after it'
    table 4.5 'binary or interval search'
    table 4.6 'cone stepping, alone and with two halvings'
    table 4.7 'linear search and cone stepping'
    table 4.8 'one cone or four sectors'
    table 4.9 'one cone, four sectors, relaxed; five halvings'
    table 4.10 'relaxed, refinements'
    table 4.11 'cone normals; five halvings'
    table 4.12 'relaxed cone normals; five halvings'
    table 4.13 'two stacked cones; five halvings'
    table 4.14 'shadows'
    table 4.15 'ambient occlusion'
} | tee "$scratch/tables"

if [[ $page ]]; then "$here/put_table.sh" "$page" 001 <"$scratch/tables"; fi
[[ $quick ]] && exit

# How cones are sampled (sec. 4.3.1, fig. 4.6).
{
    printf '| cones and how they are sampled | steps | steps, mean | MSE | missed | skipped | early | time |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n'
    for row in 'CSM|30|0' 'CSM, least of four|30|0' 'CSM|30|2' 'CSM, bilinear-safe|30|0' 'CSM, bilinear-safe|30|2'; do
        IFS='|' read -r method steps refinements <<<"$row"
        measure "$main" "$method" "$steps" "$refinements"
    done | jq -rs "$helpers"'.[0].milliseconds as $first | .[] | "| \(.method)\(if .refinements != "0" then ", \(.refinements) halvings" else "" end) | \(.steps) | \(.steps_mean | rounded(2)) | \(.mse | exponent) | \(.missed | percent) | \(.skipped | percent) | \(.early | percent) | \(.milliseconds / $first | rounded(2)) |"'
} | tee "$scratch/sampling"
if [[ $page ]]; then "$here/put_table.sh" "$page" 001-sampling <"$scratch/sampling"; fi

# The graphs.
methods=(linear CSM QCSM CNS RCS RCNS)
# refined METHOD none|binary|interval: the method's name in measure.
refined() {
    case $1/$2 in
        linear/binary | linear/interval) echo "$2" ;;
        linear/none | */none | */binary) echo "$1" ;;
        */interval) echo "$1, interval" ;;
    esac
}
curve() { # SCENE METHOD REFINEMENT: the measurements of one curve of graphs 4.8 to 4.11
    local steps
    for steps in 5 10 15 20 25 30 35; do measure "$1" "$(refined "$2" "$3")" $steps $([[ $3 == none ]] && echo 0 || echo 3); done
}
for refinement in none binary interval; do
    for method in "${methods[@]}"; do
        curve "$main" "$method" $refinement | jq -c --arg curve "$method" --arg refinement $refinement '. + {curve: $curve, refinement: $refinement}'
    done
done >"$scratch/curves"
for scene in "${scenes[@]}"; do
    for refinements in 1 2 3 4 5 6; do
        for method in binary interval; do measure "$scene" $method 10 $refinements errors; done
    done
    for steps in 5 10 15 20 25 30; do measure "$scene" CSM $steps 4 errors; done
done >"$scratch/scenes"

# Which method is best for a budget of texture reads, by three measures (what 001 sec. 4.1 and 5.2 leave open): pictures of the same candidates, so by the sweep.
sweep=$results/sweep
set_source_options "$main"
quietly "$tool" tradeoff "$heights/$main" --techniques linear,binary,interval,cone,sectors-4,cone-normal,relaxed-top,max-mip --steps 5,8,12,16,24,32,48 --refinements 3 --encodings sqrt --bits 16 --resolutions 1 \
    --tolerances 0.001 --rays 28000 --repeat 1 --angle 70 -o "$sweep" >/dev/null
{
    printf '| texture reads at most | by MSE | by rays missed or early | by 1 - SSIM of the picture |\n| ---: | --- | --- | --- |\n'
    jq -r "$helpers"'.inputs[0].measurements as $all
        | def best($budget; f): [$all[] | select(.figures.fetches_mean <= $budget)] | group_by(.method) | map(min_by(.figures | f)) | sort_by(.figures | f) | map("\(.method) \(.figures | f | exponent)") | join(", ");
        (8, 16, 32) as $budget | "| \($budget) | \(best($budget; .mse)) | \(best($budget; .missed + .early)) | \(best($budget; .dissimilarity)) |"' "$sweep/tradeoff.json"
} | tee "$scratch/ranking"
if [[ ! $page ]]; then exit; fi
"$here/put_table.sh" "$page" 001-ranking <"$scratch/ranking"

pictures=$(dirname "$page")/pictures/papers
mkdir -p "$pictures"
error_plot() { draw_curves "$2" "$pictures/$1.svg" "$3" MSE 'set logscale y' 'set format y "%.0e"'; }
jq -r 'select(.method == "binary" or .method == "interval") | "\(.method), \(.scene | split(".")[0])\t\(.refinements)\t\(.mse)"' "$scratch/scenes" >"$scratch/4.5"
jq -r 'select(.method == "CSM") | "\(.scene | split(".")[0])\t\(.steps)\t\(.mse)"' "$scratch/scenes" >"$scratch/4.7"
error_plot 001-graph-4.5 "$scratch/4.5" 'halvings or secants after 10 linear steps'
error_plot 001-graph-4.7 "$scratch/4.7" 'cone steps, then 4 halvings'
k=8
for refinement in none binary interval; do
    jq -r --arg r $refinement 'select(.refinement == $r) | "\(.curve)\t\(.milliseconds)\t\(.mse)"' "$scratch/curves" >"$scratch/4.$k"
    error_plot 001-graph-4.$k "$scratch/4.$k" 'milliseconds a frame'
    k=$((k + 1))
done
jq -r 'select(.curve == "linear" or .curve == "CSM") | "\(.curve), \(.refinement)\t\(.milliseconds)\t\(.mse)"' "$scratch/curves" >"$scratch/4.11"
error_plot 001-graph-4.11 "$scratch/4.11" 'milliseconds a frame'
