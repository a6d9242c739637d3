#pragma once
// Shader texts through glslangValidator. The test names the program as GLSLANG_VALIDATOR.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

namespace reliefbake::test {

class GlslangCheck {
  public:
    GlslangCheck() : folder_(std::filesystem::temp_directory_path() / ("reliefbake_shaders." + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    ~GlslangCheck() { std::filesystem::remove_all(folder_); }

    /// `extension`: .vert or .frag
    void add(const std::string& source, const char* extension) {
        const std::filesystem::path path = folder_ / (std::to_string(count_++) + extension);
        std::ofstream(path) << source;
        files_.append(" ").append(path.string());
    }

    /// Empty where all are valid; else what the validator says.
    std::string faults() const {
        const std::filesystem::path log = folder_ / "log.txt";
        if (std::system((std::string(GLSLANG_VALIDATOR) + files_ + " > " + log.string()).c_str()) == 0) return "";
        std::ifstream messages(log);
        return "refused: " + std::string(std::istreambuf_iterator<char>(messages), {});
    }

  private:
    std::filesystem::path folder_;
    std::string files_;
    int count_ = 0;
};

} // namespace reliefbake::test
