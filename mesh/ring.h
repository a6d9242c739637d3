#pragma once
// The neighbours of one position, gathered from its triangles.

#include "mesh/surface_fit.h"

namespace reliefbake {

/// Reused from position to position, so that none allocates.
class Ring {
  public:
    explicit Ring(const WeldedSurface& surface) : surface_(surface) {}

    /// Finds neighbours, topology and normal of `position`.
    void gather(std::uint32_t position);
    /// Adds the neighbours' neighbours; false where they are too many to be worth it (the hub of a large fan is near).
    bool extend();

    std::uint32_t position() const { return position_; }
    const std::vector<std::uint32_t>& neighbours() const { return neighbours_; }
    std::uint16_t flags() const { return flags_; }
    const Imath::V3d& normal() const { return normal_; } ///< unit length, or 0 with the flag no_normal
    std::size_t zero_area_corners() const { return zero_area_corners_; } ///< first corners of triangles without area

  private:
    bool take_closed_fan(std::span<const std::uint32_t> after, std::span<const std::uint32_t> before);
    void add(std::uint32_t neighbour, int direction);
    void add_many(std::span<const std::uint32_t> corners);
    void add_normal(const Imath::V3d& a, const Imath::V3d& b, bool first_corner);
    void classify(std::size_t triangles);

    const WeldedSurface& surface_;
    std::uint32_t position_ = 0;
    std::vector<std::uint32_t> neighbours_;
    std::vector<std::array<std::uint32_t, 2>> uses_; ///< triangles that leave and that come along each neighbour's edge; empty for a closed fan
    std::vector<std::array<std::uint32_t, 2>> sorting_;
    Imath::V3d normal_{0};
    std::uint16_t flags_ = 0;
    std::size_t zero_area_corners_ = 0;
};

} // namespace reliefbake
