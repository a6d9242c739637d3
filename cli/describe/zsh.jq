# Completion for zsh from --describe json.
def quoted: "'" + gsub("'"; "'\\''") + "'";
def plain: gsub("(?<special>[\\\\:\\[\\]])"; "\\\(.special)");
def spec: . as $option
    | (if .value == null then "" elif (.words | length) > 0 then ":value:(\(.words | join(" ")))" else ":\(.value | ascii_downcase | plain):_files" end) as $action
    | .names[] | "\(if $option.several then "*" else "" end)\(.)\(if $action == "" then "" elif startswith("--") then "=" else "+" end)[\($option.help | plain)]\($action)" | quoted;
def function_name: gsub("[ -]"; "_");
.name as $name | .commands as $commands
| "#compdef \($name)",
  "# zsh completion for \($name), made from `\($name) --describe json`",
  ($commands[] | "_\($name)_\(.path | function_name)() {", "    _arguments -s -S \\", (.options[] | select(.names | length > 0) | spec | "        \(. ) \\"), "        '*:file:_files'", "}"),
  ([$commands[].path | split(" ") | select(length > 1)] | group_by(.[0])[] | .[0][0] as $group
      | "_\($name)_\($group | function_name)() {", "    local -a commands=(", (.[] | . as $path | ($commands[] | select(.path == ($path | join(" "))) | .summary) as $summary | "        \("\($path[1]):\($summary | plain)" | quoted)"), "    )",
        "    if ((CURRENT == 2)); then _describe command commands && return; fi", "    local command=$words[2]", "    shift words", "    ((CURRENT--))", "    (($+functions[_\($name)_\($group | function_name)_${command//-/_}])) && _\($name)_\($group | function_name)_${command//-/_}", "}"),
  "_\($name)() {",
  "    local -a commands=(",
  ($commands[] | select(.path | contains(" ") | not) | "        \("\(.path):\(.summary | plain)" | quoted)"),
  ([$commands[].path | split(" ") | select(length > 1) | .[0]] | unique[] | "        \("\(.):\(.) commands" | quoted)"),
  "    )",
  "    if ((CURRENT == 2)); then",
  "        _describe command commands",
  "    else",
  "        local command=$words[2]",
  "        shift words",
  "        ((CURRENT--))",
  "        (($+functions[_\($name)_${command//-/_}])) && _\($name)_${command//-/_}",
  "    fi",
  "}",
  "_\($name) \"$@\""
