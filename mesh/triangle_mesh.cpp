#include "mesh/triangle_mesh.h"

#include <cmath>

namespace reliefbake {
namespace {

/// Fails when `is_bad` holds for any item; says how many and which is the first.
template <class Items, class IsBad>
Result<void> refuse_bad(const Items& items, const std::string& what, const std::string& name, IsBad is_bad) {
    std::size_t count = 0, first = 0;
    for (std::size_t k = 0; k < items.size(); ++k)
        if (is_bad(items[k]) && count++ == 0) first = k;
    if (count == 0) return {};
    return fail(ErrorCode::bad_data, name + ": " + std::to_string(count) + " " + what + ", the first is number " +
                                         std::to_string(first) + "; repair the mesh and export it again");
}

bool is_finite(const std::array<double, 3>& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

} // namespace

Result<CheckedMesh> make_mesh(const TriangleSoup& soup, const std::string& name) {
    const std::size_t count = soup.positions.size();
    Result<void> checked = refuse_bad(soup.positions, "positions are not finite", name,
                                      [](const auto& p) { return !is_finite(p); });
    if (checked)
        checked = refuse_bad(soup.triangles, "triangles name a vertex beyond the last", name,
                             [&](const auto& t) { return t[0] >= count || t[1] >= count || t[2] >= count; });
    if (!checked) return tl::unexpected(checked.error());

    CheckedMesh out;
    omerr().disable(); // it reports each refused face on stderr; we count them
    for (const auto& [x, y, z] : soup.positions) out.mesh.add_vertex({x, y, z});
    for (const auto& [a, b, c] : soup.triangles) {
        if (a == b || b == c || c == a) {
            ++out.degenerate_triangles;
            continue;
        }
        const auto vertex = [&](std::uint32_t k) { return out.mesh.vertex_handle(k); };
        if (!out.mesh.add_face(vertex(a), vertex(b), vertex(c)).is_valid()) ++out.non_manifold_triangles;
    }
    return out;
}

} // namespace reliefbake
