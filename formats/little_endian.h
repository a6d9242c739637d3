#pragma once
// Bytes of a file, number by number.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

namespace reliefbake {

/// Appends little-endian numbers and texts.
class ByteWriter {
  public:
    void u8(std::uint8_t value) { number(value); }
    void u16(std::uint16_t value) { number(value); }
    void u32(std::uint32_t value) { number(value); }
    void u64(std::uint64_t value) { number(value); }
    void zeros(std::size_t count) { bytes_.resize(bytes_.size() + count); }
    void text(std::string_view text) { append(std::as_bytes(std::span(text))); }
    void append(std::span<const std::byte> more) { bytes_.insert(bytes_.end(), more.begin(), more.end()); }
    /// Zeros up to the next multiple of `alignment`.
    void align(std::size_t alignment) { zeros((alignment - size() % alignment) % alignment); }
    std::size_t size() const { return bytes_.size(); }
    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");
    template <class T>
    void number(T value) {
        append(std::as_bytes(std::span(&value, 1)));
    }
    std::vector<std::byte> bytes_;
};

} // namespace reliefbake
