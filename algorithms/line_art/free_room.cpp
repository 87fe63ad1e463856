// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/free_room.hpp"

#include <cmath>

namespace crest::line_art {

using kernel::norm;
using kernel::operator-;

FreeRoom::FreeRoom(const Tracer& tracer, double brightest)
    : barriers_(tracer.barriers()), cell_(0.5 * tracer.spacing()) {
  const Buffers& b = tracer.buffers();
  columns_ = static_cast<int>(std::ceil(b.width * b.pixel / cell_));
  rows_ = static_cast<int>(std::ceil(b.height * b.pixel / cell_));
  taken_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1);
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      const Vec2 p = centre(i, j);
      const auto k = b.at(p);
      if (!k || b.face[*k] == kNone || !(static_cast<double>(b.luminance[*k]) < brightest))
        continue;
      if (tracer.near_singularity(p) || barriers_.nearest(p, 0.5 * cell_)) continue;
      taken_[at(i, j)] = 0;
    }
}

void FreeRoom::take(const Vec2& p, double radius) {
  const auto range = [&](double x, int limit) {
    return std::pair{std::max(0, static_cast<int>((x - radius) / cell_)),
                     std::min(limit - 1, static_cast<int>((x + radius) / cell_))};
  };
  const auto [i0, i1] = range(p[0], columns_);
  const auto [j0, j1] = range(p[1], rows_);
  for (int j = j0; j <= j1; ++j)
    for (int i = i0; i <= i1; ++i)
      if (taken_[at(i, j)] == 0 && norm(centre(i, j) - p) <= radius &&
          !barriers_.crosses(p, centre(i, j)))
        taken_[at(i, j)] = 1;
}

std::optional<Vec2> FreeRoom::farthest(double least) const {
  // Chamfer distances of 3 and 4 to the cell, within 8 % of the true ones.
  std::vector<int> distance(taken_.size());
  const auto get = [&](int i, int j) {
    return i < 0 || j < 0 || i >= columns_ || j >= rows_ ? 0 : distance[at(i, j)];
  };
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i)
      distance[at(i, j)] = taken_[at(i, j)] != 0
                               ? 0
                               : std::min({get(i - 1, j) + 3, get(i, j - 1) + 3,
                                           get(i - 1, j - 1) + 4, get(i + 1, j - 1) + 4});
  int best = 0;
  std::optional<Vec2> place;
  for (int j = rows_ - 1; j >= 0; --j)
    for (int i = columns_ - 1; i >= 0; --i) {
      int& d = distance[at(i, j)];
      d = std::min(
          {d, get(i + 1, j) + 3, get(i, j + 1) + 3, get(i + 1, j + 1) + 4, get(i - 1, j + 1) + 4});
      if (d <= best) continue;
      best = d;
      place = centre(i, j);
    }
  return best * cell_ / 3 > least ? place : std::nullopt;
}

}  // namespace crest::line_art
