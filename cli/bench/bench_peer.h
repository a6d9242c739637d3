#pragma once
// reliefbake bench peer METHOD MAP -o OUT

#include "cli/bench/peers.h"
#include "cli/command.h"
#include "formats/map_file.h"

#include <string>

namespace reliefbake {

class BenchPeerCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    Result<void> check_output(const ReliefMapInfo& info) const;

    Peer peer_;
    std::string file_;
    std::string output_;
    MapHints hints_;
    int threads_ = 0;
    bool json_ = false;
};

} // namespace reliefbake
