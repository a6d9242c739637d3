#include "cli/options/range_option.h"

#include "cli/options/number_options.h"

namespace reliefbake {

namespace {

void parse_bounds(const std::string& given, HeightOptions& options) {
    const std::size_t colon = given.find(':');
    if (colon == std::string::npos)
        throw CLI::ValidationError("--range", "expected auto, data or LO:HI, found '" + given + "'");
    options.range = RangeMode::fixed;
    options.range_low = float(require_number("--range", given.substr(0, colon), finite_number));
    options.range_high = float(require_number("--range", given.substr(colon + 1), finite_number));
    if (!(options.range_low < options.range_high))
        throw CLI::ValidationError("--range", "expected LO below HI, found '" + given + "'");
}

} // namespace

CLI::Option* add_range_option(CLI::App& app, HeightOptions& options) {
    auto assign = [&options](const std::string& given) {
        if (given == "auto")
            options.range = RangeMode::automatic;
        else if (given == "data")
            options.range = RangeMode::data;
        else
            parse_bounds(given, options);
    };
    return app.add_option_function<std::string>("--range", assign,
                                         "Source values of height 0 and 1; integers count as code / largest code (default auto: integers by their "
                                         "format; floats as they are if within "
                                         "0..1, else their smallest and largest)")
        ->type_name("auto|data|LO:HI");
}

} // namespace reliefbake
