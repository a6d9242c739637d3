#include "cli/options/wrap_option.h"

#include "cli/choices.h"

namespace reliefbake {

namespace {

const Words<WrapChoice> choice_words = {
    {"repeat", WrapChoice::repeat}, {"clamp", WrapChoice::clamp}, {"auto", WrapChoice::automatic}};
const Words<Wrap> wrap_words = {{"repeat", Wrap::repeat}, {"clamp", Wrap::clamp}};

template <class T>
T parse_axis(const Words<T>& words, const std::string& given) {
    for (const auto& [word, meaning] : words)
        if (word == given) return meaning;
    throw CLI::ValidationError("--wrap", "expected " + alternatives(words) +
                                             " for both axes, or X,Y; found '" + given + "'");
}

template <class T, class Target>
void add_option(CLI::App& app, const Words<T>& words, Target& x, Target& y, const std::string& help) {
    auto assign = [&words, &x, &y](const std::string& given) {
        const std::size_t comma = given.find(',');
        x = parse_axis(words, given.substr(0, comma));
        y = comma == std::string::npos ? x : parse_axis(words, given.substr(comma + 1));
    };
    app.add_option_function<std::string>("--wrap", assign, help)->type_name(alternatives(words) + "[,Y]");
}

} // namespace

void add_wrap_option(CLI::App& app, WrapChoice& x, WrapChoice& y) {
    add_option(app, choice_words, x, y,
               "Addressing beyond the border, for both axes or X,Y (default auto: measure the seam)");
}

void add_wrap_hint(CLI::App& app, std::optional<Wrap>& x, std::optional<Wrap>& y) {
    add_told_wrap(app, x, y, "Addressing the map was baked for, for both axes or X,Y");
}

void add_told_wrap(CLI::App& app, std::optional<Wrap>& x, std::optional<Wrap>& y, const std::string& help) {
    add_option(app, wrap_words, x, y, help);
}

} // namespace reliefbake
