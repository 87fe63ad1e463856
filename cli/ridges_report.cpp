// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ridges_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace crest::cli {
namespace {

using ridges::Colour;
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
                     {"face", run.numbers.faces[umbilic.face]},
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

}  // namespace

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
                       {"by_crest", run.dropped.by_crest}};
  report["open_ends"] = ridges::open_ends(run.graph);
  report["conflict_triangles"] = run.graph.conflict_triangles;
  report["ambiguous_edges"] = run.graph.ambiguous_edges;
  report["frames"] = {{"n_against_faces", run.graph.against_faces},
                      {"k1_equals_k2", run.graph.equal_curvatures},
                      {"d1_parallel_to_n", run.graph.parallel_frames}};
  report["zero_extremalities"] = {{"b0", run.graph.zero_extremalities[0]},
                                  {"b3", run.graph.zero_extremalities[1]}};
  report["data_digest"] = run.data_digest;
}

void add_paper_umbilics(Report& report, const ridges::PaperUmbilics& umbilics) {
  report["paper_umbilics"] = {{"candidates", umbilics.candidates},
                              {"plus", umbilics.plus},
                              {"minus", umbilics.minus},
                              {"other", umbilics.other}};
}

std::string summary_text(const RidgesRun& run) {
  const auto count_kind = [&](ridges::UmbilicKind kind) {
    return std::count_if(run.graph.umbilics.begin(), run.graph.umbilics.end(),
                         [&](const ridges::Umbilic& u) { return u.kind == kind; });
  };
  std::string text =
      fmt::format("mesh: {} vertices, {} faces, Euler characteristic {}, {} boundary loops\n",
                  run.mesh.vertex_count(), run.mesh.face_count(), run.mesh.euler_characteristic(),
                  run.mesh.boundary_loops());
  text +=
      fmt::format("umbilics: {} patches ({} 1-ridge, {} 3-ridge), index sum {}\n",
                  run.graph.umbilics.size(), count_kind(ridges::UmbilicKind::one_ridge),
                  count_kind(ridges::UmbilicKind::three_ridge), 0.5 * run.graph.twice_index_sum);
  for (const Colour colour : {Colour::blue, Colour::red}) {
    const ColourSummary s = summarise(run.graph, colour, run.order);
    text += fmt::format(
        "{}: {} loops, {} segments, length {:.6g} ({:.6g} elliptic, {:.6g} hyperbolic)\n",
        colour == Colour::blue ? "blue" : "red", s.loops, s.segments, s.length, s.elliptic_length,
        s.hyperbolic_length);
  }
  const auto dropped = run.dropped.by_sharpness + run.dropped.by_strength + run.dropped.by_length +
                       run.dropped.by_crest;
  if (dropped > 0) text += fmt::format("dropped by the filters: {} ridges\n", dropped);
  return text;
}

}  // namespace crest::cli
