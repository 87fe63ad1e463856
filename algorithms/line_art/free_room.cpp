// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/free_room.hpp"

#include <algorithm>
#include <cmath>

namespace crest::line_art {

using kernel::norm;
using kernel::operator-;

FreeRoom::FreeRoom(const Tracer& tracer, double brightest)
    : barriers_(tracer.barriers()), cell_(0.5 * tracer.spacing()) {
  const Buffers& b = tracer.buffers();
  columns_ = static_cast<int>(std::ceil(b.width * b.pixel / cell_));
  rows_ = static_cast<int>(std::ceil(b.height * b.pixel / cell_));
  // Beyond the page all is taken.
  distance_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  farthest_.assign(static_cast<std::size_t>(rows_), -1);
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i)
      distance_[at(i, j)] = 3 * (1 + std::min({i, j, columns_ - 1 - i, rows_ - 1 - j}));
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i) {
      const Vec2 p = centre(i, j);
      const auto k = b.at(p);
      const bool free = k && b.face[*k] != kNone &&
                        static_cast<double>(b.luminance[*k]) < brightest &&
                        !tracer.near_singularity(p) && !barriers_.nearest(p, 0.5 * cell_);
      if (!free) set_taken(at(i, j));
    }
}

void FreeRoom::set_taken(std::size_t cell) {
  distance_[cell] = 0;
  if (waiting_.empty()) waiting_.resize(1);
  waiting_[0].push_back(cell);
}

void FreeRoom::spread() {
  for (std::size_t d = 0; d < waiting_.size(); ++d) {
    for (std::size_t n = 0; n < waiting_[d].size(); ++n) {
      const std::size_t cell = waiting_[d][n];
      if (distance_[cell] != static_cast<int>(d)) continue;
      const int i = static_cast<int>(cell % static_cast<std::size_t>(columns_));
      const int j = static_cast<int>(cell / static_cast<std::size_t>(columns_));
      farthest_[static_cast<std::size_t>(j)] = -1;
      for (int y = std::max(0, j - 1); y <= std::min(rows_ - 1, j + 1); ++y)
        for (int x = std::max(0, i - 1); x <= std::min(columns_ - 1, i + 1); ++x) {
          const int reached = static_cast<int>(d) + (x == i || y == j ? 3 : 4);
          int& there = distance_[at(x, y)];
          if (there <= reached) continue;
          there = reached;
          const auto bucket = static_cast<std::size_t>(reached);
          if (bucket >= waiting_.size()) waiting_.resize(bucket + 1);
          waiting_[bucket].push_back(at(x, y));
        }
    }
    waiting_[d].clear();
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
      if (distance_[at(i, j)] > 0 && norm(centre(i, j) - p) <= radius &&
          !barriers_.crosses(p, centre(i, j)))
        set_taken(at(i, j));
}

std::optional<Vec2> FreeRoom::farthest(double least) {
  spread();
  std::size_t best = 0;
  for (std::size_t j = 0; j < farthest_.size(); ++j) {
    if (farthest_[j] < 0) {
      const auto row = distance_.begin() + static_cast<std::ptrdiff_t>(j) * columns_;
      farthest_[j] = *std::max_element(row, row + columns_);
    }
    if (farthest_[j] > farthest_[best]) best = j;
  }
  const int most = farthest_[best];
  if (!(most * cell_ / 3 > least)) return std::nullopt;
  int i = 0;
  while (distance_[at(i, static_cast<int>(best))] != most) ++i;
  return centre(i, static_cast<int>(best));
}

}  // namespace crest::line_art
