#include "formats/worker/row_encoder.h"

#include "formats/worker/decoder.h"
#include "formats/worker/encoder.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace reliefbake::worker {

size_t CheckedFile::write(const void* data, size_t size) {
    const size_t written = pwrite(data, size, m_pos);
    m_pos += std::int64_t(written);
    return written;
}

size_t CheckedFile::pwrite(const void* data, size_t size, std::int64_t offset) {
    const char* from = static_cast<const char*>(data);
    size_t done = 0;
    while (done < size && error_ == 0) {
        const ssize_t written = ::pwrite(fd_, from + done, std::min<size_t>(size - done, 1u << 30), offset + off_t(done));
        if (written > 0) done += size_t(written);
        else if (written == 0 || errno != EINTR) error_ = written == 0 ? EIO : errno;
    }
    size_ = std::max(size_, size_t(offset) + done);
    return done;
}

RowEncoder::RowEncoder(const nlohmann::json& request, UniqueFd file)
    : fd_(std::move(file)), file_(fd_.get()), spec_(spec_of(request)), given_(request.at("pixels").get<std::string>()),
      output_(OIIO::ImageOutput::create(request.at("writer").get<std::string>())) {
    if (!fd_) throw Refusal("no file came with the request");
    if (!output_ || !output_->supports("ioproxy")) throw Refusal("this build of OpenImageIO has no such writer");
    use_exr_threads(request.at("threads").get<int>());
    output_->set_ioproxy(&file_);
    refuse_if_failed(output_->open("rows", spec_));
}

void RowEncoder::write(int rows, std::span<const std::byte> pixels) {
    if (rows < 1 || rows > spec_.height - next_ || pixels.size() < std::uint64_t(rows) * row_bytes()) throw Refusal("was sent rows that it has not");
    refuse_if_failed(output_->write_scanlines(next_, next_ + rows, 0, given_, pixels.data()));
    next_ += rows;
    if (next_ == spec_.height) refuse_if_failed(output_->close());
}

void RowEncoder::refuse_if_failed(bool ok) {
    if (file_.error()) throw Refusal("writing stopped half-way, nothing was left behind: " + std::generic_category().message(file_.error()));
    if (!ok) throw Refusal("cannot be encoded: " + output_->geterror());
}

} // namespace reliefbake::worker
