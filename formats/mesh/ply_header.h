#pragma once
// The header of a PLY file.

#include "bake/error.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace reliefbake {

enum class PlyEncoding { text, little_endian, big_endian };
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

int ply_bytes(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type;
    bool is_list = false;
    PlyType count_type = PlyType::uint8; ///< of a list
};

struct PlyElement {
    std::string name;
    std::uint64_t count;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::text;
    std::vector<PlyElement> elements;
    std::string relief; ///< our metadata, from a comment; may be empty
    std::size_t bytes = 0; ///< where the data begins
    std::size_t lines = 0;
};

/// Refuses (bad_data) headers that claim more elements than the file has bytes for.
Result<PlyHeader> parse_ply_header(std::string_view file, const std::string& name);

} // namespace reliefbake
