#include "formats/mesh/gltf_container.h"

#include <cstring>

namespace reliefbake {

namespace {

constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;

std::uint32_t number_at(std::string_view bytes, std::size_t place) {
    std::uint32_t value;
    std::memcpy(&value, bytes.data() + place, 4);
    return value;
}

} // namespace

Result<GltfChunks> split_gltf(std::string_view bytes, const std::string& name) {
    if (!bytes.starts_with("glTF")) return GltfChunks{bytes, {}, false};
    const auto refuse = [&](const std::string& what) { return fail(ErrorCode::bad_data, name + ": " + what); };
    constexpr std::size_t header = 12, chunk_header = 8;
    if (bytes.size() < header + chunk_header) return refuse("is too short for a GLB file");
    if (number_at(bytes, 4) != 2) return refuse("is GLB version " + std::to_string(number_at(bytes, 4)) + "; expected 2");
    const std::size_t length = number_at(bytes, 8);
    if (length > bytes.size()) return refuse("claims " + std::to_string(length) + " bytes and has " + std::to_string(bytes.size()) + "; it is truncated");
    GltfChunks chunks;
    chunks.is_binary = true;
    for (std::size_t place = header; place + chunk_header <= length;) {
        const std::size_t size = number_at(bytes, place);
        const std::uint32_t kind = number_at(bytes, place + 4);
        place += chunk_header;
        if (size > length - place) return refuse("has a chunk that reaches past its end; it is truncated");
        if (kind == json_chunk && !chunks.json.data()) chunks.json = bytes.substr(place, size);
        if (kind == binary_chunk && !chunks.binary.data()) chunks.binary = bytes.substr(place, size);
        place += size;
    }
    if (chunks.json.empty()) return refuse("has no JSON chunk");
    return chunks;
}

Result<void> check_json_size(std::string_view json, std::uint64_t budget, const std::string& name) {
    constexpr int deepest = 128;
    constexpr std::uint64_t value_bytes = 64; // a parsed value with its name, growth of its container included
    std::uint64_t values = 0;
    int depth = 0;
    bool in_text = false;
    for (std::size_t k = 0; k < json.size(); ++k) {
        const char c = json[k];
        if (in_text) {
            if (c == '\\') ++k;
            else if (c == '"') in_text = false;
            continue;
        }
        if (c == '"') in_text = true;
        values += c == ',' || c == '[' || c == '{';
        depth += (c == '[' || c == '{') - (c == ']' || c == '}');
        if (depth > deepest) return fail(ErrorCode::bad_data, name + ": its JSON is nested deeper than " + std::to_string(deepest) + " levels");
    }
    if (values * value_bytes + json.size() <= budget) return {};
    return fail(ErrorCode::bad_data, name + ": its JSON has " + std::to_string(values) + " values, over the budget of " + std::to_string(budget) +
                                         " bytes; --max-bytes lifts it");
}

} // namespace reliefbake
