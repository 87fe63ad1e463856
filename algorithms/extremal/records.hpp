// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is decided of a piece of the grid, by numbers in the whole grid, ascending. A node owns the
// cell, the edges and the faces that start at it; a piece records what its nodes own. Joined
// records of all pieces are those of the whole grid as one piece, byte for byte.
#include "algorithms/extremal/faces.hpp"
#include "certify/extremal/records.hpp"
#include "kernel/geometry/piece.hpp"

namespace crest::extremal {

/// Listed cells as the certificate has them: by Hess regular ones are said to pass the cone test.
struct CellRecords {
  std::vector<certify::CellRun> runs;
  std::vector<std::uint8_t> codes;
  std::vector<Short3> directions;  ///< of cells that are not open
  std::vector<Short3> gradients;   ///< of regular cells
  /// Of regular cells: 1 if boxed, with one sheet at most and no ambiguous face, all others that it
  /// touches regular or empty, none of them missing.
  std::vector<std::uint8_t> fit;
};

struct CriticalRecord {
  Index edge;
  std::uint16_t place;  ///< of its zero on it, in 65536ths
  EdgeState state;
  bool whole;    ///< no cell round it is missing: it may have a polygon
  double level;  ///< what levels keep at the zero: at least 0 (trim.hpp)
};

/// A face with a critical edge: without the edges (faces.hpp), which follow from its number.
struct FaceRecord {
  Index face;  ///< 3 node + normal
  std::array<std::int8_t, 4> group;
  std::uint8_t critical;
  bool tested, swapped;
  bool listed;  ///< not tested, and an edge that is not belongs to a listed cell

  bool odd() const { return tested && critical % 2 == 1; }
  bool ambiguous() const { return tested && critical == 4; }
};

/// A vertex of the mesh: polygons that are joined in a cell (an image: square).
struct SheetRecord {
  Index cell;
  std::uint16_t edges;  ///< of the polygons: bits in the order of edges_of_cell
  std::array<std::uint16_t, 3> place;
  double level;
};

struct RecordCounts {
  std::array<std::size_t, 3> nodes{};  ///< by NodeState
  std::array<std::size_t, 6> cells{};  ///< by CellState
  std::array<std::size_t, 15> depths{};
  std::size_t tests = 0, sheets_split = 0;
};

struct Records {
  CellRecords cells;
  BisectedEdges bisected;
  std::vector<CriticalRecord> critical;
  std::vector<Index> undecided;
  std::vector<FaceRecord> faces;
  /// By cell, then by their lowest edge: of the extremal edges' mesh, of all critical edges'.
  std::array<std::vector<SheetRecord>, 2> sheets;
  RecordCounts counts;
};

/// Which meshes are wanted.
struct Meshes {
  bool extremal = true, critical = false;
};

/// The records of all pieces as one. Guarantees: their order does not matter.
Records join(std::vector<Records> pieces);

/// How far what is decided of a node looks, in nodes of the samples.
Index halo_of(const Grid& grid, const Options& options);

}  // namespace crest::extremal
