#include "cli/quadric_options.h"

#include "cli/choices.h"
#include "cli/number_options.h"
#include "cli/thread_option.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace reliefbake {

namespace {

namespace fs = std::filesystem;

const Words<QuadricFit> fit_words = {{"ring", QuadricFit::ring}, {"paper", QuadricFit::paper}};
const Words<FrameKind> frame_words = {{"uv", FrameKind::uv}, {"mesh", FrameKind::mesh}, {"principal", FrameKind::principal}};
const Words<bool> term_words = {{"ab", false}, {"abc", true}};

/// attr, color, or uv:N.
void parse_store(const std::string& text, QuadricStore& store) {
    constexpr int last_set = 7;
    if (text == "attr") {
        store.where = QuadricStore::Where::attribute;
    } else if (text == "color") {
        store.where = QuadricStore::Where::color;
    } else if (text.size() == 4 && text.starts_with("uv:") && text[3] >= '0' && text[3] <= '0' + last_set) {
        store.where = QuadricStore::Where::uv;
        store.uv_set = text[3] - '0';
    } else {
        throw CLI::ValidationError("--store", "expected attr, uv:0 to uv:7, or color, found '" + text + "'");
    }
}

Result<void> check_output_folder(const std::string& output) {
    const fs::path parent = fs::path(output).parent_path();
    const fs::path folder = parent.empty() ? "." : parent;
    if (access(folder.c_str(), W_OK | X_OK) == 0) return {};
    return fail(ErrorCode::cannot_create,
                output + ": cannot create a file in " + folder.string() + ": " + std::generic_category().message(errno));
}

} // namespace

void add_quadric_options(CLI::App& app, QuadricCommandOptions& o) {
    app.add_option("MESH", o.input, "Mesh: obj, ply, off, stl, gltf, glb")->required();
    app.option_defaults()->group("Fit");
    add_choice(app, "--fit", o.quadric.fit, fit_words,
               "ring: five terms, right in every frame; paper: a and b as printed, right only in frames along the principal directions (default ring)");
    add_choice(app, "--terms", o.quadric.twist, term_words, "Terms to store: a x^2 + b y^2, or with c x y (default abc)");
    add_choice(app, "--frame", o.quadric.frame, frame_words,
               "x and y of the quadric: along u (MikkTSpace), the file's tangents, or the direction of strongest curvature "
               "(default: mesh where the file has tangents, else uv where it has texture coordinates, else principal)");
    add_thread_option(app, o.quadric.threads);
    add_byte_budget(app, o.read.max_bytes);
    app.option_defaults()->group("Result");
    app.add_option("-o,--output", o.output, "Mesh to write: .glb .gltf .ply")->required()->type_name("OUT");
    app.add_option_function<std::string>("--store", [&o](const std::string& text) { parse_store(text, o.store); },
                                         "Where quadrics go: attributes _QUADRIC or quadric_a ..., texture coordinates, or colours (default attr)")
        ->type_name("attr|uv:N|color");
    CLI::Option* json = app.add_flag("--json", o.json, "Print one result object (cli/schema/quadric.schema.json)");
    app.add_flag("--quiet", o.quiet, "Print nothing unless something is wrong")->excludes(json);
}

Result<QuadricCommandOptions> plan_quadric(const QuadricCommandOptions& given) {
    QuadricCommandOptions plan = given;
    plan.store.twist = plan.quadric.twist;
    std::error_code ignored;
    if (fs::equivalent(given.input, given.output, ignored))
        return fail(ErrorCode::usage, given.output + ": the output is the input file; choose another name");
    if (given.quadric.fit == QuadricFit::paper) plan.store.twist = plan.quadric.twist = false; // it has no third term
    return check_mesh_output(plan.output, plan.store)
        .and_then([&] { return check_output_folder(plan.output); })
        .and_then([&] { return resolve_threads(given.quadric.threads); })
        .map([&](int threads) {
            plan.quadric.threads = threads;
            return plan;
        });
}

std::string word_of_fit(QuadricFit fit) { return word_of(fit_words, fit); }
std::string word_of_frame(FrameKind frame) { return word_of(frame_words, frame); }

std::string word_of_store(const QuadricStore& store) {
    if (store.where == QuadricStore::Where::uv) return "uv:" + std::to_string(store.uv_set);
    return store.where == QuadricStore::Where::color ? "color" : "attr";
}

} // namespace reliefbake
