// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/integer_march.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "algorithms/splines/normal_form.hpp"
#include "kernel/geometry/input_error.hpp"

namespace crest::splines {
namespace {

using Integer = std::int64_t;
constexpr Integer kLimit = Integer{1} << 53;

[[noreturn]] void refuse(const char* problem) {
  throw kernel::InputError(std::string("values: ") + problem +
                           " for an exactly smooth spline; scale them, or use --smoothness local");
}

/// 46 binary digits below the numbers' scale.
int unit_exponent(const CubicModel& model) {
  double largest = 0;
  const auto see = [&](const auto& all) {
    for (const auto& numbers : all)
      for (const double x : numbers) {
        if (!std::isfinite(x)) refuse("are too large");
        largest = std::max(largest, std::fabs(x));
      }
  };
  see(model.vertices);
  see(model.slopes);
  int scale = 0;
  if (largest > 0) {
    const double fraction = std::frexp(largest, &scale);
    if (fraction == 0.5) --scale;
  }
  if (scale > 1000) refuse("are too large");
  if (scale - 46 < -1060) refuse("are too small");
  return scale - 46;
}

class March {
 public:
  explicit March(CubicModel& model) : model_(model), exponent_(unit_exponent(model)) {
    f_.resize(model.vertices.size());
    h_.resize(model.vertices.size());
    t_.resize(model.slopes.size());
    for (std::size_t v = 0; v < model.vertices.size(); ++v) {
      f_[v] = rounded(model.vertices[v][0], exponent_);
      for (std::size_t d = 0; d < 3; ++d)
        h_[v][d] = rounded(model.vertices[v][d + 1], exponent_ + 1);
      for (std::size_t i = 0; i < 6; ++i) t_[v][i] = rounded(model.slopes[v][i], exponent_);
    }
  }

  void run() {
    for_each_place(model_.domain.cubes, [&](const Place& cube) {
      vertices(cube);
      for (std::size_t a = 0; a < 3; ++a) slopes(a, cube);
      centre(cube);
    });
    model_.unit = std::ldexp(1.0, exponent_);
    for (std::size_t v = 0; v < f_.size(); ++v) {
      model_.vertices[v][0] = real(f_[v], exponent_);
      for (std::size_t d = 0; d < 3; ++d) model_.vertices[v][d + 1] = real(h_[v][d], exponent_ + 1);
      for (std::size_t i = 0; i < 6; ++i) model_.slopes[v][i] = real(t_[v][i], exponent_);
    }
  }

 private:
  static Integer rounded(double x, int exponent) { return std::llrint(std::ldexp(x, -exponent)); }
  static double real(Integer x, int exponent) {
    if (x >= kLimit || x <= -kLimit) refuse("vary too much");
    return std::ldexp(static_cast<double>(x), exponent);
  }
  std::size_t vertex(const Place& cube, std::size_t corner) const {
    return model_.domain.vertex(corner_of(cube, corner));
  }

  /// V: the sum over the corners of s_x s_y s_z a(AAC) is 0; no earlier cube has the last corner.
  void vertices(const Place& cube) {
    Integer residual = 0;
    for (std::size_t c = 0; c < 8; ++c) {
      const std::size_t v = vertex(cube, c);
      Integer aac = f_[v];
      for (std::size_t d = 0; d < 3; ++d) aac -= with_sign(is_upper(c, d), h_[v][d]);
      residual += with_sign(std::popcount(c) % 2 == 1, aac);
    }
    f_[vertex(cube, 7)] -= residual;
  }

  /// E_a: the sum over the four edges along a of s_c t_b + s_b t_c is that over the corners of
  /// s_c h_b + s_b h_c - s_a s_b s_c h_a, h = g / 2.
  void slopes(std::size_t a, const Place& cube) {
    const auto [b, c] = kAcross[a];
    Integer residual = 0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      const std::size_t v = vertex(cube, corner);
      const bool sb = is_upper(corner, b), sc = is_upper(corner, c);
      const auto& h = h_[v];
      residual += with_sign(sc, h[b]) + with_sign(sb, h[c]) -
                  with_sign(std::popcount(corner) % 2 == 1, h[a]);
      if (is_upper(corner, a)) continue;
      residual -= with_sign(sc, t_[v][2 * a]) + with_sign(sb, t_[v][2 * a + 1]);
    }
    const std::size_t last = std::size_t{1} << b | std::size_t{1} << c;
    t_[vertex(cube, last)][2 * a] += residual;
  }

  void centre(const Place& cube) {
    CubeNumbers<Integer> q;
    for (std::size_t c = 0; c < 8; ++c) {
      q.f[c] = f_[vertex(cube, c)];
      q.h[c] = h_[vertex(cube, c)];
    }
    for (std::size_t e = 0; e < 12; ++e) {
      const auto& t = t_[vertex(cube, lower_corner(e))];
      q.t[e] = {t[e / 4 * 2], t[e / 4 * 2 + 1]};
    }
    const auto targets = fourfold_targets(q);
    auto numbers = centre_of_targets(targets);
    for (Integer& x : numbers) {
      if (x % 4 != 0) throw std::logic_error("a centre off its lattice");
      x /= 4;  // f_C in u/8, g_C in u/4
    }
    ValueAndSlope& to = model_.centres[model_.domain.cube(cube)];
    to[0] = real(numbers[0], exponent_ - 3);
    for (std::size_t d = 0; d < 3; ++d) to[d + 1] = real(numbers[d + 1], exponent_ - 2);
  }

  CubicModel& model_;
  int exponent_;
  std::vector<Integer> f_;
  std::vector<std::array<Integer, 3>> h_;
  std::vector<std::array<Integer, 6>> t_;
};

}  // namespace

void march_to_c1(CubicModel& model) {
  March(model).run();
}

}  // namespace crest::splines
