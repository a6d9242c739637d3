#pragma once
// The helper process reliefbake-image-worker: the only program that links OpenImageIO. Untrusted files are decoded
// there under limits of memory, CPU time and file size, and images are encoded there. It is spawned on first use,
// kept, and started afresh after it died; the tool itself pays neither the 0.2 s nor the 131 MB of OpenImageIO's
// libraries, and no file can take the tool down.
//
// The conversation (message.h); every answer may instead be {"error": text}:
//   open   {do, reader, level, memory, cpu} + file -> claims of that mip level (claims_from_json)
//   read   {do, channels, cpu}                  -> {bytes} + shared memory, then {rows} for each block of rows in it;
//   next   {do}  once a block has been taken    -> {rows}: float samples, interleaved in the order of `channels`
//   encode {do, writer, width, height, channels, sample, attributes, bytes, mips, threads, cpu} + pixels
//                                               -> {bytes} + encoded file
//   encode_rows {do, writer ... as encode, block, file} + output -> {bytes} + shared memory for `block` rows, then as often as needed
//   rows   {do, rows, file}  once so many rows lie there -> {}: they are in the file, which is complete with the last
// `memory` (bytes of address space above the worker's own) and `cpu` (seconds) are the limits of that request; `file`, where given, of the file it writes.

#include "bake/error.h"
#include "formats/message.h"

#include <chrono>
#include <filesystem>
#include <mutex>
#include <string>
#include <utility>

#include <sys/types.h>

namespace reliefbake {

class ImageWorker {
  public:
    /// The worker of this thread: that of its OwnImageWorker, else the one that all other threads share. That one is never destroyed:
    /// it leaves when this process does.
    static ImageWorker& instance();

    /// Held for a whole conversation (open ... last block; encode).
    std::unique_lock<std::mutex> lock() { return std::unique_lock(mutex_); }

    enum class Turn { first, later }; ///< of a conversation: a first request survives that the worker died while idle

    struct Limits {
        int cpu_seconds;
        std::uint64_t memory;
        /// Wall-clock time that stops a worker which hangs instead of computing; a loaded machine must not meet it.
        std::chrono::seconds wall() const { return std::chrono::seconds(20 + 8 * cpu_seconds); }
    };

    /// Sends one request and waits for its answer. When the worker dies or does not answer in time, or answers
    /// {"error"}: an Error with `code` and one line that begins with `name`. Errors: `code`, internal (no helper).
    Result<Message> ask(nlohmann::json request, int fd, Limits limits, Turn turn, ErrorCode code, const std::string& name);

    /// Process id of the running worker, or 0.
    pid_t pid() const { return pid_; }

    /// Whether the worker was killed since the last call, from outside or for want of an answer: what it worked on may be well.
    bool take_killed() { return std::exchange(killed_, false); }

  private:
    friend class OwnImageWorker;
    ImageWorker() = default;
    Result<void> start();
    std::string stop();

    std::mutex mutex_;
    UniqueFd socket_;
    pid_t pid_ = 0;
    bool killed_ = false;
};

/// Gives the thread that makes it a worker of its own, for as long as it lives: threads that read and write files at once do not
/// wait for each other. Spawned on first use.
class OwnImageWorker {
  public:
    OwnImageWorker();
    ~OwnImageWorker();
    OwnImageWorker(const OwnImageWorker&) = delete;
    OwnImageWorker& operator=(const OwnImageWorker&) = delete;

  private:
    ImageWorker worker_;
    ImageWorker* outer_;
};

} // namespace reliefbake
