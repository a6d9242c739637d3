#pragma once
// A page that holds everything it shows.

#include <string>
#include <string_view>
#include <vector>

namespace reliefbake {

/// A whole document, well-formed as XML too; `body` is markup.
std::string html_page(const std::string& title, const std::string& body);

/// A table; every cell is markup. The first column is text, the others are numbers.
std::string html_table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows);

/// An <img> with the picture in it.
std::string html_picture(std::string_view png, const std::string& alternative);

} // namespace reliefbake
