#include "cli/bench/python_peers.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

// Arguments: picture, distances, width, height, threads, repeat. Prints one JSON array.
constexpr const char* script = R"(
import json, sys, time
picture_file, distance_file = sys.argv[1:3]
width, height, threads, repeat = map(int, sys.argv[3:])
results = []
try:
    import numpy
except ImportError:
    print('[]'); sys.exit()
picture = numpy.fromfile(picture_file, dtype=numpy.uint8).reshape(height, width)
ours = numpy.fromfile(distance_file, dtype=numpy.float32).reshape(height, width)
def measure(name, version, transform):
    best, out = float('inf'), None
    for _ in range(repeat):
        start = time.perf_counter(); out = transform(out); best = min(best, time.perf_counter() - start)
    error, wrong = 0.0, 0
    for first in range(0, height, 256):
        theirs, mine = out[first:first + 256], ours[first:first + 256]
        difference = numpy.abs(theirs - mine)
        error = max(error, float(difference.max())); wrong += int((difference > 1e-6 * (1 + mine)).sum())
    results.append(dict(name=name, version=version, ns_per_pixel=best * 1e9 / picture.size, error_max=error, wrong=wrong / picture.size))
try:
    import cv2
    cv2.setNumThreads(threads)
    measure('OpenCV, DIST_MASK_PRECISE', cv2.__version__,
            lambda out: cv2.distanceTransform(picture, cv2.DIST_L2, cv2.DIST_MASK_PRECISE, dst=out))
except ImportError:
    pass
try:
    import scipy, scipy.ndimage
    repeat = 1
    measure('SciPy, distance_transform_edt', scipy.__version__, lambda out: scipy.ndimage.distance_transform_edt(picture))
except ImportError:
    pass
print(json.dumps(results))
)";

/// A folder that goes away with its files.
class WorkFolder {
  public:
    WorkFolder() {
        std::error_code ignored;
        std::string name = (fs::temp_directory_path(ignored) / "reliefbake-bench-XXXXXX").string();
        if (::mkdtemp(name.data())) path_ = name;
    }
    ~WorkFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    WorkFolder(const WorkFolder&) = delete;
    WorkFolder& operator=(const WorkFolder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

template <class T>
bool write_plane(const fs::path& path, const Image<T>& plane) {
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(plane.data()), std::streamsize(plane.size() * sizeof(T)));
    return bool(file.flush());
}

std::string output_of(const std::string& command) {
    std::string text;
    std::FILE* pipe = ::popen(command.c_str(), "r");
    if (!pipe) return text;
    char block[4096];
    for (std::size_t got; (got = std::fread(block, 1, sizeof block, pipe)) > 0;) text.append(block, got);
    ::pclose(pipe);
    return text;
}

} // namespace

Result<nlohmann::json> time_python_peers(const Image<std::uint8_t>& picture, const Image<float>& ours, const PeerRun& run) {
    const WorkFolder folder;
    const fs::path program = folder.path() / "peers.py", in = folder.path() / "picture", distances = folder.path() / "distances";
    std::ofstream(program) << script;
    if (folder.path().empty() || !write_plane(in, picture) || !write_plane(distances, ours))
        return fail(ErrorCode::write_failed, "--peers: cannot write temporary files in " + fs::temp_directory_path().string());
    std::string arguments;
    for (const std::string& argument : {program.string(), in.string(), distances.string()}) arguments += " '" + argument + "'";
    for (const int number : {picture.width(), picture.height(), run.threads, run.repeat}) arguments += " " + std::to_string(number);
    // The first python3 of PATH need not be the system's, which has the distribution's packages.
    for (const char* python : {"python3", "/usr/bin/python3"}) {
        const nlohmann::json results = nlohmann::json::parse(output_of(python + arguments + " 2>/dev/null"), nullptr, false);
        if (results.is_array() && !results.empty()) return results;
    }
    return nlohmann::json::array();
}

} // namespace reliefbake
