// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numeric>
#include <ostream>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"
#include "tests/support/random.hpp"

namespace crest::tests {

struct Counts {
  int saddles = 0, sources = 0, sinks = 0, foci = 0;
  int inside_edges = 0, inside_corners = 0, outside_edges = 0, outside_corners = 0;
  int index = 0;
  int zero_ends = 0, boundary_ends = 0, orbit_ends = 0;
  friend bool operator==(const Counts&, const Counts&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Counts& c) {
    return out << c.saddles << '/' << c.sources << '/' << c.sinks << " (" << c.foci << ") "
               << c.inside_edges << '+' << c.inside_corners << " / " << c.outside_edges << '+'
               << c.outside_corners << ", index " << c.index << ", " << c.zero_ends << '/'
               << c.boundary_ends << '/' << c.orbit_ends;
  }
};

inline Counts counts_of(const vector_fields::Skeleton& s) {
  using namespace vector_fields;
  Counts c;
  for (const CriticalPoint& p : s.critical_points) {
    c.saddles += p.kind == ZeroKind::saddle;
    c.sources += p.kind == ZeroKind::source;
    c.sinks += p.kind == ZeroKind::sink;
    c.foci += p.focus;
  }
  for (const SwitchPoint& p : s.switch_points)
    ++(p.inside      ? p.at_vertex ? c.inside_corners : c.inside_edges
       : p.at_vertex ? c.outside_corners
                     : c.outside_edges);
  c.index = s.index_sum;
  for (const Separatrix& l : s.separatrices) {
    c.zero_ends += l.end == EndKind::critical_point;
    c.boundary_ends += l.end == EndKind::boundary;
    c.orbit_ends += l.end == EndKind::closed_orbit;
  }
  return c;
}

inline vector_fields::PlanarField field_of(sampling::PlanarSample sample) {
  return {std::move(sample.points), std::move(sample.vectors), std::move(sample.triangles)};
}

/// The same field with vertices, triangles and corners numbered anew.
inline vector_fields::PlanarField renumbered(const vector_fields::PlanarField& field,
                                             std::uint64_t seed) {
  Random random(seed);
  std::vector<kernel::Index> to(field.points.size());
  std::iota(to.begin(), to.end(), 0U);
  std::shuffle(to.begin(), to.end(), random);
  vector_fields::PlanarField result = field;
  for (std::size_t v = 0; v < to.size(); ++v) {
    result.points[to[v]] = field.points[v];
    result.vectors[to[v]] = field.vectors[v];
  }
  for (auto& t : result.triangles) {
    for (auto& v : t) v = to[v];
    std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(random() % 3), t.end());
  }
  std::shuffle(result.triangles.begin(), result.triangles.end(), random);
  return result;
}

}  // namespace crest::tests
