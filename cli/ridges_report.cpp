// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ridges_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace crest::cli {
namespace {

using ridges::Colour;
using ridges::Index;
using ridges::RidgeType;

double distance(const kernel::Vec3& a, const kernel::Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Lengths by the third-order rule: it types whole segments.
void add_third_order_lengths(const ridges::Ridge& ridge, ColourSummary& summary) {
  const auto& crossings = ridge.crossings;
  for (std::size_t i = 0; i < ridge.segment_count(); ++i) {
    const double length = distance(crossings[i].point, crossings[(i + 1) % crossings.size()].point);
    if (ridge.third_order[i] == RidgeType::elliptic) summary.elliptic_length += length;
    if (ridge.third_order[i] == RidgeType::hyperbolic) summary.hyperbolic_length += length;
  }
}

Json colour_json(const RidgesRun& run, Colour colour) {
  return to_json(summarise(run.graph, colour, run.order));
}

const char* kind_name(ridges::UmbilicKind kind) {
  switch (kind) {
    case ridges::UmbilicKind::one_ridge:
      return "1-ridge";
    case ridges::UmbilicKind::three_ridge:
      return "3-ridge";
    default:
      return "degenerate";
  }
}

Json umbilics_json(const RidgesRun& run) {
  const ridges::RidgeGraph& graph = run.graph;
  Json items = Json::array();
  for (const ridges::Umbilic& umbilic : graph.umbilics) {
    items.push_back({{"index", 0.5 * umbilic.twice_index},
                     {"kind", kind_name(umbilic.kind)},
                     {"coherent", umbilic.coherent},
                     {"face", run.numbers.face(umbilic.face)},
                     {"point", umbilic.point}});
  }
  return {{"count", graph.umbilics.size()},
          {"index_sum", 0.5 * graph.twice_index_sum},
          {"items", std::move(items)}};
}

Json fit_json(const ridges::FitResult& fit) {
  std::array<std::size_t, 5> vertices{};
  double worst = 0;
  for (const ridges::FitQuality& q : fit.quality) {
    ++vertices[std::min<std::size_t>(q.degree, 4)];
    if (q.degree > 0) worst = std::max(worst, q.condition);
  }
  Json degrees = Json::object();
  for (const std::size_t degree : {4u, 3u, 2u, 1u, 0u})
    if (vertices[degree] > 0) degrees[std::to_string(degree)] = vertices[degree];
  return {{"vertices_by_degree", std::move(degrees)}, {"worst_condition", worst}};
}

Json salience_json(const RidgesRun& run) {
  const ridges::SalienceReport& s = *run.salience;
  Json trials = Json::array(), regions = Json::array();
  for (const ridges::SupportTrial& t : run.choice.trials) {
    trials.push_back({{"points", t.points},
                      {"length", t.length},
                      {"significant_length", t.significant_length},
                      {"J", t.j}});
  }
  for (const ridges::UmbilicRegion& r : s.regions) {
    regions.push_back(
        {{"twice_index", r.twice_index}, {"faces", r.faces}, {"umbilics", r.umbilics.size()}});
  }
  return {{"z", run.salience_options.z},
          {"min_weight", run.salience_options.min_weight},
          {"support_points", run.fit.points},
          {"support_choice", std::move(trials)},
          {"ridges_significant", s.significant},
          {"ridges_salient", s.salient},
          {"length", s.length},
          {"length_significant", s.length_significant},
          {"length_salient", s.length_salient},
          {"dropped",
           {{"insignificant", s.insignificant},
            {"short", s.short_runs},
            {"not_crest", s.not_crest},
            {"light", s.light}}},
          {"gaps_closed", s.gaps_closed},
          {"undetermined_crossings", s.undetermined},
          {"umbilic_regions", std::move(regions)},
          {"index_sum", 0.5 * run.graph.twice_index_sum},
          {"degenerate", s.degenerate()}};
}

Json counts_json(const GraphCounts& counts) {
  const auto colour = [&](std::size_t c) {
    return Json{{"loops", counts.loops[c]}, {"segments", counts.segments[c]}};
  };
  return {{"blue", colour(0)}, {"red", colour(1)}, {"umbilics", counts.umbilics}};
}

std::string colour_line(const std::string& what, const ColourSummary& s) {
  return fmt::format(
      "{}: {} loops, {} segments, length {:.6g} ({:.6g} elliptic, {:.6g} hyperbolic)\n", what,
      s.loops, s.segments, s.length, s.elliptic_length, s.hyperbolic_length);
}

/// Umbilics and lines of the whole graph.
std::string graph_lines(const RidgesRun& run) {
  const auto count_kind = [&](ridges::UmbilicKind kind) {
    return std::count_if(run.graph.umbilics.begin(), run.graph.umbilics.end(),
                         [&](const ridges::Umbilic& u) { return u.kind == kind; });
  };
  return fmt::format("umbilics: {} patches ({} 1-ridge, {} 3-ridge), index sum {}\n",
                     run.graph.umbilics.size(), count_kind(ridges::UmbilicKind::one_ridge),
                     count_kind(ridges::UmbilicKind::three_ridge),
                     0.5 * run.graph.twice_index_sum) +
         colour_line("blue", summarise(run.graph, Colour::blue, run.order)) +
         colour_line("red", summarise(run.graph, Colour::red, run.order));
}

/// Significant umbilics and regions, salient and significant lines.
std::string salience_lines(const RidgesRun& run) {
  const ridges::SalienceReport& s = *run.salience;
  const auto plus = std::count_if(s.regions.begin(), s.regions.end(), [](const auto& r) {
    return r.is_umbilic() && r.twice_index > 0;
  });
  const auto minus = std::count_if(s.regions.begin(), s.regions.end(), [](const auto& r) {
    return r.is_umbilic() && r.twice_index < 0;
  });
  const auto others = std::count_if(s.regions.begin(), s.regions.end(), [](const auto& r) {
    return !r.is_umbilic() && r.twice_index != 0;
  });
  std::string text = fmt::format(
      "significant umbilics: {} of index +1/2, {} of -1/2; other regions: {}; index sum {}\n", plus,
      minus, others, 0.5 * run.graph.twice_index_sum);
  if (s.degenerate()) {
    text += "nothing significant: k1, k2 constant along their lines within the error of the fit\n";
  } else {
    for (const int level : {2, 1}) {
      ridges::RidgeGraph kept = run.graph;
      ridges::filter(kept, at_level(level));
      for (const Colour colour : {Colour::blue, Colour::red}) {
        const std::string name = colour == Colour::blue ? "blue" : "red";
        text += colour_line(name + (level == 2 ? ", salient" : ", significant"),
                            summarise(kept, colour, run.order));
      }
    }
  }
  text += fmt::format("whole graph: {} ridges, {} umbilics (--all counts and draws it)\n",
                      run.whole.ridges(), run.whole.umbilics);
  return text;
}

}  // namespace

GraphCounts count(const ridges::RidgeGraph& graph) {
  GraphCounts counts;
  for (const ridges::Ridge& r : graph.ridges)
    ++(r.loop ? counts.loops : counts.segments)[static_cast<std::size_t>(r.colour)];
  counts.umbilics = static_cast<ridges::Index>(graph.umbilics.size());
  return counts;
}

ridges::FilterOptions at_level(int level) {
  ridges::FilterOptions options;
  options.min_level = level;
  return options;
}

std::vector<std::string> RidgesRun::filtered_by() const {
  const bool cut = ridges::open_ends(graph) > 0;
  std::vector<std::string> by;
  if (dropped.by_sharpness > 0) by.push_back("--min-sharpness");
  if (dropped.by_strength > 0) by.push_back("--min-strength");
  if (dropped.by_length > 0) by.push_back("--min-length");
  if (dropped.by_crest > 0 || (cut && filter.crest_only)) by.push_back("--crest-only");
  if (dropped.by_level > 0 || (cut && filter.min_level > 0))
    by.push_back(filter.min_level > 1 ? "--salient" : "--significant");
  return by;
}

ColourSummary summarise(const ridges::RidgeGraph& graph, Colour colour, int order) {
  ColourSummary summary;
  for (const ridges::Ridge& ridge : graph.ridges) {
    if (ridge.colour != colour) continue;
    ++(ridge.loop ? summary.loops : summary.segments);
    summary.length += ridge.length;
    if (order == 3) {
      add_third_order_lengths(ridge, summary);
    } else {
      summary.elliptic_length += ridge.elliptic_length;
      summary.hyperbolic_length += ridge.hyperbolic_length;
    }
  }
  return summary;
}

void fill_report(Report& report, const RidgesRun& run) {
  for (const auto& [name, counts] : run.predicates) {
    report["predicates"][name] = {{"calls", counts.calls},
                                  {"interval", counts.interval},
                                  {"exact", counts.exact},
                                  {"symbolic", counts.symbolic}};
  }
  report["vertices"] = run.mesh.vertex_count();
  report["faces"] = run.mesh.face_count();
  report["euler_characteristic"] = run.mesh.euler_characteristic();
  report["boundary_loops"] = run.mesh.boundary_loops();
  report["components"] = run.mesh.components();
  report["scale"] = run.fit.scale;
  report["fit"] = fit_json(run.fit);
  report["order"] = run.order;
  report["umbilics"] = umbilics_json(run);
  report["ridges"] = {{"blue", colour_json(run, Colour::blue)},
                      {"red", colour_json(run, Colour::red)}};
  report["dropped"] = {{"by_sharpness", run.dropped.by_sharpness},
                       {"by_strength", run.dropped.by_strength},
                       {"by_length", run.dropped.by_length},
                       {"by_crest", run.dropped.by_crest},
                       {"by_level", run.dropped.by_level}};
  report["open_ends"] = ridges::open_ends(run.graph);
  report["conflict_triangles"] = run.graph.conflict_triangles;
  report["ambiguous_edges"] = run.graph.ambiguous_edges;
  report["frames"] = {{"n_against_faces", run.graph.against_faces},
                      {"k1_equals_k2", run.graph.equal_curvatures},
                      {"d1_parallel_to_n", run.graph.parallel_frames}};
  report["zero_extremalities"] = {{"b0", run.graph.zero_extremalities[0]},
                                  {"b3", run.graph.zero_extremalities[1]}};
  if (run.salience) report["salience"] = salience_json(run);
  add_written(report, run.filtered_by(), counts_json(run.whole));
  report["data_digest"] = run.data_digest;
}

void add_paper_umbilics(Report& report, const ridges::PaperUmbilics& umbilics) {
  report["paper_umbilics"] = {{"candidates", umbilics.candidates},
                              {"plus", umbilics.plus},
                              {"minus", umbilics.minus},
                              {"other", umbilics.other}};
}

std::string summary_text(const RidgesRun& run) {
  std::string text =
      fmt::format("mesh: {} vertices, {} faces, Euler characteristic {}, {} boundary loops\n",
                  run.mesh.vertex_count(), run.mesh.face_count(), run.mesh.euler_characteristic(),
                  run.mesh.boundary_loops());
  if (!run.choice.trials.empty())
    text += fmt::format("support of the fits: {} points, chosen\n", run.choice.points);
  text += run.shows_salience ? salience_lines(run) : graph_lines(run);
  const std::string share =
      fmt::format("{}{} of {} ridges", count(run.graph).ridges(),
                  ridges::open_ends(run.graph) > 0 ? " pieces" : "", run.whole.ridges());
  return text + written_line({"subset", whole("graph", run.certifies), share, run.filtered_by()});
}

}  // namespace crest::cli
