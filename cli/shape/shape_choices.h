#pragma once
// Words of shapes and their distances.

#include "bake/shape_map.h"
#include "cli/choices.h"

namespace reliefbake {

inline const Words<ShapeModel> model_words = {
    {"squares", ShapeModel::squares}, {"centres", ShapeModel::centres}, {"contour", ShapeModel::contour}};
/// Those that one may name; contour is --antialiased, which also says how to read the samples.
inline const Words<ShapeModel> given_model_words(model_words.begin(), model_words.begin() + 2);
inline const Words<DistanceMethod> method_words = {{"exact", DistanceMethod::exact}, {"danielsson", DistanceMethod::danielsson}};

} // namespace reliefbake
