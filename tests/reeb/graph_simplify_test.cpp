// SPDX-License-Identifier: GPL-3.0-or-later
// Simplified graphs and branches against a simplification that starts anew at every step.
#include <catch2/catch.hpp>
#include <limits>
#include <set>

#include "algorithms/reeb/simplify.hpp"
#include "tests/reeb/graph_cases.hpp"
#include "tests/support/environment.hpp"

namespace crest::tests {
namespace {

using kernel::Index;
using kernel::kNone;
constexpr double kEnd = std::numeric_limits<double>::infinity();

struct SlowArc {
  Index lower, upper, strand;
  std::uint8_t open_below, open_above;
  Index number;  ///< of its lowest part
  auto operator<=>(const SlowArc&) const = default;
};

/// Vertices of the ends, strand and openness of the arcs that are left.
std::vector<SlowArc> simplified_slowly(const reeb::ReebGraph& graph,
                                       const std::vector<double>& values, double p, bool loops) {
  std::vector<SlowArc> arcs;
  for (Index i = 0; i < graph.arcs.size(); ++i) {
    const auto& a = graph.arcs[i];
    arcs.push_back({a.lower, a.upper, a.strand, a.open_below, a.open_above, i});
  }
  const auto above = [&](Index n) {
    return std::count_if(arcs.begin(), arcs.end(), [&](const auto& a) { return a.lower == n; });
  };
  const auto below = [&](Index n) {
    return std::count_if(arcs.begin(), arcs.end(), [&](const auto& a) { return a.upper == n; });
  };
  const auto drop = [&](Index number) {
    std::erase_if(arcs, [&](const auto& a) { return a.number == number; });
  };
  for (;;) {
    bool changed = false;
    for (Index n = 0; n < graph.nodes.size() && !changed; ++n) {
      if (above(n) != 1 || below(n) != 1) continue;
      const auto low =
          std::find_if(arcs.begin(), arcs.end(), [&](const auto& a) { return a.upper == n; });
      const auto high =
          *std::find_if(arcs.begin(), arcs.end(), [&](const auto& a) { return a.lower == n; });
      low->upper = high.upper;
      low->open_above = high.open_above;
      drop(high.number);
      changed = true;
    }
    if (changed) continue;
    std::tuple<double, Index, Index> best{kEnd, kNone, kNone};
    for (const auto& a : arcs) {
      const bool leaf = (below(a.lower) == 0 && above(a.lower) == 1 && below(a.upper) > 1) ||
                        (above(a.upper) == 0 && below(a.upper) == 1 && above(a.lower) > 1);
      const bool twin = loops && std::any_of(arcs.begin(), arcs.end(), [&](const auto& b) {
                          return a.lower == b.lower && a.upper == b.upper && b.number != a.number;
                        });
      if (!leaf && !twin) continue;
      const double rise = values[graph.nodes[a.upper].vertex] - values[graph.nodes[a.lower].vertex];
      if (rise <= p) best = std::min(best, {rise, a.upper - a.lower, a.number});
    }
    if (std::get<2>(best) == kNone) break;
    drop(std::get<2>(best));
  }
  for (auto& a : arcs) {
    a.lower = graph.nodes[a.lower].vertex;
    a.upper = graph.nodes[a.upper].vertex;
    a.number = 0;
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

std::vector<SlowArc> by_vertex(const reeb::ReebGraph& graph) {
  std::vector<SlowArc> arcs;
  for (const auto& a : graph.arcs) {
    arcs.push_back({graph.nodes[a.lower].vertex, graph.nodes[a.upper].vertex, a.strand,
                    a.open_below, a.open_above, 0});
  }
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

void check_simplified(const reeb::ReebGraph& graph, const std::vector<double>& values, double p,
                      bool loops) {
  const reeb::CoarserGraph coarse = reeb::simplify(graph, values, p, loops);
  if (loops) {
    // Which of two arcs with the same ends goes is free as far as ends are concerned.
    const auto ends = [](std::vector<SlowArc> arcs) {
      for (auto& a : arcs) a.strand = a.open_below = a.open_above = 0;
      std::sort(arcs.begin(), arcs.end());
      return arcs;
    };
    CHECK(ends(by_vertex(coarse.graph)) == ends(simplified_slowly(graph, values, p, true)));
  } else {
    CHECK(by_vertex(coarse.graph) == simplified_slowly(graph, values, p, false));
    CHECK(coarse.graph.loops() == graph.loops());
  }
  CHECK(coarse.graph.components == graph.components);
  REQUIRE(coarse.arc_of_arc.size() == graph.arcs.size());
  std::set<Index> used(coarse.arc_of_arc.begin(), coarse.arc_of_arc.end());
  CHECK(used.size() == coarse.graph.arcs.size());
  CHECK(*used.rbegin() + 1 == coarse.graph.arcs.size());
}

void check_all_simplified(const Surface& s, const std::vector<double>& values) {
  const OrderedCase c(s, values);
  const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
  for (const double p : {-1.0, 0.0, 0.05, 0.3, 1.0, kEnd})
    for (const bool loops : {false, true}) check_simplified(graph, values, p, loops);
  // Branches: every arc once, paths upwards, leaf branches as simplify takes them.
  const auto branches = reeb::branch_decomposition(graph, values);
  std::vector<int> uses(graph.arcs.size(), 0);
  std::vector<SlowArc> left;
  for (const auto& b : branches) {
    REQUIRE(!b.arcs.empty());
    Index at = b.lower;
    for (const Index a : b.arcs) {
      CHECK(graph.arcs[a].lower == at);
      at = graph.arcs[a].upper;
      ++uses[a];
    }
    CHECK(at == b.upper);
    const auto &lower = graph.nodes[b.lower], &upper = graph.nodes[b.upper];
    CHECK(b.persistence == values[upper.vertex] - values[lower.vertex]);
    if (b.kind == reeb::PairKind::minimum) CHECK(lower.kind == reeb::NodeKind::minimum);
    if (b.kind == reeb::PairKind::maximum) CHECK(upper.kind == reeb::NodeKind::maximum);
    if (b.kind == reeb::PairKind::component || b.kind == reeb::PairKind::loop) {
      left.push_back({lower.vertex, upper.vertex, graph.arcs[b.arcs.front()].strand,
                      graph.arcs[b.arcs.front()].open_below, graph.arcs[b.arcs.back()].open_above,
                      0});
    }
  }
  CHECK(std::all_of(uses.begin(), uses.end(), [](int n) { return n == 1; }));
  std::sort(left.begin(), left.end());
  CHECK(left == simplified_slowly(graph, values, kEnd, false));
  if (graph.loops() == 0) CHECK(left.size() == graph.components);
}

TEST_CASE("Simplified graphs and branches equal those made step by step") {
  for (const SurfaceRow& row : surface_rows()) {
    const Surface s = row.make();
    for (std::uint64_t seed = 0; seed < scaled(3); ++seed) {
      INFO(row.name << ", seed " << seed);
      check_all_simplified(s, smooth_values(s, kSeed + seed, 12));
      check_all_simplified(s, quantised(smooth_values(s, kSeed + seed), 1));
    }
  }
  for (std::uint64_t seed = 0; seed < scaled(20); ++seed) {
    INFO("noise, seed " << seed);
    const Surface small = seed % 2 ? torus_surface(8, 9) : strip(9, 8, Sides::open, Sides::open);
    check_all_simplified(small, noise_values(small, kSeed + seed));
  }
}

TEST_CASE("A torus without its small features is a loop between a minimum and a maximum") {
  const Surface s = torus_surface(30, 20);
  std::vector<double> values;
  const std::vector<double> noise = noise_values(s, kSeed);
  for (std::size_t v = 0; v < s.points.size(); ++v)
    values.push_back(s.points[v][0] + 0.4 * noise[v]);
  const OrderedCase c(s, values);
  const reeb::ReebGraph graph = reeb::reeb_graph(c.complex());
  CHECK(graph.nodes.size() > 20);
  const auto coarse = reeb::simplify(graph, values, 0.5).graph;
  CHECK(coarse.nodes.size() == 4);
  CHECK(coarse.arcs.size() == 4);
  CHECK(coarse.loops() == 1);
  const auto line = reeb::simplify(graph, values, 10, true).graph;
  CHECK(line.nodes.size() == 2);
  CHECK(line.arcs.size() == 1);
}

}  // namespace
}  // namespace crest::tests
