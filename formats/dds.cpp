#include "formats/little_endian.h"
#include "formats/texture_file.h"

namespace reliefbake {

namespace {

// DDS_HEADER and DDS_HEADER_DXT10, by Microsoft's names.
constexpr std::uint32_t ddsd_caps = 0x1, ddsd_height = 0x2, ddsd_width = 0x4, ddsd_pitch = 0x8, ddsd_pixel_format = 0x1000,
                        ddsd_mip_map_count = 0x20000;
constexpr std::uint32_t ddscaps_complex = 0x8, ddscaps_texture = 0x1000, ddscaps_mip_map = 0x400000;
constexpr std::uint32_t ddpf_alpha_pixels = 0x1, ddpf_four_cc = 0x4, ddpf_rgb = 0x40;
constexpr std::uint32_t dimension_texture_2d = 3;
constexpr std::uint32_t alpha_mode_custom = 4; // the fourth channel is data, not opacity

std::uint32_t dxgi_format(BitDepth bits, int channels) {
    // By BitDepth, for one channel, two, and four; R8G8B8A8_UNORM has masks instead.
    constexpr std::uint32_t formats[][3] = {{61, 49, 28}, {56, 35, 11}, {54, 34, 10}, {41, 16, 2}};
    return formats[int(bits)][channels == 4 ? 2 : channels - 1];
}

bool has_masks(BitDepth bits, int channels) { return bits == BitDepth::unorm8 && channels == 4; }

/// DDS_PIXELFORMAT. RGBA of 8 bits in the old way, by masks, which every reader knows (OpenImageIO 2.4 reads no uncompressed format
/// behind a DX10 header); others have no masks.
void write_pixel_format(ByteWriter& out, BitDepth bits, int channels) {
    out.u32(32);
    if (!has_masks(bits, channels)) {
        out.u32(ddpf_four_cc);
        out.text("DX10");
        out.zeros(5 * 4);
        return;
    }
    out.u32(ddpf_rgb | ddpf_alpha_pixels);
    out.zeros(4);
    out.u32(32); // bits of a texel
    for (const std::uint32_t mask : {0xffu, 0xff00u, 0xff0000u, 0xff000000u}) out.u32(mask); // R, G, B, A
}

/// DDS_HEADER_DXT10.
void write_dx10_header(ByteWriter& out, BitDepth bits, int channels) {
    out.u32(dxgi_format(bits, channels));
    out.u32(dimension_texture_2d);
    out.u32(0); // no cube
    out.u32(1); // array of one
    out.u32(alpha_mode_custom);
}

void write_header(ByteWriter& out, BitDepth bits, int channels, const TextureLevel& top, std::uint32_t levels) {
    out.text("DDS ");
    out.u32(124); // size of this header
    out.u32(ddsd_caps | ddsd_height | ddsd_width | ddsd_pitch | ddsd_pixel_format | (levels > 1 ? ddsd_mip_map_count : 0));
    out.u32(std::uint32_t(top.height));
    out.u32(std::uint32_t(top.width));
    out.u32(std::uint32_t(top.pixels.size() / std::size_t(top.height))); // bytes of a row
    out.u32(0);                                                          // depth
    out.u32(levels);
    out.zeros(11 * 4);
    write_pixel_format(out, bits, channels);
    out.u32(ddscaps_texture | (levels > 1 ? ddscaps_complex | ddscaps_mip_map : 0));
    out.zeros(4 * 4);
}

} // namespace

std::vector<std::byte> encode_dds(BitDepth bits, int channels, std::span<const TextureLevel> levels) {
    ByteWriter out;
    write_header(out, bits, channels, levels[0], std::uint32_t(levels.size()));
    if (!has_masks(bits, channels)) write_dx10_header(out, bits, channels);
    for (const TextureLevel& level : levels) out.append(level.pixels);
    return out.take();
}

} // namespace reliefbake
