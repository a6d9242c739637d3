#include "cli/quadric/quadric_report.h"

#include "cli/report/format_text.h"
#include "cli/version.h"

#include <algorithm>

namespace reliefbake {

using nlohmann::json;

namespace {

/// Frames of several meshes may differ: what the file has decides for each.
std::string frame_words_of(std::span<const QuadricBake> bakes) {
    std::string words;
    for (const QuadricBake& bake : bakes)
        if (const std::string word = word_of_frame(bake.frame); words.find(word) == words.npos) words += (words.empty() ? "" : ",") + word;
    return words;
}

json counts_of(const QuadricCounts& c) {
    return {{"vertices", c.vertices},
            {"positions", c.positions},
            {"triangles", c.triangles},
            {"non_finite_vertices", c.non_finite_vertices},
            {"non_finite_triangles", c.non_finite_triangles},
            {"degenerate_triangles", c.degenerate_triangles},
            {"zero_area_triangles", c.zero_area_triangles},
            {"isolated", c.isolated},
            {"no_normal", c.no_normal},
            {"boundary", c.boundary},
            {"non_manifold", c.non_manifold},
            {"low_valence", c.low_valence},
            {"second_ring", c.second_ring},
            {"short_rank", c.short_rank},
            {"made_normals", c.made_normals},
            {"against_winding", c.against_winding},
            {"made_tangents", c.made_tangents},
            {"mirrored", c.mirrored},
            {"split_vertices", c.split_vertices},
            {"out_of_range", c.out_of_range}};
}

json term_of(const TermStatistics& t) {
    return {{"lowest", t.lowest}, {"highest", t.highest}, {"mean", t.mean}, {"reach", t.reach}, {"histogram", t.histogram}};
}

const char* word_of_format(MeshFormat format) {
    switch (format) {
    case MeshFormat::obj: return "obj";
    case MeshFormat::ply: return "ply";
    case MeshFormat::off: return "off";
    case MeshFormat::stl: return "stl";
    case MeshFormat::gltf: return "gltf";
    case MeshFormat::glb: return "glb";
    }
    return "";
}

const char* store_warning(const QuadricStore& store) {
    switch (store.where) {
    case QuadricStore::Where::attribute: return "";
    case QuadricStore::Where::uv:
        return "--store uv: tools that pack, clamp or atlas texture coordinates change them; gltfpack keeps two sets only when a material uses them";
    case QuadricStore::Where::color:
        return "--store color: codes instead of floats (16 bits in glTF, 8 in PLY), and viewers multiply the colours into the material; "
               "the metadata's range scales them back";
    }
    return "";
}

} // namespace

json quadric_info(const QuadricCommandOptions& plan, std::span<const QuadricBake> bakes) {
    const bool twist = plan.store.twist;
    return {{"kind", "quadric"},
            {"version", version()},
            {"formula", twist ? "z = a x^2 + b y^2 + c x y" : "z = a x^2 + b y^2"},
            {"unit", "1 / unit of the positions"},
            {"axes", "x along the tangent, y along sign * cross(normal, tangent), z along the normal"},
            {"frame", frame_words_of(bakes)},
            {"fit", word_of_fit(plan.quadric.fit)},
            {"terms", twist ? json::array({"a", "b", "c"}) : json::array({"a", "b"})},
            {"store", word_of_store(plan.store)}};
}

std::vector<std::string> quadric_warnings(const QuadricRun& run) {
    std::vector<std::string> warnings = run.file.notes;
    const QuadricCounts& c = run.counts;
    constexpr double small_loss = 0.02;
    if (!run.plan.store.twist && run.statistics.twist_share > small_loss)
        warnings.push_back(format("%s leaves out c, which holds %.0f %% of the curvature here: the frames are turned off the principal directions; use %s",
                                  run.plan.quadric.fit == QuadricFit::paper ? "--fit paper" : "--terms ab", 100 * run.statistics.twist_share,
                                  run.plan.quadric.fit == QuadricFit::paper ? "--fit ring" : "--terms abc, or --frame principal"));
    const bool has_texture = std::any_of(run.file.meshes.begin(), run.file.meshes.end(), [](const Mesh& m) { return !m.uvs.empty(); });
    if (run.plan.quadric.frame == FrameKind::principal && has_texture)
        warnings.push_back("--frame principal: the tangents do not follow the texture: normal maps, and reliefs that are marched along u and v, need --frame uv");
    if (const std::string text = store_warning(run.plan.store); !text.empty()) warnings.push_back(text);
    const auto count = [&](std::size_t n, const char* what) {
        if (n > 0) warnings.push_back(std::to_string(n) + " " + what);
    };
    count(c.non_finite_vertices, "vertices are not finite: no triangle of theirs counts, their quadrics are 0");
    count(c.against_winding, "vertices have normals against the winding of their triangles: their quadrics follow the normals");
    count(c.no_normal, "positions have no normal (their triangles cancel or have no area): their quadrics are 0");
    count(c.out_of_range, "quadrics are beyond what a float holds: 0; scale the mesh up");
    return warnings;
}

std::string quadric_result_text(const QuadricRun& run, const StageClock::Seconds& seconds) {
    json times = json::object();
    for (const auto& [stage, duration] : seconds) times[stage] = duration;
    const QuadricStatistics& s = run.statistics;
    const json result = {{"input", run.plan.input},
                         {"output", run.plan.output},
                         {"format", word_of_format(run.file.format)},
                         {"meshes", run.bakes.size()},
                         {"quadric", quadric_info(run.plan, run.bakes)},
                         {"counts", counts_of(run.counts)},
                         {"residual", {{"rms", s.residual_rms}, {"max", s.residual_max}}},
                         {"twist_share", s.twist_share},
                         {"a", term_of(s.terms[0])},
                         {"b", term_of(s.terms[1])},
                         {"c", term_of(s.terms[2])},
                         {"warnings", run.warnings},
                         {"threads", run.plan.quadric.threads},
                         {"seconds", times}};
    return result.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

std::string quadric_summary(const QuadricRun& run, const StageClock::Seconds& seconds) {
    const QuadricCounts& c = run.counts;
    const QuadricStatistics& s = run.statistics;
    std::string text = run.plan.output + ": " + format("%zu vertices at %zu positions, %zu triangles, from ", c.vertices, c.positions, c.triangles) +
                       run.plan.input + "\n";
    text += format("  frame %s, fit %s; a %.4g..%.4g, b %.4g..%.4g, c %.4g..%.4g\n", frame_words_of(run.bakes).c_str(),
                   word_of_fit(run.plan.quadric.fit).c_str(), s.terms[0].lowest, s.terms[0].highest, s.terms[1].lowest, s.terms[1].highest,
                   s.terms[2].lowest, s.terms[2].highest);
    text += format("  %zu boundary, %zu non-manifold, %zu isolated; %zu rings reach to the second ring, %zu give the shortest solution\n", c.boundary,
                   c.non_manifold, c.isolated, c.second_ring, c.short_rank);
    text += format("  %zu vertices split, %zu mirrored, %zu with a normal and %zu with a tangent that was made\n", c.split_vertices, c.mirrored,
                   c.made_normals, c.made_tangents);
    return text + format("  %.3g s, %d threads\n", seconds.back().second, run.plan.quadric.threads);
}

} // namespace reliefbake
