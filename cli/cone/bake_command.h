#pragma once
// What the commands that bake cones have in common: the options of a run, and --also.

#include "cli/command.h"
#include "cli/command_files.h"
#include "cli/cone/cone_options.h"

#include <memory>
#include <string>
#include <vector>

namespace reliefbake {

/// A command that bakes one map of cones, and with --also others of the same source.
class BakeCommand : public Command, public PlannedCommand {
  public:
    void add_to(CLI::App& app) override;
    Result<void> run() final;
    Result<CommandFiles> files() const final;

    /// Declares what may differ between the maps of one run: what is baked, how it is stored, and where.
    virtual void add_own_options(CLI::App& app) = 0;
    /// The options as given. Errors (usage): own options that do not fit each other.
    virtual Result<ConeCommandOptions> given() const { return options_; }

  protected:
    ConeCommandOptions options_;

  private:
    std::vector<std::string> also_;
};

/// The command of this name: cone, acm, cone-normal, cone-stack; null for any other.
std::unique_ptr<BakeCommand> make_bake_command(const std::string& name);

/// Parses "COMMAND OPTIONS -o OUT" as that command parses them; source, proportions, threads and output to the terminal are those
/// of `run`. Errors (usage): no such command, what the command refuses, an option that is the run's; the message begins with the text.
Result<ConeCommandOptions> parse_also(const std::string& text, const ConeCommandOptions& run);

/// Plans of a run: the first map, and those of --also. Errors: those of parse_also, plan_cone, validate_outputs.
Result<std::vector<ConePlan>> plan_maps(const ConeCommandOptions& first, const std::vector<std::string>& also);

} // namespace reliefbake
