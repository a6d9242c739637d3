#!/usr/bin/env bash
# tests/put_table.sh FILE.md < TABLE: puts TABLE between FILE's lines <!-- table --> and <!-- end -->, or makes FILE of it.
set -euo pipefail
file=$1 table=$(cat)
if ! grep -qs '^<!-- table -->$' "$file"; then
    printf '%s\n' "$table" >"$file"
    exit
fi
{
    sed '/^<!-- table -->$/q' "$file"
    printf '%s\n' "$table"
    sed -n '/^<!-- end -->$/,$p' "$file"
} >"$file.new"
mv "$file.new" "$file"
