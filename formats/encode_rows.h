#pragma once
// Pixels to an image file some rows at a time, in the helper process.

#include "bake/error.h"
#include "formats/encode_image.h"
#include "formats/image_worker.h"
#include "formats/shared_memory.h"

#include <cstddef>
#include <mutex>
#include <span>
#include <string>

namespace reliefbake {

/// The same bytes as encode_image makes of all rows at once. Holds the worker until it is destroyed.
class RowsEncoder {
  public:
    /// `fd`: where the file goes, from its first byte on; `block_rows`: most rows of a block. EXR and TIFF without mips.
    /// `name` is the file, for messages. Errors: write_failed, internal.
    static Result<RowsEncoder> start(const EncodeRequest& request, int block_rows, int fd, const std::string& name);

    /// Where the next rows go, block_rows of them at most.
    std::span<std::byte> block() { return block_->bytes(); }
    /// Takes the first `rows` of block(); with the last one the file is complete, though not yet on the disk. Errors: write_failed (its
    /// message tells a full disk).
    Result<void> take(int rows);

  private:
    RowsEncoder() = default;

    std::string name_;
    ImageWorker::Limits limits_{};
    std::uint64_t file_bytes_ = 0;
    std::unique_lock<std::mutex> lock_;
    std::optional<SharedMemory> block_;
};

} // namespace reliefbake
