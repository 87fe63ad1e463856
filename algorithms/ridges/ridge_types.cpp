// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/ridges/ridge_types.hpp"

#include "kernel/predicates/segment_type.hpp"

namespace crest::ridges {
namespace {

using kernel::MongeForm;

// The triangle with both edges, and which of its corners lies on both.
std::pair<Index, std::size_t> triangle_between(const kernel::TriangleMesh& mesh, Index edge,
                                               Index next) {
  const kernel::Edge& e = mesh.edges()[edge];
  for (Index f : {e.f0, e.f1}) {
    if (f == kernel::kNone) continue;
    const auto& sides = mesh.face_edges()[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = sides[k], b = sides[(k + 2) % 3];  // the sides at corner k
      if ((a == edge && b == next) || (a == next && b == edge)) return {f, k};
    }
  }
  return {kernel::kNone, 0};
}

}  // namespace

RidgeType fourth_order_type(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                            Index edge, Colour colour, TypeCounts& counts) {
  const MongeForm &p = forms[mesh.edges()[edge].v0], &q = forms[mesh.edges()[edge].v1];
  const kernel::Decision d = colour == Colour::blue
                                 ? kernel::crossing_type(kernel::blue_end(p), kernel::blue_end(q))
                                 : kernel::crossing_type(kernel::red_end(p), kernel::red_end(q));
  counts.crossing.add(d.stage);
  if (d.sign == kernel::Sign::zero) return RidgeType::none;
  return d.sign == kernel::Sign::negative ? RidgeType::elliptic : RidgeType::hyperbolic;
}

RidgeType third_order_type(const kernel::TriangleMesh& mesh, const std::vector<MongeForm>& forms,
                           const EdgeStates& states, Index edge, Index next, Colour colour,
                           TypeCounts& counts) {
  const auto [f, apex] = triangle_between(mesh, edge, next);
  const bool red = colour == Colour::red;
  std::array<Index, 3> v;
  kernel::CrossedTriangle t;
  Vec3* corner[3] = {&t.v1, &t.v2, &t.v3};
  double* b[3] = {&t.b1, &t.b2, &t.b3};
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = mesh.faces()[f][(apex + k) % 3];
    *corner[k] = mesh.points()[v[k]];
    *b[k] = red ? forms[v[k]].b3 : forms[v[k]].b0;
  }
  int vote = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const MongeForm& m = forms[v[k]];
    const kernel::Decision side = kernel::segment_side({t, m.d1, m.n, red});
    counts.segment.add(side.stage);
    const int beta = states.extremality[red ? 1 : 0][v[k]];
    vote += (k == 0 ? 1 : -1) * beta * static_cast<int>(side.sign);
  }
  if (vote == 0) return RidgeType::none;
  return (vote > 0) != red ? RidgeType::elliptic : RidgeType::hyperbolic;
}

}  // namespace crest::ridges
