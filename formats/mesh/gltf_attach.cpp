// Quadrics into a glTF document that otherwise stays as it was.

#include "formats/mesh/gltf_accessor.h"
#include "formats/mesh/gltf_builder.h"

#include <algorithm>
#include <limits>

namespace reliefbake {

namespace {

using json = nlohmann::ordered_json;

/// The model that read_accessor wants, of a document that was read before: only views and accessors.
tinygltf::Model arrays_of(const GltfSource& source) {
    tinygltf::Model model;
    for (const std::string& bytes : source.buffers) {
        model.buffers.emplace_back();
        model.buffers.back().data.assign(bytes.begin(), bytes.end());
    }
    const auto number = [](const json& o, const char* key, std::int64_t otherwise) {
        const auto found = o.find(key);
        return found != o.end() && found->is_number_integer() ? found->get<std::int64_t>() : otherwise;
    };
    const auto list = [&](const char* key) { return source.document.value(key, json::array()); };
    for (const json& v : list("bufferViews")) {
        tinygltf::BufferView view;
        view.buffer = int(number(v, "buffer", -1));
        view.byteOffset = std::size_t(number(v, "byteOffset", 0)), view.byteLength = std::size_t(number(v, "byteLength", 0));
        view.byteStride = std::size_t(number(v, "byteStride", 0));
        model.bufferViews.push_back(view);
    }
    static constexpr std::pair<const char*, int> types[] = {
        {"SCALAR", TINYGLTF_TYPE_SCALAR}, {"VEC2", TINYGLTF_TYPE_VEC2}, {"VEC3", TINYGLTF_TYPE_VEC3}, {"VEC4", TINYGLTF_TYPE_VEC4}};
    for (const json& o : list("accessors")) {
        tinygltf::Accessor a;
        a.bufferView = int(number(o, "bufferView", -1)), a.byteOffset = std::size_t(number(o, "byteOffset", 0));
        a.componentType = int(number(o, "componentType", -1)), a.count = std::size_t(number(o, "count", 0));
        for (const auto& [word, type] : types)
            if (o.value("type", "") == word) a.type = type;
        if (const auto s = o.find("sparse"); s != o.end() && s->is_object()) {
            const json indices = s->value("indices", json::object()), values = s->value("values", json::object());
            a.sparse.isSparse = true, a.sparse.count = int(number(*s, "count", 0));
            a.sparse.indices = {int(number(indices, "byteOffset", 0)), int(number(indices, "bufferView", -1)), int(number(indices, "componentType", -1))};
            a.sparse.values = {int(number(values, "bufferView", -1)), int(number(values, "byteOffset", 0))};
        }
        model.accessors.push_back(a);
    }
    return model;
}

class Attacher {
  public:
    Attacher(const GltfSource& source, const QuadricStore& store, const nlohmann::json& info, const std::string& name)
        : source_(source), builder_(source), store_(store), info_(info), name_(name) {}

    Result<void> attach(std::size_t m, const Mesh& mesh, const std::vector<std::uint32_t>& source, float range) {
        for (const GltfPrimitive& share : source_.meshes[m]) {
            std::vector<std::uint32_t> vertices(share.vertex_count);
            for (std::uint32_t k = 0; k < share.vertex_count; ++k) vertices[k] = share.first_vertex + k;
            // Split vertices stand at the mesh's end; take those that copy one of ours.
            const std::uint32_t first_copy = std::uint32_t(source_vertices(m));
            for (std::uint32_t v = first_copy; v < source.size(); ++v)
                if (source[v] - share.first_vertex < share.vertex_count) vertices.push_back(v);
            Result<void> done = attach_to(share, mesh, source, vertices, range);
            if (!done) return done;
        }
        return {};
    }

    GltfDocument take() { return builder_.take(); }

  private:
    std::size_t source_vertices(std::size_t m) const {
        std::size_t count = 0;
        for (const GltfPrimitive& share : source_.meshes[m]) count += share.vertex_count;
        return count;
    }

    Result<void> attach_to(const GltfPrimitive& share, const Mesh& mesh, const std::vector<std::uint32_t>& source,
                           const std::vector<std::uint32_t>& vertices, float range) {
        json& primitive = builder_.document()["meshes"][share.mesh]["primitives"][share.primitive];
        if (vertices.size() > share.vertex_count)
            if (Result<void> copied = copy_split(primitive, share, mesh, source, vertices); !copied) return copied;
        replace_changed(primitive["attributes"], "NORMAL", vertices, mesh.normals, share);
        replace_changed(primitive["attributes"], "TANGENT", vertices, mesh.tangents, share);
        return store_quadrics(primitive["attributes"], mesh, vertices, range);
    }

    /// New arrays for all attributes, morph targets too, and new triangles.
    Result<void> copy_split(json& primitive, const GltfPrimitive& share, const Mesh& mesh, const std::vector<std::uint32_t>& source,
                            const std::vector<std::uint32_t>& vertices) {
        if (!model_) model_ = std::make_unique<tinygltf::Model>(arrays_of(source_));
        Result<void> copied = copy_arrays(primitive["attributes"], share, source, vertices);
        if (primitive.contains("targets") && primitive["targets"].is_array())
            for (json& target : primitive["targets"])
                if (copied) copied = copy_arrays(target, share, source, vertices);
        if (!copied) return copied;
        std::vector<std::uint32_t> number(source.size(), 0);
        for (std::size_t k = 0; k < vertices.size(); ++k) number[vertices[k]] = std::uint32_t(k);
        std::vector<Triangle> triangles(mesh.triangles.begin() + share.first_triangle, mesh.triangles.begin() + share.first_triangle + share.triangle_count);
        for (Triangle& t : triangles)
            for (std::uint32_t& v : t) v = number[v];
        primitive["indices"] = builder_.add_indices(triangles, 0, std::uint32_t(vertices.size()));
        primitive.erase("mode"); // strips and fans have become triangles
        return {};
    }

    Result<void> copy_arrays(json& attributes, const GltfPrimitive& share, const std::vector<std::uint32_t>& source,
                             const std::vector<std::uint32_t>& vertices) {
        const MeshBudget budget{std::numeric_limits<std::uint64_t>::max()};
        for (auto& [semantic, accessor] : attributes.items()) {
            const std::size_t number = accessor.get<std::size_t>(); // throws where the file has something else: write_mesh says so
            const Result<GltfArray> array = read_accessor(*model_, int(number), budget, name_);
            if (!array) return tl::unexpected(array.error());
            if (array->count != share.vertex_count)
                return fail(ErrorCode::bad_data, name_ + ": " + semantic + " has " + std::to_string(array->count) + " elements; expected " +
                                                     std::to_string(share.vertex_count));
            std::string bytes;
            for (const std::uint32_t v : vertices)
                bytes += std::string_view(array->bytes).substr((source[v] - share.first_vertex) * array->element_bytes(), array->element_bytes());
            json copy = source_.document["accessors"][number]; // bounds hold for copies too
            for (const char* key : {"bufferView", "byteOffset", "sparse"}) copy.erase(key);
            copy["bufferView"] = builder_.add_view(bytes, vertices.size(), GltfBuilder::Use::vertices);
            copy["count"] = vertices.size();
            accessor = builder_.add_accessor(std::move(copy));
        }
        return {};
    }

    /// Writes an attribute that the source lacks or has otherwise; what is equal keeps its accessor, whatever its type.
    template <class Vector>
    void replace_changed(json& attributes, const char* semantic, const std::vector<std::uint32_t>& vertices, const std::vector<Vector>& values,
                         const GltfPrimitive& share) {
        std::vector<float> flat;
        for (const std::uint32_t v : vertices)
            for (unsigned k = 0; k < Vector::dimensions(); ++k) flat.push_back(values[v][int(k)]);
        if (attributes.contains(semantic) && vertices.size() == share.vertex_count && same_as_source(attributes[semantic], flat)) return;
        attributes[semantic] = builder_.add_floats(flat, int(Vector::dimensions()));
    }

    bool same_as_source(const json& accessor, const std::vector<float>& values) {
        if (!model_) model_ = std::make_unique<tinygltf::Model>(arrays_of(source_));
        const Result<GltfArray> array = read_accessor(*model_, accessor.get<int>(), {std::numeric_limits<std::uint64_t>::max()}, name_);
        if (!array || array->count * std::size_t(array->components) != values.size()) return false;
        for (std::size_t k = 0; k < values.size(); ++k)
            if (float(array->number(k / std::size_t(array->components), int(k % std::size_t(array->components)))) != values[k]) return false;
        return true;
    }

    Result<void> store_quadrics(json& attributes, const Mesh& mesh, const std::vector<std::uint32_t>& vertices, float range);

    const GltfSource& source_;
    GltfBuilder builder_;
    std::unique_ptr<tinygltf::Model> model_;
    const QuadricStore& store_;
    const nlohmann::json& info_;
    const std::string& name_;
};

Result<void> Attacher::store_quadrics(json& attributes, const Mesh& mesh, const std::vector<std::uint32_t>& vertices, float range) {
    const auto floats = [&](int components, auto component) {
        std::vector<float> flat;
        for (const std::uint32_t v : vertices)
            for (int k = 0; k < components; ++k) flat.push_back(component(mesh.quadrics[v], k));
        return builder_.add_floats(flat, components);
    };
    const auto term = [](const Quadric& q, int k) { return k == 0 ? q.a : k == 1 ? q.b : q.c; };
    const auto taken = [&](const std::string& semantic) {
        return fail(ErrorCode::usage, name_ + ": --store: the file has " + semantic + " already, which would be lost; choose another place");
    };
    std::size_t accessor = 0;
    if (store_.where == QuadricStore::Where::attribute) {
        accessor = floats(store_.twist ? 3 : 2, term);
        attributes["_QUADRIC"] = accessor;
    } else if (store_.where == QuadricStore::Where::uv) {
        for (int k = 0; k < store_.uv_set; ++k)
            if (!attributes.contains("TEXCOORD_" + std::to_string(k)))
                return fail(ErrorCode::usage, name_ + ": --store uv:" + std::to_string(store_.uv_set) + ": the file has no TEXCOORD_" + std::to_string(k) +
                                                  ", and sets must follow each other; use uv:" + std::to_string(k));
        const std::string first = "TEXCOORD_" + std::to_string(store_.uv_set), second = "TEXCOORD_" + std::to_string(store_.uv_set + 1);
        if (attributes.contains(first) || (store_.twist && attributes.contains(second))) return taken(attributes.contains(first) ? first : second);
        accessor = floats(2, term);
        attributes[first] = accessor;
        if (store_.twist) attributes[second] = floats(2, [](const Quadric& q, int k) { return k == 0 ? q.c : 0; });
    } else {
        if (attributes.contains("COLOR_0")) return taken("COLOR_0");
        std::string bytes;
        for (const std::uint32_t v : vertices)
            for (int k = 0; k < 4; ++k) {
                const std::uint32_t code = k == 3 ? 65535 : quadric_code(term(mesh.quadrics[v], k) * float(k < 2 || store_.twist), range, 65535);
                bytes.append(reinterpret_cast<const char*>(&code), 2);
            }
        const std::size_t view = builder_.add_view(bytes, vertices.size(), GltfBuilder::Use::vertices);
        accessor = builder_.add_accessor(
            {{"bufferView", view}, {"componentType", 5123}, {"normalized", true}, {"count", vertices.size()}, {"type", "VEC4"}});
        attributes["COLOR_0"] = accessor;
    }
    builder_.document()["accessors"][accessor]["extras"]["reliefbake"] = info_;
    return {};
}

} // namespace

Result<GltfDocument> attach_quadrics(const GltfSource& source, std::span<const Mesh> meshes, std::span<const std::vector<std::uint32_t>> sources,
                                     const QuadricStore& store, const nlohmann::json& info, const std::string& name) {
    const float range = quadric_range(meshes, store.twist);
    Attacher attacher(source, store, info, name);
    for (std::size_t m = 0; m < meshes.size(); ++m)
        if (Result<void> done = attacher.attach(m, meshes[m], sources[m], range); !done) return tl::unexpected(done.error());
    return attacher.take();
}

} // namespace reliefbake
