#pragma once
// Options that take one word of a fixed set, and the words themselves.

#include "bake/cone.h"
#include "bake/relief_map.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <string>
#include <utility>
#include <vector>

namespace reliefbake {

template <class T>
using Words = std::vector<std::pair<std::string, T>>;

inline const Words<Metric> metric_words = {{"l2", Metric::l2}, {"l1", Metric::l1}};
inline const Words<SurfaceModel> surface_words = {{"bilinear", SurfaceModel::bilinear},
                                                  {"texel", SurfaceModel::texel}};
inline const Words<ConeEncoding> encoding_words = {{"ratio", ConeEncoding::ratio},
                                                   {"sqrt", ConeEncoding::sqrt},
                                                   {"radius", ConeEncoding::radius},
                                                   {"normal", ConeEncoding::normal}};
inline const Words<BitDepth> bits_words = {{"8", BitDepth::unorm8},
                                           {"16", BitDepth::unorm16},
                                           {"half", BitDepth::half},
                                           {"float", BitDepth::float32}};
inline const Words<NormalY> normal_y_words = {{"gl", NormalY::gl}, {"dx", NormalY::dx}};
inline const Words<ChannelLayout> layout_words = {{"rgba", ChannelLayout::rgba},
                                                  {"named", ChannelLayout::named},
                                                  {"side", ChannelLayout::side},
                                                  {"pair", ChannelLayout::pair}};
/// Those of a map with one cone a texel (--exr-layout).
inline const Words<ChannelLayout> single_cone_layout_words(layout_words.begin(), layout_words.begin() + 2);
inline const Words<ConeFamily> family_words = {{"conservative", ConeFamily::conservative},
                                               {"relaxed", ConeFamily::relaxed},
                                               {"hybrid", ConeFamily::hybrid}};
inline const Words<ConeLookup> lookup_words = {{"filtered", ConeLookup::filtered}, {"cell", ConeLookup::cell}};
inline const Words<InputKind> input_words = {{"height", InputKind::height}, {"depth", InputKind::depth}};
inline const Words<NanPolicy> nan_words = {{"error", NanPolicy::error}, {"fill", NanPolicy::fill}};

/// How a channel is stored, for people.
inline const char* storage_words(BitDepth bits) {
    switch (bits) {
    case BitDepth::unorm8:
        return "8-bit codes";
    case BitDepth::unorm16:
        return "16-bit codes";
    case BitDepth::half:
        return "halfs";
    case BitDepth::float32:
        return "floats";
    }
    return "";
}

/// The word for a value; `words` must hold it.
template <class T>
const std::string& word_of(const Words<T>& words, T value) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    std::abort();
}

/// "a|b|c", for help and messages.
template <class T>
std::string alternatives(const Words<T>& words) {
    std::string text;
    for (const auto& [word, meaning] : words)
        text += (text.empty() ? "" : "|") + word;
    return text;
}

/// Adds an option that takes one of `words`; anything else is refused with the list. `target`: a T or
/// optional<T>.
template <class T, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& flag, Target& target, const Words<T>& words,
                        const std::string& help) {
    auto assign = [flag, &target, &words](const std::string& given) {
        for (const auto& [word, meaning] : words) {
            if (word != given) continue;
            target = meaning;
            return;
        }
        throw CLI::ValidationError(flag, "expected " + alternatives(words) + ", found '" + given + "'");
    };
    return app.add_option_function<std::string>(flag, assign, help)->type_name(alternatives(words));
}

} // namespace reliefbake
