#include "formats/fact_reader.h"

#include "bake/wrap_words.h"

#include <cmath>

namespace reliefbake {

using nlohmann::json;

namespace {

std::optional<double> number_or_infinity(const json& value) {
    if (value.is_number()) return value.get<double>();
    if (value == infinity_word) return std::numeric_limits<double>::infinity();
    return std::nullopt;
}

} // namespace

json number_or_word(double value) { return std::isinf(value) ? json(infinity_word) : json(value); }

json bits_to_json(BitDepth bits) {
    switch (bits) {
    case BitDepth::unorm8: return 8;
    case BitDepth::unorm16: return 16;
    case BitDepth::half: return "half";
    case BitDepth::float32: return "float";
    }
    return nullptr;
}

json wrap_to_json(const TexelGrid& grid) { return {word_of_wrap(grid.wrap_x), word_of_wrap(grid.wrap_y)}; }

json numbers_to_json(const std::map<std::string, double>& numbers) {
    json object = json::object();
    for (const auto& [key, value] : numbers) object[key] = number_or_word(value);
    return object;
}

std::optional<bool> FactReader::flag(const char* key) const {
    const json* value = find(key);
    if (!value) return std::nullopt;
    if (!value->is_boolean()) return bad(key);
    return value->get<bool>();
}

std::optional<std::pair<Wrap, Wrap>> FactReader::wrap(const char* key) const {
    const json* pair = find(key);
    if (!pair) return std::nullopt;
    const auto axis = [&](std::size_t i) -> std::optional<Wrap> {
        if (!pair->is_array() || pair->size() != 2 || !(*pair)[i].is_string()) return std::nullopt;
        return word_in<Wrap>((*pair)[i].get<std::string>(), words_of_wraps);
    };
    const auto x = axis(0), y = axis(1);
    if (!x || !y) return bad(key);
    return std::pair(*x, *y);
}

std::map<std::string, double> FactReader::numbers(const char* key) const {
    std::map<std::string, double> numbers;
    const json* object = find(key);
    if (!object) return numbers;
    if (!object->is_object()) {
        bad(key);
        return numbers;
    }
    for (const auto& [name, value] : object->items())
        if (const auto number = number_or_infinity(value)) numbers[name] = *number;
    return numbers;
}

} // namespace reliefbake
