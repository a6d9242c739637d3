#include "cli/report/height_report.h"

#include "bake/wrap_words.h"
#include "cli/report/format_text.h"
#include "formats/shortest_decimal.h"

namespace reliefbake {

using nlohmann::json;

namespace {

bool was_chosen(const HeightOptions& options) {
    return options.wrap_x == WrapChoice::automatic || options.wrap_y == WrapChoice::automatic;
}

std::string range_line(const HeightReport& height) {
    const char* origin = height.range_from_data ? "the source's extremes" : "as declared or by the format";
    std::string line = format("  height 0..1 is source %g..%g, %s; the source spans %g..%g", height.range_low,
                              height.range_high, origin, height.source_low, height.source_high);
    if (height.bad_texels > 0) line += format("; %zu texels filled", height.bad_texels);
    return line + "\n";
}

} // namespace

json height_result(const ConeCommandOptions& given, const SourceImage& source, const HeightReport& height, const TexelGrid& grid) {
    const auto number = [](double sample) { return shortest_decimal(float(sample)); };
    return {
        {"input", given.input},
        {"output", given.output},
        {"source",
         {{"format", source.format},
          {"channel", source.channel},
          {"bit_depth", source.bit_depth},
          {"is_integer", source.is_integer},
          {"low", number(height.source_low)},
          {"high", number(height.source_high)},
          {"filled_texels", height.bad_texels}}},
        {"range", {{"low", number(height.range_low)}, {"high", number(height.range_high)}, {"from_data", height.range_from_data}}},
        {"wrap", {word_of_wrap(grid.wrap_x), word_of_wrap(grid.wrap_y)}},
        {"seam", {height.seam_x.border, height.seam_y.border}},
    };
}

std::string height_summary(const ConeCommandOptions& given, const SourceImage& source, const HeightReport& height, const TexelGrid& grid) {
    return given.output + ": " + format("%d x %d from %s of ", grid.width, grid.height, source.channel.c_str()) + given.input + "\n" +
           range_line(height) +
           format("  wrap %s, %s (%s; seam %.2f, %.2f)\n", word_of_wrap(grid.wrap_x), word_of_wrap(grid.wrap_y),
                  was_chosen(given.height) ? "measured" : "as told", height.seam_x.border, height.seam_y.border);
}

} // namespace reliefbake
