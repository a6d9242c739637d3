#pragma once
// The tool as a process that can be watched and interrupted.

#include <chrono>
#include <string>
#include <vector>

#include <sys/types.h>

namespace reliefbake::test {

/// A shell's exit status: the program's own, or 128 + the signal that ended it.
int shell_status(int wait_status);

/// `reliefbake ARGUMENTS` in the work folder, its stdout thrown away; killed when its owner leaves it running.
class RunningTool {
  public:
    enum class Stderr { inherited, terminal };
    explicit RunningTool(std::vector<std::string> arguments, Stderr where = Stderr::inherited);
    ~RunningTool();
    RunningTool(const RunningTool&) = delete;
    RunningTool& operator=(const RunningTool&) = delete;

    bool is_running();
    void signal(int number) const;
    /// Exit status as a shell tells it, or -1 when it still runs after `patience`.
    int wait(std::chrono::milliseconds patience);
    /// Processes it has started.
    std::vector<pid_t> children() const;
    /// All that it has written to its terminal until it left; only with Stderr::terminal.
    std::string terminal_output() const;

  private:
    pid_t pid_ = 0;
    int terminal_ = -1;
    int status_ = -1;
};

/// Whether a process is there and does anything; one that nobody has waited for does not.
bool is_alive(pid_t pid);

} // namespace reliefbake::test
