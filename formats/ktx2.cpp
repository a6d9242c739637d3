#include "formats/little_endian.h"
#include "formats/texture_file.h"

#include <algorithm>

namespace reliefbake {

namespace {

/// What a sample type is called in KTX 2.0 and in the Khronos Data Format specification 1.3.
struct Format {
    std::uint32_t vk_format; ///< VK_FORMAT_R8..., R16..._UNORM, R16..., R32..._SFLOAT
    std::uint32_t sample_bytes;
    std::uint8_t qualifiers; ///< of the channel: float and signed, or none
    std::uint32_t lower, upper; ///< what stands for 0 and 1; of floats the bits of -1 and 1
};

constexpr std::uint8_t float_signed = 0x80 | 0x40;
constexpr std::uint32_t minus_one = 0xbf800000, one = 0x3f800000;

Format format_of(BitDepth bits, int channels) {
    const auto of = [channels](std::uint32_t r, std::uint32_t rg, std::uint32_t rgba) { return channels == 1 ? r : channels == 2 ? rg : rgba; };
    switch (bits) {
    case BitDepth::unorm8: return {of(9, 16, 37), 1, 0, 0, 255};
    case BitDepth::unorm16: return {of(70, 77, 91), 2, 0, 0, 65535};
    case BitDepth::half: return {of(76, 83, 97), 2, float_signed, minus_one, one};
    case BitDepth::float32: return {of(100, 103, 109), 4, float_signed, minus_one, one};
    }
    return {};
}

/// The basic data format descriptor (KDF 1.3, section 5): RGBA, linear, no primaries, alpha not multiplied in.
std::vector<std::byte> data_format_descriptor(const Format& format, int channels) {
    const std::uint32_t block = 24 + std::uint32_t(channels) * 16;
    constexpr std::uint8_t model_rgbsda = 1, primaries_unspecified = 0, transfer_linear = 1, alpha_straight = 0;
    ByteWriter out;
    out.u32(4 + block);
    out.u32(0); // Khronos, basic format
    out.u16(2); // KDF 1.3
    out.u16(std::uint16_t(block));
    out.u8(model_rgbsda);
    out.u8(primaries_unspecified);
    out.u8(transfer_linear);
    out.u8(alpha_straight);
    out.zeros(4); // a texel block of 1 x 1 x 1 x 1
    out.u8(std::uint8_t(std::uint32_t(channels) * format.sample_bytes));
    out.zeros(7); // one plane
    constexpr std::uint8_t names[] = {0, 1, 2, 15}; // R, G, B, A
    for (int c = 0; c < channels; ++c) {
        out.u16(std::uint16_t(c * 8 * int(format.sample_bytes)));
        out.u8(std::uint8_t(8 * format.sample_bytes - 1));
        out.u8(names[c] | format.qualifiers);
        out.u32(0); // sample position
        out.u32(format.lower);
        out.u32(format.upper);
    }
    return out.take();
}

/// One entry: length, key, 0, value, 0, padded to 4.
void write_entry(ByteWriter& out, const std::string& key, const std::string& value) {
    out.u32(std::uint32_t(key.size() + value.size() + 2));
    out.text(key);
    out.zeros(1);
    out.text(value);
    out.zeros(1);
    out.align(4);
}

/// The level index and the levels. Offsets count from the file's start; the smallest level lies first, each at a multiple of
/// `alignment`: lcm(texel size, 4), and ours are powers of two.
void write_levels(ByteWriter& out, std::span<const TextureLevel> levels, std::size_t alignment, std::size_t data_start,
                  std::span<const std::byte> between) {
    std::vector<std::uint64_t> offsets(levels.size());
    std::size_t at = data_start;
    for (std::size_t n = levels.size(); n-- > 0;) {
        at = (at + alignment - 1) / alignment * alignment;
        offsets[n] = at;
        at += levels[n].pixels.size();
    }
    for (std::size_t n = 0; n < levels.size(); ++n) {
        out.u64(offsets[n]);
        out.u64(levels[n].pixels.size());
        out.u64(levels[n].pixels.size()); // uncompressed: the same
    }
    out.append(between);
    for (std::size_t n = levels.size(); n-- > 0;) {
        out.align(alignment);
        out.append(levels[n].pixels);
    }
}

} // namespace

std::vector<std::byte> encode_ktx2(BitDepth bits, int channels, std::span<const TextureLevel> levels, const std::string& metadata,
                                   const std::string& writer) {
    const Format format = format_of(bits, channels);
    const std::vector<std::byte> descriptor = data_format_descriptor(format, channels);
    ByteWriter keys; // sorted by key
    write_entry(keys, "KTXwriter", writer);
    write_entry(keys, "reliefbake", metadata);
    const std::vector<std::byte> key_values = keys.take();

    // Header and index.
    constexpr std::size_t head_bytes = 12 + 9 * 4 + 4 * 4 + 2 * 8, index_entry = 3 * 8;
    const std::size_t descriptor_at = head_bytes + index_entry * levels.size();
    const std::size_t keys_at = descriptor_at + descriptor.size();
    ByteWriter out;
    out.text("\xabKTX 20\xbb\r\n\x1a\n");
    out.u32(format.vk_format);
    out.u32(format.sample_bytes);
    out.u32(std::uint32_t(levels[0].width));
    out.u32(std::uint32_t(levels[0].height));
    out.u32(0); // depth
    out.u32(0); // not an array
    out.u32(1); // one face
    out.u32(std::uint32_t(levels.size()));
    out.u32(0); // not supercompressed
    out.u32(std::uint32_t(descriptor_at));
    out.u32(std::uint32_t(descriptor.size()));
    out.u32(std::uint32_t(keys_at));
    out.u32(std::uint32_t(key_values.size()));
    out.u64(0); // no data of a supercompression
    out.u64(0);

    ByteWriter between;
    between.append(descriptor);
    between.append(key_values);
    const std::vector<std::byte> middle = between.take();
    write_levels(out, levels, std::max<std::size_t>(4, std::size_t(channels) * format.sample_bytes), keys_at + key_values.size(), middle);
    return out.take();
}

} // namespace reliefbake
