#pragma once
// The keys of an asset, whichever file they stand in.

#include "cli/scene/scene.h"

#include <functional>
#include <map>
#include <variant>

namespace reliefbake {

/// What a key holds; `std::monostate`: something that no key of a scene takes.
using SceneValue = std::variant<std::monostate, bool, double, std::string, std::vector<std::string>>;
using SceneKeys = std::map<std::string, SceneValue>;

/// A path as a scene names it, to a path that opens. May refuse it (usage).
using ResolvePath = std::function<Result<std::string>(const std::string& path)>;

/// An asset of these keys, checked (scene_rules.h). `name`: its name where the keys have none. `place`: the file, for messages.
/// Errors (usage): an unknown key, a value of another kind, what resolve and check_asset refuse.
Result<SceneAsset> asset_of(const SceneKeys& keys, const std::string& name, const ResolvePath& resolve, const std::string& place);

/// Refuses (usage) two assets of one name, also where only the case of its letters differs: their maps would be one file.
Result<void> check_names(const Scene& scene);

} // namespace reliefbake
