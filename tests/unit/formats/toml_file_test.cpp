#include "formats/toml_file.h"

#include "temporary_folder.h"

#include <catch2/catch.hpp>

#include <random>
#include <thread>

using namespace reliefbake;
using namespace reliefbake::test;

namespace {

std::string repeat(const std::string& what, int count, const std::string& start = "") {
    std::string text = start;
    for (int k = 0; k < count; ++k) text += what;
    return text;
}

/// The refusal's message; "" where the text is read.
std::string fault_of(const std::string& text) {
    const Result<toml::table> table = parse_toml(text, "r.toml");
    if (table) return "";
    CHECK(table.error().code == ErrorCode::bad_data);
    CHECK(table.error().message.find('\n') == std::string::npos);
    return table.error().message;
}

} // namespace

TEST_CASE("A TOML file is read into tables; what is wrong is told with its line") {
    TemporaryFolder folder;
    write_bytes(folder / "a.toml", "title = \"x\"\n[bake]\ndepth = 3\nratio = 0.5\nmips = true\nlist = [1, 2]\n");
    const Result<toml::table> table = read_toml_file(folder / "a.toml");
    REQUIRE(table);
    CHECK(toml_value<std::string>(*table, "title", "a")->value() == "x");
    CHECK_FALSE(toml_value<std::string>(*table, "none", "a")->has_value());
    const toml::table* bake = *toml_part<toml::table>(*table, "bake", "a");
    REQUIRE(bake);
    CHECK(toml_value<std::int64_t>(*bake, "depth", "a")->value() == 3);
    CHECK(toml_value<double>(*bake, "depth", "a")->value() == 3.0);
    CHECK(toml_value<double>(*bake, "ratio", "a")->value() == 0.5);
    CHECK(toml_value<bool>(*bake, "mips", "a")->value());
    CHECK((*toml_part<toml::array>(*bake, "list", "a"))->size() == 2);
    CHECK(*toml_part<toml::array>(*bake, "none", "a") == nullptr);

    CHECK(toml_value<bool>(*bake, "depth", "a.toml").error().message == "a.toml:3: 'depth': expected true or false, found an integer");
    CHECK(toml_value<std::int64_t>(*bake, "ratio", "a.toml").error().message == "a.toml:4: 'ratio': expected an integer, found a number");
    CHECK(toml_value<std::string>(*bake, "list", "a.toml").error().message == "a.toml:6: 'list': expected a string, found an array");
    CHECK(toml_part<toml::table>(*table, "title", "a.toml").error().message == "a.toml:1: 'title': expected a table, found a string");
    CHECK(refuse_unknown_keys(*bake, {"depth", "ratio", "mips", "list"}, "a.toml"));
    CHECK(refuse_unknown_keys(*bake, {"depth", "list"}, "a.toml").error().message == "a.toml:4: unknown key 'ratio'; expected one of depth, list");
    CHECK(fault_of("a = 1\nb = \n").starts_with("r.toml:2: "));
    CHECK(fault_of("a = 1\na = 2\n").starts_with("r.toml:2: "));
    CHECK(toml_value<double>(*parse_toml("a = inf", "r"), "a", "r").error().message == "r:1: 'a': expected a finite number");
}

TEST_CASE("A TOML file that cannot be opened, is no file, or is too large is refused") {
    TemporaryFolder folder;
    CHECK(read_toml_file(folder / "none.toml").error().code == ErrorCode::no_input);
    CHECK(read_toml_file(folder.path()).error().code == ErrorCode::no_input);
    const std::string fill = "#" + std::string(largest_toml_bytes - 2, ' ') + "\n";
    write_bytes(folder / "most.toml", fill);
    CHECK(read_toml_file(folder / "most.toml"));
    write_bytes(folder / "more.toml", fill + " ");
    const Result<toml::table> more = read_toml_file(folder / "more.toml");
    REQUIRE_FALSE(more);
    CHECK(more.error().code == ErrorCode::bad_data);
    CHECK(more.error().message.find("1048576") != std::string::npos);
}

TEST_CASE("Nesting of any kind is refused beyond its limit, and read up to it") {
    const std::string more_brackets = ": more than 32 brackets inside each other", more_dots = ": a key of more than 32 dots";
    for (const int depth : {31, 32})
        CHECK(fault_of(repeat("[", depth, "a = ") + repeat("]", depth)) == "");
    CHECK(fault_of(repeat("[", 33, "b = 1\na = ") + repeat("]", 33)) == "r.toml:2" + more_brackets);
    CHECK(fault_of(repeat(".a", 32, "a") + " = 1") == "");
    CHECK(fault_of(repeat(".a", 33, "\n\na") + " = 1") == "r.toml:3" + more_dots);
    CHECK(fault_of(repeat(" . \"a\"", 33, "[a") + "]") == "r.toml:1" + more_dots);
    CHECK(fault_of(repeat(".'a'", 33, "[[a") + "]]") == "r.toml:1" + more_dots);
    CHECK(fault_of(repeat(".a", 33, "a = {b") + " = 1}") == "r.toml:1" + more_dots);
    // Half a megabyte of each, open or closed, in a thread with little stack: no crash.
    std::thread([&] {
        for (const char* unit : {"[", "[[", "{a=", "[{a=", "a.", "\"\".", "''.", "a . "})
            for (const char* start : {"", "a = ", "[", "a = {", "a = \"\"\"x\"\"\"\"\"\nb", "#\r\n", "a = 'it''s'\n", "a = \"\\\"\"\n"})
                CHECK(fault_of(start + repeat(unit, 100000)) != "");
    }).join();
    // The deepest that both limits allow is read and destroyed.
    const std::string dots = repeat(".a", 32, "a");
    CHECK(fault_of("[" + dots + "]\n" + dots + " = " + repeat("{" + dots + " = ", 32) + "1" + repeat("}", 32)) == "");
}

TEST_CASE("Brackets and dots in strings and comments do not count") {
    const std::string many = repeat("[.", 100);
    for (const std::string& text : {"a = \"" + many + "\"", "a = '" + many + "'", "a = \"\"\"" + many + "\n\"" + many + "\"\"\"\"", "a = '''" + many + "'\n" + many + "'''", "# " + many,
                                    "a = \"\\\"" + many + "\"", "a = 1 # " + many + "\nb = 2", "a = \"\"\"\\\"\"\"" + many + "\"\"\"", "\"" + many + "\" = 1", std::string("a = ''\nb = \"\"\n")})
        CHECK(fault_of(text) == "");
    // A string that ends does not hide what follows.
    for (const std::string start : {"a = \"\"\n", "a = ''\n", "a = \"\"\"\"\"\"\n", "a = \"\\\\\"\n", "a = '\\'\n", "a = \"\"\"\"\"\"\"\"\n", "a = 1 # \"\n", "a = 1 # '''\r\n"})
        CHECK(fault_of(start + "b = " + repeat("[", 33)).find("brackets") != std::string::npos);
}

TEST_CASE("Damaged TOML is refused in one line and never crashes") {
    const std::string whole = "[bake]\nname = \"a\\u00e9\"\nlist = [1, 2.5e3, 0x1F, 1979-05-27T07:32:00Z]\nsub = {x = 'y', z.w = true}\n[[rule]]\nglob = \"\"\"\nq\"\"\"\n";
    REQUIRE(fault_of(whole) == "");
    for (std::size_t size = 0; size < whole.size(); ++size) (void)fault_of(whole.substr(0, size));
    std::mt19937 random(1);
    for (int round = 0; round < 20000; ++round) {
        std::string text = whole;
        for (int change = 0; change < 3; ++change) text[random() % text.size()] = char(random());
        (void)fault_of(text);
    }
    CHECK(fault_of(std::string("a = 1\0b", 7)).starts_with("r.toml:1: holds the control character 0"));
    CHECK(fault_of("a = \"\xff\xfe\"").starts_with("r.toml:1"));
    CHECK(fault_of(repeat("a.", 100, "# \v")) != ""); // no line break for us, whatever it is for others
}
