#pragma once
// Which keys mean something together: no key of a scene is read and then ignored.

#include "cli/scene/scene.h"

#include <set>

namespace reliefbake {

/// Refuses (usage) values out of range, keys that change nothing in what the asset needs, and needs that nothing can serve. `given`: the
/// keys that stand in the file; `place`: the file and the asset, for messages.
Result<void> check_asset(const SceneAsset& asset, const std::set<std::string>& given, const std::string& place);

/// Refuses (usage) a name that is no file's name on every system: empty, with '/', '\', control characters and other signs that some
/// system keeps for itself, a dot or blank at either end, longer than 100 bytes.
Result<void> check_asset_name(const std::string& name, const std::string& place);

} // namespace reliefbake
