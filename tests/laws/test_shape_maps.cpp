// What shape maps promise: distances that never reach into the shape, however they are stored and filtered.

#include "bake/cut_square.h"
#include "bake/danielsson.h"
#include "bake/distance_transform.h"
#include "bake/shape_map.h"
#include "shaders-reference/measure/compare_solid.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <random>

using namespace reliefbake;

namespace {

Image<float> picture_of(int width, int height, const std::function<double(int, int)>& sample) {
    Image<float> picture(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture(x, y) = float(sample(x, y));
    return picture;
}

BinaryShape shape_of(const Image<float>& picture, ShapeModel model, bool wrap) {
    ShapeOptions options;
    options.model = model;
    options.wrap_x = options.wrap_y = wrap;
    return *make_shape(picture, options, "test");
}

DistanceCheck check(const ShapeMap& map, int points) {
    return check_distances(map, stored_shape(map), points, 1, 1);
}

/// The area of a texel that a disc covers, by points.
double disc_coverage(double cx, double cy, double radius, int x, int y) {
    constexpr int side = 32;
    int covered = 0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) covered += std::hypot(x + (i + 0.5) / side - cx, y + (j + 0.5) / side - cy) < radius;
    return double(covered) / (side * side);
}

/// Thin, far apart, and at the border: what a step overlooks first.
std::vector<Image<float>> adversarial_pictures() {
    std::mt19937 random(1);
    std::vector<Image<float>> pictures;
    pictures.push_back(picture_of(40, 31, [](int x, int y) { return x == 20 && y == 11 ? 0.0 : 1.0; }));
    pictures.push_back(picture_of(40, 31, [](int x, int y) { return x == 20 && y == 11 ? 1.0 : 0.0; }));
    pictures.push_back(picture_of(33, 33, [](int x, int y) { return x == y ? 0.0 : 1.0; }));
    pictures.push_back(picture_of(64, 16, [](int x, int y) { return (3 * y == x) ? 0.0 : 1.0; }));
    pictures.push_back(picture_of(40, 31, [](int x, int y) { return x == 0 || y == 30 ? 0.0 : 1.0; }));
    pictures.push_back(picture_of(40, 40, [&](int, int) { return random() % 40 ? 1.0 : 0.0; }));
    pictures.push_back(picture_of(40, 40, [&](int, int) { return random() % 256 / 255.0; }));
    pictures.push_back(picture_of(48, 48, [](int x, int y) { return 1 - disc_coverage(20.3, 25.8, 9.7, x, y); }));
    pictures.push_back(picture_of(257, 3, [](int x, int) { return x == 1 ? 0.0 : 1.0; }));
    return pictures;
}

} // namespace

TEST_CASE("No safe step enters the shape: every model, side, addressing, bit depth and scale") {
    for (const Image<float>& picture : adversarial_pictures())
        for (const ShapeModel model : {ShapeModel::squares, ShapeModel::centres, ShapeModel::contour})
            for (const bool wrap : {false, true})
                for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
                    for (const bool signed_distance : {false, true})
                        for (const double scale_f : {1.0, 0.3}) {
                            const ShapeMap map =
                                *bake_shape_map(shape_of(picture, model, wrap), {DistanceMethod::exact, signed_distance, scale_f, bits, 1});
                            const DistanceCheck found = check(map, 300);
                            INFO(picture.width() << " model " << int(model) << " wrap " << wrap << " bits " << int(bits) << " signed "
                                                 << signed_distance << " f " << scale_f << " excess " << found.worst << " at " << found.u << ", " << found.v);
                            CHECK(found.violations == 0);
                            CHECK(map.info.guarantee == "S");
                        }
}

TEST_CASE("Distances that are rounded up, half a texel too long, or of the other addressing are caught") {
    const Image<float> picture = picture_of(40, 31, [](int x, int y) { return x == 2 && y == 11 ? 0.0 : 1.0; });
    for (const ShapeModel model : {ShapeModel::squares, ShapeModel::contour}) {
        const ShapeMap good = *bake_shape_map(shape_of(picture, model, false), {});
        CHECK(check(good, 3000).violations == 0);
        ShapeMap up = good;
        for (float& code : up.distance) code = std::min(1.0f, code + 1.0f / 255);
        CHECK(check(up, 3000).violations > 0);
        ShapeMap centres = good;
        centres.info.tau *= 1.02;
        CHECK(check(centres, 3000).violations > 0);
        ShapeMap tile = good;
        tile.grid.wrap_x = Wrap::repeat;
        CHECK(check(tile, 3000).violations > 0);
    }
}

TEST_CASE("A bilinearly filtered distance may exceed the distance; guarantee S takes no more off than it must") {
    // One texel, far away, seen from the middle of four texels: the excess tends to (1/4) / (2 d), and S takes 1 / (4 d).
    const Image<float> picture = picture_of(101, 101, [](int x, int y) { return x == 50 && y == 50 ? 0.0 : 1.0; });
    const ShapeMap map = *bake_shape_map(shape_of(picture, ShapeModel::centres, false), {DistanceMethod::exact, false, 1, BitDepth::float32, 1});
    double most = -1;
    for (int y = 0; y < 100; ++y)
        for (int x = 0; x < 100; ++x) {
            const double filtered = 0.25 * map.info.tau * 101 *
                                    (double(map.distance(x, y)) + map.distance(x + 1, y) + map.distance(x, y + 1) + map.distance(x + 1, y + 1));
            most = std::max(most, filtered - std::hypot(x - 49.5, y - 49.5));
        }
    CHECK(most > 0.1); // so the plain distance is unsafe
    CHECK(most < 0.5);
}

TEST_CASE("Code 1 stands for tau, which is f of the largest distance") {
    const Image<float> picture = picture_of(64, 32, [](int x, int y) { return x == 3 && y == 16 ? 0.0 : 1.0; });
    for (const double f : {1.0, 0.25}) {
        const ShapeMap map = *bake_shape_map(shape_of(picture, ShapeModel::centres, false), {DistanceMethod::exact, false, f, BitDepth::unorm16, 1});
        CHECK(map.info.max_distance == Approx(std::hypot(60, 16)));
        CHECK(map.info.tau == Approx(f * std::hypot(60, 16) / 64).epsilon(1e-6));
        CHECK(map.distance(63, 0) == 1); // both ends of the codes are used
        CHECK(map.distance(3, 16) == 0);
        CHECK(map.shape(3, 16) == 0);
        CHECK(map.shape(4, 16) == 1);
        CHECK(decoded_distance(map.distance(13, 16), map.info) * 64 == Approx(10).epsilon(1e-3));
    }
}

TEST_CASE("An empty and a full shape have defined maps") {
    for (const ShapeModel model : {ShapeModel::squares, ShapeModel::centres, ShapeModel::contour})
        for (const bool signed_distance : {false, true}) {
            const ShapeMapOptions options{DistanceMethod::exact, signed_distance, 1, BitDepth::float32, 1};
            const ShapeMap empty = *bake_shape_map(shape_of(Image<float>(30, 40, 1), model, false), options);
            CHECK(empty.info.max_distance == 50);
            CHECK(empty.distance == Image<float>(30, 40, 1));
            CHECK(empty.gradient_x == Image<float>(30, 40, 0));
            CHECK(check(empty, 300).violations == 0);
            const ShapeMap full = *bake_shape_map(shape_of(Image<float>(30, 40, 0), model, false), options);
            CHECK(full.distance == Image<float>(30, 40, signed_distance ? -1 : 0));
            CHECK(full.info.tau > 0);
            CHECK(full.info.max_distance == (signed_distance ? 50 : 0));
            CHECK(check(full, 300).violations == 0);
        }
}

TEST_CASE("Signed distances are those to the shape outside it and minus those to the outside within it") {
    std::mt19937 random(3);
    const Image<float> picture = picture_of(37, 29, [&](int, int) { return random() % 3 ? 1.0 : 0.0; });
    const ShapeMapOptions options{DistanceMethod::exact, true, 1, BitDepth::float32, 1};
    const ShapeMap map = *bake_shape_map(shape_of(picture, ShapeModel::squares, true), options);
    ShapeOptions inverted;
    inverted.invert = inverted.wrap_x = inverted.wrap_y = true;
    const ShapeMap other = *bake_shape_map(*make_shape(picture, inverted, "test"), options);
    for (std::size_t k = 0; k < map.distance.size(); ++k) {
        CHECK(other.shape[k] == 1 - map.shape[k]);
        // Both are rounded down, so they differ by what rounding down takes.
        CHECK(map.distance[k] == Approx(-other.distance[k]).epsilon(1e-6));
    }
}

TEST_CASE("The gradient has length 1 and points away from the shape") {
    const Image<float> disc = picture_of(96, 96, [](int x, int y) { return std::hypot(x - 40, y - 50) < 12 ? 0.0 : 1.0; });
    const ShapeMap map = *bake_shape_map(shape_of(disc, ShapeModel::squares, false), {DistanceMethod::exact, true, 1, BitDepth::float32, 1});
    double worst = 1;
    for (int y = 1; y < 95; ++y)
        for (int x = 1; x < 95; ++x) {
            const double r = std::hypot(x - 40, y - 50);
            if (r < 14) continue; // stairs
            CHECK(std::hypot(map.gradient_x(x, y), map.gradient_y(x, y)) == Approx(1).epsilon(1e-6));
            worst = std::min(worst, (map.gradient_x(x, y) * (x - 40) + map.gradient_y(x, y) * (y - 50)) / r);
        }
    CHECK(worst > std::cos(0.3));
    const Image<float> half_plane = picture_of(20, 20, [](int x, int) { return x < 7 ? 0.0 : 1.0; });
    const ShapeMap plane = *bake_shape_map(shape_of(half_plane, ShapeModel::squares, false), {DistanceMethod::exact, false, 1, BitDepth::unorm8, 1});
    CHECK(plane.gradient_x(10, 9) == 1);
    CHECK(plane.gradient_y(10, 9) == 128.0f / 255);
}

TEST_CASE("A shape map of a transposed or mirrored picture is the transposed or mirrored map") {
    std::mt19937 random(4);
    const int w = 41, h = 30;
    const Image<float> picture = picture_of(w, h, [&](int, int) { return random() % 50 ? random() % 2 * 0.5 + 0.5 : 0.0; });
    for (const ShapeModel model : {ShapeModel::squares, ShapeModel::centres, ShapeModel::contour}) {
        const ShapeMapOptions options{DistanceMethod::exact, true, 1, BitDepth::float32, 1};
        const ShapeMap map = *bake_shape_map(shape_of(picture, model, true), options);
        const ShapeMap turned = *bake_shape_map(shape_of(picture_of(h, w, [&](int x, int y) { return picture(y, x); }), model, true), options);
        const ShapeMap mirror = *bake_shape_map(shape_of(picture_of(w, h, [&](int x, int y) { return picture(w - 1 - x, y); }), model, true), options);
        const double epsilon = model == ShapeModel::contour ? 1e-5 : 0;
        const double to_w = map.info.tau * w, to_h = turned.info.tau * h;
        for (int y = 0; y < h; ++y)
            for (int x = 0; x < w; ++x) {
                CHECK(std::abs(to_h * turned.distance(y, x) - to_w * map.distance(x, y)) <= 1e-6 * to_w + epsilon);
                CHECK(std::abs(mirror.distance(w - 1 - x, y) - map.distance(x, y)) <= epsilon);
                if (model == ShapeModel::contour) continue; // its distances are rounded otherwise, and decide where they nearly cancel
                CHECK(std::abs(turned.gradient_y(y, x) - map.gradient_x(x, y)) <= 1e-6);
                CHECK(std::abs(mirror.gradient_x(w - 1 - x, y) + map.gradient_x(x, y)) <= 0);
            }
    }
}

TEST_CASE("A cut square has its coverage as area and the gradient as normal") {
    std::mt19937 random(5);
    const TexelGrid grid{3, 3, Wrap::clamp, Wrap::clamp, 1};
    for (int round = 0; round < 200; ++round) {
        const Image<float> coverage = picture_of(3, 3, [&](int, int) { return random() % 255 / 254.0; });
        const CutSquare cut = cut_square(coverage, grid, 1, 1);
        if (coverage(1, 1) == 0 || cut.is_whole()) continue;
        int inside = 0;
        constexpr int side = 200;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) inside += cut.nx * ((i + 0.5) / side - 0.5) + cut.ny * ((j + 0.5) / side - 0.5) <= cut.reach;
        CHECK(double(inside) / (side * side) == Approx(coverage(1, 1)).margin(0.01));
        CHECK(std::hypot(cut.nx, cut.ny) == Approx(1));
    }
}

TEST_CASE("Anti-aliased edges give distances to a twentieth of a texel, where thresholds are a quarter off") {
    const double cx = 60.37, cy = 58.81, radius = 23.6;
    const Image<float> disc = picture_of(128, 128, [&](int x, int y) { return 1 - disc_coverage(cx, cy, radius, x, y); });
    const auto error = [&](ShapeModel model) {
        const ShapeMap map = *bake_shape_map(shape_of(disc, model, false), {DistanceMethod::exact, false, 1, BitDepth::float32, 1});
        double sum = 0, count = 0;
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const double exact = std::hypot(x + 0.5 - cx, y + 0.5 - cy) - radius;
                if (exact < 0.5) continue;
                sum += std::pow(decoded_distance(map.distance(x, y), map.info) * 128 - exact, 2), count += 1;
            }
        return std::sqrt(sum / count);
    };
    CHECK(error(ShapeModel::contour) < 0.05);
    CHECK(error(ShapeModel::squares) > 0.15);
}

TEST_CASE("Danielsson's distances are never too small, hardly ever wrong, and wrong by little") {
    std::mt19937 random(6);
    double wrong = 0, all = 0, most = 0;
    for (int round = 0; round < 40; ++round) {
        Image<std::uint8_t> picture(200, 160, 1);
        for (int k = 0; k < 90; ++k) picture(int(random() % 200), int(random() % 160)) = 0;
        const Image<float> exact = distance_transform(picture), near = danielsson_distances(picture);
        for (std::size_t k = 0; k < exact.size(); ++k) {
            CHECK(near[k] >= exact[k]);
            wrong += near[k] != exact[k], all += 1;
            most = std::max(most, double(near[k]) - exact[k]);
        }
    }
    CHECK(wrong > 0); // the method is approximate, or this is another one
    CHECK(wrong < 0.02 * all);
    CHECK(most < 0.5);
    const ShapeMap map = *bake_shape_map(shape_of(picture_of(60, 60, [&](int, int) { return random() % 300 ? 1.0 : 0.0; }), ShapeModel::centres, false),
                                         {DistanceMethod::danielsson, false, 1, BitDepth::float32, 1});
    CHECK(map.info.guarantee.empty());
    CHECK(map.info.statistics.count("error_max") == 1);
    CHECK(!bake_shape_map(shape_of(Image<float>(4, 4, 0), ShapeModel::squares, false), {DistanceMethod::danielsson, false, 1, BitDepth::float32, 1}));
    CHECK(!bake_shape_map(shape_of(Image<float>(4, 4, 0), ShapeModel::centres, true), {DistanceMethod::danielsson, false, 1, BitDepth::float32, 1}));
}

TEST_CASE("The door for shapes refuses what is no shape") {
    ShapeOptions options;
    options.threshold = 1.5;
    CHECK(make_shape(Image<float>(2, 2, 0), options, "f").error().code == ErrorCode::usage);
    options.threshold = 0.25;
    options.model = ShapeModel::contour;
    CHECK(make_shape(Image<float>(2, 2, 0), options, "f").error().code == ErrorCode::usage);
    options.threshold = 0.5;
    CHECK(make_shape(Image<float>(2, 2, 1.25f), options, "f").error().code == ErrorCode::bad_data);
    const Result<BinaryShape> bad = make_shape(picture_of(3, 2, [](int x, int y) { return x == 1 && y == 1 ? NAN : 0; }), {}, "f");
    CHECK(bad.error().code == ErrorCode::bad_data);
    CHECK(bad.error().message.find("(1, 1)") != std::string::npos);
    for (const double f : {0.0, -1.0, 1.5, double(NAN)}) {
        ShapeMapOptions bake;
        bake.scale_f = f;
        CHECK(bake_shape_map(shape_of(Image<float>(2, 2, 0), ShapeModel::squares, false), bake).error().code == ErrorCode::usage);
    }
}

TEST_CASE("A threshold, its side and its inverse choose the texels") {
    const Image<float> picture = picture_of(4, 1, [](int x, int) { return x / 4.0; }); // 0, 1/4, 1/2, 3/4
    const auto inside = [&](double threshold, bool bright, bool invert) {
        ShapeOptions options;
        options.threshold = threshold, options.bright_is_inside = bright, options.invert = invert;
        std::string text;
        const Result<BinaryShape> shape = make_shape(picture, options, "f");
        for (const std::uint8_t outside : shape->outside()) text += outside ? '.' : '#';
        return text;
    };
    CHECK(inside(0.5, false, false) == "##..");
    CHECK(inside(0.5, true, false) == "..##");
    CHECK(inside(0.5, false, true) == "..##");
    CHECK(inside(0.5, true, true) == "##..");
    CHECK(inside(0.75, true, false) == "...#");
    CHECK(inside(0, true, false) == "####");
}
