#pragma once
// --threads: as many as the machine's owner lets us use.

#include "bake/error.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace reliefbake {

/// Adds --threads N (1..1024).
void add_thread_option(CLI::App& app, int& threads);

/// The flag if given (> 0); else RELIEFBAKE_THREADS, OPENIMAGEIO_THREADS, CUE_THREADS, SLURM_CPUS_PER_TASK,
/// the first that is set and not 0; else the affinity mask, cut to the CPU quota of the cgroup (rounded up).
/// Errors: usage, when one of those variables is not a number from 0 to 1024.
Result<int> resolve_threads(int flag);

} // namespace reliefbake
