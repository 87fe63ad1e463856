// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/line_art/stroke.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crest::line_art {
namespace {

using kernel::norm;
using kernel::operator+, kernel::operator-, kernel::operator*;

constexpr double kMitre = 2;  // of the half width

Vec2 left_of(const Vec2& a) {
  return {-a[1], a[0]};
}

/// Half a circle from centre + from to centre - from, by way of `ahead`.
void add_cap(const Vec2& centre, const Vec2& from, const Vec2& ahead, double radius,
             std::vector<Vec2>& polygon) {
  if (!(radius > 0)) return;
  constexpr int kSteps = 6;
  for (int i = 1; i < kSteps; ++i) {
    const double angle = std::numbers::pi * i / kSteps;
    polygon.push_back(centre + (radius * std::cos(angle)) * from +
                      (radius * std::sin(angle)) * ahead);
  }
}

/// Turns an end's offset into a direction, as far as that is not too slanting; false for none.
bool cut(const Vec2& direction, double half, Vec2& offset) {
  if (direction == Vec2{0, 0}) return false;
  constexpr double kLongest = 2;  // half widths
  const Vec2 across = unit(offset);
  const double cosine = kernel::dot(direction, across);
  const double length = half / std::max(1 / kLongest, std::abs(cosine));
  if (std::abs(cosine) * kLongest > 1) offset = (cosine < 0 ? -length : length) * direction;
  return true;
}

}  // namespace

Vec2 unit(const Vec2& a) {
  const double n = norm(a);
  return n > 0 ? (1 / n) * a : Vec2{0, 0};
}

const char* name_of(StrokeKind kind) {
  constexpr const char* names[] = {"rib", "cross", "streamline", "contour"};
  return names[static_cast<std::size_t>(kind)];
}

double Stroke::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += norm(points[i] - points[i - 1]);
  return sum;
}

std::vector<Vec2> outline(const Stroke& stroke) {
  std::vector<Vec2> p;
  std::vector<double> half;
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    if (!p.empty() && p.back() == stroke.points[i]) continue;
    p.push_back(stroke.points[i]);
    half.push_back(0.5 * stroke.widths[i]);
  }
  const std::size_t n = p.size();
  if (n < 2) return {};
  const bool closed = n > 3 && p.front() == p.back();
  std::vector<Vec2> offset(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& before = i > 0 ? p[i - 1] : closed ? p[n - 2] : p[i];
    const Vec2& after = i + 1 < n ? p[i + 1] : closed ? p[1] : p[i];
    const Vec2 in = unit(p[i] - before), out = unit(after - p[i]);
    const Vec2 normal = unit(left_of(in + out));
    const Vec2 side = left_of(norm(out) > 0 ? out : in);
    const double cosine = std::max(1 / kMitre, kernel::dot(normal, side));
    offset[i] = (half[i] / cosine) * (norm(normal) > 0 ? normal : side);
  }
  const bool cut_start = !closed && cut(stroke.start_cut, half[0], offset[0]);
  const bool cut_end = !closed && cut(stroke.end_cut, half[n - 1], offset[n - 1]);
  std::vector<Vec2> polygon;
  for (std::size_t i = 0; i < n; ++i) polygon.push_back(p[i] + offset[i]);
  if (!closed && !cut_end)
    add_cap(p[n - 1], unit(offset[n - 1]), unit(p[n - 1] - p[n - 2]), half[n - 1], polygon);
  for (std::size_t i = n; i-- > 0;) polygon.push_back(p[i] - offset[i]);
  if (!closed && !cut_start)
    add_cap(p[0], -1.0 * unit(offset[0]), unit(p[0] - p[1]), half[0], polygon);
  return polygon;
}

std::vector<Vec2> band_outline(const Stroke& stroke) {
  Stroke band = stroke;
  std::fill(band.widths.begin(), band.widths.end(), stroke.band);
  return outline(band);
}

std::vector<Vec2> simplified(const std::vector<Vec2>& line, double error) {
  if (line.size() < 3) return line;
  std::vector<Vec2> kept = {line.front()};
  std::size_t last = 0;
  for (std::size_t end = 2; end < line.size(); ++end) {
    // All between must lie on the chord, and it may not be longer than what the eye compares.
    const Vec2 chord = line[end] - line[last];
    const double length = norm(chord);
    bool straight = length > 0 && end - last < 40;
    for (std::size_t i = last + 1; straight && i < end; ++i) {
      const Vec2 q = line[i] - line[last];
      const double t = kernel::dot(q, chord) / (length * length);
      straight = std::abs(kernel::cross(chord, q)) <= error * length && t > 0 && t < 1;
    }
    if (straight) continue;
    last = end - 1;
    kept.push_back(line[last]);
  }
  kept.push_back(line.back());
  return kept;
}

std::vector<Vec2> resample(const std::vector<Vec2>& line, double step) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::round(length / step)));
  std::vector<Vec2> result = {line.front()};
  double done = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double part = norm(line[i] - line[i - 1]);
    while (result.size() < pieces) {
      const double at = length * static_cast<double>(result.size()) / static_cast<double>(pieces);
      if (at > done + part) break;
      result.push_back(line[i - 1] + ((at - done) / part) * (line[i] - line[i - 1]));
    }
    done += part;
  }
  result.push_back(line.back());
  return result;
}

}  // namespace crest::line_art
