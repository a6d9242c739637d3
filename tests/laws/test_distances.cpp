#include "bake/distance_transform.h"
#include "bake/simd.h"

#include "tests/support/slow_distances.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

using Picture = Image<std::uint8_t>;

/// Both ways to measure, both sides, all four addressings.
std::vector<DistanceOptions> all_options() {
    std::vector<DistanceOptions> all;
    for (const DistanceTo to : {DistanceTo::centres, DistanceTo::squares})
        for (const int bits : {0, 1, 2, 3, 4, 5, 6, 7}) all.push_back({to, std::uint8_t(bits & 1), (bits & 2) != 0, (bits & 4) != 0, 1});
    return all;
}

void check_exact(const Picture& picture, const DistanceOptions& options) {
    INFO(picture.width() << " x " << picture.height() << ", squares " << int(options.to) << ", set " << int(options.set) << ", wrap "
                         << options.wrap_x << options.wrap_y);
    CHECK(distance_transform(picture, options) == slow_distances(picture, options));
}

Picture picture_of(int width, int height, const std::function<bool(int, int)>& set) {
    Picture picture(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) picture(x, y) = !set(x, y);
    return picture;
}

/// One texel in `sparsity` set.
Picture noise(int width, int height, std::mt19937& random, unsigned sparsity) {
    return picture_of(width, height, [&](int, int) { return random() % sparsity == 0; });
}

template <class T>
Image<T> moved(int width, int height, const std::function<T(int, int)>& at) {
    Image<T> out(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) out(x, y) = at(x, y);
    return out;
}

template <class T>
Image<T> transposed(const Image<T>& image) {
    return moved<T>(image.height(), image.width(), [&](int x, int y) { return image(y, x); });
}

template <class T>
Image<T> mirrored(const Image<T>& image) {
    return moved<T>(image.width(), image.height(), [&](int x, int y) { return image(image.width() - 1 - x, y); });
}

template <class T>
Image<T> shifted(const Image<T>& image, int by_x, int by_y) {
    return moved<T>(image.width(), image.height(),
                    [&](int x, int y) { return image((x + by_x) % image.width(), (y + by_y) % image.height()); });
}

} // namespace

TEST_CASE("Distances equal brute force for every picture of up to eight texels") {
    for (int width = 1; width <= 8; ++width)
        for (int height = 1; width * height <= 8; ++height)
            for (unsigned bits = 0; bits < 1u << (width * height); ++bits) {
                const Picture picture = picture_of(width, height, [&](int x, int y) { return (bits >> (y * width + x) & 1) != 0; });
                for (const DistanceOptions& options : all_options())
                    if (distance_transform(picture, options) != slow_distances(picture, options)) check_exact(picture, options);
            }
}

TEST_CASE("Distances equal brute force for every size up to 9 x 9, and around the lengths of vectors and bands") {
    std::mt19937 random(1);
    for (int width = 1; width <= 9; ++width)
        for (int height = 1; height <= 9; ++height)
            for (const unsigned sparsity : {2u, 5u, 30u}) {
                const Picture picture = noise(width, height, random, sparsity);
                for (const DistanceOptions& options : all_options())
                    if (distance_transform(picture, options) != slow_distances(picture, options)) check_exact(picture, options);
            }
    for (const int width : {15, 16, 17, 31, 33, 63, 64, 65, 129})
        for (const int height : {1, 2, 63, 64, 65, 130})
            for (const DistanceOptions& options : all_options()) {
                Picture picture = noise(width, height, random, 90);
                if (options.set == 1) // brute force is slow where much is set
                    for (std::uint8_t& texel : picture) texel = 1 - texel;
                check_exact(picture, options);
            }
}

TEST_CASE("Distances equal brute force on 256 x 256, from noise to one texel") {
    std::mt19937 random(2);
    for (const unsigned sparsity : {100u, 3000u, 20000u, 65536u})
        for (const DistanceTo to : {DistanceTo::centres, DistanceTo::squares})
            for (const bool wrap : {false, true}) {
                Picture picture = noise(256, 256, random, sparsity);
                picture(int(random() % 256), int(random() % 256)) = 0;
                check_exact(picture, {to, 0, wrap, wrap, 1});
            }
}

TEST_CASE("Distances equal brute force where shapes are thin, far, large, or touch the border") {
    const int n = 50;
    const std::function<bool(int, int)> shapes[] = {
        [](int x, int y) { return x == 0 && y == 0; },                                       // a corner
        [&](int x, int y) { return x == y; },                                                // a diagonal
        [&](int x, int y) { return x + y == n - 1 && x % 7; },                               // a diagonal with gaps
        [&](int x, int y) { return x == 0 || y == n - 1; },                                  // the border
        [&](int x, int y) { return !(x == 30 && y == 21); },                                 // a gap of one texel
        [](int x, int y) { return (x - 25) * (x - 25) + (y - 25) * (y - 25) < 300; },       // a disc
        [](int x, int y) { return (x - 25) * (x - 25) + (y - 25) * (y - 25) > 500; },       // a hole
        [](int x, int y) { return std::abs((x - 10) * (x - 10) + (y - 25) * (y - 25) - 400) < 20; }, // a ring: many equal candidates
        [](int x, int y) { return x % 20 == 3 && y % 15 == 5; },                             // a grid
        [](int x, int) { return x == 17; },                                                  // a column: rows without a bend
        [](int, int y) { return y == 17; },                                                  // a row: columns alone decide
    };
    for (const auto& shape : shapes)
        for (const DistanceOptions& options : all_options()) check_exact(picture_of(n, n, shape), options);
}

TEST_CASE("Distances of a single column and a single row, longer than a byte counts") {
    for (const int length : {300, 16384}) {
        DistanceOptions options;
        for (options.wrap_x = false;; options.wrap_x = true) {
            options.wrap_y = options.wrap_x;
            Picture row(length, 1, 1);
            row(3, 0) = row(length / 2, 0) = 0;
            check_exact(row, options);
            check_exact(transposed(row), options);
            if (options.wrap_x) break;
        }
    }
}

TEST_CASE("Where nothing is set every distance is infinite; where all is set it is 0") {
    for (const DistanceOptions& options : all_options()) {
        const Picture nothing(70, 40, std::uint8_t(1 - options.set)), all(70, 40, options.set);
        CHECK(distance_transform(nothing, options) == Image<float>(70, 40, std::numeric_limits<float>::infinity()));
        CHECK(distance_transform(all, options) == Image<float>(70, 40, 0));
    }
}

TEST_CASE("A transposed or mirrored picture has the transposed or mirrored distances") {
    std::mt19937 random(3);
    const Picture picture = noise(211, 97, random, 700);
    for (DistanceOptions options : all_options()) {
        const Image<float> distances = distance_transform(picture, options);
        CHECK(distance_transform(mirrored(picture), options) == mirrored(distances));
        std::swap(options.wrap_x, options.wrap_y);
        CHECK(distance_transform(transposed(picture), options) == transposed(distances));
    }
}

TEST_CASE("Shifting a tile shifts its distances, and a tile twice over has them twice over") {
    std::mt19937 random(4);
    const Picture tile = noise(83, 61, random, 900);
    for (const DistanceTo to : {DistanceTo::centres, DistanceTo::squares}) {
        const DistanceOptions options{to, 0, true, true, 1};
        const Image<float> distances = distance_transform(tile, options);
        CHECK(distance_transform(shifted(tile, 40, 17), options) == shifted(distances, 40, 17));
        const auto twice = [](const auto& image) {
            using T = std::remove_cvref_t<decltype(image[0])>;
            return moved<T>(2 * image.width(), image.height(), [&](int x, int y) { return image(x % image.width(), y); });
        };
        CHECK(distance_transform(twice(tile), options) == twice(distances));
    }
}

TEST_CASE("Distances have the same bits for every instruction set and number of threads") {
    std::mt19937 random(5);
    const Picture picture = noise(333, 200, random, 2000);
    for (DistanceOptions options : all_options()) {
        use_simd(Simd::automatic);
        const Image<float> distances = distance_transform(picture, options);
        for (const Simd simd : available_simd())
            for (const int threads : {1, 2, 5}) {
                use_simd(simd);
                options.threads = threads;
                INFO(to_string(simd) << " " << threads);
                CHECK(distance_transform(picture, options) == distances);
            }
    }
    use_simd(Simd::automatic);
}

TEST_CASE("Distances are right up to the corner of the largest picture that 32 bits serve, and beyond") {
    // One set texel in a corner: every distance is known. Thin pictures reach the largest squares at little cost.
    for (const auto& [width, height] : {std::pair(32768, 20), std::pair(20, 32768), std::pair(40000, 3), std::pair(3, 65536), std::pair(65536, 2)})
        for (const DistanceTo to : {DistanceTo::centres, DistanceTo::squares}) {
            Picture picture(width, height, 1);
            picture(0, height - 1) = 0;
            const Image<float> distances = distance_transform(picture, {to, 0, false, false, 0});
            std::size_t wrong = 0;
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) {
                    const double less = to == DistanceTo::squares ? 0.5 : 0;
                    const double dx = std::max(0.0, x - less), dy = std::max(0.0, height - 1 - y - less);
                    wrong += distances(x, y) != float(std::sqrt(dx * dx + dy * dy));
                }
            INFO(width << " x " << height);
            CHECK(wrong == 0);
        }
}
