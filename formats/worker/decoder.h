#pragma once
// Decoding with OpenImageIO: one open file, its claims, float rows.

#include "formats/image_gate.h"

#include <OpenImageIO/imageio.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace reliefbake::worker {

/// A refusal in words that make sense after "file: ".
struct Refusal : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Threads that OpenEXR uses for the files opened from now on.
void use_exr_threads(int threads);

class Decoder {
  public:
    /// Opens mip level `level` of the file behind `fd` with the named reader and no other. Throws Refusal.
    Decoder(const std::string& reader, int fd, int level);

    const ImageClaims& claims() const { return claims_; }

    /// Fixes the channels to read (indices into claims().channels). Throws Refusal.
    void choose(std::vector<int> channels);
    std::size_t row_floats() const { return std::size_t(spec_.width) * channels_.size(); }
    /// Rows that one call of next_rows delivers at most: about 4 MiB, at least one row or one row of tiles,
    /// and the whole image when its samples have 64 bits.
    int block_rows() const { return block_rows_; }
    /// Decodes the next rows to `out`, top to bottom; returns how many. Throws Refusal.
    int next_rows(float* out);

  private:
    void read_native(int y_begin, int y_end);

    std::string path_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    ImageClaims claims_;
    std::vector<int> channels_;
    int level_ = 0;
    int first_channel_ = 0, end_channel_ = 0; ///< the smallest range that holds channels_
    int block_rows_ = 0;
    int next_y_ = 0;
    std::vector<std::byte> native_; ///< one block as the library delivers it
};

} // namespace reliefbake::worker
