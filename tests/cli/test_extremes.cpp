// Sizes and values at their ends, through the whole tool: baked, explained, and judged by verify.

#include "formats/atomic_file.h"
#include "formats/encode_image.h"
#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

json succeed(const std::string& arguments) {
    const Outcome outcome = run_tool(arguments);
    INFO(arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return json::parse(outcome.out);
}

/// Bakes `input` as halfs or floats by ratio, and holds the result to the schema and to the metadata in the file.
json bake(const std::string& input, const std::string& options) {
    const json result = succeed("cone " + input + " -o extreme.exr --json " + options);
    const json schema = json::parse(bytes_of(std::string(RELIEFBAKE_SCHEMA_DIR) + "/cone.schema.json"));
    CHECK(schema_fault(result, schema) == "");
    CHECK(succeed("explain --json extreme.exr") == result["map"]);
    return result;
}

void check_safe() {
    const json verdict = succeed("verify extreme.exr --json");
    CHECK(verdict["missed"] == 0);
    CHECK(verdict["violations"] == 0);
}

/// A one-channel EXR of halfs.
void write_half_exr(const std::string& name, int width, int height, const std::vector<float>& samples) {
    using namespace reliefbake;
    const auto pixels = SharedMemory::create(samples.size() * sizeof(float));
    std::memcpy(pixels->bytes().data(), samples.data(), samples.size() * sizeof(float));
    const auto file = encode_image({"openexr", width, height, {"Y"}, "half", "float"}, *pixels, name);
    REQUIRE(file);
    REQUIRE(write_file_atomically(work_folder() / name, file->bytes()));
}

constexpr float smallest_half = 0x1p-24f, largest_half = 65504;

} // namespace

TEST_CASE("Sizes at their ends: one texel, one column, a strip, two by three") {
    const int sizes[][2] = {{1, 1}, {1, 16384}, {16384, 1}, {16384, 4}, {2, 3}};
    for (const auto& [width, height] : sizes)
        for (const std::string wrap : {"repeat", "clamp"}) {
            CAPTURE(width, height, wrap);
            write_pgm(work_folder() / "size.pgm", width, height, [](int x, int y) { return (x * 7 + y * 13) % 256; });
            const json result = bake("size.pgm", "--wrap " + wrap);
            CHECK(result["map"]["width"] == width);
            CHECK(result["map"]["height"] == height);
            if (width * height <= 6) check_safe();
        }
}

TEST_CASE("Constant 0 and constant 1 get the widest cone everywhere") {
    for (const int code : {0, 255}) {
        CAPTURE(code);
        write_pgm(work_folder() / "flat.pgm", 17, 13, [code](int, int) { return code; });
        const json result = bake("flat.pgm", "--encoding ratio");
        CHECK(result["statistics"]["depth_min"] == (code ? 0 : 1));
        CHECK(result["statistics"]["ratio_min"] == 1);
        CHECK(result["statistics"]["zero_codes"] == 0);
        check_safe();
        const json unbounded = bake("flat.pgm", "--encoding normal --cone-max inf");
        CHECK(unbounded["statistics"]["ratio_min"] == "inf");
        CHECK(unbounded["statistics"]["ratio_mean"] == "inf");
    }
}

TEST_CASE("One spike: every bit depth of it is safe") {
    write_pgm(work_folder() / "spike.pgm", 33, 33, [](int x, int y) { return x == 16 && y == 16 ? 255 : 0; });
    for (const std::string bits : {"half", "float"}) {
        bake("spike.pgm", "--bits " + bits);
        check_safe();
    }
}

TEST_CASE("Half floats at their limits: the largest, the smallest, both signs") {
    std::vector<float> samples(16 * 16);
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = i % 3 == 0 ? largest_half : i % 3 == 1 ? -largest_half : smallest_half;
    write_half_exr("limits.exr", 16, 16, samples);
    CHECK(run_tool("cone limits.exr -o extreme.exr --range 0:1").status == 65);
    const json limits = bake("limits.exr", "--range data --bits half");
    CHECK(limits["source"]["low"] == -largest_half);
    CHECK(limits["source"]["high"] == largest_half);
    check_safe();

    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = float(i % 4) * smallest_half;
    write_half_exr("denormal.exr", 16, 16, samples);
    const json as_they_are = bake("denormal.exr", "");
    CHECK(as_they_are["range"]["from_data"] == false);
    check_safe();
    const json stretched = bake("denormal.exr", "--range data");
    CHECK(stretched["source"]["high"].get<float>() == 3 * smallest_half);
    CHECK(stretched["statistics"]["depth_min"] == 0);
    CHECK(stretched["statistics"]["depth_max"] == 1);
    check_safe();
}

TEST_CASE("Floats at their limits are stretched without overflow") {
    constexpr float largest = std::numeric_limits<float>::max(), denormal = std::numeric_limits<float>::denorm_min();
    write_pfm(work_folder() / "huge.pfm", 8, 8, [](int x, int y) { return (x + y) % 2 ? largest : -largest; });
    const json huge = bake("huge.pfm", "");
    CHECK(huge["range"]["from_data"] == true);
    CHECK(huge["statistics"]["depth_max"] == 1);
    check_safe();
    write_pfm(work_folder() / "tiny.pfm", 8, 8, [](int x, int) { return x % 2 ? denormal : 0.0f; });
    bake("tiny.pfm", "--range data");
    check_safe();
}
