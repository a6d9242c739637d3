#include "cli/output_checks.h"

#include "cli/command_files.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

/// Steeper than anything; beyond, squares of slopes leave double's range.
constexpr double largest_depth_scale = 1e6;

} // namespace

std::string extension_of(const std::string& path) {
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return extension;
}

BitDepth default_bits(const std::string& output) {
    const std::string extension = extension_of(output);
    if (extension == ".exr") return BitDepth::float32;
    return extension == ".tga" ? BitDepth::unorm8 : BitDepth::unorm16;
}

Result<void> validate_not_input(const std::string& input, const std::string& output) {
    std::error_code ignored;
    if (!fs::equivalent(input, output, ignored)) return {};
    return fail(ErrorCode::usage, output + ": the output is the input file; choose another name");
}

Result<void> validate_output_folder(const std::string& output) {
    if (folders_are_made_later()) return {};
    const fs::path parent = fs::path(output).parent_path();
    const fs::path folder = parent.empty() ? "." : parent;
    if (access(folder.c_str(), W_OK | X_OK) == 0) return {};
    return fail(ErrorCode::cannot_create, output + ": cannot create a file in " + folder.string() + ": " +
                                              std::generic_category().message(errno));
}

std::string identity_of(const fs::path& file) {
    std::error_code ignored;
    std::string name = fs::weakly_canonical(fs::absolute(file), ignored).string();
    if (name.empty()) name = fs::absolute(file).lexically_normal().string();
    for (char& c : name)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return name;
}

double depth_scale_of(const ConeCommandOptions& options) {
    if (options.size_metres) return *options.depth_metres / *options.size_metres;
    return options.depth_uv.value_or(ReliefMapInfo().depth_scale);
}

Result<void> validate_depth_scale(double scale) {
    if (scale > 0 && scale <= largest_depth_scale) return {};
    return fail(ErrorCode::usage, "--depth-uv, or --depth over --size: expected a depth above 0 and up to 1e6 texture widths");
}

} // namespace reliefbake
