#pragma once
// Which files of a folder are baked, into what, and how the results are called.

#include "bake/error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reliefbake {

/// One command for each file that a rule matches. Placeholders, in braces: stem (the file's name without extension), from (its
/// extension), kind; in options also folder (that of the source) and out (that of the output).
struct BakeRule {
    std::string kind;                 ///< a command: cone, acm, cone-normal, cone-stack, shape, bump, quadric
    std::vector<std::string> options; ///< its options, but IN, -o, --threads, --json, --quiet
    std::string output;               ///< name below the output folder, e.g. "{stem}_{kind}.png"
};

/// The files that meet each of the conditions that are given.
struct FileRule {
    std::string name;                  ///< for messages and events
    std::vector<std::string> files;    ///< globs, one of which must match (cli/batch/glob.h)
    std::vector<std::string> suffixes; ///< the stem ends in one of these, in any case
    std::vector<std::string> folders;  ///< one of the folders above the file, in any case
    std::optional<bool> one_bit;       ///< the image's header says one bit a sample
    std::vector<BakeRule> bakes;       ///< none: files are left out, for the reason `skip`
    std::string skip;
};

/// The first rule that matches decides; a file that none matches is left out.
struct Recipe {
    std::vector<FileRule> rules;
};

/// Heights become cone maps, pictures of shapes shape maps, meshes quadrics; told by extension, suffix, folder and header
/// (docs/BATCH.md has the table). Outputs are called `name` and an extension.
Recipe built_in_recipe(const std::string& name);

/// Reads a recipe (docs/BATCH.md). Errors: no_input; bad_data, with file and line: no TOML, unknown keys, a rule that bakes nothing,
/// a kind that is none, an output that leaves the folder, an unknown placeholder.
Result<Recipe> read_recipe(const std::filesystem::path& path);

/// Checks a pattern of an output's name; "" or what is wrong with it.
std::string name_fault(const std::string& pattern);

/// The rule for the file at `relative` (with '/'), to be opened as `path`; null where none matches.
const FileRule* rule_for(const Recipe& recipe, const std::string& relative, const std::filesystem::path& path);

/// The text with its placeholders filled in.
struct Placeholders {
    std::string stem, from, kind, folder, out;
};
std::string fill_in(const std::string& pattern, const Placeholders& values);

} // namespace reliefbake
