#pragma once
// A folder of sources, a batch over it, and what it told.

#include "tests/cli/json_schema.h"
#include "tests/cli/make_input.h"
#include "tests/cli/run_tool.h"

#include <catch2/catch.hpp>

#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace reliefbake::test {

using Events = std::vector<nlohmann::json>;

inline nlohmann::json batch_schema(const std::string& name) {
    return nlohmann::json::parse(bytes_of(std::filesystem::path(RELIEFBAKE_SCHEMA_DIR) / (name + ".schema.json")));
}

/// Each line as JSON that fits the schema.
inline Events events_in(const std::string& text) {
    static const nlohmann::json schema = batch_schema("batch_event");
    Events events;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        events.push_back(nlohmann::json::parse(line));
        CHECK(schema_fault(events.back(), schema) == "");
    }
    return events;
}

struct BatchRun {
    int status;
    std::string err;
    Events events;
    nlohmann::json summary; ///< the last event
    /// Ids of the events of this name.
    std::vector<std::string> ids(const std::string& event) const {
        std::vector<std::string> found;
        for (const nlohmann::json& one : events)
            if (one["event"] == event) found.push_back(one["id"]);
        std::sort(found.begin(), found.end());
        return found;
    }
};

inline BatchRun batch(const std::string& arguments, const std::string& environment = "") {
    const Outcome outcome = run_tool("batch " + arguments, environment);
    BatchRun run{outcome.status, outcome.err, events_in(outcome.out), {}};
    if (!run.events.empty()) run.summary = run.events.back();
    return run;
}

/// Every file below a folder but those of .reliefbake, with its bytes.
inline std::map<std::string, std::string> files_below(const std::filesystem::path& folder) {
    std::map<std::string, std::string> files;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().lexically_relative(folder).string();
        if (entry.is_regular_file() && !name.starts_with(".reliefbake/")) files[name] = bytes_of(entry.path());
    }
    return files;
}

/// A small height map; another seed, another map.
inline void write_height(const std::filesystem::path& path, int seed, int side = 24) {
    std::filesystem::create_directories(path.parent_path());
    write_pgm(path, side, side, [&](int x, int y) { return (x * x * (seed + 3) + y * y * 7 + x * y * seed) % 251; });
}

inline void write_text(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

/// Empty folders src and out in the work folder.
inline std::filesystem::path fresh_sources() {
    for (const char* name : {"src", "out"}) std::filesystem::remove_all(work_folder() / name);
    std::filesystem::create_directories(work_folder() / "src");
    return work_folder() / "src";
}

inline const std::string pyramid_mesh = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 0.7\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 1\n";

} // namespace reliefbake::test
