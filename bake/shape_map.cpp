#include "bake/shape_map.h"

#include "bake/contour_distance.h"
#include "bake/danielsson.h"
#include "bake/distance_transform.h"
#include "bake/parallel.h"
#include "bake/stored_code.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reliefbake {

namespace {

/// What distances are measured to.
struct Side {
    const BinaryShape& shape;
    const Image<float>& coverage; ///< as stored; of ShapeModel::contour
};

DistanceOptions transform_options(const BinaryShape& shape, int threads) {
    const TexelGrid& grid = shape.grid();
    DistanceOptions options;
    options.to = shape.model() == ShapeModel::centres ? DistanceTo::centres : DistanceTo::squares;
    options.wrap_x = grid.wrap_x == Wrap::repeat, options.wrap_y = grid.wrap_y == Wrap::repeat;
    options.threads = threads;
    return options;
}

template <class T>
Image<T> one_minus(Image<T> image) {
    for (T& v : image) v = T(1 - v);
    return image;
}

/// Distances, in texels, to the shape, or to its outside.
Image<float> distances_to(const Side& side, bool outside, const ShapeMapOptions& options) {
    const BinaryShape& shape = side.shape;
    if (shape.model() == ShapeModel::contour)
        return contour_distances(outside ? one_minus(side.coverage) : side.coverage, shape.grid(), options.threads);
    if (options.method == DistanceMethod::danielsson)
        return danielsson_distances(outside ? one_minus(shape.outside()) : shape.outside());
    DistanceOptions to = transform_options(shape, options.threads);
    to.set = outside;
    return distance_transform(shape.outside(), to);
}

/// Distances in texels: to the shape outside it; inside it 0, or minus that to its outside.
Image<float> signed_distances(const Side& side, const ShapeMapOptions& options) {
    Image<float> distance = distances_to(side, false, options);
    if (!options.signed_distance) return distance;
    const Image<float> inner = distances_to(side, true, options);
    for (std::size_t k = 0; k < distance.size(); ++k)
        if (distance[k] == 0) distance[k] = -inner[k];
    return distance;
}

/// How far Danielsson's distances are from the exact ones.
void measure_error(const BinaryShape& shape, const ShapeMapOptions& options, const Image<float>& distance, ShapeMapInfo& info) {
    ShapeMapOptions exact = options;
    exact.method = DistanceMethod::exact;
    const Image<float> right = signed_distances({shape, {}}, exact);
    double most = 0, wrong = 0;
    for (std::size_t k = 0; k < right.size(); ++k) {
        wrong += distance[k] != right[k];
        if (distance[k] != right[k]) most = std::max(most, std::fabs(double(distance[k]) - right[k]));
    }
    info.statistics["wrong_texels"] = wrong;
    info.statistics["error_max"] = most;
}

Result<void> check_options(const BinaryShape& shape, const ShapeMapOptions& options) {
    if (!(options.scale_f > 0 && options.scale_f <= 1)) return fail(ErrorCode::usage, "scale f: expected a number above 0, at most 1");
    if (options.method == DistanceMethod::exact) return {};
    const bool plain = shape.model() == ShapeModel::centres && shape.grid().wrap_x == Wrap::clamp && shape.grid().wrap_y == Wrap::clamp;
    if (plain) return {};
    return fail(ErrorCode::usage, "method danielsson: measures to texel centres alone, and not around the border of a tile");
}

float largest_magnitude(const Image<float>& plane) {
    float most = 0;
    for (const float v : plane) most = std::max(most, std::fabs(v));
    return most;
}

/// Central differences with Scharr's weights 3, 10, 3 (2000), which keep directions best.
void unit_gradients(const Image<float>& distance, const TexelGrid& grid, int threads, Image<float>& gx, Image<float>& gy) {
    gx = gy = Image<float>(grid.width, grid.height);
    parallel_for(grid.height, threads, [&](int y) {
        const float* rows[] = {distance.row(grid.address_y(y - 1)), distance.row(y), distance.row(grid.address_y(y + 1))};
        for (int x = 0; x < grid.width; ++x) {
            const int left = grid.address_x(x - 1), right = grid.address_x(x + 1);
            constexpr double side = 3, middle = 10;
            const auto along_x = [&](int j) { return double(rows[j][right]) - rows[j][left]; };
            const auto along_y = [&](int i) { return double(rows[2][i]) - rows[0][i]; };
            const double dx = side * (along_x(0) + along_x(2)) + middle * along_x(1);
            const double dy = side * (along_y(left) + along_y(right)) + middle * along_y(x);
            const double length = std::sqrt(dx * dx + dy * dy);
            constexpr double rounding = 1e-5; // of distances: where they cancel there is no direction
            const bool has_one = length > rounding * (1 + std::fabs(double(rows[1][x])));
            gx(x, y) = has_one ? float(dx / length) : 0;
            gy(x, y) = has_one ? float(dy / length) : 0;
        }
    });
}

float stored_direction(float g, BitDepth bits) {
    if (is_unorm(bits)) return stored_value(nearest_code(0.5 * g + 0.5, bits), bits);
    return std::copysign(stored_value(nearest_code(std::fabs(g), bits), bits), g);
}

/// The largest value that decodes to at most `code`, code >= 0.
float stored_below(double code, BitDepth bits) {
    const StoredCode up = code_at_least(code, bits);
    const float value = stored_value(up, bits);
    return value <= code || up == 0 ? value : stored_value(up - 1, bits);
}

float stored_above(double code, BitDepth bits) { return stored_value(code_at_least(code, bits), bits); }

/// 0 inside, 1 outside; of a contour, the part of each texel that is outside, to the nearest code: what is stored is what is measured.
Image<float> stored_shape_plane(const BinaryShape& shape, BitDepth bits) {
    Image<float> plane(shape.grid().width, shape.grid().height);
    const bool contour = shape.model() == ShapeModel::contour;
    for (std::size_t k = 0; k < plane.size(); ++k)
        plane[k] = contour ? stored_value(nearest_code(1 - double(shape.coverage()[k]), bits), bits) : float(shape.outside()[k]);
    return plane;
}

/// A quotient -1..1 as its code, rounded down.
float stored_distance(double quotient, const ShapeMapInfo& info) {
    const double q = std::clamp(quotient, -1.0, 1.0);
    if (info.signed_distance && is_unorm(info.bits)) return stored_below(0.5 * q + 0.5, info.bits);
    return q >= 0 ? stored_below(q, info.bits) : -stored_above(-q, info.bits);
}

/// What makes up for distances that were rounded up to float, and for a shader's float arithmetic.
constexpr double rounding_margin = 1 - 0x1p-22;

} // namespace

bool is_empty(const ShapeMap& map) {
    const float outside = map.info.model == ShapeModel::contour ? 1 : 0.5f;
    return std::none_of(map.shape.begin(), map.shape.end(), [outside](float stored) { return stored < outside; });
}

double safe_distance(double distance, const TexelGrid& grid) {
    const double texel = grid.pitch_x();
    const double square = distance * distance - 0.5 * texel * texel;
    return distance > 0 && square > 0 ? std::sqrt(square) : 0;
}

Result<ShapeMap> bake_shape_map(const BinaryShape& shape, const ShapeMapOptions& options) {
    if (Result<void> checked = check_options(shape, options); !checked) return tl::unexpected(checked.error());
    const TexelGrid& grid = shape.grid();
    const float diagonal = float(std::hypot(double(grid.width), double(grid.height)));
    Image<float> mask = stored_shape_plane(shape, options.bits);
    const Image<float> coverage = shape.model() == ShapeModel::contour ? one_minus(mask) : Image<float>();
    Image<float> distance = signed_distances({shape, coverage}, options);
    for (float& d : distance) d = std::clamp(d, -diagonal, diagonal);

    ShapeMap map;
    map.grid = grid;
    map.info.model = shape.model();
    map.info.method = options.method;
    map.info.signed_distance = options.signed_distance;
    map.info.bits = options.bits;
    map.info.scale_f = options.scale_f;
    map.info.max_distance = largest_magnitude(distance);
    const double largest = map.info.max_distance > 0 ? map.info.max_distance : 1;
    map.info.tau = options.scale_f * largest * rounding_margin / grid.width;
    // Weights of 1/256 place a lookup up to 1/512 texel off on each axis.
    map.info.filter_delta = std::sqrt(2.0) / 512 / grid.width;
    if (options.method == DistanceMethod::exact) map.info.guarantee.assign(1, 'S');
    map.info.statistics["inside_texels"] = double(shape.inside_count());

    if (options.method == DistanceMethod::danielsson) measure_error(shape, options, distance, map.info);

    unit_gradients(distance, grid, options.threads, map.gradient_x, map.gradient_y);
    for (float& g : map.gradient_x) g = stored_direction(g, options.bits);
    for (float& g : map.gradient_y) g = stored_direction(g, options.bits);
    const double per_code = options.scale_f * largest;
    for (float& d : distance) d = stored_distance(d / per_code, map.info);
    map.distance = std::move(distance);
    map.shape = std::move(mask);
    return map;
}

} // namespace reliefbake
