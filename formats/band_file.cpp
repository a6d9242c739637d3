// rows | ratio_sums (doubles) | facts (JSON) | footer
// The footer: the length of the JSON text (8 bytes), XXH3-128 of all before the footer (16), "reliefbake band1" (16).

#include "formats/band_file.h"

#include "formats/image_gate.h"
#include "formats/map_format.h"
#include "formats/map_pixels.h"
#include "formats/scratch_file.h"

#include <xxhash.h>

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <system_error>

namespace reliefbake {

/// XXH3-128 of bytes as they come.
struct BandWriter::Sum {
    std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state{XXH3_createState(), XXH3_freeState};

    Sum() { XXH3_128bits_reset(state.get()); }
    void add(std::span<const std::byte> bytes) { XXH3_128bits_update(state.get(), bytes.data(), bytes.size()); }
    XXH128_canonical_t value() const {
        XXH128_canonical_t canonical;
        XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state.get()));
        return canonical;
    }
};

namespace {

using nlohmann::json;

constexpr std::string_view mark = "reliefbake band1";
struct Footer {
    std::uint64_t text_bytes;
    unsigned char sum[16];
    char mark[16];
};
static_assert(sizeof(Footer) == 40);
constexpr std::uint64_t longest_text = 1u << 20;
constexpr std::size_t block_bytes = 4u << 20;

constexpr BitDepth all_bits[] = {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32};

json to_json(const BandFacts& facts) {
    return {{"map", facts.map},           {"width", facts.width},       {"height", facts.height},
            {"first", facts.first},       {"end", facts.end},           {"sample", sample_name(facts.bits)},
            {"channels", facts.channels}, {"ratio_min", std::bit_cast<std::uint32_t>(facts.ratio_min)},
            {"zero_codes", facts.zero_codes}};
}

/// Throws json::exception for what is missing or of another type; empty for what makes no sense.
std::optional<BandFacts> facts_from(const json& text) {
    BandFacts facts;
    facts.map = text.at("map");
    facts.width = text.at("width").get<int>(), facts.height = text.at("height").get<int>();
    facts.first = text.at("first").get<int>(), facts.end = text.at("end").get<int>();
    facts.channels = text.at("channels").get<std::vector<std::string>>();
    facts.ratio_min = std::bit_cast<float>(text.at("ratio_min").get<std::uint32_t>());
    facts.zero_codes = text.at("zero_codes").get<std::uint64_t>();
    const auto sample = text.at("sample").get<std::string>();
    bool known = false;
    for (const BitDepth bits : all_bits)
        if (sample == sample_name(bits)) facts.bits = bits, known = true;
    const auto side = [](int n) { return n >= 1 && n <= max_side; };
    const bool sensible = known && facts.map.is_object() && side(facts.width) && side(facts.height) && 0 <= facts.first && facts.first < facts.end &&
                          facts.end <= facts.height && !facts.channels.empty() && facts.channels.size() <= 4;
    if (!sensible) return std::nullopt;
    return facts;
}

std::uint64_t pixel_bytes(const BandFacts& facts) { return facts.row_bytes() * std::uint64_t(facts.end - facts.first); }

std::uint64_t size_of(int fd) {
    struct stat status {};
    return ::fstat(fd, &status) == 0 ? std::uint64_t(status.st_size) : 0;
}

std::optional<Footer> read_footer(int fd) {
    Footer footer;
    const std::uint64_t size = size_of(fd);
    if (size < sizeof footer || !read_at(fd, size - sizeof footer, std::as_writable_bytes(std::span(&footer, 1)))) return std::nullopt;
    if (std::string_view(footer.mark, sizeof footer.mark) != mark || footer.text_bytes > longest_text || footer.text_bytes > size - sizeof footer)
        return std::nullopt;
    return footer;
}

} // namespace

std::uint64_t BandFacts::row_bytes() const { return std::uint64_t(width) * channels.size() * std::uint64_t(sample_bytes_of(bits)); }

BandWriter::BandWriter(int fd, std::string name) : fd_(fd), name_(std::move(name)), sum_(std::make_unique<Sum>()) {}
BandWriter::~BandWriter() = default;

Result<void> BandWriter::rows(std::span<const std::byte> bytes) {
    if (!write_at(fd_, at_, bytes))
        return fail(ErrorCode::write_failed, name_ + ": writing stopped half-way, nothing was left behind: " + std::generic_category().message(errno));
    at_ += bytes.size();
    sum_->add(bytes);
    return {};
}

Result<void> BandWriter::finish(const BandFacts& facts) {
    const std::string text = to_json(facts).dump(-1, ' ', true, json::error_handler_t::replace);
    return rows(std::as_bytes(std::span(facts.ratio_sums))).and_then([&] { return rows(std::as_bytes(std::span(text))); }).and_then([&]() -> Result<void> {
        Footer footer{text.size(), {}, {}};
        const XXH128_canonical_t sum = sum_->value();
        static_assert(sizeof sum.digest == sizeof footer.sum);
        std::memcpy(footer.sum, sum.digest, sizeof footer.sum);
        std::memcpy(footer.mark, mark.data(), mark.size());
        return rows(std::as_bytes(std::span(&footer, 1)));
    });
}

Result<BandReader> BandReader::open(const std::filesystem::path& path) {
    UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat status {};
    if (!fd || ::fstat(fd.get(), &status) != 0)
        return fail(ErrorCode::no_input, path.string() + ": cannot open: " + std::generic_category().message(errno));
    if (!S_ISREG(status.st_mode)) return fail(ErrorCode::no_input, path.string() + ": is not a regular file");
    const auto no_band = [&] { return fail(ErrorCode::bad_data, path.string() + ": is no band of this version of reliefbake, or is cut off"); };
    const std::optional<Footer> footer = read_footer(fd.get());
    if (!footer) return no_band();
    const std::uint64_t end = size_of(fd.get()) - sizeof(Footer), text_at = end - footer->text_bytes;
    std::string text(std::size_t(footer->text_bytes), '\0');
    if (!read_at(fd.get(), text_at, std::as_writable_bytes(std::span(text)))) return no_band();
    try {
        std::optional<BandFacts> facts = facts_from(json::parse(text));
        if (!facts) return no_band();
        facts->ratio_sums.resize(std::size_t(facts->end - facts->first));
        const std::uint64_t sums_at = pixel_bytes(*facts);
        if (sums_at + facts->ratio_sums.size() * sizeof(double) != text_at) return no_band();
        if (!read_at(fd.get(), sums_at, std::as_writable_bytes(std::span(facts->ratio_sums)))) return no_band();
        BandReader reader(-1, std::move(*facts), path.string());
        reader.file_ = std::move(fd);
        return reader;
    } catch (const json::exception&) {
        return no_band();
    }
}

Result<void> BandReader::read(int y, int n, std::span<std::byte> out) const {
    const std::uint64_t row = facts_.row_bytes();
    if (read_at(fd(), std::uint64_t(y - facts_.first) * row, out.first(std::size_t(std::uint64_t(n) * row)))) return {};
    return fail(ErrorCode::bad_data, name_ + ": cannot be read: " + std::generic_category().message(errno));
}

Result<void> BandReader::check_sum() const {
    const std::optional<Footer> footer = read_footer(fd());
    const std::uint64_t end = size_of(fd()) - sizeof(Footer);
    BandWriter::Sum sum;
    std::vector<std::byte> block(block_bytes);
    bool read = footer.has_value();
    for (std::uint64_t at = 0; read && at < end; at += block.size()) {
        block.resize(std::size_t(std::min<std::uint64_t>(block_bytes, end - at)));
        read = read_at(fd(), at, block);
        sum.add(block);
    }
    if (read && std::memcmp(sum.value().digest, footer->sum, sizeof footer->sum) == 0) return {};
    return fail(ErrorCode::bad_data, name_ + ": is damaged: its rows are not those that were written; bake the band again");
}

} // namespace reliefbake
