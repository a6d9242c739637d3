#include "cli/build_options.h"

#include "cli/depfile.h"
#include "cli/output_checks.h"
#include "formats/atomic_file.h"
#include "formats/mesh_file.h"

namespace reliefbake {

void BuildOptions::add_to(CLI::App& app) {
    app.option_defaults()->group("Build systems");
    CLI::Option* file = app.add_option("--depfile", depfile, "(or -MF) Write what was read, in the syntax of make")->type_name("FILE");
    app.add_option("--depfile-target", target, "(or -MT) The target that it names (default: the output)")->type_name("NAME")->needs(file);
    app.add_flag("--if-changed", if_changed, "Leave an output that would get the bytes it has, with its time");
}

Result<void> BuildOptions::begin(const PlannedCommand& command) const {
    leave_equal_files(if_changed);
    if (depfile.empty()) return {};
    const Result<CommandFiles> files = command.files();
    if (!files) return tl::unexpected(files.error());
    for (const auto* names : {&files->inputs, &files->outputs})
        for (const std::filesystem::path& name : *names)
            if (identity_of(name) == identity_of(depfile)) return fail(ErrorCode::usage, "-MF " + depfile + ": is a file of this bake; name another");
    return {};
}

Result<void> BuildOptions::end(const PlannedCommand& command) const {
    if (depfile.empty()) return {};
    Result<CommandFiles> files = command.files();
    if (!files) return tl::unexpected(files.error());
    for (const std::filesystem::path& beside : mesh_buffer_files(files->inputs.front())) files->inputs.push_back(beside);
    const Result<std::string> text = depfile_text({target.empty() ? files->outputs.front().string() : target}, files->inputs);
    if (!text) return tl::unexpected(text.error());
    return write_file_atomically(depfile, *text);
}

std::vector<std::string> with_long_options(int argc, char** argv) {
    std::vector<std::string> words;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        words.push_back(word == "-MF" ? "--depfile" : word == "-MT" ? "--depfile-target" : word);
    }
    return words;
}

} // namespace reliefbake
