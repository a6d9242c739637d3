#include "cli/describe/describe.h"

#include "cli/options/number_options.h"
#include "cli/version.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace reliefbake {

namespace {

using Json = nlohmann::ordered_json;

/// What an option takes. CLI11 appends its checks to the name of a type: "N:INT in [1 - 1024]", "INT:{4,8}", "BYTES:SIZE [b, ...]".
struct Value {
    std::string name;
    std::vector<std::string> words;
    std::optional<double> least, most;
};

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

/// Words are those of "ratio|sqrt|normal"; "MAP|HEIGHT" and "auto|LO:HI" name kinds of things.
bool are_words(const std::string& type) {
    return type.find('|') != std::string::npos && std::none_of(type.begin(), type.end(), [](unsigned char c) { return std::isupper(c) || c == ' ' || c == ','; });
}

Value value_of(const std::string& type) {
    static const std::regex in_range(R"(([^:]+):(?:INT|FLOAT) in \[(\S+) - (\S+)\])"), in_set(R"(([^:]+):\{([^}]+)\})"), checked("([^:]+):SIZE .*");
    std::smatch match;
    if (std::regex_match(type, match, in_range)) return {match[1], {}, parse_number(match[2]), parse_number(match[3])};
    if (std::regex_match(type, match, in_set)) return {match[1], split(match[2], ','), {}, {}};
    if (std::regex_match(type, match, checked)) return {match[1], {}, {}, {}};
    if (are_words(type)) return {type, split(type, '|'), {}, {}};
    return {type, {}, {}, {}};
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

Json names_of(const std::set<CLI::Option*>& options) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options) names.push_back(option->get_name());
    std::sort(names.begin(), names.end()); // the set is in the order of addresses
    return names;
}

Json describe_option(const CLI::Option& option) {
    const bool flag = option.get_items_expected_max() == 0;
    Json json = {{"names", names_of(option)}, {"positional", option.get_positional()}, {"group", option.get_group()}, {"help", option.get_description()}};
    const Value value = value_of(flag ? "" : option.get_type_name());
    const bool is_file = !option.nonpositional() && value.name == "TEXT";
    json["value"] = flag ? Json() : Json(is_file ? "FILE" : value.name);
    json["words"] = value.words;
    if (value.least) json["least"] = *value.least, json["most"] = *value.most;
    json["required"] = option.get_required();
    json["several"] = option.get_items_expected_max() > 1;
    json["needs"] = names_of(option.get_needs());
    json["excludes"] = names_of(option.get_excludes());
    return json;
}

void add_commands(const CLI::App& app, const std::string& path, Json& commands) {
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        const std::string whole = path + command->get_name();
        if (!command->get_subcommands([](const CLI::App*) { return true; }).empty()) {
            add_commands(*command, whole + " ", commands);
            continue;
        }
        Json options = Json::array();
        for (const CLI::Option* option : command->get_options()) options.push_back(describe_option(*option));
        commands.push_back({{"path", whole}, {"summary", command->get_description()}, {"options", std::move(options)}});
    }
}

} // namespace

Json describe(const CLI::App& root) {
    Json commands = Json::array();
    add_commands(root, "", commands);
    return {{"name", root.get_name()}, {"version", version()}, {"about", root.get_description()}, {"commands", std::move(commands)}};
}

} // namespace reliefbake
