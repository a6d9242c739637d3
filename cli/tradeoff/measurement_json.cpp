#include "cli/tradeoff/measurement_json.h"

#include "cli/choices.h"
#include "formats/shortest_decimal.h"

#include <cmath>

namespace reliefbake {
namespace {

constexpr MeasurementField fields[] = {
    {"missed", &Measurement::missed},
    {"early", &Measurement::early},
    {"out_of_steps", &Measurement::out_of_steps},
    {"error_mean", &Measurement::error_mean},
    {"error_deviation", &Measurement::error_deviation},
    {"error_p99", &Measurement::error_p99},
    {"error_max", &Measurement::error_max},
    {"mse", &Measurement::mse},
    {"dissimilarity", &Measurement::dissimilarity},
    {"steps_mean", &Measurement::steps_mean},
    {"refining_steps_mean", &Measurement::refining_steps_mean},
    {"steps_max", &Measurement::steps_max},
    {"fetches_mean", &Measurement::fetches_mean},
    {"instructions", &Measurement::instructions},
    {"bytes_per_texel", &Measurement::bytes_per_texel},
    {"bytes", &Measurement::bytes},
    {"bake_seconds", &Measurement::bake_seconds},
    {"ms_per_frame", &Measurement::ms_per_frame},
    {"cpu_ms_per_frame", &Measurement::cpu_ms_per_frame},
};

} // namespace

std::span<const MeasurementField> measurement_fields() { return fields; }

nlohmann::json to_json(const Candidate& candidate) {
    const Representation& map = candidate.map;
    const TechniqueInfo& info = technique_info(candidate.march.technique);
    nlohmann::json json{{"id", id_of(candidate)}, {"kind", map.kind}, {"bits", word_of(bits_words, map.bits)}, {"resolution", resolution_of(map)},
                        {"technique", info.word}, {"exact_finish", candidate.march.exact_finish}, {"steps", candidate.march.steps},
                        {"refinements", nullptr}, {"planes", nullptr}, {"family", nullptr}, {"encoding", nullptr}, {"tolerance", nullptr}, {"cone_max", nullptr}};
    if (info.refines) json["refinements"] = candidate.march.refinements;
    if (!map.has_cones()) return json;
    json["planes"] = map.planes, json["family"] = word_of(family_words, map.cone.family), json["encoding"] = word_of(encoding_words, map.encoding);
    json["tolerance"] = shortest_decimal(map.cone.tolerance);
    if (std::isfinite(map.cone.ratio_max)) json["cone_max"] = shortest_decimal(map.cone.ratio_max);
    return json;
}

nlohmann::json to_json(const Measurement& measurement) {
    nlohmann::json json{{"rays", measurement.rays}};
    for (const MeasurementField& field : fields) json[field.name] = measurement.*field.value;
    return json;
}

std::optional<Measurement> measurement_from_json(const nlohmann::json& json) {
    Measurement measurement;
    const auto rays = json.find("rays");
    if (rays == json.end() || !rays->is_number_unsigned()) return std::nullopt;
    measurement.rays = rays->get<std::uint64_t>();
    for (const MeasurementField& field : fields) {
        const auto value = json.find(field.name);
        if (value == json.end() || !value->is_number()) return std::nullopt;
        measurement.*field.value = value->get<double>();
    }
    return measurement;
}

} // namespace reliefbake
