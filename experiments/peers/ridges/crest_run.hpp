// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Crest's ridge pipeline on a mesh, timed phase by phase.
#include <string>

#include "algorithms/ridges/certificate.hpp"
#include "algorithms/ridges/ridges.hpp"
#include "certify/certificate.hpp"

namespace crest::peers {

struct CrestResult {
  double mesh = 0, fit = 0, extract = 0, write = 0;  // s; extract: graph and certificate
  std::size_t certificate_bytes = 0;
  int plus = 0, minus = 0, other = 0;  ///< umbilics by index
  struct Ridges {
    int loops = 0, segments = 0;
    int components() const { return loops + segments; }
  } blue, red;
  int open_ends = 0, conflict_triangles = 0;
  double index_sum = 0;
  double total() const { return fit + extract + write; }
};

/// Counts only.
inline CrestResult count(const ridges::RidgeGraph& graph) {
  CrestResult r;
  for (const ridges::Umbilic& u : graph.umbilics)
    ++(u.twice_index == 1 ? r.plus : u.twice_index == -1 ? r.minus : r.other);
  for (const ridges::Ridge& ridge : graph.ridges) {
    auto& colour = ridge.colour == ridges::Colour::blue ? r.blue : r.red;
    ++(ridge.loop ? colour.loops : colour.segments);
  }
  r.open_ends = static_cast<int>(ridges::open_ends(graph));
  r.conflict_triangles = static_cast<int>(graph.conflict_triangles);
  r.index_sum = 0.5 * graph.twice_index_sum;
  return r;
}

}  // namespace crest::peers
