#include "cli/cone/cone_options.h"

#include "cli/choices.h"
#include "cli/cone/mip_options.h"
#include "cli/options/length_option.h"
#include "cli/options/number_options.h"
#include "cli/options/range_option.h"
#include "cli/options/thread_option.h"
#include "cli/options/wrap_option.h"

namespace reliefbake {

namespace {

void add_source_options(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Source");
    app.add_option("--channel", o.read.channel,
                   "R|G|B|A|Y (luminance) or a channel's name (default: the only channel, else luminance)");
    add_choice(app, "--input", o.height.input, input_words, "What white means (default height)");
    add_range_option(app, o.height);
    add_choice(
        app, "--nan", o.height.nan, nan_words,
        "NaN, Inf and no-data texels: refuse the file, or fill from the nearest texel (default error)");
    add_number(app, "--no-data", o.height.no_data, finite_number,
               "Value that means 'no sample here' (default: the file's own)");
    add_number(app, "--scale", o.height.scale, finite_number,
               "height = scale * height + bias; must stay in 0..1");
    add_number(app, "--bias", o.height.bias, finite_number, "See --scale");
    add_wrap_option(app, o.height.wrap_x, o.height.wrap_y);
    add_byte_budget(app, o.read.max_bytes);
}

void add_physical_options(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Proportions");
    CLI::Option* uv = add_number(app, "--depth-uv", o.depth_uv, positive_number,
                                 "Depth of the relief in texture widths (default 0.1)");
    CLI::Option* size = add_length(app, "--size", o.size_metres, "Width of the texture, e.g. 2m");
    CLI::Option* depth = add_length(app, "--depth", o.depth_metres, "Depth of the relief, e.g. 10cm");
    size->needs(depth)->excludes(uv);
    depth->needs(size)->excludes(uv);
    add_number(app, "--pixel-aspect", o.height.pixel_aspect, pixel_aspect,
               "Height of a texel divided by its width, 0.5 to 2 (default 1)");
}

} // namespace

void add_search_options(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Bake");
    add_choice(app, "--surface", o.cone.surface, surface_words,
               "Surface that no cone may touch (default bilinear: as a GPU filters it)");
    add_choice(app, "--metric", o.cone.metric, metric_words,
               "How horizontal distance is measured (default l2)");
    add_number(app, "--tolerance", o.cone.tolerance, fraction_number,
               "How much narrower than exact a cone may be, relative, for speed (default 0.001)");
}

void add_cone_max_option(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Bake");
    add_number(app, "--cone-max", o.cone.ratio_max, positive_or_inf,
               "Widest cone, texture widths per unit of depth (default 1; inf: encoding normal, or radius in "
               "floats)");
}

void add_encoding_option(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Result");
    add_choice(app, "--encoding", o.encoding, encoding_words, "Encoding of the cone channel (default sqrt)");
}

void add_exr_layout_option(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Result");
    add_choice(app, "--exr-layout", o.layout, single_cone_layout_words,
               "Channels R,G,B,A or relief.nx, relief.ny, relief.cone, relief.depth (default rgba)");
}

void add_output_options(CLI::App& app, ConeCommandOptions& o) {
    app.option_defaults()->group("Result");
    app.add_option("-o,--output", o.output, "Map to write: .png .tif .exr .tga .dds .ktx2")
        ->required()
        ->type_name("OUT");
    add_choice(app, "--bits", o.bits, bits_words, "Depth of the channels (default 16; exr: float; tga: 8)");
    add_choice(app, "--normal-y", o.normal_y, normal_y_words, "Direction of the normals' y (default gl: up)");
}

void add_input_options(CLI::App& app, ConeCommandOptions& options) {
    app.add_option("IN", options.input, "Height map: png, tif, exr, hdr, jpg, tga, bmp, pgm, ppm, pfm")
        ->required();
    add_source_options(app, options);
    add_physical_options(app, options);
}

void add_run_options(CLI::App& app, ConeCommandOptions& o) {
    add_input_options(app, o);
    add_alpha_options(app, o.alpha);
    app.option_defaults()->group("Run");
    add_thread_option(app, o.cone.threads);
    CLI::Option* json = app.add_flag("--json", o.json, "Print one result object (cli/schema/cone.schema.json)");
    app.add_flag("--quiet", o.quiet, "Print nothing unless something is wrong")->excludes(json);
}

void copy_run_options(const ConeCommandOptions& from, ConeCommandOptions& to) {
    to.input = from.input, to.read = from.read, to.alpha = from.alpha, to.height = from.height;
    to.depth_uv = from.depth_uv, to.size_metres = from.size_metres, to.depth_metres = from.depth_metres;
    to.cone.threads = from.cone.threads, to.json = from.json, to.quiet = from.quiet;
}

} // namespace reliefbake
