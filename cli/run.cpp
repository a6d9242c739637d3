#include "cli/run.h"

#include "cli/build_options.h"
#include "cli/command.h"
#include "cli/describe/describe.h"
#include "cli/version.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string_view>
#include <vector>

namespace reliefbake {

namespace {

/// A command whose options are declared, waiting to be chosen.
struct Declared {
    CLI::App* app;
    std::string path;
    std::unique_ptr<Command> command;
    const PlannedCommand* bake;          ///< the same, of a command that bakes one file; else null
    std::unique_ptr<BuildOptions> build; ///< with such a command
};

CLI::App* find_or_add_group(CLI::App& parent, const std::string& name) {
    const auto same_name = [&](const CLI::App* app) { return app->get_name() == name; };
    const std::vector<CLI::App*> groups = parent.get_subcommands(same_name);
    if (!groups.empty()) return groups.front();
    CLI::App* group = parent.add_subcommand(name, name + " commands");
    group->require_subcommand(1);
    return group;
}

Declared declare(CLI::App& root, const CommandEntry& entry) {
    const std::string path = entry.path;
    const std::size_t space = path.find(' ');
    CLI::App* parent = &root;
    if (space != std::string::npos) parent = find_or_add_group(root, path.substr(0, space));
    CLI::App* app = parent->add_subcommand(path.substr(space + 1), entry.summary);
    std::unique_ptr<Command> command = entry.make();
    command->add_to(*app);
    const auto* bake = dynamic_cast<const PlannedCommand*>(command.get());
    auto build = std::make_unique<BuildOptions>();
    if (bake) build->add_to(*app);
    return {app, path, std::move(command), bake, std::move(build)};
}

int report(const std::string& path, const Error& error) {
    std::fprintf(stderr, "reliefbake%s: %s\n", path.empty() ? "" : (" " + path).c_str(), error.message.c_str());
    return int(error.code);
}

/// A script that reads stdout must learn that it got less than everything.
Result<void> flush_output() {
    if (std::fflush(stdout) == 0 && !std::ferror(stdout) && std::cout.flush()) return {};
    return fail(ErrorCode::write_failed, "cannot write to standard output");
}

int run_chosen(std::vector<Declared>& declared) {
    for (Declared& candidate : declared) {
        if (!candidate.app->parsed()) continue;
        Result<void> result = candidate.bake ? candidate.build->begin(*candidate.bake) : Result<void>();
        result = result.and_then([&] { return candidate.command->run(); });
        if (candidate.bake) result = result.and_then([&] { return candidate.build->end(*candidate.bake); });
        result = result.and_then(flush_output);
        return result ? 0 : report(candidate.path, result.error());
    }
    return int(ErrorCode::usage);
}

void add_describe(CLI::App& root) {
    const auto print = [&root](const std::string& format) {
        if (format != "json") throw CLI::ValidationError("--describe", "expected json, found '" + format + "'");
        std::cout << describe(root).dump(1) << '\n';
        throw CLI::Success();
    };
    root.add_option_function<std::string>("--describe", print, "Print every command and option (cli/schema/describe.schema.json)")->type_name("json");
}

int parse_and_run(int argc, char** argv) {
    CLI::App root(
        "Offline baking for relief rendering.\n"
        "Exit status: 0 done, 1 internal fault, 2 usage, 3 some assets of a batch failed, 4 verification\n"
        "failed, 5 over budget, 65 bad input data, 66 no such input, 73/74 cannot write, 75 another run holds\n"
        "the folder, 130/143 interrupted.",
        "reliefbake");
    root.set_version_flag("--version", std::string("reliefbake ") + version());
    root.require_subcommand(1);
    add_describe(root);
    std::vector<Declared> declared;
    for (const CommandEntry& entry : commands())
        declared.push_back(declare(root, entry));
    try {
        std::vector<std::string> words = with_long_options(argc, argv);
        std::reverse(words.begin(), words.end()); // CLI11 takes them from the back
        root.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        if (root.exit(error) != 0) return int(ErrorCode::usage);
        const Result<void> flushed = flush_output();
        return flushed ? 0 : report("", flushed.error());
    }
    return run_chosen(declared);
}

} // namespace

int run_command_line(int argc, char** argv) noexcept {
    try {
        return parse_and_run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::fputs("reliefbake: out of memory\n", stderr);
        return int(ErrorCode::budget);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "reliefbake: internal fault: %s\n", error.what());
        return int(ErrorCode::internal);
    }
}

} // namespace reliefbake
