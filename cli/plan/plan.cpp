#include "cli/plan/plan.h"

#include "cli/choices.h"
#include "cli/plan/emit.h"
#include "formats/atomic_file.h"

#include <cstdio>
#include <filesystem>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

/// This program, wherever it is called from.
std::string own_path() {
    std::error_code error;
    const fs::path path = fs::read_symlink("/proc/self/exe", error);
    return error ? "reliefbake" : path.string();
}

} // namespace

void PlanCommand::add_to(CLI::App& app) {
    static const Words<Emit> emit_words = {{"commands", Emit::commands}, {"ninja", Emit::ninja}, {"slurm", Emit::slurm}, {"k8s", Emit::k8s}};
    given_.add_to(app);
    app.option_defaults()->group("What is printed");
    add_choice(app, "--emit", emit_, emit_words, "A command line a job; a build.ninja; a script for sbatch; a manifest for kubectl")->required();
    app.add_option("--shards", shards_, "Parts that slurm and k8s run at once")->check(CLI::Range(1, 100000))->type_name("N");
    app.add_option("--program", program_, "The tool, where the work is done (default: this one; in a k8s container reliefbake)")->type_name("PATH");
    app.add_option("--image", image_, "k8s: the container image that holds the tool");
    app.add_option("--claim", claim_, "k8s: the persistent volume claim that holds this folder");
    app.add_option("-o,--output", file_, "File to write (default: standard output)")->type_name("FILE");
}

Result<void> PlanCommand::check_options() const {
    const bool sharded = emit_ == Emit::slurm || emit_ == Emit::k8s, k8s = emit_ == Emit::k8s;
    if (sharded && !shards_) return fail(ErrorCode::usage, "--emit slurm and k8s: name --shards N");
    if (!sharded && shards_) return fail(ErrorCode::usage, "--shards: is for --emit slurm and k8s");
    if (k8s && (image_.empty() || claim_.empty())) return fail(ErrorCode::usage, "--emit k8s: name --image and --claim");
    if (!k8s && !(image_.empty() && claim_.empty())) return fail(ErrorCode::usage, "--image, --claim: are for --emit k8s");
    return {};
}

Result<std::string> PlanCommand::text() const {
    const Result<BatchPlan> plan = given_.plan(); // refuses what could not be baked, for all
    if (!plan) return tl::unexpected(plan.error());
    const EmitOptions options{!program_.empty() ? program_ : emit_ == Emit::k8s ? "reliefbake" : own_path(), fs::current_path(), shards_, given_.words(), image_, claim_};
    switch (emit_) {
    case Emit::commands: return emit_commands(*plan, options);
    case Emit::ninja: return emit_ninja(*plan, options);
    case Emit::slurm: return emit_slurm(options);
    case Emit::k8s: return emit_k8s(options);
    }
    return fail(ErrorCode::internal, "no such text");
}

Result<void> PlanCommand::run() {
    if (Result<void> checked = check_options(); !checked) return checked;
    const Result<std::string> text = this->text();
    if (!text) return tl::unexpected(text.error());
    if (!file_.empty()) return write_file_atomically(file_, *text);
    std::fputs(text->c_str(), stdout);
    return {};
}

} // namespace reliefbake
