// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The components of the cut mesh: topology, orientation, and the clusters of theorem (b).
#include <functional>
#include <span>

#include "algorithms/extremal/placing.hpp"
#include "algorithms/extremal/trim.hpp"
#include "kernel/geometry/disjoint_sets.hpp"

namespace crest::extremal {

/// Which cells belong to a cluster that proves isotopy: connected through shared points, all
/// regular with one sheet at most, all others that they touch empty, no border, no ambiguous face.
class Clusters {
 public:
  Clusters(const Grid& grid, const CellRecords& cells);
  bool proven(std::size_t cell) const;
  /// And s_nn > 0 on all of its cells?
  bool extremal(std::size_t cell) const;

 private:
  void join_neighbours(const Grid& grid, kernel::DisjointSets& sets) const;

  std::vector<Index> members_;     ///< regular cells, ascending
  std::vector<Index> cluster_;     ///< a member's
  std::vector<bool> bad_, mixed_;  ///< a cluster's
};

/// What a component has beside what is reported.
struct ComponentProof {
  std::size_t polygons = 0;  ///< of the sheet mesh, of which something is left
  bool cut = false, extremal = false;
};
struct Measured {
  std::vector<Component> components;
  std::vector<ComponentProof> proofs;
  std::vector<Index> component_of;  ///< a polygon's
};
/// Orients the polygons of `trimmed` alike across edges of two.
Measured measure(const Grid& grid, const SheetMesh& mesh, TrimmedMesh& trimmed);
/// isotopic: closed, not cut, all cells of its vertices in proven clusters.
void decide_isotopy(const SheetMesh& mesh, const TrimmedMesh& trimmed, const Clusters& clusters,
                    Measured& measured);

/// A mesh and what is measured of it.
struct MeasuredMesh {
  SheetMesh sheets;
  TrimmedMesh trimmed;
  Measured measured;
};
/// What the fields have at places, in units of the grid.
using ValuesAt = std::function<std::vector<AtPlace>(std::span<const Vec3>)>;
/// The points, polygons and components of a result. Parts of the mesh are thrown away as they are
/// written.
void write_mesh(const Grid& grid, MeasuredMesh& mesh, const ValuesAt& values, Result& result);

}  // namespace crest::extremal
