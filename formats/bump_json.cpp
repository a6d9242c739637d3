#include "formats/bump_json.h"

#include "formats/fact_reader.h"

#include <array>
#include <cmath>

namespace reliefbake {

using nlohmann::json;

namespace {

// The words of the file format, in the order of the enumerators.
constexpr std::array kind_words{"derivative", "normal", "horizon"};
constexpr std::array codes_words{"centred", "unorm"};
constexpr std::array kernel_words{"central", "sobel", "scharr"};

const char* const azimuth_names[] = {"horizon.a0", "horizon.a1", "horizon.a2", "horizon.a3", "horizon.a4", "horizon.a5", "horizon.a6", "horizon.a7"};

std::vector<std::string> named_channels(BumpKind kind) {
    switch (kind) {
    case BumpKind::derivative: return {"bump.du", "bump.dv", "relief.depth"};
    case BumpKind::normal: return {"relief.nx", "relief.ny", "relief.nz", "relief.depth"};
    case BumpKind::horizon: break;
    }
    std::vector<std::string> names(std::begin(azimuth_names), std::end(azimuth_names));
    names.emplace_back("relief.depth");
    return names;
}

json azimuths(const TexelGrid& grid) {
    // Rounded: the C library's last bit of an angle differs between processors, and files must not.
    constexpr double half_turn = 3.14159265358979323846, digits = 1e6;
    json degrees = json::array();
    for (int k = 0; k < horizon_azimuths; ++k) degrees.push_back(std::round(horizon_angle(grid, k) * 180 / half_turn * digits) / digits);
    return degrees;
}

/// What only some kinds have.
void write_kind(const BumpMapInfo& info, const TexelGrid& grid, json& facts) {
    if (info.kind == BumpKind::horizon) facts["azimuths"] = azimuths(grid);
    if (info.kind == BumpKind::horizon) return;
    facts["codes"] = codes_words[std::size_t(info.codes)];
    facts["kernel"] = kernel_words[std::size_t(info.kernel)];
    if (info.kind == BumpKind::derivative) facts["derivative_scale"] = info.derivative_scale;
    if (info.kind == BumpKind::normal) facts["normal_y"] = normal_y_words[std::size_t(info.normal_y)];
}

void read_kind(const FactReader& reader, BumpFacts& facts) {
    BumpMapInfo& info = facts.info;
    constexpr double largest = 1e9;
    if (info.kind != BumpKind::derivative) info.depth_scale = reader.required(reader.number("depth_scale", 1e-30, largest), "depth_scale");
    if (info.kind == BumpKind::horizon) return;
    info.codes = reader.required(reader.word<SignedCodes>("codes", codes_words), "codes");
    info.kernel = reader.required(reader.word<DerivativeKernel>("kernel", kernel_words), "kernel");
    if (info.kind == BumpKind::derivative)
        info.derivative_scale = reader.required(reader.number("derivative_scale", 1e-30, largest), "derivative_scale");
    if (info.kind == BumpKind::normal) info.normal_y = reader.required(reader.word<NormalY>("normal_y", normal_y_words), "normal_y");
}

} // namespace

const char* word_of(BumpKind kind) { return kind_words[std::size_t(kind)]; }

std::optional<BumpKind> bump_kind_of(const std::string& word) { return FactReader::word_in<BumpKind>(word, kind_words); }

std::vector<BumpImage> bump_images(const BumpMapInfo& info) {
    if (info.layout == ChannelLayout::named) return {{"", named_channels(info.kind), 0}};
    if (info.kind == BumpKind::derivative) return {{"", {"R", "G", "B"}, 0}};
    const std::vector<std::string> rgba{"R", "G", "B", "A"};
    if (info.kind == BumpKind::normal) return {{"", rgba, 0}};
    return {{"", rgba, 0}, {"_b", rgba, 4}};
}

json to_json(const BumpMapInfo& info, const TexelGrid& grid) {
    json facts = {
        {"kind", word_of(info.kind)},
        {"version", info.version},
        {"width", grid.width},
        {"height", grid.height},
        {"aspect", grid.aspect()},
        {"pixel_aspect", grid.pixel_aspect},
        {"wrap", wrap_to_json(grid)},
        {"bits", bits_to_json(info.bits)},
        {"layout", layout_words[std::size_t(info.layout)]},
        {"channels", bump_images(info)[0].channels},
        {"error", info.error},
        {"source_hash", info.source_hash},
        {"argument_hash", info.argument_hash},
        {"statistics", numbers_to_json(info.statistics)},
    };
    if (info.kind != BumpKind::derivative) facts["depth_scale"] = info.depth_scale;
    write_kind(info, grid, facts);
    return facts;
}

BumpFacts bump_facts_from(const std::string& text) {
    BumpFacts facts;
    const json object = json::parse(text, nullptr, false);
    if (!object.is_object()) return facts;
    const FactReader reader(object, facts.bad_keys);
    facts.kind = reader.text("kind").value_or("");
    const auto kind = bump_kind_of(facts.kind);
    if (!kind) return facts;
    BumpMapInfo& info = facts.info;
    info.kind = *kind;
    info.layout = reader.required(reader.word<ChannelLayout>("layout", layout_words), "layout");
    if (info.layout == ChannelLayout::side || (info.layout == ChannelLayout::pair && *kind != BumpKind::horizon) ||
        (info.layout == ChannelLayout::rgba && *kind == BumpKind::horizon))
        reader.bad("layout");
    info.error = reader.required(reader.number("error", 0, 1e9), "error");
    read_kind(reader, facts);
    reader.origin(info);
    const auto wrap = reader.required(reader.wrap("wrap"), "wrap");
    facts.wrap_x = wrap.first;
    facts.wrap_y = wrap.second;
    facts.pixel_aspect = reader.required(reader.number("pixel_aspect", least_pixel_aspect, largest_pixel_aspect), "pixel_aspect");
    return facts;
}

} // namespace reliefbake
