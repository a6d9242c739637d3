#pragma once
// --memory, --out-of-core, --rows: for maps that do not fit into memory (docs/LARGE.md).

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdint>
#include <optional>
#include <utility>

namespace reliefbake {

/// As given.
struct LargeOptions {
    std::optional<std::uint64_t> memory;     ///< --memory: ceiling in bytes
    bool out_of_core = false;                ///< --out-of-core
    std::optional<std::pair<int, int>> rows; ///< --rows FIRST:END

    static constexpr std::uint64_t default_memory = 4ull << 30;
    std::uint64_t ceiling() const { return memory.value_or(default_memory); }
};

void add_large_options(CLI::App& app, LargeOptions& options);

} // namespace reliefbake
