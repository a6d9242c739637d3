// Stereolithography, binary and text: triangles without vertices. Equal corners become one vertex.

#include "formats/mesh/readers.h"
#include "formats/mesh/text_lines.h"
#include "mesh/weld.h"

#include <algorithm>
#include <cstring>

namespace reliefbake {

namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

/// Corners as read, three a triangle, to vertices and triangles.
Mesh index_corners(std::vector<Imath::V3d> corners) {
    const Weld weld = weld_positions(corners, 1);
    Mesh mesh;
    std::vector<std::uint32_t> number(corners.size());
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const std::uint32_t place = weld.position_of[k];
        const bool repeats = place != no_position && weld.first_vertex[place] != k;
        if (!repeats) mesh.positions.push_back(corners[k]);
        number[k] = repeats ? number[weld.first_vertex[place]] : std::uint32_t(mesh.positions.size() - 1);
    }
    for (std::size_t k = 0; k + 2 < corners.size(); k += 3) mesh.triangles.push_back({number[k], number[k + 1], number[k + 2]});
    return mesh;
}

Result<std::vector<Imath::V3d>> binary_corners(std::string_view bytes, const MeshBudget& budget, const std::string& name) {
    std::uint32_t count;
    std::memcpy(&count, bytes.data() + header_bytes - 4, 4);
    const std::uint64_t there = (bytes.size() - header_bytes) / facet_bytes;
    if (count > there)
        return fail(ErrorCode::bad_data, name + ": claims " + std::to_string(count) + " triangles and holds " + std::to_string(there) +
                                             "; it is truncated or no STL file");
    if (Result<void> fits = check_budget(3 * std::uint64_t(count), count, budget, name); !fits) return tl::unexpected(fits.error());
    std::vector<Imath::V3d> corners;
    corners.reserve(3 * std::size_t(count));
    for (std::size_t t = 0; t < count; ++t) {
        float n[12]; // the facet's normal, then its corners
        std::memcpy(n, bytes.data() + header_bytes + t * facet_bytes, sizeof n);
        for (int k = 3; k < 12; k += 3) corners.push_back({n[k], n[k + 1], n[k + 2]});
    }
    return corners;
}

Result<std::vector<Imath::V3d>> text_corners(std::string_view text, const MeshBudget& budget, const std::string& name) {
    std::vector<Imath::V3d> corners;
    std::size_t in_facet = 0;
    Lines lines(text);
    for (std::string_view line; lines.next(line);) {
        const std::string_view word = take_word(line);
        const auto refuse = [&](const char* what) { return fail(ErrorCode::bad_data, name + ": line " + std::to_string(lines.number()) + ": " + what); };
        if (word == "endfacet") {
            if (in_facet != 3) return refuse("a facet needs three vertices");
            in_facet = 0;
        }
        if (word != "vertex") continue;
        const auto x = to_number(take_word(line)), y = to_number(take_word(line)), z = to_number(take_word(line));
        if (!x || !y || !z) return refuse("expected vertex and three numbers");
        corners.push_back({*x, *y, *z});
        ++in_facet;
        if (Result<void> fits = check_budget(corners.size(), corners.size() / 3, budget, name); !fits) return tl::unexpected(fits.error());
    }
    if (corners.size() % 3 != 0) return fail(ErrorCode::bad_data, name + ": ends inside a facet; it is truncated");
    return corners;
}

} // namespace

Result<MeshFile> parse_stl(std::string_view bytes, const MeshBudget& budget, const std::string& name) {
    // Binary files may begin with "solid" too.
    const bool is_text = bytes.starts_with("solid") && bytes.substr(0, 1024).find("facet") != bytes.npos;
    if (!is_text && bytes.size() < header_bytes) return fail(ErrorCode::bad_data, name + ": is too short for an STL file");
    auto corners = is_text ? text_corners(bytes, budget, name) : binary_corners(bytes, budget, name);
    if (!corners) return tl::unexpected(corners.error());
    if (corners->empty()) return fail(ErrorCode::bad_data, name + ": has no triangles to bake");
    MeshFile file{MeshFormat::stl, {}, {}, {}};
    file.meshes.push_back(index_corners(std::move(*corners)));
    return file;
}

} // namespace reliefbake
