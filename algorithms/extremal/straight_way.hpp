// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Does n at one place of a cell continue n at another one? Along the straight way between them T is
// a curve of degree 9: the cone test on its Bezier values, as on edges.
#include "algorithms/extremal/cell_nets.hpp"

namespace crest::extremal {

class CellWays {
 public:
  CellWays(const Fields& fields, const Node& cell);

  /// Does one vector pass the cone test all along the way, so that n stays within 45 degrees of it?
  bool one_branch(const Vec3& from, const Vec3& to) const;

 private:
  CellNets nets_;
};

}  // namespace crest::extremal
