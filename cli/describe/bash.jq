# Completion for bash from --describe json.
def quoted: "'" + gsub("'"; "'\\''") + "'";
def reply: "COMPREPLY=($(compgen -W \(join(" ") | quoted) -- \"$word\"))";
.name as $name | .commands as $commands
| ([$commands[].path | split(" ") | select(length > 1)] | group_by(.[0]) | map({group: .[0][0], words: map(.[1])})) as $groups
| "# bash completion for \($name), made from `\($name) --describe json`",
  "_\($name)() {",
  "    local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command=${COMP_WORDS[1]-}",
  "    COMPREPLY=()",
  "    if ((COMP_CWORD == 1)); then \([$commands[].path | split(" ")[0]] + ["--help", "--version", "--describe"] | unique | reply) && return; fi",
  "    case $command in",
  ($groups[] | "        \(.group))", "            if ((COMP_CWORD == 2)); then \(.words | reply) && return; fi", "            command+=\" ${COMP_WORDS[2]}\" ;;"),
  "    esac",
  "    case $command/$previous in",
  ($commands[] | (.path | quoted) as $path | .options[] | select((.words | length > 0) and (.names | length > 0)) | "        \(.names | map("\($path)/\(.)") | join("|"))) \(.words | reply) && return ;;"),
  "    esac",
  "    if [[ $word == -* ]]; then",
  "        case $command in",
  ($commands[] | "            \(.path | quoted)) \([.options[].names[]] | unique | reply) ;;"),
  "        esac",
  "    else",
  "        compopt -o filenames",
  "        COMPREPLY=($(compgen -f -- \"$word\"))",
  "    fi",
  "}",
  "complete -F _\($name) \($name)"
