#include "cli/scene/survey.h"

#include "bake/binary_shape.h"
#include "bake/mips.h"
#include "cli/report/format_text.h"
#include "cli/scene/bake_job.h"
#include "cli/scene/choose.h"
#include "cli/scene/measure_asset.h"
#include "cli/scene/scene_maps.h"
#include "formats/mesh_file.h"
#include "formats/read_image.h"
#include "mesh/quadric_bake.h"
#include "shaders-reference/oracle/bilinear_surface.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace reliefbake {
namespace {

/// Chains of the stored surface, one bit depth after the other, and how far each level is off.
class ErrorMeter {
  public:
    explicit ErrorMeter(const HeightField& field) : field_(field) {}

    double error(BitDepth bits, int level) {
        const auto known = errors_.find({bits, level});
        if (known != errors_.end()) return known->second;
        if (level > 0 && bits_ != bits) chain_ = bake_depth_mips(quantise_depth(field_, bits)), bits_ = bits;
        return errors_[{bits, level}] = level == 0 ? stored_error(quantise_depth(field_, bits)) : surface_error(chain_[std::size_t(level)]);
    }

  private:
    double stored_error(const DepthMap& depth) const {
        double worst = 0;
        const Image<float>& heights = field_.heights();
        for (std::size_t k = 0; k < heights.size(); ++k)
            worst = std::max(worst, std::fabs(1 - double(heights[k]) - double(depth.level[k]) / max_code(depth.bits)));
        return worst;
    }

    double surface_error(const DepthMap& level) const {
        const BilinearSurface surface(level);
        double worst = 0;
        const Image<float>& heights = field_.heights();
        for (int y = 0; y < heights.height(); ++y)
            for (int x = 0; x < heights.width(); ++x) {
                const double found = surface.height(TexelGrid::centre(x, heights.width()), TexelGrid::centre(y, heights.height()));
                worst = std::max(worst, std::fabs(double(heights.row(y)[x]) - found));
            }
        return worst;
    }

    const HeightField& field_;
    BitDepth bits_ = BitDepth::half; // none that is chosen from
    std::vector<DepthMap> chain_;
    std::map<std::pair<BitDepth, int>, double> errors_;
};

const char* storage_word(BitDepth bits) { return bits == BitDepth::unorm8 ? "8 bits" : bits == BitDepth::unorm16 ? "16 bits" : "floats"; }

/// What was given up, and what that costs.
std::string note_of(const SceneAsset& asset, const AssetFacts& facts) {
    std::string note = storage_word(facts.bits);
    if (facts.level > 0) note += format(" at 1/%d of the resolution", 1 << facts.level);
    note += format(" suffice: heights off by at most %.3g", facts.stored_error);
    if (facts.bits == BitDepth::unorm8) note += "; loss below 16 bits: normals are off by up to 1/255 and cones are narrower";
    const double wanted = asset.screen ? *asset.screen : asset.texel_density ? *asset.texel_density * *asset.size : 0;
    if (wanted > facts.width) note += format("; seen at %.6g texels, of which the source has %d", wanted, facts.width);
    return note;
}

Result<AssetFacts> choose(const SceneAsset& asset, const Scene& scene, const BakeSource& source, ErrorMeter& meter, int threads) {
    const std::string place = scene.file + ": asset '" + asset.name + "'";
    const HeightField& field = *source.field;
    const HeightFacts heights{field.grid().width, field.grid().height, [&](BitDepth bits, int level) { return meter.error(bits, level); }};
    AssetFacts facts;
    facts.width = heights.width, facts.height = heights.height;
    facts.sectors = asset.sectors.value_or(facts.sectors);
    if (needs_nothing(asset)) return facts;
    const Result<BitsChoice> bits = choose_bits(asset, heights, scene.extension, place);
    if (!bits) return tl::unexpected(bits.error());
    facts.bits = bits->bits;
    facts.level = choose_level(asset, heights, facts.bits);
    std::string measured;
    if (asset.max_wrong) {
        const Result<MeasuredChoice> choice = measure_choices(asset, facts, source, threads, place);
        if (!choice) return tl::unexpected(choice.error());
        facts.level = choice->level, facts.sectors = choice->sectors;
        measured = format("; %.3g of the rays wrong in %d steps at %.6g degrees, measured", choice->wrong, *asset.steps, *asset.angle);
    }
    facts.stored_error = meter.error(facts.bits, facts.level);
    facts.note = note_of(asset, facts) + measured;
    return facts;
}

Result<void> survey_height(const Scene& scene, const std::vector<std::size_t>& assets, int threads, std::vector<AssetFacts>& facts) {
    const Result<BakeSource> source = read_job_source({scene.assets[assets.front()].height, source_options(scene.assets[assets.front()]), {}});
    if (!source) return tl::unexpected(source.error());
    ErrorMeter meter(*source->field);
    for (const std::size_t k : assets) {
        Result<AssetFacts> chosen = choose(scene.assets[k], scene, *source, meter, threads);
        if (!chosen) return tl::unexpected(chosen.error());
        facts[k] = std::move(*chosen);
    }
    return {};
}

Result<void> survey_shape(const SceneAsset& asset, AssetFacts& facts) {
    ReadOptions options;
    options.channel = asset.channel, options.prefer_alpha = true;
    Result<SourceImage> image = read_image(asset.shape, options);
    if (!image) return tl::unexpected(image.error());
    facts.width = image->plane.width(), facts.height = image->plane.height();
    ShapeOptions shape;
    if (asset.antialiased) shape.model = ShapeModel::contour;
    return make_shape(std::move(image->plane), shape, asset.shape).map([](const auto&) {});
}

/// Positions, normals, tangents, texture coordinates and quadrics as floats, indices of 32 bits.
Result<void> survey_mesh(const SceneAsset& asset, int threads, AssetFacts& facts) {
    constexpr std::uint64_t vertex = 4 * (3 + 3 + 4 + 3), texture = 4 * 2, triangle = 4 * 3;
    const Result<MeshFile> file = read_mesh(asset.mesh);
    if (!file) return tl::unexpected(file.error());
    QuadricOptions options;
    options.threads = threads;
    for (const Mesh& mesh : file->meshes) {
        const Result<QuadricBake> bake = bake_quadrics(mesh, options, asset.mesh);
        if (!bake) return tl::unexpected(bake.error());
        facts.mesh_vertices += bake->mesh.positions.size();
        facts.mesh_bytes += bake->mesh.positions.size() * (vertex + (bake->mesh.uvs.empty() ? 0 : texture)) + bake->mesh.triangles.size() * triangle;
    }
    return {};
}

} // namespace

Result<std::vector<AssetFacts>> survey_scene(const Scene& scene, int threads) {
    std::vector<AssetFacts> facts(scene.assets.size());
    std::map<std::vector<std::string>, std::vector<std::size_t>> heights; // by how they are read
    std::vector<std::vector<std::string>> order;
    for (std::size_t k = 0; k < scene.assets.size(); ++k) {
        const SceneAsset& asset = scene.assets[k];
        if (asset.height.empty()) continue;
        std::vector<std::string> key = source_options(asset);
        key.push_back(asset.height);
        if (heights[key].empty()) order.push_back(key);
        heights[key].push_back(k);
    }
    for (const std::vector<std::string>& key : order)
        if (Result<void> seen = survey_height(scene, heights[key], threads, facts); !seen) return tl::unexpected(seen.error());
    for (std::size_t k = 0; k < scene.assets.size(); ++k) {
        const SceneAsset& asset = scene.assets[k];
        if (!asset.shape.empty())
            if (Result<void> seen = survey_shape(asset, facts[k]); !seen) return tl::unexpected(seen.error());
        if (asset.mesh.empty()) continue;
        const auto known = std::find_if(scene.assets.begin(), scene.assets.begin() + std::ptrdiff_t(k), [&](const SceneAsset& other) { return other.mesh == asset.mesh; });
        if (known != scene.assets.begin() + std::ptrdiff_t(k)) {
            const AssetFacts& same = facts[std::size_t(known - scene.assets.begin())];
            facts[k].mesh_bytes = same.mesh_bytes, facts[k].mesh_vertices = same.mesh_vertices;
        } else if (Result<void> seen = survey_mesh(asset, threads, facts[k]); !seen) {
            return tl::unexpected(seen.error());
        }
    }
    return facts;
}

} // namespace reliefbake
