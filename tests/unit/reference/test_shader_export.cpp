#include "shaders-reference/renderer/bump_export.h"
#include "shaders-reference/renderer/shader_export.h"
#include "shaders-reference/renderer/shape_export.h"
#include "tests/support/fields.h"
#include "tests/support/slow_cones.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <unistd.h>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

const TexelGrid oblong{8, 6, Wrap::repeat, Wrap::clamp, 1.25};

ReliefMap base_map(ConeEncoding encoding) {
    MapChoices choices;
    choices.encoding = encoding;
    const DepthMap depth = noise(oblong, 3);
    return make_relief_map(depth, Image<float>(8, 6, 0.5f), 1, choices);
}

/// Every kind, encoding, lookup, family, metric; with and without normals.
std::vector<ReliefMap> maps_of_all_kinds() {
    struct Kind {
        const char* word;
        std::size_t planes;
    };
    std::vector<ReliefMap> maps;
    for (const Kind kind : {Kind{"cone", 0}, Kind{"acm", 4}, Kind{"acm", 8}, Kind{"cone-stack", 3}, Kind{"cone-stack", 8},
                            Kind{"cone-pieces", 3}, Kind{"cone-pieces", 8}})
        for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::sqrt, ConeEncoding::radius, ConeEncoding::normal})
            for (const ConeLookup lookup : {ConeLookup::filtered, ConeLookup::cell})
                for (const ConeFamily family : {ConeFamily::conservative, ConeFamily::relaxed, ConeFamily::hybrid}) {
                    ReliefMap map = base_map(encoding);
                    map.info.kind = std::string(kind.word);
                    map.info.lookup = lookup;
                    map.info.family = family;
                    map.cone_planes.assign(kind.planes, map.cone);
                    if (kind.planes > 0) map.cone = Image<float>();
                    maps.push_back(map);
                }
    maps.push_back(base_map(ConeEncoding::sqrt));
    maps.back().info.metric = Metric::l1;
    maps.back().info.normal_y = NormalY::dx;
    maps.back().info.filter_delta = 0.0025;
    maps.push_back(base_map(ConeEncoding::normal));
    maps.back().info.cone_max = std::numeric_limits<float>::infinity();
    maps.back().info.bits = BitDepth::float32;
    maps.back().normal_x = maps.back().normal_y = Image<float>();
    maps.push_back(base_map(ConeEncoding::sqrt));
    maps.back().info.holes = true;
    maps.push_back(maps.back());
    maps.back().info.family = ConeFamily::relaxed;
    return maps;
}

/// Every kind, bit depth and convention.
std::vector<BumpMap> bump_maps_of_all_kinds() {
    std::vector<BumpMap> maps;
    for (const BumpKind kind : {BumpKind::derivative, BumpKind::normal, BumpKind::horizon})
        for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::float32})
            for (const SignedCodes codes : {SignedCodes::centred, SignedCodes::unorm})
                for (const NormalY y : {NormalY::gl, NormalY::dx}) {
                    BumpMapInfo info;
                    info.kind = kind, info.bits = bits, info.codes = codes, info.normal_y = y;
                    maps.push_back({info, oblong, {}, {}});
                }
    return maps;
}

/// Every bit depth, signed or not.
std::vector<ShapeMap> shape_maps_of_all_kinds() {
    std::vector<ShapeMap> maps;
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32})
        for (const bool with_sign : {false, true}) {
            ShapeMapInfo info;
            info.bits = bits, info.signed_distance = with_sign, info.tau = 0.375, info.filter_delta = 0.001, info.guarantee = "S";
            maps.push_back({info, oblong, {}, {}, {}, {}});
        }
    return maps;
}

} // namespace

TEST_CASE("the shader of every kind of map compiles alone, in every language", "[shaders][export]") {
    const auto folder = std::filesystem::temp_directory_path() / std::string("reliefbake_export.").append(std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::string files[3];
    int number = 0;
    for (const ReliefMap& map : maps_of_all_kinds())
        for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::glsl_es, ShaderLanguage::hlsl}) {
            const Result<std::string> text = export_shader(map, language);
            REQUIRE(text);
            const auto path = folder / (std::to_string(number++) + ".frag");
            std::ofstream(path) << *text;
            files[int(language)].append(" ").append(path.string());
        }
    for (const BumpMap& map : bump_maps_of_all_kinds())
        for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::glsl_es, ShaderLanguage::hlsl}) {
            const auto path = folder / (std::to_string(number++) + ".frag");
            std::ofstream(path) << export_bump_shader(map, language);
            files[int(language)].append(" ").append(path.string());
        }
    for (const ShapeMap& map : shape_maps_of_all_kinds())
        for (const ShaderLanguage language : {ShaderLanguage::glsl, ShaderLanguage::glsl_es, ShaderLanguage::hlsl}) {
            const auto path = folder / (std::to_string(number++) + ".frag");
            std::ofstream(path) << export_shape_shader(map, language);
            files[int(language)].append(" ").append(path.string());
        }
    const auto log = folder / "log.txt";
    // -D: the HLSL front end, which works only on the way to SPIR-V, a file at a time.
    const std::string validator = GLSLANG_VALIDATOR;
    const std::string output = " > " + log.string() + " 2>&1";
    const std::string hlsl = "for f in" + files[2] + "; do " + validator + " -D -V -e main -S frag -o /dev/null $f || exit 1; done";
    for (const std::string& command : {validator + files[0], validator + files[1], "(" + hlsl + ")"}) {
        const int status = std::system((command + output).c_str());
        std::ifstream messages(log);
        INFO(std::string(std::istreambuf_iterator<char>(messages), {}).substr(0, 4000));
        CHECK(status == 0);
    }
    std::filesystem::remove_all(folder);
}

TEST_CASE("what a shader prints is what the map says", "[export]") {
    ReliefMap map = base_map(ConeEncoding::sqrt);
    map.info.cone_max = 0.75f;
    map.info.depth_scale = 0.07;
    const std::string glsl = export_shader(map, ShaderLanguage::glsl).value();
    const auto has = [&glsl](const char* text) { return glsl.find(text) != glsl.npos; };
    CHECK(has("const float relief_cone_max = 0.75;"));
    CHECK(has("const float relief_depth_scale = 0.07;"));
    CHECK(has("const float relief_aspect = 0.9375;"));
    CHECK(has("const ivec2 relief_repeat = ivec2(1, 0);"));
    CHECK(has("code * code * relief_cone_max"));
    CHECK(has("cone_march(ray)"));
    CHECK_FALSE(has("#if"));
    CHECK_FALSE(has("uniform float"));
    CHECK_FALSE(has("RELIEF_ENCODING"));
    CHECK_FALSE(has("discard"));
    CHECK_FALSE(has("falls_through"));
    map.info.holes = true;
    CHECK(export_shader(map, ShaderLanguage::hlsl).value().find("if (relief_falls_through(ray, hit)) discard;") != std::string::npos);
    map.info.family = ConeFamily::relaxed;
    CHECK(export_shader(map, ShaderLanguage::hlsl).value().find("relaxed_march(ray)") != std::string::npos);
    map.cone = Image<float>();
    CHECK_FALSE(export_shader(map, ShaderLanguage::glsl));
}

TEST_CASE("what a bump map's shader prints is what the map says", "[export]") {
    BumpMapInfo info;
    info.bits = BitDepth::unorm8, info.derivative_scale = 12.5;
    const std::string glsl = export_bump_shader({info, oblong, {}, {}}, ShaderLanguage::glsl);
    const auto has = [&glsl](const char* text) { return glsl.find(text) != glsl.npos; };
    CHECK(has("const float signed_zero = 128.0;"));
    CHECK(has("const float bump_scale = 12.5;"));
    CHECK(has("const float bump_aspect = 0.9375;"));
    CHECK_FALSE(has("#if"));
    CHECK_FALSE(has("SIGNED_CODES"));
    CHECK_FALSE(has("uniform float"));
    info.kind = BumpKind::horizon;
    CHECK(export_bump_shader({info, oblong, {}, {}}, ShaderLanguage::hlsl).find("atan2(") != std::string::npos);
}

TEST_CASE("what a shape map's shader prints is what the map says", "[export]") {
    const ShapeMap map = shape_maps_of_all_kinds()[1]; // 8 bits, signed
    const std::string glsl = export_shape_shader(map, ShaderLanguage::glsl);
    const auto has = [&glsl](const char* text) { return glsl.find(text) != glsl.npos; };
    CHECK(has("const float shape_tau = 0.375;"));
    CHECK(has("const float shape_aspect = 0.9375;"));
    CHECK(has("const float shape_delta = 0.001;"));
    CHECK(has("code = 2.0 * code - 1.0;"));
    CHECK(has("guarantee S"));
    CHECK(has("const int solid_steps = 25;"));
    CHECK_FALSE(has("#if"));
    CHECK_FALSE(has("uniform float"));
    CHECK_FALSE(has("SHAPE_UNORM"));
    CHECK(export_shape_shader(map, ShaderLanguage::hlsl).find("shape_map.SampleLevel(shape_map_sampler, ") != std::string::npos);
    const std::string plain = export_shape_shader(shape_maps_of_all_kinds()[6], ShaderLanguage::glsl); // float, without sign
    CHECK(plain.find("2.0 * ") == std::string::npos);
}
