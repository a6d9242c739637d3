#pragma once
// The command line of `reliefbake bump`, and what the stages take from it.

#include "bake/bump_map.h"
#include "cli/choices.h"
#include "cli/cone/cone_options.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

inline const Words<BumpKind> bump_kind_words = {
    {"derivative", BumpKind::derivative}, {"normal", BumpKind::normal}, {"horizon", BumpKind::horizon}};
inline const Words<DerivativeKernel> kernel_words = {
    {"central", DerivativeKernel::central}, {"sobel", DerivativeKernel::sobel}, {"scharr", DerivativeKernel::scharr}};
inline const Words<SignedCodes> codes_words = {{"centred", SignedCodes::centred}, {"unorm", SignedCodes::unorm}};

/// As given; nothing is defaulted that depends on another option.
struct BumpCommandOptions {
    ConeCommandOptions height; ///< input, output, read, height, bits, proportions, threads, json, quiet: those of the height stages
    BumpKind kind = BumpKind::derivative;   ///< --kind
    std::optional<DerivativeKernel> kernel; ///< --kernel
    std::optional<SignedCodes> codes;       ///< --codes
    std::optional<double> derivative_max;   ///< --derivative-max
    std::optional<NormalY> normal_y;        ///< --normal-y
    std::optional<ChannelLayout> layout;    ///< --layout
};

/// What the stages run with: every default resolved, every combination checked.
struct BumpPlan {
    BumpCommandOptions given;
    BumpMapInfo info; ///< but what follows from the values
    int threads = 0;
};

void add_bump_options(CLI::App& app, BumpCommandOptions& options);

/// The files of such a map: `output`, and the second of a pair.
std::vector<std::filesystem::path> bump_files(const std::filesystem::path& output, const BumpMapInfo& info);

/// Refuses (usage) options that the kind does not read or that do not fit the output.
Result<BumpPlan> plan_bump(const BumpCommandOptions& options);

} // namespace reliefbake
