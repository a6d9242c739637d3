#pragma once
// From what assets need to the bakes that make it, and nothing more.

#include "bake/error.h"
#include "cli/scene/map_need.h"
#include "cli/scene/scene.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace reliefbake {

/// What was found out about an asset's sources, and chosen by it. Of an asset without such a source: 0, or the default.
struct AssetFacts {
    int width = 0, height = 0;     ///< texels of the height or the shape
    BitDepth bits = BitDepth::unorm16;
    int level = 0;
    int sectors = 4;               ///< technique sectors
    double stored_error = 0;       ///< height that the stored surface is off at most, in `bits` at `level`
    std::uint64_t mesh_bytes = 0;  ///< of the mesh with its quadrics
    std::uint64_t mesh_vertices = 0;
    std::string note;              ///< how it was chosen, for people; empty: nothing was
};

/// One file to be written.
struct SceneFile {
    std::string name;        ///< in the output folder
    int width = 0, height = 0, channels = 0, bits = 0; ///< 0 for a mesh. `bits`: of a sample
    std::uint64_t bytes = 0; ///< of its texels, uncompressed; of a mesh, its arrays
};

/// An asset that a map serves, and how.
struct SceneUse {
    std::size_t asset;
    std::string as; ///< "relief", "ambient", "normals", "horizons", "shape", "quadrics"
};

/// One map: one run of a command, or one of several maps of a run.
struct SceneMap {
    std::string command;              ///< cone, acm, cone-normal, bump, shape, quadric
    std::string what;                 ///< "cones", "relaxed cones", "8 sectors", "depth and normals", ...
    std::vector<std::string> options; ///< of its own, without -o
    std::string output;               ///< name of its first file
    std::vector<SceneFile> files;
    std::vector<SceneUse> uses;
    std::uint64_t units = 0; ///< texels of all levels, or vertices: what its time goes with
    std::uint64_t bytes() const;
};

/// One run over one source.
struct SceneJob {
    std::string input;
    std::vector<std::string> source_options; ///< --channel and the like
    std::vector<SceneMap> maps;              ///< several only where one run can make them (cone, acm, cone-normal)
};

struct ScenePlan {
    std::vector<SceneJob> jobs;
    std::uint64_t bytes() const;
    double predicted_seconds() const; ///< predicted_seconds(map), over all
};

/// The bakes of a checked scene: each asset has its facts. Maps are named after the first asset that uses them.
/// Errors (budget): more than most_needs different needs of one source.
Result<ScenePlan> plan_scene(const Scene& scene, const std::vector<AssetFacts>& facts);

/// What "bake everything" bakes: of every height each kind of map that scenes know, at full resolution with 16 bits and all levels; of
/// every shape its map, of every mesh its quadrics; each source once, those of assets that need nothing too.
ScenePlan plan_everything(const Scene& scene, const std::vector<AssetFacts>& facts);

} // namespace reliefbake
