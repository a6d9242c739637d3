#include "cli/signals.h"

#include "cli/stage_clock.h"
#include "formats/atomic_file.h"

#include <csignal>
#include <unistd.h>

namespace reliefbake {

namespace {

// A shell reports a process ended by signal N as 128 + N (POSIX sh, "Exit Status for Commands").
void clean_up_and_exit(int signal) {
    remove_temporaries_on_signal();
    erase_progress_on_signal();
    _exit(128 + signal);
}

} // namespace

void leave_no_temporaries_when_interrupted() noexcept {
    struct sigaction action = {};
    action.sa_handler = clean_up_and_exit;
    sigfillset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

} // namespace reliefbake
