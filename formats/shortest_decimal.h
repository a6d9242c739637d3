#pragma once
// Floats as people wrote them: 0.001f is 0.001, not 0.0010000000474974513.

namespace reliefbake {

/// The double with the shortest decimal digits that reads back as `value`: float(shortest_decimal(x)) == x.
double shortest_decimal(float value);

} // namespace reliefbake
