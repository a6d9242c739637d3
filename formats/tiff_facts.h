#pragma once
// What OpenImageIO 2.4 does not tell about a TIFF: whether its pixels are all there, and GDAL_NODATA.

#include <cstdint>
#include <optional>

namespace reliefbake {

struct TiffFacts {
    bool pixels_in_file = true;    ///< every strip or tile of the directory ends inside the file
    std::optional<float> no_data;  ///< GDAL_NODATA: the value that means "no sample here"
};

/// Reads directory number `index` (mip level `index` of a texture) of a classic or Big TIFF (TIFF 6.0, section 2; BigTIFF design, AWare Systems). Any bytes are
/// safe; what cannot be followed is left to the decoder's judgement.
TiffFacts read_tiff_facts(int fd, std::uint64_t file_bytes, int index = 0);

} // namespace reliefbake
