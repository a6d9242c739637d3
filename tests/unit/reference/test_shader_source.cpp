#include "shaders-reference/renderer/shader_source.h"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include <unistd.h>

using namespace reliefbake;

namespace {

constexpr Prelude preludes[] = {Prelude::core330, Prelude::core450, Prelude::es300};

std::vector<ShaderConfig> configurations() {
    std::vector<ShaderConfig> all;
    for (const Technique technique :
         {Technique::cone, Technique::cone_published, Technique::linear, Technique::binary, Technique::given})
        for (const bool exact : {false, true}) {
            if (exact && technique != Technique::cone) continue;
            ShaderConfig config;
            config.technique = technique;
            config.exact_finish = exact;
            all.push_back(config);
        }
    for (const ConeEncoding encoding : {ConeEncoding::ratio, ConeEncoding::radius, ConeEncoding::normal}) {
        ShaderConfig config;
        config.encoding = encoding;
        all.push_back(config);
    }
    ShaderConfig other;
    other.metric = Metric::l1;
    other.normal_unorm = false;
    other.normal_y = NormalY::dx;
    all.push_back(other);
    return all;
}

} // namespace

TEST_CASE("every shader is valid under all three preludes", "[shaders]") {
    const auto folder = std::filesystem::temp_directory_path() / std::string("reliefbake_shaders.").append(std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::string files;
    int number = 0;
    const auto add = [&](const std::string& source, const char* extension) {
        const auto path = folder / (std::to_string(number++) + extension);
        std::ofstream(path) << source;
        files.append(" ").append(path.string());
    };
    for (const Prelude prelude : preludes) {
        add(vertex_source(prelude), ".vert");
        for (const ShaderConfig& config : configurations()) add(fragment_source(config, prelude), ".frag");
    }
    const auto log = folder / "log.txt";
    const int status = std::system((std::string(GLSLANG_VALIDATOR) + files + " > " + log.string()).c_str());
    std::ifstream messages(log);
    INFO(std::string(std::istreambuf_iterator<char>(messages), {}));
    CHECK(status == 0);
    std::filesystem::remove_all(folder);
}

TEST_CASE("shaders keep to what all three languages have", "[shaders]") {
    for (const ShaderText& shader : shader_texts()) {
        INFO(shader.name);
        CHECK(shader.text.find("textureGather") == std::string_view::npos);
        CHECK(shader.text.find("texture(") == std::string_view::npos);
        CHECK_FALSE(shader.text.empty());
    }
}
