// What the helper may say: any bytes on the socket, and any object as an image's claims.

#include "formats/claims_json.h"
#include "formats/image_gate.h"
#include "formats/message.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <sys/socket.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace reliefbake;
    static int ends[2];
    static const int made = socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends);
    if (made != 0) std::abort();
    if (size == 0 || send(ends[0], data, size, 0) != ssize_t(size)) return 0;
    const Received received = receive_message(ends[1]);
    if (received.status != ReceiveStatus::ok) return 0;
    unsigned_member(received.message.body, "bytes");
    if (const auto claims = claims_from_json(received.message.body)) (void)check_claims(*claims, size, 0, 1, "fuzz");
    return 0;
}
