#include "cli/cone/large/bake_bands.h"

#include "bake/cone_bands.h"
#include "bake/normal_map.h"
#include "cli/cone/assemble_map.h"
#include "cli/cone/cone_info.h"
#include "cli/report/format_text.h"
#include "formats/join_bands.h"
#include "formats/map_json.h"
#include "formats/map_layout.h"
#include "formats/map_pixels.h"
#include "formats/mapped_storage.h"
#include "formats/scratch_file.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

/// Bakes bands and writes their pixels.
class BandsRun {
  public:
    BandsRun(const ConePlan& plan, const ReliefMapInfo& info, ConeBands& bands) : plan_(plan), info_(info), bands_(bands) {
        const LayoutImage image = written_image(layout_images(info).front());
        facts_.map = to_json(info, bands.grid());
        facts_.width = bands.grid().width, facts_.height = bands.grid().height;
        facts_.bits = plan.bits, facts_.channels = image.channels;
        facts_.ratio_min = std::numeric_limits<float>::infinity();
    }

    Result<BandFacts> write(int first, int end, int step, BandWriter& writer, StageClock& clock) {
        facts_.first = first, facts_.end = end;
        for (int y = first; y < end; y += step) {
            clock.tell(format("cone %.0f %%", 100.0 * (y - first) / (end - first)));
            if (Result<void> written = write_band(y, std::min(y + step, end), writer); !written) return tl::unexpected(written.error());
        }
        return facts_;
    }

  private:
    Result<void> write_band(int first, int end, BandWriter& writer) {
        const Image<float> ratio = bands_.bake(first, end);
        for (int y = 0; y < ratio.height(); ++y) facts_.ratio_sums.push_back(sum_of_row(ratio, y));
        facts_.ratio_min = std::min(facts_.ratio_min, *std::min_element(ratio.begin(), ratio.end()));

        // Among the rows beside it, so that slopes and cells see what they see on the whole map.
        ConeBands::Depth band = bands_.depth(first, end);
        const int rows = end - first, width = band.map.grid.width;
        EncodedConeMap codes = [&] {
            ConeMap framed{band.map.grid, plan_.cone, Image<float>(width, band.map.grid.height)};
            std::copy(ratio.begin(), ratio.end(), framed.ratio.row(band.above));
            return encode_cone_rows(framed, band.map, {plan_.given.encoding, plan_.bits}, band.above, band.above + rows);
        }();
        facts_.zero_codes += codes.zero_codes;
        NormalMap normals;
        if (info_.held.normals) normals = bake_normals(band.map, plan_.depth_scale, plan_.cone.threads);
        std::vector<EncodedConeMap> planes;
        planes.push_back(std::move(codes));
        const ReliefMap map = assemble_map(info_, std::move(band.map), std::move(planes), std::move(normals));

        const LayoutImage image = written_image(layout_images(info_).front());
        std::vector<std::byte> pixels(interleaved_bytes(map, image, plan_.bits));
        interleave(map, image, plan_.bits, pixels.data());
        const std::size_t row_bytes = facts_.row_bytes();
        return writer.rows(std::span(pixels).subspan(std::size_t(band.above) * row_bytes, std::size_t(rows) * row_bytes));
    }

    const ConePlan& plan_;
    const ReliefMapInfo& info_;
    ConeBands& bands_;
    BandFacts facts_;
};

/// The stored surface, all of it in `storage`, and the source's facts.
struct LargeSurface {
    BakeSource source;
    DepthMap depth;
};

Result<LargeSurface> read_surface(const ConePlan& plan, MappedStorage& storage, StageClock& clock) {
    Result<BakeSource> source = read_source_into(storage, plan.given, clock);
    if (!source) return tl::unexpected(source.error());
    DepthMap depth = clock.time("quantise", [&] { return quantise_depth(std::move(*source->field), plan.bits); });
    source->field.reset();
    return LargeSurface{std::move(*source), std::move(depth)};
}

std::vector<std::string> warnings_of(const ConePlan& plan, const SourceImage& source, const BandFacts& facts) {
    std::vector<std::string> warnings;
    if (source.srgb_tagged) warnings.push_back(plan.given.input + ": tagged sRGB, which heights are not; its codes are taken as they stand");
    if (facts.zero_codes > 0)
        warnings.push_back(plan.given.output + ": " + std::to_string(facts.zero_codes) + " texels have cone code 0, where a ray goes on cell by cell; more --bits lose fewer");
    return warnings;
}

/// What the whole map's metadata says of its cones, for the report.
void take_statistics(const nlohmann::json& map, ReliefMapInfo& info) {
    for (const char* name : {"ratio_min", "ratio_mean", "zero_codes"}) {
        const nlohmann::json& value = map.at("statistics").at(name);
        info.statistics[name] = value.is_number() ? value.get<double>() : std::numeric_limits<double>::infinity();
    }
}

} // namespace

Result<BakedBands> bake_bands(const ConePlan& plan, const MemoryPlan& memory) {
    StageClock clock(!plan.given.quiet);
    const fs::path output = plan.given.output, folder = output.parent_path();
    Result<std::unique_ptr<MappedStorage>> storage = MappedStorage::create(folder, memory.scratch, memory.resident);
    if (!storage) return tl::unexpected(storage.error());
    Result<LargeSurface> surface = read_surface(plan, **storage, clock);
    if (!surface) return tl::unexpected(surface.error());
    const TexelGrid grid = surface->depth.grid;
    ReliefMapInfo info = clock.time("describe", [&] { return describe_surface(plan, surface->source.image.pixel_hash, surface->depth, plan.cone); });

    // Where the rows go: the band's file, or a nameless one until the metadata before them in the map's file is known.
    FileBatch batch;
    UniqueFd scratch;
    if (!plan.given.large.rows) {
        Result<UniqueFd> opened = open_scratch(folder);
        if (!opened) return tl::unexpected(opened.error());
        scratch = std::move(*opened);
    }
    const Result<int> file = scratch ? Result<int>(scratch.get()) : batch.open(output);
    if (!file) return tl::unexpected(file.error());
    BandWriter writer(*file, output.string());

    const auto [first, end] = plan.given.large.rows.value_or(std::pair(0, grid.height));
    const Result<BandFacts> facts = clock.time("cone", [&] {
        ConeBands bands(std::move(surface->depth), plan.cone, memory.pyramid_in_memory ? nullptr : storage->get());
        Result<BandFacts> written = BandsRun(plan, info, bands).write(first, end, memory.band_rows, writer, clock);
        clock.add("cone_near", bands.statistics().seconds_near);
        clock.add("cone_pyramid", bands.statistics().seconds_pyramid);
        clock.add("cone_search", bands.statistics().seconds_search);
        return written;
    });
    if (!facts) return tl::unexpected(facts.error());
    storage->reset(); // its pages leave before the helper takes some

    const Result<void> written = clock.time("write", [&]() -> Result<void> {
        if (plan.given.large.rows) return writer.finish(*facts).and_then([&] { return batch.publish(); });
        std::vector<BandReader> bands;
        bands.emplace_back(scratch.get(), *facts, output.string());
        const Result<nlohmann::json> map = write_joined_map(output, bands, batch, plan.cone.threads);
        if (!map) return tl::unexpected(map.error());
        take_statistics(*map, info);
        return batch.publish();
    });
    if (!written) return tl::unexpected(written.error());
    clock.stop();
    BakedMap map{plan, info, grid, warnings_of(plan, surface->source.image, *facts), clock.seconds(), {}};
    const std::uint64_t rows_on_disk = plan.given.large.rows ? 0 : facts->row_bytes() * std::uint64_t(grid.height);
    BakedBands result{{}, {first, end, memory.band_rows, plan.given.large.ceiling(), memory.scratch + rows_on_disk, memory.pyramid_in_memory}};
    result.baked.source = std::move(surface->source);
    result.baked.maps.push_back(std::move(map));
    return result;
}

} // namespace reliefbake
