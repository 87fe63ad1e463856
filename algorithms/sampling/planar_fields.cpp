// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/sampling/planar_fields.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace crest::sampling {

using kernel::Index;
using kernel::Vec2;

namespace {

/// A linear congruential generator, the same on every machine.
class Lattice {
 public:
  Lattice(std::uint64_t seed, int cells) : cells_(cells), state_(seed) {
    for (int i = 0; i < 4; ++i) next();
    const auto side = static_cast<std::size_t>(cells) + 1;
    for (std::size_t i = 0; i < side * side; ++i) {
      const double x = 2 * next() - 1;
      vectors_.push_back({x, 2 * next() - 1});
    }
  }
  /// In the unit square.
  Vec2 at(double x, double y) const {
    const auto [a, u] = split(x);
    const auto [b, w] = split(y);
    Vec2 result;
    for (std::size_t k = 0; k < 2; ++k) {
      const double low = at(a, b)[k] * (1 - u) + at(a + 1, b)[k] * u;
      const double high = at(a, b + 1)[k] * (1 - u) + at(a + 1, b + 1)[k] * u;
      result[k] = low * (1 - w) + high * w;
    }
    return result;
  }

 private:
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) / 0x1p53;
  }
  std::pair<int, double> split(double x) const {
    const double s = x * cells_;
    const int a = std::min(cells_ - 1, static_cast<int>(std::floor(s)));
    const double f = s - a;
    return {a, f * f * (3 - 2 * f)};
  }
  const Vec2& at(int a, int b) const {
    return vectors_[static_cast<std::size_t>(b * (cells_ + 1) + a)];
  }
  int cells_;
  std::uint64_t state_;
  std::vector<Vec2> vectors_;
};

/// Cells of a grid that are kept, two triangles each; points that none uses are left out.
PlanarSample grid(int nx, int ny, const std::function<bool(int, int)>& kept,
                  const std::function<void(int, int, Vec2&, Vec2&)>& value) {
  PlanarSample sample;
  std::vector<Index> number(static_cast<std::size_t>(nx + 1) * static_cast<std::size_t>(ny + 1),
                            kernel::kNone);
  const auto at = [&](int i, int j) -> Index& {
    return number[static_cast<std::size_t>(j) * static_cast<std::size_t>(nx + 1) +
                  static_cast<std::size_t>(i)];
  };
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i)
      if (kept(i, j)) at(i, j) = at(i + 1, j) = at(i, j + 1) = at(i + 1, j + 1) = 0;
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      if (at(i, j) == kernel::kNone) continue;
      at(i, j) = static_cast<Index>(sample.points.size());
      value(i, j, sample.points.emplace_back(), sample.vectors.emplace_back());
    }
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      if (!kept(i, j)) continue;
      sample.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      sample.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return sample;
}

}  // namespace

PlanarSample lattice_field(std::uint64_t seed, int n, bool hole, int lattice) {
  const Lattice field(seed, lattice > 0 ? lattice : 5 + static_cast<int>(seed % 9));
  const auto middle = [n](int i) { return 3 * n <= 8 * i && 8 * i < 5 * n; };
  return grid(
      n, n, [&](int i, int j) { return !(hole && middle(i) && middle(j)); },
      [&](int i, int j, Vec2& p, Vec2& v) {
        p = {static_cast<double>(i) / n, static_cast<double>(j) / n};
        v = field.at(p[0], p[1]);
      });
}

PlanarSample twin_bodden() {
  const Lattice field(41, 24);
  return grid(
      114, 102,
      [](int i, int j) {
        return 14 <= i && i < 99 && 9 <= j && j < 92 && !(50 <= i && i < 54 && 40 <= j && j < 43);
      },
      [&](int i, int j, Vec2& p, Vec2& v) {
        p = {static_cast<double>(i), static_cast<double>(j)};
        v = field.at(i / 114.0, j / 102.0);
        v[0] += 0.5;
      });
}

PlanarSample twin_skin() {
  const Lattice field(342, 29);
  return grid(
      101, 63, [](int, int) { return true; },
      [&](int i, int j, Vec2& p, Vec2& v) {
        const double x = i / 101.0, y = j / 63.0;
        v = field.at(x, y);
        const auto seventh = [](double s) { return s * s * s * s * s * s * s; };
        v[0] += 0.5625 * seventh(2 * x - 1);
        v[1] += 0.5625 * seventh(2 * y - 1);
        p = {x * (0.4 + x * x * (1.8 - 1.2 * x)), 8 * y * (0.25 + y * y * (2.25 - 1.5 * y))};
      });
}

}  // namespace crest::sampling
