// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/certify_splines/reference_rays.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crest::tests {
namespace {

using certify::SplineHit;

const std::array<Int3, 9> kNormals = {{{1, 0, 0},
                                       {0, 1, 0},
                                       {0, 0, 1},
                                       {1, 1, 0},
                                       {1, -1, 0},
                                       {1, 0, 1},
                                       {1, 0, -1},
                                       {0, 1, 1},
                                       {0, 1, -1}}};

Rational dot(const Int3& n, const Exact3& x) {
  return n[0] * x[0] + n[1] * x[1] + n[2] * x[2];
}

class RayCaster {
 public:
  RayCaster(const SplineVolume& volume, const ReferenceSpline& spline,
            const std::array<double, 6>& ray)
      : spline_(spline), level_(volume.level) {
    std::array<Exact3, 3> columns;
    Exact3 from;
    for (std::size_t r = 0; r < 3; ++r) {
      from[r] = Rational(ray[r]) - Rational(volume.origin[r]);
      d_[r] = ray[3 + r];
      for (std::size_t k = 0; k < 3; ++k)
        columns[k][r] = Rational(volume.direction[3 * r + k]) * Rational(volume.spacing[k]);
    }
    o_ = solve(columns, from);
    d_ = solve(columns, d_);
    for (std::size_t k = 0; k < 3; ++k) {
      o_[k] = 2 * o_[k] + (volume.extended ? 1 : -1);
      d_[k] *= 2;
    }
  }

  std::optional<SplineHit> first() const {
    Rational begin = 0, end = -1;
    bool bounded = false;
    for (std::size_t k = 0; k < 3; ++k) {
      const int side = 2 * spline_.cubes(k);
      if (d_[k] == 0) {
        if (o_[k] < 0 || o_[k] > side) return std::nullopt;
        continue;
      }
      Rational in = -o_[k] / d_[k], out = (side - o_[k]) / d_[k];
      if (in > out) std::swap(in, out);
      begin = std::max(begin, in);
      end = bounded ? std::min(end, out) : out;
      bounded = true;
    }
    if (begin > end) return std::nullopt;
    std::vector<Rational> cuts = {begin, end};
    for (const Int3& n : kNormals) {
      const Rational speed = dot(n, d_);
      if (speed == 0) continue;
      for (int plane = -100; plane <= 100; plane += 2) {
        const Rational t = (plane - dot(n, o_)) / speed;
        if (t > begin && t < end) cuts.push_back(t);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    if (cuts.size() == 1) cuts.push_back(end);
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
      if (const auto hit = on_segment(cuts[i], cuts[i + 1])) return hit;
    return std::nullopt;
  }

 private:
  static Exact3 solve(const std::array<Exact3, 3>& columns, const Exact3& right) {
    const auto det = [](const std::array<Exact3, 3>& m) {
      return Rational(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                      m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                      m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
    };
    Exact3 x;
    for (std::size_t k = 0; k < 3; ++k) {
      auto replaced = columns;
      replaced[k] = right;
      x[k] = det(replaced) / det(columns);
    }
    return x;
  }
  Exact3 at(const Rational& t) const {
    Exact3 x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = o_[k] + t * d_[k];
    return x;
  }

  /// Zeros in signs count as positive: as of a point moved by (e, e^2, e^3).
  std::optional<SplineHit> on_segment(const Rational& a, const Rational& b) const {
    Exact3 middle = at((a + b) / 2);
    Rational e = Rational(1) / Rational(0x1p500);
    Int3 cube;
    for (std::size_t k = 0; k < 3; ++k) {
      middle[k] += e;
      e *= Rational(1) / Rational(0x1p500);
      int i = 0;
      while (i + 1 < spline_.cubes(k) && middle[k] >= 2 * (i + 1)) ++i;
      cube[k] = i;
    }
    Exact3 from_centre;
    for (std::size_t k = 0; k < 3; ++k) from_centre[k] = middle[k] - (2 * cube[k] + 1);
    for (std::size_t tet = 0; tet < 24; ++tet) {
      const auto l = reference_tets()[tet].barycentrics(from_centre);
      if (l[1] < 0 || l[2] < 0 || l[3] < 0) continue;
      return zero_in(cube, tet, a, b);
    }
    throw std::logic_error("a point in no tetrahedron");
  }

  std::optional<SplineHit> zero_in(const Int3& cube, std::size_t tet, const Rational& a,
                                   const Rational& b) const {
    const auto q = [&](const Rational& t) {
      return Rational(spline_.polynomial(cube, tet, at(t)) - level_);
    };
    const Rational first = q(a), last = q(b), half = q((a + b) / 2);
    const Rational middle = 2 * half - (first + last) / 2;
    // Up to `turn` there is one zero or none, which a change of sign shows.
    Rational turn = b;
    if (first != 0 && first * last > 0) {
      const Rational bend = first - 2 * middle + last;
      if (bend == 0) return std::nullopt;
      const Rational u = (first - middle) / bend;
      if (u <= 0 || u >= 1) return std::nullopt;
      turn = a + u * (b - a);
      if (first * q(turn) > 0) return std::nullopt;
    }
    const auto reached = [&](double t) {
      const Rational x = t;
      return x >= a && (first == 0 || x >= turn || first * q(x) <= 0);
    };
    const double high = least_double(0, 0x1p60, reached);
    const bool exact = first == 0 ? Rational(high) == a : q(high) == 0;
    const double low = exact ? high : std::nextafter(high, 0.0);
    const int number = cube[0] + spline_.cubes(0) * (cube[1] + spline_.cubes(1) * cube[2]);
    return SplineHit{static_cast<std::uint32_t>(number), static_cast<std::uint8_t>(tet), low, high};
  }

  const ReferenceSpline& spline_;
  Rational level_;
  Exact3 o_, d_;
};

}  // namespace

certify::SplineRaysCertificate reference_rays(const SplineVolume& volume,
                                              const std::vector<std::array<double, 6>>& rays) {
  certify::SplineRaysCertificate c{volume, rays, {}, {}};
  const ReferenceSpline spline(volume);
  for (const auto& ray : rays) {
    const auto hit = RayCaster(volume, spline, ray).first();
    c.meets.push_back(hit ? 1 : 0);
    if (hit) c.hits.push_back(*hit);
  }
  return c;
}

}  // namespace crest::tests
