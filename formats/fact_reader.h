#pragma once
// Single facts of a map's metadata: JSON values that may be missing or make no sense.

#include "bake/bit_depth.h"
#include "bake/texel_grid.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

// The words of the file format that several kinds of map share, in the order of the enumerators.
inline constexpr std::array layout_words{"rgba", "named", "side", "pair"};
inline constexpr std::array normal_y_words{"gl", "dx"};

nlohmann::json bits_to_json(BitDepth bits);
nlohmann::json wrap_to_json(const TexelGrid& grid);
nlohmann::json numbers_to_json(const std::map<std::string, double>& numbers);

constexpr const char* infinity_word = "inf"; ///< JSON has no infinity

nlohmann::json number_or_word(double value);

/// Finds values in an object and remembers those that make no sense.
class FactReader {
  public:
    FactReader(const nlohmann::json& object, std::vector<std::string>& bad_keys) : object_(object), bad_keys_(bad_keys) {}

    std::optional<std::string> text(const char* key) const {
        const auto value = object_.find(key);
        if (value == object_.end()) return std::nullopt;
        if (!value->is_string()) return bad(key);
        return value->get<std::string>();
    }

    template <class Enum, std::size_t N>
    std::optional<Enum> word(const char* key, const std::array<const char*, N>& words) const {
        const auto value = text(key);
        if (!value) return std::nullopt;
        if (const auto found = word_in<Enum>(*value, words)) return found;
        return bad(key);
    }

    template <class Enum, std::size_t N>
    static std::optional<Enum> word_in(const std::string& value, const std::array<const char*, N>& words) {
        for (std::size_t i = 0; i < N; ++i)
            if (value == words[i]) return Enum(i);
        return std::nullopt;
    }

    /// A finite number in [low, high].
    std::optional<double> number(const char* key, double low, double high) const {
        const auto value = object_.find(key);
        if (value == object_.end()) return std::nullopt;
        const double x = value->is_number() ? value->get<double>() : std::numeric_limits<double>::quiet_NaN();
        if (!(x >= low && x <= high)) return bad(key);
        return x;
    }

    const nlohmann::json* find(const char* key) const {
        const auto value = object_.find(key);
        return value == object_.end() ? nullptr : &*value;
    }

    std::optional<bool> flag(const char* key) const;

    /// `[x, y]`, each repeat or clamp.
    std::optional<std::pair<Wrap, Wrap>> wrap(const char* key) const;

    /// An object of numbers, infinite ones as the word "inf".
    std::map<std::string, double> numbers(const char* key) const;

    /// A fact that must be there.
    template <class T>
    T required(const std::optional<T>& fact, const char* key) const {
        if (!fact) bad(key);
        return fact.value_or(T{});
    }

    /// Where a map comes from: version, source_hash, argument_hash, statistics of `to`.
    template <class Facts>
    void origin(Facts& to) const {
        to.version = text("version").value_or("");
        to.source_hash = text("source_hash").value_or("");
        to.argument_hash = text("argument_hash").value_or("");
        to.statistics = numbers("statistics");
    }

    std::nullopt_t bad(const char* key) const {
        bad_keys_.emplace_back(key);
        return std::nullopt;
    }

  private:
    const nlohmann::json& object_;
    std::vector<std::string>& bad_keys_;
};

} // namespace reliefbake
