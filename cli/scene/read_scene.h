#pragma once
// Scene files: TOML, or glTF whose materials name height maps in their extras.

#include "cli/scene/scene.h"

namespace reliefbake {

/// By the file's extension: .toml, .gltf or .glb. Every key is checked (scene_rules.h); the sources are not opened. Paths of a TOML file
/// start from its folder; those of a glTF are URIs that never leave its folder, links followed.
/// Errors: no_input; usage (another extension, keys: see asset_of; no assets; two of one name); bad_data (not TOML, JSON or glTF, nested too deep, too large).
Result<Scene> read_scene(const std::string& file);

Result<Scene> read_scene_toml(const std::string& file);
Result<Scene> read_scene_gltf(const std::string& file);

} // namespace reliefbake
