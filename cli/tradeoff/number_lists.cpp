#include "cli/tradeoff/number_lists.h"

#include "cli/options/number_options.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

std::vector<std::string> list_parts(const std::string& flag, const std::string& given) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= given.size();) {
        const std::size_t end = std::min(given.find(',', begin), given.size());
        parts.push_back(given.substr(begin, end - begin));
        begin = end + 1;
        const bool again = std::find(parts.begin(), parts.end() - 1, parts.back()) != parts.end() - 1;
        if (parts.back().empty() || again) throw CLI::ValidationError(flag, "expected values with commas between them, each once; found '" + given + "'");
    }
    return parts;
}

std::vector<int> require_integers(const std::string& flag, const std::string& given, int low, int high) {
    std::vector<int> numbers;
    for (const std::string& part : list_parts(flag, given)) {
        const std::optional<double> number = parse_number(part);
        if (!number || *number != std::floor(*number) || *number < low || *number > high)
            throw CLI::ValidationError(flag, "expected whole numbers from " + std::to_string(low) + " to " + std::to_string(high) + ", found '" + part + "'");
        numbers.push_back(int(*number));
    }
    return numbers;
}

} // namespace reliefbake
