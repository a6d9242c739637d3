// Bump maps out and back, in every format and layout.

#include "formats/bump_file.h"
#include "formats/bump_json.h"
#include "formats/map_file.h"
#include "formats/map_kind.h"
#include "tests/support/fields.h"
#include "tests/unit/formats/temporary_folder.h"

#include <catch2/catch.hpp>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

const TexelGrid oblong{13, 7, Wrap::repeat, Wrap::clamp, 1.25};

BumpMap baked(BumpMapInfo info) {
    const DepthMap depth = noise(oblong, 6);
    DepthMap stored{oblong, info.bits, depth.level};
    for (float& level : stored.level) level = is_unorm(info.bits) ? level * float(max_code(info.bits) / 255) : level / 256;
    info.version = "0.1.0", info.source_hash = "abc", info.argument_hash = "def";
    switch (info.kind) {
    case BumpKind::derivative: {
        const DerivativeMap map = bake_derivatives(stored, info.kernel);
        info.derivative_scale = largest_derivative(map);
        return encode_derivatives(info, stored, map);
    }
    case BumpKind::normal: return encode_normals(info, stored, bake_normals(stored, info.depth_scale, 1, info.kernel));
    case BumpKind::horizon: break;
    }
    return encode_horizons(info, stored, bake_horizons(stored, info.depth_scale));
}

void require_same(const BumpMap& a, const BumpMap& b) {
    REQUIRE(to_json(a.info, a.grid) == to_json(b.info, b.grid));
    REQUIRE(a.grid == b.grid);
    REQUIRE(a.planes.size() == b.planes.size());
    for (std::size_t k = 0; k < a.planes.size(); ++k)
        for (std::size_t i = 0; i < a.planes[k].size(); ++i) REQUIRE(a.planes[k][i] == Approx(b.planes[k][i]).margin(1e-7));
    REQUIRE(a.depth.size() == b.depth.size());
    for (std::size_t i = 0; i < a.depth.size(); ++i) REQUIRE(a.depth[i] == Approx(b.depth[i]).margin(1e-7));
}

} // namespace

TEST_CASE("A bump map of any kind comes back from every format, with its meaning") {
    const TemporaryFolder folder;
    struct Format {
        const char* extension;
        BitDepth bits;
    };
    for (const BumpKind kind : {BumpKind::derivative, BumpKind::normal, BumpKind::horizon})
        for (const Format format : {Format{".png", BitDepth::unorm8}, Format{".png", BitDepth::unorm16}, Format{".tif", BitDepth::unorm16},
                                    Format{".tif", BitDepth::half}, Format{".exr", BitDepth::half}, Format{".exr", BitDepth::float32}})
            for (const bool named : {false, true}) {
                if (named && std::string(format.extension) != ".exr") continue;
                BumpMapInfo info;
                info.kind = kind, info.bits = format.bits, info.kernel = DerivativeKernel::scharr, info.normal_y = kind == BumpKind::normal ? NormalY::dx : NormalY::gl;
                info.codes = kind == BumpKind::normal ? SignedCodes::unorm : SignedCodes::centred;
                info.layout = named ? ChannelLayout::named : kind == BumpKind::horizon ? ChannelLayout::pair : ChannelLayout::rgba;
                const BumpMap map = baked(info);
                const auto path = folder.path() / (std::string("bump") + format.extension);
                CAPTURE(int(kind), format.extension, int(format.bits), named);
                REQUIRE(write_bump_map(path, map));
                CHECK(kind_of_map(path).value() == word_of(kind));
                const Result<BumpMap> back = read_bump_map(path);
                REQUIRE(back);
                require_same(*back, map);
                for (const Image<float>& plane : back->planes) // codes survive to the last bit where the format holds them
                    if (is_unorm(format.bits)) REQUIRE(decode_bump(plane[3], back->info) == decode_bump(map.planes[std::size_t(&plane - back->planes.data())][3], map.info));
            }
}

TEST_CASE("What a format or layout cannot hold is refused before the bake") {
    BumpMapInfo info;
    CHECK_FALSE(check_bump_format("map.dds", info));
    CHECK_FALSE(check_bump_format("map.exr", info)); // 16-bit codes
    info.layout = ChannelLayout::pair;
    CHECK_FALSE(check_bump_format("map.png", info));
    info.layout = ChannelLayout::named;
    CHECK_FALSE(check_bump_format("map.png", info));
    info.layout = ChannelLayout::rgba, info.kind = BumpKind::horizon;
    CHECK_FALSE(check_bump_format("map.png", info));
    info.layout = ChannelLayout::pair;
    CHECK(check_bump_format("map.png", info));
    CHECK(check_bump_format("map.tga", {BumpKind::normal, BitDepth::unorm8}));
}

TEST_CASE("Both files of a pair appear, or none") {
    const TemporaryFolder folder;
    const auto path = folder.path() / "a.png";
    BumpMapInfo info;
    info.kind = BumpKind::horizon, info.layout = ChannelLayout::pair;
    std::filesystem::create_directory(folder.path() / "a_b.png"); // where no file can be
    const Result<void> written = write_bump_map(path, baked(info));
    REQUIRE_FALSE(written);
    CHECK(written.error().code == ErrorCode::cannot_create);
    CHECK_FALSE(std::filesystem::exists(path));
    CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1); // no temporary either
    std::filesystem::remove(folder.path() / "a_b.png");
    CHECK(write_bump_map(path, baked(info)));
    CHECK(std::filesystem::exists(folder.path() / "a_b.png"));
}

TEST_CASE("Halves that do not belong together are refused") {
    const TemporaryFolder folder;
    BumpMapInfo info;
    info.kind = BumpKind::horizon, info.layout = ChannelLayout::pair;
    REQUIRE(write_bump_map(folder.path() / "a.png", baked(info)));
    info.depth_scale = 0.2;
    BumpMap other = baked(info);
    other.info.argument_hash = "other";
    REQUIRE(write_bump_map(folder.path() / "b.png", other));
    std::filesystem::copy_file(folder.path() / "b_b.png", folder.path() / "a_b.png", std::filesystem::copy_options::overwrite_existing);
    CHECK(read_bump_map(folder.path() / "a.png").error().code == ErrorCode::bad_data);
    std::filesystem::remove(folder.path() / "a_b.png");
    CHECK(read_bump_map(folder.path() / "a.png").error().code == ErrorCode::no_input);
}

TEST_CASE("Metadata of bump maps that is missing or makes no sense is named") {
    const nlohmann::json good = to_json(baked({}).info, oblong);
    CHECK(bump_facts_from(good.dump()).bad_keys.empty());
    const auto bad_after = [&](const char* key, const nlohmann::json& value) {
        nlohmann::json facts = good;
        if (value.is_null()) facts.erase(key);
        else facts[key] = value;
        return bump_facts_from(facts.dump()).bad_keys;
    };
    for (const char* key : {"codes", "kernel", "derivative_scale", "error", "wrap", "pixel_aspect", "layout"}) CHECK(bad_after(key, nullptr) == std::vector<std::string>{key});
    CHECK_FALSE(bad_after("derivative_scale", -1).empty());
    CHECK_FALSE(bad_after("codes", "signed").empty());
    CHECK_FALSE(bad_after("layout", "pair").empty());
    CHECK_FALSE(bad_after("wrap", nlohmann::json::array({"repeat"})).empty());
    CHECK(bump_facts_from("{\"kind\": \"cone\"}").kind == "cone");
    for (const char* text : {"", "[]", "{", "7"}) CHECK(bump_facts_from(text).kind.empty());
}
