#include "cli/batch/interrupt.h"

#include "formats/atomic_file.h"

#include <ctime>
#include <unistd.h>

namespace reliefbake {

namespace {

sigset_t watched_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

} // namespace

InterruptWatch::InterruptWatch(std::function<void(int)> last_words) : last_words_(std::move(last_words)) {
    const sigset_t signals = watched_signals();
    pthread_sigmask(SIG_BLOCK, &signals, &previous_);
    thread_ = std::thread(&InterruptWatch::watch, this);
}

InterruptWatch::~InterruptWatch() {
    over_ = true;
    thread_.join();
    pthread_sigmask(SIG_SETMASK, &previous_, nullptr);
}

void InterruptWatch::watch() {
    const sigset_t signals = watched_signals();
    constexpr timespec patience{0, 20'000'000}; // between looks at the end of the work
    while (!over_) {
        const int signal = sigtimedwait(&signals, nullptr, &patience);
        if (signal < 0) continue;
        last_words_(signal);
        remove_temporaries_on_signal();
        _exit(128 + signal); // as a shell reports it (cli/signals.cpp)
    }
}

} // namespace reliefbake
