#pragma once
// A verification as a person reads it.

#include "shaders-reference/measure/verify.h"
#include "shaders-reference/measure/verify_mesh.h"
#include "shaders-reference/measure/verify_shape.h"

#include <string>

namespace reliefbake {

/// A table of the views, then one line each for rays, cones, tightness and the verdict.
std::string verify_text(const VerifyReport& report);
std::string verify_text(const ShapeVerifyReport& report);
/// A table of the views.
std::string verify_text(const MeshVerifyReport& report);

} // namespace reliefbake
