#include "formats/image_worker.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <cstring>
#include <string_view>
#include <system_error>
#include <vector>

namespace reliefbake {

namespace fs = std::filesystem;

namespace {

constexpr const char* worker_name = "reliefbake-image-worker";

/// Beside this program (build tree), or in ../libexec/reliefbake (installed).
Result<fs::path> find_worker() {
    std::error_code error;
    const fs::path here = fs::read_symlink("/proc/self/exe", error).parent_path();
    const fs::path candidates[] = {here / worker_name, here.parent_path() / "libexec/reliefbake" / worker_name};
    for (const fs::path& candidate : candidates)
        if (fs::exists(candidate, error)) return candidate;
    return fail(ErrorCode::internal, "the helper " + std::string(worker_name) + " is neither in " + here.string() + " nor in " +
                                         candidates[1].parent_path().string() + "; reinstall reliefbake");
}

/// This process's environment in the C locale and UTC, less what steers OpenImageIO: same bytes on every machine.
std::vector<std::string> worker_environment() {
    std::vector<std::string> variables;
    for (char** variable = environ; *variable; ++variable) {
        const std::string_view text = *variable;
        const bool replaced = text.starts_with("LC_ALL=") || text.starts_with("TZ=");
        const bool steers = text.starts_with("OIIO_") || text.starts_with("OPENIMAGEIO_");
        if (!replaced && !steers) variables.emplace_back(text);
    }
    variables.push_back("LC_ALL=C");
    variables.push_back("TZ=UTC0");
    return variables;
}

/// Spawns with `socket` as standard input, nothing else inherited; posix_spawn because threads may be running.
int spawn_worker(const fs::path& program, int socket, pid_t& pid) {
    std::vector<std::string> variables = worker_environment();
    std::vector<char*> environment;
    for (std::string& variable : variables) environment.push_back(variable.data());
    environment.push_back(nullptr);
    std::string name = program.string();
    char* arguments[] = {name.data(), nullptr};

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, socket, 0);
    posix_spawn_file_actions_addopen(&files, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files, 2, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addclosefrom_np(&files, 3);

    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // A farm ends all processes of a job at once: the worker leaves with the tool, not before, or its file would seem to be at fault.
    sigset_t blocked, all;
    sigemptyset(&blocked);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&blocked, signal);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes, &blocked);
    posix_spawnattr_setsigdefault(&attributes, &all);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

    const int error = ::posix_spawn(&pid, name.c_str(), &files, &attributes, arguments, environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

/// How a process ended, in words that make sense after "file: ".
std::string describe_end(int status) {
    if (WIFEXITED(status)) return "the image helper gave up (exit " + std::to_string(WEXITSTATUS(status)) + ")";
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU) return "takes more processor time than an image of its size should; refused";
    const char* name = ::sigabbrev_np(signal);
    return "the image helper was stopped by SIG" + std::string(name ? name : "?") +
           (signal == SIGKILL ? "" : "; the file is damaged or hostile");
}

thread_local ImageWorker* own_worker = nullptr;

} // namespace

ImageWorker& ImageWorker::instance() {
    static ImageWorker& worker = *new ImageWorker;
    return own_worker ? *own_worker : worker;
}

OwnImageWorker::OwnImageWorker() : outer_(own_worker) { own_worker = &worker_; }

OwnImageWorker::~OwnImageWorker() {
    own_worker = outer_;
    if (worker_.socket_) worker_.stop();
}

Result<void> ImageWorker::start() {
    const Result<fs::path> program = find_worker();
    if (!program) return tl::unexpected(program.error());
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0)
        return fail(ErrorCode::internal, std::string("cannot make a socket: ") + std::strerror(errno));
    UniqueFd ours(ends[0]), theirs(ends[1]);
    if (const int error = spawn_worker(*program, theirs.get(), pid_)) {
        pid_ = 0;
        return fail(ErrorCode::internal, "cannot start " + program->string() + ": " + std::generic_category().message(error));
    }
    socket_ = std::move(ours);
    return {};
}

/// Ends the worker, if it has not ended yet, and says how it ended.
std::string ImageWorker::stop() {
    int status = 0;
    // A process that is already dying keeps the status it is dying with. The socket closes last: a helper that sees it
    // close leaves by itself, and that is not how this one ends.
    ::kill(pid_, SIGKILL);
    pid_t waited;
    do waited = ::waitpid(pid_, &status, 0);
    while (waited < 0 && errno == EINTR);
    socket_.reset();
    pid_ = 0;
    killed_ = killed_ || waited < 0 || (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    return waited > 0 ? describe_end(status) : "the image helper disappeared";
}

Result<Message> ImageWorker::ask(nlohmann::json request, int fd, Limits limits, Turn turn, ErrorCode code,
                                 const std::string& name) {
    request["cpu"] = limits.cpu_seconds;
    request["memory"] = limits.memory;

    bool sent = socket_ && send_message(socket_.get(), request, fd);
    if (!sent && turn == Turn::first) {
        if (socket_) stop();
        if (Result<void> started = start(); !started) return tl::unexpected(started.error());
        sent = send_message(socket_.get(), request, fd);
    }
    if (!sent) return fail(code, name + ": " + (socket_ ? stop() : "the image helper is not running"));

    Received received = receive_message(socket_.get(), std::chrono::steady_clock::now() + limits.wall());
    if (received.status == ReceiveStatus::timed_out) {
        stop();
        return fail(code, name + ": no answer from the image helper within " + std::to_string(limits.wall().count()) +
                              " s; refused");
    }
    if (received.status == ReceiveStatus::closed) return fail(code, name + ": " + stop());
    if (const auto error = received.message.body.find("error"); error != received.message.body.end())
        return fail(code, name + ": " + (error->is_string() ? error->get<std::string>() : "refused by the image helper"));
    return std::move(received.message);
}

} // namespace reliefbake
