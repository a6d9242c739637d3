// What OpenImageIO's DDS reader makes of our files: a second opinion for the formats that it knows.

#include "formats/map_file.h"

#include "mip_maps.h"
#include "temporary_folder.h"

#include <OpenImageIO/imageio.h>
#include <catch2/catch.hpp>

#include <cstdio>

using namespace reliefbake;
using namespace reliefbake::test;

TEST_CASE("OpenImageIO reads our DDS where it knows the format") {
    TemporaryFolder folder;
    const char* names[] = {"8", "16", "half", "float"};
    for (const BitDepth bits : {BitDepth::unorm8, BitDepth::unorm16, BitDepth::half, BitDepth::float32}) {
        const std::vector<ReliefMap> chain = mip_chain(12, 7, bits);
        REQUIRE(write_map_levels(folder / "m.dds", chain));
        OIIO::ImageSpec wishes;
        wishes["oiio:UnassociatedAlpha"] = 1;
        const auto input = OIIO::ImageInput::open((folder / "m.dds").string(), &wishes);
        if (bits == BitDepth::unorm8) REQUIRE(input);
        if (!input) {
            std::printf("OpenImageIO %s does not read DDS of %s bits with a DX10 header: %s\n", OIIO_VERSION_STRING,
                        names[int(bits)], OIIO::geterror().c_str());
            continue;
        }
        std::printf("OpenImageIO %s reads DDS of %s bits\n", OIIO_VERSION_STRING, names[int(bits)]);
        for (std::size_t n = 0; n < chain.size(); ++n) {
            CAPTURE(int(bits), n);
            REQUIRE(input->seek_subimage(0, int(n)));
            const OIIO::ImageSpec spec = input->spec();
            REQUIRE(spec.width == chain[n].grid.width);
            REQUIRE(spec.height == chain[n].grid.height);
            std::vector<float> pixels(spec.image_pixels() * std::size_t(spec.nchannels));
            REQUIRE(input->read_image(0, int(n), 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data()));
            for (std::size_t i = 0; i < chain[n].depth.size(); ++i) {
                CHECK(pixels[4 * i + 2] == Approx(chain[n].cone[i]));
                CHECK(pixels[4 * i + 3] == Approx(chain[n].depth[i]));
            }
        }
    }
}
