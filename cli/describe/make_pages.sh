#!/usr/bin/env bash
# Writes man pages and completions from `reliefbake --describe json` (needs jq): make_pages.sh TOOL DIR
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) tool=$1 out=$2
rm -rf "$out/man" "$out/bash-completion" "$out/zsh" "$out/fish"
mkdir -p "$out/man/man1" "$out/bash-completion/completions" "$out/zsh/vendor-completions" "$out/fish/vendor_completions.d"
described=$("$tool" --describe json)
page() { jq -r --arg path "$1" -f "$here/man.jq" <<<"$described" | gzip -9n >"$out/man/man1/$2.1.gz"; }
page '' reliefbake
jq -r '.commands[].path' <<<"$described" | while read -r path; do page "$path" "reliefbake-${path// /-}"; done
jq -r -f "$here/bash.jq" <<<"$described" >"$out/bash-completion/completions/reliefbake"
jq -r -f "$here/zsh.jq" <<<"$described" >"$out/zsh/vendor-completions/_reliefbake"
jq -r -f "$here/fish.jq" <<<"$described" >"$out/fish/vendor_completions.d/reliefbake.fish"
