#pragma once
// reliefbake bench shape

#include "bake/distance_transform.h"
#include "bake/simd.h"
#include "cli/command.h"

#include <nlohmann/json.hpp>

#include <string>

namespace reliefbake {

class BenchShapeCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    Result<nlohmann::json> time_picture(const std::string& name) const;

    std::string picture_;  ///< --picture: one of them; else all
    int size_ = 4096;      ///< --size
    int threads_ = 0;      ///< --threads
    int repeat_ = 5;       ///< --repeat
    DistanceTo to_ = DistanceTo::centres;
    Simd simd_ = Simd::automatic;
    bool plain_ = false, peers_ = false, json_ = false;
};

} // namespace reliefbake
