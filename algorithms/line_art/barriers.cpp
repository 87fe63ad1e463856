// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/barriers.hpp"

#include <algorithm>
#include <cmath>

namespace crest::line_art {
namespace {

using kernel::cross, kernel::dot, kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr double kReach = 1e-6;  // mm

}  // namespace

double distance_to(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a, q = p - a;
  const double squared = dot(d, d);
  const double t = squared > 0 ? std::clamp(dot(q, d) / squared, 0.0, 1.0) : 0;
  return norm(q - t * d);
}

double distance_between(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto left = [](const Vec2& p, const Vec2& q, const Vec2& r) { return cross(q - p, r - p); };
  const double c1 = left(a, b, c), d1 = left(a, b, d), a1 = left(c, d, a), b1 = left(c, d, b);
  if (((c1 > 0) != (d1 > 0)) && ((a1 > 0) != (b1 > 0))) return 0;
  return std::min(
      {distance_to(a, c, d), distance_to(b, c, d), distance_to(c, a, b), distance_to(d, a, b)});
}

Barriers::Barriers(const Scene& scene, const View& view, const Contours& contours) {
  for (const ContourEdge& e : contours.edges) {
    if (!e.occluding && !e.rim) continue;
    const Vec3 &a = scene.points[e.a], &b = scene.points[e.b];
    if (e.end_on) {
      all_.push_back({view.project(a), view.project(a)});
      continue;
    }
    for (Index i = e.first_piece; i < e.first_piece + e.pieces; ++i) {
      const Piece& piece = contours.pieces[i];
      if (!piece.drawn()) continue;
      all_.push_back({view.project((1 - piece.from) * a + piece.from * b),
                      view.project((1 - piece.to) * a + piece.to * b)});
    }
  }
  columns_ = std::max(1, static_cast<int>(view.page[0] / cell_) + 1);
  rows_ = std::max(1, static_cast<int>(view.page[1] / cell_) + 1);
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto for_cells = [&](auto&& take) {
    for (Index i = 0; i < all_.size(); ++i) {
      const auto [p, q] = all_[i];
      const auto clamp = [&](double x, int n) {
        return std::clamp(static_cast<int>(std::floor(x / cell_)), 0, n - 1);
      };
      for (int r = clamp(std::min(p[1], q[1]), rows_); r <= clamp(std::max(p[1], q[1]), rows_); ++r)
        for (int c = clamp(std::min(p[0], q[0]), columns_);
             c <= clamp(std::max(p[0], q[0]), columns_); ++c)
          take(static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(c),
               i);
    }
  };
  for_cells([&](std::size_t cell, Index) { ++begin_[cell + 1]; });
  for (std::size_t c = 1; c < begin_.size(); ++c) begin_[c] += begin_[c - 1];
  items_.resize(begin_.back());
  std::vector<Index> next(begin_.begin(), begin_.end() - 1);
  for_cells([&](std::size_t cell, Index i) { items_[next[cell]++] = i; });
}

template <class Take>
void Barriers::visit(double x0, double y0, double x1, double y1, Take&& take) const {
  const auto clamp = [&](double x, int n) {
    return std::clamp(static_cast<int>(std::floor(x / cell_)), 0, n - 1);
  };
  for (int r = clamp(y0, rows_); r <= clamp(y1, rows_); ++r)
    for (int c = clamp(x0, columns_); c <= clamp(x1, columns_); ++c) {
      const std::size_t cell = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                               static_cast<std::size_t>(c);
      for (Index i = begin_[cell]; i < begin_[cell + 1]; ++i) take(all_[items_[i]]);
    }
}

double Barriers::free_share(const Vec2& p, const Vec2& q, double clearance) const {
  const double length = norm(q - p);
  if (!(length > 0)) return 1;
  const Vec2 ahead = (1 / length) * (q - p), reach = q + clearance * ahead;
  double share = 1;
  visit(std::min(p[0], reach[0]) - clearance, std::min(p[1], reach[1]) - clearance,
        std::max(p[0], reach[0]) + clearance, std::max(p[1], reach[1]) + clearance,
        [&](const Barrier& b) {
          if (distance_between(p, reach, b.from, b.to) > clearance) return;
          // The first place that is near: in steps of a quarter of the clearance.
          const double step = 0.25 * clearance;
          for (double t = 0; t < share * length; t += step)
            if (distance_to(p + t * ahead, b.from, b.to) < clearance) {
              share = std::max(0.0, t - step) / length;
              return;
            }
          if (distance_between(p, q, b.from, b.to) == 0) {
            const Vec2 d = b.to - b.from;
            const double slope = cross(ahead, d);
            const double t = slope != 0 ? cross(b.from - p, d) / slope : 0;
            share = std::min(share, std::max(0.0, t - clearance) / length);
          }
        });
  return share;
}

bool Barriers::crosses(const Vec2& p, const Vec2& q) const {
  bool met = false;
  visit(std::min(p[0], q[0]) - kReach, std::min(p[1], q[1]) - kReach, std::max(p[0], q[0]) + kReach,
        std::max(p[1], q[1]) + kReach,
        [&](const Barrier& b) { met = met || distance_between(p, q, b.from, b.to) <= kReach; });
  return met;
}

std::optional<Barriers::Near> Barriers::nearest(const Vec2& p, double most) const {
  std::optional<Near> best;
  visit(p[0] - most, p[1] - most, p[0] + most, p[1] + most, [&](const Barrier& b) {
    const double d = distance_to(p, b.from, b.to);
    if (d > (best ? best->distance : most)) return;
    const Vec2 along = b.to - b.from;
    const double length = norm(along);
    if (length > 0) best = Near{d, (1 / length) * along};
  });
  return best;
}

}  // namespace crest::line_art
