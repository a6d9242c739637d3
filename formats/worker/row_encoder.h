#pragma once
// Encoding with OpenImageIO to an open file, some rows at a time.

#include "formats/unique_fd.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace reliefbake::worker {

/// Writes to a descriptor and remembers the first error: the libraries forget theirs.
class CheckedFile : public OIIO::Filesystem::IOProxy {
  public:
    explicit CheckedFile(int fd) : IOProxy("rows", Write), fd_(fd) {}
    const char* proxytype() const override { return "file"; }
    bool opened() const override { return true; }
    void close() override {}
    bool seek(std::int64_t offset) override {
        m_pos = offset;
        return true;
    }
    size_t write(const void* data, size_t size) override;
    size_t pwrite(const void* data, size_t size, std::int64_t offset) override;
    size_t size() const override { return size_; }
    int error() const { return error_; } ///< errno of the first failed write, or 0

  private:
    int fd_;
    size_t size_ = 0;
    int error_ = 0;
};

/// One EXR or TIFF. Throws Refusal wherever a write or the encoder fails.
class RowEncoder {
  public:
    RowEncoder(const nlohmann::json& request, UniqueFd file);

    std::uint64_t row_bytes() const { return std::uint64_t(spec_.width) * std::uint64_t(spec_.nchannels) * given_.size(); }
    int height() const { return spec_.height; }
    /// The next rows, interleaved; the file is complete with the last one.
    void write(int rows, std::span<const std::byte> pixels);

  private:
    void refuse_if_failed(bool ok);

    UniqueFd fd_;
    CheckedFile file_;
    OIIO::ImageSpec spec_;
    OIIO::TypeDesc given_;
    std::unique_ptr<OIIO::ImageOutput> output_;
    int next_ = 0;
};

} // namespace reliefbake::worker
