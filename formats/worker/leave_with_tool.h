#pragma once
// The helper's end when the tool is gone, in the middle of a request too.

namespace reliefbake::worker {

/// Ends this process as soon as the other end of `socket` is closed: an interrupted tool leaves nobody computing.
void leave_with_tool(int socket);

} // namespace reliefbake::worker
