#include "cli/report/html_page.h"

#include "cli/report/base64.h"
#include "cli/report/svg_plot.h"

namespace reliefbake {
namespace {

constexpr const char* style = "body{font:15px/1.45 sans-serif;max-width:1100px;margin:2em auto;padding:0 1em;color:#222}"
                              "table{border-collapse:collapse;margin:1em 0;font-size:13px}th,td{padding:3px 8px;border-bottom:1px solid #ddd;text-align:right}"
                              "th:first-child,td:first-child{text-align:left}th{border-bottom:2px solid #888;vertical-align:bottom}img{display:block}svg{max-width:100%;height:auto}";

} // namespace

std::string html_page(const std::string& title, const std::string& body) {
    return "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head><meta charset=\"utf-8\"/><title>" + escaped(title) +
           "</title><style>" + style + "</style></head>\n<body>\n" + body + "</body>\n</html>\n";
}

std::string html_table(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows) {
    std::string text = "<table>\n<tr>";
    for (const std::string& head : heads) text += "<th>" + head + "</th>";
    text += "</tr>\n";
    for (const std::vector<std::string>& row : rows) {
        text += "<tr>";
        for (const std::string& cell : row) text += "<td>" + cell + "</td>";
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

std::string html_picture(std::string_view png, const std::string& alternative) {
    return "<img alt=\"" + escaped(alternative) + "\" src=\"data:image/png;base64," + base64(png) + "\"/>";
}

} // namespace reliefbake
