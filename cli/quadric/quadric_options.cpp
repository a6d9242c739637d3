#include "cli/quadric/quadric_options.h"

#include "cli/choices.h"
#include "cli/options/number_options.h"
#include "cli/options/thread_option.h"
#include "cli/output_checks.h"

namespace reliefbake {

namespace {

const Words<QuadricFit> fit_words = {{"ring", QuadricFit::ring}, {"paper", QuadricFit::paper}, {"jet", QuadricFit::jet}};
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

Result<void> validate_preview(const QuadricCommandOptions& plan) {
    if (plan.preview.empty()) return {};
    if (extension_of(plan.preview) != ".png") return fail(ErrorCode::usage, "--preview: expected a name that ends in .png, found '" + plan.preview + "'");
    return validate_not_input(plan.input, plan.preview).and_then([&] { return validate_output_folder(plan.preview); });
}

} // namespace

void add_quadric_options(CLI::App& app, QuadricCommandOptions& o) {
    app.add_option("MESH", o.input, "Mesh: obj, ply, off, stl, gltf, glb")->required();
    app.option_defaults()->group("Fit");
    add_choice(app, "--fit", o.quadric.fit, fit_words,
               "ring: five terms, right in every frame; paper: a and b as printed, right only in frames along the principal directions; "
               "jet: CGAL's, in builds that hold it (default ring)");
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
    app.add_option("--preview", o.preview, "Picture to write beside it: mean curvature (red bulges) and Gaussian (blue are saddles)")->type_name("PNG");
    CLI::Option* json = app.add_flag("--json", o.json, "Print one result object (cli/schema/quadric.schema.json)");
    app.add_flag("--quiet", o.quiet, "Print nothing unless something is wrong")->excludes(json);
}

Result<QuadricCommandOptions> plan_quadric(const QuadricCommandOptions& given) {
    QuadricCommandOptions plan = given;
    plan.store.twist = plan.quadric.twist;
    if (given.quadric.fit == QuadricFit::paper) plan.store.twist = plan.quadric.twist = false; // it has no third term
    return validate_not_input(plan.input, plan.output)
        .and_then([&] { return check_mesh_output(plan.output, plan.store); })
        .and_then([&] { return validate_output_folder(plan.output); })
        .and_then([&] { return validate_preview(plan); })
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
