#include "cli/batch/recipe.h"

#include "cli/batch/bake_kinds.h"
#include "cli/batch/glob.h"
#include "formats/image_header.h"
#include "formats/toml_file.h"

#include <algorithm>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

/// Calls visit(name) for each placeholder of the pattern. False: a brace without its partner.
template <class Visit>
bool each_placeholder(const std::string& pattern, Visit visit) {
    for (std::size_t at = 0; (at = pattern.find_first_of("{}", at)) != pattern.npos;) {
        const std::size_t end = pattern.find('}', at);
        if (pattern[at] == '}' || end == pattern.npos) return false;
        visit(pattern.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    return true;
}

std::string placeholder_fault(const std::string& pattern, const std::vector<std::string>& known) {
    std::string fault;
    const bool closed = each_placeholder(pattern, [&](const std::string& name) {
        if (fault.empty() && std::find(known.begin(), known.end(), name) == known.end()) {
            for (const std::string& word : known) fault += (fault.empty() ? "" : ", ") + ("{" + word + "}");
            fault = "unknown placeholder {" + name + "}; known are " + fault;
        }
    });
    return closed ? fault : "a brace without its partner";
}

/// One TOML table of a recipe, and where it stands.
struct Place {
    const toml::table& table;
    const std::string& file;
};

Result<std::vector<std::string>> strings(const Place& place, std::string_view key) {
    std::vector<std::string> list;
    const Result<const toml::array*> array = toml_part<toml::array>(place.table, key, place.file);
    if (!array) return tl::unexpected(array.error());
    if (!*array) return list;
    for (const toml::node& node : **array) {
        const std::optional<std::string> text = node.value_exact<std::string>();
        if (!text) return toml_fault(node, place.file, "'" + std::string(key) + "': expected strings");
        list.push_back(*text);
    }
    if (list.empty()) return toml_fault(**array, place.file, "'" + std::string(key) + "': is empty; leave it out");
    return list;
}

Result<std::string> string_or(const Place& place, std::string_view key, const std::string& otherwise) {
    return toml_value<std::string>(place.table, key, place.file).map([&](const std::optional<std::string>& text) { return text.value_or(otherwise); });
}

/// The tables of an array of tables.
Result<std::vector<const toml::table*>> tables(const Place& place, std::string_view key) {
    std::vector<const toml::table*> list;
    const Result<const toml::array*> array = toml_part<toml::array>(place.table, key, place.file);
    if (!array) return tl::unexpected(array.error());
    if (!*array) return list;
    for (const toml::node& node : **array) {
        if (!node.is_table()) return toml_fault(node, place.file, "'" + std::string(key) + "': expected tables, [[" + std::string(key) + "]]");
        list.push_back(node.as_table());
    }
    return list;
}

Result<BakeRule> parse_bake(const Place& place) {
    const auto fault = [&](const std::string& words) { return toml_fault(place.table, place.file, words); };
    if (Result<void> known = refuse_unknown_keys(place.table, {"kind", "options", "output"}, place.file); !known) return tl::unexpected(known.error());
    const Result<std::string> kind = string_or(place, "kind", "");
    if (!kind) return tl::unexpected(kind.error());
    const BakeKind* known = find_bake_kind(*kind);
    if (!known) return fault("'kind': expected one of " + bake_kind_words() + ", found '" + *kind + "'");
    Result<std::vector<std::string>> options = strings(place, "options");
    if (!options) return tl::unexpected(options.error());
    for (const std::string& option : *options)
        if (const std::string wrong = placeholder_fault(option, {"stem", "from", "kind", "folder", "out"}); !wrong.empty())
            return fault("'options': '" + option + "': " + wrong);
    const Result<std::string> output = string_or(place, "output", std::string("{stem}_{kind}.") + known->extension);
    if (!output) return tl::unexpected(output.error());
    if (const std::string wrong = name_fault(*output); !wrong.empty()) return fault("'output': '" + *output + "': " + wrong);
    return BakeRule{*kind, std::move(*options), *output};
}

Result<FileRule> parse_rule(const Place& place, std::size_t number) {
    const auto fault = [&](const std::string& words) { return toml_fault(place.table, place.file, words); };
    if (Result<void> known = refuse_unknown_keys(place.table, {"name", "files", "suffixes", "folders", "one-bit", "bake", "skip"}, place.file); !known)
        return tl::unexpected(known.error());
    FileRule rule;
    Result<std::string> name = string_or(place, "name", "rule " + std::to_string(number)), skip = string_or(place, "skip", "");
    Result<std::vector<std::string>> files = strings(place, "files"), suffixes = strings(place, "suffixes"), folders = strings(place, "folders");
    Result<std::optional<bool>> one_bit = toml_value<bool>(place.table, "one-bit", place.file);
    const Result<std::vector<const toml::table*>> bakes = tables(place, "bake");
    const auto error_of = [](const auto& result) -> const Error* { return result ? nullptr : &result.error(); };
    for (const Error* error : {error_of(name), error_of(skip), error_of(files), error_of(suffixes), error_of(folders), error_of(one_bit), error_of(bakes)})
        if (error) return tl::unexpected(*error);
    rule = {std::move(*name), std::move(*files), std::move(*suffixes), std::move(*folders), *one_bit, {}, std::move(*skip)};
    for (const toml::table* bake : *bakes) {
        Result<BakeRule> parsed = parse_bake({*bake, place.file});
        if (!parsed) return tl::unexpected(parsed.error());
        rule.bakes.push_back(std::move(*parsed));
    }
    if (rule.bakes.empty() == rule.skip.empty()) return fault("expected either [[rule.bake]] or 'skip' with a reason");
    if (rule.files.empty() && rule.suffixes.empty() && rule.folders.empty() && !rule.one_bit)
        return fault("expected some of 'files', 'suffixes', 'folders', 'one-bit'; files = [\"*\"] takes all");
    return rule;
}

} // namespace

std::string name_fault(const std::string& pattern) {
    if (const std::string wrong = placeholder_fault(pattern, {"stem", "from", "kind"}); !wrong.empty()) return wrong;
    if (pattern.find("{stem}") == pattern.npos) return "lacks {stem}; all files would be called alike";
    if (fs::path(pattern).is_absolute()) return "is absolute; outputs lie below --out";
    for (const fs::path& part : fs::path(pattern))
        if (part == "..") return "leaves the output folder";
        else if (part.empty() || part.string()[0] == '.') return "has a part that is empty or hidden";
    return "";
}

Result<Recipe> read_recipe(const fs::path& path) {
    const Result<toml::table> table = read_toml_file(path);
    if (!table) return tl::unexpected(table.error());
    const std::string file = path.string();
    const Place place{*table, file};
    if (Result<void> known = refuse_unknown_keys(*table, {"rule"}, file); !known) return tl::unexpected(known.error());
    const Result<std::vector<const toml::table*>> rules = tables(place, "rule");
    if (!rules) return tl::unexpected(rules.error());
    if (rules->empty()) return fail(ErrorCode::bad_data, file + ": expected at least one [[rule]]");
    Recipe recipe;
    for (const toml::table* rule : *rules) {
        Result<FileRule> parsed = parse_rule({*rule, file}, recipe.rules.size() + 1);
        if (!parsed) return tl::unexpected(parsed.error());
        recipe.rules.push_back(std::move(*parsed));
    }
    return recipe;
}

const FileRule* rule_for(const Recipe& recipe, const std::string& relative, const fs::path& path) {
    const fs::path name = relative;
    const std::string stem = lower(name.stem().string());
    std::optional<bool> one_bit; // looked at once, and only if a rule asks
    const auto matches = [&](const FileRule& rule) {
        const auto any = [](const std::vector<std::string>& list, auto test) { return list.empty() || std::any_of(list.begin(), list.end(), test); };
        if (!any(rule.files, [&](const std::string& glob) { return glob_matches(glob, relative); })) return false;
        if (!any(rule.suffixes, [&](const std::string& suffix) { return stem.ends_with(lower(suffix)); })) return false;
        if (!any(rule.folders, [&](const std::string& folder) {
                const fs::path above = fs::path(lower(name.parent_path().string()));
                return std::find(above.begin(), above.end(), fs::path(lower(folder))) != above.end();
            }))
            return false;
        if (!rule.one_bit) return true;
        if (!one_bit) {
            const std::optional<ImageHeader> header = peek_image_header(path);
            one_bit = header && header->bits == 1;
        }
        return *one_bit == *rule.one_bit;
    };
    const auto found = std::find_if(recipe.rules.begin(), recipe.rules.end(), matches);
    return found == recipe.rules.end() ? nullptr : &*found;
}

std::string fill_in(const std::string& pattern, const Placeholders& values) {
    std::string text;
    for (std::size_t at = 0; at < pattern.size();) {
        const std::size_t end = pattern[at] == '{' ? pattern.find('}', at) : pattern.npos;
        if (end == pattern.npos) {
            text += pattern[at++];
            continue;
        }
        const std::string name = pattern.substr(at + 1, end - at - 1);
        text += name == "stem" ? values.stem : name == "from" ? values.from : name == "kind" ? values.kind : name == "folder" ? values.folder : values.out;
        at = end + 1;
    }
    return text;
}

} // namespace reliefbake
