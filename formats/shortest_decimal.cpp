#include "formats/shortest_decimal.h"

#include <charconv>

namespace reliefbake {

double shortest_decimal(float value) {
    char text[32];
    const char* end = std::to_chars(text, text + sizeof text, value).ptr;
    double decimal = 0;
    std::from_chars(text, end, decimal);
    // The digits belong to the float; by way of a double they may meet a tie and round to its neighbour.
    return float(decimal) == value ? decimal : double(value);
}

} // namespace reliefbake
