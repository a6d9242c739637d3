#include "tests/cli/running_tool.h"

#include "tests/cli/run_tool.h"

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <pty.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace reliefbake::test {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void become_tool(const std::vector<std::string>& arguments) {
    std::vector<char*> argv{const_cast<char*>("reliefbake")};
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    if (chdir(work_folder().c_str()) != 0) _exit(126);
    dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
    execv(RELIEFBAKE_BINARY, argv.data());
    _exit(127);
}

} // namespace

int shell_status(int wait_status) {
    return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

RunningTool::RunningTool(std::vector<std::string> arguments, Stderr where) {
    work_folder(); // made here, not in the child
    pid_ = where == Stderr::terminal ? forkpty(&terminal_, nullptr, nullptr, nullptr) : fork();
    if (pid_ == 0) become_tool(arguments);
}

RunningTool::~RunningTool() {
    if (is_running()) {
        kill(pid_, SIGKILL);
        waitpid(pid_, nullptr, 0);
    }
    if (terminal_ >= 0) close(terminal_);
}

bool RunningTool::is_running() {
    int wait_status = 0;
    if (status_ < 0 && waitpid(pid_, &wait_status, WNOHANG) == pid_) status_ = shell_status(wait_status);
    return status_ < 0;
}

void RunningTool::signal(int number) const { kill(pid_, number); }

int RunningTool::wait(std::chrono::milliseconds patience) {
    const auto deadline = Clock::now() + patience;
    while (is_running() && Clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return status_;
}

std::vector<pid_t> RunningTool::children() const {
    std::vector<pid_t> pids;
    std::error_code gone; // the tool may end meanwhile
    // A child belongs to the thread that started it.
    for (const auto& thread : std::filesystem::directory_iterator("/proc/" + std::to_string(pid_) + "/task", gone)) {
        std::ifstream list(thread.path() / "children");
        for (pid_t pid; list >> pid;)
            pids.push_back(pid);
    }
    return pids;
}

std::string RunningTool::terminal_output() const {
    std::string output;
    char bytes[4096];
    // The last process that held the terminal is gone: reading on is an error.
    for (ssize_t size; (size = read(terminal_, bytes, sizeof bytes)) > 0;)
        output.append(bytes, std::size_t(size));
    return output;
}

bool is_alive(pid_t pid) {
    std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
    std::string number, name, state;
    return stat >> number >> name >> state && state != "Z" && state != "X";
}

} // namespace reliefbake::test
