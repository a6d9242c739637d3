#pragma once
// Candidates and their figures as JSON (cli/schema/tradeoff.schema.json).

#include "cli/tradeoff/judge.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <span>

namespace reliefbake {

/// Keys: id, kind, planes, family, encoding, bits, tolerance, cone_max, resolution, technique, exact_finish, steps, refinements;
/// null where an axis means nothing to the candidate, or for a cap of inf.
nlohmann::json to_json(const Candidate& candidate);

/// Keys are the names of Measurement's members.
nlohmann::json to_json(const Measurement& measurement);

/// Reads what to_json made; nothing where a key is missing or no number.
std::optional<Measurement> measurement_from_json(const nlohmann::json& json);

/// A figure of a measurement, by its name: what CSV and JSON hold.
struct MeasurementField {
    const char* name;
    double Measurement::* value;
};
std::span<const MeasurementField> measurement_fields();

} // namespace reliefbake
