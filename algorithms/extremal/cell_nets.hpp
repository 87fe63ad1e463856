// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Bezier nets of a row of cells: what neighbours along x have in common is made once.
#include <array>
#include <cmath>
#include <vector>

#include "algorithms/extremal/fields.hpp"

namespace crest::extremal {

/// Controls of a cell, all in the same order (x slowest, z fastest).
using Controls = std::array<double, 64>;
struct CellNets {
  std::array<Controls, 6> tensor;    ///< T
  std::array<Controls, 3> gradient;  ///< of s, world units
  double tensor_size;                ///< largest coefficient of T
  double gradient_size;              ///< largest entry that errors of `gradient` are relative to
};

/// Bezier values along y and z of what stands at one x.
struct NetColumn {
  std::array<std::array<double, 16>, 6> tensor;
  /// L, dL/dy, dL/dz; for T = Hess s then d2L/dydy, d2L/dydz, d2L/dzdz.
  std::array<std::array<double, 16>, 6> scalar;
  double tensor_size, scalar_size;
};

class RowNets {
 public:
  RowNets(const Fields& fields, int j, int k);
  /// The nets of T and grad s of the cell at (i, j, k); cheap for i ascending by one.
  void make(int i, CellNets& nets);

 private:
  const NetColumn& column(int i);

  const Fields& fields_;
  std::array<std::size_t, 16> rows_;  ///< where coefficients' rows begin, z fastest
  std::array<NetColumn, 4> ring_;
  std::array<int, 4> held_{-9, -9, -9, -9};
};

}  // namespace crest::extremal
