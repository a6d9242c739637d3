#pragma once
// What a batch's report shows of an asset: a thumbnail, and what a short `verify` finds.

#include "cli/batch/ledger.h"
#include "shaders-reference/measure/verify.h"

#include <filesystem>
#include <optional>
#include <string>

namespace reliefbake {

struct AssetCheck {
    std::string verdict;                 ///< "safe", "unsafe", ...; or why it was not judged
    double severity = 0;                 ///< worst first: of two verdicts the worse, then the larger share of wrong rays
    std::optional<double> missed, early; ///< shares of rays
    std::string thumbnail;               ///< PNG; empty where nothing can be drawn
};

/// Judges outputs one after the other, with one renderer.
class AssetChecker {
  public:
    explicit AssetChecker(int threads) : threads_(threads) {}

    /// Cone maps by some 7000 rays and 2000 points, shape maps likewise, bump maps by all values and 2000 horizons; quadrics are not judged,
    /// which is said. Never fails: what cannot be read or drawn is a verdict too.
    AssetCheck check(const std::filesystem::path& out, const LedgerLine& line);

  private:
    AssetCheck check_cones(const std::filesystem::path& file);
    AssetCheck check_shape(const std::filesystem::path& file) const;
    AssetCheck check_bump(const std::filesystem::path& file) const;

    int threads_;
    std::optional<ReliefRenderer> renderer_;
};

} // namespace reliefbake
