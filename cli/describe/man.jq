# A man page from --describe json: of the command $path, or of the whole tool when it is empty.
def text: gsub("\\\\"; "\\e") | gsub("-"; "\\-") | gsub("(?<start>^|\n)(?<dot>[.'])"; "\(.start)\\&\(.dot)");
def bold: "\\fB\(text)\\fR";
def italic: "\\fI\(text)\\fR";
def page_name: .name as $name | if $path == "" then $name else "\($name)-\($path | gsub(" "; "-"))" end;
def head($title; $version): ".TH \"\($title | ascii_upcase)\" 1 \"\" \"reliefbake \($version)\" \"User Commands\"";
def option_line: [(if .positional then .value | italic else .names | map(bold) | join(", ") end), (if .positional or .value == null then empty else .value | italic end)] | join(" ");
def with_groups: reduce .[] as $o ([]; if (.[-1].group // null) == $o.group then .[-1].options += [$o] else . + [{group: $o.group, options: [$o]}] end);
def exit_status: capture("Exit status: (?<codes>.*)$"; "m").codes | gsub("\n"; " ");

page_name as $title | .version as $version | .name as $name
| if $path == "" then
    head($title; $version), ".SH NAME", "\($name) \\- \(.about | split("\n")[0] | rtrimstr(".") | text)",
    ".SH SYNOPSIS", "\($name | bold) \("COMMAND" | italic) [\("OPTIONS" | italic)]",
    ".SH COMMANDS", (.commands[] | ".TP", "\("\($name)-\(.path | gsub(" "; "-"))" | bold)(1)", (.summary | text)),
    ".SH EXIT STATUS", (.about | exit_status | text)
  else
    .about as $about | .commands[] | select(.path == $path) | .options as $options
    | head($title; $version), ".SH NAME", "\($title | text) \\- \(.summary | text)",
      ".SH SYNOPSIS", "\("\($name) \($path)" | bold) [\("OPTIONS" | italic)] \([$options[] | select(.positional) | (.value | italic) + if .several then "..." else "" end] | join(" "))",
      ([$options[] | select(.positional)] | if length > 0 then ".SH ARGUMENTS", (.[] | ".TP", option_line, (.help | text)) else empty end),
      ".SH OPTIONS", ([$options[] | select(.positional | not)] | with_groups[] | ".SS \(.group | text)", (.options[] | ".TP", option_line, (.help | text), (if .least then "\(.least) to \(.most)." | text else empty end), (if .required then "Must be given." else empty end))),
      ".SH EXIT STATUS", ($about | exit_status | text), ".SH SEE ALSO", "\($name | bold)(1)"
  end
