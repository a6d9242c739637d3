#include "formats/little_endian.h"
#include "formats/mesh/writers.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace reliefbake {

namespace {

bool fits_floats(const std::vector<Imath::V3d>& positions) {
    return std::all_of(positions.begin(), positions.end(), [](const Imath::V3d& p) {
        const auto same = [](double x) { return double(float(x)) == x || std::isnan(x); };
        return same(p.x) && same(p.y) && same(p.z);
    });
}

std::string header_of(const Mesh& mesh, const QuadricStore& store, bool doubles, const nlohmann::json& info) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment reliefbake " + info.dump(-1, ' ', true) + "\n";
    const auto properties = [&](const char* type, std::initializer_list<const char*> names) {
        for (const char* name : names) text += "property " + std::string(type) + " " + name + "\n";
    };
    text += "element vertex " + std::to_string(mesh.positions.size()) + "\n";
    properties(doubles ? "double" : "float", {"x", "y", "z"});
    properties("float", {"nx", "ny", "nz"});
    if (!mesh.uvs.empty()) properties("float", {"s", "t"});
    properties("float", {"tx", "ty", "tz", "tw"});
    if (store.where == QuadricStore::Where::color) properties("uchar", {"red", "green", "blue"});
    else if (store.twist) properties("float", {"quadric_a", "quadric_b", "quadric_c"});
    else properties("float", {"quadric_a", "quadric_b"});
    return text + "element face " + std::to_string(mesh.triangles.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n";
}

} // namespace

float quadric_range(std::span<const Mesh> meshes, bool twist) {
    float range = 0;
    for (const Mesh& mesh : meshes)
        for (const Quadric& q : mesh.quadrics) range = std::max({range, std::fabs(q.a), std::fabs(q.b), twist ? std::fabs(q.c) : 0});
    return range;
}

std::uint32_t quadric_code(float value, float range, std::uint32_t codes) {
    const double middle = (codes - 1) / 2; // an odd number of codes about it: 0 has one of its own
    return range > 0 ? std::uint32_t(std::lround(middle + middle * double(value) / double(range))) : std::uint32_t(middle);
}

std::vector<std::byte> encode_ply(const Mesh& mesh, const QuadricStore& store, const nlohmann::json& info) {
    const bool doubles = !fits_floats(mesh.positions), colors = store.where == QuadricStore::Where::color;
    const float range = quadric_range(std::span(&mesh, 1), store.twist);
    ByteWriter out;
    const auto real = [&](float x) { out.u32(std::bit_cast<std::uint32_t>(x)); };
    const auto color = [&](float x) { out.u8(std::uint8_t(quadric_code(x, range, 255))); };
    out.text(header_of(mesh, store, doubles, info));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        for (int k = 0; k < 3; ++k)
            if (doubles) out.u64(std::bit_cast<std::uint64_t>(mesh.positions[v][k]));
            else real(float(mesh.positions[v][k]));
        for (int k = 0; k < 3; ++k) real(mesh.normals[v][k]);
        if (!mesh.uvs.empty()) { // PLY's origin is the bottom left
            real(mesh.uvs[v].x);
            real(mesh.v_down ? 1 - mesh.uvs[v].y : mesh.uvs[v].y);
        }
        for (int k = 0; k < 4; ++k) real(mesh.tangents[v][k]);
        const Quadric& q = mesh.quadrics[v];
        if (colors) {
            color(q.a), color(q.b), color(store.twist ? q.c : 0);
        } else {
            real(q.a), real(q.b);
            if (store.twist) real(q.c);
        }
    }
    for (const Triangle& t : mesh.triangles) {
        out.u8(3);
        for (const std::uint32_t v : t) out.u32(v);
    }
    return out.take();
}

} // namespace reliefbake
