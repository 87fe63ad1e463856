// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Meshes with Monge forms for the tests of the ridge graph.
#include <random>

#include "algorithms/ridges/ridges.hpp"
#include "algorithms/sampling/mesh_surface.hpp"
#include "tests/support/degenerate_families.hpp"

namespace crest::tests {

struct RidgeCase {
  kernel::TriangleMesh mesh;
  std::vector<kernel::MongeForm> forms;
  sampling::KnownFacts known;
};

inline RidgeCase exact_case(const std::string& name, const std::vector<double>& parameters,
                            int vertices, bool rotate) {
  sampling::SurfaceSample s = sampling::sample(name, parameters, vertices, rotate);
  return {kernel::TriangleMesh(s.points, s.faces), s.forms, s.known};
}

inline RidgeCase fitted_case(const std::string& name, const std::vector<double>& parameters,
                             int vertices, bool rotate) {
  RidgeCase c = exact_case(name, parameters, vertices, rotate);
  c.forms = ridges::fit_monge_forms(c.mesh, {}).forms;
  return c;
}

/// (d1, d2, n) -> (-d1, -d2, n): the same surface in the other direct frame.
inline void reverse_frame(kernel::MongeForm& m) {
  for (double* x : {&m.d1[0], &m.d1[1], &m.d1[2], &m.b0, &m.b1, &m.b2, &m.b3}) *x = -*x;
}

/// Numbers without any meaning, from a degenerate family; k1 >= k2, d1 and n not zero.
inline std::vector<kernel::MongeForm> random_forms(std::size_t count, Family family,
                                                   std::uint64_t salt) {
  Draw d(salt);
  std::vector<kernel::MongeForm> forms(count);
  for (kernel::MongeForm& m : forms) {
    m.d1 = draw_vector(d, family);
    m.n = draw_vector(d, family);
    m.k1 = draw(d, family);
    m.k2 = draw(d, family);
    if (m.k1 < m.k2) std::swap(m.k1, m.k2);
    for (double* x : {&m.b0, &m.b1, &m.b2, &m.b3, &m.c0, &m.c4}) *x = draw(d, family);
  }
  return forms;
}

struct RidgeCounts {
  int loops[2] = {0, 0}, segments[2] = {0, 0};
};
inline RidgeCounts count_ridges(const ridges::RidgeGraph& graph) {
  RidgeCounts c;
  for (const ridges::Ridge& r : graph.ridges)
    ++(r.loop ? c.loops : c.segments)[static_cast<int>(r.colour)];
  return c;
}

}  // namespace crest::tests
