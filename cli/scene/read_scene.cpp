#include "cli/scene/read_scene.h"

#include "cli/output_checks.h"
#include "cli/scene/scene_keys.h"

namespace reliefbake {

Result<Scene> read_scene(const std::string& file) {
    const std::string extension = extension_of(file);
    const bool gltf = extension == ".gltf" || extension == ".glb";
    if (!gltf && extension != ".toml") return fail(ErrorCode::usage, file + ": expected a scene that ends in .toml, .gltf or .glb");
    Result<Scene> scene = gltf ? read_scene_gltf(file) : read_scene_toml(file);
    if (!scene) return scene;
    if (scene->assets.empty())
        return fail(ErrorCode::usage, file + (gltf ? ": no material has extras.reliefbake, which name its height map" : ": expected [[asset]] tables, found none"));
    if (Result<void> unique = check_names(*scene); !unique) return tl::unexpected(unique.error());
    return scene;
}

} // namespace reliefbake
