#include "cli/cone/mip_options.h"

namespace reliefbake {

void add_mip_options(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Result");
    app.add_flag("--mips", o.mips,
                 "A chain of levels down to 1 x 1, each with heights and cones of its own: in one .exr .tif .dds .ktx2, "
                 "or as numbered .png .tga");
    app.add_option("--mip-levels", o.mip_levels, "So many levels from the largest on, where fewer than all are ever seen; needs --mips")->check(CLI::Range(1, 31));
    app.add_option("--level", o.level, "Bake this mip level of the heights as the largest: half the side, N times (default 0)")->type_name("N")->check(CLI::Range(0, 30));
    app.add_flag("--trilinear", o.trilinear, "Cones that stay safe where two levels are blended; needs --mips");
}

Result<void> validate_mips(const ConeCommandOptions& options, const ConeOptions& cone) {
    if (options.mips && options.layout == ChannelLayout::side)
        return fail(ErrorCode::usage, "--layout side: mip levels cannot lie side by side; choose pair or named");
    if (options.mip_levels && !options.mips) return fail(ErrorCode::usage, "--mip-levels: needs --mips");
    if (!options.trilinear) return {};
    if (!options.mips) return fail(ErrorCode::usage, "--trilinear: needs --mips");
    if (cone.surface != SurfaceModel::bilinear)
        return fail(ErrorCode::usage, "--trilinear: needs --surface bilinear; texel cones are not safe under any filter");
    if (options.adaptive) return fail(ErrorCode::usage, "--trilinear: needs --method exact; approximate cones have no guarantee to keep");
    if (options.kind == "cone-pieces")
        return fail(ErrorCode::usage, "--trilinear: needs --method 1; a blend of two lines of pieces may be wider than either");
    if (cone.family != ConeFamily::conservative)
        return fail(ErrorCode::usage, "--trilinear: is for conservative cones; a blend may hold more crossings than either level");
    if (cone.lookup != ConeLookup::filtered)
        return fail(ErrorCode::usage, "--trilinear: needs --lookup filtered; cell cones are fetched from one level");
    return {};
}

} // namespace reliefbake
