#include "formats/message.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

namespace reliefbake {

using Clock = std::chrono::steady_clock;

bool send_message(int socket, const nlohmann::json& body, int fd) {
    // Strings out of files need not be UTF-8: replace what is not, instead of throwing.
    std::string text = body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    if (text.size() > max_message_bytes) return false;

    iovec part{text.data(), text.size()};
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
    if (fd >= 0) {
        header.msg_control = control;
        header.msg_controllen = sizeof control;
        cmsghdr* rights = CMSG_FIRSTHDR(&header);
        rights->cmsg_level = SOL_SOCKET;
        rights->cmsg_type = SCM_RIGHTS;
        rights->cmsg_len = CMSG_LEN(sizeof fd);
        std::memcpy(CMSG_DATA(rights), &fd, sizeof fd);
    }
    ssize_t sent;
    do sent = ::sendmsg(socket, &header, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent == ssize_t(text.size());
}

namespace {

ReceiveStatus wait_readable(int socket, std::optional<Clock::time_point> deadline) {
    for (;;) {
        int milliseconds = -1;
        if (deadline) {
            const auto left = std::chrono::ceil<std::chrono::milliseconds>(*deadline - Clock::now()).count();
            if (left <= 0) return ReceiveStatus::timed_out;
            milliseconds = int(std::min<long long>(left, 1'000'000));
        }
        pollfd poll_for{socket, POLLIN, 0};
        const int ready = ::poll(&poll_for, 1, milliseconds);
        if (ready > 0) return ReceiveStatus::ok;
        if (ready < 0 && errno != EINTR) return ReceiveStatus::closed;
    }
}

UniqueFd descriptor_of(msghdr& header) {
    for (cmsghdr* part = CMSG_FIRSTHDR(&header); part; part = CMSG_NXTHDR(&header, part))
        if (part->cmsg_level == SOL_SOCKET && part->cmsg_type == SCM_RIGHTS && part->cmsg_len == CMSG_LEN(sizeof(int))) {
            int fd;
            std::memcpy(&fd, CMSG_DATA(part), sizeof fd);
            return UniqueFd(fd);
        }
    return UniqueFd();
}

} // namespace

Received receive_message(int socket, std::optional<Clock::time_point> deadline) {
    const ReceiveStatus ready = wait_readable(socket, deadline);
    if (ready != ReceiveStatus::ok) return {ready, {}};

    std::string text(max_message_bytes, '\0');
    iovec part{text.data(), text.size()};
    msghdr header{};
    header.msg_iov = &part;
    header.msg_iovlen = 1;
    alignas(cmsghdr) char control[CMSG_SPACE(sizeof(int))] = {};
    header.msg_control = control;
    header.msg_controllen = sizeof control;
    ssize_t size;
    do size = ::recvmsg(socket, &header, MSG_CMSG_CLOEXEC);
    while (size < 0 && errno == EINTR);
    if (size <= 0) return {ReceiveStatus::closed, {}};

    Message message;
    message.fd = descriptor_of(header);
    text.resize(std::size_t(size));
    message.body = nlohmann::json::parse(text, nullptr, false);
    if ((header.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) || !message.body.is_object()) return {ReceiveStatus::closed, {}};
    return {ReceiveStatus::ok, std::move(message)};
}

} // namespace reliefbake
