#pragma once
// reliefbake verify MAP

#include "cli/command.h"
#include "cli/options/solid_options.h"
#include "cli/options/technique_options.h"
#include "cli/verify/verify_mesh.h"
#include "formats/map_file.h"
#include "formats/read_image.h"
#include "shaders-reference/measure/verify.h"

#include <string>

namespace reliefbake {

class VerifyCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    Result<void> run_bump(const std::string& kind) const;
    Result<void> run_shape() const;
    Result<void> run_mesh(const std::string& kind, int threads) const;
    Result<DepthMap> read_source(const ReliefMap& map) const;

    struct Options {
        std::string file;
        std::string source;   ///< the height map that the map was baked from
        ReadOptions read;
        HeightOptions height; ///< of the source
        std::string pictures; ///< folder
        MapHints hints;
        VerifyOptions verify;
        TechniqueOptions technique;
        bool json = false;
        SolidOptions solid;
        VerifyMeshOptions mesh;
    } options_;
    const CLI::App* app_ = nullptr; ///< knows which options were given
};

} // namespace reliefbake
