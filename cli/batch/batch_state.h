#pragma once
// What runs keep for the next ones, inside the output folder.

#include <filesystem>

namespace reliefbake {

inline std::filesystem::path state_folder(const std::filesystem::path& out) { return out / ".reliefbake"; }

/// In the state folder of a batch, or of a shard.
inline std::filesystem::path ledger_file(const std::filesystem::path& state) { return state / "ledger.jsonl"; }
inline std::filesystem::path summary_file(const std::filesystem::path& state) { return state / "summary.json"; }

} // namespace reliefbake
