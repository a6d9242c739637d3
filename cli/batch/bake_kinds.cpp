#include "cli/batch/bake_kinds.h"

namespace reliefbake {

namespace {

constexpr BakeKind kinds[] = {
    {"cone", "png", false, 900},       {"acm", "exr", false, 3000}, {"cone-normal", "png", false, 900}, {"cone-stack", "exr", false, 3000},
    {"shape", "png", false, 500},      {"bump", "png", false, 500}, {"quadric", "glb", true, 100},
};

} // namespace

const BakeKind* find_bake_kind(const std::string& word) {
    for (const BakeKind& kind : kinds)
        if (word == kind.word) return &kind;
    return nullptr;
}

std::string bake_kind_words() {
    std::string words;
    for (const BakeKind& kind : kinds) words += (words.empty() ? "" : ", ") + std::string(kind.word);
    return words;
}

} // namespace reliefbake
