// reliefbake-image-worker: answers the requests of formats/image_worker.h on standard input until the tool is gone.

#include "formats/claims_json.h"
#include "formats/message.h"
#include "formats/shared_memory.h"
#include "formats/worker/decoder.h"
#include "formats/worker/encoder.h"
#include "formats/worker/leave_with_tool.h"
#include "formats/worker/limits.h"
#include "formats/worker/row_encoder.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <new>
#include <optional>

namespace reliefbake::worker {

namespace {

using nlohmann::json;

constexpr int socket_fd = 0;

struct Answer {
    json body;
    int fd = -1;
};

/// One conversation at a time: the file being decoded and the memory that shows its rows, or the file just encoded.
class Conversation {
  public:
    Answer answer(Message& request) {
        const std::string what = request.body.at("do").get<std::string>();
        if (what == "next") return next();
        const std::uint64_t memory = request.body.at("memory").get<std::uint64_t>();
        limit_request(memory, request.body.at("cpu").get<std::uint64_t>(), std::max(memory, unsigned_member(request.body, "file")));
        if (what == "open") return open(request);
        if (what == "read") return read(request);
        if (what == "encode") return encode_to_memory(request);
        if (what == "encode_rows") return encode_rows(request);
        if (what == "rows") return take_rows(request);
        throw Refusal("the helper does not know the request " + what);
    }

    void forget() {
        decoder_.reset();
        rows_.reset();
        memory_.reset();
        file_.reset();
    }

  private:
    Answer open(Message& request) {
        forget();
        file_ = std::move(request.fd);
        decoder_.emplace(request.body.at("reader").get<std::string>(), file_.get(),
                         request.body.at("level").get<int>());
        return {claims_to_json(decoder_->claims())};
    }

    Answer read(Message& request) {
        if (!decoder_) throw Refusal("nothing is open");
        decoder_->choose(request.body.at("channels").get<std::vector<int>>());
        show(std::uint64_t(decoder_->block_rows()) * decoder_->row_floats() * sizeof(float));
        return {{{"bytes", memory_->bytes().size()}}, memory_->fd()};
    }

    Answer next() {
        if (!decoder_ || !memory_) throw Refusal("nothing is being read");
        return {{{"rows", decoder_->next_rows(reinterpret_cast<float*>(memory_->bytes().data()))}}};
    }

    Answer encode_to_memory(Message& request) {
        forget();
        std::vector<unsigned char> file;
        {
            const auto pixels = SharedMemory::adopt(std::move(request.fd), unsigned_member(request.body, "bytes"));
            if (!pixels) throw Refusal("no pixels came with the request");
            file = encode(request.body, pixels->bytes());
        }
        show(file.size());
        std::memcpy(memory_->bytes().data(), file.data(), file.size());
        return {{{"bytes", file.size()}}, memory_->fd()};
    }

    Answer encode_rows(Message& request) {
        forget();
        rows_.emplace(request.body, std::move(request.fd));
        show(rows_->row_bytes() * request.body.at("block").get<std::uint64_t>());
        return {{{"bytes", memory_->bytes().size()}}, memory_->fd()};
    }

    Answer take_rows(const Message& request) {
        if (!rows_ || !memory_) throw Refusal("no file is being written");
        rows_->write(request.body.at("rows").get<int>(), memory_->bytes());
        return {json::object()};
    }

    void show(std::uint64_t bytes) {
        memory_ = SharedMemory::create(bytes);
        if (!memory_) throw std::bad_alloc();
    }

    UniqueFd file_;
    std::optional<Decoder> decoder_;
    std::optional<RowEncoder> rows_;
    std::optional<SharedMemory> memory_;
};

Answer answer_or_error(Conversation& conversation, Message& request) {
    try {
        return conversation.answer(request);
    } catch (const Refusal& refusal) {
        conversation.forget();
        return {{{"error", refusal.what()}}};
    } catch (const std::bad_alloc&) {
        conversation.forget();
        return {{{"error", "needs more memory than its budget; --max-bytes lifts it"}}};
    } catch (const std::exception& error) {
        conversation.forget();
        return {{{"error", std::string("the image helper failed: ") + error.what()}}};
    }
}

/// One thread: the tool runs many jobs, and this process is one of them.
void configure_library() {
    OIIO::attribute("threads", 1);
    OIIO::attribute("plugin_searchpath", "");
    OIIO::attribute("try_all_readers", 0);
    OIIO::attribute("limits:imagesize_MB", std::numeric_limits<int>::max()); // check_claims judges, with a clear line
}

} // namespace

} // namespace reliefbake::worker

int main() {
    using namespace reliefbake;
    worker::limit_process();
    worker::leave_with_tool(worker::socket_fd);
    worker::configure_library();
    worker::Conversation conversation;
    for (;;) {
        Received received = receive_message(worker::socket_fd);
        if (received.status != ReceiveStatus::ok) return 0;
        const worker::Answer answer = worker::answer_or_error(conversation, received.message);
        if (!send_message(worker::socket_fd, answer.body, answer.fd)) return 0;
    }
}
