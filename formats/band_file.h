#pragma once
// Rows of a map between their bake and the map's file: in a file of their own, or one behind another in working space.
// docs/LARGE.md says what lies in a band file.

#include "bake/error.h"
#include "bake/bit_depth.h"
#include "formats/unique_fd.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace reliefbake {

/// What the rows belong to, and what the whole map wants to know of them.
struct BandFacts {
    nlohmann::json map;                ///< the map's metadata (map_json.h), without the statistics of cones
    int width = 0, height = 0;         ///< of the whole map
    int first = 0, end = 0;            ///< rows [first, end)
    BitDepth bits = BitDepth::unorm16; ///< of the samples
    std::vector<std::string> channels; ///< names in the map's file
    std::vector<double> ratio_sums;    ///< of each row's ratios, from left to right
    float ratio_min = 0;
    std::uint64_t zero_codes = 0;

    std::uint64_t row_bytes() const;
};

/// Writes rows, then facts.
class BandWriter {
  public:
    /// `name` is the file, for messages.
    BandWriter(int fd, std::string name);
    ~BandWriter();
    BandWriter(const BandWriter&) = delete;
    BandWriter& operator=(const BandWriter&) = delete;
    /// The next rows, as stored: interleaved, in this machine's byte order. Errors: write_failed.
    Result<void> rows(std::span<const std::byte> bytes);
    /// Makes the file a band file. Errors: write_failed.
    Result<void> finish(const BandFacts& facts);

    struct Sum;

  private:
    int fd_;
    std::string name_;
    std::uint64_t at_ = 0;
    std::unique_ptr<Sum> sum_; ///< of what was written
};

/// A band file, checked: its facts fit each other and its size. Its rows are only known to be whole once check_sum has read them.
class BandReader {
  public:
    /// Errors: no_input; bad_data (no band file, cut off, of another version).
    static Result<BandReader> open(const std::filesystem::path& path);
    /// Rows that lie in a file from its start on, written by this process.
    BandReader(int fd, BandFacts facts, std::string name) : borrowed_(fd), facts_(std::move(facts)), name_(std::move(name)) {}

    const BandFacts& facts() const { return facts_; }
    const std::string& name() const { return name_; }
    /// Rows [y, y + n) of the map, all of them of this band, into `out`. Errors: bad_data.
    Result<void> read(int y, int n, std::span<std::byte> out) const;
    /// Reads the whole file once. Errors: bad_data (not what was written).
    Result<void> check_sum() const;

  private:
    int fd() const { return file_ ? file_.get() : borrowed_; }

    UniqueFd file_;
    int borrowed_ = -1;
    BandFacts facts_;
    std::string name_;
};

} // namespace reliefbake
