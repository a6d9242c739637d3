#pragma once
// The outer shape of glTF files: the chunks of a GLB, and a look at JSON before it is parsed.

#include "bake/error.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace reliefbake {

struct GltfChunks {
    std::string_view json;
    std::string_view binary; ///< the BIN chunk; empty without one
    bool is_binary = false;
};

/// Splits a GLB, or takes the whole file as JSON. Errors: bad_data.
Result<GltfChunks> split_gltf(std::string_view bytes, const std::string& name);

/// Refuses (bad_data) JSON that is nested deeper than any glTF, or whose values would need more memory than `budget`.
Result<void> check_json_size(std::string_view json, std::uint64_t budget, const std::string& name);

} // namespace reliefbake
