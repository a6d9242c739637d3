#include "cli/depfile.h"

namespace reliefbake {

namespace {

/// As GCC's -MF: a blank and the backslashes before it are each preceded by a backslash; '#' by one; '$' doubled.
std::string escaped(const std::string& name) {
    std::string text;
    std::size_t backslashes = 0;
    for (const char c : name) {
        if (c == ' ' || c == '\t') text.append(backslashes + 1, '\\');
        if (c == '#') text += '\\';
        if (c == '$') text += '$';
        text += c;
        backslashes = c == '\\' ? backslashes + 1 : 0;
    }
    return text;
}

} // namespace

Result<std::string> depfile_text(const std::vector<std::string>& targets, const std::vector<std::filesystem::path>& inputs) {
    std::string text;
    const auto add = [&](const std::string& name) {
        if (name.find_first_of("\n\r") != name.npos) return false;
        text += (text.empty() ? "" : " ") + escaped(name);
        return true;
    };
    for (const std::string& target : targets)
        if (!add(target)) return fail(ErrorCode::usage, "-MF: a file of this bake has a line break in its name, which no depfile can say");
    text += ":";
    for (const std::filesystem::path& input : inputs)
        if (!add(input.string())) return fail(ErrorCode::usage, "-MF: a file of this bake has a line break in its name, which no depfile can say");
    return text + "\n";
}

} // namespace reliefbake
