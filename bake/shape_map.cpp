#include "bake/shape_map.h"

#include "bake/distance_transform.h"
#include "bake/parallel.h"
#include "bake/stored_code.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

/// Distances in texels: to the shape outside it; inside it 0, or minus that to its outside.
Image<float> signed_distances(const BinaryShape& shape, const ShapeMapOptions& options) {
    const TexelGrid& grid = shape.grid();
    DistanceOptions to;
    to.to = shape.model() == ShapeModel::centres ? DistanceTo::centres : DistanceTo::squares;
    to.wrap_x = grid.wrap_x == Wrap::repeat, to.wrap_y = grid.wrap_y == Wrap::repeat;
    to.threads = options.threads;
    Image<float> distance = distance_transform(shape.outside(), to);
    if (options.signed_distance) {
        to.set = 1;
        const Image<float> inner = distance_transform(shape.outside(), to);
        for (std::size_t k = 0; k < distance.size(); ++k) distance[k] -= inner[k] * float(1 - shape.outside()[k]);
    }
    return distance;
}

float largest_magnitude(const Image<float>& plane) {
    float most = 0;
    for (const float v : plane) most = std::max(most, std::fabs(v));
    return most;
}

/// Sobel's weights for smooth differences in any direction: Scharr (2000), 3 10 3.
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
            gx(x, y) = length > 0 ? float(dx / length) : 0;
            gy(x, y) = length > 0 ? float(dy / length) : 0;
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

/// A quotient -1..1 as its code, rounded down.
float stored_distance(double quotient, const ShapeMapInfo& info) {
    const double q = std::clamp(quotient, -1.0, 1.0);
    if (info.signed_distance && is_unorm(info.bits)) return stored_below(0.5 * q + 0.5, info.bits);
    return q >= 0 ? stored_below(q, info.bits) : -stored_above(-q, info.bits);
}

/// What makes up for distances that were rounded up to float, and for a shader's float arithmetic.
constexpr double rounding_margin = 1 - 0x1p-22;

} // namespace

double safe_distance(double distance, const TexelGrid& grid) {
    const double texel = grid.pitch_x();
    const double square = distance * distance - 0.5 * texel * texel;
    return distance > 0 && square > 0 ? std::sqrt(square) : 0;
}

Result<ShapeMap> bake_shape_map(const BinaryShape& shape, const ShapeMapOptions& options) {
    if (!(options.scale_f > 0 && options.scale_f <= 1)) return fail(ErrorCode::usage, "scale f: expected a number above 0, at most 1");
    const TexelGrid& grid = shape.grid();
    const float diagonal = float(std::hypot(double(grid.width), double(grid.height)));
    Image<float> distance = signed_distances(shape, options);
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

    unit_gradients(distance, grid, options.threads, map.gradient_x, map.gradient_y);
    for (float& g : map.gradient_x) g = stored_direction(g, options.bits);
    for (float& g : map.gradient_y) g = stored_direction(g, options.bits);
    const double per_code = options.scale_f * largest;
    for (float& d : distance) d = stored_distance(d / per_code, map.info);
    map.distance = std::move(distance);
    map.shape = Image<float>(grid.width, grid.height);
    for (std::size_t k = 0; k < map.shape.size(); ++k) map.shape[k] = shape.outside()[k];
    return map;
}

} // namespace reliefbake
