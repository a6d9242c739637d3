#pragma once
// Appends typed arrays to a glTF document: bytes, buffer views, accessors.

#include "formats/mesh/writers.h"

#include <bit>

namespace reliefbake {

/// All that is added lies in one new buffer, the document's last.
class GltfBuilder {
  public:
    explicit GltfBuilder(const GltfSource& source) : json_(source.document), buffers_(source.buffers) {}

    nlohmann::ordered_json& document() { return json_; }
    const std::vector<std::string>& buffers() const { return buffers_; }

    enum class Use { vertices = 34962, indices = 34963 };

    /// Bytes of `count` elements, each padded to a multiple of 4 for vertices; returns the view's number.
    std::size_t add_view(std::string_view bytes, std::size_t count, Use use);
    std::size_t add_accessor(nlohmann::ordered_json accessor);

    /// Floats, `components` a vertex. Returns the accessor's number.
    std::size_t add_floats(std::span<const float> values, int components);
    /// Triangles of vertices below `vertex_count`, in 16 bits where they fit.
    std::size_t add_indices(std::span<const Triangle> triangles, std::uint32_t first_vertex, std::uint32_t vertex_count);

    GltfDocument take();

  private:
    nlohmann::ordered_json json_;
    std::vector<std::string> buffers_;
    std::string added_;
};

} // namespace reliefbake
