// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/straight_way.hpp"

#include <algorithm>

#include "algorithms/extremal/direction.hpp"

namespace crest::extremal {
namespace {

constexpr double kWayMargin = 1e-6, kWaySlack = 1e-10;
/// Halvings of the way: its values close in on T four times faster each.
constexpr int kHalvings = 4;

using Way = std::array<std::array<double, 10>, 6>;  ///< T along it

double between(double a, double b, double t) {
  return (1 - t) * a + t * b;
}

/// A cubic's Bezier values on [a, b], by its polar form; a > b turns it round.
void restrict_line(double* c, std::size_t stride, double a, double b) {
  std::array<double, 3> at_a, at_b;
  for (std::size_t i = 0; i < 3; ++i) {
    at_a[i] = between(c[i * stride], c[(i + 1) * stride], a);
    at_b[i] = between(c[i * stride], c[(i + 1) * stride], b);
  }
  const std::array<double, 2> aa = {between(at_a[0], at_a[1], a), between(at_a[1], at_a[2], a)};
  const std::array<double, 2> ab = {between(at_a[0], at_a[1], b), between(at_a[1], at_a[2], b)};
  const std::array<double, 2> bb = {between(at_b[0], at_b[1], b), between(at_b[1], at_b[2], b)};
  c[0] = between(aa[0], aa[1], a);
  c[stride] = between(aa[0], aa[1], b);
  c[2 * stride] = between(ab[0], ab[1], b);
  c[3 * stride] = between(bb[0], bb[1], b);
}

/// Of the box with these corners the diagonal.
std::array<double, 10> diagonal(Controls c, const Vec3& from, const Vec3& to) {
  for (std::size_t axis = 0, stride = 16; axis < 3; ++axis, stride /= 4)  // x is slowest
    for (std::size_t high = 0; high < 64; high += 4 * stride)
      for (std::size_t low = high; low < high + stride; ++low)
        restrict_line(c.data() + low, stride, from[axis], to[axis]);
  static constexpr std::array<double, 4> kThree = {1, 3, 3, 1};
  static constexpr std::array<double, 10> kNine = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
  std::array<double, 10> r{};
  for (std::size_t i = 0; i < 64; ++i) {
    const std::size_t x = i / 16, y = i / 4 % 4, z = i % 4;
    r[x + y + z] += kThree[x] * kThree[y] * kThree[z] * c[i];
  }
  for (std::size_t m = 0; m < 10; ++m) r[m] /= kNine[m];
  return r;
}

/// Keeps the lower half, returns the upper one.
Way halve_way(Way& way) {
  Way upper;
  for (std::size_t n = 0; n < 6; ++n) {
    auto& c = way[n];
    auto d = c;
    for (std::size_t left = 9; left > 0; --left) {
      upper[n][left] = d[left];
      c[9 - left] = d[0];
      for (std::size_t i = 0; i < left; ++i) d[i] = (d[i] + d[i + 1]) / 2;
    }
    c[9] = upper[n][0] = d[0];
  }
  return upper;
}

struct WayFrame {
  Vec3 w, u, v;
};
/// q - mu
double way_gap(const Tensor& t, const WayFrame& f) {
  const Vec3 tu = product(t, f.u), tv = product(t, f.v);
  const double a = kernel::dot(f.u, tu), b = kernel::dot(f.u, tv), c = kernel::dot(f.v, tv);
  const double half = 0.5 * (a - c);
  return kernel::dot(f.w, product(t, f.w)) - 0.5 * (a + c) - std::sqrt(half * half + b * b);
}

bool way_passes(Way way, const WayFrame& f, double slack, int halvings) {
  double least = HUGE_VAL, end = HUGE_VAL;
  for (std::size_t i = 0; i < 10; ++i) {
    const double g = way_gap({way[0][i], way[1][i], way[2][i], way[3][i], way[4][i], way[5][i]}, f);
    least = std::min(least, g);
    if (i == 0 || i == 9) end = std::min(end, g);
  }
  if (least * (1 - kWayMargin) > slack) return true;
  if (halvings == 0 || !(end > slack)) return false;
  const Way upper = halve_way(way);
  return way_passes(way, f, slack, halvings - 1) && way_passes(upper, f, slack, halvings - 1);
}

}  // namespace

CellWays::CellWays(const Fields& fields, const Node& cell) {
  RowNets(fields, cell[1], cell[2]).make(cell[0], nets_);
}

bool CellWays::one_branch(const Vec3& from, const Vec3& to) const {
  Way way;
  for (std::size_t n = 0; n < 6; ++n) way[n] = diagonal(nets_.tensor[n], from, to);
  const auto end = [&](std::size_t i) {
    return dominant_direction({way[0][i], way[1][i], way[2][i], way[3][i], way[4][i], way[5][i]});
  };
  const Vec3 a = end(0), b = end(9);
  const Vec3 sum = kernel::dot(a, b) < 0 ? a - b : a + b;
  const Vec3 w = (1 / kernel::norm(sum)) * sum;
  const auto [u, v] = kernel::frame_across(w);
  return way_passes(way, {w, u, v}, kWaySlack * nets_.tensor_size, kHalvings);
}

}  // namespace crest::extremal
