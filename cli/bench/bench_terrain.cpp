// A tiled TIFF without compression (TIFF 6.0, sections 2 and 15), written row of tiles by row of tiles: the file that a tool for
// terrain would hand over.

#include "cli/bench/bench_terrain.h"

#include "bake/parallel.h"
#include "cli/bench/terrain.h"
#include "cli/options/thread_option.h"
#include "cli/output_checks.h"
#include "formats/atomic_file.h"
#include "formats/image_gate.h"
#include "formats/scratch_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <span>
#include <system_error>
#include <vector>

namespace reliefbake {

namespace {

constexpr int tile = 256;
constexpr std::uint32_t tile_bytes = tile * tile * 2, header_bytes = 8;

struct Entry {
    std::uint16_t tag, type;
    std::uint32_t count, value;
};
constexpr std::uint16_t short_type = 3, long_type = 4;

std::vector<std::uint32_t> tile_offsets(std::uint32_t tiles) {
    std::vector<std::uint32_t> offsets(tiles);
    for (std::uint32_t k = 0; k < tiles; ++k) offsets[k] = header_bytes + k * tile_bytes;
    return offsets;
}

class TiffTiles {
  public:
    TiffTiles(int width, int height)
        : width_(width), height_(height), across_((width + tile - 1) / tile), down_((height + tile - 1) / tile) {}

    std::uint32_t tiles() const { return std::uint32_t(across_) * std::uint32_t(down_); }
    std::uint64_t row_bytes() const { return std::uint64_t(across_) * tile_bytes; }
    std::uint64_t row_at(int k) const { return header_bytes + std::uint64_t(k) * row_bytes(); }
    int rows() const { return down_; }

    /// Texels beyond the map repeat its last ones.
    std::vector<std::uint16_t> row_of_tiles(int k, const Terrain& terrain, int threads) const {
        std::vector<std::uint16_t> samples(row_bytes() / 2);
        parallel_for(tile, threads, [&](int j) {
            std::vector<std::uint16_t> row(std::size_t(across_) * tile);
            terrain.row(std::min(k * tile + j, height_ - 1), row.data());
            std::fill(row.begin() + width_, row.end(), row[std::size_t(width_) - 1]);
            for (int i = 0; i < across_; ++i) std::memcpy(samples.data() + std::size_t(i) * tile * tile + std::size_t(j) * tile, row.data() + std::size_t(i) * tile, tile * 2);
        });
        return samples;
    }

    /// Everything but the pixels, little-endian as this machine is: at the file's begin, and at `row_at(rows())`.
    std::vector<std::byte> header() const {
        const std::uint32_t directory = std::uint32_t(row_at(down_));
        const std::uint32_t words[] = {0x002a4949u, directory};
        const auto bytes = std::as_bytes(std::span(words));
        return {bytes.begin(), bytes.end()};
    }
    std::vector<std::byte> directory() const {
        const std::uint32_t lists = std::uint32_t(row_at(down_)) + 2 + entries * 12 + 4, list_bytes = tiles() * 4;
        const auto list = [&](std::uint32_t at, std::uint32_t one) { return tiles() == 1 ? one : at; };
        const Entry all[entries] = {{256, long_type, 1, std::uint32_t(width_)}, {257, long_type, 1, std::uint32_t(height_)},
                                    {258, short_type, 1, 16},                   {259, short_type, 1, 1},
                                    {262, short_type, 1, 1},                    {277, short_type, 1, 1},
                                    {322, long_type, 1, tile},                  {323, long_type, 1, tile},
                                    {324, long_type, tiles(), list(lists, header_bytes)}, {325, long_type, tiles(), list(lists + list_bytes, tile_bytes)}};
        std::vector<std::byte> out;
        const auto add = [&](const void* data, std::size_t size) { out.insert(out.end(), static_cast<const std::byte*>(data), static_cast<const std::byte*>(data) + size); };
        const std::uint16_t count = entries;
        const std::uint32_t none = 0;
        add(&count, 2);
        for (const Entry& e : all) add(&e.tag, 2), add(&e.type, 2), add(&e.count, 4), add(&e.value, 4);
        add(&none, 4);
        const std::vector<std::uint32_t> offsets = tile_offsets(tiles()), sizes(tiles(), tile_bytes);
        add(offsets.data(), list_bytes), add(sizes.data(), list_bytes);
        return out;
    }

  private:
    static constexpr int entries = 10;
    int width_, height_, across_, down_;
};

} // namespace

void BenchTerrainCommand::add_to(CLI::App& app) {
    app.add_option("-o,--output", output_, "Tiled 16-bit TIFF to write: .tif")->required()->type_name("OUT");
    const CLI::Range sides(1, int(max_side));
    app.add_option("--width", width_, "Texels (default 4096)")->check(sides);
    app.add_option("--height", height_, "Texels (default 4096)")->check(sides);
    app.add_option("--seed", seed_, "Another number, another terrain (default 1)");
    add_thread_option(app, threads_);
}

Result<void> BenchTerrainCommand::run() {
    const Result<int> threads = resolve_threads(threads_);
    if (!threads) return tl::unexpected(threads.error());
    if (extension_of(output_) != ".tif") return fail(ErrorCode::usage, output_ + ": expected a .tif output");
    const TiffTiles tiff(width_, height_);
    if (tiff.row_at(tiff.rows()) > 0xf0000000u) return fail(ErrorCode::usage, output_ + ": a TIFF holds 4 GiB; take fewer texels");

    const Terrain terrain(width_, seed_);
    FileBatch batch;
    const Result<int> file = batch.open(output_);
    if (!file) return tl::unexpected(file.error());
    bool written = write_at(*file, 0, tiff.header()) && write_at(*file, tiff.row_at(tiff.rows()), tiff.directory());
    for (int k = 0; written && k < tiff.rows(); ++k) written = write_at(*file, tiff.row_at(k), std::as_bytes(std::span<const std::uint16_t>(tiff.row_of_tiles(k, terrain, *threads))));
    if (!written) return fail(ErrorCode::write_failed, output_ + ": writing stopped half-way, nothing was left behind: " + std::generic_category().message(errno));
    return batch.publish();
}

} // namespace reliefbake
