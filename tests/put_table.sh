#!/usr/bin/env bash
# tests/put_table.sh FILE.md [NAME] < TABLE: puts TABLE between FILE's lines <!-- table --> (<!-- table NAME -->) and the next
# <!-- end -->. Without a NAME and without such lines, makes FILE of it.
set -euo pipefail
file=$1 mark="<!-- table${2:+ $2} -->" table=$(cat)
if ! grep -qsxF "$mark" "$file"; then
    [[ -z ${2-} ]] || { echo "put_table: $file: has no line $mark" >&2 && exit 2; }
    printf '%s\n' "$table" >"$file"
    exit
fi
{
    sed "/^$mark\$/q" "$file"
    printf '%s\n' "$table"
    sed "0,/^$mark\$/d" "$file" | sed -n '/^<!-- end -->$/,$p'
} >"$file.new"
mv "$file.new" "$file"
