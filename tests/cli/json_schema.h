#pragma once
// The part of JSON Schema that our schemas use.

#include <nlohmann/json.hpp>

#include <string>

namespace reliefbake::test {

/// Empty, or the first place where `value` breaks `schema`. Knows type, enum, required, properties,
/// additionalProperties: false, items; other keywords are descriptions.
std::string schema_fault(const nlohmann::json& value, const nlohmann::json& schema,
                         const std::string& place = "$");

} // namespace reliefbake::test
