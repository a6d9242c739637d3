#pragma once
// reliefbake bench render MAP: what a frame costs (001 ch. 4, the frame times of its tables).

#include "cli/command.h"
#include "cli/options/technique_options.h"
#include "formats/map_file.h"

namespace reliefbake {

class BenchRenderCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    std::string file_; ///< MAP
    MapHints hints_;
    RenderOptions picture_;
    TechniqueOptions technique_;
    RendererBackend backend_ = RendererBackend::osmesa; ///< --renderer
    int frames_ = 5;    ///< --frames
    bool json_ = false; ///< --json
    const CLI::App* app_ = nullptr; ///< knows which options were given
};

} // namespace reliefbake
