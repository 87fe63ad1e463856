// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/walls.hpp"

#include <algorithm>

#include "algorithms/vector_fields/exact.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::operator-;

std::optional<Index> zero_of_triangle(const Surroundings& around, Index t) {
  for (Index i = 0; i < around.zeros.size(); ++i) {
    const auto& triangles = around.zeros[i].triangles;
    if (std::binary_search(triangles.begin(), triangles.end(), t)) return i;
  }
  return std::nullopt;
}

std::optional<Index> wall_ahead(const Surroundings& around, bool forward, HalfEdge side,
                                const Expansion& left, const Expansion& right) {
  const Domain& domain = around.domain;
  const Index t = side / 3;
  HalfEdge wall = kNone;
  for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
    if (domain.is_zero(domain.from(h)) && domain.is_zero(domain.to(h))) wall = h;
  if (wall == kNone || wall == side) return std::nullopt;
  const Exact p = exact(domain.point(domain.from(wall))), q = exact(domain.point(domain.to(wall)));
  Exact u = exact(domain.vector(domain.from(Domain::previous(wall))));
  if (!forward) u = {-u[0], -u[1]};
  if (cross(q - p, u) >= 0) return std::nullopt;
  const Exact tail = exact(domain.point(domain.from(side))),
              head = exact(domain.point(domain.to(side)));
  for (const Expansion* end : {&left, &right}) {
    Rational s = 0;
    for (const double x : *end) s += Rational(x);
    if (s < 0) s += 1;
    const Exact x = {tail[0] + s * (head[0] - tail[0]), tail[1] + s * (head[1] - tail[1])};
    // The wall's tail to the right of the line, as it comes, its head to the left.
    if (cross(u, p - x) * cross(u, q - x) >= 0) return std::nullopt;
  }
  return zero_of_triangle(around, t);
}

}  // namespace crest::vector_fields
