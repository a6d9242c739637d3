#pragma once
// Renders solids of shape maps with the shaders of glsl/, off screen.

#include "bake/error.h"
#include "bake/shape_map.h"
#include "shaders-reference/renderer/gl_context.h"
#include "shaders-reference/renderer/relief_renderer.h"
#include "shaders-reference/renderer/shape_source.h"
#include "shaders-reference/renderer/shape_texture.h"

#include <memory>

namespace reliefbake {

/// Slopes of a height texture, 003's depth map; the numbers themselves, whatever their file stores.
struct BumpTexture {
    TexelGrid grid;
    Image<float> slope_u, slope_v; ///< dH/du, dH/dv / aspect: height per width of this texture; v down
};

/// A picture to lay on a solid: linear light, repeated.
struct ColourTexture {
    Image<float> red, green, blue;
};

struct ShapeRenderOptions {
    ShapeSolid solid;
    CircleScheme scheme = CircleScheme::corrected; ///< (--scheme)
    int steps = 25;        ///< of circle tracing; 004: 25, 003: 20 (--steps)
    int binary_steps = 5;  ///< halvings at the end; 004: 5, 003: 10 (--binary-steps)
    double epsilon = 1.0 / 32; ///< gap that counts as a hit, texels
    Projection projection = Projection::planar; ///< (--projection)
    double bump_scale = 1; ///< a of 003 (5) (--bump-scale)
    double texture_tiles_u = 1, texture_tiles_v = 1; ///< repeats of colour and bumps over the solid (--texture-tiles)
    int width = 1024;      ///< of the picture, pixels (--size)
    int height = 768;
    int supersample = 1;   ///< rays per pixel and axis (--supersample)
    View view;
    Sun sun;
    bool shadow = false;   ///< hard (--shadow)
    const Image<Quad>* given = nullptr; ///< CircleScheme::given: (t, gap, status, -) per sample, top row first
};

/// What one frame yields; planes of float32, the top row first. An oracle fed with origin and direction follows the very ray that
/// the shader followed. t: world length, texture widths.
struct ShapeRendering {
    Image<Quad> origin;    ///< P where the ray enters the domain (solid.h), t where it leaves it
    Image<Quad> direction; ///< dP per unit of t; gap at the end, texture widths
    Image<Quad> counts;    ///< steps, fetches, RayStatus, t
    Image<Quad> normal;    ///< unit, in the world, not bumped; 1: of the face where the ray entered, 2: of the floor
    Image<Quad> bumped;    ///< unit, in the world: the normal that is shaded
    Image<float> depth;    ///< device depth in [0,1]; 1 where nothing is drawn
    RgbImage colour;
    double seconds = 0;    ///< drawing, up to glFinish

    int width() const { return counts.width(); }
    int height() const { return counts.height(); }
    RayStatus status(std::size_t pixel) const { return RayStatus(int(counts[pixel][2])); }
};

/// The counts that 003 and 004 use.
constexpr CircleCounts published_counts(SolidKind kind) { return kind == SolidKind::extrusion ? CircleCounts{25, 5} : CircleCounts{20, 10}; }

class ShapeRenderer {
  public:
    /// Errors (usage): the backend is not available; says what to install.
    static Result<ShapeRenderer> create(RendererBackend backend);

    ShapeRenderer(ShapeRenderer&&) noexcept;
    ShapeRenderer& operator=(ShapeRenderer&&) noexcept;
    ~ShapeRenderer();

    /// Uploads the map that following frames show. Errors (usage): larger than the driver's textures; `fixed8` for a map that is
    /// not 8-bit.
    Result<void> load(const ShapeMap& map, SamplerFilter filter = SamplerFilter::exact);
    /// Textures laid on the solid; null: none. Errors (usage): larger than the driver's textures.
    Result<void> set_textures(const ColourTexture* colour, const BumpTexture* bump);

    /// Draws one frame of the loaded map. Deterministic on one machine. Errors (usage): a picture larger than the driver allows; a
    /// solid outside the ranges of solid.h, or that reaches beyond the distances that a map with scale_f < 1, or of an empty shape, knows; more than one
    /// tile of a map that does not repeat; a projection that is not for its kind; (internal): a shader that does not compile.
    Result<ShapeRendering> render(const ShapeRenderOptions& options);

  private:
    struct State;
    explicit ShapeRenderer(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace reliefbake
