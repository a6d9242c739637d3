#!/usr/bin/env bash
# Man pages and completions say what `--describe json` says, and their shells can read them: pages.sh TOOL
set -euo pipefail
here=$(cd "$(dirname "$0")/../.." && pwd) tool=$1
command -v jq >/dev/null || { echo 'SKIPPED: needs jq' && exit 0; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "pages: $*" >&2 && exit 1; }

"$here/cli/describe/make_pages.sh" "$tool" "$scratch"
"$tool" --describe json >"$scratch/described"
jq -r '.commands[] | .path as $path | .options[] | .names[] | "\($path)\t\(.)"' "$scratch/described" | sort >"$scratch/options"
[[ -s $scratch/options ]] || fail 'no options'
pages=0
while read -r path; do
    page=$scratch/man/man1/reliefbake-${path// /-}.1.gz
    [[ -f $page ]] || fail "no man page of $path"
    zcat "$page" | sed 's/\\-/-/g' >"$scratch/page"
    awk -F '\t' -v path="$path" '$1 == path { print $2 }' "$scratch/options" | while read -r name; do grep -qF -- "\\fB$name\\fR" "$scratch/page" || fail "$page lacks $name"; done
    pages=$((pages + 1))
done < <(jq -r '.commands[].path' "$scratch/described")

# complete WORD...: what bash offers for the last word.
complete_with() {
    bash -c 'source "$1"; compopt() { :; }; shift; COMP_WORDS=("$@"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _reliefbake; printf "%s\n" "${COMPREPLY[@]}" | sort | tr "\n" " "' - "$scratch/bash-completion/completions/reliefbake" "$@"
}
expect() { [[ $1 == "$2" ]] || fail "completed to '$1', expected '$2'"; }
expect "$(complete_with reliefbake expl)" 'explain '
expect "$(complete_with reliefbake bench sur)" 'surface '
expect "$(complete_with reliefbake cone --encoding r)" 'radius ratio '
expect "$(complete_with reliefbake bench surface --sh)" '--shear '
while IFS=$'\t' read -r path name; do
    [[ " $(complete_with reliefbake $path "$name") " == *" $name "* ]] || fail "bash does not offer $name to $path" # shellcheck disable=SC2086
done < <(awk 'NR % 40 == 1' "$scratch/options")
for shell in zsh fish; do
    command -v $shell >/dev/null || continue
    $shell -n "$(echo "$scratch/$shell"/*/*)" || fail "$shell cannot read its completion"
done
echo "$pages man pages, $(wc -l <"$scratch/options") options"
