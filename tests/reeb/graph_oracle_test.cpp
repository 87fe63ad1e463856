// SPDX-License-Identifier: GPL-3.0-or-later
// The Reeb graph against brute force, on surfaces of every topology.
#include <catch2/catch.hpp>

#include "algorithms/reeb/segmentation.hpp"
#include "algorithms/reeb/slab_oracle.hpp"
#include "tests/reeb/graph_cases.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {
namespace {

using reeb::named;
using reeb::OracleArc;
using reeb::OracleGraph;
using reeb::slab_oracle;

constexpr int kSeeds = 40;

void check_by_slabs(const Surface& s, const std::vector<double>& values) {
  const OrderedCase c(s, values);
  const OracleGraph truth = slab_oracle(c.complex());
  const reeb::GraphAndArcs labelled = reeb::reeb_graph_and_arcs(c.complex());
  const reeb::ReebGraph& graph = labelled.graph;
  const OracleGraph ours = named(c.complex(), graph, labelled.arc_of_vertex);
  CHECK(ours.nodes == truth.nodes);
  std::vector<OracleArc> arcs = ours.arcs;
  CHECK(std::is_sorted(arcs.begin(), arcs.end()));
  CHECK(arcs == truth.arcs);
  CHECK(ours.arc_of_vertex == truth.arc_of_vertex);
  const reeb::Segmentation parts = reeb::segmentation(c.complex(), graph);
  CHECK(parts.arc_of_vertex == labelled.arc_of_vertex);
  std::vector<std::array<OracleArc, 3>> triangles;
  for (const auto& t : parts.triangles) {
    const auto name = [&](kernel::Index a) { return named(c.complex(), graph, a); };
    triangles.push_back({name(t.lowest), name(t.middle), name(t.highest)});
  }
  CHECK(triangles == truth.arcs_of_triangle);
  CHECK(ours.components == truth.components);
  for (const auto& arc : graph.arcs) CHECK(arc.open_below == arc.open_above);
}

TEST_CASE("Reeb graphs equal the brute-force ones, noise") {
  const auto row = GENERATE(range(0, static_cast<int>(surface_rows().size())));
  const SurfaceRow& r = surface_rows()[static_cast<std::size_t>(row)];
  const Surface s = r.make();
  for (std::uint64_t seed = 0; seed < scaled(kSeeds); ++seed) {
    INFO(r.name << ", seed " << seed);
    check_by_slabs(s, noise_values(s, kSeed + seed));
  }
}

TEST_CASE("Reeb graphs equal the brute-force ones, smooth and quantised") {
  const auto row = GENERATE(range(0, static_cast<int>(surface_rows().size())));
  const SurfaceRow& r = surface_rows()[static_cast<std::size_t>(row)];
  const Surface s = r.make();
  for (std::uint64_t seed = 0; seed < scaled(kSeeds / 4); ++seed) {
    INFO(r.name << ", seed " << seed);
    check_by_slabs(s, smooth_values(s, kSeed + seed, 6));
    check_by_slabs(s, quantised(smooth_values(s, kSeed + seed, 6), 1));
    check_by_slabs(s, quantised(noise_values(s, kSeed + seed), 0.25));
  }
}

TEST_CASE("Reeb graphs equal the brute-force ones, constant functions under any numbering") {
  const auto row = GENERATE(range(0, static_cast<int>(surface_rows().size())));
  const SurfaceRow& r = surface_rows()[static_cast<std::size_t>(row)];
  const Surface s = r.make();
  INFO(r.name);
  check_by_slabs(s, std::vector<double>(s.points.size(), 0.0));
  std::vector<double> descending;
  for (std::size_t v = 0; v < s.points.size(); ++v) descending.push_back(-double(v));
  check_by_slabs(s, descending);
}

TEST_CASE("Reeb graphs of tiny complexes, all orders") {
  for (const Surface& s : tiny_surfaces()) {
    std::vector<double> values(s.points.size());
    std::iota(values.begin(), values.end(), 0.0);
    do check_by_slabs(s, values);
    while (std::next_permutation(values.begin(), values.end()));
  }
}

TEST_CASE("Reeb graphs of wheels: multiple saddles of any order, large stars") {
  Random random(kSeed);
  for (std::uint64_t trial = 0; trial < scaled(200); ++trial) {
    const unsigned n = 3 + static_cast<unsigned>(random() % 40);
    for (const bool closed : {true, false}) {
      Surface s = wheel(n, closed);
      if (trial % 2 == 1) s = turned_at_random(std::move(s), random);
      std::vector<double> values = noise_values(s, random());
      values[0] = 0.5;
      INFO(n << " spokes, trial " << trial);
      check_by_slabs(s, values);
    }
  }
}

TEST_CASE("Reeb graphs do not depend on the triangles' order or direction") {
  Random random(kSeed);
  for (const SurfaceRow& r : surface_rows()) {
    const Surface s = r.make();
    for (std::uint64_t trial = 0; trial < scaled(5); ++trial) {
      INFO(r.name << ", trial " << trial);
      const std::vector<double> values = noise_values(s, random());
      const OrderedCase c(s, values), d(turned_at_random(s, random), values);
      const reeb::GraphAndArcs g = reeb::reeb_graph_and_arcs(c.complex());
      const reeb::GraphAndArcs h = reeb::reeb_graph_and_arcs(d.complex());
      CHECK(same_graph(g.graph, h.graph));
      CHECK(same_graph(g.graph, reeb::reeb_graph(c.complex())));
      CHECK(g.arc_of_vertex == h.arc_of_vertex);
    }
  }
}

}  // namespace
}  // namespace crest::tests
