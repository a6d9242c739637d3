#include "tests/cli/run_tool.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <sys/wait.h>

namespace reliefbake::test {

namespace fs = std::filesystem;

namespace {

struct Folder {
    Folder() {
        std::string name = (fs::temp_directory_path() / "reliefbake-cli-XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { fs::remove_all(path); }
    fs::path path;
};

} // namespace

const fs::path& work_folder() {
    static const Folder folder;
    return folder.path;
}

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

std::string height_map(const std::string& name) {
    const fs::path path = fs::path(RELIEFBAKE_TEST_DATA) / "heights" / name;
    return std::string("'").append(path.string()).append("'");
}

Outcome run_tool(const std::string& arguments, const std::string& environment) {
    const std::string command = "cd '" + work_folder().string() + "' && " + environment + " '" +
                                RELIEFBAKE_BINARY + "' " + arguments + " >stdout 2>stderr </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, bytes_of(work_folder() / "stdout"),
            bytes_of(work_folder() / "stderr")};
}

} // namespace reliefbake::test
