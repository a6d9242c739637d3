#include "cli/explain/explain_lines.h"

#include "cli/choices.h"
#include "cli/report/format_text.h"

namespace reliefbake {

std::string title_line(const std::string& kind, const TexelGrid& grid, BitDepth bits, const std::string& version) {
    return "A " + kind + " map of " + std::to_string(grid.width) + " x " + std::to_string(grid.height) + " texels, " + word_of(bits_words, bits) + " bits" +
           (version.empty() ? "" : ", by reliefbake " + version) + ".\n";
}

std::string statistics_lines(const std::map<std::string, double>& statistics) {
    std::string text;
    for (const auto& [name, value] : statistics) text += "  " + name + " = " + digits(value) + "\n";
    return text;
}

std::string source_line(const std::string& source_hash, const std::string& argument_hash) {
    if (source_hash.empty()) return "";
    return "Source pixels " + source_hash + (argument_hash.empty() ? "" : ", options " + argument_hash) + ".\n";
}

} // namespace reliefbake
