#pragma once
// Renders baked maps with the shaders of glsl/, off screen.

#include "bake/bump_map.h"
#include "bake/error.h"
#include "bake/relief_map.h"
#include "shaders-reference/renderer/gl_context.h"
#include "shaders-reference/renderer/sampler_filter.h"
#include "shaders-reference/renderer/rendering.h"
#include "shaders-reference/renderer/scene.h"
#include "shaders-reference/renderer/shader_source.h"

#include <memory>
#include <optional>

namespace reliefbake {

struct RenderOptions {
    Technique technique = Technique::cone; ///< (--technique)
    bool exact_finish = false; ///< cone, cone_raw: solve the bilinear patch in the cell where cone steps get short (--exact-finish)
    int width = 1024;          ///< of the picture, pixels (--size)
    int height = 768;
    int supersample = 1;       ///< rays per pixel and axis; cost grows with its square (--supersample)
    int max_steps = 256;       ///< of marches: cones, maximum mipmaps (--steps)
    int linear_steps = 64;     ///< of linear searches (--steps)
    int binary_steps = 8;      ///< halvings or secants of techniques that refine (--binary-steps)
    float epsilon = 1.0f / 16384; ///< gap that counts as a hit for cone marches without exact finish, height
    int tiles = 1;             ///< repeats of the map per axis; clamped maps always show one (--tiles)
    bool endless = false;      ///< repeated maps only: the plane has no border
    View view;
    Sun sun;
    Shadow shadow = Shadow::none; ///< (--shadow)
    int shadow_steps = 64;     ///< of the march towards the sun
    std::optional<Ambient> ambient; ///< unset: cone_normal where the map's cones are conservative, else none (--ao)
    const Image<Quad>* given = nullptr; ///< Technique::given: (t, gap, status, -) per sample, top row first
};

class ReliefRenderer {
  public:
    /// Errors (usage): the backend is not available; says what to install.
    static Result<ReliefRenderer> create(RendererBackend backend);

    ReliefRenderer(ReliefRenderer&&) noexcept;
    ReliefRenderer& operator=(ReliefRenderer&&) noexcept;
    ~ReliefRenderer();

    /// Uploads the map that following frames show. Errors (usage): larger than the driver's textures; `fixed8` for a map
    /// that is not 8-bit; no depth channel; more than 8 sectors or levels.
    Result<void> load(const ReliefMap& map, SamplerFilter filter = SamplerFilter::exact);

    /// Uploads the horizons of the loaded map, for Shadow::horizon; forgotten with the next map. Errors (usage): no horizon map;
    /// baked from other heights, or for another wrap or shape of pixels; larger than the driver's textures.
    Result<void> load_horizons(const BumpMap& horizons);

    /// Draws one frame of the loaded map. Deterministic on one machine. Errors (usage): a picture larger than the driver
    /// allows; a technique, shadow or ambient term that the map's cones do not serve; (internal): a shader that does not compile.
    Result<Rendering> render(const RenderOptions& options);

  private:
    struct State;
    explicit ReliefRenderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// One frame with a renderer of its own.
Result<Rendering> render(const ReliefMap& map, const RenderOptions& options,
                         RendererBackend backend = RendererBackend::osmesa, SamplerFilter filter = SamplerFilter::exact);

} // namespace reliefbake
