# shellcheck shell=bash
# Sourced by the scripts of this folder. Needs scratch, and gnuplot.

# draw_curves LINES OUT.svg XLABEL YLABEL [SETTING...]: LINES holds "title<tab>x<tab>y", the points of one or more curves; settings are gnuplot's.
draw_curves() {
    local lines=$1 out=$2 title k=0 between=''
    local -a titles
    mapfile -t titles < <(cut -f 1 "$lines" | awk '!seen[$0]++')
    {
        printf 'set terminal svg size 760,400 font "sans,12" background "white"\nset xlabel "%s"\nset ylabel "%s"\nset key outside right\nset style data linespoints\n' "$3" "$4"
        printf '%s\n' "${@:5}"
        printf 'plot '
        for title in "${titles[@]}"; do
            k=$((k + 1))
            awk -F '\t' -v title="$title" '$1 == title && $3 > 0 { print $2, $3 }' "$lines" >"$scratch/curve.$k"
            [[ -s $scratch/curve.$k ]] || continue
            printf '%s"%s" title "%s" noenhanced linewidth 2' "$between" "$scratch/curve.$k" "$title"
            between=', '
        done
        echo
    } >"$scratch/curves.gp"
    SOURCE_DATE_EPOCH=0 gnuplot "$scratch/curves.gp" >"$out"
}
