#include "shaders-reference/renderer/shader_source.h"

#include "tests/support/glslang_check.h"

#include <catch2/catch.hpp>

#include <vector>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

constexpr Prelude preludes[] = {Prelude::core330, Prelude::core450, Prelude::es300};

std::vector<ShaderConfig> configurations() {
    std::vector<ShaderConfig> all;
    const auto add = [&all](auto change) {
        ShaderConfig config;
        change(config);
        all.push_back(config);
    };
    for (const TechniqueInfo& info : all_techniques())
        for (const bool exact : {false, true}) {
            if (exact && info.technique != Technique::cone && info.technique != Technique::cone_raw) continue;
            add([&](ShaderConfig& config) { config.technique = info.technique, config.exact_finish = exact; });
        }

    // Every way to keep cones, in every encoding, by the three lookups.
    struct Kind {
        int sectors, levels;
    };
    for (const Kind kind : {Kind{0, 1}, Kind{4, 1}, Kind{8, 1}, Kind{0, 2}, Kind{0, 4}, Kind{0, 8}})
        for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius, ConeEncoding::normal})
            for (const int lookup : {0, 1, 2})
                add([&](ShaderConfig& config) {
                    config.sectors = kind.sectors, config.levels = kind.levels, config.encoding = encoding;
                    if (lookup == 1) config.lookup = ConeLookup::cell;
                    if (lookup == 2) config.technique = Technique::cone_raw;
                    config.metric = kind.sectors == 4 ? Metric::l1 : Metric::l2;
                });

    for (const Shadow shadow : {Shadow::hard, Shadow::height_soft, Shadow::cone_soft, Shadow::horizon})
        for (const Ambient ambient : {Ambient::none, Ambient::cone, Ambient::cone_normal})
            for (const bool empty : {false, true})
                add([&](ShaderConfig& config) { config.shadow = shadow, config.ambient = ambient, config.empty_cones = empty; });
    for (const TechniqueInfo& info : all_techniques()) add([&](ShaderConfig& config) { config.technique = info.technique, config.holes = true; });
    add([](ShaderConfig& config) { config.metric = Metric::l1, config.normal_unorm = false, config.normal_y = NormalY::dx; });
    return all;
}

} // namespace

TEST_CASE("every shader is valid under all three preludes", "[shaders]") {
    GlslangCheck check;
    for (const Prelude prelude : preludes) {
        check.add(vertex_source(prelude), ".vert");
        for (const ShaderConfig& config : configurations()) check.add(fragment_source(config, prelude), ".frag");
    }
    CHECK(check.faults() == "");
}

TEST_CASE("shaders keep to what all three languages have", "[shaders]") {
    for (const ShaderText& shader : shader_texts()) {
        INFO(shader.name);
        CHECK(shader.text.find("textureGather") == std::string_view::npos);
        CHECK(shader.text.find("texture(") == std::string_view::npos);
        CHECK_FALSE(shader.text.empty());
    }
}
