// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/extremal/splines.hpp"

#include <algorithm>

namespace crest::certify::extremal {
namespace {

/// Cells of a block along an axis: a whole number of the samples' cells.
u32 block_size(const Grid& grid) {
  return grid.dimension == 3 ? 32 : 256;
}

Grid halved_grid(const Grid& grid, unsigned times) {
  Place nodes = grid.nodes;
  for (unsigned k = 0; k < grid.dimension; ++k) nodes[k] = ((nodes[k] - 1) << times) + 1;
  return Grid(grid.dimension, nodes);
}

/// The part of a row-major array between two nodes.
Buffer<float> part_of(const Buffer<float>& in, const Grid& grid, const Place& first,
                      const Place& last) {
  const size_t width = last[0] - first[0] + 1;
  Buffer<float> out(width * (last[1] - first[1] + 1) * (last[2] - first[2] + 1));
  auto to = out.begin();
  for (u32 z = first[2]; z <= last[2]; ++z)
    for (u32 y = first[1]; y <= last[1]; ++y)
      to = std::copy_n(
          in.data() + first[0] + size_t{y} * grid.stride[1] + size_t{z} * grid.stride[2], width,
          to);
  return out;
}

}  // namespace

Splines::Splines(const ExtremalData& data, u32 most_whole)
    : fields_(make_fields(data)),
      halvings_(data.refine),
      grid_(halved_grid(fields_.grid, data.refine)) {
  const u32 size = block_size(grid_);
  for (unsigned k = 0; k < grid_.dimension; ++k) counts_[k] = (grid_.nodes[k] + size - 2) / size;
  if (grid_.count > most_whole) return;
  for (; halvings_ > 0; --halvings_) halve_grid(fields_);
}

u32 Splines::block_of(u32 node) const {
  const Place p = grid_.place(node);
  const u32 size = block_size(grid_);
  const auto at = [&](unsigned k) { return std::min(p[k] / size, counts_[k] - 1); };
  return at(0) + counts_[0] * (at(1) + counts_[1] * at(2));
}

std::array<Place, 2> Splines::corners(u32 block) const {
  const Place at{block % counts_[0], block / counts_[0] % counts_[1],
                 block / counts_[0] / counts_[1]};
  const u32 size = block_size(grid_);
  std::array<Place, 2> out{};
  for (unsigned k = 0; k < grid_.dimension; ++k) {
    out[0][k] = at[k] * size;
    out[1][k] = std::min(out[0][k] + size, grid_.nodes[k] - 1);
  }
  return out;
}

// A cell from p to p + 1 has coefficients p - 1 to p + 2. Of a window that starts within the grid,
// halving r times makes the first 2^r - 1 wrong, as they are mirrored there; one node of the
// samples more on each side is 2^r more.
std::array<Place, 2> Splines::reach(u32 block) const {
  std::array<Place, 2> out = corners(block);
  for (unsigned k = 0; k < grid_.dimension; ++k) {
    out[0][k] = std::max(out[0][k] >> halvings_, 1U) - 1;
    out[1][k] = std::min((out[1][k] >> halvings_) + 1, fields_.grid.nodes[k] - 1);
  }
  return out;
}

// Sums, products by 6 and 8, and rounding keep order: coefficients below the level, a float, give
// such ones; their means are below it, too.
bool Splines::is_low(u32 block, float level) const {
  const auto [first, last] = reach(block);
  for (u32 z = first[2]; z <= last[2]; ++z)
    for (u32 y = first[1]; y <= last[1]; ++y) {
      const float* const row = fields_.l.data() + size_t{y} * fields_.grid.stride[1] +
                               size_t{z} * fields_.grid.stride[2];
      for (u32 x = first[0]; x <= last[0]; ++x)
        if (!(row[x] < level)) return false;
    }
  return true;
}

Fields Splines::make_window(u32 block, bool tensors, Place& first) const {
  const auto [low, high] = reach(block);
  Place nodes{1, 1, 1};
  for (unsigned k = 0; k < grid_.dimension; ++k) {
    first[k] = low[k] << halvings_;
    nodes[k] = high[k] - low[k] + 1;
  }
  Fields out{Grid(grid_.dimension, nodes),
             fields_.hessian,
             fields_.valley,
             fields_.spacing,
             fields_.inverse_spacing,
             {},
             {}};
  out.l = part_of(fields_.l, fields_.grid, low, high);
  for (unsigned i = 0; i < 6 && tensors; ++i)
    if (!fields_.t[i].empty()) out.t[i] = part_of(fields_.t[i], fields_.grid, low, high);
  for (unsigned i = 0; i < halvings_; ++i) halve_grid(out);
  return out;
}

}  // namespace crest::certify::extremal
