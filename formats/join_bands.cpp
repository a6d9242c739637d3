#include "formats/join_bands.h"

#include "formats/encode_rows.h"
#include "formats/map_file.h"
#include "formats/map_format.h"
#include "formats/shortest_decimal.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int block_rows = 64; ///< whole strips and blocks of either format

std::string rows_text(int first, int end) { return std::to_string(first) + ":" + std::to_string(end); }

/// The words that differ first between two maps' metadata, for a person.
std::string difference(const json& a, const json& b) {
    const json changes = json::diff(a, b);
    return changes.empty() ? "size" : changes[0].at("path").get<std::string>().substr(1);
}

Result<void> check_same_map(const BandReader& a, const BandReader& b) {
    const BandFacts& x = a.facts();
    const BandFacts& y = b.facts();
    if (x.map == y.map && x.width == y.width && x.height == y.height && x.bits == y.bits && x.channels == y.channels) return {};
    return fail(ErrorCode::bad_data, b.name() + ": is of another map than " + a.name() + ": they differ in " + difference(x.map, y.map) +
                                         "; bake all bands from the same file with the same options and version");
}

json statistic(double value) { return std::isinf(value) ? json("inf") : json(value); }

/// Metadata of the whole map. Sums are added row by row, as they are for a map baked at once.
json joined_metadata(std::span<const BandReader> bands) {
    const BandFacts& any = bands.front().facts();
    double sum = 0, zero_codes = 0;
    float least = any.ratio_min;
    for (const BandReader& band : bands) {
        for (const double row : band.facts().ratio_sums) sum += row;
        zero_codes += double(band.facts().zero_codes);
        least = std::min(least, band.facts().ratio_min);
    }
    json map = any.map;
    json& statistics = map["statistics"];
    statistics["ratio_min"] = statistic(shortest_decimal(least));
    statistics["ratio_mean"] = statistic(sum / (double(any.width) * any.height));
    statistics["zero_codes"] = zero_codes;
    return map;
}

/// Rows [y, y + n) of the map out of the bands that have them.
Result<void> gather(std::span<const BandReader> bands, int y, int n, std::span<std::byte> out) {
    for (const BandReader& band : bands) {
        const int from = std::max(y, band.facts().first), to = std::min(y + n, band.facts().end);
        if (from >= to) continue;
        const std::uint64_t row = band.facts().row_bytes();
        if (Result<void> read = band.read(from, to - from, out.subspan(std::size_t(std::uint64_t(from - y) * row))); !read) return read;
    }
    return {};
}

} // namespace

Result<void> check_streamed_format(const fs::path& path, std::uint64_t pixel_bytes) {
    const Result<MapFormat> format = map_format_of(path);
    if (!format) return tl::unexpected(format.error());
    if (*format != MapFormat::tiff && *format != MapFormat::openexr)
        return fail(ErrorCode::usage, path.string() + ": only .exr and .tif files are written row by row, out of core");
    constexpr std::uint64_t mib = 1u << 20, most = 4000 * mib;
    if (*format == MapFormat::tiff && pixel_bytes > most)
        return fail(ErrorCode::usage, path.string() + ": a TIFF holds 4 GiB, and these pixels are " + std::to_string((pixel_bytes + mib - 1) / mib) +
                                          " MiB before they are compressed; write an .exr, or fewer --channels or --bits");
    return {};
}

Result<void> order_bands(std::vector<BandReader>& bands) {
    std::sort(bands.begin(), bands.end(), [](const BandReader& a, const BandReader& b) { return a.facts().first < b.facts().first; });
    int next = 0;
    for (const BandReader& band : bands) {
        if (Result<void> same = check_same_map(bands.front(), band); !same) return same;
        const int first = band.facts().first;
        if (first < next) return fail(ErrorCode::bad_data, band.name() + ": rows " + rows_text(first, std::min(next, band.facts().end)) + " are in another band too");
        if (first > next) return fail(ErrorCode::bad_data, band.name() + ": rows " + rows_text(next, first) + " before it are in no band; bake them with --rows " + rows_text(next, first));
        next = band.facts().end;
    }
    const int height = bands.front().facts().height;
    if (next == height) return {};
    return fail(ErrorCode::bad_data, bands.back().name() + ": rows " + rows_text(next, height) + " behind it are in no band; bake them with --rows " + rows_text(next, height));
}

Result<json> write_joined_map(const fs::path& path, std::span<const BandReader> bands, FileBatch& batch, int threads) {
    const BandFacts& facts = bands.front().facts();
    const std::uint64_t row_bytes = facts.row_bytes();
    if (Result<void> fits = check_map_format(path, facts.bits, ChannelLayout::rgba); !fits) return tl::unexpected(fits.error());
    if (Result<void> fits = check_streamed_format(path, row_bytes * std::uint64_t(facts.height)); !fits) return tl::unexpected(fits.error());

    json map = joined_metadata(bands);
    EncodeRequest request;
    request.writer = writer_name(*map_format_of(path));
    request.width = facts.width, request.height = facts.height;
    request.channels = facts.channels;
    request.sample = request.pixels = sample_name(facts.bits);
    request.threads = threads;
    request.attributes = map_attributes(*map_format_of(path), map);

    const Result<int> file = batch.open(path);
    if (!file) return tl::unexpected(file.error());
    Result<RowsEncoder> encoder = RowsEncoder::start(request, std::min(block_rows, facts.height), *file, path.string());
    if (!encoder) return tl::unexpected(encoder.error());
    for (int y = 0; y < facts.height; y += block_rows) {
        const int rows = std::min(block_rows, facts.height - y);
        if (Result<void> read = gather(bands, y, rows, encoder->block()); !read) return tl::unexpected(read.error());
        if (Result<void> taken = encoder->take(rows); !taken) return tl::unexpected(taken.error());
    }
    return map;
}

} // namespace reliefbake
