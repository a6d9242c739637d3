#include "cli/batch/available_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace reliefbake {

namespace {

std::uint64_t number_in(const std::string& file, std::uint64_t otherwise) {
    std::ifstream stream(file);
    std::uint64_t number = 0;
    return stream >> number ? number : otherwise; // cgroup v2 says "max" for no limit
}

/// What the process's cgroup and those above it (cgroup v2) still grant.
std::uint64_t cgroup_memory() {
    constexpr std::uint64_t boundless = ~std::uint64_t(0);
    std::ifstream groups("/proc/self/cgroup");
    std::string path;
    for (std::string line; std::getline(groups, line);)
        if (line.starts_with("0::")) path = line.substr(3);
    std::uint64_t least = boundless;
    while (true) {
        const std::string folder = "/sys/fs/cgroup" + path;
        const std::uint64_t most = number_in(folder + "/memory.max", boundless), used = number_in(folder + "/memory.current", 0);
        if (most != boundless) least = std::min(least, most > used ? most - used : 0);
        if (path.empty() || path == "/") return least;
        path.erase(path.find_last_of('/'));
    }
}

} // namespace

std::uint64_t available_memory() {
    std::uint64_t available = 4'000'000'000;
    std::ifstream facts("/proc/meminfo");
    std::string word;
    for (std::uint64_t number = 0; facts >> word;)
        if (word == "MemAvailable:" && facts >> number) available = number * 1024;
    return std::min(available, cgroup_memory());
}

} // namespace reliefbake
