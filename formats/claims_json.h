#pragma once
// ImageClaims as the helper process sends them. The tool trusts no type and no range in them.

#include "formats/image_gate.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace reliefbake {

nlohmann::json claims_to_json(const ImageClaims& claims);

/// Empty when a member is missing or of another type. Values are checked later, by check_claims.
std::optional<ImageClaims> claims_from_json(const nlohmann::json& json);

/// The member as a number, or 0 when it is missing or not an unsigned integer.
std::uint64_t unsigned_member(const nlohmann::json& json, const char* key);

} // namespace reliefbake
