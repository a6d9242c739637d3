#include "cli/batch/glob.h"

#include <fnmatch.h>

#include <vector>

namespace reliefbake {

namespace {

std::vector<std::string> parts_of(std::string_view path) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= path.size();) {
        const std::size_t end = std::min(path.find('/', begin), path.size());
        parts.emplace_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

} // namespace

bool glob_matches(std::string_view pattern, std::string_view path) {
    const std::vector<std::string> want = parts_of(pattern);
    std::vector<std::string> have = parts_of(path);
    if (want.size() == 1) have.erase(have.begin(), have.end() - 1);
    // matches[k]: what has been read of the pattern matches the first k parts of the path.
    std::vector<bool> matches(have.size() + 1, false);
    matches[0] = true;
    for (const std::string& part : want) {
        std::vector<bool> next(have.size() + 1, false);
        if (part == "**") {
            bool any = false;
            for (std::size_t k = 0; k <= have.size(); ++k) next[k] = any = any || matches[k];
        } else {
            for (std::size_t k = 0; k < have.size(); ++k)
                next[k + 1] = matches[k] && fnmatch(part.c_str(), have[k].c_str(), FNM_NOESCAPE) == 0;
        }
        matches = next;
    }
    return matches.back();
}

bool is_glob(std::string_view text) { return text.find_first_of("*?[") != text.npos; }

std::string lower(std::string text) {
    for (char& c : text)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return text;
}

} // namespace reliefbake
