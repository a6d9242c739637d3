#include "formats/encode_rows.h"

#include "formats/claims_json.h"

#include <utility>

namespace reliefbake {

Result<RowsEncoder> RowsEncoder::start(const EncodeRequest& request, int block_rows, int fd, const std::string& name) {
    const std::uint64_t whole = pixel_bytes(request), block = whole / std::uint64_t(request.height) * std::uint64_t(block_rows);
    constexpr std::uint64_t scratch = 256ull << 20, thread_memory = 160ull << 20; // as encode_image has them
    RowsEncoder encoder;
    encoder.name_ = name;
    // Deflate at 2 MiB a second is the slowest that 16-bit noise gives; a disk may stall for longer than it computes.
    encoder.limits_ = {int(30 + block / (2u << 20)), scratch + 8 * block + std::uint64_t(request.threads) * thread_memory};
    encoder.file_bytes_ = (1ull << 30) + 2 * whole;
    nlohmann::json message = encode_message(request);
    message["do"] = "encode_rows", message["block"] = block_rows, message["file"] = encoder.file_bytes_;

    ImageWorker& worker = ImageWorker::instance();
    encoder.lock_ = worker.lock();
    Result<Message> answer = worker.ask(message, fd, encoder.limits_, ImageWorker::Turn::first, ErrorCode::write_failed, name);
    if (!answer) return tl::unexpected(answer.error());
    auto memory = SharedMemory::adopt(std::move(answer->fd), unsigned_member(answer->body, "bytes"));
    if (!memory || memory->bytes().size() != block) return fail(ErrorCode::write_failed, name + ": the image helper's answer makes no sense");
    encoder.block_ = std::move(*memory);
    return encoder;
}

Result<void> RowsEncoder::take(int rows) {
    const Result<Message> answer = ImageWorker::instance().ask({{"do", "rows"}, {"rows", rows}, {"file", file_bytes_}}, -1, limits_,
                                                               ImageWorker::Turn::later, ErrorCode::write_failed, name_);
    if (!answer) return tl::unexpected(answer.error());
    return {};
}

} // namespace reliefbake
