#include "cli/cone/large/large_options.h"

#include "bake/cone_bands.h"

#include <charconv>
#include <string>

namespace reliefbake {

namespace {

std::pair<int, int> require_rows(const std::string& text) {
    std::pair<int, int> rows;
    const char* end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, rows.first);
    if (first.ec == std::errc() && first.ptr != end && *first.ptr == ':') {
        const auto last = std::from_chars(first.ptr + 1, end, rows.second);
        if (last.ec == std::errc() && last.ptr == end && 0 <= rows.first && rows.first < rows.second) return rows;
    }
    throw CLI::ValidationError("--rows", "expected FIRST:END, such as 0:4096, found '" + text + "'");
}

} // namespace

void add_large_options(CLI::App& app, LargeOptions& options) {
    app.option_defaults()->group("Large maps");
    app.add_option("--memory", options.memory,
                   "Most memory that the run may keep, e.g. 4GiB (the default); an EXR or TIFF that needs more is baked out of core")
        ->transform(CLI::AsSizeValue(false))
        ->type_name("BYTES");
    app.add_flag("--out-of-core", options.out_of_core, "Bake out of core whatever the size: heights on the disk beside OUT, rows written as they are baked");
    app.add_option_function<std::string>(
           "--rows", [&options](const std::string& text) { options.rows = require_rows(text); },
           "Bake these rows alone, out of core, into a band file OUT.band for `merge`; both are multiples of " + std::to_string(band_step) +
               ", but for the last row")
        ->type_name("FIRST:END");
}

} // namespace reliefbake
