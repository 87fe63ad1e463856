// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/splines/leaf_test.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "algorithms/splines/active_cubes.hpp"
#include "kernel/arithmetic/approximate.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/arithmetic/sign.hpp"
#include "kernel/arithmetic/wide_clones.hpp"

namespace crest::splines {

using kernel::kUnitRoundoff;
using kernel::Rational;
using kernel::Sign;

namespace {

/// Coefficients by pairs of corners.
constexpr auto kPair = [] {
  std::array<std::array<std::uint8_t, 4>, 4> pair{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) pair[i][k] = static_cast<std::uint8_t>(pair_position(i, k));
  return pair;
}();

/// A corner from its cube's centre; exact in doubles.
template <class T>
std::array<T, 3> from_centre(const Cube& cube, const FinePoint& p) {
  constexpr std::int64_t unit = std::int64_t{1} << kFineBits;
  std::array<T, 3> d;
  for (std::size_t k = 0; k < 3; ++k)
    d[k] = T(static_cast<double>(p[k] - (2 * cube[k] + 1) * unit) / static_cast<double>(unit));
  return d;
}

template <class T>
std::array<T, 10> blossoms(const QuadraticNet<T>& root, const Cube& cube, std::size_t t,
                           const FineCorners& corners) {
  std::array<std::array<T, 4>, 4> l;
  for (std::size_t i = 0; i < 4; ++i) l[i] = barycentric(t, from_centre<T>(cube, corners[i]));
  std::array<T, 10> b;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto step = kernel::blossom_step(root, l[i]);
    for (std::size_t k = i; k < 4; ++k) b[kPair[i][k]] = kernel::value_at(step, l[k]);
  }
  return b;
}

std::array<Rational, 10> exact_net(const QuadraticSpline& spline, double level, const Cube& cube,
                                   std::size_t t, const FineCorners* corners) {
  QuadraticNet<Rational> root;
  if (spline.exact()) {
    const auto net = tetrahedron_net(cube_coefficients(spline.stencil<double>(cube)), t);
    std::copy(net.c.begin(), net.c.end(), root.c.begin());
  } else {
    root = tetrahedron_net(cube_coefficients(spline.stencil<Rational>(cube)), t);
  }
  for (Rational& x : root.c) x -= level;
  return corners ? blossoms(root, cube, t, *corners) : root.c;
}

/// Signs of numbers of degree 1 and 2 in the coefficients, the latter with factors of the shape;
/// notes where it is not sure.
struct Filter {
  double error, product_error;
  bool unsure = false;
  template <class T>
  Sign operator()(T x, double bound) {
    // Not: sure. So NaN is not.
    unsure |= !(std::fabs(x) > bound) || !(std::fabs(x) < HUGE_VAL);
    return kernel::sign_of(x);
  }
  template <class T>
  Sign linear(T x) {
    return (*this)(x, error);
  }
  template <class T>
  Sign product(T x) {
    return (*this)(x, product_error);
  }
};
struct Exact {
  static constexpr bool unsure = false;
  static Sign linear(const Rational& x) { return kernel::sign_of(x); }
  static Sign product(const Rational& x) { return kernel::sign_of(x); }
};

/// Zero counts as +.
template <class T, class Signs>
bool is_empty(std::initializer_list<T> b, Signs& signs) {
  bool any_below = false, any_other = false;
  for (const T& x : b) (signs.linear(x) == Sign::negative ? any_below : any_other) = true;
  return !(any_below && any_other);
}

template <class T, class Signs>
bool edge_is_simple(const T& b0, const T& b1, const T& b2, Signs& signs) {
  const bool below = signs.linear(b0) == Sign::negative;
  if (below != (signs.linear(b2) == Sign::negative)) return true;
  if ((signs.linear(b1) == Sign::negative) == below) return true;
  const Sign d = signs.product(T(b0 * b2 - b1 * b1));
  return below ? d == Sign::positive : d != Sign::negative;
}

/// Edges from corner 0, the longest coordinate scaled to 1: small integers, but for a power of two.
template <class T>
using Edges = std::array<std::array<T, 3>, 4>;

template <class T>
T inner(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// (ii): the gradient within the face i j k.
template <class T, class Signs>
bool face_is_simple(const std::array<T, 10>& b, const Edges<T>& x, std::size_t i, std::size_t j,
                    std::size_t k, Signs& signs) {
  std::array<T, 3> u, v;
  for (std::size_t r = 0; r < 3; ++r) {
    u[r] = x[j][r] - x[i][r];
    v[r] = x[k][r] - x[i][r];
  }
  const T uu = inner(u, u), uv = inner(u, v), vv = inner(v, v);
  std::array<std::array<T, 2>, 3> d;
  T mean_u(0), mean_v(0);
  std::size_t n = 0;
  for (const std::size_t p : {i, j, k}) {
    d[n] = {b[kPair[p][j]] - b[kPair[p][i]], b[kPair[p][k]] - b[kPair[p][i]]};
    mean_u = mean_u + d[n][0];
    mean_v = mean_v + d[n][1];
    ++n;
  }
  // The inverse of the metric but for a positive factor.
  const T along_u = vv * mean_u - uv * mean_v, along_v = uu * mean_v - uv * mean_u;
  for (const auto& [du, dv] : d)
    if (signs.product(T(du * along_u + dv * along_v)) != Sign::positive) return false;
  return true;
}

/// (iii).
template <class T, class Signs>
bool gradient_is_simple(const std::array<T, 10>& b, const Edges<T>& x, Signs& signs) {
  std::array<std::array<T, 3>, 3> normal;
  for (std::size_t j = 0; j < 3; ++j) {
    const auto &u = x[1 + (j + 1) % 3], &v = x[1 + (j + 2) % 3];
    normal[j] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  }
  std::array<std::array<T, 3>, 4> g;
  std::array<T, 3> mean = {T(0), T(0), T(0)};
  for (std::size_t p = 0; p < 4; ++p)
    for (std::size_t r = 0; r < 3; ++r) {
      g[p][r] = T(0);
      for (std::size_t j = 0; j < 3; ++j)
        g[p][r] = g[p][r] + (b[kPair[p][j + 1]] - b[kPair[p][0]]) * normal[j][r];
      mean[r] = mean[r] + g[p][r];
    }
  for (const auto& corner : g)
    if (signs.product(inner(corner, mean)) != Sign::positive) return false;
  return true;
}

template <class T, class Signs>
bool is_settled(const std::array<T, 10>& b, const Edges<T>& x, Signs& signs) {
  if (is_empty({b[0], b[1], b[2], b[3], b[4], b[5], b[6], b[7], b[8], b[9]}, signs)) return true;
  const auto at = [&](std::size_t i, std::size_t k) -> const T& { return b[kPair[i][k]]; };
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = i + 1; k < 4; ++k)
      if (!edge_is_simple(at(i, i), at(i, k), at(k, k), signs)) return false;
  for (std::size_t left_out = 0; left_out < 4; ++left_out) {
    const std::size_t i = left_out == 0 ? 1 : 0, j = left_out <= 1 ? 2 : 1,
                      k = left_out <= 2 ? 3 : 2;
    if (!is_empty({at(i, i), at(i, j), at(i, k), at(j, j), at(j, k), at(k, k)}, signs) &&
        !face_is_simple(b, x, i, j, k, signs))
      return false;
  }
  return gradient_is_simple(b, x, signs);
}

/// Of all 24 tetrahedra, but for an isometry.
constexpr Edges<double> kTetrahedronShape = {{{0, 0, 0}, {1, 1, -1}, {1, 1, 1}, {1, 0, 0}}};

/// The same with the shape folded in.
CREST_WIDE_CLONES bool tetrahedron_is_settled(const std::array<double, 10>& b, Filter& filter) {
  return is_settled(b, kTetrahedronShape, filter);
}

template <class T>
Edges<T> edges_of(const FineCorners& corners) {
  Edges<T> x;
  std::int64_t longest = 1;
  for (const FinePoint& p : corners)
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, std::abs(p[k] - corners[0][k]));
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      x[i][k] =
          T(static_cast<double>(corners[i][k] - corners[0][k]) / static_cast<double>(longest));
  return x;
}

template <class T>
Edges<T> edges_of(const FineCorners* corners) {
  if (corners) return edges_of<T>(*corners);
  Edges<T> x;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 3; ++k) x[i][k] = T(kTetrahedronShape[i][k]);
  return x;
}

/// Half the distance from 1 to the next long double.
constexpr double kFine = std::numeric_limits<long double>::epsilon() / 2;

/// Coefficients are off by less than 45 roundings of what is at most the largest sample, extended
/// ones and the level's difference included: a_c by 12, their means by 27, extended samples by 8.
constexpr double kRoundings = 128;

double largest_of(const auto& b) {
  double largest = 0;
  for (const auto& x : b) largest = std::max(largest, static_cast<double>(std::fabs(x)));
  return largest;
}

/// Products have factors of at most 2^8 from a shape whose edges are at most 1 along each axis.
double product_error(double error, double unit, double largest) {
  return 0x1p13 * (error + 2 * unit * largest) * largest;
}

}  // namespace

LeafTest::LeafTest(const QuadraticSpline& spline, double c)
    : spline_(spline),
      level_(c),
      scaled_level_(c),
      error_(spline.exact() ? 0 : kRoundings * kUnitRoundoff * spline.largest_sample()) {
  const double largest = std::max(spline.largest_sample(), std::fabs(c));
  if (largest != 0 && !(largest > 0x1p-400 && largest < 0x1p400)) {
    // What vanishes is below the error, too.
    scale_ = scale_to_one(largest);
    scaled_level_ *= scale_;
    error_ = kRoundings * kUnitRoundoff * (scale_ * largest);
    return;
  }
  const double steps = c / spline.step();
  if (spline.exact() && std::fabs(steps) < 0x1p50 && std::floor(steps) == steps)
    bits_ = 1 + std::max(spline.bits(), steps == 0 ? 0 : std::ilogb(steps) + 1);
}

LeafNet LeafTest::net(const CubeCoefficients<double>& a, const Cube& cube, std::size_t t,
                      const FineCorners* corners) const {
  QuadraticNet<double> root = tetrahedron_net(a, t);
  LeafNet leaf;
  for (double& x : root.c) x -= scaled_level_;
  leaf.error = error_;
  int bits = bits_;
  if (corners) {
    leaf.b = blossoms(root, cube, t, *corners);
    // Two barycentric coordinates of as many bits as the corners have behind the point, and one.
    std::uint64_t all = std::uint64_t{1} << kFineBits;
    for (const FinePoint& p : *corners)
      for (const std::int64_t x : p) all |= static_cast<std::uint64_t>(x);
    bits += 2 * (kFineBits - std::countr_zero(all) + 1);
    if (bits_ == 0 || bits > 51) leaf.error += 16 * kUnitRoundoff * largest_of(root.c);
  } else {
    leaf.b = root.c;  // a difference of doubles has its exact sign
  }
  // Of two coefficients, and edges that are multiples of 1/2 and at most 1: four bits behind the
  // point, sums below 2^9.
  leaf.largest = largest_of(leaf.b);
  leaf.exact_products = bits_ > 0 && 2 * bits + 13 <= 53;
  return leaf;
}

FineNet LeafTest::fine_net(const Cube& cube, std::size_t t, const FineCorners* corners) const {
  auto f = spline_.stencil<long double>(cube);
  for (long double& x : f) x *= scale_;
  auto root = tetrahedron_net(cube_coefficients(f), t);
  for (long double& x : root.c) x -= scaled_level_;
  FineNet net;
  net.error = kRoundings * kFine * scale_ * spline_.largest_sample();
  // What the level loses by being scaled.
  if (scale_ != 1) net.error += 0x1p-1000;
  if (corners) {
    net.b = blossoms(root, cube, t, *corners);
    net.error += 16 * kFine * largest_of(root.c);
  } else {
    std::copy(root.c.begin(), root.c.end(), net.b.begin());
  }
  return net;
}

CubeSigns LeafTest::signs(const CubeCoefficients<double>& a) const {
  static constexpr SlotBits kUsed = [] {
    SlotBits used{};
    for (const SlotBits& bits : kSlotBits)
      for (const std::size_t k : {0, 1}) used[k] |= bits[k];
    return used;
  }();
  CubeSigns signs;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::uint64_t left = kUsed[k]; left != 0; left &= left - 1) {
      const auto bit = static_cast<unsigned>(std::countr_zero(left));
      const double x = a[64 * k + bit] - scaled_level_;
      signs.below[k] |= std::uint64_t{x < -error_} << bit;
      // A difference of doubles has its exact sign.
      signs.other[k] |= std::uint64_t{error_ == 0 ? x >= 0 : x > error_} << bit;
    }
  return signs;
}

bool LeafTest::empty(const LeafNet& net) const {
  bool below = true, other = true;
  for (const double x : net.b) {
    below &= x < -net.error;
    other &= net.error == 0 ? x >= 0 : x > net.error;
  }
  return below || other;
}

bool LeafTest::settled(const LeafNet& net, const Cube& cube, std::size_t t,
                       const FineCorners* corners) const {
  if (empty(net)) return true;
  Filter filter{net.error, product_error(net.error, kUnitRoundoff, net.largest)};
  // Signs are exact, zeros too.
  if (net.error == 0) filter.error = -1;
  if (net.exact_products) filter.product_error = -1;
  const bool answer = corners ? is_settled(net.b, edges_of<double>(*corners), filter)
                              : tetrahedron_is_settled(net.b, filter);
  if (!filter.unsure) return answer;
  if (net.error > 0) {
    const auto [b, error] = fine_net(cube, t, corners);
    Filter fine{error, product_error(error, kFine, largest_of(b))};
    const bool fine_answer = is_settled(b, edges_of<long double>(corners), fine);
    if (!fine.unsure) return fine_answer;
  }
  Exact exact;
  return is_settled(exact_net(spline_, level_, cube, t, corners), edges_of<Rational>(corners),
                    exact);
}

Sign LeafTest::sign(const LeafNet& net, const Cube& cube, std::size_t t, const FineCorners* corners,
                    std::size_t corner) const {
  const std::size_t i = kPair[corner][corner];
  if (net.error == 0 || std::fabs(net.b[i]) > net.error) return kernel::sign_of(net.b[i]);
  const auto fine = fine_net(cube, t, corners);
  if (std::fabs(fine.b[i]) > fine.error) return kernel::sign_of(fine.b[i]);
  return kernel::sign_of(exact_net(spline_, level_, cube, t, corners)[i]);
}

AlongEdge LeafTest::along(const LeafNet& net, const Cube& cube, std::size_t t,
                          const FineCorners* corners, std::size_t below, std::size_t other) const {
  const std::array<std::size_t, 3> pairs = {kPair[below][below], kPair[below][other],
                                            kPair[other][other]};
  const AlongEdge near = {net.b[pairs[0]], net.b[pairs[1]], net.b[pairs[2]], net.error};
  if (net.error == 0 || (near.b0 < -net.error && near.b2 > net.error)) return near;
  const auto exact = exact_net(spline_, level_, cube, t, corners);
  Rational largest = 0;
  for (const std::size_t i : pairs) largest = std::max(largest, Rational(abs(exact[i])));
  // By a power of two, so that what doubles hold stays as it is.
  const int power =
      static_cast<int>(msb(denominator(largest))) - static_cast<int>(msb(numerator(largest)));
  const Rational scale = power >= 0 ? Rational(numerator(Rational(1)) << power)
                                    : 1 / Rational(numerator(Rational(1)) << -power);
  bool rounded = false;
  const auto scaled = [&](std::size_t i) {
    const Rational x = scale * exact[i];
    const auto y = static_cast<double>(x);
    rounded |= x != Rational(y);
    return y;
  };
  AlongEdge along = {scaled(pairs[0]), scaled(pairs[1]), scaled(pairs[2]), 0};
  if (rounded) along.error = 4 * kUnitRoundoff;
  return along;
}

}  // namespace crest::splines
