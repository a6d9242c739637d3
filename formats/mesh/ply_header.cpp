#include "formats/mesh/ply_header.h"

#include "formats/mesh/text_lines.h"

#include <optional>
#include <utility>

namespace reliefbake {

namespace {

std::optional<PlyType> type_of(std::string_view word) {
    static constexpr std::pair<std::string_view, PlyType> words[] = {
        {"char", PlyType::int8},     {"int8", PlyType::int8},       {"uchar", PlyType::uint8},    {"uint8", PlyType::uint8},
        {"short", PlyType::int16},   {"int16", PlyType::int16},     {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},
        {"int", PlyType::int32},     {"int32", PlyType::int32},     {"uint", PlyType::uint32},    {"uint32", PlyType::uint32},
        {"float", PlyType::float32}, {"float32", PlyType::float32}, {"double", PlyType::float64}, {"float64", PlyType::float64}};
    for (const auto& [name, type] : words)
        if (name == word) return type;
    return std::nullopt;
}

class HeaderParser {
  public:
    HeaderParser(std::string_view file, const std::string& name) : file_(file), lines_(file), name_(name) {}

    Result<PlyHeader> parse() {
        std::string_view line;
        lines_.next(line);
        if (take_word(line) != "ply") return refuse("expected ply");
        bool has_format = false;
        for (;;) {
            if (!lines_.next(line)) return refuse("the header has no end_header; the file is truncated");
            const std::string_view word = take_word(line);
            if (word == "end_header") break;
            if (word == "comment") take_comment(line);
            Result<void> taken;
            if (word == "format") taken = take_format(line), has_format = true;
            if (word == "element") taken = take_element(line);
            if (word == "property") taken = take_property(line);
            if (!taken) return tl::unexpected(taken.error());
        }
        if (!has_format) return refuse("the header names no format");
        header_.bytes = file_.size() - lines_.rest().size();
        header_.lines = lines_.number();
        return check_counts().map([&] { return std::move(header_); });
    }

  private:
    tl::unexpected<Error> refuse(const std::string& what) const {
        return fail(ErrorCode::bad_data, name_ + ": line " + std::to_string(lines_.number()) + ": " + what);
    }

    void take_comment(std::string_view line) {
        std::string_view look = line;
        if (take_word(look) != "reliefbake") return;
        while (!look.empty() && is_blank(look.front())) look.remove_prefix(1);
        while (!look.empty() && is_blank(look.back())) look.remove_suffix(1);
        header_.relief = look;
    }

    Result<void> take_format(std::string_view line) {
        const std::string_view word = take_word(line);
        if (word == "ascii") header_.encoding = PlyEncoding::text;
        else if (word == "binary_little_endian") header_.encoding = PlyEncoding::little_endian;
        else if (word == "binary_big_endian") header_.encoding = PlyEncoding::big_endian;
        else return refuse("expected format ascii, binary_little_endian or binary_big_endian");
        return {};
    }

    Result<void> take_element(std::string_view line) {
        const std::string_view word = take_word(line);
        const auto count = to_integer(take_word(line));
        if (word.empty() || !count || *count < 0) return refuse("expected element, a name and a count");
        header_.elements.push_back({std::string(word), std::uint64_t(*count), {}});
        return {};
    }

    Result<void> take_property(std::string_view line) {
        if (header_.elements.empty()) return refuse("a property stands before the first element");
        PlyProperty property;
        std::string_view word = take_word(line);
        property.is_list = word == "list";
        if (property.is_list) {
            const auto count_type = type_of(take_word(line));
            if (!count_type || *count_type >= PlyType::float32) return refuse("expected an integer type for a list's length");
            property.count_type = *count_type;
            word = take_word(line);
        }
        const auto type = type_of(word);
        property.name = take_word(line);
        if (!type || property.name.empty()) return refuse("expected property, a type and a name");
        property.type = *type;
        header_.elements.back().properties.push_back(std::move(property));
        return {};
    }

    Result<void> check_counts() const {
        const std::uint64_t left = file_.size() - header_.bytes;
        for (const PlyElement& element : header_.elements) {
            std::uint64_t least = 0;
            for (const PlyProperty& p : element.properties)
                least += header_.encoding == PlyEncoding::text ? 2 : std::uint64_t(ply_bytes(p.is_list ? p.count_type : p.type));
            // The last number of a text needs no blank behind it.
            if (element.count > (left + 1) / (least > 0 ? least : 1))
                return refuse("claims " + std::to_string(element.count) + " of element " + element.name + "; the file is too short for them");
        }
        return {};
    }

    std::string_view file_;
    Lines lines_;
    const std::string& name_;
    PlyHeader header_;
};

} // namespace

int ply_bytes(PlyType type) {
    switch (type) {
    case PlyType::int8:
    case PlyType::uint8: return 1;
    case PlyType::int16:
    case PlyType::uint16: return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32: return 4;
    case PlyType::float64: return 8;
    }
    return 8;
}

Result<PlyHeader> parse_ply_header(std::string_view file, const std::string& name) { return HeaderParser(file, name).parse(); }

} // namespace reliefbake
