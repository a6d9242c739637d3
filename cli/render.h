#pragma once
// reliefbake render MAP -o PNG

#include "cli/command.h"
#include "formats/map_file.h"
#include "shaders-reference/renderer/relief_renderer.h"

#include <optional>
#include <string>

namespace reliefbake {

class RenderCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    struct Options {
        std::string file;
        std::string output;
        MapHints hints;
        RenderOptions picture;
        RendererBackend backend = RendererBackend::osmesa;
        std::optional<int> steps; ///< of whichever technique
        bool shadow = false;
    } options_;
};

} // namespace reliefbake
