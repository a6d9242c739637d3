#include "formats/toml_file.h"

#include "formats/whole_file.h"

#include <algorithm>
#include <cmath>

namespace reliefbake {

namespace {

tl::unexpected<Error> fault_at(std::size_t line, const std::string& name, const std::string& words) {
    std::string message = name;
    if (line > 0) message.append(":").append(std::to_string(line));
    return fail(ErrorCode::bad_data, message + ": " + words);
}

/// Walks over the text as TOML's lexer does and counts what nests. toml++ allows 256 brackets, each of which may hold a key of any
/// number of dots, and destroys the tables that these make by recursion: too deep for a stack.
class DepthGate {
  public:
    DepthGate(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    Result<void> pass() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (is_control(c)) return fault("holds the control character " + std::to_string(int(static_cast<unsigned char>(c))) + "; TOML is text");
            if (c == '"' || c == '\'') {
                skip_string(c);
                continue;
            }
            if (c == '#') {
                skip_comment();
                continue;
            }
            count(c);
            if (brackets_ > deepest_toml) return fault("more than " + std::to_string(deepest_toml) + " brackets inside each other");
            if (dots_ > deepest_toml) return fault("a key of more than " + std::to_string(deepest_toml) + " dots");
            ++at_;
        }
        return {};
    }

  private:
    tl::unexpected<Error> fault(const std::string& words) const { return fault_at(line_, name_, words); }

    static bool is_control(char c) { return (c >= 0 && c < ' ' && c != '\t' && c != '\n' && c != '\r') || c == 127; }

    bool starts_with(std::string_view what) const { return text_.substr(at_).starts_with(what); }

    void count(char c) {
        if (c == '\n') ++line_;
        if (c == '[' || c == '{') ++brackets_;
        if ((c == ']' || c == '}') && brackets_ > 0) --brackets_;
        if (c == '.') ++dots_;
        // Blanks do not end a key: `a . b` is one. Anything else that is no key's does.
        constexpr std::string_view ends = "\n=,[]{}";
        if (ends.find(c) != ends.npos) dots_ = 0;
    }

    /// Past the end of a string; one that never ends, or meets the end of its line, is refused by the parser, which reads no further.
    void skip_string(char quote) {
        const std::string three(3, quote);
        const bool lines = starts_with(three);
        at_ += lines ? 3 : 1;
        for (; at_ < text_.size(); ++at_) {
            const char c = text_[at_];
            if (c == '\n') ++line_;
            if (c == '\\' && quote == '"') {
                if (++at_ < text_.size() && text_[at_] == '\n') ++line_;
            } else if (lines && starts_with(three)) {
                at_ += 3;
                for (int extra = 0; extra < 2 && at_ < text_.size() && text_[at_] == quote; ++extra) ++at_; // """x""""" ends in two of its own
                return;
            } else if (!lines && (c == quote || c == '\n')) {
                ++at_;
                return;
            }
        }
    }

    void skip_comment() {
        while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t at_ = 0, line_ = 1;
    int brackets_ = 0, dots_ = 0;
};

const char* type_words(toml::node_type type) {
    switch (type) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "an array";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "an integer";
    case toml::node_type::floating_point: return "a number";
    case toml::node_type::boolean: return "true or false";
    case toml::node_type::date:
    case toml::node_type::time:
    case toml::node_type::date_time: return "a date or time";
    case toml::node_type::none: break;
    }
    return "nothing";
}

tl::unexpected<Error> type_fault(const toml::node& node, std::string_view key, const std::string& name, const char* expected) {
    return toml_fault(node, name, std::string("'").append(key) + "': expected " + expected + ", found " + type_words(node.type()));
}

} // namespace

tl::unexpected<Error> toml_fault(const toml::node& node, const std::string& name, const std::string& words) {
    return fault_at(node.source().begin.line, name, words);
}

Result<toml::table> parse_toml(std::string_view text, const std::string& name) {
    if (text.size() > largest_toml_bytes)
        return fail(ErrorCode::bad_data, name + ": has " + std::to_string(text.size()) + " bytes; a TOML file may have " + std::to_string(largest_toml_bytes));
    if (Result<void> shallow = DepthGate(text, name).pass(); !shallow) return tl::unexpected(shallow.error());
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        std::string words(error.description());
        std::replace(words.begin(), words.end(), '\n', ' ');
        return fault_at(error.source().begin.line, name, words);
    }
}

Result<toml::table> read_toml_file(const std::filesystem::path& path) {
    const Result<std::string> text = read_whole_file(path, largest_toml_bytes);
    if (text) return parse_toml(*text, path.string());
    if (text.error().code != ErrorCode::bad_data) return tl::unexpected(text.error());
    return fail(ErrorCode::bad_data, path.string() + ": has more than " + std::to_string(largest_toml_bytes) + " bytes, too many for a TOML file");
}

template <class T>
Result<std::optional<T>> toml_value(const toml::table& table, std::string_view key, const std::string& name) {
    const toml::node* node = table.get(key);
    if (!node) return std::optional<T>();
    if constexpr (std::is_same_v<T, double>) {
        if (!node->is_number()) return type_fault(*node, key, name, "a number");
        const double number = *node->value<double>();
        if (!std::isfinite(number)) return toml_fault(*node, name, std::string("'").append(key) + "': expected a finite number");
        return std::optional<double>(number);
    } else {
        const std::optional<T> value = node->value_exact<T>();
        if (value) return value;
        constexpr toml::node_type expected = std::is_same_v<T, bool> ? toml::node_type::boolean
                                             : std::is_same_v<T, std::string> ? toml::node_type::string
                                                                              : toml::node_type::integer;
        return type_fault(*node, key, name, type_words(expected));
    }
}

template Result<std::optional<std::string>> toml_value(const toml::table&, std::string_view, const std::string&);
template Result<std::optional<bool>> toml_value(const toml::table&, std::string_view, const std::string&);
template Result<std::optional<std::int64_t>> toml_value(const toml::table&, std::string_view, const std::string&);
template Result<std::optional<double>> toml_value(const toml::table&, std::string_view, const std::string&);

template <class T>
Result<const T*> toml_part(const toml::table& table, std::string_view key, const std::string& name) {
    const toml::node* node = table.get(key);
    if (!node) return nullptr;
    if (const T* part = node->as<T>()) return part;
    return type_fault(*node, key, name, std::is_same_v<T, toml::table> ? "a table" : "an array");
}

template Result<const toml::table*> toml_part(const toml::table&, std::string_view, const std::string&);
template Result<const toml::array*> toml_part(const toml::table&, std::string_view, const std::string&);

Result<void> refuse_unknown_keys(const toml::table& table, std::initializer_list<std::string_view> known, const std::string& name) {
    const toml::key* first = nullptr;
    for (const auto& [key, value] : table) {
        if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
        if (!first || key.source().begin.line < first->source().begin.line) first = &key;
    }
    if (!first) return {};
    std::string list;
    for (const std::string_view word : known) list += std::string(list.empty() ? "" : ", ").append(word);
    return fault_at(first->source().begin.line, name, std::string("unknown key '").append(first->str()) + "'; expected one of " + list);
}

} // namespace reliefbake
