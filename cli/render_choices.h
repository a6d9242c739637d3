#pragma once
// The words that `render` and `verify` share.

#include "cli/choices.h"
#include "shaders-reference/renderer/relief_renderer.h"

namespace reliefbake {

inline const Words<Technique> technique_words = {{"cone", Technique::cone},
                                                 {"cone-published", Technique::cone_published},
                                                 {"linear", Technique::linear},
                                                 {"binary", Technique::binary}};
inline const Words<RendererBackend> renderer_words = {{"osmesa", RendererBackend::osmesa},
                                                      {"egl", RendererBackend::egl}};
inline const Words<SamplerFilter> filter_words = {{"float", SamplerFilter::exact},
                                                  {"fixed8", SamplerFilter::fixed8}};

} // namespace reliefbake
