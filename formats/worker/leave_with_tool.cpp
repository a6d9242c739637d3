#include "formats/worker/leave_with_tool.h"

#include <cerrno>
#include <poll.h>
#include <thread>
#include <unistd.h>

namespace reliefbake::worker {

void leave_with_tool(int socket) {
    std::thread([socket] {
        pollfd hang_up{socket, 0, 0}; // POLLHUP is reported without being asked for
        while (::poll(&hang_up, 1, -1) < 0 && errno == EINTR) {}
        ::_exit(0);
    }).detach();
}

} // namespace reliefbake::worker
