#include "cli/scene/choose.h"
#include "cli/scene/scene_keys.h"
#include "cli/scene/scene_rules.h"
#include "tests/unit/scene/scenes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

using Strings = std::vector<std::string>;

const SceneKeys relief = {{"name", std::string("stone wall")}, {"height", std::string("a b.png")}, {"technique", std::string("cone")}};

Result<SceneAsset> read(SceneKeys keys) {
    return asset_of(keys, "", [](const std::string& path) -> Result<std::string> { return "folder/" + path; }, "s.toml");
}

/// `keys` with some more.
SceneKeys with(SceneKeys keys, const SceneKeys& more) {
    for (const auto& [key, value] : more) keys[key] = value;
    return keys;
}

} // namespace

TEST_CASE("keys become an asset") {
    const Result<SceneAsset> asset = read(with(relief, {{"features", Strings{"shadow", "mips"}}, {"mip_filter", std::string("trilinear")}, {"screen", 300.0}, {"size", 2.0}, {"depth", 0.1}}));
    REQUIRE(asset);
    CHECK(asset->name == "stone wall");
    CHECK(asset->height == "folder/a b.png");
    CHECK(asset->features.shadow);
    CHECK_FALSE(asset->features.ao);
    CHECK(asset->trilinear);
    CHECK(depth_scale_of(*asset) == Approx(0.05));
}

TEST_CASE("a key that means nothing where it stands is refused") {
    const auto refused = [](const SceneKeys& keys, const std::string& words) {
        const Result<SceneAsset> asset = read(keys);
        CAPTURE(words);
        REQUIRE_FALSE(asset);
        CAPTURE(asset.error().message);
        CHECK(asset.error().code == ErrorCode::usage);
        CHECK(asset.error().message.find(words) != std::string::npos);
    };
    const SceneKeys bump = with(relief, {{"technique", std::string("bump")}}), idle = {{"name", std::string("n")}, {"height", std::string("h.png")}};
    const SceneKeys shape = {{"name", std::string("n")}, {"shape", std::string("s.png")}, {"technique", std::string("extrusion")}};
    refused(with(relief, {{"angle", 60.0}}), "angle: needs max_wrong or max_shift");
    refused(with(relief, {{"size", 2.0}}), "size: needs depth or texel_density");
    refused(with(relief, {{"depth", 0.1}}), "depth: needs size");
    refused(with(relief, {{"steps", 10.0}}), "steps: needs max_wrong");
    refused(with(relief, {{"max_wrong", 0.1}}), "max_wrong: needs steps and angle");
    refused(with(relief, {{"max_shift", 0.5}}), "max_shift: needs screen and angle");
    refused(with(relief, {{"max_error", 0.1}, {"max_shift", 0.5}, {"screen", 9.0}, {"angle", 60.0}}), "max_error: needs no max_shift");
    refused(with(relief, {{"sectors", 4.0}}), "sectors: needs technique sectors");
    refused(with(relief, {{"technique", std::string("sectors")}}), "expected sectors = 4 or 8");
    refused(with(relief, {{"technique", std::string("sectors")}, {"sectors", 5.0}}), "found 5");
    refused(with(relief, {{"technique", std::string("sectors")}, {"sectors", 4.5}}), "whole number");
    refused(with(relief, {{"mip_filter", std::string("nearest")}}), "mip_filter: needs the feature mips");
    refused(with(relief, {{"technique", std::string("relaxed")}, {"features", Strings{"mips"}}, {"mip_filter", std::string("trilinear")}}), "not relaxed");
    refused(with(relief, {{"features", Strings{"silhouette"}}}), "silhouette: needs a mesh");
    refused(with(relief, {{"features", Strings{"ao", "ao"}}}), "at most once");
    refused(with(relief, {{"features", Strings{"fog"}}}), "found 'fog'");
    refused(with(relief, {{"features", std::string("ao")}}), "expected a list");
    refused(with(relief, {{"mesh", std::string("m.obj")}}), "mesh: needs technique curved");
    refused(with(relief, {{"technique", std::string("curved")}}), "needs a mesh");
    refused(with(relief, {{"technique", std::string("magic")}}), "found 'magic'");
    refused(with(relief, {{"shape", std::string("s.png")}}), "a height or a shape");
    refused(with(relief, {{"invert", true}}), "invert: needs a shape");
    refused(with(relief, {{"colour", 1.0}}), "unknown key 'colour'");
    refused(with(relief, {{"screen", std::string("wide")}}), "expected a number");
    refused(with(relief, {{"screen", 0.0}}), "expected a number from 1");
    refused(with(relief, {{"screen", 9.0}, {"texel_density", 9.0}, {"size", 1.0}}), "screen: needs no texel_density");
    refused(with(bump, {{"screen", 100.0}}), "screen: needs a map that can have fewer texels");
    refused(with(bump, {{"features", Strings{"mips"}}}), "mips: needs");
    refused(with(bump, {{"features", Strings{"depth"}}}), "depth: needs a technique");
    refused(with(bump, {{"alpha", std::string("m.png")}}), "have no holes");
    refused(with(idle, {{"depth_uv", 0.1}}), "depth_uv: needs");
    refused(with(shape, {{"max_error", 0.1}}), "max_error: needs a map of a height");
    refused(with(shape, {{"input", std::string("depth")}}), "input: needs a height");
    refused(with(shape, {{"features", Strings{"ao"}}}), "ao: needs a height");
    refused({{"name", std::string("n")}}, "expected a height, a shape or a mesh");
    for (const char* name : {"a/b", "..", ".a", "a\\b", "a:b", "-a", "a ", "", "a\nb"}) refused(with(relief, {{"name", std::string(name)}}), "name");
}

TEST_CASE("two assets of one name are refused, by case too") {
    Scene scene;
    scene.assets = {asset("Wall", SceneTechnique::cone), asset("wall", SceneTechnique::cone)};
    CHECK_FALSE(check_names(scene));
    scene.assets[1].name = "wall 2";
    CHECK(check_names(scene));
}

TEST_CASE("budgets choose bits and resolution") {
    SceneAsset stone = asset("a", SceneTechnique::cone);
    HeightFacts facts{512, 256, [](BitDepth bits, int level) { return (bits == BitDepth::unorm8 ? 0.5 / 255 : bits == BitDepth::unorm16 ? 0.5 / 65535 : 1e-8) + 0.01 * level; }};
    const auto bits = [&](const std::string& extension = ".png") { return choose_bits(stone, facts, extension, "s"); };
    CHECK(bits()->bits == BitDepth::unorm16);
    stone.max_error = 0.002;
    CHECK(bits()->bits == BitDepth::unorm8);
    stone.max_error = 0.0019;
    CHECK(bits()->bits == BitDepth::unorm16);
    stone.max_error = 1e-7;
    REQUIRE_FALSE(bits());
    CHECK(bits().error().code == ErrorCode::budget);
    CHECK(bits(".tif")->bits == BitDepth::float32);

    // What is seen decides the resolution; a budget may want more.
    stone.max_error.reset();
    CHECK(choose_level(stone, facts, BitDepth::unorm16) == 0);
    stone.screen = 129;
    CHECK(choose_level(stone, facts, BitDepth::unorm16) == 1);
    stone.screen = 128;
    CHECK(choose_level(stone, facts, BitDepth::unorm16) == 2);
    stone.max_error = 0.015;
    CHECK(choose_level(stone, facts, BitDepth::unorm16) == 1);
    stone.max_error = 0.001;
    CHECK(choose_level(stone, facts, BitDepth::unorm16) == 0);
    stone.screen.reset(), stone.max_error.reset();
    stone.texel_density = 64, stone.size = 2;
    CHECK(choose_level(stone, facts, BitDepth::unorm16) == 2);
    CHECK(seen_level(stone, 100, 50) == 0);

    // Pixels are heights at an angle; the depth feature asks more.
    SceneAsset wall = asset("w", SceneTechnique::cone);
    wall.max_shift = 0.5, wall.screen = 1000, wall.angle = 60, wall.depth_uv = 0.1;
    CHECK(height_budget(wall) == Approx(0.5 / (100 * std::sin(M_PI / 3))));
    wall.features.depth = true;
    CHECK(height_budget(wall) == Approx(0.5 / (100 * 2)));
}
