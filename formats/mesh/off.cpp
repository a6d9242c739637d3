// Object File Format: [ST][C][N]OFF, text.

#include "formats/mesh/polygon.h"
#include "formats/mesh/readers.h"
#include "formats/mesh/text_lines.h"

#include <algorithm>

namespace reliefbake {

namespace {

class OffParser {
  public:
    OffParser(std::string_view text, const MeshBudget& budget, const std::string& name) : lines_(text), budget_(budget), name_(name) {}

    Result<MeshFile> parse() {
        return header().and_then([&] { return vertices(); }).and_then([&] { return faces(); }).and_then([&]() -> Result<MeshFile> {
            if (mesh_.triangles.empty()) return fail(ErrorCode::bad_data, name_ + ": has no faces to bake");
            MeshFile file{MeshFormat::off, {}, {}, {}};
            file.meshes.push_back(std::move(mesh_));
            return file;
        });
    }

  private:
    tl::unexpected<Error> refuse(const std::string& what) const {
        return fail(ErrorCode::bad_data, name_ + ": line " + std::to_string(lines_.number()) + ": " + what);
    }

    /// The next line that holds something, without its comment.
    bool next(std::string_view& line) {
        while (lines_.next(line)) {
            line = line.substr(0, line.find('#'));
            std::string_view look = line;
            if (!take_word(look).empty()) return true;
        }
        return false;
    }

    Result<void> header() {
        std::string_view line;
        if (!next(line)) return refuse("expected OFF");
        std::string_view word = take_word(line);
        if (word.starts_with("ST")) has_uv_ = true, word.remove_prefix(2);
        if (word.starts_with("C")) word.remove_prefix(1); // colours stand behind what we read
        if (word.starts_with("N")) has_normal_ = true, word.remove_prefix(1);
        if (word != "OFF") return refuse("expected OFF of three dimensions, with or without ST, C, N; export it as PLY");
        std::string_view look = line;
        if (take_word(look) == "BINARY") return refuse("is a binary OFF file, which is not read; export it as text or PLY");
        look = line;
        if (take_word(look).empty() && !next(line)) return refuse("expected the counts of vertices, faces and edges");
        const auto v = to_integer(take_word(line)), f = to_integer(take_word(line));
        if (!v || !f || *v < 0 || *f < 0) return refuse("expected the counts of vertices, faces and edges");
        constexpr std::int64_t shortest = 2; // a digit and a blank
        const std::int64_t left = std::int64_t(lines_.rest().size()) + 1;
        if (*v > left / (3 * shortest) || *f > left / shortest)
            return refuse("claims " + std::to_string(*v) + " vertices and " + std::to_string(*f) + " faces; the file is too short for them");
        vertex_count_ = std::size_t(*v), face_count_ = std::size_t(*f);
        return check_budget(vertex_count_, face_count_, budget_, name_);
    }

    Result<void> vertices() {
        std::string_view line;
        for (std::size_t k = 0; k < vertex_count_; ++k) {
            if (!next(line)) return refuse("the file ends at vertex " + std::to_string(k) + " of " + std::to_string(vertex_count_));
            std::vector<double>& n = numbers_;
            n.clear();
            for (std::string_view word; !(word = take_word(line)).empty();) {
                const auto value = to_number(word);
                if (!value) return refuse("expected numbers, found '" + std::string(word.substr(0, 40)) + "'");
                n.push_back(*value);
            }
            const std::size_t needed = 3 + (has_normal_ ? 3 : 0) + (has_uv_ ? 2 : 0);
            if (n.size() < needed) return refuse("expected " + std::to_string(needed) + " numbers for a vertex, found " + std::to_string(n.size()));
            mesh_.positions.push_back({n[0], n[1], n[2]});
            if (has_normal_) mesh_.normals.push_back({float(n[3]), float(n[4]), float(n[5])});
            if (has_uv_) mesh_.uvs.push_back({float(n[n.size() - 2]), float(n[n.size() - 1])});
        }
        return {};
    }

    Result<void> faces() {
        std::string_view line;
        std::vector<std::uint32_t> corners;
        for (std::size_t k = 0; k < face_count_; ++k) {
            if (!next(line)) return refuse("the file ends at face " + std::to_string(k) + " of " + std::to_string(face_count_));
            const auto count = to_integer(take_word(line));
            if (!count || *count < 1 || *count > std::int64_t(line.size())) return refuse("expected a face's number of corners, and its corners");
            corners.clear();
            for (std::int64_t c = 0; c < *count; ++c) {
                const auto index = to_integer(take_word(line));
                if (!index || *index < 0 || *index >= std::int64_t(vertex_count_))
                    return refuse("the face needs " + std::to_string(*count) + " corners from 0 to " + std::to_string(std::int64_t(vertex_count_) - 1));
                corners.push_back(std::uint32_t(*index));
            }
            append_polygon(mesh_, corners);
            if (Result<void> fits = check_budget(vertex_count_, mesh_.triangles.size(), budget_, name_); !fits) return fits;
        }
        return {};
    }

    Lines lines_;
    const MeshBudget& budget_;
    const std::string& name_;
    bool has_normal_ = false, has_uv_ = false;
    std::size_t vertex_count_ = 0, face_count_ = 0;
    std::vector<double> numbers_;
    Mesh mesh_;
};

} // namespace

Result<MeshFile> parse_off(std::string_view text, const MeshBudget& budget, const std::string& name) {
    return OffParser(text, budget, name).parse();
}

} // namespace reliefbake
