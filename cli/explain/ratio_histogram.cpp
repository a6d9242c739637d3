#include "cli/explain/ratio_histogram.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace reliefbake {

namespace {

constexpr double widest_counted = 1e6;

class Histogram {
  public:
    explicit Histogram(int bins) : counts_(std::size_t(bins)) {}

    void add(double ratio) {
        sum_ += std::min(ratio, widest_counted);
        ++total_;
        if (ratio > 1)
            ++wider_;
        else
            ++counts_[std::min(std::size_t(ratio * double(counts_.size())), counts_.size() - 1)];
    }

    nlohmann::ordered_json to_json() const {
        return {{"counts", counts_}, {"wider", wider_}, {"mean", sum_ / double(total_)}};
    }

  private:
    std::vector<std::uint64_t> counts_;
    std::uint64_t wider_ = 0, total_ = 0;
    double sum_ = 0;
};

} // namespace

Result<nlohmann::ordered_json> ratio_histogram(const std::string& file, const ReliefMap& map, int bins) {
    const ReliefMapInfo& info = map.info;
    const bool several = !map.cone_planes.empty();
    if (!several && map.cone.empty())
        return fail(ErrorCode::usage, file + ": it holds no cones to count; leave out --histogram");
    const bool needs_depth = info.encoding == ConeEncoding::radius;
    if (needs_depth && map.depth.empty())
        return fail(ErrorCode::usage, file + ": its cones are radii, which are ratios to a depth that it does not hold; name the map that does with --relief");
    Histogram each(bins), mean(bins), widest(bins);
    const std::size_t texels = several ? map.cone_planes[0].size() : map.cone.size();
    for (std::size_t i = 0; i < texels; ++i) {
        const double depth = needs_depth ? double(map.depth[i]) : 0;
        const auto ratio = [&](const Image<float>& plane) { return decode_ratio(double(plane[i]), depth, info.encoding, double(info.cone_max)); };
        if (!several) {
            each.add(ratio(map.cone));
            continue;
        }
        double sum = 0, most = 0;
        for (const Image<float>& plane : map.cone_planes) {
            const double r = ratio(plane);
            each.add(r);
            sum += std::min(r, widest_counted);
            most = std::max(most, r);
        }
        mean.add(sum / double(map.cone_planes.size()));
        widest.add(most);
    }
    nlohmann::ordered_json json = {{"bins", bins}, {"each", each.to_json()}};
    if (several) {
        json["mean"] = mean.to_json();
        json["widest"] = widest.to_json();
    }
    return json;
}

} // namespace reliefbake
