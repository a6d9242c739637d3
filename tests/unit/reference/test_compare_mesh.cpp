#include "shaders-reference/measure/compare_mesh.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;

namespace {

constexpr float none = INFINITY;

Image<float> row(std::initializer_list<float> values) {
    Image<float> image(int(values.size()), 1);
    std::copy(values.begin(), values.end(), image.begin());
    return image;
}

} // namespace

TEST_CASE("covers are counted pixel by pixel", "[measure][mesh]") {
    //                              out   band: right, wrong, beyond; both, hole, NaN
    const MeshPlanes view{row({none, 5, 5, none, 5, 5, 5}), row({none, none, none, 5, 5.5f, 6, 6}), row({none, none, 6, 5, 5.25f, none, NAN}),
                          row({0, 3, 4, 0, 5, 6, 2})};
    const MeshComparison c = compare_mesh({&view, 1}, 0.5);
    CHECK(c.base == 5);
    CHECK(c.truth == 4);
    CHECK(c.rendering == 3);
    CHECK(c.both == 2);
    CHECK(c.holes == 2);
    CHECK(c.wrong_cover == 1);
    CHECK(c.not_finite == 1);
    CHECK(c.iou() == Approx(2.0 / 5));
    CHECK(c.band == 3);
    CHECK(c.band_agreement() == Approx(2.0 / 3));
    CHECK(c.cut == 4); // right, wrong, hole, NaN
    CHECK(c.cut_iou() == Approx(1.0 / 4));
    CHECK(c.depth_mean == Approx(0.25));
    CHECK(c.depth_max == Approx(0.5));
    CHECK(c.steps_mean == Approx(4));
    CHECK(c.steps_max == 6);
}

TEST_CASE("a shader that never discards has nothing of the band; a perfect one all", "[measure][mesh]") {
    MeshPlanes view{row({5, 5, 5, 5}), row({none, 5, 5, none}), row({5, 5, 5, 5}), row({1, 1, 1, 1})};
    CHECK(compare_mesh({&view, 1}, 1).band_agreement() == 0);
    CHECK(compare_mesh({&view, 1}, 1).cut_iou() == 0);
    CHECK(compare_mesh({&view, 1}, 1).iou() == 0.5);
    view.rendering = view.truth;
    CHECK(compare_mesh({&view, 1}, 1).band_agreement() == 1);
    CHECK(compare_mesh({&view, 1}, 1).cut_iou() == 1);
    CHECK(compare_mesh({&view, 1}, 1).iou() == 1);
    // With nothing to cut away nothing is wrong.
    view.truth = view.rendering = view.base;
    CHECK(compare_mesh({&view, 1}, 1).cut_iou() == 1);
}

TEST_CASE("one pixel in a hundred lies beyond the 99 % error", "[measure][mesh]") {
    Image<float> near(1000, 1, 1), far(1000, 1, 1), steps(1000, 1, 0);
    for (int k = 0; k < 1000; ++k) far(k, 0) = 1 + float(k) / 1000;
    const MeshPlanes view{near, near, far, steps};
    const MeshComparison c = compare_mesh({&view, 1}, 1);
    CHECK(c.depth_99 == Approx(0.989).margin(2e-3));
    CHECK(c.depth_mean == Approx(0.4995).margin(1e-4));
}
