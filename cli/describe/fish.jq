# Completion for fish from --describe json.
def quoted: "'" + (gsub("\\\\"; "\\\\") | gsub("'"; "\\'")) + "'";
def chosen: split(" ") | map("__fish_seen_subcommand_from \(.)") | join("; and ");
.name as $name | .commands as $commands
| ([$commands[].path | split(" ")[0]] | unique | join(" ")) as $first
| "# fish completion for \($name), made from `\($name) --describe json`",
  ($commands[] | select(.path | contains(" ") | not) | "complete -c \($name) -n 'not __fish_seen_subcommand_from \($first)' -f -a \(.path) -d \(.summary | quoted)"),
  ([$commands[].path | split(" ") | select(length > 1)] | group_by(.[0])[] | (map(.[1]) | join(" ")) as $words
      | "complete -c \($name) -n 'not __fish_seen_subcommand_from \($first)' -f -a \(.[0][0])",
        (.[] | . as [$group, $word] | ($commands[] | select(.path == "\($group) \($word)")) as $command
            | "complete -c \($name) -n '__fish_seen_subcommand_from \($group); and not __fish_seen_subcommand_from \($words)' -f -a \($word) -d \($command.summary | quoted)")),
  ($commands[] | (.path | chosen) as $chosen | .options[] | select(.names | length > 0)
      | "complete -c \($name) -n \($chosen | quoted) \(.names | map(if startswith("--") then "-l \(.[2:])" else "-s \(.[1:])" end) | join(" "))"
        + (if (.words | length) > 0 then " -x -a \(.words | join(" ") | quoted)" elif .value != null then " -r" else "" end) + " -d \(.help | quoted)")
