// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/skeleton_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace crest::cli {
namespace {

using namespace vector_fields;

Json to_json(const Vec2& p) {
  return std::vector<double>(p.begin(), p.end());
}

const char* word(ZeroKind kind) {
  constexpr const char* words[] = {"saddle", "source",       "sink",
                                   "centre", "higher_order", "undecided"};
  return words[static_cast<std::size_t>(kind)];
}
const char* word(ZeroPlace place) {
  constexpr const char* words[] = {"triangle", "edge", "vertex", "line", "region"};
  return words[static_cast<std::size_t>(place)];
}
const char* word(OpenReason reason) {
  constexpr const char* words[] = {"none", "saddle_connection", "vertex_hit", "weak_focus",
                                   "budget"};
  return words[static_cast<std::size_t>(reason)];
}

std::size_t count(const Skeleton& s, ZeroKind kind) {
  return static_cast<std::size_t>(
      std::count_if(s.critical_points.begin(), s.critical_points.end(),
                    [&](const CriticalPoint& c) { return c.kind == kind; }));
}
std::size_t count(const Skeleton& s, EndKind end) {
  return static_cast<std::size_t>(std::count_if(s.separatrices.begin(), s.separatrices.end(),
                                                [&](const Separatrix& l) { return l.end == end; }));
}

Json critical_points(const Skeleton& s, const Importance* importance) {
  Json items = Json::array();
  std::size_t foci = 0;
  for (const CriticalPoint& c : s.critical_points) {
    foci += c.focus ? 1 : 0;
    Json item = {{"kind", word(c.kind)},
                 {"focus", c.focus},
                 {"index", c.index ? Json(*c.index) : Json()},
                 {"where", word(c.where)},
                 {"simplex", c.simplex},
                 {"point", to_json(c.point)}};
    item["jacobian"] = c.jacobian ? Json(*c.jacobian) : Json();
    item["sectors"] = c.sectors ? Json({{"hyperbolic", c.sectors->hyperbolic},
                                        {"elliptic", c.sectors->elliptic},
                                        {"parabolic", c.sectors->parabolic}})
                                : Json();
    if (importance != nullptr) {
      const ZeroWeight& w = importance->zeros[static_cast<std::size_t>(&c - &s.critical_points[0])];
      item["weight"] = w.weight;
      item["partner"] = w.end == PathEnd::partner ? Json(w.partner) : Json();
    }
    items.push_back(std::move(item));
  }
  return {{"count", s.critical_points.size()},
          {"saddles", count(s, ZeroKind::saddle)},
          {"sources", count(s, ZeroKind::source)},
          {"sinks", count(s, ZeroKind::sink)},
          {"centres", count(s, ZeroKind::centre)},
          {"foci", foci},
          {"higher_order", count(s, ZeroKind::higher_order)},
          {"undecided", count(s, ZeroKind::undecided)},
          {"items", items}};
}

Json switch_points(const Skeleton& s) {
  Json items = Json::array();
  std::size_t inside = 0, corners = 0;
  for (const SwitchPoint& p : s.switch_points) {
    inside += p.inside ? 1 : 0;
    corners += p.corner ? 1 : 0;
    const char* words[] = {"outflow", "inflow"};
    items.push_back({{"loop", p.loop},
                     {"point", to_json(p.point)},
                     {"touches", p.inside ? "inside" : "outside"},
                     {"corner", p.corner},
                     {"before", words[p.inflow_after ? 0 : 1]},
                     {"after", words[p.inflow_after ? 1 : 0]}});
  }
  return {{"interior", inside},
          {"exterior", s.switch_points.size() - inside},
          {"corners", corners},
          {"items", items}};
}

Json loops(const Skeleton& s) {
  Json items = Json::array();
  for (const BoundaryLoop& l : s.loops)
    items.push_back({{"winding", l.winding ? Json(*l.winding) : Json()},
                     {"turning", l.turning},
                     {"interior", l.interior},
                     {"exterior", l.exterior},
                     {"inflow", l.inflow},
                     {"outflow", l.outflow},
                     {"tangent", l.tangent},
                     {"zero", l.zero}});
  return items;
}

Json separatrices(const Skeleton& s) {
  Json undecided = Json::array(), bits = Json::object();
  std::size_t connections = 0;
  for (const Separatrix& l : s.separatrices) {
    connections +=
        l.end == EndKind::critical_point && s.critical_points[l.target].kind == ZeroKind::saddle
            ? 1
            : 0;
    if (l.end != EndKind::undecided) continue;
    undecided.push_back({{"from", l.from_switch_point ? "switch_point" : "critical_point"},
                         {"number", l.origin},
                         {"forward", l.forward},
                         {"reason", word(l.reason)},
                         {"point", to_json(l.line.back())},
                         {"width", l.width},
                         {"crossings", l.crossings}});
  }
  for (const auto& [precision, n] : s.counts.bits) bits[std::to_string(precision)] = n;
  return {{"count", s.separatrices.size()},
          {"undecided", undecided_count(s)},
          {"ends",
           {{"critical_point", count(s, EndKind::critical_point)},
            {"boundary", count(s, EndKind::boundary)},
            {"closed_orbit", count(s, EndKind::closed_orbit)},
            {"zero_flow", count(s, EndKind::zero_flow)},
            {"switch_point", count(s, EndKind::switch_point)}}},
          {"crossings", s.counts.crossings},
          {"bits", bits},
          {"saddle_connections", connections},
          {"undecided_items", undecided}};
}

/// Of weights between i/10 and (i + 1)/10, 1 among the last.
template <class Items, class Weight>
Json histogram(const Items& items, Weight&& weight) {
  std::array<std::size_t, 10> bins{};
  for (const auto& x : items) ++bins[static_cast<std::size_t>(std::min(9.0, 10 * weight(x)))];
  return bins;
}

std::size_t count_important(const Importance& w, double threshold) {
  return static_cast<std::size_t>(std::count_if(
      w.zeros.begin(), w.zeros.end(), [&](const ZeroWeight& z) { return z.weight >= threshold; }));
}

}  // namespace

Json importance_in_words(const Importance& w, double threshold, Laplacian laplacian) {
  return {{"threshold", threshold},
          {"laplacian", laplacian == Laplacian::uniform ? "uniform" : "cotan"},
          {"pairs", w.pairs},
          {"unpaired", w.staying + w.open},
          {"undecided", w.open},
          {"important", count_important(w, threshold)},
          {"histograms",
           {{"critical_points_first", histogram(w.zeros, [](const auto& z) { return z.first; })},
            {"critical_points", histogram(w.zeros, [](const auto& z) { return z.weight; })},
            {"separatrices", histogram(w.separatrices, [](double x) { return x; })}}},
          {"certified", false}};
}

std::string importance_summary(const Importance& w, double threshold) {
  return fmt::format(
      "{} pairs of critical points, {} unpaired; {} weigh {} or more; weights are not certified\n",
      w.pairs, w.staying + w.open, count_important(w, threshold), threshold);
}

std::size_t undecided_count(const Skeleton& skeleton) {
  return count(skeleton, EndKind::undecided);
}

Json skeleton_in_words(const PlanarField& field, const Skeleton& s, const Importance* importance) {
  Json report;
  report["vertices"] = field.points.size();
  report["triangles"] = field.triangles.size();
  report["components"] = s.components;
  report["euler_characteristic"] = s.euler_characteristic;
  report["zero_flow"] = {
      {"triangles", s.zero_triangles}, {"regions", s.zero_regions}, {"edges", s.zero_edges}};
  report["critical_points"] = critical_points(s, importance);
  report["boundary_switch_points"] = switch_points(s);
  report["boundary_loops"] = loops(s);
  report["index_sum"] = s.index_sum;
  report["winding_sum"] = s.winding_sum;
  report["separatrices"] = separatrices(s);
  Json orbits = Json::array();
  for (const ClosedOrbit& o : s.orbits)
    orbits.push_back({{"attracting", o.attracting}, {"point", to_json(o.line.front())}});
  report["witnesses"] = {{"count", s.witnesses.size()}};
  report["closed_orbits"] = {{"count", s.orbits.size()}, {"items", orbits}};
  return report;
}

std::string skeleton_summary(const Skeleton& s) {
  std::size_t inside = 0;
  for (const SwitchPoint& p : s.switch_points) inside += p.inside ? 1 : 0;
  return fmt::format(
      "{} critical points: {} saddles, {} sources, {} sinks, {} others; indices sum to {}, "
      "windings to {}\n"
      "{} switch points, {} of them touched from inside, on {} boundary loops\n"
      "{} separatrices: {} end at critical points, {} at the boundary, {} in closed orbits, {} at "
      "walls; {} are undecided\n",
      s.critical_points.size(), count(s, ZeroKind::saddle), count(s, ZeroKind::source),
      count(s, ZeroKind::sink),
      count(s, ZeroKind::centre) + count(s, ZeroKind::higher_order) + count(s, ZeroKind::undecided),
      s.index_sum, s.winding_sum, s.switch_points.size(), inside, s.loops.size(),
      s.separatrices.size(), count(s, EndKind::critical_point), count(s, EndKind::boundary),
      count(s, EndKind::closed_orbit), count(s, EndKind::zero_flow), undecided_count(s));
}

}  // namespace crest::cli
