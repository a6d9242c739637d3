#include "formats/worker/limits.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace reliefbake::worker {

namespace {

// Sanitizers reserve terabytes of address space for their shadow.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool address_space_means_memory = false;
#else
constexpr bool address_space_means_memory = true;
#endif

/// Lowers or raises a soft limit; the hard one stays, so that the next request can have another.
template <class Resource>
void set_soft_limit(Resource resource, std::uint64_t value) {
    rlimit limit{};
    if (::getrlimit(resource, &limit) != 0) return;
    limit.rlim_cur = std::min<rlim_t>(value, limit.rlim_max);
    ::setrlimit(resource, &limit);
}

std::uint64_t address_space() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * std::uint64_t(::sysconf(_SC_PAGESIZE));
}

std::uint64_t used_cpu_seconds() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec + 1); // the two fractions make less than 2
}

} // namespace

void limit_process() {
    set_soft_limit(RLIMIT_CORE, 0);
    ::signal(SIGXFSZ, SIG_IGN);
    ::signal(SIGINT, SIG_IGN); // Ctrl-C reaches the whole group; the tool decides when this process ends
    ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
}

void limit_request(std::uint64_t memory, std::uint64_t cpu_seconds, std::uint64_t file_bytes) {
    if (address_space_means_memory) set_soft_limit(RLIMIT_AS, address_space() + memory);
    set_soft_limit(RLIMIT_CPU, used_cpu_seconds() + cpu_seconds);
    set_soft_limit(RLIMIT_FSIZE, file_bytes);
}

} // namespace reliefbake::worker
