// Cones baked by bands of rows have the bits of those baked at once.

#include "bake/cone_bands.h"
#include "bake/normal_map.h"
#include "tests/support/cone_fields.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <limits>
#include <vector>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

struct Case {
    DepthMap depth;
    ConeOptions options;
    ConeEncoding encoding;
};

bool same_row(const float* a, const float* b, int width) { return std::memcmp(a, b, std::size_t(width) * sizeof(float)) == 0; }

/// Bands of `step` rows, from the top down or from the bottom up.
std::vector<std::pair<int, int>> bands_of(int height, int step, bool upwards) {
    std::vector<std::pair<int, int>> bands;
    for (int y = 0; y < height; y += step) bands.emplace_back(y, std::min(y + step, height));
    if (upwards) std::reverse(bands.begin(), bands.end());
    return bands;
}

/// Compares every row of a band: ratios, codes, normals.
void require_band(const Case& c, const ConeMap& whole, ConeBands& bands, int first, int end) {
    const Image<float> ratio = bands.bake(first, end);
    const int width = whole.grid.width;
    for (int y = first; y < end; ++y) REQUIRE(same_row(ratio.row(y - first), whole.ratio.row(y), width));

    const ConeBands::Depth band = bands.depth(first, end);
    ConeMap framed{band.map.grid, c.options, Image<float>(width, band.map.grid.height, 1.0f)};
    std::copy(ratio.begin(), ratio.end(), framed.ratio.row(band.above));
    const EncodeOptions encode{c.encoding, c.depth.bits};
    const EncodedConeMap codes = encode_cones(whole, c.depth, encode);
    const EncodedConeMap own = encode_cone_rows(framed, band.map, encode, band.above, band.above + end - first);
    const NormalMap normals = bake_normals(c.depth, 0.1), own_normals = bake_normals(band.map, 0.1);
    for (int y = first; y < end; ++y) {
        const int k = y - first + band.above;
        REQUIRE(same_row(band.map.level.row(k), c.depth.level.row(y), width));
        REQUIRE(same_row(own.value.row(k), codes.value.row(y), width));
        REQUIRE(same_row(own_normals.x.row(k), normals.x.row(y), width));
        REQUIRE(same_row(own_normals.y.row(k), normals.y.row(y), width));
    }
}

void require_same(const Case& c) {
    const ConeMap whole = bake_cones(c.depth, c.options);
    std::pmr::monotonic_buffer_resource storage;
    for (const bool upwards : {false, true})
        for (const int step : {band_step, 2 * band_step}) {
            CAPTURE(step, upwards, c.depth.grid.width, c.depth.grid.height, int(c.depth.grid.wrap_y));
            ConeBands bands(c.depth, c.options, &storage);
            for (const auto& [first, end] : bands_of(c.depth.grid.height, step, upwards)) require_band(c, whole, bands, first, end);
        }
}

std::vector<ConeOptions> all_options() {
    std::vector<ConeOptions> all(6);
    all[1].metric = Metric::l1;
    all[2].surface = SurfaceModel::texel;
    all[3].lookup = ConeLookup::cell;
    all[4].ratio_max = std::numeric_limits<float>::infinity();
    all[5].tolerance = 0;
    for (ConeOptions& options : all) options.threads = 2;
    return all;
}

} // namespace

TEST_CASE("bands have the bits of the whole map: sizes, addressing, options") {
    const ConeEncoding encodings[] = {ConeEncoding::sqrt, ConeEncoding::ratio, ConeEncoding::radius, ConeEncoding::normal};
    int next = 0;
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{{131, 200}, {64, 129}, {97, 64}, {40, 65}, {33, 7}, {5, 1}})
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp})
            for (const ConeOptions& options : all_options()) {
                const TexelGrid grid = grid_of(width, height, wrap, next % 3 == 0 ? 1.3 : 1);
                const bool open = std::isinf(options.ratio_max);
                require_same({noise(grid, std::uint32_t(next)), options, open ? ConeEncoding::normal : encodings[next % 4]});
                require_same({adversarial(grid, adversarial_names()[std::size_t(next) % adversarial_names().size()]), options,
                              open ? ConeEncoding::normal : encodings[(next + 1) % 4]});
                ++next;
            }
}

TEST_CASE("bands of floats, and of axes that repeat and end") {
    for (const bool across : {false, true}) {
        TexelGrid grid = grid_of(150, 193, Wrap::clamp);
        (across ? grid.wrap_x : grid.wrap_y) = Wrap::repeat;
        DepthMap depth = bumpy(grid, 3);
        depth.bits = BitDepth::float32;
        for (float& level : depth.level) level /= 65535.0f;
        for (const ConeOptions& options : all_options()) require_same({depth, options, ConeEncoding::normal});
    }
}
