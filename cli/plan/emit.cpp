#include "cli/plan/emit.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

bool is_plain(char c) { return std::isalnum(static_cast<unsigned char>(c)) || std::string_view("_-./=+,:@%").find(c) != std::string_view::npos; }

std::string shell_line(const std::vector<std::string>& words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_quoted(word);
    return line;
}

/// As a job that shares the machine with others: one thread, no words unless something is wrong.
std::vector<std::string> command_of(const BatchJob& job, const BatchPlan& plan, const EmitOptions& options) {
    std::vector<std::string> words{options.program, job.kind, job.input.string(), "-o", (plan.out / job.id).string(), "--threads", "1", "--quiet"};
    words.insert(words.end(), job.options.begin(), job.options.end());
    return words;
}

Result<void> refuse_line_breaks(const std::string& line, const BatchJob& job, const char* what) {
    if (line.find_first_of("\n\r") == line.npos) return {};
    return fail(ErrorCode::usage, job.source + ": its name or an option has a line break, which " + what + " cannot say");
}

std::string ninja_path(const std::string& path) {
    std::string text;
    for (const char c : path) {
        if (c == ' ' || c == ':' || c == '$') text += '$';
        text += c;
    }
    return text;
}

std::string ninja_value(const std::string& text) {
    std::string escaped;
    for (const char c : text) escaped += c == '$' ? "$$" : std::string(1, c);
    return escaped;
}

/// Some assets that failed are no reason to run a task again: `merge` tells of them.
std::string run_line(const EmitOptions& options) {
    std::vector<std::string> words{options.program, "run"};
    words.insert(words.end(), options.batch.begin(), options.batch.end());
    words.insert(words.end(), {"--shards", std::to_string(options.shards)});
    return shell_line(words) + " || [ $? -eq 3 ]";
}

} // namespace

std::string shell_quoted(const std::string& text) {
    if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

Result<std::string> emit_commands(const BatchPlan& plan, const EmitOptions& options) {
    std::string text;
    for (const BatchJob& job : plan.jobs) {
        const std::string line = "mkdir -p " + shell_quoted((plan.out / job.id).parent_path().string()) + " && " + shell_line(command_of(job, plan, options));
        if (Result<void> plain = refuse_line_breaks(line, job, "a list of commands"); !plain) return tl::unexpected(plain.error());
        text += line + "\n";
    }
    return text;
}

Result<std::string> emit_ninja(const BatchPlan& plan, const EmitOptions& options) {
    std::string text = "# Made by `reliefbake plan --emit ninja`; to be run from " + options.folder.string() + "\nninja_required_version = 1.7\n\n"
                       "rule bake\n  command = $line --if-changed\n  description = $kind $in\n  restat = 1\n";
    for (const BatchJob& job : plan.jobs) {
        std::string line = "\nbuild " + ninja_path((plan.out / job.id).string()) + ": bake " + ninja_path(job.input.string());
        for (std::size_t k = 1; k < job.inputs.size(); ++k) line += (k == 1 ? " | " : " ") + ninja_path(job.inputs[k].string());
        const std::string command = ninja_value(shell_line(command_of(job, plan, options)));
        if (Result<void> plain = refuse_line_breaks(line.substr(1) + command, job, "a build.ninja"); !plain) return tl::unexpected(plain.error());
        text += line + "\n  kind = " + job.kind + "\n  line = " + command + "\n";
    }
    return text;
}

Result<std::string> emit_slurm(const EmitOptions& options) {
    return "#!/bin/sh\n"
           "# Made by `reliefbake plan --emit slurm`: sbatch THIS, then `reliefbake merge`. A task that is killed is run again and goes on where it was.\n"
           "#SBATCH --job-name=reliefbake\n#SBATCH --array=0-" + std::to_string(options.shards - 1) + "\n#SBATCH --requeue\n"
           "cd " + shell_quoted(options.folder.string()) + " || exit\n" + run_line(options) + "\n";
}

Result<std::string> emit_k8s(const EmitOptions& options) {
    const nlohmann::ordered_json volume = {{"name", "assets"}, {"persistentVolumeClaim", {{"claimName", options.claim}}}};
    const nlohmann::ordered_json container = {{"name", "reliefbake"},
                                              {"image", options.image},
                                              {"workingDir", options.folder.string()},
                                              {"command", {"sh", "-c", run_line(options)}},
                                              {"volumeMounts", {{{"name", "assets"}, {"mountPath", options.folder.string()}}}}};
    const nlohmann::ordered_json job = {
        {"apiVersion", "batch/v1"},
        {"kind", "Job"},
        {"metadata", {{"name", "reliefbake"}}},
        {"spec",
         {{"completions", options.shards},
          {"parallelism", options.shards},
          {"completionMode", "Indexed"},
          {"template", {{"spec", {{"restartPolicy", "OnFailure"}, {"containers", nlohmann::ordered_json::array({container})}, {"volumes", nlohmann::ordered_json::array({volume})}}}}}}}};
    return job.dump(2) + "\n";
}

} // namespace reliefbake
