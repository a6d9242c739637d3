#pragma once
// Ctrl-C during a batch: time to say what was done, and none to finish it.

#include <atomic>
#include <functional>
#include <thread>

#include <signal.h>

namespace reliefbake {

/// While it lives, SIGINT and SIGTERM call `last_words` on a thread of its own; then temporaries are removed and the process ends with 130
/// or 143. To be made before the threads of the work, which inherit that they do not see these signals.
class InterruptWatch {
  public:
    explicit InterruptWatch(std::function<void(int signal)> last_words);
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

  private:
    void watch();

    std::function<void(int)> last_words_;
    sigset_t previous_;
    std::atomic<bool> over_ = false;
    std::thread thread_;
};

} // namespace reliefbake
