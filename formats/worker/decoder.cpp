#include "formats/worker/decoder.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

namespace reliefbake::worker {

namespace {

constexpr std::size_t block_bytes = 4u << 20;

/// The library's message in one line, without the name of a file that only this process knows.
std::string one_line(std::string text, const std::string& path) {
    for (std::size_t at; (at = text.find(path)) != text.npos;) text.erase(at, path.size());
    std::string line;
    for (const char c : text) {
        if (c == '\n' && line.empty()) continue;
        if (c == '\n') line += "; ";
        else if (static_cast<unsigned char>(c) >= ' ') line += c;
    }
    constexpr std::size_t longest = 300;
    while (!line.empty() && (line.back() == ' ' || line.back() == ';')) line.pop_back();
    return line.empty() ? "cannot be decoded" : "cannot be decoded: " + line.substr(0, longest);
}

SampleType sample_type(OIIO::TypeDesc type) {
    switch (type.basetype) {
    case OIIO::TypeDesc::UINT8: return SampleType::uint8;
    case OIIO::TypeDesc::INT8: return SampleType::int8;
    case OIIO::TypeDesc::UINT16: return SampleType::uint16;
    case OIIO::TypeDesc::INT16: return SampleType::int16;
    case OIIO::TypeDesc::UINT32: return SampleType::uint32;
    case OIIO::TypeDesc::INT32: return SampleType::int32;
    case OIIO::TypeDesc::HALF: return SampleType::half;
    case OIIO::TypeDesc::FLOAT: return SampleType::float32;
    case OIIO::TypeDesc::DOUBLE: return SampleType::float64;
    default: throw Refusal(std::string("has samples of type ") + type.c_str() + ", which are not numbers");
    }
}

/// What Exif or an embedded profile say; OpenImageIO's own oiio:ColorSpace is a guess. Profiles spell names in Latin or in
/// UTF-16, so zero bytes are skipped.
bool says_srgb(const OIIO::ImageSpec& spec) {
    if (spec.get_int_attribute("Exif:ColorSpace") == 1) return true;
    const OIIO::ParamValue* profile = spec.find_attribute("ICCProfile");
    if (!profile) return false;
    std::string letters(static_cast<const char*>(profile->data()), std::size_t(profile->datasize()));
    std::erase(letters, '\0');
    return letters.find("sRGB") != letters.npos;
}

/// Our metadata: its own attribute, or TIFF's ImageDescription, the one free text that survives there.
std::string relief_text(const OIIO::ImageSpec& spec) {
    constexpr std::size_t longest = 64 * 1024;
    std::string text = spec.get_string_attribute("reliefbake");
    if (text.empty()) text = spec.get_string_attribute("ImageDescription");
    return text.starts_with("{") && text.size() <= longest ? text : std::string();
}

ImageClaims claims_of(const OIIO::ImageSpec& spec, const std::string& reader) {
    ImageClaims claims;
    claims.width = spec.width;
    claims.height = spec.height;
    claims.depth = spec.depth;
    claims.tile_width = spec.tile_width;
    claims.tile_height = spec.tile_height;
    claims.sample = sample_type(spec.format);
    claims.deep = spec.deep;
    claims.srgb_tagged = says_srgb(spec);
    claims.relief = relief_text(spec);
    if (spec.nchannels < 0 || spec.nchannels > max_channels)
        throw Refusal("claims " + std::to_string(spec.nchannels) + " channels; 1 to " + std::to_string(max_channels) +
                      " can be read");
    constexpr std::size_t longest_name = 64;
    for (int c = 0; c < spec.nchannels; ++c) claims.channels.push_back(spec.channel_name(c).substr(0, longest_name));

    // TIFF samples of 1 to 15 bits arrive scaled to 8 or 16; the other readers give whole bytes or mean something else.
    claims.bit_depth = 8 * sample_bytes(claims.sample);
    const int bits = spec.get_int_attribute("oiio:BitsPerSample", claims.bit_depth);
    if (reader == "tiff" && is_integer(claims.sample) && bits >= 1 && bits < claims.bit_depth) claims.bit_depth = bits;
    return claims;
}

/// One sample as a float: an integer divided by its type's largest value, correctly rounded (the library multiplies by a
/// rounded reciprocal instead). A sample of `bits` < 8 sizeof(T) was widened by repeating its bits: take the original.
template <class T>
float to_float(T value, int bits) {
    if constexpr (std::is_integral_v<T> && std::is_unsigned_v<T>) {
        const int shift = 8 * int(sizeof value) - bits;
        return float(double(value >> shift) / double(std::numeric_limits<T>::max() >> shift));
    } else if constexpr (std::is_integral_v<T>) {
        return float(double(value) / double(std::numeric_limits<T>::max()));
    } else {
        return float(value);
    }
}

template <class T>
void gather(const std::byte* native, std::size_t pixels, int stride, std::span<const int> offsets, int bits, float* out) {
    for (std::size_t p = 0; p < pixels; ++p)
        for (const int offset : offsets) {
            T value;
            std::memcpy(&value, native + (p * std::size_t(stride) + std::size_t(offset)) * sizeof value, sizeof value);
            *out++ = to_float(value, bits);
        }
}

} // namespace

void use_exr_threads(int threads) {
    OIIO::attribute("exr_threads", threads > 1 ? threads : -1); // -1: none beside the caller's
}

Decoder::Decoder(const std::string& reader, int fd, int level)
    : path_("/proc/self/fd/" + std::to_string(fd)), input_(OIIO::ImageInput::create(reader)), level_(level) {
    if (!input_) throw Refusal("this build of OpenImageIO has no " + reader + " reader");
    use_exr_threads(1);
    // Alpha is data here: hand out the stored numbers, not premultiplied ones.
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;
    if (!input_->open(path_, spec_, wishes)) throw Refusal(one_line(input_->geterror(), path_));
    const int top_width = spec_.width, top_height = spec_.height;
    if (level_ > 0 && !input_->seek_subimage(0, level_))
        throw Refusal("has no mip level " + std::to_string(level_));
    spec_ = input_->spec();
    claims_ = claims_of(spec_, reader);
    claims_.top_width = top_width;
    claims_.top_height = top_height;
    if (claims_.sample == SampleType::float64 && spec_.height == 1)
        throw Refusal("cannot be decoded: OpenImageIO delivers nothing for a single row of 64-bit samples");
}

void Decoder::choose(std::vector<int> channels) {
    if (channels.empty() || !channels_.empty()) throw Refusal("was asked for twice");
    const auto [first, last] = std::minmax_element(channels.begin(), channels.end());
    if (*first < 0 || *last >= spec_.nchannels) throw Refusal("has no such channel");
    first_channel_ = *first;
    end_channel_ = *last + 1;
    channels_ = std::move(channels);

    const std::size_t row_bytes = row_floats() * sizeof(float);
    block_rows_ = int(std::clamp<std::size_t>(block_bytes / row_bytes, 1, std::size_t(spec_.height)));
    if (spec_.tile_height > 0) {
        const int tile_rows = std::max(1, block_rows_ / spec_.tile_height);
        block_rows_ = int(std::min<std::int64_t>(std::int64_t(tile_rows) * spec_.tile_height, spec_.height));
    }
    // OpenImageIO 2.4 reports success and delivers nothing for 64-bit TIFF rows that are not whole strips.
    if (claims_.sample == SampleType::float64) block_rows_ = spec_.height;
    native_.resize(std::size_t(block_rows_) * std::size_t(spec_.width) * std::size_t(end_channel_ - first_channel_) *
                   std::max<std::size_t>(sizeof(float), std::size_t(sample_bytes(claims_.sample))));
}

void Decoder::read_native(int y_begin, int y_end) {
    // Integers as stored, because the library's own conversion is not exact; halves as floats, which is.
    const OIIO::TypeDesc read_as = claims_.sample == SampleType::half ? OIIO::TypeDesc(OIIO::TypeDesc::FLOAT) : spec_.format;
    const bool ok =
        spec_.tile_width > 0
            ? input_->read_tiles(0, level_, spec_.x, spec_.x + spec_.width, spec_.y + y_begin, spec_.y + y_end, spec_.z,
                                 spec_.z + 1, first_channel_, end_channel_, read_as, native_.data())
            : input_->read_scanlines(0, level_, spec_.y + y_begin, spec_.y + y_end, spec_.z, first_channel_, end_channel_,
                                     read_as, native_.data());
    if (!ok) throw Refusal(one_line(input_->geterror(), path_));
}

int Decoder::next_rows(float* out) {
    const int y_end = std::min(next_y_ + block_rows_, spec_.height);
    read_native(next_y_, y_end);
    const int rows = y_end - next_y_;
    next_y_ = y_end;

    std::vector<int> offsets;
    for (const int channel : channels_) offsets.push_back(channel - first_channel_);
    const int stride = end_channel_ - first_channel_;
    const std::size_t pixels = std::size_t(rows) * std::size_t(spec_.width);
    const auto convert = [&]<class T>(T) { gather<T>(native_.data(), pixels, stride, offsets, claims_.bit_depth, out); };
    switch (claims_.sample) {
    case SampleType::uint8: convert(std::uint8_t{}); break;
    case SampleType::int8: convert(std::int8_t{}); break;
    case SampleType::uint16: convert(std::uint16_t{}); break;
    case SampleType::int16: convert(std::int16_t{}); break;
    case SampleType::uint32: convert(std::uint32_t{}); break;
    case SampleType::int32: convert(std::int32_t{}); break;
    case SampleType::half:
    case SampleType::float32: convert(float{}); break;
    case SampleType::float64: convert(double{}); break;
    }
    return rows;
}

} // namespace reliefbake::worker
