#pragma once
// The commands that bake cones, all from the same stages: cone, acm, cone-normal, cone-stack.

#include "cli/cone/bake_command.h"

namespace reliefbake {

/// One cone a texel at most: depth, and with --channels what is wanted of normals and cones.
class SingleConeCommand : public BakeCommand {
  public:
    void add_to(CLI::App& app) final;
    Result<ConeCommandOptions> given() const final;

  protected:
    void add_single_cone_result_options(CLI::App& app);

  private:
    const CLI::App* app_ = nullptr; ///< knows which options were given
};

/// reliefbake cone IN -o OUT: one cone a texel, of any family.
class ConeCommand : public SingleConeCommand {
  public:
    void add_own_options(CLI::App& app) override;
};

/// reliefbake acm IN -o OUT --sectors 4|8: one cone per sector of azimuth (002).
class AcmCommand : public BakeCommand {
  public:
    void add_own_options(CLI::App& app) override;
    Result<ConeCommandOptions> given() const override;

  private:
    enum class Method { exact, adaptive };

    Method method_ = Method::exact;
    std::optional<int> levels_;
    std::optional<double> similarity_;
};

/// reliefbake cone-normal IN -o OUT: `cone` with encoding normal and no cap (001 sec. 3.1), whose code is also a distance.
class ConeNormalCommand : public SingleConeCommand {
  public:
    void add_own_options(CLI::App& app) override;
};

/// reliefbake cone-stack IN -o OUT --levels K --method 1|2: cones stacked above each texel, or one of K pieces (001 sec. 3.4).
class ConeStackCommand : public BakeCommand {
  public:
    void add_own_options(CLI::App& app) override;
    Result<ConeCommandOptions> given() const override;

  private:
    int method_ = 1;
};

} // namespace reliefbake
