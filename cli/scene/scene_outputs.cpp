#include "cli/scene/scene_outputs.h"

#include "cli/output_checks.h"
#include "cli/scene/bake_job.h"

#include <filesystem>
#include <map>
#include <unistd.h>

namespace reliefbake {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> inputs_of(const Scene& scene) {
    std::vector<std::string> inputs = {scene.file};
    for (const SceneAsset& asset : scene.assets)
        for (const std::string& file : {asset.height, asset.shape, asset.mesh, asset.alpha})
            if (!file.empty()) inputs.push_back(file);
    inputs.insert(inputs.end(), scene.other_files.begin(), scene.other_files.end());
    return inputs;
}

/// The folder itself, or the nearest above it that exists.
fs::path existing_folder(const std::string& folder) {
    fs::path path = fs::absolute(folder).lexically_normal();
    std::error_code ignored;
    while (!fs::exists(path, ignored) && path.has_parent_path() && path.parent_path() != path) path = path.parent_path();
    return path;
}

Result<void> check_folder(const std::string& folder) {
    const fs::path existing = existing_folder(folder);
    std::error_code ignored;
    if (!fs::is_directory(existing, ignored)) return fail(ErrorCode::cannot_create, folder + ": cannot create the folder: " + existing.string() + " is no folder");
    if (access(existing.c_str(), W_OK | X_OK) == 0) return {};
    return fail(ErrorCode::cannot_create, folder + ": cannot create files in " + existing.string() + ": permission denied");
}

} // namespace

Result<void> check_outputs(const Scene& scene, const ScenePlan& plan, const std::string& folder) {
    if (Result<void> writable = check_folder(folder); !writable) return writable;
    std::map<std::string, std::string> inputs, outputs; // by identity: the name
    for (const std::string& input : inputs_of(scene)) inputs.emplace(identity_of(input), input);
    for (const SceneJob& job : plan.jobs)
        for (const SceneMap& map : job.maps)
            for (const SceneFile& file : map.files) {
                const std::string path = folder + "/" + file.name;
                const std::string identity = identity_of(path);
                const std::string asset = map.uses.empty() ? map.what : "asset '" + scene.assets[map.uses.front().asset].name + "'";
                if (const auto input = inputs.find(identity); input != inputs.end())
                    return fail(ErrorCode::usage, path + ": would be written for " + asset + " and is an input of the scene (" + input->second + "); choose another folder or name");
                for (const auto& [same, input] : inputs)
                    if (Result<void> other = validate_not_input(input, path); !other) return other; // one file by two names
                if (const auto [known, is_new] = outputs.emplace(identity, map.output); !is_new)
                    return fail(ErrorCode::usage, path + ": would be written for " + asset + " and by the map " + known->second + "; rename an asset");
                std::error_code ignored;
                if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored)) return fail(ErrorCode::cannot_create, path + ": cannot create the file: something else has its name");
            }
    return {};
}

Result<void> check_jobs(const ScenePlan& plan, const std::string& folder) {
    const std::string prefix = (existing_folder(folder) / ".reliefbake-planned-").string(); // names that no input has
    for (const SceneJob& job : plan.jobs)
        if (Result<void> fits = check_job(job, prefix); !fits) return fail(fits.error().code, job.input + ": " + fits.error().message);
    return {};
}

Result<void> make_output_folder(const std::string& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return fail(ErrorCode::cannot_create, folder + ": cannot create the folder: " + error.message());
    return {};
}

} // namespace reliefbake
