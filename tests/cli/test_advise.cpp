// reliefbake advise, from outside, on maps that it has never seen.

#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <set>

using namespace reliefbake::test;
using nlohmann::json;

namespace {

const std::string few_rays = " --rays 3500 ";

/// Compiling shaders takes longer than measuring such small maps: keep them from run to run.
Outcome run(const std::string& arguments, const std::string& environment = "") {
    return run_tool(arguments, environment + " MESA_SHADER_CACHE_DISABLE=false MESA_SHADER_CACHE_DIR='" + (work_folder() / "shaders").string() + "'");
}

json json_of(const std::string& text) {
    const json parsed = json::parse(text, nullptr, false);
    REQUIRE_FALSE(parsed.is_discarded());
    return parsed;
}

/// Waves, blocks and noise in proportions that the seed decides.
void write_random_field(const std::string& name, unsigned seed, int side) {
    std::mt19937 random(seed);
    const auto part = [&] { return double(random() % 1001) / 1000; };
    const double waves = part(), blocks = part(), noise = part() * part(), u = 1 + random() % 4, v = 1 + random() % 4, total = waves + blocks + noise + 1e-9;
    const int block = 3 + int(random() % 9);
    std::mt19937 heights(seed + 1);
    write_pgm(work_folder() / name, side, side, [&](int x, int y) {
        const double turn = 6.283185307179586 / side;
        const double wave = 0.5 + 0.5 * std::sin(u * turn * x) * std::cos(v * turn * y);
        const double high = ((x / block) * 7 + (y / block) * 13) % 5 / 4.0;
        return int(255 * (waves * wave + blocks * high + noise * double(heights() % 1001) / 1000) / total);
    });
}

/// The answer's figures on the whole, and that what is printed holds together.
const json& checked_answer(const json& result, double missed, double error, int steps, double bytes) {
    const json& answer = result["answer"];
    const json& trial = result["trials"][answer["trial"].get<std::size_t>()];
    CHECK(trial["candidate"]["id"] == answer["id"]);
    CHECK(trial["stage"] == "proof");
    CHECK(trial["faults"].empty());
    const json& f = trial["figures"];
    CHECK(f["rays"].get<int>() > 1000);
    CHECK(f["missed"].get<double>() <= missed);
    CHECK(f["error_mean"].get<double>() <= error);
    CHECK(f["steps_max"].get<int>() <= steps);
    CHECK(f["bytes_per_texel"].get<double>() <= bytes);
    return trial;
}

/// What `tradeoff` measures for the march over the baked map, on the surface that the map stores.
json judged_by_tradeoff(const std::string& map, const json& answer, const json& candidate, const std::string& folder) {
    const std::string refinements = candidate["refinements"].is_null() ? "" : " --refinements " + candidate["refinements"].dump();
    const Outcome ran = run("tradeoff " + map + " --techniques " + answer["method"].get<std::string>() + " --steps " + candidate["steps"].dump() + refinements + few_rays + " --angle 75 --repeat 1 --json -o " + folder);
    REQUIRE(ran.status == 0);
    const json result = json_of(ran.out);
    REQUIRE(result["inputs"][0]["measurements"].size() == 1);
    return result["inputs"][0]["measurements"][0]["figures"];
}

} // namespace

TEST_CASE("what is advised for a map never seen meets its budget, and is baked as it was measured") {
    const json schema = json_of(bytes_of(RELIEFBAKE_SCHEMA_DIR "/advise.schema.json"));
    std::set<std::string> methods;
    for (unsigned seed = 1; seed <= 3; ++seed) {
        const std::string name = "field" + std::to_string(seed);
        write_random_field(name + ".pgm", seed, 33 + 7 * int(seed));
        const double missed = seed % 2 ? 0 : 0.02, error = seed % 2 ? 0.004 : 0.03;
        const Outcome ran = run("advise " + name + ".pgm --max-missed " + std::to_string(missed) + " --max-error " + std::to_string(error) +
                                     " --angle 75deg --steps 64 --bytes-per-texel 8 --json --apply -o " + name + ".png" + few_rays);
        CAPTURE(seed, ran.err, ran.out.substr(0, 1000));
        REQUIRE(ran.status == 0);
        CHECK(ran.err == "");
        const json result = json_of(ran.out);
        CHECK(schema_fault(result, schema) == "");
        CHECK(result["applied"] == name + ".png");
        CHECK(result["budget"]["angle"] == 75);
        const json& trial = checked_answer(result, missed, error, 64, 8);
        methods.insert(result["answer"]["method"].get<std::string>());

        // The file is what the printed command bakes, and judged apart, on the 8-bit surface that it stores, it errs as much.
        REQUIRE(run(result["answer"]["bake"].get<std::string>() + " " + name + ".pgm -o again.png --quiet").status == 0);
        CHECK(bytes_of(work_folder() / "again.png") == bytes_of(work_folder() / (name + ".png")));
        if (trial["candidate"]["resolution"] != 1) continue; // another surface than the source's
        const json figures = judged_by_tradeoff(name + ".png", result["answer"], trial["candidate"], "judged" + std::to_string(seed));
        CHECK(figures["missed"].get<double>() == Approx(trial["figures"]["missed"].get<double>()).margin(0.001));
        CHECK(figures["error_mean"].get<double>() == Approx(trial["figures"]["error_mean"].get<double>()).margin(0.0001));
    }
    CHECK(methods.size() >= 2);
}

TEST_CASE("a loosened budget is never dearer, and a budget that cannot be met says what comes nearest") {
    write_random_field("field.pgm", 9, 48);
    double bytes = 0, reads = 0;
    for (const char* error : {"0.00001", "0.004", "0.04"}) {
        const Outcome ran = run(std::string("advise field.pgm --max-missed 0 --steps 64 --json --max-error ") + error + few_rays);
        const json result = json_of(ran.out);
        CAPTURE(error, ran.err);
        const bool met = result["met"].get<bool>();
        CHECK(ran.status == (met ? 0 : 5));
        if (met) {
            const json& f = checked_answer(result, 0, std::stod(error), 64, 1e9)["figures"];
            const double next_bytes = f["bytes_per_texel"].get<double>(), next_reads = f["fetches_mean"].get<double>();
            if (bytes > 0) CHECK((next_bytes < bytes || (next_bytes == bytes && next_reads <= reads)));
            bytes = next_bytes, reads = next_reads;
        }
    }
    CHECK(bytes > 0);

    const Outcome none = run("advise field.pgm --max-missed 0 --max-error 0.000001 --steps 4 --bytes-per-texel 4 --json --apply -o none.png" + few_rays);
    CHECK(none.status == 5);
    CHECK(std::count(none.err.begin(), none.err.end(), '\n') == 1);
    CHECK(none.err.find("field.pgm: the budget cannot be met") != std::string::npos);
    const json result = json_of(none.out);
    CHECK(schema_fault(result, json_of(bytes_of(RELIEFBAKE_SCHEMA_DIR "/advise.schema.json"))) == "");
    CHECK(result["answer"].is_null());
    CHECK(none.err.find(result["nearest"]["id"].get<std::string>()) != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(work_folder() / "none.png"));

    const Outcome bytes_alone = run("advise field.pgm --max-missed 0.01 --max-error 0.01 --bytes-per-texel 0.1");
    CHECK(bytes_alone.status == 5);
    CHECK(bytes_alone.err.find("the nearest is 0.188") != std::string::npos);
}

TEST_CASE("a large map is screened on a crop, and what is advised proven on the whole") {
    write_random_field("large.pgm", 5, 96);
    const std::string arguments = "advise large.pgm --max-missed 0.01 --max-error 0.01 --bytes-per-texel 4 --crop 16" + few_rays;
    const Outcome ran = run(arguments + " --json");
    CAPTURE(ran.err);
    REQUIRE(ran.status == 0);
    const json result = json_of(ran.out);
    CHECK(result["crop"] == 16);
    checked_answer(result, 0.01, 0.01, 128, 4);
    std::set<std::string> stages;
    for (const json& trial : result["trials"]) stages.insert(trial["stage"].get<std::string>());
    CHECK(stages == std::set<std::string>{"screen", "proof"});
    const Outcome text = run(arguments);
    CHECK(text.out.find("on a crop of 16 x 16") != std::string::npos);
    for (const char* word : {"take ", "runner-up", "the others:", "linear", "max-mip"}) CHECK(text.out.find(word) != std::string::npos);
    CHECK(run(arguments, "RELIEFBAKE_THREADS=1").out == text.out);
}

TEST_CASE("a target and an output allow only what they can hold and follow") {
    write_random_field("field.pgm", 9, 40);
    const std::string budget = "advise field.pgm --max-missed 0.01 --max-error 0.02 --json" + few_rays;
    for (const std::string target : {"glsl-es", "hlsl"}) {
        const Outcome ran = run(budget + " --target " + target + " --apply -o target.tif");
        CAPTURE(target, ran.err);
        REQUIRE(ran.status == 0);
        const json result = json_of(ran.out);
        CHECK(result["target"] == target);
        for (const json& trial : result["trials"]) {
            const json& candidate = trial["candidate"];
            if (target == "hlsl") CHECK((!candidate["family"].is_null() && !candidate["exact_finish"].get<bool>()));
            else CHECK((candidate["bits"] == "8" || candidate["bits"] == "half"));
        }
        if (target == "hlsl") CHECK(run("shader --for target.tif --language hlsl").status == 0);
    }
    const Outcome exr = run(budget + " --apply -o field.exr");
    REQUIRE(exr.status == 0);
    const json result = json_of(exr.out);
    for (const json& trial : result["trials"]) CHECK((trial["candidate"]["bits"] == "half" || trial["candidate"]["bits"] == "float"));
}

TEST_CASE("what advise cannot do is refused in a line") {
    write_random_field("field.pgm", 9, 20);
    REQUIRE(run("cone field.pgm -o baked.png --quiet").status == 0);
    const auto refused = [](const std::string& arguments, const std::string& expected, int status = 2) {
        const Outcome ran = run("advise " + arguments);
        CAPTURE(arguments, ran.err);
        CHECK(ran.status == status);
        CHECK(ran.out == "");
        CHECK(ran.err.find(expected) != std::string::npos);
    };
    const std::string budget = " --max-missed 0.01 --max-error 0.01";
    refused("field.pgm", "--max-");
    refused("field.pgm --max-missed 0.01", "--max-error");
    refused("field.pgm --max-missed 2 --max-error 0.01", "--max-missed");
    refused("field.pgm --max-missed 0.01 --max-error 0", "--max-error");
    refused("field.pgm --max-missed 0.01 --max-error nan", "--max-error");
    refused("field.pgm --max-missed 0.000001 --max-error 0.01", "cannot tell so small a share");
    refused("field.pgm --steps 0" + budget, "--steps");
    refused("field.pgm --bytes-per-texel 0" + budget, "--bytes-per-texel");
    refused("field.pgm --angle 90deg" + budget, "--angle");
    refused("field.pgm --angle 80rad" + budget, "80rad");
    refused("field.pgm --target metal" + budget, "found 'metal'");
    refused("field.pgm --crop 8" + budget, "--crop");
    refused("field.pgm --apply" + budget, "--output");
    refused("field.pgm -o a.png" + budget, "--apply");
    refused("field.pgm --apply -o a.dds" + budget, "found 'a.dds'");
    refused("field.pgm --apply -o absent/a.png" + budget, "absent/a.png", 73);
    refused("absent.pgm" + budget, "absent.pgm", 66);
    refused("baked.png" + budget, "is a map that is baked");
    refused("baked.png --apply -o baked.png" + budget, "is the input file");
}
