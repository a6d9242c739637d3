#include "cli/options/length_option.h"

#include "cli/options/number_options.h"

#include <utility>

namespace reliefbake {

namespace {

// The longer suffix first: "mm" also ends in "m".
constexpr std::pair<const char*, double> units[] = {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}};

double parse_length(const std::string& flag, const std::string& given) {
    for (const auto& [unit, metres] : units) {
        const std::string suffix = unit;
        if (given.size() <= suffix.size() || !given.ends_with(suffix)) continue;
        const std::optional<double> number = parse_number(given.substr(0, given.size() - suffix.size()));
        if (number && positive_number.holds(*number)) return *number * metres;
    }
    throw CLI::ValidationError(flag, "expected a length with its unit (mm, cm, m), such as 10cm; found '" +
                                         given + "'");
}

} // namespace

CLI::Option* add_length(CLI::App& app, const std::string& flag, std::optional<double>& metres,
                        const std::string& help) {
    auto assign = [flag, &metres](const std::string& given) { metres = parse_length(flag, given); };
    return app.add_option_function<std::string>(flag, assign, help)->type_name("LENGTH");
}

} // namespace reliefbake
