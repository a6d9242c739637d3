#pragma once
// reliefbake bench cone [FILE | --field NAME --size N]

#include "bake/acm_adaptive.h"
#include "bake/cone.h"
#include "bake/simd.h"
#include "cli/bench/compare_maps.h"
#include "cli/command.h"
#include "cli/cone/family_options.h"
#include "formats/read_image.h"

#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

class BenchConeCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    struct Subject {
        std::string name;
        DepthMap depth;
    };

    Result<std::vector<Subject>> subjects() const;
    Result<Subject> file_subject() const;

    std::string file_;
    ReadOptions read_;
    HeightOptions height_;
    std::string field_; ///< --field: one synthetic field; with neither FILE nor --field, all of them
    int size_ = 1024;   ///< --size, of synthetic fields
    int repeat_ = 5;    ///< --repeat: the fastest run counts
    ConeOptions cone_;
    FamilyOptions family_;
    int sectors_ = 1; ///< --sectors: 1, or an anisotropic map
    std::optional<int> adaptive_levels_; ///< --adaptive: 002's Algorithm 1 beside the exact sectors
    double similarity_ = AdaptiveOptions().similarity;
    int levels_ = 1;  ///< --levels: 1, or a stack
    int method_ = 1;  ///< --method: of a stack
    Simd simd_ = Simd::automatic;
    bool peers_ = false;   ///< --peers: time the ways others bake
    bool compare_ = false; ///< --compare: what safety costs and what others' maps miss
    bool json_ = false;
};

} // namespace reliefbake
