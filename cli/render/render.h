#pragma once
// reliefbake render MAP -o PNG

#include "cli/command.h"
#include "cli/options/technique_options.h"
#include "cli/render/render_mesh.h"
#include "cli/render/render_shape.h"
#include "formats/map_file.h"
#include "shaders-reference/renderer/relief_renderer.h"

#include <filesystem>
#include <string>

namespace reliefbake {

class RenderCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    Result<void> check_output(const std::filesystem::path& path) const;
    Result<Rendering> draw(const ReliefMap& map, const RenderOptions& picture) const;
    Result<void> write_error(const ReliefMap& map, const Rendering& rendering) const;
    Result<void> run_mesh(const std::string& kind) const;
    Result<void> run_shape() const;

    struct Options {
        std::string file;
        std::string output;
        std::string error; ///< picture of the distances from the exact hits; empty: none
        MapHints hints;
        std::string horizons; ///< horizon map of the same heights; empty: none
        RenderOptions picture;
        RendererBackend backend = RendererBackend::osmesa;
        TechniqueOptions technique;
        RenderShapeOptions shape;
        RenderMeshOptions mesh;
    } options_;
    const CLI::App* app_ = nullptr; ///< knows which options were given
};

} // namespace reliefbake
