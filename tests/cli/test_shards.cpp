// reliefbake run, merge and plan: a batch divided, put together, and handed to other runners.

#include "tests/cli/batch_folder.h"

#include <cstdlib>
#include <numeric>
#include <set>

#include <sys/wait.h>

using namespace reliefbake::test;
namespace fs = std::filesystem;

namespace {

/// Nine heights of three sizes, and a picture that is none.
fs::path sources() {
    const fs::path src = fresh_sources();
    fs::remove_all(work_folder() / "whole");
    for (int k = 0; k < 9; ++k) write_height(src / ("h" + std::to_string(k) + ".pgm"), k, 16 + 16 * (k % 3));
    write_text(src / "broken.png", "no picture");
    return src;
}

std::set<std::string> planned(const std::string& arguments, const std::string& environment = "") {
    const Outcome outcome = run_tool(arguments + " --dry-run", environment);
    CHECK(outcome.status == 0);
    std::set<std::string> ids;
    for (const nlohmann::json& event : events_in(outcome.out))
        if (event["event"] == "planned") ids.insert(event["id"].get<std::string>());
    return ids;
}

/// The lines of a ledger without what time and place decide.
std::map<std::string, nlohmann::json> ledger_of(const fs::path& out) {
    std::map<std::string, nlohmann::json> lines;
    std::istringstream text(bytes_of(out / ".reliefbake" / "ledger.jsonl"));
    for (std::string line; std::getline(text, line);) {
        nlohmann::json json = nlohmann::json::parse(line);
        json.erase("seconds");
        for (const char* files : {"inputs", "outputs"})
            if (json.contains(files))
                for (nlohmann::json& file : json[files]) file.erase("stamp");
        lines[json["id"]] = json;
    }
    return lines;
}

} // namespace

TEST_CASE("Shards have each asset once, for any N, and much the same work") {
    sources();
    const std::set<std::string> all = planned("batch src --out out");
    REQUIRE(all.size() == 10);
    for (const int count : {1, 2, 3, 7, 20}) {
        std::set<std::string> together;
        std::size_t sum = 0;
        for (int index = 0; index < count; ++index) {
            const std::set<std::string> shard = planned("run src --out out --shard " + std::to_string(index) + "/" + std::to_string(count));
            sum += shard.size();
            together.insert(shard.begin(), shard.end());
        }
        CHECK(sum == all.size());
        CHECK(together == all);
    }
}

TEST_CASE("Which shard: by the option, by Slurm, by Kubernetes; numbers that do not fit are refused") {
    sources();
    const std::set<std::string> second = planned("run src --out out --shard 1/3");
    CHECK(planned("run src --out out", "SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=0") == second);
    CHECK(planned("run src --out out", "SLURM_ARRAY_TASK_ID=5 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=4") == second);
    CHECK(planned("run src --out out --shards 3", "JOB_COMPLETION_INDEX=1") == second);
    const struct {
        const char *arguments, *environment;
    } refused[] = {{"", ""},
                   {"--shard 3/3", ""},
                   {"--shard -1/3", ""},
                   {"--shard 1", ""},
                   {"--shard 1/3x", ""},
                   {"--shards 3", ""},
                   {"--shard 1/3 --shards 3", ""},
                   {"", "JOB_COMPLETION_INDEX=1"},
                   {"--shards 3", "JOB_COMPLETION_INDEX=3"},
                   {"", "SLURM_ARRAY_TASK_ID=1"},
                   {"--shards 4", "SLURM_ARRAY_TASK_ID=1 SLURM_ARRAY_TASK_COUNT=3"},
                   {"", "SLURM_ARRAY_TASK_ID=7 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_MIN=0"},
                   {"", "SLURM_ARRAY_TASK_ID=one SLURM_ARRAY_TASK_COUNT=3"}};
    for (const auto& [arguments, environment] : refused) {
        CAPTURE(arguments, environment);
        CHECK(run_tool(std::string("run src --out out ") + arguments, environment).status == 2);
        CHECK_FALSE(fs::exists(work_folder() / "out"));
    }
}

TEST_CASE("Shards merged are what one run leaves: files, ledger, failures; and nothing is left to do") {
    sources();
    REQUIRE(batch("src --out whole").status == 3);
    for (const int index : {2, 0, 1}) {
        const int status = run_tool("run src --out out --shard " + std::to_string(index) + "/3").status;
        CHECK((status == 0 || status == 3));
    }
    const Outcome merged = run_tool("merge --out out --json");
    CHECK(merged.status == 3);
    const nlohmann::json summary = nlohmann::json::parse(merged.out);
    CHECK(schema_fault(summary, batch_schema("batch_summary")) == "");
    CHECK(summary["baked"] == 9);
    CHECK(summary["failed"] == 1);
    CHECK(summary == nlohmann::json::parse(bytes_of(work_folder() / "out" / ".reliefbake" / "summary.json")));
    CHECK(files_below(work_folder() / "out") == files_below(work_folder() / "whole"));
    CHECK(ledger_of(work_folder() / "out") == ledger_of(work_folder() / "whole"));
    CHECK_FALSE(fs::exists(work_folder() / "out" / ".reliefbake" / "shards"));
    const BatchRun again = batch("src --out out");
    CHECK(again.summary["baked"] == 0);
    CHECK(again.summary["unchanged"] == 9);
    CHECK(run_tool("merge --out out").status == 66); // merged already
}

TEST_CASE("merge names the shard that is missing or has not ended; a shard that was killed goes on") {
    sources();
    CHECK(run_tool("run src --out out --shard 0/2").status % 3 == 0);
    const Outcome missing = run_tool("merge --out out");
    CHECK(missing.status == 66);
    CHECK(missing.err.find("shard 1/2") != std::string::npos);
    // Killed while it bakes: no summary, though an earlier run had left one.
    CHECK(run_tool("run src --out out --shard 1/2").status % 3 == 0);
    fs::remove_all(work_folder() / "out" / "h0_cone.png");
    const int before = run_tool("run src --out out --shard 1/2 --dry-run").status;
    CHECK(before == 0);
    fs::remove(work_folder() / "out" / ".reliefbake" / "shards" / "1-of-2" / "summary.json");
    const Outcome ended = run_tool("merge --out out");
    CHECK(ended.status == 66);
    CHECK(ended.err.find("1-of-2") != std::string::npos);
    for (const char* shard : {"0/2", "1/2"}) CHECK(run_tool(std::string("run src --out out --shard ") + shard).status % 3 == 0);
    CHECK(run_tool("merge --out out").status == 3);
    CHECK(fs::exists(work_folder() / "out" / "h0_cone.png"));
}

TEST_CASE("plan's commands and build.ninja bake what batch bakes") {
    const fs::path src = sources();
    fs::remove(src / "broken.png");
    fs::rename(src / "h1.pgm", src / "it's $a name.pgm");
    REQUIRE(batch("src --out whole").status == 0);
    const auto shell = [](const std::string& line) { return std::system(("cd '" + work_folder().string() + "' && " + line + " >said 2>&1").c_str()); };
    REQUIRE(run_tool("plan src --out out --emit commands -o commands.txt").status == 0);
    REQUIRE(shell("sh commands.txt") == 0);
    CHECK(files_below(work_folder() / "out") == files_below(work_folder() / "whole"));
    if (std::system("command -v parallel >/dev/null") == 0) { // the workstation's way
        fs::remove_all(work_folder() / "out");
        REQUIRE(shell("parallel -j 2 <commands.txt") == 0);
        CHECK(files_below(work_folder() / "out") == files_below(work_folder() / "whole"));
    }
    if (std::system("command -v ninja >/dev/null") == 0) {
        fs::remove_all(work_folder() / "out");
        REQUIRE(run_tool("plan src --out out --emit ninja -o build.ninja").status == 0);
        REQUIRE(shell("ninja") == 0);
        std::map<std::string, std::string> files = files_below(work_folder() / "out");
        CHECK(files == files_below(work_folder() / "whole"));
        REQUIRE(shell("ninja >again && grep -q 'no work to do' again") == 0);
    }
}

TEST_CASE("plan writes a Slurm array and a Kubernetes job of run, with every word as it was given") {
    sources();
    const Outcome slurm = run_tool("plan src --out out --emit slurm --shards 4 --program '/opt/my tool'");
    CHECK(slurm.status == 0);
    CHECK(slurm.out.find("#SBATCH --array=0-3\n") != std::string::npos);
    CHECK(slurm.out.find("'/opt/my tool' run src --out out --shards 4") != std::string::npos);
    const Outcome k8s = run_tool("plan src --out out --emit k8s --shards 4 --image bakers/reliefbake:1 --claim textures");
    CHECK(k8s.status == 0);
    const nlohmann::json job = nlohmann::json::parse(k8s.out);
    CHECK(job["spec"]["completionMode"] == "Indexed");
    CHECK(job["spec"]["completions"] == 4);
    CHECK(job["spec"]["template"]["spec"]["containers"][0]["command"][2] == "reliefbake run src --out out --shards 4 || [ $? -eq 3 ]");
    for (const char* refused : {"--emit slurm", "--emit commands --shards 4", "--emit k8s --shards 4", "--emit ninja --image x", "--emit make", ""}) {
        CAPTURE(refused);
        CHECK(run_tool(std::string("plan src --out out ") + refused).status == 2);
    }
}
