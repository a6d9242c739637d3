#pragma once
// The words that `render` and `verify` share.

#include "cli/choices.h"
#include "shaders-reference/renderer/relief_renderer.h"

namespace reliefbake {

inline const Words<Technique> technique_words = [] {
    Words<Technique> words;
    for (const TechniqueInfo& info : all_techniques())
        if (!info.word.empty()) words.emplace_back(std::string(info.word), info.technique);
    return words;
}();
inline const Words<Shadow> shadow_words = {
    {"hard", Shadow::hard}, {"height-soft", Shadow::height_soft}, {"cone-soft", Shadow::cone_soft},
    {"horizon", Shadow::horizon}};
inline const Words<Ambient> ambient_words = {
    {"none", Ambient::none}, {"cone", Ambient::cone}, {"cone-normal", Ambient::cone_normal}};
inline const Words<RendererBackend> renderer_words = {{"osmesa", RendererBackend::osmesa},
                                                      {"egl", RendererBackend::egl}};
inline const Words<SamplerFilter> filter_words = {{"float", SamplerFilter::exact},
                                                  {"fixed8", SamplerFilter::fixed8}};

} // namespace reliefbake
