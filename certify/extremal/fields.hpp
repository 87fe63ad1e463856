// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The grid, and the coefficients of the splines L and T as the data's samples give them (SPEC.md,
// "Coefficients"). An image is a volume of one layer; its T has T_zz < 0 beyond all eigenvalues.
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certify/container/buffer.hpp"
#include "certify/extremal/records.hpp"

namespace crest::certify::extremal {

using u32 = std::uint32_t;
using std::size_t;
using Vec = std::array<double, 3>;
using Place = std::array<u32, 3>;  ///< of a node

struct Grid {
  unsigned dimension = 3;
  Place nodes{1, 1, 1};
  std::array<u32, 3> stride{1, 1, 1};
  u32 count = 0;  ///< nodes

  Grid(unsigned dimension, const Place& nodes);
  Place place(u32 node) const {
    return {node % nodes[0], node / nodes[0] % nodes[1], node / stride[2]};
  }
  /// Is there a cell whose lowest node this is?
  bool is_cell(u32 node) const {
    const Place p = place(node);
    for (unsigned k = 0; k < dimension; ++k)
      if (p[k] + 1 >= nodes[k]) return false;
    return true;
  }
  u32 edge(u32 node, unsigned axis) const { return dimension * node + axis; }
  u32 corners() const { return 1U << dimension; }  ///< of a cell
};

/// Order of components: xx yy zz xy yz xz.
inline constexpr unsigned kComponent[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

struct Fields {
  Grid grid;
  bool hessian, valley;
  Vec spacing, inverse_spacing;  ///< of an image the third inverse is 0
  Buffer<float> l;
  std::array<Buffer<float>, 6> t;  ///< empty with `hessian`; components without z with an image
};

/// Requires the stored weights to be those of the sigmas (SPEC.md, "Weights"). Throws Reject.
void check_weights(const ExtremalData& data);
/// On the grid of the samples. Throws Reject for samples that no double holds, coefficients that
/// are not finite.
Fields make_fields(const ExtremalData& data);
/// The same splines on the grid of half the spacing.
void halve_grid(Fields& fields);

}  // namespace crest::certify::extremal
