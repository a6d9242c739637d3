#include "cli/batch/batch_sources.h"

#include "cli/batch/recipe.h"
#include "cli/batch/sources.h"

namespace reliefbake {

void BatchSources::add_to(CLI::App& app) {
    app.add_option("SOURCES", sources, "Folders (searched through), 'GLOB's (* ? [..] **), files, or @LIST: a file with a name a line")->required()->type_name("DIR|GLOB|FILE|@LIST");
    app.option_defaults()->group("What is baked");
    app.add_option("--out", out, "Folder for the results, in the folders of their sources")->required()->type_name("DIR");
    CLI::Option* toml = app.add_option("--recipe", recipe, "Which files become what, with which options (docs/BATCH.md; default: heights cone, shapes shape, meshes quadric)")->type_name("TOML");
    app.add_option("--name", name, "Names of the built-in recipe's results: {stem}, {kind}, {from}: the source's extension (default {stem}_{kind})")->excludes(toml);
}

Result<BatchPlan> BatchSources::plan() const {
    if (const std::string wrong = name_fault(name); !wrong.empty()) return fail(ErrorCode::usage, "--name " + name + ": " + wrong);
    const Result<Recipe> read = recipe.empty() ? Result<Recipe>(built_in_recipe(name)) : read_recipe(recipe);
    if (!read) return tl::unexpected(read.error());
    const Result<std::vector<SourceFile>> files = find_sources(sources, out);
    if (!files) return tl::unexpected(files.error());
    return plan_batch(*files, *read, out);
}

std::vector<std::string> BatchSources::words() const {
    std::vector<std::string> words = sources;
    words.insert(words.end(), {"--out", out});
    if (!recipe.empty()) words.insert(words.end(), {"--recipe", recipe});
    else if (name != BatchSources().name) words.insert(words.end(), {"--name", name});
    return words;
}

} // namespace reliefbake
