// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Tests of tetrahedra piece by piece: the signs of f, and the trees of tetrahedra as far as
// rejections and witnesses need no faces. Each is a function of the tetrahedron's own tensors: a
// piece needs no halo. Faces, roots on edges, pieces of surfaces and triangles are made of the
// joined records by whoever has the whole mesh.
//
// A record says where the piece cut a cell. Two edges of exactly one angle are told apart by the
// numbers of vertices, which depend on what was cut elsewhere: where the whole cuts another edge,
// the tetrahedron's further records are left out of account and tested again.
#include <functional>

#include "algorithms/modes/cells.hpp"
#include "algorithms/modes/modes.hpp"

namespace crest::modes {

struct TetRecords {
  std::vector<CellSign> signs;        ///< a tetrahedron; none of those with a zero corner
  std::vector<std::uint32_t> counts;  ///< a tetrahedron: of its tree's tests
  std::vector<CellTest> tests;        ///< by tetrahedron, in the order in which trees grow
};

struct TetJob {
  std::vector<Symmetric> tensors;          ///< a vertex of the piece
  std::vector<std::array<Index, 4>> tets;  ///< their corners, ascending
  int scale = 0;
  Level level;
  Limits limits;
};
TetRecords work_on(const TetJob& job);

/// Who tests pieces, and on how many. Each job is asked for once; answers are in the jobs' order.
struct Workers {
  Index pieces = 1;
  std::function<std::vector<TetRecords>(std::size_t, const std::function<TetJob(std::size_t)>&)>
      tests;
};
/// This process, one piece after the other.
Workers workers_here(Index pieces);

/// The sign of f on tetrahedra; none on those with a zero corner.
std::vector<CellSign> signs_on(Vertices& vertices, std::span<const std::array<Index, 4>> tets,
                               const Level& level);
/// By the workers; of one piece only the signs, trees being tested as they grow.
TetRecords test_tets(const ModeField& field, Vertices& vertices, int scale, const Level& level,
                     const Limits& limits, const Workers* workers);

}  // namespace crest::modes
