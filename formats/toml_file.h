#pragma once
// TOML that people write: recipes, scenes. Read into toml++'s tables; every refusal names the file and the line.

#include "bake/error.h"

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace reliefbake {

constexpr std::uint64_t largest_toml_bytes = 1u << 20;
/// Brackets and braces inside each other, and dots of one key. toml++ and its tables recurse once for each.
constexpr int deepest_toml = 32;

/// `name` stands in messages. Any bytes are safe. Errors: bad_data, "NAME:LINE: what is wrong".
Result<toml::table> parse_toml(std::string_view text, const std::string& name);

/// Errors: no_input; bad_data (no TOML, above largest_toml_bytes, deeper than deepest_toml).
Result<toml::table> read_toml_file(const std::filesystem::path& path);

/// "NAME:LINE: words" as bad_data, for what is wrong with the value `node`; "NAME: words" where it has no line.
tl::unexpected<Error> toml_fault(const toml::node& node, const std::string& name, const std::string& words);

/// The value of `key`; none where the table lacks it. Errors (bad_data): it is of another type, which the message names.
/// T: std::string, bool, std::int64_t; double takes integers too, and refuses inf and nan.
template <class T>
Result<std::optional<T>> toml_value(const toml::table& table, std::string_view key, const std::string& name);

/// The same for a table or an array (toml::table, toml::array) inside; null where the table lacks it.
template <class T>
Result<const T*> toml_part(const toml::table& table, std::string_view key, const std::string& name);

/// Refuses (bad_data) the first key, by line, that is none of `known`, which the message lists.
Result<void> refuse_unknown_keys(const toml::table& table, std::initializer_list<std::string_view> known, const std::string& name);

} // namespace reliefbake
