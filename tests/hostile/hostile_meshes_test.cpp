// Each hostile mesh is read or refused with one clear line, within 2 s, and the caller lives on.

#include "formats/mesh_file.h"
#include "mesh/quadric_bake.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>

#include <unistd.h>

using namespace reliefbake;
namespace fs = std::filesystem;

namespace {

fs::path shared_data() {
    const char* given = std::getenv("RELIEFBAKE_DATA");
    return given ? given : RELIEFBAKE_SHARED_DATA;
}

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string bytes_of(const fs::path& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

void check_refusal(const Error& error, const fs::path& path) {
    CHECK(error.code == ErrorCode::bad_data);
    CHECK(error.message.starts_with(path.string() + ": "));
    CHECK(error.message.find('\n') == std::string::npos);
    CHECK(error.message.size() < path.string().size() + 400);
}

/// Reads and bakes; every quadric is finite. True when there was a result.
bool survives(const fs::path& path) {
    const Result<MeshFile> file = read_mesh(path);
    if (!file) {
        check_refusal(file.error(), path);
        return false;
    }
    for (const Mesh& mesh : file->meshes) {
        const Result<QuadricBake> made = bake_quadrics(mesh, {}, path.string());
        REQUIRE(made);
        for (const Quadric& q : made->mesh.quadrics) REQUIRE((std::isfinite(q.a) && std::isfinite(q.b) && std::isfinite(q.c)));
    }
    return true;
}

/// One small valid file of each format.
std::vector<fs::path> seeds(const fs::path& folder) {
    std::vector<fs::path> paths;
    const auto put = [&](const char* name, const std::string& bytes) {
        paths.push_back(folder / name);
        std::ofstream(paths.back(), std::ios::binary) << bytes;
    };
    put("s.obj", "v 0 0 0\nv 1 0 0.1\nv 0 1 0.1\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 2//1 -1//1 3//1\n");
    put("s.off", "OFF\n4 2 0\n0 0 0\n1 0 0.1\n0 1 0.1\n1 1 0\n3 0 1 2\n3 1 3 2\n");
    put("s.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n");
    put("t.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    const Result<MeshFile> file = read_mesh(paths[0]);
    REQUIRE(file);
    const Result<QuadricBake> made = bake_quadrics(file->meshes[0], {}, "s");
    for (const char* name : {"s.ply", "s.glb", "s.gltf"}) {
        paths.push_back(folder / name);
        REQUIRE(write_mesh(paths.back(), *file, {made->mesh}, {made->source}, {}, {{"kind", "quadric"}}));
    }
    return paths;
}

struct Folder {
    Folder() : path(fs::temp_directory_path() / ("reliefbake-hostile-mesh-" + std::to_string(::getpid()))) { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    fs::path path;
};

} // namespace

TEST_CASE("every truncation of a valid mesh") {
    const Folder folder;
    for (const fs::path& seed : seeds(folder.path)) {
        const std::string whole = bytes_of(seed);
        REQUIRE(survives(seed));
        const fs::path cut = folder.path / std::string("cut").append(seed.extension().string());
        for (std::size_t length = 0; length < whole.size(); ++length) {
            CAPTURE(seed.filename(), length);
            std::ofstream(cut, std::ios::binary).write(whole.data(), std::streamsize(length));
            survives(cut);
        }
    }
}

TEST_CASE("random damage to a valid mesh") {
    const Folder folder;
    std::mt19937 random(17);
    for (const fs::path& seed : seeds(folder.path)) {
        const std::string whole = bytes_of(seed);
        const fs::path bad = folder.path / std::string("bad").append(seed.extension().string());
        for (int trial = 0; trial < 1500; ++trial) {
            std::string bytes = whole;
            for (int k = random() % 4; k >= 0; --k) {
                const std::size_t place = random() % bytes.size();
                switch (random() % 4) {
                case 0: bytes[place] = char(random()); break;
                case 1: bytes[place] = "0123456789-[]{}e,."[random() % 18]; break;
                case 2: bytes.erase(place, 1 + random() % 8); break;
                default: bytes.insert(place, bytes.substr(random() % bytes.size(), random() % 12)); break;
                }
                if (bytes.empty()) bytes.assign(1, ' ');
            }
            CAPTURE(seed.filename(), trial);
            std::ofstream(bad, std::ios::binary) << bytes;
            survives(bad);
        }
    }
}

TEST_CASE("JSON bombs in glTF are refused before they are parsed") {
    const Folder folder;
    const auto refuse = [&](const std::string& text, const char* why) {
        const fs::path path = folder.path / "bomb.gltf";
        std::ofstream(path, std::ios::binary) << text;
        const auto start = std::chrono::steady_clock::now();
        const Result<MeshFile> file = read_mesh(path);
        CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
        REQUIRE_FALSE(file);
        check_refusal(file.error(), path);
        CHECK(file.error().message.find(why) != std::string::npos);
    };
    refuse("{\"asset\":" + std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}", "nested");
    std::string wide = "{\"extras\":[0";
    for (int k = 0; k < 17'000'000; ++k) wide += ",0";
    refuse(wide + "]}", "values");
    refuse(R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"componentType":5126,"count":4000000000,"type":"VEC3"}]})",
           "accessor 0");
}

TEST_CASE("hostile meshes of the shared set, and the nasty ones") {
    if (!fs::exists(shared_data() / "hostile_meshes")) {
        std::cout << "SKIPPED: no " << shared_data() << "; RELIEFBAKE_DATA names the large test set\n";
        return;
    }
    std::vector<fs::path> files = files_in(shared_data() / "hostile_meshes");
    for (const fs::path& path : files_in(shared_data() / "meshes")) files.push_back(path);
    REQUIRE(files.size() > 30);
    for (const fs::path& path : files) {
        CAPTURE(path.filename());
        const auto start = std::chrono::steady_clock::now();
        const bool result = survives(path);
        CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(2));
        if (path.parent_path().filename() == "meshes") CHECK(result);
    }
}
