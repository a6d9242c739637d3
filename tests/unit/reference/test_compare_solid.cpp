#include "shaders-reference/measure/compare_solid.h"
#include "tests/support/fields.h"
#include "tests/support/shapes.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

TEST_CASE("guarantee S holds at random and adversarial points, and its breach is found", "[measure][shape]") {
    std::mt19937 random(8);
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
        for (const ShapeModel model : {ShapeModel::squares, ShapeModel::centres, ShapeModel::contour})
            for (const bool with_sign : {false, true})
                for (const Wrap wrap : {Wrap::repeat, Wrap::clamp}) {
                    const TexelGrid grid{1 + int(random() % 40), 1 + int(random() % 40), wrap, wrap, 1};
                    ShapeMapOptions options;
                    options.bits = bits, options.signed_distance = with_sign;
                    const unsigned share = random() % 2 ? 20 : 200;
                    const ShapeMap map = model == ShapeModel::contour ? contour_map_of(grid, random_coverage(grid, random(), share), options)
                                                                      : shape_map_of(grid, random_shape(grid, random(), share), options, model);
                    const DistanceCheck check = check_distances(map, stored_shape(map), 2000, random());
                    INFO("bits " << int(bits) << " model " << int(model) << " size " << grid.width << "x" << grid.height << " worst " << check.worst);
                    CHECK(check.points == 2000);
                    CHECK(check.violations == 0);
                }
    const TexelGrid grid{32, 32, Wrap::clamp, Wrap::clamp, 1};
    for (ShapeMap map : {shape_map_of(grid, random_shape(grid, 3, 6)), contour_map_of(grid, random_coverage(grid, 3, 6))}) {
        map.info.tau *= 1.1;
        const DistanceCheck broken = check_distances(map, stored_shape(map), 2000, 1);
        CHECK(broken.violations > 100);
        CHECK(broken.worst > 0.1);
    }
}

TEST_CASE("the distance check does not depend on threads", "[measure][shape]") {
    const TexelGrid grid{32, 32, Wrap::repeat, Wrap::clamp, 1};
    const ShapeMap map = shape_map_of(grid, random_shape(grid, 3, 6));
    const DistanceCheck one = check_distances(map, stored_shape(map), 3000, 7, 1), two = check_distances(map, stored_shape(map), 3000, 7, 2);
    CHECK(one.worst == two.worst);
    CHECK(one.u == two.u);
}
