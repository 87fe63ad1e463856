// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/steering.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crest::line_art {
namespace {

using kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

/// A polyline at a share of its length, and its velocity.
std::pair<Vec2, Vec2> along(const std::vector<Vec2>& line, double t) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
  double left = t * length;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 d = line[i] - line[i - 1];
    const double part = norm(d);
    if ((left <= part || i + 1 == line.size()) && part > 0)
      return {line[i - 1] + (std::min(left, part) / part) * d, (length / part) * d};
    left -= part;
  }
  return {line.back(), {0, 0}};
}

bool inside(const std::vector<std::vector<Vec2>>& rings, const Vec2& p) {
  if (rings.empty()) return true;
  bool in = false;
  for (const auto& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a[1] > p[1]) != (b[1] > p[1]) &&
          p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        in = !in;
    }
  return in;
}

void set_direction(Buffers& b, std::size_t k, const Vec2& d) {
  const double n = norm(d);
  if (!(n > 0) || b.face[k] == kNone) return;
  b.rib[k] = {static_cast<float>(d[0] / n), static_cast<float>(d[1] / n)};
  b.backbone[k] = {-b.rib[k][1], b.rib[k][0]};
}

/// Samples the patch so densely that every pixel it covers gets a direction.
void set_coons(const Region& region, const std::vector<bool>& mine, Buffers& b) {
  double longest = 0;
  for (const auto& line : region.coons)
    for (std::size_t i = 1; i < line.size(); ++i) longest += norm(line[i] - line[i - 1]);
  const int n = std::max(2, static_cast<int>(2 * longest / b.pixel));
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const CoonsPoint c =
          coons_point(region.coons, static_cast<double>(i) / n, static_cast<double>(j) / n);
      const auto k = b.at(c.place);
      if (k && mine[*k]) set_direction(b, *k, c.along_u);
    }
}

/// Of luminance over the region's pixels within a radius.
void filter(const std::vector<bool>& mine, double radius_mm, bool median, Buffers& b) {
  const int radius =
      std::max(1, static_cast<int>(std::lround((median ? 1 : 2) * radius_mm / b.pixel)));
  const double deviation = radius_mm / b.pixel;
  const std::vector<float> before = b.luminance;
  std::vector<float> values;
  for (int y = 0; y < b.height; ++y)
    for (int x = 0; x < b.width; ++x) {
      const auto at = [&](int i, int j) {
        return static_cast<std::size_t>(j) * static_cast<std::size_t>(b.width) +
               static_cast<std::size_t>(i);
      };
      if (!mine[at(x, y)]) continue;
      double sum = 0, weight = 0;
      values.clear();
      for (int j = std::max(0, y - radius); j <= std::min(b.height - 1, y + radius); ++j)
        for (int i = std::max(0, x - radius); i <= std::min(b.width - 1, x + radius); ++i) {
          const int r2 = (i - x) * (i - x) + (j - y) * (j - y);
          if (r2 > radius * radius || !mine[at(i, j)]) continue;
          values.push_back(before[at(i, j)]);
          const double w = std::exp(-0.5 * r2 / (deviation * deviation));
          sum += w * static_cast<double>(values.back());
          weight += w;
        }
      if (median) {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        b.luminance[at(x, y)] = *middle;
      } else {
        b.luminance[at(x, y)] = static_cast<float>(sum / weight);
      }
    }
}

void apply(const Region& region, const std::vector<bool>& mine, Buffers& b) {
  if (region.gauss > 0) filter(mine, region.gauss, false, b);
  if (region.median > 0) filter(mine, region.median, true, b);
  const double angle = region.angle * std::numbers::pi / 180;
  for (std::size_t k = 0; k < b.size(); ++k) {
    if (!mine[k]) continue;
    if (region.tones)
      b.luminance[k] = std::clamp(b.luminance[k], static_cast<float>((*region.tones)[0]),
                                  static_cast<float>((*region.tones)[1]));
    if (region.field == Region::Field::min) std::swap(b.rib[k], b.backbone[k]);
    if (region.field == Region::Field::angle)
      set_direction(b, k, {std::cos(angle), -std::sin(angle)});
    if (region.field == Region::Field::off) b.luminance[k] = 1;
  }
  if (region.field == Region::Field::coons) set_coons(region, mine, b);
}

}  // namespace

CoonsPoint coons_point(const std::array<std::vector<Vec2>, 4>& curves, double u, double v) {
  const auto [below, below_u] = along(curves[0], u);
  const auto [right, right_v] = along(curves[1], v);
  const auto [above, above_u] = along(curves[2], u);
  const auto [left, left_v] = along(curves[3], v);
  const Vec2 &p00 = curves[0].front(), &p10 = curves[0].back(), &p01 = curves[2].front(),
             &p11 = curves[2].back();
  const Vec2 bilinear = (1 - v) * ((1 - u) * p00 + u * p10) + v * ((1 - u) * p01 + u * p11);
  const Vec2 bilinear_u = (1 - v) * (p10 - p00) + v * (p11 - p01);
  return {(1 - v) * below + v * above + (1 - u) * left + u * right - bilinear,
          (1 - v) * below_u + v * above_u + right - left - bilinear_u};
}

void steer(const std::vector<Region>& regions, Buffers& b) {
  std::vector<bool> free(b.size(), true);
  for (const Region& region : regions) {
    std::vector<bool> mine(b.size());
    for (std::size_t k = 0; k < b.size(); ++k)
      if (free[k] && b.face[k] != kNone && inside(region.rings, b.centre(k))) {
        mine[k] = true;
        free[k] = false;
      }
    apply(region, mine, b);
  }
}

}  // namespace crest::line_art
