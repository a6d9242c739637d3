#pragma once
// reliefbake merge BAND... -o OUT; reliefbake merge --out DIR

#include "cli/command.h"

#include <string>
#include <vector>

namespace reliefbake {

class MergeCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    Result<void> merge_batch() const;

    std::vector<std::string> inputs_;
    std::string output_, out_;
    int threads_ = 0;
    bool json_ = false, quiet_ = false;
};

} // namespace reliefbake
