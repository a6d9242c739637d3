#include "cli/scene/scene_rules.h"
#include "tests/unit/scene/scenes.h"

#include <catch2/catch.hpp>

#include <algorithm>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr SceneTechnique all_techniques[] = {SceneTechnique::none,     SceneTechnique::cone, SceneTechnique::relaxed, SceneTechnique::sectors,   SceneTechnique::cone_normal,
                                             SceneTechnique::parallax, SceneTechnique::bump, SceneTechnique::curved,  SceneTechnique::extrusion, SceneTechnique::revolution};

SceneFeatures features_of(unsigned set) {
    SceneFeatures features;
    features.shadow = set & 1, features.ao = set & 2, features.silhouette = set & 4, features.mips = set & 8, features.depth = set & 16;
    return features;
}

std::string words(const SceneMap& map) {
    std::string text = map.command;
    for (const std::string& option : map.options) text += " " + option;
    return text;
}

} // namespace

TEST_CASE("removing a feature never adds bytes") {
    int compared = 0;
    for (const SceneTechnique first : all_techniques)
        for (const SceneTechnique second : all_techniques)
            for (unsigned set = 0; set < 32; ++set)
                for (unsigned removed = 0; removed < 5; ++removed) {
                    if ((set >> removed & 1) == 0) continue;
                    Scene scene;
                    scene.assets = {asset("a", first), asset("b", second)};
                    scene.assets[1].features.mips = true, scene.assets[1].features.ao = true;
                    std::vector<AssetFacts> facts = facts_of(scene);
                    facts[1].bits = BitDepth::unorm8, facts[1].level = 1;
                    const auto bytes = [&](unsigned features) {
                        scene.assets[0].features = features_of(features);
                        return plan_of(scene, facts).bytes();
                    };
                    const std::uint64_t with = bytes(set), without = bytes(set & ~(1u << removed));
                    if (without > with) FAIL(int(first) << " beside " << int(second) << ": features " << set << " without " << removed);
                    ++compared;
                }
    CHECK(compared == 10 * 10 * 80);
}

TEST_CASE("the same asset twice is one output") {
    for (const SceneTechnique technique : all_techniques) {
        if (technique == SceneTechnique::none) continue;
        Scene one, two;
        one.assets = {asset("a", technique)};
        two.assets = {asset("a", technique), asset("b", technique)};
        const std::vector<SceneMap> once = maps_of(plan_of(one)), twice = maps_of(plan_of(two));
        REQUIRE(once.size() == twice.size());
        REQUIRE(!once.empty());
        for (std::size_t k = 0; k < once.size(); ++k) {
            CHECK(words(once[k]) == words(twice[k]));
            CHECK(once[k].bytes() == twice[k].bytes());
            CHECK(twice[k].uses.size() == 2);
        }
    }
}

TEST_CASE("an asset that nothing needs has no output") {
    Scene scene;
    scene.assets = {asset("idle", SceneTechnique::none), asset("unworn", SceneTechnique::cone), asset("pot", SceneTechnique::curved)};
    scene.assets[1].is_placed = false;
    scene.assets[2].height.clear(); // a mesh alone, and no silhouette
    CHECK(plan_of(scene).jobs.empty());
    CHECK(plan_everything(scene, facts_of(scene)).bytes() > 0);
    scene.assets[2].features.silhouette = true;
    REQUIRE(maps_of(plan_of(scene)).size() == 1);
    CHECK(maps_of(plan_of(scene))[0].command == "quadric");
    CHECK(plan_of(scene).bytes() == 10000);
}

TEST_CASE("one source, several needs: one run, and one map where one can serve") {
    Scene scene;
    scene.assets = {asset("near", SceneTechnique::cone), asset("far", SceneTechnique::parallax), asset("low", SceneTechnique::relaxed)};
    const ScenePlan plan = plan_of(scene);
    REQUIRE(plan.jobs.size() == 1);
    REQUIRE(plan.jobs[0].maps.size() == 2);
    CHECK(plan.jobs[0].maps[0].output == "near.png");
    CHECK(plan.jobs[0].maps[0].uses.size() == 2); // near and far
    CHECK(words(plan.jobs[0].maps[1]) == "cone --bits 16 --kind relaxed");

    // Another depth: other normals, another run.
    scene.assets[1].depth_uv = 0.3;
    CHECK(plan_of(scene).jobs.size() == 2);
    // Another source.
    scene.assets[2].height = "sand.png";
    CHECK(plan_of(scene).jobs.size() == 3);
}

TEST_CASE("only the channels, levels and bits that are needed") {
    Scene scene;
    scene.assets = {asset("a", SceneTechnique::parallax)};
    std::vector<AssetFacts> facts = facts_of(scene);
    const auto only = [&] {
        const std::vector<SceneMap> maps = maps_of(plan_of(scene, facts));
        REQUIRE(maps.size() == 1);
        return maps[0];
    };
    CHECK(words(only()) == "cone --bits 16 --channels normal,depth");
    CHECK(only().files[0].channels == 3);
    scene.assets[0].features.ao = true;
    CHECK(words(only()) == "cone --bits 16");
    facts[0].bits = BitDepth::unorm8, facts[0].level = 2;
    scene.assets[0].features.mips = true, scene.assets[0].trilinear = true;
    CHECK(words(only()) == "cone --bits 8 --level 2 --mips --trilinear");
    CHECK(only().files.size() == 7); // 64 x 32 to 1 x 1
    CHECK(only().files[6].name == "a_mip6.png");
    scene.extension = ".tif";
    CHECK(only().files.size() == 1);

    // ao beside relaxed cones needs cones of its own, blended as safely.
    scene.extension = ".png";
    scene.assets[0].technique = SceneTechnique::relaxed;
    const std::vector<SceneMap> both = maps_of(plan_of(scene, facts));
    REQUIRE(both.size() == 2);
    CHECK(words(both[0]) == "cone --bits 8 --level 2 --mips --kind relaxed");
    CHECK(both[1].output == "a_ambient.png");
    CHECK(words(both[1]) == "cone --bits 8 --level 2 --mips --trilinear --channels cone,depth");

    scene.assets[0] = asset("a", SceneTechnique::bump);
    scene.assets[0].features.shadow = true;
    facts[0] = facts_of(scene)[0];
    const std::vector<SceneMap> bump = maps_of(plan_of(scene, facts));
    REQUIRE(bump.size() == 2);
    CHECK(words(bump[0]) == "bump --kind normal --bits 16");
    CHECK(words(bump[1]) == "bump --kind horizon --bits 16");
    CHECK(bump[1].files[0].name == "a_horizon.png");
    CHECK(bump[1].files[1].name == "a_horizon_b.png");

    scene.assets[0] = asset("a", SceneTechnique::sectors);
    const std::vector<SceneMap> sectors = maps_of(plan_of(scene, facts));
    REQUIRE(sectors.size() == 2);
    CHECK(words(sectors[0]) == "acm --bits 16 --sectors 4");
    CHECK(sectors[1].output == "a_relief.png");
}

TEST_CASE("too many needs of one source are refused") {
    Scene scene;
    for (int k = 0; k < 14; ++k) {
        scene.assets.push_back(asset("a" + std::to_string(k), SceneTechnique::cone));
        scene.assets.back().depth_uv = 0.1 + 0.1 * k;
    }
    const Result<ScenePlan> plan = plan_scene(scene, facts_of(scene));
    REQUIRE_FALSE(plan);
    CHECK(plan.error().code == ErrorCode::budget);
    scene.assets.resize(12);
    CHECK(maps_of(plan_of(scene)).size() == 12);
}
