// The walk over a TIFF's tags: any bytes.

#include "formats/tiff_facts.h"
#include "formats/unique_fd.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <sys/mman.h>
#include <unistd.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace reliefbake;
    static const UniqueFd file(memfd_create("fuzz", MFD_CLOEXEC));
    if (ftruncate(file.get(), 0) != 0 || pwrite(file.get(), data, size, 0) != ssize_t(size)) std::abort();
    read_tiff_facts(file.get(), size);
    return 0;
}
