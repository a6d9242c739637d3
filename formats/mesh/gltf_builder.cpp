#include "formats/mesh/gltf_builder.h"

#include <limits>

namespace reliefbake {

using json = nlohmann::ordered_json;

namespace {

constexpr int unsigned_short = 5123, unsigned_int = 5125, real = 5126;

} // namespace

std::size_t GltfBuilder::add_view(std::string_view bytes, std::size_t count, Use use) {
    const std::size_t size = count > 0 ? bytes.size() / count : bytes.size(), padded = use == Use::vertices ? (size + 3) / 4 * 4 : size;
    json view = {{"buffer", buffers_.size()}, {"byteOffset", added_.size()}, {"byteLength", padded * count}};
    if (padded != size) view["byteStride"] = padded;
    view["target"] = int(use);
    if (padded == size) {
        added_ += bytes;
    } else {
        for (std::size_t k = 0; k < count; ++k) {
            added_ += bytes.substr(k * size, size);
            added_.append(padded - size, '\0');
        }
    }
    added_.append((4 - added_.size() % 4) % 4, '\0');
    json_["bufferViews"].push_back(std::move(view));
    return json_["bufferViews"].size() - 1;
}

std::size_t GltfBuilder::add_accessor(json accessor) {
    json_["accessors"].push_back(std::move(accessor));
    return json_["accessors"].size() - 1;
}

std::size_t GltfBuilder::add_floats(std::span<const float> values, int components) {
    static constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
    const std::size_t count = values.size() / std::size_t(components);
    static_assert(std::endian::native == std::endian::little, "glTF is little-endian");
    const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    const std::size_t view = add_view(bytes, count, Use::vertices);
    return add_accessor({{"bufferView", view}, {"componentType", real}, {"count", count}, {"type", types[components - 1]}});
}

std::size_t GltfBuilder::add_indices(std::span<const Triangle> triangles, std::uint32_t first_vertex, std::uint32_t vertex_count) {
    const bool small = vertex_count <= std::numeric_limits<std::uint16_t>::max(); // the largest 16-bit index restarts primitives
    std::string bytes;
    for (const Triangle& t : triangles)
        for (const std::uint32_t v : t) {
            const std::uint32_t index = v - first_vertex;
            bytes.append(reinterpret_cast<const char*>(&index), small ? 2 : 4);
        }
    const std::size_t view = add_view(bytes, 3 * triangles.size(), Use::indices);
    return add_accessor({{"bufferView", view}, {"componentType", small ? unsigned_short : unsigned_int}, {"count", 3 * triangles.size()}, {"type", "SCALAR"}});
}

GltfDocument GltfBuilder::take() {
    if (!added_.empty()) {
        json_["buffers"].push_back({{"byteLength", added_.size()}});
        buffers_.push_back(std::move(added_));
    }
    return {std::move(json_), std::move(buffers_)};
}

} // namespace reliefbake
