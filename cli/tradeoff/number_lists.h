#pragma once
// Options that take several values, "A,B,C".

#include "cli/choices.h"

#include <string>
#include <vector>

namespace reliefbake {

/// The parts between commas. Throws CLI::ValidationError that names `flag` where one is empty or stands twice.
std::vector<std::string> list_parts(const std::string& flag, const std::string& given);

/// Whole numbers from low to high, likewise.
std::vector<int> require_integers(const std::string& flag, const std::string& given, int low, int high);

/// Adds an option that takes words of a set.
template <class T>
void add_choices(CLI::App& app, const std::string& flag, std::vector<T>& target, const Words<T>& words, const std::string& help) {
    auto assign = [flag, &target, &words](const std::string& given) {
        target.clear();
        for (const std::string& part : list_parts(flag, given)) {
            const auto found = std::find_if(words.begin(), words.end(), [&](const auto& word) { return word.first == part; });
            if (found == words.end()) throw CLI::ValidationError(flag, "expected some of " + alternatives(words) + ", found '" + part + "'");
            target.push_back(found->second);
        }
    };
    app.add_option_function<std::string>(flag, assign, help)->type_name("A,B,...");
}

} // namespace reliefbake
