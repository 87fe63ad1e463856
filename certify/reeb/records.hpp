// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The certificate of claim 3, reeb, as plain structs (SPEC.md).
#include <array>
#include <cstdint>
#include <vector>

namespace crest::certify {

inline constexpr std::uint32_t kReeb = 3, kReebVersion = 2;

struct ArcRecord {
  std::uint32_t lower, upper;  ///< positions in critical_nodes
};
struct CutRecord {
  std::uint32_t arc, node;
};

/// Claim reeb: the Reeb graph of a function linear or quadratic on each face.
struct ReebCertificate {
  std::vector<std::array<std::uint32_t, 3>> faces;  ///< F
  std::vector<std::array<double, 3>> positions;     ///< V
  std::vector<double> values;                       ///< V
  std::vector<double> edge_values;                  ///< E midpoint values; empty: linear
  std::int32_t euler_characteristic = 0;
  std::uint32_t boundary_loops = 0, components = 0;
  std::uint32_t line_critical = 0, face_critical = 0, tiles = 0;
  std::uint32_t minima = 0, saddles = 0, maxima = 0;  ///< saddles with multiplicity
  std::vector<std::uint32_t> order;                   ///< all nodes, ascending
  std::vector<std::uint32_t> critical_nodes;          ///< ascending in the order
  std::vector<ArcRecord> arcs;                        ///< by (lower, upper)
  std::vector<CutRecord> cuts;                        ///< by arc
  std::uint32_t tied_arcs = 0, contracted_nodes = 0;  ///< arcs between equal values, classes
};

}  // namespace crest::certify
