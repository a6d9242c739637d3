#include "cli/batch/recipe.h"

namespace reliefbake {

namespace {

const std::vector<std::string> mesh_files{"*.[oO][bB][jJ]", "*.[pP][lL][yY]", "*.[oO][fF][fF]", "*.[sS][tT][lL]", "*.[gG][lL][tT][fF]", "*.[gG][lL][bB]"};
const std::vector<std::string> image_files{"*.[pP][nN][gG]", "*.[tT][iI][fF]", "*.[tT][iI][fF][fF]", "*.[eE][xX][rR]", "*.[hH][dD][rR]", "*.[jJ][pP][gG]",
                                           "*.[jJ][pP][eE][gG]", "*.[tT][gG][aA]", "*.[bB][mM][pP]", "*.[pP][gG][mM]", "*.[pP][pP][mM]", "*.[pP][fF][mM]"};

/// Names that texture libraries give to what is no relief.
const std::vector<std::string> other_suffixes{"_albedo",    "_basecolor", "_base_color", "_color",    "_colour", "_col",       "_diffuse", "_diff",
                                              "_normal",    "_normalgl",  "_normaldx",   "_nor",      "_nrm",    "_roughness", "_rough",   "_metallic",
                                              "_metalness", "_ao",        "_occlusion",  "_emissive", "_spec",   "_specular",  "_gloss"};

} // namespace

Recipe built_in_recipe(const std::string& name) {
    const auto bake = [&](const char* kind, const char* extension, std::vector<std::string> options = {}) {
        return std::vector{BakeRule{kind, std::move(options), name + "." + extension}};
    };
    return {{
        {"meshes", mesh_files, {}, {}, {}, bake("quadric", "glb"), ""},
        {"masks", image_files, {"_mask", "_opacity", "_alpha", "_shape"}, {}, {}, bake("shape", "png"), ""},
        {"depths", image_files, {"_depth"}, {}, {}, bake("cone", "png", {"--input", "depth"}), ""},
        {"named heights", image_files, {"_height", "_disp", "_displacement", "_bump", "_h"}, {}, {}, bake("cone", "png"), ""},
        {"other textures", image_files, other_suffixes, {}, {}, {}, "its name says that it is no relief"},
        {"shapes", image_files, {}, {"shape", "shapes", "mask", "masks"}, {}, bake("shape", "png"), ""},
        {"pictures of one bit", image_files, {}, {}, true, bake("shape", "png"), ""},
        {"heights", image_files, {}, {}, {}, bake("cone", "png"), ""},
    }};
}

} // namespace reliefbake
