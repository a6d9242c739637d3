#pragma once
// The commands that bake other kinds of cones from the same stages: acm, cone-normal, cone-stack.

#include "cli/command.h"
#include "cli/cone_options.h"

namespace reliefbake {

/// reliefbake acm IN -o OUT --sectors 4|8: one cone per sector of azimuth (002).
class AcmCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    enum class Method { exact, adaptive };

    Method method_ = Method::exact;
    std::optional<int> levels_;
    std::optional<double> similarity_;
    ConeCommandOptions options_;
};

/// reliefbake cone-normal IN -o OUT: `cone` with encoding normal and no cap (001 sec. 3.1), whose code is also a distance.
class ConeNormalCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    ConeCommandOptions options_;
};

/// reliefbake cone-stack IN -o OUT --levels K --method 1|2: cones stacked above each texel, or one of K pieces (001 sec. 3.4).
class ConeStackCommand : public Command {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() override;

  private:
    int method_ = 1;
    ConeCommandOptions options_;
};

} // namespace reliefbake
