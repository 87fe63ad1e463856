// SPDX-License-Identifier: GPL-3.0-or-later
// crest ridges: ridges and umbilics of a triangle mesh or of a smooth surface, with a certificate.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <memory>
#include <optional>

#include "algorithms/ridges/auto_scale.hpp"
#include "algorithms/ridges/certificate.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "certify/certificate.hpp"
#include "cli/mesh_workers.hpp"
#include "cli/ridges_report.hpp"
#include "cli/run.hpp"
#include "cli/smooth_ridges_run.hpp"
#include "io/page/scene.hpp"
#include "io/ridges/ridge_picture.hpp"
#include "io/ridges/ridge_writer.hpp"

namespace crest::cli {
namespace {

struct RidgesOptions {
  CommonOptions common;
  SmoothRidgesOptions smooth;
  ridges::FitOptions fit;
  ridges::GraphOptions graph;
  ridges::FilterOptions filter;
  ridges::SalienceOptions salience;  ///< z = 0: none
  std::string scale;
  bool auto_scale = false;
  bool salient = false, significant = false, all = false;
  int order = 4;
};

void add_salience_options(CLI::App& app, RidgesOptions& o) {
  const CLI::Range not_negative(0.0, 1e300);
  app.add_option(
         "--significance", o.salience.z,
         "standard errors by which a significant ridge stands out (default 4; 0: do not ask)")
      ->check(not_negative)
      ->type_name("Z");
  app.add_option("--min-weight", o.salience.min_weight,
                 "least weight of a salient ridge (no unit, default 1.5)")
      ->check(not_negative)
      ->type_name("W");
  auto* salient = app.add_flag("--salient", o.salient, "write salient ridges only with -o");
  auto* significant =
      app.add_flag("--significant", o.significant, "write significant ridges only with -o");
  auto* all = app.add_flag("--all", o.all, "draw and count the whole graph, salient or not");
  salient->excludes(significant)->excludes(all);
  significant->excludes(all);
}

void add_ridges_options(CLI::App& app, RidgesOptions& o) {
  const CLI::Range not_negative(0.0, 1e300);
  app.option_defaults()->group(kMeshGroup);
  auto* rings = app.add_option("--rings", o.fit.rings,
                               "rings of neighbours a fit uses (default: until 30 points)");
  rings->check(CLI::Range(1, 100))->type_name("N");
  app.add_option("--scale", o.scale,
                 "radius of a fit's support in units of the input, or auto: chosen by what is "
                 "salient (the default with --picture and --page)")
      ->type_name("auto|R")
      ->excludes(rings);
  app.add_option("--smooth", o.fit.smooth, "smoothing steps of the extremalities (default 0)")
      ->check(CLI::Range(0, 1000))
      ->type_name("N");
  app.add_option("--order", o.order,
                 "rule that types the ridges: third or fourth order (default 4)")
      ->check(CLI::IsMember({3, 4}))
      ->type_name("3|4");
  app.add_option("--umbilic-patch", o.graph.umbilic_patch,
                 "size of umbilic patches in one-rings (default 3)")
      ->check(CLI::Range(0.0, 1000.0))
      ->type_name("K");
  app.add_option("--min-sharpness", o.filter.min_sharpness, "drop ridges below it (no unit)")
      ->check(not_negative)
      ->type_name("S");
  app.add_option("--min-strength", o.filter.min_strength, "drop ridges below it (no unit)")
      ->check(not_negative)
      ->type_name("S");
  app.add_option("--min-length", o.filter.min_length, "drop shorter ridges (units of the input)")
      ->check(not_negative)
      ->type_name("L");
  app.add_flag("--crest-only", o.filter.crest_only,
               "keep crest lines: elliptic, and of the larger curvature");
  add_salience_options(app, o);
  app.option_defaults()->group("Options");
}

/// --scale auto|R into the fit's options. With a picture or a page auto is the default.
void set_scale(RidgesOptions& o) {
  const bool marks = o.salience.z > 0;
  o.fit.errors = marks;
  if (!marks && (o.salient || o.significant))
    throw UsageError("--salient and --significant need --significance above 0");
  if (o.scale.empty()) {
    const bool drawn = !o.common.picture.empty() || !o.common.page.empty();
    o.auto_scale = marks && !o.all && o.fit.rings == 0 && drawn;
    return;
  }
  if (o.scale == "auto") {
    if (!marks) throw UsageError("--scale auto needs --significance above 0");
    o.auto_scale = true;
    return;
  }
  const char* end = o.scale.data() + o.scale.size();
  const auto [stop, error] = std::from_chars(o.scale.data(), end, o.fit.scale);
  if (error != std::errc() || stop != end || !(o.fit.scale > 0) || !std::isfinite(o.fit.scale))
    throw UsageError("--scale: " + o.scale + " is neither auto nor a positive number");
}

void warn_about_fit(const ridges::FitResult& fit, int degree, Run& run) {
  std::size_t lowered = 0;
  for (const ridges::FitQuality& q : fit.quality) lowered += q.degree < degree ? 1 : 0;
  if (lowered > 0) {
    run.warn(
        fmt::format("{} vertices were fitted with a lower degree (too few or badly placed "
                    "neighbours)",
                    lowered));
  }
}

std::vector<std::string> used_references(const RidgesOptions& o) {
  std::vector<std::string> keys = {"cazals2004ridges", "cazals2003jets", "knoeppel2013globally",
                                   "broennimann2001interval"};
  if (o.fit.smooth > 0) keys.push_back("hildebrandt2005smooth");
  if (!o.common.certificate.empty()) keys.push_back("mcconnell2011certifying");
  keys.push_back("cgal");
  return keys;
}

/// The first option of a group of the help that the command line has, or nothing.
std::string given_of(const CLI::App& app, const std::string& group) {
  for (const CLI::Option* option : app.get_options())
    if (option->get_group() == group && option->count() > 0) return option->get_name();
  return {};
}

/// Exactly one surface, and no option of the other kind. Returns whether it is a smooth one.
bool is_smooth(const CLI::App& app) {
  const auto given = [&](const char* name) { return app.count(name) > 0 ? 1 : 0; };
  if (given("INPUT") + given("--surface") + given("--param") != 1)
    throw UsageError("give exactly one of INPUT, --surface and --param");
  const bool smooth = given("INPUT") == 0;
  const std::string other = given_of(app, smooth ? kMeshGroup : kSmoothGroup);
  if (!other.empty()) {
    throw UsageError(other + " is for " +
                     (smooth ? "meshes" : "smooth surfaces (--surface, --param)"));
  }
  return smooth;
}

/// Of the fits' supports.
double mean_radius(const ridges::FitResult& fit) {
  double sum = 0;
  for (const ridges::CurvatureError& e : fit.errors) sum += e.radius;
  return sum / static_cast<double>(std::max<std::size_t>(fit.errors.size(), 1));
}

/// Calls `show` with what pictures and pages show: the whole graph, or what is significant with the
/// salient lines in full width.
template <class Show>
void draw(const Show& show, const ridges::RidgeGraph& graph, const RidgesRun& result,
          const RidgesOptions& o) {
  io::PictureOptions picture;
  picture.view = o.common.viewpoint.view;
  picture.up = o.common.viewpoint.up;
  picture.order = o.order;
  std::vector<std::string> by = result.filtered_by();
  picture.note = legend_note("subset", by);
  if (!result.shows_salience) return show(graph, picture);
  constexpr double kAll = 0.95;  // of the length: then nothing needs to stand back
  const ridges::SalienceReport& s = *result.salience;
  picture.by_salience = true;
  picture.spur = mean_radius(result.fit);
  picture.full_level = s.length_significant >= kAll * s.length ? 1 : 2;
  ridges::RidgeGraph significant = graph;
  if (ridges::filter(significant, at_level(1)).by_level > 0) by.push_back("significance");
  picture.note = legend_note("subset", by);
  show(significant, picture);
}

io::Scene page_scene(const kernel::TriangleMesh& mesh, const ridges::RidgeGraph& graph,
                     const RidgesRun& result, const RidgesOptions& o) {
  io::Scene scene;
  draw([&](const auto& shown,
           const auto& picture) { scene = io::ridge_scene(mesh, result.fit, shown, picture); },
       graph, result, o);
  scene.data_digest = result.data_digest;
  return scene;
}

/// With a support that is chosen, if that is asked for.
std::pair<ridges::SupportChoice, ridges::FitResult> fitted(Run& run,
                                                           const kernel::TriangleMesh& mesh,
                                                           const RidgesOptions& o) {
  const ridges::Workers* workers = mesh_workers().ridges;
  ridges::FitOptions fitting = o.fit;
  ridges::SupportChoice choice;
  if (o.auto_scale) {
    choice = run.step("scale", "choosing the fits' support", [&] {
      return ridges::choose_support(mesh, o.fit, o.graph, o.salience, workers);
    });
    fitting.min_points = choice.points;
  }
  return {std::move(choice), run.step("fit", "fitting Monge forms", [&] {
            return ridges::fit_monge_forms(mesh, fitting, workers);
          })};
}

Outcome work(Run& run, const RidgesOptions& o) {
  const io::MeshFile file = run.read_mesh();
  const kernel::TriangleMesh& mesh = file.mesh;
  const auto fits = run.with_input([&] { return fitted(run, mesh, o); });
  const ridges::SupportChoice& choice = fits.first;
  const ridges::FitResult& fit = fits.second;
  warn_about_fit(fit, o.fit.degree, run);
  ridges::PredicateReport predicates;
  ridges::ClaimedRidges claimed = run.step("extract", "extracting ridges and umbilics", [&] {
    return ridges::extract_claimed(mesh, fit.forms, o.graph, &predicates, mesh_workers().ridges);
  });
  ridges::RidgeGraph& graph = claimed.graph;
  if (run.wanted("--report")) {
    add_paper_umbilics(run.report(), run.step("paper_umbilics", "searching minima of k1 - k2", [&] {
      return ridges::paper_umbilics(mesh, fit.forms, graph, o.graph.umbilic_patch);
    }));
  }
  std::optional<ridges::SalienceReport> salience;
  if (o.fit.errors) {
    salience = run.step("salience", "measuring salience",
                        [&] { return ridges::mark_salience(mesh, fit, graph, o.salience); });
  }
  const GraphCounts whole = count(graph);
  const ridges::FilterReport dropped =
      run.step("filter", "filtering", [&] { return ridges::filter(graph, o.filter); });
  const RidgesRun result{mesh,
                         file.numbers,
                         fit,
                         graph,
                         o.filter,
                         dropped,
                         predicates,
                         o.order,
                         certify::hex(claimed.data_digest),
                         whole,
                         salience,
                         o.salience,
                         choice,
                         salience && !o.all,
                         run.wanted("--certificate")};
  run.step("write", "writing", [&] {
    run.write("-o", [&](const std::string& path) {
      io::write_ridges(path, mesh, fit, graph, result.data_digest);
    });
    run.write("--picture", [&](const std::string& path) {
      draw([&](const auto& shown,
               const auto& picture) { io::write_picture(path, mesh, shown, picture); },
           graph, result, o);
    });
    run.write_certificate("ridges-mesh", [&](const io::Sink& sink) {
      ridges::hand_on_certificate(
          claimed.envelope, mesh, fit.forms, [&](std::span<const std::uint8_t> piece) {
            sink({reinterpret_cast<const char*>(piece.data()), piece.size()});
          });
    });
  });
  run.show_page([&] { return page_scene(mesh, graph, result, o); });
  fill_report(run.report(), result);
  return {summary_text(result), used_references(o)};
}

int run_ridges(RidgesOptions& o) {
  set_scale(o);
  o.filter.min_level = o.salient ? 2 : o.significant ? 1 : 0;
  return run_command({"ridges", o.common, {".vtp", ".pvtp", ".obj", ".ply"}},
                     [&](Run& run) { return work(run, o); });
}

std::function<int()> add_ridges(CLI::App& app) {
  auto options = std::make_shared<RidgesOptions>();
  add_common_options(app, options->common,
                     fmt::format("mesh ({}), unless --surface or --param is given", kMeshFormats),
                     "ridges and umbilics as polylines (.vtp .pvtp .obj .ply)");
  app.get_option("INPUT")->required(false);
  add_ridges_options(app, *options);
  add_clean_options(app, options->common.clean, true);
  add_smooth_ridges_options(app, options->smooth);
  return [options, &app] {
    if (is_smooth(app)) {
      SmoothRidgesOptions& smooth = options->smooth;
      smooth.implicit = app.count("--surface") > 0;
      options->common.input = smooth.implicit ? smooth.surface : smooth.param;
      return run_smooth_ridges(options->common, smooth);
    }
    return run_ridges(*options);
  };
}

}  // namespace

extern const Command ridges_command;
const Command ridges_command = {
    "ridges",
    "ridges and umbilics of a triangle mesh or of a smooth surface",
    add_ridges,
    {"crest ridges ellipsoid.off -o ellipsoid.vtp --picture ellipsoid.svg",
     "crest ridges ellipsoid.off --page ellipsoid.html --certificate ellipsoid.crest",
     "crest ridges ellipsoid.off --certificate ellipsoid.crest --report ellipsoid.json",
     "crest ridges --surface 'x^2 + y^2/2.25 + z^2/4 - 1' --box '-3,3' -o smooth.vtp "
     "--certificate smooth.crest",
     "crest ridges --param 'u; v; u^2 + 0.5*v^2 + 0.2*u^3 + 0.3*u*v^2 + 0.1*v^3' --domain "
     "'-0.5,0.6,-0.5,0.6' --picture patch.svg"}};

}  // namespace crest::cli
