// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/domain.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "kernel/geometry/disjoint_sets.hpp"
#include "kernel/geometry/input_error.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::InputError;
using kernel::Sign;

Domain::Domain(const PlanarField& field) : field_(field) {
  check();
  link();
  count();
  cut();
}

void Domain::check() const {
  if (field_.triangles.empty()) throw InputError("mesh: has no triangles; give a plane mesh");
  for (std::size_t v = 0; v < field_.points.size(); ++v) {
    const auto finite = [](const Vec2& a) { return std::isfinite(a[0]) && std::isfinite(a[1]); };
    if (!finite(field_.points[v]))
      throw InputError("vertex " + std::to_string(v) + ": is not finite; export the file again");
    if (!finite(field_.vectors[v]))
      throw InputError("vertex " + std::to_string(v) +
                       ": its vector is not finite; leave the cells around it out");
  }
  for (std::size_t t = 0; t < field_.triangles.size(); ++t) {
    const auto& [a, b, c] = field_.triangles[t];
    const Sign s = kernel::orientation(point(a), point(b), point(c));
    if (s == Sign::zero)
      throw InputError("triangle " + std::to_string(t) + ": has no area; leave it out");
    if (s == Sign::negative)
      throw InputError("triangle " + std::to_string(t) +
                       ": is flipped; the mesh must not overlap itself");
  }
}

void Domain::link() {
  const Index halves = 3 * triangle_count();
  // Half-edges by their lower vertex: few a vertex, so that their partner is found by looking.
  std::vector<Index> begin(field_.points.size() + 1, 0);
  const auto low = [&](HalfEdge h) { return std::min(from(h), to(h)); };
  for (HalfEdge h = 0; h < halves; ++h) ++begin[low(h) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<HalfEdge> sorted(halves);
  {
    std::vector<Index> at(begin.begin(), begin.end() - 1);
    for (HalfEdge h = 0; h < halves; ++h) sorted[at[low(h)]++] = h;
  }
  twins_.assign(halves, kNone);
  Index paired = 0;
  for (std::size_t v = 0; v + 1 < begin.size(); ++v)
    for (Index i = begin[v]; i < begin[v + 1]; ++i)
      for (Index k = i + 1; k < begin[v + 1]; ++k) {
        const HalfEdge g = sorted[i], h = sorted[k];
        if (std::max(from(g), to(g)) != std::max(from(h), to(h))) continue;
        if (from(g) == from(h) || twins_[g] != kNone || twins_[h] != kNone)
          throw InputError("triangle " + std::to_string(h / 3) +
                           ": overlaps a neighbour along an edge; the mesh must be plane");
        twins_[g] = h;
        twins_[h] = g;
        ++paired;
      }
  euler_characteristic_ -= static_cast<int>(halves - paired);
}

void Domain::count() {
  std::vector<std::uint8_t> used(field_.points.size(), 0);
  kernel::DisjointSets sets(triangle_count());
  for (Index t = 0; t < triangle_count(); ++t) {
    for (const Index v : field_.triangles[t]) used[v] = 1;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h)
      if (twins_[h] != kNone) sets.unite(t, twins_[h] / 3);
  }
  components_ = sets.count();
  euler_characteristic_ += static_cast<int>(triangle_count());
  euler_characteristic_ += static_cast<int>(std::count(used.begin(), used.end(), 1));
}

void Domain::cut() {
  std::vector<std::uint8_t> zero(field_.points.size());
  bool any = false;
  for (Index v = 0; v < zero.size(); ++v) {
    zero[v] = is_zero(v) ? 1 : 0;
    any = any || zero[v] != 0;
  }
  if (!any) return;
  dead_.assign(triangle_count(), 0);
  region_border_.assign(twins_.size(), 0);
  for (Index t = 0; t < triangle_count(); ++t) {
    const auto& [a, b, c] = field_.triangles[t];
    if (zero[a] != 0 && zero[b] != 0 && zero[c] != 0) {
      dead_[t] = 1;
      ++zero_triangles_;
    }
  }
  if (zero_triangles_ == triangle_count())
    throw InputError("vectors: are all zero; choose another field");
  kernel::DisjointSets regions(triangle_count());
  for (HalfEdge h = 0; h < twins_.size(); ++h) {
    const HalfEdge g = twins_[h];
    if (g == kNone || g < h || zero[from(h)] == 0 || zero[to(h)] == 0) continue;
    const bool left = dead_[h / 3] != 0, right = dead_[g / 3] != 0;
    if (left && right) regions.unite(h / 3, g / 3);
    if (!left && right) region_border_[h] = 1;
    if (left && !right) region_border_[g] = 1;
    if (!left && !right) ++zero_edges_;
    twins_[h] = twins_[g] = kNone;
  }
  for (Index t = 0; t < triangle_count(); ++t)
    if (dead_[t] != 0 && regions.find(t) == t) ++zero_regions_;
}

Fan Domain::fan(HalfEdge h) const {
  // Clockwise first, to the boundary or once around.
  HalfEdge start = h;
  bool closed = false;
  for (HalfEdge at = h; twins_[at] != kNone;) {
    at = next(twins_[at]);
    if (at == h) {
      closed = true;
      break;
    }
    start = at;
  }
  if (closed) start = h;
  Fan result;
  result.closed = closed;
  for (HalfEdge at = start;;) {
    result.leaving.push_back(at);
    const HalfEdge g = twins_[previous(at)];
    if (g == kNone || g == start) break;
    at = g;
  }
  return result;
}

HalfEdge Domain::next_on_boundary(HalfEdge h) const {
  HalfEdge at = next(h);
  while (twins_[at] != kNone) at = next(twins_[at]);
  return at;
}

std::vector<std::vector<HalfEdge>> Domain::loops() const {
  std::vector<std::vector<HalfEdge>> result;
  std::vector<std::uint8_t> seen(twins_.size(), 0);
  for (HalfEdge h = 0; h < twins_.size(); ++h) {
    if (twins_[h] != kNone || seen[h] != 0 || !live(h / 3)) continue;
    auto& loop = result.emplace_back();
    for (HalfEdge at = h; seen[at] == 0; at = next_on_boundary(at)) {
      seen[at] = 1;
      loop.push_back(at);
    }
  }
  return result;
}

}  // namespace crest::vector_fields
