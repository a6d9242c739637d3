// Wavefront OBJ: v, vt, vn, f. Each distinct v/vt/vn becomes a vertex.

#include "formats/mesh/polygon.h"
#include "formats/mesh/readers.h"
#include "formats/mesh/text_lines.h"

#include <algorithm>
#include <unordered_map>

namespace reliefbake {

namespace {

struct CornerKey {
    std::uint32_t position, uv, normal; ///< from 1; 0: none
    bool operator==(const CornerKey&) const = default;
};

struct CornerHash {
    std::size_t operator()(const CornerKey& k) const {
        std::uint64_t h = (std::uint64_t(k.position) << 32 | k.uv) * 0x9e3779b97f4a7c15;
        h = (h ^ h >> 29 ^ k.normal) * 0xbf58476d1ce4e5b9;
        return h ^ h >> 32;
    }
};

class ObjParser {
  public:
    ObjParser(const MeshBudget& budget, const std::string& name) : budget_(budget), name_(name) {}

    Result<MeshFile> parse(std::string_view text) {
        Lines lines(text);
        for (std::string_view line; lines.next(line);) {
            line_ = lines.number();
            if (Result<void> done = take_line(joined(line, lines)); !done) return tl::unexpected(done.error());
        }
        if (mesh_.triangles.empty()) return fail(ErrorCode::bad_data, name_ + ": has no faces to bake");
        if (!any_uv_) mesh_.uvs.clear();
        if (!any_normal_) mesh_.normals.clear();
        MeshFile file{MeshFormat::obj, {}, {}, {}};
        file.meshes.push_back(std::move(mesh_));
        return file;
    }

  private:
    /// A line that ends with a backslash goes on in the next.
    std::string_view joined(std::string_view line, Lines& lines) {
        const auto goes_on = [](std::string_view l) {
            while (!l.empty() && is_blank(l.back())) l.remove_suffix(1);
            return !l.empty() && l.back() == '\\' ? l.size() : 0;
        };
        if (!goes_on(line)) return line;
        joined_.clear();
        for (std::size_t end; (end = goes_on(line)) > 0;) {
            joined_ += line.substr(0, end - 1);
            joined_ += ' ';
            if (!lines.next(line)) line = {};
        }
        joined_ += line;
        return joined_;
    }

    Result<void> take_line(std::string_view line) {
        const std::string_view word = take_word(line);
        if (word == "v") return numbers(line, 3).map([&](const auto& n) { positions_.push_back({n[0], n[1], n[2]}); });
        if (word == "vt")
            return numbers(line, 1).map([&](const auto& n) { uvs_.push_back({float(n[0]), float(n[1])}); });
        if (word == "vn")
            return numbers(line, 3).map([&](const auto& n) { normals_.push_back({float(n[0]), float(n[1]), float(n[2])}); });
        if (word == "f" || word == "fo") return face(line);
        return {};
    }

    Error here(const std::string& what) const { return {ErrorCode::bad_data, name_ + ": line " + std::to_string(line_) + ": " + what}; }

    Result<std::array<double, 3>> numbers(std::string_view line, int needed) {
        std::array<double, 3> values{};
        for (int k = 0; k < 3; ++k) {
            const std::string_view word = take_word(line);
            if (word.empty() && k >= needed) break;
            const auto value = to_number(word);
            if (!value) return tl::unexpected(here("expected " + std::to_string(needed) + " numbers, found '" + std::string(word.substr(0, 40)) + "'"));
            values[std::size_t(k)] = *value;
        }
        return values;
    }

    /// Index as the file counts: from 1, or back from the newest with a minus.
    Result<std::uint32_t> index(std::string_view digits, std::size_t count, const char* of) const {
        if (digits.empty()) return 0u;
        const auto given = to_integer(digits);
        const std::int64_t k = !given ? 0 : *given < 0 ? std::int64_t(count) + *given + 1 : *given;
        if (k >= 1 && k <= std::int64_t(count)) return std::uint32_t(k);
        return tl::unexpected(here("the face names " + std::string(of) + " '" + std::string(digits.substr(0, 40)) + "' of " + std::to_string(count)));
    }

    Result<std::uint32_t> corner(std::string_view word) {
        const std::size_t first = word.find('/'), second = first == word.npos ? word.npos : word.find('/', first + 1);
        const std::string_view p = word.substr(0, first);
        const std::string_view t = first == word.npos ? "" : word.substr(first + 1, second == word.npos ? word.npos : second - first - 1);
        const std::string_view n = second == word.npos ? "" : word.substr(second + 1);
        const auto position = index(p, positions_.size(), "position"), uv = index(t, uvs_.size(), "texture coordinate"),
                   normal = index(n, normals_.size(), "normal");
        for (const auto* part : {&position, &uv, &normal})
            if (!*part) return tl::unexpected(part->error());
        if (*position == 0) return tl::unexpected(here("expected a vertex, found '" + std::string(word.substr(0, 40)) + "'"));
        return vertex({*position, *uv, *normal});
    }

    std::uint32_t vertex(const CornerKey& key) {
        const auto [found, is_new] = numbers_.try_emplace(key, std::uint32_t(mesh_.positions.size()));
        if (is_new) {
            mesh_.positions.push_back(positions_[key.position - 1]);
            mesh_.uvs.push_back(key.uv ? uvs_[key.uv - 1] : Imath::V2f(0));
            mesh_.normals.push_back(key.normal ? normals_[key.normal - 1] : Imath::V3f(0));
            any_uv_ |= key.uv != 0, any_normal_ |= key.normal != 0;
        }
        return found->second;
    }

    Result<void> face(std::string_view line) {
        corners_.clear();
        for (std::string_view word; !(word = take_word(line)).empty();) {
            if (word[0] == '#') break;
            const Result<std::uint32_t> k = corner(word);
            if (!k) return tl::unexpected(k.error());
            corners_.push_back(*k);
        }
        append_polygon(mesh_, corners_);
        return check_budget(mesh_.positions.size(), mesh_.triangles.size(), budget_, name_);
    }

    const MeshBudget& budget_;
    const std::string& name_;
    std::size_t line_ = 0;
    std::string joined_;
    std::vector<Imath::V3d> positions_;
    std::vector<Imath::V2f> uvs_;
    std::vector<Imath::V3f> normals_;
    std::unordered_map<CornerKey, std::uint32_t, CornerHash> numbers_;
    std::vector<std::uint32_t> corners_;
    Mesh mesh_;
    bool any_uv_ = false, any_normal_ = false;
};

} // namespace

Result<MeshFile> parse_obj(std::string_view text, const MeshBudget& budget, const std::string& name) {
    return ObjParser(budget, name).parse(text);
}

} // namespace reliefbake
