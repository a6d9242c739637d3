#pragma once
// Options that take a number: in range, nothing left over.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace reliefbake {

/// What a number must be, and how a message says it.
struct NumberRule {
    bool (*holds)(double);
    const char* expected;
};

extern const NumberRule finite_number;   ///< any finite number
extern const NumberRule positive_number; ///< finite and greater than 0
extern const NumberRule positive_or_inf; ///< greater than 0, or "inf"
extern const NumberRule fraction_number; ///< 0 to 1
extern const NumberRule pixel_aspect;    ///< what a bake accepts: 0.5 to 2

/// The whole of `text` as a decimal number (or "inf", "nan") in the C locale; nothing when anything is left
/// over.
std::optional<double> parse_number(const std::string& text);

/// Parses `text` under a rule. Throws CLI::ValidationError that names `flag`, what was expected and what was
/// found.
double require_number(const std::string& flag, const std::string& text, const NumberRule& rule);

/// "WIDTHxHEIGHT" in pixels, likewise.
std::pair<int, int> require_size(const std::string& flag, const std::string& text);

/// "N" or "N,M": repeats along u and v, likewise.
std::pair<double, double> require_repeats(const std::string& flag, const std::string& text);

/// Adds an option that takes one number. `target`: a float, a double or an optional of these.
template <class Target>
CLI::Option* add_number(CLI::App& app, const std::string& flag, Target& target, const NumberRule& rule,
                        const std::string& help) {
    auto assign = [flag, &target, &rule](const std::string& given) {
        target = require_number(flag, given, rule);
    };
    return app.add_option_function<std::string>(flag, assign, help)->type_name("NUMBER");
}

/// Adds --max-bytes: the budget of one decoded image; 0 keeps the built-in budget.
void add_byte_budget(CLI::App& app, std::uint64_t& bytes);

} // namespace reliefbake
