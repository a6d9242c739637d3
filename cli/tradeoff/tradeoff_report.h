#pragma once
// What a sweep found, as CSV, JSON, plots and a page. Texts alone: the command writes the files.

#include "cli/tradeoff/sweep.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace reliefbake {

/// All of one input.
struct TradeoffSection {
    std::string file, name; ///< as given; a word for files, once a run
    int width = 0, height = 0;
    std::string pictures; ///< folder of the pictures of its fronts, in the sweep's own
    std::vector<MeasuredCandidate> candidates;
};

/// A cost that errors are set against.
struct TradeoffCost {
    const char* word;  ///< in names of files
    const char* title; ///< on axes
    double Measurement::* value;
    bool plotted;
};
std::span<const TradeoffCost> tradeoff_costs();

/// Candidates whose error_mean no other has at as low a cost; indices, in order of cost.
std::vector<std::size_t> front_of(const TradeoffSection& section, const TradeoffCost& cost);

std::string tradeoff_csv(const std::vector<TradeoffSection>& sections);

/// cli/schema/tradeoff.schema.json
nlohmann::json tradeoff_json(const std::vector<TradeoffSection>& sections, const JudgeOptions& options, double depth_scale);

/// Curves of the methods, all at their base axes; everything else as dots.
std::string tradeoff_svg(const TradeoffSection& section, const TradeoffCost& cost);

/// The bytes of a candidate's picture and error picture, PNG.
struct PngPair {
    std::string colour, error;
};
using PicturesOf = std::function<PngPair(const TradeoffSection&, const std::string& id)>;

std::string tradeoff_html(const std::vector<TradeoffSection>& sections, const JudgeOptions& options, double depth_scale, const PicturesOf& pictures_of);

} // namespace reliefbake
