#pragma once
// Messages between the tool and its helper process: one small JSON value and at most one file descriptor each, over
// a SOCK_SEQPACKET socket. Used by both sides; the conversation itself is described in image_worker.h.

#include "formats/unique_fd.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <optional>

namespace reliefbake {

struct Message {
    nlohmann::json body;
    UniqueFd fd; ///< may be empty
};

/// Longest message; strings out of files are cut well below it.
constexpr std::size_t max_message_bytes = 128 * 1024;

/// False when the other side is gone or the message is too long.
bool send_message(int socket, const nlohmann::json& body, int fd = -1);

enum class ReceiveStatus { ok, closed, timed_out };
struct Received {
    ReceiveStatus status;
    Message message;
};

/// Waits until `deadline` (none: for ever). Anything that is not one JSON object counts as `closed`.
Received receive_message(int socket, std::optional<std::chrono::steady_clock::time_point> deadline = std::nullopt);

} // namespace reliefbake
