// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 3 under another numbering of the vertices: what SPEC.md says depends on the function alone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>
#include <map>
#include <numeric>
#include <tuple>

#include "certify/verify.hpp"
#include "tests/certify/reeb_samples.hpp"
#include "tests/certify/reference_reeb.hpp"
#include "tests/support/failures.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using u32 = std::uint32_t;
using Rational = ReferenceReeb::Rational;

/// Vertex v becomes number[v]; the function is the same.
ReebCertificate renumbered(const ReebCertificate& data, const std::vector<u32>& number) {
  ReebCertificate out;
  out.positions.resize(data.positions.size());
  out.values.resize(data.values.size());
  for (std::size_t v = 0; v < number.size(); ++v) out.values[number[v]] = data.values[v];
  std::map<std::pair<u32, u32>, double> before, after;
  for (const auto& f : data.faces) {
    out.faces.push_back({number[f[0]], number[f[1]], number[f[2]]});
    for (std::size_t i = 0; i < 3; ++i) before[std::minmax(f[i], f[(i + 1) % 3])];
  }
  std::size_t e = 0;
  for (auto& [edge, m] : before)
    if (!data.edge_values.empty()) {
      m = data.edge_values[e++];
      after[std::minmax(number[edge.first], number[edge.second])] = m;
    }
  for (const auto& [edge, m] : after) out.edge_values.push_back(m);
  return out;
}

/// The contracted graph without its nodes inside arcs: nodes by value and number of arcs below and
/// above, arcs by the values of their ends. Also how many classes there were in all.
struct Contracted {
  std::vector<std::tuple<Rational, std::size_t, std::size_t>> nodes;
  std::vector<std::pair<Rational, Rational>> arcs;
  std::size_t classes = 0, inside = 0;
};
Contracted contracted(const ReferenceReeb& graph) {
  const std::size_t n = graph.critical().size();
  std::vector<u32> name(n);
  std::iota(name.begin(), name.end(), u32{0});
  const auto value = [&](u32 i) { return graph.value(graph.critical()[i]); };
  for (std::size_t pass = 0; pass < n; ++pass)
    for (const auto& arc : graph.arcs())
      if (value(arc.lower) == value(arc.upper))
        name[arc.lower] = name[arc.upper] = std::min(name[arc.lower], name[arc.upper]);
  std::vector<std::vector<u32>> below(n), above(n);  // other ends
  for (const auto& arc : graph.arcs()) {
    if (value(arc.lower) == value(arc.upper)) continue;
    above[name[arc.lower]].push_back(name[arc.upper]);
    below[name[arc.upper]].push_back(name[arc.lower]);
  }
  const auto is_inside = [&](u32 i) { return below[i].size() == 1 && above[i].size() == 1; };
  Contracted out;
  for (u32 i = 0; i < n; ++i) {
    if (name[i] != i) continue;
    ++out.classes;
    out.inside += is_inside(i);
    if (is_inside(i)) continue;
    out.nodes.emplace_back(value(i), below[i].size(), above[i].size());
    for (u32 to : above[i]) {
      while (is_inside(to)) to = above[to].front();
      out.arcs.emplace_back(value(i), value(to));
    }
  }
  std::sort(out.nodes.begin(), out.nodes.end());
  std::sort(out.arcs.begin(), out.arcs.end());
  return out;
}

}  // namespace

TEST_CASE("the contracted graph does not depend on the vertices' numbers") {
  Random random(kSeed + 31);
  std::uint64_t graphs = 0, other_nodes = 0, other_classes = 0;
  for (std::uint64_t round = 0; round < scaled(3); ++round)
    for (const ReebSurface& surface : reeb_surfaces(random))
      for (const int degree : {1, 2})
        for (const Values kind : {Values::small, Values::constant, Values::mixed}) {
          const ReebCertificate data = reeb_data(surface, degree, kind, random);
          const ReferenceReeb first(data);
          const Contracted truth = contracted(first);
          std::vector<u32> number(surface.vertices);
          std::iota(number.begin(), number.end(), u32{0});
          for (int again = 0; again < 3; ++again) {
            std::shuffle(number.begin(), number.end(), random);
            const ReferenceReeb other(renumbered(data, number));
            const ReebCertificate c = other.certificate(random);
            const OnFailure shown([&] {
              return surface.name + ", degree " + std::to_string(degree) + ", kind " +
                     std::to_string(static_cast<int>(kind)) + ", round " + std::to_string(round);
            });
            const Verdict verdict = verify(encode(c));
            REQUIRE(verdict.accepted);
            const Contracted found = contracted(other);
            const std::string words = " arcs, " + std::to_string(found.inside) +
                                      " nodes with one arc below and one above";
            CHECK((verdict.lines.back().find(words) != std::string::npos) == (found.inside > 0));
            CHECK(found.nodes == truth.nodes);
            CHECK(found.arcs == truth.arcs);
            CHECK(c.contracted_nodes == found.classes);
            CHECK(c.arcs.size() - c.tied_arcs == found.arcs.size() + found.inside);
            ++graphs;
            other_nodes += other.critical().size() != first.critical().size();
            other_classes += found.classes != truth.classes;
          }
        }
  std::cout << "Reeb graphs renumbered: " << graphs << ", with another number of nodes "
            << other_nodes << ", of classes " << other_classes << "\n";
  CHECK(other_nodes > graphs / 4);
}
