#include "bake/parallel.h"

#include <sched.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>

namespace reliefbake {

int available_threads() {
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0) return CPU_COUNT(&set);
    return tbb::this_task_arena::max_concurrency();
}

void parallel_for(int count, int threads, const std::function<void(int)>& body) {
    if (threads <= 0) threads = available_threads();
    if (threads == 1 || count <= 1) {
        for (int i = 0; i < count; ++i) body(i);
        return;
    }
    // More threads than cores are the caller's choice; without this TBB warns on stderr and refuses. Never fewer than the cores: the
    // least of all that run at once would hold for all.
    const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, std::size_t(std::max(threads, available_threads())));
    tbb::task_arena arena(threads);
    arena.execute([&] { tbb::parallel_for(0, count, body); });
}

} // namespace reliefbake
