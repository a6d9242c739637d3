// PLY, text and binary of either byte order: vertex and face are read, other elements skipped.

#include "formats/mesh/ply_header.h"
#include "formats/mesh/polygon.h"
#include "formats/mesh/readers.h"
#include "formats/mesh/text_lines.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>

namespace reliefbake {

namespace {

/// The numbers behind the header, one after the other; `ok` turns false at the end of the file or where none is.
class Numbers {
  public:
    Numbers(std::string_view data, PlyEncoding encoding) : data_(data), encoding_(encoding) {}

    double next(PlyType type) {
        if (encoding_ != PlyEncoding::text) return next_binary(type);
        while (!data_.empty() && (is_blank(data_.front()) || data_.front() == '\n')) data_.remove_prefix(1);
        std::size_t end = 0;
        while (end < data_.size() && !is_blank(data_[end]) && data_[end] != '\n') ++end;
        const auto value = to_number(data_.substr(0, end));
        data_.remove_prefix(end);
        ok_ &= value.has_value();
        return value.value_or(0);
    }

    bool ok() const { return ok_; }
    std::size_t left() const { return data_.size(); }

  private:
    template <class T>
    double take() {
        unsigned char bytes[sizeof(T)] = {};
        if (data_.size() < sizeof(T)) {
            ok_ = false;
            return 0;
        }
        std::memcpy(bytes, data_.data(), sizeof(T));
        data_.remove_prefix(sizeof(T));
        if ((encoding_ == PlyEncoding::big_endian) == (std::endian::native == std::endian::little)) std::reverse(bytes, bytes + sizeof(T));
        T value;
        std::memcpy(&value, bytes, sizeof(T));
        return double(value);
    }

    double next_binary(PlyType type) {
        switch (type) {
        case PlyType::int8: return take<std::int8_t>();
        case PlyType::uint8: return take<std::uint8_t>();
        case PlyType::int16: return take<std::int16_t>();
        case PlyType::uint16: return take<std::uint16_t>();
        case PlyType::int32: return take<std::int32_t>();
        case PlyType::uint32: return take<std::uint32_t>();
        case PlyType::float32: return take<float>();
        case PlyType::float64: return take<double>();
        }
        return 0;
    }

    std::string_view data_;
    PlyEncoding encoding_;
    bool ok_ = true;
};

/// Where a vertex property goes, by the names that programs use.
using Place = std::function<void(Mesh&, std::size_t, double)>;

Place place_of(const std::string& name, Mesh& mesh, std::size_t count) {
    const auto is = [&](std::initializer_list<const char*> names) { return std::find(names.begin(), names.end(), name) != names.end(); };
    const auto component = [&](auto member, std::initializer_list<std::initializer_list<const char*>> names) -> Place {
        int k = 0;
        for (const auto& alternatives : names) {
            if (is(alternatives)) {
                (mesh.*member).resize(count);
                return [member, k](Mesh& m, std::size_t v, double value) { (m.*member)[v][k] = std::decay_t<decltype((m.*member)[v][k])>(value); };
            }
            ++k;
        }
        return {};
    };
    if (Place p = component(&Mesh::positions, {{"x"}, {"y"}, {"z"}})) return p;
    if (Place p = component(&Mesh::normals, {{"nx"}, {"ny"}, {"nz"}})) return p;
    if (Place p = component(&Mesh::uvs, {{"s", "u", "texture_u"}, {"t", "v", "texture_v"}})) return p;
    if (Place p = component(&Mesh::tangents, {{"tx"}, {"ty"}, {"tz"}, {"tw"}})) return p;
    static constexpr float Quadric::*terms[] = {&Quadric::a, &Quadric::b, &Quadric::c};
    for (int k = 0; k < 3; ++k)
        if (name == std::string("quadric_") + "abc"[k]) {
            mesh.quadrics.resize(count);
            return [k](Mesh& m, std::size_t v, double value) { m.quadrics[v].*terms[k] = float(value); };
        }
    return {};
}

class PlyParser {
  public:
    PlyParser(PlyHeader header, std::string_view data, const MeshBudget& budget, const std::string& name)
        : header_(std::move(header)), numbers_(data, header_.encoding), budget_(budget), name_(name) {}

    Result<MeshFile> parse() {
        for (const PlyElement& element : header_.elements) {
            Result<void> taken = element.name == "vertex" ? vertices(element) : others(element);
            if (taken && !numbers_.ok())
                taken = refuse("ends, or holds something that is no number, inside element " + element.name);
            if (!taken) return tl::unexpected(taken.error());
        }
        if (mesh_.triangles.empty()) return refuse("has no faces to bake");
        if (mesh_.positions.empty()) return refuse("has no vertices with x, y, z");
        const std::size_t count = mesh_.positions.size();
        for (const Triangle& t : mesh_.triangles)
            for (const std::uint32_t v : t)
                if (v >= count) return refuse("a face names vertex " + std::to_string(v) + " of " + std::to_string(count));
        MeshFile file{MeshFormat::ply, {}, {}, {}};
        if (!left_.empty()) file.notes.push_back("vertex properties that are not kept: " + left_);
        file.meshes.push_back(std::move(mesh_));
        return file;
    }

  private:
    tl::unexpected<Error> refuse(const std::string& what) const { return fail(ErrorCode::bad_data, name_ + ": " + what); }

    /// A list's length, or less than 0 where the file cannot hold it.
    std::int64_t length(const PlyProperty& property) {
        const double n = numbers_.next(property.count_type);
        return n >= 0 && n <= double(numbers_.left()) && n == std::floor(n) ? std::int64_t(n) : -1;
    }

    Result<void> vertices(const PlyElement& element) {
        if (!mesh_.positions.empty()) return refuse("has two elements vertex");
        if (Result<void> fits = check_budget(element.count, 0, budget_, name_); !fits) return fits;
        std::vector<Place> places;
        for (const PlyProperty& p : element.properties) {
            places.push_back(p.is_list ? Place() : place_of(p.name, mesh_, std::size_t(element.count)));
            if (!places.back()) left_ += (left_.empty() ? "" : ", ") + p.name.substr(0, 40);
        }
        for (std::size_t v = 0; v < element.count && numbers_.ok(); ++v)
            for (std::size_t k = 0; k < places.size(); ++k) {
                if (element.properties[k].is_list) {
                    if (!skip_list(element.properties[k])) return refuse("holds a list that is longer than the file");
                    continue;
                }
                const double value = numbers_.next(element.properties[k].type);
                if (places[k]) places[k](mesh_, v, value);
            }
        return {};
    }

    bool skip_list(const PlyProperty& property) {
        const std::int64_t n = length(property);
        for (std::int64_t k = 0; k < n && numbers_.ok(); ++k) numbers_.next(property.type);
        return n >= 0;
    }

    Result<void> face(const PlyProperty& property) {
        const std::int64_t n = length(property);
        if (n < 0) return refuse("a face has more corners than the file has bytes, or less than none");
        corners_.clear();
        for (std::int64_t k = 0; k < n && numbers_.ok(); ++k) {
            const double index = numbers_.next(property.type);
            if (!(index >= 0 && index < double(mesh_.positions.size())))
                return numbers_.ok() ? Result<void>(refuse("a face names vertex " + std::to_string(std::int64_t(std::clamp(index, -1e15, 1e15))) + " of " +
                                                           std::to_string(mesh_.positions.size())))
                                     : Result<void>();
            corners_.push_back(std::uint32_t(index));
        }
        append_polygon(mesh_, corners_);
        return check_budget(mesh_.positions.size(), mesh_.triangles.size(), budget_, name_);
    }

    /// Faces, and what is skipped.
    Result<void> others(const PlyElement& element) {
        if (element.properties.empty()) return {};
        for (std::uint64_t k = 0; k < element.count && numbers_.ok(); ++k)
            for (const PlyProperty& p : element.properties) {
                const bool corners = element.name == "face" && p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
                if (corners) {
                    if (Result<void> taken = face(p); !taken) return taken;
                } else if (!p.is_list) {
                    numbers_.next(p.type);
                } else if (!skip_list(p)) {
                    return refuse("holds a list that is longer than the file");
                }
            }
        return {};
    }

    PlyHeader header_;
    Numbers numbers_;
    const MeshBudget& budget_;
    const std::string& name_;
    std::vector<std::uint32_t> corners_;
    std::string left_;
    Mesh mesh_;
};

} // namespace

Result<MeshFile> parse_ply(std::string_view bytes, const MeshBudget& budget, const std::string& name) {
    Result<PlyHeader> header = parse_ply_header(bytes, name);
    if (!header) return tl::unexpected(header.error());
    const std::size_t begin = header->bytes;
    return PlyParser(std::move(*header), bytes.substr(begin), budget, name).parse();
}

} // namespace reliefbake
