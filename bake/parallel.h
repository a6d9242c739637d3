#pragma once
// The one place that names the thread library.

#include <functional>

namespace reliefbake {

/// Threads this process may use: its affinity mask.
int available_threads();

/// Calls body(i) once for every i in [0, count), on up to `threads` threads (0: available_threads()). Results must not
/// depend on the order of calls.
void parallel_for(int count, int threads, const std::function<void(int)>& body);

} // namespace reliefbake
