#include "cli/report/base64.h"
#include "cli/report/html_page.h"
#include "cli/report/svg_plot.h"

#include <catch2/catch.hpp>

using namespace reliefbake;

TEST_CASE("base64 is that of RFC 4648") {
    CHECK(base64("") == "");
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foob") == "Zm9vYg==");
    CHECK(base64("fooba") == "Zm9vYmE=");
    CHECK(base64("foobar") == "Zm9vYmFy");
    CHECK(base64(std::string_view("\xff\xfe\x00", 3)) == "//4A");
}

TEST_CASE("text that goes into markup is escaped") {
    CHECK(escaped("a<b> & \"c\"") == "a&lt;b&gt; &amp; &quot;c&quot;");
    LogPlot plot;
    plot.title = "<x>", plot.series = {{"a & b", {{1, 0.1}, {10, 0}}}};
    const std::string svg = svg_text(plot);
    CHECK(svg.find("<x>") == std::string::npos);
    CHECK(svg.find("a &amp; b") != std::string::npos);
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
    CHECK(html_page("<t>", "").find("<t>") == std::string::npos);
}

TEST_CASE("an empty plot, and one of a single point, are plots") {
    for (LogPlot plot : {LogPlot{}, LogPlot{.title = "t", .x_label = "x", .y_label = "y", .series = {{"s", {{3, 0}}}}, .dots = {}, .front = {{3, 0}}}}) {
        const std::string svg = svg_text(plot);
        CHECK(svg.find("nan") == std::string::npos);
        CHECK(svg.find("inf") == std::string::npos);
    }
}
