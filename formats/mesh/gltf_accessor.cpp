#include "formats/mesh/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <span>

namespace reliefbake {

namespace {

using Bytes = std::span<const unsigned char>;

/// `count` elements of `size` bytes at `offset` inside a view, `stride` bytes apart; empty where they do not fit.
struct Strided {
    Bytes bytes;
    std::size_t stride;
};

std::optional<Strided> find_elements(const tinygltf::Model& model, int view_index, std::size_t offset, std::size_t count, std::size_t size,
                                     bool strided) {
    if (view_index < 0 || std::size_t(view_index) >= model.bufferViews.size()) return std::nullopt;
    const tinygltf::BufferView& view = model.bufferViews[std::size_t(view_index)];
    if (view.buffer < 0 || std::size_t(view.buffer) >= model.buffers.size()) return std::nullopt;
    const Bytes buffer(model.buffers[std::size_t(view.buffer)].data);
    if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) return std::nullopt;
    const Bytes whole = buffer.subspan(view.byteOffset, view.byteLength);
    const std::size_t stride = strided && view.byteStride > 0 ? view.byteStride : size;
    if (stride < size || offset > whole.size()) return std::nullopt;
    const Bytes rest = whole.subspan(offset);
    if (count > 0 && (rest.size() < size || (rest.size() - size) / stride < count - 1)) return std::nullopt;
    return Strided{rest, stride};
}

/// Indices of 8, 16 or 32 bits.
std::size_t index_at(const unsigned char* bytes, int size) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes, std::size_t(size));
    return value;
}

bool apply_sparse(const tinygltf::Model& model, const tinygltf::Accessor& a, GltfArray& array) {
    const int index_size = tinygltf::GetComponentSizeInBytes(std::uint32_t(a.sparse.indices.componentType));
    if (a.sparse.count < 0 || std::size_t(a.sparse.count) > array.count || index_size < 1 || index_size > 4 ||
        a.sparse.indices.byteOffset < 0 || a.sparse.values.byteOffset < 0)
        return false;
    const std::size_t count = std::size_t(a.sparse.count), size = array.element_bytes();
    const auto indices = find_elements(model, a.sparse.indices.bufferView, std::size_t(a.sparse.indices.byteOffset), count, std::size_t(index_size), false);
    const auto values = find_elements(model, a.sparse.values.bufferView, std::size_t(a.sparse.values.byteOffset), count, size, false);
    if (!indices || !values) return false;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t index = index_at(indices->bytes.data() + k * indices->stride, index_size);
        if (index >= array.count) return false;
        std::memcpy(array.bytes.data() + index * size, values->bytes.data() + k * size, size);
    }
    return true;
}

template <class T>
double number_of(const char* bytes, bool normalized, double largest) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return normalized ? std::max(double(value) / largest, -1.0) : double(value);
}

} // namespace

std::size_t GltfArray::element_bytes() const {
    return std::size_t(components) * std::size_t(tinygltf::GetComponentSizeInBytes(std::uint32_t(component_type)));
}

double GltfArray::number(std::size_t element, int component) const {
    const std::size_t size = element_bytes() / std::size_t(components);
    const char* at = bytes.data() + element * element_bytes() + std::size_t(component) * size;
    switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return number_of<std::int8_t>(at, normalized, 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return number_of<std::uint8_t>(at, normalized, 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT: return number_of<std::int16_t>(at, normalized, 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return number_of<std::uint16_t>(at, normalized, 65535);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return number_of<std::uint32_t>(at, false, 1);
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return number_of<float>(at, false, 1);
    default: return 0;
    }
}

Result<GltfArray> read_accessor(const tinygltf::Model& model, int index, const MeshBudget& budget, const std::string& name) {
    const auto refuse = [&](const std::string& what) {
        return fail(ErrorCode::bad_data, name + ": accessor " + std::to_string(index) + " " + what);
    };
    if (index < 0 || std::size_t(index) >= model.accessors.size()) return refuse("does not exist");
    const tinygltf::Accessor& a = model.accessors[std::size_t(index)];
    GltfArray array;
    array.count = a.count;
    array.component_type = a.componentType;
    array.components = tinygltf::GetNumComponentsInType(std::uint32_t(a.type));
    array.normalized = a.normalized;
    const int component_bytes = tinygltf::GetComponentSizeInBytes(std::uint32_t(a.componentType));
    if (array.components < 1 || array.components > 4 || component_bytes < 1 || component_bytes > 4) return refuse("has a type that no vertex has");
    if (a.count > budget.bytes / array.element_bytes()) return refuse("claims " + std::to_string(a.count) + " elements, over the budget; --max-bytes lifts it");

    const std::size_t size = array.element_bytes();
    array.bytes.assign(a.count * size, '\0');
    if (a.bufferView >= 0) {
        const auto elements = find_elements(model, a.bufferView, a.byteOffset, a.count, size, true);
        if (!elements) return refuse("reaches past its buffer");
        for (std::size_t k = 0; k < a.count; ++k)
            std::memcpy(array.bytes.data() + k * size, elements->bytes.data() + k * elements->stride, size);
    } else if (!a.sparse.isSparse && a.count > budget.bytes / 1024) {
        return refuse("claims many elements and has no data");
    }
    if (a.sparse.isSparse && !apply_sparse(model, a, array)) return refuse("has sparse values that make no sense");
    return array;
}

} // namespace reliefbake
