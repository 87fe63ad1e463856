// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/second/graph.hpp"

namespace crest::recheck {
namespace {

void demand_count(const char* what, std::uint64_t stated, std::uint64_t found) {
  if (stated != found)
    throw Rejected("there are " + std::to_string(found) + " " + what + ", not " +
                   std::to_string(stated));
}

/// Loops and paths: crossed edges joined through faces; a path has two ends, at patches or
/// boundary.
std::array<std::uint64_t, 2> curves(const Problem& problem, const std::vector<bool>& crossed) {
  const Complex& complex = problem.complex;
  UnionFind joined(complex.edges.size());
  for (Index f = 0; f < problem.certificate.faces.size(); ++f) {
    if (complex.patch_of[f] != Complex::kNone) continue;
    Index before = Complex::kNone, number = 0;
    for (const Index e : complex.edge_of[f]) {
      if (!crossed[e]) continue;
      ++number;
      if (before != Complex::kNone) joined.join(before, e);
      before = e;
    }
    if (number != 0 && number != 2) throw Rejected("a face has one or three crossed edges");
  }
  std::vector<unsigned> ends(complex.edges.size());
  for (Index e = 0; e < complex.edges.size(); ++e) {
    if (!crossed[e]) continue;
    const Edge& edge = complex.edges[e];
    if (edge.faces == 1) ++ends[joined.find(e)];
    for (Index i = 0; i < static_cast<Index>(edge.faces); ++i)
      if (complex.patch_of[edge.face[i]] != Complex::kNone) ++ends[joined.find(e)];
  }
  std::array<std::uint64_t, 2> count{};
  for (Index e = 0; e < complex.edges.size(); ++e)
    if (crossed[e] && joined.find(e) == e) {
      if (ends[e] != 0 && ends[e] != 2) throw Rejected("a ridge has not two ends");
      ++count[ends[e] / 2];
    }
  return count;
}

void check_umbilics(const Problem& problem, const std::array<std::vector<bool>, 2>& crossed) {
  const Certificate& c = problem.certificate;
  std::array<std::uint64_t, 4> count{};
  std::int64_t twice_sum = 0;
  for (const PatchRecord& p : c.patches) {
    ++count[p.twice_index > 0 ? 0 : 1];
    ++count[p.branches[0] == 1 ? 2 : 3];
    twice_sum += p.twice_index;
    for (std::size_t j = 0; j < 2; ++j) {
      int border = 0;
      for (const std::uint32_t f : p.faces)
        for (const Index e : problem.complex.edge_of[f])
          border += crossed[j][e] && !problem.complex.interior_to_patch(problem.complex.edges[e]);
      demand_count("crossed edges on a patch's border", static_cast<std::uint64_t>(p.branches[j]),
                   static_cast<std::uint64_t>(border));
    }
  }
  const char* names[] = {"umbilics of index 1/2", "umbilics of index -1/2",
                         "umbilics with one blue branch", "umbilics with three blue branches"};
  for (Index k = 0; k < 4; ++k) demand_count(names[k], c.umbilics[k], count[k]);
  if (problem.complex.closed() && twice_sum != 2 * static_cast<std::int64_t>(c.euler))
    throw Rejected("the indices do not sum to the Euler characteristic");
}

}  // namespace

void check_graph(const Problem& problem, const std::array<std::vector<bool>, 2>& crossed) {
  const Certificate& c = problem.certificate;
  check_umbilics(problem, crossed);
  std::uint64_t purple = 0;
  for (std::size_t j = 0; j < 2; ++j) {
    const auto found = curves(problem, crossed[j]);
    demand_count(j == 0 ? "blue loops" : "red loops", c.curves[j][0], found[0]);
    demand_count(j == 0 ? "blue paths" : "red paths", c.curves[j][1], found[1]);
    std::uint64_t turning = 0;
    for (const FaceRecord& f : c.records) turning += f.type[j] == 3 ? 1 : 0;
    demand_count(j == 0 ? "blue turning points" : "red turning points", c.turning[j], turning);
  }
  for (const FaceRecord& f : c.records) purple += f.purple ? 1 : 0;
  demand_count("purple points", c.purple, purple);
}

}  // namespace crest::recheck
