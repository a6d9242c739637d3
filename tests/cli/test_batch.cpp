// reliefbake batch: which files become what, and what is refused before anything is written.

#include "tests/cli/batch_folder.h"

#include <set>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

fs::path out() { return work_folder() / "out"; }

std::set<std::string> names_below(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& [name, bytes] : files_below(folder)) names.insert(name);
    return names;
}

/// Refused with this status and these words, and nothing written.
void check_refused(const std::string& arguments, int status, const std::string& words) {
    CAPTURE(arguments);
    const BatchRun run = batch(arguments);
    CHECK(run.status == status);
    CHECK(run.err.find(words) != std::string::npos);
    CAPTURE(run.err);
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(out()));
}

} // namespace

TEST_CASE("A folder of heights, shapes, meshes and other files is baked by one command, as by many") {
    const fs::path src = fresh_sources();
    write_height(src / "a.pgm", 1);
    write_height(src / "wood" / "w_height.pgm", 2);
    write_height(src / "wood" / "w_albedo.pgm", 3);
    write_height(src / "wood" / "w_depth.pgm", 4);
    write_height(src / "wood" / "w_mask.pgm", 5);
    write_height(src / "shapes" / "s.pgm", 6);
    write_text(src / "m" / "mesh.obj", pyramid_mesh);
    write_text(src / "readme.md", "no image");
    write_height(src / ".hidden.pgm", 7);
    const BatchRun run = batch("src --out out");
    CHECK(run.err == "");
    REQUIRE(run.status == 0);
    CHECK(names_below(out()) == std::set<std::string>{"a_cone.png", "m/mesh_quadric.glb", "shapes/s_shape.png", "wood/w_depth_cone.png", "wood/w_height_cone.png", "wood/w_mask_shape.png"});
    CHECK(run.summary["event"] == "summary");
    CHECK(run.summary["baked"] == 6);
    CHECK(run.summary["skipped_files"] == 2);
    CHECK(run.ids("done").size() == 6);
    CHECK(schema_fault(nlohmann::json::parse(bytes_of(out() / ".reliefbake" / "summary.json")), batch_schema("batch_summary")) == "");

    const struct {
        const char *command, *name;
    } alone[] = {{"cone src/a.pgm", "a_cone.png"},           {"cone --input depth src/wood/w_depth.pgm", "wood/w_depth_cone.png"},
                 {"shape src/shapes/s.pgm", "shapes/s_shape.png"}, {"quadric src/m/mesh.obj", "m/mesh_quadric.glb"}};
    for (const auto& one : alone) {
        CAPTURE(one.command);
        const std::string file = "alone" + fs::path(one.name).extension().string();
        REQUIRE(run_tool(std::string(one.command) + " -o " + file + " --quiet").status == 0);
        CHECK(bytes_of(work_folder() / file) == bytes_of(out() / one.name));
    }
}

TEST_CASE("What is written does not depend on jobs, threads, memory, or the order of the disk") {
    const fs::path src = fresh_sources();
    for (int k = 0; k < 6; ++k) write_height(src / ("map" + std::to_string(k) + ".pgm"), k, 40 + 9 * k);
    write_text(src / "mesh.obj", pyramid_mesh);
    REQUIRE(batch("src --out out --jobs 1 --threads 1").status == 0);
    const auto expected = files_below(out());
    CHECK(expected.size() == 7);
    for (const char* limits : {"--jobs 1 --threads 4", "--jobs 4 --threads 4", "--jobs 3 --threads 2 --memory 400MB"}) {
        CAPTURE(limits);
        fs::remove_all(out());
        REQUIRE(batch(std::string("src --out out ") + limits).status == 0);
        CHECK(files_below(out()) == expected);
    }
}

TEST_CASE("Globs, lists and single files name sources") {
    const fs::path src = fresh_sources();
    for (const char* name : {"a.pgm", "b.pgm", "x/c.pgm", "x/y/d.pgm", "x/y/e.obj"}) write_height(src / name, 1);
    const auto ids = [&](const std::string& sources) {
        const BatchRun run = batch(sources + " --out out --dry-run");
        CHECK(run.status == 0);
        return run.ids("planned");
    };
    using Names = std::vector<std::string>;
    CHECK(ids("'src/*.pgm'") == Names{"a_cone.png", "b_cone.png"});
    CHECK(ids("'src/[b-z].pgm'") == Names{"b_cone.png"});
    CHECK(ids("'src/**/*.pgm'") == Names{"a_cone.png", "b_cone.png", "x/c_cone.png", "x/y/d_cone.png"});
    CHECK(ids("'src/x/**/d.*' src/a.pgm") == Names{"a_cone.png", "y/d_cone.png"});
    CHECK(ids("src src/a.pgm") == Names{"a_cone.png", "b_cone.png", "x/c_cone.png", "x/y/d_cone.png", "x/y/e_quadric.glb"});
    write_text(work_folder() / "list", "# these\nsrc/x/c.pgm\n\nsrc/a.pgm\r\n");
    CHECK(ids("@list") == Names{"src/a_cone.png", "src/x/c_cone.png"});
    CHECK(ids("src --name '{stem}.{from}.{kind}'").front() == "a.pgm.cone.png");
    CHECK_FALSE(fs::exists(out()));

    check_refused("src/none --out out", 66, "src/none: no such file or folder");
    check_refused("'src/*.exr' --out out", 66, "matches no file");
    write_text(work_folder() / "list", "src/a.pgm\nsrc/none.pgm\n");
    check_refused("@list --out out", 66, "list:2: no such file: src/none.pgm");
    check_refused("@nolist --out out", 66, "nolist");
    CHECK(batch("src --out src").status == 2);
    // An output folder among the sources is none of them.
    REQUIRE(batch("src --out src/baked").status == 3);
    CHECK(batch("src --out src/baked --dry-run").ids("planned").size() == 5);
}

TEST_CASE("A dry run says what, why and how long, and writes nothing") {
    const fs::path src = fresh_sources();
    write_height(src / "a.pgm", 1, 100);
    write_height(src / "b_albedo.pgm", 1);
    const BatchRun run = batch("src --out out --dry-run");
    REQUIRE(run.status == 0);
    CHECK_FALSE(fs::exists(out()));
    REQUIRE(run.events.size() == 3);
    CHECK(run.events[0]["event"] == "planned");
    CHECK(run.events[0]["bake"] == true);
    CHECK(run.events[0]["reason"] == "new");
    CHECK(run.events[0]["width"] == 100);
    CHECK(run.events[0]["seconds_predicted"] > 0);
    CHECK(run.events[0]["bytes_predicted"] > 100 * 100 * 24);
    CHECK(run.events[1]["event"] == "skipped");
    CHECK(run.events[2]["to_bake"] == 1);
    REQUIRE(batch("src --out out").status == 0);
    const BatchRun later = batch("src --out out --dry-run");
    CHECK(later.events[0]["bake"] == false);
    CHECK(later.events[0]["reason"] == "nothing changed");
    CHECK(later.summary["to_bake"] == 0);
}

TEST_CASE("Outputs that would collide, also by case, or overwrite an input, stop the batch before anything is written") {
    const fs::path src = fresh_sources();
    write_height(src / "a.pgm", 1);
    write_text(src / "a.obj", pyramid_mesh);
    CHECK(batch("src --out out --dry-run").status == 0);
    write_height(src / "a.ppm", 1);
    check_refused("src --out out", 2, "a_cone.png, baked from a.ppm");
    CHECK(batch("src --out out --name '{stem}_{from}_{kind}' --dry-run").status == 0);
    fs::remove(src / "a.ppm");
    write_height(src / "A.pgm", 2);
    check_refused("src --out out", 2, "would be baked from");
    fs::remove(src / "A.pgm");

    // An output that is an input, also through a link.
    write_text(work_folder() / "in-place.toml", "[[rule]]\nfiles = [\"*.pgm\"]\n[[rule.bake]]\nkind = \"cone\"\noutput = \"{stem}.png\"\n");
    fs::create_directories(src / "png");
    fs::copy(fs::path(RELIEFBAKE_TEST_DATA) / "heights" / "bevy_parallax_cube_depth_348.png", src / "a.png");
    fs::create_directory_symlink(src, work_folder() / "link");
    const std::string before = bytes_of(src / "a.png");
    const BatchRun run = batch("src/a.pgm src/a.png --out link --recipe in-place.toml");
    CHECK(run.status == 2);
    CHECK(run.err.find("is an input, and would be overwritten") != std::string::npos);
    CHECK(bytes_of(src / "a.png") == before);
    CHECK_FALSE(fs::exists(src / ".reliefbake"));
    fs::remove(work_folder() / "link");

    // Files of --relief and --mips count.
    write_height(src / "b.pgm", 2);
    write_text(work_folder() / "r.toml", "[[rule]]\nfiles = [\"*.pgm\"]\n[[rule.bake]]\nkind = \"acm\"\noptions = [\"--relief\", \"{out}/same.png\"]\noutput = \"{stem}.png\"\n");
    check_refused("src/a.pgm src/b.pgm --out out --recipe r.toml", 2, "same.png");
    write_text(work_folder() / "r.toml", "[[rule]]\nfiles = [\"*.pgm\"]\n[[rule.bake]]\nkind = \"acm\"\noptions = [\"--relief\", \"elsewhere.png\"]\noutput = \"{stem}.png\"\n");
    check_refused("src/a.pgm --out out --recipe r.toml", 2, "lies outside of --out");
}

TEST_CASE("Outputs stay in their folder, whatever links lie in it") {
    const fs::path src = fresh_sources();
    write_height(src / "x" / "a.pgm", 1);
    fs::create_directories(out());
    fs::remove_all(work_folder() / "elsewhere");
    fs::create_directories(work_folder() / "elsewhere");
    fs::create_directory_symlink(work_folder() / "elsewhere", out() / "x");
    const BatchRun run = batch("src --out out");
    CHECK(run.status == 2);
    CHECK(run.err.find("by a symbolic link") != std::string::npos);
    CHECK(names_below(work_folder() / "elsewhere").empty());
    CHECK_FALSE(fs::exists(out() / ".reliefbake"));
}

TEST_CASE("A recipe maps files to bakes with options; what is wrong with one is told with its line") {
    const fs::path src = fresh_sources();
    write_height(src / "roof_height.pgm", 1);
    write_height(src / "old" / "wall_height.pgm", 2);
    write_height(src / "logo.pgm", 3);
    write_text(work_folder() / "r.toml", R"(
[[rule]]
name = "old ones"
folders = ["OLD"]
skip = "replaced"

[[rule]]
suffixes = ["_HEIGHT"]
[[rule.bake]]
kind = "cone"
options = ["--encoding", "ratio", "--bits", "8"]
output = "maps/{stem}.tga"
[[rule.bake]]
kind = "bump"
options = ["--kind", "normal"]

[[rule]]
files = ["logo.*"]
[[rule.bake]]
kind = "shape"
output = "{stem}_{from}_{kind}.tif"
)");
    const BatchRun run = batch("src --out out --recipe r.toml");
    CHECK(run.err == "");
    REQUIRE(run.status == 0);
    CHECK(names_below(out()) == std::set<std::string>{"logo_pgm_shape.tif", "maps/roof_height.tga", "roof_height_bump.png"});
    CHECK(run.summary["skipped_files"] == 1);
    REQUIRE(run_tool("cone src/roof_height.pgm -o alone.tga --encoding ratio --bits 8 --quiet").status == 0);
    CHECK(bytes_of(work_folder() / "alone.tga") == bytes_of(out() / "maps" / "roof_height.tga"));

    fs::remove_all(out());
    const std::string rule = "[[rule]]\nfiles = [\"*\"]\n", bake = rule + "[[rule.bake]]\n";
    const struct {
        std::string text;
        const char* words;
        int status;
    } wrong[] = {
        {"x = 1", "r.toml:1: unknown key 'x'", 65},
        {"", "expected at least one [[rule]]", 65},
        {"[[rule]]\nfile = [\"*\"]", "r.toml:2: unknown key 'file'", 65},
        {rule, "expected either [[rule.bake]] or 'skip'", 65},
        {"[[rule]]\nskip = \"x\"", "expected some of 'files'", 65},
        {"[[rule]]\nfiles = []\nskip = \"x\"", "r.toml:2: 'files': is empty", 65},
        {"[[rule]]\nfiles = [1]\nskip = \"x\"", "r.toml:2: 'files': expected strings", 65},
        {bake + "kind = \"conic\"", "'kind': expected one of cone, acm", 65},
        {bake + "kind = \"cone\"\noutput = \"x.png\"", "lacks {stem}", 65},
        {bake + "kind = \"cone\"\noutput = \"../{stem}.png\"", "leaves the output folder", 65},
        {bake + "kind = \"cone\"\noutput = \"/{stem}.png\"", "is absolute", 65},
        {bake + "kind = \"cone\"\noutput = \"{stem}{size}.png\"", "unknown placeholder {size}; known are {stem}, {from}, {kind}", 65},
        {bake + "kind = \"cone\"\noptions = [\"{x\"]", "a brace without its partner", 65},
        {bake + "kind = \"cone\"\noptions = [\"--kin\", \"x\"]", "rule 1, for src/", 2},
        {bake + "kind = \"cone\"\noptions = [\"-o\", \"x.png\"]", "rule 1, for src/", 2},
        {bake + "kind = \"cone\"\noptions = [\"--bits\", \"float\"]", "rule 1, for src/", 2},
        {"[[rule]\n", "r.toml:1: ", 65},
    };
    for (const auto& one : wrong) {
        CAPTURE(one.text);
        write_text(work_folder() / "r.toml", one.text);
        check_refused("src --out out --recipe r.toml", one.status, one.words);
    }
    check_refused("src --out out --recipe none.toml", 66, "none.toml");
    CHECK(batch("src --out out --recipe r.toml --name '{stem}'").status == 2);
    check_refused("src --out out --name 'x'", 2, "lacks {stem}");
}

TEST_CASE("One bad file never stops the others; the exit code tells") {
    const fs::path src = fresh_sources();
    write_height(src / "a.pgm", 1);
    write_height(src / "z.pgm", 2);
    write_text(src / "broken.png", "\x89PNG\r\n\x1a\nnothing");
    write_text(src / "empty.exr", "");
    write_text(src / "bad.obj", "f 1 2 3\n");
    const BatchRun run = batch("src --out out");
    CHECK(run.status == 3);
    CHECK(run.err.find("3 of 5 assets failed") != std::string::npos);
    CHECK(names_below(out()) == std::set<std::string>{"a_cone.png", "z_cone.png"});
    CHECK(run.ids("failed") == std::vector<std::string>{"bad_quadric.glb", "broken_cone.png", "empty_cone.png"});
    CHECK(run.summary["failed"] == 3);
    CHECK(run.summary["failures"].size() == 3);
    for (const auto& failure : run.summary["failures"]) CHECK(failure["code"] == 65);

    // Again: failures are remembered, and cost nothing.
    const BatchRun again = batch("src --out out");
    CHECK(again.status == 3);
    CHECK(again.ids("start").empty());
    CHECK(again.summary["failed_before"] == 3);
    CHECK(again.summary["unchanged"] == 2);
    CHECK(batch("src --out out --retry-failed").ids("start").size() == 3);
    // Mended: only that one.
    write_height(src / "broken.png", 5);
    const BatchRun mended = batch("src --out out --keep-going");
    CHECK(mended.status == 3);
    CHECK(mended.ids("done") == std::vector<std::string>{"broken_cone.png"});
    CHECK(mended.summary["failed"] == 2);
}

TEST_CASE("--fail-fast starts nothing after a failure") {
    const fs::path src = fresh_sources();
    for (int k = 0; k < 20; ++k) write_height(src / ("small" + std::to_string(k) + ".pgm"), k);
    write_text(src / "broken.pgm", "P5\n2000 2000\n255\nshort"); // predicted to be the longest: comes first
    const BatchRun run = batch("src --out out --fail-fast --jobs 1");
    CHECK(run.status == 3);
    CHECK(run.summary["state"] == "stopped");
    CHECK(run.summary["failed"] == 1);
    CHECK(run.summary["not_started"] == 20);
    CHECK(batch("src --out out --fail-fast --keep-going").status == 2);
    const BatchRun all = batch("src --out out");
    CHECK(all.status == 3);
    CHECK(all.summary["baked"] == 20);
}

TEST_CASE("Memory is a ceiling; what never fits fails and is baked once it may") {
    const fs::path src = fresh_sources();
    write_height(src / "small.pgm", 1);
    write_height(src / "large.pgm", 2, 1500);
    const BatchRun run = batch("src --out out --memory 200MB");
    CHECK(run.status == 3);
    CHECK(run.ids("done") == std::vector<std::string>{"small_cone.png"});
    REQUIRE(run.summary["failures"].size() == 1);
    CHECK(run.summary["failures"][0]["code"] == 5);
    const BatchRun more = batch("src --out out");
    CHECK(more.status == 0);
    CHECK(more.ids("done") == std::vector<std::string>{"large_cone.png"});
    // A header that claims what no file holds is bad data, not a want of memory.
    write_text(src / "liar.pgm", "P5\n60000 60000\n255\n");
    const BatchRun liar = batch("src --out out --memory 400MB");
    CHECK(liar.summary["failures"][0]["code"] == 65);
}

TEST_CASE("A folder that another run holds, or that cannot be written, is refused") {
    const fs::path src = fresh_sources();
    write_height(src / "a.pgm", 1);
    REQUIRE(batch("src --out out").status == 0);
    const int lock = open((out() / ".reliefbake" / "lock").c_str(), O_RDWR);
    REQUIRE(flock(lock, LOCK_EX | LOCK_NB) == 0);
    const BatchRun busy = batch("src --out out");
    CHECK(busy.status == 75);
    CHECK(busy.err.find("another run holds the folder") != std::string::npos);
    CHECK(batch("src --out out --dry-run").status == 0);
    close(lock);
    CHECK(batch("src --out out").status == 0);
    write_text(work_folder() / "file", "");
    CHECK(batch("src --out file").status == 73);
    CHECK(batch("src --out /proc/none").status == 73);
}

TEST_CASE("The revision of the ledger stands for these bytes") {
    // Where this fails, a command writes other bytes than before: raise bytes_revision (cli/batch/algorithm_version.h), so that
    // batches bake again, and put the new hashes here.
    const fs::path src = fresh_sources();
    fs::copy(fs::path(RELIEFBAKE_TEST_DATA) / "heights" / "gz_dem_squared_129.tif", src / "dem.tif");
    write_text(src / "mesh.obj", pyramid_mesh);
    std::string rules = "[[rule]]\nfiles = [\"*.obj\"]\n[[rule.bake]]\nkind = \"quadric\"\n[[rule]]\nfiles = [\"*\"]\n";
    for (const char* kind : {"cone", "acm", "cone-normal", "cone-stack", "shape", "bump"}) rules += std::string("[[rule.bake]]\nkind = \"") + kind + "\"\n";
    write_text(work_folder() / "all.toml", rules);
    REQUIRE(batch("src --out out --recipe all.toml").status == 0);
    std::map<std::string, std::string> hashes;
    std::istringstream lines(bytes_of(out() / ".reliefbake" / "ledger.jsonl"));
    std::string revision;
    for (std::string line; std::getline(lines, line);) {
        const nlohmann::json asset = nlohmann::json::parse(line);
        revision = asset["algorithm"];
        hashes[asset["id"]] = asset["outputs"][0]["hash"];
    }
    CHECK(revision == "0.1.0+1");
    const std::map<std::string, std::string> known{
        {"dem_acm.exr", "d33758935fac359aaaeb25b621ee5053"},
        {"dem_bump.png", "f68b46704952f8544e1364345fe7e3c4"},
        {"dem_cone-normal.png", "e4b36fa500499ca58f1e888bf9eb7d3c"},
        {"dem_cone-stack.exr", "64ea568691f5ddf6fcb28449243e86d6"},
        {"dem_cone.png", "f47c32b26d824dba3da8997db49a082f"},
        {"dem_shape.png", "6a409712e704bf31dcfae3210e842617"},
        {"mesh_quadric.glb", "5c5e8886cd04417dfba8983944a5eb0e"}};
    CHECK(hashes == known);
}

TEST_CASE("--report shows every asset and failure on one page, the worst first") {
    const fs::path src = fresh_sources();
    fs::remove(work_folder() / "page.html");
    for (const char* name : {"a_height.pgm", "b_height.pgm"}) write_height(src / name, 3, 64);
    write_text(src / "broken.png", "no picture");
    write_height(src / "s_mask.pgm", 5);
    write_height(src / "n_bump.pgm", 6);
    write_text(work_folder() / "r.toml", "[[rule]]\nfiles = ['n_*']\n[[rule.bake]]\nkind = 'bump'\noutput = '{stem}.png'\n"
                                         "[[rule]]\nfiles = ['b_*']\n[[rule.bake]]\nkind = 'cone'\noptions = ['--surface', 'texel', '--wrap', 'repeat']\noutput = '{stem}.png'\n"
                                         "[[rule]]\nfiles = ['*_mask.*']\n[[rule.bake]]\nkind = 'shape'\noutput = '{stem}.png'\n"
                                         "[[rule]]\nfiles = ['*']\n[[rule.bake]]\nkind = 'cone'\noutput = '{stem}.png'\n");
    const BatchRun run = batch("src --out out --recipe r.toml --report page.html");
    CAPTURE(run.err);
    REQUIRE(run.status == 3);
    const std::string page = bytes_of(work_folder() / "page.html");
    CHECK(std::system(("xmllint --nonet --noout '" + (work_folder() / "page.html").string() + "'").c_str()) == 0);
    CHECK(page.find("4 baked") != std::string::npos);
    CHECK(page.find("<td>broken.png</td>") != std::string::npos);
    const std::string assets = page.substr(page.find("worst first"));
    const std::size_t a = assets.find("<td>a_height.png</td>"), b = assets.find("<td>b_height.png</td>"), s = assets.find("<td>s_mask.png</td>");
    REQUIRE((a != assets.npos && b != assets.npos && s != assets.npos));
    CHECK(b < a); // cones of texel centres let rays pass between them
    CHECK(assets.find("not_conservative", b) < a);
    CHECK(assets.find("<td>holds</td>", assets.find("<td>n_bump.png</td>")) < assets.npos);
    CHECK(assets.find("not judged") == assets.npos);
    std::size_t thumbnails = 0;
    for (std::size_t at = 0; (at = assets.find("data:image/png;base64,", at)) != assets.npos; ++at) ++thumbnails;
    CHECK(thumbnails == 4);
    // Nothing is baked again for a page, and it may not replace a file of the batch.
    CHECK(batch("src --out out --recipe r.toml --report page.html").summary["unchanged"] == 4);
    CHECK(run_tool("batch src --out out --recipe r.toml --report out/a_height.png").status == 2);
    CHECK(run_tool("batch src --out out --recipe r.toml --report src/a_height.pgm").status == 2);
    CHECK(run_tool("batch src --out out --recipe r.toml --report none/page.html").status == 73);
}
