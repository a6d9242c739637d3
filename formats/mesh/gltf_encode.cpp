#include "formats/little_endian.h"
#include "formats/mesh/gltf_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace reliefbake {

namespace {

using json = nlohmann::ordered_json;

std::string base64(std::string_view bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t k = 0; k < bytes.size(); k += 3) {
        const std::size_t have = std::min<std::size_t>(3, bytes.size() - k);
        std::uint32_t group = 0;
        for (std::size_t j = 0; j < 3; ++j) group = group << 8 | (j < have ? std::uint8_t(bytes[k + j]) : 0);
        for (std::size_t j = 0; j < 4; ++j) text += j <= have ? digits[group >> (18 - 6 * j) & 63] : '=';
    }
    return text;
}

} // namespace

Result<GltfSource> make_gltf(const Mesh& mesh, const std::string& generator, const std::string& name) {
    const auto beyond = [](const auto& v) {
        for (unsigned k = 0; k < v.dimensions(); ++k)
            if (!std::isfinite(float(v[int(k)]))) return true;
        return false;
    };
    const auto bad = std::count_if(mesh.positions.begin(), mesh.positions.end(), beyond) + std::count_if(mesh.uvs.begin(), mesh.uvs.end(), beyond);
    if (bad > 0)
        return fail(ErrorCode::bad_data, name + ": glTF cannot hold the " + std::to_string(bad) +
                                             " positions or texture coordinates that are not finite as floats; write .ply, or repair the mesh");
    GltfSource empty;
    empty.document = {{"asset", {{"version", "2.0"}, {"generator", generator}}},
                      {"scene", 0},
                      {"scenes", {{{"nodes", {0}}}}},
                      {"nodes", {{{"mesh", 0}}}},
                      {"meshes", {{{"primitives", {{{"attributes", json::object()}}}}}}}};
    GltfBuilder builder(empty);
    std::vector<float> flat;
    Imath::V3f low(std::numeric_limits<float>::max()), high(-std::numeric_limits<float>::max());
    for (const Imath::V3d& p : mesh.positions)
        for (int k = 0; k < 3; ++k) {
            flat.push_back(float(p[k]));
            low[k] = std::min(low[k], flat.back()), high[k] = std::max(high[k], flat.back());
        }
    const std::size_t positions = builder.add_floats(flat, 3);
    builder.document()["accessors"][positions]["min"] = {low.x, low.y, low.z};
    builder.document()["accessors"][positions]["max"] = {high.x, high.y, high.z};
    json attributes = {{"POSITION", positions}};
    if (!mesh.uvs.empty()) {
        flat.clear();
        for (const Imath::V2f& t : mesh.uvs) flat.push_back(t.x), flat.push_back(mesh.v_down ? t.y : 1 - t.y);
        attributes["TEXCOORD_0"] = builder.add_floats(flat, 2);
    }
    const std::uint32_t count = std::uint32_t(mesh.positions.size());
    json& primitive = builder.document()["meshes"][0]["primitives"][0];
    const std::size_t indices = builder.add_indices(mesh.triangles, 0, count);
    primitive["attributes"] = attributes;
    primitive["indices"] = indices;
    GltfDocument document = builder.take();
    GltfSource source{std::move(document.json), std::move(document.buffers), {}, {}};
    source.meshes.push_back({{0, 0, 0, count, 0, std::uint32_t(mesh.triangles.size())}});
    return source;
}

Result<std::vector<std::byte>> encode_glb(GltfDocument document, const std::string& name) {
    // Lay all buffers one behind the other.
    std::string binary;
    std::vector<std::size_t> begin;
    for (const std::string& bytes : document.buffers) {
        begin.push_back(binary.size());
        binary += bytes;
        binary.append((4 - binary.size() % 4) % 4, '\0');
    }
    if (document.json.contains("bufferViews"))
        for (json& view : document.json["bufferViews"]) {
            const std::size_t buffer = view.value("buffer", std::size_t(0));
            if (buffer >= begin.size()) continue;
            if (begin[buffer] > 0) view["byteOffset"] = view.value("byteOffset", std::size_t(0)) + begin[buffer];
            view["buffer"] = 0;
        }
    if (!document.buffers.empty()) {
        json whole = {{"byteLength", binary.size()}};
        const json& first = document.json["buffers"][0];
        for (const char* key : {"name", "extras"})
            if (first.is_object() && first.contains(key)) whole[key] = first[key];
        document.json["buffers"] = json::array({whole});
    }

    std::string text = document.json.dump(-1, ' ', false, json::error_handler_t::replace);
    text.append((4 - text.size() % 4) % 4, ' ');
    const std::uint64_t total = 12 + 8 + std::uint64_t(text.size()) + (binary.empty() ? 0 : 8 + std::uint64_t(binary.size()));
    if (total > std::numeric_limits<std::uint32_t>::max())
        return fail(ErrorCode::usage, name + ": GLB files end at 4 GiB; write a .gltf");
    ByteWriter out;
    out.text("glTF"), out.u32(2), out.u32(std::uint32_t(total));
    out.u32(std::uint32_t(text.size())), out.text("JSON"), out.text(text);
    if (!binary.empty()) out.u32(std::uint32_t(binary.size())), out.text(std::string_view("BIN\0", 4)), out.text(binary);
    return out.take();
}

std::vector<std::byte> encode_gltf(GltfDocument document) {
    for (std::size_t k = 0; k < document.buffers.size(); ++k) {
        json& buffer = document.json["buffers"][k];
        if (!buffer.contains("uri")) buffer["uri"] = "data:application/octet-stream;base64," + base64(document.buffers[k]);
    }
    ByteWriter out;
    out.text(document.json.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
    return out.take();
}

} // namespace reliefbake
