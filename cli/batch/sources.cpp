#include "cli/batch/sources.h"

#include "cli/batch/glob.h"
#include "formats/whole_file.h"

#include <algorithm>
#include <set>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t largest_list = 64u << 20;

class Search {
  public:
    explicit Search(const fs::path& out) : out_(canonical(out)) {}

    Result<void> add(const std::string& given) {
        std::error_code ignored;
        if (given.starts_with('@')) return add_list(given.substr(1));
        if (fs::is_directory(given, ignored)) return add_folder(given, "");
        if (fs::is_regular_file(given, ignored)) return add_file(fs::path(given).filename().string(), given);
        if (is_glob(given)) return add_glob(given);
        return fail(ErrorCode::no_input, given + ": no such file or folder");
    }

    std::vector<SourceFile> take() {
        std::sort(found_.begin(), found_.end(), [](const SourceFile& a, const SourceFile& b) {
            return std::tie(a.relative, a.path.native()) < std::tie(b.relative, b.path.native());
        });
        return std::move(found_);
    }

  private:
    static fs::path canonical(const fs::path& path) {
        std::error_code ignored;
        fs::path name = fs::weakly_canonical(fs::absolute(path), ignored);
        if (!name.has_filename()) name = name.parent_path(); // "out/"
        return name;
    }

    Result<void> add_file(const std::string& relative, const fs::path& path) {
        if (seen_.insert(fs::absolute(path).lexically_normal().native()).second) found_.push_back({relative, path});
        return {};
    }

    /// All files below `folder`, or those whose path from it matches `glob`.
    Result<void> add_folder(const fs::path& folder, const std::string& glob) {
        if (canonical(folder) == out_) return fail(ErrorCode::usage, "--out " + out_.string() + ": is the folder of the sources; choose another one, or one inside it");
        const auto unreadable = [&](const std::error_code& error) { return fail(ErrorCode::no_input, folder.string() + ": cannot list the folder: " + error.message()); };
        std::error_code error;
        fs::recursive_directory_iterator entry(folder, error), end;
        if (error) return unreadable(error);
        for (; entry != end; entry.increment(error)) {
            if (error) return unreadable(error);
            const bool hidden = entry->path().filename().native()[0] == '.';
            std::error_code gone; // a file that went away meanwhile is none
            if (entry->is_directory(gone)) {
                if (hidden || canonical(entry->path()) == out_) entry.disable_recursion_pending();
            } else if (!hidden && entry->is_regular_file(gone)) {
                const std::string relative = entry->path().lexically_relative(folder).generic_string();
                if (!glob.empty() && !glob_matches(glob, relative)) continue;
                if (Result<void> added = add_file(relative, entry->path()); !added) return added;
            }
        }
        if (error) return unreadable(error);
        return {};
    }

    Result<void> add_glob(const std::string& given) {
        const std::size_t slash = given.rfind('/', given.find_first_of("*?["));
        const fs::path folder = slash == given.npos ? "." : slash == 0 ? "/" : given.substr(0, slash);
        // Without a folder in it, a pattern is for this folder alone, as a shell's is.
        const std::string glob = slash == given.npos ? given : given.substr(slash + 1);
        std::error_code ignored;
        if (!fs::is_directory(folder, ignored)) return fail(ErrorCode::no_input, given + ": there is no folder " + folder.string());
        const std::size_t before = found_.size();
        Result<void> added = glob.find('/') == glob.npos ? add_names(folder, glob) : add_folder(folder, glob);
        if (added && found_.size() == before) return fail(ErrorCode::no_input, given + ": matches no file");
        return added;
    }

    Result<void> add_names(const fs::path& folder, const std::string& glob) {
        std::error_code error;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
            const std::string name = entry->path().filename().string();
            std::error_code gone;
            if (name[0] != '.' && entry->is_regular_file(gone) && glob_matches(glob, name))
                if (Result<void> added = add_file(name, entry->path()); !added) return added;
        }
        if (error) return fail(ErrorCode::no_input, folder.string() + ": cannot list the folder: " + error.message());
        return {};
    }

    Result<void> add_list(const std::string& name) {
        const Result<std::string> text = read_whole_file(name, largest_list);
        if (!text) return tl::unexpected(text.error());
        std::size_t number = 0;
        for (std::size_t begin = 0; begin < text->size();) {
            const std::size_t end = std::min(text->find('\n', begin), text->size());
            std::string line = text->substr(begin, end - begin);
            begin = end + 1, ++number;
            if (line.ends_with('\r')) line.pop_back();
            if (line.empty() || line[0] == '#') continue;
            std::error_code ignored;
            if (!fs::is_regular_file(line, ignored)) return fail(ErrorCode::no_input, name + ":" + std::to_string(number) + ": no such file: " + line);
            const fs::path normal = fs::path(line).lexically_normal();
            const bool inside = normal.is_relative() && *normal.begin() != "..";
            if (Result<void> added = add_file(inside ? normal.generic_string() : normal.filename().string(), line); !added) return added;
        }
        return {};
    }

    fs::path out_;
    std::set<std::string> seen_;
    std::vector<SourceFile> found_;
};

} // namespace

Result<std::vector<SourceFile>> find_sources(const std::vector<std::string>& given, const fs::path& out) {
    Search search(out);
    for (const std::string& one : given)
        if (Result<void> added = search.add(one); !added) return tl::unexpected(added.error());
    return search.take();
}

} // namespace reliefbake
