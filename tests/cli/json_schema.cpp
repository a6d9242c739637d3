#include "tests/cli/json_schema.h"

#include <algorithm>

namespace reliefbake::test {

using nlohmann::json;

namespace {

bool is_type(const json& value, const std::string& type) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    return type == "null" && value.is_null();
}

bool has_type(const json& value, const json& types) {
    if (types.is_string()) return is_type(value, types);
    return std::any_of(types.begin(), types.end(), [&](const json& type) { return is_type(value, type); });
}

std::string object_fault(const json& value, const json& schema, const std::string& place) {
    for (const json& key : schema.value("required", json::array()))
        if (!value.contains(key)) return place + "." + key.get<std::string>() + ": missing";
    const json properties = schema.value("properties", json::object());
    const bool closed = schema.contains("additionalProperties") && schema["additionalProperties"] == false;
    for (const auto& [key, member] : value.items()) {
        if (properties.contains(key)) {
            const std::string fault = schema_fault(member, properties[key], place + "." + key);
            if (!fault.empty()) return fault;
        } else if (closed)
            return place + "." + key + ": not in the schema";
    }
    return "";
}

} // namespace

std::string schema_fault(const json& value, const json& schema, const std::string& place) {
    if (schema.contains("type") && !has_type(value, schema["type"])) return place + ": wrong type";
    if (schema.contains("enum")) {
        const json& words = schema["enum"];
        if (std::find(words.begin(), words.end(), value) == words.end())
            return place + ": not one of the words";
    }
    if (value.is_object()) return object_fault(value, schema, place);
    if (value.is_array() && schema.contains("items"))
        for (std::size_t i = 0; i < value.size(); ++i) {
            const std::string fault =
                schema_fault(value[i], schema["items"], place + "[" + std::to_string(i) + "]");
            if (!fault.empty()) return fault;
        }
    return "";
}

} // namespace reliefbake::test
