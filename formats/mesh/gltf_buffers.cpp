#include "formats/mesh/gltf_container.h"
#include "formats/mesh_file.h"
#include "formats/whole_file.h"

#include <cctype>
#include <cstdlib>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_document = 1u << 30;

/// RFC 3986, 2.1: %20 is a blank.
std::string percent_decoded(const std::string& uri) {
    std::string text;
    for (std::size_t k = 0; k < uri.size(); ++k) {
        const bool escape = uri[k] == '%' && k + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[k + 1])) && std::isxdigit(static_cast<unsigned char>(uri[k + 2]));
        text += escape ? char(std::strtol(uri.substr(k + 1, 2).c_str(), nullptr, 16)) : uri[k];
        if (escape) k += 2;
    }
    return text;
}

} // namespace

std::vector<fs::path> mesh_buffer_files(const fs::path& path) {
    std::vector<fs::path> files;
    const std::string extension = path.extension().string();
    if (extension.size() < 4 || std::tolower(static_cast<unsigned char>(extension[2])) != 'l' || std::tolower(static_cast<unsigned char>(extension[1])) != 'g') return files;
    const Result<std::string> bytes = read_whole_file(path, largest_document);
    if (!bytes) return files;
    const Result<GltfChunks> chunks = split_gltf(*bytes, path.string());
    if (!chunks || !check_json_size(chunks->json, largest_document, path.string())) return files;
    const nlohmann::json document = nlohmann::json::parse(chunks->json, nullptr, false);
    if (!document.is_object() || !document.contains("buffers") || !document["buffers"].is_array()) return files;
    for (const nlohmann::json& buffer : document["buffers"]) {
        if (!buffer.is_object() || !buffer.contains("uri") || !buffer["uri"].is_string()) continue;
        const std::string uri = buffer["uri"].get<std::string>();
        if (!uri.starts_with("data:")) files.push_back(path.parent_path() / percent_decoded(uri));
    }
    return files;
}

} // namespace reliefbake
