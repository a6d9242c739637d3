#pragma once
// Accessors of a glTF document: typed arrays inside buffers, sparse ones too.

#include "bake/error.h"
#include "formats/mesh/readers.h"

#include <tiny_gltf.h>

#include <string>
#include <vector>

namespace reliefbake {

/// An accessor's elements side by side, without gaps.
struct GltfArray {
    std::string bytes;
    std::size_t count = 0;
    int component_type = 0, components = 0;
    bool normalized = false;

    std::size_t element_bytes() const;
    double number(std::size_t element, int component) const; ///< integers as they are, or over their range where normalized
};

/// Checks every range before it is read. Errors: bad_data.
Result<GltfArray> read_accessor(const tinygltf::Model& model, int accessor, const MeshBudget& budget, const std::string& name);

} // namespace reliefbake
