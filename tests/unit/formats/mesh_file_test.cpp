// Meshes in and out of files.

#include "formats/mesh_file.h"
#include "mesh/quadric_bake.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

#include <unistd.h>

using namespace reliefbake;
namespace fs = std::filesystem;

namespace {

struct Folder {
    Folder() : path(fs::temp_directory_path() / ("reliefbake-mesh-" + std::to_string(::getpid()))) { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    fs::path path;
};

const fs::path& folder() {
    static const Folder made;
    return made.path;
}

fs::path put(const std::string& name, const std::string& bytes) {
    const fs::path path = folder() / name;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

std::string bytes_of(const fs::path& path) {
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    return bytes.str();
}

Mesh read_one(const fs::path& path) {
    const Result<MeshFile> file = read_mesh(path);
    INFO((file ? std::string() : file.error().message));
    REQUIRE(file);
    REQUIRE(file->meshes.size() == 1);
    return file->meshes[0];
}

std::string refusal(const fs::path& path) {
    const Result<MeshFile> file = read_mesh(path);
    REQUIRE_FALSE(file);
    CHECK(file.error().code == ErrorCode::bad_data);
    CHECK(file.error().message.starts_with(path.string() + ": "));
    CHECK(file.error().message.find('\n') == std::string::npos);
    return file.error().message;
}

/// Two triangles with a mirrored texture: the vertices at the fold need two tangents.
const char* mirrored_obj = "v -1 0 0\nv 0 0 0.5\nv 0 1 0.5\nv 1 0 0\nvt 1 0\nvt 0 0\nvt 0 1\nvt 1 0\nvn 0 0 1\n"
                           "f 1/1/1 2/2/1 3/3/1\nf 2/2/1 4/4/1 3/3/1\n";

QuadricBake bake(const Mesh& mesh) {
    const Result<QuadricBake> made = bake_quadrics(mesh, {}, "mesh");
    REQUIRE(made);
    return *made;
}

void write(const fs::path& path, const MeshFile& file, const QuadricBake& made, QuadricStore store = {}) {
    const Result<void> written = write_mesh(path, file, {made.mesh}, {made.source}, store, {{"kind", "quadric"}});
    INFO((written ? std::string() : written.error().message));
    REQUIRE(written);
}

nlohmann::json document_of(const fs::path& path) {
    const std::string bytes = bytes_of(path);
    if (!bytes.starts_with("glTF")) return nlohmann::json::parse(bytes);
    std::uint32_t length;
    std::memcpy(&length, bytes.data() + 12, 4);
    return nlohmann::json::parse(bytes.substr(20, length));
}

/// A glTF file of one triangle strip with an external buffer, a line, a material, an animation's worth of other members.
std::string strip_gltf(const std::string& uri) {
    return R"({"asset":{"version":"2.0","generator":"hand"},"extensionsUsed":["X_unknown"],"extensions":{"X_unknown":{"k":[1,2.5,"\u00e9"]}},
"materials":[{"name":"red","extras":{"keep":1}}],"images":[{"uri":"red.png"}],"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[2,2,2]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0,"_CUSTOM":2},"indices":1,"mode":5,"material":0,"targets":[{"POSITION":0}]},
{"attributes":{"POSITION":0},"mode":1}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,0.25]},
{"bufferView":1,"componentType":5121,"count":4,"type":"SCALAR"},{"bufferView":2,"componentType":5121,"count":4,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":4},{"buffer":0,"byteOffset":52,"byteLength":16,"byteStride":4}],
"buffers":[{"uri":")" + uri + R"(","byteLength":68}]})";
}

std::string strip_buffer() {
    const float p[] = {0, 0, 0, 1, 0, 0, 0, 1, 0.25f, 1, 1, 0.25f};
    std::string bytes(reinterpret_cast<const char*>(p), sizeof p);
    return bytes + std::string("\0\1\2\3", 4) + std::string("\7\0\0\0\10\0\0\0\11\0\0\0\12\0\0\0", 16);
}

} // namespace

TEST_CASE("OBJ: polygons, relative indices, vertices without attributes, long lines") {
    const Mesh quad = read_one(put("quad.obj", "# c\nv 0 0 0\nv 2 0 0 0.5 0.5 0.5\r\nv 2 1 0\nv 0 1 0\nvt 0.25\nf -4 -3 \\\n -2/1 -1\n"));
    REQUIRE(quad.positions.size() == 4);
    REQUIRE(quad.triangles.size() == 2);
    REQUIRE(quad.uvs[2] == Imath::V2f(0.25f, 0));
    REQUIRE(quad.normals.empty());
    const Mesh seam = read_one(put("seam.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 2/1 4/2 3/2\n"));
    REQUIRE(seam.positions.size() == 5); // 3/1 and 3/2
    REQUIRE(read_one(put("far.obj", "v 1e400 0 0\nv -1e400 0 0\nv 1e-400 0 nan\nf 1 2 3\n")).positions[1].x < -1e300);
}

TEST_CASE("OBJ: what is wrong is named with its line") {
    REQUIRE(refusal(put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")).find("line 4: the face names position '4' of 3") != std::string::npos);
    REQUIRE(refusal(put("b.obj", "v 0 0 0\nf 0 0 0\n")).find("line 2") != std::string::npos);
    REQUIRE(refusal(put("c.obj", "v 0 zero 0\n")).find("expected 3 numbers, found 'zero'") != std::string::npos);
    REQUIRE(refusal(put("d.obj", "v 0 0 0\n")).find("no faces") != std::string::npos);
    REQUIRE(refusal(put("e.xyz", "1 2 3\n")).find("none of obj") != std::string::npos);
    REQUIRE(read_mesh(folder() / "absent.obj").error().code == ErrorCode::no_input);
    REQUIRE(read_mesh(folder()).error().code == ErrorCode::no_input);
}

TEST_CASE("PLY: both byte orders and text agree, unknown properties and elements are skipped") {
    const std::string head = "element vertex 3\nproperty double x\nproperty short y\nproperty float z\nproperty list uchar int odd\n"
                             "element thing 1\nproperty list uchar uchar l\nelement face 1\nproperty uchar flag\nproperty list uchar uint vertex_indices\nend_header\n";
    const auto number = [](auto value, bool big) {
        std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
        if (big) std::reverse(bytes.begin(), bytes.end());
        return bytes;
    };
    std::vector<Mesh> meshes;
    for (const bool big : {false, true}) {
        std::string data;
        const double x[] = {0.1, 1, 0};
        const std::int16_t y[] = {-3, 0, 4};
        for (int v = 0; v < 3; ++v) data += number(x[v], big) + number(y[v], big) + number(float(v) / 4, big) + number(std::uint8_t(1), big) + number(9, big);
        data += number(std::uint8_t(2), big) + "ab" + number(std::uint8_t(7), big) + number(std::uint8_t(3), big);
        for (const unsigned k : {2u, 0u, 1u}) data += number(k, big);
        meshes.push_back(read_one(put("m.ply", std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + head + data)));
    }
    meshes.push_back(read_one(put("m.ply", "ply\nformat ascii 1.0\ncomment c\n" + head + "0.1 -3 0 1 9\n1 0 .25 1 9\n0 4 0.5 1 9\n2 97 98\n7 3 2 0 1\n")));
    for (const Mesh& mesh : meshes) {
        REQUIRE(mesh.positions == std::vector<Imath::V3d>{{0.1, -3, 0}, {1, 0, 0.25}, {0, 4, 0.5}});
        REQUIRE(mesh.triangles == std::vector<Triangle>{{2, 0, 1}});
    }
    REQUIRE(refusal(put("n.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n1 2 three\n")).find("element vertex") != std::string::npos);
}

TEST_CASE("OFF and STL, text and binary") {
    const Mesh off = read_one(put("m.off", "NOFF # with normals\n3 1 0\n\n0 0 0 0 0 1\n1 0 0 0 0 1\n# c\n0 1 0 0 0 1\n3 0 1 2 255 0 0\n"));
    REQUIRE(off.triangles.size() == 1);
    REQUIRE(off.normals[0] == Imath::V3f(0, 0, 1));
    const std::string facets = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
                               "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";
    const Mesh text = read_one(put("t.stl", "solid s\n" + facets + "endsolid\n"));
    REQUIRE(text.positions.size() == 4);
    REQUIRE(text.triangles.size() == 2);
    std::string binary = "solid looks like text" + std::string(59, ' ') + std::string("\1\0\0\0", 4);
    const float f[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    binary += std::string(reinterpret_cast<const char*>(f), sizeof f) + std::string(2, '\0');
    REQUIRE(read_one(put("b.stl", binary)).positions.size() == 3);
    REQUIRE(refusal(put("c.stl", binary.substr(0, 100))).find("truncated") != std::string::npos);
}

TEST_CASE("PLY and glTF give back what was written, split vertices included") {
    const Result<MeshFile> file = read_mesh(put("mirrored.obj", mirrored_obj));
    REQUIRE(file);
    const QuadricBake made = bake(file->meshes[0]);
    REQUIRE(made.counts.split_vertices == 2);
    for (const char* name : {"out.ply", "out.glb", "out.gltf"}) {
        write(folder() / name, *file, made);
        const Mesh back = read_one(folder() / name);
        CAPTURE(name);
        REQUIRE(back.positions == made.mesh.positions); // these are floats
        REQUIRE(back.triangles == made.mesh.triangles);
        REQUIRE(back.tangents == made.mesh.tangents);
        REQUIRE(back.normals == made.mesh.normals);
        REQUIRE(back.quadrics.size() == made.mesh.quadrics.size());
        for (std::size_t v = 0; v < back.quadrics.size(); ++v) {
            REQUIRE(std::memcmp(&back.quadrics[v], &made.mesh.quadrics[v], sizeof(Quadric)) == 0);
            const float up = back.v_down ? 1 - back.uvs[v].y : back.uvs[v].y;
            REQUIRE(up == made.mesh.uvs[v].y);
        }
    }
    REQUIRE(bytes_of(folder() / "out.ply").find("comment reliefbake {\"kind\":\"quadric\"}\n") != std::string::npos);
}

TEST_CASE("a tangent frame means the same in files with either origin of the texture") {
    const Result<MeshFile> file = read_mesh(put("mirrored.obj", mirrored_obj));
    const QuadricBake made = bake(file->meshes[0]);
    write(folder() / "frames.glb", *file, made);
    Mesh down = read_one(folder() / "frames.glb");
    down.tangents.clear(); // computed anew from texture coordinates that now run down
    const QuadricBake again = bake(down);
    REQUIRE(again.counts.split_vertices == 0);
    for (std::size_t v = 0; v < again.mesh.tangents.size(); ++v)
        for (int k = 0; k < 4; ++k) REQUIRE(again.mesh.tangents[v][k] == Approx(made.mesh.tangents[v][k]).margin(1e-6));
}

TEST_CASE("glTF keeps everything else") {
    put("strip.bin", strip_buffer());
    const Result<MeshFile> file = read_mesh(put("strip.gltf", strip_gltf("strip.bin")));
    INFO((file ? std::string() : file.error().message));
    REQUIRE(file);
    REQUIRE(file->notes.size() == 1); // the line
    const Mesh& mesh = file->meshes[0];
    REQUIRE(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
    const QuadricBake made = bake(mesh);
    for (const char* name : {"kept.gltf", "kept.glb"}) {
        write(folder() / name, *file, made);
        nlohmann::json before = nlohmann::json::parse(strip_gltf("strip.bin")), after = document_of(folder() / name);
        CAPTURE(name);
        for (const char* key : {"asset", "extensions", "extensionsUsed", "materials", "images", "scenes", "nodes"}) REQUIRE(after[key] == before[key]);
        REQUIRE(after["meshes"][0]["primitives"][1] == before["meshes"][0]["primitives"][1]);
        nlohmann::json& primitive = after["meshes"][0]["primitives"][0];
        const nlohmann::json extras = after["accessors"][primitive["attributes"]["_QUADRIC"].get<std::size_t>()]["extras"];
        REQUIRE(extras["reliefbake"]["kind"] == "quadric");
        for (const char* ours : {"_QUADRIC", "NORMAL", "TANGENT"}) REQUIRE(primitive["attributes"].erase(ours) == 1);
        REQUIRE(primitive == before["meshes"][0]["primitives"][0]);
        for (std::size_t k = 0; k < before["accessors"].size(); ++k) REQUIRE(after["accessors"][k] == before["accessors"][k]);
        REQUIRE(read_one(folder() / name).quadrics.size() == 4);
    }
    REQUIRE(document_of(folder() / "kept.gltf")["buffers"][0]["uri"] == "strip.bin");

    // With split vertices every array of the primitive is copied, morph targets and strange ones too.
    QuadricBake split = made;
    for (auto* values : {&split.mesh.positions}) values->push_back((*values)[1]);
    split.mesh.normals.push_back(split.mesh.normals[1]), split.mesh.tangents.push_back({0, 1, 0, -1}), split.mesh.quadrics.push_back({1, 2, 3});
    split.source.push_back(1), split.mesh.triangles[1] = {4, 3, 2};
    write(folder() / "split.glb", *file, split);
    const Mesh back = read_one(folder() / "split.glb");
    REQUIRE(back.triangles == split.mesh.triangles);
    REQUIRE(back.positions[4] == mesh.positions[1]);
    REQUIRE(back.quadrics[4].c == 3);
    const nlohmann::json document = document_of(folder() / "split.glb"), primitive = document["meshes"][0]["primitives"][0];
    REQUIRE_FALSE(primitive.contains("mode"));
    const nlohmann::json custom = document["accessors"][primitive["attributes"]["_CUSTOM"].get<std::size_t>()];
    REQUIRE(custom["count"] == 5);
    REQUIRE(document["accessors"][primitive["targets"][0]["POSITION"].get<std::size_t>()]["count"] == 5);
    REQUIRE(document["bufferViews"][custom["bufferView"].get<std::size_t>()]["byteStride"] == 4);
}

TEST_CASE("glTF buffers are read only from the asset's folder") {
    fs::create_directories(folder() / "inner");
    put("secret.bin", strip_buffer());
    REQUIRE(refusal(put("inner/up.gltf", strip_gltf("../secret.bin"))).find("secret.bin") != std::string::npos);
    refusal(put("inner/absolute.gltf", strip_gltf((folder() / "secret.bin").string())));
    fs::create_symlink(folder() / "secret.bin", folder() / "inner/link.bin");
    refusal(put("inner/link.gltf", strip_gltf("link.bin")));
    put("inner/near.bin", strip_buffer());
    REQUIRE(read_mesh(put("inner/near.gltf", strip_gltf("near.bin"))));
    REQUIRE(read_mesh(put("inner/here.gltf", strip_gltf("./near.bin"))));
}

TEST_CASE("glTF: sparse accessors are applied, and checked") {
    put("sparse.bin", strip_buffer() + std::string("\1\0\0\0", 4) + strip_buffer().substr(36, 12));
    std::string text = strip_gltf("sparse.bin");
    const auto replace = [&](const std::string& from, const std::string& to) { text.replace(text.find(from), from.size(), to); };
    replace("\"byteLength\":68}]}", "\"byteLength\":84}]}");
    replace("],\n\"buffers\"", ",{\"buffer\":0,\"byteOffset\":68,\"byteLength\":16}],\n\"buffers\"");
    replace("\"max\":[1,1,0.25]", "\"max\":[1,1,0.25],\"sparse\":{\"count\":1,\"indices\":{\"bufferView\":3,\"componentType\":5121},"
                                  "\"values\":{\"bufferView\":3,\"byteOffset\":4}}");
    REQUIRE(read_one(put("sparse.gltf", text)).positions[1] == Imath::V3d(1, 1, 0.25));
    replace("\"byteOffset\":4}}", "\"byteOffset\":5}}");
    REQUIRE(refusal(put("sparse.gltf", text)).find("sparse") != std::string::npos);
}

TEST_CASE("quadrics as texture coordinates and colours") {
    const Result<MeshFile> file = read_mesh(put("mirrored.obj", mirrored_obj));
    QuadricBake made = bake(file->meshes[0]);
    made.mesh.quadrics[0] = {-2, 1, 0.5f};
    QuadricStore store;
    store.where = QuadricStore::Where::uv, store.uv_set = 1;
    write(folder() / "uv.glb", *file, made, store);
    const nlohmann::json attributes = document_of(folder() / "uv.glb")["meshes"][0]["primitives"][0]["attributes"];
    REQUIRE(attributes.contains("TEXCOORD_1"));
    REQUIRE(attributes.contains("TEXCOORD_2"));
    store.uv_set = 0;
    REQUIRE(write_mesh(folder() / "uv0.glb", *file, {made.mesh}, {made.source}, store, {}).error().code == ErrorCode::usage);
    store.uv_set = 3;
    REQUIRE(write_mesh(folder() / "uv3.glb", *file, {made.mesh}, {made.source}, store, {}).error().message.find("use uv:1") != std::string::npos);
    REQUIRE_FALSE(fs::exists(folder() / "uv0.glb"));

    store.where = QuadricStore::Where::color;
    write(folder() / "color.ply", *file, made, store);
    const std::string bytes = bytes_of(folder() / "color.ply");
    REQUIRE(bytes.find("property uchar red") != std::string::npos);
    REQUIRE(bytes.find("\"range\":2.0") != std::string::npos);
    write(folder() / "color.glb", *file, made, store);
    const nlohmann::json document = document_of(folder() / "color.glb");
    REQUIRE(document["accessors"][document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].get<std::size_t>()]["normalized"] == true);
}

TEST_CASE("glTF refuses numbers that it cannot hold, PLY keeps them") {
    const Result<MeshFile> file = read_mesh(put("far.obj", "v 1e39 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 4 3\n"));
    REQUIRE(file);
    const QuadricBake made = bake(file->meshes[0]);
    const Result<void> written = write_mesh(folder() / "far.glb", *file, {made.mesh}, {made.source}, {}, {});
    REQUIRE(written.error().code == ErrorCode::bad_data);
    REQUIRE(written.error().message.find("write .ply") != std::string::npos);
    write(folder() / "far.ply", *file, made);
    REQUIRE(read_one(folder() / "far.ply").positions[0].x == 1e39);
}

TEST_CASE("files that cannot carry quadrics are refused with the way out") {
    for (const char* name : {"m.obj", "m.OBJ", "m.stl", "m.off"}) {
        const Result<void> checked = check_mesh_output(name, {});
        REQUIRE(checked.error().code == ErrorCode::usage);
        REQUIRE(checked.error().message.find("write .glb, .gltf or .ply") != std::string::npos);
    }
    REQUIRE_FALSE(check_mesh_output("m", {}));
    REQUIRE(check_mesh_output("m.GLB", {}));
}
