// The readers of meshes on arbitrary bytes, and the bake of what they take.

#include "formats/mesh/readers.h"
#include "mesh/quadric_bake.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace reliefbake;
    if (size < 1) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const MeshBudget budget{1 << 24};
    const std::string name = "fuzz";
    Result<MeshFile> file = [&] {
        switch (data[0] % 5) {
        case 0: return parse_obj(bytes, budget, name);
        case 1: return parse_ply(bytes, budget, name);
        case 2: return parse_off(bytes, budget, name);
        case 3: return parse_stl(bytes, budget, name);
        default: return parse_gltf(bytes, "/nonexistent", budget, name);
        }
    }();
    if (!file) return 0;
    QuadricOptions options;
    options.threads = 1;
    for (const Mesh& mesh : file->meshes)
        if (!bake_quadrics(mesh, options, name)) __builtin_trap();
    return 0;
}
