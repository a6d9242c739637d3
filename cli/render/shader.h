#pragma once
// reliefbake shader --for FILE [--language glsl|glsl-es|hlsl]

#include "cli/command.h"
#include "formats/map_file.h"
#include "shaders-reference/renderer/shader_export.h"

#include <string>

namespace reliefbake {

class ShaderCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    struct Options {
        std::string file;
        ShaderLanguage language = ShaderLanguage::glsl;
        MapHints hints;
    } options_;
};

} // namespace reliefbake
