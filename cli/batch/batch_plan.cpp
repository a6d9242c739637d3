#include "cli/batch/batch_plan.h"

#include "cli/batch/glob.h"
#include "cli/batch/predict.h"
#include "cli/batch/run_command.h"
#include "cli/output_checks.h"
#include "formats/mesh_file.h"

#include <algorithm>
#include <map>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

fs::path resolved(const fs::path& path) {
    std::error_code ignored;
    fs::path name = fs::weakly_canonical(fs::absolute(path), ignored);
    if (name.empty()) name = fs::absolute(path).lexically_normal();
    return name;
}

bool is_below(const fs::path& path, const fs::path& folder) {
    const fs::path relative = path.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != ".." && relative != ".";
}

/// What the whole plan must not do; looked at asset by asset.
class OutputGate {
  public:
    OutputGate(const std::vector<SourceFile>& sources, const fs::path& out) : out_(resolved(out)) {
        for (const SourceFile& source : sources) inputs_.emplace(identity_of(source.path), source.path.string());
    }

    void add_input(const fs::path& path) { inputs_.emplace(identity_of(path), path.string()); }

    Result<void> add(const BatchJob& job) {
        for (const std::string& name : job.outputs) {
            const fs::path file = out_ / name;
            const std::string told = file.string() + ", baked from " + job.source + " (" + job.rule + ")";
            if (!is_below(resolved(file), out_)) return fail(ErrorCode::usage, told + ": leaves the output folder, by a symbolic link");
            const std::string identity = identity_of(file);
            if (const auto [other, fresh] = outputs_.emplace(identity, &job); !fresh && other->second != &job)
                return fail(ErrorCode::usage, told + ": would be baked from " + other->second->source + ", too" + (other->second->id == name ? "" : " (" + other->second->id + ")") +
                                                  "; tell them apart by {from} or folders in the output's name");
        }
        return {};
    }

    /// Once all are known.
    Result<void> check_against_inputs() const {
        for (const auto& [identity, job] : outputs_) {
            if (const auto input = inputs_.find(identity); input != inputs_.end())
                return fail(ErrorCode::usage, input->second + ": is an input, and would be overwritten by what is baked from " + job->source);
            for (fs::path above = fs::path(identity).parent_path(); above.native().size() > out_.native().size(); above = above.parent_path())
                if (const auto file = outputs_.find(above.string()); file != outputs_.end())
                    return fail(ErrorCode::usage, file->second->id + ": would be a file, and a folder for what is baked from " + job->source);
        }
        return {};
    }

  private:
    fs::path out_;
    std::map<std::string, std::string> inputs_;
    std::map<std::string, const BatchJob*> outputs_;
};

class Planner {
  public:
    explicit Planner(const fs::path& out) : out_(out) {}

    Result<BatchJob> plan(const SourceFile& source, const FileRule& rule, const BakeRule& bake) const {
        const fs::path name = source.relative;
        const std::string from = name.extension().string();
        Placeholders values{name.stem().string(), from.empty() ? "" : lower(from.substr(1)), bake.kind, source.path.parent_path().string(), ""};
        if (values.folder.empty()) values.folder = ".";
        const fs::path output = (name.parent_path() / fill_in(bake.output, values)).lexically_normal();
        values.out = (out_ / output).parent_path().string();

        BatchJob job;
        job.source = source.relative, job.rule = rule.name, job.kind = bake.kind, job.input = source.path;
        job.id = output.generic_string();
        for (const std::string& option : bake.options) job.options.push_back(fill_in(option, values));
        const Result<CommandFiles> files = files_of_command(command_line(job, out_, 1));
        if (!files) return fail(ErrorCode::usage, rule.name + ", for " + source.path.string() + ": " + files.error().message);

        job.inputs = files->inputs;
        for (const fs::path& beside : mesh_buffer_files(source.path)) job.inputs.push_back(beside);
        for (const fs::path& file : files->outputs) {
            const fs::path plain = fs::absolute(file).lexically_normal().lexically_relative(fs::absolute(out_).lexically_normal());
            if (plain.empty() || *plain.begin() == "..")
                return fail(ErrorCode::usage, rule.name + ", for " + source.path.string() + ": " + file.string() + " lies outside of --out; begin with {out}/");
            job.outputs.push_back(plain.generic_string());
        }
        job.arguments = files->arguments;
        job.max_bytes = files->max_bytes;
        job.predicted = predict_bake(bake.kind, *files);
        return job;
    }

  private:
    const fs::path& out_;
};

bool is_text(const std::string& name) {
    const nlohmann::json quoted(name);
    try {
        (void)quoted.dump();
        return true;
    } catch (const nlohmann::json::type_error&) {
        return false;
    }
}

} // namespace

bool takes_memory(const BatchJob& job) {
    return job.kind == "cone" && std::find(job.options.begin(), job.options.end(), "--memory") == job.options.end();
}

bool can_stream(const BatchJob& job) {
    const std::string extension = lower(fs::path(job.id).extension().string());
    return takes_memory(job) && (extension == ".exr" || extension == ".tif" || extension == ".tiff");
}

std::vector<std::string> command_line(const BatchJob& job, const fs::path& out, int threads) {
    std::vector<std::string> words{job.kind, job.input.string(), "-o", (out / job.id).string(), "--threads", std::to_string(threads), "--json"};
    words.insert(words.end(), job.options.begin(), job.options.end());
    return words;
}

Result<BatchPlan> plan_batch(const std::vector<SourceFile>& sources, const Recipe& recipe, const fs::path& out) {
    BatchPlan plan{out, {}, {}};
    const Planner planner(plan.out);
    for (const SourceFile& source : sources) {
        if (!is_text(source.relative)) return fail(ErrorCode::usage, source.path.string() + ": its name is not UTF-8; rename it or leave it out");
        const FileRule* rule = rule_for(recipe, source.relative, source.path);
        if (!rule) plan.skipped.push_back({source.relative, "no rule is for it"});
        else if (rule->bakes.empty()) plan.skipped.push_back({source.relative, rule->skip});
        else
            for (const BakeRule& bake : rule->bakes) {
                Result<BatchJob> job = planner.plan(source, *rule, bake);
                if (!job) return tl::unexpected(job.error());
                plan.jobs.push_back(std::move(*job));
            }
    }
    OutputGate gate(sources, plan.out);
    for (const BatchJob& job : plan.jobs) {
        for (const fs::path& input : job.inputs) gate.add_input(input);
        if (Result<void> added = gate.add(job); !added) return tl::unexpected(added.error());
    }
    if (Result<void> apart = gate.check_against_inputs(); !apart) return tl::unexpected(apart.error());
    return plan;
}

} // namespace reliefbake
