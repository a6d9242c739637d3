// reliefbake batch: what a second run does.

#include "tests/cli/batch_folder.h"

#include <thread>

#include <fcntl.h>
#include <sys/stat.h>

using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

fs::path out() { return work_folder() / "out"; }

/// Three maps and a mesh, baked.
fs::path baked_sources() {
    const fs::path src = fresh_sources();
    for (int k = 0; k < 3; ++k) write_height(src / ("map" + std::to_string(k) + ".pgm"), k);
    write_text(src / "mesh.obj", pyramid_mesh);
    REQUIRE(batch("src --out out").summary["baked"] == 4);
    return src;
}

/// The ids that a run bakes, which ends well.
Names rebaked(const std::string& arguments = "src --out out") {
    const BatchRun run = batch(arguments);
    CHECK(run.err == "");
    CHECK(run.status == 0);
    return run.ids("done");
}

std::size_t ledger_lines() {
    const std::string text = bytes_of(out() / ".reliefbake" / "ledger.jsonl");
    return std::size_t(std::count(text.begin(), text.end(), '\n'));
}

void touch(const fs::path& file) { fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::hours(1)); }

} // namespace

TEST_CASE("A second run bakes nothing; touched files are not baked again") {
    const fs::path src = baked_sources();
    const auto before = files_below(out());
    CHECK(rebaked().empty());
    for (const auto& entry : fs::directory_iterator(src)) touch(entry.path());
    for (const char* name : {"map0_cone.png", "mesh_quadric.glb"}) touch(out() / name);
    CHECK(rebaked().empty());
    const std::size_t lines = ledger_lines();
    CHECK(rebaked().empty()); // stamps are renewed: nothing is read, nothing recorded
    CHECK(ledger_lines() == lines);
    CHECK(files_below(out()) == before);
}

TEST_CASE("A changed byte bakes what depends on it, and nothing else") {
    const fs::path src = baked_sources();
    const auto before = files_below(out());
    write_height(src / "map1.pgm", 9);
    CHECK(rebaked() == Names{"map1_cone.png"});
    auto after = files_below(out());
    CHECK(after["map1_cone.png"] != before.at("map1_cone.png"));
    write_height(src / "map1.pgm", 1);
    CHECK(rebaked() == Names{"map1_cone.png"});
    CHECK(files_below(out()) == before);

    // The same size and the same time of change: the file system's own time tells.
    struct stat status {};
    REQUIRE(stat((src / "map2.pgm").c_str(), &status) == 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    write_height(src / "map2.pgm", 8);
    const timespec times[2] = {status.st_atim, status.st_mtim};
    REQUIRE(utimensat(AT_FDCWD, (src / "map2.pgm").c_str(), times, 0) == 0);
    CHECK(rebaked() == Names{"map2_cone.png"});

    // Other bytes that decode alike: a comment in the header.
    std::string pgm = bytes_of(src / "map0.pgm");
    write_text(src / "map0.pgm", pgm.replace(0, 3, "P5\n# a comment\n"));
    CHECK(rebaked().empty());
    write_text(src / "mesh.obj", "# moved\n" + pyramid_mesh + "v 3 3 3\n");
    CHECK(rebaked() == Names{"mesh_quadric.glb"});
}

TEST_CASE("Files beside the input count: an alpha, a glTF's buffer") {
    const fs::path src = fresh_sources();
    write_height(src / "a.pgm", 1);
    write_height(src / "b.pgm", 2);
    write_height(src / "a_holes.pgm", 3);
    write_height(src / "b_holes.pgm", 4);
    write_text(work_folder() / "r.toml", "[[rule]]\nsuffixes = [\"_holes\"]\nskip = \"an alpha\"\n[[rule]]\nfiles = [\"*.pgm\"]\n[[rule.bake]]\nkind = \"cone\"\n"
                                         "options = [\"--alpha\", \"{folder}/{stem}_holes.pgm\"]\n");
    CHECK(rebaked("src --out out --recipe r.toml").size() == 2);
    write_height(src / "b_holes.pgm", 5);
    CHECK(rebaked("src --out out --recipe r.toml") == Names{"b_cone.png"});

    fs::remove_all(src / "a.pgm");
    write_text(src / "mesh.obj", pyramid_mesh);
    REQUIRE(run_tool("quadric src/mesh.obj -o whole.gltf --quiet").status == 0);
    nlohmann::json document = nlohmann::json::parse(bytes_of(work_folder() / "whole.gltf"));
    const std::string uri = document["buffers"][0]["uri"];
    document["buffers"][0]["uri"] = "data%20file.bin";
    fs::create_directories(work_folder() / "src" / "gltf");
    write_text(src / "gltf" / "m.gltf", document.dump());
    write_text(work_folder() / "base64", uri.substr(uri.find(',') + 1));
    REQUIRE(std::system(("cd '" + work_folder().string() + "' && base64 -d base64 > 'src/gltf/data file.bin'").c_str()) == 0);
    CHECK(rebaked("'src/gltf/*.gltf' --out out") == Names{"m_quadric.glb"});
    CHECK(rebaked("'src/gltf/*.gltf' --out out").empty());
    std::string buffer = bytes_of(src / "gltf" / "data file.bin");
    buffer[2] = char(buffer[2] ^ 64);
    write_text(src / "gltf" / "data file.bin", buffer);
    CHECK(rebaked("'src/gltf/*.gltf' --out out") == Names{"m_quadric.glb"});
}

TEST_CASE("Moved folders bake nothing") {
    baked_sources();
    for (const char* name : {"src2", "out2"}) fs::remove_all(work_folder() / name);
    fs::rename(work_folder() / "src", work_folder() / "src2");
    fs::rename(out(), work_folder() / "out2");
    CHECK(rebaked("src2 --out out2").empty());
    fs::copy(work_folder() / "src2", work_folder() / "src", fs::copy_options::recursive);
    fs::copy(work_folder() / "out2", out(), fs::copy_options::recursive);
    CHECK(rebaked("'" + (work_folder() / "src").string() + "' --out '" + out().string() + "'").empty());
}

TEST_CASE("Outputs that vanished or were edited are baked again") {
    baked_sources();
    const auto before = files_below(out());
    fs::remove(out() / "map0_cone.png");
    std::string bytes = before.at("map1_cone.png");
    bytes[bytes.size() / 2] = char(bytes[bytes.size() / 2] ^ 1);
    write_text(out() / "map1_cone.png", bytes);
    write_text(out() / "mesh_quadric.glb", "");
    const BatchRun run = batch("src --out out");
    CHECK(run.ids("done") == Names{"map0_cone.png", "map1_cone.png", "mesh_quadric.glb"});
    CHECK(files_below(out()) == before);
}

TEST_CASE("Other options bake again; those given at their default do not, nor those that change no byte") {
    fresh_sources();
    write_height(work_folder() / "src" / "a.pgm", 1);
    const auto recipe = [](const std::string& options) {
        write_text(work_folder() / "r.toml", "[[rule]]\nfiles = [\"*\"]\n[[rule.bake]]\nkind = \"cone\"\noptions = [" + options + "]\n");
        return "src --out out --recipe r.toml";
    };
    write_text(work_folder() / "r.toml", "[[rule]]\nfiles = [\"*\"]\n[[rule.bake]]\nkind = \"cone\"\n");
    CHECK(rebaked("src --out out --recipe r.toml").size() == 1);
    CHECK(rebaked(recipe("\"--encoding\", \"sqrt\", \"--max-bytes\", \"1GB\"")).empty());
    CHECK(rebaked(recipe("\"--encoding\", \"ratio\"")).size() == 1);
    CHECK(rebaked(recipe("\"--depth-uv\", \"0.2\", \"--encoding\", \"ratio\"")).size() == 1);
    CHECK(rebaked(recipe("\"--encoding\", \"ratio\", \"--depth-uv\", \"0.20\"")).empty());
}

TEST_CASE("A ledger that is torn, damaged or from elsewhere costs bakes, never a fault") {
    baked_sources();
    const fs::path ledger = out() / ".reliefbake" / "ledger.jsonl";
    const std::string whole = bytes_of(ledger);
    // Torn in the middle of its last line: that asset alone is baked.
    write_text(ledger, whole.substr(0, whole.size() - 20));
    CHECK(rebaked().size() == 1);
    CHECK(rebaked().empty());
    for (const std::string& text : {std::string("nonsense\n\n{}\n[1]\n{\"ledger\": 1}\n"), std::string("\0\0\0\n", 4), std::string("{\"ledger\": 2}\n")}) {
        write_text(ledger, text);
        CHECK(rebaked().size() == 4);
    }
    // Many lines of one asset become one.
    std::string many;
    for (int k = 0; k < 40; ++k) many += whole;
    write_text(ledger, many);
    CHECK(rebaked().empty());
    CHECK(ledger_lines() <= 8); // four, and as many new stamps
}

TEST_CASE("A cache gives other folders and machines what is baked once") {
    const fs::path src = baked_sources();
    const auto expected = files_below(out());
    fs::remove_all(work_folder() / "cache");
    fs::remove_all(out());
    CHECK(rebaked("src --out out --cache cache").size() == 4);
    fs::remove_all(out());
    const BatchRun run = batch("src --out out --cache cache");
    CHECK(run.summary["from_cache"] == 4);
    CHECK(run.summary["baked"] == 0);
    CHECK(files_below(out()) == expected);
    CHECK(rebaked("src --out out").empty());

    // Under another name, too.
    fs::rename(src / "map0.pgm", src / "other.pgm");
    CHECK(batch("src --out out --cache cache").summary["from_cache"] == 1);
    CHECK(bytes_of(out() / "other_cone.png") == expected.at("map0_cone.png"));
    fs::rename(src / "other.pgm", src / "map0.pgm");

    // Damaged entries are as good as none, and are mended.
    for (const auto& entry : fs::recursive_directory_iterator(work_folder() / "cache"))
        if (entry.is_regular_file()) write_text(entry.path(), bytes_of(entry.path()).substr(1));
    fs::remove_all(out());
    CHECK(batch("src --out out --cache cache").summary["baked"] == 4);
    CHECK(files_below(out()) == expected);
    fs::remove_all(out());
    CHECK(batch("src --out out --cache cache").summary["from_cache"] == 4);
    CHECK(files_below(out()) == expected);

    // One that cannot be written costs nothing but itself.
    write_text(work_folder() / "file", "");
    fs::remove_all(out());
    const BatchRun without = batch("src --out out --cache file");
    CHECK(without.status == 0);
    CHECK(without.summary["baked"] == 4);
    CHECK(without.summary["notes"].size() == 4);
}
