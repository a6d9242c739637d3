#include "cli/signals.h"

#include "bake/error.h"
#include "cli/stage_clock.h"
#include "formats/atomic_file.h"

#include <csignal>
#include <string_view>
#include <unistd.h>

namespace reliefbake {

namespace {

// A shell reports a process ended by signal N as 128 + N (POSIX sh, "Exit Status for Commands").
void clean_up_and_exit(int signal) {
    remove_temporaries_on_signal();
    erase_progress_on_signal();
    _exit(128 + signal);
}

/// What is mapped can no longer be read: working space on a disk that has failed (formats/mapped_storage).
void tell_lost_space_and_exit(int) {
    constexpr std::string_view words = "reliefbake: the working space on the disk cannot be read or written any more; nothing was left behind\n";
    remove_temporaries_on_signal();
    erase_progress_on_signal();
    (void)!::write(STDERR_FILENO, words.data(), words.size());
    _exit(int(ErrorCode::write_failed));
}

} // namespace

void leave_no_temporaries_when_interrupted() noexcept {
    struct sigaction action = {};
    action.sa_handler = clean_up_and_exit;
    sigfillset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    action.sa_handler = tell_lost_space_and_exit;
    sigaction(SIGBUS, &action, nullptr);
}

} // namespace reliefbake
