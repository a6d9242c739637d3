#include "cli/options/thread_option.h"

#include "bake/parallel.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string_view>

namespace reliefbake {

namespace {

constexpr int most_threads = 1024;

std::optional<int> parse_count(std::string_view text) {
    int count = 0;
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error != std::errc() || rest != text.data() + text.size() || count < 0 || count > most_threads)
        return {};
    return count;
}

/// The process's cgroup below `/sys/fs/cgroup` (cgroup v2: the line "0::/path" of /proc/self/cgroup).
std::string cgroup_path() {
    std::ifstream file("/proc/self/cgroup");
    for (std::string line; std::getline(file, line);)
        if (line.rfind("0::", 0) == 0) return line.substr(3);
    return "/";
}

/// CPUs that one cgroup directory grants: cgroup v2's cpu.max ("quota period" in microseconds, or "max").
double quota_of(const std::string& directory) {
    std::ifstream file(directory + "/cpu.max");
    double quota = 0, period = 0;
    if (file >> quota >> period && quota > 0 && period > 0) return quota / period;
    return HUGE_VAL;
}

/// The smallest quota of the process's cgroup and of those above it.
double cgroup_cpus() {
    double cpus = HUGE_VAL;
    std::string path = cgroup_path();
    while (true) {
        cpus = std::min(cpus, quota_of("/sys/fs/cgroup" + path));
        if (path.empty() || path == "/") return cpus;
        path.erase(path.find_last_of('/'));
    }
}

int granted_threads() {
    return int(std::max(1.0, std::min(double(available_threads()), std::ceil(cgroup_cpus()))));
}

} // namespace

void add_thread_option(CLI::App& app, int& threads) {
    app.add_option("--threads", threads, "Threads (default: RELIEFBAKE_THREADS, or what the process may use)")
        ->check(CLI::Range(1, most_threads))
        ->type_name("N");
}

Result<int> resolve_threads(int flag) {
    if (flag > 0) return flag;
    for (const char* name :
         {"RELIEFBAKE_THREADS", "OPENIMAGEIO_THREADS", "CUE_THREADS", "SLURM_CPUS_PER_TASK"}) {
        const char* text = std::getenv(name);
        if (!text || !*text) continue;
        const std::optional<int> count = parse_count(text);
        if (!count)
            return fail(ErrorCode::usage, std::string("environment variable ") + name +
                                              ": expected a number from 0 to 1024, found '" + text + "'");
        if (*count > 0) return *count;
    }
    return granted_threads();
}

} // namespace reliefbake
