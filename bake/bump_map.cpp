#include "bake/bump_map.h"

#include "bake/stored_code.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace reliefbake {

namespace {

constexpr double float_rounding = 0x1p-24; ///< relative, of the float that a value is baked as

Image<float> sampled_depth(const DepthMap& depth) {
    Image<float> plane = depth.level;
    for (float& level : plane) level /= float(max_code(depth.bits));
    return plane;
}

/// `scale`: what the value 1 of a signed code stands for.
Image<float> encode_signed(const Image<float>& values, double scale, const BumpMapInfo& info) {
    Image<float> plane(values.width(), values.height());
    for (std::size_t k = 0; k < values.size(); ++k) plane[k] = stored_signed(values[k] / scale, info.bits, info.codes);
    return plane;
}

double mean(const Image<float>& plane) { return std::accumulate(plane.begin(), plane.end(), 0.0) / double(plane.size()); }

double largest(const Image<float>& plane) {
    double most = 0;
    for (const float value : plane) most = std::max(most, std::fabs(double(value)));
    return most;
}

} // namespace

float decode_bump(float value, const BumpMapInfo& info) {
    switch (info.kind) {
    case BumpKind::derivative: return decode_signed(value, info.bits, info.codes) * float(info.derivative_scale);
    case BumpKind::normal: return decode_signed(value, info.bits, info.codes);
    case BumpKind::horizon: return value;
    }
    return value;
}

double largest_derivative(const DerivativeMap& map) { return std::max(largest(map.du), largest(map.dv)); }

BumpMap encode_derivatives(BumpMapInfo info, const DepthMap& depth, const DerivativeMap& derivatives) {
    const double most = largest_derivative(derivatives);
    if (!is_unorm(info.bits)) info.derivative_scale = 1;
    assert(!is_unorm(info.bits) || most <= info.derivative_scale);
    info.error = signed_error(info.bits, info.codes, is_unorm(info.bits) ? 1 : most) * info.derivative_scale + most * 2 * float_rounding;
    info.statistics = {{"derivative_max", most}};
    return {info, depth.grid,
            {encode_signed(derivatives.du, info.derivative_scale, info), encode_signed(derivatives.dv, info.derivative_scale, info)},
            sampled_depth(depth)};
}

BumpMap encode_normals(BumpMapInfo info, const DepthMap& depth, const NormalMap& normals) {
    Image<float> y = normals.y, z(depth.grid.width, depth.grid.height);
    if (info.normal_y == NormalY::dx)
        for (float& n : y) n = 0 - n;
    for (std::size_t k = 0; k < z.size(); ++k)
        z[k] = float(std::sqrt(1 - double(normals.x[k]) * normals.x[k] - double(normals.y[k]) * normals.y[k]));
    // z^2 = 1 - x^2 - y^2 from rounded x and y: on the steepest cliffs z^2 is as small as their rounding.
    const double least_z = *std::min_element(z.begin(), z.end());
    info.error = signed_error(info.bits, info.codes) + float_rounding * (1 + 2 / least_z);
    info.statistics = {{"normal_z_min", least_z}};
    return {info, depth.grid, {encode_signed(normals.x, 1, info), encode_signed(y, 1, info), encode_signed(z, 1, info)}, sampled_depth(depth)};
}

BumpMap encode_horizons(BumpMapInfo info, const DepthMap& depth, const HorizonMap& horizons) {
    assert(info.depth_scale == horizons.depth_scale);
    BumpMap map{info, depth.grid, {}, holds_depth(info) ? sampled_depth(depth) : Image<float>()};
    double most = 0, sum = 0;
    for (const Image<float>& sine : horizons.sine) {
        most = std::max(most, largest(sine)), sum += mean(sine) / horizon_azimuths;
        Image<float> plane(sine.width(), sine.height());
        for (std::size_t k = 0; k < sine.size(); ++k) plane[k] = stored_value(nearest_code(sine[k], info.bits), info.bits);
        map.planes.push_back(std::move(plane));
    }
    map.info.error = horizon_error(info.bits);
    map.info.statistics = {{"sine_max", most}, {"sine_mean", sum}};
    return map;
}

} // namespace reliefbake
