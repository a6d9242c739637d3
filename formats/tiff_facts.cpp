#include "formats/tiff_facts.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include <unistd.h>

namespace reliefbake {

namespace {

enum Tag : std::uint64_t { strip_offsets = 273, strip_bytes = 279, tile_offsets = 324, tile_bytes = 325, gdal_no_data = 42113 };

/// Where an entry's values lie.
struct Entry {
    std::uint64_t type = 0, count = 0, at = 0;
};

class Reader {
  public:
    Reader(int fd, std::uint64_t file_bytes) : fd_(fd), file_bytes_(file_bytes) {
        const std::string head = bytes(0, 4);
        big_endian_ = head.starts_with("MM");
        big_tiff_ = number(head, 2, 2) == 43;
    }

    std::map<std::uint64_t, Entry> directory(int index) const {
        const std::uint64_t word = big_tiff_ ? 8 : 4, entry_bytes = big_tiff_ ? 20 : 12, count_bytes = big_tiff_ ? 8 : 2;
        constexpr std::uint64_t most_entries = 4096;
        const auto entries_at = [&](std::uint64_t at) {
            return std::min(number(bytes(at, count_bytes), 0, count_bytes), most_entries);
        };
        std::uint64_t directory = number(bytes(big_tiff_ ? 8 : 4, word), 0, word);
        for (int i = 0; i < index; ++i)
            directory = number(bytes(directory + count_bytes + entries_at(directory) * entry_bytes, word), 0, word);
        const std::uint64_t count = entries_at(directory);
        const std::string table = bytes(directory + count_bytes, count * entry_bytes);

        std::map<std::uint64_t, Entry> entries;
        for (std::uint64_t i = 0; (i + 1) * entry_bytes <= table.size(); ++i) {
            const std::uint64_t at = i * entry_bytes;
            Entry entry{number(table, at + 2, 2), number(table, at + 4, word), 0};
            const bool fits = entry.count <= word && entry.count * size_of(entry.type) <= word;
            entry.at = fits ? directory + count_bytes + at + 4 + word : number(table, at + 4 + word, word);
            entries.emplace(number(table, at, 2), entry);
        }
        return entries;
    }

    /// The values of an entry of whole numbers; empty when there are none, or more than a file of ours can need.
    std::vector<std::uint64_t> numbers(const Entry& entry) const {
        constexpr std::uint64_t most_values = 1u << 20;
        const std::uint64_t size = size_of(entry.type);
        if (entry.count > most_values) return {};
        const std::string values = bytes(entry.at, entry.count * size);
        std::vector<std::uint64_t> result;
        for (std::uint64_t i = 0; (i + 1) * size <= values.size(); ++i) result.push_back(number(values, i * size, size));
        return result;
    }

    std::string text(const Entry& entry) const { return bytes(entry.at, std::min<std::uint64_t>(entry.count, 64)); }

  private:
    /// BYTE, ASCII 1; SHORT 2; LONG 4; LONG8 8. Other types are none that we read.
    static std::uint64_t size_of(std::uint64_t type) { return type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 1; }

    /// Exactly these bytes, or none.
    std::string bytes(std::uint64_t at, std::uint64_t count) const {
        if (at > file_bytes_ || count > file_bytes_ - at) return {};
        std::string result(count, '\0');
        return ::pread(fd_, result.data(), count, off_t(at)) == ssize_t(count) ? result : std::string();
    }

    /// 0 where there are too few bytes.
    std::uint64_t number(const std::string& from, std::uint64_t at, std::uint64_t size) const {
        if (at + size > from.size()) return 0;
        std::uint64_t value = 0;
        for (std::uint64_t i = 0; i < size; ++i) {
            const std::uint64_t k = big_endian_ ? i : size - 1 - i;
            value = value << 8 | static_cast<unsigned char>(from[at + k]);
        }
        return value;
    }

    int fd_;
    std::uint64_t file_bytes_;
    bool big_endian_ = false;
    bool big_tiff_ = false;
};

bool all_inside(const std::vector<std::uint64_t>& offsets, const std::vector<std::uint64_t>& sizes, std::uint64_t file_bytes) {
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const std::uint64_t size = i < sizes.size() ? sizes[i] : 0;
        if (offsets[i] > file_bytes || size > file_bytes - offsets[i]) return false;
    }
    return true;
}

} // namespace

TiffFacts read_tiff_facts(int fd, std::uint64_t file_bytes, int index) {
    const Reader reader(fd, file_bytes);
    const std::map<std::uint64_t, Entry> entries = reader.directory(index);
    const auto numbers = [&](Tag tag) {
        const auto entry = entries.find(tag);
        return entry == entries.end() ? std::vector<std::uint64_t>() : reader.numbers(entry->second);
    };

    TiffFacts facts;
    facts.pixels_in_file = all_inside(numbers(strip_offsets), numbers(strip_bytes), file_bytes) &&
                           all_inside(numbers(tile_offsets), numbers(tile_bytes), file_bytes);
    if (const auto entry = entries.find(gdal_no_data); entry != entries.end()) {
        const std::string text = reader.text(entry->second);
        char* end = nullptr;
        const float value = std::strtof(text.c_str(), &end);
        if (end != text.c_str()) facts.no_data = value;
    }
    return facts;
}

} // namespace reliefbake
