#include "cli/batch/run_command.h"

#include "cli/command_output.h"

#include <algorithm>
#include <new>

namespace reliefbake {

namespace {

/// The command with its options set.
Result<std::unique_ptr<Command>> parse_command(const std::vector<std::string>& words) {
    for (const CommandEntry& entry : commands()) {
        if (words.front() != entry.path) continue;
        std::unique_ptr<Command> command = entry.make();
        CLI::App app;
        app.set_help_flag();
        command->add_to(app);
        try {
            app.parse(std::vector<std::string>(words.rbegin(), words.rend() - 1)); // CLI11 takes them from the back
        } catch (const CLI::ParseError& error) {
            std::string text = error.what();
            std::replace(text.begin(), text.end(), '\n', ' ');
            return fail(ErrorCode::usage, words.front() + ": " + text);
        }
        return command;
    }
    return fail(ErrorCode::usage, words.front() + ": no such command");
}

} // namespace

Result<CommandResult> run_command(const std::vector<std::string>& words) {
    CapturedOutput output;
    try {
        const Result<std::unique_ptr<Command>> command = parse_command(words);
        if (!command) return tl::unexpected(command.error());
        if (const Result<void> done = (*command)->run(); !done) return tl::unexpected(done.error());
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::budget, "out of memory");
    } catch (const std::exception& error) {
        return fail(ErrorCode::internal, std::string("internal fault: ") + error.what());
    }
    return CommandResult{std::move(output.result), std::move(output.warnings)};
}

Result<CommandFiles> files_of_command(const std::vector<std::string>& words) {
    const Result<std::unique_ptr<Command>> command = parse_command(words);
    if (!command) return tl::unexpected(command.error());
    const auto* planned = dynamic_cast<const PlannedCommand*>(command->get());
    return planned ? planned->files() : fail(ErrorCode::usage, words.front() + ": bakes no single file");
}

} // namespace reliefbake
